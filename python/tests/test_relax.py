# SPDX-License-Identifier: BSD-3-Clause
"""The example that relaxes a packing: its gradient is that of its energy, and it leaves no overlap."""

import importlib.util
import os
from pathlib import Path

import numpy as np
import pytest

import pypw85

pytest.importorskip("scipy")


@pytest.fixture(scope="module")
def relax():
    path = Path(os.environ["PYPW85_SOURCE"]) / "examples" / "python" / "relax.py"
    spec = importlib.util.spec_from_file_location("relax", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_gradient(relax, rng):
    packing = relax.random_packing(8, 0.6, rng)
    x = 0.3 * rng.normal(size=48)
    x[24:27] = 0  # an ellipsoid that is not turned
    gradient, h = packing.energy(x)[1], 1e-5
    for k in range(len(x)):
        step = h * np.eye(len(x))[k]
        difference = (packing.energy(x + step)[0] - packing.energy(x - step)[0]) / (2 * h)
        # (1-μ)² has a third derivative; h² of it, and 1e-16/h of rounding, times the sum of some ten pairs.
        assert abs(gradient[k] - difference) <= 1e-7


def test_no_overlap_is_left(relax, capfd):
    relax.main(64, 0.6, 1)
    assert capfd.readouterr().out.splitlines()[-1] == "overlaps when relaxed: 0"


def test_overlaps_are_those_of_all_images(relax, rng):
    packing = relax.random_packing(5, 0.5, rng)
    q = pypw85.ellipsoid_quaternion(packing.semi_axes, packing.quaternions)
    shifts = np.stack(np.meshgrid(*[np.arange(-2, 3)] * 3), axis=-1).reshape(-1, 3)
    count = 0
    for i in range(5):
        for j in range(i, 5):
            r12 = packing.centers[j] - packing.centers[i] + (shifts @ packing.cell)
            found = pypw85.overlap(r12, q[i], q[j])
            count += found.sum() if i < j else (found.sum() - 1) // 2
    assert packing.overlaps()[0] == count
