// SPDX-License-Identifier: BSD-3-Clause
// The functions of many ellipsoids and convex sets of the C API that use lanes. They call the
// driver (many_pairs.hpp).
#include <pw85.h>
#include <pw85_batch.h>

#include <iterator>

#include "../base/c_arrays.hpp"
#include "many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;

namespace {

/// Names of the arrays of a set's points.
template <class Set> constexpr char const *names[3] = {};
template <> constexpr char const *names<Segments>[2] = {"end1", "end2"};
template <> constexpr char const *names<Triangles>[3] = {"vertex1", "vertex2", "vertex3"};
template <> constexpr char const *names<Boxes>[2] = {"lower", "upper"};
template <> constexpr char const *names<Lines>[2] = {"origin", "directions"};

/// Computes n ellipsoids and sets, and returns the status of the first bad one.
template <class Set, class Arrays> int
compute_sets(char const *name, std::size_t n, SetRows<Set> const &rows, Arrays const &out) noexcept
{
    if (n == 0) return PW85_SUCCESS;
    for (std::size_t i = 0; i < std::size(rows.points); ++i)
        if (c_api::any_null(rows.points[i]))
            return refuse_arrays(name, "n", n, NamedArray{names<Set>[i], rows.points[i]});
    if (n > max_rows || c_api::any_null(rows.q))
        return refuse_arrays(name, "n", n, NamedArray{"q", rows.q});
    return compute_all(n, rows, out);
}

template <class Set> int compute_overlaps(char const *name, std::size_t n, SetRows<Set> const &rows,
                                          unsigned char *overlap) noexcept
{
    if (n > 0 && c_api::any_null(overlap))
        return refuse_arrays(name, "n", n, NamedArray{"overlap", overlap});
    return compute_sets(name, n, rows, OverlapArray{overlap});
}

} // namespace

int pw85_contact_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                               double *mu2, double *point)
{
    return compute_sets("pw85_contact_segment_batch", n, SetRows<Segments>{{end1, end2}, q},
                        SetContactArrays{mu2, point});
}

int pw85_contact_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                double const *vertex3, double const *q, double *mu2, double *point)
{
    return compute_sets("pw85_contact_triangle_batch", n,
                        SetRows<Triangles>{{vertex1, vertex2, vertex3}, q},
                        SetContactArrays{mu2, point});
}

int pw85_contact_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                           double *mu2, double *point)
{
    return compute_sets("pw85_contact_box_batch", n, SetRows<Boxes>{{lower, upper}, q},
                        SetContactArrays{mu2, point});
}

int pw85_overlap_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                               unsigned char *overlap)
{
    return compute_overlaps("pw85_overlap_segment_batch", n, SetRows<Segments>{{end1, end2}, q},
                            overlap);
}

int pw85_overlap_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                double const *vertex3, double const *q, unsigned char *overlap)
{
    return compute_overlaps("pw85_overlap_triangle_batch", n,
                            SetRows<Triangles>{{vertex1, vertex2, vertex3}, q}, overlap);
}

int pw85_overlap_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                           unsigned char *overlap)
{
    return compute_overlaps("pw85_overlap_box_batch", n, SetRows<Boxes>{{lower, upper}, q},
                            overlap);
}

int pw85_intersect_line_batch(size_t n, double const *origin, double const *directions,
                              double const *q, double *enter, double *leave)
{
    return compute_sets("pw85_intersect_line_batch", n, SetRows<Lines>{{origin, directions}, q},
                        ChordArrays{enter, leave});
}
