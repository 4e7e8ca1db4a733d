# SPDX-License-Identifier: BSD-3-Clause
"""Columns that are read from a table, and what they are."""

from __future__ import annotations

from typing import NamedTuple
from collections.abc import Iterator, Sequence

from ._conventions import Names
from ._doubts import Doubt
from ._turns import Turn


class Taken(NamedTuple):
    """Columns that are read from a table. `spheroid` is empty where `shape` are the lengths themselves; otherwise the first of two columns
    is the length across the axis of revolution, and the second "length", that along it, or "ratio", that over the first; `factors` make
    them `lengths`.
    `sphere` is the size of particles whose lengths are all 0; `turn` says how particles are turned that have no quaternions;
    of `doubts`, the values decide whether they could change bodies."""

    shape: Names
    lengths: str
    quaternion: Names
    order: str
    sphere: Names
    exponents: list[tuple[str, tuple[float, ...]]]
    source: str
    notes: list[str]
    turn: Turn
    spheroid: str = ""
    factors: tuple[float, float] = (1.0, 1.0)
    doubts: Sequence[Doubt] = ()

    @property
    def columns(self) -> Iterator[str]:
        yield from (*self.shape, *self.quaternion, *self.sphere, *(name for name, _ in self.exponents), *self.turn.columns)

    @property
    def checked(self) -> Iterator[str]:
        """The columns whose values are needed."""
        yield from (*self.columns, *(name for doubt in self.doubts for name in doubt.names))
