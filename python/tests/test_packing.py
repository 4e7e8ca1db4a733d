# SPDX-License-Identifier: BSD-3-Clause
"""Packings, relaxation, voxels, statistics, conversion."""

import pickle
import re

import numpy as np
import pytest

import pypw85
from pypw85 import _packing, _statistics, _voxels
from pypw85._system import quaternions_of
from systems import CELL, random_system


def rotations(quaternions):
    """Rotation matrices, column by column: the form of an ellipsoid that is long along one axis tells where that goes."""
    return np.stack([pypw85.full(pypw85.ellipsoid_quaternion(1 + axis, quaternions)) for axis in np.eye(3)], axis=1)


def test_quaternions_of_rotations(rng):
    quaternions = np.concatenate([rng.normal(size=(200, 4)), np.eye(4), [[1e-9, 1, 0, 0], [0, 1, -1, 0]]])
    semi_axes, rotation = pypw85.principal_axes(pypw85.ellipsoid_quaternion([1, 2, 3], quaternions))
    q = pypw85.ellipsoid_quaternion(semi_axes, quaternions_of(rotation))
    np.testing.assert_allclose(q, pypw85.ellipsoid([1, 2, 3], rotation), atol=2e-14)


def test_turned(rng):
    """Half a turn about z, twice a quarter, and the derivative that torques are."""
    start = rng.normal(size=(20, 4))
    turned = _packing._rotated(start, np.tile([0, 0, np.pi], (20, 1)))
    mirror = np.diag([-1, -1, 1])
    np.testing.assert_allclose(rotations(turned), mirror @ rotations(start) @ mirror, atol=1e-13)
    quarter = np.tile([0, 0, np.pi / 2], (20, 1))
    np.testing.assert_allclose(rotations(_packing._rotated(_packing._rotated(start, quarter), quarter)), rotations(turned), atol=1e-13)
    np.testing.assert_allclose(_packing._rotated(start, np.zeros((20, 3))), start / np.linalg.norm(start, axis=1)[:, None])


def test_forces_are_derivatives_of_the_energy(rng):
    system, swelling = random_system(count=12), 1.01
    soft = _packing._Soft(system)

    def energy(centers, quaternions):
        swollen = pypw85.System.from_axes(centers, swelling * system.semi_axes, quaternions, cell=system.cell)
        return 0.5 * ((1 - swollen.overlaps().mu ** 2) ** 2).sum()

    push = soft.push(swelling)
    forces, torques = push.force[0] / soft.length, push.force[1]
    assert push.energy == pytest.approx(energy(system.centers, system.quaternions), rel=1e-12)
    assert (push.overlaps, push.smallest) == (len(system.overlaps().mu), pytest.approx(system.overlaps().mu[0] ** 2))
    for _ in range(5):
        way, turn, h = rng.normal(size=(12, 3)), rng.normal(size=(12, 3)), 1e-5
        plus, minus = (energy(system.centers + s * h * way, _packing._rotated(system.quaternions, s * h * turn)) for s in (1, -1))
        slope = -(forces * way).sum() - (torques * turn).sum()
        # Central differences: an error of h² times third derivatives, and of 1e-15 energy / h
        np.testing.assert_allclose((plus - minus) / (2 * h), slope, rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("cell", [None, CELL])
def test_pack(cell):
    kinds = np.array([[1, 1, 2], [1.5, 1.5, 0.5]])[np.arange(30) % 2]
    system = pypw85.pack(kinds, 0.45, cell, seed=3)
    assert len(system.overlaps().mu) == 0
    assert system.packing_fraction == pytest.approx(0.45, rel=1e-12)
    np.testing.assert_array_equal(system.semi_axes, kinds)
    fractions = system.centers @ np.linalg.inv(system.cell)
    assert (fractions > -1e-12).all() and (fractions < 1 + 1e-12).all()
    again = pypw85.pack(kinds, 0.45, cell, seed=3)
    np.testing.assert_array_equal(again.q, system.q)
    assert (pypw85.pack(kinds, 0.45, cell, seed=4).q != system.q).any()


def test_too_dense():
    with pytest.raises(pypw85.OverlapsLeft, match="remain after 20 steps") as caught:
        pypw85.pack(np.ones((10, 3)), 0.9, steps=20)
    assert isinstance(caught.value, ValueError)
    best = caught.value.system
    assert caught.value.overlaps == len(best.overlaps().mu) > 0
    assert best.packing_fraction == pytest.approx(0.9)
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (copy.overlaps, str(copy)) == (caught.value.overlaps, str(caught.value))
    for axes, fraction in (([[1, 1, 0]], 0.3), ([1, 1, 1], 0.3), ([[1, 1, 1]], 1.0), ([[1, 1, 1]], np.nan)):
        with pytest.raises(ValueError):
            pypw85.pack(axes, fraction)


# Semi-axes of one ellipsoid, and the largest cells in which it overlaps its own image in every orientation: one is too short, one has too
# small an area, of which ellipses on a triangular lattice need √12 times the product of their semi-axes, and one too small a volume.
THIN = {
    (1.0, 2.0, 3.0): [np.diag([9.0, 9, 2]), np.diag([9.0, 2.5, 2 * 12**0.5 / 2.5]), np.cbrt(6 * 32**0.5) * np.eye(3)],
    (1.0, 2.0): [np.diag([9.0, 2]), np.array([[2.0, 0], [1, 12**0.5]]), np.array([[12**0.5, 0], [5 * 12**0.5, 2.0]])],
}


@pytest.mark.parametrize("axes", THIN)
def test_thin_cells(axes, monkeypatch):
    """Are refused before the first step; slightly larger ones are not."""
    monkeypatch.setattr(_packing._Soft, "push", lambda *_: pytest.fail("there was a step"))
    for cell in THIN[axes]:
        fraction = _packing.UNIT_BALL[len(axes)] * np.prod(axes) / abs(np.linalg.det(cell))
        with pytest.raises(ValueError, match="ellipsoid 1 overlaps its own image in every orientation. Its images are apart by the"):
            pypw85.pack([axes], fraction * 1.001, cell, dimensions=len(axes))
        one = np.ones((1, 4)) / 2
        system = (pypw85.System.from_ellipses(0 * one[:, :2], [axes], [0.0], cell=1.001 * cell) if len(axes) == 2 else
                  pypw85.System.from_axes(0 * one[:, :3], [axes], one, cell=1.001 * cell))  # fmt: skip
        assert not _packing.too_thin(system)


def test_thin_and_partly_periodic():
    """Directions in which the system does not repeat do not matter."""
    for periodic in ((True, True, False), (False, False, True)):
        system = pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 2]], [[1, 0, 0, 0]], cell=np.diag([9, 9, 1.9]), periodic=periodic)
        assert ("apart by the length 1.9;" in _packing.too_thin(system)) == periodic[2]


def test_thin_in_any_unit():
    """Six lengths are multiplied: 2⁻¹⁸⁰⁰ is 0, and 2¹⁸⁰⁰ is infinite."""
    for unit in (2.0**-300, 1.0, 2.0**300):
        for edge, is_thin in ((3.0, False), (1.9, True)):
            system = pypw85.System.from_axes([[0, 0, 0]], [[unit] * 3], [[1, 0, 0, 0]], cell=edge * unit * np.eye(3))
            assert bool(_packing.too_thin(system)) == is_thin


def test_the_best_is_kept(monkeypatch):
    """Not the last: annealing starts with deep overlaps."""
    depths, push = [], _packing._Soft.push
    monkeypatch.setattr(_packing._Soft, "push", lambda *arguments: depths.append((found := push(*arguments)).depth) or found)
    with pytest.raises(pypw85.OverlapsLeft) as caught:
        pypw85.pack(np.tile([1, 1, 3], (30, 1)), 0.75, seed=1, steps=600)
    assert len(depths) == 600 and depths[-1] > 2 * min(depths)
    left = 0.5 * ((1 - caught.value.system.overlaps().mu ** 2) ** 2).sum()
    assert left == pytest.approx(min(depths), rel=1e-9)  # μ² to 1e-14, of centres that were wrapped; squares of 1e-2 and more


def test_interruption_keeps_the_best():
    texts = []

    def interrupt(text):
        texts.append(text)
        if len(texts) == 50:
            raise KeyboardInterrupt

    with pytest.raises(pypw85.RelaxationInterrupted) as caught:
        pypw85.pack(np.ones((20, 3)), 0.8, seed=1, stage=interrupt)
    assert isinstance(caught.value, KeyboardInterrupt)
    assert 0 < caught.value.overlaps == len(caught.value.system.overlaps().mu)
    assert str(caught.value) == f"overlaps that remain: {caught.value.overlaps}"


def test_dense_packing():
    """Spheroids of aspect ratio 3 stay stuck at this fraction where they only go downhill."""
    kinds = np.tile([1, 1, 3], (60, 1))
    system = pypw85.pack(kinds, 0.68, seed=4)
    assert len(system.overlaps().mu) == 0
    assert system.packing_fraction == pytest.approx(0.68, rel=1e-12)


def test_concentric_ellipsoids_part():
    """Nothing says which way: they are shaken."""
    system = pypw85.System.from_axes(np.zeros((2, 3)), [[1, 1, 2]] * 2, [[1, 0, 0, 0]] * 2)
    assert len(pypw85.relax(system).overlaps().mu) == 0


def test_relax_without_cell():
    system = pypw85.System.from_axes([[0, 0, 0], [0.5, 0, 0], [9, 9, 9]], [[1, 1, 2]] * 3, [[1, 0, 0, 0]] * 3)
    relaxed = pypw85.relax(system)
    assert len(relaxed.overlaps().mu) == 0
    np.testing.assert_array_equal(relaxed.centers[2], system.centers[2])
    np.testing.assert_array_equal(relaxed.semi_axes, system.semi_axes)


def test_pack_and_relax_commands(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arguments = ["-n", 20, "--axes", "1,1,2", "--axes", "2,2,1", "--spread", 0.1, "--fraction", 0.4]
    for suffix in ("data", "h5", "vtk"):
        done = run("pack", f"a.{suffix}", *arguments, "--voxels", "voxels.vtk", "--resolution", 8)
        made = rf"a\.{suffix}: 20 ellipsoids without overlaps, fraction 0\.4, cell edges \S+ \S+ \S+, nematic order 0\.\d{{4}}\n"
        assert (done.status, done.err) == (0, "") and re.fullmatch(made, done.out), done
    assert run("check", "a.data").status == 0
    system = pypw85.read("a.data")
    assert system.packing_fraction == pytest.approx(0.4, rel=1e-12)
    assert list(system.types) == [1, 2] * 10 and len(np.unique(system.semi_axes[:, 0])) == 20
    pypw85.write("b.gsd", [random_system(count=10), random_system(2, count=10)])
    assert run("check", "b.gsd").status == 1
    taken = "b.gsd: gsd, lengths of type_shapes as radii, quaternions orientation as w x y z\n"
    assert run("relax", "b.gsd", "c.h5").out == taken + "c.h5: 2 frames, 20 particles in all, without overlaps\n"
    assert run("check", "c.h5").status == 0
    done = run("pack", "d.data", "-n", 9, "--axes", "1,1,1", "--fraction", 0.9, "--steps", 5)
    left = int(re.fullmatch(r"pw85: d\.data: overlaps that remain after 5 steps: (\d+); use a larger cell or more steps "
                            r"\(--steps\); the file contains the best configuration that was found\n", done.err)[1])  # fmt: skip
    assert done.status == 1
    assert int(run("check", "d.data").out.splitlines()[3].split()[5]) == left > 0
    done = run("relax", "b.gsd", "e.h5", "--steps", 1)
    assert (done.status, done.err.count("\n")) == (1, 2) and "pw85: e.h5, from frame 1: overlaps" in done.err
    assert len(list(pypw85.frames("e.h5"))) == 2
    assert run("pack", "d.txt", *arguments).status == 2


@pytest.mark.parametrize("periodic", [True, (True, False, False)])
def test_voxels(periodic):
    """Each centre of a voxel against all images of all ellipsoids."""
    system = random_system(count=3, periodic=periodic)
    n = 12
    image = _voxels.voxels(system, n)
    grid = (np.mgrid[:n, :n, :n].reshape(3, -1).T + 0.5) / n @ system.cell + system.origin
    expected = np.zeros(n**3, dtype=int)
    for k in range(3):
        inverse = np.linalg.inv(pypw85.full(system.q[k]))
        for shift in np.mgrid[-1:2, -1:2, -1:2].reshape(3, -1).T:
            if (shift[~np.array(system.periodic)] == 0).all():
                offset = grid - system.centers[k] - shift @ system.cell
                expected[np.einsum("ni,ij,nj->n", offset, inverse, offset) <= 1] = k + 1
    np.testing.assert_array_equal(image.ravel(), expected)


def test_voxel_files(tmp_path):
    import h5py

    system = random_system(count=3, cell=np.diag([3.0, 4, 5]))
    image = _voxels.voxels(system, 6)
    _voxels.save_voxels(str(tmp_path / "a.h5"), system, 6)
    with h5py.File(tmp_path / "a.h5") as file:
        np.testing.assert_array_equal(file["voxels"], image)
    _voxels.save_voxels(str(tmp_path / "a.vtk"), system, 6)
    header, numbers = (tmp_path / "a.vtk").read_bytes().split(b"LOOKUP_TABLE default\n")
    assert b"DIMENSIONS 7 7 7\n" in header and b"SPACING 0.5 0.66666666666666663 0.83333333333333337\n" in header
    np.testing.assert_array_equal(np.frombuffer(numbers, ">i4").reshape(6, 6, 6), image.transpose(2, 1, 0))
    for name in ("a.vtk", "a.txt"):
        with pytest.raises(ValueError):
            _voxels.save_voxels(str(tmp_path / name), random_system(), 6)


def test_nematic_order(rng):
    parallel = np.tile([1.0, 2, 3, 4], (50, 1))
    zeros = np.zeros((50, 3))
    for axes in ([1, 1, 3], [3, 1, 1], [2, 2, 0.5]):
        system = pypw85.System.from_axes(zeros, [axes] * 50, parallel / np.sqrt(30))
        assert _statistics.nematic_order(system) == pytest.approx(1, abs=1e-14)
    random = rng.normal(size=(20000, 4))
    random /= np.linalg.norm(random, axis=1)[:, None]
    system = pypw85.System.from_axes(np.zeros((20000, 3)), [[1, 1, 3]] * 20000, random)
    # Entries of the mean of n dyads spread by less than 1/√n, their largest eigenvalue by less than 3/2 times 3 of these.
    assert 0 < _statistics.nematic_order(system) < 4.5 / np.sqrt(20000)


def test_correlation_of_an_ideal_gas(rng):
    """Points thrown at random are uncorrelated in μ, too."""
    n = 150
    centers, axes = rng.uniform(0, 8, (n, 3)), rng.uniform(0.3, 0.9, (n, 3))
    system = pypw85.System.from_axes(centers, axes, random_quaternions(rng, n), cell=8 * np.eye(3))
    found = _statistics.correlation(system, 2.0, 4)
    # Poisson noise of a bin, and 1 % of the estimate of excluded volumes
    assert (np.abs(found.pairs - found.uncorrelated) < 4 * np.sqrt(found.uncorrelated) + 0.01 * found.uncorrelated).all()
    assert found.uncorrelated[-1] > 500
    with pytest.raises(ValueError, match="needs a cell"):
        _statistics.correlation(pypw85.System(system.centers, system.q))
    with pytest.raises(ValueError, match="correlation: the system must have particles"):
        _statistics.correlation(pypw85.System(np.empty((0, 3)), np.empty((0, 6)), np.eye(3)))
    with pytest.raises(ValueError, match="correlation: reach must be"):
        _statistics.correlation(system, 0)
    with pytest.raises(ValueError, match="correlation: bins must be"):
        _statistics.correlation(system, 1.5, 0)


def test_compressibility_of_a_cubic_density():
    """The estimate is the density at 0 itself if it is a cubic polynomial: here by the points of a quadrature, one pair for each."""
    width, n = 0.3, 1000
    points = (np.arange(n) + 0.5) / n * width
    for power, expected in ((0, 1.0), (1, 0.0), (2, 0.0), (3, 0.0)):
        weights = points**power * width / n  # a configuration for each point, which has this share of the pairs
        sums = [_statistics.compressibility([[(1 + e) ** 2]] * 2, 1, width).value - 1 for e in points]
        # The rule of midpoints errs by (width/n)²/24 of the second derivative, which is below 2000/width³ with the factor 1/(3 width).
        assert 3 * np.dot(sums, weights) == pytest.approx(expected, abs=1e-4)


def test_compressibility_of_rods_on_a_line(rng):
    """Tonks: βP/ρ = 1/N + (1 - 1/N) L/(L - N) in one dimension, a third of whose excess over 1 is that in three."""
    n, length = 20, 32.0
    cuts = np.sort(rng.uniform(0, length - n, (10000, n)), axis=1)
    gaps = np.diff(cuts, axis=1, append=cuts[:, :1] + length - n)
    found = _statistics.compressibility((1 + gaps) ** 2, n, 0.3)
    expected = 1 + (1 / n + (1 - 1 / n) * length / (length - n) - 1) / 3
    assert found.error < 0.02
    assert abs(found.value - expected) < 4 * found.error
    # Half of the configurations, the error of which is √2 times as large
    half = _statistics.compressibility((1 + gaps[::2]) ** 2, n, 0.3)
    assert half.error == pytest.approx(np.sqrt(2) * found.error, rel=0.05)


def test_pack_refuses():
    """The text says which number is bad."""
    good = np.ones((3, 3))
    for bad in (0, -1, np.nan, np.inf):
        axes = good.copy()
        axes[2, 1] = bad
        with pytest.raises(ValueError, match=f"must be finite and > 0, not .1.0, {float(bad)}, 1.0. of ellipsoid 2$"):
            pypw85.pack(axes, 0.3)
    for axes in (np.ones(3), np.ones((3, 2)), np.ones((0, 3))):
        with pytest.raises(ValueError, match=r"rows of three numbers, not an array of the shape \("):
            pypw85.pack(axes, 0.3)
    for size in (1e160, 1e-170, 1e110):
        with pytest.raises(ValueError, match="choose another unit of length"):
            pypw85.pack(size * good, 0.3)
    for cell in (np.arange(1, 10).reshape(3, 3), np.diag([1, 1, 0]), 1e-40 * np.arange(9).reshape(3, 3)):
        with pytest.raises(ValueError, match="the vectors of the cell must not lie in a plane"):
            pypw85.pack(good, 0.3, cell)
    for cell in (np.eye(2), np.diag([1, np.nan, 1])):
        with pytest.raises(ValueError, match="three vectors of finite numbers"):
            pypw85.pack(good, 0.3, cell)
    for fraction in (0, 1, np.nan):
        with pytest.raises(ValueError, match=f"between 0 and 1, not {fraction}"):
            pypw85.pack(good, fraction)


def test_compressibility_refuses(rng):
    with pytest.raises(ValueError, match="configuration 1 overlaps"):
        _statistics.compressibility([[1.1], [1.2, 0.9]], 10)
    with pytest.raises(ValueError, match="not 1"):
        _statistics.compressibility([[1.1]], 10)
    with pytest.raises(ValueError, match="configuration 1 overlaps, or its μ² is NaN"):
        _statistics.compressibility([[1.1], [1.2, np.nan]], 10)
    with pytest.raises(ValueError, match="compressibility: num_particles must be an integer >= 1, not 0"):
        _statistics.compressibility([[1.1], [1.2]], 0)
    for width in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match=f"compressibility: width must be > 0 and at most 1, not {width}"):
            _statistics.compressibility([[1.1], [1.2]], 10, width)
    empty = pypw85.System(np.empty((0, 3)), np.empty((0, 6)))
    for function in (pypw85.nematic_order, pypw85.director):
        with pytest.raises(ValueError, match="must have particles"):
            function(empty)


def random_quaternions(rng, n):
    quaternions = rng.normal(size=(n, 4))
    return quaternions / np.linalg.norm(quaternions, axis=1)[:, None]


def test_plot(run, tmp_path):
    pypw85.write(tmp_path / "a.gsd", [random_system(seed) for seed in range(2)])
    done = run("plot", tmp_path / "a.gsd", tmp_path / "a.png", "--bins", 20)
    assert (done.status, done.err) == (0, "")
    assert [line.split()[0] for line in done.out.splitlines()] == [f"{tmp_path / 'a.gsd'}:", "frame", "0", "1"]
    assert (tmp_path / "a.png").stat().st_size > 1000
    assert run("plot", tmp_path / "a.gsd", tmp_path / "a.xyz").status == 2


def test_convert(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    systems = [random_system(seed, step=seed) for seed in range(3)]
    pypw85.write("a.dump", systems)
    assert run("convert", "a.dump", "b.gsd").status == 0
    assert run("convert", "b.gsd", "c.xyz", "--frames", "1:").status == 0
    assert [system.step for system in pypw85.frames("c.xyz")] == [1, 2]
    np.testing.assert_array_equal(pypw85.read("c.xyz").q, systems[1].q)
    assert run("convert", "a.dump", "d", "--to", "csv", "--frames", 2).status == 0
    np.testing.assert_array_equal(pypw85.read("d").q, systems[2].q)
    done = run("convert", "a.dump", "d", "--to", "csv")
    assert done.status == 2 and "holds one frame" in done.err
