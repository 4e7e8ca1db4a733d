# SPDX-License-Identifier: BSD-3-Clause
"""Forms from the data of other programs, Euler angles, rotation vectors and covariance matrices."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import doubles, plain
from ._documentation import FUNCTIONS
from ._errors import named
from ._explanations import explain_values
from ._forms import packed
from ._functions import ellipsoid, ellipsoid_quaternion
from ._numbers import truth
from ._rotations import check_sequence
from ._typing import Floats


def from_lammps(diameters: ArrayLike, quaternions_wxyz: ArrayLike) -> Floats:
    """Computes the forms of ellipsoids of LAMMPS (``atom_style ellipsoid``).

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
        is zero. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.from_lammps([2, 4, 6], [1, 0, 0, 0])
    array([1., 0., 0., 4., 0., 9.])
    """
    with named("from_lammps"):
        return ellipsoid_quaternion(0.5 * doubles(diameters), quaternions_wxyz)


def _plain_rows(function: str, x: ArrayLike, size: int) -> Floats:
    rows: Floats = doubles(x)
    if rows.shape[-1:] != (size,):
        raise ValueError(f"{function}: the last dimension must be {size}, not the shape {rows.shape}")
    return rows


def from_ovito(semi_axes: ArrayLike, quaternions_xyzw: ArrayLike) -> Floats:
    """Computes the forms of ellipsoids of OVITO.

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
        For a single particle: a length is not positive, or the quaternion is zero. In arrays, invalid rows become NaN.

    Examples
    --------
    A quarter turn about z:

    >>> import numpy as np, pypw85
    >>> pypw85.from_ovito([1, 2, 3], [0, 0, 1, 1]).round(12) + 0.0
    array([4., 0., 0., 1., 0., 9.])
    """
    quaternions = _plain_rows("from_ovito", quaternions_xyzw, 4)
    with named("from_ovito"):
        return ellipsoid_quaternion(semi_axes, quaternions[..., [3, 0, 1, 2]])


def from_gsd(
    type_shapes: Sequence[Mapping[str, Any]], typeid: ArrayLike, orientations_wxyz: ArrayLike
) -> Floats:
    """Computes the forms of ellipsoids and spheres of a GSD file (HOOMD-blue).

    Parameters
    ----------
    type_shapes : sequence of dict
        ``particles/type_shapes``, one for each type: ``{"type": "Ellipsoid", "a": ..., "b": ..., "c": ...}`` with
        semi-axes, or ``{"type": "Sphere", "diameter": ...}``.
    typeid : (n) array_like of int
        ``particles/typeid``. A dask array is computed immediately.
    orientations_wxyz : (n, 4) array_like
        ``particles/orientation``.

    Returns
    -------
    (n, 6) array

    Raises
    ------
    ValueError
        The shape of a particle is neither an ellipsoid nor a sphere.
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
        raise TypeError(f"typeid must be integers, not {types.dtype}")
    types = types.astype(np.intp)
    semi_axes = np.full((len(type_shapes), 3), np.nan)
    for k in np.unique(types):
        if not 0 <= k < len(type_shapes):
            raise IndexError(f"typeid must be an index of the {len(type_shapes)} shapes, not {k}")
        semi_axes[k] = _gsd_semi_axes(type_shapes[k])
    with named("from_gsd"):
        return ellipsoid_quaternion(semi_axes[types], orientations_wxyz)


def from_euler(semi_axes: ArrayLike, seq: str, angles: ArrayLike, degrees: bool = False) -> Floats:
    """Computes the forms of ellipsoids from Euler angles. This function needs SciPy.

    Parameters
    ----------
    semi_axes : (..., 3) array_like
    seq : str
        Axes of the rotations, as for ``scipy.spatial.transform.Rotation.from_euler``: up to three letters, upper case for
        axes that rotate with the body (intrinsic), lower case for fixed axes (extrinsic).
    angles : (..., number of axes) array_like
        Angles in radians, or in degrees. If `seq` is a single letter, a number or a one-dimensional array, as for SciPy.
    degrees : bool
        True if the angles are in degrees.

    Returns
    -------
    (..., 6) array

    Raises
    ------
    ValueError
        `seq` is not a sequence of axes, or SciPy refuses the angles.
    PW85Error
        For a single ellipsoid: a length is not positive. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.from_euler([3, 2, 1], "ZYX", [90, 0, 0], degrees=True).round(12) + 0.0
    array([4., 0., 0., 9., 0., 1.])
    """
    from scipy.spatial.transform import Rotation

    check_sequence(seq, "from_euler: seq")
    angles, degrees = np.asarray(plain(angles), dtype=np.float64), truth(degrees, "from_euler: degrees")
    if len(seq) > 1 and angles.shape[-1:] != (len(seq),):
        raise ValueError(f"from_euler: the last dimension must be {len(seq)}, not the shape {angles.shape}")
    leading = angles.shape[:-1] if len(seq) > 1 else angles.shape
    rows = angles.reshape((-1, len(seq))) if len(seq) > 1 else angles.reshape(-1)
    matrices = np.empty((0, 3, 3)) if rows.shape[0] == 0 else Rotation.from_euler(seq, rows, degrees).as_matrix()
    with named("from_euler"):
        return ellipsoid(semi_axes, matrices.reshape((*leading, 3, 3)))


def from_rotation_vector(semi_axes: ArrayLike, rotation_vectors: ArrayLike) -> Floats:
    """Computes the forms of ellipsoids from rotation vectors ω: rotations by |ω| radians about the direction of ω.

    Parameters
    ----------
    semi_axes, rotation_vectors : (..., 3) array_like

    Returns
    -------
    (..., 6) array

    Raises
    ------
    PW85Error
        For a single ellipsoid: a length is not positive, or ω is not finite. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.from_rotation_vector([3, 2, 1], [0, 0, np.pi / 2]).round(12) + 0.0
    array([4., 0., 0., 9., 0., 1.])
    """
    omega = _plain_rows("from_rotation_vector", rotation_vectors, 3)
    half = 0.5 * np.sqrt((omega * omega).sum(axis=-1, keepdims=True))
    quaternions = np.concatenate([np.cos(half), 0.5 * np.sinc(half / np.pi) * omega], axis=-1)
    with named("from_rotation_vector"):
        return ellipsoid_quaternion(semi_axes, quaternions)


def from_covariance(covariance: ArrayLike, confidence: float) -> Floats:
    """Computes the forms of confidence ellipsoids or ellipses of normal distributions from their covariance matrices.

    The ellipsoid about the mean contains the given probability. Its form is the covariance times the quantile of the χ²
    distribution with three degrees of freedom, or two in the plane. In three dimensions this function needs SciPy. An
    ellipse whose form is the covariance itself, the standard ellipse of ecology, has the confidence 1 - exp(-1/2), which
    is 39.3 %.

    Parameters
    ----------
    covariance : (..., 3, 3) or (..., 2, 2) array_like
        Symmetric and positive definite.
    confidence : float
        The probability, between 0 and 1.

    Returns
    -------
    (..., 6) or (..., 3) array
        In the unit of the covariance.

    Raises
    ------
    ValueError
        A matrix is not symmetric, or neither 3×3 nor 2×2, or the probability is not between 0 and 1.

    Examples
    --------
    Standard deviations of 1, 2 and 3. The semi-axes for 95 % are 2.8 times as long:

    >>> import numpy as np, pypw85
    >>> q = pypw85.from_covariance(np.diag([1, 4, 9]), 0.95)
    >>> pypw85.principal_axes(q)[0].round(3)
    array([2.795, 5.591, 8.386])
    """
    if not 0 < confidence < 1:
        raise ValueError(f"from_covariance: the confidence must be between 0 and 1, not {confidence}")
    matrices = doubles(covariance)
    if matrices.shape[-2:] == (2, 2):
        in_space = np.zeros((*matrices.shape[:-2], 3, 3))
        in_space[..., :2, :2] = matrices
        return packed(in_space)[..., [0, 1, 3]] * (-2.0 * math.log1p(-confidence))
    from scipy.special import gammaincinv

    return packed(doubles(covariance)) * (2.0 * float(gammaincinv(1.5, confidence)))


def from_moments(second_moments: ArrayLike) -> Floats:
    """Computes the forms of ellipsoids, or of ellipses in the plane, from the second moments of bodies.

    A uniform ellipsoid with the form Q has the covariance Q/5, and a uniform ellipse Q/4. For a body that is not an ellipsoid, the
    result is the ellipsoid with the covariance of the body. Its volume differs from that of the body.

    Parameters
    ----------
    second_moments : (..., 3, 3) or (..., 2, 2) array_like
        Covariance of the points of a uniform body about its centre, that is, second moments per volume; symmetric and positive definite.

    Returns
    -------
    (..., 6) or (..., 3) array

    Raises
    ------
    ValueError
        A matrix is neither 3×3 nor 2×2, or not symmetric, or not positive definite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.from_moments(np.diag([1, 4, 9]) / 5)
    array([1., 0., 0., 4., 0., 9.])
    """
    return _of_uniform_body("from_moments", doubles(second_moments))


def from_inertia(inertia: ArrayLike, mass: ArrayLike = 1.0) -> Floats:
    """Computes the forms of ellipsoids, or of ellipses in the plane, from the tensors of inertia of uniform bodies.

    The tensor of inertia is the trace of the second moments times the unit matrix, minus the second moments. Therefore its largest
    principal value belongs to the shortest axis. The property ``inertia_tensor`` of scikit-image is such a tensor for the mass 1, but
    its first axis is y (the rows of pixels) and its last axis is x. Use ``inertia_tensor[::-1, ::-1]`` to get x before y.

    Parameters
    ----------
    inertia : (..., 3, 3) or (..., 2, 2) array_like
        Tensors of inertia about the centres. In the plane, the matrix has the integrals of y² and x² on the diagonal, and that of -xy.
    mass : (...) array_like
        Mass of each body, > 0; 1 if the tensors are per unit mass.

    Returns
    -------
    (..., 6) or (..., 3) array

    Raises
    ------
    ValueError
        A matrix is neither 3×3 nor 2×2, or not symmetric, or no body has this tensor: in space, each principal moment is smaller
        than the sum of the two others.

    Examples
    --------
    The principal moments of an ellipsoid are m (b² + c²)/5 and so on:

    >>> import numpy as np, pypw85
    >>> a, b, c = 1, 2, 3
    >>> inertia = 7 / 5 * np.diag([b*b + c*c, a*a + c*c, a*a + b*b])
    >>> pypw85.from_inertia(inertia, mass=7).round(12) + 0.0
    array([1., 0., 0., 4., 0., 9.])
    """
    tensors = doubles(inertia)
    _check_matrices("from_inertia", tensors)
    tensors = tensors / np.asarray(doubles(mass))[..., None, None]
    n = tensors.shape[-1]
    traces = tensors[..., range(n), range(n)].sum(axis=-1)[..., None, None] / (n - 1)
    return _of_uniform_body("from_inertia", traces * np.eye(n) - tensors)


def _check_matrices(function: str, matrices: Any) -> None:
    if matrices.shape[-2:] not in ((2, 2), (3, 3)):
        raise ValueError(f"{function}: the last dimensions must be 3×3 or 2×2, not the shape {matrices.shape}")


FUNCTIONS["from_moments"] = FUNCTIONS["from_moments_2d"] = from_moments


def _of_uniform_body(function: str, moments: Any) -> Floats:
    """Forms of second moments; all are refused if one is, with what the library tells of the first."""
    _check_matrices(function, moments)
    name, rows = "from_moments", moments
    if moments.shape[-1] == 2:
        rows = np.zeros((*moments.shape[:-2], 3, 3))
        rows[..., :2, :2] = moments
        name = "from_moments_2d"
    rows = packed(rows) if name == "from_moments" else packed(rows)[..., [0, 1, 3]]
    with np.errstate(invalid="ignore"):
        forms: Floats = getattr(_core, name)(rows)
    if isinstance(forms, np.ndarray) and np.isnan(forms).any():
        raise ValueError(f"{function}: {explain_values(name, (rows,))}: {_ADVICE[function]}")
    return forms


_ADVICE = {
    "from_moments": "check that they are second moments, about the centre, of a body that is not flat",
    "from_inertia": "they follow from the inertia: check that it is a tensor, about the centre, of a body that is not flat; in space, "
                    "each principal moment is smaller than the sum of the two others",
}  # fmt: skip


# Keys of type_shapes of ellipsoids and spheres
_KEYS_OF_GSD = {"type", "a", "b", "c", "diameter"}


def _gsd_semi_axes(shape: Mapping[str, Any]) -> tuple[float, float, float]:
    if any(shape[key] for key in shape.keys() - _KEYS_OF_GSD):  # such as a radius by which the body is rounded
        raise ValueError(f"not an ellipsoid: {dict(shape)}")
    if shape.get("type") == "Ellipsoid" and shape.keys() >= {"a", "b", "c"}:
        return shape["a"], shape["b"], shape["c"]
    if shape.get("type") == "Sphere" and "diameter" in shape:
        radius = 0.5 * shape["diameter"]
        return radius, radius, radius
    raise ValueError(f"a shape must be an Ellipsoid with a, b and c, or a Sphere with a diameter, not {dict(shape)}")
