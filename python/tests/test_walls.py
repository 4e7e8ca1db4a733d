# SPDX-License-Identifier: BSD-3-Clause
"""Walls, points and lines in Python."""

import numpy as np
import pytest

import pypw85


def test_points_agree_with_small_ellipsoids(random_pairs, assert_rows):
    """A point outside is an ellipsoid of no size: their distances differ by its radius."""
    r, q, _ = random_pairs(500)
    distance, point, normal = pypw85.distance_point(r, q)
    outside = distance > 1e-3
    radius = 1e-6
    apart, point1, _ = pypw85.distance(r, q, pypw85.spheroid(radius, radius, [0, 0, 1]))
    assert_rows((np.abs(apart + radius - distance) <= 1e-12) | ~outside, r, q)
    assert_rows((np.abs(point1 - point).max(axis=1) <= 1e-9) | ~outside, r, q)
    assert_rows(np.abs(r - point - distance[:, None] * normal).max(axis=1) <= 1e-12, r, q)


def test_lines_end_on_the_surface(random_pairs, assert_rows):
    origin, q, _ = random_pairs(500)
    enter, leave = pypw85.intersect_line(origin, [1.0, 2.0, 3.0], q)
    for t in (enter, leave):
        hit = ~np.isnan(t)
        distance = pypw85.distance_point(origin[hit] + t[hit, None] * [1.0, 2.0, 3.0], q[hit])[0]
        assert hit.sum() > 50
        assert_rows(np.abs(distance) <= 1e-12, origin[hit], q[hit])


def test_walls_agree(random_pairs, assert_rows):
    """A box as planes; a plane as a face of a box."""
    _, q, _ = random_pairs(500)
    distance, point, normal = pypw85.distance_box([-9, -9, -9], [9, 9, 3], q)
    plane, deepest = pypw85.distance_plane([0, 0, 2], 6, q)
    mu2, touching = pypw85.contact_plane([0, 0, 2], 6, q)
    d_center, d_rot = pypw85.distance_plane_derivatives([0, 0, 2], q)
    assert_rows(np.abs(distance - plane) <= 1e-14, q)
    assert_rows(np.abs(point - deepest).max(axis=1) <= 1e-14, q)
    assert_rows(np.abs(touching - np.sqrt(mu2)[:, None] * deepest).max(axis=1) <= 1e-13, q)
    np.testing.assert_array_equal(d_center, -normal)
    assert_rows(np.abs(d_rot - np.cross(normal, point)).max(axis=1) <= 1e-14, q)
    d_mu2 = pypw85.contact_plane_derivatives([0, 0, 2], 6, q)
    factor = 2 / 3 * mu2[:, None]  # μ = 3/α, and (2μ/α) = 2μ²/3 for a unit normal
    assert_rows(np.abs(d_mu2[0] - factor * d_center).max(axis=1) <= 1e-14 * mu2, q)
    assert_rows(np.abs(d_mu2[1] - factor * np.cross(normal, touching)).max(axis=1) <= 1e-13 * mu2**1.5, q)


def test_cylinder_against_many_normals(random_pairs, assert_rows):
    center, q, _ = random_pairs(200)
    distance = pypw85.distance_cylinder([0, 0, 1], 10, center, q)[0]
    angle = np.linspace(0, 2 * np.pi, 2000)
    normal = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    walls = pypw85.distance_plane(normal, 10 - center @ normal.T, q[:, None])[0].min(axis=1)
    assert_rows(distance <= walls + 1e-14, center, q)
    assert_rows(distance >= walls - 1e-4, center, q)


@pytest.mark.parametrize(
    "call",
    [
        lambda q: pypw85.distance_plane([0, 0, 0], 1, q),
        lambda q: pypw85.distance_box([0, 0, 1], [1, 1, 0], q),
        lambda q: pypw85.distance_cylinder([0, 0, 1], -1, [0, 0, 0], q),
        lambda q: pypw85.distance_point([np.nan, 0, 0], q),
        lambda q: pypw85.intersect_line([0, 0, 0], [0, 0, 0], q),
    ],
)
def test_errors(call):
    with pytest.raises(pypw85.PW85Error, match=r"^\w+: \w+ must "):
        call([1, 0, 0, 1, 0, 1])
