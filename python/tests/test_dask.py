"""Dask arrays, chunk by chunk, without code of ours beyond the declaration of the outputs."""

import numpy as np
import pytest

import pypw85
from pypw85 import gufuncs

da = pytest.importorskip("dask.array")


@pytest.fixture
def chunked(random_pairs):
    pairs = random_pairs(1000)
    return pairs, [da.from_array(x, chunks=(100, -1)) for x in pairs]


def test_contact(chunked):
    pairs, arrays = chunked
    mu2, lambda_ = pypw85.contact(*arrays)
    assert isinstance(mu2, da.Array) and mu2.chunks == ((100,) * 10,)
    np.testing.assert_array_equal(da.compute(mu2, lambda_, scheduler="threads"), pypw85.contact(*pairs))


def test_outputs_with_sizes_of_their_own(chunked):
    pairs, arrays = chunked
    np.testing.assert_array_equal(pypw85.contact_gradient(*arrays, 0.5)[1].compute(),
                                  pypw85.contact_gradient(*pairs, 0.5)[1])
    q = pypw85.ellipsoid_quaternion(da.ones((10, 3), chunks=(5, 3)), da.ones((10, 4), chunks=(5, 4)))
    assert q.shape == (10, 6)
    np.testing.assert_allclose(q.compute(), np.tile([1, 0, 0, 1, 0, 1], (10, 1)), atol=1e-15)


def test_truth_values(chunked):
    pairs, arrays = chunked
    overlap = pypw85.overlap(*arrays)
    assert overlap.dtype == np.bool_
    np.testing.assert_array_equal(overlap.compute(), pypw85.overlap(*pairs))


def test_mixed_with_numpy(chunked):
    pairs, arrays = chunked
    mu2, _ = pypw85.contact(arrays[0], pairs[1][0], pairs[2][0])
    np.testing.assert_array_equal(mu2.compute(), pypw85.contact(pairs[0], pairs[1][0], pairs[2][0])[0])


def test_apply_gufunc(chunked):
    pairs, arrays = chunked
    ufunc = gufuncs.closest_approach
    distance = da.apply_gufunc(ufunc, ufunc.signature, *arrays, output_dtypes=float)
    np.testing.assert_array_equal(distance.compute(), pypw85.closest_approach(*pairs))
