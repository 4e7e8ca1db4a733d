"""Tables with a comma between columns and their names in the first line.

Columns: x y z; the semi-axes a b c, or radius; the quaternion qw qx qy qz; id and type. A line ``# cell`` before the names
holds the nine components of the vectors of a cell, ``# origin`` three, ``# periodic`` three of T and F, ``# step`` a time step.
Names of types are quoted where they have a comma or a quotation mark.
"""

from __future__ import annotations

import os
import re
from typing import IO
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._frames import Frame, Location, Options
from ._names import PRINTED, Rule, checked_names
from ._table import Lines, coded, write_rows

SUFFIXES = (".csv",)
_NUMBER = re.compile(r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?")
_POSITION, _SHAPE, _QUATERNION = ["x", "y", "z"], ["a", "b", "c"], ["qw", "qx", "qy", "qz"]


def recognise(start: bytes) -> bool:
    lines = start.removeprefix(b"\xef\xbb\xbf").split(b"\n")
    names = next((line for line in lines if not line.startswith(b"#")), b"")
    return {b"x", b"y", b"z"} <= {word.strip().strip(b'"') for word in names.split(b",")}


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        keys: dict[str, str] = {}
        while (line := lines.expect("the names of the columns")).startswith("#"):
            name, _, keys_of = line[1:].strip().partition(" ")
            if name in ("cell", "origin", "periodic", "step"):
                keys[name] = keys_of
        columns = [word.strip().strip('"') for word in line.split(",")]
        shape, quaternion = _named(columns, options, lines)
        periodic = lines.flags(keys.get("periodic", "T T T"), "periodic")
        step = lines.whole(keys.get("step", "0"), "step", -(2**63))
        cell = np.reshape(lines.numbers(keys["cell"], 9, "cell"), (3, 3)) if "cell" in keys else None
        origin = lines.numbers(keys.get("origin", "0 0 0"), 3, "origin")
        table = lines.table(_remaining(lines), columns, ["type"], ",", [*_POSITION, *shape, *quaternion, "id", "type"])
    has_types = "type" in table
    frame = Frame(
        path, location, table.stack(_POSITION),
        shapes=table.stack(shape if len(shape) == 3 else 3 * shape) if shape else None,
        quaternions=table.stack(quaternion) if quaternion else None,
        types=table["type"] if has_types else None, ids=table.integers("id") if "id" in table else None,
        cell=cell, origin=origin, periodic=periodic, step=step,
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


def _remaining(lines: Lines) -> int:
    place = lines.location(lines.frame)
    count = lines.skip(2**62)
    lines.back(place)
    return count


def _is_no_formula(name: str) -> bool:
    """Spreadsheets compute what begins so, unless it is a number."""
    return name[:1] not in tuple("=+-@") or _NUMBER.fullmatch(name) is not None


_HARMLESS: Rule = (_is_no_formula, "is a formula to a spreadsheet, which opens files of this format")
_TRIMMED: Rule = (lambda name: name == name.strip() != "", "is empty, or begins or ends with a blank")


def save(file: IO[str], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a CSV file holds one frame: choose one (--frames)")
    names = checked_names(system, PRINTED, _TRIMMED, _HARMLESS)
    if system.step:
        file.write(f"# step {system.step}\n")
    if system.cell is not None:
        for name, values in (("cell", system.cell), ("origin", system.origin)):
            file.write(f"# {name} {' '.join(f'{value:.17g}' for value in np.ravel(values))}\n")
        file.write(f"# periodic {' '.join('FT'[flag] for flag in system.periodic)}\n")
    file.write(",".join(["id", "type", *_POSITION, *_SHAPE, *_QUATERNION]) + "\n")
    write_rows(file, ",", system.ids, coded(names, _quoted), system.centers, system.semi_axes, system.quaternions)


def _quoted(name: str) -> str:
    """In quotation marks, which are doubled within, if need be."""
    return '"' + name.replace('"', '""') + '"' if set(name) & set(',"') else name
