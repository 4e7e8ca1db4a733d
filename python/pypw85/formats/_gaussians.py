# SPDX-License-Identifier: BSD-3-Clause
"""Data of all formats of splats, and the semi-axes that follow: one standard deviation, or several."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np

from .._typing import Floats
from .._words import counted
from ._errors import FileError
from ._frames import Frame, Location
from ._options import Options

# The form holds squares. Its rounding errors are about 2⁻⁵³ of the largest, so a smaller ratio would be lost among them.
FLATTEST = 2.0**-26


class Gaussians(NamedTuple):
    """Splats as a file has them: `lengths` are standard deviations, and 0 across discs; `quaternions` (w, x, y, z) have any length > 0.

    `lengths_from` and `rotation_from` say in words what these were made of.
    """

    centers: Floats
    lengths: Floats
    quaternions: Floats
    lengths_from: str
    rotation_from: str


def frame_of(path: os.PathLike[str], location: Location, options: Options, splats: Gaussians) -> Frame:
    """The ellipsoids of splats."""
    sigma = 1.0 if options.sigma is None else options.sigma
    many = "one standard deviation" if sigma == 1 else f"{sigma:g} standard deviations"
    with np.errstate(over="ignore", invalid="ignore"):
        lengths = sigma * splats.lengths
        least = FLATTEST * lengths.max(axis=1, initial=0.0)[:, None]
        is_flat = (lengths < least) & (lengths >= 0)
    if options.strict and is_flat.any():
        _refuse_flat(path, location, lengths, is_flat)
    source = f"lengths {splats.lengths_from}, {many}, as radii, quaternions {splats.rotation_from} as w x y z"
    if count := int(is_flat.any(axis=1).sum()):
        source += f", {counted(count, 'flat splat')} with semi-axes raised to 2⁻²⁶ of the longest"
    frame = Frame(
        path, location, splats.centers, np.where(is_flat, least, lengths), splats.quaternions,
        periodic=(False, False, False), tolerance=np.inf, source=source,
    )  # fmt: skip
    if not len(splats.centers):
        raise frame.error("there are no particles")
    return frame


def _refuse_flat(path: os.PathLike[str], location: Location, lengths: Floats, is_flat: np.ndarray) -> None:  # type: ignore[type-arg]
    splat = int(is_flat.any(axis=1).argmax())
    raise FileError(path, f"splat {splat + 1} has the semi-axis {lengths[splat].min():g}, which is less than 2⁻²⁶ of its longest, "
                    f"{lengths[splat].max():g}: leave out --strict, and it is raised to that", location.frame)  # fmt: skip
