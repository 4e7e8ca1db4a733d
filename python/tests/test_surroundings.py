# SPDX-License-Identifier: BSD-3-Clause
"""Walls, fields, potentials, insertions and removals of simulations in Python."""

import copy
import ctypes
import gc
import pickle

import numpy as np
import pytest

import pypw85
from pypw85 import Field, Status, Wall


def alone(semi_axes=(0.5, 0.5, 0.5), center=(0, 0, 0), **others):
    return pypw85.HardEllipsoids(pypw85.System.from_axes([center], [semi_axes], [[1, 0, 0, 0]], **others))


def spheres(side=4, spacing=1.5, **others):
    """Spheres on a lattice, in a periodic cell."""
    places = spacing * np.stack(np.meshgrid(*[np.arange(side)] * 3), axis=-1).reshape(-1, 3)
    n = len(places)
    others = {"cell": spacing * side * np.eye(3)} | others
    return pypw85.HardEllipsoids(pypw85.System.from_axes(places, np.full((n, 3), 0.5), np.tile([1, 0, 0, 0], (n, 1)), **others))


def cube(half):
    """The surface of a cube."""
    corners = [[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [[0, 1, 3], [0, 3, 2], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4]]
    faces += [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 3, 7], [1, 7, 5]]
    return pypw85.Mesh(corners, faces)


def error_of(function, *arguments):
    with pytest.raises(pypw85.PW85Error) as caught:
        function(*arguments)
    return caught.value


def test_mesh():
    """A mesh keeps a particle in as walls do, is saved, and is taken away."""
    simulation, boxed = alone(), alone()
    simulation.set_mesh(cube(1.0))
    boxed.set_walls([Wall.box([-1, -1, -1], [1, 1, 1])])
    for one in simulation, boxed:
        one.set_steps(0.5, 0.5, 0.1)
        one.sweep(100)
    assert np.array_equal(simulation.centers, boxed.centers)
    again = pypw85.HardEllipsoids.restore(simulation.save())
    for one in simulation, again:
        one.sweep(10)
    assert again.save() == simulation.save()
    assert not simulation.try_placement(0, [0.51, 0, 0], None)
    simulation.set_mesh(None)
    assert simulation.try_placement(0, [0.51, 0, 0], None)


def test_bad_mesh():
    """Meshes that a simulation cannot have change nothing."""
    simulation = alone()
    before = simulation.save()
    error = error_of(simulation.set_mesh, cube(0.4))
    assert error.status == Status.EOVERLAP and "cuts particle 0, next to triangle" in str(error)
    assert simulation.save() == before
    assert error_of(alone(dimensions=2).set_mesh, cube(1.0)).status == Status.EINVAL


def test_each_wall():
    """A unit sphere stays inside of walls of each kind, and reaches them."""
    for walls in (
        [Wall.plane(sign * np.eye(3)[d], 1.0) for sign in (-1, 1) for d in range(3)],
        [Wall.sphere([0, 0, 0], 1.0)],
        [Wall.cylinder([0, 0, 5], [0, 0, 2], 1.0), Wall.plane([0, 0, 1], 1.0), Wall.plane([0, 0, -1], 1.0)],
        [Wall.box([-1, -1, -1], [1, 1, 1])],
    ):
        simulation, largest = alone(), 0.0
        simulation.set_walls(walls)
        simulation.set_steps(0.5, 0.5, 0.1)
        for _ in range(2000):
            simulation.sweep()
            largest = max(largest, abs(simulation.centers).max())
        assert 0.45 < largest <= 0.5
        simulation.check()
    disc = pypw85.HardEllipsoids(pypw85.System.from_ellipses([[0, 0]], [[0.5, 1]], [0.0]))
    disc.set_walls([Wall.sphere([0, 0], 1.25), Wall.box([-1.25, -1.25], [1.25, 1.25])])
    disc.sweep(100)
    assert disc.quaternions[0, 3] != 0


def test_fields_and_energy():
    simulation = alone((0.5, 0.5, 1.0), (1, 2, 3))
    simulation.set_fields([Field.linear([1, 10, 100]), Field.harmonic([1, 0, 0], [5, 2, 0]), Field.aligning([0, 0, 1], 3, axis=2)])
    assert simulation.energy() == 321 + 4 - 3
    simulation.set_fields([Field.weight([0, 0, 1])])
    assert simulation.energy() == pytest.approx(3 * 4 / 3 * np.pi * 0.25)
    simulation.set_fields()
    assert simulation.energy() == 0
    flat = pypw85.HardEllipsoids(pypw85.System.from_ellipses([[3, 4]], [[0.5, 1]], [0.0]))
    flat.set_fields([Field.weight([2, 0])])
    assert flat.energy() == pytest.approx(6 * np.pi * 0.5)
    flat.set_fields([Field.aligning([1, 0], 2.0, 0)])
    assert flat.energy() == -2


def test_errors():
    simulation = spheres()
    error = error_of(simulation.set_walls, [Wall.plane([0, 0, 1], 99)])
    assert error.status == Status.EINVAL and "wall 0 must be the same in all images of the cell, not Wall(" in str(error)
    slit = spheres(periodic=(True, True, False))
    error = error_of(slit.set_walls, [Wall.plane([0, 0, 1], 99), Wall.plane([0, 0, -1], 0.25)])
    assert error.status == Status.EOVERLAP and "wall 1, Wall(" in str(error) and str(error).endswith(
        "), particle 0: walls must not cut a particle: move one of them")
    inside = [(Wall.plane([0, 0, 1], -20), "where normal·x >= offset"), (Wall.sphere([9, 9, 9], 2), "beyond the radius"),
              (Wall.cylinder([9, 9, 9], [0, 0, 3], 2), "beyond the radius"),
              (Wall.box([9, 9, 9], [20, 20, 20]), "outside of the box")]  # fmt: skip
    for wall, where in inside:
        error = error_of(spheres(periodic=False).set_walls, [wall])
        assert f"particle 0: walls must not have a particle in them, {where}: correct the numbers of the wall" in str(error), error
    for wall in (Wall.sphere([0, 0, 0], 0.25), Wall.cylinder([0, 0, 0], [0, 0, 3], 0.25), Wall.box([-0.25] * 3, [20, 20, 20])):
        assert "particle 0: walls must not cut a particle: move one of them" in str(error_of(spheres(periodic=False).set_walls, [wall]))
    assert "field 0 must be the same in all images" in str(error_of(simulation.set_fields, [Field.linear([1, 0, 0])]))
    slit.set_walls([Wall.plane([0, 0, -1], 2.0)])
    assert "must have no walls" in str(error_of(slit.chain, 1, 1.0))
    assert "walls" in str(error_of(slit.compress))
    assert "direction" in str(error_of(slit.chain, 1, 1.0, [0, 0, 0]))
    for bad in (lambda: Wall.plane([0, 1, 2, 3], 1), lambda: Field.harmonic([0, 0, 0], 1.0)):
        with pytest.raises(ValueError, match="must be"):
            bad()
    for kind in (7, -1, 10**30):
        assert error_of(slit.set_walls, [Wall(kind, (0, 0, 0), (0, 0, 1), 99.0)]).status == Status.EINVAL
        assert error_of(slit.set_fields, [Field(0, kind, (0, 0, 0), (0, 0, 1), 99.0)]).status == Status.EINVAL
    assert not slit.try_placement(0, [0, 0, -1.6])


def test_potential():
    """Its arguments, its energy, and a distribution: r² is 3/k on average."""
    seen = []

    def potential(particle, center, quaternion, semi_axes):
        seen.append((particle, *map(np.copy, (center, quaternion, semi_axes))))
        return 5.0 * (center @ center)

    simulation = alone((0.3, 0.4, 0.5), (1, 0, 0))
    simulation.set_potential(potential)
    assert simulation.energy() == 5
    particle, center, quaternion, semi_axes = seen[0]
    assert particle == 0 and center.tolist() == [1, 0, 0] and quaternion.tolist() == [1, 0, 0, 0] and semi_axes.tolist() == [0.3, 0.4, 0.5]
    simulation.set_steps(0.7, 0.1, 0.1)
    simulation.set_fractions(translation=1)
    squares = pypw85.Blocking()
    for _ in range(4000):
        simulation.sweep(2)
        squares.add((simulation.centers**2).sum())
    found = squares.estimate()
    assert abs(found.value[0] - 0.3) < 4 * found.error[0] < 0.1
    simulation.set_potential(None)
    assert simulation.energy() == 0


def test_exception_of_a_potential():
    """It comes back, and the simulation is in the state before."""

    def potential(particle, center, *others):
        if is_bad and particle == 7:
            raise KeyError("nothing is known of this place")
        return 0.0

    is_bad = False
    simulation = spheres()
    simulation.set_potential(potential)
    simulation.sweep(3)
    before, is_bad = simulation.save(), True
    for call in (simulation.sweep, lambda: simulation.volume_moves(1, 1.0), simulation.energy, lambda: simulation.tune(1), simulation.save,
                 lambda: simulation.try_placement(7, [0.1, 0, 0]), lambda: spheres().set_potential(potential)):  # fmt: skip
        with pytest.raises(KeyError, match="nothing is known"):
            call()
    is_bad = False
    assert simulation.save() == before
    simulation.sweep()
    simulation.set_potential(lambda *_: 0.0)
    assert error_of(simulation.set_potential, lambda *_: np.nan).status == Status.EPOTENTIAL
    assert error_of(simulation.set_potential, lambda *_: np.inf).status == Status.EPOTENTIAL
    simulation.sweep()


def test_nan_without_exception():
    value = 0.0
    simulation = spheres()
    simulation.set_potential(lambda *_: value)
    value = float("nan")
    error = error_of(simulation.sweep)
    assert error.status == Status.EPOTENTIAL and "NaN" in str(error)
    for bad in ("nan", "inf", "-inf"):
        value = float(bad)
        error = error_of(simulation.save)
        assert error.status == Status.EPOTENTIAL and "must give an energy that is finite" in str(error)


def test_address_of_a_function():
    """The address of a compiled function and its context."""
    doubles = ctypes.POINTER(ctypes.c_double)
    kind = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p, ctypes.c_int32, doubles, doubles, doubles)
    factor = ctypes.c_double(3.0)
    function = kind(lambda context, particle, center, *_: ctypes.cast(context, doubles)[0] * center[0])
    simulation = alone(center=(2, 0, 0))
    simulation.set_potential(ctypes.cast(function, ctypes.c_void_p).value, ctypes.addressof(factor))
    assert simulation.energy() == 6
    with pytest.raises(TypeError):
        simulation.set_potential("no function")


def test_copies_and_restart():
    simulation = spheres()
    simulation.set_fields([Field.aligning([0, 1, 0], 2)])
    simulation.set_potential(lambda particle, center, *_: np.cos(center[0] * np.pi / 3))
    simulation.sweep(2)
    for other in (copy.copy(simulation), copy.deepcopy(simulation)):
        first = copy.copy(simulation)
        first.sweep(2)
        other.sweep(2)
        assert first.save() == other.save()
    restored = pickle.loads(pickle.dumps(simulation))
    error = error_of(restored.sweep)
    assert error.status == Status.EPOTENTIAL and "potential must be set again" in str(error)
    assert error_of(restored.energy).status == error_of(restored.remove, 0).status == Status.EPOTENTIAL
    assert len(restored) == len(simulation)
    assert "their energies differ" in str(error_of(restored.set_potential, lambda particle, center, *_: np.cos(center[1])))
    restored.set_potential(lambda particle, center, *_: np.cos(center[0] * np.pi / 3))
    restored.sweep(2)
    simulation.sweep(2)
    assert restored.save() == simulation.save()


def law_sums(simulation, law):
    system = simulation.system()
    found = system.neighbors(2.0)
    return pypw85.law_forces_pairs(found.pairs, system.centers, system.q, law, system.cell, images=found.images)


def test_law():
    """The energy is that of `law_forces_pairs`; states and copies have the law; and where there is none."""
    simulation, law = spheres(spacing=1.2), pypw85.Law.inverse_powers(4, 12, 4, 6, mu2_max=4)
    before = simulation.save()
    simulation.set_law(law)
    energy = law_sums(simulation, law).energy
    assert simulation.energy() == pytest.approx(energy, abs=1e-7) and energy < -100
    other = pickle.loads(pickle.dumps(simulation))
    for one in (simulation, other):
        one.tune(5, pressure=1.0)
        one.sweep(5)
        one.volume_moves(5, 1.0)
        one.check()
    assert other.save() == simulation.save() and other.energy() == simulation.energy()
    assert "or law" in str(error_of(simulation.chain, 1, 1.0))
    assert "law" in str(error_of(simulation.insertion_weight, 1, [400, 400, 400]))
    assert simulation.law_virial() == pytest.approx(np.trace(law_sums(simulation, law).virial), rel=1e-12)
    assert simulation.compress() == other.compress() < 1
    for bad, reason in (
        (pypw85.Law.soft_repulsion(1), "law must not be a soft repulsion"),
        (pypw85.Law.inverse_powers(4, 12, 4, 6), "law must have a cutoff of at most 10⁶ in μ²"),
        (pypw85.Law.inverse_powers(1e7, 12, 4, 6, 4), "law must have energies of pairs of at most 2²⁰ k_B T"),
    ):
        assert reason in str(error_of(simulation.set_law, bad))
    again = spheres(spacing=1.2)
    again.set_law(law)
    again.set_law(None)
    assert again.save() == before and again.energy() == 0 and again.law_virial() == 0


def test_insertions_and_removals():
    simulation = spheres()
    old = simulation.centers
    before = old.copy()
    assert not simulation.try_insertion([0, 0, 0.5], [1, 0, 0, 0], [0.1, 0.1, 0.1])
    assert simulation.try_insertion([0.75, 0.75, 0.75], [2, 0, 0, 0], [0.1, 0.2, 0.3]) and len(simulation) == 64
    assert simulation.try_insertion([0.75, 0.75, 0.75], [2, 0, 0, 0], [0.1, 0.2, 0.3], take=True) and len(simulation) == 65
    assert simulation.semi_axes[64].tolist() == [0.1, 0.2, 0.3] and simulation.quaternions[64].tolist() == [1, 0, 0, 0]
    for k in range(300):  # more than the arrays have room for, again and again
        simulation.try_insertion([0.75 + 0.006 * (k % 7), 2.25, 0.75 + 0.02 * k], [1, 0, 0, 0], [1e-3] * 3, take=True)
    assert len(simulation) > 300
    gc.collect()
    assert (old == before).all()
    last = simulation.centers[-1].copy()
    simulation.remove(3)
    assert (simulation.centers[3] == last).all()
    simulation.check()
    simulation.sweep(2)
    with pytest.raises(IndexError):
        simulation.remove(len(simulation))
    del simulation
    gc.collect()
    assert (old == before).all()


def test_grand_canonical():
    """Two kinds of points have Poisson's distribution."""
    simulation = pypw85.HardEllipsoids(pypw85.System.from_axes(np.empty((0, 3)), np.empty((0, 3)), np.empty((0, 4)), cell=2 * np.eye(3)))
    kinds, numbers = [[1e-9, 1e-9, 2e-9], [1e-9, 1e-9, 1e-9]], pypw85.Blocking(2)
    for _ in range(5000):
        counts = simulation.insertion_moves(40, kinds, [1.0, 0.25])
        assert counts.insertions + counts.removals == 40
        first = (simulation.semi_axes[:, 2] == 2e-9).sum()
        numbers.add([first, len(simulation) - first])
    found = numbers.estimate()
    assert (abs(found.value - [8, 2]) < 4 * found.error).all() and (found.error < 0.2).all()
    assert simulation.insertion_weight(10, kinds[0]) == 1


def test_errors_of_insertions():
    simulation = spheres()
    assert "species 0: activities must be > 0, not -1" in str(error_of(simulation.insertion_moves, 1, [0.5, 0.5, 0.5], -1))
    assert "semi_axes" in str(error_of(simulation.insertion_weight, 1, [0.5, -0.5, 0.5]))
    assert "32 times" in str(error_of(simulation.insertion_weight, 1, [0.5, 0.5, 500]))
    assert "species 1: semi_axes must differ" in str(error_of(simulation.insertion_moves, 1, [[0.5, 0.5, 0.5]] * 2, [1, 2]))
    assert "must have a cell" in str(error_of(alone().insertion_weight, 1, [0.5, 0.5, 0.5]))
    assert "center" in str(error_of(simulation.try_insertion, [np.inf, 0, 0], [1, 0, 0, 0], [1, 1, 1]))
    assert "32 times" in str(error_of(simulation.try_insertion, [0, 0, 0], [1, 0, 0, 0], [1, 1, 1e9]))
    assert "quaternion" in str(error_of(simulation.try_insertion, [0, 0, 0], [0, 0, 0, 0], [1, 1, 1]))
    with pytest.raises(ValueError, match="shapes"):
        simulation.insertion_moves(1, [0.5, 0.5, 0.5], [1, 2])
    assert np.isnan(simulation.insertion_weight(0, [0.5, 0.5, 0.5]))


def test_kind_steps():
    simulation = spheres()
    simulation.set_steps(0.3, 0.4, 0.1)
    simulation.set_kind_steps([[0.5, 0.5, 0.5], [1, 2, 3]], [0.1, 0.2], 0.05)
    assert simulation.kind_steps([0.5, 0.5, 0.5]) == (0.1, 0.05, 0.1)
    assert simulation.kind_steps([1, 2, 3]) == (0.2, 0.05, 0.1)
    assert simulation.kind_steps([1, 1, 1]) == simulation.steps == (0.3, 0.4, 0.1)
    assert "translation must be > 0, not -0.1" in str(error_of(simulation.set_kind_steps, [1, 1, 1], -0.1, 0.1))
    assert "rotation must be at most 1, not 2.0" in str(error_of(simulation.set_kind_steps, [1, 1, 1], 0.1, 2.0))
    assert pickle.loads(pickle.dumps(simulation)).kind_steps([1, 2, 3]) == (0.2, 0.05, 0.1)
    simulation.tune(20)
    assert simulation.kind_steps([0.5, 0.5, 0.5]) != (0.1, 0.05, 0.1)
    assert simulation.kind_steps([1, 2, 3]) == (0.2, 0.05, simulation.steps.volume)
    simulation.set_kind_steps([], [], [])
    assert simulation.kind_steps([1, 2, 3]) == simulation.steps


def test_aspect():
    simulation = spheres()
    simulation.volume_moves(200, 0.0, change="aspect")
    simulation.tune(10, change="aspect")
    assert np.linalg.det(simulation.cell) == pytest.approx(216, rel=1e-12)
    assert np.ptp(np.diag(simulation.cell)) > 0.01
    assert "pressure" in str(error_of(simulation.volume_moves, 1, np.nan, "aspect"))
