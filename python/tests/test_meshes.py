"""Triangle meshes in Python."""

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
    with pytest.raises(pypw85.PW85Error, match=r"Mesh: vertex 1 is not finite: \[0.0, nan, 0.0\]"):
        pypw85.Mesh([[0, 0, 0], [0, np.nan, 0]], [[0, 0, 0]])
    for index in (-1, 4, 2**40):
        with pytest.raises(pypw85.PW85Error, match="Mesh: triangle 1 has an index that is no vertex"):
            pypw85.Mesh(VERTICES, [[0, 1, 2], [0, index, 1]])
    with pytest.raises(ValueError, match="triangles must be integers"):
        pypw85.Mesh(VERTICES, [[0.0, 1, 2]])
    with pytest.raises(ValueError, match="triangles must be integers"):
        pypw85.Mesh(VERTICES, [0, 1, 2])
    with pytest.raises(ValueError, match="vertices must have 3 columns"):
        pypw85.Mesh([[0, 0]], [[0, 0, 0]])
    mesh = pypw85.Mesh(VERTICES, TRIANGLES)
    q = np.array([[1.0, 0, 0, 1, 0, 1]] * 2)
    with pytest.raises(pypw85.PW85Error, match="Mesh.overlap: row 1: q is not positive definite"):
        mesh.overlap(np.zeros((2, 3)), q * [[1], [0]])
    with pytest.raises(pypw85.PW85Error, match=r"Mesh.overlap: row 0: centers is bad: \[inf"):
        mesh.overlap([[np.inf, 0, 0], [0, 0, 0]], q)
    with pytest.warns(RuntimeWarning, match="invalid value"):
        mu2, point, triangle = mesh.contact([[np.nan, 0, 0], [1, 1, 1]], q)
    assert np.isnan(mu2[0]) and np.isnan(point[0]).all() and triangle[0] == -1 and mu2[1] == 1 / 3
    with pytest.raises(ValueError, match="2 centers, but 1 forms"):
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
