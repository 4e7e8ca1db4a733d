# SPDX-License-Identifier: BSD-3-Clause
"""Ellipsoids that move: the time of the first contact."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._documentation import documented
from ._pairs import _pair_list, _rows, check_list
from ._typing import Floats


class Events(NamedTuple):
    """First contacts of pairs, and the next one of each particle."""

    time: Floats
    next_time: Floats
    next_pair: NDArray[np.int64]


def motion(
    velocity: ArrayLike = (0.0, 0.0, 0.0), angular_velocity: ArrayLike = (0.0, 0.0, 0.0), growth: ArrayLike = 0.0
) -> Floats:
    """Motions of ellipsoids, in one row each.

    Parameters
    ----------
    velocity : (..., 3) array_like
        Of the centres.
    angular_velocity : (..., 3) array_like
        About the centres, in radians per unit of time.
    growth : (...) array_like
        At time t the semi-axes are 1 + growth·t times those at time 0.

    Returns
    -------
    (..., 7) array
        Velocity, angular velocity and growth.

    Examples
    --------
    >>> import pypw85
    >>> pypw85.motion([1, 2, 3], growth=0.5)
    array([1. , 2. , 3. , 0. , 0. , 0. , 0.5])
    """
    v, w, g = (np.asarray(x, dtype=np.float64) for x in (velocity, angular_velocity, growth))
    leading = np.broadcast_shapes(v.shape[:-1], w.shape[:-1], g.shape)
    rows = np.empty((*leading, 7))
    rows[..., :3], rows[..., 3:6], rows[..., 6] = v, w, g
    return rows


@documented
def first_contact_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    motions: ArrayLike,
    t_max: float = np.inf,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> Events:
    """`first_contact` for the pairs of a neighbour list, and the next event of each particle.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`. A pair refers to one image throughout, that of time 0.
    motions : (n, 7) array_like
        Motions of the particles, from `motion`.
    t_max : number, optional
        The time up to which contacts count, >= 0.

    Returns
    -------
    Events
        A named tuple: `time` (k) of each pair, infinity where there is no contact and NaN for a bad pair, which NumPy
        reports as ``np.errstate(invalid=...)`` says; `next_time` (n), the least time of each particle's pairs; and
        `next_pair` (n), the index of that pair, or -1.

    {raises_pair_list}

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 3)
    >>> motions = pypw85.motion([[1, 0, 0], [0, 0, 0], [0, 0, 0]])
    >>> pairs, centers = [[0, 1], [0, 2]], [[0, 0, 0], [5, 0, 0], [4, 0, 0]]
    >>> events = pypw85.first_contact_pairs(pairs, centers, q, motions)
    >>> events.time, events.next_pair
    (array([3., 2.]), array([1, 0, 1]))
    """
    arrays = _pair_list(pairs, centers, q, cell, images)
    rows = _rows(motions, 7, "motions")
    if len(rows) != len(arrays.centers):
        raise ValueError(f"{len(arrays.centers)} centers, but {len(rows)} motions")
    n, num_particles = len(arrays.pairs), len(rows)
    result = Events(np.empty(n), np.empty(num_particles), np.empty(num_particles, dtype=np.int64))
    status = _core.first_contact_pairs(*arrays, rows, float(t_max), *result)
    check_list(status, "first_contact_pairs", arrays)
    return result
