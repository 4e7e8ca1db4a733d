"""Arrays on a GPU, by the driver of the tests: its memory is that of this process."""

import ctypes

import numpy as np
import pytest

import pypw85

try:
    DRIVER = ctypes.CDLL("libcuda.so.1")
    DRIVER.fake_hold
except (OSError, AttributeError):
    pytest.skip("there is no driver of the tests", allow_module_level=True)

# As of a library: what `_device` makes results with.
float64, uint8 = np.float64, np.uint8


class Array:
    """An array on the device, contiguous unless `strides` say otherwise."""

    def __init__(self, shape, dtype, stream=None, strides=None):
        self.shape, self.dtype, self.stream, self.strides = shape, np.dtype(dtype), stream, strides
        self.size = int(np.prod(shape)) * self.dtype.itemsize
        address = ctypes.c_uint64()
        assert DRIVER.cuMemAllocAsync(ctypes.byref(address), ctypes.c_size_t(max(self.size, 1)), None) == 0
        self.address = address.value

    def __del__(self):
        DRIVER.cuMemFreeAsync(ctypes.c_uint64(self.address), None)

    @property
    def __cuda_array_interface__(self):
        return {"shape": self.shape, "typestr": self.dtype.str, "data": (self.address, False), "version": 3,
                "strides": self.strides, "stream": self.stream}

    def view(self):
        """The numbers, once the device is done."""
        assert DRIVER.cuStreamSynchronize(None) == 0
        data = (ctypes.c_char * self.size).from_address(self.address)
        return np.frombuffer(data, dtype=self.dtype).reshape(self.shape)

    def host(self):
        return self.view().copy()

    def __ne__(self, number):
        return device(self.host() != number)

    def __array__(self, *args, **kwargs):
        raise AssertionError("a copy to the host")


def empty(shape, dtype):
    return Array(shape, dtype)


def device(values, **options):
    values = np.ascontiguousarray(values)
    array = Array(values.shape, values.dtype, **options)
    array.view()[...] = values
    return array


@pytest.fixture
def pairs():
    random = np.random.default_rng(1)
    r12 = random.normal(size=(500, 3)) * 2
    q = [pypw85.ellipsoid_quaternion(random.uniform(0.5, 3, 3), random.normal(size=4)) for _ in range(1000)]
    return r12, np.array(q[:500]), np.array(q[500:])


def test_contact(pairs):
    mu2, lambda_ = pypw85.contact(*map(device, pairs))
    expected = pypw85.contact(*pairs)
    assert isinstance(mu2, Array) and mu2.shape == (500,)
    np.testing.assert_allclose(mu2.host(), expected[0], rtol=1e-12)
    np.testing.assert_allclose(lambda_.host(), expected[1], rtol=1e-6)


def test_shapes(pairs):
    shaped = [device(x.reshape(20, 25, -1)) for x in pairs]
    assert pypw85.contact(*shaped)[0].shape == (20, 25)
    derivatives = pypw85.contact_derivatives(*shaped)
    assert derivatives.normal.shape == (20, 25, 3)
    np.testing.assert_array_equal(derivatives.mu2.host(), pypw85.contact(*shaped)[0].host())
    assert pypw85.contact(*(device(x[:0]) for x in pairs))[0].shape == (0,)


def test_overlap(pairs):
    pairs[0][7] = np.nan
    with np.errstate(invalid="ignore"):
        expected = pypw85.overlap(*pairs, dtype=np.uint8)
    codes = pypw85.overlap(*map(device, pairs), dtype=np.uint8)
    np.testing.assert_array_equal(codes.host(), expected)
    assert codes.host()[7] == 255
    np.testing.assert_array_equal(pypw85.overlap(*map(device, pairs)).host(), expected != 0)


def test_derivatives(pairs):
    result = pypw85.contact_derivatives(*map(device, pairs))
    assert isinstance(result, pypw85.ContactDerivatives)
    for column, expected in zip(result, pypw85.contact_derivatives(*pairs)):
        np.testing.assert_allclose(column.host(), expected, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("images", [False, True])
def test_lists(pairs, images):
    random = np.random.default_rng(2)
    index = random.integers(0, 500, size=(800, 2)).astype(np.int32)
    cell, q = 8.0 * np.eye(3), pairs[1]
    centers = np.round(random.uniform(-4, 4, size=(500, 3)) * 2**20) / 2**20
    multiples = random.integers(-1, 2, size=(800, 3)).astype(np.int32) if images else None
    on_device = (device(index), device(centers), device(q), cell)
    keywords = {"images": device(multiples) if images else None}
    expected = pypw85.contact_pairs(index, centers, q, cell, images=multiples)
    np.testing.assert_allclose(pypw85.contact_pairs(*on_device, **keywords)[0].host(), expected[0], rtol=1e-12)
    np.testing.assert_array_equal(pypw85.overlap_pairs(*on_device, **keywords).host(),
                                  pypw85.overlap_pairs(index, centers, q, cell, images=multiples))
    derivatives = pypw85.contact_derivatives_pairs(*on_device, **keywords)
    np.testing.assert_allclose(derivatives.mu2.host(), expected[0], rtol=1e-12)


def test_streams(pairs):
    stream = ctypes.c_void_p()
    assert DRIVER.cuStreamCreate(ctypes.byref(stream), 1) == 0
    arrays = [device(x, stream=stream.value) for x in pairs]
    mu2, _ = pypw85.contact(*arrays)
    assert DRIVER.cuStreamSynchronize(stream) == 0
    np.testing.assert_allclose(mu2.host(), pypw85.contact(*pairs)[0], rtol=1e-12)
    arrays[1].stream = stream.value + 8
    with pytest.raises(ValueError, match="different streams"):
        pypw85.contact(*arrays)
    assert DRIVER.cuStreamDestroy_v2(stream) == 0


def test_refused(pairs):
    r12, q1, q2 = map(device, pairs)
    for bad, error in [((r12, q1, pairs[2]), TypeError), ((r12, q1, device(pairs[2][:7])), ValueError),
                       ((q1, q1, q2), ValueError), ((r12, q1, device(pairs[2].astype(np.float32))), TypeError),
                       ((r12, q1, device(pairs[2], strides=(8, 8))), ValueError)]:
        with pytest.raises(error):
            pypw85.contact(*bad)
    with pytest.raises(TypeError, match="casting"):
        pypw85.contact(r12, q1, q2, casting="no")
    with pytest.raises(TypeError, match="no such function"):
        pypw85.closest_approach(r12, q1, q2)
    index = device(np.zeros((4, 2), dtype=np.int32))
    for bad in [(index, device(pairs[0][:7]), q2), (index, r12, q2, np.eye(3), None, device(np.zeros((3, 3), dtype=np.int32)))]:
        with pytest.raises(ValueError):
            pypw85.contact_pairs(*bad)
    with pytest.raises(TypeError):
        pypw85.contact_pairs(device(np.zeros((4, 2))), r12, q2)
    with pytest.raises(pypw85.PW85Error, match="invalid argument"):
        pypw85.contact_pairs(index, r12, q2, np.zeros((3, 3)))


def test_no_memory(pairs, monkeypatch):
    arrays = [device(x) for x in pairs]
    outputs = [Array((500,), np.float64) for _ in range(2)]
    monkeypatch.setattr("pypw85._device._outputs", lambda *_: tuple(outputs))
    setenv = ctypes.CDLL(None).setenv
    setenv(b"PW85_FAKE_DRIVER", b"no_memory", 1)
    try:
        with pytest.raises(pypw85.PW85Error) as error:
            pypw85.contact(*arrays)
    finally:
        ctypes.CDLL(None).unsetenv(b"PW85_FAKE_DRIVER")
    assert error.value.status == pypw85.Status.EDEVICE
    assert "graphics processor" in str(error.value)
