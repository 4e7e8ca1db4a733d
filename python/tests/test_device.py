# SPDX-License-Identifier: BSD-3-Clause
"""Arrays on a GPU, by the driver of the tests: its memory is that of this process."""

import ctypes

import numpy as np
import pytest

import pypw85

try:
    DRIVER = ctypes.CDLL("libcuda.so.1")
    _ = DRIVER.fake_hold
except (OSError, AttributeError):
    pytest.skip("there is no driver of the tests", allow_module_level=True)

# As of a library: what `_device` makes results with.
float64, uint8 = np.float64, np.uint8


class Array:
    """An array on the device, contiguous unless `strides` say otherwise, in the order of the default stream."""

    def __init__(self, shape, dtype, stream=1, strides=None):
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


class Handed:
    """An array of a library that hands its arrays over by DLPack, and takes others: itself."""

    def __init__(self, producer):
        assert producer.__dlpack_device__() == (2, 0)
        capsule = producer.__dlpack__(stream=77)
        self.address, self.shape, strides, kind = pypw85._core.dlpack_view(capsule)
        assert strides is None
        # The capsule gives the memory back unless somebody takes it out.
        self.dtype, self.capsule, self.streams = np.dtype(kind), capsule, []

    @staticmethod
    def __array_namespace__():
        return Library

    @staticmethod
    def __dlpack_device__():
        return (2, 0)

    def __dlpack__(self, *, stream=None):
        self.streams.append(stream)
        return self.capsule

    view, host = Array.view, Array.host
    size = property(lambda self: int(np.prod(self.shape)) * self.dtype.itemsize)

    def __ne__(self, number):
        return self.host() != number


class Library:
    """What JAX has: an `empty` whose arrays cannot be filled, too."""

    from_dlpack = Handed

    @staticmethod
    def empty(shape, dtype):
        raise AssertionError("arrays that cannot be filled")


def handed(values):
    values = np.ascontiguousarray(values)
    array = pypw85._device.DeviceArray(values.shape, values.dtype)
    taken = Handed(array)
    taken.view()[...] = values
    return taken


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
    with pytest.raises(ValueError, match="must belong to one stream"):
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
    with pytest.raises(TypeError, match="out, which follows"):
        pypw85.contact(r12, q1, q2, out=(device(np.zeros(500)), device(np.zeros(500))))
    with pytest.raises(TypeError, match="must be on the host"):
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
    assert "GPU" in str(error.value)


def test_dlpack(pairs):
    arrays = [handed(x) for x in pairs]
    results = pypw85.contact(*arrays)
    assert [x.streams for x in arrays] == [[1]] * 3
    for result, expected, tolerance in zip(results, pypw85.contact(*pairs), (1e-12, 1e-6)):
        assert type(result) is Handed and result.dtype == np.float64
        # They are there: nobody waited since.
        data = (ctypes.c_char * result.size).from_address(result.address)
        np.testing.assert_allclose(np.frombuffer(data), expected, rtol=tolerance)
    overlap = pypw85.overlap(*pairs)
    codes = pypw85.overlap(*arrays, dtype=np.uint8)
    assert codes.dtype == np.uint8
    np.testing.assert_array_equal(codes.host(), overlap)
    np.testing.assert_array_equal(pypw85.overlap(*arrays), overlap)
    normal = pypw85.contact_derivatives(*(handed(x.reshape(20, 25, -1)) for x in pairs)).normal
    assert normal.shape == (20, 25, 3)
    index = np.array([[0, 1], [2, 3]], dtype=np.int32)
    mu2, _ = pypw85.contact_pairs(device(index), *map(handed, pairs[:2]))
    np.testing.assert_allclose(mu2.host(), pypw85.contact_pairs(index, *pairs[:2])[0], rtol=1e-12)


def test_dlpack_on_a_stream(pairs):
    stream = ctypes.c_void_p()
    assert DRIVER.cuStreamCreate(ctypes.byref(stream), 1) == 0
    r12, q1, q2 = device(pairs[0], stream=stream.value), *map(handed, pairs[1:])
    mu2, _ = pypw85.contact(r12, q1, q2)
    assert q1.streams == [stream.value]
    assert DRIVER.cuStreamSynchronize(stream) == 0
    np.testing.assert_allclose(mu2.host(), pypw85.contact(*pairs)[0], rtol=1e-12)
    assert DRIVER.cuStreamDestroy_v2(stream) == 0


def blocks():
    """Those that are not given back, once what was queued before is done."""
    assert DRIVER.cuStreamSynchronize(None) == 0
    return DRIVER.fake_blocks()


def test_memory_of_dlpack(pairs):
    arrays = [handed(x) for x in pairs]
    pypw85.contact(*arrays)
    before = blocks()
    for _ in range(3):
        pypw85.contact(*arrays)
    assert blocks() == before
    result = pypw85.contact(*arrays)
    assert blocks() == before + 2
    del result
    assert blocks() == before


class Plain:
    """An array of a library that makes none and says no stream, as those of Numba."""

    def __init__(self, array):
        self.array = array

    @property
    def __cuda_array_interface__(self):
        return {**self.array.__cuda_array_interface__, "stream": None}


def test_library_without_arrays(pairs, monkeypatch):
    monkeypatch.delattr("test_device.empty", raising=False)
    monkeypatch.setattr(Plain, "__module__", "math.arrays")
    arrays = [Plain(device(x)) for x in pairs]
    mu2, _ = pypw85.contact(*arrays)
    interface = mu2.__cuda_array_interface__
    assert interface["shape"] == (500,) and interface["typestr"] == "<f8"
    data = (ctypes.c_double * 500).from_address(interface["data"][0])
    np.testing.assert_allclose(np.frombuffer(data), pypw85.contact(*pairs)[0], rtol=1e-12)
    codes = pypw85.overlap(*arrays, dtype=np.uint8)
    assert Handed(codes).host().tolist() == pypw85.overlap(*pairs).tolist()
    with pytest.raises(TypeError, match="uint8"):
        pypw85.overlap(*arrays)
    with pytest.raises(BufferError):
        mu2.__dlpack__(copy=True)
    with pytest.raises(BufferError):
        mu2.__dlpack__(dl_device=(1, 0))


def test_strides():
    """Those of a dimension of one row say nothing, nor those of an array without numbers."""
    row = device(np.array([[3.0, 0.0, 0.0]]), strides=(8, 8))
    q = device(np.array([[1.0, 0.0, 0.0, 1.0, 0.0, 1.0]]), strides=(-1, 8))
    assert pypw85.contact(row, q, q)[0].host() == pytest.approx(2.25)
    none = device(np.zeros((0, 3)), strides=(7, 7)), device(np.zeros((0, 6))), device(np.zeros((0, 6)))
    assert pypw85.contact(*none)[0].shape == (0,)


def test_no_memory_for_results(pairs):
    arrays = [handed(x) for x in pairs]
    setenv = ctypes.CDLL(None).setenv
    setenv(b"PW85_FAKE_DRIVER", b"no_memory", 1)
    try:
        with pytest.raises(pypw85.PW85Error, match="no usable GPU, or not enough GPU memory"):
            pypw85.contact(*arrays)
    finally:
        ctypes.CDLL(None).unsetenv(b"PW85_FAKE_DRIVER")


def test_taken_capsule():
    """Who takes the tensor renames the capsule, and destroys the tensor in the end."""

    class Managed(ctypes.Structure):
        _fields_ = [("tensor", ctypes.c_char * 48), ("owner", ctypes.c_void_p), ("destroy", ctypes.CFUNCTYPE(None, ctypes.c_void_p))]

    python = ctypes.pythonapi
    python.PyCapsule_GetPointer.restype = ctypes.c_void_p
    before = blocks()
    array = pypw85._device.DeviceArray((3,), "float64")
    capsule = array.__dlpack__()
    pointer = python.PyCapsule_GetPointer(ctypes.py_object(capsule), b"dltensor")
    name = b"used_dltensor"
    assert python.PyCapsule_SetName(ctypes.py_object(capsule), name) == 0
    with pytest.raises(ValueError):
        pypw85._core.dlpack_view(capsule)
    del array, capsule
    assert blocks() == before + 1
    Managed.from_address(pointer).destroy(pointer)
    assert blocks() == before
