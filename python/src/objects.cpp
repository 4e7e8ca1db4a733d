// SPDX-License-Identifier: BSD-3-Clause
// Functions on objects of the library, lists of pairs, systems, and arrays of any dimension. They
// are made (api/python_calls.py). The Python layer converts and explains; what would read or
// write beyond an array is refused here.
#include <cstdint>
#include <type_traits>

#include <pw85.h>
#include <pw85_any_dimension.h>
#include <pw85_batch.h>
#include <pw85_enclosing.h>
#include <pw85_simulation.h>
#include <pw85_systems.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

/// Type numbers of NumPy; other structs are records of their size.
template <class Element> constexpr int number_of_type = NPY_VOID;
template <> constexpr int number_of_type<double> = NPY_DOUBLE;
template <> constexpr int number_of_type<std::int32_t> = NPY_INT32;
template <> constexpr int number_of_type<std::int64_t> = NPY_INT64;
template <> constexpr int number_of_type<unsigned char> = NPY_UINT8;

/// Reads the arguments of a call in their order. After an exception the others are zero or null.
class Arguments {
  public:
    Arguments(PyObject *const *args, Py_ssize_t given, Py_ssize_t expected) : next_(args)
    {
        right_number(given, expected);
    }

    template <class Object> Object *object(char const *name)
    {
        PyObject *const capsule = next();
        return capsule == nullptr ? nullptr
                                  : static_cast<Object *>(PyCapsule_GetPointer(capsule, name));
    }

    std::size_t size()
    {
        PyObject *const number = next();
        return number == nullptr ? 0 : PyLong_AsSize_t(number);
    }

    int integer()
    {
        PyObject *const number = next();
        return number == nullptr ? 0 : static_cast<int>(PyLong_AsLong(number));
    }

    double real()
    {
        PyObject *const number = next();
        return number == nullptr ? 0.0 : PyFloat_AsDouble(number);
    }

    void *address()
    {
        PyObject *const number = next();
        return number == nullptr ? nullptr : PyLong_AsVoidPtr(number);
    }

    /// An array of `count` numbers, which may be a square matrix; null for None, if that is
    /// allowed.
    template <class Element> Element *numbers(npy_intp count, bool optional)
    {
        auto *const array = reinterpret_cast<PyArrayObject *>(*next_);
        bool const is_matrix = !PyErr_Occurred() && PyArray_Check(*next_) &&
                               PyArray_NDIM(array) == 2 &&
                               PyArray_DIM(array, 1) * PyArray_DIM(array, 1) == count;
        npy_intp const columns = is_matrix ? PyArray_DIM(array, 1) : 0;
        npy_intp n = is_matrix ? columns : count;
        return rows<Element>(n, columns, optional);
    }

    /// An array of n rows, or of as many as it has if n < 0.
    template <class Element> Element *rows(npy_intp &n, npy_intp columns, bool optional)
    {
        using Plain = std::remove_const_t<Element>;
        PyObject *const array = next();
        if (array == nullptr || (optional && array == Py_None)) return nullptr;
        void *const data =
            data_of(array, number_of_type<Plain>, n, columns, !std::is_const_v<Element>);
        if (data == nullptr) return nullptr;
        auto *const found = reinterpret_cast<PyArrayObject *>(array);
        if (PyArray_ITEMSIZE(found) == static_cast<npy_intp>(sizeof(Element)))
            return static_cast<Element *>(data);
        PyErr_SetString(PyExc_TypeError, "an array of other records was expected");
        return nullptr;
    }

  private:
    PyObject *next() { return PyErr_Occurred() ? nullptr : *next_++; }

    PyObject *const *next_;
};

std::size_t size_of(npy_intp n) { return n < 0 ? 0 : static_cast<std::size_t>(n); }

/// The result of a function, for which other threads of Python do not wait.
template <class Function> auto unlocked(Function const &function)
{
    decltype(function()) result;
    Py_BEGIN_ALLOW_THREADS;
    result = function();
    Py_END_ALLOW_THREADS;
    return result;
}

/// A new object, or null.
template <class Object> struct Made {
    Object *const &object;
    char const *name;
    void (*destroy)(PyObject *);
};

template <class Object, void (*destroy_object)(Object *)> void destroy(PyObject *capsule)
{
    destroy_object(
        static_cast<Object *>(PyCapsule_GetPointer(capsule, PyCapsule_GetName(capsule))));
}

template <class Object> PyObject *value_of(Made<Object> const &made)
{
    return made.object == nullptr ? Py_NewRef(Py_None)
                                  : PyCapsule_New(made.object, made.name, made.destroy);
}

PyObject *value_of(double x) { return PyFloat_FromDouble(x); }

template <class Integer>
requires std::is_integral_v<Integer> PyObject *value_of(Integer n)
{
    if constexpr (std::is_unsigned_v<Integer>) return PyLong_FromSize_t(n);
    return PyLong_FromLongLong(static_cast<long long>(n));
}

template <class Number, std::size_t n> PyObject *value_of(Number const (&numbers)[n])
{
    Reference tuple(PyTuple_New(static_cast<Py_ssize_t>(n)));
    for (std::size_t k = 0; tuple && k < n; ++k) {
        PyObject *const number = value_of(numbers[k]);
        if (number == nullptr) return nullptr;
        PyTuple_SetItem(tuple.get(), static_cast<Py_ssize_t>(k), number);
    }
    return tuple.release();
}

/// A status or a size alone.
template <class Result> PyObject *returned(Result result) { return value_of(result); }

/// A tuple of the status and the outputs.
template <class First, class... Outputs>
PyObject *returned(int status, First const &first, Outputs const &...outputs)
{
    Reference const values[] = {Reference(value_of(status)), Reference(value_of(first)),
                                Reference(value_of(outputs))...};
    Py_ssize_t const n = 2 + sizeof...(outputs);
    Reference tuple(PyTuple_New(n));
    for (Py_ssize_t k = 0; tuple && k < n; ++k) {
        if (!values[k]) return nullptr;
        PyTuple_SetItem(tuple.get(), k, Py_NewRef(values[k].get()));
    }
    return tuple.release();
}

/// Rows of an object as an array, which keeps it alive and cannot be written to; None for null.
template <class Number>
Reference view_of(Number const *data, std::size_t rows, npy_intp columns, PyObject *owner)
{
    if (data == nullptr && rows > 0) return Reference(Py_NewRef(Py_None));
    npy_intp const shape[] = {static_cast<npy_intp>(rows), columns};
    Reference array(
        PyArray_SimpleNewFromData(2, shape, number_of_type<Number>, const_cast<Number *>(data)));
    if (!array) return nullptr;
    auto *const object = reinterpret_cast<PyArrayObject *>(array.get());
    PyArray_CLEARFLAGS(object, NPY_ARRAY_WRITEABLE);
    if (data != nullptr && PyArray_SetBaseObject(object, Py_NewRef(owner)) != 0) return nullptr;
    return array;
}

#include "objects.inc"

/// The pairs of a neighbour list, and their images or None.
PyObject *neighbors_list(PyObject *, PyObject *capsule)
{
    auto *const list = Arguments(&capsule, 1, 1).object<pw85_neighbors>("pw85_neighbors");
    if (list == nullptr) return nullptr;
    auto const [size, indices, multiples] = pw85_neighbors_list(list);
    Reference const pairs = view_of(indices, size, 2, capsule);
    Reference const images = view_of(multiples, size, PW85_DIM, capsule);
    if (!pairs || !images) return nullptr;
    return Py_BuildValue("OO", pairs.get(), images.get());
}

/// Centres, forms, semi-axes, quaternions and cell or None of a simulation, and along which vectors
/// it is periodic.
PyObject *hard_ellipsoids_views(PyObject *, PyObject *capsule)
{
    auto *const simulation =
        Arguments(&capsule, 1, 1).object<pw85_hard_ellipsoids>("pw85_hard_ellipsoids");
    if (simulation == nullptr) return nullptr;
    auto const [n, centers, q, cell, periodic] = pw85_hard_ellipsoids_system(simulation);
    Reference const views[] = {view_of(centers, n, 3, capsule), view_of(q, n, 6, capsule),
                               view_of(pw85_hard_ellipsoids_semi_axes(simulation), n, 3, capsule),
                               view_of(pw85_hard_ellipsoids_quaternions(simulation), n, 4, capsule),
                               view_of(cell, 3, 3, capsule)};
    for (Reference const &one : views)
        if (!one) return nullptr;
    return Py_BuildValue("OOOOO(iii)", views[0].get(), views[1].get(), views[2].get(),
                         views[3].get(), views[4].get(), periodic[0], periodic[1], periodic[2]);
}

PyMethodDef other_methods[] = {
    {"neighbors_list", neighbors_list, METH_O, "Arrays of a neighbour list."},
    {"hard_ellipsoids_views", hard_ellipsoids_views, METH_O, "Arrays of a simulation."},
    {nullptr, nullptr, 0, nullptr},
};

} // namespace

bool add_objects(PyObject *module)
{
    return PyModule_AddFunctions(module, made_methods) == 0 &&
           PyModule_AddFunctions(module, other_methods) == 0;
}

} // namespace pypw85
