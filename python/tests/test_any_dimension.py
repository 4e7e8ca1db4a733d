# SPDX-License-Identifier: BSD-3-Clause
"""Two ellipsoids in n dimensions: shapes, errors, and SciPy's minimisation as the truth."""

import numpy as np
import pytest

import pypw85
from pypw85 import PW85Error


def random_form(rng, n, aspect):
    axes = np.linalg.qr(rng.normal(size=(n, n)))[0]
    lengths = aspect ** rng.uniform(-1, 0, size=n)
    return (axes * lengths**2) @ axes.T


def f(lambda_, r12, q1, q2):
    return lambda_ * (1 - lambda_) * r12 @ np.linalg.solve((1 - lambda_) * q1 + lambda_ * q2, r12)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 6, 9, 16])
def test_contact_is_the_maximum(n):
    rng = np.random.default_rng(n)
    for _ in range(5):
        r12, q1, q2 = rng.normal(size=n), random_form(rng, n, 5), random_form(rng, n, 5)
        mu2, lambda_ = pypw85.nd_contact(r12, q1, q2)
        # np.linalg.solve has a condition number of at most 25
        assert abs(f(lambda_, r12, q1, q2) / mu2 - 1) < 1e-12
        assert all(f(x, r12, q1, q2) <= mu2 * (1 + 1e-12) for x in np.linspace(0, 1, 41))
        geometry = pypw85.nd_contact_geometry(r12, q1, q2, lambda_)
        assert abs(geometry.point @ np.linalg.solve(q1, geometry.point) / mu2 - 1) < 1e-7  # λ is known to 1e-8 or so
        assert abs(geometry.normal @ geometry.normal - 1) < 1e-14
        assert abs(geometry.d_r12 @ r12 / (2 * mu2) - 1) < 1e-12  # μ² is homogeneous
        assert pypw85.nd_overlap(r12, q1, q2) == (mu2 < 1)
        assert pypw85.nd_overlap(r12 / np.sqrt(mu2) * (1 - 1e-9), q1, q2)
        assert not pypw85.nd_overlap(r12 / np.sqrt(mu2) * (1 + 1e-9), q1, q2)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 16])
def test_containment_is_the_farthest_point(n):
    rng = np.random.default_rng(n + 50)
    for _ in range(5):
        r12, q1, q2 = rng.normal(size=n), random_form(rng, n, 5), random_form(rng, n, 5)
        kappa2, point = pypw85.nd_containment(r12, q1, q2)
        # np.linalg.solve has a condition number of at most 25
        assert abs(point @ np.linalg.solve(q1, point) / kappa2 - 1) < 1e-11
        assert abs((point - r12) @ np.linalg.solve(q2, point - r12) - 1) < 1e-11
        directions = rng.normal(size=(200, n))
        others = r12 + directions @ q2 / np.sqrt(np.einsum("ki,ij,kj->k", directions, q2, directions))[:, np.newaxis]
        assert (np.einsum("ki,ki->k", others, np.linalg.solve(q1, others.T).T) <= kappa2 * (1 + 1e-11)).all()
        assert pypw85.nd_contains(r12, q1 * kappa2 * (1 + 1e-9), q2)
        assert not pypw85.nd_contains(r12, q1 * kappa2 * (1 - 1e-9), q2)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 16])
def test_distance(n):
    rng = np.random.default_rng(n + 60)
    for _ in range(5):
        r12, q1, q2 = 6 * rng.normal(size=n), random_form(rng, n, 5), random_form(rng, n, 5)
        found = pypw85.nd_distance(r12, q1, q2)
        if pypw85.nd_overlap(r12, q1, q2):
            assert found.distance == 0 and np.isnan(found.point1).all() and np.isnan(found.normal).all()
            continue
        # np.linalg.solve has a condition number of at most 25
        for point, q in ((found.point1, q1), (found.point2 - r12, q2)):
            assert abs(point @ np.linalg.solve(q, point) - 1) < 1e-12
        np.testing.assert_allclose(found.point2 - found.point1, found.distance * found.normal, atol=1e-10)
        slab = found.normal @ r12 - np.sqrt(found.normal @ q1 @ found.normal) - np.sqrt(found.normal @ q2 @ found.normal)
        assert abs(slab - found.distance) < 1e-13 * np.linalg.norm(r12)


def test_comparison():
    rng = np.random.default_rng(51)
    r12, q1, q2 = rng.normal(size=(8, 5)), random_form(rng, 5, 5), random_form(rng, 5, 5)
    mu2, _ = pypw85.nd_contact(r12, q1, q2)
    np.testing.assert_array_equal(pypw85.nd_compare(r12, q1, q2, mu2 * (1 - 1e-9)), np.ones(8))
    np.testing.assert_array_equal(pypw85.nd_compare(r12, q1, q2, mu2 * (1 + 1e-9)), -np.ones(8))
    assert pypw85.nd_compare(r12[0], q1, q2, [[0], [np.inf]]).tolist() == [[1], [-1]]
    with pytest.raises(PW85Error, match=r"row \(1,\): mu2 must be >= 0, not -1.0"):
        pypw85.nd_compare(r12[0], q1, q2, [1, -1])


def test_three_dimensions_are_as_before():
    rng = np.random.default_rng(3)
    r12, q1, q2 = rng.normal(size=(50, 3)), *(np.array([random_form(rng, 3, 10) for _ in range(50)]) for _ in range(2))
    packed = [pypw85.packed(q) for q in (q1, q2)]
    expected = pypw85.contact(r12, *packed)
    for forms in ((q1, q2), packed, (q1, packed[1])):
        mu2, _ = pypw85.nd_contact(r12, *forms)
        np.testing.assert_allclose(mu2, expected[0] if isinstance(expected, tuple) else expected[..., 0], rtol=1e-11)
    np.testing.assert_array_equal(pypw85.nd_overlap(r12, q1, q2), pypw85.overlap(r12, *packed))
    small = [q / 16 for q in packed]
    np.testing.assert_array_equal(pypw85.nd_contains(r12 / 8, q1, small[1]), pypw85.contains(r12 / 8, packed[0], small[1]))
    apart = 5 * r12
    for one, other in zip(pypw85.nd_distance(apart, q1, q2), pypw85.distance(apart, *packed)):
        np.testing.assert_allclose(one, other, atol=1e-9)
    np.testing.assert_allclose(pypw85.nd_containment(r12, q1, q2)[0], pypw85.containment(r12, *packed)[0], rtol=1e-11)


def test_shapes():
    eye = np.eye(4)
    mu2, lambda_ = pypw85.nd_contact(np.ones((5, 1, 4)), eye, np.stack([eye, 4 * eye]))
    assert mu2.shape == lambda_.shape == (5, 2)
    np.testing.assert_allclose(mu2, np.broadcast_to([1, 4 / 9], (5, 2)), rtol=1e-14)
    assert np.ndim(pypw85.nd_contact([1.0], [[4.0]], [4.0])[0]) == 0
    assert pypw85.nd_overlap(np.empty((0, 4)), eye, eye).shape == (0,)
    geometry = pypw85.nd_contact_geometry(np.ones((3, 4)), eye, eye, 0.5)
    assert geometry.point.shape == (3, 4) and geometry.d_q1.shape == (3, 10)
    # a float32, a transposed and a strided array
    assert pypw85.nd_contact(np.ones(8, dtype=np.float32)[::2], np.asfortranarray(eye), eye)[0] == 1
    for bad in [
        (1.0, eye, eye), (np.ones(17), np.eye(17), np.eye(17)), (np.ones(4), np.eye(3), eye), (np.ones(4), np.ones(9), eye),
        (np.ones((2, 4)), np.stack([eye] * 3), eye), (np.ones(4), eye + np.eye(4, k=1), eye),
    ]:  # fmt: skip
        with pytest.raises(ValueError, match="nd_contact: "):
            pypw85.nd_contact(*bad)


def test_causes_are_named():
    eye = np.eye(4)
    flat = np.diag([1.0, 1, 1, 0])
    for arguments, words in [
        ((np.ones(4), eye, flat), "q2 must be positive definite"),
        ((np.ones((2, 4)), np.stack([eye, -eye]), eye), r"row \(1,\): q1 must be positive definite"),
        (([1, np.nan, 0, 0], eye, eye), "r12 must be finite"),
    ]:
        with pytest.raises(PW85Error, match=words):
            pypw85.nd_contact(*arguments)
        with pytest.raises(PW85Error, match=words):
            pypw85.nd_overlap(*arguments)
        with pytest.raises(PW85Error, match=words):
            pypw85.nd_containment(*arguments)
    with pytest.raises(PW85Error, match=r"nd_contact_geometry: lambda_ must be in \[0, 1\], not 2.0"):
        pypw85.nd_contact_geometry(np.ones(4), eye, eye, 2.0)
    with pytest.raises(PW85Error, match=r"nd_contact_geometry: row \(1,\): r12 must not be zero, not \[0.0, 0.0, 0.0, 0.0\]"):
        pypw85.nd_contact_geometry([np.ones(4), np.zeros(4)], eye, eye, 0.5)


def test_the_bad_row_is_named():
    """Row 0 has axes too far apart for a number, but not for an overlap; row 1 is refused."""
    far = [2.0**1000, 0, 2.0**-90]
    with pytest.raises(pypw85.PW85Error, match=r"row \(1,\): q1 must be positive definite, not \[1.0, 2.0, 1.0\]"):
        pypw85.nd_overlap([[1, 0], [1, 0]], [far, [1, 2, 1]], [far, [1, 0, 1]])


def test_pairs_without_numbers():
    """Lengths that are more than 2⁴⁰⁰ apart: no argument is wrong, and there is no distance."""
    with pytest.raises(pypw85.PW85Error, match="^nd_distance: the iterations did not converge$") as caught:
        pypw85.nd_distance([2.0**600, 0], np.eye(2), 2.0**-900 * np.eye(2))
    assert caught.value.status == pypw85.Status.ECONVERGENCE


def as_lists(x):
    """A vector as a tuple; a matrix as it is."""
    return tuple(x.tolist()) if x.ndim == 1 else x


def strided(x):
    wide = np.full(tuple(2 * k for k in x.shape), np.nan)
    wide[(slice(None, None, 2),) * x.ndim] = x
    return wide[(slice(None, None, 2),) * x.ndim]


@pytest.mark.parametrize("n", [1, 2, 5, 16])
def test_one_pair_is_a_row(n):
    """Calls for one pair take a shorter way: the values, types and shapes are those of a row of many."""
    rng = np.random.default_rng(n)
    functions = {
        pypw85.nd_contact: (), pypw85.nd_contact_geometry: (0.25,), pypw85.nd_overlap: (), pypw85.nd_compare: (1.5,),
        pypw85.nd_contains: (), pypw85.nd_containment: (), pypw85.nd_distance: (),
    }  # fmt: skip
    for scale in (0.1, 1, 9):
        r12, forms = scale * rng.normal(size=n), [random_form(rng, n, 5) for _ in range(2)]
        packed = [q[np.triu_indices(n)] for q in forms]
        for function, number in functions.items():
            rows = function(r12[np.newaxis], *packed, *number)
            expected = tuple(x[0] for x in rows) if isinstance(rows, tuple) else (rows[0],)
            for convert in (np.asarray, as_lists, strided, np.asfortranarray, lambda x: x.astype(object)):
                for given in (forms, packed):
                    found = function(convert(r12), *map(convert, given), *number)
                    assert type(found) is type(rows) or not isinstance(rows, tuple)
                    for one, other in zip(found if isinstance(found, tuple) else (found,), expected):
                        np.testing.assert_array_equal(one, other)
                        assert type(one) is type(other) and one.dtype == other.dtype


def test_what_is_not_one_plain_pair():
    """Numbers of other types give the same result; what is not a number is refused by the same errors as in rows."""
    eye = np.eye(2)
    for r12 in ([4, 0], (4.0, 0), np.array([4, 0]), np.ma.array([4.0, 0]), [np.float32(4), 0], [True * 4, False]):
        assert np.all(pypw85.nd_contact(r12, eye, eye)[0] == 4)
    masked = np.ma.array([4.0, 0], mask=[True, False])
    for r12, error, words in [
        (masked, PW85Error, "r12 must be finite"), ([10**400, 0], TypeError, "r12 must be real numbers"), (["4", "0"], TypeError, "real"),
        ([4, [0]], TypeError, "real"), ([], ValueError, "last dimension of 1 to 16"),
        ([0.0] * 17, ValueError, "last dimension of 1 to 16"), ("44", TypeError, "real"), ({4.0, 0.0}, TypeError, "real"),
    ]:  # fmt: skip
        with pytest.raises(error, match=words):
            pypw85.nd_contact(r12, eye, eye)
    with pytest.raises(ValueError, match="q1 must be symmetric"):
        pypw85.nd_contact([4, 0], [[1, 0.1], [0, 1]], eye)
    with pytest.raises(ValueError, match="q2 must be symmetric"):
        pypw85.nd_contact([4, 0], eye, np.array([[1, 0.1], [0, 1]]))
    with pytest.raises(TypeError, match="lambda_ must be real numbers"):
        pypw85.nd_contact_geometry([4, 0], eye, eye, "half")
    for arguments in ((), ("nd_contact",), ("nd_compare", eye, eye, eye), ("contact", eye, eye, eye), (1, 2, 3, 4)):
        with pytest.raises(TypeError, match="the name of a function and its arguments were expected"):
            pypw85._core.nd_one_pair(*arguments)
