// SPDX-License-Identifier: BSD-3-Clause
// Neighbour lists and systems. The Python layer converts and explains; what would read or write
// beyond an array is refused here.
#include <cstdint>

#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

struct PairList {
    npy_intp num_pairs = -1;
    npy_intp num_particles = -1;
    pw85_pair_list list = {};
    pw85_system system = {0, nullptr, nullptr, nullptr, {1, 1, 1}};
};

/// Reads a cell, or None as null.
bool read_cell(PyObject *argument, double const *&cell)
{
    npy_intp three = 3;
    if (argument == Py_None) return true;
    cell = static_cast<double const *>(data_of(argument, NPY_DOUBLE, three, PW85_DIM, false));
    return cell != nullptr;
}

/// Reads the arguments pairs, centers, q or None, cell or None, images or None.
bool read_pair_list(PyObject *const *args, PairList &read)
{
    pw85_pair_list &list = read.list;
    pw85_system &system = read.system;
    list.pairs =
        static_cast<std::int32_t const *>(data_of(args[0], NPY_INT32, read.num_pairs, 2, false));
    if (list.pairs == nullptr) return false;
    list.num_pairs = static_cast<size_t>(read.num_pairs);
    system.centers = static_cast<double const *>(
        data_of(args[1], NPY_DOUBLE, read.num_particles, PW85_DIM, false));
    if (system.centers == nullptr) return false;
    system.num_particles = static_cast<size_t>(read.num_particles);
    if (args[2] != Py_None) {
        system.q = static_cast<double const *>(
            data_of(args[2], NPY_DOUBLE, read.num_particles, PW85_SYM, false));
        if (system.q == nullptr) return false;
    }
    if (!read_cell(args[3], system.cell)) return false;
    if (args[4] == Py_None) return true;
    list.images = static_cast<std::int32_t const *>(
        data_of(args[4], NPY_INT32, read.num_pairs, PW85_DIM, false));
    return list.images != nullptr;
}

} // namespace

PyObject *contact_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 7) || !read_pair_list(args, read)) return nullptr;
    auto *const mu2 = static_cast<double *>(data_of(args[5], NPY_DOUBLE, read.num_pairs, 0, true));
    if (mu2 == nullptr) return nullptr;
    auto *const lambda =
        static_cast<double *>(data_of(args[6], NPY_DOUBLE, read.num_pairs, 0, true));
    if (lambda == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_contact_pairs(&read.list, &read.system, mu2, lambda);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *overlap_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 6) || !read_pair_list(args, read)) return nullptr;
    auto *const overlap =
        static_cast<unsigned char *>(data_of(args[5], NPY_UINT8, read.num_pairs, 0, true));
    if (overlap == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_overlap_pairs(&read.list, &read.system, overlap);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *overlap_volume_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 6) || !read_pair_list(args, read)) return nullptr;
    auto *const volume =
        static_cast<double *>(data_of(args[5], NPY_DOUBLE, read.num_pairs, 0, true));
    if (volume == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_overlap_volume_pairs(&read.list, &read.system, volume);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *contact_derivatives_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 12) || !read_pair_list(args, read)) return nullptr;
    double *out[7];
    for (int k = 0; k < 7; ++k) {
        out[k] = static_cast<double *>(
            data_of(args[5 + k], NPY_DOUBLE, read.num_pairs, k < 2 ? 0 : PW85_DIM, true));
        if (out[k] == nullptr) return nullptr;
    }
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_contact_derivatives_pairs(&read.list, &read.system, out[0], out[1], out[2],
                                            out[3], out[4], out[5], out[6]);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *first_contact_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 10) || !read_pair_list(args, read)) return nullptr;
    static_assert(sizeof(pw85_motion) == 7 * sizeof(double));
    auto const *const motions = static_cast<pw85_motion const *>(
        data_of(args[5], NPY_DOUBLE, read.num_particles, 7, false));
    if (motions == nullptr) return nullptr;
    double const t_max = PyFloat_AsDouble(args[6]);
    if (PyErr_Occurred()) return nullptr;
    auto *const t = static_cast<double *>(data_of(args[7], NPY_DOUBLE, read.num_pairs, 0, true));
    if (t == nullptr) return nullptr;
    auto *const next =
        static_cast<double *>(data_of(args[8], NPY_DOUBLE, read.num_particles, 0, true));
    if (next == nullptr) return nullptr;
    auto *const next_pair =
        static_cast<std::int64_t *>(data_of(args[9], NPY_INT64, read.num_particles, 0, true));
    if (next_pair == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_first_contact_pairs(&read.list, &read.system, motions, t_max, t, next, next_pair);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *overlap_any(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp one = 1, n = -1;
    if (!right_number(nargs, 3)) return nullptr;
    auto const *const q1 =
        static_cast<double const *>(data_of(args[0], NPY_DOUBLE, one, PW85_SYM, false));
    if (q1 == nullptr) return nullptr;
    auto const *const r12 =
        static_cast<double const *>(data_of(args[1], NPY_DOUBLE, n, PW85_DIM, false));
    if (r12 == nullptr) return nullptr;
    auto const *const q2 =
        static_cast<double const *>(data_of(args[2], NPY_DOUBLE, n, PW85_SYM, false));
    if (q2 == nullptr) return nullptr;
    int status, any;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_overlap_any(q1, static_cast<size_t>(n), r12, q2, &any);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, any);
}

PyObject *nearest_images(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp num_pairs = -1, num_particles = -1, cell_rows = 3;
    if (!right_number(nargs, 5)) return nullptr;
    auto const *const pairs =
        static_cast<std::int32_t const *>(data_of(args[0], NPY_INT32, num_pairs, 2, false));
    if (pairs == nullptr) return nullptr;
    auto const *const centers =
        static_cast<double const *>(data_of(args[1], NPY_DOUBLE, num_particles, PW85_DIM, false));
    if (centers == nullptr) return nullptr;
    auto const *const cell =
        static_cast<double const *>(data_of(args[2], NPY_DOUBLE, cell_rows, PW85_DIM, false));
    if (cell == nullptr) return nullptr;
    auto *const r12 =
        static_cast<double *>(data_of(args[3], NPY_DOUBLE, num_pairs, PW85_DIM, true));
    if (r12 == nullptr) return nullptr;
    auto *const images =
        static_cast<std::int32_t *>(data_of(args[4], NPY_INT32, num_pairs, PW85_DIM, true));
    if (images == nullptr) return nullptr;
    pw85_system const system = {
        static_cast<size_t>(num_particles), centers, nullptr, cell, {1, 1, 1}};
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_nearest_images(static_cast<size_t>(num_pairs), pairs, &system, r12, images);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *overlap_any_indices(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp one = 1, n = -1, num_particles = -1;
    if (!right_number(nargs, 7)) return nullptr;
    auto const *const center =
        static_cast<double const *>(data_of(args[0], NPY_DOUBLE, one, PW85_DIM, false));
    if (center == nullptr) return nullptr;
    auto const *const q1 =
        static_cast<double const *>(data_of(args[1], NPY_DOUBLE, one, PW85_SYM, false));
    if (q1 == nullptr) return nullptr;
    auto const *const indices =
        static_cast<std::int32_t const *>(data_of(args[2], NPY_INT32, n, 0, false));
    if (indices == nullptr) return nullptr;
    auto const *const centers =
        static_cast<double const *>(data_of(args[3], NPY_DOUBLE, num_particles, PW85_DIM, false));
    if (centers == nullptr) return nullptr;
    auto const *const q =
        static_cast<double const *>(data_of(args[4], NPY_DOUBLE, num_particles, PW85_SYM, false));
    if (q == nullptr) return nullptr;
    double const *cell = nullptr;
    if (!read_cell(args[5], cell)) return nullptr;
    std::int32_t const *images = nullptr;
    if (args[6] != Py_None) {
        images = static_cast<std::int32_t const *>(data_of(args[6], NPY_INT32, n, PW85_DIM, false));
        if (images == nullptr) return nullptr;
    }
    pw85_system const system = {static_cast<size_t>(num_particles), centers, q, cell, {1, 1, 1}};
    int status, any;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_overlap_any_indices(center, q1, &system, static_cast<size_t>(n), indices, images,
                                      &any);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("ii", status, any);
}

PyObject *contact_forces_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 12) || !read_pair_list(args, read)) return nullptr;
    npy_intp three = 3;
    auto const *const d_u =
        static_cast<double const *>(data_of(args[5], NPY_DOUBLE, read.num_pairs, 0, false));
    if (d_u == nullptr) return nullptr;
    double const *in[3];
    double *out[3];
    for (int k = 0; k < 3; ++k) {
        in[k] = static_cast<double const *>(
            data_of(args[6 + k], NPY_DOUBLE, read.num_pairs, PW85_DIM, false));
        npy_intp &rows = k < 2 ? read.num_particles : three;
        if (in[k] == nullptr) return nullptr;
        out[k] = static_cast<double *>(data_of(args[9 + k], NPY_DOUBLE, rows, PW85_DIM, true));
        if (out[k] == nullptr) return nullptr;
    }
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_contact_forces_pairs(&read.list, &read.system, d_u, in[0], in[1], in[2], out[0],
                                       out[1], out[2]);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *law_forces_pairs(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    PairList read;
    if (!right_number(nargs, 11) || !read_pair_list(args, read)) return nullptr;
    npy_intp num_parameters = -1, one = 1, three = 3;
    long const kind = PyLong_AsLong(args[5]);
    if (PyErr_Occurred()) return nullptr;
    auto const *const parameters =
        static_cast<double const *>(data_of(args[6], NPY_DOUBLE, num_parameters, 0, false));
    if (parameters == nullptr) return nullptr;
    auto *const energy = static_cast<double *>(data_of(args[7], NPY_DOUBLE, one, 0, true));
    if (energy == nullptr) return nullptr;
    double *out[3];
    for (int k = 0; k < 3; ++k) {
        npy_intp &rows = k < 2 ? read.num_particles : three;
        out[k] = static_cast<double *>(data_of(args[8 + k], NPY_DOUBLE, rows, PW85_DIM, true));
        if (out[k] == nullptr) return nullptr;
    }
    pw85_law const law = {static_cast<int>(kind), static_cast<size_t>(num_parameters), parameters};
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_law_forces_pairs(&read.list, &read.system, &law, energy, out[0], out[1], out[2]);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *nearest_image_limit(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp n = -1, cell_rows = 3;
    if (!right_number(nargs, 2)) return nullptr;
    auto const *const q =
        static_cast<double const *>(data_of(args[0], NPY_DOUBLE, n, PW85_SYM, false));
    if (q == nullptr) return nullptr;
    auto const *const cell =
        static_cast<double const *>(data_of(args[1], NPY_DOUBLE, cell_rows, PW85_DIM, false));
    if (cell == nullptr) return nullptr;
    pw85_system const system = {static_cast<size_t>(n), nullptr, q, cell, {1, 1, 1}};
    int status;
    double mu2;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_nearest_image_limit(&system, &mu2);
    Py_END_ALLOW_THREADS;
    return Py_BuildValue("id", status, mu2);
}

} // namespace pypw85
