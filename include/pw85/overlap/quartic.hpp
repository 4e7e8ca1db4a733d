/// @file
/// The first two tiers of the overlap test: the sign of a quartic. overlap.hpp calls it for one pair, lane_overlap.hpp for one pair
/// per lane.
///
/// With M = Q1 + t Q2, a = rᵀ adj(M) r and b = det M, the ellipsoids are apart if t a - (1 + t) b > 0 for some t > 0 (W. Wang, J.
/// Wang and M.-S. Kim, Comput. Aided Geom. Des. 18, 531, 2001), that is f > 1. They overlap if A < 1 and t²B < 1 for some t,
/// because x0 is then inside both. Both conditions are tested at a few t, with bounds on the rounding errors, so that each decision
/// is certain. The first t is about √(rᵀQ1r/rᵀQ2r). At this t, f > 1 if the projections of the ellipsoids on the line of centres
/// are apart, since rᵀM⁻¹r >= |r|⁴/rᵀMr. If the bounding spheres are apart, so are these projections. The search on the rational
/// form gives the next t.
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

/// The values that the test needs at t.
template <class T> struct QuarticEvaluation {
    T b;        ///< det M
    T a;        ///< b R, with R = rᵀM⁻¹r
    T form;     ///< b²B
    T diagonal; ///< P, the product of the diagonal of M
};

template <class T, int D>
PW85_FUNCTION constexpr QuarticEvaluation<T> evaluate_quartic(Pair<T, D> const &pair, T const &t) noexcept
{
    auto const m = blend(pair.q1, t, pair.q2);
    auto const solution = solve_by_adjugate(m, pair.r12);
    return {solution.determinant, dot(pair.r12, solution.s), quadratic_form(pair.q2, solution.s), solution.diagonal};
}

/// b²A, from A + tB = R.
template <class T> PW85_FUNCTION constexpr T first_form(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return e.a * e.b - t * e.form;
}

/// t² for the next t of the fixed-point map, which is x - h in log t.
template <class T> PW85_FUNCTION constexpr T fixed_point_square(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    return rough_quotient(first_form(e, t), e.form);
}

// The margins of the tests at one t > 0, for a pair with ratio 1 that passes_fast_checks(), in units of u. Each rounding error has a
// bound that holds for all pairs: in units in which M has a unit diagonal and det M = d, the eigenvalues of adj(M) are between d/3
// and 9/4. The margins are the theorems `apart` and `inside` of tests/bounds/proofs.cpp. Those of the tests inside contain a, which
// errs by up to 5.2 %, and 3u for products of two errors. To first order their errors are 31.6 and 46.6 at least
// (scripts/rounding_bounds.py).

inline constexpr int apart_margin = 20, inside1_margin = 45, inside2_margin = 62;

/// The smallest d, in units of u, at which the inside tests may decide. If det M is as small, the error of a is below 5 % (theorem
/// `separation` of tests/bounds/proofs.cpp). d errs by 17u at most, so that the error of a is below 5.2 %.
inline constexpr int least_conditioning = 512;

/// Shows that f > 1. If f <= 1, r is so short that the error of both sides together is below the margin times (1 + t) P.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask shows_apart(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    T const margin = T(apart_margin * unit_roundoff<T>());
    return t * e.a > T(T(1) + t) * T(e.b + margin * e.diagonal);
}

template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_well_conditioned(QuarticEvaluation<T> const &e) noexcept
{
    return e.b > T(least_conditioning * unit_roundoff<T>()) * e.diagonal;
}

/// Shows that A < 1, for a well-conditioned pair. If A = 1, the error of b²A is below the margin times a P. If A is larger, a is
/// larger too.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask shows_inside1(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    T const margin = T(inside1_margin * unit_roundoff<T>());
    return e.a * T(e.b + margin * e.diagonal) - t * e.form < T(e.b * e.b);
}

/// Shows that t²B < 1, in the same way: the error of b² t²B is below the margin times t a P.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask shows_inside2(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    T const margin = T(inside2_margin * unit_roundoff<T>());
    return t * T(t * e.form + T(margin * e.diagonal) * e.a) < T(e.b * e.b);
}

template <class T> PW85_FUNCTION constexpr Certainty<typename ScalarTraits<T>::Mask>
test_quartic(QuarticEvaluation<T> const &e, T const &t) noexcept
{
    auto const positive = t > T(0);
    return {positive && shows_apart(e, t),
            positive && is_well_conditioned(e) && shows_inside1(e, t) && shows_inside2(e, t)};
}

template <class Lanes, class T, int D>
PW85_FUNCTION constexpr Vector<Lanes, D> broadcast(Vector<T, D> const &x) noexcept
{
    Vector<Lanes, D> copies{};
    for (int i = 0; i < D; ++i) copies[i] = Lanes(x[i]);
    return copies;
}

template <class Lanes, class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<Lanes, D> broadcast(SymmetricMatrix<T, D> const &a) noexcept
{
    SymmetricMatrix<Lanes, D> copies{};
    for (int k = 0; k < a.size; ++k) copies[k] = Lanes(a[k]);
    return copies;
}

/// Tests several points about the first t at once, as many as there are lanes. Testing one point after another would be slower,
/// because the processor cannot predict whether the next test is needed. Four points decide 92 to 97 % of random pairs with aspect
/// ratios from 2 to 100; the first point alone decides 80 to 97 %. `t` becomes that of the fixed-point map from the first point.
template <class Lanes, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Decision decide_by_points(Vector<T, D> const &r12,
                                                                      SymmetricMatrix<T, D> const &q1,
                                                                      SymmetricMatrix<T, D> const &q2, T &t) noexcept
{
    using Lane = typename ScalarTraits<T>::Lane;
    Lane const points[4] = {Lane(1), Lane(0.5), Lane(2), Lane(0.25)};
    static_assert(ScalarTraits<Lanes>::lanes <= 4);
    auto const weights = outer_weights(r12);
    T const center = coarse_root_of_ratio(quadratic_form(q1, weights), quadratic_form(q2, weights));
    Lanes const probes = Lanes(center) * load_lanes<Lanes>(points);
    Pair<Lanes, D> const copies{broadcast<Lanes>(r12), broadcast<Lanes>(q1), broadcast<Lanes>(q2), Lanes(T(1))};
    auto const e = evaluate_quartic(copies, probes);
    auto const certainty = test_quartic(e, probes);
    t = rough_root(first_lane(fixed_point_square(e, probes)));
    return to_decision(any_of(certainty.apart), any_of(certainty.overlap));
}

/// A search on the rational form with a test at each of its points. It is a task (contact/rational_search.hpp) that ends when a
/// test decides.
template <class T> struct QuarticSearch {
    RationalSearch<T> rational;
    Decision decision;
    bool active;
};

template <class T, int D> PW85_FUNCTION inline void take_step(QuarticSearch<T> &search, Pair<T, D> const &pair) noexcept
{
    take_step(search.rational, pair);
    T const &t = search.rational.candidate.t;
    auto const certainty = test_quartic(evaluate_quartic(pair, t), t);
    search.decision = to_decision(certainty.apart, certainty.overlap);
    search.active = search.rational.active && search.decision == Decision::none;
}

/// Tests at the points of a search that starts at t.
template <class T, int D> PW85_FUNCTION inline Decision decide_by_search(Pair<T, D> const &pair, T const &t) noexcept
{
    QuarticSearch<T> search{start_search(pair, t), Decision::none, t == t};
    run(search, pair, max_rational_steps);
    return search.decision;
}

/// The same, not inlined, and with a Pair of its own. If the caller had a Pair in memory, the tests at the first points would wait
/// where the compiler loads two numbers at once that were stored one by one.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Decision decide_by_search(Vector<T, D> const &r12,
                                                                 SymmetricMatrix<T, D> const &q1,
                                                                 SymmetricMatrix<T, D> const &q2, T const &t) noexcept
{
    return decide_by_search(pair_of(r12, q1, q2), t);
}

} // namespace pw85::detail

#endif
