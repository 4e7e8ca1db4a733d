# SPDX-License-Identifier: BSD-3-Clause
"""Functions of lists of pairs, with or without a periodic cell."""

from __future__ import annotations

from typing import Any, NamedTuple, NoReturn, cast
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._arrays import check_out, reals
from ._device import apply_to_pairs, is_device_array
from ._documentation import documented
from ._errors import describe
from ._explanations import form_hint
from ._typing import Floats
from ._words import counted

ALL_PERIODIC = np.ones(3, np.int32)  # all vectors of a cell


class PairList(NamedTuple):
    """Pairs and their system, in the order of the arguments of the compiled functions."""

    pairs: NDArray[np.int32]
    images: NDArray[np.int32] | None
    centers: Floats
    q: Floats | None
    cell: Floats | None
    periodic: NDArray[np.int32] = ALL_PERIODIC


@documented
def contact_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    out: tuple[Floats, Floats] | None = None,
    images: ArrayLike | None = None,
) -> tuple[Floats, Floats]:
    """Computes the contact function of the pairs of a list; see `contact`. Dask arrays are computed immediately.

    Parameters
    ----------
    {pair_list}
    out : tuple of two contiguous (k) arrays of float64, optional
        Output arrays for μ² and λ.

    Returns
    -------
    mu2, lambda_ : (k) arrays
        NaN for an invalid pair (see `bad_rows`). NumPy then warns, or does what ``np.errstate(invalid=...)`` selects.

    {raises_pair_list}

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.contact_pairs([[0, 1]], [[0, 0, 0], [9, 0, 0]], q, cell=10 * np.eye(3))
    (array([0.25]), array([0.5]))
    """
    if is_device_array(pairs):
        if out is not None:
            raise TypeError("contact_pairs: 'out' is not supported for arrays on a GPU")
        return cast("tuple[Floats, Floats]", apply_to_pairs("contact", pairs, centers, q, _cell(cell), images))
    arrays = _pair_list(pairs, centers, q, cell, images)
    mu2, lambda_ = _outputs(out, len(arrays.pairs))
    status = _core.contact_pairs(*arrays, mu2, lambda_)
    check_list(status, "contact_pairs", arrays)
    return mu2, lambda_


@documented
def overlap_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    dtype: DTypeLike = np.bool_,
    images: ArrayLike | None = None,
) -> NDArray[Any]:
    """Tests whether the pairs of a list overlap; see `overlap`. Dask arrays are computed immediately.

    Parameters
    ----------
    {pair_list}
    dtype : bool or uint8
        With ``np.uint8`` the result is 1, 0, or 255 for an invalid pair.

    Returns
    -------
    array (k) of `dtype`
        An invalid pair counts as an overlap. NumPy then warns, or does what ``np.errstate(invalid=...)`` selects.

    {raises_pair_list}

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
    if is_device_array(pairs):
        return cast("NDArray[Any]", apply_to_pairs("overlap", pairs, centers, q, _cell(cell), images, dtype))
    arrays = _pair_list(pairs, centers, q, cell, images)
    codes = np.empty(len(arrays.pairs), dtype=np.uint8)
    status = _core.overlap_pairs(*arrays, codes)
    check_list(status, "overlap_pairs", arrays, report=_core.report_overlap_pairs)
    if np.dtype(dtype) == np.uint8:
        return codes
    np.minimum(codes, 1, out=codes)
    return codes.view(np.bool_)


@documented
def overlap_volume_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> Floats:
    """Computes the volumes of the intersections of the pairs of a list; see `overlap_volume`.

    The sum of these volumes counts a region that is inside three ellipsoids three times. Dask arrays are computed immediately.

    Parameters
    ----------
    {pair_list}

    Returns
    -------
    array (k)
        NaN for an invalid pair. NumPy then warns, or does what ``np.errstate(invalid=...)`` selects.

    {raises_pair_list}

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> centers = [[0, 0, 0], [9, 0, 0]]
    >>> pypw85.overlap_volume_pairs([[0, 1]], centers, q, cell=10 * np.eye(3)).round(4)
    array([1.309])
    """
    arrays = _pair_list(pairs, centers, q, cell, images)
    volume = np.empty(len(arrays.pairs))
    status = _core.overlap_volume_pairs(*arrays, volume)
    check_list(status, "overlap_volume_pairs", arrays, report=_core.report_overlap_volume_pairs)
    return volume


@documented
def nearest_images(
    pairs: ArrayLike, centers: ArrayLike, cell: ArrayLike
) -> tuple[Floats, NDArray[np.int32]]:
    """Computes the nearest images that the functions of pair lists use if `images` is not given.

    Parameters
    ----------
    pairs : (k, 2) array_like of int
        Indices (i, j) of particles, from 0.
    centers : (n, 3) array_like
        Centres of the particles.
    cell : (3, 3) array_like
        Rows are the vectors of the periodic cell.

    Returns
    -------
    r12 : (k, 3) array
        Vectors from particle i to the image of particle j; NaN for an invalid pair, such as one with a centre that is not finite.
    images : (k, 3) array of int32
        Multiples of the cell vectors to add to the centre of j, for the argument `images`; -2³¹ for an invalid pair, such as one
        whose centres are too many cells apart.

    {raises_pair_list}

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nearest_images([[0, 1]], [[0, 0, 0], [9, 0, 0]], 10 * np.eye(3))
    (array([[-1.,  0.,  0.]]), array([[-1,  0,  0]], dtype=int32))
    """
    arrays = _pair_list(pairs, centers, None, cell, None)
    r12, images = np.empty((len(arrays.pairs), 3)), np.empty((len(arrays.pairs), 3), dtype=np.int32)
    status = _core.nearest_images(arrays.pairs, arrays.centers, arrays.cell, arrays.periodic, r12, images)
    check_list(status, "nearest_images", arrays, report=lambda status: None)
    return r12, images


def _outputs(out: Any, count: int) -> tuple[Floats, Floats]:
    if out is None:
        return np.empty(count), np.empty(count)
    if not isinstance(out, tuple) or len(out) != 2 or any(array is None for array in out):
        raise TypeError("contact_pairs: 'out' must be a tuple of two arrays")
    check_out(out, "contact_pairs")
    return out[0], out[1]


def _pair_list(
    pairs: ArrayLike, centers: ArrayLike, q: ArrayLike | None, cell: ArrayLike | None, images: ArrayLike | None
) -> PairList:
    """Converts arrays to contiguous arrays of the types of the C functions, without a copy if possible. `q` may be None."""
    rows, forms = (_rows(centers, 3, "centers"), None) if q is None else _particles(centers, q)
    indices = _indices(pairs, len(rows))
    return PairList(indices, _images(images, len(indices), cell is not None), rows, forms, _cell(cell))


def _particles(centers: ArrayLike, q: ArrayLike) -> tuple[Floats, Floats]:
    centers = _rows(centers, 3, "centers")
    q = _rows(q, 6, "q")
    if len(centers) != len(q):
        raise ValueError(f"{counted(len(centers), 'center')}, but {counted(len(q), 'form')}")
    return centers, q


def _cell(cell: ArrayLike | None) -> Floats | None:
    if cell is None:
        return None
    rows = reals(cell, "cell")
    if rows.shape != (3, 3):
        raise ValueError(f"cell must be three vectors of three numbers, one in each row, not an array of the shape {rows.shape}")
    rows = _rows(rows, 3, "cell")
    return rows


def _images(images: ArrayLike | None, num_pairs: int, has_cell: bool) -> NDArray[np.int32] | None:
    if images is None:
        return None
    multiples = np.asarray(images)
    if not has_cell:
        if np.any(multiples):
            raise ValueError("images are multiples of the cell vectors: pass cell, too")
        return None
    if multiples.size == 0 and num_pairs == 0:
        return np.empty((0, 3), dtype=np.int32)
    if multiples.shape != (num_pairs, 3):
        raise ValueError(f"the shape of images must be ({num_pairs}, 3), not {multiples.shape}")
    return _int32(multiples, "images")


def _int32(array: NDArray[Any], name: str) -> NDArray[np.int32]:
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, not {array.dtype}")
    if array.dtype != np.int32 and not np.array_equal(array, array.astype(np.int32)):
        raise OverflowError(f"{name} must fit into 32 bits")
    return np.require(array, np.int32, ["C", "A"])


def _rows(array: ArrayLike, columns: int, name: str) -> Floats:
    rows = reals(array, name)
    if rows.ndim != 2 or rows.shape[1] != columns:
        hint = form_hint(rows.shape, (columns,))
        single = f": for a single one use the shape (1, {columns})" if rows.shape == (columns,) else hint
        raise ValueError(f"{name} must be rows of {columns} numbers, not an array of the shape {rows.shape}{single}")
    return np.require(rows, np.float64, ["C", "A"])


def _indices(pairs: ArrayLike, num_particles: int) -> NDArray[np.int32]:
    if np.ma.is_masked(pairs):
        raise TypeError("pairs must not be masked")
    indices = np.asarray(pairs)
    if indices.size == 0 and indices.shape in ((0,), (0, 2)):
        return np.empty((0, 2), dtype=np.int32)
    if indices.ndim != 2 or indices.shape[1] != 2:
        raise ValueError(f"pairs must have 2 columns, not the shape {indices.shape}")
    if indices.dtype.kind not in "iu":
        raise TypeError(f"pairs must be integers, not {indices.dtype}")
    if indices.dtype != np.int32:
        _check_indices(indices, num_particles)
    return np.require(indices, np.int32, ["C", "A"])


def _check_indices(indices: NDArray[Any], num_particles: int) -> None:
    outside = ((indices < 0) | (indices >= num_particles)).any(axis=1)
    if outside.any():
        _refuse_pair(int(outside.argmax()), indices, num_particles)


def _refuse_pair(pair: int, indices: NDArray[Any], num_particles: int) -> NoReturn:
    raise IndexError(f"pair {pair} is {tuple(indices[pair].tolist())}, but there are {num_particles} particles")


def check_list(
    status: int, name: str, arrays: PairList, report: Callable[[int], None] = _core.report_contact_pairs, **others: Any
) -> None:
    """Raises the exception for a call that failed as a whole, with the cause from the library. If single pairs are invalid, calls
    report(status) instead: the cause is then that of one pair, or of its centres."""
    if not status:
        return
    cause = _core.last_error()
    if cause is None or cause[0] != f"pw85_{name}" or cause[1] == "centers":
        report(status)
    elif cause[1] == "pairs":
        _refuse_pair(cause[3], arrays.pairs, len(arrays.centers))
    else:
        raise ValueError(f"{name}: {describe(cause, cell=arrays.cell, **others)}")
