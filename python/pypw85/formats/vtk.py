# SPDX-License-Identifier: BSD-3-Clause
"""For ParaView (written only): points with √Q, which its filter Tensor Glyph draws with a sphere of radius 1 for each.

√Q, the symmetric root of Q, has the semi-axes as eigenvalues. Its components are in VTK's order: xx, yy, zz, xy, yz, xz.
"""

from __future__ import annotations

from typing import IO, Any

import numpy as np

from .._functions import ellipsoid_quaternion
from .._system import System
from ._table import write_rows

SUFFIXES = (".vtk",)


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a VTK file holds one frame: choose one with --frames")
    n = len(system)
    # The form of an ellipsoid with the square roots of the semi-axes is the square root of the form.
    roots = ellipsoid_quaternion(np.sqrt(system.semi_axes), system.quaternions)
    file.write(f"# vtk DataFile Version 3.0\nellipsoids of pw85\nASCII\nDATASET POLYDATA\nPOINTS {n} double\n")
    write_rows(file, " ", system.centers)
    file.write(f"VERTICES {n} {2 * n}\n")
    write_rows(file, " ", np.ones(n, np.int64), np.arange(n))
    file.write(f"POINT_DATA {n}\nTENSORS6 shape double\n")
    write_rows(file, " ", roots[:, [0, 3, 5, 1, 4, 2]])
    file.write("SCALARS id double 1\nLOOKUP_TABLE default\n")
    write_rows(file, " ", system.ids)
