"""Extended XYZ with OVITO's properties Aspherical Shape (semi-axes) and Orientation (x, y, z, w).

ASE reads such files too, but says neither in which line nor in which column one is wrong.
"""

from __future__ import annotations

import os
import re
import shlex
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._frames import Frame, Location, Options
from ._table import Lines, locate_frames

SUFFIXES = (".xyz", ".extxyz")
# Names of properties without capitals and underscores, and how many columns each has.
_PROPERTIES = {"pos": 3, "asphericalshape": 3, "orientation": 4, "radius": 1, "species": 1, "type": 1, "id": 1}


def recognise(start: bytes) -> bool:
    lines = start.split(b"\n", 2)
    return len(lines) > 1 and lines[0].strip().isdigit() and b"Properties=" in lines[1]


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    def lines_of_frame(lines: Lines) -> int | None:
        count = _count(lines)
        return None if count is None else 1 + count

    return locate_frames(path, lines_of_frame)


def _count(lines: Lines) -> int | None:
    line = lines.next()
    while line == "":
        line = lines.next()
    if line is None:
        return None
    if not line.isdigit():
        raise lines.error(f"the number of particles should be here, not '{line[:40]}': more lines than particles, or no XYZ file")
    return int(line)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        count = _count(lines) or 0
        keys = _keys(lines)
        columns, text = _columns(keys, lines)
        table = lines.table(count, columns, text)
        cell = keys.get("Lattice")
        box = None if cell is None else np.reshape(lines.numbers(cell, 9, "Lattice"), (3, 3))
        origin = lines.numbers(keys.get("Origin", "0 0 0"), 3, "Origin")
    groups = {name: [f"{name}{k}" for k in range(n)] for name, n in _PROPERTIES.items() if f"{name}0" in columns}
    if "pos" not in groups:
        raise lines.error("the property pos is missing in 'Properties='")
    shape = groups.get("asphericalshape") or 3 * groups.get("radius", [])
    types = groups.get("species") or groups.get("type")
    frame = Frame(
        path, location, table.stack(groups["pos"]),
        shapes=table.stack(shape) if shape else None,
        quaternions=table.stack(groups["orientation"]) if "orientation" in groups else None,
        order="xyzw",
        types=_types(table[types[0]]) if types else None,
        ids=table.integers("id0") if "id" in groups else None,
        cell=box, origin=origin, periodic=[flag[:1].upper() in "T1" for flag in keys.get("pbc", "T T T").split()],
        step=int(float(keys.get("Timestep", 0))), lines=range(table.line, table.line + count),
    )  # fmt: skip
    return frame.system(options)


def _types(column: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
    """Numbers where all types are."""
    try:
        return column.astype(np.int64)
    except ValueError:
        return column


def _keys(lines: Lines) -> dict[str, str]:
    comment = lines.expect("the line with Properties")
    try:
        words = shlex.split(comment)
    except ValueError:
        raise lines.error("a quotation mark has no partner") from None
    keys = dict(word.split("=", 1) for word in words if "=" in word)
    if "Properties" not in keys:
        raise lines.error("'Properties=' is missing: only extended XYZ has shapes")
    return keys


def _columns(keys: dict[str, str], lines: Lines) -> tuple[list[str], list[str]]:
    """Names of the columns, numbered within each property, and of those that hold text."""
    columns, text = [], []
    for name, kind, number in re.findall(r"([^:]+):([SIRL]):(\d+):?", keys["Properties"]):
        plain = name.replace("_", "").lower()
        if plain in _PROPERTIES and int(number) != _PROPERTIES[plain]:
            raise lines.error(f"the property {name} has {number} columns instead of {_PROPERTIES[plain]}")
        names = [f"{plain}{k}" for k in range(int(number))]
        columns += names
        text += names if kind in "SL" else []
    return columns, text


def save(file: IO[str], system: System, frame: int) -> None:
    keys = [f"Timestep={system.step}"]
    if system.cell is not None:
        flags = " ".join("FT"[flag] for flag in system.periodic)
        keys += [f'Lattice="{_numbers(system.cell)}"', f'Origin="{_numbers(system.origin)}"', f'pbc="{flags}"']
    keys += ["Properties=id:I:1:species:S:1:pos:R:3:aspherical_shape:R:3:orientation:R:4"]
    file.write(f"{len(system)}\n{' '.join(keys)}\n")
    numbers: Any = np.column_stack([system.centers, system.semi_axes, system.quaternions[:, [1, 2, 3, 0]]])
    for name, kind, row in zip(system.ids, system.types, numbers):
        file.write(f"{name} {kind} {_numbers(row)}\n")


def _numbers(values: np.ndarray) -> str:  # type: ignore[type-arg]
    return " ".join(f"{value:.17g}" for value in np.ravel(values))
