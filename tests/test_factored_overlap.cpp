// SPDX-License-Identifier: BSD-3-Clause
// The overlap test of ellipsoids that are given by factors of their forms, against 200 digits and
// against pairs that are tangent by construction. The tiers are also tested alone.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "factors.hpp"
#include "failures.hpp"

using namespace pw85_tests;
using pw85::Decision;
using pw85::detail::times_power_of_two;

namespace {

/// The sign of μ² - 1 in 200 digits, for a pair that is not tangent.
template <class T, int D> int sign_of_excess(Factors<T, D> const &p)
{
    auto const w = squared(p);
    TruthOfFactors const excess = pw85::contact(w.r12, w.q1, w.q2).mu2 - 1;
    g_assert_true(abs(excess) > TruthOfFactors("1e-75"));
    return excess > 0 ? 1 : -1;
}

int overlap_in_c(Factors<double, 3> const &p)
{
    int overlap = 7;
    int const status =
        pw85_overlap_factored(p.r12.coordinates, p.s1.entries, p.s2.entries, &overlap);
    return status == PW85_SUCCESS ? overlap : -status;
}

template <class T, int D> Factors<T, D> swapped(Factors<T, D> const &p)
{
    return {-p.r12, p.s2, p.s1};
}

template <class T, int D> Factors<T, D> scaled(Factors<T, D> const &p, int e)
{
    return {times_power_of_two(p.r12, e), times_power_of_two(p.s1, e), times_power_of_two(p.s2, e)};
}

/// Each tier decides as `overlap` says, or not at all; integers always decide.
template <class T, int D> void check_tiers(Factors<T, D> const &p, bool overlap, Failures &failures)
{
    using namespace pw85::detail;
    auto const describe = [&] { return hex_text(p); };
    Decision const wrong = overlap ? Decision::apart : Decision::overlap;
    auto const check = [&](Decision decision, char const *what) {
        failures.check(decision != wrong, what, static_cast<double>(decision), overlap, describe);
    };
    auto const pair = pair_of(p.r12, p.s1, p.s2);
    if (passes_fast_checks(pair)) check(decide_by_rounded_forms(pair), "rounded forms");
    auto const near_contact = decide_near_contact(pair);
    check(near_contact.decision, "maximum");
    auto const exactly = decide_factored_exactly(p.r12, p.s1, p.s2);
    check(exactly, "integers");
    failures.check(exactly != Decision::none, "integers decide", 0, 1, describe);
    auto const all = pw85::overlap_factored(p.r12, p.s1, p.s2);
    failures.check(all.status == pw85::Status::success && all.overlap == overlap, "overlap",
                   all.overlap, overlap, describe);
}

/// Checks a pair, the swapped pair, and both at other sizes.
void check_answer(Factors<double, 3> const &p, bool overlap, Failures &failures)
{
    for (auto const &q : {p, swapped(p)}) {
        check_tiers(q, overlap, failures);
        for (int const e : {-400, -40, 40, 400}) {
            int const actual = overlap_in_c(scaled(q, e));
            failures.check(actual == overlap, "overlap of a scaled pair", actual, overlap,
                           [&] { return hex_text(scaled(q, e)); });
        }
    }
}

/// Puts ellipsoid 2 so that μ² is near 1 + excess.
Factors<double, 3> placed(Factors<double, 3> p, double excess)
{
    double const mu2 = pw85::contact_factored(p.r12, p.s1, p.s2).mu2;
    p.r12 = std::sqrt((1.0 + excess) / mu2) * p.r12;
    return p;
}

/// Pairs as near to contact as doubles allow, of all kinds, aspect ratios to 1e10 and sizes to
/// 2^±40.
PW85_TEST("/factored_overlap/near-contact")
{
    Failures failures;
    Random random(60);
    for (int n = 0; n < draws(2000); ++n) {
        double const aspect = random.log_uniform(1.0, n % 4 == 1 ? 1e5 : 1e10),
                     ratio = n % 2 == 0 ? 1.0 : random.log_uniform(0x1p-40, 0x1p40);
        auto const p = placed(random_factors(random, n % 4, aspect, ratio),
                              random.sign() * random.log_uniform(1e-18, 1e-1));
        check_answer(p, sign_of_excess(p) < 0, failures);
    }
}

/// Integers are not needed for ordinary pairs, of any sizes: at |μ² - 1| = 1e-6, aspect ratios to
/// 1e3, and kinds of factors whose columns are not nearly dependent.
PW85_TEST("/factored_overlap/bounds-suffice")
{
    Failures failures;
    Random random(64);
    for (int n = 0; n < draws(2000); ++n) {
        double const ratio = n % 2 == 0 ? 1.0 : random.log_uniform(0x1p-40, 0x1p40);
        auto const p = placed(random_factors(random, 0, random.log_uniform(1.0, 1e3), ratio),
                              random.sign() * 1e-6);
        for (int const e : {-400, 0, 400}) {
            auto const q = scaled(p, e);
            auto const tier = pw85::overlap_factored(q.r12, q.s1, q.s2).tier;
            failures.check(tier == pw85::OverlapTier::contact, "tier", static_cast<double>(tier),
                           static_cast<double>(pw85::OverlapTier::contact),
                           [&] { return hex_text(q); });
        }
    }
}

/// The bounds of the proofs hold in 200 digits: those on the residual, on the inverse of a factor,
/// and on the gap along a direction.
PW85_TEST("/factored_overlap/bounds")
{
    Failures failures;
    Random random(65);
    for (int n = 0; n < draws(2000); ++n) {
        auto const p =
            random_factors(random, n % 4, random.log_uniform(1.0, n % 4 == 1 ? 1e5 : 1e10), 1.0);
        auto const describe = [&] { return hex_text(p); };
        auto const pair = pw85::detail::pair_of(p.r12, p.s1, p.s2);
        auto const direction = random.direction<3>();
        auto const v = pw85::detail::solve_blend(0.5, p.s1, 0.5, p.s2, p.r12);
        auto const w1 = 0.5 * v.first, w2 = 0.5 * v.second;
        auto const s = n % 2 == 0 ? v.w : direction;
        TruthOfFactors residual = 0, inverse2 = 0, gap = 0, squares[2] = {};
        for (int i = 0; i < 3; ++i) {
            TruthOfFactors e = p.r12[i];
            gap += TruthOfFactors(p.r12[i]) * s[i];
            for (int j = 0; j < 3; ++j)
                e -= TruthOfFactors(p.s1(i, j)) * w1[j] + TruthOfFactors(p.s2(i, j)) * w2[j];
            residual += abs(e);
        }
        for (int j = 0; j < 3; ++j) {
            TruthOfFactors along[2] = {};
            for (int i = 0; i < 3; ++i) {
                along[0] += TruthOfFactors(p.s1(i, j)) * s[i];
                along[1] += TruthOfFactors(p.s2(i, j)) * s[i];
            }
            for (int k = 0; k < 2; ++k) squares[k] += along[k] * along[k];
        }
        gap -= sqrt(squares[0]) + sqrt(squares[1]);
        auto const q = squared(p).q1;
        auto const adjugate = pw85::detail::adjugate(q);
        inverse2 = (adjugate(0, 0) + adjugate(1, 1) + adjugate(2, 2)) /
                   pw85::detail::determinant(q, adjugate);
        double const bound = pw85::detail::bound_on_residual(pair, w1, w2);
        failures.check(residual <= bound, "residual", static_cast<double>(residual), bound,
                       describe);
        double const inverse = pw85::detail::bound_on_inverse(p.s1);
        failures.check(inverse2 <= TruthOfFactors(inverse) * inverse, "inverse",
                       std::sqrt(static_cast<double>(inverse2)), inverse, describe);
        bool const apart = pw85::detail::separates(pair, s, pw85::detail::transposed_times(p.s1, s),
                                                   pw85::detail::transposed_times(p.s2, s));
        failures.check(!apart || gap > 0, "gap", static_cast<double>(gap), 0.0, describe);
    }
}

/// A matrix with small integer entries whose determinant is not zero.
pw85::Factor<double, 3> random_integers(Random &random)
{
    pw85::Factor<double, 3> a{};
    pw85::Vector<double, 3> columns[3];
    do {
        for (double &x : a.entries) x = std::floor(random.uniform(-20.0, 21.0));
        for (int j = 0; j < 3; ++j) columns[j] = pw85::detail::column(a, j);
    } while (pw85::detail::determinant(columns) == 0.0);
    return a;
}

/// Tangent by construction: two spheres, one direction of their contact with integer coordinates,
/// and one integer map for both. Each factor is turned by an orthogonal matrix, times 9, with
/// integer entries.
Factors<double, 3> tangent_pair(Random &random)
{
    pw85::Factor<double, 3> const turn{{1, 8, 4, 8, 1, -4, 4, -4, 7}},
        one{{1, 0, 0, 0, 1, 0, 0, 0, 1}};
    pw85::Factor<double, 3> const flip{{0, -1, 0, 1, 0, 0, 0, 0, 1}};
    auto const map = random_integers(random);
    double const a1 = std::floor(random.uniform(1.0, 1000.0)),
                 a2 = std::floor(random.uniform(1.0, 1000.0));
    auto const times = [](double a, pw85::Factor<double, 3> s) {
        for (double &x : s.entries) x *= a;
        return s;
    };
    pw85::Vector<double, 3> r12{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) r12[i] += (a1 + a2) * map(i, k) * turn(0, k);
    return {r12, product(map, times(a1, random.sign() > 0 ? turn : times(9.0, one))),
            product(map, times(a2, product(turn, flip)))};
}

/// Tangent ellipsoids do not overlap. The last bit of any number decides otherwise or not, and so
/// do tiny numbers.
PW85_TEST("/factored_overlap/tangent")
{
    Failures failures;
    Random random(61);
    for (int n = 0; n < draws(400); ++n) {
        auto p = tangent_pair(random);
        auto const pair = pw85::detail::pair_of(p.r12, p.s1, p.s2);
        failures.check(pw85::detail::decide_near_contact(pair).decision == Decision::none,
                       "no float decides", 0, 0, [&] { return hex_text(p); });
        check_answer(p, false, failures);
        double *const numbers[3] = {p.r12.coordinates, p.s1.entries, p.s2.entries};
        int const which = n % 3;
        double &x = numbers[which][static_cast<int>(random.uniform(0.0, which == 0 ? 3.0 : 9.0))];
        x = x == 0.0 ? random.sign() * 0x1p-60 : std::nextafter(x, random.sign() * 1e9);
        check_answer(p, sign_of_excess(p) < 0, failures);
    }
}

/// Other scalars, and two dimensions: random factors near contact, and balls that touch.
template <class T, int D> void test_scalar()
{
    Failures failures;
    Random random(62);
    for (int n = 0; n < draws(200); ++n) {
        Factors<T, D> p{};
        for (int i = 0; i < D; ++i) {
            p.r12[i] = static_cast<T>(random.normal());
            for (int j = 0; j < D; ++j) {
                p.s1(i, j) = static_cast<T>(random.normal());
                p.s2(i, j) = static_cast<T>(random.normal());
            }
        }
        T const mu2 = pw85::contact_factored(p.r12, p.s1, p.s2).mu2;
        T const excess = static_cast<T>(random.sign() * random.log_uniform(1e-20, 1.0));
        p.r12 = T(pw85::detail::square_root(T(T(1) + excess) / mu2)) * p.r12;
        check_tiers(p, sign_of_excess(p) < 0, failures);
        check_tiers(swapped(p), sign_of_excess(p) < 0, failures);
    }
    Factors<T, D> touching{};
    for (int i = 0; i < D; ++i) touching.s1(i, i) = touching.s2(i, D - 1 - i) = T(2);
    touching.r12[0] = T(4);
    check_tiers(touching, false, failures);
}

/// Factors whose rounded forms would be decided otherwise: some hundred of them, by the fusing of
/// the processor.
PW85_TEST("/factored_overlap/rounded-forms")
{
    Random random(63);
    int differ = 0;
    for (int n = 0; n < 2000; ++n) {
        auto const p = placed(random_factors(random, 0, 1e6, 1.0),
                              random.sign() * random.log_uniform(1e-12, 1e-8));
        auto const q1 = pw85::detail::form_of_factor(p.s1), q2 = pw85::detail::form_of_factor(p.s2);
        differ += pw85::overlap(p.r12, q1, q2).overlap != (overlap_in_c(p) == 1);
    }
    g_assert_cmpint(differ, >, 100);
}

/// The digits that integers have memory for.
PW85_TEST("/factored_overlap/memory")
{
    Factors<double, 3> p{};
    p.r12[0] = 0x1p601;
    for (int i = 0; i < 3; ++i) p.s1(i, i) = p.s2(i, i) = 0x1p600;
    g_assert_cmpint(overlap_in_c(p), ==, 0);
    for (int const e : {-400, -890}) {
        p.s1(0, 1) = std::ldexp(1.0, e); // the half-width along r12 is longer by a tiny amount
        g_assert_cmpint(overlap_in_c(p), ==, 1);
        p.r12[1] = std::ldexp(1.0, e);
        g_assert_cmpint(overlap_in_c(p), ==, 1);
        p.r12[1] = 0.0;
    }
    p.s1(0, 1) = 0x1p-1074;
    g_assert_cmpint(overlap_in_c(p), ==, -PW85_ECONVERGENCE);
    p.r12[0] = std::nextafter(p.r12[0], 0.0);
    p.r12[0] *= 1.0 - 0x1p-40;
    g_assert_cmpint(overlap_in_c(p), ==, 1);
    p.r12[0] = 0x1p601 * (1.0 + 0x1p-40);
    g_assert_cmpint(overlap_in_c(p), ==, 0);
}

PW85_TEST("/factored_overlap/status")
{
    double const s[9] = {1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0}, r12[3] = {1.0, 2.0, 3.0},
                 zero[3] = {};
    double const far[3] = {1e300, 0.0, 0.0}, near[3] = {1e-300, 0.0, 0.0};
    auto const answer = [&](double const *r, double const *s1, double const *s2) {
        int overlap = 7;
        int const status = pw85_overlap_factored(r, s1, s2, &overlap);
        unsigned char code = 7;
        g_assert_cmpint(pw85_overlap_factored_batch(1, r, s1, s2, &code), ==, status);
        g_assert_cmpint(code, ==, status == PW85_SUCCESS ? overlap : 255);
        g_assert_true(status == PW85_SUCCESS ? overlap == 0 || overlap == 1 : overlap == -1);
        return status == PW85_SUCCESS ? overlap : -status;
    };
    g_assert_cmpint(answer(zero, s, s), ==, 1);
    g_assert_cmpint(answer(near, s, s), ==, 1);
    g_assert_cmpint(answer(far, s, s), ==, 0);
    double const parallel[9] = {1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0}, none[9] = {};
    for (double const *bad : {parallel, none}) {
        g_assert_cmpint(answer(r12, bad, s), ==, -PW85_ENOTPD);
        g_assert_cmpint(answer(far, s, bad), ==, -PW85_ENOTPD);
        g_assert_cmpint(answer(zero, s, bad), ==, -PW85_ENOTPD);
    }
}

PW85_ADD_TEST("/factored_overlap/scalars/float", test_scalar<float, 3>);
PW85_ADD_TEST("/factored_overlap/scalars/long-double", test_scalar<long double, 3>);
PW85_ADD_TEST("/factored_overlap/scalars/plane", test_scalar<double, 2>);

} // namespace
