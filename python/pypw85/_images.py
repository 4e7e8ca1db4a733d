# SPDX-License-Identifier: BSD-3-Clause
"""Labelled images: grains as the ellipsoids that have their moments."""

from __future__ import annotations

import itertools
import warnings
from typing import Any, NamedTuple
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import reals
from ._conversions import from_moments
from ._forms import principal_axes
from ._system import UNIT_BALL, System, quaternions_of
from ._typing import Floats
from ._words import counted

# Pixels that are looked at together
_BLOCK = 1 << 20
# Labels up to here are looked up in a table, others by bisection.
_LARGEST_TABLE = 1 << 24
_LARGEST_LABEL = 2**53
# A thinner grain, in pixels, is known by few of them.
_THIN = 2.0
# Of all bodies with the same second moments, the ellipsoid is the largest. A cube fills 0.89 of its ellipsoid, two balls that touch 0.82; a
# label that fills less than half is far from convex, or in parts that lie apart.
_FILLED = 0.5
# The channels of a colour picture
_CHANNELS = (3, 4)


class _Moments(NamedTuple):
    """Of each label, in pixels: how many there are, the mean place, and the covariance of their centres."""

    labels: NDArray[np.int64]
    counts: Floats
    means: Floats
    covariances: Floats


def from_labels(image: ArrayLike, spacing: ArrayLike = 1.0, origin: ArrayLike = 0.0) -> System:
    """Converts a labelled image to a system: each grain becomes the ellipsoid (ellipse) with its centre and second moments.

    The moments are those of the centres of the pixels. If a pixel has the label of the grain at its centre, this is right on average, and
    no term for the size of the pixels is added. (The union of the pixels, as squares or cubes, has variances along the axes that are
    larger by 1/12 of a pixel squared.)

    Parameters
    ----------
    image : (m, n) or (l, m, n) array_like of int
        A label for each pixel or voxel; 0 is the background. The image is read in blocks, so it may be a memory map.
    spacing : number or one for each dimension
        Distance between two pixels, > 0; it sets the unit of length.
    origin : number or one for each dimension
        Position of the centre of the first pixel. For images made by `voxels`, this is the corner of the cell plus half a voxel.

    Returns
    -------
    System
        Its ids are the labels. x is along the first dimension of the image, y along the second. Transpose images whose first index is y or
        z, such as those of scikit-image and TIFF files: ``image.T``. A grain that is cut by the border of the image is not completed.
        `notes`, also given as warnings, name the grains that are thinner than two pixels, and those that fill less than half of their
        ellipsoid, for instance because the label consists of several parts.

    Raises
    ------
    ValueError
        There are no labels, or they are not integers, or negative, or beyond 2⁵³; the image is a mask or a colour picture, or has
        neither two nor three dimensions; the spacing is not positive; or all pixels of a label lie in a plane or on a line.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> x, y = np.indices((60, 40))
    >>> image = np.where(((x - 30) / 20)**2 + ((y - 18) / 10)**2 <= 1, 7, 0)
    >>> system = pypw85.from_labels(image, spacing=0.5)
    >>> system.ids, system.centers, system.semi_axes[:, :2].round()
    (array([7]), array([[15.,  9.,  0.]]), array([[10.,  5.]]))
    """
    labels = np.ma.filled(image, 0) if np.ma.isMaskedArray(image) else np.asarray(image)
    _check_image(labels)
    n = labels.ndim
    steps, start = _numbers(spacing, n, "spacing"), _numbers(origin, n, "origin")
    if not (steps > 0).all():
        raise ValueError(f"from_labels: the spacing must be > 0, not {steps.tolist()}")
    found = _moments(labels)
    notes = _check_shapes(found, labels)
    q = from_moments(found.covariances * steps[:, None] * steps)
    system = _system(found.means * steps + start, q, found.labels)
    system.source = (f"labels of an image of {' × '.join(map(str, labels.shape))} as ids, x along the first dimension, "
                     f"pixels {' × '.join(f'{step:g}' for step in steps)} apart, semi-axes of uniform bodies by "
                     "second moments")  # fmt: skip
    system.notes = notes
    for note in notes:
        warnings.warn(note, stacklevel=2)
    return system


def _numbers(values: ArrayLike, n: int, name: str) -> Floats:
    numbers = reals(values, f"from_labels: {name}")
    if numbers.shape not in ((), (n,)) or not np.isfinite(numbers).all():
        raise ValueError(f"from_labels: the {name} must be a finite number, or {n} of them, not {numbers.tolist()}")
    return np.broadcast_to(numbers, n)


def _check_image(labels: NDArray[Any]) -> None:
    if labels.ndim == 0 and labels.dtype.kind in "SU":
        raise TypeError(f"from_labels: image must be an array of integers, not the text {str(labels)[:40]!r}: read a file with pypw85.read")
    if labels.ndim not in (2, 3):
        raise ValueError(f"from_labels: the image must have two or three dimensions, not the shape {labels.shape}")
    if labels.dtype.kind == "b":
        raise ValueError("from_labels: the image is a mask, without labels: label its parts first (scipy.ndimage.label)")
    if labels.dtype.kind not in "iu":
        raise ValueError(f"from_labels: labels must be integers, not {labels.dtype}: convert them (image.astype(int))")
    channels = [size for size in labels.shape[::-2] if size in _CHANNELS]  # behind the pixels, or before them
    if labels.ndim == 3 and labels.dtype == np.uint8 and channels and sorted(labels.shape)[1] > max(_CHANNELS):
        raise ValueError(f"from_labels: the shape {labels.shape} of bytes is that of a colour picture: label its grains first, or "
                         f"convert it if these are labels in {channels[0]} planes (image.astype(int))")  # fmt: skip


def _blocks(image: NDArray[Any]) -> Iterator[tuple[NDArray[np.int64], list[NDArray[np.intp]]]]:
    """Labels that are not 0, and the places of their pixels, for some slices after the other."""
    thickness = max(1, _BLOCK // max(1, image[:1].size))
    for first in range(0, len(image), thickness):
        block = np.asarray(image[first : first + thickness])
        places = np.nonzero(block)
        labels = block[places]
        if labels.size and not 0 < labels.min() <= labels.max() <= _LARGEST_LABEL:
            wrong = int(((labels < 0) | (labels > _LARGEST_LABEL)).argmax())
            place = [int(one[wrong]) + first * (axis == 0) for axis, one in enumerate(places)]
            raise ValueError(f"from_labels: labels must be from 0 to 2⁵³, not {labels[wrong]} at {place}: renumber the labels")
        yield labels.astype(np.int64), [places[0] + first, *places[1:]]


def _names(image: NDArray[Any]) -> NDArray[np.int64]:
    """The labels that occur, in increasing order."""
    seen, large = np.zeros(1, dtype=np.intp), [np.empty(0, dtype=np.int64)]
    for labels, _ in _blocks(image):
        if labels.max(initial=0) < _LARGEST_TABLE:
            counts = np.bincount(labels, minlength=len(seen))
            counts[: len(seen)] += seen
            seen = counts
        else:
            large.append(np.unique(labels))
    names: NDArray[np.int64] = np.unique(np.concatenate([np.flatnonzero(seen), *large]))
    return names


def _moments(image: NDArray[Any]) -> _Moments:
    """The sums are of whole numbers, and exact up to 2⁵³."""
    names = _names(image)
    if not names.size:
        raise ValueError(
            f"from_labels: the image must have labels, not background alone ({image.size} pixels): label the grains 1, 2 and so on"
        )
    n = image.ndim
    counts, sums, products = np.zeros(len(names)), np.zeros((n, len(names))), np.zeros((n, n, len(names)))
    table = np.zeros(names[-1] + 1, dtype=np.intp) if names[-1] < _LARGEST_TABLE else None
    if table is not None:
        table[names] = np.arange(len(names))
    for labels, places in _blocks(image):
        codes = np.searchsorted(names, labels) if table is None else table[labels]
        numbers = [one.astype(np.float64) for one in places]
        counts += np.bincount(codes, minlength=len(names))
        for i in range(n):
            sums[i] += np.bincount(codes, numbers[i], len(names))
        for i, j in itertools.combinations_with_replacement(range(n), 2):
            products[i, j] += np.bincount(codes, numbers[i] * numbers[j], len(names))
    for i, j in itertools.combinations(range(n), 2):
        products[j, i] = products[i, j]
    means = sums / counts
    covariances = products / counts - means[:, None] * means
    return _Moments(names, counts, means.T, np.moveaxis(covariances, -1, 0))


def _check_shapes(found: _Moments, image: NDArray[Any]) -> tuple[str, ...]:
    """Refuses masks and flat grains. Sentences on thin grains, and on labels that are not bodies like ellipsoids."""
    if image.dtype == np.uint8 and found.labels.tolist() == [255]:
        raise ValueError("from_labels: the only label is 255, so the image is a mask: label its parts first (scipy.ndimage.label)")
    variances = np.linalg.eigvalsh(found.covariances)
    smallest = variances[:, 0]
    # The mean square and the square of the mean, up to size², err by some rounding errors each.
    flat = smallest <= 64 * 2.0**-53 * max(image.shape) ** 2
    if flat.any():
        raise ValueError(f"from_labels: all pixels of the label {_listed(found.labels[flat])} lie in a plane or on a line, and "
                         "have no volume: set these labels to 0, or remove small objects first")  # fmt: skip
    semi_axes = np.sqrt((image.ndim + 2) * variances)
    thin = 2 * semi_axes[:, 0] < _THIN
    sparse = found.counts < _FILLED * UNIT_BALL[image.ndim] * semi_axes.prod(axis=1)
    notes = []
    if thin.any():
        notes.append(f"{counted(int(thin.sum()), 'grain is', 'grains are')} thinner than two pixels, which makes shapes uncertain: those "
                     f"of the label {_listed(found.labels[thin])}; use smaller pixels, or remove small objects first")  # fmt: skip
    if sparse.any():
        notes.append(f"{counted(int(sparse.sum()), 'grain fills', 'grains fill')} less than half of the ellipsoid with the same moments: "
                     f"those of the label {_listed(found.labels[sparse])}; check whether such a label has several parts")  # fmt: skip
    return tuple(notes)


def _listed(labels: NDArray[np.int64]) -> str:
    more = f" and {counted(len(labels) - 5, 'other')}" if len(labels) > 5 else ""
    return ", ".join(map(str, labels[:5])) + more


def _system(centers: Floats, q: Floats, labels: NDArray[np.int64]) -> System:
    if q.shape[1] == 6:
        semi_axes, rotation = principal_axes(q)
        return System.from_axes(centers, semi_axes, quaternions_of(rotation), ids=labels)
    squares, axes = np.linalg.eigh(q[:, [[0, 1], [1, 2]]])
    angles = np.arctan2(axes[:, 1, 1], axes[:, 0, 1])
    return System.from_ellipses(centers, np.sqrt(squares[:, ::-1]), angles, ids=labels)
