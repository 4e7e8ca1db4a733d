# SPDX-License-Identifier: BSD-3-Clause
"""Random sequential addition, against brute force and known fractions. tests/test_random_addition.cpp tests what voxels cover."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pypw85

SHAPES = {"discs": [[1, 1]], "ellipses": [[2, 1]], "mixture": [[1, 2.5], [0.7, 0.7]], "balls": [[1, 1, 1]]}


def cell_of(axes, edge=14.0):
    """Skewed."""
    return edge * (np.eye(2) + [[0, 0], [0.3, 0]] if len(axes[0]) == 2 else np.eye(3) + [[0, 0, 0], [0.3, 0, 0], [0, -0.2, 0]])


def free_attempts(system, axes, count, rng):
    """How many of random attempts find room: against all images that may touch, by the functions of pairs."""
    dimensions, n = system.dimensions, len(system)
    places = rng.uniform(size=(count, dimensions)) @ system.cell[:dimensions, :dimensions]
    shifts = np.stack(np.meshgrid(*[[-1, 0, 1]] * dimensions, indexing="ij"), -1).reshape(-1, dimensions)
    shifts = shifts @ system.cell[:dimensions, :dimensions]
    if dimensions == 2:
        q = pypw85.ellipse(axes[0], axes[1], rng.uniform(0, np.pi, count))
        others, overlap = system.q[:, [0, 1, 3]], pypw85.overlap_2d
    else:
        q, others, overlap = np.tile(pypw85.spheroid(axes[0], axes[2], [0, 0, 1]), (count, 1)), system.q, pypw85.overlap
    taken = np.zeros(count, bool)
    for j in range(n):
        for shift in shifts:
            r = system.centers[j, :dimensions] + shift - places
            near = np.flatnonzero(~taken & (np.einsum("ij,ij->i", r, r) < (max(axes) + system.semi_axes[j].max()) ** 2))
            taken[near] = overlap(r[near], q[near], np.broadcast_to(others[j], (len(near), others.shape[1])))
    return int((~taken).sum())


@pytest.mark.parametrize("axes, exponents", [([[2, 1]], (-500, 490)), ([[1, 1, 2], [1, 1, 1]], (-340, 330))])
def test_same_in_any_unit(axes, exponents):
    """Powers of two as units change nothing but the size."""
    one = pypw85.random_addition(axes, cell_of(axes), attempts=20000, seed=2).system
    assert len(one) > 10
    for exponent in exponents:
        other = pypw85.random_addition(np.ldexp(axes, exponent), np.ldexp(cell_of(axes), exponent), attempts=20000, seed=2).system
        np.testing.assert_array_equal(other.centers, np.ldexp(one.centers, exponent))
        np.testing.assert_array_equal(other.quaternions, one.quaternions)


@pytest.mark.parametrize("name", SHAPES)
def test_saturated(name, rng):
    """There are no overlaps, and no attempt at random places finds room."""
    axes = SHAPES[name]
    found = pypw85.random_addition(axes, cell_of(axes), seed=3)
    system = found.system
    assert found.is_saturated and found.end == "saturated" and found.free_share < 1e-12
    assert system.dimensions == len(axes[0]) and len(system.overlaps().mu) == 0
    fractions = system.centers @ np.linalg.inv(system.cell)
    assert (fractions[:, : system.dimensions] >= 0).all() and (fractions[:, : system.dimensions] < 1 + 1e-15).all()
    np.testing.assert_array_equal(system.semi_axes[:, : system.dimensions], np.array(axes)[system.types - 1])
    for one in axes:
        assert free_attempts(system, one, 20000 if system.dimensions == 2 else 5000, rng) == 0
    # After all but a few are taken away, there is room: the oracle sees it.
    few = pypw85.random_addition(axes, cell_of(axes), number=4, seed=3)
    assert (few.end, len(few.system), few.is_saturated) == ("number", 4, False)
    assert free_attempts(few.system, axes[0], 1000, rng) > 100


def test_same_as_attempts_one_by_one(rng):
    """Voxels do not change the distribution: fractions of small cells, with attempts made one by one in Python."""
    edge, runs, attempts = 9.0, 30, 20000
    fractions = np.empty((2, runs))
    for k in range(runs):
        places = rng.uniform(0, edge, (attempts, 2))
        taken = np.zeros(attempts, bool)
        count = i = 0
        while i < attempts:
            difference = places[i:] - places[i]
            difference -= edge * np.round(difference / edge)
            taken[i:] |= (difference**2).sum(axis=1) < 4
            count += 1
            rest = np.flatnonzero(~taken[i:])
            i = i + int(rest[0]) if len(rest) else attempts
        fractions[:, k] = np.pi * count / edge**2, pypw85.random_addition([[1, 1]], edge * np.eye(2), seed=k).system.packing_fraction
    (slow, fast), errors = fractions.mean(axis=1), fractions.std(axis=1, ddof=1) / np.sqrt(runs)
    # At the time t = 20000 π/81 = 776, discs still lack some 0.1/√t = 0.004.
    assert -4 * np.hypot(*errors) < fast - slow < 0.004 + 4 * np.hypot(*errors)


@pytest.mark.parametrize("axes, expected", [([[1, 1]], 0.547), ([[2, 1]], 0.583), ([[1, 1, 1]], 0.384)])
def test_fractions(axes, expected):
    """Of saturation: those of the reference data, and of balls by Zhang and Torquato (2013). Fractions of cells with the volume of n
    particles spread by some 0.16/√n."""
    dimensions = len(axes[0])
    edge = 60.0 if dimensions == 2 else 22.0
    found = pypw85.random_addition(axes, edge * np.eye(dimensions), seed=5)
    n = edge**dimensions / (np.pi * axes[0][0] if dimensions == 2 else 4 / 3 * np.pi)
    assert abs(found.system.packing_fraction - expected) < 4 * 0.16 / np.sqrt(n)
    assert found.time == pytest.approx(found.attempts / n, rel=1e-12)


def test_seeds_and_threads():
    """The same packing on any number of threads, and another one with another seed."""
    program = ("import numpy as np, pypw85, hashlib; s = pypw85.random_addition([[2, 1], [1, 1]], 30 * np.eye(2), seed=7).system; "
               "print(hashlib.sha256(s.centers.tobytes() + s.quaternions.tobytes()).hexdigest())")  # fmt: skip
    results = {subprocess.run([sys.executable, "-c", program], env=os.environ | {"OMP_NUM_THREADS": str(number)}, check=True,
                              capture_output=True, text=True).stdout for number in (1, 2, 3)}  # fmt: skip
    assert len(results) == 1
    one, two = (pypw85.random_addition([[2, 1]], 30 * np.eye(2), seed=seed).system for seed in (1, 2))
    assert len(one) != len(two) or (one.centers != two.centers).any()


def test_limits():
    cell = 12 * np.eye(3)
    found = pypw85.random_addition([[1, 1, 2]], cell, attempts=50000)
    assert found.end == "attempts" and 50000 <= found.attempts < 50000 + 1 / found.free_share and 0 < found.free_share <= 1
    assert len(found.system.overlaps().mu) == 0
    found = pypw85.random_addition([[1, 1, 2]], cell, seconds=0.2)
    assert found.end == "seconds"
    found = pypw85.random_addition([[1, 1, 2]], cell, number=20, seconds=100)
    assert found.end == "number" and len(found.system) == 20


def test_interruption_keeps_what_was_added():
    def interrupt(text):
        if int(text.split()[0]) > 0:
            raise KeyboardInterrupt

    with pytest.raises(pypw85.AdditionInterrupted, match=r"\d+ ellipsoids were added") as caught:
        pypw85.random_addition([[1, 1, 2]], 12 * np.eye(3), seconds=100, stage=interrupt)
    assert isinstance(caught.value, KeyboardInterrupt)
    assert caught.value.result.end == "interrupted" and len(caught.value.result.system) > 0


def test_refused():
    for arguments, reason in (
        (([[1, 0]], np.eye(2)), r"must be finite and > 0, not .1.0, 0.0. of ellipsoid 0"),
        (([1, 1], np.eye(2)), r"rows of three numbers, not an array of the shape \(2,\)"),
        (([[1, 1]], 9 * np.eye(3)), "two vectors of finite numbers"),
        (([[1, 1]], [[9, 9], [9, 9]]), "lie in a line"),
        (([[1, 1]], 1.9 * np.eye(2)), "opposite sides of the cell must be at least 2, the longest diameter, apart, not 1.9"),
        (([[1, 1]], 9 * np.eye(2), 0), "number must be an integer from 1 to .*, not 0"),
        (([[1, 1]], 9 * np.eye(2), None, -1), "an integer from 0 to"),
        (([[1, 1]], 9 * np.eye(2), None, 0, np.nan), "attempts must be > 0, not nan"),
        (([[1, 1]], 9 * np.eye(2), None, 0, None, 0), "seconds must be > 0, not 0"),
        (([[1, 1, 2]], 9 * np.eye(3)), "pass number, attempts or seconds for other ellipsoids"),
    ):
        with pytest.raises(ValueError, match=reason):
            pypw85.random_addition(*arguments)


def test_command(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    plane = ["--dimensions", 2, "--axes", "2,1"]
    done = run("pack", "a.h5", "--rsa", *plane, "--cell", "20,20")
    assert done.status == 0
    particles, fraction = re.fullmatch(r"(\d+) particles, fraction (0\.\d+), .* attempts \(RSA time .*\), saturated: no other "
                                       r"particle fits at any position and orientation\n", done.out).groups()  # fmt: skip
    done = run("check", "a.h5")
    assert (done.status, done.out.splitlines()[3].split()[2:4]) == (0, [particles, f"{float(fraction):.6g}"])
    done = run("pack", "b.data", "--rsa", *plane, "-n", 100, "--fraction", 0.4)
    assert done.status == 0 and "100 particles, fraction 0.400000" in done.out and "all inserted" in done.out
    done = run("pack", "b.data", "--rsa", *plane, "-n", 100, "--fraction", 0.7)  # more than there is room for
    assert done.status == 1 and "saturated" in done.out
    voxels = ["--voxels", "c.vtk", "--resolution", 4]
    done = run("pack", "c.xyz", "--rsa", "--axes", "1,1,2", "--cell", "12,12,12", "--attempts", 5000, *voxels)
    assert done.status == 1 and "not saturated: ended by --attempts" in done.out
    done = run("pack", "d.xyz", *plane, "-n", 20, "--fraction", 0.6, "--cell", "2,1", "--spread", 0.1)
    assert done.status == 0
    for arguments, reason in (
        (["--rsa", *plane], "--rsa needs --cell, or -n and --fraction"),
        (["--rsa", *plane, "--cell", "20,20", "-n", 3], "with --rsa, -n also needs --fraction"),
        (["--rsa", *plane, "--cell", "20,20", "--spread", 0.1], "--spread has no effect with --rsa"),
        (["--rsa", *plane, "--cell", "20,20,20"], "--cell must have 2 or 4 numbers with --dimensions 2"),
        (["--rsa", "--axes", "1,2", "--cell", "20,20,20"], "--axes must have 3 numbers, not 2: add the third one, or --dimensions 2"),
        (["--rsa", *plane, "--cell", "20,20", "--voxels", "a.vtk"], "--voxels is not supported for ellipses"),
        (["--rsa", "--axes", "1,1,2", "--cell", "20,20,20"],
         "--rsa can prove saturation of ellipses and balls only, not of other ellipsoids: use --attempts, --seconds, or -n with"),
        ([*plane, "-n", 3], "a random packing needs -n and --fraction"),
        ([*plane, "-n", 3, "--fraction", 0.3, "--seconds", 3], "--seconds has no effect without --rsa"),
    ):
        done = run("pack", "e.xyz", *arguments)
        assert done.status == 2 and reason in done.err, arguments


@pytest.fixture(scope="module")
def program():
    """That of the reference data."""
    sys.path.insert(0, str(Path(os.environ["PYPW85_SOURCE"]) / "reference" / "random_addition"))
    import random_addition

    return random_addition


def test_reference_data(program):
    """The table follows from the runs. Discs saturate at 0.547, the maximum is near the aspect ratio 2, and long ellipses fill less."""
    runs, rows = (program.read(program.FOLDER / f"{name}.csv") for name in ("runs", "random_addition"))
    assert program.table(runs) == rows
    assert [row["aspect"] for row in rows] == list(program.ASPECTS) and all(int(row["runs"]) == program.SEEDS for row in rows)
    fractions, errors = ({row["aspect"]: float(row[name]) for row in rows} for name in ("fraction", "fraction_error"))
    assert abs(fractions["1"] - 0.547) < 0.0005 + 4 * errors["1"]
    assert abs(max(fractions.values()) - 0.583) < 0.0015 and max(fractions, key=fractions.get) in ("1.75", "2")
    assert fractions["1"] < fractions["1.25"] < fractions["1.5"] and fractions["2"] > fractions["2.5"] > fractions["3"] > fractions["4"]
    assert all(abs(float(row["particles"]) / program.AREAS - float(row["fraction"])) < 1e-8 for row in runs)


def test_reference_data_remade(program, tmp_path, monkeypatch, capsys):
    """In small cells, fractions are those of the table within 0.16/√n; runs that are there stay."""
    monkeypatch.setattr(program, "ASPECTS", ("1", "2"))
    monkeypatch.setattr(program, "SEEDS", 2)
    monkeypatch.setattr(program, "AREAS", 900)
    monkeypatch.setattr(sys, "argv", ["random_addition.py", str(tmp_path)])
    program.main()
    rows = {row["aspect"]: float(row["fraction"]) for row in program.read(tmp_path / "random_addition.csv")}
    whole = {row["aspect"]: float(row["fraction"]) for row in program.read(program.FOLDER / "random_addition.csv")}
    assert all(abs(rows[aspect] - whole[aspect]) < 4 * 0.16 / np.sqrt(2 * 900) for aspect in rows)
    capsys.readouterr()
    program.main()
    assert capsys.readouterr().out == ""
