# SPDX-License-Identifier: BSD-3-Clause
"""Random sequential addition: ellipsoids are put at random places, one after the other, and stay where they overlap none."""

from __future__ import annotations

import time
from typing import Any, NamedTuple, SupportsIndex
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import reals
from ._errors import Status, check_status
from ._numbers import function, integer, real, seed_of
from ._packing import check_axes, check_cell
from ._system import UNIT_BALL, System
from ._typing import Floats
from ._words import counted

# A count of particles that is never reached: indices have 32 bits.
_NO_NUMBER = 2**31 - 1
# Reasons of the library for the end, PW85_ADDITION_...
_ENDS = ("", "saturated", "attempts", "number")


class RandomAddition(NamedTuple):
    """Result of `random_addition`.

    - `system`: the ellipsoids in the order in which they were added. Their types are the numbers of their species, from 1;
    - `attempts`: number of attempts. Attempts at positions that are known to be occupied are not made, but counted by their mean number;
    - `end`: why the addition ended: "saturated", "number", "attempts", "seconds" or "interrupted";
    - `free_share`: upper bound of the fraction of all positions and orientations that are still free; 0 if the packing is saturated.
    """

    system: System
    attempts: float
    end: str
    free_share: float

    @property
    def is_saturated(self) -> bool:
        """True if no other ellipsoid fits at any position and orientation."""
        return self.end == "saturated"

    @property
    def time(self) -> float:
        """Dimensionless time of the addition, which is attempts times mean volume of an ellipsoid, divided by the cell volume."""
        fraction = self.system.packing_fraction
        assert fraction is not None
        return self.attempts * fraction / max(len(self.system), 1)


class AdditionInterrupted(KeyboardInterrupt):
    """Exception of `random_addition`: the user pressed Ctrl-C. It is a KeyboardInterrupt.

    Attributes
    ----------
    result : RandomAddition
        The ellipsoids that had been added until then.
    """

    def __init__(self, result: RandomAddition) -> None:
        super().__init__(result)
        self.result = result

    def __str__(self) -> str:
        return f"{counted(len(self.result.system), 'ellipsoid was', 'ellipsoids were')} added"


def random_addition(
    semi_axes: ArrayLike,
    cell: ArrayLike,
    number: SupportsIndex | None = None,
    seed: SupportsIndex = 0,
    attempts: float | None = None,
    seconds: float | None = None,
    stage: Callable[[str], object] = str,
) -> RandomAddition:
    """Make a packing by random sequential addition (RSA) of ellipses in the plane, or of ellipsoids, in a periodic cell.

    Each attempt draws a species, a position and an orientation, all uniform. The particle is added if it overlaps no earlier particle,
    by the exact test; it then never moves. The packing is saturated if no other particle fits. For ellipses, discs and balls the function
    proves that: it keeps a list of small boxes in the space of positions and angles, deletes a box if an existing particle would overlap
    every particle in it, and divides the others, until no box is left. For other ellipsoids there is no such proof, and a limit must end
    the addition.

    Parameters
    ----------
    semi_axes : (k, 2) or (k, 3) array_like
        One row for each species: two semi-axes of an ellipse, or three of an ellipsoid. All species are tried equally often.
    cell : (2, 2) or (3, 3) array_like
        Rows are the cell vectors. Opposite sides must be at least the longest diameter of a particle apart.
    number : int, optional
        End at this number of particles.
    seed : int
        Seed of the random numbers, from 0 to 2**64 - 1. The same seed gives the same packing, with any number of threads.
    attempts : float, optional
        End after this number of attempts.
    seconds : float, optional
        End after this time. The result then depends on the speed of the machine.
    stage : callable
        Called from time to time with a string that describes the progress. If it raises KeyboardInterrupt, the addition ends as after
        Ctrl-C.

    Returns
    -------
    RandomAddition

    Raises
    ------
    ValueError
        `semi_axes`, `cell`, `seed` or a limit is not allowed; or there is no limit, and the particles are ellipsoids other than balls.
    AdditionInterrupted
        The user pressed Ctrl-C. The exception has the particles that were added until then.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> found = pypw85.random_addition([[1, 0.5]], 30 * np.eye(2), seed=1)
    >>> found.is_saturated, len(found.system.overlaps().mu)
    (True, 0)
    >>> 0.56 < found.system.packing_fraction < 0.6
    True
    """
    axes = reals(semi_axes, "random_addition: semi_axes")
    dimensions = 2 if axes.ndim == 2 and axes.shape[1] == 2 else 3
    check_axes(axes, dimensions)
    shape, volume = check_cell(cell, dimensions)
    _check_room(axes, shape)
    most = _NO_NUMBER if number is None else integer(number, "random_addition: number", 1, _NO_NUMBER)
    key = seed_of(seed, "random_addition: seed")
    function(stage, "random_addition: stage")
    _check_limits(dimensions == 2 or not np.ptp(axes, axis=1).any(), number, attempts, seconds)
    box, kinds = np.eye(3), np.ones((len(axes), 3))
    box[:dimensions, :dimensions], kinds[:, :dimensions] = shape, axes
    kinds[:, dimensions:] = axes.min(axis=1, keepdims=True)
    status, addition = _core.random_addition_create(dimensions, box, kinds, key)
    _check(status, cell=box, semi_axes=kinds)
    share = UNIT_BALL[dimensions] * axes.prod(axis=1).mean() / volume  # of one particle
    limit, start, end = np.inf if attempts is None else float(attempts), time.monotonic(), ""
    try:
        while not end:
            status, reached = _core.random_addition_advance(addition, limit, most)
            _check(status)
            _, added, tried, _ = _core.random_addition_state(addition)
            stage(f"{added} particles, fraction {share * added:.4f}, {tried:.2e} attempts")
            is_late = seconds is not None and time.monotonic() - start >= seconds
            end = _ENDS[reached] if reached or not is_late else "seconds"
    except KeyboardInterrupt:
        raise AdditionInterrupted(_result(addition, kinds, shape, "interrupted")) from None
    return _result(addition, kinds, shape, end)


def _check(status: int, **arguments: Any) -> None:
    if status == Status.ENOMEM:
        raise MemoryError("random_addition: " + _core.strerror(status))
    check_status(status, "random_addition", "ellipsoid", **arguments)


def _check_limits(ends: bool, number: SupportsIndex | None, attempts: float | None, seconds: float | None) -> None:
    """Refuses limits that are not positive, and an addition without limits unless it ends by itself."""
    for name, value in (("attempts", attempts), ("seconds", seconds)):
        if value is not None and not real(value, f"random_addition: {name}") > 0:
            raise ValueError(f"random_addition: {name} must be > 0, not {value}")
    if not ends and number is None and attempts is None and seconds is None:
        raise ValueError("saturation is proved for ellipses and balls only: pass number, attempts or seconds for other ellipsoids")


def _check_room(axes: Floats, shape: Floats) -> None:
    """Refuses a cell in which an ellipsoid may overlap its own image."""
    height, diameter = 1 / np.linalg.norm(np.linalg.inv(shape), axis=0).max(), 2 * axes.max()
    if height < diameter * (1 + 1e-9):
        raise ValueError(f"opposite sides of the cell must be at least {diameter:g}, the longest diameter, apart, not {height:g}")


def _result(addition: Any, kinds: Floats, shape: Floats, end: str) -> RandomAddition:
    _, added, attempts, free_share = _core.random_addition_state(addition)
    centers, quaternions, which = np.empty((added, 3)), np.empty((added, 4)), np.empty(added, np.int32)
    _core.random_addition_particles(addition, centers, quaternions, which)
    dimensions = len(shape)
    cell, origin = np.eye(3), np.array([0.0, 0.0, -0.5 if dimensions == 2 else 0.0])
    cell[:dimensions, :dimensions] = shape
    types = which.astype(np.int64) + 1
    system = System.from_axes(centers, kinds[which], quaternions, cell=cell, types=types, origin=origin, dimensions=dimensions)
    return RandomAddition(system, attempts, end, free_share)


AdditionInterrupted.__module__ = "pypw85"
