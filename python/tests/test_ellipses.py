# SPDX-License-Identifier: BSD-3-Clause
"""The equation of state of hard ellipses and discs: `reference/ellipses`."""

import itertools
import os
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(os.environ["PYPW85_SOURCE"]) / "reference" / "ellipses"))
import ellipses
from ellipses import Effort, State
from scipy.special import ellipe
from scipy.stats import chi2
from systems import expect_resumed

pytestmark = pytest.mark.usefixtures("usual_mode")  # the programs leave the reproducible mode on
ROWS = ellipses.read_table()
AT_CONSTANT_AREA = [state for state in ROWS if state.ensemble == "NVT"]


def numbers(state, *names):
    return [float(ROWS[state][name]) for name in names]


def test_complete():
    """All states are there, each with its seed and its pressure."""
    assert list(ROWS) == ellipses.states()
    for state, row in ROWS.items():
        assert int(row["seed"]) == state.seed
        if state.ensemble == "NPT":
            assert row["pressure"] == ROWS[state._replace(ensemble="NVT")]["pressure"]
        else:
            fraction, pressure, z = numbers(state, "fraction", "pressure", "z")
            assert pressure == pytest.approx(fraction * z, rel=1e-5) and fraction == pytest.approx(float(state.target), rel=1e-6)
    assert len({state.seed for state in ROWS}) == len(ROWS)


@pytest.mark.parametrize("target", ["0.1", "0.2", "0.3"])
def test_discs(target):
    """The virial series to B6. Beyond, it has some 0.12 x⁶/(1 - x) with x = B2 ρ, twice the area fraction. In the cell, the term of B2 has
    the factor (N - 1)/N, and that of B3 some 3/N less."""
    state = State("1", "NVT", target)
    (particles, z, error), x = numbers(state, "particles", "z", "z_error"), 2 * float(target)
    series = 1 + x * (1 - 1 / particles) + 0.78200 * x**2 + 0.53223 * x**3 + 0.33356 * x**4 + 0.19884 * x**5
    rest = 0.12 * x**6 / (1 - x)
    assert abs(z - series - rest / 2) < 4 * error + rest / 2 + 3 * x**2 / particles


def scaled_particles(aspect, fraction):
    """Z by the scaled particle theory of convex figures, 1/(1 - φ) + γ φ/(1 - φ)² with γ = perimeter²/(4π area). B2 is exact."""
    perimeter = 4 * aspect * ellipe(1 - 1 / aspect**2)
    return 1 / (1 - fraction) + perimeter**2 / (4 * np.pi**2 * aspect) * fraction / (1 - fraction) ** 2


@pytest.mark.parametrize("aspect", ellipses.FRACTIONS)
def test_scaled_particles(aspect):
    """Beyond B2, the theory errs by some per cent."""
    for target in ("0.1", "0.2"):
        z, error = numbers(State(aspect, "NVT", target), "z", "z_error")
        assert abs(z / scaled_particles(float(aspect), float(target)) - 1) < 0.015 * float(target) / 0.1 + 4 * error / z, (target, z)


def test_two_pressures():
    """Chains and contacts agree in each state, and as a whole: χ² is below the quantile with a probability of 0.999."""
    sigmas = []
    for state in AT_CONSTANT_AREA:
        z, z_error, contacts, contacts_error = numbers(state, "z", "z_error", "contacts", "contacts_error")
        sigmas.append((z - contacts) / np.hypot(z_error, contacts_error))
        assert abs(sigmas[-1]) < 4, (state, sigmas[-1])
    assert np.square(sigmas).sum() < chi2.ppf(0.999, len(sigmas))


@pytest.mark.parametrize("aspect", ellipses.FRACTIONS)
def test_stable(aspect):
    """The pressure increases with the area fraction."""
    pressures = [numbers(state, "pressure")[0] for state in AT_CONSTANT_AREA if state.aspect == aspect]
    assert all(lower < higher for lower, higher in itertools.pairwise(pressures))


@pytest.mark.parametrize("state", [state for state in ROWS if state.ensemble == "NPT"], ids=" ".join)
def test_constant_pressure(state):
    """The pressure of the chains, applied, leads to the area fraction at which they found it, and contacts find this pressure. Z grows, so
    that an error of the pressure is a smaller one of the fraction. That of few ellipses differs by some Z/N."""
    fraction, error, contacts, contacts_error, pressure, particles = numbers(
        state, "fraction", "fraction_error", "contacts", "contacts_error", "pressure", "particles"
    )
    z, z_error = numbers(state._replace(ensemble="NVT"), "z", "z_error")
    target = float(state.target)
    assert abs(fraction / target - 1) < 4 * np.hypot(error / target, z_error / z) + z / particles, (fraction, error)
    assert abs(contacts - pressure / fraction) < 4 * np.hypot(contacts_error, z * error / fraction) + 2 * z / particles


def test_order():
    """Dilute ellipses have no order, and dense long ones have."""
    for state in AT_CONSTANT_AREA:
        (order,) = numbers(state, "order")
        if state.aspect == "1":
            assert np.isnan(order)
        elif float(state.target) <= 0.3:
            assert order < 0.15, state
    assert numbers(State("6", "NVT", "0.6"), "order")[0] > 0.4


def test_remade():
    """A short run on a small system agrees with the table."""
    state = State("2", "NVT", "0.3")
    row = ellipses.row_of(state, Effort(cells=(10, 6), tuning=100, equilibration=32, cycles=128, sweeps=4))
    z, error = numbers(state, "z", "z_error")
    assert abs(float(row["z"]) - z) < 4 * np.hypot(error, float(row["z_error"])) + z / 120, row
    assert row.keys() == ROWS[state].keys() and float(row["z_error"]) < 0.1


def test_start():
    """It is what it says, in a cell whose edges differ little."""
    for aspect, targets in ellipses.FRACTIONS.items():
        start = ellipses.start_of(State(aspect, "NVT", targets[-1]), Effort().cells)
        assert start.packing_fraction == pytest.approx(float(targets[-1]), rel=1e-12) and len(start.overlaps().mu) == 0
    edges = np.diag(ellipses.start_of(State("1", "NVT", "0.5"), Effort().cells).cell)[:2]
    assert edges.max() < 1.1 * edges.min()


def test_resumed(tmp_path, monkeypatch, capsys):
    """Rows that are there stay; what is missing is measured, and written in order."""
    states = [State("2", "NVT", fraction) for fraction in ("0.1", "0.2", "0.3")]
    monkeypatch.setattr(ellipses, "effort", lambda _: Effort(cells=(5, 3), tuning=1, equilibration=1, cycles=64, sweeps=1))
    expect_resumed(ellipses, states, tmp_path / "table.csv", monkeypatch, capsys)
