"""Writes a ring of triangles in the plane z = 0 around a round hole: the bottom of a tube, as a mesh in STL format.

    python3 orifice.py DIAMETER OUTER_DIAMETER orifice.stl
"""

import sys
from pathlib import Path

import numpy as np


def write_ring(inner, outer, path, corners=48):
    """The hole is a polygon with the area of the circle."""
    angles = 2 * np.pi * np.arange(corners + 1) / corners
    radii = np.array([inner * np.sqrt(angles[1] / np.sin(angles[1])), outer]) / 2
    ring = radii[:, None, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    lines = ["solid ring"]
    for (a, b), (c, d) in zip(zip(ring[0], ring[0][1:]), zip(ring[1], ring[1][1:])):
        for triangle in ((a, c, d), (a, d, b)):
            vertices = [f"vertex {x:.9g} {y:.9g} 0" for x, y in triangle]
            lines += ["facet normal 0 0 1", "outer loop", *vertices, "endloop", "endfacet"]
    Path(path).write_text("\n".join([*lines, "endsolid ring", ""]), encoding="ascii")


if __name__ == "__main__":
    write_ring(float(sys.argv[1]), float(sys.argv[2]), sys.argv[3])
