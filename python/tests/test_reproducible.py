# SPDX-License-Identifier: BSD-3-Clause
"""The reproducible mode: it can be switched, and set from the environment."""

import os
import subprocess
import sys

import numpy as np
import pypw85
import pytest

PAIRS = 1000


@pytest.fixture
def pairs():
    random = np.random.default_rng(85)
    q1, q2 = (pypw85.ellipsoid_quaternion(random.uniform(0.1, 1, (PAIRS, 3)), random.normal(size=(PAIRS, 4))) for _ in range(2))
    return random.normal(size=(PAIRS, 3)), q1, q2


def test_mode_switches(pairs):
    usual = pypw85.contact(*pairs)
    pypw85.set_reproducible(True)
    try:
        assert pypw85.is_reproducible() is True
        rows = [pypw85.contact(*row) for row in zip(*pairs)]
        np.testing.assert_array_equal(pypw85.contact_function(*pairs), np.transpose(rows))
    finally:
        pypw85.set_reproducible(False)
    assert pypw85.is_reproducible() is False
    np.testing.assert_array_equal(pypw85.contact(*pairs), usual)


@pytest.mark.parametrize("value, on", [("1", True), ("0", False), ("", False)])
def test_environment(value, on):
    code = "import pypw85; print(pypw85.is_reproducible())"
    done = subprocess.run([sys.executable, "-c", code], env={**os.environ, "PW85_REPRODUCIBLE": value}, check=True,
                          text=True, stdout=subprocess.PIPE)
    assert done.stdout.strip() == str(on)
