# SPDX-License-Identifier: BSD-3-Clause
"""Formulas beside equation_of_state.csv: that of Parsons, the virial series from reference/virial/virial.csv alone and with the rest
of that of spheres, and how far they are from the table; and the pressures of event chains beside the volume fractions at these
pressures.

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
from coefficients import FITS, ORDERS, PATH

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


def powers(coefficients: dict[int, float], phi):
    """The terms of the virial series with some coefficients, by their orders."""
    return sum(b * phi ** (order - 1) for order, b in coefficients.items())


def partial_sum(row: Row, orders: Iterable[int], phi):
    """Z by the virial series with B2 and other coefficients of a row, and its standard error from those of these coefficients."""
    orders = tuple(orders)
    terms = powers({order: float(row[f"B{order}"]) for order in (2, *orders)}, phi)
    variances = [(float(row[f"B{order}_error"]) * phi ** (order - 1)) ** 2 for order in orders]
    return 1 + terms, sum(variances) ** 0.5


def series(row: Row, phi):
    """Z by the virial series with B2 to B6, and its standard error from those of B3 to B6."""
    return partial_sum(row, ORDERS, phi)


def with_rest(row: Row, phi):
    """Z by the virial series with B2 to B5, and what Carnahan and Starling's Z of spheres has beyond these terms, scaled to B2; with
    its standard error. Vega's equation (1997) has this form, with his fits as coefficients. Those of spheres are here the fits at
    α' = τ' = 0."""
    z, error = partial_sum(row, FITS, phi)
    spheres = {2: 4.0} | {order: fit[0, 0] for order, fit in FITS.items()}
    return z + float(row["B2"]) / 4 * (parsons(4, phi) - 1 - powers(spheres, phi)), error


class Deviation(NamedTuple):
    """Of a formula from the Z that was measured, and its standard error, relative to this Z."""

    phi: float
    value: float
    error: float


def isotropic(rows: Iterable[Row], aspect: str) -> list[Row]:
    """Those of a shape at constant volume from random starts, but for states next to a transition, whose order is above 0.15. That of
    spheres is NaN."""
    chosen = (aspect, "random", "NVT")
    return [row for row in rows if (row["aspect"], row["start"], row["ensemble"]) == chosen and not float(row["order"]) >= 0.15]


def deviation(row: Row, z: float, error: float = 0.0) -> Deviation:
    measured = float(row["z"])
    return Deviation(float(row["fraction"]), z / measured - 1, math.hypot(error, float(row["z_error"])) / measured)


class Deviations(NamedTuple):
    """Of three formulas in the isotropic fluid of a shape."""

    series: list[Deviation]
    with_rest: list[Deviation]
    parsons: list[Deviation]


def deviations(rows: Iterable[Row], aspect: str) -> Deviations:
    virial = virial_row(aspect)
    chosen = [(row, float(row["fraction"])) for row in isotropic(rows, aspect)]
    by_series, by_both = ([deviation(row, *formula(virial, phi)) for row, phi in chosen] for formula in (series, with_rest))
    return Deviations(by_series, by_both, [deviation(row, parsons(float(virial["B2"]), phi)) for row, phi in chosen])


class Comparison(NamedTuple):
    """The volume fraction at which chains found a pressure, and that at this pressure. `error` is that of their difference."""

    aspect: str
    start: str
    pressure: float
    chains: float
    applied: float
    applied_error: float
    error: float

    @property
    def sigmas(self) -> float:
        return (self.applied - self.chains) / self.error


def branch_of(row: Row, rows: Iterable[Row]) -> list[Row]:
    """Rows at constant volume of the same shape and phase, from the same start. A fluid with an order above 0.4 is nematic."""

    def phase(one: Row):
        return one["aspect"], one["start"], float(one["order"]) > 0.4

    return [one for one in rows if one["ensemble"] == "NVT" and phase(one) == phase(row)]


def slope(row: Row, branch: list[Row]) -> float:
    """The derivative of the pressure by the volume fraction at a row, by the power of φ that the pressures of the next rows of its
    branch follow. In the isotropic fluid it is that of Parsons' formula to a tenth."""
    ordered = sorted(branch, key=lambda one: float(one["fraction"]))
    place = ordered.index(row)
    low, here, high = (
        [float(one[name]) for name in ("fraction", "pressure")]
        for one in (ordered[max(place - 1, 0)], row, ordered[min(place + 1, len(ordered) - 1)])
    )
    return math.log(high[1] / low[1]) / math.log(high[0] / low[0]) * here[1] / here[0]


def comparisons(rows: Iterable[Row]) -> Iterator[Comparison]:
    """One for each state at constant pressure. The error of the pressure is one of the volume fraction by the slope of the branch."""
    rows = list(rows)
    for row in rows:
        if row["ensemble"] == "NPT":
            branch = branch_of(row, rows)
            other = next(one for one in branch if one["target"] == row["target"])
            phi = float(other["fraction"])
            applied, applied_error = float(row["fraction"]), float(row["fraction_error"])
            error = math.hypot(applied_error, phi * float(other["z_error"]) / slope(other, branch))
            yield Comparison(row["aspect"], row["start"], float(row["pressure"]), phi, applied, applied_error, error)
