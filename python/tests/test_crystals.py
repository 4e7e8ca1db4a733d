# SPDX-License-Identifier: BSD-3-Clause
"""Dense crystals: `reference/crystals`."""

import csv
import itertools
import os
import sys
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import pypw85

FOLDER = Path(os.environ["PYPW85_SOURCE"]) / "reference" / "crystals"
sys.path.insert(0, str(FOLDER))
import crystals  # noqa: E402

with (FOLDER / "crystals.csv").open(newline="", encoding="utf-8") as file:
    ROWS = list(csv.DictReader(file))
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")
SHAPES = [(1, 1, 1.3), (1.3, 1, 1.3), (1, 1, 2**0.5), (0.8, 1, 1.25), (1, 2, 3), (5, 1, 1), (5, 1, 5), (1, 3, 50)]


def discriminant(a, b, c, d):
    """Of a x³ + b x² + c x + d."""
    return 18 * a * b * c * d - 4 * b**3 * d + (b * c) ** 2 - 4 * a * c**3 - 27 * (a * d) ** 2


def layers_overlap(alpha2, h2):
    """Whether the circle of a layer overlaps the ellipse of the next one, exactly.

    That is where λ (1 - λ) (X + h² b) - b, with b = α² - (α² - 1) λ, has no root in (0, 1): a cubic without other real roots than one.
    """
    x, k = 4 * alpha2 / (1 + alpha2), alpha2 - 1
    return discriminant(h2 * k, -(x + h2 * alpha2) - h2 * k, x + h2 * alpha2 + k, -alpha2) < 0


def test_table():
    """All digits of the table but the last: by the discriminant of a cubic, in rational arithmetic."""
    for row in ROWS:
        alpha2 = min(Fraction(row["aspect"]) ** 2, Fraction(3))
        # From φ = π (1 + α²) / (6 α h), squared.
        h2 = [
            (PI * (1 + alpha2)) ** 2 / (36 * alpha2 * fraction**2)
            for fraction in (Fraction(row["fraction"]) + sign * Fraction(1, 10**48) for sign in (1, -1))
        ]
        assert layers_overlap(alpha2, h2[0]) and not layers_overlap(alpha2, h2[1]), row


def test_remade():
    """One row, by the program."""
    row = ROWS[7]
    assert crystals.row_of(Decimal(row["aspect"])) == row


@pytest.mark.parametrize("semi_axes", SHAPES)
@pytest.mark.parametrize("scale", [2.0**-40, 1.0, 3.0])
def test_contacts(semi_axes, scale):
    """Ellipsoids of any shape touch 12 or 14 others. No pair overlaps in a cell that is larger by rounding errors, and all touching
    pairs do in one that is smaller."""
    axes = scale * np.asarray(semi_axes, float)
    system = crystals.layered_crystal(tuple(axes))
    aspect = max(semi_axes) / min(semi_axes)
    number = crystals.contacts(system)
    assert number == (14 if aspect > 3**0.5 else 12), (semi_axes, number)
    mu2 = system.contacts(1 + crystals.TOUCHING).mu ** 2
    # Relative errors of 2^-53 in the largest entry of a form count aspect² times as much along the shortest semi-axis. Sixteen such
    # errors are allowed: of the angle, the quaternion, the form, the centres and the cell, of both ellipsoids.
    bound = 16 * aspect**2 * 2.0**-53
    assert np.abs(mu2 - 1).max() < bound, (semi_axes, mu2.min(), mu2.max())
    for factor, overlaps in ((1 + bound, 0), (1 - bound, number)):
        cell = factor * system.cell
        other = pypw85.System.from_axes(factor * system.centers, system.semi_axes, system.quaternions, cell=cell)
        assert len(other.overlaps().mu) == overlaps, (semi_axes, factor)


def test_denser():
    """Up to √3 the crystals are the denser the more slender the ellipsoids are, and from there on as dense as published: 0.770732."""
    fractions = [Fraction(row["fraction"]) for row in ROWS]
    assert float(fractions[0]) == pytest.approx(np.pi / 18**0.5, rel=1e-15)
    assert all(one < next_one for one, next_one in itertools.pairwise(fractions[:16]))
    assert all(f"{float(one):.6f}" == "0.770732" for one in fractions[15:])


@pytest.mark.parametrize("semi_axes", SHAPES)
def test_fraction(semi_axes):
    """The cell of doubles holds what the table says."""
    short, _, long = sorted(map(Decimal, semi_axes))
    expected = float(crystals.layers(crystals.in_layer(long / short)).fraction)
    assert crystals.layered_crystal(semi_axes).packing_fraction == pytest.approx(expected, rel=2.0**-48)
