#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An independent check of two thresholds: makes check.csv.

It needs pypw85 on the path.

It shares no code, no random numbers and no constant of the literature with thresholds.py. Spheroids are in a cube that is periodic
along x and y only; connected components of SciPy span it if they reach beyond both faces along z. The probability of spanning at the
threshold does not depend on the size of large cubes, so the curves of two sizes cross there.
"""

import argparse
import csv
import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pypw85
from scipy.optimize import brentq
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.special import gammainc

HERE = Path(__file__).resolve().parent


def bonds(centers, q, side):
    """The pairs that overlap, among them those with the two faces, which are the particles n and n + 1."""
    system = pypw85.System(centers, q, np.eye(3) * side, periodic=(True, True, False))
    listed = system.neighbors()
    overlap = pypw85.overlap_pairs(listed.pairs, system.centers, system.q, system.cell, images=listed.images) == 1
    z, half_width, n = centers[:, 2], np.sqrt(q[:, 5]), len(q)
    faces = [(np.flatnonzero(near), face) for near, face in ((z < half_width, n), (z > side - half_width, n + 1))]
    return np.concatenate([listed.pairs[overlap], *(np.column_stack([i, np.full_like(i, face)]) for i, face in faces)])


def spanning_number(centers, q, side):
    """With how many particles, inserted one by one, the cube is spanned; one more than there are if it is not."""
    most = len(q)
    pairs = bonds(centers, q, side)
    inserted = np.where(pairs[:, 1] >= most, pairs[:, 0], pairs.max(axis=1))

    def spans(number):
        i, j = pairs[inserted < number].T
        _, label = connected_components(coo_array((np.ones(len(i)), (i, j)), shape=(most + 2, most + 2)), directed=False)
        return label[most] == label[most + 1]

    low, high = 0, most + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if spans(middle) else (middle, high)
    return high


# By shape: the edges of two cubes in units of the longest axis, how many realisations of each, and a volume fraction far above the
# threshold, up to which spheroids are inserted. It has no influence on the result. Open faces shift the crossing: with cubes a quarter
# as large, it was below the threshold by 1.4 %, and with cubes half as large by 0.5 %.
CHECKS = {"1/10": ((24, 1000), (48, 250), 0.16), "4": ((16, 1000), (32, 250), 0.28)}
SEED = 2


def numbers_of(aspect, box, realizations, enough):
    """Particles per volume of a spheroid and of the cube, and the numbers at which realisations are spanned."""
    side = 2 * box * max(1, aspect)
    volumes = side**3 / (4 / 3 * math.pi * aspect)
    most = math.ceil(-math.log1p(-enough) * volumes)
    rng = np.random.default_rng([SEED, box, most])
    numbers = []
    for _ in range(realizations):
        centers = rng.uniform(0, side, size=(most, 3))
        q = pypw85.spheroid(1.0, aspect, rng.normal(size=(most, 3)))
        numbers.append(spanning_number(centers, q, side))
    return volumes, np.array(numbers)


def crossing(systems):
    """Where the probabilities of spanning of two sizes are the same, as n v, and its standard error.

    The number of particles is distributed as Poisson's, as in thresholds.py.
    """

    def shares(eta):
        return [gammainc(numbers, eta * volumes) for volumes, numbers in systems]

    def difference(eta):
        small, large = shares(eta)
        return large.mean() - small.mean()

    low, high = (np.quantile(systems[1][1], part) / systems[1][0] for part in (0.02, 0.98))
    eta = brentq(difference, low, high)
    slope = (difference(1.01 * eta) - difference(0.99 * eta)) / (0.02 * eta)
    variance = sum(share.var(ddof=1) / len(share) for share in shares(eta))
    return eta, math.sqrt(variance) / slope


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    rows = [["aspect", "box_small", "box_large", "realizations_small", "realizations_large", "eta", "eta_error"]]
    for aspect, (*cubes, enough) in CHECKS.items():
        eta, error = crossing([numbers_of(float(Fraction(aspect)), *cube, enough) for cube in cubes])
        (small, few), (large, many) = cubes
        rows.append([aspect, small, large, few, many, f"{eta:.5f}", f"{error:.5f}"])
    with (HERE / "check.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


if __name__ == "__main__":
    main()
