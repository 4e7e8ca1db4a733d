# SPDX-License-Identifier: BSD-3-Clause
"""Measures the equation of state of hard ellipses and discs by Monte Carlo in the plane, and writes ellipses.csv.

It needs pypw85 on the path. States that the table already has are not measured again. So a run that was interrupted goes on at the state
where it was, and a state is measured anew if its row is deleted.

All ellipses have the semi-axes 1/√κ and √κ, where κ is the aspect ratio. They start parallel, on a triangular lattice that is stretched
as they are. At constant area, Z = βP/ρ is measured by event chains and, independently of them, from the pairs that nearly touch. The
pressure of some of these states is then applied, and the area fraction is measured.
"""

from __future__ import annotations

import argparse
import sys
import zlib
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pypw85

sys.path.append(str(Path(__file__).resolve().parents[1]))
import csv_rows

TABLE = Path(__file__).with_name("ellipses.csv")
AREA = np.pi  # of each ellipse, because the product of its semi-axes is 1
# The width of the interval of μ from which the pressure of contacts is extrapolated
WIDTH = 0.05
# Cells of the stretched lattice, of two ellipses each, along the short axes and the long ones
CELLS = (24, 14)


class State(NamedTuple):
    """What is asked for."""

    aspect: str
    ensemble: str  # NVT or NPT
    target: str  # area fraction; in NPT that of the state whose pressure is applied

    @property
    def seed(self) -> int:
        return zlib.crc32(" ".join(("ellipses", *self)).encode())

    @property
    def semi_axes(self) -> tuple[float, float]:
        root = np.sqrt(float(self.aspect))
        return 1 / root, root


class Effort(NamedTuple):
    """Lengths of a run. A cycle is some sweeps, and some chains in NVT. In NPT, two trials of the area follow each sweep."""

    cells: tuple[int, int] = CELLS
    tuning: int = 500  # sweeps in which the steps change
    equilibration: int = 256  # cycles before the samples
    cycles: int = 512  # with one sample each
    sweeps: int = 16
    chains: int = 8


FRACTIONS = {
    "1": ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.65", "0.69"),
    "2": ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"),
    "4": ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6"),
    "6": ("0.1", "0.2", "0.3", "0.4", "0.5", "0.6"),
}
# Aspect ratio, area fraction: where the order is so slow that shorter runs have no errors
SLOW = (("4", "0.6"), ("6", "0.5"))
# Area fractions whose pressures, by chains, are applied
COMPRESSED = {"1": ("0.3", "0.5"), "2": ("0.3", "0.5"), "4": ("0.3",), "6": ("0.3",)}


def states() -> list[State]:
    """All states of the table, in the order in which they are measured."""
    return [State(aspect, ensemble, fraction) for ensemble, shapes in (("NVT", FRACTIONS), ("NPT", COMPRESSED))
            for aspect, fractions in shapes.items() for fraction in fractions]  # fmt: skip


def effort(state: State) -> Effort:
    """The denser and the longer ellipses are, the slower their orientations and the order of discs relax. Areas change slowly."""
    if state.ensemble == "NPT":
        return Effort(cells=(12, 7), sweeps=64)
    if (state.aspect, state.target) in SLOW:
        return Effort(sweeps=384)
    return Effort(sweeps=64) if float(state.target) >= 0.5 else Effort()


def start_of(state: State, cells: tuple[int, int]) -> pypw85.System:
    """Parallel ellipses on the stretched triangular lattice, whose area fraction is at most 0.907."""
    short, long = state.semi_axes
    edges = np.array([short, np.sqrt(3) * long]) * np.sqrt(2 * AREA / float(state.target) / np.sqrt(3))
    corners = np.stack(np.meshgrid(*map(np.arange, cells), indexing="ij"), axis=-1).reshape(-1, 1, 2)
    places = (corners + np.array([[0, 0], [0.5, 0.5]])).reshape(-1, 2) * edges
    n = len(places)
    return pypw85.System.from_ellipses(places, np.tile([short, long], (n, 1)), np.zeros(n), np.diag(edges * cells))


def measure(state: State, how: Effort, pressure: float = 0.0) -> pypw85.Observables:
    """Averages at constant area, or at a pressure βP > 0."""
    pypw85.set_reproducible(True)  # so that contacts have the same bits on every processor
    simulation = pypw85.HardEllipsoids(start_of(state, how.cells), state.seed)
    if state.aspect == "1":
        simulation.set_fractions(translation=1)
    simulation.tune(how.tuning, pressure=pressure)
    length = float(np.sqrt(np.linalg.det(simulation.cell)))
    observables = pypw85.Observables(WIDTH)
    for cycle in range(how.equilibration + how.cycles):
        for _ in range(how.sweeps if pressure else 0):
            simulation.sweep()
            simulation.volume_moves(2, pressure)
        if not pressure:
            simulation.sweep(how.sweeps)
        z = np.nan if pressure else simulation.chain(how.chains, length)
        if cycle >= how.equilibration:
            observables.add(simulation, z)
    simulation.check()
    return observables


def row_of(state: State, how: Effort, pressure: float = 0.0) -> dict[str, str]:
    """The row of a state; `pressure` is βP times the area of an ellipse, for NPT."""
    observables = measure(state, how, pressure / AREA)
    found, drifts = observables.estimates(), observables.drifts()
    unknown = np.nan, np.nan, np.nan
    fraction, fraction_error, _ = found["packing_fraction"]
    z, z_error, _ = found.get("compressibility_chains", unknown)
    contacts, contacts_error, _ = found["compressibility_contacts"]
    order, order_error, _ = found.get("nematic_order", unknown)
    drift = drifts.get("packing_fraction" if pressure else "compressibility_chains", np.nan)
    return {
        **state._asdict(), "particles": str(2 * how.cells[0] * how.cells[1]), "sweeps": str(how.cycles * how.sweeps),
        "fraction": f"{fraction:.6f}", "fraction_error": f"{fraction_error:.2g}",
        "pressure": f"{pressure or z * fraction:.6g}", "z": f"{z:.6g}", "z_error": f"{z_error:.2g}",
        "contacts": f"{contacts:.6g}", "contacts_error": f"{contacts_error:.2g}", "order": f"{order:.3g}",
        "order_error": f"{order_error:.2g}", "drift": f"{drift:.1f}", "seed": str(state.seed), "version": pypw85.__version__,
    }  # fmt: skip


def read_table(path: Path = TABLE) -> dict[State, dict[str, str]]:
    return {State(row["aspect"], row["ensemble"], row["target"]): row for row in csv_rows.read(path)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", nargs="?", type=Path, default=TABLE)
    path = parser.parse_args().table
    rows = read_table(path)

    def measured(state: State) -> dict[str, str]:
        pressure = float(rows[state._replace(ensemble="NVT")]["pressure"]) if state.ensemble == "NPT" else 0.0
        return row_of(state, effort(state), pressure)

    for _, row in csv_rows.complete(path, states(), rows, measured):
        print(*row.values(), flush=True)


if __name__ == "__main__":
    main()
