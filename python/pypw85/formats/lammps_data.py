"""Data files of LAMMPS (write_data) for atom_style ellipsoid."""

from __future__ import annotations

import os
import re
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._boxes import box, numbered_types
from ._errors import FileError
from ._frames import Frame, Location, Options
from ._table import Lines, Table

SUFFIXES = (".data", ".lmp")
_ATOMS = ["id", "type", "ellipsoid", "density", "x", "y", "z"]
_ELLIPSOIDS = ["id", "shapex", "shapey", "shapez", "quatw", "quati", "quatj", "quatk"]


def recognise(start: bytes) -> bool:
    return re.search(rb"^\s*\d+\s+atoms\b", start, re.MULTILINE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        lines.next()
        counts, bounds, tilts, section = _header(lines)
        atoms: Table | None = None
        ellipsoids: Table | None = None
        while section is not None:
            name = section.split("#")[0].strip()
            if name == "Atoms":
                atoms = _table(lines, section, counts["atoms"])
            elif name == "Ellipsoids":
                ellipsoids = _table(lines, section, counts.get("ellipsoids", 0))
            section = _next_section(lines)
    if atoms is None:
        raise FileError(path, "there is no section Atoms: the file is truncated, or no data file of LAMMPS", 0)
    shapes, quaternions = _shapes(path, atoms, ellipsoids)
    frame = Frame(
        path, location, atoms.stack(["x", "y", "z"]), shapes, quaternions, "diameters",
        types=atoms.integers("type"), ids=atoms.integers("id"),
        cell=np.diag(bounds[:, 1] - bounds[:, 0]) + tilts, origin=bounds[:, 0],
        lines=range(atoms.line, atoms.line + atoms.count),
    )  # fmt: skip
    return frame.system(options)


def _header(lines: Lines) -> tuple[dict[str, int], Floats, Floats, str | None]:
    """Counts, bounds, tilts of the box, and the first line of the first section."""
    counts: dict[str, int] = {}
    bounds, tilts = np.full((3, 2), np.nan), np.zeros((3, 3))
    while (line := lines.next()) is not None:
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0][0].isalpha():
            break
        if words[-1] in ("xhi", "yhi", "zhi"):
            bounds["xyz".index(words[-1][0])] = lines.numbers(" ".join(words[:-2]), 2, "bounds of the box")
        elif words[-3:] == ["xy", "xz", "yz"]:
            tilts[[1, 2, 2], [0, 0, 1]] = lines.numbers(" ".join(words[:-3]), 3, "tilts of the box")
        elif len(words) == 2:
            counts[words[1]] = int(lines.numbers(words[0], 1, f"the number of {words[1]}")[0])
    if "atoms" not in counts or np.isnan(bounds).any():
        raise lines.error("the number of atoms or the bounds of the box are missing before the first section")
    return counts, bounds, tilts, line


def _next_section(lines: Lines) -> str | None:
    while (line := lines.next()) is not None:
        if line and line[0].isalpha():
            return line
    return None


def _table(lines: Lines, section: str, count: int) -> Table:
    """The table of a section; behind the columns of atoms there may be three image flags."""
    style = section.partition("#")[2].strip()
    if section.startswith("Atoms") and style not in ("", "ellipsoid"):
        raise lines.error(f"atom_style {style} has no shapes: write the file with atom_style ellipsoid")
    lines.expect("an empty line")
    place = lines.location(lines.frame)
    words = len(lines.expect(f"section {section}").split())
    columns = _ELLIPSOIDS
    if section.startswith("Atoms"):
        columns = _ATOMS + ["ix", "iy", "iz"] * (words == 10)
    lines.back(place)
    return lines.table(count, columns)


def _shapes(path: os.PathLike[str], atoms: Table, ellipsoids: Table | None) -> tuple[Floats | None, Floats | None]:
    """Rows in the order of the atoms, 0 0 0 for those without."""
    if ellipsoids is None:
        return None, None
    ids, known = atoms.integers("id"), ellipsoids.integers("id")
    order = np.argsort(ids, kind="stable")
    places = order[np.minimum(np.searchsorted(ids, known, sorter=order), len(ids) - 1)]
    if (ids[places] != known).any():
        wrong = int((ids[places] != known).argmax())
        raise FileError(path, f"there is no atom {known[wrong]}: remove this ellipsoid", 0, ellipsoids.line + wrong)
    shapes, quaternions = np.zeros((len(ids), 3)), np.tile([1.0, 0, 0, 0], (len(ids), 1))
    shapes[places], quaternions[places] = ellipsoids.stack(_ELLIPSOIDS[1:4]), ellipsoids.stack(_ELLIPSOIDS[4:])
    return shapes, quaternions


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a data file of LAMMPS holds one frame: choose one (--frames)")
    cell, low = box(system)
    types = numbered_types(system)
    file.write(f"ellipsoids of pw85\n\n{len(system)} atoms\n{len(system)} ellipsoids\n{types.max()} atom types\n\n")
    for name, start, length in zip("xyz", low, np.diag(cell)):
        file.write(f"{start:.17g} {start + length:.17g} {name}lo {name}hi\n")
    if (tilts := cell[[1, 2, 2], [0, 0, 1]]).any():
        file.write("{:.17g} {:.17g} {:.17g} xy xz yz\n".format(*tilts))
    file.write("\nAtoms # ellipsoid\n\n")
    ones = np.ones(len(system))
    np.savetxt(file, np.column_stack([system.ids, types, ones, ones, system.centers]), fmt="%d %d %d %g" + 3 * " %.17g")
    file.write("\nEllipsoids\n\n")
    rows: Any = np.column_stack([system.ids, 2 * system.semi_axes, system.quaternions])
    np.savetxt(file, rows, fmt="%d" + 7 * " %.17g")
