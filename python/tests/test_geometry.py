# SPDX-License-Identifier: BSD-3-Clause
"""What follows from the contact function, by finite differences and by the equations of the ellipsoids."""

import numpy as np
import pytest

import pypw85

COUNT = 50


@pytest.fixture
def contact(random_pairs):
    r12, q1, q2 = random_pairs(COUNT)
    mu2, lambda_ = pypw85.contact(r12, q1, q2)
    return r12, q1, q2, lambda_, mu2


def normals(q, x):
    return np.linalg.solve(pypw85.full(q), x[..., np.newaxis])[..., 0]


def level(q, x):
    return np.einsum("ni,ni->n", x, normals(q, x))


def test_contact_geometry(contact):
    r12, q1, q2, lambda_, mu2 = contact
    point, normal = pypw85.contact_geometry(r12, q1, q2, lambda_)
    # Both levels are stationary nowhere: an error of 1e-12 in λ is seen as it is, times a factor of a few tens.
    np.testing.assert_allclose(level(q1, point), mu2, rtol=1e-9)
    np.testing.assert_allclose(level(q2, point - r12), mu2, rtol=1e-9)
    gradient = normals(q1, point)
    np.testing.assert_allclose(normal, gradient / np.linalg.norm(gradient, axis=1, keepdims=True), atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(normal, axis=1), 1, rtol=1e-15)


def central_difference(function, x):
    """Derivatives of function(x) along each component, with an error of h² f'''/6 + u f/h: some 1e-9 for f'''~10."""
    h = 1e-5
    columns = []
    for k in range(x.shape[-1]):
        step = h * np.eye(x.shape[-1])[k]
        columns.append((function(x + step) - function(x - step)) / (2 * h))
    return np.stack(columns, axis=-1)


def test_contact_gradient(contact):
    r12, q1, q2, lambda_, mu2 = contact
    d_r12, d_q1, d_q2 = pypw85.contact_gradient(r12, q1, q2, lambda_)
    tolerance = {"rtol": 1e-6, "atol": 1e-6 * mu2.max()}
    np.testing.assert_allclose(d_r12, central_difference(lambda x: pypw85.contact(x, q1, q2)[0], r12), **tolerance)
    np.testing.assert_allclose(d_q1, central_difference(lambda x: pypw85.contact(r12, x, q2)[0], q1), **tolerance)
    np.testing.assert_allclose(d_q2, central_difference(lambda x: pypw85.contact(r12, q1, x)[0], q2), **tolerance)


def turned(q, omega):
    """Forms turned by small rotation vectors (exact to second order, orthogonal to the fourth)."""
    cross = np.cross(np.eye(3), omega[..., np.newaxis, :])
    half = np.eye(3) + 0.5 * cross
    rotation = np.linalg.solve(np.eye(3) - 0.5 * cross, half)
    return pypw85.packed(rotation @ pypw85.full(q) @ np.swapaxes(rotation, -1, -2))


def test_contact_torque(contact):
    r12, q1, q2, lambda_, mu2 = contact
    d_rot1, d_rot2 = pypw85.contact_torque(r12, q1, q2, lambda_)
    tolerance = {"rtol": 1e-6, "atol": 1e-6 * mu2.max()}
    zero = np.zeros((COUNT, 3))
    expected1 = central_difference(lambda omega: pypw85.contact(r12, turned(q1, omega), q2)[0], zero)
    expected2 = central_difference(lambda omega: pypw85.contact(r12, q1, turned(q2, omega))[0], zero)
    np.testing.assert_allclose(d_rot1, expected1, **tolerance)
    np.testing.assert_allclose(d_rot2, expected2, **tolerance)


def test_closest_approach(contact):
    r12, q1, q2, _, mu2 = contact
    distance = pypw85.closest_approach(r12, q1, q2)
    np.testing.assert_allclose(distance, np.linalg.norm(r12, axis=1) / np.sqrt(mu2), rtol=1e-14)
    # An independent algorithm, which searches for a maximum to about the root of the rounding unit.
    np.testing.assert_allclose(pypw85.zheng_ellipsoids(r12, q1, q2), distance, rtol=1e-9)


def test_two_dimensions(rng):
    direction = rng.normal(size=(COUNT, 2))
    q1, q2 = (pypw85.ellipse(*rng.uniform(0.5, 2, (2, COUNT)), rng.uniform(0, 4, COUNT)) for _ in range(2))
    distance = pypw85.closest_approach_2d(direction, q1, q2)
    mu2, lambda_ = pypw85.contact_2d(direction, q1, q2)
    np.testing.assert_allclose(distance, np.linalg.norm(direction, axis=1) / np.sqrt(mu2), rtol=1e-14)
    np.testing.assert_allclose(pypw85.zheng_ellipses(direction, q1, q2), distance, rtol=1e-9)

    def extruded(q):
        """Ellipsoids with these ellipses as sections: the same contact function in their plane."""
        zero = np.zeros(COUNT)
        return np.stack([q[:, 0], q[:, 1], zero, q[:, 2], zero, zero + 1], axis=-1)

    solid = pypw85.contact(np.pad(direction, ((0, 0), (0, 1))), extruded(q1), extruded(q2))
    np.testing.assert_allclose(mu2, solid[0], rtol=1e-14)
    np.testing.assert_allclose(lambda_, solid[1], rtol=1e-10)
    out = np.empty((COUNT, 2))
    pypw85.contact_2d(direction, q1, q2, out)
    np.testing.assert_array_equal(out, np.stack([mu2, lambda_], axis=-1))
