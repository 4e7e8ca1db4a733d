# SPDX-License-Identifier: BSD-3-Clause
"""Words that callers pass. One that an option does not have is refused: the message has the argument, what is allowed, and the value."""

from __future__ import annotations

from typing import Any, TypeVar
from collections.abc import Iterable, Sequence

import numpy as np

from ._words import shown

Choice = TypeVar("Choice", str, int)


def choice(value: Any, name: str, allowed: Iterable[Choice]) -> Choice:
    """One of the words, or of the integers, that are allowed."""
    choices = list(allowed)
    for one in choices:
        if isinstance(value, (str, int, np.integer)) and not isinstance(value, bool) and value == one:
            return one
    raise ValueError(f"{name} must be {listed(choices)}, not {shown(value)}")


def listed(choices: Sequence[str | int]) -> str:
    """Alternatives in a message: "'a', 'b' or 'c'", "2 or 3"."""
    words = list(map(repr, choices))
    return " or ".join(filter(None, [", ".join(words[:-1]), words[-1]]))


def names_of(value: Any, name: str, counts: Sequence[int] = ()) -> list[str]:
    """Names as a list, of one of these lengths if there are such. One text is not a list of names."""
    names = None if isinstance(value, (str, bytes)) else _as_list(value)
    if names is None or not all(isinstance(one, str) for one in names) or (counts and len(names) not in counts):
        count = f"{listed(counts)} names" if counts else "names"
        raise ValueError(f"{name} must be a list of {count}, not {shown(value)}")
    return [str(one) for one in names]


def _as_list(value: Any) -> list[Any] | None:
    try:
        return list(value)
    except TypeError:
        return None
