# SPDX-License-Identifier: BSD-3-Clause
"""Random sequential addition, against brute force and known fractions."""

import itertools
import os
import re
import subprocess
import sys
from decimal import Decimal, localcontext
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import pypw85
from pypw85 import _core

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


def test_ellipse_inside_turned_ones(rng):
    """What stands for all angles of a voxel: nowhere wider than an ellipse that is turned by up to the angle, and close to it for small
    angles. Half-widths along t are √(m + d cos 2(t - φ))."""
    t = np.linspace(0, np.pi, 721)
    for b, ratio, angle in zip(rng.uniform(0.1, 2, 200), 2 ** rng.uniform(0, 5, 200), 2.0 ** rng.uniform(-12, 1, 200)):
        a = b * ratio
        axes = _core.inside_turned_ellipses(a, b, angle)
        inner = (axes[0] * np.cos(t)) ** 2 + (axes[1] * np.sin(t)) ** 2
        for phi in np.linspace(-1, 1, 41) * min(angle, np.pi / 2):
            assert (inner <= ((a * np.cos(t - phi)) ** 2 + (b * np.sin(t - phi)) ** 2) * (1 + 1e-12)).all()
        assert axes[0] >= axes[1] > 0 and axes[0] * axes[1] >= b * b * (1 - 1e-15)
        # The loss is of the first order in the angle, with a factor of the order of the ratio squared.
        assert axes[0] * axes[1] >= a * b * (1 - 4 * ratio**2 * angle)


PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")


def cosine_sine(angle):
    """To 60 digits, by their series, and by halving the angle until it is small."""
    with localcontext() as context:
        context.prec = 80
        x = angle / 1024
        c, s, term = Decimal(0), Decimal(0), Decimal(1)
        for k in itertools.count(1):
            c, s = (c + term, s) if k % 2 else (c, s + term)
            if abs(term) < Decimal("1e-75"):
                break
            term = term * x / k * (1 if k % 2 else -1)
        for _ in range(10):
            c, s = c * c - s * s, 2 * c * s
        return Fraction(c), Fraction(s)


def is_inside(inner, outer):
    """Whether an ellipse about the same centre is inside another one: the difference of the forms is not negative."""
    xx, xy, yy = (Fraction(y) - Fraction(x) for x, y in zip(inner, outer))
    return xx + yy >= 0 and xx * yy >= xy * xy


@pytest.mark.parametrize("aspect", [1, 2.5, 30, 1e3, 1e4, 1e5, 1e6])
def test_form_of_a_voxel_is_inside_all_that_is_drawn(aspect, rng):
    """Exactly, with the forms as doubles: inside all true ellipses, and inside those that the library makes of what is drawn. Voxels of
    angles are so narrow that rounding matters, and the widths of these are of all sizes."""
    for k in range(60):
        b = float(np.ldexp(rng.uniform(1, 2), int(rng.integers(-40, 41))))
        a, angles = b * aspect, 2 ** int(rng.integers(1, 51))
        index = int(rng.integers(0, angles)) if k % 2 else (0, angles // 4, angles // 2, 3 * angles // 4, angles - 1)[k // 2 % 5]
        found = _core.form_of_voxel(a, b, 2 * a, index, angles)
        for turns in (Fraction(index, angles), Fraction(2 * index + 1, 2 * angles), Fraction(index + 1, angles)):
            c, s = cosine_sine(PI * turns.numerator / turns.denominator)
            long, short = Fraction(a) ** 2, Fraction(b) ** 2
            true = (long * c * c + short * s * s, (long - short) * c * s, long * s * s + short * c * c)
            assert is_inside(found, true), (a.hex(), b.hex(), index, angles, turns)
        for u in (index / angles, (index + 0.5) / angles, np.nextafter((index + 1) / angles, 0)):
            drawn = pypw85.ellipsoid_quaternion([a, b, b], [np.cos(np.pi / 2 * u), 0, 0, np.sin(np.pi / 2 * u)])
            assert is_inside(found, drawn[[0, 1, 3]].tolist()), (a.hex(), b.hex(), index, angles, u)


@pytest.mark.parametrize("aspect", [1, 30, 1e3, 1e5, 1e6])
def test_ball_inside_all_that_is_drawn(aspect, rng):
    """Exactly, for the forms as doubles: Q - s I is positive semidefinite for the square s of the radius. Rounding makes the shortest
    semi-axis of slender forms smaller. The ball is smaller by no more than 2⁻⁴⁶ of the square of the aspect ratio."""
    for turns in rng.normal(size=(200, 4)):
        b = float(np.ldexp(rng.uniform(1, 2), int(rng.integers(-40, 41))))
        axes = rng.permutation([b * aspect, b, b * aspect ** rng.uniform()])
        radius = _core.radius_inside_body(axes.max(), axes.min())
        q = [Fraction(x) for x in pypw85.ellipsoid_quaternion(axes, turns / np.linalg.norm(turns)).tolist()]
        xx, yy, zz = (q[k] - Fraction(radius) ** 2 for k in (0, 3, 5))
        xy, xz, yz = q[1], q[2], q[4]
        minors = yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy
        determinant = xx * minors[0] + xy * (xz * yz - xy * zz) + xz * (xy * yz - xz * yy)
        assert xx + yy + zz >= 0 and sum(minors) >= 0 and determinant >= 0, (axes.tolist(), turns.tolist())
        assert radius**2 >= b**2 * (1 - 2.0**-45 * aspect**2)


@pytest.mark.parametrize("axes, exponents", [([[2, 1]], (-500, 490)), ([[1, 1, 2], [1, 1, 1]], (-340, 330))])
def test_same_in_any_unit(axes, exponents):
    """Powers of two as units change nothing but the size."""
    one = pypw85.random_addition(axes, cell_of(axes), attempts=20000, seed=2).system
    assert len(one) > 10
    for exponent in exponents:
        other = pypw85.random_addition(np.ldexp(axes, exponent), np.ldexp(cell_of(axes), exponent), attempts=20000, seed=2).system
        np.testing.assert_array_equal(other.centers, np.ldexp(one.centers, exponent))
        np.testing.assert_array_equal(other.quaternions, one.quaternions)


def test_form_of_a_voxel_bears_moved_places(rng):
    """A half-width h that is left is so much smaller than that of the ellipse that places may be wrong by some roundings of the cell."""
    for aspect, edges in itertools.product([1, 7, 1e3, 1e5], [2, 50, 1e3]):
        b = float(np.ldexp(rng.uniform(1, 2), int(rng.integers(-40, 41))))
        a, length = b * aspect, b * aspect * edges
        with localcontext() as context:
            context.prec = 50
            moved = 27 * Decimal(length) * Decimal(2).sqrt() / 2**53
            xx, xy, yy = (Decimal(x) for x in _core.form_of_voxel(a, b, length, 0, 2**50))
            for turn in [0, 1, *(Decimal(float(x)) for x in 2 ** rng.uniform(-40, 0, 40))]:
                c, s = Decimal(turn), (1 - Decimal(turn) ** 2).sqrt()
                h = (xx * c * c + 2 * xy * c * s + yy * s * s).sqrt()
                whole = ((Decimal(a) * c) ** 2 + (Decimal(b) * s) ** 2).sqrt()
                assert h + moved <= whole, (a.hex(), b.hex(), length.hex(), c)


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
    particles, fraction = re.fullmatch(r"(\d+) particles, fraction (0\.\d+), .* attempts \(RSA time .*\), saturated: no place and no "
                                       r"orientation is left for another one\n", done.out).groups()  # fmt: skip
    done = run("check", "a.h5")
    assert (done.status, done.out.splitlines()[3].split()[2:4]) == (0, [particles, f"{float(fraction):.6g}"])
    done = run("pack", "b.data", "--rsa", *plane, "-n", 100, "--fraction", 0.4)
    assert done.status == 0 and "100 particles, fraction 0.400000" in done.out and "all placed" in done.out
    done = run("pack", "b.data", "--rsa", *plane, "-n", 100, "--fraction", 0.7)  # more than there is room for
    assert done.status == 1 and "saturated" in done.out
    voxels = ["--voxels", "c.vtk", "--resolution", 4]
    done = run("pack", "c.xyz", "--rsa", "--axes", "1,1,2", "--cell", "12,12,12", "--attempts", 5000, *voxels)
    assert done.status == 1 and "not saturated: ended by --attempts" in done.out
    done = run("pack", "d.xyz", *plane, "-n", 20, "--fraction", 0.6, "--cell", "2,1", "--spread", 0.1)
    assert done.status == 0
    for arguments, reason in (
        (["--rsa", *plane], "--rsa fills a cell"),
        (["--rsa", *plane, "--cell", "20,20", "-n", 3], "--rsa fills a cell"),
        (["--rsa", *plane, "--cell", "20,20", "--spread", 0.1], "--spread has no effect with --rsa"),
        (["--rsa", *plane, "--cell", "20,20,20"], "--cell must have 2 or 4 numbers with --dimensions 2"),
        (["--rsa", "--axes", "1,2", "--cell", "20,20,20"], "--axes must have 3 numbers with --dimensions 3"),
        (["--rsa", *plane, "--cell", "20,20", "--voxels", "a.vtk"], "leave out --voxels for ellipses"),
        (["--rsa", "--axes", "1,1,2", "--cell", "20,20,20"],
         "--rsa can prove saturation of ellipses and balls only, not of other ellipsoids: use --attempts, --seconds, or -n with"),
        ([*plane, "-n", 3], "give -n and --fraction"),
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
