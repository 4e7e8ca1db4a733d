# SPDX-License-Identifier: BSD-3-Clause
"""Triangles of files, by meshio: what its readers do not know of is put into the form that they read, or refused."""

from __future__ import annotations

import contextlib
import io
import os
import re
import tempfile
from typing import Any
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from ._lost_cells import refuse_lost_cells
from ._off import read_off
from ._placed_nodes import refuse_placed_nodes
from ._ply import Element, Header, Property, check_end, end_of, read_header, rows_of
from ._typing import Floats
from ._words import printable

Path = str | os.PathLike[str]
_HEADER_OF_STL = 84
_TRIANGLE_OF_STL = 50
# Cells that are read, by their names in meshio
_FACES = ("triangle", "quad", "polygon")
# Points and tetrahedra of TetGen
_WITHOUT_FACES = (".node", ".ele")


def read_triangles(path: Path) -> tuple[Floats, NDArray[np.int64]]:
    """Points and triangles of a file.

    Raises
    ------
    ValueError
        The file does not have the format of its name, or has no triangles; with its name, and the line where there are lines.
    """
    name = os.fspath(path)
    os.stat(name)  # meshio has errors of its own for files that are not there
    said = io.StringIO()  # meshio prints some of its errors, and ends the program
    try:
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
            content = _reader(name)(name)
    except (FileNotFoundError, PermissionError, IsADirectoryError):
        raise
    except (Exception, SystemExit) as error:
        reason = " ".join((said.getvalue() or str(error)).split()).rstrip(".") or type(error).__name__
        raise ValueError(printable(f"{name}: {reason.removeprefix(f'{name}, ')}")) from None
    points = np.asarray(content.points, dtype=np.float64)
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.pad(points, ((0, 0), (0, 1)))
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"{name}: points must have three coordinates, and the array of them has the shape {points.shape}: correct it")
    refuse_lost_cells(name, os.path.splitext(name)[1].lower(), content.cells)
    blocks = [np.asarray(block.data, dtype=np.int64) for block in content.cells if block.type in _FACES]
    _check_vertices(name, len(points), blocks)
    if not blocks:
        kinds = sorted({block.type for block in content.cells})
        raise ValueError(f"{name} has no triangles" + (f", but {', '.join(kinds)}" if kinds else ""))
    return points, np.concatenate([triangles_of(points, block) for block in blocks])


def _reader(name: str) -> Callable[[str], Any]:
    """The function that reads a file by the end of its name."""
    import meshio

    ending = os.path.splitext(name)[1].lower()
    if ending in _READERS:
        return _READERS[ending]
    if ending in _WITHOUT_FACES or ending not in meshio.extension_to_filetypes:
        raise ValueError(f"files of the kind '{ending}' are not read: convert it to STL, OBJ, PLY or OFF")
    refuse_placed_nodes(name, ending)
    return meshio.read  # type: ignore[no-any-return]


def _check_vertices(name: str, count: int, blocks: list[NDArray[np.int64]]) -> None:
    """Refuses faces with too few vertices, or with an index that is out of range, in any corner."""
    for polygons in blocks:
        if len(polygons) and polygons.shape[1] < 3:
            raise ValueError(f"{name}: a face must have three or more vertices, not {polygons.shape[1]}: correct it")
        wrong = ((polygons < 0) | (polygons >= count)).any(axis=1)
        if wrong.any():
            face = polygons[wrong.argmax()].tolist()
            raise ValueError(f"{name}: the face {face} must have indices of the {count} vertices, counted from 0")


def triangles_of(points: Floats, polygons: NDArray[np.int64]) -> NDArray[np.int64]:
    """Triangles (m, 3) of polygons (n, k) in their order: fans of convex ones; others are cut along diagonals inside of them."""
    count, sides = polygons.shape
    if sides == 3 or not count:
        return polygons if count else np.empty((0, 3), np.int64)
    corners = points[polygons]
    edges = np.roll(corners, -1, axis=1) - corners
    normals = np.cross(corners - corners[:, :1], edges).sum(axis=1)
    turns = np.einsum("nki,ni->nk", np.cross(np.roll(edges, 1, axis=1), edges), normals)
    fan = np.array([(0, k, k + 1) for k in range(1, sides - 1)])
    places = np.tile(fan, (count, 1, 1))
    for row in np.flatnonzero((turns < 0).any(axis=1)):
        flat = np.delete(corners[row], np.abs(normals[row]).argmax(), axis=1)
        places[row] = _cut(flat * [1, _area(flat)])
    cut: NDArray[np.int64] = polygons[np.arange(count)[:, None, None], places].reshape(-1, 3)
    return cut


def _area(corners: Floats) -> float:
    """The sign of the area of a polygon in the plane: 1 if it turns left."""
    x, y = corners.T
    return float(np.sign(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _cut(corners: Floats) -> list[tuple[int, ...]]:
    """Triangles of a polygon in the plane that turns left: cuts off one corner after the other that has no other corner inside."""
    left = list(range(len(corners)))
    cut = []
    while len(left) > 3:
        ears = ((left[k - 1], left[k], left[(k + 1) % len(left)]) for k in range(len(left)))
        ear = next((one for one in ears if _is_ear(corners, left, one)), tuple(left[:3]))
        cut.append(ear)
        left.remove(ear[1])
    return [*cut, tuple(left)]


def _is_ear(corners: Floats, left: list[int], ear: tuple[int, ...]) -> bool:
    a, b, c = corners[list(ear)]
    others = corners[[k for k in left if k not in ear]]

    def side(start: Floats, end: Floats, points: Floats) -> Any:
        return (end[0] - start[0]) * (points[..., 1] - start[1]) - (end[1] - start[1]) * (points[..., 0] - start[0])

    inside = (side(a, b, others) >= 0) & (side(b, c, others) >= 0) & (side(c, a, others) >= 0)
    return bool(side(a, b, c) > 0 and not inside.any())


_COORDINATE = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?|[-+]?(nan|inf)\w*", re.ASCII | re.IGNORECASE)


def _obj(path: str) -> Any:
    """Only vertices and faces, without the numbers of textures and normals, which meshio takes for data of vertices."""
    import meshio

    with open(path, encoding="utf-8-sig", errors="replace") as file:
        return meshio.read(io.StringIO("".join(_plain_obj(file))), file_format="obj")


def _plain_obj(file: io.TextIOWrapper) -> Iterator[str]:
    vertices, whole = 0, ""
    for number, line in enumerate(file, 1):
        whole += line.partition("#")[0].strip()
        if whole.endswith("\\"):
            whole = whole[:-1] + " "
            continue
        words, whole = whole.split(), ""
        if words[:1] == ["v"]:
            vertices += 1
            if len(words) < 4 or not all(map(_COORDINATE.fullmatch, words[1:4])):
                raise ValueError(f"line {number}: a vertex must have three numbers with decimal points, not '{' '.join(words[1:])[:80]}'")
            if len(words) == 5 and _COORDINATE.fullmatch(words[4]) and float(words[4]) != 1:
                raise ValueError(f"line {number}: a vertex has the weight {words[4][:40]} behind its coordinates, which is not read: "
                                 "divide them by it if it is a homogeneous coordinate, and remove it")  # fmt: skip
            yield f"v {' '.join(words[1:4])}\n"
        elif words[:1] in (["f"], ["fo"]):
            yield f"f {' '.join(map(str, _face(words[1:], vertices, number)))}\n"
        elif words[:1] in (["call"], ["csh"]):
            raise ValueError(f"line {number}: the file includes another one, which is not read: write both to one file")
        elif words[:1] in (["surf"], ["curv"]):
            raise ValueError(f"line {number}: free-form surfaces have no triangles: write polygons")


def _face(words: list[str], vertices: int, number: int) -> list[int]:
    """The vertices of a face, counted from 1. Negative numbers count from the last vertex before it."""
    indices = [int(word.split("/")[0]) if re.fullmatch(r"-?\d{1,9}(/-?\d*){0,2}", word) else 0 for word in words]
    indices = [vertices + 1 + index if index < 0 else index for index in indices]
    if len(indices) < 3 or min(indices) < 1:
        raise ValueError(f"line {number}: a face must have three or more numbers of vertices, not '{' '.join(words)[:80]}'")
    return indices


def _stl(path: str) -> Any:
    """Binary files go to meshio as they are, text in small letters and without what is between the vertices."""
    import meshio

    size = os.path.getsize(path)
    with open(path, "rb") as file:
        start = file.read(_HEADER_OF_STL)
        count = int.from_bytes(start[-4:], "little")
        if size == _HEADER_OF_STL + _TRIANGLE_OF_STL * count and size > _HEADER_OF_STL:
            return meshio.stl.read(path)
        text = start + file.read()
    text = text.removeprefix(b"\xef\xbb\xbf")  # a byte order mark
    if b"\0" in start or not text.lstrip()[:5].lower() == b"solid":
        raise ValueError(f"a binary STL file of {count} triangles must have {_HEADER_OF_STL + _TRIANGLE_OF_STL * count} bytes, not "
                         f"{size}: it is truncated, or not an STL file; write it again")  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "plain.stl")
        with open(plain, "w", encoding="ascii") as out:
            out.writelines(_plain_stl(text.decode("latin-1").lower()))
        return meshio.stl.read(plain)


def _plain_stl(text: str) -> Iterator[str]:
    yield "solid\n"
    corners = 3
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if words[:1] == ["facet"] or "".join(words[:2]) == "endsolid":
            if corners != 3:
                raise ValueError(f"line {number}: the facet before must have 3 vertices, not {corners}: correct it")
            corners = 0 if words[0] == "facet" else 3
            yield "facet normal 0 0 0\n" * (words[0] == "facet")
        elif words[:1] == ["vertex"]:
            corners += 1
            yield f"vertex {' '.join(words[1:])}\n"
            if len(words) != 4:
                raise ValueError(f"line {number}: a vertex must have three numbers, not '{line.strip()[:80]}'")
    if corners != 3:
        raise ValueError(f"line {number}: the file ends within a facet: it is truncated; write it again")
    yield "endsolid\n"


# Names of the list of the vertices of a face
_VERTICES = ("vertex_indices", "vertex_index")
# Names of types that meshio knows in text and in binary files
_NAMES = {"i1": "int8", "u1": "uint8", "i2": "short", "u2": "uint16", "i4": "int32", "u4": "uint32", "f4": "float32", "f8": "double"}


def _ply(path: str) -> Any:
    """Vertices and faces alone: elements before, between and behind them are left out. meshio wants the list called vertex_indices."""
    import meshio

    with open(path, "rb") as file:
        content = file.read()
    header = read_header(content)
    check_end(content, header)
    data, elements = _vertices_and_faces(content, header)
    faces = elements[-1]
    if missing := {"x", "y", "z"} - {one.name for one in elements[0].properties}:
        raise ValueError(f"the element vertex must have x, y and z, and has no {' '.join(sorted(missing))}: add it")
    if not header.order:
        elements, data = _ordered(content, header, elements, data)
    if header.order and faces.name == "face" and len(faces.properties) > 1:
        return _faces_with_properties(header.order, elements, data)
    plain = "\n".join(_plain_ply(header.order, elements)) + "\nend_header\n"
    try:
        return meshio.read(io.BytesIO(plain.encode() + data), file_format="ply")
    except meshio.ReadError as error:
        raise ValueError(str(error) or "meshio cannot read it") from None
    except IndexError:
        raise ValueError("a row has fewer numbers than the header says: the file is truncated, or broken; write it again") from None


def _vertices_and_faces(content: bytes, header: Header) -> tuple[bytes, list[Element]]:
    """The rows of vertices, and behind them those of faces, if there are any; and these elements."""
    wanted = [one for name in ("vertex", "face") if (one := header.element(name)) is not None]
    if not wanted or wanted[0].name == "face":
        raise ValueError(f"the file must have an element 'vertex', not only {' '.join(one.name for one in header.elements)[:200]}: add it")
    if header.element("tristrips") is not None:
        raise ValueError("the element tristrips has triangles in strips, which are not read: write faces")
    if header.elements[: len(wanted)] == wanted:
        return content[header.size :], wanted
    places, place = {}, header.size
    for element in header.elements:
        end = end_of(content, header, element, place)
        places[element.name] = slice(place, end)
        place = end
    return b"".join(content[places[one.name]] for one in wanted), wanted


def _ordered(content: bytes, header: Header, elements: list[Element], data: bytes) -> tuple[list[Element], bytes]:
    """Text in which vertices have x, y and z alone: meshio takes them for coordinates only if they are the first properties, in this
    order."""
    vertices = elements[0]
    if [one.name for one in vertices.properties][:3] == ["x", "y", "z"]:
        return elements, data
    rows = rows_of(content, header, "vertex")
    lines = (" ".join(map(repr, row)) for row in np.stack([rows[axis] for axis in "xyz"], axis=1).tolist())
    faces = data[end_of(data, header, vertices, 0) :]
    plain = Element("vertex", vertices.number, [Property(axis, "f8") for axis in "xyz"])
    return [plain, *elements[1:]], "".join(f"{line}\n" for line in lines).encode() + faces


def _faces_with_properties(order: str, elements: list[Element], data: bytes) -> Any:
    """Faces with a color, for instance, behind their vertices, which meshio misreads: they must all have as many vertices."""
    import meshio

    vertices, faces = elements
    points = vertices.row(order)
    start = vertices.number * points.itemsize
    kinds: list[Any] = []
    for k, one in enumerate(faces.properties):
        if one.length:
            place = start + np.dtype(kinds).itemsize
            sides = int(np.frombuffer(data, order + one.length, 1, place)[0]) if faces.number else 3
            kinds += [(f"count {k}", order + one.length), (one.name, order + one.kind, (sides,))]
        else:
            kinds.append((one.name, order + one.kind))
    rows = np.frombuffer(data, np.dtype(kinds), faces.number, start)
    for name, *_ in kinds:
        if name.startswith("count ") and (rows[name] != rows[name][0]).any():
            raise ValueError("faces with properties in addition to lists of vertices must all have the same number of vertices: "
                             "write the file without these properties")  # fmt: skip
    name = next(one for one in _VERTICES if one in (rows.dtype.names or ()))
    corners = np.frombuffer(data, points, vertices.number)
    cells = rows[name].reshape(faces.number, -1)
    kind = {3: "triangle", 4: "quad"}.get(cells.shape[1], "polygon")
    return meshio.Mesh(np.stack([corners[axis].astype(np.float64) for axis in "xyz"], axis=1), [(kind, cells.astype(np.int64))])


def _plain_ply(order: str, elements: list[Element]) -> Iterator[str]:
    yield "ply"
    yield {"": "format ascii 1.0", "<": "format binary_little_endian 1.0", ">": "format binary_big_endian 1.0"}[order]
    for element in elements:
        yield f"element {element.name} {element.number}"
        for k, one in enumerate(element.properties):
            if one.length and (k or element.name == "vertex"):
                before = [other.name for other in element.properties[:k]] if one.name in _VERTICES else []
                what = f"'{' '.join(before)}' before its vertices" if before else f"the list '{one.name}'"
                raise ValueError(f"the element {element.name} has {what}, and only the list of the vertices of a face is read: write the "
                                 f"file without {what if before else 'it'}")  # fmt: skip
            name = "vertex_indices" if one.length else one.name
            yield f"property {f'list {_NAMES[one.length]} ' if one.length else ''}{_NAMES[one.kind]} {name}"


_READERS = {".obj": _obj, ".stl": _stl, ".ply": _ply, ".off": read_off}
