// SPDX-License-Identifier: BSD-3-Clause
// The functions for arrays on a GPU, whose addresses the Python layer reads and has checked.
#include <pw85_gpu.h>

#include <cstring>

#include "calls.hpp"

namespace pypw85 {
namespace {

/// Integers of a call: addresses and sizes.
struct Numbers {
    static constexpr Py_ssize_t most = 16;
    std::uintptr_t values[most];

    double *array(int k) const noexcept { return reinterpret_cast<double *>(values[k]); }
    std::int32_t *indices(int k) const noexcept
    {
        return reinterpret_cast<std::int32_t *>(values[k]);
    }
    unsigned char *codes(int k) const noexcept
    {
        return reinterpret_cast<unsigned char *>(values[k]);
    }
    void *stream() const noexcept { return reinterpret_cast<void *>(values[0]); }
    std::size_t size(int k) const noexcept { return values[k]; }

    /// Of the numbers 1 to 3.
    pw85_pair_list list() const noexcept { return {size(1), indices(2), indices(3)}; }
    /// Of the numbers 4 to 7.
    pw85_system system() const noexcept
    {
        return {size(4), array(5), array(6), array(7), {1, 1, 1}};
    }
};

struct GpuFunction {
    char const *name;
    Py_ssize_t arguments;
    int (*call)(Numbers const &);
};

// Arguments in the order of pw85_gpu.h, from the stream on, with the members of structs in their
// places.
constexpr GpuFunction functions_for_gpus[] = {
    {"contact", 7,
     [](Numbers const &x) {
         return pw85_gpu_contact_batch(x.stream(), x.size(1), x.array(2), x.array(3), x.array(4),
                                       x.array(5), x.array(6));
     }},
    {"overlap", 6,
     [](Numbers const &x) {
         return pw85_gpu_overlap_batch(x.stream(), x.size(1), x.array(2), x.array(3), x.array(4),
                                       x.codes(5));
     }},
    {"contact_derivatives", 12,
     [](Numbers const &x) {
         return pw85_gpu_contact_derivatives_batch(
             x.stream(), x.size(1), x.array(2), x.array(3), x.array(4), x.array(5), x.array(6),
             x.array(7), x.array(8), x.array(9), x.array(10), x.array(11));
     }},
    {"contact_pairs", 10,
     [](Numbers const &x) {
         pw85_pair_list const list = x.list();
         pw85_system const system = x.system();
         return pw85_gpu_contact_pairs(x.stream(), &list, &system, x.array(8), x.array(9));
     }},
    {"overlap_pairs", 9,
     [](Numbers const &x) {
         pw85_pair_list const list = x.list();
         pw85_system const system = x.system();
         return pw85_gpu_overlap_pairs(x.stream(), &list, &system, x.codes(8));
     }},
    {"contact_derivatives_pairs", 15,
     [](Numbers const &x) {
         pw85_pair_list const list = x.list();
         pw85_system const system = x.system();
         return pw85_gpu_contact_derivatives_pairs(x.stream(), &list, &system, x.array(8),
                                                   x.array(9), x.array(10), x.array(11),
                                                   x.array(12), x.array(13), x.array(14));
     }},
};

GpuFunction const *find(char const *name, Py_ssize_t arguments) noexcept
{
    for (GpuFunction const &function : functions_for_gpus)
        if (std::strcmp(function.name, name) == 0 && function.arguments == arguments)
            return &function;
    return nullptr;
}

} // namespace

PyObject *gpu(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    char const *const name = nargs > 0 ? PyUnicode_AsUTF8(args[0]) : "";
    if (name == nullptr) return nullptr;
    GpuFunction const *const function = find(name, nargs - 1);
    if (function == nullptr)
        return PyErr_Format(PyExc_TypeError, "no function %s with this number of arguments", name);
    Numbers numbers{};
    for (Py_ssize_t k = 1; k < nargs; ++k) {
        numbers.values[k - 1] = PyLong_AsSize_t(args[k]);
        if (PyErr_Occurred() != nullptr) return nullptr;
    }
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = function->call(numbers);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

} // namespace pypw85
