"""Forms from the conventions of other programs: what each calls a shape, and how it orders a quaternion."""

from __future__ import annotations

from typing import Any
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import plain
from ._functions import ellipsoid_quaternion
from ._typing import Floats


def from_lammps(diameters: ArrayLike, quaternions_wxyz: ArrayLike) -> Floats:
    """Forms of the ellipsoids of LAMMPS (``atom_style ellipsoid``).

    Parameters
    ----------
    diameters : (..., 3) array_like
        shapex, shapey, shapez: full lengths, not semi-axes.
    quaternions_wxyz : (..., 4) array_like
        quatw, quati, quatj, quatk.

    Returns
    -------
    (..., 6) array

    Raises
    ------
    PW85Error
        For a single particle: a diameter is not positive (LAMMPS writes 0 0 0 for point particles), or the quaternion
        is zero. Rows of arrays become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.from_lammps([2, 4, 6], [1, 0, 0, 0])
    array([1., 0., 0., 4., 0., 9.])
    """
    return ellipsoid_quaternion(0.5 * plain(diameters), quaternions_wxyz)


def from_ovito(semi_axes: ArrayLike, quaternions_xyzw: ArrayLike) -> Floats:
    """Forms of the ellipsoids of OVITO.

    Parameters
    ----------
    semi_axes : (..., 3) array_like
        The property "Aspherical Shape".
    quaternions_xyzw : (..., 4) array_like
        The property "Orientation": scalar last.

    Returns
    -------
    (..., 6) array

    Raises
    ------
    PW85Error
        For a single particle: a length is not positive, or the quaternion is zero. Rows of arrays become NaN.

    Examples
    --------
    A quarter turn about z:

    >>> import numpy as np, pypw85
    >>> pypw85.from_ovito([1, 2, 3], [0, 0, 1, 1]).round(12) + 0.0
    array([4., 0., 0., 1., 0., 9.])
    """
    quaternions = plain(quaternions_xyzw)
    if quaternions.shape[-1:] != (4,):
        raise ValueError(f"from_ovito: the last dimension must be 4, but the shape is {quaternions.shape}")
    return ellipsoid_quaternion(semi_axes, quaternions[..., [3, 0, 1, 2]])


def from_gsd(
    type_shapes: Sequence[Mapping[str, Any]], typeid: ArrayLike, orientations_wxyz: ArrayLike
) -> Floats:
    """Forms of the ellipsoids and spheres of a GSD file (HOOMD-blue).

    Parameters
    ----------
    type_shapes : sequence of dict
        ``particles/type_shapes``, one for each type: ``{"type": "Ellipsoid", "a": ..., "b": ..., "c": ...}`` with
        semi-axes, or ``{"type": "Sphere", "diameter": ...}``.
    typeid : (n) array_like of int
        ``particles/typeid``. Computed at once if it is a dask array.
    orientations_wxyz : (n, 4) array_like
        ``particles/orientation``.

    Returns
    -------
    (n, 6) array

    Raises
    ------
    ValueError
        A type that occurs has another shape.
    IndexError
        A type is not in `type_shapes`.
    TypeError
        Types are not integers.

    Examples
    --------
    >>> import pypw85
    >>> shapes = [{"type": "Ellipsoid", "a": 1, "b": 2, "c": 3},
    ...           {"type": "Sphere", "diameter": 2}]
    >>> pypw85.from_gsd(shapes, [1, 0], [[1, 0, 0, 0], [1, 0, 0, 0]])
    array([[1., 0., 0., 1., 0., 1.],
           [1., 0., 0., 4., 0., 9.]])
    """
    types = np.asarray(plain(typeid))
    if types.size and types.dtype.kind not in "iu":
        raise TypeError(f"typeid must be integers, but they are {types.dtype}")
    types = types.astype(np.intp)
    semi_axes = np.full((len(type_shapes), 3), np.nan)
    for k in np.unique(types):
        if not 0 <= k < len(type_shapes):
            raise IndexError(f"type {k}, but there are shapes for {len(type_shapes)} types")
        semi_axes[k] = _gsd_semi_axes(type_shapes[k])
    return ellipsoid_quaternion(semi_axes[types], orientations_wxyz)


def _gsd_semi_axes(shape: Mapping[str, Any]) -> tuple[float, float, float]:
    if shape.get("type") == "Ellipsoid" and shape.keys() >= {"a", "b", "c"}:
        return shape["a"], shape["b"], shape["c"]
    if shape.get("type") == "Sphere" and "diameter" in shape:
        radius = 0.5 * shape["diameter"]
        return radius, radius, radius
    raise ValueError(f"not an ellipsoid: {dict(shape)}")
