/// @file
/// The tiers of the overlap test in floating-point arithmetic, in their order: the sign of a quartic (quartic.hpp), then μ² by the
/// solver (comparison.hpp). Devices can run them. A pair that only exact arithmetic can decide stays undecided (overlap.hpp).
#ifndef PW85_OVERLAP_DECIDE_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_DECIDE_OVERLAP_HPP_INCLUDED

#include <pw85/overlap/comparison.hpp>
#include <pw85/overlap/quartic.hpp>

namespace pw85 {

/// The tier that decided a pair.
enum class OverlapTier { quartic, contact, exact };

/// The decision about a pair, and the tier that made it. It is `none` if the status is not success, or if the pair is so near to
/// contact, |μ² - 1| of some u cond, that floating-point arithmetic cannot decide.
struct OverlapDecision {
    Decision decision;
    OverlapTier tier;
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// The tiers after the first, for any pair.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline OverlapDecision
decide_near_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return {Decision::none, OverlapTier::contact, status};
    if (largest_coordinate(r12) == T(0)) return {Decision::overlap, OverlapTier::contact, Status::success};
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    return {decide_by_comparison(scaled.pair, tangent), OverlapTier::contact, Status::success};
}

/// decide_overlap(), with the first tier evaluated at as many points at once as `Lanes` has lanes.
template <class Lanes, class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline OverlapDecision
decide_overlap_by_lanes(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    Decision const decision = decide_by_quartic<Lanes>(r12, q1, q2);
    if (decision != Decision::none) return {decision, OverlapTier::quartic, Status::success};
    return decide_near_contact(r12, q1, q2);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline OverlapDecision
decide_overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return detail::decide_overlap_by_lanes<T>(r12, q1, q2);
}

} // namespace pw85

#endif
