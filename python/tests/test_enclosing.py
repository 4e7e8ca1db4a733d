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
    ([[0, 0], [1, 0]], 1e-6, r"points: m must be at least n \+ 1, not 2"),
    ([[0, 0], [1, 1], [0, 1]], 0, "tolerance must be > 0, not 0"),
])  # fmt: skip
def test_bad_points(points, tolerance, words):
    with pytest.raises(pypw85.PW85Error, match=words):
        pypw85.enclosing_ellipsoid(points, tolerance)


def test_points_in_a_plane_have_the_ellipsoid_of_their_hull():
    """Points of the plane x + y = z: the ellipsoid is the image of the one around x and y."""
    flat = np.random.default_rng(4).integers(-50, 50, size=(30, 2)).astype(float)
    points = np.column_stack([flat, flat.sum(axis=1)])
    with pytest.warns(RuntimeWarning, match="enclosing_ellipsoid: the points are in a hyperplane: the form is singular"):
        center, q, excess = pypw85.enclosing_ellipsoid(points, 1e-9)
    middle, form, _ = pypw85.enclosing_ellipsoid(flat, 1e-9)
    embedding = np.array([[1, 0], [0, 1], [1, 1]])
    expected = embedding @ [[form[0], form[1]], [form[1], form[2]]] @ embedding.T
    np.testing.assert_allclose(center, embedding @ middle, atol=1e-3)
    np.testing.assert_allclose(q, expected[np.triu_indices(3)], atol=2e-4 * form.max() * 4)
    assert 0 <= excess <= 1e-9
    with pytest.warns(RuntimeWarning, match="credible_ellipsoid: the samples are in a hyperplane"):
        pypw85.credible_ellipsoid(points, 0.8)
    with pytest.warns(RuntimeWarning, match="enclosing_ellipsoid: the points are in a hyperplane"):
        pypw85.enclosing_ellipsoid([[0, 0], [1, 1], [3, 3 + 1e-9]])
    with pytest.warns(RuntimeWarning, match="hyperplane"):
        center, q, excess = pypw85.enclosing_ellipsoid([[7, 8]] * 5)
    assert center.tolist() == [7, 8] and q.tolist() == [0, 0, 0] and excess == 0


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


@pytest.mark.parametrize("samples, words", [
    (np.zeros((0, 3)), r"samples: m must be at least n \+ 1, not 0"),
    (np.eye(3), r"samples: m must be at least n \+ 1, not 3"),
    ([[0, 0], [1, 1e200], [2, 0], [3, 1]], r"credible_ellipsoid: samples must have an extent between 2\^-480 and 2\^480 along each coord"),
])  # fmt: skip
def test_bad_samples(samples, words):
    with pytest.raises(pypw85.PW85Error, match=words):
        pypw85.credible_ellipsoid(samples, 1)


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


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_ellipsoids_are_inside(n):
    random = np.random.default_rng(n)
    centers, maps = random.normal(size=(20, n)), random.normal(size=(20, n, n)) / 4
    forms = maps @ maps.transpose(0, 2, 1) + 0.01 * np.eye(n)
    center, q, excess = pypw85.enclosing_ellipsoid_of(centers, forms, 1e-8)
    assert excess <= 1e-8
    kappa2, _ = pypw85.nd_containment(centers - center, q, forms)
    assert 1 - 1e-8 < kappa2.max() < 1 + 1e-14  # centers - center is rounded
    packed = forms[(..., *np.triu_indices(n))]
    np.testing.assert_array_equal(pypw85.enclosing_ellipsoid_of(centers, packed, 1e-8)[1], q)


def test_one_ellipsoid_is_its_own():
    center, q, _ = pypw85.enclosing_ellipsoid_of([[1, 2, 3]], [[4, 1, 0, 2, 0, 1]], 1e-10)
    np.testing.assert_allclose(center, [1, 2, 3], rtol=1e-10)
    np.testing.assert_allclose(q, [4, 1, 0, 2, 0, 1], atol=1e-9)


@pytest.mark.parametrize("centers, forms, tolerance, words", [
    ([[0, np.inf]], [[1, 0, 1]], 1e-6, r"row 0: centers must be finite, not \[0.0, inf\]"),
    ([[0, 0], [1, 0]], [[1, 0, 1], [1, 1, 1]], 1e-6, r"row 1: forms must be positive definite, not \[1.0, 1.0, 1.0\]"),
    (np.zeros((0, 2)), np.zeros((0, 3)), 1e-6, "m must be at least 1, not 0"),
    ([[0, 0]], [[1, 0, 1]], -1, "tolerance must be > 0, not -1"),
    ([[0, 0]], [[1, 1 - 2**-52, 1]], 1e-6, "the ellipsoid is too flat to be certified"),
])  # fmt: skip
def test_bad_ellipsoids(centers, forms, tolerance, words):
    with pytest.raises(pypw85.PW85Error, match=words):
        pypw85.enclosing_ellipsoid_of(centers, forms, tolerance)


def test_bad_shapes_of_ellipsoids():
    for centers, forms, words in [
        (np.zeros(2), [[1, 0, 1]], r"centers must have the shape \(m, n\)"),
        (np.zeros((2, 2)), [[1, 0, 1]], r"forms must have one row for each of 2 centers, not the shape \(1, 3\)"),
        (np.zeros((1, 2)), [[1, 0, 1, 1]], "forms must have 2×2 or 3 numbers for 2 dimensions"),
    ]:
        with pytest.raises(ValueError, match=words):
            pypw85.enclosing_ellipsoid_of(centers, forms)


def test_clusters_of_a_system():
    random = np.random.default_rng(4)
    axes, turns = random.uniform(0.5, 2, size=(12, 3)), random.normal(size=(12, 4))
    turns /= np.linalg.norm(turns, axis=1, keepdims=True)
    system = pypw85.System.from_axes(random.uniform(-5, 5, size=(12, 3)), axes, turns, cell=20 * np.eye(3))
    clusters = np.array(["b", "a", "c"])[np.arange(12) % 3]
    around = pypw85.enclosing(system, clusters)
    assert around.types.tolist() == ["a", "b", "c"] and (around.cell == system.cell).all()
    for name, center, q in zip(around.types, around.centers, around.q):
        inside = clusters == name
        kappa2, _ = pypw85.containment(system.centers[inside] - center, q, system.q[inside])
        assert 1 - 1e-6 < kappa2.max() < 1 + 1e-14
    assert len(pypw85.enclosing(system).centers) == 1
    with pytest.raises(ValueError, match=r"clusters must have one entry for each of 12 particles, not the shape \(3,\)"):
        pypw85.enclosing(system, [1, 2, 3])
    with pytest.raises(ValueError, match="enclosing: system must have particles"):
        pypw85.enclosing(pypw85.System(np.zeros((0, 3)), np.zeros((0, 6))))
    with pytest.raises(TypeError, match="enclosing: system must be a pypw85.System, not list"):
        pypw85.enclosing([])
    with pytest.raises(TypeError, match="enclosing: clusters must be numbers or strings, not"):
        pypw85.enclosing(system, [None] * len(system))
    with pytest.raises(pypw85.PW85Error, match="^enclosing: cluster a: tolerance must be > 0, not -1.0$"):
        pypw85.enclosing(system, clusters, -1)
    with pytest.raises(pypw85.PW85Error, match="^enclosing: tolerance must be > 0, not -1.0$"):
        pypw85.enclosing(system, tolerance=-1)


def test_one_ellipsoid_of_one_dimension():
    center, q, excess = pypw85.enclosing_ellipsoid_of([[1.0]], [[4.0]])
    np.testing.assert_allclose([center[0], q[0]], [1, 4], rtol=1e-6)
    assert 0 <= excess <= 1e-6


@pytest.mark.parametrize("n", [1, 2, 3, 8])
def test_far_from_the_origin(n):
    """Coordinates that are rounded to 2⁻²⁰ of the size of a ball do not allow the tolerance; the search ends, and says what it has."""
    with pytest.warns(RuntimeWarning, match="the excess is .*, above the tolerance"):
        *_, excess = pypw85.enclosing_ellipsoid_of([[1e10] * n], [np.eye(n)])
    assert 1e-6 < excess < n * 1e-5


def test_clusters_of_the_plane():
    system = pypw85.System([[0, 0, 0], [3, 0, 0]], [[1, 0, 0, 1, 0, 1]] * 2, dimensions=2)
    around = pypw85.enclosing(system, tolerance=1e-9)
    assert around.dimensions == 2
    _, q, _ = pypw85.enclosing_ellipsoid_of([[0, 0], [3, 0]], [[1, 0, 1]] * 2, 1e-9)
    np.testing.assert_array_equal(around.q[0, [0, 1, 3]], q)
