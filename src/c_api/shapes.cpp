// SPDX-License-Identifier: BSD-3-Clause
// The C API of an ellipsoid and convex sets. The functions check for null pointers. Kernels compute
// ordinary segments, triangles and boxes; the core checks and computes everything else. Other units
// share what computes that, and polytopes (PW85_SHARED_BY_QUESTIONS).
#include <pw85.h>

#include <pw85/shapes/overlap_polytope.hpp>

#include <climits>
#include <cstdint>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"
#include "../simd/define_shared.hpp"
#include "../simd/one_set.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

using HullOfSegment = Hull<double, 2>; // macros take no commas
using HullOfTriangle = Hull<double, 3>;

PW85_DEFINE_SHARED(search_polytope, double)
PW85_DEFINE_SHARED(check_planes, double)
PW85_DEFINE_SHARED(decide_polytope, double)
PW85_DEFINE_SHARED(contact_points_scaled, double, 2, FindOnSegment<>)
PW85_DEFINE_SHARED(contact_points_scaled, double, 3, FindOnTriangle<>)
PW85_DEFINE_SHARED(overlap_of_any, double, HullOfSegment)
PW85_DEFINE_SHARED(overlap_of_any, double, HullOfTriangle)
PW85_DEFINE_SHARED(overlap_of_any, double, SolidBox<double>)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

/// Returns the status for a null pointer; it marks the answer.
int null_overlap(int *overlap) noexcept
{
    if (overlap != nullptr) *overlap = -1;
    return null_pointer();
}

/// The answer of the core where the kernel has none: from its second tier on, because the kernel is
/// the first one. The functions are not inlined, because each call would save registers that only
/// they need.
template <class Core, class... Points> [[gnu::noinline, gnu::cold]] int
contact_of_core(Core core, double *mu2, double *point, double const *q, Points... points) noexcept
{
    return in_default_environment([&] {
        auto const result = core(load_matrix<3>(q), load_vector<3>(points)...);
        return put(result.status, result.mu2, mu2, result.point, point);
    });
}

template <class Make, class... Points> [[gnu::noinline, gnu::cold]] int
overlap_of_core(Make make, int *overlap, double const *q, Points... points) noexcept
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
    return contact_points_scaled(hull_of(points...).points, q, Find{});
};

/// Records why a polytope or an ellipsoid is refused. Too many planes are not read.
template <class... Outputs>
[[gnu::cold]] int refuse_polytope(int status, char const *function, size_t n, double const *normals,
                                  double const *offsets, double const *q,
                                  Outputs... outputs) noexcept
{
    if (n > INT_MAX / 3) return refuse_arrays(function, "n", n), status;
    static constexpr double none[1] = {};
    return refuse_call(status, function,
                       Argument("normals", n > 0 ? normals : none, 3 * n, limit::rows_not_zero),
                       Argument("offsets", n > 0 ? offsets : none, n),
                       Argument("q", q, 6, limit::definite), outputs...);
}

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
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_contact_segment", Argument("end1", end1, 3),
                           Argument("end2", end2, 3), Argument("q", q, 6, limit::definite));
    };
    if (any_null(end1, end2, q)) return refused(null_pointer(mu2, 1, point, PW85_DIM));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_segment);
    if (in_default_environment(kernel, end1, end2, q, mu2, point)) return PW85_SUCCESS;
    return checked(contact_of_core(contact_of_hull<FindOnSegment<>>, mu2, point, q, end1, end2),
                   refused);
}

int pw85_contact_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3],
                          double const q[6], double *mu2, double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_contact_triangle", Argument("vertex1", vertex1, 3),
                           Argument("vertex2", vertex2, 3), Argument("vertex3", vertex3, 3),
                           Argument("q", q, 6, limit::definite));
    };
    if (any_null(vertex1, vertex2, vertex3, q))
        return refused(null_pointer(mu2, 1, point, PW85_DIM));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_triangle);
    if (in_default_environment(kernel, vertex1, vertex2, vertex3, q, mu2, point))
        return PW85_SUCCESS;
    return checked(contact_of_core(contact_of_hull<FindOnTriangle<>>, mu2, point, q, vertex1,
                                   vertex2, vertex3),
                   refused);
}

int pw85_contact_box(double const lower[3], double const upper[3], double const q[6], double *mu2,
                     double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_contact_box",
                           Argument("lower", lower, 3, limit::below_next),
                           Argument("upper", upper, 3), Argument("q", q, 6, limit::definite));
    };
    if (any_null(lower, upper, q)) return refused(null_pointer(mu2, 1, point, PW85_DIM));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), contact_box);
    if (in_default_environment(kernel, lower, upper, q, mu2, point)) return PW85_SUCCESS;
    return checked(contact_of_core([](auto const &form,
                                      auto const &...x) { return contact_box_scaled(x..., form); },
                                   mu2, point, q, lower, upper),
                   refused);
}

int pw85_overlap_segment(double const end1[3], double const end2[3], double const q[6],
                         int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_overlap_segment", Argument("end1", end1, 3),
                           Argument("end2", end2, 3), Argument("q", q, 6, limit::definite),
                           Argument("overlap", overlap));
    };
    if (any_null(end1, end2, q, overlap)) return refused(null_overlap(overlap));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_segment);
    if (in_default_environment(kernel, end1, end2, q, overlap)) return PW85_SUCCESS;
    return checked(overlap_of_core(hull_of, overlap, q, end1, end2), refused);
}

int pw85_overlap_triangle(double const vertex1[3], double const vertex2[3], double const vertex3[3],
                          double const q[6], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_overlap_triangle", Argument("vertex1", vertex1, 3),
                           Argument("vertex2", vertex2, 3), Argument("vertex3", vertex3, 3),
                           Argument("q", q, 6, limit::definite), Argument("overlap", overlap));
    };
    if (any_null(vertex1, vertex2, vertex3, q, overlap)) return refused(null_overlap(overlap));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_triangle);
    if (in_default_environment(kernel, vertex1, vertex2, vertex3, q, overlap)) return PW85_SUCCESS;
    return checked(overlap_of_core(hull_of, overlap, q, vertex1, vertex2, vertex3), refused);
}

int pw85_overlap_box(double const lower[3], double const upper[3], double const q[6], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_overlap_box",
                           Argument("lower", lower, 3, limit::below_next),
                           Argument("upper", upper, 3), Argument("q", q, 6, limit::definite),
                           Argument("overlap", overlap));
    };
    if (any_null(lower, upper, q, overlap)) return refused(null_overlap(overlap));
    auto const kernel = PW85_OF_PAIR(kernels::chosen(), overlap_box);
    if (in_default_environment(kernel, lower, upper, q, overlap)) return PW85_SUCCESS;
    return checked(overlap_of_core([](auto const &...x) { return SolidBox<double>{x...}; }, overlap,
                                   q, lower, upper),
                   refused);
}

int pw85_contact_polytope(size_t n, double const *normals, double const *offsets, double const q[6],
                          double *mu2, double point[3])
{
    if (any_null(q) || !are_planes(n, normals, offsets)) {
        null_pointer(mu2, 1, point, PW85_DIM);
        return refuse_polytope(PW85_EINVAL, "pw85_contact_polytope", n, normals, offsets, q);
    }
    int const status = in_default_environment([&] {
        auto const result = contact_polytope(n, normals, offsets, load_matrix<3>(q), {});
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, [&](int bad) {
        return refuse_polytope(bad, "pw85_contact_polytope", n, normals, offsets, q);
    });
}

int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets, double const q[6],
                          int *overlap)
{
    if (any_null(q, overlap) || !are_planes(n, normals, offsets)) {
        null_overlap(overlap);
        return refuse_polytope(PW85_EINVAL, "pw85_overlap_polytope", n, normals, offsets, q,
                               Argument("overlap", overlap));
    }
    *overlap = -1;
    int const status = in_default_environment([&] {
        auto const result = overlap_polytope(n, normals, offsets, load_matrix<3>(q), {});
        return put(result.status, result.overlap, overlap);
    });
    return checked(status, [&](int bad) {
        return refuse_polytope(bad, "pw85_overlap_polytope", n, normals, offsets, q);
    });
}
