# SPDX-License-Identifier: BSD-3-Clause
"""Seeds of MicroStructPy: ellipsoids and spheres, or ellipses and circles, in text, one key and its value on a line; without a cell."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

import numpy as np

from .._rotations import product, quaternions_of_euler
from .._system import System, quaternions_of
from .._typing import Floats
from ._frames import Frame, Location
from ._options import Options
from ._table import Lines

SUFFIXES: tuple[str, ...] = ()
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_PLANE = ("circle", "ellipse")
# Rotations about axes of the body, one after the other
_ROTATION = re.compile(rf"\(\s*'?([xyz123])'?\s*,\s*({_NUMBER})\s*\)")
# Keys by which seeds are turned, of which one seed has one, in three dimensions and in two; and how many degrees a unit of theirs is
_TURNS = {3: ("rot_seq", "rot_seq_deg", "rot_seq_rad", "matrix", "orientation"),
          2: ("angle", "angle_deg", "angle_rad", "matrix", "orientation")}  # fmt: skip
_RADIANS = ("rot_seq_rad", "angle_rad")
_OTHERS = ("geometry", "phase", "position", "center", "breakdown")
# Keys of lengths: the exponents of the semi-axes whose product is the value, and the factor and power that make that product of the value
_LENGTHS: dict[int, dict[str, tuple[tuple[int, ...], float, float]]] = {
    3: {"a": ((1, 0, 0), 1, 1), "b": ((0, 1, 0), 1, 1), "c": ((0, 0, 1), 1, 1), "size": ((1, 1, 1), 0.5, 3),
        "volume": ((1, 1, 1), 0.75 / np.pi, 1), "ratio_ab": ((1, -1, 0), 1, 1), "ratio_ba": ((-1, 1, 0), 1, 1),
        "ratio_ac": ((1, 0, -1), 1, 1), "ratio_ca": ((-1, 0, 1), 1, 1), "ratio_bc": ((0, 1, -1), 1, 1), "ratio_cb": ((0, -1, 1), 1, 1)},
    2: {"a": ((1, 0), 1, 1), "b": ((0, 1), 1, 1), "size": ((1, 1), 0.5, 2), "area": ((1, 1), 1 / np.pi, 1),
        "aspect_ratio": ((1, -1), 1, 1)},
}  # fmt: skip
_SPHERE = {"radius": 1.0, "r": 1.0, "diameter": 0.5, "d": 0.5, "size": 0.5}
# Numbers are written with some digits: sizes may contradict each other, and matrices be turns, up to so much.
_ROUNDING = 1e-5


def recognise(start: bytes) -> bool:
    return re.match(rb"\s*geometry: *[a-z]+ *\r?\n", start, re.IGNORECASE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    centers, shapes, quaternions, phases, numbers = [], [], [], [], []
    turns, dimensions = set[str](), 0
    with Lines(path, location) as lines:
        for number, seed in _seeds(lines):
            last, lines.number = lines.number, number
            shapes.append(_lengths(lines, seed))
            dimensions = dimensions or _dimensions(seed)
            if _dimensions(seed) != dimensions:
                raise lines.error("there are seeds of two and of three dimensions: choose one kind")
            centers.append(_center(lines, seed, dimensions))
            quaternions.append(_turn(lines, seed, dimensions))
            turns.update(key for key in _TURNS[dimensions] if key in seed)
            phases.append(lines.whole(seed.get("phase", "0"), "phase"))
            numbers.append(number)
            lines.number = last
    if not centers:
        raise lines.error("there are no seeds: the file is truncated; write it again")
    frame = Frame(
        path, location, np.array(centers), np.array(shapes), np.array(quaternions), types=np.array(phases), lines=numbers,
        periodic=(False, False, False), dimensions=2 if dimensions == 2 else None, source=_source(dimensions, turns),
    )  # fmt: skip
    return frame.system(options)


def _source(dimensions: int, turns: set[str]) -> str:
    """Says in words which keys of the seeds were read."""
    words = []
    for key in sorted(turns):
        unit = "radians" if key in _RADIANS else "degrees"
        words.append(f"{key} as rotation matrix" if key in ("matrix", "orientation") else
                     f"{key} as {unit} about axes of the body" if key.startswith("rot_seq") else f"{key} in {unit}")  # fmt: skip
    return ", ".join([f"lengths {' '.join('abc'[:dimensions])} as radii", *words, "of MicroStructPy"])


def _dimensions(seed: dict[str, str]) -> int:
    return 2 if seed.get("geometry", "").lower() in _PLANE else 3


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
        value = re.sub(r"np\.float\d+\(([^()]*)\)", r"\1", value).strip()
        if colon:
            seed[key] = value
        elif seed and line:  # NumPy prints matrices on several lines
            last = next(reversed(seed))
            seed[last] = f"{seed[last]} {line}"
    if seed:
        yield number, seed


def _center(lines: Lines, seed: dict[str, str], dimensions: int) -> list[float]:
    found = [_vector(lines, seed, key, dimensions) for key in ("position", "center") if key in seed]
    if len(found) > 1 and found[0] != found[1]:
        raise lines.error("the keys position and center of a seed differ: remove one of them")
    return found[0] if found else _vector(lines, seed, "position", dimensions)


def _vector(lines: Lines, seed: dict[str, str], key: str, count: int) -> list[float]:
    return lines.numbers(re.sub(r"[()\[\],]", " ", seed.get(key, "")), count, f"the {key} of a seed")


def _lengths(lines: Lines, seed: dict[str, str]) -> list[float]:
    kind = seed.get("geometry", "").lower()
    if kind not in ("ellipsoid", "ellipse", "sphere", "circle"):
        raise lines.error(f"the seed is of the geometry '{kind[:40]}': only ellipsoids and spheres, ellipses and circles can be checked")
    dimensions = _dimensions(seed)
    is_round = kind in ("sphere", "circle")
    content = "area" if dimensions == 2 else "volume"
    known = {*_OTHERS, *_TURNS[dimensions], *((*_SPHERE, content) if is_round else (*_LENGTHS[dimensions], "axes"))}
    if unknown := [key for key in seed if key not in known]:
        raise lines.error(f"the key '{unknown[0][:40]}' of a seed could change its shape, and is not known: remove it")
    return _radius(lines, seed, kind, content, dimensions) if is_round else _semi_axes(lines, seed, dimensions)


def _number(lines: Lines, seed: dict[str, str], key: str, what: str) -> float:
    value = lines.numbers(seed[key], 1, what)[0]
    if not 0 < value < np.inf:
        raise lines.error(f"{what} must be a finite number > 0, not '{seed[key][:40]}'")
    return value


def _radius(lines: Lines, seed: dict[str, str], kind: str, content: str, dimensions: int) -> list[float]:
    found = [_SPHERE[key] * _number(lines, seed, key, f"the {key} of a {kind}") for key in _SPHERE if key in seed]
    if content in seed:
        value = _number(lines, seed, content, f"the {content} of a {kind}")
        found.append((value / np.pi) ** 0.5 if dimensions == 2 else np.cbrt(0.75 * value / np.pi))
    if not found or max(found) - min(found) > _ROUNDING * max(found):
        raise lines.error(f"the radius of a {kind} must be 1 number, and is {' '.join(f'{one:g}' for one in found) or 'missing'}")
    return dimensions * found[:1]


def _semi_axes(lines: Lines, seed: dict[str, str], dimensions: int) -> list[float]:
    """The semi-axes that all keys say together: in logarithms these are linear equations."""
    rows, values = [], []
    direct: dict[int, float] = {}
    if "axes" in seed:
        direct = dict(enumerate(_vector(lines, seed, "axes", dimensions)))
    for key, (exponents, factor, power) in _LENGTHS[dimensions].items():
        if key in seed:
            value = _number(lines, seed, key, f"the semi-axis {key} of a seed" if len(key) == 1 else f"the {key} of a seed")
            rows.append(exponents)
            values.append(np.log((factor * value) ** power if key == "size" else factor * value))
            if len(key) == 1:
                direct.setdefault("abc".index(key), value)
    for k, value in direct.items():
        if not 0 < value < np.inf:
            raise lines.error(f"the semi-axes of a seed must be finite numbers > 0, not {value:g}")
        rows.append(tuple(int(k == other) for other in range(dimensions)))
        values.append(np.log(value))
    if not rows or np.linalg.matrix_rank(rows) < dimensions:
        missing = next(("abc"[k] for k in range(dimensions) if k not in direct), "a")
        raise lines.error(f"the semi-axis {missing} of a seed must be 1 number, and does not follow from other keys: write it")
    found = np.linalg.lstsq(np.array(rows, dtype=np.float64), np.array(values), rcond=None)[0]
    if np.abs(np.array(rows) @ found - values).max() > _ROUNDING:
        keys = " ".join(key for key in seed if key in (*_LENGTHS[dimensions], "axes"))
        raise lines.error(f"the keys {keys} contradict each other: keep only the semi-axes")
    return [direct.get(k, float(np.exp(found[k]))) for k in range(dimensions)]


def _turn(lines: Lines, seed: dict[str, str], dimensions: int) -> Floats:
    keys = [key for key in _TURNS[dimensions] if key in seed]
    if len(keys) > 1:
        raise lines.error(f"the keys {' '.join(keys)} all give the orientation of the seed: keep only one of them")
    if not keys:
        return np.array([1.0, 0, 0, 0])
    key = keys[0]
    if key in ("matrix", "orientation"):
        return _of_matrix(lines, seed, key, dimensions)
    unit = 180 / np.pi if key in _RADIANS else 1.0
    if dimensions == 2:
        turn: Floats = quaternions_of_euler("z", [[np.radians(unit * lines.numbers(seed[key], 1, "the angle of an ellipse")[0])]])[0]
        return turn
    return _quaternion(lines, seed[key], unit)


def _of_matrix(lines: Lines, seed: dict[str, str], key: str, dimensions: int) -> Floats:
    matrix = np.eye(3)
    matrix[:dimensions, :dimensions] = np.reshape(_vector(lines, seed, key, dimensions**2), (dimensions, dimensions))
    if not (np.abs(matrix @ matrix.T - np.eye(3)).max() < _ROUNDING and np.linalg.det(matrix) > 0):
        raise lines.error(f"the {key} of a seed must be a rotation, not '{seed[key][:80]}'")
    turn: Floats = quaternions_of(matrix[np.newaxis])[0]
    return turn


def _quaternion(lines: Lines, rotations: str, unit: float) -> Floats:
    if re.sub(r"[\s,()\[\]]", "", _ROTATION.sub("", rotations)):
        raise lines.error(f"rotations must be as ((z, 90.0), (x, 45.0)), not '{rotations[:80]}'")
    result: Floats = np.array([[1.0, 0, 0, 0]])
    for axis, angle in _ROTATION.findall(rotations):
        one = quaternions_of_euler("xyz"["xyz123".index(axis) % 3], [[np.radians(unit * float(angle))]])
        result = product(result, one)
    turn: Floats = result[0]
    return turn
