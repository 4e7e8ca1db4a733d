// SPDX-License-Identifier: BSD-3-Clause
// Tests over the whole range, semi-axes from 1e-150 to 1e150 and size ratios up to 1e12, and beyond
// it.
#include <cmath>
#include <limits>

#include <glib.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "solvers.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A pair with all lengths times `length`: exact up to rounding, which the oracle sees as well.
Sample<double, 3> times_length(Sample<double, 3> const &p, double length)
{
    Sample<double, 3> s = p;
    for (int i = 0; i < 3; ++i) s.r12[i] = length * p.r12[i];
    for (int k = 0; k < 6; ++k) {
        s.q1[k] = length * (length * p.q1[k]);
        s.q2[k] = length * (length * p.q2[k]);
    }
    return s;
}

// The largest semi-axis is at most the size ratio, the smallest at least the inverse of that and of
// the aspect ratio: the units keep both within 1e-150 and 1e150.
void test_sizes(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    Failures failures;
    Random random(60);
    double worst = 0.0;
    for (int n = 0; n < draws(5000); ++n) {
        PairOptions const options{.aspect = 100.0, .size_ratio = n % 2 == 0 ? 2.0 : 1e12};
        double const room = 100.0 * options.size_ratio;
        auto const p = times_length(random_pair<3>(random, options),
                                    random.log_uniform(1e-150 * room, 1e150 / room));
        double out[2];
        auto const describe = [&] { return hex_text(p); };
        int const status = solver.call(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
        double const units = error_in_units(out[0], truth<Wide>(p));
        failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
        worst = std::fmax(worst, units);
    }
    g_test_message("largest error %.2f u cond", worst);
}

// Distances that have nothing to do with the sizes: μ² is right, or infinity, or as small as
// doubles can be.
void test_distances(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    Failures failures;
    Random random(61);
    int infinite = 0, zero = 0;
    for (int n = 0; n < draws(5000); ++n) {
        auto p = times_length(random_pair<3>(random, {.aspect = 10.0}),
                              random.log_uniform(1e-149, 1e149));
        p.r12 = random.log_uniform(1e-150, 1e150) * random.direction<3>();
        double out[2];
        auto const describe = [&] { return hex_text(p); };
        int const status = solver.call(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) continue;
        auto const exact = truth<Wide>(p);
        double const expected = static_cast<double>(exact.mu2);
        if (expected == infinity || expected < std::numeric_limits<double>::min()) {
            double const room = 4 * std::numeric_limits<double>::denorm_min() + 1e-12 * expected;
            failures.check(out[0] == expected || std::fabs(out[0] - expected) <= room, "mu^2",
                           out[0], expected, describe);
            infinite += expected == infinity;
            zero += expected == 0.0;
        } else {
            double const units = error_in_units(out[0], exact);
            failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
        }
        failures.check(out[1] > 0.0 && out[1] < 1.0, "lambda", out[1], 1.0, describe);
    }
    g_assert_cmpint(infinite, >, draws(10));
    g_assert_cmpint(zero, >, draws(10));
}

// Denormal forms and separations are numbers like any other. Their entries carry few bits, so the
// forms are diagonal.
void test_denormal(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    double const tiny = std::numeric_limits<double>::denorm_min();
    double const q[6] = {4 * tiny, 0.0, 0.0, 4 * tiny, 0.0, 4 * tiny}, r12[3] = {tiny, 0.0, 0.0};
    double out[2];
    g_assert_cmpint(solver.call(r12, q, q, out), ==, PW85_SUCCESS);
    // μ² = r²/(4·4 tiny) = tiny/16, which rounds to zero.
    g_assert_cmpfloat(out[0], ==, 0.0);
    g_assert_cmpfloat(out[1], ==, 0.5);
    double const unit[3] = {1.0, 0.0, 0.0};
    g_assert_cmpint(solver.call(unit, q, q, out), ==, PW85_SUCCESS);
    g_assert_cmpfloat(out[0], ==, infinity);
    g_assert_cmpfloat(out[1], ==, 0.5);
}

void test_largest(void const *data)
{
    auto const &solver = *static_cast<Solver const *>(data);
    double const large = std::numeric_limits<double>::max();
    double const q[6] = {large, 0.0, 0.0, large, 0.0, large}, r12[3] = {large, large, large},
                 unit[3] = {1.0, 0.0, 0.0};
    double out[2];
    g_assert_cmpint(solver.call(r12, q, q, out), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(out[0] - 0.75 * large), <=, 1e-14 * large);
    g_assert_cmpint(solver.call(unit, q, q, out), ==, PW85_SUCCESS);
    g_assert_cmpfloat(std::fabs(out[0] - 0.25 / large), <=,
                      std::numeric_limits<double>::denorm_min());
    g_assert_cmpfloat(std::fabs(out[1] - 0.5), <=, 0x1p-52);
}

/// Derivatives and contact points at a λ.
struct AtLambda {
    double point[3], normal[3], force[3], torque1[3], torque2[3];

    AtLambda(Sample<double, 3> const &x, double lambda)
    {
        double const *const r = x.r12.coordinates, *const q1 = x.q1.entries,
                            *const q2 = x.q2.entries;
        pw85_contact_geometry(r, q1, q2, lambda, point, normal);
        pw85_contact_gradient(r, q1, q2, lambda, force, nullptr, nullptr);
        pw85_contact_torque(r, q1, q2, lambda, torque1, torque2);
    }
};

// Derivatives and contact points scale as they must: bits are those of the unscaled pair.
void test_derivatives_scale()
{
    Failures failures;
    Random random(62);
    for (int n = 0; n < draws(2000); ++n) {
        auto const p = random_pair<3>(random, {.aspect = 10.0});
        int const e = static_cast<int>(random.uniform(-450.0, 450.0));
        Sample<double, 3> const s{pw85::detail::times_power_of_two(p.r12, e),
                                  pw85::detail::times_power_of_two(p.q1, 2 * e),
                                  pw85::detail::times_power_of_two(p.q2, 2 * e)};
        double out[2];
        pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
        AtLambda const own(p, out[1]), scaled(s, out[1]);
        // Exchanging the two, as scaling may, changes rounding errors only: a few u of the largest
        // coordinate, times the condition number of the blend, 100 at most.
        auto const close = [&](double const *x, double const *y, int exponent, char const *what) {
            double largest = 0.0;
            for (int i = 0; i < 3; ++i) largest = std::fmax(largest, std::fabs(x[i]));
            for (int i = 0; i < 3; ++i) {
                double const unscaled = std::ldexp(y[i], -exponent);
                failures.check(std::fabs(unscaled - x[i]) <= 0x1p-53 * 1e4 * largest, what,
                               unscaled, x[i],
                               [&] { return hex_text(p) + ", exponent " + std::to_string(e); });
            }
        };
        close(own.point, scaled.point, e, "point");
        close(own.normal, scaled.normal, 0, "normal");
        close(own.force, scaled.force, -e, "d_r12");
        close(own.torque1, scaled.torque1, 0, "d_rot1");
    }
}

// The bits of doubles against the functions of the C library.
void test_powers_of_two()
{
    Failures failures;
    Random random(66);
    for (int n = 0; n < draws(200000); ++n) {
        double const x =
            random.sign() *
            std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.uniform(-1080.0, 1024.0)));
        int const exponent = static_cast<int>(random.uniform(-2300.0, 2300.0));
        auto const describe = [&] {
            return hex_text(&x, 1) + ", exponent " + std::to_string(exponent);
        };
        double const scaled = pw85::detail::times_power_of_two(x, exponent),
                     expected = std::ldexp(x, exponent);
        failures.check(scaled == expected, "times_power_of_two", scaled, expected, describe);
        if (x == 0.0) continue;
        int const e = pw85::detail::binary_exponent(std::fabs(x)), expected_e = std::ilogb(x);
        failures.check(e == expected_e, "binary_exponent", e, expected_e, describe);
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_for_each_solver("/range", "sizes", test_sizes);
    add_for_each_solver("/range", "distances", test_distances);
    add_for_each_solver("/range", "denormal", test_denormal);
    add_for_each_solver("/range", "largest", test_largest);
    g_test_add_func("/range/derivatives", test_derivatives_scale);
    g_test_add_func("/range/powers_of_two", test_powers_of_two);
    return g_test_run();
}
