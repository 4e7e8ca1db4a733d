"""Tables of numbers in text files: fast while they are right, and the line and column where they are not."""

from __future__ import annotations

import csv
import gzip
import itertools
import os
import re
import zlib
from typing import Any, NoReturn
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ._errors import FileError
from ._files import close_or_keep, open_for_reading
from ._frames import Location, check_lengths_of_names

# Lines parsed at once: some tenths of a second, after which an interruption is noticed.
_BLOCK = 50_000
_BLOCK_BYTES = 1 << 24
# Bytes of a line: what is no text can be one line of any length, and compressed be a small file.
_LONGEST = 1 << 20
_DIGITS = re.compile(r"[-+]?[0-9]+")
_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?|[-+]?(?:inf|infinity|nan)", re.ASCII | re.IGNORECASE)
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
        """The next line with its end; nothing behind the last."""
        line: bytes = self._try(self._file.readline, _LONGEST + 1)
        self.number += bool(line)
        if len(line) > _LONGEST:
            raise self.error(f"the line is longer than {_LONGEST} bytes: this is no file of this format, or it is broken")
        return line

    def next(self) -> str | None:
        """The next line without its end; None behind the last."""
        line = self.read()
        if not line:
            return None
        # Spreadsheets begin a file with a byte order mark.
        return line.decode("utf-8", errors="replace").removeprefix("\ufeff" if self.number == 1 else "").strip()

    def expect(self, what: str) -> str:
        line = self.next()
        if line is None:
            raise self.error(f"the file ends where {what} should be: it is truncated; write it again, or end before it")
        return line

    def skip(self, count: int) -> int:
        """Skips up to so many lines; how many there were."""
        skipped = 0
        while skipped < count and self.read():
            skipped += 1
        return skipped

    def columns_ahead(self) -> int:
        """How many words the next line has."""
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
        """The numbers of a line, of which there must be so many."""
        try:
            values = [_number(word) for word in text.split()]
        except ValueError:
            values = []
        if len(values) != count:
            raise self.error(f"{what} should be {count} numbers, not '{text[:80]}'")
        return values

    def whole(self, text: str, what: str, smallest: int = 0) -> int:
        """A whole number, 0 or more unless said otherwise."""
        try:
            value: float = int(text) if _DIGITS.fullmatch(text) else _number(text)
            if not smallest <= value < 2**63 or value != int(value):
                raise ValueError(text)
        except ValueError:
            raise self.error(f"{what} should be a whole number, not '{text[:80]}'") from None
        return int(value)

    def flags(self, text: str, what: str) -> list[bool]:
        """Three words, each of which is T or F, or what other programs write for these."""
        words = text.split()
        if len(words) != 3 or not set(words) <= {*_TRUE, *_FALSE}:
            raise self.error(f"{what} should be three of T and F, not '{text[:80]}'")
        return [word in _TRUE for word in words]

    def table(self, count: int, columns: Sequence[str], text: Sequence[str] = (), separator: str | None = None,
              wanted: Sequence[str] | None = None) -> Table:  # fmt: skip
        """The next `count` lines as a table with these columns; those in `text` are strings, those not wanted are skipped."""
        return Table(self, count, list(columns), set(text), separator, None if wanted is None else set(wanted))


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
    """As float(), which also takes digits of other scripts, and 1_000."""
    if not _NUMBER.fullmatch(word):
        raise ValueError(word)
    return float(word)


class Table:
    """Columns of `count` lines, by name; its first line has the number `line`."""

    def __init__(self, lines: Lines, count: int, columns: list[str], text: set[str],
                 separator: str | None, wanted: set[str] | None) -> None:  # fmt: skip
        self.columns, self._lines, self._separator = columns, lines, separator
        chosen = columns if wanted is None else [name for name in columns if name in wanted]
        for name in chosen:
            if chosen.count(name) > 1:
                raise lines.error(f"there are several columns '{name}': rename all but one")
        self._text = {name: columns.index(name) for name in chosen if name in text}
        self._numbers = {name: columns.index(name) for name in chosen if name not in text}
        self.line, self.count = lines.number + 1, count
        blocks = list(self._blocks())
        self._values = {name: np.concatenate([block[name] for block in blocks]) if blocks else np.empty(0) for name in chosen}

    def __contains__(self, name: str) -> bool:
        return name in self._values

    def __getitem__(self, name: str) -> NDArray[Any]:
        column: NDArray[Any] = self._values[name]
        return column

    def stack(self, names: Sequence[str]) -> NDArray[np.float64]:
        for name in names:
            if name in self._text:
                raise self._lines.error(f"the column '{name}' holds names: choose columns of numbers")
        return np.stack([self[name] for name in names], axis=1)

    def integers(self, name: str) -> NDArray[np.int64]:
        column = self[name]
        wrong = ~(np.abs(column) < 2.0**53) | (column != np.trunc(column))
        if wrong.any():
            self._lines.number = self.line + int(wrong.argmax())
            raise self._lines.error(f"'{name}' should be a whole number, not {column[wrong][0]:g}")
        return column.astype(np.int64)

    def _blocks(self) -> Iterator[dict[str, NDArray[Any]]]:
        remaining = self.count
        while remaining:
            start = self._lines.number
            block = list(itertools.islice(self._lines_of_block(), min(remaining, _BLOCK)))
            end, self._lines.number = self._lines.number, start
            yield self._parse([line.decode("utf-8", errors="replace") for line in block])
            self._lines.number = end
            remaining -= len(block)
            if remaining and not self._has_more:
                raise self._lines.error(
                    f"the file ends after {self.count - remaining} of {self.count} particles: it is truncated; "
                    "write it again, or end before this frame"
                )

    def _lines_of_block(self) -> Iterator[bytes]:
        """Up to a number of bytes: a small compressed file may have long lines."""
        size, self._has_more = 0, True
        while size < _BLOCK_BYTES:
            line = self._lines.read()
            if not line:
                self._has_more = False
                return
            size += len(line)
            yield line

    def _parse(self, block: list[str]) -> dict[str, NDArray[Any]]:
        """Numbers are parsed by NumPy from whole lines, or from the words of these where some are quoted."""
        if not block:
            self._explain(block)
        names: dict[str, list[str]] = {name: [] for name in self._text}
        has_quotes = self._separator is not None and any('"' in line for line in block)
        numbers = []
        for k, line in enumerate(block):
            words = self._split(line, k)
            if len(words) != len(self.columns):
                self._explain(block)
            for name, column in self._text.items():
                names[name].append(words[column].strip())
            if has_quotes:
                numbers.append("\x1f".join(words[column] for column in self._numbers.values()))
        try:
            if has_quotes:
                rows = np.loadtxt(numbers, delimiter="\x1f", comments=None, ndmin=2)
            else:
                places = list(self._numbers.values())
                rows = np.loadtxt(block, delimiter=self._separator, usecols=places, comments=None, ndmin=2)
        except ValueError:
            self._explain(block)
        if len(rows) != len(block):
            self._explain(block)
        return dict(zip(self._numbers, rows.T)) | {name: self._names(words) for name, words in names.items()}

    def _names(self, words: list[str]) -> NDArray[np.str_]:
        different = set(words)
        check_lengths_of_names(sorted(different), self._lines.error)
        if any("\ufffd" in word for word in different):
            self._lines.number += 1 + next(k for k, word in enumerate(words) if "\ufffd" in word)
            raise self._lines.error("the name of a type is no text in UTF-8: convert the file")
        return np.array(words)

    def _split(self, line: str, number: int) -> list[str]:
        if self._separator is None or '"' not in line:
            return line.split(self._separator)
        try:
            return next(csv.reader([line], delimiter=self._separator, strict=True))
        except (csv.Error, StopIteration) as error:
            self._lines.number += number + 1
            raise self._lines.error(f"the line cannot be read ({error}): correct its quotation marks") from None

    def _explain(self, block: list[str]) -> NoReturn:
        for line in block:
            words = self._split(line, 0)
            self._lines.number += 1
            if len(words) != len(self.columns):
                raise self._lines.error(
                    f"{len(words)} columns instead of {len(self.columns)} ({' '.join(self.columns)[:200]}): the line is broken, "
                    "or the file truncated"
                )
            for name, column in self._numbers.items():
                self._check_number(column + 1, name, words[column].strip())
        if block:
            raise self._lines.error("the lines of particles cannot be read: write the file again")
        raise self._lines.error("the file ends where particles should be: it is truncated; write it again")

    def _check_number(self, number: int, name: str, word: str) -> None:
        try:
            np.loadtxt([word or "?"], comments=None, delimiter=",")
        except ValueError:
            raise self._lines.error(
                f"column {number} ({name}) should be a number, not '{word[:40]}': correct it, or name other columns"
            ) from None
