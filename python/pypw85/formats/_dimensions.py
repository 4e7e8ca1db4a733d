# SPDX-License-Identifier: BSD-3-Clause
"""Systems of two dimensions: how they are recognised in files that do not say the number, and what must be written."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .._system import System, is_planar

# The height of a box of two dimensions in LAMMPS, which its documents ask for
FLAT_BOX = (-0.5, 0.5)


def lost_dimensions(system: System) -> Iterator[tuple[str, str]]:
    """A word and a sentence on a system whose dimensions are not recognised, in a format that does not say them."""
    if system.dimensions == 2 and len(system) < 2:
        yield "dimensions", "this format does not say that the system is two-dimensional: say so where it is read (--dimensions 2)"
    if is_flat(system):
        yield "dimensions", "this format does not say that the system is three-dimensional: say so where it is read (--dimensions 3)"


def said_dimensions(system: System) -> int | None:
    """The number of dimensions to write; None for three, if no reader would read the system as a plane one."""
    return system.dimensions if system.dimensions == 2 or is_flat(system) else None


def is_flat(system: System) -> bool:
    """Returns whether particles lie in a plane of a system that LAMMPS would make with dimension 2: all centres have the same z, all
    turn about z, and the cell is as high as LAMMPS asks for, or so low that each particle would overlap with itself."""
    if len(system) < 2 or system.cell is None or not system.periodic[2]:
        return False
    height, bottom = float(system.cell[2, 2]), float(system.origin[2])
    if system.cell[2, :2].any() or system.cell[:2, 2].any() or not is_planar(system.centers, system.q):
        return False
    return (bottom, bottom + height) == FLAT_BOX or bool((2 * np.sqrt(system.q[:, 5]) > height).all())
