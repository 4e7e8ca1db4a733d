// SPDX-License-Identifier: BSD-3-Clause
// Neighbour lists. The Python layer converts and explains; what would read or write beyond an array
// is refused here.
#include <cstdint>

#include <pw85.h>
#include <pw85_systems.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

constexpr char const *capsule_name = "pw85_neighbors";

pw85_neighbors *list_of(PyObject *capsule)
{
    return static_cast<pw85_neighbors *>(PyCapsule_GetPointer(capsule, capsule_name));
}

void destroy(PyObject *capsule) { pw85_neighbors_destroy(list_of(capsule)); }

/// Reads the arguments centers, q, cell or None, periodic: three numbers.
bool read_system(PyObject *const *args, pw85_system &system)
{
    npy_intp n = -1, three = 3;
    system.centers = static_cast<double const *>(data_of(args[0], NPY_DOUBLE, n, PW85_DIM, false));
    if (system.centers == nullptr) return false;
    system.q = static_cast<double const *>(data_of(args[1], NPY_DOUBLE, n, PW85_SYM, false));
    if (system.q == nullptr) return false;
    system.num_particles = static_cast<std::size_t>(n);
    system.cell = nullptr;
    if (args[2] != Py_None) {
        system.cell =
            static_cast<double const *>(data_of(args[2], NPY_DOUBLE, three, PW85_DIM, false));
        if (system.cell == nullptr) return false;
    }
    auto const *const flags =
        static_cast<std::int32_t const *>(data_of(args[3], NPY_INT32, three, 0, false));
    if (flags == nullptr) return false;
    for (int k = 0; k < 3; ++k) system.periodic[k] = flags[k];
    return true;
}

/// The rows of a list as an array that keeps the list alive and cannot be written to; None for
/// null.
Reference array_of(std::int32_t const *data, std::size_t rows, npy_intp columns, PyObject *owner)
{
    if (data == nullptr && rows > 0) return Reference(Py_NewRef(Py_None));
    npy_intp const shape[] = {static_cast<npy_intp>(rows), columns};
    Reference array(
        PyArray_SimpleNewFromData(2, shape, NPY_INT32, const_cast<std::int32_t *>(data)));
    if (!array) return nullptr;
    auto *const object = reinterpret_cast<PyArrayObject *>(array.get());
    PyArray_CLEARFLAGS(object, NPY_ARRAY_WRITEABLE);
    if (data != nullptr && PyArray_SetBaseObject(object, Py_NewRef(owner)) != 0) return nullptr;
    return array;
}

PyObject *results(pw85_neighbors *list, bool has_cell)
{
    Reference const capsule(PyCapsule_New(list, capsule_name, destroy));
    if (!capsule) {
        pw85_neighbors_destroy(list);
        return nullptr;
    }
    auto const [size, indices, multiples] = pw85_neighbors_list(list);
    Reference const pairs = array_of(indices, size, 2, capsule.get());
    Reference const images = has_cell ? array_of(multiples, size, PW85_DIM, capsule.get())
                                      : Reference(Py_NewRef(Py_None));
    if (!pairs || !images) return nullptr;
    return Py_BuildValue("inOOO", 0, Py_ssize_t{0}, capsule.get(), pairs.get(), images.get());
}

} // namespace

PyObject *neighbors(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    pw85_system system;
    if (!right_number(nargs, 6) || !read_system(args, system)) return nullptr;
    double const scale = PyFloat_AsDouble(args[4]),
                 skin = PyErr_Occurred() ? 0.0 : PyFloat_AsDouble(args[5]);
    if (PyErr_Occurred()) return nullptr;
    int status;
    std::size_t particle = system.num_particles;
    pw85_neighbors *list;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_neighbors_create(&system, scale, skin, &list);
    if (status != PW85_SUCCESS) pw85_neighbors_check(&system, scale, skin, &particle);
    Py_END_ALLOW_THREADS;
    if (status == PW85_SUCCESS) return results(list, system.cell != nullptr);
    return Py_BuildValue("inOOO", status, static_cast<Py_ssize_t>(particle), Py_None, Py_None,
                         Py_None);
}

PyObject *neighbors_hold(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    pw85_system system;
    if (!right_number(nargs, 5)) return nullptr;
    pw85_neighbors const *const list = list_of(args[0]);
    if (list == nullptr || !read_system(args + 1, system)) return nullptr;
    int status, holds;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_neighbors_holds(list, &system, &holds);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, holds);
}

} // namespace pypw85
