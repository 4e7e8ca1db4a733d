# SPDX-License-Identifier: BSD-3-Clause
"""Monte Carlo of hard ellipsoids in Python."""

import copy
import gc
import itertools
import operator
import pickle
import threading
import zlib

import numpy as np
import pytest

import pypw85


def lattice(side=4, spacing=(1.3, 1.3, 2.7), semi_axes=(0.5, 0.5, 1.2), **others):
    """Upright ellipsoids."""
    places = np.stack(np.meshgrid(*[np.arange(side)] * 3, indexing="ij"), axis=-1).reshape(-1, 3) * spacing
    n = len(places)
    others = {"cell": side * np.diag(spacing)} | others
    return pypw85.System.from_axes(places, np.tile(semi_axes, (n, 1)), np.tile([2.0, 0, 0, 0], (n, 1)), **others)


def test_distribution():
    """Points in an ideal gas: the volume has the density V^N exp(-PV), with the mean (N + 1) / P."""
    pressure = 5.0
    simulation = pypw85.HardEllipsoids(lattice(2, 3 * [0.6], 3 * [1e-9]), seed=3)
    simulation.set_steps(0.1, 0.1, 0.6)
    volumes = []
    for _ in range(4000):
        simulation.volume_moves(2, pressure)
        volumes.append(np.linalg.det(simulation.cell))
    means = np.mean(np.reshape(volumes, (20, -1)), axis=1)
    error = np.std(means) / np.sqrt(19)
    assert abs(means.mean() - 9 / pressure) < 5 * error < 0.3, (means.mean(), error)


def free_share(cells, separations, radii):
    """For each cell 1 if two spheres with these radii and their images are apart, by the distances of centres; 0 otherwise."""
    images = np.array(list(itertools.product(range(-2, 3), repeat=3)))
    others = images[images.any(axis=1)]
    apart = np.linalg.norm(others @ cells, axis=2).min(axis=1) >= 2 * max(radii)
    return apart & (np.linalg.norm(images @ cells + separations[:, None], axis=2).min(axis=1) >= sum(radii))


def weighed_cells(rng, n, shears, pressure, bounds, radii):
    """Means, with errors, of volume and lengths: each cell counts as V^(N+1) exp(-PV) times the part of the places that is free. The
    logarithms of the lengths are uniform between bounds, and the shears over a period of the lattice."""
    lengths = np.exp(rng.uniform(*np.log(bounds), (n, 3)))
    cells = lengths[:, None] * np.eye(3)
    if shears:
        cells[:, [1, 2, 2], [0, 0, 1]] = rng.uniform(size=(n, 3)) * lengths[:, [0, 0, 1]]
    volume = lengths.prod(axis=1)
    separations = np.einsum("ni,nij->nj", rng.uniform(size=(n, 3)), cells)
    weight = volume**3 * np.exp(-pressure * volume) * free_share(cells, separations, radii)
    values = np.column_stack([volume, lengths])
    mean = weight @ values / weight.sum()
    return mean, np.sqrt(weight**2 @ (values - mean) ** 2) / weight.sum()


@pytest.mark.parametrize("change, seed", [("axis", 3), ("triclinic", 4)])
def test_two_particles_at_constant_pressure(rng, change, seed):
    """Volume and lengths of the cell against an integral over cells. A cell with a length beyond the bounds is rejected here."""
    pressure, bounds, radii = 3.0, (1.0, 2.2), (0.5, 0.3)
    expected, error = weighed_cells(rng, 12000, change == "triclinic", pressure, bounds, radii)
    start = pypw85.System.from_axes([3 * [0], 3 * [0.8]], np.outer(radii, [1, 1, 1]), [[1, 0, 0, 0]] * 2, cell=1.6 * np.eye(3))
    simulation = pypw85.HardEllipsoids(start, seed)
    simulation.set_fractions(translation=1)
    simulation.set_steps(0.7, 0.1, 0.3)
    samples = []
    for _ in range(12000):
        simulation.sweep()
        before = simulation.save()
        simulation.volume_moves(1, pressure, change)
        if not bounds[0] < simulation.cell.diagonal().min() <= simulation.cell.diagonal().max() < bounds[1]:
            simulation = pypw85.HardEllipsoids.restore(before)
            simulation.sweep()  # with the random numbers of the trial, which would be the same again
        lengths = simulation.cell.diagonal()
        samples.append([lengths.prod(), *lengths])
    blocks = np.reshape(samples, (30, -1, 4)).mean(axis=1)
    errors = np.hypot(error, blocks.std(axis=0, ddof=1) / np.sqrt(len(blocks)))
    found = blocks.mean(axis=0)
    assert (np.abs(found - expected) < 4 * errors).all() and (errors < 0.03 * expected).all(), (found, expected, errors)


def mean_and_error(samples):
    return np.mean(samples), np.std(samples, ddof=1) / np.sqrt(len(samples))


@pytest.mark.parametrize("fraction", [0.1, 0.2, 0.3, 0.4, 0.45])
def test_chains_against_trials(fraction):
    """βP/ρ at five densities by chains, with trials that only rotate, and from the contacts of trials without chains."""
    axes, blocks = np.array([0.5, 0.5, 1.0]), 24
    spacing = 2 * axes * np.cbrt(np.pi / 6 / fraction)
    trials, chains = (pypw85.HardEllipsoids(lattice(5, spacing, axes), seed) for seed in (3, 4))
    for simulation in trials, chains:
        simulation.tune(400, 0.4)
    chains.set_fractions(rotation=1)
    by_contacts, by_chains = [], []
    for _ in range(blocks):
        pairs = []
        for _ in range(6):
            trials.sweep(5)
            pairs.append(trials.system().contacts(1.1).mu ** 2)
        by_contacts.append(pypw85.compressibility(pairs, len(trials.centers)).value)
        block = []
        for _ in range(6):
            chains.sweep(2)
            block.append(chains.chain(20, 4.0))
        by_chains.append(np.mean(block))
    (first, first_error), (second, second_error) = mean_and_error(by_contacts), mean_and_error(by_chains)
    error = np.hypot(first_error, second_error)
    assert abs(first - second) < 4.5 * error < 0.3 * first, (first, first_error, second, second_error)


def test_changes():
    """Each kind of change has its effect on the cell."""
    for change, number in (("isotropic", 3), ("axis", 3), ("triclinic", 6)):
        simulation = pypw85.HardEllipsoids(lattice(), seed=3)
        simulation.set_steps(0.1, 0.1, 1e-4)
        simulation.volume_moves(40, 2.0, change)
        assert np.count_nonzero(simulation.cell) == number
        lengths = np.diag(simulation.cell) / (4 * np.array([1.3, 1.3, 2.7]))
        assert (np.ptp(lengths) < 1e-14) == (change == "isotropic")


def test_calls_of_one_particle():
    """Neighbours, placements and a compression, against the pairs of all particles."""
    simulation = pypw85.HardEllipsoids(lattice(), seed=8)
    simulation.sweep(30)
    found = simulation.neighbors(5)
    ends = simulation.centers[found.particles] + found.images @ simulation.cell
    assert len(found.particles) and np.allclose(found.separations, ends - simulation.centers[5], atol=1e-12)
    before = simulation.save()
    assert not simulation.try_placement(5, simulation.centers[6])
    assert simulation.try_placement(5, quaternion=simulation.quaternions[5])
    factor = simulation.compress()
    assert simulation.save() == before
    assert simulation.try_placement(5, simulation.centers[5] + 1e-9, take=True)
    assert simulation.save() != before
    least = simulation.system().contacts(2.0).mu.min()
    assert abs(factor * least - 1) < 1e-7
    assert abs(simulation.compress(take=True) * least - 1) < 1e-12
    simulation.check()
    assert simulation.system().contacts(1.1).mu.min() < 1 + 1e-12
    for particle in -1, 64:
        with pytest.raises(IndexError, match=f"particle must be an index of the 64 particles, not {particle}"):
            simulation.neighbors(particle)
    with pytest.raises(pypw85.PW85Error, match="nan"):
        simulation.try_placement(0, [0, 0, np.nan])


def test_views():
    """The arrays show the present state, cannot be written to, and outlive the object."""
    simulation = pypw85.HardEllipsoids(lattice(), seed=5)
    views = {name: getattr(simulation, name) for name in ("centers", "semi_axes", "quaternions", "q", "cell")}
    before = {name: view.copy() for name, view in views.items()}
    simulation.tune(10, 0.4, pressure=2.0)
    changed = [name for name, view in views.items() if (view != before[name]).any()]
    assert changed == ["centers", "quaternions", "q", "cell"]
    assert np.allclose(np.linalg.norm(views["quaternions"], axis=1), 1, rtol=0, atol=1e-15)
    form = pypw85.ellipsoid_quaternion(views["semi_axes"], views["quaternions"])
    assert (form == views["q"]).all()
    for view in views.values():
        with pytest.raises(ValueError, match="read-only"):
            view[0] = 1
        with pytest.raises(ValueError, match="cannot set WRITEABLE"):
            view.flags.writeable = True
    after = {name: view.copy() for name, view in views.items()}
    del simulation
    gc.collect()
    others = [pypw85.HardEllipsoids(lattice(), seed=6) for _ in range(4)]
    assert all((view == after[name]).all() for name, view in views.items())
    assert len(others[0]) == 64


def test_copies():
    """Copies are simulations of their own, which continue bit by bit."""
    simulation = pypw85.HardEllipsoids(lattice(), 5)
    simulation.sweep(3)
    copies = [copy.copy(simulation), copy.deepcopy(simulation), pickle.loads(pickle.dumps(simulation))]
    simulation.sweep(2)
    for one in copies:
        assert one.save() != simulation.save()
        one.sweep(2)
        assert one.save() == simulation.save()


def test_read_only():
    """What would have no effect is refused."""
    simulation = pypw85.HardEllipsoids(lattice(), 5)
    for name in ("centers", "semi_axes", "quaternions", "q", "cell", "periodic", "counts", "steps", "other"):
        with pytest.raises(AttributeError):
            setattr(simulation, name, None)


def test_short_memory(monkeypatch):
    """The cure is in the text."""
    simulation = pypw85.HardEllipsoids(lattice(), 5)
    monkeypatch.setattr("pypw85._core.hard_ellipsoids_sweep", lambda *_: int(pypw85.Status.ENOMEM))
    simulation.set_steps(2.5, 0.1, 0.1)
    with pytest.raises(MemoryError, match=r"sweep: there is not enough memory.* translation, 2\.5: set a shorter one by set_steps\(\)$"):
        simulation.sweep()


def test_long_lists():
    """A particle of thousands of cells is refused at once."""
    needle = pypw85.System.from_axes(np.zeros((1, 3)), [[0.01, 0.01, 1e4]], [[1, 0.3, 0.2, 0.1]], cell=9 * np.eye(3))
    with pytest.raises(MemoryError, match=r"^HardEllipsoids: particles, steps and the cutoff must not be so long that .* of the cell$"):
        pypw85.HardEllipsoids(needle, 1)


def test_saved():
    """A saved simulation goes on bit by bit, and sweeps may be counted together or one by one."""
    simulation = pypw85.HardEllipsoids(lattice(), 9)
    simulation.set_fractions(1, 1, 2, 0)
    simulation.tune(5, 0.5)
    again = pypw85.HardEllipsoids.restore(simulation.save())
    assert again.periodic == (True, True, True)
    simulation.sweep(6)
    for _ in range(6):
        again.sweep()
    state = simulation.save()
    assert state == again.save() and int.from_bytes(state[-8:], "little") == zlib.crc32(state[:-8])
    assert (simulation.centers == again.centers).all()
    other = pypw85.HardEllipsoids(lattice(), 10)
    other.sweep(6)
    assert other.save() != again.save()


def test_counts():
    simulation = pypw85.HardEllipsoids(lattice(), 1)
    simulation.set_fractions(translation=1, both=3)
    simulation.set_steps(0.125, 0.25, 0.5)
    assert simulation.steps == (0.125, 0.25, 0.5)
    simulation.sweep(50)
    simulation.volume_moves(7, 1.0)
    counts = simulation.counts
    assert sum(counts[move].trials for move in ("translation", "both")) == 50 * 64
    assert abs(counts["both"].trials - 2400) < 200
    assert counts["rotation"] == counts["exchange"] == (0, 0)
    assert counts["volume"].trials == 7
    assert all(0 <= one.accepted <= one.trials for one in counts.values())
    assert 0 < counts["translation"].accepted < counts["translation"].trials
    simulation.tune(1)
    assert all(one == (0, 0) for one in simulation.counts.values())
    assert simulation.steps != (0.125, 0.25, 0.5)


def test_mixture():
    """Exchanges of semi-axes, and a copy of the state, which has no overlaps."""
    start = lattice()
    axes = start.semi_axes.copy()
    axes[::2] = [0.4, 0.5, 0.9]
    start = pypw85.System.from_axes(start.centers, axes, start.quaternions, cell=start.cell)
    simulation = pypw85.HardEllipsoids(start, 2)
    simulation.set_fractions(1, 1, 1, 1)
    simulation.sweep(20)
    assert simulation.counts["exchange"].accepted > 0
    assert sorted(map(tuple, simulation.semi_axes)) == sorted(map(tuple, axes))
    state = simulation.system()
    assert (state.q == simulation.q).all() and (state.centers == simulation.centers).all()
    assert (state.semi_axes == simulation.semi_axes).all() and (state.quaternions == simulation.quaternions).all()
    assert len(state.overlaps().pairs) == 0
    simulation.check()
    simulation.sweep()
    assert (state.centers != simulation.centers).any()


def test_overlapping_start():
    start = lattice()
    start.centers[5] = start.centers[2] + [0.1, 0, 0]
    start.centers[20] = start.centers[30]
    cure = r"separate them \(pypw85\.relax\), or enlarge the cell$"
    two = r"^HardEllipsoids: pairs that overlap: 2 \(the particles (2 and 5, 20 and 30|20 and 30, 2 and 5)\): "
    with pytest.raises(pypw85.PW85Error, match=two + cure) as raised:
        pypw85.HardEllipsoids(start)
    assert raised.value.status == pypw85.Status.EOVERLAP
    pypw85.HardEllipsoids(pypw85.relax(start)).check()
    with pytest.raises(pypw85.PW85Error, match=r"pairs that overlap: 2 \(the particles 0 and its image, 0 and its image\): " + cure):
        pypw85.HardEllipsoids(lattice(1, (1, 1, 1)))


def test_bad_systems():
    start = lattice()
    start.centers[7, 1] = np.nan
    with pytest.raises(pypw85.PW85Error, match="particle 7: centers must be finite, not .*nan"):
        pypw85.HardEllipsoids(start)
    with pytest.raises(pypw85.PW85Error, match="cell"):
        pypw85.HardEllipsoids(lattice(cell=np.zeros((3, 3))))
    for seed in (-1, 2**64):
        with pytest.raises(ValueError, match="seed must be an integer from 0"):
            pypw85.HardEllipsoids(lattice(), seed)
    with pytest.raises(TypeError):
        pypw85.HardEllipsoids(lattice(), 1.5)
    for start in (None, lattice().centers, "start.xyz"):
        with pytest.raises(TypeError, match=r"system must be a pypw85\.System, not \w+$"):
            pypw85.HardEllipsoids(start)


def test_bad_restored_bytes():
    before = pypw85.HardEllipsoids(lattice(), np.int64(3)).save()
    with pytest.raises(pypw85.PW85Error, match="restore: bytes must be complete: num_bytes differs from the number in the state"):
        pypw85.HardEllipsoids.restore(before[:-1])
    with pytest.raises(TypeError):
        pypw85.HardEllipsoids.restore("text")


def test_bad_numbers():
    """Refused numbers change nothing."""
    simulation = pypw85.HardEllipsoids(lattice(), 3)
    before = simulation.save()
    for call, argument, numbers, range_ in (
        (lambda x: simulation.volume_moves(1, x), "pressure", (0.0, -1.0), "> 0"),
        (lambda x: simulation.tune(1, x), "acceptance", (0.0, -1.0), "> 0"),
        (lambda x: simulation.tune(1, x), "acceptance", (1.5,), "at most 1"),
        (lambda x: simulation.tune(1, 0.4, x), "pressure", (-1.0,), ">= 0"),
        (lambda x: simulation.set_steps(x, 0.1, 0.1), "translation", (0.0, -1.0), "> 0"),
        (lambda x: simulation.set_steps(0.1, x, 0.1), "rotation", (0.0,), "> 0"),
        (lambda x: simulation.set_steps(0.1, x, 0.1), "rotation", (1.5,), "at most 1"),
        (lambda x: simulation.set_steps(0.1, 0.1, x), "volume", (0.0,), "> 0"),
        (lambda x: simulation.set_steps(0.1, 0.1, x), "volume", (1.5,), "at most 1"),
        (lambda x: simulation.chain(1, x), "length", (0.0, -1.0), "> 0"),
    ):
        for number, range_ in (*((number, range_) for number in numbers), (np.nan, "finite"), (np.inf, "finite")):
            with pytest.raises(pypw85.PW85Error, match=rf"^HardEllipsoids\.\w+: {argument} must be {range_}, not {number}$"):
                call(number)
    for number, range_ in ((-1.0, ">= 0"), (np.nan, "finite"), (np.inf, "finite")):
        with pytest.raises(pypw85.PW85Error, match=rf"set_fractions: fractions must be {range_}, not \[1.0, {number}, 0.0, 0.0\]$"):
            simulation.set_fractions(1, number)
    for call in (
        simulation.sweep,
        lambda n: simulation.tune(n, 0.4),
        lambda n: simulation.volume_moves(n, 1.0),
        lambda n: simulation.chain(n, 1.0),
    ):
        with pytest.raises(ValueError, match="number must be an integer >= 0, not -1"):
            call(-1)
        with pytest.raises(TypeError, match="number must be an integer >= 0, not 0.5"):
            call(0.5)
    assert simulation.save() == before


def test_bad_moves():
    """Refused arguments of moves change nothing."""
    simulation = pypw85.HardEllipsoids(lattice(), 3)
    before = simulation.save()
    with pytest.raises(pypw85.PW85Error, match="translation must be at most the longest vector of the cell, not 11.0$"):
        simulation.set_steps(11, 0.1, 0.1)
    with pytest.raises(pypw85.PW85Error, match="set_fractions: fractions must have a sum that is > 0 and finite, not "):
        simulation.set_fractions()
    with pytest.raises(pypw85.PW85Error, match=r"chain: length must let chains advance: .* the length is too long, not 1e\+17$"):
        pypw85.HardEllipsoids(lattice()).chain(1, 1e17)
    for quaternion, reason in (([0, 0, 0, 0], "not be zero"), ([1, np.nan, 0, 0], "be finite")):
        with pytest.raises(pypw85.PW85Error, match=f"try_placement: quaternion must {reason}, not"):
            simulation.try_placement(0, None, quaternion)
    with pytest.raises(pypw85.PW85Error, match="try_placement: center must not be too far away"):
        simulation.try_placement(0, [1e18, 1, 2])
    with pytest.raises(ValueError, match="change must be 'isotropic', 'axis', 'triclinic' or 'aspect', not 'shear'"):
        simulation.volume_moves(1, 1.0, "shear")
    for direction, reason in (([0, 0, 0], "not be zero"), ([np.inf, 0, 0], "be finite")):
        with pytest.raises(pypw85.PW85Error, match=rf"^HardEllipsoids\.chain: direction must {reason}, not "):
            simulation.chain(1, 1.0, direction)
    with pytest.raises(ValueError, match=r"chain: the shape of direction must be \(3,\), not \(2,\)$"):
        simulation.chain(1, 1.0, [1, 2])
    assert simulation.save() == before


def test_cells():
    """Without a cell, along two vectors, without particles."""
    along_two, along_none = (True, True, False), (False, False, False)
    for others, expected in (
        ({"cell": None}, along_none),
        ({"periodic": along_two}, along_two),
        ({"periodic": False}, along_none),
    ):
        simulation = pypw85.HardEllipsoids(lattice(**others))
        simulation.sweep(3)
        simulation.check()
        with pytest.raises(pypw85.PW85Error, match="must have a cell that is periodic along its three vectors"):
            simulation.volume_moves(1, 1.0)
        with pytest.raises(ValueError, match="pass length, because the cell is not periodic along its three vectors"):
            simulation.chain(1)
        assert simulation.chain(1, 2.0) >= 1
        assert simulation.periodic == simulation.system().periodic == expected
    empty = pypw85.HardEllipsoids(pypw85.System(np.empty((0, 3)), np.empty((0, 6)), np.eye(3)))
    empty.sweep(3)
    assert empty.centers.shape == (0, 3) and repr(empty) == "<pypw85.HardEllipsoids: 0 particles>"


def test_chains():
    """Chains along an axis move nothing across it, and give a pressure above that of the ideal gas."""
    simulation, other = (pypw85.HardEllipsoids(lattice(), 2) for _ in range(2))
    before = simulation.centers.copy()
    along_x = simulation.chain(20, 5.0, [2, 0, 0])
    simulation.check()
    assert along_x > 1 and along_x == other.chain(20, 5.0, (1, 0, 0))
    assert np.array_equal(simulation.centers[:, 1:], before[:, 1:])
    assert not np.array_equal(simulation.centers[:, 0], before[:, 0])
    assert np.isnan(simulation.chain(0, 5.0))
    assert simulation.chain(5, 5.0) == other.chain(5, 5.0)
    edge = float(np.cbrt(np.linalg.det(simulation.cell)))
    assert simulation.chain(5) == other.chain(5, edge)
    assert simulation.chain(5, direction=[0, 1, 0]) == other.chain(5, edge, [0, 1, 0]) and simulation.save() == other.save()
    assert not np.array_equal(simulation.centers[:, 1:], before[:, 1:])
    simulation.check()


def test_own_images():
    """One spheroid in a cell that is shorter than it: its contacts are with its own images. Chains do not know the pressure, and the
    pairs that nearly touch do. βP/ρ = βPV is by <V> of the free orientations at random volumes, V^N exp(-βPV) each, within four
    standard errors."""
    pressure, axes = 8.0, np.array([0.3, 0.3, 0.5])
    start = pypw85.System.from_axes([[0, 0, 0]], [axes], [[1, 0, 0, 0]], cell=1.05 * np.eye(3))
    simulation = pypw85.HardEllipsoids(start, 1)
    simulation.set_steps(0.1, 0.5, 0.3)
    observables = pypw85.Observables()
    for _ in range(1500):
        simulation.sweep()
        simulation.volume_moves(4, pressure)
        simulation.sweep()
        sample = observables.add(simulation, simulation.chain(1))
        assert np.isnan(sample.compressibility_chains) == (simulation.cell[0, 0] <= 1)
    found = observables.estimates()
    assert "compressibility_chains" not in found
    rng = np.random.default_rng(1)
    edges, axis = np.linspace(0.6, 1.6, 400), rng.normal(size=(400, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    images = np.array([image for image in itertools.product(range(-1, 2), repeat=3) if any(image)])
    # Of a spheroid and its image at r, μ² is (r² sin²)/(2 a)² + (r² cos²)/(2 c)².
    cosines, lengths = images @ axis.T, (images**2).sum(axis=1)[:, None]
    least = np.sqrt(((lengths - cosines**2) / 0.6**2 + cosines**2 / 1.0**2).min(axis=0))  # μ in a cell of edge one
    free = (edges[:, None] * least >= 1).mean(axis=1)
    weights = free * edges**5 * np.exp(-pressure * edges**3)  # V dV is edge⁵ d(edge)
    expected = pressure * (weights @ edges**3) / weights.sum()
    volume = found["volume"]
    assert abs(pressure * volume.value - expected) < 4 * pressure * volume.error + 0.02 * expected
    z, printed = (estimates["compressibility_contacts"] for estimates in (observables.stationary(), found))
    assert abs(z.value - expected) < 4 * z.error < 0.4 * expected and z.error < printed.error < np.inf, (z, printed)


def test_threads():
    """Calls from several threads wait for each other."""
    simulation, expected = (pypw85.HardEllipsoids(lattice(), 4) for _ in range(2))
    workers = [threading.Thread(target=simulation.sweep, args=(20,)) for _ in range(4)]
    for step in (operator.methodcaller("start"), operator.methodcaller("join")):
        for worker in workers:
            step(worker)
    expected.sweep(80)
    assert simulation.save() == expected.save()


def ellipses(shape=(8, 6), spacing=(1.25, 2.5), semi_axes=(0.5, 1.0), cell=None, **others):
    """Upright ellipses on a lattice."""
    places = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 2) * spacing
    n = len(places)
    cell = np.diag(np.multiply(shape, spacing)) if cell is None else cell
    return pypw85.System.from_ellipses(places, np.tile(semi_axes, (n, 1)), np.zeros(n), cell, **others)


def test_plane():
    """A simulation of ellipses: what it is called, its views, copies and saved states, and nothing leaves the plane."""
    simulation = pypw85.HardEllipsoids(ellipses(), seed=2)
    assert simulation.dimensions == 2 and repr(simulation) == "<pypw85.HardEllipsoids: 48 ellipses>"
    assert pypw85.HardEllipsoids(lattice()).dimensions == 3
    simulation.tune(20, pressure=1.0, change="triclinic")
    simulation.sweep(20)
    simulation.volume_moves(20, 1.0, "axis")
    assert simulation.counts["volume"].trials == 20 and simulation.cell[2].tolist() == [0, 0, 1]
    others = [copy.copy(simulation), pypw85.HardEllipsoids.restore(simulation.save())]
    z = simulation.chain(10)
    simulation.sweep(2)
    for other in others:
        assert other.dimensions == 2
        (a, _, _), (b, c, _) = other.cell[:2]
        assert (b != 0) and other.chain(10, np.sqrt(a * c)) == z
        other.sweep(2)
        assert other.save() == simulation.save()
    assert not simulation.centers[:, 2].any() and not simulation.quaternions[:, 1:3].any() and not simulation.cell[:2, 2].any()
    state = simulation.system()
    assert state.dimensions == 2 and len(state.overlaps().mu) == 0 and len(pypw85.HardEllipsoids(state)) == 48
    assert abs(state.packing_fraction - 48 * np.pi / 2 / np.linalg.det(simulation.cell)) < 1e-15
    simulation.check()


def test_points_of_the_plane():
    """Points and directions may be given as (x, y). A compression is in the plane."""
    simulation = pypw85.HardEllipsoids(ellipses(), seed=2)
    assert abs(copy.copy(simulation).compress(take=True) - 0.8) < 1e-12  # ellipses of 1 × 2 on a lattice of 1.25 × 2.5
    other = copy.copy(simulation)
    assert simulation.chain(4, 3.0, (1, 2)) == other.chain(4, 3.0, (1, 2, 0))
    place = simulation.centers[3, :2] + 1e-9
    assert simulation.try_placement(3, place, take=True) and other.try_placement(3, [*place, 0], take=True)
    assert simulation.save() == other.save() and (simulation.centers[3, :2] == place).all()


def test_other_quaternions():
    """An ellipse is the same whichever semi-axis of its ellipsoid is along z."""
    tilted = pypw85.System.from_axes(
        [[0, 0, 0], [3, 0, 0]], [[0.5, 1, 0.7], [0.7, 1, 0.5]], [[0, 1, 0, 0], [1, 0, 1, 0]], cell=9 * np.eye(3), dimensions=2
    )
    simulation = pypw85.HardEllipsoids(tilted)
    np.testing.assert_allclose(simulation.q, tilted.q, atol=1e-15)
    simulation.sweep(20)
    assert (simulation.semi_axes[:, 2] == 0.7).all() and not simulation.quaternions[:, 1:3].any()


def test_out_of_the_plane():
    """What would leave the plane is refused in one sentence, and changes nothing."""
    simulation = pypw85.HardEllipsoids(ellipses())
    before = simulation.save()
    for call, reason in (
        (lambda: simulation.chain(1, 1.0, [1, 0, 1]), "chain: direction must be in the plane, not "),
        (lambda: simulation.chain(1, 1.0, [0, 0]), "chain: direction must not be zero, not "),
        (lambda: simulation.try_placement(0, [0, 0, 1]), "try_placement: center must be in the plane of the ellipses, not "),
        (lambda: simulation.try_placement(0, None, [1, 0.1, 0, 0]), "quaternion must be a rotation about z, which keeps the ellipse in"),
        (lambda: simulation.set_steps(16, 0.1, 0.1), "translation must be at most the longest vector of the cell, not 16.0$"),
    ):
        with pytest.raises(pypw85.PW85Error, match=reason):
            call()
    with pytest.raises(ValueError, match=r"the shape of direction must be \(3,\), not \(4,\)"):
        simulation.chain(1, 1.0, [1, 2, 3, 4])
    assert simulation.save() == before
    channel = pypw85.HardEllipsoids(ellipses(periodic=(True, False)))
    with pytest.raises(pypw85.PW85Error, match="simulation must have a cell that is periodic along its first two vectors$"):
        channel.volume_moves(1, 1.0)
    with pytest.raises(ValueError, match="pass length, because the cell is not periodic along its two vectors"):
        channel.chain(1)
    assert channel.chain(1, 2.0) >= 1
    overlapping = ellipses()
    overlapping.centers[5, :2] = overlapping.centers[7, :2] + 0.1
    with pytest.raises(pypw85.PW85Error, match=r"^HardEllipsoids: pairs that overlap: 1 \(the particles 5 and 7\)"):
        pypw85.HardEllipsoids(overlapping)


@pytest.mark.parametrize("change, reason", [
    (lambda system: system.centers.__setitem__((4, 2), 0.1), "particle 4: centers must all have the same z"),
    (lambda system: system.quaternions.__setitem__((9, 1), 0.1), "particle 9: quaternions must be rotations about z"),
    (lambda system: system.cell.__setitem__((1, 2), 0.1), "cell must have its first two vectors in the plane"),
])  # fmt: skip
def test_no_plane(change, reason):
    """A system that was changed after it was made."""
    system = ellipses()
    change(system)
    with pytest.raises(pypw85.PW85Error, match=reason) as raised:
        pypw85.HardEllipsoids(system)
    assert raised.value.status == pypw85.Status.EINVAL


def virials(fraction):
    """βP/ρ of hard discs by B2 to B6; B2 ρ is twice the area fraction."""
    x = 2 * fraction
    return 1 + x + 0.78200 * x**2 + 0.53223 * x**3 + 0.33356 * x**4 + 0.19884 * x**5


def test_pressures_of_discs():
    """βP/ρ of hard discs by chains and by contacts, at constant area, against the virial series; and the density at that pressure."""
    fraction, side = 0.2, 12
    spacing = np.sqrt(np.pi / 4 / fraction)
    simulation = pypw85.HardEllipsoids(ellipses((side, side), (spacing, spacing), (0.5, 0.5)), seed=3)
    simulation.set_fractions(translation=1)
    simulation.tune(200)
    observables = pypw85.Observables()
    for _ in range(500):
        simulation.sweep(2)
        observables.add(simulation, simulation.chain(5, 10.0))
    found, printed = observables.stationary(), observables.estimates()
    assert abs(found["packing_fraction"].value - fraction) < 1e-12
    finite = 2 * fraction / side**2  # two particles are a pair: (N - 1)/N of the term of B2
    for name, most in ("compressibility_chains", 0.02), ("compressibility_contacts", 0.04):
        value, error, _ = found[name]
        assert abs(value - virials(fraction)) < 4 * error + finite and error < most, (name, found[name])
        assert error < printed[name].error < np.inf, (found[name], printed[name])
    pressure, observables = virials(fraction) * side**2 / found["volume"].value, pypw85.Observables()
    simulation.tune(200, pressure=pressure)
    for _ in range(1000):
        simulation.sweep(2)
        simulation.volume_moves(4, pressure)
        observables.add(simulation)
    value, error, _ = observables.stationary()["packing_fraction"]
    assert abs(value - fraction) < 4 * error + fraction * (virials(fraction) - 1) / side**2 and error < 0.02 * fraction, (value, error)


def test_pressures_of_ellipses():
    """By chains and by contacts, of ellipses of aspect ratio 2 in a dense fluid."""
    simulation = pypw85.HardEllipsoids(ellipses((10, 6), (1.2, 2.4)), seed=4)
    simulation.tune(500)
    observables = pypw85.Observables(width=0.05)
    for _ in range(800):
        simulation.sweep(4)
        observables.add(simulation, simulation.chain(4, 6.0))
    found = observables.estimates()
    (first, first_error, _), (second, second_error, _) = found["compressibility_chains"], found["compressibility_contacts"]
    bias = found["contacts_bias"]
    assert abs(first - second) < 4 * np.hypot(first_error, second_error) + abs(bias.value) + bias.error, found
    assert first_error < 0.02 * first and second_error < 0.05 * second, found


def test_two_ellipses_at_constant_pressure(rng):
    """The area A of a square cell with two discs against an integral over the logarithm of its edge: each edge counts as A³ exp(-βPA) times
    the part of the places that is free."""
    pressure, radii = 3.0, (0.5, 0.3)
    edges = np.exp(rng.uniform(np.log(0.999), np.log(3.0), 40000))
    place = rng.uniform(size=(40000, 2)) * edges[:, None]
    images = np.array(list(itertools.product(range(-1, 2), repeat=2)))
    distance = np.linalg.norm(images * edges[:, None, None] - place[:, None], axis=2).min(axis=1)
    area = edges**2
    weight = area**3 * np.exp(-pressure * area) * (distance >= sum(radii)) * (edges >= 2 * radii[0])
    expected = weight @ area / weight.sum()
    error = np.sqrt(weight**2 @ (area - expected) ** 2) / weight.sum()
    start = pypw85.System.from_ellipses([[0, 0], [0.8, 0.8]], np.outer(radii, [1, 1]), [0, 0], 1.6 * np.eye(2))
    simulation = pypw85.HardEllipsoids(start, 3)
    simulation.set_fractions(translation=1)
    simulation.set_steps(0.7, 0.1, 0.3)
    samples = []
    for _ in range(12000):
        simulation.sweep()
        simulation.volume_moves(1, pressure)
        samples.append(simulation.cell[0, 0] * simulation.cell[1, 1])
    mean, found_error = mean_and_error(np.reshape(samples, (30, -1)).mean(axis=1))
    assert abs(mean - expected) < 4 * np.hypot(error, found_error) and found_error < 0.03 * expected, (mean, expected, found_error)
