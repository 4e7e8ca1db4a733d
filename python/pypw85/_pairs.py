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
    images: Optional[ArrayLike] = None,
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
        Rows are the vectors of the periodic cell, in the unit of `centers`. Unless `images` says otherwise, the image of j
        nearest to i (by the distance of the centres) is taken, however skewed the cell. In small cells another one can
        have a smaller μ²: see `nearest_image_limit`.
    out : tuple of two contiguous (k) arrays of float64, optional
        Where to put μ² and λ.
    images : (k, 3) array_like of int, optional
        Multiples of the vectors of the cell, to be added to the centres of j.

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
    arrays = _pair_list(pairs, centers, q, cell, images)
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
    images: Optional[ArrayLike] = None,
) -> NDArray[Any]:
    """Whether the pairs of a neighbour list overlap; see `overlap`.

    Parameters
    ----------
    pairs, centers, q, cell, images
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
    arrays = _pair_list(pairs, centers, q, cell, images)
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
    pairs: ArrayLike, centers: ArrayLike, q: ArrayLike, cell: Optional[ArrayLike], images: Optional[ArrayLike]
) -> tuple[NDArray[np.int32], Floats, Floats, Optional[Floats], Optional[NDArray[np.int32]]]:
    """Contiguous arrays of the types that the library takes."""
    centers = _rows(centers, 3, "centers")
    q = _rows(q, 6, "q")
    if len(centers) != len(q):
        raise ValueError(f"{len(centers)} centers, but {len(q)} forms")
    indices = _indices(pairs, len(centers))
    return indices, centers, q, _cell(cell), _images(images, len(indices), cell is not None)


def _cell(cell: Optional[ArrayLike]) -> Optional[Floats]:
    if cell is None:
        return None
    rows = _rows(cell, 3, "cell")
    if len(rows) != 3:
        raise ValueError(f"cell must have the shape (3, 3), but it is {rows.shape}")
    return rows


def _images(images: Optional[ArrayLike], num_pairs: int, has_cell: bool) -> Optional[NDArray[np.int32]]:
    if images is None:
        return None
    if not has_cell:
        raise ValueError("images are multiples of the vectors of a cell, but there is no cell")
    multiples = np.asarray(images)
    if multiples.size == 0 and num_pairs == 0:
        return np.empty((0, 3), dtype=np.int32)
    if multiples.shape != (num_pairs, 3):
        raise ValueError(f"images must have the shape ({num_pairs}, 3), but it is {multiples.shape}")
    return _int32(multiples, "images")


def _int32(array: NDArray[Any], name: str) -> NDArray[np.int32]:
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, but they are {array.dtype}")
    if not np.array_equal(array, array.astype(np.int32)):
        raise OverflowError(f"{name} must fit into 32 bits")
    return np.require(array, np.int32, ["C", "A"])


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
    status: int,
    pairs: NDArray[np.int32],
    centers: Floats,
    q: Floats,
    cell: Optional[Floats],
    images: Optional[NDArray[np.int32]],
    refused: bool,
) -> None:
    """Raise what fits if the call was refused as a whole."""
    if not refused:
        return
    _check_indices(pairs, len(centers))
    raise ValueError("the cell is singular or not finite" if cell is not None else _core.strerror(status))
