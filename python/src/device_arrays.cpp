// SPDX-License-Identifier: BSD-3-Clause
// Arrays on a GPU that are handed from library to library by DLPack, and memory there for new ones.
#include <cstdint>
#include <new>

#include "../../src/gpu/driver.hpp"
#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

using pw85::detail::gpu::Address;
using pw85::detail::gpu::Context;
using pw85::detail::gpu::Driver;
using pw85::detail::gpu::Handle;

// DLPack's interface, as far as it is used here (dlpack.h).
constexpr std::int32_t cuda_device = 2;

struct Tensor {
    void *data;
    std::int32_t device_type, device;
    std::int32_t num_dimensions;
    std::uint8_t type_code, type_bits;
    std::uint16_t type_lanes;
    std::int64_t *shape, *strides;
    std::uint64_t byte_offset;
};

struct ManagedTensor {
    Tensor tensor;
    void *owner;
    void (*destroy)(ManagedTensor *);
};

constexpr char const *tensor_name = "dltensor", *memory_name = "pypw85.device_memory";
constexpr char type_letters[] = {'i', 'u', 'f'};

/// Numbers times a factor.
Reference tuple_of(std::int64_t const *numbers, std::int32_t size, std::int64_t factor)
{
    Reference tuple(PyTuple_New(size));
    for (std::int32_t d = 0; tuple && d < size; ++d) {
        PyObject *const number = PyLong_FromLongLong(numbers[d] * factor);
        if (number == nullptr) return nullptr;
        PyTuple_SET_ITEM(tuple.get(), d, number);
    }
    return tuple;
}

/// As NumPy writes it; V is one that it does not have.
Reference type_of(Tensor const &x)
{
    bool const known = x.type_lanes == 1 && x.type_code < sizeof type_letters;
    return Reference(PyUnicode_FromFormat("%c%c%d", x.type_bits == 8 ? '|' : '<',
                                          known ? type_letters[x.type_code] : 'V',
                                          x.type_bits / 8));
}

/// A shape with room for it, and its owner.
struct Export {
    static constexpr Py_ssize_t most = 16;
    ManagedTensor managed;
    std::int64_t shape[most];
};

void destroy_export(ManagedTensor *managed)
{
    PyGILState_STATE const state = PyGILState_Ensure();
    Py_DECREF(static_cast<PyObject *>(managed->owner));
    delete reinterpret_cast<Export *>(managed);
    PyGILState_Release(state);
}

/// Who takes a tensor gives its capsule another name.
void destroy_capsule(PyObject *capsule)
{
    if (!PyCapsule_IsValid(capsule, tensor_name)) return;
    auto *const managed = static_cast<ManagedTensor *>(PyCapsule_GetPointer(capsule, tensor_name));
    managed->destroy(managed);
}

void release(PyObject *capsule)
{
    Driver const *const driver = pw85::detail::gpu::driver();
    Context const context(driver);
    driver->release(reinterpret_cast<Address>(PyCapsule_GetPointer(capsule, memory_name)), nullptr);
}

/// Memory that work of any stream may use; 0 if there is none.
Address allocate(std::size_t size, int &device)
{
    Driver const *const driver = pw85::detail::gpu::driver();
    Context const context(driver);
    Address address = 0;
    if (context.handle() == nullptr || driver->current_device(&device) != 0) return 0;
    if (driver->allocate(&address, size, nullptr) != 0) return 0;
    return driver->synchronize(nullptr) == 0 ? address : 0;
}

bool read_shape(PyObject *shape, Export &e)
{
    e.managed.tensor.num_dimensions = static_cast<std::int32_t>(PyTuple_GET_SIZE(shape));
    for (Py_ssize_t d = 0; d < PyTuple_GET_SIZE(shape); ++d)
        e.shape[d] = PyLong_AsLongLong(PyTuple_GET_ITEM(shape, d));
    return PyErr_Occurred() == nullptr;
}

} // namespace

PyObject *dlpack_view(PyObject *, PyObject *capsule)
{
    auto const *const managed =
        static_cast<ManagedTensor *>(PyCapsule_GetPointer(capsule, tensor_name));
    if (managed == nullptr) return nullptr;
    Tensor const &x = managed->tensor;
    Reference const shape = tuple_of(x.shape, x.num_dimensions, 1);
    Reference const strides = x.strides == nullptr
                                  ? Reference(Py_NewRef(Py_None))
                                  : tuple_of(x.strides, x.num_dimensions, x.type_bits / 8);
    Reference const type = type_of(x);
    if (!shape || !strides || !type) return nullptr;
    return Py_BuildValue(
        "KOOO", static_cast<unsigned long long>(reinterpret_cast<Address>(x.data) + x.byte_offset),
        shape.get(), strides.get(), type.get());
}

PyObject *dlpack_export(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    if (!right_number(nargs, 5)) return nullptr;
    auto *const made = new (std::nothrow) Export{};
    if (made == nullptr) return PyErr_NoMemory();
    Tensor &x = made->managed.tensor;
    x.data = PyLong_AsVoidPtr(args[1]);
    x.device_type = cuda_device;
    x.device = static_cast<std::int32_t>(PyLong_AsLong(args[2]));
    x.type_bits = static_cast<std::uint8_t>(8 * PyLong_AsLong(args[4]));
    x.type_code = x.type_bits == 8 ? 1 : 2;
    x.type_lanes = 1;
    x.shape = made->shape;
    made->managed.owner = args[0];
    made->managed.destroy = destroy_export;
    bool const fits = PyTuple_Check(args[3]) && PyTuple_GET_SIZE(args[3]) <= Export::most;
    if (!fits) PyErr_SetString(PyExc_TypeError, "the shape must be a tuple of up to 16 numbers");
    PyObject *const capsule = fits && read_shape(args[3], *made)
                                  ? PyCapsule_New(&made->managed, tensor_name, destroy_capsule)
                                  : nullptr;
    if (capsule == nullptr)
        delete made;
    else
        Py_INCREF(args[0]);
    return capsule;
}

PyObject *device_memory(PyObject *, PyObject *size)
{
    std::size_t const bytes = PyLong_AsSize_t(size);
    if (PyErr_Occurred() != nullptr) return nullptr;
    int device = 0;
    Address const address = allocate(bytes, device);
    if (address == 0) Py_RETURN_NONE;
    Reference const capsule(PyCapsule_New(reinterpret_cast<void *>(address), memory_name, release));
    if (!capsule) return nullptr;
    return Py_BuildValue("OKi", capsule.get(), static_cast<unsigned long long>(address), device);
}

PyObject *device_wait(PyObject *, PyObject *stream)
{
    Handle const handle = PyLong_AsVoidPtr(stream);
    if (PyErr_Occurred() != nullptr) return nullptr;
    Driver const *const driver = pw85::detail::gpu::driver();
    bool done;
    Py_BEGIN_ALLOW_THREADS;
    Context const context(driver);
    done = context.handle() != nullptr && driver->synchronize(handle) == 0;
    Py_END_ALLOW_THREADS;
    return PyBool_FromLong(done);
}

} // namespace pypw85
