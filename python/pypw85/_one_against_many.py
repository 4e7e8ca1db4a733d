# SPDX-License-Identifier: BSD-3-Clause
"""Tests of one ellipsoid against many others, and the limit up to which nearest images suffice."""

from __future__ import annotations


import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._errors import PW85Error, check_status, last_cause
from ._pairs import ALL_PERIODIC, _cell, _images, _int32, _particles, _rows


def overlap_any_indices(
    center: ArrayLike,
    q1: ArrayLike,
    indices: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> bool:
    """Tests whether an ellipsoid overlaps any of the listed particles of a system, for example after a Monte Carlo trial move.

    With `images`, the function tests one image of each listed particle, as in a neighbour list. Without `images`, the result is valid
    for all images of these particles and of the ellipsoid itself. If the nearest images do not overlap but farther images could
    (`nearest_image_limit` is below 1), the function raises `PW85Error`. In that case pass the images of a neighbour list, and write the
    trial ellipsoid into `centers` and `q` before the call: the list may contain images of the ellipsoid itself, under its own index.

    Parameters
    ----------
    center : (3) array_like
        Centre of the ellipsoid.
    q1 : (6) array_like
        Form of the ellipsoid.
    indices : (n) array_like of int
        Indices of the particles to test, from 0.
    centers, q : (N, 3) and (N, 6) array_like
        Centres and forms of all particles of the system.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell.
    images : (n, 3) array_like of int, optional
        Multiples of the cell vectors to add to the centres of the listed particles.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A particle before the first overlap is invalid, an index is out of range, the cell is singular, or the nearest images do not
        decide.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 3)
    >>> centers = np.array([[0.0, 0, 0], [3, 0, 0], [9, 0, 0]])
    >>> cell = 10 * np.eye(3)
    >>> pypw85.overlap_any_indices(centers[0], q[0], [1, 2], centers, q, cell=cell)
    True
    """
    others = np.asarray(indices)
    if others.size == 0:
        others = np.empty(0, np.int32)
    if others.ndim != 1 or others.dtype.kind not in "iu":
        raise ValueError("indices must be a row of integers")
    one, form = _rows(np.asarray(center)[np.newaxis], 3, "center")[0], _rows(np.asarray(q1)[np.newaxis], 6, "q1")[0]
    points, forms = _particles(centers, q)
    rows, vectors = _int32(others, "indices"), _cell(cell)
    multiples = _images(images, len(others), cell is not None)
    status, overlap = _core.overlap_any_indices(one, form, points, forms, vectors, ALL_PERIODIC, rows, multiples)
    if status:
        r12, q2 = points.take(rows, axis=0, mode="clip") - one, forms.take(rows, axis=0, mode="clip")
        cause = last_cause(cell=vectors, indices=rows.tolist(), r12=r12, q1=form, q2=q2)
        detail = cause.replace("index of a particle", f"index of the {len(points)} particles")
        raise PW85Error(status, "overlap_any_indices", _core.strerror(status), detail)
    return bool(overlap)


def overlap_any(q1: ArrayLike, r12: ArrayLike, q2: ArrayLike) -> bool:
    """Tests whether an ellipsoid overlaps any of n others. The function stops at the first overlap.

    Note the order of the arguments: unlike in functions of pairs, the form `q1` comes before the separations `r12`.

    Parameters
    ----------
    q1 : (6) array_like
        Form of the ellipsoid.
    r12 : (n, 3) array_like
        Centres of the other ellipsoids, relative to the centre of the first one.
    q2 : (n, 6) array_like
        Forms of the other ellipsoids.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A pair before the first overlap is invalid.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.overlap_any(q[0], [[3, 0, 0], [0, 1.5, 0]], q)
    True
    """
    form = _rows(np.asarray(q1)[np.newaxis], 6, "q1")[0]
    separations, forms = _rows(r12, 3, "r12"), _rows(q2, 6, "q2")
    if len(separations) != len(forms):
        raise ValueError(f"{len(separations)} separations, but {len(forms)} forms")
    status, overlap = _core.overlap_any(form, separations, forms)
    check_status(status, "overlap_any", r12=separations, q1=form, q2=forms)
    return bool(overlap)


def nearest_image_limit(q: ArrayLike, cell: ArrayLike) -> float:
    """Computes the limit of μ² below which an image of a pair is always the nearest image.

    If the limit is at least 1, `overlap_pairs` with nearest images misses no overlap. A value of μ² from `contact_pairs`
    that is below the limit is the smallest over all images. In a rectangular cell, the limit is at least 1 if no bounding
    box is wider than half the cell.

    Parameters
    ----------
    q : (n, 6) array_like
        Forms of the particles.
    cell : (3, 3) array_like
        Rows are the vectors of the periodic cell.

    Returns
    -------
    float

    Raises
    ------
    PW85Error
        A form is invalid, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nearest_image_limit([pypw85.spheroid(1, 2, [0, 0, 1])], 8 * np.eye(3))
    1.0
    """
    rows = _cell(cell)
    forms = _rows(q, 6, "q")
    status, limit = _core.nearest_image_limit(forms, rows, ALL_PERIODIC)
    check_status(status, "nearest_image_limit", q=forms, cell=rows)
    return float(limit)
