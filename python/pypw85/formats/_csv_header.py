# SPDX-License-Identifier: BSD-3-Clause
"""The lines before the rows of a table: comments with keys, the names of the columns, and what separates these."""

from __future__ import annotations

import contextlib
import csv
import itertools
import re
from typing import Any
from collections.abc import Iterator

import numpy as np

from .._typing import Floats
from ._boxes import SAYS_CELL
from ._column_names import plain_name
from ._columns import centers_of
from ._conventions import CONVENTIONS, named, possible, recognised
from ._errors import FileError
from ._options import Options
from ._table import Lines

NUMBER = re.compile(r"[-+]?[0-9.]+(?:[deDE][-+]?[0-9]+)?")
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
OF_ECSV = re.compile(r"\b(name|unit): ['\"]?([\w.]+)")
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
NUMBERED = re.compile(r"#\s*(?:(\d{1,4})\s+([A-Za-z]\w*)|Column\s+(\d{1,4}):\s+([A-Za-z]\w*)\s+\[)")
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


def recognise(start: bytes) -> bool:
    lines = start.decode("utf-8", errors="replace").splitlines()
    comments = list(itertools.takewhile(_may_precede, lines))
    first = next(iter(lines[len(comments) :]), "")
    is_named = any(possible({plain_name(name) for name in words}) for words in rows_of(first))
    is_named = is_named or (has_numbers(first) and _names_in(comments, first) is not None)
    return _are_names(first) or _is_row(first) or is_named or (not first and any(map(_are_names, comments)))


def _may_precede(line: str) -> bool:
    """Lines before the names of columns: comments, the number of rows that DREAM.3D writes, and the separator for spreadsheets."""
    text = line.strip()
    return not text or text.startswith(("#", "%")) or text.isdecimal() or re.fullmatch("sep=.?", text) is not None


def _are_names(line: str) -> bool:
    return bool(_header(line)[1])


def _is_row(line: str) -> bool:
    """Returns whether the line has numbers enough for a centre and a length."""
    return any(len(words) > 3 and all(NUMBER.fullmatch(word) for word in words[:4]) for words in rows_of(line))


def rows_of(line: str) -> Iterator[list[str]]:
    return (split(line, one) for one in _SEPARATORS)


def _header(line: str) -> tuple[str | None, list[str], list[str]]:
    """The separator, the names of the columns that hold a position (none if there are none), and those of all columns.

    The names may be a comment, as NumPy writes them.
    """
    line = _FORMAT_OF_YADE.sub(lambda found: found[1].replace("_", " "), line)
    line = _COMMENT_OF_NAMES.sub("", line)
    found = [(one, split(line, one)) for one in _SEPARATORS]
    # Blanks do not separate columns where another character separates three, which a table has at least.
    found = [(one, words) for one, words in found if one is not None or all(len(others) < 3 for _, others in found[:-1])]
    for count in (3, 2):
        for separator, columns in found:
            if positions := positions_in(columns, count):
                return separator, positions[0], columns
    for separator, columns in found:
        if (convention := recognised(columns, {plain_name(name) for name in columns})) is not None:
            return separator, list(centers_of(convention, columns)), columns
    separator, columns = max(found, key=lambda pair: len(pair[1]))
    return separator, [], columns


def positions_in(columns: list[str], count: int) -> list[list[str]]:
    """All sets of columns that may hold positions with so many coordinates, two in tables of ellipses."""
    plain = {plain_name(name): name for name in reversed(columns)}
    return [[plain[name] for name in names[:count]] for names in _POSITIONS if set(names[:count]) <= plain.keys()]


def split(line: str, separator: str | None) -> list[str]:
    words = line.split(separator) if separator is not None else _WORD.findall(_UNIT_BEHIND.sub(r"\1", line))
    if separator is not None and '"' in line:
        with contextlib.suppress(csv.Error, StopIteration):
            words = next(csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True))
    return [word.strip().strip('"').strip() for word in words]


def without_empty_end(lines: Lines, separator: str | None, columns: list[str]) -> list[str]:
    """The names without an empty one at the end, behind the last separator, if the first row has none there."""
    if separator is None or columns[-1]:
        return columns
    return columns[:-1] if len(split(lines.first_row(), separator)) == len(columns) - 1 else columns


def with_names_of_rows(lines: Lines, separator: str | None, columns: list[str]) -> list[str]:
    """Adds a column without a name before the others if the first row begins with a word in quotation marks that has none: R writes the
    names of rows so."""
    row = lines.first_row()
    return ["", *columns] if _NAME_OF_ROW.match(row) and len(split(row, separator)) == len(columns) + 1 else columns


def box_of(keys: dict[str, Any], lines: Lines) -> tuple[Floats | None, list[float], list[bool]]:
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


def read_keys(lines: Lines, options: Options) -> tuple[dict[str, Any], str, list[str]]:
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
            for key, value in OF_ECSV.findall(text):
                column = value if key == "name" else column
                units |= {column: value} if key == "unit" else {}
        place = lines.location(lines.frame)
    for number, text in others.items() if "cell" not in keys else ():
        check_cell(text, number, options, lines)
    # The names may be a comment: one that has as many words as the first row, or SExtractor's list.
    names = None if line is not None and not has_numbers(line) else _names_in(comments, line)
    if names is not None:
        lines.back(place)
        return keys, names, [one for one in comments if one != names] if names in comments else []
    if line is not None and not _is_row(line):
        return keys, _with_units(line, units), comments
    lines.back(place)
    return keys, line if line is not None else lines.expect("the names of the columns"), comments


def check_cell(comment: str, number: int, options: Options, lines: Lines) -> None:
    """Refuses comments, of the line with this number (0 if it is not known), that say a cell in other words."""
    if options.cell is None and _LIKE_KEYS.match(_NO_CELL.sub("", comment[:_SENTENCE].replace('"', ""))):
        lines.number = number
        raise lines.error(f"the comment '{comment[:60]}' could say the cell, and is not read: write '# cell' and nine numbers, '# origin' "
                          "and three, '# periodic' and three of T and F, give the cell (--cell), or remove the comment")  # fmt: skip


def has_numbers(line: str) -> bool:
    """Returns whether a line has three numbers, which names have not."""
    return any(sum(map(bool, map(NUMBER.fullmatch, words))) > 2 for words in rows_of(line))


def _names_in(comments: list[str], line: str | None) -> str | None:
    """The names of the columns in the comments above a row."""
    if (listed := _listed(comments)) is not None:
        return listed
    counts = {len(words) for words in rows_of(line or "")}
    found = [comment for comment in reversed(comments) if line is None or len(_header(comment)[2]) in counts]
    # Names of which none is known to be a position have a separator; sentences have blanks.
    return next((comment for comment in found if _are_names(comment)),
                next((comment for comment in found if line is not None and _is_list(comment)), None))  # fmt: skip


def _is_list(comment: str) -> bool:
    separator, _, names = _header(comment)
    return separator is not None and len(names) > 3 and all(names)


def _with_units(line: str, units: dict[str, str]) -> str:
    """Adds units to the names of columns, as these are in the header of ECSV."""
    words = re.split(r"([,\s]+)", line) if units else [line]
    return "".join(f"{word}[{units[word]}]" if word in units else word for word in words)


def _listed(comments: list[str]) -> str | None:
    """The names that SExtractor (ASCII_HEAD) and Gnuastro write as numbered comments; a column of several numbers has one."""
    found = [tuple(filter(None, match.groups())) for comment in comments if (match := NUMBERED.match(comment))]
    if not found or int(found[0][0]) != 1:
        return None
    names: list[str] = []
    for number, name in found:
        names += [f"{names[-1]}[{k}]" for k in range(2, int(number) - len(names) + 1)]
        names.append(name)
    return " ".join(names)


def names_of_columns(lines: Lines, line: str, options: Options) -> tuple[str | None, list[str], list[str]]:
    """Separator, columns of positions, all columns. Rows without names are those of a convention, if an option names one."""
    if not _is_row(line):
        separator, positions, columns = _header(line)
        is_comment = line.startswith(("#", "%"))
        return _separator_of_rows(lines, separator, len(columns)) if is_comment else separator, positions, columns
    found = [words for words in rows_of(line) if all(NUMBER.fullmatch(word) for word in words)]
    count = max(map(len, found), default=0)
    for one in named(options.convention or ""):
        if one.rows and len(one.rows) == count:
            separator = next(one for one in _SEPARATORS if len(split(line, one)) == count)
            return separator, [], list(one.rows)
    lines.next()
    programs = " or ".join(f"--convention {one.name}" for one in CONVENTIONS if one.rows and len(one.rows) == count)
    program = f", or say which program wrote them ({programs})" if programs else ""
    raise lines.error(f"there is no line with the names of the columns: write one before the numbers, as x,y,z,a,b,c,qw,qx,qy,qz{program}")


def _separator_of_rows(lines: Lines, separator: str | None, count: int) -> str | None:
    """The separator of rows beneath names that are a comment: it may be another than that of the names."""
    row = lines.first_row()
    return next((one for one in (separator, *_SEPARATORS) if len(split(row, one)) == count), separator)
