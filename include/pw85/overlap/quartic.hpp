// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The first two tiers of the overlap test: the sign of a quartic. overlap.hpp calls it for one
/// pair, lanes/overlap.hpp for one pair per lane.
///
/// With M = Q1 + t Q2, a = rᵀ adj(M) r and b = det M, the ellipsoids are apart if t a - (1 + t) b >
/// 0 for some t > 0 (W. Wang, J. Wang and M.-S. Kim, Comput. Aided Geom. Des. 18, 531, 2001), that
/// is f > 1. They overlap if A < 1 and t²B < 1 for some t, because x0 is then inside both. Both
/// conditions are tested at a few t, with bounds on the rounding errors: each decision is certain.
/// The first t is about √(rᵀQ1r/rᵀQ2r). At this t, f > 1 if the projections of the ellipsoids on
/// the line of centres are apart, since rᵀM⁻¹r >= |r|⁴/rᵀMr. If the bounding spheres are apart, so
/// are these projections. The search on the rational form gives the next t.
///
/// There are two ways to evaluate a and b. One pair has the coefficients of their powers of t
/// (contact/rational.hpp); each t then costs a few products. The adjugate of M at t has smaller
/// rounding errors. It serves packs of lanes, and one pair at the last t.
#ifndef PW85_OVERLAP_QUARTIC_HPP_INCLUDED
#define PW85_OVERLAP_QUARTIC_HPP_INCLUDED

#include <pw85/contact/contact.hpp>
#include <pw85/overlap/decision.hpp>

namespace pw85::detail {

/// The decision of a test in each lane.
template <class Mask> struct Certainty {
    Mask apart;
    Mask overlap;
};

/// The decisions of packs; decision.hpp has that of one pair.
template <class Mask>
PW85_FUNCTION constexpr Certainty<Mask> to_decision(Mask const &apart, Mask const &overlap) noexcept
{
    return {apart, overlap};
}

/// The decision of one pair, or those of a pack.
template <class T> using DecisionOf =
    decltype(to_decision(typename ScalarTraits<T>::Mask(), typename ScalarTraits<T>::Mask()));

/// The values that the test needs at t.
template <class T> struct QuarticEvaluation {
    T b;        ///< det M
    T a;        ///< b R, with R = rᵀM⁻¹r
    T form;     ///< b²B, which is ab' - a'b
    T diagonal; ///< P, the product of the diagonal of M
};

template <class T, int D> PW85_FUNCTION constexpr QuarticEvaluation<T>
evaluate_quartic(Pair<T, D> const &pair, T const &t) noexcept
{
    auto const m = blend(pair.q1, t, pair.q2);
    auto const solution = solve_by_adjugate(m, pair.r12);
    return {solution.determinant, dot(pair.r12, solution.s), quadratic_form(pair.q2, solution.s),
            solution.diagonal};
}

/// b²A, from A + tB = R.
template <class T>
PW85_FUNCTION constexpr T first_form(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return e.a * e.b - t * e.form;
}

/// t² for the next t of the fixed-point map, which is x - h in log t.
template <class T>
PW85_FUNCTION constexpr T fixed_point_square(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return rough_quotient(first_form(e, t), e.form);
}

// The margins of the tests at one t > 0, for a pair with ratio 1 that passes_fast_checks(), in
// units of u. Each rounding error has a bound that holds for all pairs: in units in which M has a
// unit diagonal and det M = d, the eigenvalues of adj(M) are between d/3 and 9/4. The margins are
// the theorems `apart` and `inside` of tests/bounds/proofs.cpp. Those of the tests inside contain
// a, which errs by up to 5.2 %, and 3u for products of two errors. To first order their errors are
// 31.6 and 46.6 at least (scripts/rounding_bounds.py).

inline constexpr int apart_margin = 20, inside1_margin = 45, inside2_margin = 62;

/// The smallest d, in units of u, at which the inside tests may decide. If det M is as small, the
/// error of a is below 5 % (theorem `separation` of tests/bounds/proofs.cpp). d errs by 17u at
/// most, so the error of a is below 5.2 %.
inline constexpr int least_conditioning = 512;

/// A number of unit roundoffs.
template <class T> PW85_FUNCTION constexpr T roundoffs(int units) noexcept
{
    return T(static_cast<typename ScalarTraits<T>::Lane>(units) * unit_roundoff<T>());
}

/// Shows that f > 1. If f <= 1, r is so short that the error of both sides together is below the
/// margin times (1 + t) P.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
shows_apart(QuarticEvaluation<T> const &e, T const &t, int units = apart_margin) noexcept
{
    T const margin = roundoffs<T>(units);
    return t * e.a > T(T(1) + t) * T(e.b + margin * e.diagonal);
}

template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_well_conditioned(QuarticEvaluation<T> const &e, int units = least_conditioning) noexcept
{
    return e.b > roundoffs<T>(units) * e.diagonal;
}

/// Shows that A < 1, for a well-conditioned pair. If A = 1, the error of b²A is below the margin
/// times a P. If A is larger, a is larger too.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
shows_inside1(QuarticEvaluation<T> const &e, T const &t, int units = inside1_margin) noexcept
{
    T const margin = roundoffs<T>(units);
    return e.a * T(e.b + margin * e.diagonal) - t * e.form < T(e.b * e.b);
}

/// Shows that t²B < 1, in the same way: the error of b² t²B is below the margin times t a P.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
shows_inside2(QuarticEvaluation<T> const &e, T const &t, int units = inside2_margin) noexcept
{
    T const margin = roundoffs<T>(units);
    return t * T(t * e.form + T(margin * e.diagonal) * e.a) < T(e.b * e.b);
}

template <class T> PW85_FUNCTION constexpr Certainty<typename ScalarTraits<T>::Mask>
test_quartic(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    auto const positive = t > T(0);
    return {positive && shows_apart(e, t),
            positive && is_well_conditioned(e) && shows_inside1(e, t) && shows_inside2(e, t)};
}

/// The coefficients of P, in increasing powers of t.
template <class T> struct DiagonalCoefficients {
    T c[4];
};

/// The coefficients of a, b and P. In two dimensions the last one of each is zero.
template <class T> struct QuarticCoefficients {
    RationalForm<T> form;
    DiagonalCoefficients<T> diagonal;
};

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr DiagonalCoefficients<T>
diagonal_coefficients(SymmetricMatrix<TwoLanes<T>, 2> const &q,
                      SymmetricMatrix<TwoLanes<T>, 2> const &other) noexcept
{
    auto const p = diagonal_product(q), mixed = q[0] * other[2];
    return {{first_of(p), first_of(mixed) + second_of(mixed), second_of(p), T(0)}};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr DiagonalCoefficients<T>
diagonal_coefficients(SymmetricMatrix<TwoLanes<T>, 3> const &q,
                      SymmetricMatrix<TwoLanes<T>, 3> const &other) noexcept
{
    auto const p = diagonal_product(q),
               mixed = q[0] * q[3] * other[5] + q[5] * (q[0] * other[3] + other[0] * q[3]);
    return {{first_of(p), first_of(mixed), second_of(mixed), second_of(p)}};
}

/// The values at t from the coefficients. `T` is `Number`, or has several lanes of it.
template <class T, class Number> [[gnu::always_inline]] PW85_FUNCTION constexpr QuarticEvaluation<T>
evaluate_quartic(QuarticCoefficients<Number> const &quartic, T const &t) noexcept
{
    auto const &form = quartic.form;
    auto const &p = quartic.diagonal.c;
    T const a2 = T(form.a[2]) * t, b2 = T(form.b[2]), b3 = T(form.b[3]) * t, square = t * t;
    T const a = (a2 + T(form.a[1])) * t + T(form.a[0]),
            b = (T(form.b[1]) * t + T(form.b[0])) + square * (b3 + b2);
    T const a_slope = T(2) * a2 + T(form.a[1]),
            b_slope = (T(3) * b3 + T(2) * b2) * t + T(form.b[1]);
    T const diagonal = (T(p[1]) * t + T(p[0])) + square * (T(p[3]) * t + T(p[2]));
    return {b, a, a * b_slope - a_slope * b, diagonal};
}

// The margins of the same tests from the coefficients (theorem `coefficients` of
// tests/bounds/proofs.cpp).

inline constexpr int coefficients_apart_margin = 264, coefficients_inside_margin = 1704,
                     coefficients_least_conditioning = 6666;

template <class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr Certainty<typename ScalarTraits<T>::Mask>
test_by_coefficients(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    auto const positive = t > T(0),
               well_conditioned = is_well_conditioned(e, coefficients_least_conditioning);
    auto const inside1 = shows_inside1(e, t, coefficients_inside_margin);
    auto const inside2 = shows_inside2(e, t, coefficients_inside_margin);
    return {both_true(positive, shows_apart(e, t, coefficients_apart_margin)),
            both_true(both_true(positive, well_conditioned), both_true(inside1, inside2))};
}

/// The second point over the first one. At aspect ratio 10 both decide 91 % of random pairs, and
/// the first one alone 86 %.
inline constexpr int second_point = 2;

/// Tests two points at once, which takes little more time than a test of one.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline DecisionOf<T>
decide_by_points(QuarticCoefficients<T> const &quartic, T const &t) noexcept
{
    TwoLanes<T> const points(t, T(T(second_point) * t));
    auto const certainty = test_by_coefficients(evaluate_quartic(quartic, points), points);
    return to_decision(either_of(certainty.apart), either_of(certainty.overlap));
}

/// A search on the rational form with a test at each of its points. It is a task
/// (contact/iteration.hpp) that ends when a test decides.
template <class T> struct QuarticSearch {
    RationalSearch<T, FormOfSteps<T>> rational;
    QuarticCoefficients<T> quartic;
    Decision decision;
    bool active;
};

template <class T, int D>
PW85_FUNCTION inline void take_step(QuarticSearch<T> &search, Pair<T, D> const &pair) noexcept
{
    take_step(search.rational, pair);
    T const &t = search.rational.candidate.t;
    auto const certainty = test_by_coefficients(evaluate_quartic(search.quartic, t), t);
    search.decision = to_decision(certainty.apart, certainty.overlap);
    search.active = search.rational.active && search.decision == Decision::none;
}

/// Tests at the points of a search that starts at t. The last test is by the adjugate.
template <class T, int D>
PW85_FUNCTION inline Decision search_for_decision(Pair<T, D> const &pair,
                                                  QuarticCoefficients<T> const &quartic,
                                                  T const &t) noexcept
{
    QuarticSearch<T> search{
        {form_of_steps(quartic.form), {t, T(0), T(0)}, t == t}, quartic, Decision::none, t == t};
    run(search, pair, max_rational_steps);
    if (search.decision != Decision::none) return search.decision;
    T const &last = search.rational.candidate.t;
    auto const certainty = test_quartic(evaluate_quartic(pair, last), last);
    return to_decision(certainty.apart, certainty.overlap);
}

/// Calls the search in a function that is not inlined, with its own copy of the Pair. If the caller
/// had a Pair in memory, the tests at the first points would wait where the compiler loads two
/// numbers at once that were stored one by one.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Decision
call_search_for_decision(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                         SymmetricMatrix<T, D> const &q2, QuarticCoefficients<T> const &quartic,
                         T const &t) noexcept
{
    return search_for_decision(pair_of(r12, q1, q2), quartic, t);
}

/// Tier 1, with what the next tier starts from.
template <class T> struct QuarticStart {
    QuarticCoefficients<T> quartic;
    T t;                                   ///< the first point
    DecisionOf<T> decision;                ///< of decide_by_points(), for a pair that passes
    typename ScalarTraits<T>::Mask passes; ///< the result of passes_fast_checks()
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline QuarticStart<T>
start_by_quartic(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2) noexcept
{
    // t comes first, because the points wait for it, and not for the coefficients.
    auto const q = side_by_side(q1, q2);
    auto const weights = outer_weights(converted<TwoLanes<T>>(r12));
    T const t = coarse_root_of_ratio(quadratic_form(q, weights));
    auto const other = side_by_side(q2, q1), adj = adjugate(q);
    QuarticCoefficients<T> const quartic{rational_form(q, other, adj, weights),
                                         diagonal_coefficients(q, other)};
    auto const decision = decide_by_points(quartic, t);
    return {quartic, t, decision, passes_fast_checks(r12, q, adj)};
}

/// Tiers 1 and 2. The result is `none` for pairs that fail the fast checks, are ill-conditioned, or
/// are tangent up to rounding.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Decision
decide_by_quartic(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                  SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const start = start_by_quartic(r12, q1, q2);
    if (start.passes && start.decision != Decision::none) return start.decision;
    if (!start.passes) return Decision::none;
    if constexpr (is_for_device) { // a call would need local memory
        return search_for_decision(pair_of(r12, q1, q2), start.quartic, start.t);
    } else {
        auto const copy = start.quartic; // its address would keep the original in memory
        return call_search_for_decision(r12, q1, q2, copy, start.t);
    }
}

} // namespace pw85::detail

#endif
