# SPDX-License-Identifier: BSD-3-Clause
"""Meshes in the Object File Format of Geomview (its manual, section "OFF Files"), as text.

Behind x y z, rows of vertices may have normals, colours and texture coordinates, and rows of faces colours behind their vertices. These
are left out.
"""

from __future__ import annotations

import itertools
import re
from typing import Any
from collections.abc import Iterator

import numpy as np

_KEYWORD = re.compile(r"(ST)?C?N?OFF")
_WHOLE = re.compile(r"[0-9]{1,9}")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.ASCII | re.IGNORECASE)
_KINDS = {3: "triangle", 4: "quad"}

Row = tuple[int, list[str]]


def read_off(path: str) -> Any:
    import meshio

    with open(path, encoding="utf-8-sig", errors="replace") as file:
        rows = _rows(file)
        vertices, faces = _counts(rows)
        points = [_vertex(row) for row in itertools.islice(rows, vertices)]
        polygons = [_face(row) for row in itertools.islice(rows, faces)]
        if len(points) < vertices or len(polygons) < faces:
            raise ValueError(f"the file ends after {len(points)} of {vertices} vertices and {len(polygons)} of {faces} faces: it is "
                             "truncated; write it again")  # fmt: skip
        if (more := next(rows, None)) is not None:
            raise ValueError(f"line {more[0]}: there are more rows than those of {vertices} vertices and {faces} faces: correct these "
                             "numbers")  # fmt: skip
    cells = [(_KINDS.get(sides, "polygon"), np.array(list(same))) for sides, same in itertools.groupby(polygons, len)]
    return meshio.Mesh(np.array(points).reshape(-1, 3), cells)


def _rows(file: Any) -> Iterator[Row]:
    """The words of lines that are neither blank nor a comment, and the numbers of these lines."""
    for number, line in enumerate(file, 1):
        if words := line.partition("#")[0].split():
            yield number, words


def _counts(rows: Iterator[Row]) -> tuple[int, int]:
    """The numbers of vertices and faces, which may stand behind the keyword."""
    number, words = next(rows, (1, [""]))
    if not _KEYWORD.fullmatch(words[0]) or "BINARY" in words:
        raise ValueError(f"line {number}: the file must begin with OFF, COFF, NOFF or STOFF and be text, and begins with "
                         f"'{' '.join(words)[:40]}': four coordinates, other dimensions and binary files are not read")  # fmt: skip
    number, words = (number, words[1:]) if len(words) > 1 else next(rows, (number, []))
    if len(words) not in (2, 3) or not all(map(_WHOLE.fullmatch, words)):
        raise ValueError(f"line {number}: the numbers of vertices, faces and edges must be here, not '{' '.join(words)[:80]}'")
    return int(words[0]), int(words[1])


def _vertex(row: Row) -> list[float]:
    number, words = row
    if len(words) < 3 or not all(map(_NUMBER.fullmatch, words[:3])):
        raise ValueError(f"line {number}: a vertex must begin with three numbers, not '{' '.join(words)[:80]}'")
    return [float(word) for word in words[:3]]


def _face(row: Row) -> list[int]:
    number, words = row
    sides = int(words[0]) if _WHOLE.fullmatch(words[0]) else 0
    if sides < 3 or len(words) <= sides or not all(map(_WHOLE.fullmatch, words[1 : 1 + sides])):
        raise ValueError(f"line {number}: a face must begin with the number of its vertices, three or more, and these, not "
                         f"'{' '.join(words)[:80]}'")  # fmt: skip
    return [int(word) for word in words[1 : 1 + sides]]
