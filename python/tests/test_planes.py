# SPDX-License-Identifier: BSD-3-Clause
"""Systems of ellipses in the plane: numbers by independent formulas, files, and what is refused."""

import json
import os
import pathlib
import warnings

import numpy as np
import pytest

import pypw85
from systems import read

FILES = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz" / "files"
SUFFIXES = ("dump", "data", "gsd", "xyz", "h5", "csv")
U = 2.0**-53


def gas(rng, n=400, axes=(1.0, 0.5), edges=(40.0, 30.0), origin=(0.0, 0.0), **others):
    """Ellipses at random places, which overlap."""
    places, angles = rng.uniform(size=(n, 2)) * edges + origin, rng.uniform(-np.pi / 2, np.pi / 2, n)
    return pypw85.System.from_ellipses(places, np.tile(axes, (n, 1)), angles, cell=np.diag(edges), origin=origin, **others)


def test_pairs_are_those_of_ellipses(rng, assert_rows):
    """μ², λ and overlaps of ellipsoids with z as a principal axis, whatever they are along z, are those of their sections."""
    n = 20000
    sizes = 2.0 ** rng.uniform(-40, 40, (n, 1, 1))
    axes = sizes * 2.0 ** rng.uniform(-3, 3, (n, 2, 3))
    angles = rng.uniform(0, np.pi, (n, 2))
    systems = [pypw85.System.from_axes(np.zeros((n, 3)), axes[:, k], quaternions(angles[:, k]), dimensions=2) for k in (0, 1)]
    q = [system.q for system in systems]
    flat = [form[:, [0, 1, 3]] for form in q]
    r = rng.normal(size=(n, 2))
    # μ² around 1, some of them by parts in 2⁵⁰
    r *= pypw85.closest_approach_2d(r, *flat)[:, None] * (1 + rng.choice([0.2, 1e-6, 4 * U], (n, 1)) * rng.normal(size=(n, 1)))
    r /= np.where(rng.uniform(size=(n, 1)) < 0.5, 1, np.linalg.norm(r, axis=1, keepdims=True) / sizes[:, 0])
    r12 = np.column_stack([r, np.zeros(n)])
    in_space, in_plane = pypw85.overlap(r12, *q), pypw85.overlap_2d(r, *flat)
    assert_rows(in_space == in_plane, r12, *q)
    assert 0.1 < in_plane.mean() < 0.9
    mu2, lambda_ = pypw85.contact(r12, *q)
    mu2_plane, _ = pypw85.contact_2d(r, *flat)
    # Each has the bound 4 u cond, with the cond of its λ, of which the plane's is no other.
    cond = pypw85.condition(r12, *q, lambda_)
    assert_rows(np.abs(mu2 - mu2_plane) <= 8 * U * cond * mu2, mu2, mu2_plane)


def quaternions(angles):
    zero = np.zeros(len(angles))
    return np.stack([np.cos(angles / 2), zero, zero, np.sin(angles / 2)], axis=1)


def test_from_ellipses(rng):
    """The forms are those of `ellipse`, to the rounding of half angles."""
    centers, axes, angles = rng.normal(size=(50, 2)), rng.uniform(0.5, 3, (50, 2)), rng.uniform(-np.pi / 2, np.pi / 2, 50)
    system = pypw85.System.from_ellipses(centers, axes, angles, cell=[[9, 1], [2, 8]], periodic=(True, False), origin=(1, 2))
    np.testing.assert_allclose(system.q[:, [0, 1, 3]], pypw85.ellipse(axes[:, 0], axes[:, 1], angles), rtol=0, atol=9 * 16 * U)
    np.testing.assert_allclose(system.angles, angles, rtol=0, atol=4 * U)
    np.testing.assert_array_equal(system.semi_axes[:, :2], axes)
    np.testing.assert_array_equal(system.centers, np.column_stack([centers, np.zeros(50)]))
    assert system.dimensions == 2 and system.periodic == (True, False, False)
    assert system.cell.tolist() == [[9, 1, 0], [2, 8, 0], [0, 0, 1]] and system.origin.tolist() == [1, 2, -0.5]
    assert system.volume == 70 and system.density == 50 / 70
    assert system.packing_fraction == pytest.approx(np.pi * (axes[:, 0] * axes[:, 1]).sum() / 70, rel=1e-14)
    assert pypw85.System.from_ellipses(centers, axes, angles).packing_fraction is None


def test_canonical_forms(rng):
    """Ellipsoids that are turned into the plane by other quaternions are the same, and become rotations about z."""
    n = 30
    axes, angles, half = rng.uniform(0.5, 2, (n, 3)), rng.uniform(-1.5, 1.5, n), np.sqrt(0.5)
    for turn, order in (([half, half, 0, 0], (0, 2, 1)), ([half, 0, half, 0], (2, 1, 0)), ([0, 1, 0, 0], (0, 1, 2))):
        w, (x, y) = np.cos(angles / 2), np.array(turn)[1:3]
        z, w0 = np.sin(angles / 2), turn[0]
        turned = np.stack([w * w0, w * x - z * y, w * y + z * x, z * w0], axis=1)  # first that turn, then the angle about z
        space = pypw85.System.from_axes(np.full((n, 3), 0.25), axes, turned)
        plane = pypw85.System.from_axes(np.full((n, 3), 0.25), axes, turned, dimensions=2)
        np.testing.assert_allclose(plane.q, space.q, rtol=0, atol=64 * U)
        assert (plane.quaternions[:, 1:3] == 0).all() and (plane.centers[:, 2] == 0).all()
        np.testing.assert_array_equal(np.sort(plane.semi_axes, axis=1), np.sort(axes, axis=1))
        np.testing.assert_array_equal(plane.semi_axes[:, 2], axes[:, order[2]])
    # Of a spheroid whose equal axes are at 45° to z, no axis of the body is along z.
    spheroid = pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 2]], [[np.cos(np.pi / 8), 0, 0, np.sin(np.pi / 8)]])
    tilted = pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 2]], pypw85_product([half, half, 0, 0], spheroid.quaternions[0]), dimensions=2)
    np.testing.assert_allclose(np.sort(tilted.semi_axes[0]), [1, 1, 2], rtol=1e-14)
    assert tilted.packing_fraction is None and sorted(tilted.semi_axes[0, :2].round(12)) == [1, 2]


def pypw85_product(a, b):
    (w, x, y, z), (p, q, r, s) = a, b
    return [[w * p - x * q - y * r - z * s, w * q + x * p + y * s - z * r, w * r - x * s + y * p + z * q, w * s + x * r - y * q + z * p]]


def test_refused(rng):
    flat = {"semi_axes": [[1, 1, 2]] * 2, "quaternions": [[1, 0, 0, 0]] * 2}
    with pytest.raises(ValueError, match="must lie in a plane z = constant"):
        pypw85.System.from_axes([[0, 0, 0], [0, 0, 1]], **flat, dimensions=2)
    with pytest.raises(ValueError, match="must lie in a plane z = constant"):
        pypw85.System.from_axes([[0, 0, 0]], [[1, 1, 2]], [[np.cos(0.1), np.sin(0.1), 0, 0]], dimensions=2)
    with pytest.raises(ValueError, match="components along z"):
        pypw85.System.from_axes(np.zeros((2, 3)), **flat, cell=[[1, 0, 1], [0, 9, 0], [0, 0, 9]], dimensions=2)
    with pytest.raises(ValueError, match="dimensions must be 2 or 3, not 4"):
        pypw85.System.from_axes(np.zeros((2, 3)), **flat, dimensions=4)
    good = [[0, 0]], [[1, 2]], [0.5]
    for bad, reason in (((good[0] * 2, *good[1:]), "must have the same length, not 2"), ((*good[:2], [[0.5]]), r"and the shape \(1, 1\)")):
        with pytest.raises(ValueError, match=reason):
            pypw85.System.from_ellipses(*bad)
    with pytest.raises(ValueError, match=r"the cell of a plane must be \(2, 2\), not"):
        pypw85.System.from_ellipses(*good, cell=np.eye(3))
    with pytest.raises(ValueError, match=r"the shape of origin must be \(2,\), not"):
        pypw85.System.from_ellipses(*good, cell=np.eye(2), origin=(0, 0, 0))
    space = pypw85.System.from_axes(np.zeros((2, 3)), **flat)
    with pytest.raises(ValueError, match="must be two-dimensional: only ellipses have angles"):
        space.angles  # noqa: B018
    with pytest.raises(ValueError, match="must be two-dimensional for the tetratic order"):
        pypw85.tetratic_order(space)
    empty = pypw85.System.from_ellipses(np.empty((0, 2)), np.empty((0, 2)), np.empty(0))
    with pytest.raises(ValueError, match="must have particles"):
        pypw85.tetratic_order(empty)
    with pytest.raises(ValueError, match="dimensions must be 2 or 3, not 4"):
        pypw85.compressibility([[1.1], [1.2]], 10, dimensions=4)
    plane = gas(rng, 10)
    for arguments, words in (((0, 5), "reach must be > 0 and finite"), ((np.inf, 5), "reach must be"), ((1, 0), "bins must be an integer")):
        with pytest.raises(ValueError, match=f"^pair_correlation: {words}"):
            pypw85.pair_correlation(plane, *arguments)
    with pytest.raises(ValueError, match="all must have the same dimensions"):
        pypw85.pair_correlation([], 1)
    with pytest.raises(ValueError, match="needs a cell that is periodic"):
        pypw85.pair_correlation(pypw85.System.from_ellipses(*good), 1)


@pytest.mark.parametrize("axes", [(1, 3), (3, 1)])
def test_orders(axes, rng):
    """<cos 2θ> and <cos 4θ> about the best direction, from the moments of the angles."""
    n = 4000
    angles = rng.normal(0.7, 0.3, n)
    system = pypw85.System.from_ellipses(rng.uniform(size=(n, 2)), np.tile(axes, (n, 1)), angles)
    long = angles + (np.pi / 2 if axes[0] < axes[1] else 0)
    for order, k in ((pypw85.nematic_order, 2), (pypw85.tetratic_order, 4)):
        best = max(np.cos(k * (long - phi)).mean() for phi in np.linspace(0, np.pi, 2001))
        assert order(system) == pytest.approx(best, abs=1e-5)  # of 1 - cos(k π / 4000)
        # Of a normal distribution: exp(-k² σ²/2), with an error of less than 1/√n
        assert abs(order(system) - np.exp(-0.5 * (0.3 * k) ** 2)) < 4 / np.sqrt(n)
    direction = pypw85.director(system)
    expected = 0.5 * np.angle(np.exp(2j * long).mean())
    assert direction[2] == 0 and abs(np.dot(direction[:2], [np.cos(expected), np.sin(expected)])) == pytest.approx(1, abs=3000 * U)


def test_extreme_orders(rng):
    n = 3000
    aligned = pypw85.System.from_ellipses(rng.uniform(size=(n, 2)), [[2, 1]] * n, np.full(n, 0.3))
    assert pypw85.nematic_order(aligned) == pytest.approx(1, abs=3000 * U)
    assert pypw85.tetratic_order(aligned) == pytest.approx(1, abs=3000 * U)
    crossed = pypw85.System.from_ellipses(rng.uniform(size=(n, 2)), [[2, 1]] * n, 0.3 + np.arange(n) % 2 * np.pi / 2)
    assert pypw85.nematic_order(crossed) < 3000 * U
    assert pypw85.tetratic_order(crossed) == pytest.approx(1, abs=3000 * U)
    # Both are lengths of a mean of n random unit vectors of the plane, which exceed 4/√n with the probability exp(-16).
    isotropic = gas(rng, n)
    assert max(pypw85.nematic_order(isotropic), pypw85.tetratic_order(isotropic)) < 4 / np.sqrt(n)
    # Discs have no direction, however long along z.
    mixed = pypw85.System.from_axes(np.zeros((4, 3)), [[2, 1, 9], [2, 1, 9], [1, 1, 9], [1, 1, 0.1]], [[1, 0, 0, 0]] * 4, dimensions=2)
    assert pypw85.nematic_order(mixed) == 1
    discs = pypw85.System.from_ellipses([[0, 0]], [[1, 1]], [0])
    assert np.isnan(pypw85.nematic_order(discs)) and np.isnan(pypw85.tetratic_order(discs)) and np.isnan(pypw85.director(discs)).all()


def test_pair_correlation_of_an_ideal_gas(rng):
    """g = 1 in rings within its error, and directions do not know of each other."""
    found = pypw85.pair_correlation([gas(rng, 300) for _ in range(40)], reach=25, bins=5)  # farther than half of the cell
    assert (np.abs(found.g - 1) < 4.5 * found.g_error).all() and (found.g_error < 0.02).all()
    assert (np.abs(found.p2) < 4.5 * found.p2_error).all() and (found.p2_error < 0.02).all()
    # By brute force, over images
    one = gas(rng, 40, edges=(7.0, 5.0))
    counts, cosines = np.zeros(3), np.zeros(3)
    shifts = np.stack(np.meshgrid(np.arange(-2, 3), np.arange(-2, 3)), axis=-1).reshape(-1, 2) @ one.cell[:2, :2]
    for i in range(40):
        for j in range(i):
            distances = np.linalg.norm(one.centers[i, :2] - one.centers[j, :2] + shifts, axis=1)
            bins = np.histogram(distances, [0, 1, 2, 3])[0]
            counts += bins
            cosines += bins * np.cos(2 * (one.angles[i] - one.angles[j]))
    found = pypw85.pair_correlation(one, 3, 3)
    np.testing.assert_allclose(found.g, counts / (40 * 39 / 2 / 35 * np.pi * np.array([1, 3, 5])), rtol=1e-13)
    np.testing.assert_allclose(found.p2, cosines / counts, rtol=0, atol=1e-13)
    assert np.isnan(found.g_error).all() and np.isnan(found.p2_error).all()


def test_correlation_of_an_ideal_gas(rng):
    """In μ. The excluded area of ellipses at all angles by another formula: 2 A + C1 C2/(2π), with their circumferences."""
    found = [pypw85.correlation(gas(rng, 300, (1.5, 0.5)), 2.0, 4) for _ in range(20)]
    pairs, uncorrelated = (np.sum([getattr(one, name) for one in found], axis=0) for name in ("pairs", "uncorrelated"))
    assert (np.abs(pairs - uncorrelated) < 4.5 * np.sqrt(uncorrelated) + 0.01 * uncorrelated).all()  # 1 % of the estimate of the areas
    t = np.linspace(0, 2 * np.pi, 4000, endpoint=False)
    around = np.hypot(1.5 * np.sin(t), 0.5 * np.cos(t)).mean() * 2 * np.pi
    excluded = 2 * np.pi * 1.5 * 0.5 + around**2 / (2 * np.pi)
    assert found[0].uncorrelated.sum() == pytest.approx(0.5 * 300**2 * 4 * excluded / 1200, rel=0.01)


def test_compressibility_of_discs(rng):
    """βP/ρ = 1 + n'(0)/(2 N): of pairs whose density in μ is constant, as the exact value for one pair each."""
    n, density = 4000, 30.0
    mu2 = [(1 + rng.uniform(0, 0.2, rng.poisson(0.2 * density))) ** 2 for _ in range(n)]
    found = pypw85.compressibility(mu2, 10, 0.2, dimensions=2)
    assert abs(found.value - (1 + density / 20)) < 4 * found.error < 0.4


class Frozen(pypw85.HardEllipsoids):
    """Stands for a simulation in a state."""

    def __init__(self, system):
        self.given = system

    def system(self):
        return self.given

    def energy(self):
        return 0.0

    def law_virial(self):
        return 0.0


def test_observables(rng):
    """Averages over systems of ellipses are those of the functions of one system."""
    systems = [gas(rng, 64, axes=(0.1, 0.05), edges=(8.0, 8.0)) for _ in range(8)]
    observables = pypw85.Observables(width=0.5, reach=3.0, bins=4)
    for system in systems:
        sample = observables.add(Frozen(system))
        assert (sample.volume, sample.density, sample.packing_fraction) == (64, 1, system.packing_fraction)
        assert sample.nematic_order == pytest.approx(pypw85.nematic_order(system), abs=1e-14)
        found = system.neighbors(1.5)
        mu2 = pypw85.contact_pairs(found.pairs, system.centers, system.q, system.cell, images=found.images)[0]
        expected = pypw85.compressibility([np.maximum(mu2, 1)] * 2, 64, 0.5, dimensions=2).value
        assert sample.compressibility_contacts == pytest.approx(expected, rel=1e-13)
    found, other = observables.pair_correlation(), pypw85.pair_correlation(systems, 3.0, 4)
    np.testing.assert_allclose(found.g, other.g, rtol=1e-13)
    np.testing.assert_allclose(found.p2, other.p2, rtol=0, atol=1e-13)
    assert observables.director()[2] == 0
    with pytest.raises(ValueError, match="periodic along its two vectors"):
        observables.add(Frozen(gas(rng, 9, periodic=(True, False))))
    assert len(observables) == 8


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_round_trip(suffix, rng, tmp_path):
    """Ellipses in cells, whose third vector is not written, stay what they are."""
    system = gas(rng, 50, edges=(40.0, 30.0), origin=(-20, -15), types=np.arange(50) % 2 + 1, step=3)
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message=".*dimensional")
        warnings.filterwarnings("ignore", message=".*(GSD)")
        pypw85.write(tmp_path / f"a.{suffix}", system, **({"precision": "double"} if suffix == "gsd" else {}))
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        again = pypw85.read(tmp_path / f"a.{suffix}")
    says = suffix not in ("dump", "data")
    assert says == again.source.endswith("two-dimensional, as the file says")
    assert [says or "taken as two-dimensional" in str(one.message) for one in warned] == [True] * (not says)
    assert (again.dimensions, again.periodic, again.packing_fraction) == (2, (True, True, False), system.packing_fraction)
    for name in ("centers", "semi_axes", "quaternions", "q", "cell", "origin"):
        np.testing.assert_array_equal(getattr(again, name), getattr(system, name))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_without_cell(suffix, rng, tmp_path):
    system = pypw85.System.from_ellipses(rng.uniform(size=(9, 2)), [[2, 1]] * 9, rng.uniform(size=9))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        pypw85.write(tmp_path / f"a.{suffix}", system)
        again = pypw85.read(tmp_path / f"a.{suffix}")
    assert again.dimensions == 2
    assert len(again.overlaps().mu) == len(system.overlaps().mu)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_flat_in_space(suffix, rng, tmp_path):
    """What the user took as three-dimensional stays so, or a note says that it will not."""
    n = 20
    system = pypw85.System.from_axes(rng.uniform(0, 9, (n, 3)) * [1, 1, 0], [[1, 1, 1]] * n, [[1, 0, 0, 0]] * n, cell=np.diag([9, 9, 1.5]))
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        pypw85.write(tmp_path / f"a.{suffix}", system)
    if any("--dimensions 3" in str(one.message) for one in said):
        assert suffix in ("dump", "data")
    else:
        assert pypw85.read(tmp_path / f"a.{suffix}").dimensions == 3


def test_layer_of_no_stated_dimensions(run, tmp_path):
    """Three ellipsoids in one plane and a cell that is not periodic across it may be a layer, or ellipses. Both are possible, and the
    reader says which one it takes."""
    lines = ["3", 'Lattice="9 0 0 0 9 0 0 0 9" pbc="T T F" Properties=pos:R:3:aspherical_shape:R:3:orientation:R:4']
    path = tmp_path / "layer.xyz"
    for heights, words in (((1, 1, 1), "--dimensions 2 if its particles are ellipses"), ((1, 2, 1), "")):
        rows = [f"{3 * k} 1 {z} 1 0.5 0.5 0 0 0 1" for k, z in enumerate(heights)]
        path.write_text("\n".join([*lines, *rows]) + "\n")
        system = pypw85.read(path)
        assert system.dimensions == 3 and len(system.notes) == bool(words) and words in "".join(system.notes)
    path.write_text("\n".join([*lines, *(f"{3 * k} 1 1 1 0.5 0.5 0 0 0 1" for k in range(3))]) + "\n")
    for dimensions in ("2", "3"):
        done = run("check", path, "--dimensions", dimensions)
        assert "if its particles are ellipses" not in done.out + done.err


def test_one_particle_for_lammps(tmp_path):
    """Of which LAMMPS's files do not show that it is in a plane."""
    system = pypw85.System.from_ellipses([[0, 0]], [[2, 1]], [0], cell=9 * np.eye(2))
    for suffix in ("dump", "data"):
        with pytest.warns(UserWarning, match="say so where it is read .--dimensions 2"):
            pypw85.write(tmp_path / f"a.{suffix}", system)
        with warnings.catch_warnings():  # the user says it: no warning says it again
            warnings.filterwarnings("error", message="the system is taken as")
            assert pypw85.read(tmp_path / f"a.{suffix}", dimensions=2).dimensions == 2


ELLIPSES = {
    "x,y,a,b,angle_degrees": "1,2,3,1,30",
    "x,y,a,b,angle (deg)": "1,2,3,1,30",
    "x;y;a;b;theta [rad]": "1;2;3;1;0,52359877559829882",
    "X Y semi_major semi_minor angle_rad": "1 2 3 1 0.52359877559829882",
    "# dimensions 2\nx,y,z,a,b,c,angle_deg": "1,2,7,3,1,9,30",
    "x,y,diameter_x,diameter_y,angle_deg": "1,2,6,2,30",
    "x,y,a,b,angle_deg,angle_rad": "1,2,3,1,30,0.52359877559829882",
}


@pytest.mark.parametrize("header", ELLIPSES)
def test_tables_of_ellipses(header, tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(f"# cell 9 0 0 9\n# origin 1 1\n# periodic T F\n{header}\n{ELLIPSES[header]}\n")
    if header.startswith("# dimensions"):
        system = pypw85.read(path)
        assert system.source.endswith("two-dimensional, as the file says") and not system.notes
    else:
        with pytest.warns(UserWarning, match="taken as two-dimensional"):
            system = pypw85.read(path)
    assert system.dimensions == 2 and system.periodic == (True, False, False) and system.volume == 81
    assert system.centers.tolist() == [[1, 2, 0]] and system.origin.tolist() == [1, 1, -0.5]
    np.testing.assert_array_equal(system.semi_axes[:, :2], [[3, 1]])
    np.testing.assert_allclose(system.angles, [np.pi / 6], rtol=0, atol=2 * U)
    assert " in radians" in system.source or " in degrees" in system.source


REFUSED = {
    "x,y,a,b,angle\n1,2,3,1,30": "angle may be in degrees or in radians: use --angle degrees or --angle radians",
    "x,y,major,minor,angle_deg\n1,2,3,1,30": "major minor may be whole axes or semi-axes: use --lengths",
    "x,y,a,b\n1,2,3,1": "is not a sphere, and lacks an orientation: write quaternions, or the angles of ellipses",
    "x,y,a,b,angle_deg\n1,2,3,1,nan": "line 2: particle 1 has an angle that is not finite",
    "x,y,z,a,b,angle_deg\n1,2,0,3,1,30": "angle_deg may be the angle of ellipses in a plane, or a rotation in space",
    "x,y,z,a,b,c,angle_deg\n1,2,0,3,1,1,30": "angle_deg may be the angle of ellipses in a plane, or a rotation in space",
    "x,y,a,b,orientation\n1,2,3,1,1": "orientation may be counted from the axis x or from y: use --angle-zero",
    "# dimensions 2\nx,y,z,a,b,angle_deg\n1,2,0,3,1,30\n1,2,1,3,1,30": "several z|do not lie in one plane",
    "# dimensions 4\nx,y,radius\n1,2,3": "line 1: the comment '# dimensions' must be followed by 2 or 3, .*, not by '4'",
    "# an image\n# dimensions 10 x 10\nx,y,radius\n1,2,3": "line 2: the comment '# dimensions' .* not by '10 x 10': correct it, or reword",
    "# origin 1 2\nx,y,radius\n1,2,3": "the comments '# origin' and '# periodic' have two values, which need '# cell' and four numbers",
    "# origin 10 um\nx,y,radius\n1,2,3": "line 1: the comment '# origin' must be followed by three numbers, the corner of the cell",
    "# cell 10 10 10\nx,y,radius\n1,2,3": "line 1: the comment '# cell' must be followed by nine numbers, the three vectors of the cell",
    "# dimensions 2\nx,y,z,a,b,c,qw,qx,qy,qz\n1,2,0,3,2,1,0.96,0.28,0,0": "rotated out of it: the file says",
    "# dimensions 2\n# cell 1 0 1 0 1 0 0 0 1\nx,y,z,radius\n1,2,0,3": "the first two vectors of the cell do not lie in the plane",
}


@pytest.mark.parametrize("text", REFUSED)
def test_refused_tables(text, tmp_path):
    (tmp_path / "a.csv").write_text(text + "\n")
    if "several z" in REFUSED[text]:
        with pytest.warns(UserWarning, match="its centres have several z, which do not count"):
            pypw85.read(tmp_path / "a.csv")
        return
    with pytest.raises(pypw85.FileError, match=REFUSED[text]):
        pypw85.read(tmp_path / "a.csv")


def test_options_decide(run, tmp_path):
    (tmp_path / "a.csv").write_text("x,y,major,minor,angle\n1,2,6,2,0.5\n")
    with pytest.warns(UserWarning):
        system = pypw85.read(tmp_path / "a.csv", lengths="diameters", angle="radians")
    np.testing.assert_allclose([*system.angles, *system.semi_axes[0, :2]], [0.5, 3, 1], atol=2 * U)
    with pytest.warns(UserWarning):
        system = pypw85.read(tmp_path / "a.csv", lengths="radii", angle="degrees")
    np.testing.assert_allclose([*system.angles, *system.semi_axes[0, :2]], [np.radians(0.5), 6, 2], atol=2 * U)
    with pytest.raises(pypw85.FileError, match="angle may be the angle of ellipses in a plane, or a rotation"):
        pypw85.read(tmp_path / "a.csv", lengths="radii", angle="degrees", dimensions=3)
    done = run("check", tmp_path / "a.csv", "--lengths", "radii", "--angle", "degrees")
    assert (done.status, "angle in degrees" in done.out, "two-dimensional" in done.err) == (0, True, True)
    done = run("check", tmp_path / "a.csv", "--lengths", "radii")
    assert done.status == 2 and "--angle degrees" in done.err
    done = run("check", FILES / "flat_gas.gsd", "--angle", "degrees")
    assert done.status == 2 and "leave out --angle" in done.err


def test_ellipses_in_other_formats(tmp_path):
    """Dumps and extended XYZ with the columns of ellipses, and HDF5 with data sets of them."""
    import h5py

    (tmp_path / "a.dump").write_text("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n-0.5 0.5\n"
                                     "ITEM: ATOMS id type x y shapex shapey angle_deg\n1 1 1 2 6 2 30\n")  # fmt: skip
    (tmp_path / "a.xyz").write_text('1\nDimensions=2 Lattice="9 0 0 0 9 0 0 0 1" Properties=species:S:1:pos:R:2:aspherical_shape:R:2:'
                                    "angle_deg:R:1\nA 1 2 3 1 30\n")  # fmt: skip
    with h5py.File(tmp_path / "a.h5", "w") as file:
        group = file.create_group("particles/all")
        group["position"], group["semi_axes"], group["angle"] = [[1.0, 2]], [[3.0, 1]], [30.0]
        group["box/edges"] = [9.0, 9, 1]
    with pytest.raises(pypw85.FileError, match="may be in degrees or in radians: give it the attribute unit"):
        pypw85.read(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5", "a") as file:
        file["particles/all/angle"].attrs["unit"] = "deg"
    for suffix in ("dump", "xyz", "h5"):
        system = read(tmp_path / f"a.{suffix}")
        assert "two-dimensional" in system.source + " ".join(system.notes)
        assert system.dimensions == 2 and system.volume == 81
        np.testing.assert_array_equal(np.concatenate([system.centers[0, :2], system.semi_axes[0, :2]]), [1, 2, 3, 1])
        np.testing.assert_allclose(system.angles, [np.pi / 6], rtol=0, atol=2 * U)
        assert "in degrees" in system.source
    (tmp_path / "a.xyz").write_text("1\nDimensions=5 Properties=species:S:1:pos:R:3:radius:R:1\nA 1 2 0 3\n")
    with pytest.raises(pypw85.FileError, match="'Dimensions' must be 2 or 3, not 5"):
        pypw85.read(tmp_path / "a.xyz")


def test_planes_of_h5md(tmp_path):
    """Boxes of two vectors, and attributes that are not those of a plane."""
    import h5py

    with h5py.File(tmp_path / "a.h5", "w") as file:
        group = file.create_group("particles/all")
        group["position"], group["semi_axes"], group["angle"] = [[1.0, 2]], [[3.0, 1]], [30.0]
        group["angle"].attrs["unit"] = "deg"
        group["box/edges"] = [[9.0, 1], [0, 9]]
        group["box/offset"], group["box"].attrs["boundary"] = [-1.0, 2], np.array([b"none", b"periodic"])
    with pytest.warns(UserWarning, match="taken as two-dimensional"):
        system = pypw85.read(tmp_path / "a.h5")
    assert system.cell.tolist() == [[9, 1, 0], [0, 9, 0], [0, 0, 1]] and system.periodic == (False, True, False)
    assert system.origin.tolist() == [-1, 2, -0.5]
    with h5py.File(tmp_path / "a.h5", "a") as file:
        file["particles/all/box"].attrs["boundary"] = np.array([b"none"] * 3)
    with pytest.raises(pypw85.FileError, match="boundary of the box must be two of"):
        pypw85.read(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5", "a") as file:
        del file["particles/all/box"]
        file["particles/all"].attrs["dimensions"] = 4
    with pytest.raises(pypw85.FileError, match="the attribute dimensions must be 2 or 3, not 4"):
        pypw85.read(tmp_path / "a.h5")
    flat, solid = gas(np.random.default_rng(1), 5), pypw85.System.from_axes(np.eye(3), np.ones((3, 3)), [[1, 0, 0, 0]] * 3)
    with pytest.raises(ValueError, match="frame 1 has another number of dimensions"):
        pypw85.write(tmp_path / "b.h5", [flat, solid])


def test_seeds_of_microstructpy(tmp_path):
    """As its Ellipse and Circle print themselves: semi-axes and degrees."""
    text = ("Geometry: ellipse\ncenter: (np.float64(1.0), 2.0)\na: 3.0\nb: 1.0\nangle: 30.0\nphase: 1\nposition: (1.0, 2.0)\n"
            "Geometry: circle\nRadius: 2.0\nCenter: (9.0, 9.0)\nphase: 0\nposition: (9.0, 9.0)\n")  # fmt: skip
    (tmp_path / "a.txt").write_text(text)
    system = pypw85.read(tmp_path / "a.txt")
    assert system.source.endswith("two-dimensional, as the file says")
    assert system.dimensions == 2 and system.centers.tolist() == [[1, 2, 0], [9, 9, 0]] and system.types.tolist() == [1, 0]
    np.testing.assert_array_equal(system.semi_axes[:, :2], [[3, 1], [2, 2]])
    np.testing.assert_allclose(system.angles, [np.pi / 6, 0], rtol=0, atol=2 * U)
    assert repr(system) == "<System of 2 ellipses in a plane, no cell>"
    for bad, reason in ((text.replace("30.0", "a"), "the angle of an ellipse must be 1 number,"),
                        (text + (FILES / "seeds.txt").read_text(), "seeds of two and of three dimensions"),
                        (text.replace("(1.0, 2.0)", "(1.0, 2.0, 3.0)"), "the position of a seed must be 2 numbers")):  # fmt: skip
        (tmp_path / "a.txt").write_text(bad)
        with pytest.raises(pypw85.FileError, match=reason):
            pypw85.read(tmp_path / "a.txt")


def test_check_of_a_flat_gas(run, tmp_path):
    """g5 of the reports: area fraction 0.393, S2 0.037."""
    done = run("check", FILES / "flat_gas.gsd", "--json", tmp_path / "a.json", "--hdf5", tmp_path / "a.h5")
    assert "area fraction" in done.out and "packing fraction" not in done.out
    (frame,) = json.loads((tmp_path / "a.json").read_text())["frames"]
    assert frame["dimensions"] == 2
    assert frame["packing_fraction"] == pytest.approx(0.3927, abs=1e-4)
    assert frame["nematic_order"] == pytest.approx(0.0366, abs=1e-4)
    assert frame["density"] == pytest.approx(0.25, rel=1e-12)
    assert frame["volume"] == pytest.approx(1600, rel=1e-12)
    assert np.hypot(*frame["director"][:2]) == pytest.approx(1) and frame["director"][2] == 0
    assert 0 < frame["tetratic_order"] < 0.1


def in_plane(system):
    """Bit by bit."""
    zeros = np.column_stack([system.centers[:, 2], system.quaternions[:, 1:3], system.q[:, [2, 4]]])
    return system.dimensions == 2 and not zeros.any() and not np.signbit(zeros).any()


def test_pack(rng):
    axes = np.array([[2, 1], [1, 1]])[np.arange(40) % 2]
    system = pypw85.pack(axes, 0.8, [[2, 0], [1, 1]], seed=3, dimensions=2)
    assert len(system.overlaps().mu) == 0 and in_plane(system)
    assert system.packing_fraction == pytest.approx(0.8, rel=1e-12)
    np.testing.assert_array_equal(system.semi_axes[:, :2], axes)
    np.testing.assert_allclose(system.cell[1, 0], system.cell[1, 1])
    np.testing.assert_array_equal(pypw85.pack(axes, 0.8, [[2, 0], [1, 1]], seed=3, dimensions=2).q, system.q)


def test_relax(run, rng, tmp_path):
    """Concentric ones part, too, by shaking in the plane; relaxation finds what the exact test of ellipses finds."""
    concentric = pypw85.System.from_ellipses([[0, 0]] * 2, [[2, 1]] * 2, [0, 0])
    for system in (gas(rng, 60, edges=(14.0, 14.0), types=np.arange(60), origin=(3, 1)), concentric):
        relaxed = pypw85.relax(system)
        assert len(relaxed.overlaps().mu) == 0 and in_plane(relaxed)
        for name in ("semi_axes", "types", "cell", "origin"):
            np.testing.assert_array_equal(getattr(relaxed, name), getattr(system, name))
    with pytest.raises(pypw85.OverlapsLeft) as caught:
        pypw85.pack([[1, 1]] * 10, 0.95, steps=20, dimensions=2)
    assert in_plane(caught.value.system) and caught.value.overlaps == len(caught.value.system.overlaps().mu) > 0
    pypw85.write(tmp_path / "a.xyz", gas(rng, 20, edges=(10.0, 10.0)))
    assert run("relax", tmp_path / "a.xyz", tmp_path / "b.dump").status == 0
    done = run("check", tmp_path / "b.dump")
    assert done.status == 0 and "area fraction" in done.out


def test_forces_are_derivatives_of_the_energy(rng):
    """In the plane; the other components of forces and torques are 0."""
    from pypw85 import _packing

    system, swelling = gas(rng, 30, edges=(9.0, 9.0)), 1.01
    soft = _packing._Soft(system)
    push = soft.push(swelling)
    forces, torques = push.force[0] / soft.length, push.force[1]
    assert not forces[:, 2].any() and not torques[:, :2].any() and forces[:, :2].any() and torques[:, 2].any()

    def energy(move, turn):
        swollen = pypw85.System.from_ellipses(
            system.centers[:, :2] + move, swelling * system.semi_axes[:, :2], system.angles + turn, cell=system.cell[:2, :2])  # fmt: skip
        return 0.5 * ((1 - swollen.overlaps().mu ** 2) ** 2).sum()

    for _ in range(3):
        move, turn, h = rng.normal(size=(30, 2)), rng.normal(size=30), 1e-5
        slope = -(forces[:, :2] * move).sum() - (torques[:, 2] * turn).sum()
        difference = (energy(h * move, h * turn) - energy(-h * move, -h * turn)) / (2 * h)
        np.testing.assert_allclose(difference, slope, rtol=1e-6, atol=1e-7)  # h² of third derivatives, and 1e-15 energy / h


def test_pack_refuses():
    good = np.ones((3, 2))
    for axes, fraction, cell, dimensions, reason in (
        (np.ones((3, 3)), 0.3, None, 2, r"rows of two numbers, not an array of the shape \(3, 3\)"),
        (good, 0.3, None, 3, r"rows of three numbers, not an array of the shape \(3, 2\)"),
        (good, 0.3, np.eye(3), 2, "two vectors of finite numbers"),
        (good, 0.3, [[1, 1], [2, 2]], 2, "lie in a line"),
        (good, 1.0, None, 2, "between 0 and 1, not 1.0"),
        (good, 0.3, None, 4, "dimensions must be 2 or 3, not 4"),
    ):
        with pytest.raises(ValueError, match=reason):
            pypw85.pack(axes, fraction, cell, dimensions=dimensions)
    with pytest.raises(ValueError, match="must be three-dimensional for a voxel image"):
        pypw85.voxels(pypw85.System.from_ellipses([[0, 0]], [[1, 1]], [0], cell=4 * np.eye(2)), 4)


def test_picture(rng):
    """Each ellipse once, and those of its images that reach into the cell."""
    from matplotlib.collections import EllipseCollection

    system = pypw85.System.from_ellipses([[0.5, 5], [9.9, 9.9], [5, 5], [-14, 5]], [[1, 0.5], [1, 0.5], [2, 2], [1, 0.5]],
                                         [0, np.pi / 4, 0, np.pi / 2], cell=10 * np.eye(2))  # fmt: skip
    axes = system.draw(contacts=True)
    parts = {one.get_label(): one for one in axes.collections if isinstance(one, EllipseCollection)}
    assert axes.get_title() == "4 ellipses, 1 overlapping pairs"
    places = {name: sorted(map(tuple, one.get_offsets().round(12).tolist())) for name, one in parts.items()}
    assert places["overlapping ellipses"] == [(5, 5), (6, 5)] and places["ellipses"] == [(0.5, 5), (9.9, 9.9)]
    assert places["images"] == [(-0.1, -0.1), (-0.1, 9.9), (9.9, -0.1), (10.5, 5)]
    marked = parts["overlapping ellipses"]
    disc, ellipse = marked.get_facecolors()[np.argsort(marked.get_offsets()[:, 0]), :3]
    assert np.ptp(disc) == 0 < np.ptp(ellipse)  # a disc is grey
    (marks,) = (one for one in axes.collections if one.get_label() == "contact points")
    np.testing.assert_allclose(np.abs(marks.get_offsets() - [5.5, 5]).max(), 0, atol=2.5)
    np.testing.assert_allclose(parts["ellipses"]._angles, np.radians([0, 45]), atol=1e-14)
    assert axes.get_xlim()[0] < 0 and axes.get_xlim()[1] > 10
    outside = pypw85.System.from_ellipses([[15, 5], [5, 5]], [[2, 1]] * 2, [0, 0], cell=10 * np.eye(2), periodic=False)
    (ellipses,) = (one for one in outside.draw().collections if isinstance(one, EllipseCollection))
    assert sorted(ellipses.get_offsets()[:, 0]) == [5, 15]


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_draw(suffix, run, rng, tmp_path):
    pypw85.write(tmp_path / "a.h5", gas(rng, 30))
    done = run("draw", tmp_path / "a.h5", tmp_path / f"a.{suffix}", "--contacts", "--size", 400)
    assert done.status == 0 and "two-dimensional" in done.out + done.err
    assert (tmp_path / f"a.{suffix}").stat().st_size > 1000
    done = run("draw", tmp_path / "a.h5", tmp_path / "a.html")
    assert done.status == 2 and "a page shows ellipsoids, but these are ellipses in a plane" in done.err
    pypw85.System.from_ellipses([[0, 0], [3, 1]], [[2, 1]] * 2, [0, 1]).draw(tmp_path / f"b.{suffix}")  # without a cell


def test_plot(run, rng, tmp_path):
    pypw85.write(tmp_path / "a.h5", [gas(rng, 50) for _ in range(2)])
    done = run("plot", tmp_path / "a.h5", tmp_path / "a.svg", "--bins", 10)
    assert done.status == 0
    taken, header, *rows = done.out.splitlines()
    assert taken.startswith(f"{tmp_path / 'a.h5'}: hdf5, lengths semi_axes as radii")
    assert header.split() == ["frame", "step", "nematic", "order", "tetratic", "order"] and [len(row.split()) for row in rows] == [4, 4]
    assert (tmp_path / "a.svg").stat().st_size > 1000
    systems = [gas(rng, 9), pypw85.System.from_axes(np.eye(3), [[1, 1, 2]] * 3, [[1, 0, 0, 0]] * 3, cell=9 * np.eye(3))]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        pypw85.write(tmp_path / "b.xyz", systems)
    done = run("plot", tmp_path / "b.xyz", tmp_path / "b.svg")
    assert done.status == 2 and "frames have different dimensions" in done.err
