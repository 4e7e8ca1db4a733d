# SPDX-License-Identifier: BSD-3-Clause
"""The names and semantics of the manual of pw85 1.0: results of the wrapper, and in-place outputs."""

import itertools

import numpy as np
import pytest

import pypw85
from pypw85 import legacy

RADII = (0.0199, 1.999, 9.999)
GOLDEN = (1 + 5**0.5) / 2
DIRECTIONS = [
    np.array(n) / np.sqrt(1 + GOLDEN**2)
    for sign1, sign2 in itertools.product((-1, 1), repeat=2)
    for n in ((0, sign1, sign2 * GOLDEN), (sign1, sign2 * GOLDEN, 0), (sign2 * GOLDEN, 0, sign1))
]
SPHEROIDS = [pypw85.spheroid(a, c, n) for a in RADII for c in RADII for n in DIRECTIONS[::3]]
U = 2.0**-53


def lower_triangle(l):
    full = np.zeros((3, 3))
    full.T[np.triu_indices(3)] = l
    return full


def is_same_or_new(result, out):
    return out is None or result is out


@pytest.mark.parametrize("in_place", [False, True])
def test_cholesky_decomp(in_place):
    expected = np.array([1.0, 2.0, -3.0, 4.0, 5.0, 6.0])
    factor = lower_triangle(expected)
    out = np.empty(6) if in_place else None
    actual = pypw85._cholesky_decomp(pypw85.packed(factor @ factor.T), out)
    assert is_same_or_new(actual, out)
    # Integers throughout: all operations are exact.
    np.testing.assert_array_equal(actual, expected)


@pytest.mark.parametrize("in_place", [False, True])
def test_cholesky_solve(in_place):
    l = np.array([1.0, 2.0, -4.0, 8.0, 16.0, 32.0])
    x = np.array([1.0, -2.0, 3.0])
    factor = lower_triangle(l)
    b = factor @ (factor.T @ x)
    out = np.empty(3) if in_place else None
    actual = pypw85._cholesky_solve(l, b, out)
    assert is_same_or_new(actual, out)
    # Diagonal entries are powers of two: all operations are exact.
    np.testing.assert_array_equal(actual, x)


def test_cholesky_solve_into_right_hand_side():
    b = np.array([4.0, 9.0, 16.0])
    assert pypw85._cholesky_solve([2, 0, 0, 3, 0, 4], b, b) is b
    np.testing.assert_array_equal(b, [1, 1, 1])


@pytest.mark.parametrize("in_place", [False, True])
@pytest.mark.parametrize("a, c", itertools.product(RADII, RADII))
def test_spheroid(a, c, in_place):
    for n in DIRECTIONS:
        out = np.empty(6) if in_place else None
        q = pypw85.spheroid(a, c, n, out)
        assert is_same_or_new(q, out)
        expected = a**2 * np.eye(3) + (c**2 - a**2) * np.outer(n, n)
        # An entry sums two terms no larger than the larger square, with some six roundings in either computation.
        assert np.abs(pypw85.full(q) - expected).max() <= 16 * U * max(a, c) ** 2, [x.hex() for x in (a, c, *n)]


def f_and_cond(lambda_, r12, q1, q2):
    """f, and the condition number by which its rounding error is judged."""
    full1, full2 = pypw85.full(q1), pypw85.full(q2)
    s = np.linalg.solve((1 - lambda_) * full1 + lambda_ * full2, r12)
    size = (1 - lambda_) * np.abs(full1) + lambda_ * np.abs(full2)
    value = lambda_ * (1 - lambda_) * (r12 @ s)
    terms = np.abs(s) @ size @ np.abs(s) + 2 * np.abs(r12) @ np.abs(s)
    return value, lambda_ * (1 - lambda_) * terms / value if value > 0 else 0.0


def test_f():
    for q1, q2 in itertools.product(SPHEROIDS[::5], SPHEROIDS[::7]):
        for lambda_ in (0.0, 0.1, 0.5, 0.9, 1.0):
            actual = pypw85.f(lambda_, DIRECTIONS[1], q1, q2)
            expected, cond = f_and_cond(lambda_, DIRECTIONS[1], q1, q2)
            # 4 u cond for the library; NumPy's solution with row exchanges may err by as much times a factor of about
            # 3 (n) of growth.
            assert abs(actual - expected) <= 16 * U * cond * abs(expected), [x.hex() for x in (lambda_, *q1, *q2)]


@pytest.mark.parametrize("function", [pypw85.contact_function, pypw85.contact])
@pytest.mark.parametrize("in_place", [False, True])
def test_contact_function(function, in_place):
    for q1, q2 in itertools.product(SPHEROIDS, SPHEROIDS[::3]):
        r12 = DIRECTIONS[2]
        out = np.empty(2) if in_place else None
        mu2, lambda_ = function(r12, q1, q2, out)
        if in_place:
            assert (out[0], out[1]) == (mu2, lambda_)
        value, cond = f_and_cond(lambda_, r12, q1, q2)
        assert 0 < lambda_ < 1
        # f is stationary at λ: its value there is μ² up to rounding.
        assert abs(value - mu2) <= 16 * U * cond * mu2, [x.hex() for x in (*r12, *q1, *q2)]
        # No other λ gives more.
        for other in (0.5 * lambda_, 0.5 * (1 + lambda_)):
            assert f_and_cond(other, r12, q1, q2)[0] < mu2


def test_contact_function_of_arrays_in_place(random_pairs):
    pairs = random_pairs(100)
    out = np.empty((100, 2))
    mu2, lambda_ = pypw85.contact_function(*pairs, out)
    expected = pypw85.contact_function(*pairs)
    np.testing.assert_array_equal(out, np.stack(expected, axis=-1))
    assert mu2.base is out and lambda_.base is out


# Integers below: all operations of the rational form are exact.
A = np.array([1, -2, 3, 4, 5, -6.0])
B = np.array([2, 3, -1, 5, 1, 7.0])
R = np.array([1, 2, -3.0])


def exact_determinant(a):
    m = pypw85.full(a)
    return np.dot(m[0], np.cross(m[1], m[2]))


def adjugate(a):
    m = pypw85.full(a)
    return np.array([np.cross(m[1], m[2]), np.cross(m[2], m[0]), np.cross(m[0], m[1])]).T


def blend(lambda_):
    return (1 - lambda_) * A + lambda_ * B


def test_det_sym():
    assert legacy._det_sym(A) == exact_determinant(A)


def test_xT_adjA_x():
    assert legacy._xT_adjA_x(R, A) == R @ adjugate(A) @ R


@pytest.mark.parametrize("in_place", [False, True])
@pytest.mark.parametrize("given", [False, True])
def test_detQ_as_poly(given, in_place):
    extra = (2 * A - B, 0.5 * (A + B)) if given else (None, None)
    out = np.empty(4) if in_place else None
    b = legacy._detQ_as_poly(A, B, *extra, out)
    assert is_same_or_new(b, out)
    for lambda_ in (0.0, 0.25, 0.5, 1.0, 2.0):
        # The coefficients come from four exact values, with a division by 3 in between.
        bound = 8 * U * np.abs(b) @ np.abs(lambda_) ** np.arange(4)
        assert abs(np.polyval(b[::-1], lambda_) - exact_determinant(blend(lambda_))) <= bound


@pytest.mark.parametrize("in_place", [False, True])
@pytest.mark.parametrize("given", [False, True])
def test_rT_adjQ_r_as_poly(given, in_place):
    out = np.empty(3) if in_place else None
    a = legacy._rT_adjQ_r_as_poly(R, A, B, 2 * A - B if given else None, out)
    assert is_same_or_new(a, out)
    for lambda_ in (0.0, 0.25, 0.5, 1.0, 2.0):
        bound = 8 * U * np.abs(a) @ np.abs(lambda_) ** np.arange(3)
        assert abs(np.polyval(a[::-1], lambda_) - R @ adjugate(blend(lambda_)) @ R) <= bound


def derivatives_of_f1(*args):
    out = np.empty(3)
    legacy.f1(*args, out)
    return out


@pytest.mark.parametrize(
    "f, size, derivatives", [(legacy.f1, 3, derivatives_of_f1), (legacy.f2, 1, legacy.f2_derivatives)]
)
def test_legacy_f(f, size, derivatives):
    q1, q2 = pypw85.spheroid(1, 2, [0, 0, 1]), pypw85.spheroid(3, 1, [1, 1, 0])
    r12 = np.array([1.0, 2.0, 3.0])
    for lambda_ in (0.1, 0.5, 0.8):
        written = np.empty(size)
        value = f(lambda_, r12, q1, q2, written)
        out = derivatives(lambda_, r12, q1, q2)
        assert value == written[0] == out[0] == f(lambda_, r12, q1, q2)
        with pytest.raises(ValueError, match=f"must be {size}"):
            f(lambda_, r12, q1, q2, np.empty(4 - size))
        assert value == pytest.approx(f_and_cond(lambda_, r12, q1, q2)[0], rel=1e-14)
        # Central differences: h² f'''/6 with h = 1e-4 and derivatives of the order of 100, against rounding u f/h.
        h = 1e-4
        before, after = f(lambda_ - h, r12, q1, q2), f(lambda_ + h, r12, q1, q2)
        assert out[1] == pytest.approx((after - before) / (2 * h), abs=1e-5)
        assert out[2] == pytest.approx((after - 2 * value + before) / h**2, abs=1e-4)


def test_legacy_f_of_arrays_in_place(random_pairs):
    pairs = random_pairs(10)
    out = np.empty((10, 3))
    value = legacy.f1(0.25, *pairs, out)
    np.testing.assert_array_equal(value, pypw85.f(0.25, *pairs))
    np.testing.assert_array_equal(value, out[:, 0])


@pytest.mark.parametrize("function", [legacy.contact_function1, legacy.contact_function2])
def test_legacy_contact_functions(function):
    q1, q2 = pypw85.spheroid(1, 1.5, [0, 0, 1]), pypw85.spheroid(1.5, 1, [1, 1, 0])
    out = np.empty(2)
    mu2, lambda_ = function([1.0, 2.0, 3.0], q1, q2, out)
    assert tuple(out) == (mu2, lambda_)
    expected = pypw85.contact([1.0, 2.0, 3.0], q1, q2)
    # Nearly round: the rational form is as good as any; λ is found by steps or halvings down to a small tolerance, of
    # which μ² sees the square.
    assert mu2 == pytest.approx(expected[0], rel=1e-12)
    assert lambda_ == pytest.approx(expected[1], abs=1e-5)
