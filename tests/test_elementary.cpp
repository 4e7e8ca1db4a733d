// SPDX-License-Identifier: BSD-3-Clause
// The functions that the library has in place of those of the C library: sine and cosine, and
// powers of packs; and two numbers with twice the digits side by side.
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85/algebra/two_doubled.hpp>

#include "../src/simd/power.hpp"
#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/multiprecision.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

// Enough digits for angles up to 2^1000.
using Wide = Multiprecision<360>;

double ulp(double x) { return std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x); }

double error_of(double computed, Wide const &exact)
{
    return static_cast<double>(abs(Wide(computed) - exact));
}

void check_angle(double angle, Failures &failures)
{
    auto const computed = pw85::detail::sine_cosine(angle);
    Wide const sine = sin(Wide(angle)), cosine = cos(Wide(angle));
    bool const small = std::fabs(angle) <= 0.7853981633974483;
    double const rest = 0x1p-53 + 0x1p-102 * std::fabs(angle);
    double const bound1 = small ? ulp(static_cast<double>(sine)) : rest,
                 bound2 = small ? 0x1p-53 : rest;
    double const error1 = error_of(computed.sine, sine), error2 = error_of(computed.cosine, cosine);
    auto const describe = [&] { return hex_text(&angle, 1); };
    failures.check(error1 <= bound1, "sine", error1, bound1, describe);
    failures.check(error2 <= bound2, "cosine", error2, bound2, describe);
}

// Angles of all sizes, and next to multiples of π/2. Beyond 2^100 the bound is of no use, but the
// point is on the circle.
PW85_TEST("/elementary/sine_cosine")
{
    Failures failures;
    Random random(40);
    for (int n = 0; n < draws(4000); ++n) {
        check_angle(random.sign() *
                        random.log_uniform(n % 4 == 0 ? 1e-300 : 1e-3, n % 4 == 1 ? 0x1p100 : 8.0),
                    failures);
        double const multiple =
            std::floor(random.log_uniform(1.0, n % 2 == 0 ? 10.0 : 1e9)) * 1.5707963267948966;
        check_angle(multiple, failures);
        check_angle(std::nextafter(multiple, 0.0), failures);
        auto const far =
            pw85::detail::sine_cosine(random.sign() * random.log_uniform(0x1p100, 0x1p1023));
        double const length = far.sine * far.sine + far.cosine * far.cosine;
        failures.check(std::fabs(length - 1.0) < 0x1p-50, "length", length, 1.0,
                       [] { return std::string("far"); });
    }
    auto const zero = pw85::detail::sine_cosine(0.0);
    g_assert_true(zero.sine == 0.0 && zero.cosine == 1.0);
    for (double const bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        auto const none = pw85::detail::sine_cosine(bad);
        g_assert_true(std::isnan(none.sine) && std::isnan(none.cosine));
    }
}

// Two angles side by side have the bits of each alone, whether the series of both are side by side
// or one angle is too large for that.
PW85_TEST("/elementary/two_angles")
{
    using pw85::detail::sine_cosine;
    Failures failures;
    Random random(41);
    auto const check = [&](double angle, double sine, double cosine) {
        auto const [expected_sine, expected_cosine] = sine_cosine(angle);
        auto const describe = [&] { return hex_text(&angle, 1); };
        failures.check(sine == expected_sine, "sine", sine, expected_sine, describe);
        failures.check(cosine == expected_cosine, "cosine", cosine, expected_cosine, describe);
    };
    for (int n = 0; n < draws(4000); ++n) {
        double const first = random.sign() * random.log_uniform(1e-300, n % 2 == 0 ? 0.75 : 1e3),
                     second = random.uniform(-0.8, 0.8);
        auto const both = sine_cosine(pw85::detail::TwoLanes<double>(first, second));
        check(first, first_of(both.sine), first_of(both.cosine));
        check(second, second_of(both.sine), second_of(both.cosine));
    }
}

double power_of(double x, double exponent)
{
    double numbers[pw85::detail::lanes];
    for (double &number : numbers) number = 1.0;
    numbers[pw85::detail::lanes - 1] = x;
    auto const powers =
        pw85::detail::power(pw85::detail::load_lanes<pw85::detail::Pack>(numbers), exponent);
    return powers[pw85::detail::lanes - 1];
}

// Exponents that are no multiples of 1/2, or out of the range of products. Results that are
// subnormal err by half a spacing more.
PW85_TEST("/elementary/power")
{
    Failures failures;
    Random random(41);
    double worst = 0.0;
    for (int n = 0; n < draws(20000); ++n) {
        double const x = n % 4 == 0   ? random.log_uniform(0x1p-1074, 0x1p1023)
                         : n % 4 == 1 ? 1.0 + random.sign() * random.log_uniform(1e-15, 0.5)
                                      : random.log_uniform(1e-3, 1e3);
        double const z = random.sign() * random.log_uniform(1e-10, 700.0);
        double const exponent =
            n % 4 == 3 ? std::floor(random.uniform(-40.0, 80.0)) + 0.25 : z / std::log(x);
        if (!(std::fabs(exponent * std::log(x)) < 745.0)) continue;
        Wide const exact = exp(Wide(exponent) * log(Wide(x)));
        double const computed = power_of(x, exponent), error = error_of(computed, exact);
        double const bound = 2 * 0x1p-53 * static_cast<double>(exact) + 0x1p-1074;
        double const arguments[] = {x, exponent};
        failures.check(error <= bound || exact > std::numeric_limits<double>::max(), "power", error,
                       bound, [&] { return hex_text(arguments, 2); });
        if (exact > 1e-300 && exact < 1e300)
            worst = std::fmax(worst, error / static_cast<double>(exact) * 0x1p53);
    }
    g_test_message("largest relative error %.2f u", worst);
}

// What the standard says of pow(), for zero, infinity, large exponents and what is no number.
PW85_TEST("/elementary/special_powers")
{
    Failures failures;
    double const numbers[] = {0.0,      0x1p-1074,     0.5,           1.0,       2.0,
                              HUGE_VAL, 1.0 - 0x1p-53, 1.0 + 0x1p-52, 0x1.fp1023};
    for (double const x : numbers)
        for (double const exponent :
             {-1e300, -0x1p70, -1e5, -33.5, -0.25, 0.25, 33.5, 1e5, 0x1p70, 1e300}) {
            double const computed = power_of(x, exponent), expected = std::pow(x, exponent);
            double const arguments[] = {x, exponent};
            failures.check(computed == expected || std::fabs(computed / expected - 1) < 1e-15,
                           "power", computed, expected, [&] { return hex_text(arguments, 2); });
        }
    g_assert_true(std::isnan(power_of(std::numeric_limits<double>::quiet_NaN(), 0.3)));
    g_assert_true(std::isnan(power_of(-1.0, 0.3)));
}

/// A number of any sign and size, with the digits of a draw or with few digits.
double number_of_size(Random &random, double least, double most)
{
    double const size =
        std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.uniform(least, most)));
    double const sign = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    return sign * (random.uniform(0.0, 1.0) < 0.1 ? std::ldexp(1.0, std::ilogb(size)) : size);
}

bool are_same(double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }

using Digits = pw85::detail::Doubled<double>;
using Both = pw85::detail::TwoLanes<Digits>;

Digits digits_of(Random &random)
{
    double const high = number_of_size(random, -520.0, 520.0);
    return pw85::detail::ordered_sum(high, high * random.uniform(-0x1p-53, 0x1p-53));
}

// Both lanes have the bits of single numbers.
PW85_TEST("/elementary/two_numbers_with_twice_the_digits")
{
    Failures failures;
    Random random(58);
    for (int n = 0; n < draws(20000); ++n) {
        Digits const x[] = {digits_of(random), digits_of(random)};
        Digits const y[] = {digits_of(random), n % 7 == 0 ? x[1] : digits_of(random)};
        Both const a(x[0], x[1]), b(y[0], y[1]);
        Both const results[] = {a + b, a - b, a * b, a / b, maximum(a, b), minimum(a, b)};
        for (int i = 0; i < 2; ++i) {
            using pw85::detail::maximum, pw85::detail::minimum;
            Digits const expected[] = {x[i] + y[i], x[i] - y[i],         x[i] * y[i],
                                       x[i] / y[i], maximum(x[i], y[i]), minimum(x[i], y[i])};
            for (int k = 0; k < 6; ++k) {
                Digits const found = i == 0 ? first_of(results[k]) : second_of(results[k]);
                double const numbers[] = {x[i].high, x[i].low, y[i].high, y[i].low,
                                          static_cast<double>(k)};
                failures.check(
                    are_same(found.high, expected[k].high) && are_same(found.low, expected[k].low),
                    "number", found.low, expected[k].low, [&] { return hex_text(numbers, 5); });
            }
        }
    }
}

} // namespace
