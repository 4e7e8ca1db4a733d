# SPDX-License-Identifier: BSD-3-Clause
"""For MuJoCo (written only): MJCF, a body that moves freely for each particle, with a geom of type ellipsoid.

Sizes of these geoms are semi-axes, and quaternions are (w, x, y, z). Each body has its mass and its principal moments of inertia, those
of a solid body. They do not depend on what MuJoCo takes from geoms. The density is that of MuJoCo's own geoms, 1000.
"""

from __future__ import annotations

from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._solids import DENSITY, check_names, losses_of_solids, masses_and_moments

SUFFIXES = (".xml", ".mjcf")
# Masses and moments of bodies that move must be larger (mjMINVAL of MuJoCo).
_SMALLEST_INERTIA = 1e-15
_BODY = (
    '    <body name="particle_{}" pos="{} {} {}" quat="{} {} {} {}">\n      <freejoint/>\n'
    '      <inertial pos="0 0 0" mass="{}" diaginertia="{} {} {}"/>\n      <geom type="ellipsoid" size="{} {} {}"/>\n    </body>\n'
)


def losses(system: System) -> Iterator[tuple[str, str]]:
    yield from losses_of_solids(system, "MuJoCo", "bodies of MuJoCo")
    masses, moments = masses_and_moments(system.semi_axes)
    smallest = min(masses.min(), moments.min())
    if not smallest > _SMALLEST_INERTIA:
        yield "inertia", (f"MuJoCo refuses masses and moments of inertia that are not above {_SMALLEST_INERTIA:g}, and the smallest is "
                          f"{smallest:.3g} for the density {DENSITY:g}: write lengths in a smaller unit")  # fmt: skip


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("an MJCF file holds one frame: choose one with --frames")
    system.require_three_dimensions("MJCF")
    check_names(system, "bodies of MuJoCo")
    masses, moments = masses_and_moments(system.semi_axes)
    file.write(f'<?xml version="1.0"?>\n<!-- Ellipsoids of pw85, solid, with the density {DENSITY:g}. -->\n'
               '<mujoco model="ellipsoids">\n  <worldbody>\n')  # fmt: skip
    rows = np.column_stack([system.centers, system.quaternions, masses, moments, system.semi_axes]).tolist()
    for number, row in zip(system.ids.tolist(), rows, strict=True):
        file.write(_BODY.format(number, *map(repr, row)))
    file.write("  </worldbody>\n</mujoco>\n")
