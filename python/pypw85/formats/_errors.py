# SPDX-License-Identifier: BSD-3-Clause
"""Errors in files: each says what is wrong, where, and what helps."""

from __future__ import annotations

import csv
import functools
import os
import shlex
from typing import Any, TypeVar, cast
from collections.abc import Callable, Iterable

from .._words import printable

Function = TypeVar("Function", bound=Callable[..., Any])


class FileError(ValueError):
    """Exception: a file cannot be read or written. It is a ValueError.

    Attributes
    ----------
    path : str
        Name of the file.
    reason : str
        What is wrong, and, after a colon, what to do.
    frame, line : int or None
        Number of the frame, from 0, and of the line, from 1; None if unknown.
    """

    def __init__(self, path: object, reason: str, frame: int | None = None, line: int | None = None) -> None:
        super().__init__(path, reason, frame, line)
        self.path, self.reason, self.frame, self.line = os.fspath(path), reason, frame, line  # type: ignore[call-overload]

    def __str__(self) -> str:
        where = [str(self.path)]
        where += [] if self.frame is None else [f"frame {self.frame}"]
        where += [] if self.line is None else [f"line {self.line}"]
        return printable(f"{', '.join(where)}: {self.reason}")


FileError.__module__ = "pypw85"
# Makes the error of a file from a sentence
Error = Callable[[str], FileError]


def for_option(names: Iterable[str]) -> str:
    """Names of columns or types as the value of an option, which a shell takes as one word. `names_of_option` reads it."""
    return shlex.quote(",".join('"' + name.replace('"', '""') + '"' if "," in name or name.startswith('"') else name for name in names))


def names_of_option(text: str) -> list[str]:
    """The names that an option lists. A name with a comma is in quotation marks, as in CSV."""
    try:
        return next(csv.reader([text]), []) or [""]
    except csv.Error:  # of a line feed
        return text.split(",")


def guarded(function: Function) -> Function:
    """Decorator for functions (path, ...) that read a file by a library. Turns its exceptions, of any type, into FileError."""

    @functools.wraps(function)
    def run(path: os.PathLike[str], *others: Any) -> Any:
        try:
            return function(path, *others)
        except (FileError, FileNotFoundError, PermissionError, ImportError):
            raise
        except (ArithmeticError, AttributeError, LookupError, OSError, RuntimeError, TypeError, ValueError) as error:
            reason = str(error).splitlines() or [type(error).__name__]
            raise FileError(path, f"cannot be read ({reason[0]}): the file is broken; write it again") from None
        except MemoryError:  # also of a number of bytes that is damaged
            raise FileError(path, "needs more memory than there is: it is too large for this machine, or broken; write it again") from None

    return cast("Function", run)
