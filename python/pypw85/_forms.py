# SPDX-License-Identifier: BSD-3-Clause
"""Quadratic forms: packed and full matrices, semi-axes and principal directions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import by_rows, plain
from ._errors import named
from ._functions import bounding_boxes
from ._typing import Floats

_PACKED = ([0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2])
_FULL = [0, 1, 2, 1, 3, 4, 2, 4, 5]


def full(q: ArrayLike) -> NDArray[Any]:
    """Converts packed forms to symmetric 3×3 matrices.

    Parameters
    ----------
    q : (..., 6) array_like
        (xx, xy, xz, yy, yz, zz)

    Returns
    -------
    (..., 3, 3) array

    Raises
    ------
    ValueError
        If the last dimension is not 6.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.full([1, 2, 3, 4, 5, 6])
    array([[1, 2, 3],
           [2, 4, 5],
           [3, 5, 6]])
    """
    return by_rows(_full, "full", "(6)->(3,3)", q)


def _full(q: NDArray[Any]) -> NDArray[Any]:
    if q.ndim == 0 or q.shape[-1] != 6:
        raise ValueError(f"full: the last dimension must be 6, not the shape {q.shape}")
    return q[..., _FULL].reshape(q.shape[:-1] + (3, 3))


def packed(matrix: ArrayLike) -> NDArray[Any]:
    """Converts symmetric 3×3 matrices to packed forms: the upper triangle in row-major order.

    Parameters
    ----------
    matrix : (..., 3, 3) array_like
        Symmetric matrices. Corresponding entries on both sides of the diagonal may differ by at most 1e-6 times the
        largest entry, so single precision is enough.

    Returns
    -------
    (..., 6) array
        (xx, xy, xz, yy, yz, zz)

    Raises
    ------
    ValueError
        If the last two dimensions are not 3×3, or a matrix is not symmetric (with dask, when that is computed).

    Examples
    --------
    >>> import pypw85
    >>> pypw85.packed([[1, 2, 3], [2, 4, 5], [3, 5, 6]])
    array([1, 2, 3, 4, 5, 6])
    """
    return by_rows(_packed, "packed", "(3,3)->(6)", matrix)


def _packed(matrix: NDArray[Any]) -> NDArray[Any]:
    if matrix.shape[-2:] != (3, 3):
        raise ValueError(f"packed: the last dimensions must be 3×3, not the shape {matrix.shape}")
    transposed = np.swapaxes(matrix, -1, -2)
    largest = np.abs(matrix).max(axis=(-1, -2), keepdims=True) if matrix.size else 0
    differ = (np.abs(matrix - transposed) > 1e-6 * largest) | (np.isnan(matrix) != np.isnan(transposed))
    if differ.any():
        raise ValueError("packed: a matrix is not symmetric")
    return matrix[(..., *_PACKED)]


def principal_axes(q: ArrayLike) -> tuple[Floats, Floats]:
    """Computes the semi-axes and principal directions of a form. This is the inverse of `ellipsoid`.

    The errors of the eigenvalues of a form are about 1e-16 times the largest eigenvalue. Therefore the relative error of a
    semi-axis that is `k` times shorter than the longest one is about 1e-16 k².

    Parameters
    ----------
    q : (..., 6) array_like
        Positive definite forms.

    Returns
    -------
    semi_axes : (..., 3) array
        In increasing order, in the square root of the unit of `q`.
    rotation : (..., 3, 3) array
        Its columns are the principal directions, right-handed: ``ellipsoid(semi_axes, rotation)`` is `q`.

    Raises
    ------
    PW85Error
        For a single form: it is not finite or not positive definite. In arrays, invalid rows become NaN.

    Examples
    --------
    >>> import pypw85
    >>> semi_axes, rotation = pypw85.principal_axes([4, 0, 0, 1, 0, 9])
    >>> semi_axes
    array([1., 2., 3.])
    >>> abs(rotation)
    array([[0., 1., 0.],
           [1., 0., 0.],
           [0., 0., 1.]])
    """
    form = plain(q).astype(np.float64, casting="same_kind")
    return by_rows(_principal_axes, "principal_axes", "(6)->(3),(3,3)", form)


def _principal_axes(form: Floats) -> tuple[Floats, Floats]:
    if form.ndim == 1:
        with named("principal_axes"):
            bounding_boxes(form)  # refuses a bad form
    finite = np.all(np.isfinite(form), axis=-1, keepdims=True)
    squares, rotation = np.linalg.eigh(_full(np.where(finite, form, 0)))
    # The library decides what is positive definite; a rounding error must not turn the smallest eigenvalue negative.
    with np.errstate(invalid="ignore"):
        good = ~np.isnan(_core.bounding_boxes(form)[..., 0])
    squares = np.maximum(squares, 2.0**-53 * squares[..., -1:])
    rotation[..., 0] *= np.sign(np.linalg.det(rotation))[..., np.newaxis]
    rotation[~good] = np.nan
    return np.sqrt(np.where(good[..., np.newaxis], squares, -1)), rotation
