# SPDX-License-Identifier: BSD-3-Clause
"""Tests of virial.cpp and table.py, and of the table that they made. PW85_VIRIAL is the program."""

import hashlib
import csv
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pypw85
import pytest

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(__file__).resolve().parent))

import coefficients
import table

PROGRAM = os.environ["PW85_VIRIAL"]
AXES = {shape: [float(axis) for axis in axes] for shape, axes in table.SHAPES.items()}
# Of hard spheres, in units of the volume: B3 and B4 are known exactly; B5 and B6 are from N. Clisby and B. M. McCoy, Ninth and tenth order
# virial coefficients for hard spheres in D dimensions, Journal of Statistical Physics 122, 15 (2006), with errors below 1e-3.
SPHERES = {3: 10.0, 4: 18.36476838, 5: 28.224512, 6: 39.81514752}


def run(*arguments, **environment):
    command = [PROGRAM, *map(str, arguments)]
    return subprocess.run(command, env=os.environ | environment, capture_output=True, text=True, check=False)


def estimate(*arguments, **environment):
    """B_n / B2^(n-1), its error, B2 in units of the volume, its error."""
    return tuple(map(float, run(*arguments, **environment).stdout.split()))


def rows():
    return {row["shape"]: row for row in coefficients.rows()}


def mean_radius(axes):
    """Gauss's rule for cos θ and the trapezoidal rule for φ, about the axis that differs most from the others. With a = asinh(1/20) the
    function of cos θ is analytic inside of an ellipse with half-axes cosh(a) and sinh(a), so Gauss's error is of the order of e⁻⁶⁰⁰ᵃ; the
    function of φ is analytic up to atanh(1/3) from the real axis, and the other error is of the order of e⁻¹⁰⁰ᐟ³."""
    a, b, c = sorted(axes) if max(axes) * min(axes) >= np.median(axes) ** 2 else sorted(axes, reverse=True)
    z, weights = np.polynomial.legendre.leggauss(300)
    phi = np.pi * np.arange(100) / 50
    x2, y2, z2 = np.outer(1 - z**2, np.cos(phi) ** 2), np.outer(1 - z**2, np.sin(phi) ** 2), z[:, None] ** 2
    return weights @ np.sqrt(a**2 * x2 + b**2 * y2 + c**2 * z2).mean(axis=1) / 2


@pytest.mark.parametrize("shape", AXES)
def test_shape_factors(shape):
    axes = AXES[shape]
    volume, radius = 4 / 3 * np.pi * np.prod(axes), mean_radius(axes)
    area = 3 * volume * mean_radius([1 / axis for axis in axes])
    assert table.mean_radius(axes) == pytest.approx(radius, rel=1e-12)
    assert table.surface(axes) == pytest.approx(area, rel=1e-12)
    alpha, tau = table.shape_factors(axes)
    assert alpha == pytest.approx(radius * area / (3 * volume), rel=1e-12)
    assert tau == pytest.approx(4 * np.pi * radius**2 / area, rel=1e-12)


@pytest.mark.parametrize("aspect", [float(aspect) for aspect in table.ASPECTS])
def test_spheroids(aspect):
    """The closed forms, and B2 of prolate and oblate spheroids is the same."""
    root, angle = math.sqrt(aspect**2 - 1), math.acos(1 / aspect)
    prolate, oblate = (1, 1, aspect), (aspect, aspect, 1)
    assert table.mean_radius(prolate) == pytest.approx((aspect + math.acosh(aspect) / root) / 2, rel=1e-13)
    assert table.mean_radius(oblate) == pytest.approx((1 + aspect**2 / root * angle) / 2, rel=1e-13)
    assert table.surface(prolate) == pytest.approx(2 * math.pi * (1 + aspect**2 / root * angle), rel=1e-13)
    oblate_surface = 2 * math.pi * (aspect**2 + aspect / root * math.acosh(aspect))
    assert table.surface(oblate) == pytest.approx(oblate_surface, rel=1e-13)
    assert table.second_coefficient(prolate) == pytest.approx(table.second_coefficient(oblate), rel=1e-13)


@pytest.mark.parametrize("axes", [(1, 1, 2), (2, 2, 1), (1, 1, 1.1)])
def test_excluded_volume(axes):
    """2 B2 is the mean of the volume ∫ d³/3 from which a spheroid is excluded, with the distance d of closest approach in a direction. The
    quadrature is symmetric in three planes: cos θ and φ of the direction to a first axis along z, and the angle of the axes."""
    t, weights = np.polynomial.legendre.leggauss(48)
    half, half_weights = t[24:], weights[24:]
    phi = np.pi * (np.arange(64) + 0.5) / 32
    sine = np.sqrt(1 - t**2)
    d = np.stack([np.outer(sine, np.cos(phi)), np.outer(sine, np.sin(phi)), np.repeat(t[:, None], 64, 1)], axis=-1)
    axis = np.stack([np.sqrt(1 - half**2), 0 * half, half], axis=-1)
    first, second = pypw85.spheroid(axes[0], axes[2], [0.0, 0.0, 1.0]), pypw85.spheroid(axes[0], axes[2], axis)
    cubes = pypw85.closest_approach(d[None], first, second[:, None, None]) ** 3
    excluded = half_weights @ (cubes.mean(axis=2) @ weights) * 2 * np.pi / 3
    assert table.second_coefficient(axes) == pytest.approx(excluded / 2 / (4 / 3 * np.pi * np.prod(axes)), rel=1e-9)


@pytest.mark.parametrize("order", SPHERES)
def test_spheres(order):
    value, error, b2, _ = estimate(1, 1, 1, order, 100_000, 1)
    assert b2 == pytest.approx(4, rel=1e-14)
    exact = SPHERES[order] / 4 ** (order - 1)
    assert abs(value - exact) < 3 * error < 0.4 * exact
    row = rows()["sphere"]
    assert abs(float(row[f"B{order}"]) - SPHERES[order]) < 3 * float(row[f"B{order}_error"])


@pytest.mark.parametrize("shape", ["prolate 10", "oblate 10", "1:2:4"])
@pytest.mark.parametrize("order", table.SAMPLES)
def test_table_again(shape, order):
    """Other random numbers than those of the table give the same coefficients."""
    row = rows()[shape]
    value, error, b2, b2_error = estimate(row["a"], row["b"], row["c"], order, 20_000, 1000)
    exact = float(row["B2"])
    assert abs(b2 - exact) < 4 * b2_error
    difference = value * exact ** (order - 1) - float(row[f"B{order}"])
    assert abs(difference) < 4 * math.hypot(error * exact ** (order - 1), float(row[f"B{order}_error"]))


def test_rows():
    """The exact columns, and there are samples and errors."""
    assert list(rows()) == list(table.SHAPES)
    for shape, row in rows().items():
        assert (row["a"], row["b"], row["c"]) == table.SHAPES[shape]
        alpha, tau = table.shape_factors(AXES[shape])
        expected = [table.text(number) for number in (alpha, tau, table.second_coefficient(AXES[shape]))]
        assert [row["alpha"], row["tau"], row["B2"]] == expected
        for order, samples in table.SAMPLES.items():
            assert int(row[f"B{order}_samples"]) == table.ROUNDS[shape] * samples and float(row[f"B{order}_error"]) > 0


@pytest.mark.parametrize("shape", ["oblate 1.1", "prolate 2"])
def test_remade(tmp_path, monkeypatch, shape):
    """Without a number of rounds, the program makes the table that is there, to the last digit, also with later versions of the library:
    B3 of two shapes, of one and two rounds."""
    monkeypatch.setattr(table, "SAMPLES", {3: table.SAMPLES[3]})
    make_table(tmp_path / "table.csv", rounds=None, shapes=[shape])
    (row,) = (row for row in csv.DictReader((tmp_path / "table.csv").open()) if row["shape"] == shape)
    names = ["seed", "B2", "B3", "B3_error", "B3_samples"]
    assert [row[name] for name in names] == [rows()[shape][name] for name in names]


def test_errors():
    """The values and B2 of independent runs scatter by their errors. The standard deviation of 64 values has a relative error of 1/√126."""
    runs = np.array([estimate(1, 1, 2, 3, 1000, 9, 1000 * k, OMP_NUM_THREADS="1") for k in range(64)])
    for values, errors in (runs[:, :2].T, runs[:, 2:].T):
        assert np.std(values, ddof=1) == pytest.approx(errors.mean(), rel=4 / math.sqrt(126))


def test_units_and_order():
    """Powers of two as units change no bit; the order of the axes matters for the bits alone."""
    first = run(1, 2, 4, 5, 2000, 3).stdout
    assert run(0.125, 0.25, 0.5, 5, 2000, 3).stdout == first
    assert run(64, 128, 256, 5, 2000, 3).stdout == first
    value, error, *_ = estimate(1, 2, 4, 4, 50_000, 3)
    other, other_error, *_ = estimate(4, 1, 2, 4, 50_000, 3)
    assert value != other and abs(value - other) < 4 * math.hypot(error, other_error)


def test_threads_and_parts():
    """The same bits for any number of threads; the samples of two parts are those of the whole."""
    whole = run(1, 1, 3, 6, 20_000, 5, OMP_NUM_THREADS="1").stdout
    assert run(1, 1, 3, 6, 20_000, 5, OMP_NUM_THREADS="3").stdout == whole
    parts = [estimate(1, 1, 3, 6, samples, 5, first)[0] for samples, first in ((5000, 0), (15_000, 5000))]
    assert (parts[0] + 3 * parts[1]) / 4 == pytest.approx(float(whole.split()[0]), rel=1e-13)


def test_bits():
    """The same on every machine."""
    expected = "0.081119222655177584 0.0085466737622300632 4.401602183194683 0.0076136128766768688\n"
    assert run(1, 1.5, 2, 5, 10_000, 11).stdout == expected


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((1, 1, 1, 3), "usage"),
        ((1, 1, 1, 3, 10, 1, 0, 0), "usage"),
        ((1, "x", 1, 3, 10, 1), "B is not a valid number: x"),
        (("nan", 1, 1, 3, 10, 1), "semi-axes"),
        ((1, 1, -1, 3, 10, 1), "semi-axes"),
        ((1, 1, "1e400", 3, 10, 1), "semi-axes"),
        ((1, 1, 1001, 3, 10, 1), "semi-axes"),
        ((1, 1, 1, 7, 10, 1), "ORDER"),
        ((1, 1, 1, 1, 10, 1), "ORDER"),
        ((1, 1, 1, "3.5", 10, 1), "ORDER"),
        ((1, 1, 1, 3, 1, 1), "SAMPLES"),
        ((1, 1, 1, 3, -5, 1), "SAMPLES"),
        ((1, 1, 1, 3, 10, -1), "SEED"),
        ((1, 1, 1, 3, 10, 1, "1e3"), "FIRST"),
    ],
)
def test_bad_input(arguments, words):
    done = run(*arguments)
    assert done.returncode == 2 and done.stdout == "" and words in done.stderr


def make_table(path, program=PROGRAM, rounds=1, shapes=()):
    options = [*(["--rounds", str(rounds)] if rounds else []), "--table", str(path), *(["--shapes", *shapes] if shapes else [])]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["table.py", str(program), *options])
        table.main()


def test_continued_table(tmp_path, monkeypatch):
    """A table that was continued is the table that was made at once."""
    monkeypatch.setattr(table, "SHAPES", {"prolate 2": ("1", "1", "2"), "1:2:4": ("1", "2", "4")})
    monkeypatch.setattr(table, "SAMPLES", {3: 2000, 4: 3000})
    paths = tmp_path / "at_once.csv", tmp_path / "continued.csv"
    make_table(paths[0], rounds=2)
    make_table(paths[1], rounds=1)
    lines = paths[1].read_text().splitlines(keepends=True)
    paths[1].write_text("".join(lines[:2]))  # as if it had been stopped in the first round
    make_table(paths[1], rounds=2, shapes=["1:2:4"])
    first, second = table.read_table(paths[1])
    assert first["B3_samples"] == "2000" and second["B3_samples"] == "4000", "only the shapes that were asked for"
    make_table(paths[1], rounds=2)
    assert paths[0].read_text() == paths[1].read_text()
    row = table.read_table(paths[0])[1]
    value, error, *_ = estimate(1, 2, 4, 4, 6000, row["seed"])
    scale = float(row["B2"]) ** 3
    assert float(row["B4"]) == pytest.approx(value * scale, rel=1e-8)
    assert float(row["B4_error"]) == pytest.approx(error * scale, rel=0.01)


def test_wrong_program(tmp_path):
    """A program that samples another B2 is refused."""
    program = tmp_path / "wrong"
    program.write_text("#!/bin/sh\necho 0.625 0.001 4.4 0.01\n")
    program.chmod(0o755)
    with pytest.raises(SystemExit, match=r"sphere: B2 is 4\.0, but 4\.4"):
        make_table(tmp_path / "table.csv", program)


def test_bad_files(tmp_path, capsys):
    """There is an error before any work, and nothing is lost."""
    with pytest.raises(SystemExit):
        make_table(tmp_path / "table.csv", tmp_path / "absent")
    assert "absent is not a program" in capsys.readouterr().err
    other = tmp_path / "other.csv"
    other.write_text("a,b\n1,2\n")
    with pytest.raises(SystemExit, match="is not a table of this program"):
        make_table(other)
    assert other.read_text() == "a,b\n1,2\n"
    with pytest.raises(OSError, match="absent"):
        make_table(tmp_path / "absent" / "table.csv")


def test_fits():
    """Each fit is that of spheres where there are no others, and is near the table for moderate shapes. A digit lost would not be."""
    sphere = {"alpha": "1", "tau": "1"}
    for order in coefficients.FITS:
        assert coefficients.fit(sphere, order) == pytest.approx(SPHERES[order], abs=1e-4)
        for shape, row in rows().items():
            if max(AXES[shape]) / min(AXES[shape]) <= 2:
                value, error = float(row[f"B{order}"]), float(row[f"B{order}_error"])
                assert abs(coefficients.fit(row, order) - value) < 0.01 * value + 4 * error


def test_event_chains():
    """The pressure of event chains at φ = 0.1, by the mean and the standard error of 45 runs, is that of the series. The next term of the
    series is some 1e-4."""
    row, fraction = rows()["prolate 3"], 0.1
    places = np.stack(np.meshgrid(np.arange(9), np.arange(9), 3 * np.arange(3), indexing="ij"), axis=-1).reshape(-1, 3)
    semi_axes, n = np.array([0.5, 0.5, 1.5]), len(places)
    spacing = (4 / 3 * np.pi * np.prod(semi_axes) * n / fraction) ** (1 / 3) / 9
    start = pypw85.System.from_axes(
        spacing * places, np.tile(semi_axes, (n, 1)), np.tile([1, 0, 0, 0], (n, 1)), cell=9 * spacing * np.eye(3)
    )
    simulation = pypw85.HardEllipsoids(start, seed=1)
    simulation.tune(100, acceptance=0.4)
    simulation.sweep(300)  # the start is a crystal of parallel ellipsoids

    def run_of_chains():
        pressures = []
        for _ in range(5):
            simulation.sweep()
            pressures.append(simulation.chain(20, length=5.0))
        return np.mean(pressures)

    pressures = [run_of_chains() for _ in range(45)]
    series = 1 + sum(float(row[f"B{order}"]) * fraction ** (order - 1) for order in (2, *coefficients.ORDERS))
    error = np.std(pressures, ddof=1) / math.sqrt(len(pressures))
    assert error < 0.01
    assert abs(np.mean(pressures) - series) < 4 * error


def test_picture():
    """The picture of the manual shows the table."""
    picture = coefficients.PATH.parents[2] / "docs" / "pictures" / "virial.svg"
    assert hashlib.sha256(coefficients.PATH.read_bytes()).hexdigest() in picture.read_text(encoding="utf-8")
