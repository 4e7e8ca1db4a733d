# SPDX-License-Identifier: BSD-3-Clause
"""Tables of numbers in text files. Compiled code reads plain lines, and writes all; errors name the line and the column."""

from __future__ import annotations

import csv
import gzip
import os
import re
import zlib
from typing import IO, Any, TypeAlias
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from .. import _core
from .._words import counted
from ._errors import FileError
from ._files import READ_AHEAD, close_or_keep, open_for_reading
from ._frames import Location, check_lengths_of_names
from ._names import LONGEST

# Bytes of the lines that are parsed at once: some hundredths of a second, after which an interruption is noticed.
_BLOCK = 1 << 22
# Rows that are written at once: some ten megabytes.
_WRITTEN = 1 << 16
# The longest line in bytes. A file that is not text may be one line of any length, and small if it is compressed.
_LONGEST = READ_AHEAD
# The longest number; the midpoint of two numbers in double precision has up to 1075 digits.
_LONGEST_NUMBER = 1 << 13
_THOUSANDS = re.compile(r"[-+]?[1-9][0-9]{0,2},[0-9]{3}")
_DIGITS = re.compile(r"[-+]?[0-9]+")
_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[deDE][-+]?[0-9]+)?|[-+]?(?:inf|infinity|nan)", re.ASCII | re.IGNORECASE)
# Rows of numbers, and for each column of names, codes and the names that these count.
_Block: TypeAlias = tuple[NDArray[np.float64], NDArray[np.int32], list[list[str]]]
_TRUE, _FALSE = ("T", "True", "TRUE", "true", "1"), ("F", "False", "FALSE", "false", "0")


class Lines:
    """Lines of a text file from a location on, counted."""

    def __init__(self, path: os.PathLike[str], location: Location) -> None:
        self.path, self.frame, self.number = path, location.frame, location.line
        self._file = open_for_reading(path)
        self._try(self._file.seek, location.offset)

    def __enter__(self) -> Lines:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        close_or_keep(self.path, self._file, kind is None)

    def _try(self, function: Callable[[int], Any], argument: int) -> Any:
        try:
            return function(argument)
        except (EOFError, gzip.BadGzipFile, zlib.error) as error:
            raise self.error(f"what is compressed cannot be read ({error}): it is broken or truncated; write it again") from None

    def read(self) -> bytes:
        """The next line with its end; empty at the end of the file."""
        line: bytes = self._try(self._file.readline, _LONGEST + 1)
        self.number += bool(line)
        if len(line) > _LONGEST:
            raise self.error(f"the line is longer than {_LONGEST} bytes: this is not a file of this format, or it is broken")
        return line

    def read_block(self, count: int) -> tuple[bytes, int]:
        """The next lines, up to `count` and some megabytes, and how many they are."""
        parts: list[bytes] = []
        start, size = self.number, 0
        while size < _BLOCK and (left := start + count - self.number) and (part := self._read_ahead(left) or self.read()):
            parts.append(part)
            size += len(part)
        return b"".join(parts), self.number - start

    def _read_ahead(self, count: int) -> bytes:
        """Whole lines that are in memory already, up to `count`."""
        ahead: bytes = self._try(self._file.peek, 1)
        ends, size = ahead.count(b"\n"), ahead.rfind(b"\n") + 1
        if ends > count:
            ends, size = count, int(np.flatnonzero(np.frombuffer(ahead, np.uint8) == ord("\n"))[count - 1]) + 1
        self.number += ends
        return self._file.read(size)

    def next(self, ends: str | None = None) -> str | None:
        """The next line without its end and without blanks around it, or without the characters of `ends`; None behind the last."""
        line = self.read()
        if not line:
            return None
        # Spreadsheets begin a file with a byte order mark.
        return line.decode("utf-8", errors="replace").removeprefix("\ufeff" if self.number == 1 else "").strip(ends)

    def first_row(self) -> str:
        """The next line, empty if there is none, which is read again."""
        place = self.location(self.frame)
        row = self.next("\r\n") or ""
        self.back(place)
        return row

    def expect(self, what: str) -> str:
        line = self.next()
        if line is None:
            raise self.error(f"the file ends where {what} must follow: it is truncated; write it again, or end before it")
        return line

    def skip(self, count: int) -> int:
        """Skips up to `count` lines, and returns how many there were."""
        skipped = 0
        while skipped < count and (lines := self.read_block(count - skipped)[1]):
            skipped += lines
        return skipped

    def columns_ahead(self) -> int:
        """The number of words of the next line."""
        place = self.location(self.frame)
        count = len(self.read().decode("utf-8", errors="replace").split())
        self.back(place)
        return count

    def back(self, location: Location) -> None:
        """Continues from a place that was passed."""
        self._try(self._file.seek, location.offset)
        self.number = location.line

    def location(self, frame: int) -> Location:
        return Location(frame, self._file.tell(), self.number)

    def error(self, reason: str) -> FileError:
        return FileError(self.path, reason, self.frame, self.number or None)

    def numbers(self, text: str, count: int, what: str) -> list[float]:
        """The numbers of a line, whose count is checked."""
        try:
            values = [_number(word) for word in text.split()]
        except ValueError:
            values = []
        if len(values) != count:
            raise self.error(f"{what} must be {counted(count, 'number')}, not '{text[:80]}'")
        return values

    def whole(self, text: str, what: str, smallest: int = 0) -> int:
        """A whole number, 0 or more unless said otherwise."""
        try:
            value: float = int(text) if _DIGITS.fullmatch(text) else _number(text)
            if not smallest <= value < 2**63 or value != int(value):
                raise ValueError(text)
        except ValueError:
            raise self.error(f"{what} must be a whole number, not '{text[:80]}'") from None
        return int(value)

    def flags(self, text: str, what: str) -> list[bool]:
        """Three words, each of which is T or F, or what other programs write for these."""
        words = text.split()
        if len(words) != 3 or not set(words) <= {*_TRUE, *_FALSE}:
            raise self.error(f"{what} must be three of T and F, not '{text[:80]}'")
        return [word in _TRUE for word in words]

    def table(self, count: int, columns: Sequence[str], text: Sequence[str] = (), separator: str | None = None,
              wanted: Sequence[str] | None = None, decimal_comma: bool = False, comment: str = "") -> Table:  # fmt: skip
        """The next `count` lines as a table with these columns; those in `text` are strings, those not wanted are skipped.

        Numbers may have a decimal comma, and lines may end with a comment that begins with `comment`, if this is asked for.
        """
        return Table(self, count, list(columns), set(text), separator, None if wanted is None else set(wanted), decimal_comma, comment)


def locate_frames(path: os.PathLike[str], lines_of_frame: Callable[[Lines], int | None]) -> Iterator[Location]:
    """Frames one behind the other. The function reads the start of one, and says how many lines follow; None at the end."""
    with Lines(path, Location(0)) as lines:
        while True:
            location = lines.location(lines.frame)
            remaining = lines_of_frame(lines)
            if remaining is None:
                return
            yield location
            lines.skip(remaining)
            lines.frame += 1


def _number(word: str) -> float:
    """As float(), which also takes digits of other scripts, and 1_000, and whose time is quadratic in the number of digits. Exponents may
    begin with D, as in Fortran."""
    if len(word) > _LONGEST_NUMBER or not _NUMBER.fullmatch(word):
        raise ValueError(f"'{word[:80]}' is not a number")
    try:
        return float(word)
    except ValueError:
        return float(word.upper().replace("D", "E"))


def _comma_or_point(word: str) -> str:
    """Returns "point" for a number with one, "thousands" for a comma that may group these, "decimal" for one that cannot, or ""."""
    if "," not in word:
        return "point" if "." in word else ""
    return "thousands" if _THOUSANDS.fullmatch(word) else "decimal"


class Table:
    """Columns of `count` lines, by name. The first of the lines has the number `line`."""

    def __init__(self, lines: Lines, count: int, columns: list[str], text: set[str],
                 separator: str | None, wanted: set[str] | None, decimal_comma: bool, comment: str) -> None:  # fmt: skip
        self.columns, self._lines, self._separator = columns, lines, separator
        self._decimal_comma, self._comment = decimal_comma, comment
        chosen = columns if wanted is None else [name for name in columns if name in wanted]
        for name in chosen:
            if chosen.count(name) > 1:
                raise lines.error(f"there are several columns '{name}': rename all but one")
        self._text = [name for name in chosen if name in text]
        self._numbers = [name for name in chosen if name not in text]
        kinds = ["n" if name in self._numbers else "t" if name in self._text else "-" for name in columns]
        self._kinds = "".join(kinds).encode()
        self.line, self.count, self._filled = lines.number + 1, count, 0
        self._rows = np.empty((0, len(self._numbers)))
        # For each column of names, the different names with their numbers, and the numbers in each row
        self._names: list[dict[str, int]] = [{} for _ in self._text]
        self._codes: list[list[NDArray[np.int32]]] = [[] for _ in self._text]
        # Where commas may be decimal: by `_comma_or_point`, the first such number and its row
        self._commas: dict[str, tuple[int, str]] = {}
        while self._filled < count:
            self._add(*lines.read_block(count - self._filled))
        self._check_commas()

    def __contains__(self, name: str) -> bool:
        return name in self._text or name in self._numbers

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name in self._numbers:
            return self._rows[:, self._numbers.index(name)]
        column = self._text.index(name)
        return np.array(list(self._names[column]))[np.concatenate(self._codes[column])] if self.count else np.empty(0)

    def stack(self, names: Sequence[str]) -> NDArray[np.float64]:
        """Columns of numbers side by side; a view where they lie so in the file."""
        for name in names:
            if name in self._text:
                raise self._lines.error(f"the column '{name}' holds names: choose columns of numbers")
        places = [self._numbers.index(name) for name in names]
        first, end = places[0], places[0] + len(places)
        return self._rows[:, first:end] if places == list(range(first, end)) else self._rows.take(places, axis=1)

    def integers(self, name: str) -> NDArray[np.int64]:
        column = self[name]
        wrong = ~(np.abs(column) < 2.0**53) | (column != np.trunc(column))
        if wrong.any():
            raise self._error(int(wrong.argmax()), f"'{name}' must be a whole number, not {column[wrong][0]:g}")
        return column.astype(np.int64)

    def _error(self, row: int, reason: str) -> FileError:
        self._lines.number = self.line + row
        return self._lines.error(reason)

    def _add(self, block: bytes, count: int) -> None:
        """Appends the rows of a block of lines."""
        if not block:
            raise self._truncated()
        rows, codes, names = self._plain_rows(block) or self._rows_by_words(block)
        end = self._filled + count
        if end > len(self._rows):
            self._rows.resize((min(self.count, 2 * end), len(self._numbers)), refcheck=False)
        self._rows[self._filled : end] = rows
        for k, found in enumerate(names):
            self._check_names(found, codes[:, k])
            numbers = [self._names[k].setdefault(name, len(self._names[k])) for name in found]
            self._codes[k].append(np.array(numbers, np.int32)[codes[:, k]])
        self._filled = end

    def _truncated(self) -> FileError:
        if not self._filled:
            return self._lines.error("the file ends where particles must follow: it is truncated; write it again")
        return self._lines.error(
            f"the file ends after {self._filled} of {self.count} particles: it is truncated; write it again, or end before this frame"
        )

    def _plain_rows(self, block: bytes) -> _Block | None:
        """The rows of a block; None unless all of its lines are plain."""
        found = _core.parse_rows(block, ord(self._separator or "\0"), self._kinds)
        if found is None:
            return None
        rows, codes, words = found
        names = [[word.decode("utf-8", errors="replace") for word in column] for column in words]
        if self._separator is not None:
            return rows, codes, [[name.strip() for name in column] for column in names]
        # Unicode has blanks of its own.
        return (rows, codes, names) if all(name.split() == [name] for column in names for name in column) else None

    def _rows_by_words(self, block: bytes) -> _Block:
        """The rows of a block of any lines. Raises an error for the first line that cannot be read."""
        rows = []
        words: list[list[str]] = [[] for _ in self._text]
        numbers = [self.columns.index(name) for name in self._numbers]
        for k, line in enumerate(block.decode("utf-8", errors="replace").removesuffix("\n").split("\n")):
            fields = self._split(line, self._filled + k)
            rows.append([self._number(fields[column], self._filled + k, column) for column in numbers])
            for name, column in zip(self._text, words):
                column.append(fields[self.columns.index(name)].strip())
        codes = np.empty((len(rows), len(words)), np.int32)
        names = [list(dict.fromkeys(column)) for column in words]
        for k, column in enumerate(words):
            known = {name: number for number, name in enumerate(names[k])}
            codes[:, k] = [known[name] for name in column]
        return np.array(rows).reshape(len(rows), len(numbers)), codes, names

    def _split(self, line: str, row: int) -> list[str]:
        if self._comment:
            line = line.partition(self._comment)[0]
        fields = line.split(self._separator)
        if self._separator is not None and '"' in line:
            try:
                fields = next(csv.reader([line], delimiter=self._separator, strict=True))
            except (csv.Error, StopIteration) as error:
                raise self._error(row, f"the line cannot be read ({error}): correct its quotation marks") from None
        if len(fields) != len(self.columns):
            if not line.strip() or line.lstrip().startswith(("#", "%")):
                raise self._error(row, "there is an empty line or a comment among the rows: remove it, or end the table before it")
            raise self._error(row, f"{counted(len(fields), 'column')} instead of {len(self.columns)} ({' '.join(self.columns)[:200]}): "
                              "the line is broken, or the file truncated")  # fmt: skip
        return fields

    def _number(self, field: str, row: int, column: int) -> float:
        word = field.strip()
        if self._decimal_comma:
            self._commas.setdefault(_comma_or_point(word), (row, word))
        try:
            return _number(word.replace(",", ".") if self._decimal_comma else word)
        except ValueError:
            raise self._error(
                row,
                f"column {column + 1} ({self.columns[column]}) must be a number, not '{word[:40]}': "
                "correct it, or name other columns",
            ) from None

    def _check_commas(self) -> None:
        """Refuses commas that may group thousands: beside decimal points, or where each stands before three digits."""
        for kind in ("decimal", "thousands"):
            if kind in self._commas and "point" in self._commas:
                row, word = self._commas[kind]
                raise self._error(row, f"'{word[:40]}' has a comma, and '{self._commas['point'][1][:40]}' a point, so that the comma may "
                                  "be decimal or group thousands: write all numbers with points")  # fmt: skip
        if "thousands" in self._commas and "decimal" not in self._commas:
            row, word = self._commas["thousands"]
            raise self._error(row, f"the comma of '{word[:40]}' may be decimal or group thousands: write all numbers with points")

    def _check_names(self, names: list[str], codes: NDArray[np.int32]) -> None:
        for code, name in enumerate(names):
            if len(name) > LONGEST or "\ufffd" in name:
                self._lines.number = self.line + self._filled + int((codes == code).argmax())
                check_lengths_of_names([name], self._lines.error)
                raise self._lines.error("the name of a type is not text in UTF-8: convert the file")


# Codes of names, one for each row, and the names in bytes that the codes count
Coded: TypeAlias = tuple[NDArray[np.int32], list[bytes]]


def coded(names: NDArray[Any], spelled: Callable[[str], str] = str) -> Coded:
    """A column of names, for `write_rows`. Each name is written as `spelled` returns it."""
    different, codes = np.unique(names, return_inverse=True)
    return codes.astype(np.int32), [spelled(name).encode() for name in different.tolist()]


def write_rows(file: IO[str], separator: str, *columns: NDArray[Any] | Coded) -> None:
    """Writes the rows of columns: arrays (n) or (n, k) of whole numbers or of numbers in double precision, or names.

    A number has the fewest digits that are read as the same number.
    """
    plain: list[NDArray[Any] | Coded] = [column if isinstance(column, tuple) else _plain(column) for column in columns]
    count = len(plain[0][0] if isinstance(plain[0], tuple) else plain[0])
    for begin in range(0, count, _WRITTEN):
        file.write(_core.format_rows(ord(separator), *(_part(column, slice(begin, begin + _WRITTEN)) for column in plain)))


def _plain(column: NDArray[Any]) -> NDArray[Any]:
    """As compiled code takes it: contiguous, of two dimensions, of int64 or float64."""
    kind = np.int64 if column.dtype.kind in "iu" else np.float64
    return np.require(column.reshape(len(column), -1), kind, ["C", "A"])


def _part(column: NDArray[Any] | Coded, rows: slice) -> NDArray[Any] | Coded:
    return (column[0][rows], column[1]) if isinstance(column, tuple) else column[rows]
