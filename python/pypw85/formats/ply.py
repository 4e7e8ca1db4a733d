# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of ellipsoids as PLY, in text (written only)."""

from __future__ import annotations

from typing import IO, Any

import numpy as np

from .._bodies import Fit
from .._system import System
from ._triangles import triangles_of

SUFFIXES = (".ply",)


def save(file: IO[Any], system: System, frame: int, deviation: float | None = None, fit: Fit = "volume") -> None:
    vertices, triangles, said = triangles_of(system, frame, deviation, fit)
    file.write(f"ply\nformat ascii 1.0\ncomment {said}\nelement vertex {len(vertices)}\n")
    file.write("property double x\nproperty double y\nproperty double z\n")
    file.write(f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    np.savetxt(file, vertices, "%.17g %.17g %.17g")
    np.savetxt(file, triangles, "3 %d %d %d")
