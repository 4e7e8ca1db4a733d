// Neighbour lists. The Python layer converts and explains; what would read or write beyond an array is refused here.
#include <cstdint>

#include <pw85.h>

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

struct Particles {
    npy_intp n = -1;
    double const *centers = nullptr;
    double const *q = nullptr;

    bool read(PyObject *const *args)
    {
        centers = static_cast<double const *>(data_of(args[0], NPY_DOUBLE, n, PW85_DIM, false));
        if (centers != nullptr) q = static_cast<double const *>(data_of(args[1], NPY_DOUBLE, n, PW85_SYM, false));
        return q != nullptr;
    }
};

struct Options {
    double const *cell = nullptr;
    int periodic[3];
    double scale, skin;

    /// Reads the arguments cell, periodic, scale, skin.
    bool read(PyObject *const *args)
    {
        npy_intp three = 3;
        if (args[0] != Py_None) {
            cell = static_cast<double const *>(data_of(args[0], NPY_DOUBLE, three, PW85_DIM, false));
            if (cell == nullptr) return false;
        }
        auto const *const flags = static_cast<std::int32_t const *>(data_of(args[1], NPY_INT32, three, 0, false));
        if (flags == nullptr) return false;
        for (int k = 0; k < 3; ++k) periodic[k] = flags[k];
        scale = PyFloat_AsDouble(args[2]);
        skin = PyErr_Occurred() ? 0.0 : PyFloat_AsDouble(args[3]);
        return !PyErr_Occurred();
    }
};

/// The rows of a list as an array that keeps the list alive and cannot be written to; None for null.
Reference array_of(std::int32_t const *data, std::size_t rows, npy_intp columns, PyObject *owner)
{
    if (data == nullptr && rows > 0) return Reference(Py_NewRef(Py_None));
    npy_intp const shape[] = {static_cast<npy_intp>(rows), columns};
    Reference array(PyArray_SimpleNewFromData(2, shape, NPY_INT32, const_cast<std::int32_t *>(data)));
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
    std::size_t const size = pw85_neighbors_size(list);
    Reference const pairs = array_of(pw85_neighbors_pairs(list), size, 2, capsule.get());
    Reference const images =
        has_cell ? array_of(pw85_neighbors_images(list), size, PW85_DIM, capsule.get()) : Reference(Py_NewRef(Py_None));
    if (!pairs || !images) return nullptr;
    return Py_BuildValue("inOOO", 0, Py_ssize_t{0}, capsule.get(), pairs.get(), images.get());
}

} // namespace

PyObject *neighbors(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Particles particles;
    Options options;
    if (!right_number(nargs, 6) || !particles.read(args) || !options.read(args + 2)) return nullptr;
    auto const n = static_cast<std::size_t>(particles.n);
    int status;
    std::size_t particle = n;
    pw85_neighbors *list;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_neighbors_create(n, particles.centers, particles.q, options.cell, options.periodic, options.scale,
                                   options.skin, &list);
    if (status != PW85_SUCCESS)
        pw85_neighbors_check(n, particles.centers, particles.q, options.cell, options.periodic, options.scale,
                             options.skin, &particle);
    Py_END_ALLOW_THREADS;
    if (status == PW85_SUCCESS) return results(list, options.cell != nullptr);
    return Py_BuildValue("inOOO", status, static_cast<Py_ssize_t>(particle), Py_None, Py_None, Py_None);
}

PyObject *neighbors_hold(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Particles particles;
    if (!right_number(nargs, 3)) return nullptr;
    pw85_neighbors const *const list = list_of(args[0]);
    if (list == nullptr || !particles.read(args + 1)) return nullptr;
    int status, holds;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_neighbors_holds(list, static_cast<std::size_t>(particles.n), particles.centers, particles.q, &holds);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, holds);
}

} // namespace pypw85
