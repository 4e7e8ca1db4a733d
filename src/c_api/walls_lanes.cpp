// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: walls, points and lines.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/lines.hpp"
#include "../simd/lanes/surface_distances.hpp"

using namespace pw85::detail::kernels;

int pw85_distance_cylinder_batch(size_t n, double const *axis, double const *radius,
                                 double const *center, double const *q, double *distance,
                                 double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_cylinder_batch", "axis", "radius",
                                            "center", "q"};
    return compute_rows(names, n, CylinderRows{axis, radius, center, q},
                        SurfaceArrays{distance, point, normal}, axis, radius, center, q);
}

int pw85_distance_point_batch(size_t n, double const *r, double const *q, double *distance,
                              double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_point_batch", "r", "q"};
    return compute_rows(names, n, PointRows{r, q}, SurfaceArrays{distance, point, normal}, r, q);
}

int pw85_intersect_line_batch(size_t n, double const *origin, double const *directions,
                              double const *q, double *enter, double *leave)
{
    static constexpr char const *names[] = {"pw85_intersect_line_batch", "origin", "directions",
                                            "q"};
    return compute_rows(names, n, SetRows<Lines>{{origin, directions}, q},
                        ChordArrays{enter, leave}, origin, directions, q);
}
