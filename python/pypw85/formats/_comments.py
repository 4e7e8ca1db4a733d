# SPDX-License-Identifier: BSD-3-Clause
"""Sentences in files, such as comments and attributes, that say what the numbers mean. They are not read as options, but a file is refused
if one of them contradicts what is taken."""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Callable, Iterable

from ._errors import FileError


class Meaning(NamedTuple):
    """Meanings that neither an option nor the name of a column says: "radii" or "diameters", the order of quaternions,
    the unit of angles, and whether angles of ellipses are counted from x towards y. Empty or false for what is said, or not there."""

    lengths: str = ""
    order: str = ""
    unit: str = ""
    is_from_x: bool = False


_NUMBER = r"\W*[-+]?\.?\d"
# Words that ask for another meaning, whether that is a contradiction, and what helps. Texts that name both meanings say neither.
_CLAIMS: list[tuple[str, str, Callable[[Meaning], bool], str]] = [
    (r"\bx[\s,]*y[\s,]*z[\s,]*w\b|\bi[\s,]*j[\s,]*k[\s,]*[wr]\b|\b(scalar|real|w)( part)?[\s-]*last", r"\bw[\s,]*x[\s,]*y[\s,]*z\b|first",
     lambda one: one.order == "wxyz", "say the order (--quaternion)"),
    (r"\bw[\s,]*x[\s,]*y[\s,]*z\b|\b[wr][\s,]*i[\s,]*j[\s,]*k\b|\b(scalar|real|w)( part)?[\s-]*first", r"\bx[\s,]*y[\s,]*z[\s,]*w\b|last",
     lambda one: one.order == "xyzw", "say the order (--quaternion)"),
    (r"diameter|\b(full|whole)[\s-]+(\w+[\s-]+)?(ax[ei]s|lengths?|widths?)", r"radi(us|i)|semi|half",
     lambda one: one.lengths == "radii", "say what the lengths are (--lengths)"),
    (r"\bradi(us|i)|\bsemi|\bhalf", r"diameter|full|whole", lambda one: one.lengths == "diameters", "say what the lengths are (--lengths)"),
    (r"\bradians?\b", r"degree", lambda one: one.unit == "degrees", "say the unit (--angle)"),
    (r"\bdegrees?\b", r"radian", lambda one: one.unit == "radians", "say the unit (--angle)"),
    (r"(?<!counter)(?<!counter[\s-])(?<!anti)(?<!anti[\s-])clockwise|"
     r"\b(angle|orientation|counted|measured|azimuth)\w*\b.*\bfrom (the )?(north|y\b(?!\s*=))", r"$.", lambda one: one.is_from_x,
     "say from where angles are counted (--angle-zero, and --angle-sense yx if they grow from y towards x)"),
    (r"(\b|_)(scal(e|ing)|(pixel|voxel)[\s_-]*size|spacing|resolution|magnification|(add|axis)[\s_-]*offset|\w*factor|exponents?|power|"
     rf"blockiness|dilat(ion|ed)|inflat(ion|ed)|roundness|n[\s_-]*sigma|confidence([\s_-]*level)?)\w*{_NUMBER}|"
     r"\bsuper[\s-]?(quadric|ellips)", r"$.", lambda one: True, "convert the numbers, and remove it"),
]  # fmt: skip


def check(texts: Iterable[str], meaning: Meaning, error: Callable[[str], FileError]) -> None:
    """Refuses texts that contradict what is taken."""
    for text in texts:
        for claim, other, contradicts, cure in _CLAIMS:
            if contradicts(meaning) and re.search(claim, text, re.IGNORECASE) and not re.search(other, text, re.IGNORECASE):
                raise error(f"'{text[:80]}' could mean that the numbers are others than those taken here, and is not read: {cure}")
