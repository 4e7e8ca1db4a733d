# SPDX-License-Identifier: BSD-3-Clause
"""Equilibration of a simulation until its averages stop drifting."""

from __future__ import annotations

from collections.abc import Mapping
from typing import SupportsIndex

import numpy as np

from ._numbers import integer
from ._observables import Observables
from ._simulations import HardEllipsoids
from ._typing import Floats

# Each window is twice as long as the one before. Four windows take 15 times the sweeps of the first one.
_WINDOWS = 4
# Samples per window: twice the 32 that a test of a drift needs, so their blocks are 8, 16 and 32.
_SAMPLES = 64


class Equilibration:
    """Windows of sweeps before a run. The last one is the first in which no average drifts or is slow.

    The windows have `first`, 2 `first`, 4 `first` and 8 `first` sweeps. A new window forgets the samples of the one before. After a window
    the averages of `Observables` are tested by `Observables.unsettled`. The windows end if the test passes, and after the fourth.

    Parameters
    ----------
    first : int
        Sweeps of the first window, at least 1. A window of fewer than 32 sweeps never passes the test.
    width : float
        As for `Observables`.
    """

    def __init__(self, first: SupportsIndex, width: float) -> None:
        self.first, self._width = integer(first, "Equilibration: first", 1), width
        self.sweeps, self._window, self._done = 0, 0, 0
        self._observables = Observables(width)
        self.is_finished = False

    @property
    def window(self) -> int:
        """The number of sweeps of the present or last window."""
        return self.first << self._window

    @property
    def most_sweeps(self) -> int:
        """The number of sweeps of all windows."""
        return self.first * ((1 << _WINDOWS) - 1)

    def unsettled(self) -> list[str]:
        """The names of the averages that drift in the window, or are correlated over more than an eighth of it."""
        return self._observables.unsettled()

    def add(self, simulation: HardEllipsoids) -> None:
        """Takes the state after the next sweep.

        Parameters
        ----------
        simulation : HardEllipsoids
        """
        if not self._done and self.sweeps:
            self._observables = Observables(self._width)
        self.sweeps, self._done = self.sweeps + 1, self._done + 1
        if self._done % max(1, self.window // _SAMPLES) == 0:
            self._observables.add(simulation)
        if self._done < self.window:
            return
        self.is_finished = self._window + 1 == _WINDOWS or not self.unsettled()
        if not self.is_finished:
            self._window, self._done = self._window + 1, 0

    def state(self) -> dict[str, Floats]:
        """All numbers, for `restore`."""
        numbers = [self.first, self._width, self.sweeps, self._window, self._done, self.is_finished]
        return {"windows": np.array(numbers, dtype=np.float64)} | self._observables.state()

    @classmethod
    def restore(cls, state: Mapping[str, Floats]) -> Equilibration:
        """Windows that continue those whose `state` is given, bit by bit.

        Parameters
        ----------
        state : dict of arrays

        Returns
        -------
        Equilibration
        """
        first, width, *counts = state["windows"].tolist()
        made = cls(int(first), width)
        made.sweeps, made._window, made._done = map(int, counts[:3])
        made.is_finished = bool(counts[3])
        made._observables = Observables.restore({name: numbers for name, numbers in state.items() if name != "windows"})
        return made
