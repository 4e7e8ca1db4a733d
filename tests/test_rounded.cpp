// SPDX-License-Identifier: BSD-3-Clause
// μ² correctly rounded, and λ within one unit in the last place, against exact arithmetic: Sturm's
// theorem in integers of any size says on which side of the middle of two numbers μ² is, and the
// sign of f' in integers says on which side of a number λ is.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "extreme_pairs.hpp"
#include "failures.hpp"
#include "nearly_singular.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "sturm.hpp"

using namespace pw85_tests;
namespace d = pw85::detail;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The number of pairs: a million with `-m perf`.
int pairs(int count) { return g_test_perf() ? 1000000 : draws(count); }

/// How many pairs each step decides.
struct Steps {
    long pairs = 0, bounds = 0, extended = 0, comparisons = 0;
};

/// The distance to the next larger number of x >= 0, also for the largest.
template <class T> T spacing_above(T const &x)
{
    using Limits = std::numeric_limits<T>;
    return x == Limits::max() ? std::ldexp(T(1), Limits::max_exponent - Limits::digits)
                              : std::nextafter(x, Limits::infinity()) - x;
}

/// Whether the last digit of x >= 0 is 1.
template <class T> bool is_odd(T const &x)
{
    using Limits = std::numeric_limits<T>;
    int exponent = 0;
    T const fraction = std::frexp(x, &exponent);
    return std::fmod(std::ldexp(fraction, std::min(Limits::digits, exponent - Limits::min_exponent +
                                                                       Limits::digits)),
                     T(2)) != T(0);
}

/// Whether x >= 0 is the number nearest to μ².
template <class T> bool is_nearest(RationalPolynomials const &f, T const &x)
{
    using Limits = std::numeric_limits<T>;
    int const tie = is_odd(x) ? 0 : 1; // in units of a sign: whether the middle belongs to x
    if (x <= Limits::max()) {
        int const above = true_sign_of_middle(f, x, spacing_above(x));
        if (!(above < tie)) return false;
    }
    if (x == T(0)) return true;
    T const below = x > Limits::max() ? Limits::max() : std::nextafter(x, T(0));
    return true_sign_of_middle(f, below, spacing_above(below)) > (x > Limits::max() ? -1 : -tie);
}

/// Σ p_i x^i y^(degree - i).
Integer value_at(Polynomial const &p, int degree, Integer const &x, Integer const &y)
{
    Integer sum = 0, power = 1;
    for (int i = degree; i >= 0; --i) {
        sum *= x;
        if (static_cast<std::size_t>(i) < p.size()) sum += p[static_cast<std::size_t>(i)] * power;
        power *= y;
    }
    return sum;
}

Polynomial derivative(Polynomial const &p)
{
    Polynomial q;
    for (std::size_t i = 1; i < p.size(); ++i) q.push_back(static_cast<unsigned>(i) * p[i]);
    return q;
}

/// The sign of f' at t = x/y, with f = t/(1 + t) a/b.
int slope_at(RationalPolynomials const &f, Integer const &x, Integer const &y)
{
    Integer const a = value_at(f.a, 2, x, y), b = value_at(f.b, 3, x, y);
    Integer const a1 = value_at(derivative(f.a), 1, x, y), b1 = value_at(derivative(f.b), 2, x, y);
    return Integer(a * b * y + x * (x + y) * (a1 * b - a * b1)).sign();
}

/// Whether the maximiser is within one unit in the last place of λ.
template <class T> bool is_within_unit(RationalPolynomials const &f, T const &lambda)
{
    if (!(lambda >= T(0) && lambda <= T(1))) return false;
    T const unit = spacing_above(lambda);
    int const point = digits_after_point(unit);
    Integer const one = Integer(1) << point, step = shifted(unit, point),
                  middle = shifted(lambda, point);
    Integer const below = middle - step, above = middle + step;
    return (below <= 0 || slope_at(f, below, one - below) > 0) &&
           (above >= one || slope_at(f, above, one - above) < 0);
}

template <class T> double shown(T const &x) { return static_cast<double>(x); }

/// Each step alone, for a pair whose μ² is known: the bounds contain it, and other numbers lead to
/// it.
template <class T, int D> void expect_steps(Sample<T, D> const &s, RationalPolynomials const &f,
                                            T const &mu2, Failures &failures, Steps &steps)
{
    auto const describe = [&] { return hex_text(s); };
    auto const pair = d::pair_of(s.r12, s.q1, s.q2);
    d::ScaledPair<T, D> scaled;
    if (d::validate_pair(pair, scaled) != pw85::Status::success) return;
    auto const bounds = d::bound_maximum(scaled);
    T const least = std::numeric_limits<T>::min();
    if (bounds.lower >= least)
        failures.check(bounds.lower <= mu2, "lower", shown(bounds.lower), shown(mu2), describe);
    if (bounds.upper >= least)
        failures.check(bounds.upper >= mu2, "upper", shown(bounds.upper), shown(mu2), describe);
    if (bounds.lambda == bounds.lambda)
        failures.check(is_within_unit(f, bounds.lambda), "lambda of bounds", shown(bounds.lambda),
                       0, describe);
    steps.bounds += d::decides(bounds);
    ++steps.pairs;
    steps.comparisons += d::round_contact(pair).comparisons;

    if (steps.pairs % 16 == 0) {
        int const ratio = d::half_exponent(d::largest_diagonal(s.q1)) -
                          d::half_exponent(d::largest_diagonal(s.q2));
        auto const precise =
            d::maximize_to_all_digits(scaled, scaled.units.swapped ? -ratio : ratio, bounds.t);
        failures.check(is_within_unit(f, precise.lambda), "lambda", shown(precise.lambda), 0,
                       describe);
        steps.extended += is_nearest(f, precise.mu2);
    }
    if (steps.pairs % 8 == 0 && mu2 < T(infinity))
        for (T guess :
             {mu2, T(mu2 * T(1 - 4 * std::numeric_limits<T>::epsilon())),
              T(mu2 * T(1 + 4 * std::numeric_limits<T>::epsilon())), T(mu2 + spacing_above(mu2))}) {
            int comparisons = 0;
            T const found = d::nearest_number(s.r12, s.q1, s.q2, guess, comparisons);
            failures.check(found == mu2, "nearest_number", shown(found), shown(mu2), describe);
        }
}

/// The result of a pair, of the pair with both ellipsoids exchanged, and of each step alone.
template <class T, int D>
void expect_rounded(Sample<T, D> const &s, Failures &failures, Steps &steps)
{
    auto const describe = [&] { return hex_text(s); };
    auto const c = pw85::contact_rounded(s.r12, s.q1, s.q2);
    if (pw85::contact(s.r12, s.q1, s.q2).status != pw85::Status::success) return;
    if (!failures.check(c.status == pw85::Status::success, "status", static_cast<int>(c.status), 0,
                        describe))
        return;
    auto const f = rational_polynomials(s);
    failures.check(is_nearest(f, c.mu2), "mu2", shown(c.mu2), 0, describe);
    failures.check(is_within_unit(f, c.lambda), "lambda", shown(c.lambda), 0, describe);
    auto const swapped = pw85::contact_rounded(-s.r12, s.q2, s.q1);
    failures.check(swapped.mu2 == c.mu2, "swapped mu2", shown(swapped.mu2), shown(c.mu2), describe);
    if constexpr (std::is_same_v<T, double> && D == 3) {
        double out[2];
        pw85_contact_rounded(s.r12.coordinates, s.q1.entries, s.q2.entries, out);
        failures.check(out[0] == c.mu2, "pw85_contact_rounded", out[0], c.mu2, describe);
        failures.check(out[1] == c.lambda || is_within_unit(f, out[1]), "its lambda", out[1],
                       c.lambda, describe);
    }
    expect_steps(s, f, c.mu2, failures, steps);
}

void report(Steps const &steps)
{
    g_test_message(
        "%ld pairs, %ld decided by bounds, %ld of %ld to all digits nearest, %ld comparisons",
        steps.pairs, steps.bounds, steps.extended, steps.pairs / 16, steps.comparisons);
}

// Random pairs of all kinds: general ones, near contact, crossed needles and ribbons.
template <class T, int D> void test_random()
{
    Failures failures;
    Steps steps;
    Random random(700 + D);
    for (int n = 0; n < pairs(1200); ++n) {
        double const aspect = n % 8 == 7   ? 1e8
                              : n % 8 == 6 ? 1e6
                              : n % 8 == 5 ? 1e4
                              : n % 8 == 4 ? 100.0
                                           : 5.0;
        double const mu2 = 1.0 + random.sign() * random.log_uniform(1e-15, 1e-3);
        expect_rounded(
            convert<T>(n % 3 == 0 ? crossed_pair<D>(random, aspect)
                                  : random_pair<D>(random, {.aspect = aspect,
                                                            .size_ratio = n % 5 == 0 ? 1e6 : 2.0,
                                                            .mu2_min = n % 3 == 1 ? mu2 : 0.01,
                                                            .mu2_max = n % 3 == 1 ? mu2 : 100.0})),
            failures, steps);
    }
    report(steps);
    g_assert_cmpint(steps.bounds, >, steps.pairs / 3); // fewest for float
    // Bounds with the digits of long double decide all of these on some machines.
    if (std::numeric_limits<T>::digits <= std::numeric_limits<double>::digits)
        g_assert_cmpint(steps.bounds, <, steps.pairs);
}

// Needles, ribbons and discs whose forms are singular to working precision.
PW85_TEST("/rounded/singular")
{
    Failures failures;
    Steps steps;
    Random random(710);
    for (int n = 0; n < pairs(400); ++n) {
        auto const s = nearly_singular_pair(random, random.log_uniform(1e2, 1e8));
        if (is_exactly_definite(s)) expect_rounded(s, failures, steps);
    }
    report(steps);
}

// Sizes from 1e-150 to 1e150, of both ellipsoids and of one against the other, and any shape that
// doubles can have.
PW85_TEST("/rounded/sizes")
{
    Failures failures;
    Steps steps;
    Random random(720);
    for (int n = 0; n < pairs(400); ++n) {
        auto s = extreme_pair(random, n % 3);
        if (n % 2 == 0) {
            s = random_pair<3>(random, {.aspect = n % 4 == 0 ? 1e3 : 3.0});
            int const size1 = static_cast<int>(random.uniform(-500.0, 500.0)),
                      size2 = n % 8 < 4 ? size1 : static_cast<int>(random.uniform(-500.0, 500.0)),
                      length = n % 8 < 4 ? size1 + static_cast<int>(random.uniform(-20.0, 20.0))
                                         : std::max(size1, size2);
            s = {d::times_power_of_two(s.r12, length), d::times_power_of_two(s.q1, 2 * size1),
                 d::times_power_of_two(s.q2, 2 * size2)};
        }
        if (is_exactly_definite(s)) expect_rounded(s, failures, steps);
    }
    report(steps);
    g_assert_cmpint(steps.bounds, >, steps.pairs / 4);
}

// Axes along the coordinates, with lengths that span the whole range of doubles.
PW85_TEST("/rounded/span")
{
    Failures failures;
    Steps steps;
    Random random(725);
    double const tiny = std::numeric_limits<double>::denorm_min();
    for (int n = 0; n < pairs(100); ++n) {
        Sample<double, 3> s{{std::exp2(random.uniform(-1070.0, 520.0)), -tiny, 3 * tiny}, {}, {}};
        double const least2 = n % 2 == 0 ? -1070.0 : 900.0, most1 = n % 4 == 1 ? -1060.0 : 1023.0;
        for (int i = 0; i < 3; ++i) {
            s.q1(i, i) = std::exp2(random.uniform(-1070.0, most1));
            s.q2(i, i) = std::exp2(random.uniform(least2, 1023.0));
        }
        auto const status = pw85::contact_rounded(s.r12, s.q1, s.q2).status;
        failures.check(status != pw85::Status::no_convergence, "status", static_cast<int>(status),
                       0, [&] { return hex_text(s); });
        expect_rounded(s, failures, steps);
    }
    report(steps);
}

// Other units that are powers of two change no bit of μ² and of λ.
PW85_TEST("/rounded/units")
{
    Failures failures;
    Random random(730);
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = random_pair<3>(random, {.aspect = random.log_uniform(1.0, 1e5)});
        auto const c = pw85::contact_rounded(s.r12, s.q1, s.q2);
        for (int const exponent : {-400, -40, 40, 400}) {
            auto const other = pw85::contact_rounded(d::times_power_of_two(s.r12, exponent),
                                                     d::times_power_of_two(s.q1, 2 * exponent),
                                                     d::times_power_of_two(s.q2, 2 * exponent));
            failures.check(other.mu2 == c.mu2, "mu2", other.mu2, c.mu2,
                           [&] { return hex_text(s); });
            auto const longer =
                pw85::contact_rounded(d::times_power_of_two(s.r12, exponent), s.q1, s.q2);
            double const expected = std::ldexp(c.mu2, 2 * exponent);
            failures.check(longer.mu2 == expected, "longer", longer.mu2, expected,
                           [&] { return hex_text(s); });
        }
    }
}

// All contact problems.
PW85_TEST("/rounded/problems")
{
    Failures failures;
    Steps steps;
    std::size_t index = 0;
    for (auto const &p : contact_problems()) {
        if (++index % static_cast<std::size_t>(stride(4)) == 0)
            expect_rounded(p.pair, failures, steps);
        auto const c = pw85::contact_rounded(p.pair.r12, p.pair.q1, p.pair.q2);
        failures.check(c.mu2 == p.mu2, "mu2 of the data", c.mu2, p.mu2,
                       [&] { return hex_text(p.pair); });
    }
    report(steps);
}

/// Balls of radii a and 2^k - a whose centres differ by three integers, times a power of two. A map
/// stretches the axes. So μ² is the sum of the squares over 4^k. Greedy squares leave less than
/// 2^16 of the 106 bits: the sum is `numerator` or just below.
Sample<double, 3> balls(Random &random, Integer const &numerator, int below)
{
    double const sum = 64.0, a1 = std::floor(random.uniform(1.0, 64.0)), a2 = sum - a1;
    Sample<double, 3> s{};
    Integer rest = numerator - below;
    for (int i = 0; i < 3; ++i) {
        Integer const x = sqrt(rest);
        rest -= x * x;
        double const stretch = std::ldexp(1.0, static_cast<int>(random.uniform(-30.0, 30.0)));
        s.r12[i] = stretch * static_cast<double>(x);
        s.q1(i, i) = stretch * stretch * a1 * a1;
        s.q2(i, i) = stretch * stretch * a2 * a2;
    }
    return s;
}

// μ² is the middle of two doubles, or next to it by up to 2^-90 of itself. An odd x of 27 bits has
// a square of 53 or 54 bits.
PW85_TEST("/rounded/middles")
{
    Failures failures;
    Steps steps;
    Random random(740);
    long middles = 0, below = 0, above = 0;
    for (int n = 0; n < draws(1600); ++n) {
        auto const odd =
            static_cast<long long>(std::floor(random.uniform(0x1.7p25, 0x1p26))) * 2 + 1;
        Integer const middle = Integer(odd) * odd;
        auto s = balls(random, n % 2 == 0 ? middle : Integer(middle << 50), n % 2);
        if (n % 4 == 2) s.r12[1] = s.q1(1, 1) < 0x1p-30 ? 0.0 : std::sqrt(s.q1(1, 1)) * 0x1p-30;
        auto const c = pw85::contact_rounded(s.r12, s.q1, s.q2);
        auto const f = rational_polynomials(s);
        for (double const m : {c.mu2, std::nextafter(c.mu2, 0.0)}) {
            auto const sign = true_sign_of_middle(f, m, spacing_above(m));
            middles += sign == 0;
        }
        below += n % 4 == 1 || n % 4 == 3;
        above += n % 4 == 2;
        expect_rounded(s, failures, steps);
    }
    report(steps);
    g_test_message("%ld middles, %ld below, %ld above", middles, below, above);
    g_assert_cmpint(middles, >, draws(1600) / 8);
    g_assert_cmpint(steps.comparisons, >=, steps.pairs / 2);
}

// μ² is a double: balls of integers.
PW85_TEST("/rounded/doubles")
{
    Failures failures;
    Steps steps;
    Random random(750);
    for (int n = 0; n < draws(800); ++n) {
        auto const s =
            balls(random, Integer(std::floor(random.uniform(1.0, 0x1p30))) << (n % 3), 0);
        expect_rounded(s, failures, steps);
    }
    report(steps);
}

/// The pairs of data/contact_rounded.wc: lines of 15 numbers with commas between them, and comments
/// behind `#`.
std::vector<Sample<double, 3>> worst_roundings()
{
    std::string path = reference_data_path();
    path.replace(path.rfind('/') + 1, std::string::npos, "contact_rounded.wc");
    std::ifstream file(path);
    std::vector<Sample<double, 3>> found;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        Sample<double, 3> s{};
        char const *next = line.c_str();
        for (int k = 0; k < 15; ++k) {
            char *end = nullptr;
            (k < 3 ? s.r12[k] : k < 9 ? s.q1[k - 3] : s.q2[k - 9]) = std::strtod(next, &end);
            g_assert_cmpint(*end, ==, k < 14 ? ',' : 0);
            next = end + 1;
        }
        found.push_back(s);
    }
    return found;
}

// The worst pairs known: μ² is so near to the middle of two doubles that doubled numbers leave the
// rounding open for most of them.
PW85_TEST("/rounded/worst")
{
    Failures failures;
    Steps steps;
    for (auto const &s : worst_roundings()) expect_rounded(s, failures, steps);
    report(steps);
    g_assert_cmpint(steps.pairs, >=, 16);
    g_assert_cmpint(steps.bounds, <, steps.pairs / 2);
}

// The ends of the range: subnormal μ², middles of subnormal numbers, and the middle between the
// largest number and 2^1024.
PW85_TEST("/rounded/ends")
{
    Failures failures;
    Steps steps;
    Random random(760);
    pw85::SymmetricMatrix<double, 3> const unit{0.25, 0, 0, 0.25, 0, 0.25};
    for (double const odd : {1.0, 3.0, 5.0, 7.0, 1001.0, 0x1p20 + 1.0})
        for (double const tilt : {1.0, 1.0 - 0x1p-50, 1.0 + 0x1p-50})
            // x = y and z = 0: μ² = 2 x². With z, μ² rounds to it in 53 bits.
            for (double const z : {0.0, 0x1p-30}) {
                double const x = 0x1p-538 * odd;
                expect_rounded(Sample<double, 3>{{x, tilt * x, z * x}, unit, unit}, failures,
                               steps);
            }
    for (int n = 0; n < draws(400); ++n) {
        auto s = random_pair<3>(random, {.aspect = 10.0});
        int const exponent = n % 2 == 0 ? -static_cast<int>(random.uniform(505.0, 545.0)) : 511;
        s.r12 = d::times_power_of_two(s.r12, exponent);
        expect_rounded(s, failures, steps);
    }
    // x² + y² + 2z² = 2^54 - 1, so μ² = 2^1024 - 2^970 with the factor 2^970.
    double const x = 131354946, y = 27573115, z = 89;
    for (double const last : {z, std::nextafter(z, 0.0), std::nextafter(z, infinity)}) {
        Sample<double, 3> const s{{0x1p485 * x, 0x1p485 * y, 0x1p485 * last},
                                  {0.25, 0, 0, 0.25, 0, 0.125},
                                  {0.25, 0, 0, 0.25, 0, 0.125}};
        double const expected = last < z ? std::numeric_limits<double>::max() : infinity;
        auto const c = pw85::contact_rounded(s.r12, s.q1, s.q2);
        failures.check(c.mu2 == expected, "end of the range", c.mu2, expected,
                       [&] { return hex_text(s); });
        expect_rounded(s, failures, steps);
    }
    report(steps);
    g_assert_cmpint(steps.comparisons, >, draws(400) / 4);
}

// The bounds of the enclosure contain μ² and λ: at the maximum, off it, and with an s that is off
// as well.
PW85_TEST("/rounded/enclosure")
{
    Failures failures;
    Random random(770);
    double used_below = 0.0, used_above = 0.0, used_step = 0.0;
    for (int n = 0; n < draws(600); ++n) {
        auto const s = random_pair<3>(random, {.aspect = random.log_uniform(1.0, 1e5)});
        auto const exact = precise_truth(s);
        auto const pair = d::pair_of(s.r12, s.q1, s.q2);
        double const off = n % 2 == 0 ? 0.0 : random.sign() * random.log_uniform(1e-15, 1e-5);
        double const t =
            static_cast<double>(Precise(exact.lambda / (1 - exact.lambda))) * (1.0 + off);
        auto const m = d::blend(pair.q1, t, pair.q2);
        auto const inverse = d::invert_by_adjugate(m);
        auto wrong = d::solve(inverse, pair.r12);
        for (int i = 0; i < 3 && n % 4 == 1; ++i) wrong[i] *= 1.0 + off * random.sign();
        auto const e = d::enclose(pair, {t, wrong}, m, inverse);
        if (!(inverse.error < 0.0625 && e.step.proved)) continue;
        auto const describe = [&] { return hex_text(s) + ", t = " + hex_text(&t, 1); };
        Precise const error = exact.mu2 - Precise(e.value.high) - Precise(e.value.low);
        double const above = static_cast<double>(Precise(error / e.above)),
                     below = static_cast<double>(-error / e.below);
        failures.check(above <= 1.0, "above", above, 1.0, describe);
        failures.check(below <= 1.0, "below", below, 1.0, describe);
        Precise const lambda = Precise(e.lambda.high) + Precise(e.lambda.low);
        double const step = static_cast<double>(
                         Precise((exact.lambda / lambda - 1) / Precise(e.complement.high))),
                     off_step = std::fabs(step - e.step.step) / e.step.error;
        // The factor 1-λ of the relative error of λ is not used.
        failures.check(off_step <= 1.0 + 0x1p-40, "step", off_step, 1.0, describe);
        used_above = std::max(used_above, above);
        used_below = std::max(used_below, below);
        used_step = std::max(used_step, off_step);
    }
    g_test_message("used: above %g, below %g, step %g", used_above, used_below, used_step);
    g_assert_cmpfloat(used_above, >, 0.1);
}

PW85_TEST("/rounded/concentric")
{
    auto const concentric = pw85::contact_rounded(
        pw85::Vector<double, 3>{0, -0.0, 0}, pw85::SymmetricMatrix<double, 3>{9, 0, 0, 9, 0, 9},
        pw85::SymmetricMatrix<double, 3>{2, 0, 0, 1, 0, 1});
    g_assert_true(concentric.status == pw85::Status::success && concentric.mu2 == 0.0 &&
                  concentric.lambda == 0.5);
}

// A number of 50 digits is computed to rounding.
PW85_TEST("/rounded/wide")
{
    auto const s =
        convert<Wide>(Sample<double, 3>{{3, 0, 4}, {1, 0, 0, 1, 0, 1}, {9, 0, 0, 9, 0, 9}});
    auto const c = pw85::contact_rounded(s.r12, s.q1, s.q2);
    g_assert_true(abs(Wide(c.mu2 - Wide(25) / 16)) < Wide("1e-47"));
    g_assert_true(abs(Wide(c.lambda - Wide(1) / 4)) < Wide("1e-20"));
}

PW85_ADD_TEST("/rounded/random/float", test_random<float, 3>);
PW85_ADD_TEST("/rounded/random/double", test_random<double, 3>);
PW85_ADD_TEST("/rounded/random/long_double", test_random<long double, 3>);
PW85_ADD_TEST("/rounded/random/2d", test_random<double, 2>);

} // namespace
