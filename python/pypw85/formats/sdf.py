# SPDX-License-Identifier: BSD-3-Clause
"""For Gazebo (written only): SDFormat, a model that moves freely for each particle, with an ellipsoid for collisions and for drawing.

SDFormat has ellipsoids from version 1.8 on, whose radii are semi-axes, and quaternions (x, y, z, w) from version 1.9 on. Each body has its
mass and its moments of inertia about its axes, those of a solid body with the density 1000.
"""

from __future__ import annotations

from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._solids import DENSITY, check_names, losses_of_solids, masses_and_moments

SUFFIXES = (".sdf",)
_GEOMETRY = "<geometry><ellipsoid><radii>{0} {1} {2}</radii></ellipsoid></geometry>"
_MODEL = (
    '    <model name="particle_{number}">\n      <pose rotation_format="quat_xyzw">{pose}</pose>\n      <link name="body">\n'
    "        <inertial><mass>{mass!r}</mass><inertia><ixx>{moments[0]!r}</ixx><ixy>0</ixy><ixz>0</ixz>"
    "<iyy>{moments[1]!r}</iyy><iyz>0</iyz><izz>{moments[2]!r}</izz></inertia></inertial>\n"
    '        <collision name="collision">{geometry}</collision>\n        <visual name="visual">{geometry}</visual>\n'
    "      </link>\n    </model>\n"
)


def losses(system: System) -> Iterator[tuple[str, str]]:
    yield from losses_of_solids(system, "SDFormat", "models of SDFormat")


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a file of SDFormat holds one frame: choose one with --frames")
    system.require_three_dimensions("SDFormat")
    check_names(system, "models of SDFormat")
    masses, moments = masses_and_moments(system.semi_axes)
    poses = np.column_stack([system.centers, system.quaternions[:, [1, 2, 3, 0]]]).tolist()
    file.write(f'<?xml version="1.0"?>\n<!-- Ellipsoids of pw85, solid, with the density {DENSITY:g}. -->\n'
               '<sdf version="1.9">\n  <world name="ellipsoids">\n')  # fmt: skip
    rows = zip(system.ids.tolist(), poses, masses.tolist(), moments.tolist(), system.semi_axes.tolist(), strict=True)
    for number, pose, mass, moment, radii in rows:
        text = " ".join(map(repr, pose))
        geometry = _GEOMETRY.format(*map(repr, radii))
        file.write(_MODEL.format(number=number, pose=text, mass=mass, moments=moment, geometry=geometry))
    file.write("  </world>\n</sdf>\n")
