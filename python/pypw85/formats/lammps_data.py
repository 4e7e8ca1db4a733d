"""Data files of LAMMPS (write_data) for atom_style ellipsoid."""

from __future__ import annotations

import os
import re
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._boxes import bounds, lost_periodicity, numbered_types
from ._errors import FileError
from ._frames import Frame, Location, Options
from ._names import ONE_WORD, PRINTED, checked_names, numbers_if_all_are, type_names
from ._table import Lines, Table, write_rows

SUFFIXES = (".data", ".lmp")
_ATOMS = ["id", "type", "ellipsoid", "density", "x", "y", "z"]
_ELLIPSOIDS = ["id", "shapex", "shapey", "shapez", "quatw", "quati", "quatj", "quatk"]
# Names of types, which LAMMPS has since 2022
_LABELS = "Atom Type Labels"
# Sections that are read, and what the header calls their rows.
_SECTIONS = {"Atoms": "atoms", "Ellipsoids": "ellipsoids", _LABELS: "atom types"}

# What LAMMPS allows, and does not take for a number, a wildcard, a comment or a variable.
_LABEL = (re.compile(r"[^\d*#\"'$&+.-][^#\"'$&]*").fullmatch, "is no name that LAMMPS allows: it should begin with a letter")


def recognise(start: bytes) -> bool:
    return re.search(rb"^\s*\d+\s+atoms\b", start, re.MULTILINE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        title = re.search(r"\btimestep = (-?[0-9]{1,18})\b", lines.next() or "")
        counts, corners, tilts, section = _header(lines)
        tables: dict[str, Table] = {}
        while section is not None:
            name = section.split("#")[0].strip()
            if name in _SECTIONS:
                if name in tables:
                    raise lines.error(f"there are several sections {name}: remove all but one")
                tables[name] = _table(lines, section, counts.get(_SECTIONS[name], 0))
            section = _next_section(lines)
    atoms = tables.get("Atoms")
    if atoms is None:
        raise FileError(path, "there is no section Atoms: the file is truncated, or no data file of LAMMPS", 0)
    shapes, quaternions = _shapes(path, atoms, tables.get("Ellipsoids"))
    frame = Frame(
        path, location, atoms.stack(["x", "y", "z"]), shapes, quaternions, "diameters",
        types=_types(path, atoms, tables.get(_LABELS)), ids=atoms.integers("id"),
        cell=np.diag(corners[:, 1] - corners[:, 0]) + tilts, origin=corners[:, 0],
        step=int(title[1]) if title else 0, lines=range(atoms.line, atoms.line + atoms.count),
    )  # fmt: skip
    return frame.system(options)


def _types(path: os.PathLike[str], atoms: Table, labels: Table | None) -> Any:
    """Names instead of the numbers that have one."""
    if labels is None:
        return atoms["type"]
    names = dict(zip(map(str, labels.integers("id").tolist()), labels["type"].tolist()))
    if len(set(names.values())) < labels.count:
        raise FileError(path, f"a number or a name occurs twice in the section {_LABELS}: repair it", 0, labels.line)
    return np.array([names.get(kind, kind) for kind in atoms["type"].tolist()])


def _header(lines: Lines) -> tuple[dict[str, int], Floats, Floats, str | None]:
    """Counts, corners, tilts of the box, and the first line of the first section."""
    counts: dict[str, int] = {}
    corners, tilts = np.full((3, 2), np.nan), np.zeros((3, 3))
    while (line := lines.next()) is not None:
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0][0].isalpha():
            break
        if words[-1] in ("xhi", "yhi", "zhi"):
            corners["xyz".index(words[-1][0])] = lines.numbers(" ".join(words[:-2]), 2, "bounds of the box")
        elif words[-3:] == ["xy", "xz", "yz"]:
            tilts[[1, 2, 2], [0, 0, 1]] = lines.numbers(" ".join(words[:-3]), 3, "tilts of the box")
        elif words[1:] in (["atoms"], ["ellipsoids"], ["atom", "types"]):
            counts[" ".join(words[1:])] = lines.whole(words[0], f"the number of {' '.join(words[1:])}")
    if "atoms" not in counts or np.isnan(corners).any():
        raise lines.error("the number of atoms or the bounds of the box are missing before the first section")
    return counts, corners, tilts, line


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
    columns = ["id", "type"] if section.startswith(_LABELS) else _ELLIPSOIDS
    if section.startswith("Atoms"):
        columns = _ATOMS + ["ix", "iy", "iz"] * (words == 10)
    lines.back(place)
    return lines.table(count, columns, ["type"])


def _shapes(path: os.PathLike[str], atoms: Table, ellipsoids: Table | None) -> tuple[Floats | None, Floats | None]:
    """Rows in the order of the atoms, 0 0 0 for those without."""
    if ellipsoids is None:
        return None, None
    ids, known = atoms.integers("id"), ellipsoids.integers("id")
    for table, numbers in ((atoms, ids), (ellipsoids, known)):
        if len(np.unique(numbers)) < len(numbers):
            first = np.unique(numbers, return_index=True)[1]
            again = int(np.setdiff1d(np.arange(len(numbers)), first)[0])
            raise FileError(path, f"the id {numbers[again]} is there twice: number the particles anew", 0, table.line + again)
    order = np.argsort(ids, kind="stable")
    strange = ~np.isin(known, ids)
    if strange.any():
        wrong = int(strange.argmax())
        raise FileError(path, f"there is no atom {known[wrong]}: remove this ellipsoid", 0, ellipsoids.line + wrong)
    places = order[np.searchsorted(ids, known, sorter=order)]
    shapes, quaternions = np.zeros((len(ids), 3)), np.tile([1.0, 0, 0, 0], (len(ids), 1))
    shapes[places], quaternions[places] = ellipsoids.stack(_ELLIPSOIDS[1:4]), ellipsoids.stack(_ELLIPSOIDS[4:])
    return shapes, quaternions


def losses(system: System) -> Iterator[tuple[str, str]]:
    yield from lost_periodicity(system)
    if numbered_types(system)[1] and not _has_labels(system):
        yield "types", "types of LAMMPS are numbers from 1: others are numbered anew, in their order"


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a data file of LAMMPS holds one frame: choose one (--frames)")
    cell, low, high = bounds(system)
    types, has_names = numbered_types(system)
    file.write(f"ellipsoids of pw85, timestep = {system.step}\n\n")
    file.write(f"{len(system)} atoms\n{len(system)} ellipsoids\n{types.max()} atom types\n\n")
    for axis, start, end in zip("xyz", low, high):
        file.write(f"{start:.17g} {end:.17g} {axis}lo {axis}hi\n")
    if (tilts := cell[[1, 2, 2], [0, 0, 1]]).any():
        file.write("{:.17g} {:.17g} {:.17g} xy xz yz\n".format(*tilts))
    if has_names and _has_labels(system):
        _write_labels(file, system)
    file.write("\nAtoms # ellipsoid\n\n")
    write_rows(file, " ", system.ids, types, np.ones((len(system), 2), np.int64), system.centers)
    file.write("\nEllipsoids\n\n")
    write_rows(file, " ", system.ids, 2 * system.semi_axes, system.quaternions)


def _has_labels(system: System) -> bool:
    return numbers_if_all_are(type_names(system)).dtype.kind == "U"


def _write_labels(file: IO[Any], system: System) -> None:
    names = checked_names(system, PRINTED, ONE_WORD, _LABEL)
    file.write(f"\n{_LABELS}\n\n")
    for number, name in enumerate(np.unique(names), 1):
        file.write(f"{number} {name}\n")
