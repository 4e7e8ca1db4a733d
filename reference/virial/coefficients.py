# SPDX-License-Identifier: BSD-3-Clause
"""The table of virial coefficients of hard ellipsoids, and the fits of C. Vega, Virial coefficients and equation of state of hard
ellipsoids, Molecular Physics 92, 651 (1997). All are in units of the volume of the ellipsoid."""

import csv
from pathlib import Path

PATH = Path(__file__).resolve().parent / "virial.csv"
ORDERS = (3, 4, 5, 6)  # the second one is exact

# Order -> coefficients of α'^i τ'^j by (i, j), with α' = RS/(3V) - 1 and τ' = 4πR²/S - 1. Their source is the page "Vega equation of state
# for hard ellipsoids" of SklogWiki.
FITS = {
    3: {(0, 0): 10, (1, 0): 13.094756, (0, 1): -2.073909, (2, 0): 4.096689, (0, 2): 2.325342, (1, 1): -5.791266},
    4: {
        (0, 0): 18.3648, (1, 0): 27.714434, (0, 1): -10.2046, (2, 0): 11.142963, (0, 2): 8.634491, (1, 1): -28.279451,
        (2, 1): -17.190946, (1, 2): 24.188979, (3, 0): 0.74674, (0, 3): -9.455150,
    },
    5: {
        (0, 0): 28.2245, (1, 0): 21.288105, (0, 1): 4.525788, (2, 0): 36.032793, (0, 2): 59.0098, (1, 1): -118.407497,
        (2, 1): 24.164622, (1, 2): 139.766174, (3, 0): -50.490244, (0, 3): -120.995139, (3, 1): 12.624655,
    },
}  # fmt: skip


def rows(path=PATH):
    """The rows of the table as dictionaries."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def fit(row, order):
    """The fit to B_order for the shape of a row."""
    alpha, tau = float(row["alpha"]) - 1, float(row["tau"]) - 1
    return sum(factor * alpha**i * tau**j for (i, j), factor in FITS[order].items())
