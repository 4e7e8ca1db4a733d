# SPDX-License-Identifier: BSD-3-Clause
"""Many ellipsoids and one polytope."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import plain
from ._errors import check_status
from ._pairs import _rows
from ._typing import Floats


def contact_polytope(
    centers: ArrayLike, q: ArrayLike, normals: ArrayLike, offsets: ArrayLike
) -> tuple[Floats, Floats]:
    """Contact function of ellipsoids and a polytope, the set of points x with normal·x <= offset for each of some planes.

    Parameters
    ----------
    centers : (n, 3) array_like
        Centres of the ellipsoids.
    q : (n, 6) array_like
        Their forms.
    normals : (m, 3) array_like
        Normals of the planes, out of the polytope, of any lengths > 0. Without planes, the polytope is the whole space.
    offsets : (m) array_like

    Returns
    -------
    mu2 : (n) array
        Squares of the factors by which the ellipsoids must be scaled about their centres to touch the polytope; 0 if the centre is in
        the polytope, infinity if the polytope is empty.
    point : (n, 3) array
        Where the scaled ellipsoids touch, relative to their centres.

    Raises
    ------
    PW85Error
        A plane or an ellipsoid is bad.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])])
    >>> pypw85.contact_polytope([[3, 0, 0]], q, [[1, 0, 0]], [1])
    (array([4.]), array([[-2.,  0.,  0.]]))
    """
    arrays = _polytope(centers, q, normals, offsets)
    mu2, point = np.empty(len(arrays[0])), np.empty((len(arrays[0]), 3))
    _check(_core.contact_polytope_batch(*arrays, mu2, point), "contact_polytope", *arrays)
    return mu2, point


def overlap_polytope(
    centers: ArrayLike, q: ArrayLike, normals: ArrayLike, offsets: ArrayLike
) -> NDArray[np.bool_]:
    """Decides whether ellipsoids overlap a polytope, the set of points x with normal·x <= offset for each of some planes.

    The answers are those of exact arithmetic for the numbers given. An ellipsoid that only touches the polytope does not overlap it.

    Parameters
    ----------
    centers, q, normals, offsets
        As for `contact_polytope`.

    Returns
    -------
    (n) array of bool

    Raises
    ------
    PW85Error
        A plane or an ellipsoid is bad.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.overlap_polytope([[2, 0, 0], [1.5, 0, 0]], q, [[1, 0, 0]], [1])
    array([False,  True])
    """
    arrays = _polytope(centers, q, normals, offsets)
    overlap = np.empty(len(arrays[0]), dtype=np.uint8)
    _check(_core.overlap_polytope_batch(*arrays, overlap), "overlap_polytope", *arrays)
    return overlap.astype(bool)


def _polytope(
    centers: ArrayLike, q: ArrayLike, normals: ArrayLike, offsets: ArrayLike
) -> tuple[Floats, Floats, Floats, Floats]:
    points, forms = _rows(centers, 3, "centers"), _rows(q, 6, "q")
    if len(points) != len(forms):
        raise ValueError(f"{len(points)} centers, but {len(forms)} forms")
    numbers = np.require(np.asarray(plain(offsets)), np.float64, ["C", "A"])
    directions = np.empty((0, 3)) if np.size(normals) == 0 else _rows(normals, 3, "normals")
    if numbers.shape != (len(directions),):
        raise ValueError(f"offsets must have the shape ({len(directions)},), not {numbers.shape}")
    return points, forms, directions, numbers


def _check(status: int, name: str, centers: Floats, q: Floats, normals: Floats, offsets: Floats) -> None:
    check_status(status, name, center=centers, q=q, normals=normals, offsets=offsets)
