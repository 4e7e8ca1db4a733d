// SPDX-License-Identifier: BSD-3-Clause
// Distance of closest approach of two ellipsoids, by the largest distance of their plane sections.
#include <numbers>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../reference_data.hpp"
#include "distances.hpp"

using namespace pw85_tests;

namespace {

// A section depends on Q⁻¹d and det Q, which solving with Q gives to u κ relative: half of that
// goes into a length. The part of one ellipsoid in the distance is below 1, so that ½ u (κ1 + κ2)
// is left, and as much again for the search.
double bound(Sample<double, 3> const &p)
{
    return u * (condition_of_form(p.q1) + condition_of_form(p.q2));
}

void check(Failures &failures, Sample<double, 3> const &p, Wide const &expected, char const *kind)
{
    auto const describe = [&] { return std::string(kind) + ": " + hex_text(p); };
    double actual;
    int const status = zheng(p, actual);
    if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) return;
    double const allowed = bound(p), error = relative_error(actual, expected);
    failures.check(error <= allowed, "error", error, allowed, describe);
}

// The definition, in other words: no plane through the line of centres has a larger distance.
PW85_TEST("/zheng_ellipsoids/no_plane_is_larger")
{
    Failures failures;
    Random random(2009);
    for (int i = 0; i < 60; ++i) {
        auto const p = random_pair<3>(random, {10.0, 3.0, 1.0, 1.0});
        double distance;
        g_assert_cmpint(zheng(p, distance), ==, PW85_SUCCESS);
        auto const other = random.direction<3>();
        auto const a = pw85::cross(p.r12, other), b = pw85::cross(p.r12, a);
        for (int k = 0; k < 180; ++k) {
            double const theta = std::numbers::pi * k / 180.0;
            pw85::Vector<double, 3> s{};
            for (int j = 0; j < 3; ++j) s[j] = std::cos(theta) * a[j] + std::sin(theta) * b[j];
            auto const section = [&](pw85::SymmetricMatrix<double, 3> const &q) {
                auto const factors = pw85::detail::factorize(q, 0.0);
                auto const g = pw85::detail::solve(factors, p.r12),
                           h = pw85::detail::solve(factors, s);
                pw85::SymmetricMatrix<double, 2> const inverse{pw85::dot(p.r12, g), pw85::dot(s, g),
                                                               pw85::dot(s, h)};
                auto const adjugate = pw85::detail::adjugate(inverse);
                return pw85::detail::blend(1.0 / pw85::detail::determinant(inverse, adjugate),
                                           adjugate, 0.0, inverse);
            };
            // Coordinates along r12 and s, hence the distance in units of |r12|.
            double const scale = std::sqrt(pw85::dot(p.r12, p.r12));
            auto const e1 = section(p.q1), e2 = section(p.q2);
            double const in_plane =
                scale * pw85::closest_approach(pw85::Vector{1.0, 0.0}, e1, e2).distance;
            double const largest = distance * (1.0 + 16.0 * bound(p)); // two inversions more
            failures.check(in_plane <= largest, "distance in a plane", in_plane, largest,
                           [&] { return hex_text(p); });
        }
    }
}

PW85_TEST("/zheng_ellipsoids/random_pairs")
{
    Failures failures;
    Random random(57702);
    for (double const aspect : {1.0, 2.0, 4.0, 10.0, 1e2, 1e3, 1e4})
        for (double const size_ratio : {1.0, 10.0, 1e4, 1e20})
            for (int i = 0; i < 150; ++i) {
                auto const p = random_pair<3>(random, {aspect, size_ratio, 0.01, 100.0});
                auto const w = convert<Wide>(p);
                Wide const expected = true_distance(w);
                check(failures, p, expected, "random");
                // With 50 digits the two methods must agree to what the condition of the forms
                // leaves of them.
                double const error =
                    relative_error(pw85::zheng::ellipsoids(w.r12, w.q1, w.q2).distance, expected);
                double const allowed = 1e-48 * (condition_of_form(p.q1) + condition_of_form(p.q2));
                failures.check(error <= allowed, "error with 50 digits", error, allowed,
                               [&] { return hex_text(p); });
            }
}

// The contact function is good to 4 u cond, and cond is below the sum of the conditions of the
// forms.
PW85_TEST("/zheng_ellipsoids/agreement")
{
    Failures failures;
    Random random(19850101);
    for (double const aspect : {2.0, 10.0, 100.0, 1e3, 1e4})
        for (int i = 0; i < draws(4000); ++i) {
            auto const p = random_pair<3>(random, {aspect, 10.0, 1.0, 1.0});
            double actual, other;
            zheng(p, actual);
            closest_approach(p, other);
            double const difference = std::fabs(actual - other) / other, allowed = 5.0 * bound(p);
            failures.check(difference <= allowed, "difference", difference, allowed,
                           [&] { return hex_text(p); });
        }
}

PW85_TEST("/zheng_ellipsoids/aspect_100")
{
    Failures failures;
    Random random(100);
    double worst = 0.0;
    for (int i = 0; i < draws(2000); ++i) {
        Sample<double, 3> const p{random.direction<3>(), random.form(1.0, 100.0),
                                  random.form(random.log_uniform(0.1, 10.0), 100.0)};
        double distance;
        g_assert_cmpint(zheng(p, distance), ==, PW85_SUCCESS);
        double const error = relative_error(distance, true_distance(convert<Wide>(p)));
        worst = std::fmax(worst, error);
        failures.check(error <= 1e-11, "error", error, 1e-11, [&] { return hex_text(p); });
    }
    g_test_message("largest relative error %.2g", worst);
}

PW85_TEST("/zheng_ellipsoids/problems")
{
    Failures failures;
    for (auto const &p : contact_problems()) {
        Wide norm2 = 0;
        for (int i = 0; i < 3; ++i) norm2 += Wide(p.pair.r12[i]) * p.pair.r12[i];
        check(failures, p.pair, Wide(sqrt(Wide(norm2 / p.mu2))), p.category->c_str());
    }
}

PW85_TEST("/zheng_ellipsoids/special_cases")
{
    Failures failures;
    pw85::Vector<double, 4> const turns[] = {{1.0, 0.0, 0.0, 0.0},
                                             {1.0, 1.0, 1.0, 1.0},
                                             {1.0, 0.0, 0.0, 1.0},
                                             {3.0, 1.0, 2.0, 0.0},
                                             {3.0, 1.0, 2.0, 1e-9}};
    pw85::Vector<double, 3> const axes[] = {{1.0, 1.0, 1.0}, {2.0, 1.0, 1.0}, {1.0, 1.0, 5.0},
                                            {3.0, 2.0, 1.0}, {1.0, 2.0, 3.0}, {1e3, 1.0, 1.0}};
    pw85::Vector<double, 3> const directions[] = {{1.0, 0.0, 0.0},  {0.0, 0.0, -2.0},
                                                  {1.0, 1.0, 0.0},  {1.0, 1.0, 1.0},
                                                  {1.0, 1e-9, 0.0}, {1.0, 1e-200, -1e-200}};
    for (auto const &a1 : axes)
        for (auto const &a2 : axes)
            for (auto const &turn1 : turns)
                for (auto const &turn2 : turns)
                    for (auto const &d : directions) {
                        Sample<double, 3> const p{d, pw85::ellipsoid_quaternion(a1, turn1).q,
                                                  pw85::ellipsoid_quaternion(a2, turn2).q};
                        check(failures, p, true_distance(convert<Wide>(p)), "special");
                    }
}

// The caption of figure 1 of the paper gives semi-axes (10, 4, 2) and (8, 6, 2), the direction x,
// and the distance 14.7163, but no orientations. They do not follow: turning one ellipsoid from the
// coordinate axes about one of them, by the angle that makes the distance right, is possible in
// three ways already.
PW85_TEST("/zheng_ellipsoids/figure_1")
{
    struct {
        pw85::Vector<double, 4> turn1, turn2;
    } const cases[] = {
        {{std::cos(0.14652327009361374), 0.0, std::sin(0.14652327009361374), 0.0},
         {1.0, 0.0, 0.0, 0.0}},
        {{std::cos(0.33833422544901731), 0.0, 0.0, std::sin(0.33833422544901731)},
         {1.0, 0.0, 0.0, 0.0}},
        {{1.0, 0.0, 0.0, 0.0},
         {std::cos(0.21067116388324139), 0.0, std::sin(0.21067116388324139), 0.0}},
    };
    for (auto const &c : cases) {
        Sample<double, 3> const p{
            {1.0, 0.0, 0.0},
            pw85::ellipsoid_quaternion(pw85::Vector{10.0, 4.0, 2.0}, c.turn1).q,
            pw85::ellipsoid_quaternion(pw85::Vector{8.0, 6.0, 2.0}, c.turn2).q};
        double actual, other;
        g_assert_cmpint(zheng(p, actual), ==, PW85_SUCCESS);
        g_assert_cmpint(closest_approach(p, other), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(actual - 14.7163), <=, 1e-12);
        g_assert_cmpfloat(std::fabs(other - 14.7163), <=, 1e-12);
    }
}

template <class T> void check_type(Failures &failures, Random &random)
{
    T const roundoff = pw85::detail::unit_roundoff<T>();
    for (int i = 0; i < 500; ++i) {
        auto const p =
            convert<T>(random_pair<3>(random, {10.0, i % 2 == 0 ? 10.0 : 1e6, 0.1, 10.0}));
        auto const d = convert<double>(p);
        auto const w = convert<Wide>(p);
        double const error =
            relative_error(pw85::zheng::ellipsoids(p.r12, p.q1, p.q2).distance, true_distance(w));
        double const allowed =
            static_cast<double>(roundoff) * (condition_of_form(d.q1) + condition_of_form(d.q2));
        failures.check(error <= allowed, "error", error, allowed, [&] { return hex_text(p); });
    }
}

PW85_TEST("/zheng_ellipsoids/scalars")
{
    Failures failures;
    Random random(24);
    check_type<float>(failures, random);
    check_type<long double>(failures, random);
}

PW85_TEST("/zheng_ellipsoids/invariance")
{
    Failures failures;
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        auto const p = random_pair<3>(random, {100.0, 10.0, 0.1, 10.0});
        double plain, swapped, longer;
        zheng(p, plain);
        zheng(Sample<double, 3>{p.r12, p.q2, p.q1}, swapped);
        zheng(Sample<double, 3>{-1024.0 * p.r12, p.q1, p.q2}, longer);
        double const allowed = 2.0 * bound(p) * plain;
        auto const describe = [&] { return hex_text(p); };
        failures.check(std::fabs(plain - swapped) <= allowed, "swapped", swapped, plain, describe);
        failures.check(std::fabs(plain - longer) <= allowed, "longer direction", longer, plain,
                       describe);
    }
}

} // namespace
