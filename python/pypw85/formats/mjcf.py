# SPDX-License-Identifier: BSD-3-Clause
"""For MuJoCo (written only): MJCF, a body that moves freely for each particle, with a geom of type ellipsoid.

Sizes of these geoms are semi-axes, and quaternions are (w, x, y, z). Each body has its mass and its principal moments of inertia, those
of a solid body, so that they do not depend on what MuJoCo takes from geoms. The density is that of MuJoCo's own geoms, 1000.
"""

from __future__ import annotations

from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._bodies import inertia
from .._functions import volume
from .._system import System
from .._typing import Floats

SUFFIXES = (".xml", ".mjcf")
# Of MuJoCo's geoms by default, in the units of the file
_DENSITY = 1000.0
_DIAGONAL = [0, 3, 5]  # of a form
# Masses and moments of bodies that move must be larger (mjMINVAL of MuJoCo).
_SMALLEST_INERTIA = 1e-15
_BODY = (
    '    <body name="particle_{}" pos="{} {} {}" quat="{} {} {} {}">\n      <freejoint/>\n'
    '      <inertial pos="0 0 0" mass="{}" diaginertia="{} {} {}"/>\n      <geom type="ellipsoid" size="{} {} {}"/>\n    </body>\n'
)


def _inertia(semi_axes: Floats) -> tuple[Floats, Floats]:
    """The masses of solid ellipsoids, and their moments about their axes.

    None of the three moments of a body is larger than the sum of the others. MuJoCo refuses moments of flat ellipsoids for which this
    fails by a rounding error, so that the largest one is rounded down to the sum as floating-point numbers have it.
    """
    forms = np.zeros((len(semi_axes), 6))
    forms[:, _DIAGONAL] = np.square(semi_axes)
    masses: Floats = _DENSITY * np.asarray(volume(forms))
    moments = _DENSITY * inertia(forms)[:, _DIAGONAL]
    return masses, np.minimum(moments, moments[:, [1, 2, 0]] + moments[:, [2, 0, 1]])


def losses(system: System) -> Iterator[tuple[str, str]]:
    if system.cell is not None:
        yield "cell", "MuJoCo has no periodic boxes: the cell is left out"
    if len(np.unique(system.types)) > 1:
        yield "types", "bodies of MuJoCo have no types: they are left out"
    masses, moments = _inertia(system.semi_axes)
    smallest = min(masses.min(), moments.min())
    if not smallest > _SMALLEST_INERTIA:
        yield "inertia", (f"MuJoCo refuses masses and moments of inertia that are not above {_SMALLEST_INERTIA:g}, and the smallest is "
                          f"{smallest:.3g} for the density {_DENSITY:g}: write lengths in a smaller unit")  # fmt: skip


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("an MJCF file holds one frame: choose one with --frames")
    system.require_three_dimensions("MJCF")
    if len(np.unique(system.ids)) < len(system):
        raise ValueError("bodies of MuJoCo have different names, but several particles have the same id: renumber them")
    masses, moments = _inertia(system.semi_axes)
    file.write(f'<?xml version="1.0"?>\n<!-- Ellipsoids of pw85, solid, with the density {_DENSITY:g}. -->\n'
               '<mujoco model="ellipsoids">\n  <worldbody>\n')  # fmt: skip
    rows = np.column_stack([system.centers, system.quaternions, masses, moments, system.semi_axes]).tolist()
    for number, row in zip(system.ids.tolist(), rows, strict=True):
        file.write(_BODY.format(number, *map(repr, row)))
    file.write("  </worldbody>\n</mujoco>\n")
