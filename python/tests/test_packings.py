# SPDX-License-Identifier: BSD-3-Clause
"""Jammed random packings: `reference/packings`."""

import os
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

sys.path.insert(0, str(Path(os.environ["PYPW85_SOURCE"]) / "reference" / "packings"))
import packings

RUNS = packings.read(packings.FOLDER / "runs.csv")
ROWS = {(row["shape"], int(row["sweeps"])): row for row in packings.read(packings.FOLDER / "packings.csv")}
NUMBER = 48


@pytest.fixture(scope="module", params=packings.SWEEPS)
def sweeps(request):
    """Before each compression, or 0 without growth by Monte Carlo."""
    return request.param


@pytest.fixture(scope="module")
def small(sweeps):
    """A packing of few ellipsoids."""
    return packings.make(packings.semi_axes("1.5"), NUMBER, sweeps, 1)


def test_complete():
    """All runs are there, and the table has their means."""
    assert [(run["shape"], run["sweeps"], run["seed"]) for run in RUNS] == packings.wanted()
    assert list(ROWS.values()) == packings.table(RUNS)


def test_published():
    """No packing is ordered, and none has more contacts than the isostatic number: twice the degrees of freedom, 6 for spheres, 10
    for spheroids and 12 for others. Packings that grow slowly jam where others found it: spheres at 0.64, spheroids near 1.5 or 0.6
    at 0.70 to 0.71 and the triaxial ellipsoids at 0.735. Results of another rate of growth differ from these by up to 0.01."""
    for (shape, _), row in ROWS.items():
        most = 6 if shape == "1" else 12 if ":" in shape else 10
        assert 5.7 < float(row["contacts"]) < most, shape
        assert float(row["order"]) < 0.2, shape
    assert all(float(run["bond_order"]) < 0.2 for run in RUNS if run["bond_order"])
    for shape, published in (("1", 0.64), ("1.5", 0.71), ("2/3", 0.71), ("1.25:1:0.8", 0.735)):
        assert abs(float(ROWS[shape, 30]["fraction"]) - published) < 0.01, shape


def test_slow_growth():
    """It finds denser packings than none, by more than four standard errors."""
    slow, quenched = ROWS["1.25:1:0.8", 30], ROWS["1.25:1:0.8", 0]
    error = np.hypot(float(slow["fraction_error"]), float(quenched["fraction_error"]))
    assert float(slow["fraction"]) - float(quenched["fraction"]) > 4 * error


def test_remade(small, sweeps):
    """Few ellipsoids jam where the table says. The standard deviation of a run is that of the table's runs times the root of the
    ratio of numbers, and four of them are allowed, with 0.005 more because small cubes jam earlier."""
    row = ROWS["1.5", sweeps]
    root = np.sqrt(int(row["runs"]) * int(row["particles"]) / NUMBER)
    assert abs(small.loose.packing_fraction - float(row["fraction"])) < 4 * root * float(row["fraction_error"]) + 0.005
    assert abs(packings.contacts(small.jammed).mean - float(row["contacts"])) < 4 * root * float(row["contacts_error"])


def test_grown():
    """Growth leaves no overlap, and ends where Z is about LAST_PRESSURE. By Salsburg and Wood, the volume fraction is then below
    that of jamming by the share 5/LAST_PRESSURE. Few compressions measure the pressure, and the last two ellipsoids are still
    close: a fifth to three times of the share are allowed."""
    packing = packings.grown(packings.semi_axes("1.5"), NUMBER, 10, 2)
    assert len(packing.overlaps().mu) == 0
    growth = 5 / packings.LAST_PRESSURE
    assert not packings.quenched(packings.scaled(packing, (1 + growth / 5) ** (-1 / 3)))[1]
    assert packings.quenched(packings.scaled(packing, (1 + 3 * growth) ** (-1 / 3)))[1]


def test_exact(small):
    """The packing has no overlap, and is denser by 1e-4 where it is jammed. The last cube grew by what overlaps were left, of an
    energy of less than 1e-13 per ellipsoid: all 1 - μ² are less than √(2e-13 NUMBER), and the volume grows by 3/2 of that."""
    assert len(small.loose.overlaps().mu) == 0
    assert len(small.jammed.overlaps().mu) > 0
    last_growth = small.jammed.packing_fraction / small.loose.packing_fraction / (1 + 1e-4) - 1
    assert -1e-12 < last_growth < 1.5 * np.sqrt(2e-13 * NUMBER)
    assert small.loose.packing_fraction == pytest.approx(NUMBER * 4 / 3 * np.pi / np.linalg.det(small.loose.cell), rel=1e-12)


def test_without_overlaps():
    """The least expansion: one that is smaller by some rounding errors leaves an overlap."""
    start = packings.random_start(packings.semi_axes("1.25:1:0.8"), 20, 5)
    free = packings.without_overlaps(start)
    assert len(start.overlaps().mu) > 0
    assert len(free.overlaps().mu) == 0
    assert len(packings.scaled(free, 1 - 2.0**-40).overlaps().mu) > 0


def test_last_overlaps(monkeypatch):
    """A run removes the overlaps that its last quench leaves. The jammed packing keeps them."""
    axes = packings.semi_axes("1.25:1:0.8")
    start = packings.random_start(axes, 20, 5)
    monkeypatch.setattr(packings, "first_jammed", lambda *_: (start, packings.GROWTH))
    monkeypatch.setattr(packings, "quenched", lambda system: (system, False))
    packing = packings.make(axes, 20, 0, 5)
    assert packing.jammed is start
    assert len(packing.loose.overlaps().mu) == 0


def test_contacts():
    """Of the simple cubic lattice of spheres, where each touches six. Of 27 without a periodic cell all are rattlers, one after the
    other: the corners have three contacts, then the edges have two, then the faces have one."""
    edge = 2.0 * np.arange(3)
    places = np.stack(np.meshgrid(edge, edge, edge, indexing="ij"), axis=-1).reshape(-1, 3)
    # A sphere in a hole of the lattice, which is too small for it, overlaps the eight around it, but they stay in place.
    filled = np.concatenate([places, [[1.0, 1.0, 1.0]]])
    cell = 6 * np.eye(3)
    for centers, box, expected in ((places, cell, (6, 0)), (filled, cell, ((27 * 6 + 16) / 28, 0)), (places, None, (0, 1))):
        n = len(centers)
        spheres = pypw85.System.from_axes(centers, np.full((n, 3), 1.001), np.tile([1.0, 0, 0, 0], (n, 1)), cell=box)
        assert packings.contacts(spheres) == pytest.approx(expected, abs=1e-15)


def test_bond_order():
    """Of an fcc crystal by its sum over spherical harmonics: 0.57452 (Steinhardt and others, 1983)."""
    corners = np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 1, 3)
    places = (corners + [[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]]).reshape(-1, 3)
    radii = np.full(places.shape, 1.001 / np.sqrt(8))
    crystal = pypw85.System.from_axes(places, radii, np.tile([1.0, 0, 0, 0], (len(places), 1)), cell=3 * np.eye(3))
    assert packings.bond_order(crystal) == pytest.approx(0.57452, abs=1e-5)


def test_resumed(tmp_path, monkeypatch, capsys):
    """Runs that are there stay; what is missing is made, and written in order."""
    monkeypatch.setattr(packings, "SHAPES", ("1", "1.5"))
    monkeypatch.setattr(packings, "SEEDS", 2)
    monkeypatch.setattr(packings, "PARTICLES", 6)
    monkeypatch.setattr(packings, "make", lambda axes, *rest: packings.Packing(*[packings.random_start(axes, 6, rest[-1])] * 2))
    monkeypatch.setattr(sys, "argv", ["packings.py", str(tmp_path)])
    packings.main()
    whole = [(tmp_path / name).read_text() for name in ("runs.csv", "packings.csv")]
    lines = whole[0].splitlines(keepends=True)
    (tmp_path / "runs.csv").write_text("".join([*lines[:3], *lines[4:]]))
    capsys.readouterr()
    packings.main()
    assert [(tmp_path / name).read_text() for name in ("runs.csv", "packings.csv")] == whole
    assert capsys.readouterr().out.startswith("1 30 6 2 ")
    packings.main()
    assert capsys.readouterr().out == ""
