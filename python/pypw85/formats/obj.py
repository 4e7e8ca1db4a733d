# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of ellipsoids as Wavefront OBJ (written only)."""

from __future__ import annotations

from typing import IO, Any

import numpy as np

from .._bodies import Fit
from .._system import System
from ._triangles import triangles_of

SUFFIXES = (".obj",)


def save(file: IO[Any], system: System, frame: int, deviation: float | None = None, fit: Fit = "volume") -> None:
    vertices, triangles, said = triangles_of(system, frame, deviation, fit)
    file.write(f"# {said}\n")
    np.savetxt(file, vertices, "v %.17g %.17g %.17g")
    np.savetxt(file, triangles + 1, "f %d %d %d")
