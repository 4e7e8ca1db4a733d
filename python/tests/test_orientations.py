# SPDX-License-Identifier: BSD-3-Clause
"""The free energy of a crystal with orientations: `reference/free_energy/orientations.py`."""

import math
import os
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

sys.path.insert(0, str(Path(os.environ["PYPW85_SOURCE"]) / "reference" / "free_energy"))
import free_energy
import orientations


def test_table():
    """Both ways agree within three errors, which are small against what turning costs."""
    rows = orientations.read()
    assert [row.particles for row in rows] == [32, 108]
    for row in rows:
        error = math.hypot(row.einstein_error, row.field_error)
        assert abs(row.einstein - row.field) < 3 * error
        assert error < 0.05 * (row.field - row.spheres)


def test_short_run(monkeypatch):
    """One row by the Einstein crystal, with that of the table from spheres."""
    monkeypatch.setattr(free_energy, "NORMAL_SAMPLES", 500)
    value, error = orientations.by_einstein_crystal(2, 1000, 2)
    row = orientations.read()[0]
    assert abs(value - row.field) < 4 * math.hypot(error, row.field_error) and error < 0.12


def test_short_field():
    """What turning costs, with that of the table."""
    value, error = orientations.turning(2, 4000, 2)
    row = orientations.read()[0]
    assert abs(value - (row.field - row.spheres)) < 4 * error < 0.3


@pytest.mark.parametrize("spring", [0.0, 0.1, 3.0, 50.0, 1000.0])
def test_axis_moments(spring):
    """z is Dawson's function of √κ over √κ, and <sin²θ> its logarithmic derivative."""
    special = pytest.importorskip("scipy.special")
    z, square = orientations.axis_moments(spring)
    root = math.sqrt(spring)
    assert z == pytest.approx(special.dawsn(root) / root if spring else 1, rel=1e-12)
    expected = 2 / 3 if spring == 0 else 1 / (2 * spring) - (1 / special.dawsn(root) - 2 * root) / (2 * root)
    assert square == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("spring", [0.5, 3.0, 1000.0])
def test_drawn_axes(spring):
    """The mean of sin²θ, and axes that lean to no side."""
    turns = orientations.draw_axes(spring, 50000, np.random.default_rng(1))
    np.testing.assert_allclose((turns**2).sum(axis=1), 1, rtol=1e-14)
    squares = orientations.squared_sine(turns.T)
    assert squares.mean() == pytest.approx(orientations.axis_moments(spring)[1], abs=4 * squares.std() / math.sqrt(50000))
    sides = turns[:, 1:3] / np.sqrt(squares.mean())
    assert np.abs(sides.mean(axis=0)).max() < 0.02


def test_rotations():
    """The product of quaternions, and the angle of the axis, by matrices."""
    turn = [0.5, -0.1, 0.7, 0.2]
    way = np.array([0.1, 0.2, -0.3])
    axes = [1.0, 1.0, 2.0]
    found = orientations.rotated(way, turn)
    first, second = (pypw85.ellipsoid_quaternion(axes, one) for one in (turn, found))
    one, a, b, c = 1.0, *way
    norm = one + way @ way
    matrix = np.array([
        [one + a * a - b * b - c * c, 2 * (a * b - c), 2 * (a * c + b)],
        [2 * (a * b + c), one - a * a + b * b - c * c, 2 * (b * c - a)],
        [2 * (a * c - b), 2 * (b * c + a), one - a * a - b * b + c * c],
    ]) / norm  # fmt: skip

    def full(q):
        return np.array([[q[0], q[1], q[2]], [q[1], q[3], q[4]], [q[2], q[4], q[5]]])

    np.testing.assert_allclose(full(second), matrix @ full(first) @ matrix.T, rtol=0, atol=1e-14)
    # q_zz = 1 + 3 cos²θ for the semi-axes 1, 1, 2
    assert orientations.squared_sine(found) == pytest.approx(1 - (second[5] - 1) / 3, abs=1e-14)


def test_springs_alone(monkeypatch):
    """Spheroids that are too small to meet: the mean is that of normal numbers, and of axes without volume."""
    monkeypatch.setattr(orientations, "DENSITY", 0.01)
    sites, rng = orientations.crystal(2), np.random.default_rng(3)
    assert orientations.free_probability(sites, rng) == (1.0, 0.0)
    value, error = orientations.mean_square(sites, 20.0, 1500, rng)
    expected = 31 * 1.5 / 20 + 32 * orientations.RATIO * orientations.axis_moments(orientations.RATIO * 20)[1]
    assert value == pytest.approx(expected, abs=4 * error) and error < 0.04 * value


def test_crystal():
    """The stretched lattice at the density of the spheres, where axes along z touch as spheres do."""
    sites, spheres = orientations.crystal(2), free_energy.crystal(2, orientations.DENSITY)
    assert sites.density == pytest.approx(orientations.DENSITY) and sites.packing_fraction == pytest.approx(spheres.packing_fraction)
    one, other = sites.contacts(1.3), spheres.contacts(1.3)
    assert len(one.mu) == len(other.mu) > 100
    np.testing.assert_allclose(np.sort(one.mu), np.sort(other.mu), rtol=1e-12)
    assert np.ptp(sites.semi_axes[0]) > 0.05
