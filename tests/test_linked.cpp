// SPDX-License-Identifier: BSD-3-Clause
// The functions of pw85/linked.hpp against the templates whose names they have: each member of each
// result, and each status.
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85/linked.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The members of a result before its status.
template <class Result> std::vector<double> members(Result const &result)
{
    std::vector<double> x(offsetof(Result, status) / sizeof(double));
    std::memcpy(x.data(), &result, x.size() * sizeof(double));
    return x;
}
std::vector<double> members(pw85::Overlap const &result) { return {double(result.overlap)}; }
std::vector<double> members(pw85::Containment const &result) { return {double(result.contains)}; }
std::vector<double> members(pw85::ShapeOverlap const &result) { return {double(result.overlap)}; }
std::vector<double> members(pw85::Comparison const &result) { return {double(result.sign)}; }
std::vector<double> members(pw85::HertzContact<double> const &result)
{
    std::vector<double> x{result.depth, double(result.relative.status),
                          double(result.hertz.status)};
    for (int i = 0; i < 3; ++i) x.push_back(result.point[i]);
    for (auto const &inner : {members(result.relative), members(result.hertz)})
        x.insert(x.end(), inner.begin(), inner.end());
    return x;
}

/// Both sum in other orders and with other instructions: 2⁻²⁰ of the largest member is far above
/// that for these pairs, and far below any member in the place of another.
template <class Result, int D> void compare_results(Failures &failures, char const *name,
                                                    Result const &linked, Result const &own,
                                                    Sample<double, D> const &p)
{
    auto const text = [&] { return hex_text(p); };
    failures.check(linked.status == own.status, name, double(linked.status), double(own.status),
                   text);
    auto const actual = members(linked), expected = members(own);
    double largest = 0.0;
    for (double const x : expected)
        largest = std::fmax(largest, std::isfinite(x) ? std::fabs(x) : 0.0);
    for (std::size_t i = 0; i < actual.size(); ++i) {
        bool const same =
            actual[i] == expected[i] || (std::isnan(actual[i]) && std::isnan(expected[i]));
        failures.check(same || std::fabs(actual[i] - expected[i]) <= 0x1p-20 * largest, name,
                       actual[i], expected[i], text);
    }
}

// With the number type between angle brackets, a call takes the template.
#define COMPARE(name, ...)                                                                         \
    compare_results(failures, #name, pw85::name(__VA_ARGS__), pw85::name<double>(__VA_ARGS__), p)

template <int D>
void check_any_dimension(Failures &failures, Sample<double, D> const &p, double lambda)
{
    auto const &[r, q1, q2] = p;
    COMPARE(contact, r, q1, q2);
    COMPARE(contact_geometry, r, q1, q2, lambda);
    COMPARE(contact_gradient, r, q1, q2, lambda);
    COMPARE(contact_torque, r, q1, q2, lambda);
    COMPARE(contact_hessian, r, q1, q2, lambda);
    COMPARE(overlap, r, q1, q2);
    COMPARE(contains, r, q1, q2);
    COMPARE(containment, r, q1, q2);
    COMPARE(closest_approach, r, q1, q2);
    COMPARE(distance, r, q1, q2);
    COMPARE(penetration, r, q1, q2);
    COMPARE(signed_distance, r, q1, q2);
    COMPARE(second_moments, q1);
    COMPARE(from_moments, q1);
    COMPARE(shell_moments, q1);
}

void check_pair(Failures &failures, Sample<double, 3> const &p, double lambda, Random &random)
{
    auto const &[r, q1, q2] = p;
    auto const v = std::sqrt(pw85::dot(r, r)) * random.direction<3>();
    pw85::Motion<double, 3> const m1{v, random.direction<3>(), 0.0},
        m2{-v, random.direction<3>(), 0.125};
    check_any_dimension(failures, p, lambda);
    COMPARE(contact_rounded, r, q1, q2);
    COMPARE(condition, r, q1, q2, lambda);
    COMPARE(ellipse, 1.5, 0.5, lambda);
    COMPARE(volume, q1);
    COMPARE(surface_area, q1);
    COMPARE(inertia, q1, 0);
    COMPARE(inertia, q1, 1);
    COMPARE(overlap_volume, r, q1, q2);
    COMPARE(gap_inside, 0x1p-4 * r, q1, 0x1p-4 * q2);
    COMPARE(overlap_volume_gradient, r, q1, q2);
    COMPARE(overlap_volume_torque, r, q1, q2);
    COMPARE(compare, r, q1, q2, 1.5);
    COMPARE(distance_derivatives, r, q1, q2);
    COMPARE(signed_distance_derivatives, r, q1, q2);
    COMPARE(first_contact, r, q1, q2, m1, m2, 2.0);
    COMPARE(closest_passage, r, q1, q2, v, 2.0);
    COMPARE(free_path, r, q1, q2, v, 2.0);
    COMPARE(curvature, r, q1);
    COMPARE(hertz_contact, r, q1, q2, r);
    COMPARE(grain_contact, r, q1, q2, r);
    COMPARE(grain_radius_gradient, r, q1, q2, r);
}

void check_walls(Failures &failures, Sample<double, 3> const &p, Random &random)
{
    auto const &[r, q, other] = p;
    double const size = std::sqrt(pw85::dot(r, r));
    auto const n = random.direction<3>(), a = size * random.direction<3>(),
               b = size * random.direction<3>();
    pw85::Vector<double, 3> lower, upper;
    for (int i = 0; i < 3; ++i) {
        lower[i] = std::fmin(a[i], b[i]) + r[i];
        upper[i] = std::fmax(a[i], b[i]) + r[i];
    }
    double const normals[] = {n[0], n[1], n[2], a[0], a[1], a[2]};
    double const offsets[] = {0.25 * size, 0.5 * size * size};
    COMPARE(contact_polytope, 2, normals, offsets, q);
    COMPARE(contact_polytope, 2, normals, offsets, q, r);
    COMPARE(overlap_polytope, 2, normals, offsets, q);
    COMPARE(overlap_polytope, 2, normals, offsets, q, r);
    COMPARE(overlap_volume_plane, n, 0.25 * size, q);
    COMPARE(distance_plane_derivatives, n, q);
    COMPARE(grain_contact_wall, n, 0.25 * size, a, 0.5 / size, q);
    COMPARE(contact_plane, n, size, q);
    COMPARE(contact_plane_derivatives, n, size, q);
    COMPARE(distance_box, lower, upper, q);
    COMPARE(distance_cylinder, n, 8.0 * size, a, q);
    COMPARE(distance_point, r, q);
    COMPARE(intersect_line, 0.25 * r, n, q);
    COMPARE(distance_segment, a, b, q);
    COMPARE(distance_triangle, a, b, r, q);
    COMPARE(distance_solid_box, lower, upper, q);
    COMPARE(contact_segment, a, b, q);
    COMPARE(contact_triangle, a, b, r, q);
    COMPARE(contact_box, lower, upper, q);
    COMPARE(overlap_segment, a, b, q);
    COMPARE(overlap_triangle, a, b, r, q);
    COMPARE(overlap_box, lower, upper, q);
    COMPARE(contact_capsule, a, b, size, q);
    COMPARE(overlap_capsule, a, b, size, q);
    COMPARE(distance_capsule, a, b, size, q);
}

void check_factored(Failures &failures, Random &random, double size)
{
    auto const factor = [&] {
        return pw85::ellipsoid_factor(size * random.semi_axes(1.0, random.log_uniform(1.0, 5.0)),
                                      random.direction<4>())
            .s;
    };
    pw85::Factor<double, 3> const s1 = factor(), s2 = factor();
    Sample<double, 3> const p{random.log_uniform(0.5, 4.0) * size * random.direction<3>(), {}, {}};
    COMPARE(contact_factored, p.r12, s1, s2);
    COMPARE(overlap_factored, p.r12, s1, s2);
    double const lambda = pw85::contact_factored(p.r12, s1, s2).lambda;
    COMPARE(contact_geometry_factored, p.r12, s1, s2, lambda);
    COMPARE(contact_gradient_factored, p.r12, s1, s2, lambda);
}

void check_ellipses(Failures &failures, Sample<double, 2> const &p, double lambda)
{
    check_any_dimension(failures, p, lambda);
    COMPARE(area, p.q1);
    COMPARE(perimeter, p.q1);
    COMPARE(from_moments, p.q1);
    COMPARE(overlap_area, p.r12, p.q1, p.q2);
    COMPARE(overlap_area_gradient, p.r12, p.q1, p.q2);
    COMPARE(overlap_area_torque, p.r12, p.q1, p.q2);
    COMPARE(distance_point, p.r12, p.q1);
    COMPARE(contact_segment, p.r12, -p.r12, p.q1);
    COMPARE(contact_box, p.r12, p.r12, p.q1);
    COMPARE(overlap_segment, p.r12, p.r12, p.q1);
    COMPARE(overlap_box, p.r12, p.r12, p.q1);
}

template <int D> Sample<double, D> scaled(double size, Sample<double, D> const &p)
{
    return {size * p.r12, size * size * p.q1, size * size * p.q2};
}

PW85_TEST("/linked/results")
{
    Failures failures;
    Random random(1600);
    for (int n = 0; n < draws(400); ++n) {
        double const size = std::exp2(double(n % 3 - 1) * 40);
        auto const p = scaled(size, random_pair<3>(random, {.aspect = 5.0}));
        check_pair(failures, p, pw85::contact(p.r12, p.q1, p.q2).lambda, random);
        check_walls(failures, p, random);
        check_factored(failures, random, size);
        auto const flat = scaled(size, random_pair<2>(random, {.aspect = 5.0}));
        check_ellipses(failures, flat, pw85::contact(flat.r12, flat.q1, flat.q2).lambda);
    }
}

PW85_TEST("/linked/statuses")
{
    Failures failures;
    Random random(1601);
    pw85::SymmetricMatrix<double, 3> const not_positive{1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    auto const p = random_pair<3>(random, {});
    for (auto const &q : {not_positive, nan * not_positive}) {
        check_pair(failures, {p.r12, p.q1, q}, 0.5, random);
        check_pair(failures, {p.r12, q, p.q2}, 0.5, random);
        check_walls(failures, {p.r12, q, q}, random);
    }
    check_pair(failures, {nan * p.r12, p.q1, p.q2}, 0.5, random);
    check_pair(failures, p, nan, random);
    check_factored(failures, random, nan);
    auto const flat = random_pair<2>(random, {});
    check_ellipses(failures, {nan * flat.r12, flat.q1, flat.q2}, 0.5);
    check_ellipses(failures, {flat.r12, {1.0, 2.0, 1.0}, flat.q2}, 0.5);
}

// The tier is what the C API does not give out: that it is unknown says that the library decided.
PW85_TEST("/linked/library")
{
    auto const p = pw85::ellipse(2.0, 1.0, 0.5).q;
    g_assert_true(pw85::overlap(pw85::Vector<double, 2>{1.0, 1.0}, p, p).tier ==
                  pw85::OverlapTier::unknown);
    pw85::SymmetricMatrix<float, 3> const ball{1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f};
    g_assert_true(pw85::overlap(pw85::Vector<float, 3>{1.0f, 1.0f, 0.0f}, ball, ball).tier ==
                  pw85::OverlapTier::quartic);
}

} // namespace
