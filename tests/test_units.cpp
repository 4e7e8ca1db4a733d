// SPDX-License-Identifier: BSD-3-Clause
// Units that are powers of two (include/pw85/algebra/units.hpp), against std::ldexp, which rounds
// once.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <glib.h>

#include <pw85/algebra/units.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;
using pw85::detail::Unit;
using pw85::detail::unit_of;
using pw85::detail::Units;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns whether two numbers are the same, with the sign of zero.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string text(double x, Unit unit, int power)
{
    return hex_text(&x, 1) + ", unit 2^" + std::to_string(unit.exponent) + ", power " +
           std::to_string(power);
}

/// A number of any size: zero, subnormal, infinite or ordinary.
template <class T = double> T any_number(Random &random, int n)
{
    using Limits = std::numeric_limits<T>;
    T const sign = static_cast<T>(random.sign());
    switch (n % 8) {
    case 0:
        return sign * T(0);
    case 1:
        return sign * Limits::infinity();
    case 2:
        return sign * static_cast<T>(random.uniform(0.0, Limits::min()));
    default:
        return sign * static_cast<T>(random.log_uniform(Limits::min(), Limits::max() / 2));
    }
}

/// Any unit: that of the caller, one near it, or one up to 2^±1000.
Unit any_unit(Random &random, int n)
{
    if (n % 16 == 0) return {random.sign() < 0.0 ? -1000 : 1000};
    int const largest = n % 3 == 0 ? 1000 : n % 3 == 1 ? 40 : 0;
    return {static_cast<int>(std::lround(random.uniform(-largest, largest)))};
}

template <class T, std::size_t N> void fill(Random &random, int n, T (&entries)[N])
{
    for (T &x : entries) x = any_number<T>(random, n++);
}

/// Checks each entry of x that is converted to a unit and from it.
template <class X, class T, std::size_t N>
void check_entries(X const &x, T (X::*entries)[N], Unit unit, int power, Failures &failures)
{
    X const local = unit.to_local(x, power), caller = unit.to_caller(x, power);
    for (std::size_t i = 0; i < N; ++i) {
        T const number = (x.*entries)[i], to_local = (local.*entries)[i],
                to_caller = (caller.*entries)[i],
                local_truth = std::ldexp(number, -power * unit.exponent),
                caller_truth = std::ldexp(number, power * unit.exponent);
        auto const describe = [&] { return text(number, unit, power); };
        failures.check(same(to_local, local_truth), "local", to_local, local_truth, describe);
        failures.check(same(to_caller, caller_truth), "caller", to_caller, caller_truth, describe);
    }
}

template <class T, int D> void check_arrays(Random &random, Failures &failures)
{
    using Vector = pw85::Vector<T, D>;
    using Form = pw85::SymmetricMatrix<T, D>;
    using Factor = pw85::Factor<T, D>;
    for (int n = 0; n < draws(4000); ++n) {
        Unit const unit = any_unit(random, n);
        Vector r{};
        Form q{};
        Factor s{};
        fill(random, n, r.coordinates);
        fill(random, n, q.entries);
        fill(random, n, s.entries);
        for (int const power : {-2, -1, 1, 2}) {
            check_entries(r, &Vector::coordinates, unit, power, failures);
            check_entries(q, &Form::entries, unit, power, failures);
            check_entries(s, &Factor::entries, unit, power, failures);
        }
        for (int k = 0; k < q.size; ++k) {
            T const local = unit.to_local(q)[k], truth = std::ldexp(q[k], -2 * unit.exponent);
            failures.check(same(local, truth), "form", local, truth,
                           [&] { return text(q[k], unit, 2); });
        }
    }
}

PW85_TEST("/units/vectors_forms_and_factors")
{
    Failures failures;
    Random random(1);
    check_arrays<double, 2>(random, failures);
    check_arrays<double, 3>(random, failures);
    check_arrays<float, 3>(random, failures);
}

PW85_TEST("/units/numbers")
{
    Failures failures;
    Random random(2);
    for (int n = 0; n < draws(40000); ++n) {
        Unit const unit = any_unit(random, n);
        double const x = any_number(random, n), local = unit.to_local(x),
                     truth = std::ldexp(x, -unit.exponent);
        auto const describe = [&] { return text(x, unit, 1); };
        failures.check(same(local, truth), "local", local, truth, describe);
        failures.check(same(unit.as<double>(), std::ldexp(1.0, unit.exponent)), "as",
                       unit.as<double>(), std::ldexp(1.0, unit.exponent), describe);
    }
}

// Numbers at both ends of the range, and units beyond them.
PW85_TEST("/units/every_exponent")
{
    Failures failures;
    for (int exponent = -2200; exponent <= 2200; ++exponent)
        for (double const x : {0.0, -0.0, infinite, -infinite, 0x1p-1074, 0x1.8p-1060, 0x1p-1022,
                               -0x1.23456789abcdep-40, 1.0, 0x1.fffffffffffffp1023}) {
            Unit const unit{exponent};
            double const caller = unit.to_caller(x), truth = std::ldexp(x, exponent);
            failures.check(same(caller, truth), "caller", caller, truth,
                           [&] { return text(x, unit, 1); });
        }
}

// No digit is lost on the way to another unit and back, unless a number leaves the range.
PW85_TEST("/units/inverses")
{
    Failures failures;
    Random random(3);
    for (int n = 0; n < draws(40000); ++n) {
        Unit const unit = any_unit(random, n);
        double const x = n % 8 == 0 ? 0.0 : random.sign() * random.log_uniform(0x1p-500, 0x1p500);
        int const power = std::abs(unit.exponent) > 260 ? n % 2 * 2 - 1 : n % 5 - 2;
        double const local = unit.to_local(x, power), caller = unit.to_caller(x, power);
        auto const describe = [&] { return text(x, unit, power); };
        if (x == 0.0 || std::isnormal(local))
            failures.check(same(unit.to_caller(local, power), x), "local and back",
                           unit.to_caller(local, power), x, describe);
        if (x == 0.0 || std::isnormal(caller))
            failures.check(same(unit.to_local(caller, power), x), "caller and back",
                           unit.to_local(caller, power), x, describe);
    }
}

PW85_TEST("/units/products_and_quotients")
{
    Failures failures;
    Random random(4);
    for (int n = 0; n < draws(4000); ++n) {
        Unit const a = any_unit(random, n), b = any_unit(random, n / 3);
        double const x = random.log_uniform(0.5, 2.0), product = (a * b).to_caller(x),
                     quotient = (a / b).to_caller(x);
        auto const describe = [&] { return text(x, a, 1) + "; " + text(x, b, 1); };
        failures.check(same(product, std::ldexp(x, a.exponent + b.exponent)), "product", product,
                       std::ldexp(x, a.exponent + b.exponent), describe);
        failures.check(same(quotient, std::ldexp(x, a.exponent - b.exponent)), "quotient", quotient,
                       std::ldexp(x, a.exponent - b.exponent), describe);
        auto const larger = larger_of(a, b), smaller = smaller_of(a, b);
        failures.check((a < b) == (a.as<double>() < b.as<double>()), "order", a.as<double>(),
                       b.as<double>(), describe);
        failures.check(larger.as<double>() == std::fmax(a.as<double>(), b.as<double>()), "larger",
                       larger.as<double>(), b.as<double>(), describe);
        failures.check(smaller.as<double>() == std::fmin(a.as<double>(), b.as<double>()), "smaller",
                       smaller.as<double>(), b.as<double>(), describe);
        failures.check(pw85::detail::smallest_unit() < a, "smallest", 0.0, a.as<double>(),
                       describe);
    }
}

/// Checks that a positive number is in [1, limit) in its unit.
void check_local(double largest, double limit, char const *what, Unit unit, double x,
                 Failures &failures)
{
    failures.check(largest >= 1.0 && largest < limit, what, largest, limit,
                   [&] { return text(x, unit, 1); });
}

// The largest of the numbers, wherever it stands, is of order one in the unit of them all.
PW85_TEST("/units/of_numbers_vectors_forms_and_factors")
{
    Failures failures;
    Random random(5);
    for (int n = 0; n < draws(4000); ++n) {
        double const x = n % 4 == 0 ? random.log_uniform(0x1p-1074, 0x1p-1000)
                                    : random.log_uniform(0x1p-1022, 0x1p1023);
        int const k = n % 3;
        check_local(std::ldexp(x, -unit_of(x).exponent), 2.0, "number", unit_of(x), x, failures);
        pw85::Vector<double, 3> r{};
        r[(k + 1) % 3] = 0.75 * x;
        r[k] = random.sign() * x;
        check_local(std::ldexp(x, -unit_of(r).exponent), 2.0, "vector", unit_of(r), x, failures);
        pw85::SymmetricMatrix<double, 3> q{{0.5 * x, x, x, 0.5 * x, x, 0.5 * x}};
        q(k, k) = x;
        check_local(std::ldexp(x, -2 * unit_of(q).exponent), 4.0, "form", unit_of(q), x, failures);
        pw85::Factor<double, 3> s{};
        s(k, n % 2) = -x;
        check_local(std::ldexp(x, -unit_of(s).exponent), 2.0, "factor", unit_of(s), x, failures);
        // x is given in the unit `given`
        Unit const least = any_unit(random, n), given = any_unit(random, n / 3),
                   larger = larger_unit(least, x, given);
        int const own = std::ilogb(x) + given.exponent,
                  expected = own > least.exponent ? own : least.exponent;
        failures.check(larger.exponent == expected, "larger", larger.exponent, expected,
                       [&] { return text(x, least, 1) + "; " + text(x, given, 1); });
        g_assert_cmpint(larger_unit(least, 0.0, given).exponent, ==, least.exponent);
    }
    g_assert_cmpint(unit_of(pw85::Vector<double, 3>{}).exponent, ==, 0);
}

// μ is a length by that of the first ellipsoid. A vector of a pair in the other order is reversed.
PW85_TEST("/units/pairs")
{
    Failures failures;
    Random random(6);
    for (int n = 0; n < draws(4000); ++n) {
        Unit const length = any_unit(random, n), first = any_unit(random, n / 2),
                   second = any_unit(random, n / 3), time = any_unit(random, n / 5);
        Units const units{length, first, second, n % 2 == 1, time};
        auto const describe = [&] { return text(0.0, length, 1) + "; " + text(0.0, first, 1); };
        int const mu = units.mu().exponent, velocity = units.velocity().exponent;
        failures.check(mu == length.exponent - first.exponent, "mu", mu, 0.0, describe);
        failures.check(velocity == length.exponent - time.exponent, "velocity", velocity, 0.0,
                       describe);
        pw85::Vector<double, 3> r{};
        fill(random, n, r.coordinates);
        auto const other = units.reordered(r), back = units.reordered(other);
        for (int i = 0; i < 3; ++i) {
            failures.check(same(other[i], units.swapped ? -r[i] : r[i]), "reordered", other[i],
                           r[i], describe);
            failures.check(same(back[i], r[i]), "back", back[i], r[i], describe);
        }
    }
}

} // namespace
