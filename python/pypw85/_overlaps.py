# SPDX-License-Identifier: BSD-3-Clause
"""Similarity indices of ellipsoids from the volume of their intersection, and tables for two sets of ellipsoids."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._functions import area_2d, overlap_area_2d, overlap_volume, volume
from ._typing import Floats

# Type checkers try each type of a sum or of an argument with each other one, which takes mypy seconds; `Any` has only one.


def _in_own_unit(r12: Any, q1: Any, q2: Any) -> tuple[Any, Any, Any]:
    """Scales pairs with semi-axes beyond 2^±256, whose volumes may leave the range of double, by a power of two.

    Other pairs are not changed, so that error messages show the numbers as given.
    """
    r12, q1, q2 = (np.asarray(one, dtype=np.float64) for one in (r12, q1, q2))
    exponents = np.maximum(np.frexp(np.max(np.abs(q1), axis=-1))[1], np.frexp(np.max(np.abs(q2), axis=-1))[1]) // 2
    unit = -np.where(np.abs(exponents) > 256, exponents, 0)[..., np.newaxis]
    return (np.ldexp(r12, unit), np.ldexp(q1, 2 * unit), np.ldexp(q2, 2 * unit)) if np.any(unit) else (r12, q1, q2)


def _volumes(r12: Any, q1: Any, q2: Any) -> tuple[Any, Any, Any]:
    """Volumes of two ellipsoids and of their intersection."""
    return volume(q1), volume(q2), overlap_volume(r12, q1, q2)


def _areas(r12: Any, q1: Any, q2: Any) -> tuple[Any, Any, Any]:
    """Areas of two ellipses and of their intersection."""
    return area_2d(q1), area_2d(q2), overlap_area_2d(r12, q1, q2)


def _union(first: Any, second: Any, common: Any) -> Any:
    return first + second - common


def _jaccard(first: Any, second: Any, common: Any) -> Any:
    return common / _union(first, second, common)


def _sorensen(first: Any, second: Any, common: Any) -> Any:
    return 2.0 * common / (first + second)


def union_volume(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the volume of the union of two ellipsoids: the sum of their volumes minus the volume of their intersection.

    Parameters
    ----------
    r12 : (..., 3) array_like
        Vectors from the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.

    Returns
    -------
    (...) array or float

    Examples
    --------
    >>> import pypw85
    >>> ball = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> print(round(float(pypw85.union_volume([1, 0, 0], ball, ball)), 4))
    7.0686
    """
    return _union(*_volumes(r12, q1, q2))


def union_area_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the area of the union of two ellipses; see `union_volume`.

    Parameters
    ----------
    r12 : (..., 2) array_like
        Vectors from the centre of ellipse 1 to that of ellipse 2.
    q1, q2 : (..., 3) array_like
        Forms of the ellipses.

    Returns
    -------
    (...) array or float

    Examples
    --------
    >>> import pypw85
    >>> circle = pypw85.ellipse(1, 1, 0)
    >>> print(round(float(pypw85.union_area_2d([1, 0], circle, circle)), 4))
    5.0548
    """
    return _union(*_areas(r12, q1, q2))


def jaccard(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the Jaccard index of two ellipsoids: the volume of their intersection divided by the volume of their union.

    Parameters
    ----------
    r12 : (..., 3) array_like
        Vectors from the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.

    Returns
    -------
    (...) array or float
        From 0 (apart) to 1 (the same ellipsoid).

    Examples
    --------
    >>> import pypw85
    >>> ball = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> print(round(float(pypw85.jaccard([1, 0, 0], ball, ball)), 4))
    0.1852
    """
    return _jaccard(*_volumes(*_in_own_unit(r12, q1, q2)))


def jaccard_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the Jaccard index of two ellipses; see `jaccard`.

    Parameters
    ----------
    r12 : (..., 2) array_like
        Vectors from the centre of ellipse 1 to that of ellipse 2.
    q1, q2 : (..., 3) array_like
        Forms of the ellipses.

    Returns
    -------
    (...) array or float

    Examples
    --------
    >>> import pypw85
    >>> circle = pypw85.ellipse(1, 1, 0)
    >>> print(round(float(pypw85.jaccard_2d([1, 0], circle, circle)), 4))
    0.243
    """
    return _jaccard(*_areas(*_in_own_unit(r12, q1, q2)))


def sorensen(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the Sørensen–Dice index of two ellipsoids: twice their common volume divided by the sum of their volumes.

    Parameters
    ----------
    r12 : (..., 3) array_like
        Vectors from the centre of ellipsoid 1 to that of ellipsoid 2.
    q1, q2 : (..., 6) array_like
        Forms of the ellipsoids.

    Returns
    -------
    (...) array or float
        From 0 (apart) to 1 (the same ellipsoid).

    Examples
    --------
    >>> import pypw85
    >>> ball = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> print(round(float(pypw85.sorensen([1, 0, 0], ball, ball)), 4))
    0.3125
    """
    return _sorensen(*_volumes(*_in_own_unit(r12, q1, q2)))


def sorensen_2d(r12: ArrayLike, q1: ArrayLike, q2: ArrayLike) -> Any:
    """Computes the Sørensen–Dice index of two ellipses; see `sorensen`.

    Parameters
    ----------
    r12 : (..., 2) array_like
        Vectors from the centre of ellipse 1 to that of ellipse 2.
    q1, q2 : (..., 3) array_like
        Forms of the ellipses.

    Returns
    -------
    (...) array or float

    Examples
    --------
    >>> import pypw85
    >>> circle = pypw85.ellipse(1, 1, 0)
    >>> print(round(float(pypw85.sorensen_2d([1, 0], circle, circle)), 4))
    0.391
    """
    return _sorensen(*_areas(*_in_own_unit(r12, q1, q2)))


def overlap_table(centers1: ArrayLike, q1: ArrayLike, centers2: ArrayLike, q2: ArrayLike) -> Floats:
    """Computes the volume of the intersection of each ellipsoid of one set with each ellipsoid of another set.

    Parameters
    ----------
    centers1, q1 : (n, 3) and (n, 6) array_like
        Centres and forms of the first set.
    centers2, q2 : (m, 3) and (m, 6) array_like
        Centres and forms of the second set.

    Returns
    -------
    (n, m) array

    Examples
    --------
    >>> import pypw85
    >>> ball = pypw85.spheroid(1, 1, [0, 0, 1])
    >>> centers = [[0, 0, 0], [9, 0, 0]]
    >>> pypw85.overlap_table(centers, [ball, ball], [[1, 0, 0]], [ball]).round(4)
    array([[1.309],
           [0.   ]])
    """
    return np.asarray(_table(overlap_volume, centers1, q1, centers2, q2), dtype=np.float64)


def overlap_table_2d(centers1: ArrayLike, q1: ArrayLike, centers2: ArrayLike, q2: ArrayLike) -> Floats:
    """Computes the area of the intersection of each ellipse of one set with each ellipse of another set; see `overlap_table`.

    Parameters
    ----------
    centers1, q1 : (n, 2) and (n, 3) array_like
        Centres and forms of the first set.
    centers2, q2 : (m, 2) and (m, 3) array_like
        Centres and forms of the second set.

    Returns
    -------
    (n, m) array

    Examples
    --------
    >>> import pypw85
    >>> circle = pypw85.ellipse(1, 1, 0)
    >>> centers = [[0, 0], [1, 0], [3, 0]]
    >>> pypw85.overlap_table_2d([[0, 0]], [circle], centers, [circle] * 3).round(4)
    array([[3.1416, 1.2284, 0.    ]])
    """
    return np.asarray(_table(overlap_area_2d, centers1, q1, centers2, q2), dtype=np.float64)


def _table(function: Any, centers1: ArrayLike, q1: ArrayLike, centers2: ArrayLike, q2: ArrayLike) -> Any:
    first, second = np.asarray(centers1, dtype=np.float64), np.asarray(centers2, dtype=np.float64)
    return function(second[np.newaxis] - first[:, np.newaxis], np.asarray(q1)[:, np.newaxis], np.asarray(q2)[np.newaxis])
