# SPDX-License-Identifier: BSD-3-Clause
"""Tables of reference data as files: rows are dictionaries of texts by the names of the columns."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TypeVar

State = TypeVar("State")


def read(path: Path) -> list[dict[str, str]]:
    """Empty if there is no such file."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(path: Path, rows: Iterable[dict[str, str]]) -> None:
    """The file is replaced as a whole, so that an interrupted program leaves the one before."""
    rows, temporary = list(rows), path.with_suffix(".part")
    with temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    temporary.replace(path)


def complete(
    path: Path, states: Sequence[State], rows: dict[State, dict[str, str]], measure: Callable[[State], dict[str, str]]
) -> Iterator[tuple[State, dict[str, str]]]:
    """Measures the states that the rows of a table lack, and writes the table after each, in the order of the states."""
    for state in states:
        if state not in rows:
            rows[state] = measure(state)
            write(path, (rows[one] for one in states if one in rows))
            yield state, rows[state]
