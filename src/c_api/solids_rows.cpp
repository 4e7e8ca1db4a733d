// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: distances to shapes.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_distance_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                                double *distance, double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_segment_batch", "end1", "end2", "q",
                                            "distance", "point1", "point2", "normal"};
    return each_row(names, n, pw85_distance_segment, RowsOf<3>{end1}, RowsOf<3>{end2}, RowsOf<6>{q},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point1},
                    OptionalRowsOf<3>{point2}, OptionalRowsOf<3>{normal});
}

int pw85_distance_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                 double const *vertex3, double const *q, double *distance,
                                 double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_triangle_batch", "vertex1", "vertex2",
                                            "vertex3", "q", "distance", "point1", "point2",
                                            "normal"};
    return each_row(names, n, pw85_distance_triangle, RowsOf<3>{vertex1}, RowsOf<3>{vertex2},
                    RowsOf<3>{vertex3}, RowsOf<6>{q}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<3>{point1}, OptionalRowsOf<3>{point2},
                    OptionalRowsOf<3>{normal});
}

int pw85_distance_solid_box_batch(size_t n, double const *lower, double const *upper,
                                  double const *q, double *distance, double *point1, double *point2,
                                  double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_solid_box_batch", "lower", "upper", "q",
                                            "distance", "point1", "point2", "normal"};
    return each_row(names, n, pw85_distance_solid_box, RowsOf<3>{lower}, RowsOf<3>{upper},
                    RowsOf<6>{q}, OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point1},
                    OptionalRowsOf<3>{point2}, OptionalRowsOf<3>{normal});
}

int pw85_contact_capsule_batch(size_t n, double const *end1, double const *end2,
                               double const *radius, double const *q, double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_capsule_batch", "end1", "end2", "radius",
                                            "q", "mu2", "point"};
    return each_row(names, n, pw85_contact_capsule, RowsOf<3>{end1}, RowsOf<3>{end2},
                    Numbers{radius}, RowsOf<6>{q}, OptionalRowsOf<1>{mu2},
                    OptionalRowsOf<3>{point});
}

int pw85_overlap_capsule_batch(size_t n, double const *end1, double const *end2,
                               double const *radius, double const *q, unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_capsule_batch", "end1", "end2", "radius",
                                            "q", "overlap"};
    return each_row(names, n, pw85_overlap_capsule, RowsOf<3>{end1}, RowsOf<3>{end2},
                    Numbers{radius}, RowsOf<6>{q}, Bytes{overlap});
}

int pw85_distance_capsule_batch(size_t n, double const *end1, double const *end2,
                                double const *radius, double const *q, double *distance,
                                double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_capsule_batch", "end1", "end2", "radius",
                                            "q", "distance", "point1", "point2", "normal"};
    return each_row(names, n, pw85_distance_capsule, RowsOf<3>{end1}, RowsOf<3>{end2},
                    Numbers{radius}, RowsOf<6>{q}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<3>{point1}, OptionalRowsOf<3>{point2},
                    OptionalRowsOf<3>{normal});
}
