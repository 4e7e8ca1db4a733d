# SPDX-License-Identifier: BSD-3-Clause
"""Indices and tables of common parts, and a worked example of niches."""

from itertools import pairwise

import numpy as np
import pypw85
import pytest

BALL = pypw85.spheroid(1, 1, [0, 0, 1])
CIRCLE = pypw85.ellipse(1, 1, 0)


def test_indices_of_balls():
    """Two unit balls at the distance 1 have 5π/12 in common."""
    common, whole = 5 * np.pi / 12, 4 * np.pi / 3
    r12 = [1, 0, 0]
    assert pypw85.overlap_volume(r12, BALL, BALL) == pytest.approx(common, rel=1e-14)
    assert pypw85.union_volume(r12, BALL, BALL) == pytest.approx(2 * whole - common, rel=1e-14)
    assert pypw85.jaccard(r12, BALL, BALL) == pytest.approx(common / (2 * whole - common), rel=1e-14)
    assert pypw85.sorensen(r12, BALL, BALL) == pytest.approx(common / whole, rel=1e-14)


def test_indices_of_circles():
    common = 2 * np.pi / 3 - np.sqrt(3) / 2
    r12 = [1, 0]
    assert pypw85.union_area_2d(r12, CIRCLE, CIRCLE) == pytest.approx(2 * np.pi - common, rel=1e-14)
    assert pypw85.jaccard_2d(r12, CIRCLE, CIRCLE) == pytest.approx(common / (2 * np.pi - common), rel=1e-14)
    assert pypw85.sorensen_2d(r12, CIRCLE, CIRCLE) == pytest.approx(common / np.pi, rel=1e-14)


def test_limits_of_indices():
    for r12, expected in (([0, 0, 0], 1.0), ([9, 0, 0], 0.0)):
        assert pypw85.jaccard(r12, BALL, BALL) == expected
        assert pypw85.sorensen(r12, BALL, BALL) == expected


@pytest.mark.parametrize("exponent", [-480, -360, -40, 40, 360, 480])
def test_units_of_indices(exponent):
    """Indices have no unit, also where volumes are beyond the range of double."""
    scale = 2.0**exponent
    pairs = np.array([[1, 0.5, 0], [0, 0, 0], [9, 0, 0]]) * scale
    ball, circle, other = (scale * (scale * np.array(one)) for one in (BALL, CIRCLE, [4, 0.5, 0, 1, 0, 2]))
    for index in (pypw85.jaccard, pypw85.sorensen):
        assert (index(pairs, ball, other) == index(pairs / scale, BALL, [4, 0.5, 0, 1, 0, 2])).all()
    for index in (pypw85.jaccard_2d, pypw85.sorensen_2d):  # areas of 2^±80 and 1 are computed in two ways, each within some u
        expected = index(pairs[:, :2] / scale, CIRCLE, CIRCLE)
        assert index(pairs[:, :2], circle, circle) == pytest.approx(expected, rel=256 * 2.0**-53)


def test_indices_of_tangent_spheroids():
    """They touch from inside at a pole and cross at a circle. What both have in common is a segment of each."""
    r12, q1, q2 = [0, 0, 1], [4, 0, 0, 4, 0, 4], [4, 0, 0, 4, 0, 1]
    common, first, second = 112 * np.pi / 27, 32 * np.pi / 3, 16 * np.pi / 3
    union = first + second - common
    assert pypw85.union_volume(r12, q1, q2) == pytest.approx(union, rel=1e-14)
    assert pypw85.jaccard(r12, q1, q2) == pytest.approx(common / union, rel=1e-14)
    assert pypw85.sorensen(r12, q1, q2) == pytest.approx(2 * common / (first + second), rel=1e-14)


def test_tables():
    random = np.random.default_rng(1)
    first, second = random.normal(size=(3, 3)), random.normal(size=(4, 3))
    q1, q2 = np.tile(BALL, (3, 1)), np.tile(pypw85.spheroid(1, 2, [1, 1, 0]), (4, 1))
    table = pypw85.overlap_table(first, q1, second, q2)
    assert table.shape == (3, 4)
    for i in range(3):
        for j in range(4):
            assert table[i, j] == pypw85.overlap_volume(second[j] - first[i], q1[i], q2[j])
    flat = pypw85.overlap_table_2d(first[:, :2], np.tile(CIRCLE, (3, 1)), second[:, :2], np.tile(CIRCLE, (4, 1)))
    assert flat[1, 2] == pypw85.overlap_area_2d(second[2, :2] - first[1, :2], CIRCLE, CIRCLE)


def test_pairs():
    centers = np.array([[0, 0, 0], [9, 0, 0], [1, 0, 0]])
    forms = np.tile(BALL, (3, 1))
    volumes = pypw85.overlap_volume_pairs([[0, 1], [0, 2]], centers, forms, cell=10 * np.eye(3))
    np.testing.assert_allclose(volumes, 5 * np.pi / 12, rtol=1e-14)
    forms[1] = -1
    with np.errstate(invalid="ignore"):
        assert np.isnan(pypw85.overlap_volume_pairs([[0, 1]], centers, forms)).all()


def test_covariance_in_the_plane():
    """The ellipse of confidence p holds the share p of the distribution: its χ² quantile is -2 ln(1 - p)."""
    covariance = np.array([[2.0, 0.5], [0.5, 1.0]])
    q = pypw85.from_covariance(covariance, 0.95)
    np.testing.assert_allclose(q, -2 * np.log(0.05) * covariance[[0, 0, 1], [0, 1, 1]], rtol=1e-15)
    np.testing.assert_allclose(pypw85.from_covariance(covariance, 1 - np.exp(-0.5)), covariance[[0, 0, 1], [0, 1, 1]], rtol=1e-14)
    with pytest.raises(ValueError, match="confidence"):
        pypw85.from_covariance(covariance, 1.0)
    with pytest.raises(ValueError, match="symmetric"):
        pypw85.from_covariance([[1, 0.5], [0, 1]], 0.95)


def polygon(center, q, vertices):
    angle = 2 * np.pi * np.arange(vertices) / vertices
    root = np.linalg.cholesky([[q[0], q[1]], [q[1], q[2]]])
    return np.asarray(center) + (root @ [np.cos(angle), np.sin(angle)]).T


def clipped_area(subject, clip):
    """The area of the common part of two convex polygons (Sutherland and Hodgman)."""
    cross = lambda a, b: a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]  # noqa: E731
    points = subject
    for start, end in zip(clip, np.roll(clip, -1, axis=0)):
        sides = cross(end - start, points - start)
        before, before_sides = np.roll(points, 1, axis=0), np.roll(sides, 1)
        crosses = sides * before_sides < 0
        shares = np.divide(before_sides, before_sides - sides, out=np.zeros(len(points)), where=crosses)
        crossings = before + shares[:, None] * (points - before)
        points = np.stack([crossings, points], axis=1)[np.stack([crosses, sides >= 0], axis=1)]
    return 0.5 * cross(points, np.roll(points, -1, axis=0)).sum()


def test_niches_and_polygons():
    """Polygons, as SIBER intersects them, converge to the exact area from below, as the inverse square of their number of vertices."""
    herring, sprat = (pypw85.from_covariance(c, 0.95) for c in ([[1.0, 0.4], [0.4, 0.8]], [[0.5, -0.1], [-0.1, 0.6]]))
    exact = pypw85.overlap_area_2d([1.5, 0.5], herring, sprat)
    lacks = [1 - clipped_area(polygon([0, 0], herring, n), polygon([1.5, 0.5], sprat, n)) / exact for n in (100, 400, 1600)]
    assert 2e-4 < lacks[0] < 2e-3
    assert all(0.9 < 16 * after / before < 1.1 for before, after in pairwise(lacks))
