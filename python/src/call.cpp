// SPDX-License-Identifier: BSD-3-Clause
// Calls for one row go straight to the C function: a ufunc costs microseconds, the function a
// fraction of one.
#include <algorithm>
#include <cstring>

#include <pw85.h>

#include "calls.hpp"

namespace pypw85 {
namespace {

enum class Loaded { failed, one_row, other };

/// Copies the only row of an array of doubles.
void copy_row(PyArrayObject *array, Core const &core, double *row) noexcept
{
    char const *const first = PyArray_BYTES(array);
    npy_intp const *const strides = PyArray_STRIDES(array);
    for (npy_intp j = 0; j < core.dims[0]; ++j)
        for (npy_intp k = 0; k < core.dims[1]; ++k) {
            npy_intp const offset =
                (core.ndim > 0 ? j * strides[0] : 0) + (core.ndim > 1 ? k * strides[1] : 0);
            *row++ = *reinterpret_cast<double const *>(first + offset);
        }
}

bool has_core_shape(PyArrayObject *array, Core const &core) noexcept
{
    if (PyArray_NDIM(array) != core.ndim) return false;
    for (int d = 0; d < core.ndim; ++d)
        if (PyArray_DIM(array, d) != core.dims[d]) return false;
    return true;
}

bool is_plain(PyArrayObject *array) noexcept
{
    return PyArray_TYPE(array) == NPY_DOUBLE && PyArray_ISBEHAVED_RO(array);
}

Loaded load_array(PyArrayObject *array, Core const &core, double *row)
{
    if (!has_core_shape(array, core)) return Loaded::other;
    if (is_plain(array)) {
        copy_row(array, core, row);
        return Loaded::one_row;
    }
    if (!PyArray_CanCastSafely(PyArray_TYPE(array), NPY_DOUBLE)) return Loaded::other;
    Reference const converted(
        PyArray_FROM_OTF(reinterpret_cast<PyObject *>(array), NPY_DOUBLE, NPY_ARRAY_CARRAY_RO));
    if (!converted) return Loaded::failed;
    copy_row(reinterpret_cast<PyArrayObject *>(converted.get()), core, row);
    return Loaded::one_row;
}

Loaded load_number(PyObject *number, Core const &core, double *row)
{
    if (core.ndim != 0) return Loaded::other;
    *row = PyFloat_AsDouble(number);
    return *row == -1 && PyErr_Occurred() ? Loaded::failed : Loaded::one_row;
}

/// Loads an argument if it is one row. Subclasses of ndarray and the arrays of other libraries are
/// left to the ufunc.
Loaded load(PyObject *argument, Core const &core, double *row)
{
    if (PyArray_CheckExact(argument))
        return load_array(reinterpret_cast<PyArrayObject *>(argument), core, row);
    if (PyFloat_Check(argument) || PyLong_Check(argument) || PyArray_IsScalar(argument, Floating) ||
        PyArray_IsScalar(argument, Integer))
        return load_number(argument, core, row);
    if (!PyList_Check(argument) && !PyTuple_Check(argument)) return Loaded::other;
    Reference const array(PyArray_FROM_O(argument));
    return array ? load_array(reinterpret_cast<PyArrayObject *>(array.get()), core, row)
                 : Loaded::failed;
}

PyObject *new_array(Core const &core, double const *row)
{
    npy_intp const dims[2] = {core.dims[0], core.dims[1]};
    PyObject *const array = PyArray_SimpleNew(core.ndim, const_cast<npy_intp *>(dims), NPY_DOUBLE);
    if (array != nullptr)
        std::memcpy(PyArray_DATA(reinterpret_cast<PyArrayObject *>(array)), row,
                    static_cast<size_t>(core.size()) * sizeof(double));
    return array;
}

PyObject *new_value(Function const &function, Core const &core, double const *row)
{
    if (core.ndim > 0) return new_array(core, row);
    if (function.is_truth()) PyArrayScalar_RETURN_BOOL_FROM_LONG(*row != 0);
    PyObject *const number = PyArrayScalar_New(Double);
    if (number != nullptr) PyArrayScalar_ASSIGN(number, Double, *row);
    return number;
}

/// Writes an array to an output argument with as many elements, by the rules of ufuncs for casting;
/// returns the argument.
PyObject *store(Function const &function, PyObject *out, Reference const &value)
{
    if (!value) return nullptr;
    auto *const to = reinterpret_cast<PyArrayObject *>(out), *const from =
                                                                 reinterpret_cast<PyArrayObject *>(
                                                                     value.get());
    if (!PyArray_CanCastTypeTo(PyArray_DESCR(from), PyArray_DESCR(to), NPY_SAME_KIND_CASTING))
        return PyErr_Format(PyExc_TypeError, "%s: out must be an array of %S, not %S",
                            function.name, PyArray_DESCR(from), PyArray_DESCR(to));
    if (PyArray_SIZE(from) != PyArray_SIZE(to)) {
        Reference const wanted(PyObject_GetAttrString(value.get(), "shape")),
            given(PyObject_GetAttrString(out, "shape"));
        return wanted && given
                   ? PyErr_Format(PyExc_ValueError, "%s: out must have the shape %S, not %S",
                                  function.name, wanted.get(), given.get())
                   : nullptr;
    }
    if (PyArray_CopyInto(to, from) < 0) return nullptr;
    Py_INCREF(out);
    return out;
}

PyObject *store_or_new(Function const &function, PyObject *out, Core const &core, double const *row)
{
    if (out == Py_None) return new_value(function, core, row);
    if (!function.is_truth()) return store(function, out, Reference(new_array(core, row)));
    return store(function, out, Reference(PyArray_FROM_O(*row != 0 ? Py_True : Py_False)));
}

/// Output argument k, borrowed, of `out` as the caller passed it: None, the only array, or a tuple.
PyObject *output_argument(PyObject *out, int k) noexcept
{
    return PyTuple_Check(out) ? PyTuple_GET_ITEM(out, k) : out;
}

/// Whether one array is given for outputs that are numbers.
bool is_array_of_columns(Function const &function, PyObject *out)
{
    if (function.nout == 1 || !PyArray_Check(out)) return false;
    for (int k = function.nin; k < function.operands(); ++k)
        if (function.cores[k].ndim > 0) return false;
    return true;
}

bool is_one_row(PyObject *out, int count)
{
    auto *const array = reinterpret_cast<PyArrayObject *>(out);
    return PyArray_NDIM(array) == 1 && PyArray_DIM(array, 0) == count;
}

/// Writes the numbers of one row to an array (nout); returns them.
PyObject *store_columns(Function const &function, PyObject *out, double rows[][max_core_size])
{
    double numbers[max_operands];
    Reference tuple(PyTuple_New(function.nout));
    for (int k = 0; tuple && k < function.nout; ++k) {
        numbers[k] = rows[k][0];
        PyObject *const number = new_value(function, Core{}, rows[k]);
        if (number == nullptr) return nullptr;
        PyTuple_SET_ITEM(tuple.get(), k, number);
    }
    Core const row{1, {function.nout, 1}};
    return tuple && Reference(store(function, out, Reference(new_array(row, numbers))))
               ? tuple.release()
               : nullptr;
}

PyObject *results(Function const &function, PyObject *out, double rows[][max_core_size])
{
    if (is_array_of_columns(function, out)) return store_columns(function, out, rows);
    if (out != Py_None && PyTuple_Check(out) ? PyTuple_GET_SIZE(out) != function.nout
                                             : out != Py_None && function.nout > 1)
        return PyErr_Format(PyExc_ValueError, "%s: out must be a tuple of %d arrays", function.name,
                            function.nout);
    Core const *const cores = function.cores + function.nin;
    if (function.nout == 1)
        return store_or_new(function, output_argument(out, 0), cores[0], rows[0]);
    Reference tuple(PyTuple_New(function.nout));
    for (int k = 0; tuple && k < function.nout; ++k) {
        PyObject *const item = store_or_new(function, output_argument(out, k), cores[k], rows[k]);
        if (item == nullptr) return nullptr;
        PyTuple_SET_ITEM(tuple.get(), k, item);
    }
    return tuple.release();
}

/// Calls a function of a module of the package.
template <class... Args>
PyObject *delegate(char const *module_name, char const *name, char const *format, Args... args)
{
    Reference const module(PyImport_ImportModule(module_name));
    Reference const function(module ? PyObject_GetAttrString(module.get(), name) : nullptr);
    return function ? PyObject_CallFunction(function.get(), format, args...) : nullptr;
}

Reference inputs(Function const &function, PyObject *const *args)
{
    Reference tuple(PyTuple_New(function.nin));
    for (int k = 0; tuple && k < function.nin; ++k) {
        Py_INCREF(args[k]);
        PyTuple_SET_ITEM(tuple.get(), k, args[k]);
    }
    return tuple;
}

PyObject *call_one_row(Function const &function, double const *const *in, PyObject *const *args,
                       PyObject *out)
{
    double rows[max_operands][max_core_size];
    double *pointers[max_operands];
    for (int k = 0; k < function.nout; ++k) pointers[k] = rows[k];
    int const status = function.evaluate(in, pointers);
    if (status == PW85_SUCCESS) return results(function, out, rows);
    if (out != Py_None && !Reference(results(function, out, rows))) return nullptr;
    // The record of an earlier refusal is forgotten, because not all functions have causes.
    pw85_error earlier;
    pw85_last_error(&earlier);
    function.evaluate(in, pointers);
    return delegate("pypw85._explanations", "raise_status", "isO", status, function.name,
                    inputs(function, args).get());
}

/// Whether NumPy alone knows what to do with an array: it is no subclass, and is converted to
/// double safely.
bool is_plain_array(PyObject *argument)
{
    return PyArray_CheckExact(argument) &&
           PyArray_CanCastSafely(PyArray_TYPE(reinterpret_cast<PyArrayObject *>(argument)),
                                 NPY_DOUBLE);
}

bool is_plain_number(PyObject *argument)
{
    return PyFloat_Check(argument) || PyLong_Check(argument) || PyArray_IsScalar(argument, Double);
}

/// Whether outputs are such that results reach the caller; otherwise an exception is set.
bool is_good_output(Function const &function, PyObject *out)
{
    auto const is_plain = [](PyObject *array) {
        return array == Py_None || PyArray_CheckExact(array);
    };
    bool plain = is_plain(out);
    if (PyTuple_Check(out)) {
        PyObject *const *const first = &PyTuple_GET_ITEM(out, 0);
        plain = std::all_of(first, first + PyTuple_GET_SIZE(out), is_plain);
    }
    return plain ||
           Reference(delegate("pypw85._arrays", "check_out", "Os", out, function.name)) != nullptr;
}

PyObject *call_ufunc(Callable const &callable, PyObject *const *args, PyObject *out,
                     PyObject *keywords)
{
    auto const nin = static_cast<size_t>(callable.function->nin);
    if (out == Py_None) return PyObject_VectorcallDict(callable.ufunc, args, nin, keywords);
    Reference const with_out(PyDict_Copy(keywords));
    if (!with_out || PyDict_SetItemString(with_out.get(), "out", out) < 0) return nullptr;
    return PyObject_VectorcallDict(callable.ufunc, args, nin, with_out.get());
}

/// Raises what a ufunc has raised because of types, shapes or bad rows again, with words for it.
PyObject *explain(Function const &function, PyObject *const *args, PyObject *out,
                  PyObject *keywords)
{
    PyObject *type, *value, *traceback;
    PyErr_Fetch(&type, &value, &traceback);
    PyErr_NormalizeException(&type, &value, &traceback);
    Reference const owned_type(type), owned_value(value), owned_traceback(traceback);
    return delegate("pypw85._explanations", "raise_better", "OsOOO", value, function.name,
                    inputs(function, args).get(), out, keywords);
}

PyObject *call_ufunc_or_explain(Callable const &callable, PyObject *const *args, PyObject *out,
                                PyObject *keywords)
{
    PyObject *const result = call_ufunc(callable, args, out, keywords);
    bool const explicable = result == nullptr && (PyErr_ExceptionMatches(PyExc_TypeError) ||
                                                  PyErr_ExceptionMatches(PyExc_ValueError) ||
                                                  PyErr_ExceptionMatches(PyExc_FloatingPointError));
    return explicable ? explain(*callable.function, args, out, keywords) : result;
}

/// A call in which the output, which this function calls otherwise, is given as the keyword of
/// ufuncs.
PyObject *call_with_out(PyObject *self, PyObject *const *args, Py_ssize_t nargs)
{
    if (args[nargs - 2] != Py_None)
        return PyErr_Format(PyExc_TypeError, "out must not be given twice");
    Reference const keywords(PyDict_Copy(args[nargs - 1]));
    if (!keywords) return nullptr;
    PyObject *all[max_operands + 2];
    std::copy(args, args + nargs - 2, all);
    all[nargs - 2] = PyDict_GetItemString(args[nargs - 1], "out");
    all[nargs - 1] = keywords.get();
    if (PyDict_DelItemString(keywords.get(), "out") < 0) return nullptr;
    return call(self, all, nargs);
}

/// Calls the function with inputs that are not plain, or refuses them.
PyObject *apply(Callable const &callable, PyObject *const *args, PyObject *out, PyObject *keywords)
{
    return delegate("pypw85._arrays", "apply", "OOOOO", callable.object, callable.ufunc,
                    inputs(*callable.function, args).get(), out, keywords);
}

/// Returns whether the present exception tells of a value that is not a number.
bool is_bad_value()
{
    return PyErr_ExceptionMatches(PyExc_TypeError) || PyErr_ExceptionMatches(PyExc_ValueError) ||
           PyErr_ExceptionMatches(PyExc_OverflowError);
}

} // namespace

PyObject *call(PyObject *self, PyObject *const *args, Py_ssize_t nargs)
{
    auto const *const callable = static_cast<Callable const *>(PyCapsule_GetPointer(self, nullptr));
    if (callable == nullptr) return nullptr;
    Function const &function = *callable->function;
    if (nargs != function.nin + 2 || !PyDict_Check(args[nargs - 1]))
        return PyErr_Format(PyExc_TypeError, "%s: %d inputs, out and keywords expected",
                            function.name, function.nin);
    PyObject *const out = args[function.nin], *const keywords = args[function.nin + 1];
    if (PyDict_GET_SIZE(keywords) > 0 && PyDict_GetItemString(keywords, "out") != nullptr)
        return call_with_out(self, args, nargs);
    if (!is_good_output(function, out)) return nullptr;

    double rows[max_operands][max_core_size];
    double const *in[max_operands];
    bool one_row = PyDict_GET_SIZE(keywords) == 0;
    for (int k = 0; one_row && k < function.nin; ++k) {
        Loaded const loaded = load(args[k], function.cores[k], rows[k]);
        if (loaded == Loaded::failed) {
            if (!is_bad_value()) return nullptr;
            PyErr_Clear();
            return apply(*callable, args, out, keywords);
        }
        one_row = loaded == Loaded::one_row;
        in[k] = rows[k];
    }
    bool const columns = is_array_of_columns(function, out);
    if (one_row && (!columns || is_one_row(out, function.nout)))
        return call_one_row(function, in, args, out);
    if (columns)
        return delegate("pypw85._arrays", "apply_to_columns", "OOOOi", callable->object,
                        inputs(function, args).get(), out, keywords, function.nout);
    for (int k = 0; k < function.nin; ++k)
        if (!is_plain_array(args[k]) && !is_plain_number(args[k]))
            return apply(*callable, args, out, keywords);
    return call_ufunc_or_explain(*callable, args, out, keywords);
}

} // namespace pypw85
