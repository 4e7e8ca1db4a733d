"""Tables of numbers in text files: fast while they are right, and the line and column where they are not."""

from __future__ import annotations

import itertools
import os
from typing import Any, BinaryIO, NoReturn
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ._errors import FileError
from ._frames import Location

# Lines parsed at once: some tenths of a second, after which an interruption is noticed.
_BLOCK = 50_000


class Lines:
    """Lines of a text file from a location on, counted."""

    def __init__(self, path: os.PathLike[str], location: Location) -> None:
        self.path, self.frame, self.number = path, location.frame, location.line
        self._file: BinaryIO = open(path, "rb")  # noqa: SIM115 (closed by __exit__)
        self._file.seek(location.offset)

    def __enter__(self) -> Lines:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def next(self) -> str | None:
        """The next line without its end; None behind the last."""
        line = self._file.readline()
        if not line:
            return None
        self.number += 1
        return line.decode("utf-8", errors="replace").strip()

    def expect(self, what: str) -> str:
        line = self.next()
        if line is None:
            raise self.error(f"the file ends where {what} should be: it is truncated; write it again, or end before it")
        return line

    def skip(self, count: int) -> int:
        """Skips up to so many lines; how many there were."""
        skipped = sum(1 for _ in itertools.islice(self._file, count))
        self.number += skipped
        return skipped

    def back(self, location: Location) -> None:
        """Continues from a place that was passed."""
        self._file.seek(location.offset)
        self.number = location.line

    def location(self, frame: int) -> Location:
        return Location(frame, self._file.tell(), self.number)

    def error(self, reason: str) -> FileError:
        return FileError(self.path, reason, self.frame, self.number or None)

    def numbers(self, text: str, count: int, what: str) -> list[float]:
        """The numbers of a line, of which there must be so many."""
        try:
            values = [float(word) for word in text.split()]
        except ValueError:
            values = []
        if len(values) != count:
            raise self.error(f"{what} should be {count} numbers, not '{text[:80]}'")
        return values

    def table(self, count: int, columns: Sequence[str], text: Sequence[str] = (), separator: str | None = None,
              wanted: Sequence[str] | None = None) -> Table:  # fmt: skip
        """The next `count` lines as a table with these columns; those in `text` are strings, those not wanted are skipped."""
        return Table(self, self._file, count, list(columns), set(text), separator, wanted)


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


class Table:
    """Columns of `count` lines, by name; its first line has the number `line`."""

    def __init__(self, lines: Lines, file: BinaryIO, count: int, columns: list[str], text: set[str],
                 separator: str | None, wanted: Sequence[str] | None) -> None:  # fmt: skip
        self.columns, self._lines, self._separator, self._text = columns, lines, separator, text
        self._wanted = [name for name in columns if wanted is None or name in wanted]
        self.line, self.count = lines.number + 1, count
        blocks = list(self._blocks(file))
        self._values: NDArray[Any] = np.concatenate(blocks) if blocks else np.empty(0, self._type())

    def __contains__(self, name: str) -> bool:
        return name in self._wanted

    def __getitem__(self, name: str) -> NDArray[Any]:
        column: NDArray[Any] = self._values[name]
        return column

    def stack(self, names: Sequence[str]) -> NDArray[np.float64]:
        return np.stack([self[name] for name in names], axis=1)

    def integers(self, name: str) -> NDArray[np.int64]:
        column = self[name]
        wrong = ~(np.abs(column) < 2.0**53) | (column != np.trunc(column))
        if wrong.any():
            self._lines.number = self.line + int(wrong.argmax())
            raise self._lines.error(f"'{name}' should be a whole number, not {column[wrong][0]:g}")
        return column.astype(np.int64)

    def _type(self) -> np.dtype[Any]:
        return np.dtype([(name, "U32" if name in self._text else "f8") for name in self._wanted])

    def _blocks(self, file: BinaryIO) -> Iterator[NDArray[Any]]:
        remaining = self.count
        while remaining:
            block = list(itertools.islice(file, min(remaining, _BLOCK)))
            yield self._parse(block)
            self._lines.number += len(block)
            remaining -= len(block)
            if remaining and len(block) < _BLOCK:
                raise self._lines.error(
                    f"the file ends after {self.count - remaining} of {self.count} particles: it is truncated; "
                    "write it again, or end before this frame"
                )

    def _parse(self, block: list[bytes]) -> NDArray[Any]:
        separator = self._separator.encode() if self._separator else None
        if not block or any(len(line.split(separator)) != len(self.columns) for line in block):
            self._explain(block)
        numbers = [self.columns.index(name) for name in self._wanted]
        try:
            return np.loadtxt(
                [line.decode("utf-8", errors="replace") for line in block],
                dtype=self._type(), delimiter=self._separator, usecols=numbers, comments=None, ndmin=1,
            )  # fmt: skip
        except ValueError:
            self._explain(block)

    def _explain(self, block: list[bytes]) -> NoReturn:
        for line in block:
            self._lines.number += 1
            words = line.decode("utf-8", errors="replace").split(self._separator)
            if len(words) != len(self.columns):
                raise self._lines.error(
                    f"{len(words)} columns instead of {len(self.columns)} ({' '.join(self.columns)}): the line is broken, "
                    "or the file truncated"
                )
            for number, (name, word) in enumerate(zip(self.columns, words), 1):
                if name in self._wanted and name not in self._text:
                    self._check_number(number, name, word.strip())
        raise self._lines.error("the file ends where particles should be: it is truncated; write it again")

    def _check_number(self, number: int, name: str, word: str) -> None:
        try:
            np.loadtxt([word or "?"], comments=None)
        except ValueError:
            raise self._lines.error(
                f"column {number} ({name}) should be a number, not '{word[:40]}': correct it, or name other columns"
            ) from None
