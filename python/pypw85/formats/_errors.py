"""What is wrong with a file, where, and what helps."""

from __future__ import annotations

import os


class FileError(ValueError):
    """A file cannot be used.

    Attributes
    ----------
    path : str
    reason : str
        One sentence, with a cure where there is one.
    frame, line : int or None
        Where: frames count from 0, lines from 1.
    """

    def __init__(self, path: object, reason: str, frame: int | None = None, line: int | None = None) -> None:
        super().__init__(path, reason, frame, line)
        self.path, self.reason, self.frame, self.line = os.fspath(path), reason, frame, line  # type: ignore[call-overload]

    def __str__(self) -> str:
        where = [str(self.path)]
        where += [] if self.frame is None else [f"frame {self.frame}"]
        where += [] if self.line is None else [f"line {self.line}"]
        return f"{', '.join(where)}: {self.reason}"


FileError.__module__ = "pypw85"
