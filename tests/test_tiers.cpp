// SPDX-License-Identifier: BSD-3-Clause
// Tests of each tier of the overlap test alone: its decisions are right, and its margins are not
// much larger than necessary. The recorded pairs come from a search that maximised the rounding
// errors: they fail with margins a third to a half as large.
#include <algorithm>
#include <type_traits>

#include <glib.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

/// A pair and where it is tested. Single precision is rounded like any other, and an oracle in
/// double precision is exact to it.
struct Recorded {
    Sample<float, 3> pair;
    float t;
};

constexpr Recorded apart_pair = {
    {{-0x1.2845b6p-3f, 0x1.a3bcfcp-3f, -0x1.157ba6p-2f},
     {0x1.5fff2p-6f, 0x1.81b4ep-4f, 0x1.313aap-5f, 0x1.1e31fcp+1f, 0x1.0b5e1p-1f, 0x1.1b1b6ep-3f},
     {0x1.1e6caap-4f, 0x1.688bc2p-4f, -0x1.22ea18p-3f, 0x1.056ap+1f, -0x1.4881d2p-4f,
      0x1.2e21dap-2f}},
    0x1.d5ebacp+2f};
constexpr Recorded inside1_pair = {{{-0x1.d5d51cp-5f, 0x1.33b868p-1f, -0x1.11beap-2f},
                                    {0x1.f6fc62p-9f, -0x1.f84fc6p-6f, 0x1.0e515ep-6f,
                                     0x1.009faep-2f, -0x1.130486p-3f, 0x1.26c23p-4f},
                                    {0x1.49c75p-5f, -0x1.fc653ep-7f, 0x1.ed9ef2p-4f, 0x1.915448p+0f,
                                     -0x1.3cd7c4p-5f, 0x1.71ac76p-2f}},
                                   0x1.0cfa0cp+2f};
constexpr Recorded inside2_pair = {{{0x1.de7fe2p-8f, 0x1.e368a2p+0f, 0x1.423522p-4f},
                                    {0x1.10ca92p-7f, 0x1.23946ep-3f, 0x1.077342p-8f, 0x1.382c8cp+1f,
                                     0x1.1ada42p-4f, 0x1.02a682p-9f},
                                    {0x1.0e1dfep+0f, -0x1.90445p-4f, -0x1.56aa6cp+0f,
                                     0x1.20a296p+0f, 0x1.06b40cp-3f, 0x1.b2ba56p+0f}},
                                   0x1.d05618p-3f};
constexpr Recorded separation_pair = {{{-0x1.af08eap-2f, 0x1.992a0cp-3f, 0x1.9313f6p+1f},
                                       {0x1.13adc8p-4f, -0x1.0193b6p-5f, -0x1.008deep-1f,
                                        0x1.eeee4cp-7f, 0x1.de7a1p-3f, 0x1.ddc2ecp+1f},
                                       {0x1.c929cep-6f, -0x1.b20838p-7f, -0x1.ac3974p-3f,
                                        0x1.a5331p-8f, 0x1.963bccp-4f, 0x1.913e72p+0f}},
                                      0x1.3293c2p+2f};
constexpr Recorded adjugate_pair = {{{0x1.f60154p-3f, 0x1.7561ecp-1f, -0x1.3d65ccp-1f},
                                     {0x1.a6c21ep-1f, 0x1.e6c246p-2f, -0x1.dbb6dp-3f, 0x1.18fa2p-2f,
                                      -0x1.154438p-3f, 0x1.1b1ddap-4f},
                                     {0x1.6d5382p-5f, -0x1.3329f4p-2f, 0x1.5419f8p-2f,
                                      0x1.4742dap+1f, -0x1.78ff42p+1f, 0x1.ba73a4p+1f}},
                                    0x1.7a34ep-2f};
constexpr Recorded factorization_pair = {{{0x1.90bbf4p-2f, 0x1.534e9p-1f, 0x1.3e632ap-1f},
                                          {0x1.71a79ap+1f, -0x1.bf9d8ap-4f, -0x1.7cde8cp-3f,
                                           0x1.7b0302p-7f, 0x1.6f8bp-8f, 0x1.9321cp-7f},
                                          {0x1.083528p-4f, -0x1.b38018p-3f, -0x1.ed1fe6p-4f,
                                           0x1.81c19ap-1f, 0x1.a3ee5p-2f, 0x1.ff8286p-3f}},
                                         0x1.5ad25ap+1f};
constexpr Recorded value_pair = {{{-0x1.c0a27p+0f, -0x1.971416p-2f, 0x1.75f39ap-2f},
                                  {0x1.eddd82p-1f, -0x1.63e44ep-4f, 0x1.8d3d26p-3f, 0x1.2658ep-1f,
                                   0x1.94f65p-8f, 0x1.2147eep-1f},
                                  {0x1.957e0cp-1f, 0x1.d6a406p-4f, -0x1.d70cdep-5f, 0x1.024d9cp+0f,
                                   0x1.7a422cp-4f, 0x1.24c696p+0f}},
                                 0x1.d73438p-1f};

template <class T, int D> pw85::detail::Pair<T, D> to_pair(Sample<T, D> const &s)
{
    return {s.r12, s.q1, s.q2, T(1)};
}

template <class T, int D> pw85::detail::QuarticCoefficients<T> coefficients(Sample<T, D> const &s)
{
    using namespace pw85::detail;
    auto const q = side_by_side(s.q1, s.q2), other = side_by_side(s.q2, s.q1);
    return {rational_form(q, other, adjugate(q), outer_weights(converted<TwoLanes<T>>(s.r12))),
            diagonal_coefficients(q, other)};
}

template <class T, int D> Wide true_mu2(Sample<T, D> const &s)
{
    auto const w = convert<Wide>(s);
    return pw85::contact(w.r12, w.q1, w.q2).mu2;
}

/// A and t²B exactly, and M⁻¹r.
struct Exact {
    Wide square1, square2;
    pw85::Vector<Wide, 3> s;
    pw85::SymmetricMatrix<Wide, 3> m;
    Sample<Wide, 3> pair;
};

Exact exact(Recorded const &p)
{
    auto const w = convert<Wide>(p.pair);
    auto const m = pw85::detail::blend(w.q1, Wide(p.t), w.q2);
    auto const s = pw85::detail::solve(pw85::detail::factorize(m, Wide(0)), w.r12);
    return {pw85::detail::quadratic_form(w.q1, s),
            Wide(p.t) * p.t * pw85::detail::quadratic_form(w.q2, s), s, m, w};
}

pw85::detail::QuarticEvaluation<float> evaluate(Recorded const &p)
{
    return pw85::detail::evaluate_quartic(to_pair(p.pair), p.t);
}

PW85_TEST("/tiers/margins/apart")
{
    g_assert_true(true_mu2(apart_pair.pair) < 1);
    g_assert_false(pw85::detail::test_quartic(evaluate(apart_pair), apart_pair.t).apart);
}

PW85_TEST("/tiers/margins/inside")
{
    g_assert_true(exact(inside1_pair).square1 >= 1 &&
                  pw85::detail::is_well_conditioned(evaluate(inside1_pair)));
    g_assert_false(pw85::detail::shows_inside1(evaluate(inside1_pair), inside1_pair.t));
    g_assert_true(exact(inside2_pair).square2 >= 1 &&
                  pw85::detail::is_well_conditioned(evaluate(inside2_pair)));
    g_assert_false(pw85::detail::shows_inside2(evaluate(inside2_pair), inside2_pair.t));
}

// Here a errs by 10 %, more than the margins allow for.
PW85_TEST("/tiers/margins/conditioning")
{
    auto const e = evaluate(separation_pair);
    auto const x = exact(separation_pair);
    Wide const a = pw85::dot(x.pair.r12, pw85::product(pw85::detail::adjugate(x.m), x.pair.r12));
    g_assert_true(pw85::detail::absolute(Wide(e.a - a)) > a / 16);
    g_assert_false(pw85::detail::is_well_conditioned(e));
    auto near = separation_pair;
    near.pair.r12 = 0x1p-20f * near.pair.r12;
    auto const inside = evaluate(near);
    g_assert_true(pw85::detail::shows_inside1(inside, near.t) &&
                  pw85::detail::shows_inside2(inside, near.t));
    g_assert_false(pw85::detail::test_quartic(inside, near.t).overlap);
    auto const from_coefficients = pw85::detail::evaluate_quartic(coefficients(near.pair), near.t);
    int const margin = pw85::detail::coefficients_inside_margin;
    g_assert_true(pw85::detail::shows_inside1(from_coefficients, near.t, margin) &&
                  pw85::detail::shows_inside2(from_coefficients, near.t, margin));
    g_assert_false(pw85::detail::test_by_coefficients(from_coefficients, near.t).overlap);
}

// At a negative t, M may be indefinite, and t a - (1 + t) b positive for ellipsoids that overlap.
PW85_TEST("/tiers/margins/negative_t")
{
    Sample<double, 3> const s{
        {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 0.01, 0.0, 0.01}};
    g_assert_true(true_mu2(s) < 1);
    auto const e = pw85::detail::evaluate_quartic(to_pair(s), -3.0);
    g_assert_true(pw85::detail::shows_apart(e, -3.0));
    auto const certainty = pw85::detail::test_quartic(e, -3.0);
    g_assert_false(certainty.apart || certainty.overlap);
}

/// What an inexact s errs by across the exact one, in the norm of M, relative to it.
double error_across(Exact const &x, pw85::Vector<float, 3> const &computed)
{
    auto const s = convert<Wide>(computed);
    Wide const square = pw85::dot(x.pair.r12, x.s), along = pw85::dot(x.pair.r12, s) / square;
    pw85::Vector<Wide, 3> error{};
    for (int i = 0; i < 3; ++i) error[i] = s[i] / along - x.s[i];
    return static_cast<double>(sqrt(Wide(pw85::detail::quadratic_form(x.m, error) / square)));
}

PW85_TEST("/tiers/margins/solutions")
{
    double const u = pw85::detail::unit_roundoff<float>();
    auto const &a = adjugate_pair, &f = factorization_pair;
    auto const solution =
        pw85::detail::solve_by_adjugate(pw85::detail::blend(a.pair.q1, a.t, a.pair.q2), a.pair.r12);
    double const by_adjugate = error_across(exact(a), solution.s) * double(solution.determinant) /
                               (u * double(solution.diagonal));
    g_test_message("adjugate: %.2f", by_adjugate);
    g_assert_cmpfloat(by_adjugate, <=, pw85::detail::adjugate_error);
    auto const m = pw85::detail::blend(f.pair.q1, f.t, f.pair.q2);
    auto const factors = pw85::detail::factorize(m, static_cast<float>(u));
    double const by_factors = error_across(exact(f), pw85::detail::solve(factors, f.pair.r12)) /
                              (u * double(pw85::detail::inverse_eigenvalue_bound(factors, m)));
    g_test_message("factorisation: %.2f", by_factors);
    g_assert_cmpfloat(by_factors, <=, pw85::detail::factorization_error);
}

PW85_TEST("/tiers/margins/value")
{
    g_assert_true(true_mu2(value_pair.pair) < 1);
    auto const pair = to_pair(value_pair.pair);
    g_assert_true(pw85::detail::maximize(pair).mu2 > 1.0f);
    g_assert_true(pw85::detail::decide_by_certified_value(pair, 1.0f) == pw85::Decision::none);
}

// A form of positive determinant that is indefinite, and definite forms for which rounded pivots
// are not positive.
PW85_TEST("/tiers/margins/definiteness")
{
    g_assert_false(pw85::detail::is_clearly_definite(
        pw85::SymmetricMatrix<double, 3>{1.0, 2.0, 2.0, 1.0, 2.0, 1.0}));
    pw85::SymmetricMatrix<float, 3> const a{0x1.4bcc46p+1f, 0x1.62e6c8p-3f,  0x1.7e55a2p-4f,
                                            0x1.c53c24p+1f, -0x1.0999cap+0f, 0x1.3f85a6p-2f};
    g_assert_true(pw85::detail::is_positive_definite(a) &&
                  pw85::detail::factorize(a, 0.0f).pivots[2] <= 0.0f);
    g_assert_false(pw85::detail::is_clearly_definite(a));
    pw85::SymmetricMatrix<float, 2> const b{0x1.fa132cp+1f, -0x1.07b37ap+1f, 0x1.12d06ep+0f};
    g_assert_true(pw85::detail::is_positive_definite(b) &&
                  pw85::detail::factorize(b, 0.0f).pivots[1] <= 0.0f);
    g_assert_false(pw85::detail::is_clearly_definite(b));
}

/// Random or crossed pairs, of any sizes, with |μ² - 1| from 1e-12 to 0.5.
template <int D> Sample<double, D> near_contact(Random &random, int n, double largest_aspect)
{
    double const aspect = random.log_uniform(n % 3 == 0 ? 1e3 : 1.0, largest_aspect);
    auto s = n % 3 == 0
                 ? crossed_pair<D>(random, aspect)
                 : random_pair<D>(random, {.aspect = aspect, .size_ratio = n % 3 == 1 ? 2.0 : 1e3});
    double const distance =
        std::copysign(random.log_uniform(1e-12, 0.5), random.uniform(-1.0, 1.0));
    double const mu2 = pw85::contact(s.r12, s.q1, s.q2).mu2;
    s.r12 = std::sqrt((1.0 + distance) / mu2) * s.r12;
    return s;
}

/// What a tier has said so far, and of how many.
struct Tally {
    char const *name;
    Failures failures;
    int decided = 0, asked = 0;

    template <class T, int D>
    void count(pw85::Decision decision, bool overlap, Sample<T, D> const &s)
    {
        ++asked;
        if (decision == pw85::Decision::none) return;
        ++decided;
        failures.check((decision == pw85::Decision::overlap) == overlap, name,
                       decision == pw85::Decision::overlap, overlap, [&] { return hex_text(s); });
    }

    ~Tally()
    {
        g_test_message("%s: %d of %d decided", name, decided, asked);
        g_assert_cmpint(10 * decided, >, asked);
    }
};

template <class T, int D> void test_alone()
{
    Random random(110 + D);
    Tally points{"decide_by_points", {}}, search{"search_for_decision", {}},
        comparison{"decide_by_certified_value", {}};
    for (int n = 0; n < draws(3000); ++n) {
        auto const s =
            convert<T>(near_contact<D>(random, n, std::is_same_v<T, float> ? 1.1e3 : 1e6));
        pw85::detail::ScaledPair<T, D> scaled;
        if (pw85::detail::validate_pair(pw85::detail::pair_of(s.r12, s.q1, s.q2), scaled) !=
            pw85::Status::success)
            continue;
        bool const overlap = true_mu2(s) < 1;
        T const tangent = scaled.units.mu().to_local(T(1), 2);
        comparison.count(pw85::detail::decide_by_certified_value(scaled.pair, tangent), overlap, s);
        if (!pw85::detail::passes_fast_checks(s.r12, s.q1, s.q2)) continue;
        T const guess = pw85::detail::initial_guess(to_pair(s));
        auto const quartic = coefficients(s);
        points.count(pw85::detail::decide_by_points(quartic, guess), overlap, s);
        search.count(pw85::detail::search_for_decision(to_pair(s), quartic, guess), overlap, s);
    }
}

PW85_ADD_TEST("/tiers/alone/float/2", test_alone<float, 2>);
PW85_ADD_TEST("/tiers/alone/float/3", test_alone<float, 3>);
PW85_ADD_TEST("/tiers/alone/double/2", test_alone<double, 2>);
PW85_ADD_TEST("/tiers/alone/double/3", test_alone<double, 3>);
PW85_ADD_TEST("/tiers/alone/long_double/2", test_alone<long double, 2>);
PW85_ADD_TEST("/tiers/alone/long_double/3", test_alone<long double, 3>);

} // namespace
