// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes. The Python layer converts and explains; what would read or write beyond an array
// is refused here.
#include <cstdint>

#include <pw85.h>
#include <pw85_systems.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

constexpr char const *capsule_name = "pw85_mesh";

pw85_mesh *mesh_of(PyObject *capsule)
{
    return static_cast<pw85_mesh *>(PyCapsule_GetPointer(capsule, capsule_name));
}

void destroy(PyObject *capsule) { pw85_mesh_destroy(mesh_of(capsule)); }

/// A mesh, and the centres and forms of ellipsoids: the first three arguments.
struct Problem {
    pw85_mesh const *mesh = nullptr;
    npy_intp n = -1;
    double const *centers = nullptr, *q = nullptr;

    bool read(PyObject *const *args)
    {
        mesh = mesh_of(args[0]);
        if (mesh == nullptr) return false;
        centers = static_cast<double const *>(data_of(args[1], NPY_DOUBLE, n, PW85_DIM, false));
        if (centers == nullptr) return false;
        q = static_cast<double const *>(data_of(args[2], NPY_DOUBLE, n, PW85_SYM, false));
        return q != nullptr;
    }
};

} // namespace

PyObject *mesh_create(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    npy_intp num_vertices = -1, num_triangles = -1;
    if (!right_number(nargs, 2)) return nullptr;
    auto const *const vertices = data_of(args[0], NPY_DOUBLE, num_vertices, PW85_DIM, false);
    if (vertices == nullptr) return nullptr;
    auto const *const triangles = data_of(args[1], NPY_INT32, num_triangles, 3, false);
    if (triangles == nullptr) return nullptr;
    int status;
    pw85_mesh *mesh;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_mesh_create(static_cast<std::size_t>(num_vertices),
                              static_cast<double const *>(vertices),
                              static_cast<std::size_t>(num_triangles),
                              static_cast<std::int32_t const *>(triangles), &mesh);
    Py_END_ALLOW_THREADS;
    if (status != PW85_SUCCESS) return Py_BuildValue("iO", status, Py_None);
    Reference const capsule(PyCapsule_New(mesh, capsule_name, destroy));
    if (!capsule) {
        pw85_mesh_destroy(mesh);
        return nullptr;
    }
    return Py_BuildValue("iO", status, capsule.get());
}

PyObject *mesh_contact(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Problem problem;
    if (!right_number(nargs, 6) || !problem.read(args)) return nullptr;
    auto *const mu2 = static_cast<double *>(data_of(args[3], NPY_DOUBLE, problem.n, 0, true));
    if (mu2 == nullptr) return nullptr;
    auto *const point =
        static_cast<double *>(data_of(args[4], NPY_DOUBLE, problem.n, PW85_DIM, true));
    if (point == nullptr) return nullptr;
    auto *const triangle =
        static_cast<std::int32_t *>(data_of(args[5], NPY_INT32, problem.n, 0, true));
    if (triangle == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_mesh_contact_batch(problem.mesh, static_cast<std::size_t>(problem.n),
                                     problem.centers, problem.q, mu2, point, triangle);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *mesh_distance(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Problem problem;
    if (!right_number(nargs, 9) || !problem.read(args)) return nullptr;
    double *lengths[4];
    for (int k = 0; k < 4; ++k) {
        int const width = k == 0 ? 0 : PW85_DIM;
        lengths[k] =
            static_cast<double *>(data_of(args[3 + k], NPY_DOUBLE, problem.n, width, true));
        if (lengths[k] == nullptr) return nullptr;
    }
    std::int32_t *numbers[2];
    for (int k = 0; k < 2; ++k) {
        numbers[k] =
            static_cast<std::int32_t *>(data_of(args[7 + k], NPY_INT32, problem.n, 0, true));
        if (numbers[k] == nullptr) return nullptr;
    }
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_mesh_distance_batch(problem.mesh, static_cast<std::size_t>(problem.n),
                                      problem.centers, problem.q, lengths[0], lengths[1],
                                      lengths[2], lengths[3], numbers[0], numbers[1]);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *mesh_overlap(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Problem problem;
    if (!right_number(nargs, 4) || !problem.read(args)) return nullptr;
    auto *const overlap =
        static_cast<unsigned char *>(data_of(args[3], NPY_UINT8, problem.n, 0, true));
    if (overlap == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_mesh_overlap_batch(problem.mesh, static_cast<std::size_t>(problem.n),
                                     problem.centers, problem.q, overlap);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

} // namespace pypw85
