// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: shapes.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/shapes.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                               double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_segment_batch", "end1", "end2", "q"};
    return compute_rows(names, n, SetRows<Segments>{{end1, end2}, q}, SetContactArrays{mu2, point},
                        end1, end2, q);
}

int pw85_contact_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                double const *vertex3, double const *q, double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_triangle_batch", "vertex1", "vertex2",
                                            "vertex3", "q"};
    return compute_rows(names, n, SetRows<Triangles>{{vertex1, vertex2, vertex3}, q},
                        SetContactArrays{mu2, point}, vertex1, vertex2, vertex3, q);
}

int pw85_contact_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                           double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_box_batch", "lower", "upper", "q"};
    return compute_rows(names, n, SetRows<Boxes>{{lower, upper}, q}, SetContactArrays{mu2, point},
                        lower, upper, q);
}

int pw85_overlap_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                               unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_segment_batch", "end1", "end2", "q",
                                            "overlap"};
    return compute_rows(names, n, SetRows<Segments>{{end1, end2}, q}, OverlapArray{overlap}, end1,
                        end2, q, overlap);
}

int pw85_overlap_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                double const *vertex3, double const *q, unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_triangle_batch", "vertex1", "vertex2",
                                            "vertex3", "q", "overlap"};
    return compute_rows(names, n, SetRows<Triangles>{{vertex1, vertex2, vertex3}, q},
                        OverlapArray{overlap}, vertex1, vertex2, vertex3, q, overlap);
}

int pw85_overlap_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                           unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_box_batch", "lower", "upper", "q",
                                            "overlap"};
    return compute_rows(names, n, SetRows<Boxes>{{lower, upper}, q}, OverlapArray{overlap}, lower,
                        upper, q, overlap);
}
