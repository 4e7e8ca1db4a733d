# SPDX-License-Identifier: BSD-3-Clause
"""Replica exchange in pressure: `examples/python/replica_exchange.py`."""

import itertools
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

FOLDER = Path(os.environ["PYPW85_SOURCE"]) / "examples" / "python"
sys.path.insert(0, str(FOLDER))
import replica_exchange  # noqa: E402


def test_output():
    """The numbers of the page, by one process."""
    done = subprocess.run([sys.executable, FOLDER / "replica_exchange.py", "1"], capture_output=True, check=True)
    assert done.stdout.decode() == (FOLDER / "replica_exchange.out").read_text(encoding="utf-8")


def test_processes(monkeypatch):
    """Volumes, exchanges and states have the same bits with any number of processes."""
    monkeypatch.setenv("OMP_NUM_THREADS", "1")  # of those that are started
    results = []
    for processes in (1, 2, 3):
        replicas = [replica_exchange.fluid(seed) for seed in range(3)]
        *numbers, replicas = replica_exchange.exchange(replicas, [2.0, 2.3, 2.6], 10, 2, seed=5, processes=processes)
        results.append(([number.tobytes() for number in numbers], [replica.save() for replica in replicas]))
    assert results[0] == results[1] == results[2]


def gas(seed):
    """Three points, nearly: their volumes have the density V³ exp(-βPV), and the mean 4/βP."""
    places, upright = 0.1 * np.arange(9).reshape(3, 3), np.tile([1, 0, 0, 0], (3, 1))
    return pypw85.HardEllipsoids(pypw85.System.from_axes(places, np.full((3, 3), 1e-3), upright, cell=2 * np.eye(3)), seed=seed)


def mean_of(column):
    """With its error."""
    blocking = pypw85.Blocking()
    for value in column:
        blocking.add(value)
    (value,), (error,), _ = blocking.estimate()
    return value, error


def test_ideal_gas():
    """The mean volume of an ideal gas at each pressure. Exchanges are many, so that wrong ones would show; their part is known, too."""
    pressures = [0.5, 1.0, 2.0]
    volumes, orders, accepted, _ = replica_exchange.exchange(list(map(gas, range(3))), pressures, 4000, 1, seed=2)
    for pressure, column in zip(pressures, volumes.T):
        value, error = mean_of(column)
        assert value == pytest.approx(4 / pressure, abs=4 * error) and error < 0.1 * value
    assert all(len(set(column)) == 3 for column in orders.T)
    # <min(1, exp((p1 - p2)(v1 - v2)))> of independent volumes
    random = np.random.default_rng(1)
    for k, (p1, p2) in enumerate(itertools.pairwise(pressures)):
        v1, v2 = random.gamma(4, 1 / p1, 100000), random.gamma(4, 1 / p2, 100000)
        assert accepted[k] == pytest.approx(np.exp(np.minimum((p1 - p2) * (v1 - v2), 0)).mean(), abs=0.05)


def test_single_runs():
    """Densities of a dense fluid are those of runs at one pressure."""
    pressures = [2.0, 2.4]
    volumes, _, accepted, _ = replica_exchange.exchange([replica_exchange.fluid(seed) for seed in (1, 2)], pressures, 600, 20, seed=3)
    assert 0.2 < accepted[0] < 0.8
    for k, pressure in enumerate(pressures):
        single = replica_exchange.settle((replica_exchange.fluid(7 + k), pressure))
        found = []
        for _ in range(600):
            single = replica_exchange.advance((single, pressure, single.steps, 20))
            found.append(single.system().volume)
        (one, error1), (other, error2) = mean_of(volumes[:, k]), mean_of(found)
        error = np.hypot(error1, error2)
        assert abs(one - other) < 4 * error < 0.1 * one
