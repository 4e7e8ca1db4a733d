# SPDX-License-Identifier: BSD-3-Clause
"""Makes jammed random packings of ellipsoids, and writes runs.csv with one row for each and packings.csv with their means.

It needs pypw85 on the path. Runs that the folder already has are not made again. So a program that was
interrupted goes on where it was, and a run is made anew if its row is deleted. More SEEDS add runs.

Ellipsoids are thrown into a periodic cube at random, at a low volume fraction. There are two ways from there to jamming.

With sweeps, `pypw85.relax` removes the overlaps. Ellipsoids grow as those of Lubachevsky and Stillinger (J. Stat. Phys. 60, 561,
1990) do, but they move by Monte Carlo: after some sweeps of trial moves, the cube is compressed until two ellipsoids touch, again
and again, until the pressure is high. Then the volume fraction grows in small shares as in the other way.

Without sweeps, ellipsoids repel one another where they overlap, as in `pypw85.relax`: the energy is Σ (1 - μ²)²/2 over the pairs
that overlap, and FIRE lowers it until it falls by less than 5 % in 100 steps. If it vanishes, the cube shrinks with all centres in
it, the volume fraction grows by a share, and the energy is lowered again, until the packing is jammed: the energy does not vanish.

Then the cube expands from the jammed packing by a step, and the energy is lowered again. If the packing is still jammed, the
search goes on from there, by a step that its energy suggests. If not, the step is halved. A run ends with a jammed packing that is
not jammed after a step of ACCURACY.

The volume fraction of a run is that of the last packing, which is not jammed, after its cube has grown by what small overlaps are
left: then the exact test finds none. The contacts of a run are the pairs that overlap in the jammed packing, which is denser by
about ACCURACY. Rattlers and their contacts do not count.
"""

from __future__ import annotations

import argparse
import sys
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pypw85
from pypw85 import _packing

sys.path.append(str(Path(__file__).resolve().parents[1]))
from csv_rows import read, write

FOLDER = Path(__file__).parent
SHAPES = ("1/3", "1/2", "2/3", "0.8", "1", "1.25", "1.5", "2", "3", "1.25:1:0.8")
PARTICLES = 250
SWEEPS = (30, 0)  # before each compression; without sweeps there is no growth by Monte Carlo
SEEDS = 3  # of each shape, with and without sweeps
MEANS = ("fraction", "contacts", "rattlers", "order")  # columns of runs whose means the table has
# Volume fraction at the start, and the last step of the search.
START, ACCURACY = 0.5, 1e-4
# The shares by which the volume fraction grows until a packing jams, after growth by Monte Carlo and from the start.
SMALL_GROWTH, GROWTH = 0.003, 0.03
# Of growth by Monte Carlo: sweeps before the first compression, and the acceptance to which steps are tuned.
FIRST_SWEEPS, ACCEPTANCE = 200, 0.4
# It ends at this Z = βP/ρ. Near jamming at φ_J, Z is d/(1 - φ/φ_J), where d = 3 to 6 is the number of degrees of freedom (Salsburg
# and Wood, J. Chem. Phys. 37, 798, 1962): then φ is some 1 % below φ_J. A compression ends at the first contact of N
# ellipsoids. So the volume shrinks by the share 1/(N (Z - 1)) on average. The mean is over so many COMPRESSIONS.
LAST_PRESSURE, COMPRESSIONS = 400, 100
# The energy vanishes if it is less than this per ellipsoid. At a volume fraction that is too large by ACCURACY, all 1 - μ² are some
# (2/3) 1e-4. With three contacts per ellipsoid, the energy is three times half its square, 7e-9: far above.
VANISHED = 1e-13
# In three dimensions fewer forces than this do not hold an ellipsoid.
HELD = 4


class Packing(NamedTuple):
    """What a run finds: a packing without overlaps, and the jammed one from which it comes by a step of ACCURACY."""

    loose: pypw85.System
    jammed: pypw85.System


class Contacts(NamedTuple):
    """Of the ellipsoids that are held: how many each has on average. `rattlers` is the share of the others."""

    mean: float
    rattlers: float


def semi_axes(shape: str) -> np.ndarray:
    """Of a triaxial ellipsoid a:b:c, or of a spheroid with the ratio of its axis of revolution to the others. The product is 1."""
    ratios = shape.split(":") if ":" in shape else ["1", "1", shape]
    axes = np.array([float(Fraction(ratio)) for ratio in ratios])
    return axes / np.cbrt(np.prod(axes))


def random_start(axes: np.ndarray, number: int, seed: int) -> pypw85.System:
    """Ellipsoids at random, which overlap."""
    random = np.random.default_rng(seed)
    cell = np.cbrt(4 / 3 * np.pi * np.prod(axes) * number / START) * np.eye(3)
    quaternions = random.normal(size=(number, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    return pypw85.System.from_axes(random.uniform(size=(number, 3)) @ cell, np.tile(axes, (number, 1)), quaternions, cell=cell)


def grown(axes: np.ndarray, number: int, sweeps: int, seed: int) -> pypw85.System:
    """Ellipsoids without overlaps, which are nearly jammed after so many sweeps before each compression."""
    simulation = pypw85.HardEllipsoids(pypw85.pack(np.tile(axes, (number, 1)), START, seed=seed), seed)
    simulation.tune(FIRST_SWEEPS, ACCEPTANCE)
    gain = 1.0
    while gain > 1 / (number * LAST_PRESSURE):
        before = simulation.cell[0, 0]
        for _ in range(COMPRESSIONS):
            simulation.tune(sweeps, ACCEPTANCE)
            simulation.compress(take=True)
        gain = 3 * (before / simulation.cell[0, 0] - 1) / COMPRESSIONS
    return simulation.system()


def scaled(system: pypw85.System, factor: float) -> pypw85.System:
    """In a larger or smaller cube, with all centres."""
    return pypw85.System.from_axes(factor * system.centers, system.semi_axes, system.quaternions, cell=factor * system.cell)


def quenched(system: pypw85.System) -> tuple[pypw85.System, bool]:
    """The packing of least energy nearby, and whether it is jammed."""
    soft = _packing._Soft(system)
    for push in _packing._quench(soft, 1.0):
        if push.energy < VANISHED * len(system):
            break
    return _packing._moved(system, soft.centers, soft.quaternions), push.energy >= VANISHED * len(system)


def excess(system: pypw85.System) -> float:
    """By about which share the volume fraction of a jammed packing is too large. If it is by ε, all 1 - μ² of contacts are some
    2ε/3, and with nine contacts at each ellipsoid the energy per ellipsoid is ε²."""
    overlaps = 1 - system.overlaps().mu ** 2
    return float(np.sqrt(overlaps @ overlaps / 2 / len(system)))


def without_overlaps(system: pypw85.System) -> pypw85.System:
    """In a cube that is larger by what small overlaps need. Where centres move apart by a factor, μ grows by it."""
    while len(mu := system.overlaps().mu):
        system = scaled(system, (1 + 2.0**-50) / mu.min())
    return system


def first_jammed(axes: np.ndarray, number: int, sweeps: int, seed: int) -> tuple[pypw85.System, float]:
    """By growth from a random start, and by which share the volume fraction grew in the end."""
    if sweeps:
        packing, is_jammed, share = grown(axes, number, sweeps, seed), False, SMALL_GROWTH
    else:
        (packing, is_jammed), share = quenched(random_start(axes, number, seed)), GROWTH
    while not is_jammed:
        packing, is_jammed = quenched(scaled(packing, (1 + share) ** (-1 / 3)))
    return packing, share


def make(axes: np.ndarray, number: int, sweeps: int, seed: int) -> Packing:
    """One run. Without sweeps, it has no growth by Monte Carlo."""
    jammed, step = first_jammed(axes, number, sweeps, seed)
    while True:
        step = max(min(step, excess(jammed)), ACCURACY)
        packing, is_jammed = quenched(scaled(jammed, (1 + step) ** (1 / 3)))
        if is_jammed:
            jammed = packing
        elif step > ACCURACY:
            step /= 2
        else:
            return Packing(without_overlaps(packing), jammed)


def contacts(system: pypw85.System) -> Contacts:
    """Pairs that overlap, between ellipsoids that at least HELD of them hold."""
    pairs, number = system.overlaps().pairs, len(system)
    while True:
        held = np.bincount(pairs.ravel(), minlength=number) >= HELD
        left = pairs[held[pairs].all(axis=1)]
        if len(left) == len(pairs):
            return Contacts(float(2 * len(pairs) / max(held.sum(), 1)), float(1 - held.mean()))
        pairs = left


def bond_order(system: pypw85.System) -> float:
    """Q6 of all contacts (Steinhardt and others, 1983): the root of the mean of P6(cos γ) over the angles γ between two of their
    normals. It is 0.575 in an fcc crystal, and of k contacts without order it is some 1/√k."""
    normal = system.overlaps().normal
    return float(np.sqrt(np.mean(np.polynomial.Legendre.basis(6)(normal @ normal.T))))


def run(shape: str, sweeps: int, number: int, seed: int) -> dict[str, str]:
    """Makes the row of a run."""
    packing = make(semi_axes(shape), number, sweeps, seed)
    found = contacts(packing.jammed)
    return {
        "shape": shape,
        "sweeps": str(sweeps),
        "particles": str(number),
        "seed": str(seed),
        "fraction": f"{packing.loose.packing_fraction:.6f}",
        "contacts": f"{found.mean:.4f}",
        "rattlers": f"{found.rattlers:.4f}",
        "order": f"{pypw85.nematic_order(packing.loose):.4f}",
        # Slow growth could end in a crystal.
        "bond_order": f"{bond_order(packing.jammed):.4f}" if sweeps else "",
        "version": pypw85.__version__,
    }


def wanted() -> list[tuple[str, str, str]]:
    """Shapes, sweeps and seeds of all runs, in the order in which they are made."""
    return [(shape, str(sweeps), str(seed)) for sweeps in SWEEPS for seed in range(1, SEEDS + 1) for shape in SHAPES]


def table(runs: list[dict[str, str]]) -> list[dict[str, str]]:
    """Means over the runs that differ in their seeds only, and their standard errors. The variance of a run is taken as the same
    for all, because those of few runs say little."""
    groups = {(shape, str(sweeps)): [] for sweeps in SWEEPS for shape in SHAPES}
    for one in runs:
        groups[one["shape"], one["sweeps"]].append([float(one[name]) for name in MEANS])
    values = {key: np.array(group) for key, group in groups.items() if group}
    squares = sum(((group - group.mean(axis=0)) ** 2).sum(axis=0) for group in values.values())
    variance = squares / (len(runs) - len(values))
    return [
        {"shape": shape, "sweeps": sweeps, "particles": runs[0]["particles"], "runs": str(len(group))}
        | {name: f"{mean:.5f}" for name, mean in zip(MEANS, group.mean(axis=0))}
        | {f"{name}_error": f"{error:.2g}" for name, error in zip(MEANS, np.sqrt(variance / len(group)))}
        for (shape, sweeps), group in values.items()
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER)
    folder = parser.parse_args().folder
    runs = {(row["shape"], row["sweeps"], row["seed"]): row for row in read(folder / "runs.csv")}
    for key in wanted():
        if key not in runs:
            shape, sweeps, seed = key
            runs[key] = row = run(shape, int(sweeps), PARTICLES, int(seed))
            write(folder / "runs.csv", (runs[one] for one in wanted() if one in runs))
            print(*row.values(), flush=True)
    write(folder / "packings.csv", table([runs[one] for one in wanted()]))


if __name__ == "__main__":
    main()
