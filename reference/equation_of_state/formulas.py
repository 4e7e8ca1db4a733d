"""Formulas beside equation_of_state.csv: that of Parsons, the virial series from reference/virial/virial.csv, and how far they are
from the table; and the pressures of event chains beside the volume fractions at these pressures.

Volumes are in units of that of an ellipsoid, and rows are dictionaries of texts by the names of the columns.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("", "virial")]
import csv_rows
from coefficients import ORDERS, PATH

TABLE = Path(__file__).with_name("equation_of_state.csv")
Row = dict[str, str]


def virial_row(aspect: str) -> Row:
    """The row of virial.csv of the spheroids with an aspect ratio, as 3 or 1/3."""
    prolate, _, oblate = aspect.partition("/")
    shape = "sphere" if aspect == "1" else f"oblate {oblate}" if oblate else f"prolate {prolate}"
    return next(row for row in csv_rows.read(PATH) if row["shape"] == shape)


def parsons(b2, phi):
    """Z of the isotropic fluid by Parsons (1979): that of hard spheres by Carnahan and Starling (1969), scaled to the right B2."""
    return 1 + b2 * phi * (1 - phi / 2) / (1 - phi) ** 3


def parsons_slope(b2, phi):
    """The derivative of βPv = φZ by φ."""
    return 1 + b2 * phi * (2 - phi / 2) / (1 - phi) ** 4


def series(row: Row, phi):
    """Z by the virial series with B2 to B6, and its standard error from those of B3 to B6."""
    terms = [float(row[f"B{order}"]) * phi ** (order - 1) for order in (2, *ORDERS)]
    variances = [(float(row[f"B{order}_error"]) * phi ** (order - 1)) ** 2 for order in ORDERS]
    return 1 + sum(terms), sum(variances) ** 0.5


class Deviation(NamedTuple):
    """Of a formula from the Z that was measured, and its standard error, relative to this Z."""

    phi: float
    value: float
    error: float


def isotropic(rows: Iterable[Row], aspect: str) -> list[Row]:
    """Those of a shape at constant volume from random starts, which are isotropic."""
    return [row for row in rows if (row["aspect"], row["start"], row["ensemble"]) == (aspect, "random", "NVT")]


def deviation(row: Row, z: float, error: float = 0.0) -> Deviation:
    measured = float(row["z"])
    return Deviation(float(row["fraction"]), z / measured - 1, math.hypot(error, float(row["z_error"])) / measured)


def deviations(rows: Iterable[Row], aspect: str) -> tuple[list[Deviation], list[Deviation]]:
    """Those of the virial series, and those of Parsons' formula, in the isotropic fluid of a shape."""
    virial = virial_row(aspect)
    chosen = [(row, float(row["fraction"])) for row in isotropic(rows, aspect)]
    by_series = [deviation(row, *series(virial, phi)) for row, phi in chosen]
    return by_series, [deviation(row, parsons(float(virial["B2"]), phi)) for row, phi in chosen]


class Comparison(NamedTuple):
    """The volume fraction at which chains found a pressure, and that at this pressure. `error` is that of their difference."""

    aspect: str
    pressure: float
    chains: float
    applied: float
    applied_error: float
    error: float

    @property
    def sigmas(self) -> float:
        return (self.applied - self.chains) / self.error


def comparisons(rows: Iterable[Row]) -> Iterator[Comparison]:
    """One for each state at constant pressure. The error of the pressure is one of the volume fraction by the slope of Parsons'
    formula. It is right to a tenth in the isotropic fluid, and so is the error."""
    rows = list(rows)
    chains = {(row["aspect"], row["target"]): row for row in rows if (row["start"], row["ensemble"]) == ("random", "NVT")}
    for row in rows:
        if row["ensemble"] == "NPT":
            other = chains[row["aspect"], row["target"]]
            phi = float(other["fraction"])
            slope = parsons_slope(float(virial_row(row["aspect"])["B2"]), phi)
            applied, applied_error = float(row["fraction"]), float(row["fraction_error"])
            error = math.hypot(applied_error, phi * float(other["z_error"]) / slope)
            yield Comparison(row["aspect"], float(row["pressure"]), phi, applied, applied_error, error)
