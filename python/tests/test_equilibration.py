# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps before a run, until its averages stop drifting."""

import itertools
import re

import numpy as np
import pytest

import pypw85
from pypw85._equilibration import Equilibration

h5py = pytest.importorskip("h5py")


pytestmark = pytest.mark.usefixtures("folder")


def spheres(number=32, fraction=0.2):
    return pypw85.pack(np.full((number, 3), 0.5), fraction, seed=1)


def state_of(name):
    with h5py.File(name) as file:
        return file["pw85_mc/state"][()].tobytes()


def test_from_a_jammed_packing(run):
    """Steps that are tuned until the packing has loosened suit the run: the accepted parts are near the 0.4 to which they are tuned."""
    pypw85.write("jammed.xyz", pypw85.pack(np.tile([1.0, 1.0, 3.0], (60, 1)), 0.55, seed=0))
    done = run("mc", "jammed.xyz", "--sweeps", 1600, "--chains", 0, "--out", "run.h5")
    parts = [float(part) for part in re.findall(r"^(0\.\d+) accepted of", done.out, re.M)]
    assert len(parts) == 2 and all(0.25 < part < 0.6 for part in parts), done.out
    spent = int(re.search(r"^(\d+) sweeps to equilibrate$", done.out, re.M)[1])
    assert spent in (100, 300, 700, 1500), spent
    assert "were tuned before" not in done.out
    assert (spent == 1500) == ("the equilibration" in done.out) or "ended at its limit" not in done.out


def test_windows(monkeypatch):
    """A fluid that is in equilibrium passes the first window. A number that grows steadily fails in all of them, which double."""
    simulation = pypw85.HardEllipsoids(spheres(), seed=2)
    simulation.tune(200)
    windows = Equilibration(256, 0.1)
    while not windows.is_finished:
        simulation.sweep()
        windows.add(simulation)
    assert windows.sweeps in (256, 768) and windows.unsettled() == []
    values = itertools.count()
    monkeypatch.setattr(pypw85.HardEllipsoids, "energy", lambda _: float(next(values)))
    drifting, lengths = Equilibration(64, 0.1), set()
    while not drifting.is_finished:
        drifting.add(simulation)
        lengths.add(drifting.window)
    assert drifting.unsettled() == ["energy"] and drifting.sweeps == drifting.most_sweeps == 15 * 64
    assert lengths == {64, 128, 256, 512}


def test_restored():
    """At each sweep, a state continues bit by bit."""
    simulation = pypw85.HardEllipsoids(spheres(8), seed=2)
    whole = Equilibration(3, 0.2)
    parts = Equilibration(3, 0.2)
    while not whole.is_finished:
        simulation.sweep()
        whole.add(simulation)
        parts.add(simulation)
        parts = Equilibration.restore(parts.state())
        assert parts.is_finished == whole.is_finished
        for name, numbers in whole.state().items():
            np.testing.assert_array_equal(numbers, parts.state()[name])
    assert whole.sweeps == 45


def test_explicit(run):
    """So many sweeps as asked for, and no test of them."""
    pypw85.write("start.xyz", spheres(8))
    done = run("mc", "start.xyz", "--sweeps", 20, "--equilibrate", 7, "--out", "run.h5")
    assert "\n7 sweeps to equilibrate\n" in done.out and "equilibration ended" not in done.out
    done = run("mc", "start.xyz", "--sweeps", 20, "--out", "short.h5")
    assert "\n15 sweeps to equilibrate\n" in done.out
    assert "warning: the equilibration ended at its limit of 15 sweeps: in the last 8 of them" in done.out
    assert "equilibrate longer (--equilibrate 30)" in done.out


@pytest.mark.parametrize("last", [0, 9])
def test_resumed(run, monkeypatch, last):
    """A run that stops while it equilibrates goes on with the same bits, also if it then has more sweeps."""
    pypw85.write("start.xyz", spheres(8))
    common = ["mc", "start.xyz", "--sweeps", 16, "--every", 4, "--chains", 0]
    assert run(*common, "--out", "whole.h5").status == 0
    assert run("mc", "--resume", "whole.h5", "--sweeps", 24).status == 0
    calls, tune = itertools.count(), pypw85.HardEllipsoids.tune

    def dying(*others):
        if next(calls) == last:
            raise MemoryError
        return tune(*others)

    with monkeypatch.context() as changed:
        changed.setattr(pypw85.HardEllipsoids, "tune", dying)
        assert run(*common, "--checkpoint", 0, "--out", "run.h5").status != 0
    done = run("mc", "--resume", "run.h5", "--sweeps", 24)
    assert done.status == 0, done
    assert state_of("run.h5") == state_of("whole.h5")
