# SPDX-License-Identifier: BSD-3-Clause
"""One ellipsoid against many others, and where nearest images decide for all images."""

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
    """Decides whether an ellipsoid overlaps any of the given particles of a system, as the test of a Monte Carlo move.

    Without `images` the answer is about all images of the others, and of the one itself: an error where none of the nearest ones
    overlaps, but others could (`nearest_image_limit` of the one and the others is below 1). There, take the images of a neighbour
    list, and write the trial into `centers` and `q` before the call, since its own index refers to images of itself.

    Parameters
    ----------
    center : (3) array_like
        Centre of the one.
    q1 : (6) array_like
        Its form.
    indices : (n) array_like of int
        The others.
    centers, q : (N, 3) and (N, 6) array_like
        All particles.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell.
    images : (n, 3) array_like of int, optional
        Multiples of the vectors of the cell, to be added to the centres of the others.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A pair that no overlap precedes is bad, an index is out of range, the cell is singular, or nearest images do not decide.
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
    """Decides whether an ellipsoid overlaps any of n others. Tests one after the other, up to the first overlap.

    Unlike in functions of pairs, the form of the one ellipsoid comes first, before the separations.

    Parameters
    ----------
    q1 : (6) array_like
        Form of the one.
    r12 : (n, 3) array_like
        Centres of the others, relative to that of the one.
    q2 : (n, 6) array_like
        Their forms.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A pair that no overlap precedes is bad.
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
    """Up to which μ² nearest images are all there is: any image of a pair with a smaller μ² is the nearest one.

    Where the limit is 1 or more, `overlap_pairs` with nearest images misses no overlap; a smaller μ² from `contact_pairs`
    than the limit is the smallest of all images. In a rectangular cell, the limit is at least 1 where no bounding box is
    wider than half the cell.

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
        A form is bad, or the cell is singular or not finite.

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
