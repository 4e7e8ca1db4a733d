# SPDX-License-Identifier: BSD-3-Clause
"""Faces of a file that would be left out of its mesh: such files are refused."""

from __future__ import annotations

import re
from typing import Any
from collections.abc import Sequence

# Cells of surfaces that are not read, by their names in meshio: curved ones, and those of VTK
_OTHER_FACES = re.compile(r"(triangle|quad|polygon)\d+|pixel|triangle_strip|VTK_LAGRANGE_(TRIANGLE|QUADRILATERAL)")
# Where files of VTK say how many cells they have. meshio 5 leaves out strips of triangles, and of several pieces all but one.
_COUNTS = {".vtu": re.compile(rb"<Piece\b[^>]*\bNumberOfCells\s*=\s*[\"']\s*(\d{1,18})"),
           ".vtk": re.compile(rb"^CELL_TYPES\s+(\d{1,18})", re.MULTILINE)}  # fmt: skip
# Parts of files whose nodes are counted from 1 again: meshio leaves all zones of Tecplot but the first out, and mixes parts of Abaqus.
_ZONE, _PART = (re.compile(word, re.IGNORECASE | re.MULTILINE) for word in (rb"^[ \t]*ZONE\b", rb"^\*PART\b"))
_PARTS = {".tec": (_ZONE, "zones"), ".dat": (_ZONE, "zones"), ".inp": (_PART, "parts")}


def refuse_lost_cells(path: str, ending: str, blocks: Sequence[Any]) -> None:
    """Refuses a file with faces that are not in the blocks of cells that meshio returns, or that are of a kind which is not read."""
    if others := sorted({block.type for block in blocks if _OTHER_FACES.fullmatch(block.type)}):
        raise ValueError(f"{path}: the cells {' '.join(others)} are faces that are not read: write triangles, quadrilaterals or polygons")
    if ending not in (*_COUNTS, *_PARTS):
        return
    with open(path, "rb") as file:
        content = file.read()
    pattern, parts = _PARTS.get(ending, (_ZONE, ""))
    if parts and (count := len(pattern.findall(content))) > 1:
        raise ValueError(f"{path} has {count} {parts}, and only one is read: write the triangles of all in one, or as STL, OBJ or PLY")
    wanted = sum(map(int, _COUNTS[ending].findall(content))) if ending in _COUNTS else 0
    there = sum(len(block.data) for block in blocks)
    if there < wanted:
        raise ValueError(f"{path}: {wanted - there} of {wanted} cells are in strips or in other pieces, which are not read: write one "
                         "piece of triangles, quadrilaterals or polygons")  # fmt: skip
