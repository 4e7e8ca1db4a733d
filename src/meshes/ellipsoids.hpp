// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The ellipsoids that are given to functions of meshes: their checks, and the loop over many.
/// mesh.cpp and mesh_distance.cpp include this file.
#ifndef PW85_MESHES_ELLIPSOIDS_HPP_INCLUDED
#define PW85_MESHES_ELLIPSOIDS_HPP_INCLUDED

#include <pw85.h>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../rows/each_row.hpp"
#include "search.hpp"

namespace pw85::detail::meshes {
namespace {

/// Returns the status of an ellipsoid. The coordinates of all vertices relative to its centre must
/// be finite.
inline Status validate(pw85_mesh const &mesh, Vector3 const &center, Form3 const &q) noexcept
{
    if (!is_finite(center)) return Status::invalid_argument;
    if (mesh.triangles.size() > 0) {
        neighbors::Box const root = mesh.tree.root();
        for (int d = 0; d < 3; ++d)
            if (!elementary::isfinite(root.lower[d] - center[d]) ||
                !elementary::isfinite(root.upper[d] - center[d]))
                return Status::invalid_argument;
    }
    return detail::validate(q);
}

/// Ellipsoids per block of a thread: each takes some microseconds.
constexpr std::size_t block_of_ellipsoids = 32;

/// Calls row(i), which returns a status, for each of n ellipsoids, in parallel, and returns the
/// status of the first bad one.
template <class Row> int each_ellipsoid(std::size_t n, Row const &row) noexcept
{
    if (n > max_rows)
        return note_cause(PW85_EINVAL, "n",
                          "must be small enough for the bytes of each array to fit ptrdiff_t", 0, 0,
                          static_cast<double>(n));
    return for_all(
        n, [&](Range rows) { return kernels::for_rows(rows, row); }, block_of_ellipsoids);
}

} // namespace
} // namespace pw85::detail::meshes

#endif
