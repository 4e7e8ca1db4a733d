# SPDX-License-Identifier: BSD-3-Clause
"""Seeds of MicroStructPy: ellipsoids and spheres, or ellipses and circles, in text, one key and its value on a line; without a cell."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._frames import Frame, Location, Options
from ._table import Lines

SUFFIXES: tuple[str, ...] = ()
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_PLANE = ("circle", "ellipse")
# Rotations by degrees about axes of the body, one after the other
_ROTATION = re.compile(rf"\(\s*'?([xyz123])'?\s*,\s*({_NUMBER})\s*\)")


def recognise(start: bytes) -> bool:
    return re.match(rb"\s*geometry: *[a-z]+ *\r?\n", start, re.IGNORECASE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    centers, shapes, quaternions, phases, numbers = [], [], [], [], []
    dimensions = 0
    with Lines(path, location) as lines:
        for number, seed in _seeds(lines):
            last, lines.number = lines.number, number
            shapes.append(_lengths(lines, seed))
            dimensions = dimensions or _dimensions(seed)
            if _dimensions(seed) != dimensions:
                raise lines.error("there are seeds of two and of three dimensions: choose one kind")
            centers.append(_vector(lines, seed, "position" if "position" in seed else "center", dimensions))
            quaternions.append(_quaternion(seed.get("rot_seq", "") if dimensions == 3 else f"(z, {_angle(lines, seed)!r})"))
            phases.append(lines.whole(seed.get("phase", "0"), "phase"))
            numbers.append(number)
            lines.number = last
    if not centers:
        raise lines.error("there are no seeds: the file is truncated; write it again")
    frame = Frame(
        path, location, np.array(centers), np.array(shapes), np.array(quaternions), types=np.array(phases), lines=numbers,
        periodic=(False, False, False), dimensions=2 if dimensions == 2 else None, source=_SOURCES[dimensions],
    )  # fmt: skip
    return frame.system(options)


_SOURCES = {2: "lengths a b as radii, angle in degrees, of MicroStructPy",
            3: "lengths a b c as radii, rot_seq as degrees about axes of the body, of MicroStructPy"}  # fmt: skip


def _dimensions(seed: dict[str, str]) -> int:
    return 2 if seed.get("geometry", "").lower() in _PLANE else 3


def _angle(lines: Lines, seed: dict[str, str]) -> float:
    return lines.numbers(seed.get("angle", "0"), 1, "the angle of an ellipse")[0]


def _seeds(lines: Lines) -> Iterator[tuple[int, dict[str, str]]]:
    """The line in which each seed begins, and what it says."""
    number, seed = 0, dict[str, str]()
    while (line := lines.next()) is not None:
        key, colon, value = line.partition(":")
        key = key.strip().lower().replace(" ", "_")
        if key == "geometry":
            if seed:
                yield number, seed
            number, seed = lines.number, {}
        if colon:
            seed[key] = re.sub(r"np\.float\d+\(([^()]*)\)", r"\1", value).strip()
    if seed:
        yield number, seed


def _vector(lines: Lines, seed: dict[str, str], key: str, count: int) -> list[float]:
    return lines.numbers(re.sub(r"[()\[\],]", " ", seed.get(key, "")), count, f"the {key} of a seed")


def _lengths(lines: Lines, seed: dict[str, str]) -> list[float]:
    kind = seed.get("geometry", "").lower()
    if kind in ("sphere", "circle"):
        return (3 if kind == "sphere" else 2) * lines.numbers(seed.get("radius", seed.get("r", "")), 1, f"the radius of a {kind}")
    if kind not in ("ellipsoid", "ellipse"):
        raise lines.error(f"the seed is of the geometry '{kind[:40]}': only ellipsoids and spheres, ellipses and circles can be checked")
    keys = "abc" if kind == "ellipsoid" else "ab"
    return [lines.numbers(seed.get(key, ""), 1, f"the semi-axis {key} of a seed")[0] for key in keys]


def _quaternion(rotations: str) -> Floats:
    result: Floats = np.array([1.0, 0, 0, 0])
    for axis, degrees in _ROTATION.findall(rotations):
        half = np.radians(float(degrees)) / 2
        vector = np.sin(half) * np.eye(3)["xyz123".index(axis) % 3]
        w, v = result[0], result[1:]
        result = np.array([w * np.cos(half) - v @ vector, *(w * vector + np.cos(half) * v + np.cross(v, vector))])
    return result
