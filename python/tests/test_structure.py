# SPDX-License-Identifier: BSD-3-Clause
"""Structure factors, layers, columns, bond order, angular correlations and displacements: exact cases and independent formulas."""

import numpy as np
import pytest

import pypw85

TRICLINIC = np.array([[7.0, 0.5, 0.0], [-1.0, 6.0, 0.3], [0.4, 1.1, 8.0]])
FCC = np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
BCC = np.array([[0, 0, 0], [0.5, 0.5, 0.5]])
ROD = [0.1, 0.1, 0.5]


def system_of(places, axes, quaternions, cell, **others):
    return pypw85.System.from_axes(places, axes, quaternions, cell=cell, **others)


def crystal(basis, cells, vectors=None, axes=(0.1, 0.1, 0.1), quaternions=None, **others):
    """A lattice with a basis, in multiples of the vectors of its cell."""
    vectors = np.eye(3) if vectors is None else np.asarray(vectors, dtype=float)
    corners = np.stack(np.meshgrid(*map(np.arange, cells), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    places = (corners + np.asarray(basis)).reshape(-1, 3) @ vectors
    turns = np.tile([1.0, 0, 0, 0], (len(places), 1)) if quaternions is None else quaternions
    return system_of(places, np.tile(axes, (len(places), 1)), turns, np.diag(cells) @ vectors, **others)


def gas(rng, n=300, cell=TRICLINIC, axes=ROD, **others):
    turns = rng.normal(size=(n, 4))
    return system_of(rng.uniform(size=(n, 3)) @ cell, np.tile(axes, (n, 1)), turns, cell, **others)


@pytest.mark.parametrize("reach", [1e13, 1e300])
def test_wave_vectors_beyond_memory(reach, rng):
    """Also where their multiples are beyond whole numbers of 64 bits: no empty list is returned."""
    with pytest.raises(MemoryError, match="there is not enough memory for all wave vectors up to the length 1e.*"):
        pypw85.wave_vectors(gas(rng, 1), reach)


def test_wave_vectors_are_those_of_the_cell(rng):
    """exp(i q·a) is 1 for each vector a of the cell, and all such q up to the reach are there, one of each and its negative."""
    multiples, vectors = pypw85.wave_vectors(gas(rng, 1), 5.0)
    np.testing.assert_allclose(vectors @ TRICLINIC.T, 2 * np.pi * multiples, rtol=0, atol=1e-12)
    assert (np.linalg.norm(vectors, axis=1) <= 5).all() and multiples.any(axis=1).all()
    every = np.stack(np.meshgrid(*[np.arange(-15, 16)] * 3), axis=-1).reshape(-1, 3)
    length = np.linalg.norm(every @ (2 * np.pi * np.linalg.inv(TRICLINIC).T), axis=1)
    expected = {tuple(row) for row in every[(length <= 5) & (length > 0)].tolist()}
    found = {tuple(row) for row in multiples.tolist()}
    assert not found & {tuple(row) for row in (-multiples).tolist()}
    assert found | {tuple(row) for row in (-multiples).tolist()} == expected and len(expected) > 500


def test_modes_by_their_definition(rng):
    """In a skewed cell with an origin, with more particles than are in memory at a time."""
    system = gas(rng, 5000, origin=[3.0, -1.0, 2.0])
    multiples, vectors = pypw85.wave_vectors(system, 2.0)
    multiples, vectors = np.vstack([multiples, -multiples[::2]]), np.vstack([vectors, -vectors[::2]])
    order = rng.permutation(len(multiples))
    direct = np.exp(1j * (system.centers - system.origin) @ vectors.T).sum(axis=0)
    np.testing.assert_allclose(pypw85.density_modes(system, multiples[order]), direct[order], rtol=0, atol=1e-9)
    assert pypw85.density_modes(system, np.zeros((0, 3), int)).shape == (0,)
    # Particles may be at any image.
    moved = pypw85.System(system.centers + rng.integers(-2, 3, (5000, 3)) @ TRICLINIC, system.q, TRICLINIC, origin=system.origin)
    np.testing.assert_allclose(pypw85.density_modes(moved, multiples), pypw85.density_modes(system, multiples), rtol=0, atol=1e-8)


@pytest.mark.parametrize("vectors", [np.eye(3), [[1, 0, 0], [0.3, 0.9, 0], [-0.2, 0.1, 1.2]]])
def test_peaks_of_a_lattice(vectors):
    """S is N at the reciprocal vectors of a lattice, times the square of the basis, and 0 between them."""
    system = crystal(FCC, (4, 3, 5), vectors)
    multiples, _ = pypw85.wave_vectors(system, 18.0)
    s = np.abs(pypw85.density_modes(system, multiples)) ** 2 / len(system)
    order = multiples / np.array([4, 3, 5])
    # h, k and l are all odd or all even at the peaks of a face-centred lattice
    peaks = (order == np.round(order)).all(axis=1) & np.isin((order % 2).sum(axis=1), (0, 3))
    np.testing.assert_allclose(s, np.where(peaks, len(system), 0), rtol=0, atol=1e-9)
    assert peaks.sum() >= 4


def test_structure_factor_of_a_gas(rng):
    """1 within the error, and the error is that of independent systems. Bins without vectors have no value."""
    systems = [gas(rng, 50) for _ in range(400)]
    found = pypw85.structure_factor(iter(systems), 3.0, 12)
    assert found.vectors[0] == 0 and np.isnan(found.s[0]) and np.isnan(found.q[0])
    z = (found.s[3:] - 1) / found.s_error[3:]
    assert 0.3 < np.sqrt(np.mean(z**2)) < 1.8
    # |Σ exp(i q·r)|²/N of one vector has the variance 1 - 1/N
    expected = np.sqrt((1 - 1 / 50) / found.vectors[3:] / 400)
    assert (0.7 < found.s_error[3:] / expected).all() and (found.s_error[3:] / expected < 1.7).all()
    assert (found.edges[3:-1] <= found.q[3:]).all() and (found.q[3:] <= found.edges[4:]).all()
    multiples, _ = pypw85.wave_vectors(systems[0], 3.0)
    assert found.vectors.sum() == len(multiples)
    assert np.isnan(pypw85.structure_factor(systems[:31], 3.0, 12).s_error).all()


def test_structure_factor_of_a_changing_cell(rng):
    """Wave vectors are those of the cell of each system; the bins hold what they have together."""
    systems = [gas(rng, 40, TRICLINIC * scale) for scale in rng.uniform(0.9, 1.1, 40)]
    found = pypw85.structure_factor(systems, 3.0, 12)
    rows = []
    for system in systems:
        vectors = pypw85.wave_vectors(system, 3.0)[1]
        length = np.linalg.norm(vectors, axis=1)
        rows += zip(length, np.abs(np.exp(1j * system.centers @ vectors.T).sum(axis=0)) ** 2 / 40)
    length, s = np.array(rows).T
    for k in range(3, 12):
        chosen = (found.edges[k] <= length) & (length < found.edges[k + 1])
        assert found.s[k] == pytest.approx(s[chosen].mean(), rel=1e-9) and found.q[k] == pytest.approx(length[chosen].mean(), rel=1e-12)


def test_structure_factor_of_the_plane(rng):
    """Of ellipses, with the two reciprocal vectors of the plane."""
    places = rng.uniform(size=(500, 2)) * [20, 30]
    plane = pypw85.System.from_ellipses(places, [[1, 0.5]] * 500, np.zeros(500), [[20, 0], [0, 30]])
    multiples, vectors = pypw85.wave_vectors(plane, 2.0)
    assert not multiples[:, 2].any() and not vectors[:, 2].any()
    assert 2 * len(multiples) == pytest.approx(np.pi * 2**2 / (2 * np.pi) ** 2 * 600, rel=0.1)  # as many as the area has
    assert pypw85.structure_factor(plane, 2.0, 1).s[0] == pytest.approx(1, abs=0.35)
    with pytest.raises(ValueError, match="third multiple must be 0"):
        pypw85.density_modes(plane, [[0, 0, 1]])


def layers(rng, spacing=2.5, number=4, spread=0.0, cell=(6.0, 7.0)):
    """Layers across z of particles at random places."""
    n = 600
    z = rng.integers(0, number, n) * spacing + spread * rng.normal(size=n)
    places = np.column_stack([rng.uniform(size=(n, 2)) * cell, z])
    return system_of(places, np.tile(ROD, (n, 1)), [[1.0, 0, 0, 0]] * n, np.diag([*cell, number * spacing]))


def test_smectic_order(rng):
    """1 for sharp layers, and the factor of Debye and Waller for blurred ones."""
    found = pypw85.smectic_order(layers(rng), spacing=(1.5, 4))
    assert found.order == pytest.approx(1, abs=1e-12) and found.spacing == pytest.approx(2.5)
    np.testing.assert_allclose(np.abs(found.wave_vector), [0, 0, 2 * np.pi / 2.5], rtol=0, atol=1e-12)
    blurred = pypw85.smectic_order(layers(rng, spread=0.4), spacing=(1.5, 4))
    assert blurred.order == pytest.approx(np.exp(-0.5 * (2 * np.pi / 2.5 * 0.4) ** 2), abs=0.06)
    assert pypw85.smectic_order(gas(rng, 2000), spacing=(1, 4)).order < 0.12
    # Half of the longest diameter to twice it: 0.5 to 2, which has the second order of these layers
    assert pypw85.smectic_order(layers(rng)).spacing == pytest.approx(1.25)
    # The limits take part, and other directions do not.
    assert pypw85.smectic_order(layers(rng), spacing=(2.5, 2.5)).order == pytest.approx(1, abs=1e-12)
    assert pypw85.smectic_order(layers(rng), axis=[1, 0, 0], spacing=(1.5, 4)).order < 0.3
    with pytest.warns(UserWarning, match="no wave vector"):
        assert np.isnan(pypw85.smectic_order(layers(rng), spacing=(2.49, 2.499), angle=0).order)


def test_layers_of_a_turned_cell(rng):
    """The same of a system that is turned as a whole, with the director as axis."""
    system = layers(rng)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    q = pypw85.packed(turn @ pypw85.full(system.q) @ turn.T)
    turned = pypw85.System(system.centers @ turn.T, q, system.cell @ turn.T)
    found = pypw85.smectic_order(turned, spacing=(1.5, 4))
    assert found.order == pytest.approx(1, abs=1e-9)
    np.testing.assert_allclose(np.abs(found.wave_vector @ turn), [0, 0, 2 * np.pi / 2.5], rtol=0, atol=1e-9)


def test_columnar_order(rng):
    """Columns have two orders, and layers along the axis one."""
    side, rows = 1.2, 6
    hexagonal = np.array([[side, 0], [0, side * np.sqrt(3)]])
    corners = np.stack(np.meshgrid(np.arange(rows), np.arange(rows)), axis=-1).reshape(-1, 1, 2)
    flat = (corners + np.array([[0, 0], [0.5, 0.5]])).reshape(-1, 2) @ hexagonal
    places = np.column_stack([np.tile(flat, (10, 1)), rng.uniform(0, 9, 10 * len(flat))])
    n = len(places)
    cell = np.diag([rows * side, rows * side * np.sqrt(3), 9])
    columns = system_of(places, np.tile(ROD, (n, 1)), [[1.0, 0, 0, 0]] * n, cell)
    first, second = pypw85.columnar_order(columns, spacing=(0.9, 3))
    assert first.order == pytest.approx(1, abs=1e-12) and second.order == pytest.approx(1, abs=1e-12)
    assert first.spacing == pytest.approx(side * np.sqrt(3) / 2) and second.spacing == pytest.approx(first.spacing)
    cosine = abs(first.wave_vector @ second.wave_vector) * first.spacing * second.spacing / (2 * np.pi) ** 2
    assert cosine == pytest.approx(0.5)
    assert pypw85.smectic_order(columns, spacing=(0.9, 3)).order < 0.2
    along = layers(rng)  # with layers across z, as seen along x
    first, second = pypw85.columnar_order(along, axis=[1, 0, 0], spacing=(1.5, 4))
    assert first.order == pytest.approx(1, abs=1e-12) and second.order < 0.3


@pytest.mark.parametrize("basis, nearest, q4, q6", [(FCC, 12, 0.190941, 0.574524), (BCC, 8, 0.509175, 0.628539),
                                                    (BCC, 14, 0.036370, 0.510688), ([[0, 0, 0]], 6, 0.763763, 0.353553)])  # fmt: skip
def test_bond_order_of_lattices(basis, nearest, q4, q6):
    """The values of Steinhardt, Nelson and Ronchetti (1983), of each particle and of all bonds."""
    found = pypw85.bond_order(crystal(basis, (4, 4, 4)), nearest=nearest)
    np.testing.assert_allclose(found.local, np.tile([q4, q6], (len(found.local), 1)), rtol=0, atol=1e-6)
    np.testing.assert_allclose(found.mean, [q4, q6], rtol=0, atol=1e-6)
    assert (found.bonds == nearest).all()


def test_bond_order_of_hexagonal_packing():
    """Its two kinds of sites have the same order. Odd degrees differ in sign between them."""
    vectors = [[1, 0, 0], [-0.5, np.sqrt(0.75), 0], [0, 0, np.sqrt(8 / 3)]]
    found = pypw85.bond_order(crystal([[0, 0, 0], [1 / 3, 2 / 3, 0.5]], (4, 4, 3), vectors), (3, 4, 6))
    np.testing.assert_allclose(found.local[:, 1:], np.tile([0.097222, 0.484762], (96, 1)), rtol=0, atol=1e-6)
    assert found.local[0, 0] > 0.05 and found.mean[0] < 1e-12


def test_bond_order_by_the_addition_theorem(rng):
    """Q_l² is the mean of P_l of the angles between all bonds of a particle, whatever the system is and however it is turned."""
    system, degrees = gas(rng, 60), (0, 1, 2, 5, 6, 12)
    found = pypw85.bond_order(system, degrees, nearest=None, reach=2.5)
    shifts = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), axis=-1).reshape(-1, 3) @ TRICLINIC
    for i in (0, 17):
        bonds = (system.centers[:, None] + shifts - system.centers[i]).reshape(-1, 3)
        length = np.linalg.norm(bonds, axis=1)
        bonds = bonds[(length <= 2.5) & (length > 0)] / length[(length <= 2.5) & (length > 0), None]
        assert found.bonds[i] == len(bonds) > 3
        for degree, one in zip(degrees, found.local[i]):
            legendre = np.polynomial.legendre.Legendre.basis(degree)(bonds @ bonds.T)
            assert one == pytest.approx(np.sqrt(legendre.mean()), abs=1e-10)
    np.testing.assert_allclose(found.local[:, 0], np.where(found.bonds > 0, 1, np.nan))


def test_nearest_neighbours(rng):
    """They are those of a search among all images, in a cell and without one."""
    for system, shifts in ((gas(rng, 40), np.stack(np.meshgrid(*[[-2, -1, 0, 1, 2]] * 3), axis=-1).reshape(-1, 3) @ TRICLINIC),
                           (gas(rng, 40, periodic=False), np.zeros((1, 3)))):  # fmt: skip
        found = pypw85.bond_order(system, (6,), nearest=5)
        bonds = (system.centers[:, None] + shifts - system.centers[3]).reshape(-1, 3)
        bonds = bonds[np.argsort(np.linalg.norm(bonds, axis=1))[1:6]]
        bonds /= np.linalg.norm(bonds, axis=1, keepdims=True)
        legendre = np.polynomial.legendre.Legendre.basis(6)(bonds @ bonds.T)
        assert found.local[3, 0] == pytest.approx(np.sqrt(legendre.mean()), abs=1e-10)
    with pytest.raises(ValueError, match="must have 40 neighbours"):
        pypw85.bond_order(gas(rng, 40, periodic=False), nearest=40)


def test_coincident_centres():
    """Their bonds have axis must be three finite numbers, and no particle is farther away."""
    places, forms = np.zeros((3, 3)), [[1, 0, 0, 1, 0, 1]] * 3
    found = pypw85.bond_order(pypw85.System(places, forms), nearest=2)
    assert np.isnan(found.local).all() and np.isnan(found.mean).all() and (found.bonds == 2).all()
    with pytest.raises(ValueError, match="must have 3 neighbours"):
        pypw85.bond_order(pypw85.System(places, forms), nearest=3)
    with pytest.raises(ValueError, match="must have 1 neighbours"):
        pypw85.bond_order(pypw85.System(places[:1], forms[:1]), nearest=1)
    near = pypw85.System([[0, 0, 0], [1e-120, 0, 0], [0, 3e-120, 0]], forms)  # the cube of that is 0
    assert pypw85.bond_order(near, (1,), nearest=1).local.ravel().tolist() == pytest.approx([1, 1, 1])


@pytest.mark.parametrize("between", ["axes", "separation", "director"])
def test_angles_in_a_gas(rng, between):
    """1 in every bin, within errors that are those of counts."""
    systems = [gas(rng, 150) for _ in range(64)]
    found = pypw85.angular_pair_correlation(systems, 3.0, 3, 4, between)
    assert found.g.shape == found.g_error.shape == (3, 4)
    z = (found.g - 1) / found.g_error
    assert 0.4 < np.sqrt(np.mean(z**2)) < 1.8
    mean = found.g.mean(axis=1)
    np.testing.assert_allclose(mean, pypw85.pair_correlation(systems, 3.0, 3).g, rtol=1e-9)


def test_angles_in_a_lattice():
    """Upright rods on a lattice: what is along z, and what is not."""
    system = crystal([[0, 0, 0]], (5, 5, 5))
    rods = system_of(system.centers, [ROD] * 125, system.quaternions, system.cell)
    ideal = 125 * 124 / 2 / 2 / 125 * 4 / 3 * np.pi * (1.2**3 - 0.8**3)  # pairs of a gas in half of the angles
    for between, expected in (("axes", [0, 375]), ("separation", [250, 125]), ("director", [250, 125])):
        g = pypw85.angular_pair_correlation(rods, 1.2, 3, 2, between).g
        np.testing.assert_allclose(g[2] * ideal, expected, rtol=1e-12, err_msg=between)
        assert not g[:2].any()


def test_angles_without_axes(rng):
    """Spheres have no axis. Among others they do not count as pairs of axes, and count as places around one."""
    spheres = [gas(rng, 60, axes=[0.3, 0.3, 0.3]) for _ in range(2)]
    for between in ("axes", "separation", "director"):
        assert np.isnan(pypw85.angular_pair_correlation(spheres, 2.0, 2, 2, between).g).all()
    axes = np.array([ROD] * 100 + [[0.3, 0.3, 0.3]] * 100)
    mixed = [
        system_of(rng.uniform(size=(200, 3)) @ TRICLINIC, axes, rng.normal(size=(200, 4)), TRICLINIC) for _ in range(40)
    ]
    for between in ("axes", "separation"):
        assert pypw85.angular_pair_correlation(mixed, 3.0, 1, 1, between).g[0, 0] == pytest.approx(1, abs=0.03)


def wrapped(places, cell):
    inside = places @ np.linalg.inv(cell)
    return (inside - np.floor(inside)) @ cell


def test_displacements_of_a_straight_motion(rng):
    """Particles that move by v in each sample, wrapped into a skewed cell: v² lag², and the same for axes that turn."""
    n, velocity, rate = 30, np.array([0.3, -0.2, 0.25]), 0.4
    start, turns = rng.uniform(size=(n, 3)) @ TRICLINIC, rng.normal(size=(n, 4))
    turns /= np.linalg.norm(turns, axis=1, keepdims=True)

    def frames():
        for k in range(60):
            half = 0.5 * rate * k  # about the x axis of the particle, across its long axis
            w, x, y, z = turns.T
            turned = np.stack([w * np.cos(half) - x * np.sin(half), x * np.cos(half) + w * np.sin(half),
                               y * np.cos(half) + z * np.sin(half), z * np.cos(half) - y * np.sin(half)], axis=1)  # fmt: skip
            yield system_of(wrapped(start + k * velocity, TRICLINIC), [ROD] * n, turned, TRICLINIC)

    with pytest.warns(UserWarning, match="lags must be below the number of systems, 60"):
        found = pypw85.mean_square_displacement(frames(), [1, 4, 25, 100])
    # Forms alone say nothing of the sign of an axis.
    of_forms = pypw85.mean_square_displacement((pypw85.System(one.centers, one.q, one.cell) for one in frames()), [25])
    assert of_forms.rotation[0] == pytest.approx((rate * 25) ** 2, rel=1e-6)
    lags = np.array([1, 4, 25])
    assert found.lags.tolist() == [1, 4, 25, 100]
    np.testing.assert_allclose(found.translation[:3], velocity @ velocity * lags**2, rtol=1e-10)
    np.testing.assert_allclose(found.rotation[:3], (rate * lags) ** 2, rtol=1e-7)
    assert np.isnan(found.translation[3]) and np.isnan(found.rotation[3])
    assert found.translation_error[0] < 1e-10 and np.isfinite(found.rotation_error[:3]).all()


def test_displacements_of_random_steps(rng):
    """Independent steps: the mean square grows as the lag, and a particle that does not move does not change it."""
    n, scale = 50, 0.2
    steps = scale * rng.normal(size=(400, n, 3))
    places = np.cumsum(steps, axis=0)
    cell = np.diag([6.0, 7.0, 8.0])
    frames = [system_of(wrapped(one, cell), [[0.2] * 3] * n, [[1.0, 0, 0, 0]] * n, cell) for one in places]
    found = pypw85.mean_square_displacement(frames, range(1, 5))
    np.testing.assert_allclose(found.translation, 3 * scale**2 * np.arange(1, 5), rtol=0.03)
    z = (found.translation - 3 * scale**2 * np.arange(1, 5)) / found.translation_error
    assert (np.abs(z) < 4).all() and np.isnan(found.rotation).all()
    direct = np.mean(((places[3:] - places[:-3]) ** 2).sum(axis=2))
    assert found.translation[2] == pytest.approx(direct, rel=1e-10)


def test_displacements_in_a_changing_cell(rng):
    """Particles that go with the cell do not move."""
    inside = rng.uniform(size=(20, 3))
    frames = [system_of(inside @ (TRICLINIC * scale), [ROD] * 20, [[1.0, 0, 0, 0]] * 20, TRICLINIC * scale)
              for scale in rng.uniform(0.8, 1.2, 40)]  # fmt: skip
    assert pypw85.mean_square_displacement(frames, [1, 5]).translation.max() < 1e-20


def test_displacements_of_a_simulation():
    """The library does not wrap centres, so what it moved is the displacement."""
    start = pypw85.pack(np.tile([0.5, 0.5, 1], (60, 1)), 0.25, seed=1)
    simulation = pypw85.HardEllipsoids(start, seed=1)
    simulation.tune(50)
    first = simulation.system()
    frames = [first]
    for _ in range(20):
        simulation.sweep()
        frames.append(simulation.system())
    found = pypw85.mean_square_displacement(frames, [20])
    moved = ((frames[-1].centers - first.centers) ** 2).sum(axis=1).mean()
    assert found.translation[0] == pytest.approx(moved, rel=1e-9) and found.rotation[0] > 0


@pytest.mark.parametrize("call, words", [
    (lambda s: pypw85.structure_factor([], 1.0), "at least one system"),
    (lambda s: pypw85.structure_factor(s, 0.0), "structure_factor: reach must be > 0 and finite, not 0"),
    (lambda s: pypw85.structure_factor(s, 1.0, 0), "structure_factor: bins must be an integer >= 1, not 0"),
    (lambda s: pypw85.wave_vectors(s, np.inf), "wave_vectors: reach must be > 0 and finite, not inf"),
    (lambda s: pypw85.structure_factor(pypw85.System(s.centers, s.q), 1.0), "need a cell"),
    (lambda s: pypw85.structure_factor(pypw85.System(s.centers[:0], s.q[:0], s.cell), 1.0), "particles"),
    (lambda s: pypw85.density_modes(s, [[0.5, 0, 0]]), "three integers"),
    (lambda s: pypw85.density_modes(s, [1, 2, 3]), "three integers"),
    (lambda s: pypw85.smectic_order(s, axis=[0, 0, 0]), "axis must be three finite numbers"),
    (lambda s: pypw85.smectic_order(s, spacing=(2, 1)), "spacing must be two positive numbers"),
    (lambda s: pypw85.smectic_order(s, angle=91), "angle must be from 0 to 90, not 91"),
    (lambda s: pypw85.smectic_order(pypw85.System(s.centers[:0], s.q[:0], s.cell)), "must have particles"),
    (lambda s: pypw85.bond_order(s, nearest=None), "one of nearest and reach must be positive"),
    (lambda s: pypw85.bond_order(s, nearest=3, reach=1.0), "one of nearest and reach must be positive"),
    (lambda s: pypw85.bond_order(s, (-1,)), r"bond_order: degrees\[0\] must be an integer >= 0, not -1"),
    (lambda s: pypw85.bond_order(s, nearest=0), "bond_order: nearest must be an integer >= 1, not 0"),
    (lambda s: pypw85.angular_pair_correlation(s, 1.0, between="both"), "between must be 'axes', 'separation' or 'director', not 'both'"),
    (lambda s: pypw85.angular_pair_correlation(s, -1.0), "reach must be > 0 and finite, not -1"),
    (lambda s: pypw85.angular_pair_correlation(s, 1.0, angles=0), "angles must be an integer >= 1, not 0"),
    (lambda s: pypw85.mean_square_displacement([s], []), "lags must have at least one number"),
    (lambda s: pypw85.mean_square_displacement([s], [0]), r"lags\[0\] must be an integer from 1 to 2\*\*31 - 1, not 0"),
    (lambda s: pypw85.mean_square_displacement([], [1]), "at least one system"),
    (lambda s: pypw85.mean_square_displacement([s, pypw85.System(s.centers[:3], s.q[:3], s.cell)], [1]), "same number of particles"),
])  # fmt: skip
def test_refused(rng, call, words):
    with pytest.raises(ValueError, match=words):
        call(gas(rng, 10))


@pytest.mark.parametrize("call, words", [
    (lambda s: pypw85.mean_square_displacement([s] * 3, [1, 1.5]), r"mean_square_displacement: lags\[1\] must be an integer .*, not 1.5"),
    (lambda s: pypw85.mean_square_displacement([s] * 3, 2), "mean_square_displacement: lags must be a list of integers, not 2"),
    (lambda s: pypw85.bond_order(s, 6), "bond_order: degrees must be a list of integers, not 6"),
    (lambda s: pypw85.bond_order(s, nearest=12.5), "bond_order: nearest must be an integer >= 1, not 12.5"),
    (lambda s: pypw85.structure_factor(s, 1.0, 2.5), "structure_factor: bins must be an integer >= 1, not 2.5"),
    (lambda s: pypw85.smectic_order(s, angle="x"), "smectic_order: angle must be a real number, not 'x'"),
])  # fmt: skip
def test_types_that_are_refused(rng, call, words):
    with pytest.raises(TypeError, match=words):
        call(gas(rng, 10))


def test_what_is_not_there_is_said(rng):
    """NaN comes with the reason."""
    system = gas(rng, 20)
    with pytest.warns(UserWarning, match="smectic_order: no wave vector of the cell is within 15° of the axis and within the limits"):
        assert np.isnan(pypw85.smectic_order(system, [0, 0, 1], (100, 200)).order)
    with pytest.warns(UserWarning, match="columnar_order: no wave vector of the cell is within 15° of the plane across the axis"):
        assert np.isnan(pypw85.columnar_order(system, [0, 0, 1], (100, 200))[1].order)
    with pytest.warns(UserWarning, match="lags must be below the number of systems, 2: those that are not, as 5, have no displacement"):
        assert np.isnan(pypw85.mean_square_displacement([system] * 2, [1, 5]).translation).tolist() == [False, True]


def test_spheres_have_no_axis(rng):
    with pytest.raises(ValueError, match="axis must be three finite numbers"):
        pypw85.smectic_order(gas(rng, 10, axes=[0.1] * 3))


def test_plane_is_refused(rng):
    plane = pypw85.System.from_ellipses(rng.uniform(size=(5, 2)), [[1, 0.5]] * 5, np.zeros(5), 9 * np.eye(2))
    for call in (pypw85.bond_order, pypw85.columnar_order, lambda s: pypw85.angular_pair_correlation(s, 1.0)):
        with pytest.raises(ValueError, match="must be three-dimensional"):
            call(plane)
