# SPDX-License-Identifier: BSD-3-Clause
"""Extended XYZ with properties as OVITO, ASE and AniSOAP name them, and XYZ without shapes. What is written is as OVITO has it.

ASE reads such files too, but says neither in which line nor in which column one is wrong.
"""

from __future__ import annotations

import dataclasses
import os
import re
import shlex
from typing import IO
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._words import counted
from . import _comments
from ._boxes import SAYS_CELL
from ._column_names import could_change
from ._column_values import fill
from ._columns import meaning_of, take
from ._errors import for_option
from ._dimensions import said_dimensions
from ._frames import Frame, Location
from ._options import Options
from ._names import ONE_WORD, PRINTED, checked_names, type_names
from ._series import check_clumps, columns_of_clumps
from ._table import Lines, Table, coded, locate_frames, write_rows
from ._taken import Taken

SUFFIXES = (".xyz", ".extxyz")
_NUMBER = re.compile(rb"[-+]?[0-9]*\.?[0-9]*(?:[eE][-+]?[0-9]+)?")
# shlex takes some microseconds for each character.
_LONGEST_COMMENT = 1 << 15
# Columns of a frame without particles, which no line bounds
_MOST_COLUMNS = 1 << 16
# Names of properties without capitals and underscores, and how many columns each has.
_TYPES = ("species", "type")
_KEYS = ("Properties", "Lattice", "Origin", "pbc", "Dimensions", "Timestep")
# Names of keys of others for what the keys above hold
_OF_CELLS = re.compile(r"(?!.*(?:energy|volume)$)(?:lattice|origin|pbc|dimensions|((unit|simulation|virtual)?_?(cell|box))\w*|"
                       r"boundar(y|ies)|periodic\w*|virtual_lattice)", re.IGNORECASE)  # fmt: skip
_OF_DIMENSIONS = re.compile(r"dimension|n?dims?", re.IGNORECASE)
_HAS_KEYS = re.compile(r"\b(?:properties|lattice|pbc|cell|box)=", re.IGNORECASE)
_COMMENT_ON_CELL = re.compile(rf"[#%]?\s*{SAYS_CELL}", re.IGNORECASE)
# Numbers alone in the second line, as many as a cell has
_CELL_ALONE = re.compile(r"(?:[-+]?[0-9]*\.?[0-9]+(?:[eE][-+]?[0-9]+)?[\s,]*){3,9}")
# A number that is neither the number of a type nor that of a chemical element
_FRACTION = re.compile(r"[-+]?(?:[0-9]+\.[0-9]*|\.[0-9]+|[0-9]+(?=[eE]))(?:[eE][-+]?[0-9]+)?|-[0-9]+")
# Keys of units, and units of length
_SAYS_UNIT = re.compile(r"(\w+_)?units?", re.IGNORECASE)
_LENGTH = re.compile(r"[pnuµμmck]?m|Å|angstroms?|microns?|(pico|nano|micro|milli|centi)?met(er|re)s?|bohr|pix|pixels?|voxels?", re.I)
_PROPERTIES = {"pos": 3, "asphericalshape": 3, "orientation": 4, "radius": 1, "species": 1, "type": 1, "id": 1}


# As ASE has them; it begins each name with a capital.
_ELEMENTS = frozenset(
    "X H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se Br Kr Rb Sr Y Zr Nb Mo Tc Ru Rh Pd "
    "Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi Po At Rn Fr Ra Ac Th "
    "Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts Og".split()
)


def recognise(start: bytes) -> bool:
    """A number, a comment, and either Properties in that, or particles: a name and a position."""
    lines = start.lstrip().split(b"\n", 3)
    if len(lines) < 2 or not re.fullmatch(rb"[0-9]+\s*", lines[0]):
        return False
    first = lines[2].split() if len(lines) > 2 else []
    return b"Properties=" in lines[1] or (len(first) > 3 and all(map(_NUMBER.fullmatch, first[1:4])))


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
    if not line.isdecimal():
        raise lines.error(f"the number of particles must be here, not '{line[:40]}': more lines than particles, or no XYZ file")
    return lines.whole(line, "the number of particles")


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        count = _count(lines)
        if count is None:
            raise lines.error("the file has become shorter")
        keys = _keys(lines, options)
        _check_keys(keys, options, lines)
        dimensions = _dimensions(keys, lines)
        columns, text = _columns(keys, lines, count)
        positions = [f"pos[{k}]" for k in (1, 2, 3) if f"pos[{min(k, 2)}]" not in columns or f"pos[{k}]" in columns]
        if positions[0] not in columns:
            raise lines.error("the property pos is missing in 'Properties='")
        ignored = [name for name in options.ignore_columns or () if name in keys and name not in columns]
        others = [name for name in options.ignore_columns or () if name not in ignored]
        options = dataclasses.replace(options, ignore_columns=others or None)
        taken = take(columns, options, lines.error, "radii", "xyzw", ["id", *positions, *_TYPES],
                     len(positions) == 2 or dimensions == 2)  # fmt: skip
        _check_others({name: value for name, value in keys.items() if name not in (*_KEYS, *ignored)}, taken, options, lines)
        cell = keys.get("Lattice")
        box = None if cell is None else np.reshape(lines.numbers(cell, 9, "Lattice"), (3, 3))
        origin = lines.numbers(keys.get("Origin", "0 0 0"), 3, "Origin")
        periodic = lines.flags(keys.get("pbc", "T T T"), "pbc")
        step = lines.whole(keys.get("Timestep", "0"), "Timestep", -(2**63))
        clumps = [name for name in columns_of_clumps(columns, options) if name not in text]
        wanted = ["id", *_TYPES, *positions, *taken.checked, *clumps]
        table = lines.table(count, columns, text, wanted=wanted)
        check_clumps(table, clumps, lines)
        _check_names(keys, table, lines)
    types = [name for name in _TYPES if name in columns]
    frame = Frame(
        path, location, table.stack(positions),
        types=table[types[0]] if types else None,
        ids=table.integers("id") if "id" in columns else None,
        cell=box, origin=origin, periodic=periodic, step=step, lines=range(table.line, table.line + count),
        dimensions=dimensions,
    )  # fmt: skip
    fill(frame, taken, table)
    if unused := " ".join(name for name in keys if name not in _KEYS):
        frame.source = ", ".join(filter(None, [frame.source, f"keys that are not used: {unused}"]))
    frame.refuse_other_bodies(options)
    return frame.system(options)


def _dimensions(keys: dict[str, str], lines: Lines) -> int | None:
    dimensions = lines.whole(keys["Dimensions"], "Dimensions") if "Dimensions" in keys else None
    if dimensions not in (None, 2, 3):
        raise lines.error(f"'Dimensions' must be 2 or 3, not {dimensions}")
    return dimensions


def _keys(lines: Lines, options: Options) -> dict[str, str]:
    """Keys and values of the second line. In a file without Properties that may be any text, but one that could say the cell is refused."""
    comment = lines.expect("the line with Properties")
    if not _HAS_KEYS.search(comment):
        if options.cell is None and (_COMMENT_ON_CELL.match(comment) or _is_cell_alone(comment)):
            raise lines.error(f"the comment '{comment[:60]}' could say the cell, and is not read: extended XYZ has Lattice, Origin and pbc "
                              "for it; write these, or give the cell (--cell)")  # fmt: skip
        return {}
    if len(comment) > _LONGEST_COMMENT:
        raise lines.error(f"the line has more than {_LONGEST_COMMENT} characters: it is broken")
    try:
        words = shlex.split(comment)
    except ValueError:
        raise lines.error("a quotation mark is not closed") from None
    pairs = [word.split("=", 1) for word in words if "=" in word]
    keys = dict(pairs)
    if len(keys) < len(pairs):
        again = next(name for k, (name, _) in enumerate(pairs) if name in dict(pairs[:k]))
        raise lines.error(f"the key {again[:40]} is there twice: remove one")
    return keys


def _is_cell_alone(comment: str) -> bool:
    return _CELL_ALONE.fullmatch(comment) is not None and len(comment.replace(",", " ").split()) in (3, 6, 9)


def _check_names(keys: dict[str, str], table: Table, lines: Lines) -> None:
    """Refuses rows of numbers alone, whose first is a coordinate: without Properties, a name or the number of a type comes first."""
    names = [] if "Properties" in keys else table["species"].tolist()
    for name in dict.fromkeys(names):
        if _FRACTION.fullmatch(name):
            lines.number = table.line + names.index(name)
            raise lines.error(f"the first column must be a name or the number of a type, not {name}: if it is a coordinate, write a line "
                              "with Properties=pos:R:3 and so on above the rows")  # fmt: skip


def _check_keys(keys: dict[str, str], options: Options, lines: Lines) -> None:
    """Refuses keys that extended XYZ has by another name: for a cell, and for the properties."""
    for name, value in keys.items():
        if _OF_DIMENSIONS.fullmatch(name) and value != "3" and options.dimensions is None:
            raise lines.error(f"the key {name} could be the number of dimensions, and is not used: write Dimensions=2 or 3, or say it "
                              "(--dimensions)")  # fmt: skip
        if name != "Properties" and name.lower() == "properties":
            raise lines.error(f"the key {name} is spelled Properties in extended XYZ, and is not read: rename it")
        if name not in _KEYS and _OF_CELLS.fullmatch(name) and options.cell is None:
            raise lines.error(f"the key {name[:40]} could be the cell, and is not used: extended XYZ has Lattice, Origin and pbc for it; "
                              "rename it, or give the cell (--cell)")  # fmt: skip


def _check_others(keys: dict[str, str], taken: Taken, options: Options, lines: Lines) -> None:
    """Refuses keys that are not used, and whose names or values could change bodies."""
    units = {value.lower(): name for name, value in keys.items() if _SAYS_UNIT.fullmatch(name) and _LENGTH.fullmatch(value)}
    if len(units) > 1:
        raise lines.error(f"the keys {' and '.join(units.values())} state different units of length: convert all lengths to one, and "
                          "remove these keys")  # fmt: skip
    for name in keys:
        if could_change(name) and not _SAYS_UNIT.fullmatch(name):  # which all lengths have
            raise lines.error(f"the key {name[:40]} could change the shapes or how they are turned, and is not used: write what it says as "
                              f"properties, or leave it out (--ignore-columns {for_option([name])})")  # fmt: skip
    _comments.check((f"{name}={value}" for name, value in keys.items()), meaning_of(taken, options), lines.error)


def _columns(keys: dict[str, str], lines: Lines, count: int) -> tuple[list[str], list[str]]:
    """Names of the columns, numbered within each property of several, and of those that hold text."""
    there = lines.columns_ahead() if count else 0
    if "Properties" not in keys:
        columns = ["species", "pos[1]", "pos[2]", "pos[3]"]
        return columns + [f"column{k}" for k in range(len(columns), there)], ["species"]
    words = keys["Properties"].split(":")
    properties = list(zip(words[::3], words[1::3], words[2::3]))
    if len(words) % 3 or not all(kind in "SIRL" and re.fullmatch("[0-9]{1,18}", number) for _, kind, number in properties):
        raise lines.error(f"'Properties=' must have names, kinds and numbers of columns, not '{keys['Properties'][:80]}'")
    # Before names are made of a number that may be anything
    total = sum(int(number) for *_, number in properties)
    if count and total != there:
        lines.expect("a particle")
        raise lines.error(f"{counted(there, 'column')} instead of the {total} of 'Properties=': the line is broken, or the file truncated")
    return _named_columns(properties, lines, keys.get("Dimensions") == "2") if total <= _MOST_COLUMNS else ([], [])


def _named_columns(properties: list[tuple[str, str, str]], lines: Lines, are_ellipses: bool) -> tuple[list[str], list[str]]:
    columns, text = [], []
    for name, kind, number in properties:
        plain = name.replace("_", "").lower()
        has_two = are_ellipses and plain in ("pos", "asphericalshape") and int(number) == 2
        if plain in _PROPERTIES and int(number) != _PROPERTIES[plain] and not has_two:
            raise lines.error(f"the property {name} has {counted(int(number), 'column')} instead of {_PROPERTIES[plain]}")
        known = plain if plain in ("pos", "id", *_TYPES) else name
        names = [known] if int(number) == 1 else [f"{known}[{k}]" for k in range(1, int(number) + 1)]
        columns += names
        text += names if kind in "SL" or plain in _TYPES else []
    return columns, text


def losses(system: System) -> Iterator[tuple[str, str]]:
    others = [name for name in np.unique(type_names(system)).tolist() if name.capitalize() not in _ELEMENTS]
    if others:
        named = ", ".join(others[:5]) + (f" and {counted(len(others) - 5, 'other')}" if len(others) > 5 else "")
        yield "species", (f"ASE (3.22 to 3.28) reads only files in which types are chemical elements or X, and not {named}: name elements "
                          f"in their place (pw85 convert --species {others[0]}:H,...)")  # fmt: skip


def save(file: IO[str], system: System, frame: int) -> None:
    names = checked_names(system, PRINTED, ONE_WORD)
    keys = [f"Timestep={system.step}"]
    if dimensions := said_dimensions(system):
        keys += [f"Dimensions={dimensions}"]
    if system.cell is not None:
        flags = " ".join("FT"[flag] for flag in system.periodic)
        keys += [f'Lattice="{_numbers(system.cell)}"', f'Origin="{_numbers(system.origin)}"', f'pbc="{flags}"']
    keys += ["Properties=id:I:1:species:S:1:pos:R:3:aspherical_shape:R:3:orientation:R:4"]
    file.write(f"{len(system)}\n{' '.join(keys)}\n")
    write_rows(file, " ", system.ids, coded(names), system.centers, system.semi_axes, system.quaternions[:, [1, 2, 3, 0]])


def _numbers(values: np.ndarray) -> str:  # type: ignore[type-arg]
    return " ".join(f"{value:.17g}" for value in np.ravel(values))
