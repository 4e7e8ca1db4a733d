"""Makes jammed random packings of ellipsoids, and writes runs.csv with one row for each and packings.csv with one for each shape.

Usage: packings.py [FOLDER], with pypw85 on the path. Runs that the folder already has are not made again. So a program that was
interrupted goes on where it was, and a run is made anew if its row is deleted. SEEDS has the seeds: more of them add runs.

Ellipsoids are thrown into a periodic cube at random, at a low volume fraction. They repel one another where they overlap, as in
`pypw85.relax`: the energy is Σ (1 - μ²)²/2 over the pairs that overlap, and FIRE lowers it until it falls by less than 5 % in 100
steps. If it vanishes, the cube shrinks with all centres in it, the volume fraction grows by a share, and the energy is lowered
again, until the packing is jammed: the energy does not vanish.

Then the cube expands from the jammed packing by a step, and the energy is lowered again. If the packing is still jammed, the
search goes on from there, by a step that its energy suggests. If not, the step is halved. A run ends with a jammed packing that is
not jammed after a step of ACCURACY.

The volume fraction of a run is that of the last packing, which is not jammed, after its cube has grown by what small overlaps are
left: then the exact test finds none. The contacts of a run are the pairs that overlap in the jammed packing, which is denser by
about ACCURACY. Rattlers and their contacts do not count.
"""

from __future__ import annotations

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
PARTICLES, SEEDS = 250, range(1, 3)
MEANS = ("fraction", "contacts", "rattlers", "order")  # columns of runs whose means the table has
# Volume fraction at the start, the share by which it grows, and the last step.
START, GROWTH, ACCURACY = 0.5, 0.03, 1e-4
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


def first_jammed(axes: np.ndarray, number: int, seed: int) -> pypw85.System:
    """From a random start, by growth."""
    packing, is_jammed = quenched(random_start(axes, number, seed))
    while not is_jammed:
        packing, is_jammed = quenched(scaled(packing, (1 + GROWTH) ** (-1 / 3)))
    return packing


def make(axes: np.ndarray, number: int, seed: int) -> Packing:
    """One run."""
    jammed, step = first_jammed(axes, number, seed), GROWTH
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


def run(shape: str, number: int, seed: int) -> dict[str, str]:
    """Makes the row of a run."""
    packing = make(semi_axes(shape), number, seed)
    found = contacts(packing.jammed)
    return {
        "shape": shape,
        "particles": str(number),
        "seed": str(seed),
        "fraction": f"{packing.loose.packing_fraction:.6f}",
        "contacts": f"{found.mean:.4f}",
        "rattlers": f"{found.rattlers:.4f}",
        "order": f"{pypw85.nematic_order(packing.loose):.4f}",
        "version": pypw85.__version__,
    }


def table(runs: list[dict[str, str]]) -> list[dict[str, str]]:
    """Means over the runs of each shape, and their standard errors. The variance of a run is the mean over all shapes of their
    variances, because those of few runs say little."""
    values = np.array([[[float(run[name]) for name in MEANS] for run in runs if run["shape"] == shape] for shape in SHAPES])
    means, number = values.mean(axis=1), values.shape[1]
    errors = np.sqrt(values.var(axis=1, ddof=1).mean(axis=0) / number)
    return [
        {"shape": shape, "particles": runs[0]["particles"], "runs": str(number)}
        | {name: f"{mean:.5f}" for name, mean in zip(MEANS, row)}
        | {f"{name}_error": f"{error:.2g}" for name, error in zip(MEANS, errors)}
        for shape, row in zip(SHAPES, means)
    ]


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    runs = {(row["shape"], row["seed"]): row for row in read(folder / "runs.csv")}
    wanted = [(shape, str(seed)) for seed in SEEDS for shape in SHAPES]
    for shape, seed in wanted:
        if (shape, seed) not in runs:
            runs[shape, seed] = row = run(shape, PARTICLES, int(seed))
            write(folder / "runs.csv", (runs[one] for one in wanted if one in runs))
            print(*row.values(), flush=True)
    write(folder / "packings.csv", table([runs[one] for one in wanted]))


if __name__ == "__main__":
    main()
