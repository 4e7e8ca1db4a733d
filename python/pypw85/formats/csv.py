# SPDX-License-Identifier: BSD-3-Clause
"""Tables with a comma between columns and their names in the first line; read with semicolons, tabulators and decimal commas, too.

Columns that are written: x y z; the semi-axes a b c, or radius; the quaternion qw qx qy qz; id and type. A line ``# cell`` before the names
holds the nine components of the vectors of a cell, ``# origin`` three, ``# periodic`` three of T and F, ``# step`` a time step,
``# dimensions`` 2 if these are ellipses. A table of ellipses may have x y, a b and an angle instead, and four components of a cell.
Names of types are quoted where they have a comma or a quotation mark.
"""

from __future__ import annotations

import itertools
import os
import re
from typing import IO
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._columns import fill, plain_name, take
from ._frames import Frame, Location, Options, said_dimensions
from ._names import PRINTED, Rule, checked_names
from ._table import Lines, coded, write_rows

SUFFIXES = (".csv",)
_NUMBER = re.compile(r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?")
_POSITION, _SHAPE, _QUATERNION = ["x", "y", "z"], ["a", "b", "c"], ["qw", "qx", "qy", "qz"]
_SEPARATORS = (",", ";", "\t", "|", None)
# Names as `plain_name` makes them: first what is written, then those of spreadsheets, ParaView and DREAM.3D
_POSITIONS = [
    tuple(stem + end for end in ends)
    for stem, ends in [("", "xyz"), ("pos", "xyz"), ("position", "xyz"), ("center", "xyz"), ("centre", "xyz"), ("centroid", "xyz"),
                       ("c", "xyz"), ("points", "012"), ("centroids", "012"), ("coordinates", "012"), ("position", "012")]
]  # fmt: skip
_IDS, _TYPES = ("id", "ids", "particleid", "featureid", "index", "number"), ("type", "types", "species", "phase", "phases")


def recognise(start: bytes) -> bool:
    lines = start.decode("utf-8", errors="replace").removeprefix("\ufeff").splitlines()
    return any(_are_names(line) for line in itertools.takewhile(_may_precede, lines)) or any(
        _are_names(line) for line in itertools.islice(itertools.dropwhile(_may_precede, lines), 1))  # fmt: skip


def _may_precede(line: str) -> bool:
    """Lines before the names of columns: comments, and the number of rows that DREAM.3D writes."""
    return line.startswith("#") or not line.strip() or line.strip().isdecimal()


def _are_names(line: str) -> bool:
    return bool(_header(line)[1])


def _header(line: str) -> tuple[str | None, list[str], list[str]]:
    """The separator, the names of the columns that hold a position (none if there are none), and those of all columns.

    The names may be a comment, as NumPy writes them.
    """
    found = [(one, _split(line.removeprefix("#"), one)) for one in _SEPARATORS]
    for count in (3, 2):  # two in tables of ellipses
        for separator, columns in found:
            plain = {plain_name(name): name for name in reversed(columns)}
            for names in _POSITIONS:
                if set(names[:count]) <= plain.keys():
                    return separator, [plain[name] for name in names[:count]], columns
    separator, columns = max(found, key=lambda pair: len(pair[1]))
    return separator, [], columns


def _split(line: str, separator: str | None) -> list[str]:
    return [word.strip().strip('"').strip() for word in line.split(separator)]


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        keys, line = _keys(lines)
        separator, positions, columns = _header(line)
        if not positions:
            raise lines.error(f"there is no column 'x', but {' '.join(columns)}: rename those of positions to x, y and z")
        taken = take(columns, options, lines.error, "radii", "wxyz")
        plain = {plain_name(name): name for name in reversed(columns)}
        ids, types = (next((plain[name] for name in names if name in plain), "") for names in (_IDS, _TYPES))
        step = lines.whole(keys.get("step", "0"), "step", -(2**63))
        cell = _cell(lines, keys["cell"]) if "cell" in keys else None
        if cell is not None and len(keys["cell"].split()) == 4:
            keys = _completed(keys)
        origin = lines.numbers(keys.get("origin", "0 0 0"), 3, "origin")
        periodic = lines.flags(keys.get("periodic", "T T T"), "periodic")
        dimensions = lines.whole(keys["dimensions"], "dimensions") if "dimensions" in keys else None
        if dimensions not in (None, 2, 3):
            raise lines.error(f"'dimensions' should be 2 or 3, not {dimensions}")
        # Behind the rows that DREAM.3D says there are, lists of neighbours may follow.
        count = min(_remaining(lines), lines.whole(keys.get("rows", str(2**62)), "the number of rows"))
        if not count:
            raise lines.error("there are no particles")
        wanted = [name for name in (*positions, *taken.columns, ids, types) if name]
        table = lines.table(count, columns, [types], separator, wanted, decimal_comma=separator != ",")
    frame = Frame(
        path, location, table.stack(positions),
        types=table[types] if types else None, ids=table.integers(ids) if ids else None,
        cell=cell, origin=origin, periodic=periodic, step=step,
        lines=range(table.line, table.line + table.count), dimensions=dimensions,
    )  # fmt: skip
    fill(frame, taken, table)
    return frame.system(options)


def _cell(lines: Lines, text: str) -> Floats:
    """Three vectors, or the two of a plane."""
    if len(text.split()) != 4:
        return np.reshape(lines.numbers(text, 9, "cell"), (3, 3))
    cell = np.eye(3)
    cell[:2, :2] = np.reshape(lines.numbers(text, 4, "cell"), (2, 2))
    return cell


def _completed(keys: dict[str, str]) -> dict[str, str]:
    """What the lines say of the cell of a plane, with the third number or flag."""
    others = {"origin": " -0.5", "periodic": " F"}
    return keys | {name: keys[name] + end for name, end in others.items() if len(keys.get(name, "").split()) == 2}


def _keys(lines: Lines) -> tuple[dict[str, str], str]:
    """What the lines before the names say, and the line with the names."""
    keys: dict[str, str] = {}
    while _may_precede(line := lines.expect("the names of the columns")) and not _are_names(line):
        name, _, value = line[1:].strip().partition(" ")
        if name in ("cell", "dimensions", "origin", "periodic", "step"):
            keys[name] = value
        elif line.isdecimal():
            keys["rows"] = line
    return keys, line


def _remaining(lines: Lines) -> int:
    """How many lines there are up to the last one that is not blank."""
    place = lines.location(lines.frame)
    count = last = 0
    while (block := lines.read_block(2**62))[1]:
        text = block[0].rstrip()
        last = count + text.count(b"\n") + 1 if text else last
        count += block[1]
    lines.back(place)
    return last


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
    if dimensions := said_dimensions(system):
        file.write(f"# dimensions {dimensions}\n")
    if system.cell is not None:
        for name, values in (("cell", system.cell), ("origin", system.origin)):
            file.write(f"# {name} {' '.join(f'{value:.17g}' for value in np.ravel(values))}\n")
        file.write(f"# periodic {' '.join('FT'[flag] for flag in system.periodic)}\n")
    file.write(",".join(["id", "type", *_POSITION, *_SHAPE, *_QUATERNION]) + "\n")
    write_rows(file, ",", system.ids, coded(names, _quoted), system.centers, system.semi_axes, system.quaternions)


def _quoted(name: str) -> str:
    """In quotation marks, which are doubled within, if need be."""
    return '"' + name.replace('"', '""') + '"' if set(name) & set(',"') else name
