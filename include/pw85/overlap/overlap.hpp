// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The overlap test. It consists of four methods, called tiers. Each tier either decides with
/// certainty or not at all. Each tier is slower than the one before, and is used only for pairs
/// that the tiers before it do not decide:
///
/// 1. decide_by_points(): the sign of a quartic at two points, with bounds on the rounding errors
///    (quartic.hpp);
/// 2. search_for_decision(): the sign of the same quartic at the points of a search (quartic.hpp);
/// 3. decide_by_certified_value(): μ² by the solver, with a bound on its error
///    (certified_value.hpp);
/// 4. decide_exactly(): integers (exact.hpp).
///
/// Devices run the first three tiers. src/simd/lanes/overlap.hpp runs the first two for one pair
/// per lane.
#ifndef PW85_OVERLAP_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_OVERLAP_HPP_INCLUDED

#include <pw85/overlap/certified_value.hpp>
#include <pw85/overlap/exact.hpp>
#include <pw85/overlap/quartic.hpp>

namespace pw85 {

/// The tier that decided a pair. `quartic` stands for tiers 1 and 2. It is `unknown` where the
/// compiled library decided (pw85/linked.hpp).
enum class OverlapTier { quartic, contact, exact, unknown };

/// The decision about a pair, and the tier that made it. The decision is `none` in two cases: the
/// status is not success, or the pair is so near to contact (|μ² - 1| is at most a few u cond) that
/// floating-point arithmetic cannot decide.
struct OverlapDecision {
    Decision decision;
    OverlapTier tier;
    StatusCode status;
};

/// True if two ellipsoids overlap. It is false if the status is not success.
struct Overlap {
    bool overlap;
    OverlapTier tier;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Tier 3, for any pair.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline OverlapDecision decide_near_contact(Pair<T, D> pair) noexcept
{
    ScaledPair<T, D> scaled;
    StatusCode const status = validate_pair(pair, scaled);
    if (status != StatusCode::success) return {Decision::none, OverlapTier::contact, status};
    if (largest_coordinate(pair.r12) == T(0))
        return {Decision::overlap, OverlapTier::contact, StatusCode::success};
    T const tangent = scaled.units.mu().to_local(T(1), 2);
    return {decide_by_certified_value(scaled.pair, tangent), OverlapTier::contact,
            StatusCode::success};
}

/// Tier 4, for a valid pair. For multiprecision numbers it compares μ² with 1, up to rounding.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Overlap overlap_exactly(Pair<T, D> pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    if constexpr (exact::is_decidable<T>)
        return {decide_exactly(r12, q1, q2) == Decision::overlap, OverlapTier::exact,
                StatusCode::success};
    else
        return {contact(r12, q1, q2).mu2 < T(1), OverlapTier::contact, StatusCode::success};
}

/// Tiers 3 and 4.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Overlap overlap_near_contact(Pair<T, D> pair) noexcept
{
    auto const [decision, tier, status] = decide_near_contact(pair);
    if (decision == Decision::none && status == StatusCode::success) return overlap_exactly(pair);
    return {decision == Decision::overlap, tier, status};
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline OverlapDecision decide_overlap(Vector<T, D> const &r12,
                                                    SymmetricMatrix<T, D> const &q1,
                                                    SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    Decision const decision = decide_by_quartic(r12, q1, q2);
    if (decision != Decision::none) return {decision, OverlapTier::quartic, StatusCode::success};
    return decide_near_contact(pair_of(r12, q1, q2));
}

template <class T, int D>
PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                     SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    Decision const decision = decide_by_quartic(r12, q1, q2);
    if (decision != Decision::none)
        return {decision == Decision::overlap, OverlapTier::quartic, StatusCode::success};
    return overlap_near_contact(pair_of(r12, q1, q2));
}

} // namespace pw85

namespace pw85::detail {

/// overlap() for functions that call it first. It is not inlined there.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Overlap
call_overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
             SymmetricMatrix<T, D> const &q2) noexcept
{
    return overlap(r12, q1, q2);
}

PW85_SHARED_BY_QUESTIONS(call_overlap)

} // namespace pw85::detail

#endif
