"""Tables with a comma between columns and their names in the first line.

Columns: x y z; the semi-axes a b c, or radius; the quaternion qw qx qy qz; id and type. A line ``# cell`` before the names
holds the nine components of the vectors of a cell, ``# origin`` three, ``# periodic`` three of T and F.
"""

from __future__ import annotations

import os
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._frames import Frame, Location, Options
from ._table import Lines, Table

SUFFIXES = (".csv",)
_POSITION, _SHAPE, _QUATERNION = ["x", "y", "z"], ["a", "b", "c"], ["qw", "qx", "qy", "qz"]


def recognise(start: bytes) -> bool:
    names = next((line for line in start.split(b"\n") if not line.startswith(b"#")), b"")
    return {b"x", b"y", b"z"} <= {word.strip() for word in names.split(b",")}


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        keys: dict[str, str] = {}
        while (line := lines.expect("the names of the columns")).startswith("#"):
            name, _, keys_of = line[1:].strip().partition(" ")
            keys[name] = keys_of
        columns = [word.strip() for word in line.split(",")]
        shape, quaternion = _named(columns, options, lines)
        table = lines.table(_remaining(lines), columns, ["type"], ",", [*_POSITION, *shape, *quaternion, "id", "type"])
        cell = np.reshape(lines.numbers(keys["cell"], 9, "cell"), (3, 3)) if "cell" in keys else None
        origin = lines.numbers(keys.get("origin", "0 0 0"), 3, "origin")
    frame = Frame(
        path, location, table.stack(_POSITION),
        shapes=table.stack(shape if len(shape) == 3 else 3 * shape) if shape else None,
        quaternions=table.stack(quaternion) if quaternion else None,
        types=_types(table), ids=table.integers("id") if "id" in table else None,
        cell=cell, origin=origin, periodic=[word == "T" for word in keys.get("periodic", "T T T").split()],
        lines=range(table.line, table.line + table.count),
    )  # fmt: skip
    return frame.system(options)


def _named(columns: list[str], options: Options, lines: Lines) -> tuple[list[str], list[str]]:
    known: list[str] = next((names for names in (_SHAPE, ["radius"]) if set(names) <= set(columns)), [])
    shape = list(options.shape_columns or known)
    quaternion = list(options.quaternion_columns or (_QUATERNION if set(_QUATERNION) <= set(columns) else []))
    missing = [name for name in (*_POSITION, *shape, *quaternion) if name not in columns]
    if missing:
        raise lines.error(f"there is no column '{missing[0]}', but {' '.join(columns)}: rename or name columns")
    return shape, quaternion


def _types(table: Table) -> np.ndarray | None:  # type: ignore[type-arg]
    if "type" not in table:
        return None
    names = table["type"]
    return names.astype(np.int64) if np.char.isdigit(names).all() else names


def _remaining(lines: Lines) -> int:
    place = lines.location(lines.frame)
    count = lines.skip(2**62)
    lines.back(place)
    return count


def save(file: IO[str], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a CSV file holds one frame: choose one (--frames)")
    if system.cell is not None:
        for name, values in (("cell", system.cell), ("origin", system.origin)):
            file.write(f"# {name} {' '.join(f'{value:.17g}' for value in np.ravel(values))}\n")
        file.write(f"# periodic {' '.join('FT'[flag] for flag in system.periodic)}\n")
    file.write(",".join(["id", "type", *_POSITION, *_SHAPE, *_QUATERNION]) + "\n")
    rows: Any = np.column_stack([system.centers, system.semi_axes, system.quaternions])
    for name, kind, row in zip(system.ids, system.types, rows):
        file.write(f"{name},{kind},{','.join(f'{value:.17g}' for value in row)}\n")
