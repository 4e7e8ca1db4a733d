// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: distances from an ellipsoid's surface.
#include <pw85_batch.h>

#include "../base/c_arrays.hpp"
#include "../simd/surface_distances.hpp"
#include "many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

/// Fifty to a hundred microseconds of work.
static constexpr std::size_t rows_of_block = 1024;

int pw85_distance_point_batch(size_t n, double const *r, double const *q, double *distance,
                              double *point, double *normal)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r, q))
        return refuse_arrays("pw85_distance_point_batch", "n", n, NamedArray{"r", r},
                             NamedArray{"q", q});
    return compute_all(n, PointRows{r, q}, SurfaceArrays{distance, point, normal}, rows_of_block);
}

int pw85_distance_cylinder_batch(size_t n, double const *axis, double const *radius,
                                 double const *center, double const *q, double *distance,
                                 double *point, double *normal)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(axis, radius, center, q))
        return refuse_arrays("pw85_distance_cylinder_batch", "n", n, NamedArray{"axis", axis},
                             NamedArray{"radius", radius}, NamedArray{"center", center},
                             NamedArray{"q", q});
    return compute_all(n, CylinderRows{axis, radius, center, q},
                       SurfaceArrays{distance, point, normal}, rows_of_block);
}
