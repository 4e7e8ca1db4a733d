# SPDX-License-Identifier: BSD-3-Clause
"""The free energy of the face-centred cubic crystal of hard spheres by an Einstein crystal, and its limit for many particles.

Usage: free_energy.py [--cells 2 3 4] [--sweeps N] [--seed N], which writes free_energy.csv. It needs pypw85 on the path.

D. Frenkel and A. J. C. Ladd, New Monte Carlo method to compute the free energy of arbitrary solids, J. Chem. Phys. 81, 3188 (1984). In
units of kT, of the diameter σ, and with a thermal wavelength σ:

1. Springs Λ Σ |u_i - U|² hold all spheres at their sites, where u_i is the displacement of a sphere and U the mean of all. The crystal
   may be anywhere: the whole integral is V/N times that with the centre of mass fixed, δ(U), because a site of the lattice can be in N
   places for each numbering. Without the spheres' volumes, the Gaussian integral has 3 (N - 1) dimensions and the factor N^(3/2) of δ(U),
   so that

       A_0 = ln ρ + 3/2 (N - 1) ln(Λ/π) - 3/2 ln N.

2. The volumes of the spheres add A_1 = -ln P, where P is the probability that springs of this strength, alone, give no overlap. Here
   they are so strong that P is near 1, and samples of normal numbers find it.
3. As springs become weaker, the free energy falls by

       A_2 = ∫ <Σ |u_i - U|²> dΛ from 0 to the strongest.

   The average is by Monte Carlo: a translation is first accepted by the energy of the springs, and then by `try_placement`, which is exact.
   The integral over ln(Λ + c) has Gauss's points.

With A_id = ln(N!/V^N) of an ideal gas, the excess per particle is (A_0 + A_1 - A_2 - A_id)/N. Together with ln N / N it is linear in
1/N: J. M. Polson, E. Trizac, S. Pronk and D. Frenkel, Finite-size corrections to the free energies of crystalline solids, J. Chem. Phys.
112, 5339 (2000). They found 5.91889(4) in the limit at ρσ³ = 1.0409.
"""

from __future__ import annotations

import argparse
import csv
import math
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pypw85

TABLE = Path(__file__).with_name("free_energy.csv")
DENSITY = 1.0409
PUBLISHED, PUBLISHED_ERROR = 5.91889, 0.00004
BASIS = np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
STRONGEST = 2000.0
# The integrand is a smooth function of ln(Λ + c).
SHIFT, POINTS = math.exp(3.5), 12
NORMAL_SAMPLES = 4000


class Excess(NamedTuple):
    particles: int
    value: float
    error: float


def crystal(cells: int, density: float | None = None) -> pypw85.System:
    """Hard spheres of diameter 1 at the sites of the lattice."""
    edge = (4 / (density or DENSITY)) ** (1 / 3)
    corners = np.stack(np.meshgrid(*[np.arange(cells)] * 3, indexing="ij"), axis=-1).reshape(-1, 1, 3)
    sites = (corners + BASIS).reshape(-1, 3) * edge
    upright, axes = np.tile([1.0, 0, 0, 0], (len(sites), 1)), np.full((len(sites), 3), 0.5)
    return pypw85.System.from_axes(sites, axes, upright, cell=cells * edge * np.eye(3))


def free_probability(sites: pypw85.System, rng: np.random.Generator) -> tuple[float, float]:
    """How probable it is that springs of the strongest kind alone give no overlap, and the error."""
    # Spheres beyond the second shell would have to move by half a diameter: 22 standard deviations.
    found = pypw85.neighbors(sites.centers, np.tile([0.64, 0, 0, 0.64, 0, 0.64], (len(sites), 1)), sites.cell)
    first, second = found.pairs.T
    bonds = sites.centers[second] + found.images @ sites.cell - sites.centers[first]
    free = 0
    for _ in range(NORMAL_SAMPLES):
        moved = rng.normal(scale=math.sqrt(0.5 / STRONGEST), size=sites.centers.shape)
        free += bool((((bonds + moved[second] - moved[first]) ** 2).sum(axis=1) >= 1).all())
    part = free / NORMAL_SAMPLES
    return part, math.sqrt(part * (1 - part) / NORMAL_SAMPLES)


def change_of_squares(way: list[float], moved: list[float], mean: list[float], n: int) -> float:
    """By how much Σ |u|² - N |U|² changes, as one displacement u becomes u + way. Lists of three numbers are faster than arrays."""
    return sum(w * (2 * (u - m) + (1 - 1 / n) * w) for w, u, m in zip(way, moved, mean))


def squares(moved: list[list[float]]) -> float:
    """Σ |u - U|²."""
    displacements = np.asarray(moved)
    return float(((displacements - displacements.mean(axis=0)) ** 2).sum())


def mean_square(sites: pypw85.System, spring: float, sweeps: int, rng: np.random.Generator) -> tuple[float, float]:
    """<Σ |u_i - U|²> with springs, and its error."""
    simulation, n = pypw85.HardEllipsoids(sites, seed=1), len(sites)
    step = min(0.12, 1.2 / math.sqrt(spring))
    moved, mean, centers = [[0.0] * 3 for _ in range(n)], [0.0] * 3, sites.centers.tolist()
    averages = pypw85.Blocking()
    for sweep in range(sweeps + sweeps // 5):
        particles, ways = rng.integers(0, n, n), rng.uniform(-step, step, (n, 3))
        for i, way, number in zip(particles.tolist(), ways.tolist(), rng.uniform(size=n).tolist()):
            cost = spring * change_of_squares(way, moved[i], mean, n)
            if cost > 0 and number >= math.exp(-cost):
                continue
            new = [u + w for u, w in zip(moved[i], way)]
            if simulation.try_placement(i, [x + u for x, u in zip(centers[i], new)], take=True):
                moved[i], mean = new, [m + w / n for m, w in zip(mean, way)]
        if sweep >= sweeps // 5:
            averages.add([squares(moved)])
    found = averages.estimate()
    return float(found.value[0]), float(found.error[0])


def by_springs(
    n: int, density: float, free: tuple[float, float], mean_square: Callable[[float], tuple[float, float]], turning: float = 0.0
) -> tuple[float, float]:
    """The excess free energy per particle of an Einstein crystal whose springs are taken away, and its error.

    `free` is the probability that the strongest springs leave no overlap, with its error, `mean_square` gives the derivative of the free
    energy with respect to the springs, with its error, and `turning` is the logarithm of the part of orientations in the partition
    function with the strongest springs.
    """
    reference = math.log(density) + 1.5 * (n - 1) * math.log(STRONGEST / math.pi) - 1.5 * math.log(n) - turning
    probability, error = free
    variance = (error / probability) ** 2
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    low, high = math.log(SHIFT), math.log(STRONGEST + SHIFT)
    integral = 0.0
    for point, weight in zip(points, weights):
        shifted = math.exp(low + (point + 1) / 2 * (high - low))
        value, error = mean_square(shifted - SHIFT)
        factor = weight * (high - low) / 2 * shifted
        integral, variance = integral + factor * value, variance + (factor * error) ** 2
    ideal = math.lgamma(n + 1) - n * math.log(n / density)
    return (reference - math.log(probability) - integral - ideal) / n, math.sqrt(variance) / n


def excess(cells: int, sweeps: int, seed: int, density: float | None = None) -> Excess:
    """The excess free energy per particle."""
    density = density or DENSITY
    sites, rng = crystal(cells, density), np.random.default_rng(seed)
    free = free_probability(sites, rng)
    found, error = by_springs(len(sites), density, free, lambda spring: mean_square(sites, spring, sweeps, rng))
    return Excess(len(sites), found, error)


def limit(rows: list[Excess]) -> tuple[float, float]:
    """The value for infinitely many particles, by a straight line in 1/N, and its error."""
    n, values, errors = np.array(rows).T
    design = np.column_stack([np.ones_like(n), 1 / n]) / errors[:, None]
    covariance = np.linalg.inv(design.T @ design)
    found = covariance @ design.T @ ((values + np.log(n) / n) / errors)
    return float(found[0]), float(np.sqrt(covariance[0, 0]))


def read() -> list[Excess]:
    with TABLE.open(encoding="utf-8") as file:
        return [Excess(int(row["particles"]), float(row["excess"]), float(row["error"])) for row in csv.DictReader(file)]


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--cells", type=int, nargs="+", default=[2, 3, 4], help="along each edge, of four spheres each")
    parser.add_argument("--sweeps", type=int, default=3000, help="for each strength of the springs")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--table", type=Path, default=TABLE)
    given = parser.parse_args()
    rows = []
    for cells in given.cells:
        rows.append(excess(cells, given.sweeps, given.seed))
        print(f"N = {rows[-1].particles}: {rows[-1].value:.5f} ± {rows[-1].error:.5f}", flush=True)
        with given.table.open("w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["particles", "excess", "error"])
            table.writerows((row.particles, f"{row.value:.5f}", f"{row.error:.5f}") for row in rows)
    if len(rows) > 1:
        value, error = limit(rows)
        print(f"limit: {value:.4f} ± {error:.4f}; Polson and others: {PUBLISHED}")


if __name__ == "__main__":
    main()
