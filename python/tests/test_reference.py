# SPDX-License-Identifier: BSD-3-Clause
"""The compiled functions against the reference data: every value passes through Python unharmed."""

import os

import h5py
import numpy as np
import pytest

import pypw85
from pypw85 import legacy

U = 2.0**-53


@pytest.fixture(scope="module")
def data():
    with h5py.File(os.environ["PYPW85_REFERENCE_DATA"]) as file:
        yield file


@pytest.fixture(scope="module")
def pairs(data):
    return {name: data["contact"][name][...] for name in ("r12", "q1", "q2", "mu2", "mu2_minus_1", "cond", "lambda")}


@pytest.mark.parametrize("function", [pypw85.contact, pypw85.contact_function])
def test_contact(pairs, function, assert_rows):
    mu2, lambda_ = function(pairs["r12"], pairs["q1"], pairs["q2"])
    # The bound that the library states for both.
    error = np.abs(mu2 - pairs["mu2"]) / pairs["mu2"]
    assert_rows(error <= 4 * U * pairs["cond"], pairs["r12"], pairs["q1"], pairs["q2"], mu2, pairs["mu2"])
    assert ((0 <= lambda_) & (lambda_ <= 1)).all()


def test_overlap(pairs, assert_rows):
    overlap = pypw85.overlap(pairs["r12"], pairs["q1"], pairs["q2"])
    assert overlap.dtype == np.bool_
    assert_rows(overlap == (pairs["mu2_minus_1"] < 0), pairs["r12"], pairs["q1"], pairs["q2"])


def test_f(data):
    q, r12, lambdas = data["spheroids"][...], data["directions"][...], data["lambdas"][...]
    some = slice(None, None, 9)
    actual = legacy.f1(lambdas, r12[some, None, :], q[some, None, None, None, :], q[some, None, None, :])
    expected = data["F"][some, some, some, :]
    # Aspect ratios up to 500 and nothing worse than u times their square, with a factor of 100 for a dozen operations.
    np.testing.assert_allclose(actual, expected, rtol=100 * U * 503**2, atol=0)
    np.testing.assert_array_equal(actual, pypw85.f(lambdas, r12[some, None, :], q[some, None, None, None, :],
                                                   q[some, None, None, :]))
