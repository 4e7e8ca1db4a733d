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
    """Result of `first_contact_pairs` for k pairs and n particles.

    - `time` (k): time of the first contact of each pair; infinity without a contact, NaN for an invalid pair;
    - `next_time` (n): the earliest of these times over the pairs of each particle;
    - `next_pair` (n): index of the pair to which this time belongs; -1 without a contact.
    """

    time: Floats
    next_time: Floats
    next_pair: NDArray[np.int64]


def motion(
    velocity: ArrayLike = (0.0, 0.0, 0.0), angular_velocity: ArrayLike = (0.0, 0.0, 0.0), growth: ArrayLike = 0.0
) -> Floats:
    """Packs the motions of ellipsoids into one array, one row for each ellipsoid.

    Parameters
    ----------
    velocity : (..., 3) array_like
        Velocity of the centre, in units of length per unit of time.
    angular_velocity : (..., 3) array_like
        Angular velocity about the centre, in radians per unit of time.
    growth : (...) array_like
        Growth rate: at time t the semi-axes are 1 + growth·t times those at time 0.

    Returns
    -------
    (..., 7) array
        Velocity, angular velocity and growth, for `first_contact` and `first_contact_pairs`. The arguments broadcast.

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
    """Computes the first contacts of the pairs of a list (see `first_contact`), and the next contact of each particle.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`. Each pair refers to the same image at all times.
    motions : (n, 7) array_like
        Motions of the particles, from `motion`.
    t_max : number, optional
        End of the time interval in which contacts are searched, >= 0. By default there is no end.

    Returns
    -------
    Events
        For invalid pairs NumPy warns, or does what ``np.errstate(invalid=...)`` selects.

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
