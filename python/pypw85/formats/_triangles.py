# SPDX-License-Identifier: BSD-3-Clause
"""Ellipsoids as meshes of triangles, which stl.py, obj.py and ply.py write."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._bodies import Fit, sphere_mesh
from .._forms import principal_axes
from .._system import System
from .._typing import Floats

# Of the longest semi-axis, where no deviation is given.
_DEFAULT_DEVIATION = 0.01
_WORDS = {
    "inscribed": "inscribed: the vertices are on the ellipsoids, and the volume is {:.3g} % too small",
    "circumscribed": "circumscribed: the ellipsoids are inside, and the volume is {:.3g} % too large",
    "volume": "the volume is that of the ellipsoids, and the vertices are outside of them",
}


class Triangles(NamedTuple):
    """Triangles of all ellipsoids, and a line that says how close they are."""

    vertices: Floats
    triangles: NDArray[np.int64]
    said: str


def triangles_of(system: System, frame: int, deviation: float | None, fit: Fit) -> Triangles:
    if frame:
        raise ValueError("a mesh holds one frame: choose one with --frames")
    semi_axes, rotations = principal_axes(system.q)
    longest = float(semi_axes.max())
    points, faces, away, volume = sphere_mesh(_DEFAULT_DEVIATION * longest if deviation is None else deviation, longest, fit)
    turned = np.einsum("nij,nj,pj->npi", rotations, semi_axes, points)
    vertices = (system.centers[:, None] + turned).reshape(-1, 3)
    n = len(system)
    triangles = (faces + len(points) * np.arange(n)[:, None, None]).reshape(-1, 3)
    said = (f"pw85: {n} ellipsoid{'s' * (n > 1)}, {len(triangles)} triangles, at most {away:.3g} from the surfaces; "
            + _WORDS[fit].format(100 * abs(volume - 1)))  # fmt: skip
    return Triangles(vertices, triangles, said)
