// SPDX-License-Identifier: BSD-3-Clause
// Pairs of ellipsoids in n dimensions. The Python layer converts and explains; what would read or
// write beyond an array is refused here.
#include <pw85.h>
#include <pw85_any_dimension.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

/// Reads arrays of as many rows as the first one has.
class Rows {
  public:
    explicit Rows(PyObject *const *args) : next_(args) {}

    /// Reads r12, q1 and q2, and finds n. Returns false, with an exception, if they do not fit.
    bool read_pairs()
    {
        auto *const array = reinterpret_cast<PyArrayObject *>(*next_);
        if (!PyArray_Check(*next_) || PyArray_NDIM(array) != 2 ||
            PyArray_DIM(array, 1) > PW85_ND_MAX || PyArray_DIM(array, 1) < 1) {
            PyErr_SetString(PyExc_TypeError, "r12 must have rows of 1 to 16 numbers");
            return false;
        }
        n = static_cast<int>(PyArray_DIM(array, 1));
        r12 = numbers(n, false);
        q1 = r12 != nullptr ? numbers(size(), false) : nullptr;
        q2 = q1 != nullptr ? numbers(size(), false) : nullptr;
        return q2 != nullptr;
    }

    /// The numbers of the next array, with rows of that many or, for 0, one number per row.
    double *numbers(int columns, bool writeable)
    {
        return static_cast<double *>(data_of(*next_++, NPY_DOUBLE, rows, columns, writeable));
    }
    int *integers() { return static_cast<int *>(data_of(*next_++, NPY_INT, rows, 0, true)); }
    unsigned char *bytes()
    {
        return static_cast<unsigned char *>(data_of(*next_++, NPY_UINT8, rows, 0, true));
    }
    int size() const { return n * (n + 1) / 2; }
    std::size_t count() const { return static_cast<std::size_t>(rows); }

    int n = 0;
    double const *r12 = nullptr, *q1 = nullptr, *q2 = nullptr;

  private:
    PyObject *const *next_;
    npy_intp rows = -1;
};

template <class Function> PyObject *status_of(Function const &function)
{
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = function();
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

/// The status of a function that gives one byte for each row.
template <class Function>
PyObject *answers_of(PyObject *const *args, Py_ssize_t nargs, Function const &function)
{
    Rows rows(args);
    if (!right_number(nargs, 4) || !rows.read_pairs()) return nullptr;
    unsigned char *const answers = rows.bytes();
    if (answers == nullptr) return nullptr;
    return status_of(
        [&] { return function(rows.count(), rows.n, rows.r12, rows.q1, rows.q2, answers); });
}

} // namespace

PyObject *nd_contact(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Rows rows(args);
    if (!right_number(nargs, 5) || !rows.read_pairs()) return nullptr;
    double *const mu2 = rows.numbers(0, true);
    double *const lambda = mu2 != nullptr ? rows.numbers(0, true) : nullptr;
    if (lambda == nullptr) return nullptr;
    return status_of([&] {
        return pw85_nd_contact_batch(rows.count(), rows.n, rows.r12, rows.q1, rows.q2, mu2, lambda);
    });
}

PyObject *nd_contact_geometry(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Rows rows(args);
    if (!right_number(nargs, 9) || !rows.read_pairs()) return nullptr;
    double const *const lambda = rows.numbers(0, false);
    if (lambda == nullptr) return nullptr;
    double *outputs[5];
    for (int k = 0; k < 5; ++k) {
        outputs[k] = rows.numbers(k < 3 ? rows.n : rows.size(), true);
        if (outputs[k] == nullptr) return nullptr;
    }
    return status_of([&] {
        return pw85_nd_contact_geometry_batch(rows.count(), rows.n, rows.r12, rows.q1, rows.q2,
                                              lambda, outputs[0], outputs[1], outputs[2],
                                              outputs[3], outputs[4]);
    });
}

PyObject *nd_overlap(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    return answers_of(args, nargs, pw85_nd_overlap_batch);
}

PyObject *nd_contains(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    return answers_of(args, nargs, pw85_nd_contains_batch);
}

PyObject *nd_compare(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Rows rows(args);
    if (!right_number(nargs, 5) || !rows.read_pairs()) return nullptr;
    double const *const mu2 = rows.numbers(0, false);
    int *const sign = mu2 != nullptr ? rows.integers() : nullptr;
    if (sign == nullptr) return nullptr;
    return status_of([&] {
        return pw85_nd_compare_batch(rows.count(), rows.n, rows.r12, rows.q1, rows.q2, mu2, sign);
    });
}

PyObject *nd_distance(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Rows rows(args);
    if (!right_number(nargs, 7) || !rows.read_pairs()) return nullptr;
    double *outputs[4];
    for (int k = 0; k < 4; ++k) {
        outputs[k] = rows.numbers(k == 0 ? 0 : rows.n, true);
        if (outputs[k] == nullptr) return nullptr;
    }
    return status_of([&] {
        return pw85_nd_distance_batch(rows.count(), rows.n, rows.r12, rows.q1, rows.q2, outputs[0],
                                      outputs[1], outputs[2], outputs[3]);
    });
}

PyObject *nd_containment(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Rows rows(args);
    if (!right_number(nargs, 5) || !rows.read_pairs()) return nullptr;
    double *const mu2 = rows.numbers(0, true);
    double *const point = mu2 != nullptr ? rows.numbers(rows.n, true) : nullptr;
    if (point == nullptr) return nullptr;
    return status_of([&] {
        return pw85_nd_containment_batch(rows.count(), rows.n, rows.r12, rows.q1, rows.q2, mu2,
                                         point);
    });
}

} // namespace pypw85
