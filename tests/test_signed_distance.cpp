// SPDX-License-Identifier: BSD-3-Clause
// Tests of the signed distance and its derivatives. The items are those of
// include/pw85/distance/signed_distance.hpp.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include <glib.h>

#include <pw85.h>
#include <pw85/distance/signed_distance.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"
#include "sensitivity.hpp"
#include "stationary_width.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

struct Result {
    int status;
    double distance;
    pw85::Vector<double, 3> point1, point2, normal, rotation1, rotation2;
    double hessian[9][9];
};

/// The three functions of the C API, of which that with the normal gives the bits of the others.
Result signed_distance(Sample<double, 3> const &p)
{
    Result d{}, with_normal{};
    d.status = pw85_signed_distance(p.r12.coordinates, p.q1.entries, p.q2.entries, &d.distance,
                                    d.point1.coordinates, d.point2.coordinates);
    g_assert_cmpint(pw85_signed_distance_geometry(
                        p.r12.coordinates, p.q1.entries, p.q2.entries, &with_normal.distance,
                        with_normal.point1.coordinates, with_normal.point2.coordinates,
                        with_normal.normal.coordinates),
                    ==, d.status);
    g_assert_cmpint(pw85_signed_distance_derivatives(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                     d.normal.coordinates, d.rotation1.coordinates,
                                                     d.rotation2.coordinates, *d.hessian),
                    ==, d.status);
    std::size_t const size = offsetof(Result, rotation1) - offsetof(Result, distance);
    g_assert_true(std::memcmp(&d.distance, &with_normal.distance, size) == 0);
    return d;
}

/// Pairs that overlap and pairs that are apart, half of them each.
Sample<double, 3> pair_on_either_side(Random &random, int n, double aspect)
{
    return random_pair<3>(random, {.aspect = random.log_uniform(1.0, aspect),
                                   .size_ratio = random.log_uniform(1.0, 10.0),
                                   .mu2_min = n % 2 == 0 ? 1e-4 : 1.001,
                                   .mu2_max = n % 2 == 0 ? 0.999 : 10.0});
}

// The value is that of the function for the side on which the pair is, and the sign tells the side.
PW85_TEST("/signed_distance/sides")
{
    Failures failures;
    Random random(1500);
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = pair_on_either_side(random, n, 1e3);
        auto const d = signed_distance(s);
        int overlap;
        double distance, depth, direction[3];
        pw85_overlap(s.r12.coordinates, s.q1.entries, s.q2.entries, &overlap);
        pw85_distance(s.r12.coordinates, s.q1.entries, s.q2.entries, &distance, nullptr, nullptr);
        pw85_penetration(s.r12.coordinates, s.q1.entries, s.q2.entries, &depth, direction);
        double const expected = overlap == 1 ? -depth : distance;
        failures.check(d.status == PW85_SUCCESS && d.distance == expected, "value", d.distance,
                       expected, [&] { return hex_text(s); });
        failures.check(overlap == 1 ? d.distance <= 0.0 : d.distance >= 0.0, "sign", d.distance,
                       expected, [&] { return hex_text(s); });
    }
}

/// An ellipse as the section z = 0 of an ellipsoid with this square of the third semi-axis.
pw85::SymmetricMatrix<double, 3> upright(pw85::SymmetricMatrix<double, 2> const &q, double square)
{
    return {q[0], q[1], 0.0, q[2], 0.0, square};
}

// Ellipses are sections of ellipsoids, so tall that no way out of the plane is shorter: the
// distance and the depth are the same, to the bounds of both.
PW85_TEST("/signed_distance/plane")
{
    Failures failures;
    Random random(1505);
    for (int n = 0; n < draws(1000); ++n) {
        int const unit = 40 * (n % 3 - 1);
        auto s = random_pair<2>(random, {.aspect = random.log_uniform(1.0, 100.0),
                                         .size_ratio = random.log_uniform(1.0, 10.0),
                                         .mu2_min = n % 2 == 0 ? 1e-4 : 1.001,
                                         .mu2_max = n % 2 == 0 ? 0.999 : 10.0});
        s = {pw85::detail::times_power_of_two(s.r12, unit),
             pw85::detail::times_power_of_two(s.q1, 2 * unit),
             pw85::detail::times_power_of_two(s.q2, 2 * unit)};
        double const reach = norm(s.r12) + std::sqrt(pw85::detail::trace(s.q1)) +
                             std::sqrt(pw85::detail::trace(s.q2));
        double const square = n % 2 == 0 ? reach * reach : pw85::detail::trace(s.q1);
        Sample<double, 3> const p{
            {s.r12[0], s.r12[1], 0.0}, upright(s.q1, square), upright(s.q2, square)};
        auto const expected = signed_distance(p);
        double distance, point1[2], point2[2], depth, direction[2], gap;
        auto const text = [&] { return hex_text(s); };
        int const status = pw85_signed_distance_2d(s.r12.coordinates, s.q1.entries, s.q2.entries,
                                                   &distance, point1, point2);
        failures.check(status == PW85_SUCCESS &&
                           std::fabs(distance - expected.distance) <= 80 * u * reach,
                       "distance", distance, expected.distance, text);
        double const apart = std::hypot(point2[0] - point1[0], point2[1] - point1[1]);
        failures.check(std::fabs(apart - std::fabs(distance)) <= 0x1p18 * u * reach, "points",
                       apart, distance, text);
        // The normal (point2 - point1)/distance has r12 on its side.
        double const side = (point2[0] - point1[0]) * s.r12[0] + (point2[1] - point1[1]) * s.r12[1];
        failures.check(side * distance >= -0x1p18 * u * reach * reach * std::fabs(distance), "side",
                       side, distance, text);
        pw85_penetration_2d(s.r12.coordinates, s.q1.entries, s.q2.entries, &depth, direction);
        pw85_distance_2d(s.r12.coordinates, s.q1.entries, s.q2.entries, &gap, nullptr, nullptr);
        for (int i = 0; i < 2 && n % 2 == 0; ++i)
            failures.check(std::fabs(depth * direction[i] - (point1[i] - point2[i])) <=
                               0x1p18 * u * reach,
                           "way", depth * direction[i], point1[i] - point2[i], text);
        failures.check(distance == (n % 2 == 0 ? -depth : gap), "parts", distance,
                       n % 2 == 0 ? -depth : gap, text);
    }
}

// Item 2, in a wider type: the points are those of the surfaces with the normals n and -n, and they
// differ by d n.
PW85_TEST("/signed_distance/points")
{
    Failures failures;
    Random random(1510);
    for (int n = 0; n < draws(4000); ++n) {
        auto const s = pair_on_either_side(random, n, 1e3);
        auto const d = signed_distance(s);
        auto const text = [&] { return hex_text(s); };
        auto const p = convert<Wide>(s);
        auto normal = convert<Wide>(d.normal);
        normal = Wide(1 / norm(normal)) * normal;
        double const size = norm(s.r12) + norm(d.point1) + norm(s.r12 - d.point2);
        double const value = static_cast<double>(width_along(p, normal));
        double const bound = 8 * u * static_cast<double>(sensitivity(p, normal));
        failures.check(std::fabs(d.distance - value) <= bound, "width along the normal", d.distance,
                       value, text);
        double const off = norm(d.point2 - d.point1 - d.distance * d.normal);
        failures.check(off <= 0x1p18 * u * size, "points against the normal", off,
                       0x1p18 * u * size, text);
        auto const support1 = pw85::detail::support(p.q1, normal),
                   support2 = pw85::detail::support(p.q2, normal);
        double const error1 = static_cast<double>(norm(convert<Wide>(d.point1) - support1.point)),
                     error2 = static_cast<double>(
                         norm(p.r12 - convert<Wide>(d.point2) - support2.point));
        failures.check(error1 <= 0x1p18 * u * size, "point 1", error1, 0x1p18 * u * size, text);
        failures.check(error2 <= 0x1p18 * u * size, "point 2", error2, 0x1p18 * u * size, text);
    }
}

// Item 1: no direction has a larger width, and the function is convex along lines that pass through
// both sides, with the slope of the normal as a lower bound.
PW85_TEST("/signed_distance/convexity")
{
    Failures failures;
    Random random(1520);
    for (int n = 0; n < draws(1000); ++n) {
        auto const s = pair_on_either_side(random, n, 100.0);
        auto const d = signed_distance(s);
        auto moved = s;
        moved.r12 = random.uniform(0.0, 2.0) * norm(s.r12) * random.direction<3>();
        auto const e = signed_distance(moved);
        double const bound = d.distance + pw85::dot(d.normal, moved.r12 - s.r12);
        double const error =
            64 * u * (sensitivity(s, d.normal) + sensitivity(moved, e.normal) + norm(moved.r12));
        failures.check(e.distance >= bound - error, "convexity", e.distance, bound,
                       [&] { return hex_text(s) + ", " + hex_text(moved); });
        for (int k = 0; k < 20; ++k) {
            auto const direction = random.direction<3>();
            failures.check(width_along(s, direction) <= d.distance + error, "wider",
                           width_along(s, direction), d.distance, [&] { return hex_text(s); });
        }
    }
}

Sample<Wide, 3> moved(Sample<Wide, 3> p, Wide const (&change)[9])
{
    for (int i = 0; i < 3; ++i) p.r12[i] += change[i];
    p.q1 = rotated(p.q1, {change[3], change[4], change[5]});
    p.q2 = rotated(p.q2, {change[6], change[7], change[8]});
    return p;
}

/// The smallest pivot of the stiffness over its trace: how well the normal is isolated.
double isolation(Sample<double, 3> const &s, Result const &d)
{
    pw85::detail::SurfaceElement<double, 3> const elements[2] = {
        pw85::detail::surface_element(s.q1, 1.0, d.normal),
        pw85::detail::surface_element(s.q2, 1.0, d.normal)};
    auto const stiffness = pw85::detail::stiffness_across(elements, d.distance, d.normal);
    auto const f = pw85::detail::factorize(stiffness, 0.0);
    return std::min({f.pivots[0], f.pivots[1], f.pivots[2]}) / pw85::detail::trace(stiffness);
}

// Central differences of the stationary value. With h = 1e-10 truncation leaves 1e-20 times third
// and fourth derivatives, which are below 1e6 for sizes of one and normals that are isolated by
// 0.05. The normal errs by some u, the curvatures by aspect² times as much, and the Hessian by that
// over the square of the isolation.
PW85_TEST("/signed_distance/derivatives")
{
    Failures failures;
    Random random(1530);
    Wide const h("1e-10");
    int tested = 0;
    for (int n = 0; n < draws(240); ++n) {
        auto const s = random_pair<3>(random, {.aspect = 3.0, .mu2_min = 0.3, .mu2_max = 2.0});
        auto const d = signed_distance(s);
        double const isolated = isolation(s, d);
        if (isolated < 0.05) continue;
        ++tested;
        auto const p = convert<Wide>(s);
        auto const normal = convert<Wide>(d.normal);
        auto const at = [&](int i, int si, int j, int sj) {
            Wide change[9] = {};
            change[i] += si * h;
            change[j] += sj * h;
            auto const found = stationary_width(moved(p, change), normal);
            g_assert_true(found.residual <= Wide("1e-40"));
            return found.width;
        };
        auto const check = [&](double actual, Wide const &expected, char const *what) {
            double const error = std::fabs(static_cast<double>(Wide(actual - expected)));
            double const bound = 256 * u * 9.0 * norm(s.r12) / (isolated * isolated);
            failures.check(error <= bound, what, actual, static_cast<double>(expected),
                           [&] { return hex_text(s); });
        };
        for (int i = 0; i < 9; ++i) {
            double const gradient = i < 3   ? d.normal[i]
                                    : i < 6 ? d.rotation1[i - 3]
                                            : d.rotation2[i - 6];
            check(gradient, (at(i, 1, i, 0) - at(i, -1, i, 0)) / (2 * h), "gradient");
            int const j = n % 9;
            check(d.hessian[i][j],
                  (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) /
                      (4 * h * h),
                  "hessian");
            failures.check(d.hessian[i][j] == d.hessian[j][i], "symmetry", d.hessian[i][j],
                           d.hessian[j][i], [&] { return hex_text(s); });
        }
    }
    g_assert_cmpint(2 * tested, >, draws(240));
}

void assert_close(double actual, double expected, double bound)
{
    if (!(std::fabs(actual - expected) <= bound)) g_test_message("%a is not %a", actual, expected);
    g_assert_cmpfloat(std::fabs(actual - expected), <=, bound);
}

// Pairs that touch in exact arithmetic, and pairs on both sides of contact: the value passes
// through zero, and the derivatives do not jump. For spheres the second derivative with respect to
// r12 is (I - nnᵀ)/|r12|.
PW85_TEST("/signed_distance/touching")
{
    pw85::SymmetricMatrix<double, 3> const one{1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
        long_one{4.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    for (double const change : {-0x1p-20, -0x1p-51, 0.0, 0x1p-51, 0x1p-20}) {
        auto const spheres = signed_distance({{0.0, 2.0 + change, 0.0}, one, one});
        g_assert_cmpint(spheres.status, ==, PW85_SUCCESS);
        assert_close(spheres.distance, change, 16 * u);
        assert_close(spheres.normal[1], 1.0, 4 * u);
        assert_close(spheres.point1[1], 1.0, 4 * u);
        assert_close(spheres.point2[1], 1.0 + change, 4 * u);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                assert_close(spheres.hessian[i][j], i == j && i != 1 ? 1.0 / (2.0 + change) : 0.0,
                             32 * u);
        auto const ends = signed_distance({{3.0 + change, 0.0, 0.0}, long_one, one});
        assert_close(ends.distance, change, 16 * u);
        assert_close(ends.normal[0], 1.0, 4 * u);
        // The curvature radius of the end is 1/2: ellipsoid 1 turns under the sphere with the
        // arm 2.
        assert_close(ends.hessian[1][1], 1.0 / (1.5 + change), 32 * u);
    }
}

// Where no direction is best the Hessian is NaN, and everything else is that of one of the best
// directions.
PW85_TEST("/signed_distance/not_isolated")
{
    pw85::SymmetricMatrix<double, 3> const one{1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
        prolate{1.0, 0.0, 0.0, 1.0, 0.0, 9.0};
    for (Sample<double, 3> const &s : {Sample<double, 3>{{0.0, 0.0, 0.0}, one, one},
                                       Sample<double, 3>{{0.0, 0.0, 0.5}, prolate, one}}) {
        auto const d = signed_distance(s);
        g_assert_cmpint(d.status, ==, PW85_SUCCESS);
        assert_close(norm(d.normal), 1.0, 4 * u);
        assert_close(width_along(s, d.normal), d.distance, 16 * u);
        g_assert_cmpfloat(d.distance, <, 0.0);
        for (auto const &row : d.hessian)
            for (double const x : row) g_assert_true(std::isnan(x));
        for (int i = 0; i < 3; ++i)
            g_assert_true(std::isfinite(d.rotation1[i]) && std::isfinite(d.rotation2[i]));
    }
}

// Other units by the C API, far out of those that need no scaling, and other scalars by the
// templates.
PW85_TEST("/signed_distance/units_and_scalars")
{
    Failures failures;
    Random random(1540);
    for (int n = 0; n < draws(800); ++n) {
        auto const s = pair_on_either_side(random, n, 30.0);
        auto const d = signed_distance(s);
        for (int const unit : {-480, -40, 40, 480}) {
            Sample<double, 3> const scaled{pw85::detail::times_power_of_two(s.r12, unit),
                                           pw85::detail::times_power_of_two(s.q1, 2 * unit),
                                           pw85::detail::times_power_of_two(s.q2, 2 * unit)};
            auto const e = signed_distance(scaled);
            double const size = norm(s.r12) + norm(d.point1), bound = 0x1p18 * u * size;
            auto const check = [&](double actual, double expected, char const *what) {
                failures.check(std::fabs(actual - expected) <= bound, what, actual, expected,
                               [&] { return hex_text(scaled); });
            };
            check(std::ldexp(e.distance, -unit), d.distance, "distance");
            for (int i = 0; i < 3; ++i) {
                check(std::ldexp(e.point1[i], -unit), d.point1[i], "point 1");
                check(std::ldexp(e.point2[i], -unit), d.point2[i], "point 2");
                check(std::ldexp(e.rotation1[i], -unit), d.rotation1[i], "rotation 1");
            }
        }
        auto const p = convert<float>(s);
        auto const f = pw85::signed_distance(p.r12, p.q1, p.q2);
        double const bound = 64 * 0x1p-24 * sensitivity(s, d.normal);
        failures.check(std::fabs(static_cast<double>(f.distance) - d.distance) <= bound, "float",
                       static_cast<double>(f.distance), d.distance, [&] { return hex_text(s); });
    }
}

} // namespace
