# SPDX-License-Identifier: BSD-3-Clause
"""Dump files of LAMMPS (dump custom), as text."""

from __future__ import annotations

import os
import re
from typing import IO, Any, NamedTuple
from collections.abc import Iterator, Sequence

import numpy as np

from .._system import System
from .._typing import Floats
from ._boxes import bounds, check_bounds, numbered_types
from ._column_names import UNIT_AT_END
from ._column_values import fill
from ._columns import take
from ._errors import for_option
from ._dimensions import lost_dimensions
from ._frames import Frame, Location
from ._options import Options
from ._names import ONE_WORD, PRINTED, checked_names
from ._series import check_clumps, columns_of_clumps
from ._table import Lines, coded, locate_frames, write_rows
from ._taken import Taken

SUFFIXES = (".dump", ".lammpstrj")
_POSITIONS = (("x", "y", "z"), ("xu", "yu", "zu"), ("xs", "ys", "zs"), ("xsu", "ysu", "zsu"))
_ELLIPSES = (("x", "y"), ("xu", "yu"))
_SHAPE = ("shapex", "shapey", "shapez")
_QUATERNION = ("quatw", "quati", "quatj", "quatk")
# The column of names of types: since 2022, LAMMPS has names beside the numbers.
_LABEL = "typelabel"


class _Header(NamedTuple):
    step: int
    particles: int
    cell: Floats
    origin: Floats
    periodic: Sequence[bool]
    columns: list[str]


def recognise(start: bytes) -> bool:
    return start.lstrip().startswith(b"ITEM:")


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    def lines_of_frame(lines: Lines) -> int | None:
        header = _header(lines)
        return None if header is None else header.particles

    return locate_frames(path, lines_of_frame)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        header = _header(lines)
        if header is None:
            raise lines.error("the file has become shorter")
        if header.particles and not lines.columns_ahead():  # a line of columns that is cut would be misread
            lines.expect("a particle")
        positions = _positions(header.columns)
        if positions is None:
            raise lines.error(f"there are no columns x y z, but {' '.join(header.columns)}: dump them")
        taken = take(header.columns, options, lines.error, "diameters", "wxyz", [*positions, *_others(header.columns)],
                     len(positions) == 2)  # fmt: skip
        _check_turned(header, taken, lines)
        clumps = columns_of_clumps(header.columns, options)
        wanted = ["id", _type_column(header.columns), *positions, *taken.checked, *clumps]
        table = lines.table(header.particles, header.columns, [_LABEL], wanted=wanted)
        check_clumps(table, clumps, lines)
    centers = table.stack(positions)
    if positions[0].startswith("xs"):
        centers = header.origin + centers @ header.cell
    frame = Frame(
        path, location, centers,
        types=table[_LABEL] if _LABEL in table else table.integers("type") if "type" in table else None,
        ids=table.integers("id") if "id" in table else None,
        cell=header.cell, origin=header.origin, periodic=header.periodic, step=header.step,
        lines=range(table.line, table.line + table.count),
    )  # fmt: skip
    fill(frame, taken, table)
    _warn_of_points(frame, options)
    del table, centers  # of which the frame holds what it needs
    return frame.system(options)


def _positions(columns: Sequence[str]) -> tuple[str, ...] | None:
    """Three columns of one kind; two only if there is no third coordinate of any kind."""
    kinds = _POSITIONS if any(names[2] in columns for names in _POSITIONS) else _ELLIPSES
    return next((names for names in kinds if set(names) <= set(columns)), None)


def _others(columns: Sequence[str]) -> list[str]:
    """Ids, types, the charge, and computes, fixes and variables that are called like a unit, as c_cm."""
    known = ("id", "type", "type again", _LABEL, "q")
    return [name for name in columns if name in known or (name[:2] in ("c_", "f_", "v_") and UNIT_AT_END.fullmatch(name, 1))]


def _warn_of_points(frame: Frame, options: Options) -> None:
    """Before 4 Feb 2025, LAMMPS wrote the shape 0 0 0 for particles that are points."""
    if frame.types is None or frame.shapes is None or frame.quaternions is None:
        return
    unit = [1, 0, 0, 0] if (options.quaternion or frame.order) == "wxyz" else [0, 0, 0, 1]
    may_be = (frame.shapes == 1).all(axis=1) & (frame.quaternions == unit).all(axis=1)
    if not may_be.any() or not (np.ptp(frame.shapes, axis=1) > 0).any():
        return
    names = np.asarray(frame.types).astype(np.str_)
    for name in np.unique(names[may_be]).tolist():
        count = int((names == name).sum())
        if may_be[names == name].all() and name not in (options.points or ()):
            which, taken = f"all {count} particles of the type {name} have", "are taken as spheres"
            if count == 1:
                which, taken = f"the only particle of the type {name} has", "is taken as a sphere"
            frame.notes.append(f"{which} the shape 1 1 1 and the quaternion 1 0 0 0, as LAMMPS writes points since 4 Feb 2025, and "
                               f"{taken}: leave points out (--points {for_option([name])})")  # fmt: skip


def _check_turned(header: _Header, taken: Taken, lines: Lines) -> None:
    """LAMMPS turns positions into a general triclinic box, but not what computes give, as quaternions."""
    is_turned = header.cell[np.triu_indices(3, 1)].any() or (np.diag(header.cell) < 0).any()
    names, what = (taken.quaternion, "quaternions") if taken.quaternion else (taken.turn.columns, "angles or directions")
    if is_turned and names and not names[0].lower().startswith("orientation"):
        raise lines.error(f"the box is turned (triclinic/general): LAMMPS turns positions with it, but not the {what} {names[0]} of a "
                          "compute: dump without triclinic/general")  # fmt: skip


def _type_column(columns: Sequence[str]) -> str:
    return _LABEL if _LABEL in columns else "type"


def _header(lines: Lines) -> _Header | None:
    """Reads the header, up to the particles. Returns None at the end of the file."""
    step, count, box = 0, -1, None
    line = lines.next()
    while line == "":
        line = lines.next()
    if line is None:
        return None
    while not re.match("ITEM: (ATOMS|ENTRIES|GRID CELLS)", line):
        if line.startswith("ITEM: TIMESTEP"):
            step = lines.whole(lines.expect("a time step"), "the time step", -(2**63))
        elif line.startswith("ITEM: NUMBER OF ATOMS"):
            count = lines.whole(lines.expect("a number of particles"), "the number of particles")
        elif line.startswith("ITEM: BOX BOUNDS"):
            box = _box(line.split()[3:], lines)
        elif line.startswith("ITEM:"):
            lines.expect("a value")
        else:
            raise lines.error(f"an 'ITEM:' must be here, not '{line[:40]}': more lines than particles, or not a dump file")
        line = lines.expect("'ITEM: ATOMS'")
    if line.startswith("ITEM: ENTRIES"):
        raise lines.error("this is a dump of pairs (dump local), which have no positions: dump atoms")
    if line.startswith("ITEM: GRID CELLS"):
        raise lines.error("this is a dump of the cells of a grid (dump grid), not of particles: dump atoms")
    if count < 0 or box is None:
        raise lines.error("the number of particles or the box is missing before 'ITEM: ATOMS'")
    return _Header(step, count, *box, _once_type(line.split()[2:]))


def _once_type(columns: list[str]) -> list[str]:
    """LIGGGHTS's examples dump the type twice, in columns side by side."""
    first = columns.index("type") if "type" in columns else 0
    return [f"{name} again" if name == "type" and k > first else name for k, name in enumerate(columns)]


def _box(words: list[str], lines: Lines) -> tuple[Floats, Floats, list[bool]]:
    """Cell, origin, and which directions are periodic."""
    periodic = [word == "pp" for word in words if re.fullmatch("[pfsm]{2}", word)]
    if words[:2] == ["abc", "origin"]:
        rows = np.array([lines.numbers(lines.expect("the box"), 4, "a vector of the box") for _ in range(3)])
        return rows[:, :3], rows[:, 3], periodic
    columns = 3 if words[:1] == ["xy"] else 2
    rows = np.array([lines.numbers(lines.expect("the box"), columns, "bounds of the box") for _ in range(3)])
    xy, xz, yz = map(float, rows[:, 2] if columns == 3 else np.zeros(3))
    low = rows[:, 0] - [min(0.0, xy, xz, xy + xz), min(0.0, yz), 0.0]
    high = rows[:, 1] - [max(0.0, xy, xz, xy + xz), max(0.0, yz), 0.0]
    check_bounds(low, high, lines.error)
    cell = np.diag(high - low)
    cell[1, 0], cell[2, 0], cell[2, 1] = xy, xz, yz
    return cell, low, periodic


def losses(system: System) -> Iterator[tuple[str, str]]:
    yield from lost_dimensions(system)


def save(file: IO[Any], system: System, frame: int) -> None:
    cell, low, high = bounds(system)
    xy, xz, yz = map(float, cell[[1, 2, 2], [0, 0, 1]])
    sides = np.array([[low[0] + min(0, xy, xz, xy + xz), high[0] + max(0, xy, xz, xy + xz), xy],
                      [low[1] + min(0, yz), high[1] + max(0, yz), xz], [low[2], high[2], yz]])  # fmt: skip
    tilted = " xy xz yz" if xy or xz or yz else ""
    # In two dimensions, LAMMPS asks for a box that is periodic along z, too.
    flags = " ".join("pp" if flag else "ff" for flag in (*system.periodic[: system.dimensions], True)[:3])
    file.write(f"ITEM: TIMESTEP\n{system.step}\nITEM: NUMBER OF ATOMS\n{len(system)}\nITEM: BOX BOUNDS{tilted} {flags}\n")
    write_rows(file, " ", sides if tilted else sides[:, :2])
    numbers, has_names = numbered_types(system)
    labels = [coded(checked_names(system, PRINTED, ONE_WORD))] if has_names else []
    file.write(f"ITEM: ATOMS {' '.join(['id', 'type', *_POSITIONS[0], *_SHAPE, *_QUATERNION, *has_names * [_LABEL]])}\n")
    write_rows(file, " ", system.ids, numbers, system.centers, 2 * system.semi_axes, system.quaternions, *labels)
