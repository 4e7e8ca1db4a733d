"""For ParaView (written only): points with √Q, which its filter Tensor Glyph draws with a sphere of radius 1 for each.

√Q, the symmetric root of Q, has the semi-axes as eigenvalues. Its components are in VTK's order: xx, yy, zz, xy, yz, xz.
"""

from __future__ import annotations

from typing import IO, Any

import numpy as np

from .._functions import ellipsoid_quaternion
from .._system import System

SUFFIXES = (".vtk",)


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a VTK file holds one frame: choose one (--frames)")
    n = len(system)
    # The form of an ellipsoid with the square roots of the semi-axes is the square root of the form.
    roots = ellipsoid_quaternion(np.sqrt(system.semi_axes), system.quaternions)
    file.write(f"# vtk DataFile Version 3.0\nellipsoids of pw85\nASCII\nDATASET POLYDATA\nPOINTS {n} double\n")
    np.savetxt(file, system.centers, fmt="%.17g")
    file.write(f"VERTICES {n} {2 * n}\n")
    np.savetxt(file, np.column_stack([np.ones(n), np.arange(n)]), fmt="%d")
    file.write(f"POINT_DATA {n}\nTENSORS6 shape double\n")
    np.savetxt(file, roots[:, [0, 3, 5, 1, 4, 2]], fmt="%.17g")
    file.write("SCALARS id double 1\nLOOKUP_TABLE default\n")
    np.savetxt(file, system.ids, fmt="%d")
