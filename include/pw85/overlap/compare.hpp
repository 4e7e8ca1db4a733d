// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sign of μ² - m for any number m. pw85.hpp and the C API use this file. Its tiers are those
/// of the overlap test (overlap.hpp), for the ellipsoids of m Q1 and m Q2:
///
/// 1. compare_by_quartic(): the sign of the quartic at the points of a search;
/// 2. compare_by_search(): μ² by the solver, with a bound on its error (certified_value.hpp);
/// 3. compare_last(): integers (exact.hpp).
#ifndef PW85_OVERLAP_COMPARE_HPP_INCLUDED
#define PW85_OVERLAP_COMPARE_HPP_INCLUDED

#include <pw85/overlap/certified_value.hpp>
#include <pw85/overlap/exact.hpp>
#include <pw85/overlap/quartic.hpp>

namespace pw85 {

/// The sign of μ² - m. It is 2 if the status is not success.
struct Comparison {
    int sign;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Converts a decision about the ellipsoids of m Q1 and m Q2 to the sign of μ² - m.
PW85_FUNCTION constexpr int to_sign(Decision decision) noexcept
{
    return decision == Decision::apart ? 1 : decision == Decision::overlap ? -1 : 0;
}

/// The values of the quartic for r12/√m in place of r12: f and A and B are divided by m. The
/// quotients have a rounding error each. In the units of the margins of quartic.hpp, both move the
/// sides of shows_apart() by 1, of shows_inside1() by 2 and of shows_inside2() by 1 at most,
/// because t b²B <= a b and b <= P. The larger P adds a sixteenth to each margin.
template <class T> PW85_FUNCTION constexpr QuarticEvaluation<T>
relative_to(QuarticEvaluation<T> const &e, T const &m) noexcept
{
    static_assert(apart_margin >= 16 && inside1_margin > 32 && inside2_margin >= 16);
    return {e.b, e.a / m, e.form / m, T(T(1.0625) * e.diagonal)};
}

/// A search on the rational form that ends when the quartic decides. It is a task
/// (contact/iteration.hpp).
template <class T> struct ComparisonSearch {
    RationalSearch<T> rational;
    T m;
    Decision decision;
    bool active;
};

template <class T, int D>
PW85_FUNCTION inline Decision compare_at(Pair<T, D> const &pair, T const &t, T const &m) noexcept
{
    auto const certainty = test_quartic(relative_to(evaluate_quartic(pair, t), m), t);
    return to_decision(certainty.apart, certainty.overlap);
}

template <class T, int D>
PW85_FUNCTION inline void take_step(ComparisonSearch<T> &search, Pair<T, D> const &pair) noexcept
{
    take_step(search.rational, pair);
    search.decision = compare_at(pair, search.rational.candidate.t, search.m);
    search.active = search.rational.active && search.decision == Decision::none;
}

/// The first tier. The result is `none` for pairs that fail the fast checks, for m beyond 2^±30,
/// and for μ² too near to m.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Decision
compare_by_quartic(Pair<T, D> const &pair, T const &m) noexcept
{
    T const least = negative_power_of_two<T>(30);
    if (!(m >= least && m * least <= T(1)) || !passes_fast_checks(pair)) return Decision::none;
    T const t = initial_guess(pair);
    Decision const first = compare_at(pair, t, m);
    if (first != Decision::none) return first;
    ComparisonSearch<T> search{start_search(pair, t), m, Decision::none, t == t};
    run(search, pair, max_rational_steps);
    return search.decision;
}

/// The last tier, for a valid pair and 0 < m < infinity. For multiprecision numbers the comparison
/// is up to rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline int
compare_last(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
             SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    if constexpr (exact::is_decidable<T>) {
        return compare_exactly(r12, q1, q2, m);
    } else {
        T const mu2 = contact(r12, q1, q2).mu2;
        return to_sign(to_decision(mu2 > m, mu2 < m));
    }
}

/// Decides by the search for the maximum, for a valid pair and m > 0. In the units of the pair μ²
/// is at least 2^-52, so the result is also correct if the scaled m underflows. A scaled m that
/// overflows becomes infinity, and μ² is below infinity.
template <class T, int D>
PW85_FUNCTION inline Decision compare_by_search(ScaledPair<T, D> const &scaled, T const &m) noexcept
{
    return decide_by_certified_value(scaled.pair, scaled.units.mu().to_local(m, 2));
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Comparison compare(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    using namespace detail;
    Decision const first = compare_by_quartic(pair_of(r12, q1, q2), m);
    if (first != Decision::none) return {to_sign(first), StatusCode::success};
    ScaledPair<T, D> scaled;
    StatusCode const status =
        m >= T(0) ? validate_pair(pair_of(r12, q1, q2), scaled) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return {2, status};
    bool const concentric = largest_coordinate(r12) == T(0), positive = m > T(0);
    if (concentric || !positive) return {(concentric ? 0 : 1) - (positive ? 1 : 0), status};
    if (m > largest_number<T>()) return {-1, status};
    Decision const decision = compare_by_search(scaled, m);
    return {decision != Decision::none ? to_sign(decision) : compare_last(r12, q1, q2, m), status};
}

} // namespace pw85

#endif
