# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C: work that can be kept is finished and written; all other work ends at once."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator

from ..formats import discard_unfinished

_asked, _keeping = threading.Event(), threading.Event()
# Seconds for the thread that works to end by itself, and to clear up where it has ended processes that shared the work.
_SHORT, _LONG = 0.5, 5.0
# Seconds within which signals belong together: timeout(1) sends one to the process, and one more to its group.
_TOGETHER = 0.2


def is_interrupted() -> bool:
    """Returns whether the user pressed Ctrl-C."""
    return _asked.is_set()


@contextlib.contextmanager
def keeping_work() -> Iterator[None]:
    """Within this, Ctrl-C waits for the thread that works: it gets a KeyboardInterrupt, and writes what it has."""
    _keeping.set()
    try:
        yield
    finally:
        _keeping.clear()


def shield_processes() -> None:
    """Blocks Ctrl-C for the processes that this thread will start. Each of them would print an error."""
    if hasattr(signal, "pthread_sigmask"):  # not on Windows
        from multiprocessing import resource_tracker

        resource_tracker.ensure_running()  # now, since that takes the signal out of the mask
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


def interrupt(finished: threading.Event) -> None:
    """Lets the thread that works come to its end; if that takes too long, or Ctrl-C comes once more, ends the process."""
    since = time.monotonic()
    _asked.set()
    processes = multiprocessing.active_children()
    again = True
    while again:
        try:
            for process in processes:
                process.kill()
            finished.wait(None if _keeping.is_set() else _LONG if processes else _SHORT)
            again = False
        except KeyboardInterrupt:
            again = time.monotonic() - since < _TOGETHER
    if not finished.is_set():
        discard_unfinished()
        sentence = "\n" * sys.stderr.isatty() + "pw85: interrupted\n"
        os.write(2, sentence.encode())
        os._exit(130)
