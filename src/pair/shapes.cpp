// SPDX-License-Identifier: BSD-3-Clause
// The C API of an ellipsoid and convex sets. The functions check for null pointers. Kernels compute
// ordinary segments, triangles and boxes; the core checks and computes everything else. Rows share
// what computes polytopes (PW85_SHARED_BY_QUESTIONS).
#include <pw85.h>

#include <pw85/shapes/overlap_polytope.hpp>

#include <cstdint>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../simd/define_shared.hpp"
#include "../simd/one_set.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

PW85_SHARED_POLYTOPE(PW85_DEFINE_SHARED, double)
PW85_SHARED_POLYTOPE_DECISION(PW85_DEFINE_SHARED, double)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

/// The status for a null pointer; it marks the answer.
int null_overlap(int *overlap) noexcept
{
    if (overlap != nullptr) *overlap = -1;
    return null_pointer();
}

/// The answer of the core where the kernel has none: from its second tier on, because the kernel is
/// the first one. The functions are not inlined, because each call would save registers that only
/// they need.
template <class Core, class... Points> [[gnu::noinline, gnu::cold]] int
settle_contact(Core core, double *mu2, double *point, double const *q, Points... points) noexcept
{
    return in_default_environment([&] {
        auto const result = core(load_matrix<3>(q), load_vector<3>(points)...);
        return put(result.status, result.mu2, mu2, result.point, point);
    });
}

template <class Make, class... Points> [[gnu::noinline, gnu::cold]] int
settle_overlap(Make make, int *overlap, double const *q, Points... points) noexcept
{
    *overlap = -1;
    return in_default_environment([&] {
        auto const result = overlap_of_any(make(load_vector<3>(points)...), load_matrix<3>(q));
        return put(result.status, result.overlap, overlap);
    });
}

/// A hull of points, and its contact by the tiers after the first one.
constexpr auto hull_of = [](auto const &...points) {
    return Hull<double, int(sizeof...(points))>{{points...}};
};
template <class Find>
constexpr auto contact_of_hull = [](SymmetricMatrix<double, 3> const &q, auto const &...points) {
    return contact_scaled(hull_of(points...).points, q, Find{});
};

/// Returns whether the arrays of planes can be read.
bool are_planes(size_t n, double const *normals, double const *offsets) noexcept
{
    return n == 0 ||
           (n <= PTRDIFF_MAX / (PW85_DIM * sizeof(double)) && !any_null(normals, offsets));
}

} // namespace

int pw85_contact_segment(double const end1[3], double const end2[3], double const q[6], double *mu2,
                         double point[3])
{
    if (any_null(end1, end2, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_segment);
    if (in_default_environment(kernel, end1, end2, q, mu2, point)) return PW85_SUCCESS;
    return settle_contact(contact_of_hull<FindOnSegment<>>, mu2, point, q, end1, end2);
}

int pw85_contact_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3],
                          double const q[6], double *mu2, double point[3])
{
    if (any_null(vertex1, vertex2, vertex3, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_triangle);
    if (in_default_environment(kernel, vertex1, vertex2, vertex3, q, mu2, point))
        return PW85_SUCCESS;
    return settle_contact(contact_of_hull<FindOnTriangle<>>, mu2, point, q, vertex1, vertex2,
                          vertex3);
}

int pw85_contact_box(double const lower[3], double const upper[3], double const q[6], double *mu2,
                     double point[3])
{
    if (any_null(lower, upper, q)) return null_pointer(mu2, 1, point, PW85_DIM);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_box);
    if (in_default_environment(kernel, lower, upper, q, mu2, point)) return PW85_SUCCESS;
    return settle_contact(
        [](auto const &form, auto const &...x) { return contact_box_scaled(x..., form); }, mu2,
        point, q, lower, upper);
}

int pw85_overlap_segment(double const end1[3], double const end2[3], double const q[6],
                         int *overlap)
{
    if (any_null(end1, end2, q, overlap)) return null_overlap(overlap);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_segment);
    if (in_default_environment(kernel, end1, end2, q, overlap)) return PW85_SUCCESS;
    return settle_overlap(hull_of, overlap, q, end1, end2);
}

int pw85_overlap_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3],
                          double const q[6], int *overlap)
{
    if (any_null(vertex1, vertex2, vertex3, q, overlap)) return null_overlap(overlap);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_triangle);
    if (in_default_environment(kernel, vertex1, vertex2, vertex3, q, overlap)) return PW85_SUCCESS;
    return settle_overlap(hull_of, overlap, q, vertex1, vertex2, vertex3);
}

int pw85_overlap_box(double const lower[3], double const upper[3], double const q[6], int *overlap)
{
    if (any_null(lower, upper, q, overlap)) return null_overlap(overlap);
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_box);
    if (in_default_environment(kernel, lower, upper, q, overlap)) return PW85_SUCCESS;
    return settle_overlap([](auto const &...x) { return SolidBox<double>{x...}; }, overlap, q,
                          lower, upper);
}

int pw85_contact_polytope(size_t n, double const *normals, double const *offsets, double const q[6],
                          double *mu2, double point[3])
{
    if (any_null(q) || !are_planes(n, normals, offsets))
        return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment([&] {
        auto const result = contact_polytope(n, normals, offsets, load_matrix<3>(q), {});
        return put(result.status, result.mu2, mu2, result.point, point);
    });
}

int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets, double const q[6],
                          int *overlap)
{
    if (any_null(q, overlap) || !are_planes(n, normals, offsets)) return null_overlap(overlap);
    *overlap = -1;
    return in_default_environment([&] {
        auto const result = overlap_polytope(n, normals, offsets, load_matrix<3>(q), {});
        return put(result.status, result.overlap, overlap);
    });
}
