// SPDX-License-Identifier: BSD-3-Clause
// Arguments of functions that take arrays as they are.
#ifndef PYPW85_ARGUMENTS_HPP_INCLUDED
#define PYPW85_ARGUMENTS_HPP_INCLUDED

#include "numpy_api.hpp"

namespace pypw85 {
namespace {

/// Data of a contiguous array of the given type and shape (n × columns, or n if `columns` is 0);
/// null, with an exception, if it is something else. `n` < 0 takes the size from the array.
inline void *data_of(PyObject *object, int type, npy_intp &n, npy_intp columns, bool writeable)
{
    auto *const array = reinterpret_cast<PyArrayObject *>(object);
    bool const fits =
        PyArray_Check(object) && PyArray_TYPE(array) == type &&
        PyArray_NDIM(array) == (columns > 0 ? 2 : 1) && PyArray_IS_C_CONTIGUOUS(array) &&
        PyArray_ISBEHAVED_RO(array) && (!writeable || PyArray_ISWRITEABLE(array)) &&
        (columns == 0 || PyArray_DIM(array, 1) == columns) && (n < 0 || PyArray_DIM(array, 0) == n);
    if (!fits) {
        PyErr_SetString(PyExc_TypeError,
                        "a contiguous array of another type or shape was expected");
        return nullptr;
    }
    n = PyArray_DIM(array, 0);
    return PyArray_DATA(array);
}

inline bool right_number(Py_ssize_t given, Py_ssize_t expected)
{
    if (given != expected)
        PyErr_Format(PyExc_TypeError, "%zd arguments expected, %zd given", expected, given);
    return given == expected;
}

} // namespace
} // namespace pypw85

#endif
