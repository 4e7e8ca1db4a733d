"""A line on stderr for what takes longer than a second."""

from __future__ import annotations

import contextlib
import sys
import threading
from typing import Iterator, Optional

from tqdm import tqdm


class Progress:
    """What is done now, how much is done, and of how much."""

    def __init__(self, unit: str, total: Optional[int]) -> None:
        self.text, self.done, self.unit, self.total = "", 0, unit, total

    def stage(self, text: str) -> None:
        self.text = text


@contextlib.contextmanager
def progress(unit: str, total: Optional[int] = None) -> Iterator[Progress]:
    """Another thread draws it, so that time goes on while nothing else does."""
    state, finished = Progress(unit, total), threading.Event()
    thread = threading.Thread(target=_draw, args=(state, finished), daemon=True)
    thread.start()
    try:
        yield state
    finally:
        finished.set()
        thread.join()


def _draw(state: Progress, finished: threading.Event) -> None:
    if finished.wait(1.0):
        return
    with tqdm(total=state.total, unit=f" {state.unit}", file=sys.stderr, leave=False) as bar:
        while not finished.wait(0.5):
            bar.n = state.done
            bar.set_description_str(state.text)


def say(line: str) -> None:
    """Prints a line without damage to a progress bar."""
    tqdm.write(line)
