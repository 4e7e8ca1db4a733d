"""The equation of state of hard spheroids: `reference/equation_of_state`."""

import os
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(os.environ["PYPW85_SOURCE"]) / "reference" / "equation_of_state"))
import equation_of_state as eos
from equation_of_state import Effort, State

ROWS = eos.read_table()


def numbers(state, *names):
    return [float(ROWS[state][name]) for name in names]


def agree(one, other, allowed=4.0):
    """Whether two values, each with its error, agree."""
    return abs(one[0] - other[0]) < allowed * np.hypot(one[1], other[1])


def test_complete():
    """All states are there, each with its seed, and the order and the pressure make sense."""
    assert list(ROWS) == eos.states()
    for state, row in ROWS.items():
        assert int(row["seed"]) == state.seed
        assert 0 <= float(row["order"]) <= 1
        fraction, pressure, z = numbers(state, "fraction", "pressure", "z")
        assert pressure == pytest.approx(fraction * z, rel=1e-5)
    assert len({state.seed for state in ROWS}) == len(ROWS)


@pytest.mark.parametrize("state", [state for state in eos.states() if state.aspect == "1"], ids=" ".join)
def test_spheres(state):
    """Carnahan and Starling are right to 0.3 % there."""
    fraction, z, error = numbers(state, "fraction", "z", "z_error")
    exact = (1 + fraction + fraction**2 - fraction**3) / (1 - fraction) ** 3
    assert eos.parsons(1.0, fraction) == pytest.approx(exact, rel=1e-12)
    assert agree((z, error), (exact, 0.003 * exact / 4)), (z, error, exact)


@pytest.mark.parametrize("aspect", ["3", "1/3"])
def test_starts(aspect):
    """From a crystal of parallel ellipsoids the same isotropic fluid is reached as from a random packing."""
    random, aligned = (State(aspect, start, "NVT", "0.3") for start in ("random", "aligned"))
    assert agree(numbers(random, "z", "z_error"), numbers(aligned, "z", "z_error"))
    assert ROWS[aligned]["order"] < "0.2"


def test_remade():
    """A short run on a small system agrees with the table."""
    state = State("3", "random", "NVT", "0.3")
    row = eos.row_of(state, Effort(particles=64, tuning=200, equilibration=32, cycles=128, sweeps=3))
    assert agree((float(row["z"]), float(row["z_error"])), numbers(state, "z", "z_error")), (row, ROWS[state])
    assert row.keys() == ROWS[state].keys()


def test_ensembles():
    """The pressure of the chains, applied, leads to the volume fraction at which they found it."""
    state = State("3", "random", "NPT", "0.3")
    pressure = float(ROWS[state._replace(ensemble="NVT")]["pressure"])
    row = eos.row_of(state, Effort(particles=64, tuning=200, equilibration=64, cycles=128, sweeps=30), pressure)
    assert agree((float(row["fraction"]), float(row["fraction_error"])), (0.3, 0.0)), row
    assert float(row["fraction_error"]) < 0.01


@pytest.mark.parametrize("aspect", eos.CELLS)
def test_aligned_start(aspect):
    """It is what it says, in a box whose edges differ little."""
    state = State(aspect, "aligned", "NVT", "0.7")
    start = eos.aligned_start(state, eos.CELLS[aspect])
    assert start.packing_fraction == pytest.approx(0.7, rel=1e-12)
    assert pypw85.nematic_order(start) == pytest.approx(1, rel=1e-12) and len(start.overlaps().mu) == 0
    assert start.semi_axes[0] == pytest.approx(np.array([1, 1, state.kappa]) / np.cbrt(state.kappa), rel=1e-15)
    edges = np.diag(start.cell)
    assert edges.max() < 1.7 * edges.min(), edges


def test_estimate():
    """Errors of independent numbers, and larger ones of numbers that follow their predecessors."""
    random = np.random.default_rng(1)
    steps = random.normal(size=4096)
    result = eos.estimate(list(steps))
    assert abs(result.value) < 4 / 64 and 0.9 / 64 < result.error < 2 / 64
    assert abs(result.drift) < 4
    means = np.convolve(steps, np.full(128, 1 / 128), "same")
    assert 0.6 / 64 < eos.estimate(list(means)).error < 2 / 64, "single values differ by 1/√128, but the mean has the same error"
    assert eos.estimate(list(steps + np.linspace(0, 1, 4096))).drift > 3


def test_resumed(tmp_path, monkeypatch, capsys):
    """Rows that are there stay; what is missing is measured, and written in order."""
    states = [State("2", "random", "NVT", phi) for phi in ("0.1", "0.2", "0.3")]
    table = tmp_path / "table.csv"
    monkeypatch.setattr(eos, "states", lambda: states)
    monkeypatch.setattr(eos, "effort", lambda state: Effort(particles=8, tuning=1, equilibration=1, cycles=128, sweeps=1))
    monkeypatch.setattr(sys, "argv", ["equation_of_state.py", str(table)])
    eos.main()
    whole = table.read_text()
    lines = whole.splitlines(keepends=True)
    table.write_text(lines[0] + lines[1] + lines[3])
    capsys.readouterr()
    eos.main()
    assert table.read_text() == whole
    assert capsys.readouterr().out.startswith("2 random NVT 0.2 ")
    eos.main()
    assert capsys.readouterr().out == ""
