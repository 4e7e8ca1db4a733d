# SPDX-License-Identifier: BSD-3-Clause
"""Two ellipsoids in n dimensions, 1 <= n <= 16."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import reals
from ._errors import PW85Error
from ._typing import Floats

MAX_DIMENSION = 16


class NdContactGeometry(NamedTuple):
    """Result of `nd_contact_geometry` in n dimensions.

    - `point` (..., n): point at which the ellipsoids touch if both are scaled by μ, relative to the centre of ellipsoid 1;
    - `normal` (..., n): common unit normal at this point, from ellipsoid 1 to ellipsoid 2;
    - `d_r12` (..., n): derivative of μ² with respect to `r12`;
    - `d_q1`, `d_q2` (..., n (n + 1)/2): derivatives of μ² with respect to the packed forms. An entry off the diagonal stands for two
      entries of the matrix.
    """

    point: Floats
    normal: Floats
    d_r12: Floats
    d_q1: Floats
    d_q2: Floats


class NdDistance(NamedTuple):
    """Result of `nd_distance` in n dimensions.

    - `distance` (...): distance of the surfaces; 0 if the ellipsoids overlap;
    - `point1`, `point2` (..., n): the closest points of the ellipsoids, relative to the centre of ellipsoid 1; NaN if they overlap;
    - `normal` (..., n): unit vector from `point1` to `point2`; NaN if the ellipsoids overlap.
    """

    distance: Any
    point1: Floats
    point2: Floats
    normal: Floats


def nd_contact(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> tuple[Any, Any]:
    """Computes the contact function of two ellipsoids in n dimensions, 1 <= n <= 16.

    Parameters
    ----------
    r12 : (..., n) array_like
        Vectors from the centre of ellipsoid 1 to that of ellipsoid 2. Their length is the number of dimensions n.
    q1, q2 : (..., n, n) or (..., n (n + 1)/2) array_like
        The forms: symmetric matrices, or their upper triangles row by row. Leading dimensions broadcast with those of `r12`.

    Returns
    -------
    mu2 : (...) array
        Square of the common factor by which both ellipsoids must be scaled to touch.
    lambda : (...) array
        The maximiser λ of f, from 0 to 1.

    Raises
    ------
    PW85Error
        A form is not positive definite, or a number is not finite. Nothing is returned then.
    ValueError
        Shapes do not match, or a matrix is not symmetric.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> mu2, lambda_ = pypw85.nd_contact([4, 0, 0, 0, 0, 0], np.eye(6), np.eye(6))
    >>> print(mu2, lambda_)
    4.0 0.5
    """
    if (found := _core.nd_one_pair("nd_contact", r12, q1, q2)) is not None:
        return found[0], found[1]
    rows = _Rows("nd_contact", r12, q1, q2)
    mu2, lambda_ = np.empty(rows.count), np.empty(rows.count)
    rows.check(_core.nd_contact_batch(rows.n, *rows.arrays, mu2, lambda_))
    return rows.shaped(mu2), rows.shaped(lambda_)


def nd_contact_geometry(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, lambda_: ArrayLike) -> NdContactGeometry:
    """Computes the contact point and normal of two ellipsoids in n dimensions that are scaled by μ, and derivatives of μ².

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`. `r12` must not be zero.
    lambda_ : (...) array_like
        From `nd_contact`.

    Returns
    -------
    NdContactGeometry
        Contact point, normal, and the derivatives of μ² with respect to `r12` and to the packed forms.

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> geometry = pypw85.nd_contact_geometry([4, 0, 0, 0], np.eye(4), np.eye(4), 0.5)
    >>> geometry.point, geometry.d_r12
    (array([2., 0., 0., 0.]), array([2., 0., 0., 0.]))
    """
    if (found := _core.nd_one_pair("nd_contact_geometry", r12, q1, q2, lambda_)) is not None:
        return NdContactGeometry(*found)
    rows = _Rows("nd_contact_geometry", r12, q1, q2, lambda_=lambda_)
    outputs = [np.empty((rows.count, size)) for size in (rows.n, rows.n, rows.n, rows.size, rows.size)]
    rows.check(_core.nd_contact_geometry_batch(rows.n, *rows.arrays, *outputs))
    return NdContactGeometry(*map(rows.shaped, outputs))


def _flags(name: str, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Answers a question that is true or false."""
    if (found := _core.nd_one_pair(name, r12, q1, q2)) is not None:
        return found
    rows = _Rows(name, r12, q1, q2)
    flags = np.empty(rows.count, dtype=np.uint8)
    rows.check(getattr(_core, f"{name}_batch")(rows.n, *rows.arrays, flags))
    return rows.shaped(flags.astype(bool))


def nd_overlap(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Decides whether two ellipsoids in n dimensions overlap, 1 <= n <= 16.

    The answers are those of exact arithmetic for the numbers given. Ellipsoids that only touch do not overlap.

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`.

    Returns
    -------
    (...) array of bool

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nd_overlap([[2, 0, 0, 0, 0], [1.9, 0, 0, 0, 0]], np.eye(5), np.eye(5))
    array([False,  True])
    """
    return _flags("nd_overlap", r12, q1, q2)


def nd_compare(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, mu2: ArrayLike) -> Any:
    """Compares μ² of two ellipsoids in n dimensions with a number, exactly.

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`.
    mu2 : (...) array_like
        At least 0; may be infinite.

    Returns
    -------
    (...) array of int
        The sign of μ² - `mu2`: -1, 0 or 1.

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`; also for a `mu2` that is negative or NaN.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nd_compare([4, 0, 0, 0], np.eye(4), np.eye(4), [3.5, 4, np.inf])
    array([ 1,  0, -1], dtype=int32)
    """
    if (found := _core.nd_one_pair("nd_compare", r12, q1, q2, mu2)) is not None:
        return found
    rows = _Rows("nd_compare", r12, q1, q2, mu2=mu2)
    sign = np.empty(rows.count, dtype=np.intc)
    rows.check(_core.nd_compare_batch(rows.n, *rows.arrays, sign))
    return rows.shaped(sign)


def nd_contains(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Decides whether ellipsoid 2 is inside ellipsoid 1 in n dimensions, 1 <= n <= 16.

    The answers are those of exact arithmetic for the numbers given. Ellipsoid 2 may touch the surface of ellipsoid 1 from inside.

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`.

    Returns
    -------
    (...) array of bool

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nd_contains([[1, 0, 0, 0], [1.25, 0, 0, 0]], 4 * np.eye(4), np.eye(4))
    array([ True, False])
    """
    return _flags("nd_contains", r12, q1, q2)


def nd_containment(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> tuple[Any, Any]:
    """Computes the factor by which ellipsoid 1 must be scaled to contain ellipsoid 2 in n dimensions, and the contact point.

    The centre of ellipsoid 1 stays fixed.

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`.

    Returns
    -------
    mu2 : (...) array
        Square of the factor.
    point : (..., n) array
        A point on the surface of ellipsoid 2, relative to the centre of ellipsoid 1. If the ellipsoids touch at several points, it is one
        of them.

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> mu2, point = pypw85.nd_containment([3, 0, 0, 0], 4 * np.eye(4), np.eye(4))
    >>> print(mu2, point)
    4.0 [4. 0. 0. 0.]
    """
    if (found := _core.nd_one_pair("nd_containment", r12, q1, q2)) is not None:
        return found[0], found[1]
    rows = _Rows("nd_containment", r12, q1, q2)
    mu2, point = np.empty(rows.count), np.empty((rows.count, rows.n))
    rows.check(_core.nd_containment_batch(rows.n, *rows.arrays, mu2, point))
    return rows.shaped(mu2), rows.shaped(point)


def nd_distance(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> NdDistance:
    """Computes the distance of the surfaces of two ellipsoids in n dimensions, the closest points, and the normal.

    Parameters
    ----------
    r12, q1, q2
        As for `nd_contact`.

    Returns
    -------
    NdDistance
        Distance, closest points and normal.

    Raises
    ------
    PW85Error, ValueError
        As for `nd_contact`.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> found = pypw85.nd_distance([5, 0, 0, 0], np.eye(4), 4 * np.eye(4))
    >>> print(found.distance, found.point1, found.point2)
    2.0 [1. 0. 0. 0.] [3. 0. 0. 0.]
    """
    if (found := _core.nd_one_pair("nd_distance", r12, q1, q2)) is not None:
        return NdDistance(*found)
    rows = _Rows("nd_distance", r12, q1, q2)
    outputs = [np.empty(rows.count), *(np.empty((rows.count, rows.n)) for _ in range(3))]
    rows.check(_core.nd_distance_batch(rows.n, *rows.arrays, *outputs))
    return NdDistance(*map(rows.shaped, outputs))


def packed_rows(form: ArrayLike, n: int, function: str, argument: str) -> NDArray[Any]:
    """Forms in n dimensions, matrices or packed, as their upper triangles."""
    q, size = reals(form, f"{function}: {argument}"), n * (n + 1) // 2
    if q.shape[-2:] == (n, n):
        transposed = np.swapaxes(q, -1, -2)
        largest = np.abs(q).max(axis=(-1, -2), keepdims=True) if q.size else 0
        if (np.abs(q - transposed) > 1e-6 * largest).any():
            raise ValueError(f"{function}: {argument} must be symmetric")
        return q[(..., *np.triu_indices(n))]
    if q.ndim and q.shape[-1] == size:
        return q
    raise ValueError(f"{function}: {argument} must have {n}×{n} or {size} numbers for {n} dimensions, not the shape {q.shape}")


class _Rows:
    """The arguments of a call as rows of packed numbers."""

    def __init__(self, name: str, r12: ArrayLike, q1: ArrayLike, q2: ArrayLike, **numbers: ArrayLike) -> None:
        self.name, self.numbers = name, tuple(numbers)
        separations = reals(r12, f"{name}: r12")
        if separations.ndim == 0 or not 1 <= separations.shape[-1] <= MAX_DIMENSION:
            raise ValueError(f"{name}: r12 must have a last dimension of 1 to {MAX_DIMENSION}, not the shape {separations.shape}")
        self.n = separations.shape[-1]
        self.size = self.n * (self.n + 1) // 2
        others = [reals(x, f"{name}: {number}")[..., np.newaxis] for number, x in numbers.items()]
        arrays = [separations, packed_rows(q1, self.n, name, "q1"), packed_rows(q2, self.n, name, "q2"), *others]
        try:
            self.shape = np.broadcast_shapes(*(array.shape[:-1] for array in arrays))
        except ValueError:
            raise ValueError(f"{name}: the leading dimensions do not match: {[array.shape[:-1] for array in arrays]}") from None
        self.count = int(np.prod(self.shape, dtype=int))
        rows = [np.broadcast_to(array, (*self.shape, array.shape[-1])).reshape(self.count, array.shape[-1]) for array in arrays]
        self.arrays = [np.require(x if k < 3 else x[:, 0], np.float64, ["C", "A"]) for k, x in enumerate(rows)]

    def shaped(self, rows: NDArray[Any]) -> Any:
        """Rows of a result in the shape of the arguments; one number for a single pair."""
        return rows.reshape((*self.shape, *rows.shape[1:]))[()]

    def check(self, status: int) -> None:
        """Raises the error of a status other than zero, with the cause that the library gives."""
        if not status:
            return
        cause = _core.last_error()
        detail = ""
        if cause is not None and cause[1] is not None:
            _, argument, requirement, row, *_ = cause
            names = ("r12", "q1", "q2", *self.numbers)
            name = next(own for own in names if own.rstrip("_") == argument)
            where = f"row {tuple(map(int, np.unravel_index(row, self.shape)))}: " if self.shape else ""
            detail = f"{where}{name} {requirement}, not {self.arrays[names.index(name)][row].tolist()}"
        raise PW85Error(status, self.name, _core.strerror(status), detail)
