// SPDX-License-Identifier: BSD-3-Clause
// One pair of ellipsoids in n dimensions: plain numbers go straight to the C function. The way of
// rows costs tens of microseconds, the function a few.
#include <cmath>
#include <cstring>

#include <pw85.h>
#include <pw85_any_dimension.h>

#include "calls.hpp"

namespace pypw85 {
namespace {

constexpr int max_size = PW85_ND_MAX * (PW85_ND_MAX + 1) / 2;

/// Copies the numbers of a list or tuple. Returns false if there are others than `size` floats and
/// integers.
bool copy_sequence(PyObject *sequence, npy_intp size, double *numbers)
{
    if (PySequence_Fast_GET_SIZE(sequence) != size) return false;
    PyObject *const *const items = PySequence_Fast_ITEMS(sequence);
    for (npy_intp i = 0; i < size; ++i) {
        if (!PyFloat_Check(items[i]) && !PyLong_CheckExact(items[i])) return false;
        numbers[i] = PyFloat_AsDouble(items[i]);
        if (numbers[i] == -1 && PyErr_Occurred()) { // an integer beyond the range of double
            PyErr_Clear();
            return false;
        }
    }
    return true;
}

bool is_array_of_doubles(PyObject *object)
{
    auto *const array = reinterpret_cast<PyArrayObject *>(object);
    return PyArray_CheckExact(object) && PyArray_TYPE(array) == NPY_DOUBLE &&
           PyArray_ISBEHAVED_RO(array);
}

double number_at(PyArrayObject *array, npy_intp i)
{
    return *static_cast<double const *>(PyArray_GETPTR1(array, i));
}

double number_at(PyArrayObject *array, npy_intp i, npy_intp j)
{
    return *static_cast<double const *>(PyArray_GETPTR2(array, i, j));
}

/// Copies a vector. Returns false if it is not an array, list or tuple of that many numbers.
bool copy_vector(PyObject *object, npy_intp size, double *numbers)
{
    if (PyList_CheckExact(object) || PyTuple_CheckExact(object))
        return copy_sequence(object, size, numbers);
    auto *const array = reinterpret_cast<PyArrayObject *>(object);
    if (!is_array_of_doubles(object) || PyArray_NDIM(array) != 1 || PyArray_DIM(array, 0) != size)
        return false;
    for (npy_intp i = 0; i < size; ++i) numbers[i] = number_at(array, i);
    return true;
}

/// Copies the upper triangle of a symmetric matrix, as packed_rows() of the Python layer does.
bool copy_matrix(PyArrayObject *array, int n, double *numbers)
{
    double largest = 0.0, asymmetry = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j) {
            double const above = number_at(array, i, j), below = number_at(array, j, i);
            *numbers++ = above;
            largest = std::fmax(largest, std::fmax(std::abs(above), std::abs(below)));
            asymmetry = std::fmax(asymmetry, std::abs(above - below));
        }
    return asymmetry <= 1e-6 * largest;
}

bool copy_form(PyObject *object, int n, double *numbers)
{
    auto *const array = reinterpret_cast<PyArrayObject *>(object);
    if (is_array_of_doubles(object) && PyArray_NDIM(array) == 2 && PyArray_DIM(array, 0) == n &&
        PyArray_DIM(array, 1) == n)
        return copy_matrix(array, n, numbers);
    return copy_vector(object, n * (n + 1) / 2, numbers);
}

npy_intp length_of(PyObject *object)
{
    if (PyList_CheckExact(object) || PyTuple_CheckExact(object))
        return PySequence_Fast_GET_SIZE(object);
    return is_array_of_doubles(object) ? PyArray_SIZE(reinterpret_cast<PyArrayObject *>(object))
                                       : 0;
}

/// The numbers of one pair, and one more number if there is a fourth argument.
struct OnePair {
    int n;
    double r12[PW85_ND_MAX], q1[max_size], q2[max_size], number;

    /// Returns false, without an exception, for all that is not a pair of plain numbers.
    bool read(PyObject *const *args, bool with_number)
    {
        npy_intp const length = length_of(args[0]);
        if (length < 1 || length > PW85_ND_MAX) return false;
        n = static_cast<int>(length);
        return copy_vector(args[0], n, r12) && copy_form(args[1], n, q1) &&
               copy_form(args[2], n, q2) && (!with_number || read_number(args[3]));
    }

    bool read_number(PyObject *object)
    {
        if (!PyFloat_Check(object)) return false;
        number = PyFloat_AS_DOUBLE(object);
        return true;
    }
};

/// The outputs of a function of one pair, each of which has room for a form.
using OneRow = double[5][max_size];

/// A function of one pair. Its outputs are numbers (f), truth values (b), signs (i), vectors (v)
/// and forms (q).
struct OfOnePair {
    char const *name;
    bool with_number;
    char const *outputs;
    int (*evaluate)(OnePair const &pair, OneRow &out);
};

constexpr OfOnePair of_one_pair[] = {
    {"nd_contact", false, "ff",
     [](OnePair const &x, OneRow &out) {
         double both[2];
         int const status = pw85_nd_contact(x.n, x.r12, x.q1, x.q2, both);
         *out[0] = both[0];
         *out[1] = both[1];
         return status;
     }},
    {"nd_contact_geometry", true, "vvvqq",
     [](OnePair const &x, OneRow &out) {
         return pw85_nd_contact_geometry(x.n, x.r12, x.q1, x.q2, x.number, out[0], out[1], out[2],
                                         out[3], out[4]);
     }},
    {"nd_overlap", false, "b",
     [](OnePair const &x, OneRow &out) {
         int answer;
         int const status = pw85_nd_overlap(x.n, x.r12, x.q1, x.q2, &answer);
         **out = answer;
         return status;
     }},
    {"nd_contains", false, "b",
     [](OnePair const &x, OneRow &out) {
         int answer;
         int const status = pw85_nd_contains(x.n, x.r12, x.q1, x.q2, &answer);
         **out = answer;
         return status;
     }},
    {"nd_compare", true, "i",
     [](OnePair const &x, OneRow &out) {
         int sign;
         int const status = pw85_nd_compare(x.n, x.r12, x.q1, x.q2, x.number, &sign);
         **out = sign;
         return status;
     }},
    {"nd_containment", false, "fv",
     [](OnePair const &x, OneRow &out) {
         return pw85_nd_containment(x.n, x.r12, x.q1, x.q2, out[0], out[1]);
     }},
    {"nd_distance", false, "fvvv",
     [](OnePair const &x, OneRow &out) {
         return pw85_nd_distance(x.n, x.r12, x.q1, x.q2, out[0], out[1], out[2], out[3]);
     }},
};

PyObject *new_numbers(npy_intp size, double const *numbers)
{
    PyObject *const array = PyArray_SimpleNew(1, &size, NPY_DOUBLE);
    if (array != nullptr)
        std::memcpy(PyArray_DATA(reinterpret_cast<PyArrayObject *>(array)), numbers,
                    static_cast<std::size_t>(size) * sizeof(double));
    return array;
}

/// An output as NumPy gives the entries of arrays.
PyObject *new_output(char kind, int n, double const *numbers)
{
    if (kind == 'v') return new_numbers(n, numbers);
    if (kind == 'q') return new_numbers(n * (n + 1) / 2, numbers);
    if (kind == 'b') PyArrayScalar_RETURN_BOOL_FROM_LONG(*numbers != 0);
    PyObject *const value = kind == 'i' ? PyArrayScalar_New(Int) : PyArrayScalar_New(Double);
    if (value == nullptr) return nullptr;
    if (kind == 'i')
        PyArrayScalar_ASSIGN(value, Int, static_cast<npy_int>(*numbers));
    else
        PyArrayScalar_ASSIGN(value, Double, *numbers);
    return value;
}

/// One output, or a tuple of several.
PyObject *new_outputs(OfOnePair const &function, int n, OneRow const &out)
{
    auto const count = static_cast<Py_ssize_t>(std::strlen(function.outputs));
    if (count == 1) return new_output(*function.outputs, n, *out);
    Reference tuple(PyTuple_New(count));
    for (Py_ssize_t k = 0; tuple && k < count; ++k) {
        PyObject *const value = new_output(function.outputs[k], n, out[k]);
        if (value == nullptr) return nullptr;
        PyTuple_SET_ITEM(tuple.get(), k, value);
    }
    return tuple.release();
}

/// The function of this name and number of arguments, or null.
OfOnePair const *find_function(PyObject *name, Py_ssize_t nargs)
{
    for (OfOnePair const &one : of_one_pair)
        if (PyUnicode_CheckExact(name) && PyUnicode_CompareWithASCIIString(name, one.name) == 0)
            return nargs == (one.with_number ? 5 : 4) ? &one : nullptr;
    return nullptr;
}

} // namespace

PyObject *nd_one_pair(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    OfOnePair const *const function = nargs > 0 ? find_function(args[0], nargs) : nullptr;
    if (function == nullptr) {
        PyErr_SetString(PyExc_TypeError, "the name of a function and its arguments were expected");
        return nullptr;
    }
    OnePair pair;
    OneRow out;
    if (!pair.read(args + 1, function->with_number)) Py_RETURN_NONE;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = function->evaluate(pair, out);
    Py_END_ALLOW_THREADS;
    if (status != PW85_SUCCESS) Py_RETURN_NONE;
    return new_outputs(*function, pair.n, out);
}

} // namespace pypw85
