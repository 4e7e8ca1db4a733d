# SPDX-License-Identifier: BSD-3-Clause
"""Words of messages that depend on a number or a value."""

from __future__ import annotations

import reprlib
from typing import Any

import numpy as np

# Values whose text is short and says what they are. Of others a message has the type.
_SHOWN = (str, bytes, bool, int, float, complex, list, tuple, dict)


def counted(count: int, one: str, many: str = "") -> str:
    """A number and what is counted: "1 particle", "2 particles". `many` is the plural where it is not `one` with an s."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def shown(value: Any) -> str:
    """A value in a message, short and on one line."""
    if isinstance(value, np.ndarray) and value.ndim:
        return f"an array of {value.dtype}"
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.item()
    text = reprlib.repr(value) if value is None or isinstance(value, _SHOWN) else ""
    return text if text and "array(" not in text and "<" not in text else type(value).__qualname__


def printable(text: str) -> str:
    """Escapes control characters, so that text from a file neither breaks a line nor controls a terminal."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)
