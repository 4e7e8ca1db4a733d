# SPDX-License-Identifier: BSD-3-Clause
"""Splats of Gaussian splatting: PLY files, compressed or not, .splat and .spz. The ellipsoid of a splat has its standard deviations as
semi-axes, or some multiple of them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from .._system import System
from ._errors import FileError, guarded
from ._files import check_input, is_compressed
from ._frames import Location
from ._options import Options
from ._gaussians import Gaussians, frame_of
from ._splats_packed import SPZ as SPZ, read_splat, read_spz
from ._splats_ply import read_ply

SUFFIXES: tuple[str, ...] = ()
# Files without a mark at their start are known by their names.
RECOGNISED_NAMES = (".splat",)
_PLY = rb"^property \w+ (scale_0|packed_scale)\s*$"


def recognise(start: bytes) -> bool:
    return start.startswith(SPZ) or (start.startswith(b"ply") and re.search(_PLY, start, re.MULTILINE) is not None)


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


@guarded
def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    return frame_of(path, location, options, _gaussians(path, options)).system(options)


def _gaussians(path: os.PathLike[str], options: Options) -> Gaussians:
    check_input(path)
    with open(path, "rb") as file:
        start = file.read(4)
    if start[:3] == b"ply":
        return read_ply(path, options)
    for name, value, what in (("--scales", options.scales, "may have scales of two kinds"),
                              ("--ignore-columns", options.ignore_columns, "have named properties")):  # fmt: skip
        if value is not None:
            raise FileError(path, f"only PLY files {what}: leave out {name}", 0)
    if start == SPZ or is_compressed(path):
        return read_spz(path, start != SPZ)
    if os.fspath(path).lower().endswith(RECOGNISED_NAMES):
        return read_splat(path)
    raise FileError(path, "the file must be a .splat, or have the mark of .ply or .spz at its start, and has neither: name the right "
                    "file", 0)  # fmt: skip
