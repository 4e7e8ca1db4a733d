// SPDX-License-Identifier: BSD-3-Clause
// Distance of closest approach of two ellipses, by the quartic.
#include <numbers>

#include "../cases.hpp"
#include "../draws.hpp"
#include "distances.hpp"

using namespace pw85_tests;

namespace {

// The distance is a sum of two support functions, stationary in all that the quartic gives: what is
// left is the error of evaluating them, half of u cond (μ² has twice the relative error), and the
// rounding of four operations.
double bound(Sample<double, 2> const &p)
{
    auto const w = convert<Wide>(p);
    auto const contact = pw85::contact(w.r12, w.q1, w.q2);
    return 2.0 * u * static_cast<double>(condition_number(w, contact.lambda)) + 4.0 * u;
}

void check(Failures &failures, Sample<double, 2> const &p)
{
    auto const describe = [&] { return hex_text(p); };
    double actual, other;
    int const status = zheng(p, actual);
    if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) return;
    auto const w = convert<Wide>(p);
    Wide const expected = true_distance(w);
    double const allowed = bound(p), error = relative_error(actual, expected);
    failures.check(error <= allowed, "error", error, allowed, describe);
    closest_approach(p, other);
    double const difference = std::fabs(actual - other) / other;
    failures.check(difference <= 2.0 * allowed, "difference from the contact function", difference,
                   2.0 * allowed, describe);
    // With 50 digits the two methods must agree to what the condition of the forms leaves of them.
    double const wide_error =
        relative_error(pw85::zheng::ellipses(w.r12, w.q1, w.q2).distance, expected);
    double const wide_bound = 1e-48 * (condition_of_form(p.q1) + condition_of_form(p.q2));
    failures.check(wide_error <= wide_bound, "error with 50 digits", wide_error, wide_bound,
                   describe);
}

PW85_TEST("/zheng_ellipses/random_pairs")
{
    Failures failures;
    Random random(20080101);
    for (double const aspect : {1.0, 2.0, 10.0, 1e2, 1e3, 1e4, 1e6})
        for (double const size_ratio : {1.0, 10.0, 1e4, 1e20})
            for (int i = 0; i < 200; ++i)
                check(failures, random_pair<2>(random, {aspect, size_ratio, 0.01, 100.0}));
}

// Orientations and directions in which axes and angles have special cases: equal or crossed
// orientations, circles, axes swapped or equal, a direction along an axis or halfway between.
PW85_TEST("/zheng_ellipses/special_cases")
{
    Failures failures;
    double const quarter = std::numbers::pi / 2.0;
    pw85::Vector<double, 2> const directions[] = {
        {1.0, 0.0}, {0.0, -1.0}, {1.0, 1.0}, {1.0, 1e-9}, {-3.0, 1e-300}};
    double const axes[][2] = {{1.0, 1.0},           {2.0, 1.0}, {1.0, 2.0},
                              {1.0, 1.0 + 2.0 * u}, {7.0, 7.0}, {1e5, 1.0}};
    for (auto const &direction : directions)
        for (auto const &a : axes)
            for (auto const &b : axes)
                for (double const turn1 : {0.0, 0.5 * quarter, 1.0})
                    for (double const turn2 : {0.0, 0.5 * quarter, quarter, 1.0, 1.0 + 1e-8})
                        check(failures, {direction, pw85::ellipse(a[0], a[1], turn1).q,
                                         pw85::ellipse(b[0], b[1], turn2).q});
}

PW85_TEST("/zheng_ellipses/exact_answers")
{
    struct {
        Sample<double, 2> pair;
        double distance;
    } const cases[] = {
        {{{0.6, 0.8}, {4.0, 0.0, 4.0}, {9.0, 0.0, 9.0}}, 5.0},   // circles
        {{{1.0, 0.0}, {4.0, 0.0, 1.0}, {9.0, 0.0, 25.0}}, 5.0},  // along axes
        {{{0.0, -7.0}, {4.0, 0.0, 1.0}, {9.0, 0.0, 25.0}}, 6.0}, // along axes
        // circles, direction of any length
        {{{3.0, 4.0}, {4.0, 0.0, 4.0}, {64.0, 0.0, 64.0}}, 10.0},
        {{{1.0, 0.0}, {1.0, 0.0, 0.0625}, {1.0, 0.0, 16.0}}, 2.0}, // axes swapped
    };
    for (auto const &c : cases) {
        double distance;
        g_assert_cmpint(zheng(c.pair, distance), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(distance - c.distance), <=, 4.0 * u * c.distance);
    }
}

// The closed form itself, where its terms differ by any orders of magnitude or cancel. It is
// backward stable: the root found is that of an equation whose terms differ by some roundings. (The
// root itself is as sensitive as 1/w, where M = κ2² and κ1 is small.)
PW85_TEST("/zheng_ellipses/quartic")
{
    Failures failures;
    Random random(61709);
    for (int i = 0; i < draws(20000); ++i) {
        double const span = random.log_uniform(1.0, 1e35);
        double k1 = random.log_uniform(1.0 / span, 1.0), k2 = random.log_uniform(1.0 / span, 1.0);
        double m = random.log_uniform(1.0 / span, 1.0);
        if (i % 4 == 1) { // M and κ1² - κ2² both small
            k1 = k2 * (1.0 + random.uniform(-1e-8, 1e-8));
            m = k2 * k2 * random.log_uniform(1e-20, 1e-6);
        }
        // r near 0
        if (i % 4 == 2) m = std::fabs(k2 * k2 - k1 * k1) * (1.0 + random.uniform(-1e-10, 1e-10));
        if (i % 4 == 3) m = 0.0;
        double const largest = std::fmax(m, std::fmax(k1, k2));
        k1 /= largest;
        k2 /= largest;
        m /= largest;
        double const w = pw85::detail::zheng::quartic_root(m, k1, k2), arguments[3] = {m, k1, k2};
        auto const describe = [&] { return hex_text(arguments, 3); };
        Wide const x = w, left = m * x * x + k1 * k1 * (x + k2) * (x + k2),
                   right = x * x * (x + k2) * (x + k2);
        double const residual = relative_error(left, right);
        failures.check(residual <= 16.0 * u, "residual of the quartic", residual, 16.0 * u,
                       describe);
    }
}

} // namespace
