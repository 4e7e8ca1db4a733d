# SPDX-License-Identifier: BSD-3-Clause
"""Words of messages that depend on a number."""

from __future__ import annotations


def counted(count: int, one: str, many: str = "") -> str:
    """A number and what is counted: "1 particle", "2 particles". `many` is the plural where it is not `one` with an s."""
    return f"{count} {one if count == 1 else many or one + 's'}"
