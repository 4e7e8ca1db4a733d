// SPDX-License-Identifier: BSD-3-Clause
// The smallest ellipsoid around points, and random points of an ellipsoid. The Python layer
// converts and explains; what would read or write beyond an array is refused here.
#include <pw85_enclosing.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {

namespace {

/// Reads the tolerance and the outputs, which are the last four arguments, and finds n.
struct Enclosing {
    npy_intp n = -1, packed = -1;
    double tolerance = 0.0, *center = nullptr, *q = nullptr, *excess = nullptr;

    bool read(PyObject *const *args)
    {
        tolerance = PyFloat_AsDouble(args[0]);
        if (PyErr_Occurred()) return false;
        center = static_cast<double *>(data_of(args[1], NPY_DOUBLE, n, 0, true));
        if (center == nullptr) return false;
        packed = n * (n + 1) / 2;
        npy_intp one = 1;
        q = static_cast<double *>(data_of(args[2], NPY_DOUBLE, packed, 0, true));
        if (q != nullptr)
            excess = static_cast<double *>(data_of(args[3], NPY_DOUBLE, one, 0, true));
        return excess != nullptr;
    }
};

} // namespace

PyObject *enclosing_ellipsoid(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Enclosing out;
    if (!right_number(nargs, 5) || !out.read(args + 1)) return nullptr;
    npy_intp m = -1;
    auto const *const points = static_cast<double *>(data_of(args[0], NPY_DOUBLE, m, out.n, false));
    if (points == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_enclosing_ellipsoid(static_cast<int>(out.n), static_cast<size_t>(m), points,
                                      out.tolerance, out.center, out.q, out.excess);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *enclosing_ellipsoid_of(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Enclosing out;
    if (!right_number(nargs, 6) || !out.read(args + 2)) return nullptr;
    npy_intp m = -1;
    auto const rows = [&](PyObject *array, npy_intp columns) {
        return static_cast<double const *>(data_of(array, NPY_DOUBLE, m, columns, false));
    };
    double const *const centers = rows(args[0], out.n);
    double const *const forms = centers != nullptr ? rows(args[1], out.packed) : nullptr;
    if (forms == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_enclosing_ellipsoid_of(static_cast<int>(out.n), static_cast<size_t>(m), centers,
                                         forms, out.tolerance, out.center, out.q, out.excess);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *random_points(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    if (!right_number(nargs, 4)) return nullptr;
    npy_intp six = 6, n = -1;
    auto const *const q = static_cast<double *>(data_of(args[0], NPY_DOUBLE, six, 0, false));
    if (q == nullptr) return nullptr;
    int const surface = PyObject_IsTrue(args[1]);
    std::size_t const seed = PyLong_AsSize_t(args[2]);
    if (PyErr_Occurred()) return nullptr;
    auto *const points = static_cast<double *>(data_of(args[3], NPY_DOUBLE, n, 3, true));
    if (points == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_random_points(q, surface, seed, static_cast<size_t>(n), points);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

} // namespace pypw85
