/// @file
/// The overlap test, and the ladder of its tiers. pw85.hpp, the C API, the headers for distances and the code for devices call it.
/// Each tier decides for certain or not at all. Each tier is slower than the one before, and decides pairs that the tiers before it
/// leave open:
///
/// 1. decide_by_points(): the sign of a quartic at some points, with bounds on the rounding errors (quartic.hpp);
/// 2. decide_by_search(): the sign of the same quartic at the points of a search (quartic.hpp);
/// 3. decide_by_comparison(): μ² by the solver, with a bound on its error (comparison.hpp);
/// 4. decide_exactly(): integers (exact.hpp).
///
/// Devices run the first three tiers. src/kernels/lane_overlap.hpp runs the first two for one pair per lane.
#ifndef PW85_OVERLAP_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_OVERLAP_HPP_INCLUDED

#include <pw85/overlap/comparison.hpp>
#include <pw85/overlap/exact.hpp>
#include <pw85/overlap/quartic.hpp>

namespace pw85 {

/// The tier that decided a pair. `quartic` stands for tiers 1 and 2.
enum class OverlapTier { quartic, contact, exact };

/// The decision about a pair, and the tier that made it. The decision is `none` in two cases: the status is not success, or the
/// pair is so near to contact (|μ² - 1| of some u cond) that floating-point arithmetic cannot decide.
struct OverlapDecision {
    Decision decision;
    OverlapTier tier;
    Status status;
};

/// Whether two ellipsoids overlap. It is false if the status is not success.
struct Overlap {
    bool overlap;
    OverlapTier tier;
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// Tiers 1 and 2. Tier 1 tests as many points at once as `Lanes` has lanes. The result is `none` for pairs that fail the fast
/// checks, are ill-conditioned, or are tangent up to rounding.
template <class Lanes, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Decision decide_by_quartic(Pair<T, D> const &pair) noexcept
{
    if (!passes_fast_checks(pair)) return Decision::none;
    T t;
    Decision const decision = decide_by_points<Lanes>(pair.r12, pair.q1, pair.q2, t);
    if (decision != Decision::none) return decision;
    if constexpr (is_for_device) // a call would need local memory
        return decide_by_search(pair, t);
    else
        return decide_by_search(pair.r12, pair.q1, pair.q2, t);
}

/// Tier 3, for any pair.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline OverlapDecision decide_near_contact(Pair<T, D> pair) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(pair, scaled);
    if (status != Status::success) return {Decision::none, OverlapTier::contact, status};
    if (largest_coordinate(pair.r12) == T(0)) return {Decision::overlap, OverlapTier::contact, Status::success};
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    return {decide_by_comparison(scaled.pair, tangent), OverlapTier::contact, Status::success};
}

/// Tier 4, for a valid pair. For multiprecision numbers it compares μ² with 1, up to rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Overlap overlap_exactly(Pair<T, D> pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    if constexpr (exact::is_decidable<T>)
        return {decide_exactly(r12, q1, q2) == Decision::overlap, OverlapTier::exact, Status::success};
    else
        return {contact(r12, q1, q2).mu2 < T(1), OverlapTier::contact, Status::success};
}

/// Tiers 1 to 3.
template <class Lanes, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline OverlapDecision decide_overlap_by_lanes(Pair<T, D> const &pair) noexcept
{
    Decision const decision = decide_by_quartic<Lanes>(pair);
    if (decision != Decision::none) return {decision, OverlapTier::quartic, Status::success};
    return decide_near_contact(pair);
}

/// All tiers.
template <class Lanes, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Overlap overlap_by_lanes(Pair<T, D> const &pair) noexcept
{
    auto const [decision, tier, status] = decide_overlap_by_lanes<Lanes>(pair);
    if (decision == Decision::none && status == Status::success) return overlap_exactly(pair);
    return {decision == Decision::overlap, tier, status};
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline OverlapDecision
decide_overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return detail::decide_overlap_by_lanes<T>(detail::pair_of(r12, q1, q2));
}

template <class T, int D> PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                               SymmetricMatrix<T, D> const &q2) noexcept
{
    return detail::overlap_by_lanes<T>(detail::pair_of(r12, q1, q2));
}

} // namespace pw85

#endif
