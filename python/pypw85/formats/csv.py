# SPDX-License-Identifier: BSD-3-Clause
"""Tables with a comma between columns and their names in the first line; read with semicolons, tabulators and decimal commas, too.

Columns that are written: x y z; the semi-axes a b c, or radius; the quaternion qw qx qy qz; id and type. Comments before the names may
state ``# cell`` (the nine components of the cell vectors), ``# origin`` (three numbers), ``# periodic`` (three letters T or F), ``# step``
(the time step) and ``# dimensions`` (2 for ellipses). A table of ellipses may have the columns x y, a b and an angle instead, and four
components of a cell. The name of a type is quoted if it contains a comma or a quotation mark.
"""

from __future__ import annotations

import os
import re
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from . import _comments
from ._column_names import UNIT_AT_END, plain_name
from ._column_values import fill
from ._columns import centers_of, convention_of, meaning_of, offsets_of, take
from ._conventions import Convention, possible
from ._csv_header import (
    NUMBER,
    NUMBERED,
    OF_ECSV,
    box_of,
    check_cell,
    has_numbers,
    names_of_columns,
    positions_in,
    read_keys,
    recognise as recognise,
    rows_of,
    split,
    with_names_of_rows,
    without_empty_end,
)
from ._dimensions import said_dimensions
from ._errors import for_option
from ._frames import Frame, Location
from ._names import PRINTED, Rule, checked_names
from ._options import Options
from ._series import check_repeated, check_series, columns_of_series
from ._table import Lines, Table, coded, write_rows
from ._taken import Taken

SUFFIXES = (".csv",)
_POSITION, _SHAPE, _QUATERNION = ["x", "y", "z"], ["a", "b", "c"], ["qw", "qx", "qy", "qz"]
# A comment that is a row of units
_UNIT_WORD = re.compile(r"[(\[]?(mm|[uµμnk]?m|cm|Å|microns?|px|pix|pixels?|voxels?|deg(rees?)?|rad(ians?)?|[-1])[)\]]?")
# Words in the last row of a table that is not a body
_SUMMARY = re.compile(r"(arithmetic )?mean|average|avg|median|sd|std\.?( ?dev\w*\.?)?|standard deviation|min(imum)?|max(imum)?|"
                      r"(grand )?total|sum(mary)?|count|var(iance)?|(25|50|75) ?%", re.IGNORECASE)  # fmt: skip
# A unit of a column in a row of its own
_UNIT_ALONE = re.compile(r"[(\[]?[^\W\d][^\d]{0,11}[)\]]?")
_THIRD = ("z", "zc", "depth", "elevation", "posz", "positionz", "centerz", "centrez", "centroidz", "cz", "pz", "upward", "altitude",
          "zslice", "zindex", "zstack", "zplane", "zpos", "zposition", "centroid2", "centroid3")
# Units in brackets behind the name of a column, and those that have several names
_UNIT = re.compile(r"[(\[]\s*((?:[^\W\d]|\ufffd)[^)\]]*)[)\]]\s*$")
# In texts in Latin-1, µ is a character that is not read (�).
_SAME_UNITS = dict.fromkeys(("µm", "μm", "\ufffdm", "micron", "microns"), "um")
_SAME_UNITS |= dict.fromkeys(("pix", "pixel", "pixels", "voxel", "voxels"), "px")
_SAME_UNITS |= dict.fromkeys(("meter", "meters", "metre", "metres"), "m") | dict.fromkeys(("angstrom", "angstroms"), "å")
# Names that mean the middle of a body, where others may mean the corner of a box around it
_OF_CENTERS = re.compile(r"(cent|barycent|pos|loc).*|[xyz](c|pos|cent).*|c[xyz]")
# What an empty row of a spreadsheet has
_EMPTY = ' \t\r,;|"'
# The sides of boxes, as `plain_name` makes their names
_SIDES = (["width", "height"], ["w", "h"])
_IDS = ("id", "ids", "particleid", "featureid", "index", "number")
_TYPES = ("type", "types", "species", "phase", "phases", "particletype", "bodytype", "objecttype", "graintype", "body", "object", "class")

# Names of columns of ids and types that need not be said
_USUAL = ("id", "ids", "particleid", "type", "types", "species")


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        keys, line, comments = read_keys(lines, options)
        separator, positions, columns = names_of_columns(lines, line, options)
        columns = with_names_of_rows(lines, separator, without_empty_end(lines, separator, columns))
        convention = convention_of(columns, options, lines.error)
        positions = _positions_of(convention, columns, separator, len(positions), options, lines)
        dimensions = keys.get("dimensions")
        _check_third(columns, positions, options, lines, convention)
        ids, types, notes = _ids_and_types(lines, separator, columns, options)
        offsets = offsets_of(convention, columns)
        taken = take(columns, options, lines.error, "radii", "wxyz", [*positions, *offsets, ids, types],
                     (dimensions or len(positions)) == 2, convention)  # fmt: skip
        count, behind = _count(keys, lines, separator)
        for comment in behind if "cell" not in keys else ():
            check_cell(comment, 0, options, lines)
        comments += behind
        has_units = bool({*map(_plain_unit, map(_unit, (*positions, *taken.shape)))} - {"", "px"})
        _comments.check(comments, meaning_of(taken, options, convention is not None, has_units), lines.error)
        _check_lengths(columns, positions, taken, (options.dimensions or dimensions) is not None, lines)
        _check_units(comments, columns, positions, taken, lines)
        cell, origin, periodic = box_of(keys, lines)
        _check_units_row(lines, separator, [columns.index(name) for name in positions])
        series = columns_of_series(columns, len(positions), options, convention)
        wanted = [name for name in (*positions, *offsets, *taken.checked, ids, types, *series) if name]
        table = lines.table(count, columns, [types, *series], separator, wanted, decimal_comma=separator != ",")
        check_series(table, series, convention, lines)
        _check_mistake(table, [*positions, *taken.shape], lines)
        numbers = table.integers(ids) if ids else None
        check_repeated(numbers, ids, table.line, lines)
    frame = Frame(
        path, location, table.stack(positions) + table.stack(offsets) if offsets else table.stack(positions),
        types=table[types] if types else None, ids=numbers,
        cell=cell, origin=origin, periodic=periodic, step=keys.get("step", 0),
        lines=range(table.line, table.line + table.count), dimensions=dimensions,
    )  # fmt: skip
    fill(frame, taken, table)
    frame.notes += notes
    said = [f"{what} {name}" for what, name in (("ids", ids), ("types", types)) if name and plain_name(name) not in _USUAL]
    frame.source = ", ".join(filter(None, [*said, frame.source]))
    frame.refuse_other_bodies(options)
    return frame.system(options)


def _positions_of(convention: Convention | None, columns: list[str], separator: str | None, count: int, options: Options,
                  lines: Lines) -> list[str]:  # fmt: skip
    """The columns of positions: those of a convention, or those that are known by their names. Skips what a program writes beneath."""
    if convention is not None:
        positions = list(centers_of(convention, columns))
        _skip_heads(lines, separator, columns, positions, convention)
    else:
        positions = _one_position(columns, count, options, lines) if count else []
    _check_positions(columns, positions, lines)
    return positions


def _count(keys: dict[str, Any], lines: Lines, separator: str | None) -> tuple[int, list[str]]:
    """The number of rows, and comments behind them. Behind those that DREAM.3D says there are, lists of neighbours may follow."""
    remaining, comments = _remaining(lines, separator)
    count = min(remaining, keys.get("rows", remaining))
    if not count:
        raise lines.error("there are no particles: no row follows the names of the columns; write the file again")
    return count, comments


def _check_positions(columns: list[str], positions: list[str], lines: Lines) -> None:
    """Refuses tables in which no columns are known to be positions."""
    if positions:
        return
    if others := possible({plain_name(name) for name in columns}):
        raise lines.error(f"the columns may be those of {' or '.join(others)}, whose versions differ: if they are, say so "
                          f"(--convention {others[0]})")  # fmt: skip
    if all(map(NUMBER.fullmatch, columns)):
        raise lines.error(f"the first line must name the columns (x,y,z,a,b,c,qw,qx,qy,qz), not be {' '.join(columns)}: add such a line")
    raise lines.error(f"there is no column 'x', but {' '.join(columns)}: rename those of positions to x, y and z, or begin lines before "
                      "the names with #")  # fmt: skip


def _one_position(columns: list[str], count: int, options: Options, lines: Lines) -> list[str]:
    """The columns of positions that an option does not leave out. Refuses several: one may be a corner of a box around a body."""
    kept = [name for name in columns if name not in (options.ignore_columns or ())]
    found = positions_in(kept, count) or positions_in(kept, 2)
    others = [names for names in found if all(_OF_CENTERS.fullmatch(plain_name(name)) for name in names)]
    if len(found) > 1 and others and found[0] != others[-1]:
        raise lines.error(f"the columns {' '.join(found[0])} and {' '.join(others[-1])} may both be the position: leave one of both out "
                          f"(--ignore-columns {for_option(found[0])})")  # fmt: skip
    return found[0] if found else []


def _skip_heads(lines: Lines, separator: str | None, columns: list[str], positions: list[str], convention: Convention) -> None:
    """Skips lines of other names and of units beneath the names, which a program writes."""
    places = [columns.index(name) for name in positions]
    for _ in range(convention.heads):
        place = lines.location(lines.frame)
        words = split(lines.next("\r\n") or "", separator)
        if not _are_words(words, places):
            lines.back(place)
            return


def _are_words(words: list[str], places: list[int]) -> bool:
    """Returns whether a row has names or units, not numbers, in these columns."""
    return max(places) < len(words) and all(_UNIT_ALONE.fullmatch(words[k]) and words[k].lower() not in ("nan", "inf") for k in places)


def _starts_with_number(lines: Lines, separator: str | None, column: int) -> bool:
    """Returns whether the first row has a number in this column, or is too short for a row."""
    words = split(lines.first_row(), separator)
    return column >= len(words) or NUMBER.fullmatch(words[column].replace(",", ".")) is not None


def _check_units_row(lines: Lines, separator: str | None, places: list[int]) -> None:
    """Refuses a row of units beneath the names."""
    place = lines.location(lines.frame)
    words = split(lines.next("\r\n") or "", separator)
    if _are_words(words, places):
        raise lines.error(f"the row beneath the names has words, not numbers, such as {words[places[0]]}: remove it, and if these are "
                          "units, write them into the names, as x (mm)")  # fmt: skip
    lines.back(place)


def _ids_and_types(lines: Lines, separator: str | None, columns: list[str], options: Options) -> tuple[str, str, list[str]]:
    """The columns of ids and of types, each empty if there is none, and a note if ids are words."""
    plain = {plain_name(name): name for name in reversed(columns) if name not in (options.ignore_columns or ())}
    ids, types = (next((plain[name] for name in names if name in plain), "") for names in (_IDS, _TYPES))
    if not ids or _starts_with_number(lines, separator, columns.index(ids)):
        return ids, types, []
    return "", types, [f"the column {ids} has words, not numbers: the particles are numbered from 1 in their order"]


def _check_third(columns: list[str], positions: list[str], options: Options, lines: Lines, convention: Convention | None) -> None:
    """Refuses tables of two coordinates that have a third by another name than that of their convention."""
    if len(positions) == 2 and options.dimensions is None:
        for name in columns:
            if convention is not None and plain_name(name) == convention.third:
                continue
            if plain_name(name) in _THIRD and name not in positions and name not in (options.ignore_columns or ()):
                raise lines.error(f"there are two coordinates, {' '.join(positions)}, and {name}: rename it to z, or leave it out "
                                  f"(--ignore-columns {for_option([name])})")  # fmt: skip


def _check_lengths(columns: list[str], positions: list[str], taken: Taken, says_dimensions: bool, lines: Lines) -> None:
    """Refuses a coordinate that is there twice, as in pixels and in a length; three lengths beside two coordinates; and what may be the
    corner and the sides of a box."""
    for name in positions:
        same = [one for one in columns if plain_name(one) == plain_name(name)]
        if len(set(same)) > 1:
            raise lines.error(f"the columns {' and '.join(same)} may both be the position: rename or remove all but one")
    if len(positions) == 2 and len(taken.shape) == 3 and not says_dimensions:
        raise lines.error(f"there are two coordinates, {' '.join(positions)}, and three lengths, {' '.join(taken.shape)}: write the "
                          "third coordinate, or say that these are ellipses in a plane (--dimensions 2)")  # fmt: skip
    if [*map(plain_name, positions)] == ["x", "y"] and [*map(plain_name, taken.shape)] in _SIDES and not taken.turn.kind:
        raise lines.error(f"{' '.join(positions)} beside {' '.join(taken.shape)} may be the corner of a box, as ImageJ lists regions, and "
                          "not the centre: write the centres to columns center_x and center_y")  # fmt: skip


def _check_units(comments: list[str], columns: list[str], positions: list[str], taken: Taken, lines: Lines) -> None:
    """Refuses several units of length, which names, a row of units or comments say."""
    units_row = _units_row(comments, columns)
    said = [(name, unit) for name in (*positions, *taken.shape, *taken.sphere) if (unit := _unit(name) or units_row.get(name))]
    for name, unit in zip(taken.turn.columns, taken.turn.units):
        if (row := units_row.get(name, "-")).isalpha() and row[:3] != unit[:3]:
            raise lines.error(f"the angle {name} is taken in {unit}, and a comment says {row}: correct one of both")
    units = {_plain_unit(unit): name for name, unit in said}
    if len(units) > 1:
        raise lines.error(f"the columns {' and '.join(units.values())} have different units: convert them to one, and rename them")
    others = _comments.units_of(one for one in comments if not OF_ECSV.search(one) and not NUMBERED.match(one))
    if len(stated := {*units, *map(_plain_unit, others)}) > 1:
        raise lines.error(f"comments state several units of length, {' and '.join(sorted(stated))}: convert the numbers to one, and remove "
                          "the others")  # fmt: skip
    silent = [name for name in (*positions, *taken.shape, *taken.sphere) if name not in dict(said)]
    if said and silent:
        taken.notes.append(f"{' '.join(silent)} without a unit are taken in that of {said[0][0]}")


def _check_mistake(table: Table, names: list[str], lines: Lines) -> None:
    """Refuses what MorphoLibJ 1.6.3 writes by mistake: y as z, and the second radius as the third (corrected in its commit d31b5d89)."""
    if [*map(plain_name, names[2:4])] == ["ellicenterz", "elliradius1"]:
        _, y, z, _, second, third = table.stack(names).T
        if (y == z).all() and (second == third).all():
            raise lines.error("all bodies have equal y and z, and equal second and third radii, as MorphoLibJ 1.6.3 writes by mistake for "
                              "any bodies: measure with another version, or rename the columns if these numbers are right")  # fmt: skip


def _units_row(comments: list[str], columns: list[str]) -> dict[str, str]:
    """The units of columns that a comment says."""
    rows = [[*zip(columns, words)] for comment in comments for words in rows_of(comment.lstrip("#% ")) if len(words) == len(columns)]
    found = [{name: word.strip("()[]") for name, word in row if _UNIT_WORD.fullmatch(word)} for row in rows]
    return next((one for one in found if 2 * len(one) > len(columns)), {})


def _plain_unit(unit: str) -> str:
    """One spelling of units that have several."""
    return _SAME_UNITS.get(unit.lower(), unit if unit[:1] == "M" else unit.lower())


def _unit(name: str) -> str:
    """The unit of length that a name says, or an empty string."""
    found = _UNIT.search(name) or UNIT_AT_END.search(name)
    return next(filter(None, found.groups())).strip() if found else ""


def _remaining(lines: Lines, separator: str | None) -> tuple[int, list[str]]:
    """The number of lines up to the last one that is neither empty nor a comment, which must be a body, and the comments behind it."""
    place = lines.location(lines.frame)
    count = last = 0
    end, comments = b"", list[str]()
    while (block := lines.read_block(2**62))[1]:
        text, behind = _without_comments(block[0].rstrip())
        if text:
            last, end, comments = count + text.count(b"\n") + 1, text.rpartition(b"\n")[2], behind
        else:
            comments += behind
        count += block[1]
    lines.back(place)
    for word in split(end.decode("utf-8", errors="replace"), separator):
        if _SUMMARY.fullmatch(word):
            lines.number += last
            raise lines.error(f"the row with the word '{word}' is a summary of others, and not a body: remove such rows")
    return last, comments


def _without_comments(text: bytes) -> tuple[bytes, list[str]]:
    """Lines without empty ones and comments at their end, and these comments. A row may begin so, too, as with a colour, #ff0000."""
    comments, end = list[str](), len(text)
    while end:
        begin = text.rfind(b"\n", 0, end) + 1
        line = text[begin:end].decode("utf-8", errors="replace").strip(_EMPTY)
        if line and (not line.startswith(("#", "%")) or has_numbers(line)):
            break
        comments += [line] if line else []
        end = max(begin - 1, 0)
    return text[:end], comments[::-1]


def _is_no_formula(name: str) -> bool:
    """Spreadsheets compute what begins so, unless it is a number."""
    return name[:1] not in tuple("=+-@") or NUMBER.fullmatch(name) is not None


_HARMLESS: Rule = (_is_no_formula, "is a formula to a spreadsheet, which opens files of this format")
_TRIMMED: Rule = (lambda name: name == name.strip() != "", "is empty, or begins or ends with a blank")


def save(file: IO[str], system: System, frame: int) -> None:
    if frame:
        raise ValueError("a CSV file holds one frame: choose one with --frames")
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
