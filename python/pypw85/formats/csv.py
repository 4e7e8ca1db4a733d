# SPDX-License-Identifier: BSD-3-Clause
"""Tables with a comma between columns and their names in the first line; read with semicolons, tabulators and decimal commas, too.

Columns that are written: x y z; the semi-axes a b c, or radius; the quaternion qw qx qy qz; id and type. Comments before the names may
state ``# cell`` (the nine components of the cell vectors), ``# origin`` (three numbers), ``# periodic`` (three letters T or F), ``# step``
(the time step) and ``# dimensions`` (2 for ellipses). A table of ellipses may have the columns x y, a b and an angle instead, and four
components of a cell. The name of a type is quoted if it contains a comma or a quotation mark.
"""

from __future__ import annotations

import contextlib
import csv
import itertools
import os
import re
from typing import IO, Any
from collections.abc import Iterator

import numpy as np

from .._system import System
from .._typing import Floats
from . import _comments
from ._boxes import SAYS_CELL
from ._column_names import UNIT_AT_END, plain_name
from ._column_values import fill
from ._columns import Taken, centers_of, convention_of, meaning_of, offsets_of, take
from ._conventions import CONVENTIONS, Convention, named, possible, recognised
from ._errors import FileError, for_option
from ._frames import Frame, Location, Options, said_dimensions
from ._names import PRINTED, Rule, checked_names
from ._series import check_repeated, check_series, columns_of_series
from ._table import Lines, Table, coded, write_rows

SUFFIXES = (".csv",)
_NUMBER = re.compile(r"[-+]?[0-9.]+(?:[deDE][-+]?[0-9]+)?")
_POSITION, _SHAPE, _QUATERNION = ["x", "y", "z"], ["a", "b", "c"], ["qw", "qx", "qy", "qz"]
# Keys, and what follows them; with other words a comment is a sentence, as "# origin at the lower left"
_KEYS = {"cell": r"[-+.\d]|nan\b|inf", "dimensions": r"[-+.\d]", "origin": r"[-+.\d]|nan\b|inf", "periodic": r"(T|F|true|false|[01])\b|$",
         "step": r"[-+.\d]+([eE][-+]?\d+)?\s*$"}  # fmt: skip
# The values that must follow keys, and what helps if they do not
_VALUES = {
    "cell": "nine numbers, the three vectors of the cell one after the other (four numbers in a plane)",
    "dimensions": "2 or 3, the number of dimensions",
    "origin": "three numbers, the corner of the cell (two in a plane)",
    "periodic": "three letters T or F, one for each vector of the cell (two in a plane)",
    "step": "a whole number, the time step",
}
_OTHER_MEANING = "correct it, or reword the comment if it says something else"
# Comments that say the cell in another way, or that there is one
_LIKE_KEYS = re.compile(rf"[#%](?:.*[\s,;('\"{{])?{SAYS_CELL}|"
                        r"[#%].*?(?<!non)(?<!non-)(?<!not )(?<!no )(?<!a)(periodic|\bpbc)\b(?!\W*(no|none|false|f|0|table)\b)",
                        re.IGNORECASE)  # fmt: skip
# The search for a cell takes the square of the length in time, so it ends after so many characters.
_SENTENCE = 1000
_NO_CELL = re.compile(r"\b(periodic\w*|pbc|((simulation|periodic) )?(box|cell)|boundar\w*)\W*(no|none|false|F F F|open|free)\b|"
                      r"\bboundar\w*\W*(reflect\w*|hard|rigid|walls?|fixed|closed)\b|"
                      r"\b(periodic\w*|pbc)( boundar\w*)?( conditions?)?( (is|are|was|were))? (off|disabled|not (used|applied|present))\b|"
                      r"\bwithout (periodic\w*|pbc)( boundar\w*)?",
                      re.IGNORECASE)  # fmt: skip
# Names and units of columns in the header of ECSV (Astropy), on one line or on several
_OF_ECSV = re.compile(r"\b(name|unit): ['\"]?([\w.]+)")
# A comment that is a row of units
_UNIT_WORD = re.compile(r"[(\[]?(mm|[uµμnk]?m|cm|Å|microns?|px|pix|pixels?|voxels?|deg(rees?)?|rad(ians?)?|[-1])[)\]]?")
# Brackets of a unit that a blank separates from the name before it
_UNIT_BEHIND = re.compile(r"(?<=\w)\s+([(\[][^\d)\]][^)\]]*[)\]])(?!\S)")
# A word, which may have blanks in quotation marks
_WORD = re.compile(r'"[^"]*"(?!\S)|\S+')
# The line that YADE writes before spheres (export.textExt)
_FORMAT_OF_YADE = re.compile(r"^#\s*format\s+(x_y_z_r\w*)$")
# A word in quotation marks, and a number behind it
_NAME_OF_ROW = re.compile(r"\s*\"[^\"]*\"[\s,;]+[-+.\d]")
# What stands before names in a comment; the last word is that of files of EDAX (.ang)
_COMMENT_OF_NAMES = re.compile(r"^[#%]*(?:\s*COLUMN_HEADERS:)?")
# Words in the last row of a table that is not a body
_SUMMARY = re.compile(r"(arithmetic )?mean|average|avg|median|sd|std\.?( ?dev\w*\.?)?|standard deviation|min(imum)?|max(imum)?|"
                      r"(grand )?total|sum(mary)?|count|var(iance)?|(25|50|75) ?%", re.IGNORECASE)  # fmt: skip
# A unit of a column in a row of its own
_UNIT_ALONE = re.compile(r"[(\[]?[^\W\d][^\d]{0,11}[)\]]?")
_NUMBERED = re.compile(r"#\s*(?:(\d{1,4})\s+([A-Za-z]\w*)|Column\s+(\d{1,4}):\s+([A-Za-z]\w*)\s+\[)")
_THIRD = ("z", "zc", "depth", "elevation", "posz", "positionz", "centerz", "centrez", "centroidz", "cz", "pz", "upward", "altitude",
          "zslice", "zindex", "zstack", "zplane", "zpos", "zposition", "centroid2", "centroid3")
# Units in brackets behind the name of a column, and those that have several names
_UNIT = re.compile(r"[(\[]\s*((?:[^\W\d]|\ufffd)[^)\]]*)[)\]]\s*$")
# In texts in Latin-1, µ is a character that is not read (�).
_SAME_UNITS = dict.fromkeys(("µm", "μm", "\ufffdm", "micron", "microns"), "um")
_SAME_UNITS |= dict.fromkeys(("pix", "pixel", "pixels", "voxel", "voxels"), "px")
_SAME_UNITS |= dict.fromkeys(("meter", "meters", "metre", "metres"), "m") | dict.fromkeys(("angstrom", "angstroms"), "å")
_SEPARATORS = (",", ";", "\t", "|", None)
# Names as `plain_name` makes them: first what is written, then those of spreadsheets, ParaView and DREAM.3D
_POSITIONS = [
    tuple(stem + end for end in ends)
    for stem, ends in [("", "xyz"), ("pos", "xyz"), ("position", "xyz"), ("center", "xyz"), ("centre", "xyz"), ("centroid", "xyz"),
                       ("c", "xyz"), ("", ("xc", "yc", "zc")), ("loc", "xyz"), ("location", "xyz"), ("coord", "xyz"), ("p", "xyz"),
                       ("centerofmass", "xyz"), ("barycenter", "xyz"), ("translation", "xyz"),
                       ("points", "012"), ("centroids", "012"), ("coordinates", "012"), ("position", "012"),
                       *((one, ("[0]", "[1]", "[2]")) for one in ("pos", "position", "center", "centre", "porecoords")),
                       *((one, "xyz") for one in ("mean", "poseposition", "poseposeposition", "fieldposeposition")),
                       *((stem, tuple(axis + one for axis in "xyz")) for stem, one in (
                           ("", "0"), ("", "pos"), ("", "position"), ("", "cent"), ("", "center"), ("", "centroid"), ("", "coord"),
                           ("", "coordinate"), ("particle", "coordinate")))]
]  # fmt: skip
# Names that mean the middle of a body, where others may mean the corner of a box around it
_OF_CENTERS = re.compile(r"(cent|barycent|pos|loc).*|[xyz](c|pos|cent).*|c[xyz]")
# The sides of boxes, as `plain_name` makes their names
_SIDES = (["width", "height"], ["w", "h"])
_IDS = ("id", "ids", "particleid", "featureid", "index", "number")
_TYPES = ("type", "types", "species", "phase", "phases", "particletype", "bodytype", "objecttype", "graintype", "body", "object", "class")

# Names of columns of ids and types that need not be said
_USUAL = ("id", "ids", "particleid", "type", "types", "species")


def recognise(start: bytes) -> bool:
    lines = start.decode("utf-8", errors="replace").splitlines()
    comments = list(itertools.takewhile(_may_precede, lines))
    first = next(iter(lines[len(comments) :]), "")
    is_named = any(possible({plain_name(name) for name in words}) for words in _rows_of(first))
    is_named = is_named or (_has_numbers(first) and _names_in(comments, first) is not None)
    return _are_names(first) or _is_row(first) or is_named or (not first and any(map(_are_names, comments)))


def _may_precede(line: str) -> bool:
    """Lines before the names of columns: comments, the number of rows that DREAM.3D writes, and the separator for spreadsheets."""
    text = line.strip()
    return not text or text.startswith(("#", "%")) or text.isdecimal() or re.fullmatch("sep=.?", text) is not None


def _are_names(line: str) -> bool:
    return bool(_header(line)[1])


def _is_row(line: str) -> bool:
    """Returns whether the line has numbers enough for a centre and a length."""
    return any(len(words) > 3 and all(_NUMBER.fullmatch(word) for word in words[:4]) for words in _rows_of(line))


def _rows_of(line: str) -> Iterator[list[str]]:
    return (_split(line, one) for one in _SEPARATORS)


def _header(line: str) -> tuple[str | None, list[str], list[str]]:
    """The separator, the names of the columns that hold a position (none if there are none), and those of all columns.

    The names may be a comment, as NumPy writes them.
    """
    line = _FORMAT_OF_YADE.sub(lambda found: found[1].replace("_", " "), line)
    line = _COMMENT_OF_NAMES.sub("", line)
    found = [(one, _split(line, one)) for one in _SEPARATORS]
    # Blanks do not separate columns where another character separates three, which a table has at least.
    found = [(one, words) for one, words in found if one is not None or all(len(others) < 3 for _, others in found[:-1])]
    for count in (3, 2):
        for separator, columns in found:
            if positions := _positions_in(columns, count):
                return separator, positions[0], columns
    for separator, columns in found:
        if (convention := recognised(columns, {plain_name(name) for name in columns})) is not None:
            return separator, list(centers_of(convention, columns)), columns
    separator, columns = max(found, key=lambda pair: len(pair[1]))
    return separator, [], columns


def _positions_in(columns: list[str], count: int) -> list[list[str]]:
    """All sets of columns that may hold positions with so many coordinates, two in tables of ellipses."""
    plain = {plain_name(name): name for name in reversed(columns)}
    return [[plain[name] for name in names[:count]] for names in _POSITIONS if set(names[:count]) <= plain.keys()]


def _split(line: str, separator: str | None) -> list[str]:
    words = line.split(separator) if separator is not None else _WORD.findall(_UNIT_BEHIND.sub(r"\1", line))
    if separator is not None and '"' in line:
        with contextlib.suppress(csv.Error, StopIteration):
            words = next(csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True))
    return [word.strip().strip('"').strip() for word in words]


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    with Lines(path, location) as lines:
        keys, line, comments = _keys(lines, options)
        separator, positions, columns = _names(lines, line, options)
        columns = _with_names_of_rows(lines, separator, _without_empty_end(lines, separator, columns))
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
            _check_cell(comment, 0, options, lines)
        comments += behind
        has_units = bool({*map(_plain_unit, map(_unit, (*positions, *taken.shape)))} - {"", "px"})
        _comments.check(comments, meaning_of(taken, options, convention is not None, has_units), lines.error)
        _check_lengths(columns, positions, taken, (options.dimensions or dimensions) is not None, lines)
        _check_units(comments, columns, positions, taken, lines)
        cell, origin, periodic = _box(keys, lines)
        _check_units_row(lines, separator, [columns.index(name) for name in positions])
        series = columns_of_series(columns, len(positions), options, convention)
        wanted = [name for name in (*positions, *offsets, *taken.columns, ids, types, *series) if name]
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
    if all(map(_NUMBER.fullmatch, columns)):
        raise lines.error(f"the first line must name the columns (x,y,z,a,b,c,qw,qx,qy,qz), not be {' '.join(columns)}: add such a line")
    raise lines.error(f"there is no column 'x', but {' '.join(columns)}: rename those of positions to x, y and z, or begin lines before "
                      "the names with #")  # fmt: skip


def _without_empty_end(lines: Lines, separator: str | None, columns: list[str]) -> list[str]:
    """The names without an empty one at the end, behind the last separator, if the first row has none there."""
    if separator is None or columns[-1]:
        return columns
    place = lines.location(lines.frame)
    row = lines.next("\r\n") or ""
    lines.back(place)
    return columns[:-1] if len(_split(row, separator)) == len(columns) - 1 else columns


def _one_position(columns: list[str], count: int, options: Options, lines: Lines) -> list[str]:
    """The columns of positions that an option does not leave out. Refuses several: one may be a corner of a box around a body."""
    kept = [name for name in columns if name not in (options.ignore_columns or ())]
    found = _positions_in(kept, count) or _positions_in(kept, 2)
    others = [names for names in found if all(_OF_CENTERS.fullmatch(plain_name(name)) for name in names)]
    if len(found) > 1 and others and found[0] != others[-1]:
        raise lines.error(f"the columns {' '.join(found[0])} and {' '.join(others[-1])} may both be the position: leave one of both out "
                          f"(--ignore-columns {for_option(found[0])})")  # fmt: skip
    return found[0] if found else []


def _with_names_of_rows(lines: Lines, separator: str | None, columns: list[str]) -> list[str]:
    """Adds a column without a name before the others if the first row begins with a word in quotation marks that has none: R writes the
    names of rows so."""
    place = lines.location(lines.frame)
    row = lines.next("\r\n") or ""
    lines.back(place)
    return ["", *columns] if _NAME_OF_ROW.match(row) and len(_split(row, separator)) == len(columns) + 1 else columns


def _skip_heads(lines: Lines, separator: str | None, columns: list[str], positions: list[str], convention: Convention) -> None:
    """Skips lines of other names and of units beneath the names, which a program writes."""
    places = [columns.index(name) for name in positions]
    for _ in range(convention.heads):
        place = lines.location(lines.frame)
        words = _split(lines.next("\r\n") or "", separator)
        if not _are_words(words, places):
            lines.back(place)
            return


def _are_words(words: list[str], places: list[int]) -> bool:
    """Returns whether a row has names or units, not numbers, in these columns."""
    return max(places) < len(words) and all(_UNIT_ALONE.fullmatch(words[k]) and words[k].lower() not in ("nan", "inf") for k in places)


def _starts_with_number(lines: Lines, separator: str | None, column: int) -> bool:
    """Returns whether the first row has a number in this column, or is too short for a row."""
    place = lines.location(lines.frame)
    words = _split(lines.next("\r\n") or "", separator)
    lines.back(place)
    return column >= len(words) or _NUMBER.fullmatch(words[column].replace(",", ".")) is not None


def _check_units_row(lines: Lines, separator: str | None, places: list[int]) -> None:
    """Refuses a row of units beneath the names."""
    place = lines.location(lines.frame)
    words = _split(lines.next("\r\n") or "", separator)
    if _are_words(words, places):
        raise lines.error(f"the row beneath the names has words, not numbers, such as {words[places[0]]}: remove it, and if these are "
                          "units, write them into the names, as x (mm)")  # fmt: skip
    lines.back(place)


def _box(keys: dict[str, Any], lines: Lines) -> tuple[Floats | None, list[float], list[bool]]:
    """The cell, its corner, and the directions along which it repeats."""
    numbers, origin, periodic = keys.get("cell"), keys.get("origin", [0.0, 0.0, 0.0]), keys.get("periodic", [True, True, True])
    if numbers is not None and len(numbers) == 4:  # of a plane
        origin, periodic = [*origin, -0.5][:3], [*periodic, False][:3]
        numbers = [*numbers[:2], 0, *numbers[2:], 0, 0, 0, 1]
    if len(origin) != 3 or len(periodic) != 3:
        lines.number = 0
        raise lines.error("the comments '# origin' and '# periodic' have two values, which need '# cell' and four numbers: correct them")
    return None if numbers is None else np.reshape(np.array(numbers, dtype=np.float64), (3, 3)), origin, periodic


def _value(lines: Lines, key: str, text: str) -> Any:
    """The value of a key in the present line: a number, or a list."""
    count = len(text.split())
    value: int | list[bool] | list[float]
    try:
        if key in ("dimensions", "step"):
            value = lines.whole(text, key, -(2**63))
            is_allowed = key == "step" or value in (2, 3)
        elif key == "periodic":
            value = lines.flags(text if count != 2 else f"{text} F", key)[:count]
            is_allowed = True
        else:
            value = lines.numbers(text, count, key)
            is_allowed = count in ((4, 9) if key == "cell" else (2, 3))
    except FileError:
        is_allowed = False
    if not is_allowed:
        raise lines.error(f"the comment '# {key}' must be followed by {_VALUES[key]}, not by '{text[:60]}': {_OTHER_MEANING}")
    return value


def _keys(lines: Lines, options: Options) -> tuple[dict[str, Any], str, list[str]]:
    """Reads the lines before the names. Also returns the line with the names, or the first row if no line has names; and the comments."""
    keys: dict[str, Any] = {}
    units: dict[str, str] = {}
    others: dict[int, str] = {}
    comments, column = [], ""
    place = lines.location(lines.frame)
    while (line := lines.next("\r\n")) is not None and _may_precede(text := line.strip()):
        name, _, value = text[1:].strip().partition(" ")
        is_key = name in _KEYS and re.match(_KEYS[name], value.strip(), re.IGNORECASE) is not None
        if is_key and name in keys:
            raise lines.error(f"the comment '# {name}' is there twice: remove one")
        others |= {} if is_key else {lines.number: text}
        if is_key:
            keys[name] = _value(lines, name, value.strip())
        elif text.isdecimal():
            keys["rows"] = lines.whole(text, "the number of rows")
        elif text:
            comments.append(text)
            for key, value in _OF_ECSV.findall(text):
                column = value if key == "name" else column
                units |= {column: value} if key == "unit" else {}
        place = lines.location(lines.frame)
    for number, text in others.items() if "cell" not in keys else ():
        _check_cell(text, number, options, lines)
    # The names may be a comment: one that has as many words as the first row, or SExtractor's list.
    names = None if line is not None and not _has_numbers(line) else _names_in(comments, line)
    if names is not None:
        lines.back(place)
        return keys, names, [one for one in comments if one != names] if names in comments else []
    if line is not None and not _is_row(line):
        return keys, _with_units(line, units), comments
    lines.back(place)
    return keys, line if line is not None else lines.expect("the names of the columns"), comments


def _check_cell(comment: str, number: int, options: Options, lines: Lines) -> None:
    """Refuses comments, of the line with this number (0 if it is not known), that say a cell in other words."""
    if options.cell is None and _LIKE_KEYS.match(_NO_CELL.sub("", comment[:_SENTENCE].replace('"', ""))):
        lines.number = number
        raise lines.error(f"the comment '{comment[:60]}' could say the cell, and is not read: write '# cell' and nine numbers, '# origin' "
                          "and three, '# periodic' and three of T and F, give the cell (--cell), or remove the comment")  # fmt: skip


def _has_numbers(line: str) -> bool:
    """Returns whether a line has three numbers, which names have not."""
    return any(sum(map(bool, map(_NUMBER.fullmatch, words))) > 2 for words in _rows_of(line))


def _names_in(comments: list[str], line: str | None) -> str | None:
    """The names of the columns in the comments above a row."""
    if (listed := _listed(comments)) is not None:
        return listed
    counts = {len(words) for words in _rows_of(line or "")}
    return next((comment for comment in reversed(comments)
                 if _are_names(comment) and (line is None or len(_header(comment)[2]) in counts)), None)  # fmt: skip


def _with_units(line: str, units: dict[str, str]) -> str:
    """Adds units to the names of columns, as these are in the header of ECSV."""
    words = re.split(r"([,\s]+)", line) if units else [line]
    return "".join(f"{word}[{units[word]}]" if word in units else word for word in words)


def _listed(comments: list[str]) -> str | None:
    """The names that SExtractor (ASCII_HEAD) and Gnuastro write as numbered comments; a column of several numbers has one."""
    found = [tuple(filter(None, match.groups())) for comment in comments if (match := _NUMBERED.match(comment))]
    if not found or int(found[0][0]) != 1:
        return None
    names: list[str] = []
    for number, name in found:
        names += [f"{names[-1]}[{k}]" for k in range(2, int(number) - len(names) + 1)]
        names.append(name)
    return " ".join(names)


def _names(lines: Lines, line: str, options: Options) -> tuple[str | None, list[str], list[str]]:
    """Separator, columns of positions, all columns. Rows without names are those of a convention, if an option names one."""
    if not _is_row(line):
        separator, positions, columns = _header(line)
        is_comment = line.startswith(("#", "%"))
        return _separator_of_rows(lines, separator, len(columns)) if is_comment else separator, positions, columns
    found = [words for words in _rows_of(line) if all(_NUMBER.fullmatch(word) for word in words)]
    count = max(map(len, found), default=0)
    for one in named(options.convention or ""):
        if one.rows and len(one.rows) == count:
            separator = next(one for one in _SEPARATORS if len(_split(line, one)) == count)
            return separator, [], list(one.rows)
    lines.next()
    programs = " or ".join(f"--convention {one.name}" for one in CONVENTIONS if one.rows and len(one.rows) == count)
    program = f", or say which program wrote them ({programs})" if programs else ""
    raise lines.error(f"there is no line with the names of the columns: write one before the numbers, as x,y,z,a,b,c,qw,qx,qy,qz{program}")


def _separator_of_rows(lines: Lines, separator: str | None, count: int) -> str | None:
    """The separator of rows beneath names that are a comment: it may be another than that of the names."""
    place = lines.location(lines.frame)
    row = lines.next("\r\n") or ""
    lines.back(place)
    return next((one for one in (separator, *_SEPARATORS) if len(_split(row, one)) == count), separator)


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
    others = _comments.units_of(one for one in comments if not _OF_ECSV.search(one) and not _NUMBERED.match(one))
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
    rows = [[*zip(columns, words)] for comment in comments for words in _rows_of(comment.lstrip("#% ")) if len(words) == len(columns)]
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
    """The number of lines up to the last one that is neither blank nor a comment, which must be a body, and the comments behind it."""
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
    for word in _split(end.decode("utf-8", errors="replace"), separator):
        if _SUMMARY.fullmatch(word):
            lines.number += last
            raise lines.error(f"the row with the word '{word}' is a summary of others, and not a body: remove such rows")
    return last, comments


def _without_comments(text: bytes) -> tuple[bytes, list[str]]:
    """Lines without blank ones and comments at their end, and these comments. A row may begin so, too, as with a colour, #ff0000."""
    comments, end = list[str](), len(text)
    while end:
        begin = text.rfind(b"\n", 0, end) + 1
        line = text[begin:end].decode("utf-8", errors="replace").strip()
        if line and (not line.startswith(("#", "%")) or _has_numbers(line)):
            break
        comments += [line] if line else []
        end = max(begin - 1, 0)
    return text[:end], comments[::-1]


def _is_no_formula(name: str) -> bool:
    """Spreadsheets compute what begins so, unless it is a number."""
    return name[:1] not in tuple("=+-@") or _NUMBER.fullmatch(name) is not None


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
