# SPDX-License-Identifier: BSD-3-Clause
"""Boxes and types of a system as LAMMPS and HOOMD need them."""

from __future__ import annotations

from typing import Any
from collections.abc import Callable, Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._errors import FileError
from ._names import numbers_if_all_are, type_names

# A box around a system is wider by this fraction of it: no images overlap where single precision rounds it.
_MARGIN = 2.0**-20
# Rounding a corner, and adding an edge to it, may change the edge by this share. If it changes more, the corner is too far from 0.
_ROUNDED = 2.0**-40
# How a comment begins that may say the cell; its first group is the word for that
SAYS_CELL = (r"((?:(?:simulation|periodic|unit)[ _-]?)?(?:cell|box|lattice)(?:[ _-]?(?:size|lengths?|vectors?|edges))?|"
             r"domain(?:[ _-]?(?:size|lengths?|bounds))?|bounds|extents?|[xyz]lo(?:[ ,]+[xyz]hi)?|"
             r"l[xyz](?:[ ,]+l[xyz])*|l(?=\s*[=:]\s*[-+.\d])|"
             r"l_?box|rve(?:[ _-]?size)?|pbc|periodic\w*|boundar(?:y|ies)|lattice)\s*(?:[:=(\[]|[-+]?\.?\d|[TFtf]\b)")  # fmt: skip


def numbered_types(system: System) -> tuple[Any, bool]:
    """Types as LAMMPS has them, numbers from 1, and whether their names would be lost."""
    types = numbers_if_all_are(system.types if system.types.dtype.kind in "iu" else type_names(system))
    if types.dtype.kind in "iu" and 0 < types.min() and types.max() < 2**31:
        return types, False
    different, numbers = np.unique(types, return_inverse=True)
    return numbers + 1, types.dtype.kind not in "iu" or len(different) > 1


def box(system: System) -> tuple[Floats, Floats]:
    """Cell and its corner, or a box around the system if there is none.

    Raises
    ------
    ValueError
        The cell is not lower triangular with a positive diagonal, as both programs need.
    """
    if system.cell is None:
        reach = np.sqrt(system.q[:, [0, 3, 5]])
        low, high = (system.centers - reach).min(axis=0), (system.centers + reach).max(axis=0)
        margin = _MARGIN * (high - low)
        edges, corner = high - low + 2 * margin, low - margin
        if system.dimensions == 2:
            edges[2], corner[2] = 1.0, -0.5
        return np.diag(edges), corner
    if system.cell[np.triu_indices(3, 1)].any() or (np.diag(system.cell) <= 0).any():
        raise ValueError("the cell is not lower triangular with a positive diagonal, as this format needs: rotate the system")
    return system.cell, system.origin


def check_bounds(low: Floats, high: Floats, error: Callable[[str], FileError]) -> None:
    """Refuses a box of LAMMPS whose bounds are exchanged (LAMMPS: Box bounds are invalid)."""
    if (low > high).any():
        axis = int((low > high).argmax())
        raise error(f"the lower bound of the box along {'xyz'[axis]}, {low[axis]:g}, is above the upper one, {high[axis]:g}: correct them")


def bounds(system: System) -> tuple[Floats, Floats, Floats]:
    """Cell, and two of its corners, as in files of LAMMPS.

    Raises
    ------
    ValueError
        As `box`, or rounding the corners would change the cell.
    """
    cell, low = box(system)
    edges = np.diag(cell)
    high = low + edges
    if (np.abs(high - low - edges) > _ROUNDED * edges).any():
        raise ValueError("the corner of the cell is so far from 0 that rounding would change the cell: move the system")
    return cell, low, high


def lost_periodicity(system: System) -> Iterator[tuple[str, str]]:
    """A word and a sentence on a system that is not periodic, for a format that cannot say so."""
    if not all(system.periodic[: system.dimensions]):
        yield ("periodic", "programs take what is in this format as periodic in all directions, which the system is not: "
               "say so where it is read (--periodic)")  # fmt: skip
