# SPDX-License-Identifier: BSD-3-Clause
"""Distances in Python: what the gufuncs give is what the mathematics says."""

import numpy as np
import pytest

import pypw85


@pytest.fixture
def pairs_apart(random_pairs):
    r12, q1, q2 = random_pairs(2000)
    apart = ~pypw85.overlap(r12, q1, q2)
    return r12[apart], q1[apart], q2[apart]


def test_points_and_normal(pairs_apart, assert_rows):
    r12, q1, q2 = pairs_apart
    distance, point1, point2 = pypw85.distance(r12, q1, q2)
    normal, torque1, torque2, hessian = pypw85.distance_derivatives(r12, q1, q2)
    error = np.abs(point2 - point1 - distance[:, None] * normal).max(axis=1)
    assert_rows(error <= 1e-12, r12, q1, q2)
    on_surface = np.einsum("ij,ij->i", np.linalg.solve(pypw85.full(q1), point1[..., None])[..., 0], point1)
    assert_rows(np.abs(on_surface - 1) <= 1e-12, r12, q1, q2)
    assert_rows(np.abs(torque1 + torque2 + np.cross(r12, normal)).max(axis=1) <= 1e-12, r12, q1, q2)
    assert hessian.shape == (len(r12), 9, 9)
    np.testing.assert_array_equal(hessian, hessian.swapaxes(1, 2))


def test_overlapping_pairs():
    q = pypw85.spheroid(1, 2, [0, 0, 1])
    distance, point1, point2 = pypw85.distance([1, 0, 0], q, q)
    assert distance == 0
    assert np.isnan(point1).all() and np.isnan(point2).all()
    assert all(np.isnan(x).all() for x in pypw85.distance_derivatives([1, 0, 0], q, q))


def test_bad_rows_become_nan():
    q = pypw85.spheroid(1, 2, [0, 0, 1])
    r12 = np.array([[5.0, 0, 0], [np.nan, 0, 0]])
    with np.errstate(invalid="ignore"):
        distance, point1, _ = pypw85.distance(r12, q, q)
    np.testing.assert_array_equal(np.isnan(distance), [False, True])
    assert np.isnan(point1[1]).all()


def test_two_dimensions():
    q = pypw85.ellipse(2, 1, 0)
    distance, point1, point2 = pypw85.distance_2d([7, 0], q, q)
    assert (distance, *point1, *point2) == pytest.approx((3, 2, 0, 5, 0), abs=1e-15)


@pytest.mark.parametrize("name", ["distance", "distance_derivatives"])
def test_errors(name):
    with pytest.raises(pypw85.PW85Error, match="positive definite"):
        getattr(pypw85, name)([5, 0, 0], [1, 2, 0, 1, 0, 1], [1, 0, 0, 1, 0, 1])


def test_penetration(random_pairs, assert_rows):
    r12, q1, q2 = random_pairs(300)
    r12 = 0.3 * r12
    overlapping = pypw85.overlap(r12, q1, q2)
    assert 50 < overlapping.sum()
    depth, direction = pypw85.penetration(r12, q1, q2)
    np.testing.assert_array_equal(depth > 0, overlapping)
    np.testing.assert_array_equal(np.isnan(direction).any(axis=1), ~overlapping)
    r12, q1, q2, depth, direction = (x[overlapping] for x in (r12, q1, q2, depth, direction))
    mu2 = pypw85.contact(r12 + depth[:, None] * direction, q1, q2)[0]
    assert_rows(np.abs(mu2 - 1) <= 1e-12, r12, q1, q2)
