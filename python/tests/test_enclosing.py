# SPDX-License-Identifier: BSD-3-Clause
"""The smallest ellipsoid around points, and around a share of samples."""

import numpy as np
import pypw85
import pytest


def squares(center, q, points):
    """(x - c)ᵀ Q⁻¹ (x - c) of each point."""
    n = len(center)
    form = np.zeros((n, n))
    form[np.triu_indices(n)] = q
    form = form + np.triu(form, 1).T
    z = np.asarray(points) - center
    return np.einsum("ij,ij->i", z, np.linalg.solve(form, z.T).T)


@pytest.mark.parametrize("n", [1, 2, 3, 7, 16])
def test_points_are_inside_and_some_on_the_surface(n):
    points = np.random.default_rng(n).normal(size=(500, n))
    center, q, excess = pypw85.enclosing_ellipsoid(points, tolerance=1e-9)
    assert q.shape == (n * (n + 1) // 2,)
    assert excess <= 1e-9
    found = squares(center, q, points)
    assert found.max() <= 1 + 1e-12
    assert (found > 1 - 1e-6).sum() >= n + (n > 1)


def test_cube():
    corners = np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T * [1, 2, 4] + [5, 6, 7]
    center, q, _ = pypw85.enclosing_ellipsoid(corners, 1e-10)
    np.testing.assert_allclose(center, [5, 6, 7], rtol=1e-9)
    np.testing.assert_allclose(q, [3, 0, 0, 12, 0, 48], atol=1e-8)


def test_what_double_precision_does_not_allow_is_said():
    points = np.random.default_rng(1).normal(size=(50, 3)) + 1e9
    with pytest.warns(RuntimeWarning, match=r"the excess is \d.*, above the tolerance 1e-12"):
        center, q, excess = pypw85.enclosing_ellipsoid(points, 1e-12)
    assert 1e-12 < excess < 1e-4
    assert squares(center, q, points).max() <= 1


@pytest.mark.parametrize("points, tolerance, words", [
    ([[0, 0], [1, 1], [0, np.nan]], 1e-6, r"row 2: points must be finite, not \[0.0, nan\]"),
    ([[0, 0], [1, 0]], 1e-6, "points must be at least 3 in 2 dimensions, not 2"),
    ([[0, 0], [1, 1], [3, 3]], 1e-6, "points must not be in a hyperplane"),
    ([[0, 0], [1, 1], [0, 1]], 0, "tolerance must be positive and finite, not 0"),
])  # fmt: skip
def test_bad_points(points, tolerance, words):
    with pytest.raises(pypw85.PW85Error, match=words):
        pypw85.enclosing_ellipsoid(points, tolerance)


@pytest.mark.parametrize("points", [[1, 2, 3], np.zeros((4, 17)), np.zeros((4, 0))])
def test_bad_shapes(points):
    for function in (pypw85.enclosing_ellipsoid, lambda x: pypw85.credible_ellipsoid(x, 0.5)):
        with pytest.raises(ValueError, match=r"must have the shape \(m, n\) with n from 1 to 16"):
            function(points)


def test_share_of_samples():
    """Outliers are left out, and the ellipsoid is about that of the quantile of χ²."""
    random = np.random.default_rng(2)
    samples = random.normal(size=(20000, 2)) @ [[2, 0], [1, 0.5]]
    samples[:100] = 1000 + random.normal(size=(100, 2))
    center, q, excess = pypw85.credible_ellipsoid(samples, 0.9)
    found = squares(center, q, samples)
    assert excess <= 1e-6
    assert 18000 <= (found <= 1).sum() < 18400
    volume, exact = np.sqrt(q[0] * q[2] - q[1] ** 2), 2 * np.log(10)  # the quantile of χ² at 90 %, and det of the map is 1
    assert 0.95 < volume / exact < 1.15


def test_share_of_all_is_the_smallest_around_all():
    samples = np.random.default_rng(3).normal(size=(40, 3))
    for one, other in zip(pypw85.credible_ellipsoid(samples, 1), pypw85.enclosing_ellipsoid(samples)):
        np.testing.assert_array_equal(one, other)
    for share in (0, 1.5, np.nan):
        with pytest.raises(ValueError, match="share must be above 0 and at most 1"):
            pypw85.credible_ellipsoid(samples, share)
    with pytest.raises(pypw85.PW85Error, match="row 0: samples must be finite"):
        pypw85.credible_ellipsoid(samples * np.nan, 0.5)


def test_credible_ellipsoid_in_any_units():
    """The same samples are kept whatever the units of each coordinate are, and the volume has these units."""
    samples = np.random.default_rng(2).normal(size=(2000, 2))
    full = lambda q: q[0] * q[2] - q[1] ** 2  # noqa: E731
    expected = full(pypw85.credible_ellipsoid(samples, 0.5)[1])
    for first, second in ((0, -30), (40, -40), (400, 300)):
        q = pypw85.credible_ellipsoid(np.ldexp(samples, [first, second]), 0.5)[1]
        found = full(np.ldexp(q, [-2 * first, -first - second, -2 * second]))
        np.testing.assert_allclose(found, expected, rtol=4e-6)  # twice the excess of each
