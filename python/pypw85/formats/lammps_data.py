# SPDX-License-Identifier: BSD-3-Clause
"""Data files of LAMMPS (write_data) for atom_style ellipsoid, for hybrid styles with it, and for atom_style sphere."""

from __future__ import annotations

import os
import re
from typing import IO, Any, NamedTuple
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from ._boxes import bounds, check_bounds, lost_periodicity, numbered_types
from ._columns import describe
from ._errors import FileError
from ._dimensions import lost_dimensions
from ._frames import Frame, Location
from ._options import Options
from ._names import ONE_WORD, PRINTED, checked_names, numbers_if_all_are, type_names
from ._table import Lines, Table, write_rows

SUFFIXES = (".data", ".lmp")
_ATOMS = ["id", "type", "ellipsoid", "density", "x", "y", "z"]
_SPHERES = ["id", "type", "diameter", "density", "x", "y", "z"]
_BONDED_SPHERES = ["id", "molecule", *_SPHERES[1:]]
_COLUMNS = {"sphere": _SPHERES, "bpm/sphere": _BONDED_SPHERES, "ellipsoid": _ATOMS}
# The flag of atom_style ellipsoid in a hybrid style
_FLAG = "flag"
_ELLIPSOIDS = ["id", "shapex", "shapey", "shapez", "quatw", "quati", "quatj", "quatk"]
# Exponents of superellipsoids, which LAMMPS has since 2026
_BLOCKS = ["block1", "block2"]
_STYLES_WITHOUT_SHAPES = set(
    "angle atomic body bond bpm charge dielectric dipole dpd edpd electron full line mdpd mesont molecular oxdna peri rheo smd sph "
    "spin tdpd template tri wavepacket".split()
)
# Names of types, which LAMMPS has since 2022
_LABELS = "Atom Type Labels"
# Sections that are read, and what the header calls their rows.
_SECTIONS = {"Atoms": "atoms", "Ellipsoids": "ellipsoids", _LABELS: "atom types"}

# What LAMMPS allows, and does not take for a number, a wildcard, a comment or a variable.
_LABEL = (re.compile(r"[^\d*#\"'$&+.-][^#\"'$&]*").fullmatch, "is not a name that LAMMPS allows: it must begin with a letter")


def recognise(start: bytes) -> bool:
    return re.search(rb"^\s*\d+\s+atoms\b", start, re.MULTILINE) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        title = re.search(r"\btimestep = (-?[0-9]{1,18})\b", lines.next() or "")
        header, section = _header(lines)
        tables: dict[str, Table] = {}
        while section is not None:
            name = section.split("#")[0].strip()
            if name in _SECTIONS:
                if name in tables:
                    raise lines.error(f"there are several sections {name}: remove all but one")
                if _SECTIONS[name] not in header.counts:
                    raise lines.error(f"the header does not say how many {_SECTIONS[name]} there are: write it there")
                tables[name] = _table(lines, section, header.counts[_SECTIONS[name]])
            section = _next_section(lines)
    atoms = tables.get("Atoms")
    if atoms is None:
        raise FileError(path, "there is no section Atoms: the file is truncated, or not a data file of LAMMPS", 0)
    if (count := header.counts.get("ellipsoids", 0)) and "Ellipsoids" not in tables:  # LAMMPS: Needed bonus data not in data file
        raise FileError(path, f"the header says that there are {count} ellipsoids, and there is no section Ellipsoids, which LAMMPS "
                        "refuses: the file is truncated; write it again", 0)  # fmt: skip
    frame = Frame(
        path, location, atoms.stack(["x", "y", "z"]), lengths="diameters", tolerance=np.inf,
        types=_types(path, atoms, tables.get(_LABELS)), ids=atoms.integers("id"),
        cell=header.cell, origin=header.origin,
        step=int(title[1]) if title else 0, lines=range(atoms.line, atoms.line + atoms.count),
    )  # fmt: skip
    _take_shapes(frame, atoms, tables.get("Ellipsoids"))
    return frame.system(options)


def _types(path: os.PathLike[str], atoms: Table, labels: Table | None) -> Any:
    """Names instead of the numbers that have one."""
    if labels is None:
        return atoms["type"]
    names = {str(number): str(name) for number, name in zip(labels.integers("id"), labels["type"])}
    if len(set(names.values())) < labels.count:
        raise FileError(path, f"a number or a name occurs twice in the section {_LABELS}: repair it", 0, labels.line)
    return np.array([names.get(kind, kind) for kind in map(str, atoms["type"])])


class _Header(NamedTuple):
    counts: dict[str, int]
    cell: Floats
    origin: Floats


def _header(lines: Lines) -> tuple[_Header, str | None]:
    """Reads the lines before the first section. Also returns the first line of that section."""
    counts: dict[str, int] = {}
    corners, tilts = np.full((3, 2), np.nan), np.zeros((3, 3))
    vectors = np.full((3, 3), np.nan)
    origin: Floats = np.zeros(3)
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
        elif words[-1] in ("avec", "bvec", "cvec"):
            vectors["abc".index(words[-1][0])] = lines.numbers(" ".join(words[:-1]), 3, "a vector of the box")
        elif words[-2:] == ["abc", "origin"]:
            origin = np.array(lines.numbers(" ".join(words[:-2]), 3, "the corner of the box"))
        elif words[1:] in (["atoms"], ["ellipsoids"], ["atom", "types"]):
            counts[" ".join(words[1:])] = lines.whole(words[0], f"the number of {' '.join(words[1:])}")
    is_general = not np.isnan(vectors).any()
    if "atoms" not in counts or (np.isnan(corners).any() and not is_general):
        raise lines.error("the number of atoms or the bounds of the box are missing before the first section")
    if is_general and (tilts.any() or not np.isnan(corners).all()):
        raise lines.error("the header gives the box twice, by its bounds and by avec, bvec and cvec, which LAMMPS refuses: remove one")
    if is_general:
        return _Header(counts, vectors, origin), line
    check_bounds(corners[:, 0], corners[:, 1], lines.error)
    return _Header(counts, np.diag(corners[:, 1] - corners[:, 0]) + tilts, corners[:, 0]), line


def _next_section(lines: Lines) -> str | None:
    while (line := lines.next()) is not None:
        if line and line[0].isalpha():
            return line
    return None


def _table(lines: Lines, section: str, count: int) -> Table:
    """The table of a section."""
    if lines.expect("an empty line").partition("#")[0].strip():
        raise lines.error(f"an empty line must follow {section[:40]}, because LAMMPS skips a line there: insert it")
    place = lines.location(lines.frame)
    words = len(lines.expect(f"section {section}").partition("#")[0].split())
    columns = ["id", "type"] if section.startswith(_LABELS) else _ELLIPSOIDS + _BLOCKS * (words == 10)
    if section.startswith("Atoms"):
        columns = _columns_of_atoms(lines, section.partition("#")[2].split(), words)
    lines.back(place)
    return lines.table(count, columns, ["type"], comment="#")


def _columns_of_atoms(lines: Lines, hint: list[str], words: int) -> list[str]:
    """Columns by the style that may be named behind Atoms; any other comment means nothing."""
    style = hint[0].split("/")[0] if hint else ""
    if style == "hybrid":
        flag = [_FLAG] if hint[1:2] == ["ellipsoid"] else []  # of the first of its styles
        return ["id", "type", "x", "y", "z", *flag] + [f"column {k}" for k in range(6 + len(flag), words + 1)]
    if style in _STYLES_WITHOUT_SHAPES and hint[0] != "bpm/sphere":
        raise lines.error(f"atom_style {hint[0]} has no shapes: write the file with atom_style ellipsoid")
    name = hint[0] if hint and hint[0] in _COLUMNS else "ellipsoid"
    columns = _COLUMNS[name]
    if words not in (len(columns), len(columns) + 3):
        raise lines.error(f"{words} columns, but atom_style {name} has {len(columns)} ({' '.join(columns)}), or {len(columns) + 3} with "
                          "the numbers of images: if these are atoms of a hybrid style, write 'Atoms # hybrid'")  # fmt: skip
    return columns + ["ix", "iy", "iz"] * (words > len(columns))


def _take_shapes(frame: Frame, atoms: Table, ellipsoids: Table | None) -> None:
    """Gives the frame shapes in the order of the atoms, 0 0 0 for those without. What LAMMPS refuses is refused."""
    ids = atoms.integers("id")
    known = ellipsoids.integers("id") if ellipsoids is not None else ids[:0]
    _check_ids(frame, atoms, ids)
    if "ellipsoid" in atoms:
        _check_style(frame, atoms)
    if ellipsoids is not None:
        _check_ids(frame, ellipsoids, known)
        strange = ~np.isin(known, ids)
        if strange.any():
            wrong = int(strange.argmax())
            raise _error(frame, ellipsoids, wrong, f"there is no atom {known[wrong]}: remove this ellipsoid")
    if ellipsoids is None and "diameter" in atoms:
        frame.shapes, frame.source = atoms.stack(3 * ["diameter"]), describe(["diameter"], "diameters", [], "wxyz")
    if ellipsoids is None:
        return
    _check_flags(frame, atoms, np.isin(ids, known))
    _check_lengths(frame, ellipsoids)
    order = np.argsort(ids, kind="stable")
    places = order[np.searchsorted(ids, known, sorter=order)]
    frame.shapes, frame.quaternions = np.zeros((len(ids), 3)), np.tile([1.0, 0, 0, 0], (len(ids), 1))
    frame.shapes[places], frame.quaternions[places] = ellipsoids.stack(_ELLIPSOIDS[1:4]), ellipsoids.stack(_ELLIPSOIDS[4:])
    frame.source = describe(_ELLIPSOIDS[1:4], "diameters", _ELLIPSOIDS[4:], "wxyz")


def _error(frame: Frame, table: Table, row: int, reason: str) -> FileError:
    return FileError(frame.path, reason, 0, table.line + row)


def _check_ids(frame: Frame, table: Table, ids: Any) -> None:
    if len(np.unique(ids)) < len(ids):
        again = int(np.setdiff1d(np.arange(len(ids)), np.unique(ids, return_index=True)[1])[0])
        raise _error(frame, table, again, f"the id {ids[again]} is there twice: renumber the particles")


def _check_lengths(frame: Frame, ellipsoids: Table) -> None:
    wrong = ~(ellipsoids.stack(_ELLIPSOIDS[1:4]) > 0).all(axis=1)
    if wrong.any():
        raise _error(frame, ellipsoids, int(wrong.argmax()), "an ellipsoid must have positive lengths: correct them, or remove the row, "
                     "and write the flag 0 for its atom")  # fmt: skip
    for name in set(_BLOCKS) & set(ellipsoids.columns):
        wrong = ellipsoids[name] != 2
        if wrong.any():
            raise _error(frame, ellipsoids, int(wrong.argmax()), f"{name} is not 2: this is a superellipsoid, and only ellipsoids can be "
                         "checked")  # fmt: skip


def _check_style(frame: Frame, atoms: Table) -> None:
    """Refuses rows of other styles with as many columns, such as full and sphere, by the flag and the density, which LAMMPS checks, too."""
    for name, which, wrong in (("ellipsoid", "third column must be the flag 0 or 1", ~np.isin(atoms["ellipsoid"], (0, 1))),
                               ("density", "fourth column must be the density > 0", ~(atoms["density"] > 0))):  # fmt: skip
        if wrong.any():
            raise _error(frame, atoms, int(wrong.argmax()), f"the {which} of atom_style ellipsoid, not {atoms[name][wrong][0]:g}: if these "
                         "are atoms of a hybrid style or of atom_style sphere, write 'Atoms # hybrid' or 'Atoms # sphere'; other styles "
                         "have no shapes, so write the file with "
                         "atom_style ellipsoid")  # fmt: skip


def _check_flags(frame: Frame, atoms: Table, has_row: Any) -> None:
    """LAMMPS asks that a flag of 1 says which atoms have a row in the section Ellipsoids. In a hybrid style of which ellipsoid is not
    the first, any column may be it."""
    if "ellipsoid" not in atoms:
        others = [_FLAG] if _FLAG in atoms else [name for name in atoms.columns if name.startswith("column ")]
        if not any((atoms[name] == has_row).all() for name in others):
            raise FileError(frame.path, "no column of the section Atoms has 1 for the atoms of the section Ellipsoids and 0 for all "
                            "others, as LAMMPS demands: check whether rows are missing", 0, atoms.line)  # fmt: skip
        return
    flags = atoms["ellipsoid"]
    wrong = (flags == 1) != has_row
    if wrong.any():
        row = int(wrong.argmax())
        there = "none" if flags[row] == 1 else "one"
        raise _error(frame, atoms, row, f"the atom {atoms.integers('id')[row]} has the flag {flags[row]:g}, but there is {there} for it in "
                     "the section Ellipsoids, which LAMMPS refuses: correct one of both")  # fmt: skip


def losses(system: System) -> Iterator[tuple[str, str]]:
    yield from lost_periodicity(system)
    yield from lost_dimensions(system)
    if numbered_types(system)[1] and not _has_labels(system):
        yield "types", "types of LAMMPS are numbers from 1: others are renumbered, in their order"
    if not _are_ids_of_lammps(system.ids):
        yield "ids", "ids of LAMMPS are different numbers from 1: the particles are renumbered, in their order"


def _are_ids_of_lammps(ids: Any) -> bool:
    return bool(ids.min() >= 1 and ids.max() < 2**31 and len(np.unique(ids)) == len(ids))


def _reduced_tilts(system: System, cell: Floats, edges: Floats) -> Floats:
    """xy, xz, yz of the same lattice, up to half of the edges along x and y: LAMMPS refuses larger ones of periodic systems."""
    a, b, c = np.diag(edges)
    b[0], c[:2] = cell[1, 0], cell[2, :2]
    for vector, other, axis in ((c, b, 1), (c, a, 0), (b, a, 0)):
        if system.periodic[axis] and abs(vector[axis]) > 0.5 * edges[axis]:
            vector -= np.round(vector[axis] / edges[axis]) * other
            if abs(vector[axis]) > 0.5 * edges[axis]:  # by rounding
                vector -= np.copysign(1.0, vector[axis]) * other
    return np.array([b[0], c[0], c[1]])


def save(file: IO[Any], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a data file of LAMMPS holds one frame: choose one with --frames")
    cell, low, high = bounds(system)
    types, has_names = numbered_types(system)
    ids = system.ids if _are_ids_of_lammps(system.ids) else np.arange(1, len(system) + 1)
    file.write(f"ellipsoids of pw85, timestep = {system.step}\n\n")
    file.write(f"{len(system)} atoms\n{len(system)} ellipsoids\n{types.max()} atom types\n\n")
    for axis, start, end in zip("xyz", low, high):
        file.write(f"{start:.17g} {end:.17g} {axis}lo {axis}hi\n")
    if (tilts := _reduced_tilts(system, cell, high - low)).any():
        file.write("{:.17g} {:.17g} {:.17g} xy xz yz\n".format(*tilts))
    if has_names and _has_labels(system):
        _write_labels(file, system)
    file.write("\nAtoms # ellipsoid\n\n")
    write_rows(file, " ", ids, types, np.ones((len(system), 2), np.int64), system.centers)
    file.write("\nEllipsoids\n\n")
    write_rows(file, " ", ids, 2 * system.semi_axes, system.quaternions)


def _has_labels(system: System) -> bool:
    return numbers_if_all_are(type_names(system)).dtype.kind == "U"


def _write_labels(file: IO[Any], system: System) -> None:
    names = checked_names(system, PRINTED, ONE_WORD, _LABEL)
    file.write(f"\n{_LABELS}\n\n")
    for number, name in enumerate(np.unique(names), 1):
        file.write(f"{number} {name}\n")
