# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of ellipsoids as STL, in text (written only)."""

from __future__ import annotations

from typing import IO, Any

import numpy as np

from .._bodies import Fit
from .._system import System
from ._triangles import triangles_of

SUFFIXES = (".stl",)


def save(file: IO[Any], system: System, frame: int, deviation: float | None = None, fit: Fit = "volume") -> None:
    vertices, triangles, said = triangles_of(system, frame, deviation, fit)
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    file.write(f"solid {said}\n")
    rows = np.concatenate([normals, corners.reshape(-1, 9)], axis=1)
    vertex = "vertex %.17g %.17g %.17g\n"
    np.savetxt(file, rows, f"facet normal %.9g %.9g %.9g\nouter loop\n{3 * vertex}endloop\nendfacet")
    file.write("endsolid\n")
