# SPDX-License-Identifier: BSD-3-Clause
"""The free energy of a crystal of hard spheroids that turn, by an Einstein crystal with orientations, and by another way.

Usage: orientations.py [--cells 2 3] [--sweeps N] [--seed N], which writes orientations.csv. It needs pypw85 on the path.

The crystal is that of hard spheres (free_energy.py), stretched along z by the aspect ratio of the spheroids, at constant volume. If all
axes were along z, a linear map would make it the crystal of spheres, with the same free energy. Two ways lead to spheroids that turn:

1. The Einstein crystal. Springs hold centres and axes, with the energy

       Λ (Σ |u_i - U|² + R Σ sin²θ_i).

   u_i is the displacement of centre i, stretched back to the crystal of spheres, U the mean of all, and θ_i the angle between the axis
   and z. The axes have an integral of their own: relative to axes that are free, each has

       z(κ) = ∫ exp(-κ sin²θ) d cosθ from 0 to 1, with κ = R Λ,

   so that A_0 is that of spheres less N ln z. A_1 and A_2 are as for spheres, with the energy of both springs.

2. From spheres, with an aligning field alone, which the sweeps of the library know. In a field κ sin²θ the free energy is that of axes
   without volume, plus G(κ). G is that of hard spheres for infinite κ, where all axes are along z. So without a field

       G(0) = G(∞) - ∫ (<Σ sin²θ> - N <sin²θ> of axes without volume) dκ from 0 to ∞,

   by Gauss's points in κ/(κ + K). The integrand falls as 1/κ².

Both are the excess over an ideal gas whose axes are free, per particle. They share the overlap test only.
"""

from __future__ import annotations

import argparse
import csv
import math
from pathlib import Path
from typing import NamedTuple

import free_energy
import numpy as np

import pypw85

TABLE = Path(__file__).with_name("orientations.csv")
# Where the axes stay near z without a field. At the density of free_energy.csv they turn from one direction to another now and then.
ASPECT, DENSITY = 1.5, 1.2
STRETCH = np.array([ASPECT ** (-1 / 3), ASPECT ** (-1 / 3), ASPECT ** (2 / 3)])
# R, by which axes and centres of the strongest springs meet others about as often
RATIO = 0.5
# Where the integrand of the second way has fallen to a tenth or so
MIDDLE, FIELD_POINTS = 30.0, 10


class Excess(NamedTuple):
    particles: int
    einstein: float
    einstein_error: float
    field: float
    field_error: float
    spheres: float
    spheres_error: float


def crystal(cells: int) -> pypw85.System:
    """Spheroids along z at the sites of the stretched lattice."""
    spheres = free_energy.crystal(cells, DENSITY)
    turns, cell = np.tile([1.0, 0, 0, 0], (len(spheres), 1)), spheres.cell * STRETCH
    return pypw85.System.from_axes(spheres.centers * STRETCH, np.tile(0.5 * STRETCH, (len(spheres), 1)), turns, cell=cell)


def axis_moments(spring: float) -> tuple[float, float]:
    """z(κ), and <sin²θ> of an axis without volume."""
    points, weights = np.polynomial.legendre.leggauss(60)
    end = min(1.0, 40 / spring) if spring > 0 else 1.0  # of 1 - cosθ: the rest is less than e⁻⁴⁰ of the whole
    x = end * (points + 1) / 2
    squares = x * (2 - x)
    density = weights * end / 2 * np.exp(-spring * squares)
    return float(density.sum()), float(density @ squares / density.sum())


def draw_axes(spring: float, count: int, rng: np.random.Generator) -> np.ndarray:
    """Quaternions of spheroids whose axes have the density exp(-κ sin²θ)."""
    found = np.empty(0)
    while len(found) < count:  # by rejection from exp(-κ x), with x = 1 - cosθ
        x = rng.exponential(1 / spring, 2 * count)
        found = np.append(found, x[(x <= 1) & (rng.uniform(size=len(x)) < np.exp(-spring * x * (1 - x)))])
    half, angle = np.arccos(1 - found[:count]) / 2, rng.uniform(0, 2 * math.pi, count)
    return np.stack([np.cos(half), np.sin(half) * np.cos(angle), np.sin(half) * np.sin(angle), 0 * half], axis=1)


def free_probability(sites: pypw85.System, rng: np.random.Generator) -> tuple[float, float]:
    """How probable it is that springs of the strongest kind alone give no overlap, and the error."""
    n, samples, spring = len(sites), free_energy.NORMAL_SAMPLES, free_energy.STRONGEST
    found = pypw85.neighbors(sites.centers, np.tile(0.64 * np.array([1, 0, 0, 1, 0, 1]) * ASPECT**2, (n, 1)), sites.cell)
    first, second = found.pairs.T
    bonds = sites.centers[second] + found.images @ sites.cell - sites.centers[first]
    free = 0
    for _ in range(samples):
        moved = rng.normal(scale=math.sqrt(0.5 / spring), size=(n, 3)) * STRETCH
        q = pypw85.ellipsoid_quaternion(0.5 * STRETCH, draw_axes(RATIO * spring, n, rng))
        free += not pypw85.overlap(bonds + moved[second] - moved[first], q[first], q[second]).any()
    part = free / samples
    return part, math.sqrt(part * (1 - part) / samples)


def rotated(way: list[float], turn: list[float]) -> list[float]:
    """The quaternion (1, way), of length one, times another one."""
    a, b, c = way
    w, x, y, z = turn
    product = [w - a * x - b * y - c * z, x + a * w + b * z - c * y, y + b * w + c * x - a * z, z + c * w + a * y - b * x]
    length = math.hypot(*product)
    return [number / length for number in product]


def squared_sine(turn: list[float]) -> float:
    """sin²θ of the axis of a spheroid with this quaternion."""
    w, x, y, z = turn
    return 4 * ((x * z + w * y) ** 2 + (y * z - w * x) ** 2)


class EinsteinCrystal:
    """Spheroids with springs that hold their centres and axes."""

    def __init__(self, sites: pypw85.System, spring: float, rng: np.random.Generator) -> None:
        self.sites, self.spring, self.rng, self.n = sites, spring, rng, len(sites)
        self.simulation = pypw85.HardEllipsoids(sites, seed=1)
        self.centers, self.stretch = sites.centers.tolist(), STRETCH.tolist()
        self.moved, self.mean = [[0.0] * 3 for _ in range(self.n)], [0.0] * 3
        self.turns, self.sines = [[1.0, 0, 0, 0] for _ in range(self.n)], np.zeros(self.n)

    def sweep(self) -> None:
        """As many trials as there are spheroids, of translations and of rotations."""
        step = min(0.12, 1.2 / math.sqrt(self.spring))
        turn = min(0.3, 0.8 / math.sqrt(RATIO * self.spring))
        particles, numbers = self.rng.integers(0, self.n, (2, self.n)).tolist(), self.rng.uniform(size=(2, self.n)).tolist()
        ways, turns = self.rng.uniform(-step, step, (self.n, 3)).tolist(), self.rng.uniform(-turn, turn, (self.n, 3)).tolist()
        for k in range(self.n):
            self.translate(particles[0][k], ways[k], numbers[0][k])
            self.rotate(particles[1][k], turns[k], numbers[1][k])

    def translate(self, i: int, way: list[float], number: float) -> None:
        cost = self.spring * free_energy.change_of_squares(way, self.moved[i], self.mean, self.n)
        if cost > 0 and number >= math.exp(-cost):
            return
        new = [u + w for u, w in zip(self.moved[i], way)]
        place = [x + u * s for x, u, s in zip(self.centers[i], new, self.stretch)]
        if self.simulation.try_placement(i, place, take=True):
            self.moved[i], self.mean = new, [m + w / self.n for m, w in zip(self.mean, way)]

    def rotate(self, i: int, way: list[float], number: float) -> None:
        turn = rotated(way, self.turns[i])
        square = squared_sine(turn)
        cost = self.spring * RATIO * (square - self.sines[i])
        if (cost <= 0 or number < math.exp(-cost)) and self.simulation.try_placement(i, quaternion=turn, take=True):
            self.turns[i], self.sines[i] = turn, square

    def squares(self) -> float:
        """Σ |u_i - U|² + R Σ sin²θ_i."""
        return free_energy.squares(self.moved) + RATIO * float(self.sines.sum())


def mean_square(sites: pypw85.System, spring: float, sweeps: int, rng: np.random.Generator) -> tuple[float, float]:
    """<Σ |u_i - U|² + R Σ sin²θ_i>, and its error."""
    crystal, averages = EinsteinCrystal(sites, spring, rng), pypw85.Blocking()
    for sweep in range(sweeps + sweeps // 5):
        crystal.sweep()
        if sweep >= sweeps // 5:
            averages.add([crystal.squares()])
    found = averages.estimate()
    return float(found.value[0]), float(found.error[0])


def by_einstein_crystal(cells: int, sweeps: int, seed: int) -> tuple[float, float]:
    """The excess free energy per particle by the first way, and its error."""
    sites, rng = crystal(cells), np.random.default_rng(seed)
    turning = len(sites) * math.log(axis_moments(RATIO * free_energy.STRONGEST)[0])
    free = free_probability(sites, rng)
    return free_energy.by_springs(len(sites), DENSITY, free, lambda spring: mean_square(sites, spring, sweeps, rng), turning)


def mean_squared_sine(sites: pypw85.System, spring: float, sweeps: int, seed: int) -> tuple[float, float]:
    """<sin²θ> with the aligning field alone, and its error."""
    simulation, averages = pypw85.HardEllipsoids(sites, seed=seed), pypw85.Blocking()
    # κ sin²θ is a constant less 2/3 κ P2.
    simulation.set_fields([pypw85.Field.aligning([0, 0, 1], 2 * spring / 3)])
    simulation.tune(sweeps // 5)
    for _ in range(sweeps // 2):
        simulation.sweep(2)
        averages.add([squared_sine(simulation.quaternions.T).mean()])
    found = averages.estimate()
    return float(found.value[0]), float(found.error[0])


def turning(cells: int, sweeps: int, seed: int) -> tuple[float, float]:
    """What it costs a spheroid that the others are in its way as it turns: G(0) - G(∞), per particle, and its error."""
    sites, total, variance = crystal(cells), 0.0, 0.0
    points, weights = np.polynomial.legendre.leggauss(FIELD_POINTS)
    for point, weight in zip((points + 1) / 2, weights / 2):
        spring = MIDDLE * point / (1 - point)
        value, error = mean_squared_sine(sites, spring, sweeps, seed)
        factor = weight * MIDDLE / (1 - point) ** 2
        total, variance = total - factor * (value - axis_moments(spring)[1]), variance + (factor * error) ** 2
    return total, math.sqrt(variance)


def read() -> list[Excess]:
    with TABLE.open(encoding="utf-8") as file:
        return [Excess(int(row["particles"]), *(float(row[name]) for name in Excess._fields[1:])) for row in csv.DictReader(file)]


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--cells", type=int, nargs="+", default=[2, 3], help="along each edge, of four spheroids each")
    parser.add_argument("--sweeps", type=int, default=6000, help="for each strength of the springs; ten times as many in the field")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--table", type=Path, default=TABLE)
    given = parser.parse_args()
    rows = []
    for cells in given.cells:
        n, spheres, error = free_energy.excess(cells, given.sweeps, given.seed, DENSITY)
        cost, error_of_cost = turning(cells, 10 * given.sweeps, given.seed)
        second = spheres + cost, math.hypot(error, error_of_cost)
        rows.append(Excess(n, *by_einstein_crystal(cells, given.sweeps, given.seed), *second, spheres, error))
        print("N = {}: {:.4f} ± {:.4f} by the Einstein crystal, {:.4f} ± {:.4f} from spheres".format(*rows[-1][:5]), flush=True)
        with given.table.open("w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(Excess._fields)
            table.writerows((row.particles, *(f"{number:.5f}" for number in row[1:])) for row in rows)


if __name__ == "__main__":
    main()
