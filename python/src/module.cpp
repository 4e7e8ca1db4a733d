// SPDX-License-Identifier: BSD-3-Clause
// The extension module pypw85._core: a ufunc and a callable "call_..." for each function, and the
// pair lists.
#define PYPW85_IMPORTS_NUMPY
#include "calls.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <string>
#include <vector>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_simulation.h>
#include <pw85_systems.h>

namespace pypw85 {
namespace {

/// Everything that ufuncs and callables keep pointers to; never destroyed, as NumPy asks.
struct Registered {
    Callable callable;
    std::string call_name;
    PyMethodDef method;
    PyUFuncGenericFunction loops[2];
    void *data[2];
    char types[2 * max_operands];
};

void describe_loops(Function &function, Registered &registered)
{
    int const operands = function.operands();
    for (int k = 0; k < 2 * operands; ++k) registered.types[k] = NPY_DOUBLE;
    registered.loops[0] = function.is_truth()         ? boolean_loop
                          : function.batch != nullptr ? batch_loop
                                                      : row_loop;
    registered.loops[1] = code_loop;
    registered.data[0] = registered.data[1] = &function;
    if (!function.is_truth()) return;
    registered.types[operands - 1] = NPY_BOOL;
    registered.types[2 * operands - 1] = NPY_UINT8;
}

bool add(PyObject *module, char const *name, Reference object)
{
    return object && PyModule_AddObjectRef(module, name, object.get()) == 0;
}

bool register_function(PyObject *module, Function &function)
{
    parse_signature(function);
    auto *const registered = new Registered{};
    describe_loops(function, *registered);
    Reference ufunc(PyUFunc_FromFuncAndDataAndSignature(
        registered->loops, registered->data, registered->types, function.is_truth() ? 2 : 1,
        function.nin, function.nout, PyUFunc_None, function.name,
        "Generalised ufunc; see the function of this name in pypw85 or "
        "pypw85.legacy.",
        0, function.signature));
    registered->callable = {&function, ufunc.get(), nullptr};
    registered->call_name = std::string("call_") + function.name;
    registered->method = {registered->call_name.c_str(),
                          reinterpret_cast<PyCFunction>(reinterpret_cast<void *>(call)),
                          METH_FASTCALL, "call(input..., out, keywords)"};
    Reference const capsule(PyCapsule_New(&registered->callable, nullptr, nullptr));
    if (!capsule) return false;
    Reference callable(PyCFunction_New(&registered->method, capsule.get()));
    registered->callable.object = callable.get();
    return add(module, function.name, std::move(ufunc)) &&
           add(module, registered->call_name.c_str(), std::move(callable));
}

/// Ufuncs whose only purpose is to let NumPy report a failed call of this name as np.errstate says.
bool register_report(PyObject *module, char const *name, char const *attribute)
{
    static PyUFuncGenericFunction loops[] = {report_loop};
    static void *data[] = {nullptr};
    static char types[] = {NPY_LONG, NPY_DOUBLE};
    return add(module, attribute,
               Reference(PyUFunc_FromFuncAndData(loops, data, types, 1, 1, 1, PyUFunc_None, name,
                                                 "Reports statuses that are not zero.", 0)));
}

/// Names and values of the statuses, without the prefix.
Reference statuses()
{
    Reference dict(PyDict_New());
    bool good = dict != nullptr;
#define PYPW85_ADD_STATUS(c_name, cpp_name, value, text)                                           \
    {                                                                                              \
        Reference const number(PyLong_FromLong(value));                                            \
        good = good && number &&                                                                   \
               PyDict_SetItemString(dict.get(), &#c_name[sizeof "PW85_" - 1], number.get()) == 0;  \
    }
    PW85_STATUS_LIST(PYPW85_ADD_STATUS)
#undef PYPW85_ADD_STATUS
    return good ? std::move(dict) : nullptr;
}

PyObject *version(PyObject *, PyObject *) { return PyUnicode_FromString(pw85_version()); }

/// The cause of the last refusal in this thread: function, argument or None, requirement, row,
/// entry and value.
PyObject *last_error(PyObject *, PyObject *)
{
    pw85_error error;
    pw85_last_error(&error);
    if (error.function == nullptr) Py_RETURN_NONE;
    return Py_BuildValue("zzznnd", error.function, error.argument, error.requirement,
                         static_cast<Py_ssize_t>(error.row), static_cast<Py_ssize_t>(error.entry),
                         error.value);
}

PyObject *strerror(PyObject *, PyObject *status)
{
    long const number = PyLong_AsLong(status);
    if (number == -1 && PyErr_Occurred()) return nullptr;
    bool const is_int = number == static_cast<int>(number);
    return PyUnicode_FromString(pw85_strerror(is_int ? static_cast<int>(number) : -1));
}

/// Returns 1 or 0 for True, False, or the integers 1 and 0; -1 for anything else.
int truth_of(PyObject *value)
{
    if (PyBool_Check(value) || PyArray_IsScalar(value, Bool)) return PyObject_IsTrue(value);
    int overflow = 0;
    long const number = PyLong_Check(value) ? PyLong_AsLongAndOverflow(value, &overflow) : -1;
    return number == 0 || number == 1 ? static_cast<int>(number) : -1;
}

PyObject *set_reproducible(PyObject *, PyObject *on)
{
    int const truth = truth_of(on);
    if (truth < 0)
        return PyErr_Format(PyExc_TypeError, "set_reproducible: on must be True or False, not %R",
                            on);
    pw85_set_reproducible(truth);
    Py_RETURN_NONE;
}

PyObject *is_reproducible(PyObject *, PyObject *)
{
    int on = 0;
    pw85_is_reproducible(&on);
    return PyBool_FromLong(on);
}

/// For this thread, and those that it starts. Without OpenMP there is one thread.
PyObject *set_num_threads(PyObject *, PyObject *number)
{
    long const threads = PyLong_AsLong(number);
    if (threads == -1 && PyErr_Occurred()) return nullptr;
#ifdef _OPENMP
    omp_set_num_threads(static_cast<int>(threads));
#endif
    Py_RETURN_NONE;
}

PyMethodDef methods[] = {
    {"version", version, METH_NOARGS,
     "version()\n--\n\nVersion of the library, 'major.minor.patch'."},
    {"set_reproducible", set_reproducible, METH_O,
     "set_reproducible(on, /)\n--\n\n"
     "Switch the reproducible mode on or off, for all threads of the process.\n\n"
     "In this mode all functions of pairs give the same bits on every processor and with every "
     "number of threads; "
     "those\n"
     "of arrays are slower. `contact_function` returns the numbers of `contact`. The functions of "
     "Zheng and those for\n"
     "arrays of a GPU do not follow the mode. The environment variable PW85_REPRODUCIBLE=1 starts "
     "a process in it."},
    {"is_reproducible", is_reproducible, METH_NOARGS,
     "is_reproducible()\n--\n\nWhether the reproducible mode is on: see `set_reproducible`."},
    {"set_num_threads", set_num_threads, METH_O,
     "Sets the number of threads of functions that this thread calls."},
    {"last_error", last_error, METH_NOARGS,
     "Cause of the last refusal, or None: function, argument, requirement, row, entry, value."},
    {"strerror", strerror, METH_O,
     "strerror(status, /)\n--\n\nSentence that says what a status means."},
    {"gpu", as_method(gpu), METH_FASTCALL, "Status of a function for arrays on a GPU."},
    {"dlpack_view", dlpack_view, METH_O, "What DLPack says of an array."},
    {"dlpack_export", as_method(dlpack_export), METH_FASTCALL, "An array for DLPack."},
    {"device_memory", device_memory, METH_O, "Memory on a GPU."},
    {"device_wait", device_wait, METH_O, "Whether the work of a stream was done."},
    {"parse_rows", parse_rows, METH_VARARGS, "Rows of a table in a text file."},
    {"nd_one_pair", as_method(nd_one_pair), METH_FASTCALL,
     "Outputs of a function of one pair in n dimensions, or None."},
    {"format_rows", format_rows, METH_VARARGS, "Text of the rows of a table."},
    {nullptr, nullptr, 0, nullptr},
};

PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    "_core",
    "The compiled part of pypw85.",
    -1,
    methods,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
};

#ifdef _OPENMP
PyObject *limit_threads(PyObject *, PyObject *)
{
    omp_set_num_threads(1);
    Py_RETURN_NONE;
}

PyMethodDef after_fork = {"limit_threads", limit_threads, METH_NOARGS,
                          "For a process that was forked."};
#endif

/// The threads of GNU OpenMP do not survive fork(), on which multiprocessing may rely: the child
/// would wait for them for ever. One thread, the child's own, needs no others. Python's handlers
/// come after those of pthread_atfork(), where PyTorch sets its own number.
bool limit_threads_after_fork()
{
#ifdef _OPENMP
    Reference os(PyImport_ImportModule("os"));
    if (os == nullptr) return false;
    // a system without fork()
    if (!PyObject_HasAttrString(os.get(), "register_at_fork")) return true;
    Reference function(PyObject_GetAttrString(os.get(), "register_at_fork")), none(PyTuple_New(0));
    Reference handler(PyCFunction_New(&after_fork, nullptr));
    if (function == nullptr || none == nullptr || handler == nullptr) return false;
    Reference keywords(Py_BuildValue("{s:O}", "after_in_child", handler.get()));
    return keywords != nullptr &&
           Reference(PyObject_Call(function.get(), none.get(), keywords.get())) != nullptr;
#else
    return true;
#endif
}

/// Python without its lock may keep it off: after the import nothing here is written to but what a
/// call owns, and simulations have locks of their own (HardEllipsoids).
bool declare_free_threading([[maybe_unused]] PyObject *module)
{
#ifdef Py_GIL_DISABLED
    return PyUnstable_Module_SetGIL(module, Py_MOD_GIL_NOT_USED) == 0;
#else
    return true;
#endif
}

PyObject *create_module()
{
    Reference module(PyModule_Create(&definition));
    bool good = module != nullptr && declare_free_threading(module.get()) &&
                add(module.get(), "STATUSES", statuses()) &&
                add(module.get(), "LAMBDA_ATOL", Reference(PyFloat_FromDouble(PW85_LAMBDA_ATOL)));
    for (Function &function : functions()) good = good && register_function(module.get(), function);
    good = good && register_report(module.get(), "contact_pairs", "report_contact_pairs") &&
           register_report(module.get(), "overlap_pairs", "report_overlap_pairs") &&
           register_report(module.get(), "overlap_volume_pairs", "report_overlap_volume_pairs") &&
           register_report(module.get(), "Mesh.contact", "report_mesh_contact") &&
           register_report(module.get(), "Mesh.distance", "report_mesh_distance");
    good = good && add_objects(module.get());
    return good && limit_threads_after_fork() ? module.release() : nullptr;
}

} // namespace
} // namespace pypw85

PyMODINIT_FUNC PyInit__core()
{
    import_array();
    import_umath();
    return pypw85::create_module();
}
