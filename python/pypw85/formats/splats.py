# SPDX-License-Identifier: BSD-3-Clause
"""Splats of 3D Gaussian splatting in PLY files, by meshio: positions, logarithms of standard deviations, quaternions of any length.

The ellipsoid of a splat has its standard deviations as semi-axes.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

import numpy as np

from .._mesh_files import read_ply
from .._system import System
from ._errors import FileError, guarded
from ._files import check_input
from ._frames import Frame, Location, Options

SUFFIXES: tuple[str, ...] = ()
_SCALES, _ROTATION = [f"scale_{k}" for k in range(3)], [f"rot_{k}" for k in range(4)]
_LONGEST_HEADER = 1 << 16


def recognise(start: bytes) -> bool:
    return start.startswith(b"ply") and re.search(rb"^property \w+ (scale_0|packed_scale)\s*$", start, re.MULTILINE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


@guarded
def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    count = _check_header(path)
    content = read_ply(os.fspath(path))
    if len(content.points) != count:
        raise FileError(path, f"the file ends after {len(content.points)} of {count} splats: it is truncated; write it again", 0)
    columns = {name: np.asarray(values, dtype=np.float64) for name, values in content.point_data.items()}
    with np.errstate(over="ignore"):
        shapes = np.exp(np.stack([columns[name] for name in _SCALES], axis=1))
    frame = Frame(
        path, location, np.asarray(content.points, dtype=np.float64), shapes, np.stack([columns[name] for name in _ROTATION], axis=1),
        periodic=(False, False, False), tolerance=np.inf,
        source="lengths exp(scale_0 scale_1 scale_2), one standard deviation, as radii, quaternions rot_0 rot_1 rot_2 rot_3 as w x y z",
    )  # fmt: skip
    if not count:
        raise frame.error("there are no particles")
    return frame.system(options)


def _check_header(path: os.PathLike[str]) -> int:
    """How many splats there should be, if the file is large enough for them."""
    size = check_input(path).st_size
    with open(path, "rb") as file:
        header = file.read(_LONGEST_HEADER).partition(b"end_header")[0].decode("latin-1")
    if "packed_scale" in header:
        raise FileError(path, "the splats are compressed (packed_scale), as by SuperSplat: write them uncompressed", 0)
    found = re.search(r"^element vertex (\d{1,18})\s*$", header, re.MULTILINE)
    names = re.findall(r"^property \w+ (\S+)\s*$", header, re.MULTILINE)
    missing = [name for name in ("x", "y", "z", *_SCALES, *_ROTATION) if name not in names]
    if missing or not found:
        raise FileError(path, f"there is no property {(missing or ['x'])[0]} of splats, but {' '.join(names)[:200]}: write splats of three "
                        "dimensions", 0)  # fmt: skip
    if int(found[1]) * len(names) > size:
        raise FileError(path, f"says that there are {found[1]} splats, which it is too small for: it is truncated; write it again", 0)
    return int(found[1])
