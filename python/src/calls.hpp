// SPDX-License-Identifier: BSD-3-Clause
// What the Python layer calls.
#ifndef PYPW85_CALLS_HPP_INCLUDED
#define PYPW85_CALLS_HPP_INCLUDED

#include "function.hpp"
#include "numpy_api.hpp"

namespace pypw85 {

/// A function of METH_FASTCALL in a table of methods.
template <class Function> PyCFunction as_method(Function *function)
{
    return reinterpret_cast<PyCFunction>(reinterpret_cast<void *>(function));
}

/// A function together with its ufunc, behind one callable of the module.
struct Callable {
    Function const *function;
    PyObject *ufunc;
    PyObject *object; ///< the callable itself
};

/// call(input..., out, keywords): for one row of each input the function itself, with a PW85Error
/// if it fails; for arrays the ufunc; for anything else pypw85._arrays. `self` is a capsule of a
/// Callable; `out` is None, an array or a tuple; `keywords` is a dict.
PyObject *call(PyObject *self, PyObject *const *args, Py_ssize_t nargs);

/// gpu(name, stream, n, addresses and sizes...): status of pw85_gpu_... of this name.
PyObject *gpu(PyObject *self, PyObject *const *args, Py_ssize_t nargs);

/// dlpack_view(capsule): (address, shape, strides in bytes or None, type) of an array that another
/// library hands over; it is not taken.
PyObject *dlpack_view(PyObject *self, PyObject *capsule);

/// dlpack_export(owner, address, device, shape, bytes of a number: 8 or 1): a capsule for another
/// library to take.
PyObject *dlpack_export(PyObject *self, PyObject *const *args, Py_ssize_t nargs);

/// device_memory(bytes): (owner, address, device), or None if there is no memory.
PyObject *device_memory(PyObject *self, PyObject *size);

/// device_wait(stream): whether all of its work was done.
PyObject *device_wait(PyObject *self, PyObject *stream);

/// Adds the functions on objects of the library: neighbour lists, meshes, simulations.
bool add_objects(PyObject *module);

/// parse_rows(block, separator or 0, kinds): (numbers (rows, n), codes (rows, m) of int32, m lists
/// of names that codes count), or None unless all lines of the block, which is bytes, are plain.
/// Kinds of columns, in bytes, are n (number), t (name), - (skipped).
PyObject *parse_rows(PyObject *self, PyObject *args);

/// format_rows(separator, columns...): the rows as text. A column is an array of int64 or float64
/// of two dimensions, or a tuple (codes of int32, list of names as bytes that the codes count). All
/// columns have the same number of rows, and all arrays are contiguous.
PyObject *format_rows(PyObject *self, PyObject *args);

/// nd_one_pair(name, r12, q1, q2) or (name, r12, q1, q2, number): what the function of the package
/// with this name returns for one pair, as a tuple if there are several outputs. None, if the
/// arguments are not plain numbers of one pair, or the status is not success.
PyObject *nd_one_pair(PyObject *self, PyObject *const *args, Py_ssize_t nargs);

} // namespace pypw85

#endif
