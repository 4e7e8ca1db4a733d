"""What LAMMPS and HOOMD ask of a system that is written for them."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._system import System
from .._typing import Floats


def numbered_types(system: System) -> Any:
    """Types as LAMMPS has them: numbers from 1."""
    if system.types.dtype.kind in "iu" and system.types.min(initial=1) > 0:
        return system.types
    return np.unique(system.types, return_inverse=True)[1] + 1


def box(system: System) -> tuple[Floats, Floats]:
    """Cell and its corner, or a box around the system if there is none.

    Raises
    ------
    ValueError
        The cell is not lower triangular with a positive diagonal, as both programs need.
    """
    if system.cell is None:
        reach = np.sqrt(system.q[:, [0, 3, 5]])
        low = (system.centers - reach).min(axis=0)
        return np.diag((system.centers + reach).max(axis=0) - low), low
    if system.cell[np.triu_indices(3, 1)].any() or (np.diag(system.cell) <= 0).any():
        raise ValueError("the cell is not lower triangular with a positive diagonal, as this format needs: rotate the system")
    return system.cell, system.origin
