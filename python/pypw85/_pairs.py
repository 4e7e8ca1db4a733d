"""Pairs of a neighbour list, in a periodic cell or not."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core

Floats = NDArray[np.float64]

# No result has these values: where one is still there after a call, the call was refused as a whole.
_NO_MU2 = -1.0
_NO_CODE = 254


def contact_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: Optional[ArrayLike] = None,
    out: Optional[tuple[Floats, Floats]] = None,
) -> tuple[Floats, Floats]:
    """Contact function for the pairs of a neighbour list; see `contact`.

    Parameters
    ----------
    pairs : (k, 2) array_like of int
        Indices (i, j) of particles, from 0. Contiguous int32 is used as it is, anything else copied.
    centers : (n, 3) array_like
        Centres of the particles.
    q : (n, 6) array_like
        Their forms, in the square of the unit of `centers`.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell, in the unit of `centers`. Of all images of j the nearest to i (by the
        distance of the centres) is taken, however skewed the cell.
    out : tuple of two contiguous (k) arrays of float64, optional
        Where to put μ² and λ.

    Returns
    -------
    mu2, lambda_ : (k) arrays
        NaN for a bad pair (see `bad_rows`), which NumPy reports as ``np.errstate(invalid=...)`` says.

    Raises
    ------
    IndexError
        An index is not in [0, n).
    ValueError
        Shapes do not match, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.contact_pairs([[0, 1]], [[0, 0, 0], [9, 0, 0]], q, cell=10 * np.eye(3))
    (array([0.25]), array([0.5]))
    """
    arrays = _pair_list(pairs, centers, q, cell)
    mu2, lambda_ = out if out is not None else (np.empty(len(arrays[0])), np.empty(len(arrays[0])))
    if mu2.size:
        mu2.flat[0] = _NO_MU2
    status = _core.contact_pairs(*arrays, mu2, lambda_)
    if status:
        _explain(status, *arrays, refused=mu2.size == 0 or mu2[0] == _NO_MU2)
        _core.report_contact_pairs(status)
    return mu2, lambda_


def overlap_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: Optional[ArrayLike] = None,
    dtype: DTypeLike = np.bool_,
) -> NDArray[Any]:
    """Whether the pairs of a neighbour list overlap; see `overlap`.

    Parameters
    ----------
    pairs, centers, q, cell
        As for `contact_pairs`.
    dtype : bool or uint8
        As for `overlap`: with ``np.uint8`` the result is 1, 0, or 255 for a bad pair.

    Returns
    -------
    (k) array of `dtype`
        A bad pair counts as an overlap; NumPy reports it as ``np.errstate(invalid=...)`` says.

    Raises
    ------
    IndexError
        An index is not in [0, n).
    ValueError
        Shapes do not match, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.overlap_pairs([[0, 1]], [[0, 0, 0], [9, 0, 0]], q)
    array([False])
    >>> pypw85.overlap_pairs([[0, 1]], [[0, 0, 0], [9, 0, 0]], q, cell=10 * np.eye(3))
    array([ True])
    """
    if np.dtype(dtype) not in (np.dtype(np.bool_), np.dtype(np.uint8)):
        raise TypeError("overlap_pairs: dtype must be bool or uint8")
    arrays = _pair_list(pairs, centers, q, cell)
    codes = np.full(len(arrays[0]), _NO_CODE, dtype=np.uint8)
    status = _core.overlap_pairs(*arrays, codes)
    if status:
        _explain(status, *arrays, refused=codes.size == 0 or codes[0] == _NO_CODE)
        _core.report_overlap_pairs(status)
    if np.dtype(dtype) == np.uint8:
        return codes
    np.minimum(codes, 1, out=codes)
    return codes.view(np.bool_)


def _pair_list(
    pairs: ArrayLike, centers: ArrayLike, q: ArrayLike, cell: Optional[ArrayLike]
) -> tuple[NDArray[np.int32], Floats, Floats, Optional[Floats]]:
    """Contiguous arrays of the types that the library takes."""
    centers = _rows(centers, 3, "centers")
    q = _rows(q, 6, "q")
    if len(centers) != len(q):
        raise ValueError(f"{len(centers)} centers, but {len(q)} forms")
    if cell is not None:
        cell = _rows(cell, 3, "cell")
        if len(cell) != 3:
            raise ValueError(f"cell must have the shape (3, 3), but it is {cell.shape}")
    return _indices(pairs, len(centers)), centers, q, cell


def _rows(array: ArrayLike, columns: int, name: str) -> Floats:
    rows = np.require(array, np.float64, ["C", "A"])
    if rows.ndim != 2 or rows.shape[1] != columns:
        raise ValueError(f"{name} must have {columns} columns, but the shape is {rows.shape}")
    return rows


def _indices(pairs: ArrayLike, num_particles: int) -> NDArray[np.int32]:
    indices = np.asarray(pairs)
    if indices.size == 0:
        return np.empty((0, 2), dtype=np.int32)
    if indices.ndim != 2 or indices.shape[1] != 2:
        raise ValueError(f"pairs must have 2 columns, but the shape is {indices.shape}")
    if indices.dtype.kind not in "iu":
        raise TypeError(f"pairs must be integers, but they are {indices.dtype}")
    if indices.dtype != np.int32:
        _check_indices(indices, num_particles)
    return np.require(indices, np.int32, ["C", "A"])


def _check_indices(indices: NDArray[Any], num_particles: int) -> None:
    outside = ((indices < 0) | (indices >= num_particles)).any(axis=1)
    if outside.any():
        first = int(outside.argmax())
        raise IndexError(f"pair {first} is {tuple(indices[first].tolist())}, but there are {num_particles} particles")


def _explain(
    status: int, pairs: NDArray[np.int32], centers: Floats, q: Floats, cell: Optional[Floats], refused: bool
) -> None:
    """Raise what fits if the call was refused as a whole."""
    if not refused:
        return
    _check_indices(pairs, len(centers))
    raise ValueError("the cell is singular or not finite" if cell is not None else _core.strerror(status))
