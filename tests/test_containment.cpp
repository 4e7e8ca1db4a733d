// SPDX-License-Identifier: BSD-3-Clause
// Whether an ellipsoid is inside another one, against κ² in 100 digits and against pairs that touch
// from inside by construction.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "containment_truth.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "integer_maps.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

/// 1 or 0 by the headers, or -1 - status.
template <class T, int D> int contains(Sample<T, D> const &s)
{
    auto const answer = pw85::contains(s.r12, s.q1, s.q2);
    return answer.status == pw85::Status::success ? answer.contains
                                                  : -1 - static_cast<int>(answer.status);
}

/// 1 or 0 by the library, or -1 - status.
int contains_in_c(Sample<double, 3> const &s)
{
    int answer = 7;
    int const status = pw85_contains(s.r12.coordinates, s.q1.entries, s.q2.entries, &answer);
    return status == PW85_SUCCESS ? answer : -1 - status;
}

/// Compares all ways to ask with what is right: floating-point numbers decide rightly or not at
/// all, and integers always.
template <class T, int D> void compare(Sample<T, D> const &s, bool expected, Failures &failures)
{
    auto const describe = [&] { return hex_text(s); };
    failures.check(contains(s) == expected, "contains", contains(s), expected, describe);
    bool const exactly = pw85::detail::contains_exactly(s.r12, s.q1, s.q2);
    failures.check(exactly == expected, "contains_exactly", exactly, expected, describe);
    if constexpr (std::is_same_v<T, double> && D == 3)
        failures.check(contains_in_c(s) == expected, "pw85_contains", contains_in_c(s), expected,
                       describe);
}

/// Whether floating-point numbers decide.
template <class T, int D> bool is_decided(Sample<T, D> const &s)
{
    using namespace pw85::detail;
    return decide_containment_scaled(s.r12, s.q1, s.q2) != ContainmentDecision::none;
}

/// The factor of ellipsoid 1 that makes κ² what is wanted, to rounding.
template <int D> Sample<double, D> with_kappa2(Sample<double, D> s, Truth100 const &wanted)
{
    Truth100 const factor = kappa2(s) / wanted;
    for (int k = 0; k < s.q1.size; ++k) s.q1[k] = static_cast<double>(Truth100(factor * s.q1[k]));
    return s;
}

/// Balls, needles, discs and what is between, κ² log-uniform about 1.
template <int D> Sample<double, D> pair_near_touch(Random &random, int n)
{
    double const aspect = n % 4 == 0 ? 1.0 : n % 4 == 1 ? 10.0 : n % 4 == 2 ? 1e3 : 1e6;
    double const distance = random.sign() * random.log_uniform(1e-17, 0.5);
    Sample<double, D> s{
        random.uniform(0.0, 3.0) * random.direction<D>(),
        random_form<D>(random, 1.0, random.log_uniform(1.0, aspect)),
        random_form<D>(random, random.log_uniform(0.01, 1.0), random.log_uniform(1.0, aspect))};
    if (n % 5 == 0) s.r12 = random.log_uniform(1e-12, 1.0) * s.r12;
    return with_kappa2(s, Truth100(1) + distance);
}

template <class T, int D> void test_random()
{
    Failures failures;
    Random random(500 + D);
    int inside = 0, decided = 0, count = draws(800);
    for (int n = 0; n < count; ++n) {
        auto const s = convert<T>(pair_near_touch<D>(random, n));
        if (contains(s) < 0) continue; // a form that is not definite when it is rounded
        bool const expected = is_inside(kappa2(s));
        compare(s, expected, failures);
        inside += expected;
        decided += is_decided(s);
    }
    g_test_message("%d inside, %d decided by floating-point numbers, of %d", inside, decided,
                   count);
    g_assert_cmpint(inside, >, count / 4);
    g_assert_cmpint(inside, <, 3 * count / 4);
    if (std::is_same_v<T, double>) g_assert_cmpint(decided, >, count / 2);
}

/// The same pair in another unit, and with the axes in another order.
template <int D> Sample<double, D> changed(Sample<double, D> const &s, int exponent,
                                           int const (&order)[std::size_t(D)])
{
    Sample<double, D> t = s;
    for (int i = 0; i < D; ++i) {
        t.r12[order[i]] = std::ldexp(s.r12[i], exponent);
        for (int j = i; j < D; ++j) {
            t.q1(order[i], order[j]) = std::ldexp(s.q1(i, j), 2 * exponent);
            t.q2(order[i], order[j]) = std::ldexp(s.q2(i, j), 2 * exponent);
        }
    }
    return t;
}

// Units and orders of the axes change no answer.
template <int D> void test_units()
{
    Failures failures;
    Random random(510 + D);
    int const cycle[3] = {1, 2, 0}, exchange[2] = {1, 0};
    for (int n = 0; n < draws(200); ++n) {
        auto const s = pair_near_touch<D>(random, n);
        int const expected = contains(s);
        if (expected < 0) continue;
        for (int const exponent : {-400, -40, 0, 40, 400})
            if constexpr (D == 3)
                compare(changed(s, exponent, cycle), expected == 1, failures);
            else
                compare(changed(s, exponent, exchange), expected == 1, failures);
    }
}

// Small integers: coincidences of all kinds.
template <int D> void test_small_integers()
{
    Failures failures;
    Random random(520 + D);
    int inside = 0, touching = 0;
    for (int n = 0; n < draws(1500); ++n) {
        Sample<double, D> s{
            {}, mapped_ball(random_map<D>(random, 5, 4)), mapped_ball(random_map<D>(random, 3, 2))};
        for (int i = 0; i < D; ++i)
            s.r12[i] = n % (i + 2) == 0 ? 0 : random_integer(random, 4) / 2.0;
        auto const k = kappa2(s);
        compare(s, is_inside(k), failures);
        inside += is_inside(k);
        touching += abs(k - 1) < Truth100("1e-40");
    }
    g_test_message("%d inside, %d of them touch", inside, touching);
    g_assert_cmpint(inside, >, draws(60));
    g_assert_cmpint(touching, >, draws(8));
}

// Balls: |r| + a2 <= a1, by Pythagorean quadruples. A linear map of integers makes ellipsoids of
// them, which touch as they do.
PW85_TEST("/containment/touching_balls")
{
    Failures failures;
    Random random(530);
    double const quadruples[][4] = {{1, 2, 2, 3},  {2, 3, 6, 7}, {1, 4, 8, 9},
                                    {6, 6, 7, 11}, {0, 3, 4, 5}, {0, 0, 2, 2}};
    for (int n = 0; n < draws(400); ++n) {
        auto const &quadruple = quadruples[n % 6];
        auto const map = n < 6 ? IntegerMap<3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}
                               : random_map<3>(random, 1 + n % 40, n % 40);
        double const a2 = 1 + std::abs(random_integer(random, 20)), a1 = quadruple[3] + a2,
                     scale = std::ldexp(1, n % 801 - 400);
        Sample<double, 3> s{{},
                            mapped_ball(map, a1 * a1 * scale * scale),
                            mapped_ball(map, a2 * a2 * scale * scale)};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k <= i; ++k) s.r12[i] += map.l[i][k] * quadruple[k] * scale;
        compare(s, true, failures);
        auto larger = s, smaller = s, farther = s;
        for (int const k : {0, 3, 5}) {
            larger.q2[k] = std::nextafter(s.q2[k], 1e300);
            smaller.q2[k] = std::nextafter(s.q2[k], 0.0);
        }
        for (int i = 0; i < 3; ++i) farther.r12[i] *= 1 + 0x1p-30;
        compare(larger, false, failures);
        compare(smaller, true, failures);
        compare(farther, false, failures);
    }
}

// Ellipsoids that touch where Q1 - Q2/ν is singular: a rim of radius √½ in the unit ball, at height
// h. With half-thickness s the touch is at ν = ½ if s² = ½ (1 - 2 h²); for h = ½ the curvatures
// agree there, too.
PW85_TEST("/containment/singular_touch")
{
    Failures failures;
    double const heights[] = {0.125, 0.25, 0.375, 0.5, 0.625};
    for (double const h : heights)
        for (double const wide : {0.5, 0.25, 0.0625}) {
            double const s2 = 0.5 - h * h;
            Sample<double, 3> const s{{0, 0, h}, {1, 0, 0, 1, 0, 1}, {0.5, 0, 0, wide, 0, s2}};
            Sample<double, 2> const flat{{0, h}, {1, 0, 1}, {0.5, 0, s2}};
            compare(s, true, failures);
            compare(flat, true, failures);
            for (double const towards : {0.0, 1.0}) {
                auto near = s;
                auto flat_near = flat;
                near.q2[5] = flat_near.q2[2] = std::nextafter(s2, towards);
                compare(near, is_inside(kappa2(near)), failures);
                compare(flat_near, is_inside(kappa2(flat_near)), failures);
                near = s;
                near.q2[0] = std::nextafter(0.5, towards);
                compare(near, is_inside(kappa2(near)), failures);
            }
        }
}

// Where Q1 - Q2 is singular only r = 0 is inside.
PW85_TEST("/containment/equal_extents")
{
    Failures failures;
    Random random(540);
    double const tiny = std::numeric_limits<double>::denorm_min();
    for (int n = 0; n < draws(400); ++n) {
        auto const q = random.form(random.log_uniform(1e-100, 1e100), random.log_uniform(1.0, 1e5));
        Sample<double, 3> s{{0.0, -0.0, 0.0}, q, q};
        if (contains(s) < 0) continue;
        compare(s, true, failures);
        for (int k = 0; k < 6; ++k) {
            auto other = s;
            other.q2[k] = std::nextafter(q[k], 0.0);
            compare(other, k == 0 || k == 3 || k == 5, failures);
        }
        s.r12[n % 3] = n % 2 == 0 ? tiny : 1e-120;
        compare(s, false, failures);
    }
    for (double const r : {0.0, tiny, 0.5, 1.0}) {
        compare(Sample<double, 3>{{r, 0, 0}, {4, 0, 0, 4, 0, 4}, {1, 0, 0, 4, 0, 1}}, r == 0.0,
                failures);
        compare(Sample<double, 3>{{0, r, 0}, {4, 0, 0, 4, 0, 4}, {1, 0, 0, 4, 0, 1}}, r == 0.0,
                failures);
        compare(Sample<double, 2>{{r, 0}, {4, 0, 4}, {1, 0, 4}}, r == 0.0, failures);
        compare(Sample<double, 3>{{r, 0, 0}, {4, 0, 0, 4, 0, 4}, {1, 0, 0, 1, 0, 1}}, true,
                failures);
    }
}

// Every limb of the integers: entries at both ends of the range.
template <class T> void test_widest()
{
    using Limits = std::numeric_limits<T>;
    Failures failures;
    T const tiny = Limits::denorm_min(), large = Limits::max();
    pw85::SymmetricMatrix<T, 3> const full{large, tiny, -tiny, large, tiny, large};
    T const quarter = std::ldexp(T(1), Limits::max_exponent - 2), root = std::sqrt(quarter);
    pw85::SymmetricMatrix<T, 3> const ball{4 * (quarter / 2), 0, 0,
                                           4 * (quarter / 2), 0, 4 * (quarter / 2)};
    pw85::SymmetricMatrix<T, 3> const blob{quarter / 2, tiny, 0, quarter / 2, -tiny, quarter / 2};
    pw85::SymmetricMatrix<T, 3> const small{quarter / 2, 0, 0, quarter / 2, 0, quarter / 2};
    using S = Sample<T, 3>;
    T const half = root / std::sqrt(T(2));
    bool const is_square = 2 * half * half == quarter;
    compare(S{{0, 0, 0}, full, full}, true, failures);
    compare(S{{tiny, tiny, tiny}, full, full}, false, failures);
    compare(S{{tiny, tiny, tiny}, full, blob}, true, failures);
    compare(S{{tiny, -tiny, tiny}, full, small}, true, failures);
    compare(S{{large, tiny, tiny}, full, blob}, false, failures);
    compare(S{{root, tiny, tiny}, ball, blob}, false, failures);
    if (is_square) compare(S{{half, 0, 0}, ball, small}, true, failures);
    compare(S{{root / 2, tiny, -tiny}, ball, blob}, true, failures);
}

// Every kind of bad input, with the status and the answer.
PW85_TEST("/containment/status")
{
    Sample<double, 3> const good{{0.1, 0.2, 0.3}, {9, 0, 0, 9, 0, 9}, {2, 0, 0, 1, 0, 1}};
    g_assert_cmpint(contains_in_c(good), ==, 1);
    auto const refused = [&](Sample<double, 3> const &s, int status) {
        int answer = 7;
        g_assert_cmpint(pw85_contains(s.r12.coordinates, s.q1.entries, s.q2.entries, &answer), ==,
                        status);
        g_assert_cmpint(answer, ==, -1);
        auto const result = pw85::contains(s.r12, s.q1, s.q2);
        g_assert_true(!result.contains && static_cast<int>(result.status) == status);
        unsigned char code = 7;
        g_assert_cmpint(
            pw85_contains_batch(1, s.r12.coordinates, s.q1.entries, s.q2.entries, &code), ==,
            status);
        g_assert_cmpint(code, ==, 255);
    };
    for (Form3 const &bad : {Form3{1, 2, 0, 1, 0, 1}, Form3{1, 0, 0, 0, 0, 1},
                             Form3{-1, 0, 0, -1, 0, -1}, Form3{1, 1, 1, 1, 1, 1}})
        for (double const r : {0.0, 1.0, 1e6}) {
            refused({{r, 0, 0}, good.q1, bad}, PW85_ENOTPD);
            refused({{r, 0, 0}, bad, good.q2}, PW85_ENOTPD);
        }
}

// Many pairs, one of them bad.
PW85_TEST("/containment/batch")
{
    Random random(550);
    std::vector<Sample<double, 3>> pairs;
    std::vector<double> r12, q1, q2;
    for (int n = 0; n < 1000; ++n) {
        Sample<double, 3> s{random.direction<3>(), random.form(3.0, 3.0), random.form(1.0, 10.0)};
        if (n == 600) s.q2[0] = -1;
        pairs.push_back(s);
        r12.insert(r12.end(), s.r12.coordinates, s.r12.coordinates + 3);
        q1.insert(q1.end(), s.q1.entries, s.q1.entries + 6);
        q2.insert(q2.end(), s.q2.entries, s.q2.entries + 6);
    }
    std::vector<unsigned char> answers(pairs.size(), 7);
    g_assert_cmpint(
        pw85_contains_batch(pairs.size(), r12.data(), q1.data(), q2.data(), answers.data()), ==,
        PW85_ENOTPD);
    int inside = 0;
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        g_assert_cmpint(answers[n], ==, n == 600 ? 255 : contains_in_c(pairs[n]));
        inside += answers[n] == 1;
    }
    g_assert_cmpint(inside, >, 100);
    g_assert_cmpint(inside, <, 900);
}

PW85_ADD_TEST("/containment/random/float", test_random<float, 3>);
PW85_ADD_TEST("/containment/random/double", test_random<double, 3>);
PW85_ADD_TEST("/containment/random/long_double", test_random<long double, 3>);
PW85_ADD_TEST("/containment/random/2d", test_random<double, 2>);
PW85_ADD_TEST("/containment/units/2d", test_units<2>);
PW85_ADD_TEST("/containment/units/3d", test_units<3>);
PW85_ADD_TEST("/containment/small_integers/2d", test_small_integers<2>);
PW85_ADD_TEST("/containment/small_integers/3d", test_small_integers<3>);
PW85_ADD_TEST("/containment/widest/float", test_widest<float>);
PW85_ADD_TEST("/containment/widest/double", test_widest<double>);

} // namespace
