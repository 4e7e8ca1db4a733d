// SPDX-License-Identifier: BSD-3-Clause
// pw85_overlap() gives the exact result for the numbers that it is given.
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

/// 1 or 0, or -1 - status.
int overlap(Sample<double, 3> const &p)
{
    int answer = -1;
    int const status = pw85_overlap(p.r12.coordinates, p.q1.entries, p.q2.entries, &answer);
    return status == PW85_SUCCESS ? answer : -1 - status;
}

/// The answer for a pair whose exact μ² - 1 is known at least by its sign, tangent pairs (0)
/// included.
PW85_TEST("/overlap/problems")
{
    Failures failures;
    long near = 0;
    for (auto const &p : contact_problems()) {
        int const expected = p.mu2_minus_1 < 0.0, answer = overlap(p.pair);
        bool const is_near = pw85::detail::absolute(p.mu2_minus_1) <= 8 * u * p.cond;
        near += is_near;
        failures.check(answer == expected, is_near ? "overlap, near contact" : "overlap", answer,
                       expected, [&] {
                           return *p.category + ": mu^2 - 1 = " + hex_text(&p.mu2_minus_1, 1) +
                                  ", " + hex_text(p.pair);
                       });
    }
    g_test_message("%ld of the pairs are within 8 u cond of contact", near);
}

// What is decided without exact arithmetic is right, and all is decided that is not near contact:
// the second tier compares with a margin of 8 u cond a value that errs by no more. Left are pairs
// so slender that the value is not proved.
PW85_TEST("/overlap/decisions/problems")
{
    Failures failures;
    std::size_t undecided = 0, slender = 0;
    for (auto const &p : contact_problems()) {
        auto const expected = p.mu2_minus_1 < 0.0 ? pw85::Decision::overlap : pw85::Decision::apart;
        auto const answer = pw85::decide_overlap(p.pair.r12, p.pair.q1, p.pair.q2);
        bool const is_near = pw85::detail::absolute(p.mu2_minus_1) <=
                             (2 * pw85::detail::value_margin + 1) * u * p.cond;
        bool const is_open = answer.decision == pw85::Decision::none;
        undecided += is_open;
        slender += is_open && !is_near;
        failures.check(
            answer.status == pw85::Status::success && (answer.decision == expected || is_open),
            "decision", static_cast<int>(answer.decision), static_cast<int>(expected), [&] {
                return *p.category + ": mu^2 - 1 = " + hex_text(&p.mu2_minus_1, 1) + ", " +
                       hex_text(p.pair);
            });
    }
    g_test_message("%zu of the pairs are left to exact arithmetic, %zu of them not near contact",
                   undecided, slender);
    g_assert_cmpuint(undecided, >, 0);
    g_assert_cmpuint(50 * slender, <, contact_problems().size());
}

// Pairs that are not valid are not decided, and are told from those that cannot be.
PW85_TEST("/overlap/decisions/bad")
{
    Sample<double, 3> const good{
        {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    auto bad = good;
    bad.r12[1] = std::numeric_limits<double>::quiet_NaN();
    auto const not_finite = pw85::decide_overlap(bad.r12, good.q1, good.q2);
    g_assert_true(not_finite.decision == pw85::Decision::none &&
                  not_finite.status == pw85::Status::invalid_argument);
    bad.q2[0] = -1.0;
    auto const indefinite = pw85::decide_overlap(good.r12, good.q1, bad.q2);
    g_assert_true(indefinite.decision == pw85::Decision::none &&
                  indefinite.status == pw85::Status::not_positive_definite);
    auto const tangent = pw85::decide_overlap(2.0 * good.r12, good.q1, good.q2);
    g_assert_true(tangent.decision == pw85::Decision::none &&
                  tangent.status == pw85::Status::success);
    auto const concentric = pw85::decide_overlap(0.0 * good.r12, good.q1, good.q2);
    g_assert_true(concentric.decision == pw85::Decision::overlap);
}

// Spheres with integer data: |r|² = (a1+a2)² exactly, by Pythagorean quadruples.
PW85_TEST("/overlap/tangent/spheres")
{
    double const quadruples[][4] = {{1, 2, 2, 3},  {2, 3, 6, 7},  {1, 4, 8, 9},
                                    {2, 6, 9, 11}, {6, 6, 7, 11}, {3, 4, 12, 13}};
    for (auto const &[x, y, z, length] : quadruples)
        for (double const scale : {1.0, 0x1p-400, 0x1p400, 3.0}) {
            double const a1 = scale, a2 = scale * (length - 1.0);
            Sample<double, 3> p{{scale * x, scale * y, scale * z},
                                {a1 * a1, 0.0, 0.0, a1 * a1, 0.0, a1 * a1},
                                {a2 * a2, 0.0, 0.0, a2 * a2, 0.0, a2 * a2}};
            g_assert_cmpint(overlap(p), ==, 0);
            auto nearer = p, farther = p;
            nearer.r12[2] = std::nextafter(p.r12[2], 0.0);
            farther.r12[2] = std::nextafter(p.r12[2], 1e300);
            g_assert_cmpint(overlap(nearer), ==, 1);
            g_assert_cmpint(overlap(farther), ==, 0);
        }
}

// Tangent pairs answer 0 and stay so under an exchange; moved by the last bit of one coordinate
// they answer for that.
PW85_TEST("/overlap/tangent/neighbours")
{
    Failures failures;
    for (auto const &p : contact_problems()) {
        if (p.mu2_minus_1 != 0.0) continue;
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        Sample<double, 3> const exchanged{-p.pair.r12, p.pair.q2, p.pair.q1};
        failures.check(overlap(exchanged) == 0, "exchanged", overlap(exchanged), 0.0, describe);
        auto larger = p.pair, smaller = p.pair;
        for (int k : {0, 3, 5}) {
            larger.q1[k] = std::nextafter(p.pair.q1[k], 1e300);
            smaller.q1[k] = std::nextafter(p.pair.q1[k], 0.0);
        }
        failures.check(overlap(larger) == 1, "ellipsoid 1 larger", overlap(larger), 1.0, describe);
        failures.check(overlap(smaller) == 0, "ellipsoid 1 smaller", overlap(smaller), 0.0,
                       describe);
    }
}

// Random pairs over the whole range, against the wide type.
PW85_TEST("/overlap/random")
{
    Failures failures;
    Random random(100);
    int overlapping = 0;
    for (int n = 0; n < draws(10000); ++n) {
        PairOptions const options{.aspect = n % 2 == 0 ? 10.0 : 1e5,
                                  .size_ratio = n % 3 == 0 ? 1e12 : 3.0,
                                  .mu2_min = n % 5 == 0 ? 1e-8 : 0.9,
                                  .mu2_max = n % 5 == 0 ? 1e8 : 1.1};
        auto const p = random_pair<3>(random, options);
        auto const w = convert<Wide>(p);
        bool const expected = pw85::contact(w.r12, w.q1, w.q2).mu2 < 1;
        int const answer = overlap(p);
        // A form this slender can lose its definiteness when it is rounded.
        if (answer == -1 - PW85_ENOTPD) continue;
        overlapping += expected;
        failures.check(answer == (expected ? 1 : 0), "overlap", answer, expected,
                       [&] { return hex_text(p); });
    }
    g_assert_cmpint(overlapping, >, draws(3000));
    g_assert_cmpint(overlapping, <, 7000);
}

/// A pair with |μ² - 1| log-uniform from far below the margins of all tests to far above them, of
/// any sizes.
Sample<double, 3> pair_near_margins(Random &random, int n)
{
    double const distance = std::copysign(random.log_uniform(1e-9, 0.7), n % 2 == 0 ? 1.0 : -1.0);
    return random_pair<3>(random, {.aspect = n % 4 < 2 ? 10.0 : 1e3,
                                   .size_ratio = random.log_uniform(1.0, 1e7),
                                   .mu2_min = 1.0 + distance,
                                   .mu2_max = 1.0 + distance});
}

// The tests are made at several points at once where the library has lanes, and at one after the
// other in the headers.
template <class T> void test_margins()
{
    Failures failures;
    Random random(102);
    int tiers[3] = {};
    for (int n = 0; n < draws(10000); ++n) {
        auto const p = convert<T>(pair_near_margins(random, n));
        auto const w = convert<Wide>(p);
        bool const expected = pw85::contact(w.r12, w.q1, w.q2).mu2 < 1;
        auto const describe = [&] { return hex_text(p); };
        auto const answer = pw85::overlap(p.r12, p.q1, p.q2);
        // what rounding can do to it
        if (answer.status == pw85::Status::not_positive_definite) continue;
        ++tiers[static_cast<int>(answer.tier)];
        failures.check(answer.status == pw85::Status::success && answer.overlap == expected,
                       "pw85::overlap", answer.overlap, expected, describe);
        if constexpr (std::is_same_v<T, double>)
            failures.check(overlap(p) == expected, "pw85_overlap", overlap(p), expected, describe);
    }
    g_test_message("quartic %d, contact %d, exact %d", tiers[0], tiers[1], tiers[2]);
    g_assert_cmpint(tiers[0], >, 0);
    g_assert_cmpint(tiers[1], >, 0);
}

/// Half-width of an ellipsoid's projection on a unit vector.
Wide half_width(pw85::SymmetricMatrix<Wide, 3> const &q, pw85::Vector<Wide, 3> const &direction)
{
    return sqrt(pw85::detail::quadratic_form(q, direction));
}

/// xᵀQ⁻¹x: below 1 inside.
Wide level(pw85::SymmetricMatrix<Wide, 3> const &q, pw85::Vector<Wide, 3> const &x)
{
    return pw85::dot(x, pw85::cholesky_solve(pw85::cholesky(q), x));
}

// What is returned as a proof is one: a plane that separates the ellipsoids, or a point that is
// inside both.
PW85_TEST("/overlap/witness/random")
{
    Failures failures;
    Random random(103);
    for (int n = 0; n < draws(5000); ++n) {
        auto const p = random_pair<3>(
            random, {.aspect = 100.0, .size_ratio = 100.0, .mu2_min = 1e-3, .mu2_max = 1e3});
        auto const witness = pw85::overlap_witness(p.r12, p.q1, p.q2);
        auto const w = convert<Wide>(p);
        auto const describe = [&] { return hex_text(p); };
        if (witness.overlap) {
            auto const x = convert<Wide>(witness.point);
            pw85::Vector<Wide, 3> const from2{x[0] - w.r12[0], x[1] - w.r12[1], x[2] - w.r12[2]};
            double const deepest =
                static_cast<double>(pw85::detail::maximum(level(w.q1, x), level(w.q2, from2)));
            failures.check(deepest < 1.0, "point inside both", deepest, 1.0, describe);
            failures.check(std::isnan(witness.direction[0]), "no direction", witness.direction[0],
                           0.0, describe);
        } else {
            auto const normal = convert<Wide>(witness.direction);
            double const gap = static_cast<double>(Wide(
                pw85::dot(normal, w.r12) - half_width(w.q1, normal) - half_width(w.q2, normal)));
            failures.check(gap > 0.0, "gap between the planes", gap, 0.0, describe);
            double const f = static_cast<double>(
                pw85::detail::evaluate_f(Wide(witness.lambda), w.r12, w.q1, w.q2));
            failures.check(f > 1.0, "f(lambda)", f, 1.0, describe);
            failures.check(std::isnan(witness.point[0]), "no point", witness.point[0], 0.0,
                           describe);
        }
    }
}

PW85_TEST("/overlap/witness/special")
{
    Sample<double, 3> p{
        {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, {4.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    auto const concentric = pw85::overlap_witness(p.r12, p.q1, p.q2);
    g_assert_true(concentric.overlap && concentric.status == pw85::Status::success);
    for (int i = 0; i < 3; ++i) g_assert_cmpfloat(concentric.point[i], ==, 0.0);
    p.q2[0] = -1.0;
    auto const invalid = pw85::overlap_witness(p.r12, p.q1, p.q2);
    g_assert_true(!invalid.overlap && invalid.status == pw85::Status::not_positive_definite);
    g_assert_true(std::isnan(invalid.point[0]) && std::isnan(invalid.direction[0]));
}

PW85_TEST("/overlap/extreme_scales")
{
    Failures failures;
    Random random(101);
    for (int n = 0; n < draws(5000); ++n) {
        auto p = random_pair<3>(random, {.aspect = 10.0, .mu2_min = 0.5, .mu2_max = 2.0});
        double const length = random.log_uniform(1e-148, 1e148);
        p.r12 = length * p.r12;
        for (int k = 0; k < 6; ++k) {
            p.q1[k] = length * (length * p.q1[k]);
            p.q2[k] = length * (length * p.q2[k]);
        }
        auto const w = convert<Wide>(p);
        int const expected = pw85::contact(w.r12, w.q1, w.q2).mu2 < 1;
        failures.check(overlap(p) == expected, "overlap", overlap(p), expected,
                       [&] { return hex_text(p); });
    }
}

// Separations and sizes that have nothing to do with each other.
PW85_TEST("/overlap/distances")
{
    double const tiny = std::numeric_limits<double>::denorm_min(),
                 large = std::numeric_limits<double>::max();
    for (double const size : {tiny, 1e-300, 1.0, 1e300})
        for (double const r : {tiny, 1e-300, 1e-100, 1e100, large}) {
            Sample<double, 3> const p{{r, 0.0, 0.0},
                                      {size, 0.0, 0.0, size, 0.0, size},
                                      {size, 0.0, 0.0, size, 0.0, size}};
            g_assert_cmpint(overlap(p), ==, Wide(r) * r < 4 * Wide(size));
        }
}

PW85_TEST("/overlap/concentric")
{
    Sample<double, 3> const p{
        {0.0, -0.0, 0.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, {1e-300, 0.0, 0.0, 1e-300, 0.0, 1e-300}};
    g_assert_cmpint(overlap(p), ==, 1);
}

PW85_TEST("/overlap/status")
{
    Sample<double, 3> const good{
        {1.0, 2.0, 3.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, {2.0, 0.0, 0.0, 1.0, 0.0, 1.0}};
    double const *r12 = good.r12.coordinates, *q1 = good.q1.entries, *q2 = good.q2.entries;
    int answer = 7;
    for (Form3 const &bad :
         {Form3{1.0, 2.0, 0.0, 1.0, 0.0, 1.0}, Form3{1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
          Form3{-1.0, 0.0, 0.0, -1.0, 0.0, -1.0}, Form3{1.0, 1.0, 1.0, 1.0, 1.0, 1.0}}) {
        answer = 7;
        g_assert_cmpint(pw85_overlap(r12, bad.entries, q2, &answer), ==, PW85_ENOTPD);
        g_assert_cmpint(answer, ==, -1);
        g_assert_cmpint(pw85_overlap(r12, q1, bad.entries, &answer), ==, PW85_ENOTPD);
        // Neither far away, where bounding spheres decide, nor at zero distance.
        double const far[3] = {1e6, 0.0, 0.0}, zero[3] = {0.0, 0.0, 0.0};
        g_assert_cmpint(pw85_overlap(far, q1, bad.entries, &answer), ==, PW85_ENOTPD);
        g_assert_cmpint(pw85_overlap(zero, q1, bad.entries, &answer), ==, PW85_ENOTPD);
    }
}

PW85_ADD_TEST("/overlap/margins/float", test_margins<float>);
PW85_ADD_TEST("/overlap/margins/double", test_margins<double>);
PW85_ADD_TEST("/overlap/margins/long_double", test_margins<long double>);

} // namespace
