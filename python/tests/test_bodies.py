# SPDX-License-Identifier: BSD-3-Clause
"""Points in and on ellipsoids, meshes of ellipsoids, and the ellipsoids of meshes."""

import math

import numpy as np
import pypw85
import pytest

AXES = [(1, 1, 1), (1, 2, 3), (1e-3, 1, 1), (1e-3, 1e-3, 1), (1e-6, 1e-3, 1), (2.0**-40, 2.0**-39, 2.0**-38)]
POINTS = 100_000
# The largest value of χ² for k degrees of freedom, with the probability 1e-9 of more, is below k + 2 √(k x) + 2x, x = log 1e9 (Laurent and
# Massart, Ann. Statist. 28, 1302, 2000, lemma 1).
CHANCE = math.log(1e9)
TURN = [0.5, 0.1, -0.7, 0.2]


@pytest.mark.parametrize("shell", [False, True])
def test_inertia(shell):
    """The trace is twice that of the second moments; a tensor grows with length⁵ of a body, length⁴ of a shell."""
    forms = np.array([[1, 0.1, 0.2, 4, 0.3, 9], [1, 0, 0, 1, 0, 1e-12], [9, -1, 2, 5, 1, 1]])
    found = pypw85.inertia(forms, shell=shell)
    mass = pypw85.surface_area(forms) if shell else pypw85.volume(forms)
    moments = pypw85.shell_moments(forms) if shell else forms / 5
    np.testing.assert_allclose(found[:, [0, 3, 5]].sum(axis=1), 2 * mass * moments[:, [0, 3, 5]].sum(axis=1), rtol=1e-15)
    np.testing.assert_allclose(found[:, [1, 2, 4]], -mass[:, None] * moments[:, [1, 2, 4]], rtol=1e-15)
    np.testing.assert_allclose(pypw85.inertia(4 * forms, shell), found * 2 ** (4 if shell else 5), rtol=1e-15)
    with pytest.raises(pypw85.PW85Error):
        pypw85.inertia([1, 0, 0, 1, 0, 0], shell=shell)


def largest_chi_square(freedom):
    return freedom + 2 * math.sqrt(freedom * CHANCE) + 2 * CHANCE


def matrix_of(quaternion):
    w, x, y, z = np.array(quaternion) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])  # fmt: skip


def cells_of(directions):
    """One of 128 cells of the sphere: four heights and four angles in each octant."""
    height, turn = np.abs(directions[:, 2]), np.arctan2(np.abs(directions[:, 1]), np.abs(directions[:, 0]))
    octant = (directions < 0) @ [1, 2, 4]
    parts = np.minimum((4 * height).astype(int), 3) * 4 + np.minimum((8 / math.pi * turn).astype(int), 3)
    return octant * 16 + parts


def shares_of_area(axes):
    """The share of the area in each of the sixteen cells of an octant, by the rule of midpoints."""
    steps = 400
    height = (np.arange(4 * steps) + 0.5) / (4 * steps)
    turn = (np.arange(4 * steps) + 0.5) / (4 * steps) * math.pi / 2
    ring = 1 - height[:, None] ** 2
    scaled = min(axes) / np.array(axes, dtype=float)
    element = np.sqrt(ring * ((np.cos(turn) * scaled[0]) ** 2 + (np.sin(turn) * scaled[1]) ** 2) + (height[:, None] * scaled[2]) ** 2)
    sums = element.reshape(4, steps, 4, steps).sum(axis=(1, 3)).ravel()
    return sums / sums.sum()


def chi_square(counts, shares):
    expected = shares * counts.sum()
    return float(((counts - expected) ** 2 / expected).sum())


# Forms of thin ellipsoids in general directions lose the short axes by rounding (aspect² u): points of these are drawn along the axes.
@pytest.mark.parametrize("axes", AXES)
def test_points_of_the_surface_are_uniform(axes):
    directions = drawn(axes, surface=True)
    assert abs(np.linalg.norm(directions, axis=1) - 1).max() < 1e-9
    counts = np.bincount(cells_of(directions), minlength=128)
    assert chi_square(counts, np.tile(shares_of_area(axes), 8) / 8) < largest_chi_square(127)


@pytest.mark.parametrize("axes", AXES)
def test_points_of_the_body_are_uniform(axes):
    directions = drawn(axes, surface=False)
    radii = np.linalg.norm(directions, axis=1)
    assert radii.max() <= 1 + 1e-9
    shells = np.minimum((4 * radii**3).astype(int), 3)
    counts = np.bincount(cells_of(directions / radii[:, None]) * 4 + shells, minlength=512)
    assert chi_square(counts, np.full(512, 1 / 512)) < largest_chi_square(511)


def drawn(axes, surface):
    axes = np.array(axes, dtype=float)
    turn = TURN if axes.max() < 100 * axes.min() else [1, 0, 0, 0]
    q = pypw85.ellipsoid_quaternion(axes, turn)
    points = pypw85.random_points(q, POINTS, seed=20261129, surface=surface)
    return points @ matrix_of(turn) / axes


def test_points_by_their_seed():
    q = [1, 0, 0, 4, 0, 9]
    for surface in (False, True):
        few, many = (pypw85.random_points(q, n, seed=3, surface=surface) for n in (10, 10))
        assert (few == many).all()
        assert (few != pypw85.random_points(q, 10, seed=4, surface=surface)).any()
        assert pypw85.random_points(q, 0, surface=surface).shape == (0, 3)
    assert (pypw85.random_points(q, 5000, 3, True)[:10] == pypw85.random_points(q, 10, 3, True)).all()


@pytest.mark.parametrize("axes", AXES)
def test_even_points(axes):
    """The second moments are those of the shell, and each cell has its share of points to a few of them."""
    axes = np.array(axes, dtype=float)
    q = pypw85.ellipsoid_quaternion(axes, [1, 0, 0, 0])
    points = pypw85.even_points(q, 4000)
    moments = (points**2).mean(axis=0)
    assert moments == pytest.approx(pypw85.shell_moments(q)[[0, 3, 5]], rel=2e-3)
    counts = np.bincount(cells_of(points / axes), minlength=128)
    assert abs(counts - 4000 * np.tile(shares_of_area(axes), 8) / 8).max() < 12  # 30 for random ones, of 31


@pytest.mark.parametrize("axes", AXES[:4] + AXES[5:])
@pytest.mark.parametrize("fit", ["inscribed", "circumscribed", "volume"])
def test_meshes(axes, fit):
    axes = np.array(axes, dtype=float)
    q = pypw85.ellipsoid_quaternion(axes, [1, 0, 0, 0])
    mesh = pypw85.ellipsoid_mesh(q, 0.01 * axes.max(), fit)
    assert 0.001 * axes.max() < mesh.deviation <= 0.01 * axes.max()
    corners = mesh.vertices[mesh.triangles]
    volume = np.linalg.det(corners).sum() / 6
    assert volume / pypw85.volume(q) == pytest.approx(mesh.volume, rel=1e-12)
    levels = np.linalg.norm(mesh.vertices / axes, axis=1)
    a, b, c = (corners[:, k] / axes for k in range(3))
    normals = np.cross(b - a, c - a)
    heights = np.einsum("ij,ij->i", normals, a) / np.linalg.norm(normals, axis=1)
    if fit == "inscribed":
        assert abs(levels - 1).max() < 1e-12
        assert mesh.volume < 1
    elif fit == "circumscribed":
        assert heights.min() == pytest.approx(1, abs=1e-12)
        assert mesh.volume > 1
    else:
        assert mesh.volume == pytest.approx(1, rel=1e-12)
    assert max(levels.max() - 1, 1 - heights.min()) * axes.max() <= mesh.deviation * (1 + 1e-12)


@pytest.mark.parametrize("unit", [2.0**-40, 1.0, 2.0**40])
def test_from_mesh(unit):
    """A box, whose moments are known: its ellipsoid has the squares of the semi-axes 5/12 of those of its sides."""
    sides, corner = np.array([1.0, 2.0, 3.0]), np.array([5.0, -7.0, 1.0])
    vertices = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)]) * sides + corner
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    for listed in (triangles, triangles[:, ::-1]):
        center, q = pypw85.from_mesh(pypw85.Mesh(unit * vertices, listed))
        assert center == pytest.approx(unit * (corner + sides / 2), rel=1e-14)
        assert q[[0, 3, 5]] == pytest.approx(unit**2 * 5 / 12 * sides**2, rel=1e-13)
        assert abs(q[[1, 2, 4]]).max() < 1e-13 * unit**2
    doubled = unit * vertices[triangles].reshape(-1, 3)  # as in STL: each triangle has vertices of its own
    center, q = pypw85.from_mesh(pypw85.Mesh(doubled, np.arange(len(doubled)).reshape(-1, 3)))
    assert q[0] == pytest.approx(unit**2 * 5 / 12, rel=1e-13)
    for wrong in (triangles[1:], np.concatenate([triangles[:1, ::-1], triangles[1:]]), triangles[[*range(12), 0]]):
        with pytest.raises(ValueError, match="not closed"):
            pypw85.from_mesh(pypw85.Mesh(unit * vertices, wrong))


def test_meshes_without_a_body():
    flat = pypw85.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 1]])
    with pytest.raises(ValueError, match="must have a volume, not 0"):
        pypw85.from_mesh(flat)
    with pytest.raises(ValueError, match="no triangles"):
        pypw85.from_mesh(pypw85.Mesh([[0, 0, 0]], np.zeros((0, 3), int)))


def test_refusals():
    for call in (pypw85.even_points, pypw85.random_points):
        with pytest.raises(pypw85.PW85Error):
            call([1, 0, 0, 1, 0, 0], 3)
        with pytest.raises(ValueError, match=r"n must be an integer from 0 to 2\*\*40, not -1"):
            call([1, 0, 0, 1, 0, 1], -1)
        with pytest.raises(ValueError, match=r"one form with the shape \(6,\), not"):
            call(np.ones((2, 6)), 1)
    for seed in (-1, 2**64):
        with pytest.raises(ValueError, match=rf"random_points: seed must be an integer from 0 to 2\*\*64 - 1, not {seed}"):
            pypw85.random_points([1, 0, 0, 1, 0, 1], 3, seed)
    with pytest.raises(pypw85.PW85Error):
        pypw85.ellipsoid_mesh([1, 0, 0, math.nan, 0, 1], 0.1)
    for deviation in (0, -1, math.nan):
        with pytest.raises(ValueError, match="positive"):
            pypw85.ellipsoid_mesh([1, 0, 0, 1, 0, 1], deviation)
    with pytest.raises(ValueError, match="triangles"):
        pypw85.ellipsoid_mesh([1, 0, 0, 1, 0, 1], 1e-12)
    with pytest.raises(ValueError, match="ellipsoid_mesh: fit must be 'inscribed', 'circumscribed' or 'volume', not"):
        pypw85.ellipsoid_mesh([1, 0, 0, 1, 0, 1], 0.1, "outside")


@pytest.mark.parametrize("end", ["stl", "obj", "ply"])
@pytest.mark.parametrize("fit", [None, "inscribed", "circumscribed"])
def test_files(tmp_path, run, end, fit):
    """Meshes come back from the files with the volume that their first lines say, and with the ellipsoids."""
    pytest.importorskip("meshio")
    q = pypw85.ellipsoid_quaternion([1, 2, 3], TURN)
    system = pypw85.System([[4, 5, 6]], [q])
    pypw85.write(tmp_path / "one.csv", system)
    output = tmp_path / f"one.{end}"
    options = ["--deviation", "0.02", *(["--fit", fit] if fit else [])]
    assert run("convert", tmp_path / "one.csv", output, *options).status == 0
    line = output.read_text().splitlines()[2 if end == "ply" else 0]
    mesh = pypw85.Mesh.read(output)
    center, found = pypw85.from_mesh(mesh)
    assert center == pytest.approx([4, 5, 6], abs=1e-6)
    assert found == pytest.approx(q, abs=0.02 * 9)
    volume = np.linalg.det(mesh.vertices[mesh.triangles] - center).sum() / 6 / pypw85.volume(q)
    assert f"1 ellipsoid, {len(mesh)} triangles" in line
    if fit:
        assert f"the volume is {100 * abs(volume - 1):.3g} % too {'small' if fit == 'inscribed' else 'large'}" in line
    else:
        assert volume == pytest.approx(1, abs=1e-6)


def test_files_of_meshes_that_are_refused(tmp_path):
    system = pypw85.System([[4, 5, 6]], [[1, 0, 0, 1, 0, 1]])
    with pytest.raises(ValueError, match="one frame"):
        pypw85.write(tmp_path / "a.stl", [system, system])
    with pytest.raises(pypw85.FileError, match="leave out --fit"):
        pypw85.write(tmp_path / "a.xyz", system, fit="inscribed")
    with pytest.raises(ValueError, match="positive"):
        pypw85.write(tmp_path / "a.obj", system, deviation=0.0)
    assert not list(tmp_path.iterdir())
