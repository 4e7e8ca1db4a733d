"""Names of types: what they are, and which of them a format can hold."""

from __future__ import annotations

import re
from typing import Any
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .._system import System
from ._errors import printable

# As for names of files. Arrays have room for the longest name in every row, so that one long name would take much memory.
LONGEST = 255
# Whole numbers as Python writes them, within 64 bits: only these are the same after they were read as numbers.
_WHOLE = re.compile(r"0|-?[1-9][0-9]{0,17}")


def type_names(system: System) -> NDArray[np.str_]:
    """Types as text."""
    types: NDArray[Any] = system.types
    return np.char.decode(types, "utf-8") if types.dtype.kind == "S" else types.astype(np.str_)


def numbers_if_all_are(names: NDArray[Any]) -> NDArray[Any]:
    """Names as whole numbers, if all are: "007" and "7" remain two names."""
    if names.dtype.kind == "U" and all(map(_WHOLE.fullmatch, np.unique(names).tolist())):
        return names.astype(np.int64)
    return names


# What names a format can hold: a test, and what is wrong with a name that does not pass it.
Rule = tuple[Callable[[str], Any], str]

_VALID: Rule = (lambda name: not re.search("[\0\ud800-\udfff]", name), "is no valid Unicode, or contains a null")
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
    for name in np.unique(names).tolist():
        for allows, cause in (_VALID, _SHORT, *rules):
            if not allows(name):
                shown = name if len(name) <= 40 else name[:40] + "…"
                raise ValueError(f"the type '{printable(shown)}' {cause}: give it another name")
    return names
