# SPDX-License-Identifier: BSD-3-Clause
"""Masses and moments of inertia of ellipsoids that are solid bodies, for files of simulation programs of rigid bodies."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._bodies import inertia
from .._functions import volume
from .._system import System
from .._typing import Floats

# Of MuJoCo's geoms by default, and of water in SI units
DENSITY = 1000.0
_DIAGONAL = [0, 3, 5]  # of a form


def masses_and_moments(semi_axes: Floats) -> tuple[Floats, Floats]:
    """The masses of solid ellipsoids, and their moments about their axes.

    None of the three moments of a body is larger than the sum of the others. Programs refuse moments of flat ellipsoids for which this
    fails by a rounding error. Therefore the largest one is rounded down to the sum as floating-point numbers have it.
    """
    forms = np.zeros((len(semi_axes), 6))
    forms[:, _DIAGONAL] = np.square(semi_axes)
    masses: Floats = DENSITY * np.asarray(volume(forms))
    moments = DENSITY * inertia(forms)[:, _DIAGONAL]
    return masses, np.minimum(moments, moments[:, [1, 2, 0]] + moments[:, [2, 0, 1]])


def check_names(system: System, bodies: str) -> None:
    """Refuses a system whose bodies would not have names of their own."""
    if len(np.unique(system.ids)) < len(system):
        raise ValueError(f"{bodies} have different names, but several particles have the same id: renumber them")


def losses_of_solids(system: System, program: str, bodies: str) -> Iterator[tuple[str, str]]:
    """Yields what files of such programs cannot hold, and what becomes of it."""
    if system.cell is not None:
        yield "cell", f"{program} has no periodic boxes: the cell is left out"
    if len(np.unique(system.types)) > 1:
        yield "types", f"{bodies} have no types: they are left out"
