#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of virial coefficients of hard ellipsoids, virial.csv. docs/reference/virial.rst has the method.

Usage: table.py PROGRAM [--rounds N] [--shapes SHAPE...] [--table FILE], with PROGRAM built from virial.cpp.

The second coefficient is exact; the others are by Monte Carlo. Each round adds SAMPLES to each row that has fewer than N rounds, or to
each of some shapes, such as "prolate 20". Without N, each shape gets the rounds that it has in virial.csv, one to four (ROUNDS). The
file is written whenever there are new samples, and has all that is needed to continue: to stop loses nothing, and a file that was
continued is the same as one that was made at once.
"""

import argparse
import csv
import math
import os
import re
import subprocess
from pathlib import Path

import coefficients
from scipy.special import elliprg

ASPECTS = ("1.1", "1.25", "1.5", "2", "2.5", "3", "4", "5", "7.5", "10", "15", "20")
SHAPES = {
    "sphere": ("1", "1", "1"),
    **{f"prolate {aspect}": ("1", "1", aspect) for aspect in ASPECTS},
    **{f"oblate {aspect}": ("1", aspect, aspect) for aspect in ASPECTS},
    **{shape: tuple(shape.split(":")) for shape in ("1:1.25:1.5625", "1:1.5:2", "1:2:3", "1:2:4", "1:3:9")},
}
SAMPLES = dict(zip(coefficients.ORDERS, (1_000_000, 1_000_000, 1_500_000, 2_000_000)))  # more where the errors are larger
ROUNDS = dict.fromkeys(SHAPES, 1) | dict.fromkeys(("sphere", *(f"prolate {aspect}" for aspect in ASPECTS[:8])), 2)
ROUNDS |= dict.fromkeys((*(f"{kind} {aspect}" for kind in ("prolate", "oblate") for aspect in ASPECTS[8:]), "1:3:9"), 4)
COLUMNS = ["shape", "a", "b", "c", "alpha", "tau", "B2"]
COLUMNS += [f"B{order}{suffix}" for order in SAMPLES for suffix in ("", "_error", "_samples")] + ["seed", "version"]


def text(number):
    return f"{number:.10g}"


def mean_radius(axes):
    """The mean of √(nᵀQn), half the width along n, over all directions n: R, the integral of the mean curvature over 4π."""
    return float(elliprg(*(axis**2 for axis in axes)))


def surface(axes):
    """The projection along n has the area π √(det Q nᵀQ⁻¹n), and by Cauchy the surface is four times its mean over all n."""
    return 4 * math.pi * math.prod(axes) * mean_radius([1 / axis for axis in axes])


def shape_factors(axes):
    """α = RS/(3V) and τ = 4πR²/S, which are 1 for spheres."""
    radius, area, volume = mean_radius(axes), surface(axes), 4 / 3 * math.pi * math.prod(axes)
    return radius * area / (3 * volume), 4 * math.pi * radius**2 / area


def second_coefficient(axes):
    """B2 in units of the volume, 1 + 3α (A. Isihara 1950, for any convex body)."""
    return 1 + 3 * shape_factors(axes)[0]


def version():
    return re.search(r"version: '(.*?)'", (coefficients.PATH.parents[2] / "meson.build").read_text(encoding="utf-8"))[1]


def empty_row(shape, seed):
    axes = [float(axis) for axis in SHAPES[shape]]
    alpha, tau = shape_factors(axes)
    row = dict(zip("abc", SHAPES[shape]), shape=shape, alpha=text(alpha), tau=text(tau), B2=text(second_coefficient(axes)))
    samples = {f"B{order}_samples": "0" for order in SAMPLES}
    return dict.fromkeys(COLUMNS, "") | row | samples | {"seed": str(seed), "version": version()}


def read_table(path):
    """The rows of the table, empty ones for the shapes that it lacks. Their seeds are their numbers."""
    rows = {row.get("shape"): row for row in coefficients.rows(path)} if path.exists() else {}
    if any(set(row) != set(COLUMNS) for row in rows.values()):
        raise SystemExit(f"{path} is not a table of this program: its columns must be {', '.join(COLUMNS)}")
    return [rows.get(shape) or empty_row(shape, number) for number, shape in enumerate(SHAPES, 1)]


def write_table(path, rows):
    """A stop leaves the old file or the new one."""
    new = path.with_suffix(".new")
    with new.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(new, path)


def sample(program, row, order):
    """New samples: B_order in units of the volume, and its standard error. The B2 that was sampled beside it must be the exact one."""
    numbers = [order, SAMPLES[order], row["seed"], row[f"B{order}_samples"]]
    command = [program, row["a"], row["b"], row["c"], *map(str, numbers)]
    ratio, error, b2, b2_error = map(float, subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.split())
    exact = float(row["B2"])
    # The chance that a right program fails once in a million runs is below 1e-2. Spheres have no error, but rounding.
    if abs(b2 - exact) > 6 * b2_error + 1e-9 * exact:
        raise SystemExit(f"{row['shape']}: B2 is {exact}, but {b2} ± {b2_error} was sampled")
    return ratio * exact ** (order - 1), error * exact ** (order - 1)


def add(row, order, value, error):
    """Adds a sample of SAMPLES[order] to what the row has of this order."""
    new, old = SAMPLES[order], int(row[f"B{order}_samples"])
    if old:
        value = (old * float(row[f"B{order}"]) + new * value) / (old + new)
        error = math.hypot(old * float(row[f"B{order}_error"]), new * error) / (old + new)
    row |= {f"B{order}": text(value), f"B{order}_error": text(error), f"B{order}_samples": str(old + new)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--rounds", type=int, help="for each shape; those of virial.csv without")
    parser.add_argument("--shapes", nargs="+", choices=SHAPES, default=SHAPES, metavar="SHAPE", help="as in the table; all without")
    parser.add_argument("--table", type=Path, default=coefficients.PATH)
    arguments = parser.parse_args()
    if not os.access(arguments.program, os.X_OK):
        parser.error(f"{arguments.program} is not a program")
    rows = read_table(arguments.table)
    write_table(arguments.table, rows)  # before any work, in case that it cannot be written
    rounds = {shape: arguments.rounds or ROUNDS[shape] for shape in arguments.shapes}
    for number in range(max(rounds.values())):
        for row in (row for row in rows if rounds.get(row["shape"], 0) > number):
            for order, samples in SAMPLES.items():
                if int(row[f"B{order}_samples"]) <= number * samples:
                    add(row, order, *sample(arguments.program.resolve(), row, order))
                    row["version"] = version()
                    write_table(arguments.table, rows)


if __name__ == "__main__":
    main()
