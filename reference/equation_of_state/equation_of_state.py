# SPDX-License-Identifier: BSD-3-Clause
"""Measures the equation of state of hard spheroids by Monte Carlo, and writes equation_of_state.csv.

It needs pypw85 on the path. States that the table already has are not measured again. So a run
that was interrupted goes on at the state where it was, and a state is measured anew if its row is deleted.

All ellipsoids have the semi-axes (s, s, κ s), where κ is the aspect ratio and s³κ = 1. At constant volume, event chains measure
Z = βP/ρ. The pressure of some of these states is then applied, and the volume fraction φ is measured. Each row has the seed of
its random numbers and the version of the library. Another version may give other random walks with the same averages.
"""

from __future__ import annotations

import argparse
import sys
import zlib
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pypw85

sys.path += [str(Path(__file__).resolve().parents[1])]
import csv_rows
from formulas import TABLE, branch_of, slope

VOLUME = 4 / 3 * np.pi  # of each ellipsoid, because the product of its semi-axes is 1


class State(NamedTuple):
    """What is asked for. `start` is random, or aligned: a stretched fcc crystal of parallel ellipsoids."""

    aspect: str  # of the axis of revolution to the others: 3 or 1/3
    start: str
    ensemble: str  # NVT or NPT
    target: str  # volume fraction; in NPT that of the state whose pressure is applied

    @property
    def seed(self) -> int:
        return zlib.crc32(" ".join(self).encode())

    @property
    def kappa(self) -> float:
        return float(Fraction(self.aspect))

    @property
    def cells(self) -> tuple[int, int, int]:
        """Of the crystal of the start, if it is aligned."""
        return CELLS[self.ensemble][self.aspect]

    @property
    def semi_axes(self) -> np.ndarray:
        """Their product is 1."""
        return np.array([1, 1, self.kappa]) / np.cbrt(self.kappa)


class Effort(NamedTuple):
    """Lengths of a run. A cycle is some sweeps, and some chains in NVT. In NPT, four trials of the volume follow each sweep."""

    particles: int = 1000
    tuning: int = 500  # sweeps in which the steps change
    equilibration: int = 128  # cycles before the samples
    cycles: int = 256  # with one sample each
    sweeps: int = 4
    chains: int = 8
    translation: float = 0.0  # the part of the trials of a sweep that translate; the others rotate


class Estimate(NamedTuple):
    value: float
    error: float
    drift: float  # from the first sample to the last, in units of its error


# From both starts, on both sides of a transition and next to it
TRANSITION = {"1/5": ("0.32", "0.34", "0.36")}
# Isotropic, but so near a transition that the order is slow
SLOW = (("3", "0.45"), ("1/3", "0.45"), ("5", "0.35"))
# Aspect ratio, start, volume fraction: where 2^18 sweeps do not show how slow the order is
SLOWEST = {("1/5", "random", fraction) for fraction in TRANSITION["1/5"]} | {
    ("1/5", "aligned", "0.34"),
    ("5", "aligned", "0.5"),
    ("5", "aligned", "0.55"),
}
RANDOM = {
    "1": ("0.1", "0.2", "0.3", "0.4", "0.45"),
    "3": ("0.1", "0.2", "0.3", "0.4", "0.45"),
    "1/3": ("0.1", "0.2", "0.3", "0.4", "0.45"),
    "5": ("0.1", "0.2", "0.3", "0.35"),
    "1/5": ("0.1", "0.2", "0.3", *TRANSITION["1/5"]),
    "2": ("0.1", "0.2", "0.3", "0.4", "0.5"),
    "1/2": ("0.1", "0.2", "0.3", "0.4", "0.5"),
}
ALIGNED = {
    "5": ("0.45", "0.475", "0.5", "0.55"),
    "1/5": (*TRANSITION["1/5"], "0.425", "0.45", "0.5"),
    "3": ("0.3", "0.55", "0.56"),
    "1/3": ("0.3", "0.53", "0.55"),
}
# Volume fractions whose pressures, by chains, are applied.
COMPRESSED = {
    "random": {
        "1": ("0.3", "0.4"),
        "3": ("0.3",),
        "1/3": ("0.3",),
        "5": ("0.3",),
        "1/5": ("0.2",),
        "2": ("0.4",),
        "1/2": ("0.4",),
    },
    "aligned": {"5": ("0.5",), "1/5": ("0.45",)},
}
# Cells of the stretched crystal, which have four particles each: the box is about as long as it is wide.
CELLS = {
    "NVT": {"5": (11, 11, 2), "1/5": (4, 4, 20), "3": (9, 9, 3), "1/3": (4, 4, 12)},
    "NPT": {"5": (8, 8, 2), "1/5": (3, 3, 15)},
}


def states() -> list[State]:
    """All states of the table, in the order in which they are measured."""
    branches = {
        ("random", "NVT"): RANDOM,
        ("random", "NPT"): COMPRESSED["random"],
        ("aligned", "NVT"): ALIGNED,
        ("aligned", "NPT"): COMPRESSED["aligned"],
    }
    return [State(a, *branch, f) for branch, shapes in branches.items() for a, fractions in shapes.items() for f in fractions]


def effort(state: State) -> Effort:
    """Orientations of long and flat ellipsoids relax slowly, parallel ones lose their order slowly, and volumes change slowly. Next to a
    transition the order takes longest."""
    near = state.ensemble == "NVT" and (state.target in TRANSITION.get(state.aspect, ()) or (state.aspect, state.target) in SLOW)
    if near or (state.start == "aligned" and state.target != "0.3"):
        slow = "3" in state.aspect or (state.aspect, state.start, state.target) in SLOWEST
        return Effort(cycles=512, sweeps=1600 if slow else 512, chains=64, translation=0.5)
    if state.ensemble == "NPT":
        return Effort(particles=128, equilibration=40, cycles=512, sweeps=64, translation=0.5)
    return Effort(sweeps=8, chains=16) if "5" in state.aspect else Effort()


def random_start(state: State, number: int) -> pypw85.System:
    return pypw85.pack(np.tile(state.semi_axes, (number, 1)), float(state.target), seed=state.seed)


def aligned_start(state: State) -> pypw85.System:
    """The fcc crystal of spheres, stretched along the axes of the cell. It exists up to a volume fraction of 0.74."""
    edges = state.semi_axes * np.cbrt(4 * VOLUME / float(state.target))
    corners = np.stack(np.meshgrid(*map(np.arange, state.cells), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    places = (corners + np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])).reshape(-1, 3) * edges
    n = len(places)
    upright = np.tile([1.0, 0, 0, 0], (n, 1))
    return pypw85.System.from_axes(places, np.tile(state.semi_axes, (n, 1)), upright, cell=np.diag(edges * state.cells))


def estimates(samples: list[tuple[float, ...]]) -> list[Estimate]:
    """Those of each number of the samples. Errors are NaN if one of the numbers is too slow for the run (`pypw85.Blocking`). The drift is
    that of a straight line, whose difference from the start to the end has the error √12 times that of the mean."""
    found, slow = [], False
    for numbers in zip(*samples):
        averages = pypw85.Blocking()
        for number in numbers:
            averages.add(number)
        found.append([averages.estimate().value[0], averages.errors(averages.squared_error)[0][0]])
        slow = slow or bool(averages.too_slow()[0])
    value, error = np.transpose(found)
    error = np.where(slow, np.nan, error)
    n = len(samples)
    drift = 12 * ((np.arange(n) - (n - 1) / 2) @ np.array(samples)) / n**2 / (np.sqrt(12) * error)
    return [Estimate(*row) for row in zip(value.tolist(), error.tolist(), drift.tolist())]


def crystal_order(simulation: pypw85.HardEllipsoids, cells: tuple[int, int, int]) -> float:
    """The largest |Σ exp(ik·x)|²/N² over the shortest reciprocal vectors k of the crystal of the start. It is 1 in this crystal,
    and some 1/N if it has melted."""
    vectors = np.array([[1, 1, 1], [-1, 1, 1], [1, -1, 1], [1, 1, -1]]) * 2 * np.pi * cells / np.diag(simulation.cell)
    waves = np.exp(1j * simulation.system().centers @ vectors.T)
    return float((abs(waves.mean(axis=0)) ** 2).max())


def fraction(simulation: pypw85.HardEllipsoids) -> float:
    return len(simulation) * VOLUME / abs(float(np.linalg.det(simulation.cell)))


def one_cycle(simulation: pypw85.HardEllipsoids, how: Effort, pressure: float) -> float:
    """Z of a cycle at constant volume if `pressure` is 0, and the volume fraction after a cycle at this pressure otherwise."""
    if not pressure:
        simulation.sweep(how.sweeps)
        return simulation.chain(how.chains, float(simulation.cell.max()))
    for _ in range(how.sweeps):
        simulation.sweep()
        simulation.volume_moves(4, pressure)
    return fraction(simulation)


def volume_step(number: int, z: float) -> float:
    """The largest change of the logarithm of the edge, for the volume to change fast. With δ the change of the logarithm of the
    volume, a compression of N ellipsoids makes no overlap with the probability exp(-N(Z - 1)δ), and an expansion is accepted with
    the same one. The mean square of the change is largest if δ is drawn up to some 3/(N(Z - 1))."""
    return 1 / (number * (z - 1))


def measure(state: State, how: Effort, pressure: float = 0.0) -> tuple[Estimate, Estimate]:
    """Z, or the volume fraction at a pressure βPv > 0, and the nematic order. No overlap and no crystal is there at the end."""
    aligned = state.start == "aligned"
    start = aligned_start(state) if aligned else random_start(state, how.particles)
    simulation = pypw85.HardEllipsoids(start, state.seed)
    beta_p = pressure / VOLUME
    simulation.set_fractions(translation=how.translation, rotation=1 - how.translation)
    simulation.tune(how.tuning, pressure=beta_p)
    if pressure:
        steps = simulation.steps
        simulation.set_steps(steps.translation, steps.rotation, volume_step(len(start), pressure / float(state.target)))
    for _ in range(how.equilibration):
        one_cycle(simulation, how, beta_p)
    samples = []
    for _ in range(how.cycles):
        found = one_cycle(simulation, how, beta_p)
        samples.append((found, pypw85.nematic_order(simulation.system())))
    simulation.check()
    if aligned and crystal_order(simulation, state.cells) > 0.1:
        raise RuntimeError(f"{' '.join(state)} is still a crystal")
    result, order = estimates(samples)
    return result, order


def error_at_fraction(phi: float, phi_error: float, steepness: float) -> float:
    """The error of Z = P/φ at the volume fraction φ that was found at the pressure P. With the true Z(φ) = P(φ)/φ, an error δ of φ
    changes P/φ - Z(φ) by -(P/φ² + Z'(φ)) δ = -P'(φ) δ/φ. The error of P/φ alone, P δ/φ², leaves out that both numbers err together."""
    return steepness * phi_error / phi


def row_of(state: State, how: Effort, pressure: float = 0.0, steepness: float = 0.0) -> dict[str, str]:
    """Measures a state and makes its row. In NPT it needs the pressure, and the derivative of the pressure by the volume fraction."""
    result, order = measure(state, how, pressure)
    phi, phi_error = result[:2] if pressure else (float(state.target), 0.0)
    z, z_error = (pressure / phi, error_at_fraction(phi, phi_error, steepness)) if pressure else result[:2]
    number = 4 * int(np.prod(state.cells)) if state.start == "aligned" else how.particles
    return state._asdict() | {
        "particles": str(number),
        "sweeps": str(how.cycles * how.sweeps),
        "fraction": f"{phi:.6f}",
        "fraction_error": f"{phi_error:.2g}",
        "pressure": repr(pressure) if pressure else f"{z * phi:.6g}",
        "z": f"{z:.6g}",
        "z_error": f"{z_error:.2g}",
        "order": f"{order.value:.4f}",
        "order_error": f"{order.error:.2g}",
        "drift": f"{result.drift:.1f}",
        "order_drift": f"{order.drift:.1f}",
        "seed": str(state.seed),
        "version": pypw85.__version__,
    }


def read_table(path: Path = TABLE) -> dict[State, dict[str, str]]:
    """Rows by their states; empty if there is no such file."""
    return {State(*(row[name] for name in State._fields)): row for row in csv_rows.read(path)}


def applied(state: State, rows: dict[State, dict[str, str]]) -> tuple[float, float]:
    """The pressure that is applied, and its derivative by the volume fraction, from the rows at constant volume; zeros for none."""
    if state.ensemble == "NVT":
        return 0.0, 0.0
    row = rows[state._replace(ensemble="NVT")]
    return float(row["pressure"]), slope(row, branch_of(row, rows.values()))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", nargs="?", type=Path, default=TABLE)
    path = parser.parse_args().table
    pypw85.set_reproducible(True)  # so that random packings, from which runs start, have the same bits on every processor
    rows = read_table(path)
    for state, row in csv_rows.complete(path, states(), rows, lambda one: row_of(one, effort(one), *applied(one, rows))):
        shown = ("fraction", "z", "z_error", "order", "drift", "order_drift")
        print(*state, *(f"{name} {row[name]}" for name in shown), flush=True)


if __name__ == "__main__":
    main()
