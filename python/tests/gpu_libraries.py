# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of CuPy, PyTorch, Numba and JAX on a real GPU: scripts/test_gpu.sh runs this with the libraries that are there.

    python3 -m pytest python/tests/gpu_libraries.py
"""

import importlib

import numpy as np
import pytest

import pypw85


class CuPy:
    def __init__(self):
        self.cupy = importlib.import_module("cupy")
        self.cupy.cuda.runtime.getDevice()

    def device(self, array):
        return self.cupy.asarray(array)

    def host(self, array):
        assert isinstance(array, self.cupy.ndarray)
        return array.get()

    def in_another_stream(self):
        return self.cupy.cuda.Stream(non_blocking=True)


class PyTorch:
    def __init__(self):
        self.torch = importlib.import_module("torch")
        self.torch.zeros(1, device="cuda")

    def device(self, array):
        return self.torch.tensor(array, device="cuda")

    def host(self, array):
        assert isinstance(array, self.torch.Tensor) and array.is_cuda
        return array.cpu().numpy()

    def in_another_stream(self):
        return self.torch.cuda.stream(self.torch.cuda.Stream())


class Numba:
    def __init__(self):
        self.cuda = importlib.import_module("numba.cuda")
        self.cuda.current_context()

    def device(self, array):
        return self.cuda.to_device(array)

    def host(self, array):
        return self.cuda.as_cuda_array(array).copy_to_host()

    in_another_stream = None


class Jax:
    def __init__(self):
        jax = importlib.import_module("jax")
        jax.config.update("jax_enable_x64", True)
        self.jax, self.gpu = jax, jax.devices("gpu")[0]

    def device(self, array):
        return self.jax.device_put(array, self.gpu)

    def host(self, array):
        assert isinstance(array, self.jax.Array)
        return np.asarray(array)

    in_another_stream = None


@pytest.fixture(scope="module", params=[CuPy, PyTorch, Numba, Jax])
def library(request):
    try:
        return request.param()
    except Exception as reason:  # each library has its own for no device
        pytest.skip(f"{request.param.__name__}: {reason}")


@pytest.fixture(scope="module")
def pairs():
    random = np.random.default_rng(5)
    r12 = random.normal(size=(5000, 3)) * 2
    forms = [pypw85.ellipsoid_quaternion(random.uniform(0.5, 3, (5000, 3)), random.normal(size=(5000, 4))) for _ in range(2)]
    return r12, *forms


def check_contact(library, pairs, result):
    for actual, expected, tolerance in zip(result, pypw85.contact(*pairs), (1e-12, 1e-6)):
        np.testing.assert_allclose(library.host(actual), expected, rtol=tolerance)


def test_contact(library, pairs):
    check_contact(library, pairs, pypw85.contact(*map(library.device, pairs)))


def test_overlap(library, pairs):
    arrays = [library.device(x) for x in pairs]
    codes = library.host(pypw85.overlap(*arrays, dtype=np.uint8))
    np.testing.assert_array_equal(codes, pypw85.overlap(*pairs, dtype=np.uint8))
    assert 0 < codes.sum() < len(codes)


# Spheres that touch: the device leaves the exact test to the host, in the order of the stream.
def test_tangent(library):
    n = 10000
    r12 = np.zeros((n, 3))
    r12[:, 0] = 2 + np.arange(n) % 3 * 2.0**-51 - 2.0**-51
    q = np.tile([1.0, 0, 0, 1, 0, 1], (n, 1))
    codes = library.host(pypw85.overlap(*map(library.device, (r12, q, q)), dtype=np.uint8))
    np.testing.assert_array_equal(codes, r12[:, 0] < 2)


def test_derivatives(library, pairs):
    result = pypw85.contact_derivatives(*map(library.device, pairs))
    for actual, expected in zip(result, pypw85.contact_derivatives(*pairs)):
        np.testing.assert_allclose(library.host(actual), expected, rtol=1e-6, atol=1e-6)


def test_bad_rows(library, pairs):
    bad = [x.copy() for x in pairs]
    bad[0][7], bad[1][8, 0], bad[2][9] = np.nan, -1, 0
    mu2, _ = pypw85.contact(*map(library.device, bad))
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(library.host(mu2))), [7, 8, 9])
    codes = library.host(pypw85.overlap(*map(library.device, bad), dtype=np.uint8))
    np.testing.assert_array_equal(np.flatnonzero(codes == 255), [7, 8, 9])


def test_lists(library, pairs):
    random = np.random.default_rng(6)
    index = random.integers(0, 5000, size=(20000, 2)).astype(np.int32)
    centers, cell = np.round(random.uniform(-9, 9, size=(5000, 3)) * 2**20) / 2**20, 18.0 * np.eye(3)
    arrays = [library.device(x) for x in (index, centers, pairs[1])]
    mu2, _ = pypw85.contact_pairs(*arrays, cell)
    expected = pypw85.contact_pairs(index, centers, pairs[1], cell)[0]
    np.testing.assert_allclose(library.host(mu2), expected, rtol=1e-12)


# What a stream of the library computes just before is what the functions see.
def test_streams(library, pairs):
    if library.in_another_stream is None:
        pytest.skip("its arrays name no stream")
    for _ in range(20):
        with library.in_another_stream():
            arrays = [library.device(x) for x in pairs]
            for _ in range(10):
                arrays[0] = arrays[0] * 2.0
            arrays[0] = arrays[0] * 2.0**-10
            check_contact(library, pairs, pypw85.contact(*arrays))
