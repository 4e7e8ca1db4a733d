// SPDX-License-Identifier: BSD-3-Clause
// Many ellipsoids and one polytope. The Python layer converts and explains; what would read or
// write beyond an array is refused here.
#include <pw85.h>
#include <pw85_batch.h>

#include "arguments.hpp"
#include "calls.hpp"

namespace pypw85 {
namespace {

struct Polytope {
    npy_intp num_ellipsoids = -1, num_planes = -1;
    double const *centers, *q, *normals, *offsets;
};

/// Reads the arguments centers, q, normals, offsets.
bool read_polytope(PyObject *const *args, Polytope &read)
{
    struct {
        double const *&numbers;
        npy_intp &rows, columns;
    } const arrays[] = {{read.centers, read.num_ellipsoids, PW85_DIM},
                        {read.q, read.num_ellipsoids, PW85_SYM},
                        {read.normals, read.num_planes, PW85_DIM},
                        {read.offsets, read.num_planes, 0}};
    for (auto const &array : arrays) {
        array.numbers = static_cast<double const *>(
            data_of(*args++, NPY_DOUBLE, array.rows, static_cast<int>(array.columns), false));
        if (array.numbers == nullptr) return false;
    }
    return true;
}

} // namespace

PyObject *contact_polytope(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Polytope read;
    if (!right_number(nargs, 6) || !read_polytope(args, read)) return nullptr;
    auto *const mu2 =
        static_cast<double *>(data_of(args[4], NPY_DOUBLE, read.num_ellipsoids, 0, true));
    if (mu2 == nullptr) return nullptr;
    auto *const point =
        static_cast<double *>(data_of(args[5], NPY_DOUBLE, read.num_ellipsoids, PW85_DIM, true));
    if (point == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_contact_polytope_batch(static_cast<size_t>(read.num_ellipsoids), read.centers,
                                         read.q, static_cast<size_t>(read.num_planes), read.normals,
                                         read.offsets, mu2, point);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

PyObject *overlap_polytope(PyObject *, PyObject *const *args, Py_ssize_t nargs)
{
    Polytope read;
    if (!right_number(nargs, 5) || !read_polytope(args, read)) return nullptr;
    auto *const overlap =
        static_cast<unsigned char *>(data_of(args[4], NPY_UINT8, read.num_ellipsoids, 0, true));
    if (overlap == nullptr) return nullptr;
    int status;
    Py_BEGIN_ALLOW_THREADS;
    status = pw85_overlap_polytope_batch(static_cast<size_t>(read.num_ellipsoids), read.centers,
                                         read.q, static_cast<size_t>(read.num_planes), read.normals,
                                         read.offsets, overlap);
    Py_END_ALLOW_THREADS;
    return PyLong_FromLong(status);
}

} // namespace pypw85
