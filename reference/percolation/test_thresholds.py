# SPDX-License-Identifier: BSD-3-Clause
"""Tests of wrapping.cpp, thresholds.py and spanning.py, and of the tables that they made. PW85_WRAPPING is the program."""

import csv
import math
import os
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import spanning  # noqa: E402
import thresholds  # noqa: E402

PROGRAM = os.environ["PW85_WRAPPING"]


def run(*arguments, **environment):
    command = [PROGRAM, *map(str, arguments)]
    environment = os.environ | {"OMP_NUM_THREADS": "1"} | environment
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def rows(name):
    with (HERE / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize("aspect, box, count", [("1/20", "4", 200), ("1", "6", 300), ("4", "4", 100)])
def test_small_systems(tmp_path, aspect, box, count):
    """Other random numbers than those of the table."""
    path = tmp_path / "numbers"
    path.write_text(run(float(Fraction(aspect)), box, 99, 0, count).stdout)
    row = thresholds.size_row(path, Fraction(aspect), Fraction(box), count)
    (table,) = (row for row in rows("sizes.csv") if (row["aspect"], row["box"]) == (aspect, box))
    for name in thresholds.WRAPPING:
        eta, error = row[f"eta_{name}"], math.hypot(row[f"eta_{name}_error"], float(table[f"eta_{name}_error"]))
        assert abs(eta - float(table[f"eta_{name}"])) < 4 * error


def test_same_bits():
    """The numbers are those of every machine."""
    assert run("0.2", "4", "1", "0", "3").stdout == "132 123 154\n103 129 126\n71 140 71\n"


def test_parts_and_threads():
    whole = run(3, 2, 5, 10, 6, OMP_NUM_THREADS="1").stdout
    assert run(3, 2, 5, 10, 2).stdout + run(3, 2, 5, 12, 4, OMP_NUM_THREADS="3").stdout == whole
    assert len(set(whole.splitlines())) == 6


@pytest.mark.parametrize(
    "arguments, word",
    [
        ((), "usage"),
        (("x", 4, 1, 0, 1), "usage"),
        ((1, 4, -1, 0, 1), "usage"),
        ((1, 4, 1, 0, "1e3"), "usage"),
        (("nan", 4, 1, 0, 1), "ASPECT"),
        ((0, 4, 1, 0, 1), "ASPECT"),
        (("inf", 4, 1, 0, 1), "ASPECT"),
        ((1, 0, 1, 0, 1), "BOX"),
        ((1, "nan", 1, 0, 1), "BOX"),
        ((1, 1e6, 1, 0, 1), "BOX"),
    ],
)
def test_bad_input(arguments, word):
    result = run(*arguments)
    assert (result.returncode, result.stdout) == (2, "")
    assert word in result.stderr


def test_full_disk():
    with open("/dev/full", "w") as full:
        assert subprocess.run([PROGRAM, "1", "3", "1", "0", "1"], stdout=full, check=False).returncode == 1


def test_interrupted_line(tmp_path):
    """What is left of a line is made anew, and the rest is kept."""
    path, whole = tmp_path / "numbers", run(1, 3, thresholds.SEED, 0, 5).stdout
    path.write_text(whole[: len(whole) // 2])
    thresholds.extend(PROGRAM, path, 1, 3, 5)
    assert path.read_text() == whole


def test_threshold():
    """If all realisations wrap with n particles, the share of those that wrap is the probability of Poisson's numbers from n on."""
    n = 50
    for probability in (0.2578, 0.9):
        mean, _ = thresholds.threshold(np.array([[n, n, n], [n, n, n]]), probability)
        below = sum(math.exp(k * math.log(mean) - mean - math.lgamma(k + 1)) for k in range(n))
        assert 1 - below == pytest.approx(probability, abs=1e-9)


def test_standard_error():
    """Against the scatter of independent samples, to five standard errors of its own."""
    rng = np.random.default_rng(1)
    samples = [thresholds.threshold(rng.integers(80, 120, size=(50, 3)), 0.5) for _ in range(100)]
    scatter = np.std([mean for mean, _ in samples], ddof=1)
    assert abs(scatter / np.mean([error for _, error in samples]) - 1) < 5 / math.sqrt(2 * 100)


def test_extrapolation():
    boxes, errors = np.array([4, 6, 9]), np.array([1e-3, 2e-3, 3e-3])
    eta = 0.3 + 0.5 * boxes ** -(thresholds.INVERSE_NU + 1.2)
    limit, error, chi2 = thresholds.extrapolate(boxes, eta, errors, 1.2)
    assert limit == pytest.approx(0.3, abs=1e-12) and chi2 < 1e-18 and error > 1e-3


def test_table():
    """The table follows from the sizes, up to rounding. All errors are within 0.1 %. Spheres have the known threshold (Torquato and
    Jiao, 2012)."""
    sizes = rows("sizes.csv")
    for row in rows("percolation.csv"):
        cubes = [size for size in sizes if size["aspect"] == row["aspect"]]
        own = [{name: float(x) for name, x in size.items() if name != "aspect"} for size in cubes]
        limit = thresholds.limit_row(Fraction(row["aspect"]), own)
        for name in ("phi", "eta", "eta_any"):
            error = float(row[f"{name}_error"])
            assert float(row[name]) == pytest.approx(limit[name], abs=error / 10)
            assert error == pytest.approx(limit[f"{name}_error"], rel=0.1)
        assert float(row["chi2"]) < 10.8  # exceeded once in 1000 cases
        assert float(row["phi_error"]) <= 1e-3 * float(row["phi"])
    spheres = next(row for row in rows("percolation.csv") if row["aspect"] == "1")
    assert abs(float(spheres["eta"]) - 0.341889) < 4 * float(spheres["eta_error"])
    assert abs(float(spheres["phi"]) - 0.289573) < 4 * float(spheres["phi_error"])


def test_independent_check():
    table = {row["aspect"]: row for row in rows("percolation.csv")}
    checks = rows("check.csv")
    assert [row["aspect"] for row in checks] == list(spanning.CHECKS)
    for row in checks:
        other = table[row["aspect"]]
        error = math.hypot(float(row["eta_error"]), float(other["eta_error"]))
        assert abs(float(row["eta"]) - float(other["eta"])) < 4 * error


def test_spanning():
    """A row of three spheres joins the faces; the others lead from one side of the cell to the other."""
    rows = [(2.5, 2.5, 0.5), (2.5, 2.5, 2.4), (0.2, 0.2, 2.4), (4.9, 0.2, 2.4), (2.5, 2.5, 4.3), (0.2, 0.2, 0.9)]
    q = np.array([[1.0, 0, 0, 1, 0, 1]] * len(rows))
    pairs = {tuple(sorted(pair)) for pair in spanning.bonds(np.array(rows), q, 5.0).tolist()}
    assert pairs == {(0, 1), (1, 4), (2, 3), (2, 5), (3, 5), (0, 6), (5, 6), (4, 7)}
    assert spanning.spanning_number(np.array(rows), q, 5.0) == 5
    assert spanning.spanning_number(np.array(rows[:4]), q[:4], 5.0) == 5  # not spanned


def test_crossing():
    """Two sizes whose numbers scatter about the same density, the larger one less."""
    rng = np.random.default_rng(1)
    systems = [(1000, rng.normal(300, 60, 2000)), (8000, rng.normal(2400, 150, 2000))]
    eta, error = spanning.crossing(systems)
    assert abs(eta - 0.3) < 4 * error < 0.02
