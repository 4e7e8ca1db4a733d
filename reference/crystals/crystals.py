# SPDX-License-Identifier: BSD-3-Clause
"""Builds dense crystals of ellipsoids with two orientations, and writes crystals.csv.

It needs pypw85 on the path.

A. Donev, F. H. Stillinger, P. M. Chaikin and S. Torquato, Unusually dense crystal packings of ellipsoids, Phys. Rev. Lett. 92,
255506 (2004). The construction, in equations that the table solves to 50 digits:

1. A layer has ellipsoids with the semi-axes α along x, 1 along y and 1 along z at the points of a square lattice, whose shortest
   vectors (e, ±e, 0)/√2 lie along the diagonals of x and y. Neighbours along them touch if e² (1/α² + 1) / 2 = 4, so

       e² = 8 α² / (1 + α²).

2. The next layer is turned by 90° around z, and lies above the holes. An ellipsoid of it has its centre at (e/√2, 0, h) from one
   below, where the sections by the plane of x and z are a circle of radius 1 and an ellipse. They touch if the largest value over λ of

       f(λ) = λ (1 - λ) [X / ((1 - λ) α² + λ) + h²],   X = e²/2,

   is 1. For given λ that is an equation for h². The least h² of all λ belongs to the largest value of f:

       h² = min over λ of 1 / (λ (1 - λ)) - X / (α² - (α² - 1) λ),
       (2 λ - 1) (α² - (α² - 1) λ)² = X (α² - 1) λ² (1 - λ)² at the minimum.

   It is the only root of this quartic in (1/2, 1), because the sets of λ with f(λ) >= 1 are intervals: f is concave.

   Each ellipsoid touches four others in its layer, four above and four below. The volume per ellipsoid is e² h, so

       φ = 4π α / (3 e² h) = π (1 + α²) / (6 α h).

3. Neighbours along the long axis are 4 α / √(1 + α²) apart. They touch, too, at α = √3, and would overlap beyond. So at α = √3 there
   are 14 contacts. There λ is eliminated from 2, and h² = 2.4614… is a root of 9 H⁴ + 60 H³ - 194 H² + 20 H - 99.
4. Linear maps keep contacts and φ. A factor along z changes the third semi-axis alone. Factors p and q along the diagonals of x and y
   map the ellipsoids of both orientations to congruent ones, because a reflection exchanges both and keeps the map. The larger ratio
   κ of the two semi-axes in the layer then is

       κ + 1/κ = (α + 1/α) (p/q + q/p) / 2.

   So α = √3 gives φ = 0.770732 for all κ >= √3.

Here the diagonals are the axes of an orthorhombic cell, with one ellipsoid at its corner and one at its centre. The longest and the
shortest semi-axis lie in the layers, and the middle one across them: then φ depends on the ratio of longest to shortest alone.
"""

from __future__ import annotations

import argparse
import csv
from decimal import ROUND_FLOOR, Decimal, localcontext
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pypw85

TABLE = Path(__file__).with_name("crystals.csv")
DIGITS = 50
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")
# Touching pairs are found within this distance of 1 from μ: far above rounding errors, far below the next pairs of the table.
TOUCHING = 2.0**-30


class Layers(NamedTuple):
    """Edge e, height h and volume fraction φ of the layers of ellipsoids with semi-axes α, 1, 1."""

    edge: Decimal
    height: Decimal
    fraction: Decimal


class Crystal(NamedTuple):
    """Orthorhombic cell, and the angles ± of the long axes to its first edge, in radians."""

    edges: tuple[Decimal, Decimal, Decimal]
    angle: float


def layers(alpha: Decimal) -> Layers:
    """For 1 <= α <= √3."""
    with localcontext() as context:
        context.prec = DIGITS + 10
        a = alpha * alpha
        x = 4 * a / (1 + a)
        low, high = Decimal("0.5"), Decimal(1)
        while high - low > Decimal(10) ** -DIGITS:
            middle = (low + high) / 2
            falls = (2 * middle - 1) * (a - (a - 1) * middle) ** 2 < x * (a - 1) * (middle * (1 - middle)) ** 2
            low, high = (middle, high) if falls else (low, middle)
        height = (1 / (low * (1 - low)) - x / (a - (a - 1) * low)).sqrt()
        return Layers((2 * x).sqrt(), height, PI * (1 + a) / (6 * alpha * height))


def in_layer(aspect: Decimal) -> Decimal:
    """α of the layers from which the crystal of ellipsoids with this ratio of longest to shortest semi-axis is mapped. √3 is rounded
    down, so that ellipsoids do not overlap."""
    with localcontext() as context:
        context.prec, context.rounding = DIGITS, ROUND_FLOOR
        return min(aspect, Decimal(3).sqrt())


def crystal(shortest: Decimal, middle: Decimal, longest: Decimal) -> Crystal:
    with localcontext() as context:
        context.prec = DIGITS + 10
        kappa = longest / shortest
        alpha = in_layer(kappa)
        edge, height, _ = layers(alpha)
        sum_of_ratios = 2 * (kappa + 1 / kappa) / (alpha + 1 / alpha)
        ratio = (sum_of_ratios + max(sum_of_ratios**2 - 4, Decimal(0)).sqrt()) / 2  # p/q, at least 1
        product = longest * shortest / alpha  # p q: the map multiplies areas by it
        p, q = (product * ratio).sqrt(), (product / ratio).sqrt()
        # The first form, along the diagonals: ((p² m, p q d), (p q d, q² m)) with m = (α² + 1)/2 and d = (α² - 1)/2.
        m, d = (alpha**2 + 1) / 2, (alpha**2 - 1) / 2
        angle = 0.5 * np.arctan2(float(2 * product * d), float((p * p - q * q) * m))
        return Crystal((p * edge, q * edge, 2 * height * middle), float(angle))


def layered_crystal(semi_axes: tuple[float, float, float]) -> pypw85.System:
    """Two ellipsoids in a cell, of these semi-axes in any order."""
    shortest, middle, longest = sorted(semi_axes)
    edges, angle = crystal(Decimal(shortest), Decimal(middle), Decimal(longest))
    cell = np.diag([float(edge) for edge in edges])
    turned = [[np.cos(angle / 2), 0, 0, sign * np.sin(angle / 2)] for sign in (1, -1)]
    axes = np.tile([longest, shortest, middle], (2, 1))
    return pypw85.System.from_axes([np.zeros(3), np.diag(cell) / 2], axes, turned, cell=cell)


def contacts(system: pypw85.System) -> int:
    """How many others each ellipsoid touches. Both must touch as many, and nothing may overlap but by rounding."""
    found = system.contacts(1 + TOUCHING)
    if (found.mu < 1 - TOUCHING).any():
        raise ArithmeticError(f"ellipsoids overlap: μ = {found.mu.min()}")
    first, second = np.bincount(found.pairs.ravel(), minlength=2)
    if first != second:
        raise ArithmeticError(f"one ellipsoid touches {first}, the other {second}")
    return int(first)


def aspects() -> list[Decimal]:
    """Of the table, with √3 among them."""
    below = [Decimal(k) / 20 for k in range(20, 35)]
    return [*below, in_layer(Decimal(2)), *map(Decimal, ("1.75", "1.8", "1.9", "2", "2.5", "3", "4", "5", "10"))]


def row_of(aspect: Decimal) -> dict[str, str]:
    """Prolate, oblate and a triaxial shape between, which must touch alike and fill the same volume."""
    long = float(aspect)
    built = {middle: layered_crystal((1.0, middle, long)) for middle in (1.0, long**0.5, long)}
    counts = {contacts(system) for system in built.values()}
    if len(counts) > 1:
        raise ArithmeticError(f"aspect {aspect}: {counts} contacts")
    edges, angle = crystal(Decimal(1), Decimal(1), aspect)
    return {
        "aspect": str(aspect),
        "fraction": f"{layers(in_layer(aspect)).fraction:.{DIGITS - 1}f}",
        "contacts": str(counts.pop()),
        "angle": f"{np.degrees(angle):.10f}",
        **{f"edge_{k + 1}": f"{edge:.20f}" for k, edge in enumerate(edges)},
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", nargs="?", type=Path, default=TABLE)
    path = parser.parse_args().table
    rows = [row_of(aspect) for aspect in aspects()]
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
