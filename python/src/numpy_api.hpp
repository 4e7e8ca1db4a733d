// SPDX-License-Identifier: BSD-3-Clause
// The NumPy C API, shared by all files of the extension: exactly one of them, module.cpp, imports
// it.
#ifndef PYPW85_NUMPY_API_HPP_INCLUDED
#define PYPW85_NUMPY_API_HPP_INCLUDED

#define PY_SSIZE_T_CLEAN
#include <Python.h>

// Nothing that is deprecated in the NumPy that is built against; where that is 1.25 or later, the
// result runs with every version from 1.21, which has the API of 1.20.
#define NPY_NO_DEPRECATED_API NPY_API_VERSION
#define NPY_TARGET_VERSION NPY_1_20_API_VERSION
#define PY_ARRAY_UNIQUE_SYMBOL pypw85_array_api
#define PY_UFUNC_UNIQUE_SYMBOL pypw85_ufunc_api
#ifndef PYPW85_IMPORTS_NUMPY
#define NO_IMPORT_ARRAY
#define NO_IMPORT_UFUNC
#endif
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <numpy/ufuncobject.h>

#include <memory>

namespace pypw85 {

struct Decref {
    void operator()(PyObject *object) const noexcept { Py_DECREF(object); }
};

/// An owned reference.
using Reference = std::unique_ptr<PyObject, Decref>;

} // namespace pypw85

#endif
