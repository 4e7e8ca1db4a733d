# SPDX-License-Identifier: BSD-3-Clause
"""Ordered starts: lattices of parallel ellipsoids."""

import numpy as np
import pytest

import pypw85

# The largest fractions: spheres by hand; stretched lattices as spheres; and rods of aspect 3 along an edge, which touch sideways first.
LARGEST = [
    ("sc", [1, 1, 1], np.pi / 6),
    ("fcc", [1, 1, 1], np.pi / np.sqrt(18)),
    ("stretched", [1, 1, 3], np.pi / np.sqrt(18)),
    ("stretched", [2, 3, 1], np.pi / np.sqrt(18)),
    ("sc", [1, 1, 3], np.pi / 6 / 9),
    ("sc", [3, 3, 1], np.pi / 6 / 3),
]


@pytest.mark.parametrize("kind, axes, largest", LARGEST)
@pytest.mark.parametrize("unit", [1.0, 2.0**40, 2.0**-40])
def test_largest_fraction(kind, axes, largest, unit):
    """No overlap right below it; a sentence with it above."""
    number = 27 if kind == "sc" else 32
    system = pypw85.lattice(unit * np.array(axes), largest * (1 - 1e-8), number, kind)
    assert len(system) == number and len(system.overlaps().mu) == 0
    assert system.packing_fraction == pytest.approx(largest, rel=1e-7)
    with pytest.raises(ValueError, match=rf"at most {largest:.6g}, beyond which parallel ellipsoids overlap on the {kind} lattice, not"):
        pypw85.lattice(unit * np.array(axes), largest * (1 + 1e-8), number, kind)


@pytest.mark.parametrize("align", [(0, 0, 1), (0, 0, -3), (1, 0, 0), (1, -2, 2e-300), (-1, 2, 0.5)])
@pytest.mark.parametrize("kind", ["stretched", "fcc"])
@pytest.mark.parametrize("axes", [[0.5, 0.5, 1.5], [1.5, 0.5, 0.5], [1, 0.4, 1]])
def test_directions(kind, align, axes):
    """Long axes of rods and short ones of plates point along the direction; the exact test finds no overlap."""
    system = pypw85.lattice(axes, 0.7 if kind == "stretched" else 0.05, 32, kind, align)
    assert len(system.overlaps().mu) == 0
    assert pypw85.nematic_order(system) == pytest.approx(1, abs=1e-12)
    assert abs(pypw85.director(system) @ align) == pytest.approx(np.linalg.norm(align), rel=1e-12)
    q = pypw85.full(system.q[0])
    assert np.sqrt(np.linalg.eigvalsh(q)) == pytest.approx(np.sort(axes), rel=1e-12)


def test_shape_of_the_cell():
    edges = np.linalg.norm(pypw85.lattice([0.5, 0.5, 1.5], 0.5, 4 * 5 * 5 * 2).cell, axis=1)
    assert edges.max() / edges.min() < 1.3


REFUSED = [
    (([1, 1, 3], 0.5, 30), "must be a multiple of 4, the particles in a cell of the stretched lattice, not 30: take 28 or 32"),
    (([1, 1, 3], 0.5, 0), "must be a multiple of 4, the particles in a cell of the stretched lattice, not 0: take 4"),
    (([1, 1, 3], 1.5, 32), "fraction must be between 0 and 1"),
    (([1, 1, 3], 0.5, 32, "hcp"), "lattice: kind must be 'sc', 'fcc' or 'stretched', not 'hcp'"),
    (([1, 1, 3], 0.5, 32, "sc", (0, 0, 0)), "align must be three finite numbers that are not all 0"),
    (([1, 1, 3], 0.5, 32, "sc", (0, np.nan, 1)), "align must be three finite numbers that are not all 0"),
    (([1, 1], 0.5, 32), r"semi_axes must be three numbers, not an array of the shape \(2,\)"),
    (([1, 1, -1], 0.5, 32), "must be finite and > 0"),
]


@pytest.mark.parametrize("arguments, sentence", REFUSED)
def test_refused(arguments, sentence):
    with pytest.raises(ValueError, match=sentence):
        pypw85.lattice(*arguments)
