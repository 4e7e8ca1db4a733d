# SPDX-License-Identifier: BSD-3-Clause
"""Names of types: what they are, and which of them a format can hold."""

from __future__ import annotations

import re
from typing import Any
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .._system import System
from .._words import printable

# Arrays of strings have room for the longest name in every row, so a long name would need much memory. 255 is the limit for names
# of files, too.
LONGEST = 255
# Whole numbers as Python writes them, within 64 bits. Only these keep their spelling when they are read as numbers.
_WHOLE = re.compile(r"0|-?[1-9][0-9]{0,17}")


def type_names(system: System) -> NDArray[np.str_]:
    """Types as text."""
    types: NDArray[Any] = system.types
    return np.char.decode(types, "utf-8") if types.dtype.kind == "S" else types.astype(np.str_)


def numbers_if_all_are(names: NDArray[Any]) -> NDArray[Any]:
    """Converts names to whole numbers if all are such; "007" and "7" remain two names."""
    if names.dtype.kind == "U" and all(map(_WHOLE.fullmatch, np.unique(names).tolist())):
        return names.astype(np.int64)
    return names


# A rule for the names that a format can store: a test, and the error for a name that fails it
Rule = tuple[Callable[[str], Any], str]

_VALID: Rule = (lambda name: not re.search("[\0\ud800-\udfff]", name), "is not valid Unicode, or contains a null")
_SHORT: Rule = (lambda name: len(name) <= LONGEST, f"has more than {LONGEST} characters")
PRINTED: Rule = (str.isprintable, "has characters that cannot be printed")
ONE_WORD: Rule = (lambda name: name.split() == [name], "is empty or has a blank, which separates columns in this format")


def checked_names(system: System, *rules: Rule) -> NDArray[np.str_]:
    """Types as text, none of which breaks a rule.

    Raises
    ------
    ValueError
        One does.
    """
    names = type_names(system)
    for name in map(str, np.unique(names)):
        for allows, cause in (_VALID, _SHORT, *rules):
            if not allows(name):
                shown = name if len(name) <= 40 else name[:40] + "…"
                raise ValueError(f"the type '{printable(shown)}' {cause}: give it another name")
    return names
