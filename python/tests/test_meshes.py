# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes in Python."""

import struct
import sys
from fractions import Fraction

import numpy as np
import pytest

import pypw85

# A tetrahedron.
VERTICES = np.array([[0.0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.fixture
def ellipsoids(random_pairs):
    centers, q, _ = random_pairs(500)
    return centers, q


def corners(mesh, centers):
    """The vertices of all triangles relative to the centres: (n, m, 3 vertices, 3)."""
    return mesh.vertices[mesh.triangles] - centers[:, None, None, :]


def test_all_triangles(ellipsoids, assert_rows):
    """The least of all triangles, bit by bit as by single calls."""
    centers, q = ellipsoids
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    mu2, point, triangle = mesh.contact(centers, q)
    points = corners(mesh, centers)
    rows = np.arange(len(q))
    calls = [[pypw85.contact_triangle(*one, form) for one in row] for row, form in zip(points, q)]
    each, where = (np.array([[call[k] for call in row] for row in calls]) for k in range(2))
    assert_rows(mu2 == each.min(axis=1), centers, q)
    assert_rows(triangle == each.argmin(axis=1), centers, q)
    assert_rows((point == where[rows, triangle]).all(axis=1), centers, q)
    overlap = pypw85.overlap_triangle(points[:, :, 0], points[:, :, 1], points[:, :, 2], q[:, None])
    assert_rows(mesh.overlap(centers, q) == overlap.any(axis=1), centers, q)
    assert 0 < mesh.overlap(centers, q).sum() < len(q)


def test_distance_of_all_triangles(ellipsoids, assert_rows):
    """The least of all triangles, bit by bit as by single calls. The tetrahedron is closed, and its inside is three inequalities."""
    centers, q = ellipsoids
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    found = mesh.distance(centers, q)
    points = corners(mesh, centers)
    each = pypw85.distance_triangle(points[:, :, 0], points[:, :, 1], points[:, :, 2], q[:, None])
    rows, least = np.arange(len(q)), each[0].argmin(axis=1)
    assert_rows(found.triangle == least, centers, q)
    for one, all_triangles in zip(found, each):
        assert_rows((one == all_triangles[rows, least]).reshape(len(q), -1).all(axis=1), centers, q)
    inside = (centers > 0).all(axis=1) & (centers.sum(axis=1) < 4)
    assert_rows(found.inside == inside, centers, q)
    assert (pypw85.Mesh(VERTICES, TRIANGLES[1:]).distance(centers, q).inside == -1).all()


def test_distance_of_bad_rows():
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    centers, q = np.zeros((3, 3)), np.tile([1.0, 0, 0, 1, 0, 1], (3, 1))
    centers[1, 2], q[2, 0] = np.nan, -1
    with np.errstate(invalid="ignore"):
        found = mesh.distance(centers, q)
    assert np.isnan(found.distance).tolist() == [False, True, True]
    assert found.triangle.tolist()[1:] == [-1, -1] and found.inside.tolist()[1:] == [-1, -1]
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=r"Mesh\.distance"):
        mesh.distance(centers, q)
    none = pypw85.Mesh(np.empty((0, 3)), np.empty((0, 3), int)).distance(centers[:1], q[:1])
    assert none.distance == np.inf and none.triangle == -1 and none.inside == -1 and np.isnan(none.point1).all()


def ball_overlaps(center, square, a, b, c):
    """Whether a ball and a triangle overlap, in fractions: the nearest point by the regions of the triangle."""
    a, b, c = ([Fraction(x) - Fraction(y) for x, y in zip(vertex.tolist(), center)] for vertex in (a, b, c))
    dot = lambda x, y: sum(s * t for s, t in zip(x, y))  # noqa: E731
    minus = lambda x, y: [s - t for s, t in zip(x, y)]  # noqa: E731
    squares = [dot(x, x) for x in (a, b, c)]
    for x, y in ((a, b), (b, c), (c, a)):
        edge = minus(y, x)
        t = -dot(x, edge) / dot(edge, edge)
        if 0 < t < 1:
            squares.append(dot(x, x) - dot(x, edge) ** 2 / dot(edge, edge))
    e1, e2 = minus(b, a), minus(c, a)
    g11, g12, g22, d1, d2 = dot(e1, e1), dot(e1, e2), dot(e2, e2), -dot(a, e1), -dot(a, e2)
    s, t = ((d1 * g22 - d2 * g12) / (g11 * g22 - g12**2), (d2 * g11 - d1 * g12) / (g11 * g22 - g12**2))
    if s >= 0 and t >= 0 and s + t <= 1:
        squares.append(dot(a, a) - s * d1 - t * d2)
    return min(squares) < Fraction(square)


def test_overlap_in_fractions():
    """Balls that touch the mesh exactly, and by a last bit not; integers and quarters have no rounding errors."""
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    rng = np.random.default_rng(71)
    centers = np.repeat(rng.integers(-16, 33, (60, 3)) / 4.0, 3, axis=0)
    mu2 = mesh.contact(centers, np.tile([1.0, 0, 0, 1, 0, 1], (180, 1)))[0]
    squares = np.nextafter(mu2, np.tile([0.0, np.inf, 1e300], 60)) + np.tile([0.0, 0, 0], 60)
    squares[2::3] = mu2[2::3]
    good = squares > 0
    centers, squares = centers[good], squares[good]
    q = squares[:, None] * [1.0, 0, 0, 1, 0, 1]
    expected = [
        any(ball_overlaps(center.tolist(), square, *mesh.vertices[triangle]) for triangle in mesh.triangles)
        for center, square in zip(centers, squares)
    ]
    assert mesh.overlap(centers, q).tolist() == expected
    assert 40 < sum(expected) < len(expected) - 40


def test_bad_input():
    with pytest.raises(pypw85.PW85Error, match=r"Mesh: row 1: vertices must be finite, not \[0.0, nan, 0.0\]"):
        pypw85.Mesh([[0, 0, 0], [0, np.nan, 0]], [[0, 0, 0]])
    for index in (-1, 4, 2**40):
        with pytest.raises(pypw85.PW85Error, match="Mesh: row 1: triangles must have indices of vertices, not"):
            pypw85.Mesh(VERTICES, [[0, 1, 2], [0, index, 1]])
    with pytest.raises(ValueError, match="triangles must be integers"):
        pypw85.Mesh(VERTICES, [[0.0, 1, 2]])
    with pytest.raises(ValueError, match="triangles must be integers"):
        pypw85.Mesh(VERTICES, [0, 1, 2])
    with pytest.raises(ValueError, match="vertices must be rows of 3 numbers"):
        pypw85.Mesh([[0, 0]], [[0, 0, 0]])
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    q = np.array([[1.0, 0, 0, 1, 0, 1]] * 2)
    with pytest.raises(pypw85.PW85Error, match="Mesh.overlap: row 1: q must be positive definite"):
        mesh.overlap(np.zeros((2, 3)), q * [[1], [0]])
    with pytest.raises(pypw85.PW85Error, match=r"Mesh.overlap: row 0: centers must be finite, not \[inf"):
        mesh.overlap([[np.inf, 0, 0], [0, 0, 0]], q)
    with pytest.warns(RuntimeWarning, match="invalid value"):
        mu2, point, triangle = mesh.contact([[np.nan, 0, 0], [1, 1, 1]], q)
    assert np.isnan(mu2[0]) and np.isnan(point[0]).all() and triangle[0] == -1 and mu2[1] == 1 / 3
    with pytest.raises(ValueError, match="2 centers, but 1 form$"):
        mesh.contact(np.zeros((2, 3)), q[:1])


def test_object():
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    assert repr(mesh) == "<pypw85.Mesh: 4 triangles, 4 vertices>"
    assert len(mesh) == 4
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0] = 1
    empty = pypw85.Mesh(np.empty((0, 3)), [])
    mu2, point, triangle = empty.contact([[0, 0, 0]], [[1, 0, 0, 1, 0, 1]])
    assert mu2[0] == np.inf and np.isnan(point).all() and triangle[0] == -1
    assert mesh.contact(np.empty((0, 3)), np.empty((0, 6)))[0].shape == (0,)


@pytest.mark.parametrize("ending", ["stl", "obj", "ply"])
def test_files(tmp_path, ending):
    meshio = pytest.importorskip("meshio")
    path = tmp_path / f"tetrahedron.{ending}"
    meshio.write_points_cells(path, VERTICES, [("triangle", TRIANGLES)])
    mesh = pypw85.Mesh.read(path)
    assert (mesh.vertices[mesh.triangles] == VERTICES[TRIANGLES]).all()


def test_squares(tmp_path):
    meshio = pytest.importorskip("meshio")
    meshio.write_points_cells(tmp_path / "a.obj", VERTICES, [("triangle", TRIANGLES[:1]), ("quad", [[0, 1, 2, 3]])])
    assert pypw85.Mesh.read(tmp_path / "a.obj").triangles.tolist() == [[0, 2, 1], [0, 1, 2], [0, 2, 3]]
    (tmp_path / "points.obj").write_text("v 0 0 0\nv 1 0 0\n")
    with pytest.raises(ValueError, match="has no triangles"):
        pypw85.Mesh.read(tmp_path / "points.obj")


def test_without_meshio(monkeypatch):
    monkeypatch.setitem(sys.modules, "meshio", None)
    with pytest.raises(ImportError, match="python3-meshio"):
        pypw85.Mesh.read("wall.stl")


CUBE = np.array(np.meshgrid([-1.0, 1], [-1, 1], [-1, 1], indexing="ij")).reshape(3, -1).T
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def area(mesh):
    a, b, c = np.swapaxes(mesh.vertices[mesh.triangles], 0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


@pytest.mark.parametrize("name", ["{}", "{}/1", "{}/1/1", "{}//1"])
@pytest.mark.parametrize("first", [1, -8])
def test_faces_of_obj(name, first, tmp_path):
    """Numbers of textures and normals, from the start or from the end, quads, and comments."""
    pytest.importorskip("meshio")
    lines = ["mtllib a.mtl", "o cube", *(f"v {' '.join(map(repr, corner.tolist()))} 1 0 0" for corner in CUBE), "vt 0 0", "vn 0 0 1"]
    lines += ["f " + " ".join(name.format(first + k) for k in face) + " # a face" for face in FACES]
    (tmp_path / "a.obj").write_text("\n".join(lines))
    mesh = pypw85.Mesh.read(tmp_path / "a.obj")
    assert (len(mesh), area(mesh)) == (12, 24)


def test_polygons(tmp_path):
    """An L of area 3, whose fan from the first corner would have 5, beside a triangle: every point of it is hit, none outside."""
    pytest.importorskip("meshio")
    corners = [(2, 1, 0), (1, 1, 0), (1, 2, 0), (0, 2, 0), (0, 0, 0), (2, 0, 0)]
    for start in range(6):
        for turn in (1, -1):
            face = np.roll(np.arange(1, 7), start)[::turn]
            text = [f"v {x} {y} {z}" for x, y, z in [*corners, (0, 0, 1)]] + ["f " + " ".join(map(str, face)), "f 5 6 7"]
            (tmp_path / "a.obj").write_text("\n".join(text))
            mesh = pypw85.Mesh.read(tmp_path / "a.obj")
            assert (len(mesh), area(mesh)) == (5, 4)
            small = np.tile(1e-4 * np.array([1.0, 0, 0, 1, 0, 1]), (4, 1))
            assert mesh.overlap([[0.5, 1.5, 0], [1.5, 0.5, 0], [0.5, 0.5, 0], [1.5, 1.5, 0]], small).tolist() == [True] * 3 + [False]


def test_text_of_stl(tmp_path):
    """In capitals, several solids, "end solid", and without normals."""
    pytest.importorskip("meshio")
    facets = [f"  FACET\n   OUTER LOOP\n{''.join(f'    VERTEX {x} {y} {z}' + chr(10) for x, y, z in VERTICES[triangle])}"
              "   END LOOP\n  END FACET\n" for triangle in TRIANGLES]  # fmt: skip
    text = "SOLID one\n" + "".join(facets[:2]) + "END SOLID one\nsolid two\n" + "".join(facets[2:]) + "endsolid\n"
    (tmp_path / "a.STL").write_text(text)
    mesh = pypw85.Mesh.read(tmp_path / "a.STL")
    assert (mesh.vertices[mesh.triangles] == VERTICES[TRIANGLES]).all()


PLY = """ply
format ascii 1.0
comment made by hand
element vertex 8
property float x
property float y
property double z
element face 6
property list uchar int vertex_index
element edge 0
property int vertex1
property int vertex2
end_header
"""


@pytest.mark.parametrize("is_binary", [True, False])
def test_faces_of_ply(is_binary, tmp_path):
    """Quads, elements behind the faces, and the older name of the list."""
    pytest.importorskip("meshio")
    if is_binary:
        points = np.array([tuple(corner) for corner in CUBE], [("x", "<f4"), ("y", "<f4"), ("z", "<f8")])
        faces = np.array([(4, face) for face in FACES], [("n", "u1"), ("face", "<i4", 4)])
        content = PLY.replace("ascii", "binary_little_endian").encode() + points.tobytes() + faces.tobytes()
    else:
        rows = [*CUBE.tolist(), *([4, *face] for face in FACES)]
        content = (PLY + "\n".join(" ".join(map(str, row)) for row in rows) + "\n").encode()
    (tmp_path / "a.ply").write_bytes(content)
    mesh = pypw85.Mesh.read(tmp_path / "a.ply")
    assert (len(mesh), area(mesh)) == (12, 24)


@pytest.mark.parametrize("place", ["element vertex", "element face", "element edge"])
@pytest.mark.parametrize("is_binary", [True, False])
def test_elements_beside_vertices_and_faces(is_binary, place, tmp_path):
    """Before, between and behind them, with lists and without."""
    pytest.importorskip("meshio")
    header = PLY.replace(place, f"element camera 2\nproperty short focus\nproperty list uchar float view\n{place}")
    cameras = [struct.pack("<hB2f", 7, 2, 1, 1), struct.pack("<hB", 7, 0)] if is_binary else ["7 2 1 1", "7 0"]
    if is_binary:
        points = [tuple(corner) for corner in CUBE]
        rows = [np.array(points, [("x", "<f4"), ("y", "<f4"), ("z", "<f8")]).tobytes(),
                np.array([(4, face) for face in FACES], [("n", "u1"), ("face", "<i4", 4)]).tobytes()]  # fmt: skip
    else:
        rows = ["\n".join(" ".join(map(str, row)) for row in part) for part in (CUBE.tolist(), [[4, *face] for face in FACES])]
    rows[(k := ["element vertex", "element face", "element edge"].index(place)) : k] = cameras
    header = header.replace("ascii", "binary_little_endian") if is_binary else header
    content = header.encode() + b"".join(rows) if is_binary else (header + "\n".join(rows)).encode()
    (tmp_path / "a.ply").write_bytes(content)
    mesh = pypw85.Mesh.read(tmp_path / "a.ply")
    assert (len(mesh), area(mesh)) == (12, 24)


@pytest.mark.parametrize("order", ["<", ">"])
def test_colored_faces_of_ply(order, tmp_path):
    """Properties of faces lie between the lists of a binary file."""
    pytest.importorskip("meshio")
    format = "binary_little_endian" if order == "<" else "binary_big_endian"
    header = PLY.replace("ascii", format).replace("vertex_index\n", "vertex_indices\nproperty uchar red\nproperty short flags\n")
    points = np.array([tuple(corner) for corner in CUBE], [("x", order + "f4"), ("y", order + "f4"), ("z", order + "f8")])
    kinds = [("n", "u1"), ("face", order + "i4", 4), ("red", "u1"), ("flags", order + "i2")]
    faces = np.array([(4, face, 200, -3) for face in FACES], kinds)
    path = tmp_path / "a.ply"
    path.write_bytes(header.encode() + points.tobytes() + faces.tobytes())
    mesh = pypw85.Mesh.read(path)
    assert (len(mesh), area(mesh)) == (12, 24)
    faces["n"][3] = 3
    for content, reason in ((faces.tobytes(), "must all have the same number of vertices"), (faces.tobytes()[:-1], "buffer is smaller")):
        path.write_bytes(header.encode() + points.tobytes() + content)
        with pytest.raises(ValueError, match=reason):
            pypw85.Mesh.read(path)


BAD_MESHES = {
    "a.obj": [("v 0 0 0\nv 1,5 0 0\n", "line 2: a vertex must have three numbers with decimal points, not '1,5 0 0'"),
              ("v 0 0\n", "line 1: a vertex must have three numbers"), ("v 0 0 \0\x1b[2J\n", r"not '0 0 .x00.x1b\[2J'"),
              ("v 0 0 0\nf 1 2\n", "line 2: a face must have three"), ("v 0 0 0\nf 1 2 0\n", "line 2: a face"),
              ("v 0 0 0\nf 1 2 99999999999999999999\n", "line 2: a face must have"),
              ("v 0 0 0\nf 1 2 3\n", r"the face \[0, 1, 2\] must have indices of the 1 vertices"),
              ("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 4\n", r"the face \[0, 1, 2, 3\] must have indices of the 3 vertices"),
              ("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 -4\n", "line 4"),
              ("v 0 0 nought\nf 1 1 1\n", "nought"), ("surf 0 1 0 1\n", "line 1: free-form")],
    "a.stl": [("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n",
               "line 7: the facet before must have 3 vertices, not 1"),
              ("solid\nfacet normal 0 0 1\nvertex 0 0\n", "line 3: a vertex"), (84 * "\0" + "x", "a binary STL file of 0 triangles"),
              ("solid\nfacet normal 0 0 1\nvertex 0 0 0\n", "the file ends within a facet")],
    "a.ply": [("plain", "must begin with the header of a PLY file"),
              (PLY.replace("element edge", "property list uchar float texcoord\nelement edge"), "the list 'texcoord'"),
              (PLY.replace("element vertex", "element point"), "must have an element 'vertex', not only point face edge"),
              (PLY.replace("uchar int", "uchar whole"), "line 9: a property must have a type"),
              (PLY.replace("int vertex_index", "int vertex_index\nproperty uchar red") + 8 * "0 0 0\n" + 6 * "3 0 1 2\n",
               "a row has fewer numbers than the header says"),
              (PLY.replace("element edge", "element tristrips"), "the element tristrips has triangles in strips"),
              (PLY.replace("face 6", "face 1") + 8 * "0 0 0\n" + "0\n", "a face must have three or more vertices, not 0"),
              (PLY + 8 * "0 0 0\n" + 9 * "3 0 1 2\n", "17 rows instead of 14 follow the header"),
              (PLY.replace("face 6", "face -6"), "line 8: an element must have a name and a number")],
    "a.off": [("4OFF\n0 0 0\n", "line 1: the file must begin with OFF, .*'4OFF': four coordinates"), ("OFF BINARY\n", "binary files"),
              ("OFF\n\n1 2 3 4\n", "line 3: the numbers of vertices, faces and edges must be here"), ("", "line 1: the file must begin"),
              ("OFF\n1 0 0\n0 0\n", "line 3: a vertex must begin with three numbers"),
              ("OFF\n1 0 0\n0 0 1,5\n", "line 3: a vertex must begin with three numbers"),
              ("OFF\n1 1 0\n0 0 0\n3 0 0\n", "line 4: a face must begin with the number of its vertices, three or more"),
              ("OFF\n1 1 0\n0 0 0\n2 0 0\n", "line 4: a face must begin with"), ("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "indices of the 1 vert"),
              ("OFF\n99999999 1 0\n0 0 0\n", "the file ends after 1 of 99999999 vertices and 0 of 1 faces"),
              ("OFF\n1 1 0\n0 0 0\n3 0 0 0\n3 0 0 0\n", "line 5: there are more rows than those of 1 vertices and 1")],
    "a.foo": [("", "files of the kind '.foo' are not read: convert it to STL, OBJ, PLY or OFF")],
    "a.node": [("TetGen\n", "files of the kind '.node' are not read")],
    "a.bdf": [("CEND\n", "the file ends without ENDDATA: it is truncated")],
    "a.vtk": [("nonsense", "a.vtk"), ("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 2 2 1",
                                      r"points must have three coordinates, and the array of them has the shape \(\)")],
}  # fmt: skip


@pytest.mark.parametrize("name", BAD_MESHES)
def test_broken_meshes(name, tmp_path):
    pytest.importorskip("meshio")
    for content, reason in BAD_MESHES[name]:
        path = tmp_path / name
        path.write_text(content)
        with pytest.raises(ValueError, match=reason) as raised:
            pypw85.Mesh.read(path)
        assert str(raised.value).startswith(f"{path}: ") and str(raised.value).isprintable()
    with pytest.raises(FileNotFoundError):
        pypw85.Mesh.read(tmp_path / f"missing-{name}")


@pytest.mark.parametrize("head", ["OFF", "# made by hand\nOFF 8 6 12", "COFF\n\n8 6 12", "NOFF\n8 6"])
@pytest.mark.parametrize("is_cut", [False, True])
def test_off(head, is_cut, tmp_path):
    """Squares, or triangles beside squares, in Geomview's Object File Format. Colours and normals stand behind what is read."""
    pytest.importorskip("meshio")
    faces = [face for one in FACES for face in ([one[:3], [one[0], *one[2:]]] if is_cut and one[0] else [one])]
    head = (head if "8 6" in head else f"{head}\n8 6 0").replace("8 6", f"8 {len(faces)}")
    end = {"C": " 255 0 0 255", "N": " 0 0 1"}.get(head[0], "")
    rows = [f"{' '.join(map(str, corner))}{end}" for corner in CUBE]
    rows += [f"{len(face)} {' '.join(map(str, face))} # a face" if k else f"{len(face)} {' '.join(map(str, face))} 255 0 0"
             for k, face in enumerate(faces)]  # fmt: skip
    (tmp_path / "a.off").write_text("\n".join([head, *rows]) + "\n")
    mesh = pypw85.Mesh.read(tmp_path / "a.off")
    assert (len(mesh), area(mesh)) == (12, 24)


@pytest.mark.parametrize("kind, sides", [("triangle6", 6), ("quad8", 8)])
def test_curved_faces(kind, sides, tmp_path):
    """Beside triangles, they were left out."""
    meshio = pytest.importorskip("meshio")
    cells = [("triangle", np.array([[0, 1, 2]])), (kind, np.arange(sides)[None])]
    meshio.write(tmp_path / "a.vtu", meshio.Mesh(np.array(CUBE, float), cells))
    with pytest.raises(ValueError, match=f"a.vtu: the cells {kind} are faces that are not read: write triangles, quad"):
        pypw85.Mesh.read(tmp_path / "a.vtu")


def vtu(*pieces):
    """A file of VTK with pieces, each of which has the points of CUBE; the types of VTK are 5 for triangles and 6 for strips."""
    arrays = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="ascii">{}</DataArray>'.format
    text = ""
    for cells, kinds in pieces:
        ends = " ".join(map(str, np.cumsum([len(cell) for cell in cells])))
        columns = arrays("Int64", "connectivity", 1, " ".join(str(k) for cell in cells for k in cell))
        columns += arrays("Int64", "offsets", 1, ends) + arrays("UInt8", "types", 1, " ".join(map(str, kinds)))
        points = arrays("Float64", "Points", 3, " ".join(map(str, CUBE.ravel())))
        text += f'<Piece NumberOfPoints="8" NumberOfCells="{len(cells)}"><Points>{points}</Points><Cells>{columns}</Cells></Piece>'
    head = '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">'
    return f"{head}<UnstructuredGrid>{text}</UnstructuredGrid></VTKFile>"


def test_lost_cells_of_vtk(tmp_path):
    """meshio leaves out strips, and pieces but one."""
    pytest.importorskip("meshio")
    one, other = [0, 1, 2], [4, 5, 6]
    (tmp_path / "a.vtu").write_text(vtu(([one, other], [5, 5])))
    assert len(pypw85.Mesh.read(tmp_path / "a.vtu")) == 2
    for pieces in ([([one], [5]), ([other], [5])], [([[0, 1, 2, 3], other], [6, 5])]):
        (tmp_path / "a.vtu").write_text(vtu(*pieces))
        with pytest.raises(ValueError, match="a.vtu: 1 of 2 cells are in strips or in other pieces, which are not read: write one"):
            pypw85.Mesh.read(tmp_path / "a.vtu")


ZONE = "ZONE NODES=3, ELEMENTS=1, DATAPACKING=POINT, ZONETYPE=FETRIANGLE\n0 0 0\n1 0 0\n1 1 0\n1 2 3\n"
SINGLE = "*Part, name=A\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n*End Part\n"


@pytest.mark.parametrize("name, head, part, parts", [("a.tec", 'VARIABLES = "X" "Y" "Z"\n', ZONE, "zones"), ("a.inp", "", SINGLE, "parts")])
def test_several_parts(name, head, part, parts, tmp_path):
    """Of Tecplot the others are lost, and of Abaqus the nodes of one number are mixed."""
    pytest.importorskip("meshio")
    (tmp_path / name).write_text(head + part)
    assert area(pypw85.Mesh.read(tmp_path / name)) == 0.5
    (tmp_path / name).write_text(head + 2 * part)
    with pytest.raises(ValueError, match=f"{name} has 2 {parts}, and only one is read: write the triangles of all in one"):
        pypw85.Mesh.read(tmp_path / name)


PART = "*PART, NAME=A\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n*END PART\n"
DECK = "BEGIN BULK\n{}\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nCTRIA3,1,1,1,2,3\nENDDATA\n"
# What finite elements read of a file, and the word that moves nodes, empty if there is none
PLACED = {
    PART: "", PART + "*INSTANCE, NAME=B, PART=A\n*END INSTANCE\n": "", PART.replace("*NODE", "*NODE, NSET=B"): "",
    PART + "*Instance, name=B, part=A\n** moved\n 0., 0., 5.\n*END INSTANCE\n": r"line 9: \*Instance",
    "*SYSTEM\n0, 0, 5\n" + PART: r"line 1: \*SYSTEM", PART.replace("*NODE", "*NODE, SYSTEM=C"): r"line 2: \*NODE",
    PART + "*INCLUDE, INPUT=b.inp\n": r"line 9: \*INCLUDE",
    DECK.format("GRID,1,,0.,0.,0."): "", DECK.format("GRID,1,0,0.,0.,0."): "",
    DECK.format("GRID    1               0.      0.      0."): "",
    DECK.format("GRID,1,7,0.,0.,0."): "line 2: GRID", DECK.format("GRID    1              70.      0.      0."): "line 2: GRID",
    DECK.format("GRID*   1               7               0.              0.\n*       0."): r"line 2: GRID\*",
    DECK.format("GRDSET,,7\nGRID,1,,0.,0.,0."): "line 2: GRDSET",
}  # fmt: skip


@pytest.mark.parametrize("text", PLACED)
def test_placed_nodes(text, tmp_path):
    """Of Abaqus and Nastran: meshio does not read what moves nodes."""
    pytest.importorskip("meshio")
    path = tmp_path / ("a.bdf" if "BULK" in text else "a.inp")
    path.write_text(text)
    if not PLACED[text]:
        assert len(pypw85.Mesh.read(path)) == 1
        return
    with pytest.raises(ValueError, match=f"{PLACED[text]} places or adds nodes in a way that is not read: write the triangles alone"):
        pypw85.Mesh.read(path)


def test_order_of_memory():
    mesh = pypw85.Mesh(np.asfortranarray(VERTICES), np.asfortranarray(TRIANGLES))
    assert (mesh.triangles == TRIANGLES).all()
