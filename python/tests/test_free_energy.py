# SPDX-License-Identifier: BSD-3-Clause
"""The free energy of a crystal: `reference/free_energy`."""

import math
import os
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

FOLDER = Path(os.environ["PYPW85_SOURCE"]) / "reference" / "free_energy"
sys.path.insert(0, str(FOLDER))
import free_energy  # noqa: E402


def test_table():
    """The limit of the table is the published value, within three errors, which are small enough to see a missing term."""
    rows = free_energy.read()
    assert [row.particles for row in rows] == [32, 108, 256]
    value, error = free_energy.limit(rows)
    assert abs(value - free_energy.PUBLISHED) < 3 * math.hypot(error, free_energy.PUBLISHED_ERROR)
    assert error < 0.01
    # Without the terms in N, the last row alone is far from the limit.
    assert free_energy.PUBLISHED - rows[-1].value > 3 * rows[-1].error


def test_short_run(monkeypatch):
    """One row, by the program, with the others of the table."""
    monkeypatch.setattr(free_energy, "NORMAL_SAMPLES", 500)
    found = free_energy.excess(2, 800, 5)
    expected = free_energy.read()[0]
    assert found.particles == 32 and abs(found.value - expected.value) < 4 * found.error < 0.25, found


def test_springs_alone(monkeypatch):
    """Spheres that are too small to meet: the mean square is that of normal numbers, (N - 1) 3/(2 Λ), and nothing overlaps."""
    monkeypatch.setattr(free_energy, "DENSITY", 0.01)
    sites = free_energy.crystal(2)
    rng = np.random.default_rng(3)
    assert free_energy.free_probability(sites, rng) == (1.0, 0.0)
    value, error = free_energy.mean_square(sites, 150.0, 1500, rng)
    assert value == pytest.approx(31 * 1.5 / 150, abs=4 * error) and error < 0.02 * value


def test_crystal():
    """Four spheres in each cubic cell, twelve neighbours of each, at the density."""
    sites = free_energy.crystal(3)
    assert len(sites) == 108 and sites.density == pytest.approx(free_energy.DENSITY)
    assert pypw85.bond_order(sites).mean == pytest.approx([0.190941, 0.574524], abs=1e-6)


def test_limit():
    """A straight line in 1/N is found exactly, with the error of its first coefficient."""
    rows = [free_energy.Excess(n, 5.9 - 6 / n - math.log(n) / n, 0.001) for n in (32, 108, 256)]
    value, error = free_energy.limit(rows)
    assert value == pytest.approx(5.9, abs=1e-12)
    assert 0.001 / math.sqrt(3) < error < 0.002
