# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the time series of runs."""

import sys

import matplotlib
import numpy as np
import pytest

import pypw85
from pypw85.cli import _series

matplotlib.use("Agg")
pytest.importorskip("h5py")


@pytest.fixture
def run(run, folder):
    pypw85.write("start.xyz", pypw85.pack(np.tile([0.5, 0.5, 1.0], (20, 1)), 0.2, seed=1))
    return run


def test_series(run, tmp_path):
    """The file of a run and its table have the same numbers, which are plotted; a packing has none, and is plotted as before."""
    assert run("mc", "start.xyz", "--sweeps", 200, "--out", "run.csv").status == 0
    of_run, of_table = (_series.read_series(name) for name in ("run.csv.h5", "run.csv"))
    assert list(of_run) == list(of_table) and len(of_run["sweep"]) == 20
    for name, values in of_run.items():
        np.testing.assert_array_equal(values, of_table[name])
    figure = _series.series_figure(of_run)
    labels = [ax.get_ylabel() for ax in figure.axes]
    assert labels == ["nematic order S", "Z (chains)", "Z (contacts)", "density"]
    # The density at constant volume is a quotient that may change by a unit of rounding. Its axis is of its own size.
    low, high = figure.axes[3].get_ylim()
    density = of_run["density"][0]
    assert low == pytest.approx(0.95 * density, rel=1e-9) and high == pytest.approx(1.05 * density, rel=1e-9)
    low, high = figure.axes[0].get_ylim()
    assert low < of_run["nematic_order"].min() and of_run["nematic_order"].max() < high
    samples, mean = figure.axes[0].lines
    np.testing.assert_array_equal(samples.get_ydata(), of_run["nematic_order"])
    assert mean.get_ydata()[-1] == pytest.approx(of_run["nematic_order"].mean(), rel=1e-14)
    for name in ("run.csv", "run.csv.h5"):
        done = run("plot", name, "series.png")
        assert (done.status, done.out) == (0, "series.png: 20 samples up to sweep 200\n"), done
        assert (tmp_path / "series.png").stat().st_size > 10000
        done = run("plot", name, "series.png", "--reach", 3)
        assert done.status == 2 and "--reach has no effect on the time series of a run" in done.err
    assert "nematic order" in run("plot", "start.xyz", "pairs.png").out


@pytest.mark.parametrize("unit", [2.0**-40, 1.0, -(2.0**40)])
def test_axis_of_a_constant(unit):
    """5 % to either side, also if the numbers differ by rounding errors; other numbers have no such axis."""
    for values in (np.full(9, 0.25), 0.25 * (1 + 2.0**-52 * np.arange(9))):
        low, high = _series._limits(unit * values)
        assert high - low == pytest.approx(0.025 * abs(unit)) and (low + high) / 2 == pytest.approx(0.25 * unit)
    assert _series._limits(unit * (0.25 + 1e-10 * np.arange(9))) is None


def test_broken_tables(run, tmp_path):
    header = "sweep,volume,density,packing_fraction"
    for text, sentence in ((header + "\n", "has no samples yet"), (header + "\n1,2,3\n", "has 3 numbers in a line, but 4 names"),
                           (header + "\n1,2,3,x\n", "is not a complete table")):  # fmt: skip
        (tmp_path / "bad.csv").write_text(text)
        done = run("plot", "bad.csv", "a.png")
        assert done.status == 2 and f"pw85: bad.csv: {sentence}" in done.err, done


def test_axis_of_mu(run, monkeypatch):
    """It begins where pairs are."""
    plot = sys.modules["pypw85.cli.plot"]

    figures = []
    monkeypatch.setattr(plot, "_figure", lambda *given, _make=plot._figure: figures.append(_make(*given)) or figures[-1])
    assert run("plot", "start.xyz", "a.png").status == 0
    system = pypw85.read("start.xyz")
    least = float(system.contacts(2.0).mu.min())
    assert least - 0.02 < figures[0].axes[0].get_xlim()[0] <= least
