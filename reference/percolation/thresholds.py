#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Percolation thresholds of overlapping spheroids: makes percolation.csv and sizes.csv.

The command may be stopped at any time and goes on where it was, by the numbers in the folder. Each round adds realisations for all
shapes and cubes. The tables are those of the first rounds, even if the folder has more.
"""

import argparse
import csv
import math
import os
import re
import subprocess
from fractions import Fraction
from pathlib import Path

import numpy as np
from scipy.optimize import brentq
from scipy.special import gammainc

HERE = Path(__file__).resolve().parent
VERSION = re.search(r"version: '(\S+)'", (HERE.parent.parent / "meson.build").read_text(encoding="utf-8"))[1]
ROUNDS = 17
SEED = 1
# About so many particles are inserted for each shape and cube in a round. Long needles have the largest relative errors, and so more.
PARTICLES, PARTICLES_OF_NEEDLES = 400_000, 2_400_000
NEEDLE = 20  # the least aspect ratio of a long needle

# Edges of the cubes in units of the longest axis. Needles and plates need fewer, as they are longer than their distances.
CUBES = {
    (6, 9, 14): "1/3 1/2 3/4 1 4/3 3/2 2",
    (4, 6, 9): "1/100 1/50 1/20 1/10 1/5 3 4 5",
    (3, 4.5, 7): "10",
    (2.5, 3.5, 5.5): "20 30 50",
}
PLAN = sorted(
    ((Fraction(aspect), boxes) for boxes, aspects in CUBES.items() for aspect in aspects.split()),
)

# Universal values of critical percolation in three dimensions (Wang and others, Phys. Rev. E 87, 052107, 2013): the probabilities
# that a cluster wraps around a periodic cube along a given edge, or along any edge; 1/ν; and the exponents of corrections, the
# leading one and the one that these probabilities show.
WRAPPING = {"axis": 0.2578, "any": 0.45997}
INVERSE_NU = 1.141
CORRECTIONS = (1.2, 2.0)

# Volume fractions of Garboczi, Snyder, Douglas and Thorpe (Phys. Rev. E 52, 819, 1995), table 1.
GARBOCZI = {
    "1/100": 0.01248, "1/10": 0.1058, "1/5": 0.1757, "1/3": 0.2289, "1/2": 0.2629, "3/4": 0.2831, "1": 0.2854, "3/2": 0.2795,
    "2": 0.2618, "3": 0.2244, "4": 0.1901, "5": 0.1627, "10": 0.08703, "20": 0.04150, "30": 0.02646, "50": 0.01502,
}  # fmt: skip


def volumes(aspect, box):
    """How many spheroids have the volume of the cube."""
    side = 2 * box * max(1, aspect)
    return float(side**3 / aspect) / (4 / 3 * math.pi)


def block(aspect, box):
    """Realisations in a round."""
    particles = PARTICLES_OF_NEEDLES if aspect >= NEEDLE else PARTICLES
    return math.ceil(particles / (volumes(aspect, box) / (2 + max(aspect, 1 / aspect))))


def complete_lines(path):
    """How many realisations a file has. Removes what an interrupted process has left of a line."""
    if not path.exists():
        return 0
    data = path.read_bytes()
    whole = data[: data.rfind(b"\n") + 1]
    if len(whole) < len(data):
        path.write_bytes(whole)
    return whole.count(b"\n")


def extend(program, path, aspect, box, count):
    """Adds realisations until there are `count`."""
    first = complete_lines(path)
    if first < count:
        arguments = [repr(float(aspect)), repr(float(box)), str(SEED), str(first), str(count - first)]
        with path.open("ab") as file:
            subprocess.run([program, *arguments], stdout=file, check=True, env={**os.environ, "OMP_NUM_THREADS": "1"})


def threshold(numbers, probability):
    """The mean number of particles at which a share of the realisations wraps, and its standard error.

    The number of particles has a Poisson distribution, so P(n, m), the regularised incomplete gamma function, is the probability that
    a realisation which wraps with n particles does so at the mean number m. A row of `numbers` is a realisation.
    """

    def shares(mean):
        return gammainc(numbers, mean).mean(axis=1)

    mean = brentq(lambda m: shares(m).mean() - probability, numbers.min() / 2, 2 * numbers.max(), xtol=1e-9 * numbers.max())
    step = 1e-3 * mean
    slope = (shares(mean + step).mean() - shares(mean - step).mean()) / (2 * step)
    return mean, shares(mean).std(ddof=1) / math.sqrt(len(numbers)) / slope


def size_row(path, aspect, box, count):
    """A row of sizes.csv, from the first realisations of a file."""
    numbers = np.loadtxt(path, ndmin=2, max_rows=count)
    row = {"aspect": aspect, "box": box, "realizations": len(numbers)}
    for name, columns in (("axis", numbers), ("any", numbers.min(axis=1, keepdims=True))):
        mean, error = threshold(columns, WRAPPING[name])
        row[f"eta_{name}"] = mean / volumes(aspect, box)
        row[f"eta_{name}_error"] = error / volumes(aspect, box)
    row["particles"] = round(row["eta_axis"] * volumes(aspect, box))
    return row


def extrapolate(boxes, eta, error, correction):
    """The limit of eta = limit + amplitude · box^-(1/ν + correction), its standard error, and χ², by weighted least squares."""
    powers = np.asarray(boxes, float) ** -(INVERSE_NU + correction)
    matrix = np.column_stack([np.ones_like(powers), powers]) / np.asarray(error)[:, None]
    right = np.asarray(eta) / error
    (limit, amplitude), *_ = np.linalg.lstsq(matrix, right, rcond=None)
    covariance = np.linalg.inv(matrix.T @ matrix)
    return limit, math.sqrt(covariance[0, 0]), np.sum((matrix @ (limit, amplitude) - right) ** 2)


def limit_row(aspect, sizes):
    """A row of percolation.csv. The error has the difference between the exponents of the corrections, too."""
    boxes = [row["box"] for row in sizes]
    limits = {}
    for name in WRAPPING:
        eta, error = ([row[f"eta_{name}{what}"] for row in sizes] for what in ("", "_error"))
        first, second = (extrapolate(boxes, eta, error, correction) for correction in CORRECTIONS)
        limits[name] = (first[0] + second[0]) / 2, math.hypot(first[1], (first[0] - second[0]) / 2), first[2]
    eta, error, chi2 = limits["axis"]
    phi = -math.expm1(-eta)
    return {
        "aspect": aspect, "phi": phi, "phi_error": (1 - phi) * error, "eta": eta, "eta_error": error,
        "eta_any": limits["any"][0], "eta_any_error": limits["any"][1], "chi2": chi2, "garboczi": GARBOCZI.get(str(aspect), ""),
        "seed": SEED, "version": VERSION,
    }  # fmt: skip


def text(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def rounded(row, digits):
    """Cells as texts; numbers that have an error with so many digits of it."""
    out = {name: text(value) for name, value in row.items()}
    for name, value in row.items():
        error = f"{name}_error"
        if error in row:
            decimals = digits - 1 - math.floor(math.log10(row[error]))
            out[name], out[error] = f"{value:.{decimals}f}", f"{row[error]:.{decimals}f}"
    return out


def write(path, rows, digits):
    rows = [rounded(row, digits) for row in rows]
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def file_of(folder, aspect, box):
    return folder / f"{str(aspect).replace('/', '_')}-{box}.txt"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the built wrapping.cpp")
    parser.add_argument("folder", type=Path, help="for its numbers: one file for each shape and cube")
    parser.add_argument("rounds", nargs="?", type=int, default=ROUNDS)
    program, folder, rounds = vars(parser.parse_args()).values()
    folder.mkdir(parents=True, exist_ok=True)
    for k in range(1, rounds + 1):
        for aspect, boxes in PLAN:
            for box in boxes:
                extend(program, file_of(folder, aspect, box), aspect, box, k * block(aspect, box))
        print(f"round {k} of {rounds}", flush=True)
    sizes, limits = [], []
    for aspect, boxes in PLAN:
        own = [size_row(file_of(folder, aspect, box), aspect, box, rounds * block(aspect, box)) for box in boxes]
        limits.append(limit_row(aspect, own))
        sizes += own
    write(HERE / "sizes.csv", sizes, 4)
    write(HERE / "percolation.csv", limits, 2)


if __name__ == "__main__":
    main()
