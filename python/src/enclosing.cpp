// SPDX-License-Identifier: BSD-3-Clause
// The smallest ellipsoid around points, and random points of an ellipsoid. The Python layer
// converts and explains; what would read or write beyond an array is refused here.
#include <pw85_enclosing.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {

PyObject *enclosing_ellipsoid(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    if (!right_number(nargs, 5)) return nullptr;
    npy_intp n = -1, m = -1, one = 1;
    double const tolerance = PyFloat_AsDouble(args[1]);
    if (PyErr_Occurred()) return nullptr;
    auto *const center = static_cast<double *>(data_of(args[2], NPY_DOUBLE, n, 0, true));
    if (center == nullptr) return nullptr;
    npy_intp packed = n * (n + 1) / 2;
    auto *const q = static_cast<double *>(data_of(args[3], NPY_DOUBLE, packed, 0, true));
    if (q == nullptr) return nullptr;
    auto *const excess = static_cast<double *>(data_of(args[4], NPY_DOUBLE, one, 0, true));
    if (excess == nullptr) return nullptr;
    auto const *const points = static_cast<double *>(data_of(args[0], NPY_DOUBLE, m, n, false));
    if (points == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_enclosing_ellipsoid(static_cast<int>(n), static_cast<size_t>(m), points,
                                      tolerance, center, q, excess);
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
