# SPDX-License-Identifier: BSD-3-Clause
"""A line that shows the progress of work that takes longer than a second, on terminals, if tqdm is installed."""

from __future__ import annotations

import contextlib
import os
import sys
import threading
from typing import TextIO
from collections.abc import Callable, Iterator

from ..formats import STANDARD_OUTPUT
from ._interruption import is_interrupted

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None


@contextlib.contextmanager
def progress() -> Iterator[Callable[[str], None]]:
    """Yields a function that takes a description of the current work, and raises KeyboardInterrupt after Ctrl-C.

    Another thread shows it: the time advances while nothing else happens.
    """
    stage, finished = ["starting"], threading.Event()
    thread = threading.Thread(target=_show, args=(stage, finished), daemon=True)
    if tqdm is not None and sys.stderr.isatty():
        thread.start()

    def change(text: str) -> None:
        stage[0] = text
        if is_interrupted():
            raise KeyboardInterrupt

    try:
        yield change
    finally:
        finished.set()
        if thread.is_alive():
            thread.join()


def _show(stage: list[str], finished: threading.Event) -> None:
    if finished.wait(1.0):
        return
    with tqdm(bar_format="{desc} [{elapsed}]", file=sys.stderr, leave=False) as bar:
        while not finished.wait(0.5):
            bar.set_description_str(stage[0])


def beside(output: str) -> TextIO:
    """The stream for a sentence about an output, which is not that output, by whatever name."""
    return sys.stderr if output == STANDARD_OUTPUT or _is_standard_output(output) else sys.stdout


def _is_standard_output(path: str) -> bool:
    try:
        return os.path.samestat(os.stat(path), os.fstat(1))
    except OSError:
        return False


def say(line: str, to: TextIO | None = None) -> None:
    """Prints a line, to stdout by default, without damage to the line of the progress."""
    stream = to or sys.stdout
    if tqdm is None:
        print(line, file=stream, flush=True)
    else:
        tqdm.write(line, stream)
        stream.flush()  # or tqdm would, in the thread that shows progress, for which a closed pipe is an error
