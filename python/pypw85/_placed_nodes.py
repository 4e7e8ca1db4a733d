# SPDX-License-Identifier: BSD-3-Clause
"""Files of finite elements that place nodes elsewhere than their coordinates say. meshio does not read that: such files are refused."""

from __future__ import annotations

import re

# Abaqus (Keywords Guide): instances of parts with a translation or a rotation, systems of coordinates, nodes that are generated, and
# other files. Nastran (Quick Reference Guide): points whose third field names a system of coordinates, in its three forms, defaults of
# such fields, and other files.
_OF_ABAQUS = re.compile(rb"^(\*instance)\b[^\n]*\n(?:\*\*[^\n]*\n)*[ \t]*[-+.\d]|"
                        rb"^(\*(?:system|transform|ngen|nfill|ncopy|nmap|elgen|elcopy|include))\b|"
                        rb"^(\*node)\b[^\n]*\b(?:system|input)\s*=", re.IGNORECASE | re.MULTILINE)  # fmt: skip
_OF_NASTRAN = re.compile(rb"^(grid)\*?\s*,[^,\n]*,\s*[1-9]|^(grid) {4}.{8} {0,7}[1-9]|^(grid\*) {3}.{16} {0,15}[1-9]|"
                         rb"^(grdset|include)\b", re.IGNORECASE | re.MULTILINE)  # fmt: skip
_END_OF_NASTRAN = re.compile(rb"^[ \t]*ENDDATA", re.MULTILINE)
_PATTERNS = {".inp": _OF_ABAQUS, ".bdf": _OF_NASTRAN, ".fem": _OF_NASTRAN, ".nas": _OF_NASTRAN}


def refuse_placed_nodes(path: str, ending: str) -> None:
    """Refuses a file in which coordinates are not those of the mesh."""
    if ending not in _PATTERNS:
        return
    with open(path, "rb") as file:
        content = file.read()
    if _PATTERNS[ending] is _OF_NASTRAN and not _END_OF_NASTRAN.search(content):
        raise ValueError("the file ends without ENDDATA: it is truncated; write it again")
    if found := _PATTERNS[ending].search(content):
        word = next(filter(None, found.groups())).decode("latin-1")
        line = content.count(b"\n", 0, found.start()) + 1
        raise ValueError(f"line {line}: {word} places or adds nodes in a way that is not read: write "
                         "the triangles alone, as STL, OBJ or PLY")  # fmt: skip
