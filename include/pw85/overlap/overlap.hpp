/// @file
/// The overlap test: floating-point arithmetic decides if it can (decide_overlap.hpp), otherwise exact arithmetic (exact.hpp).
#ifndef PW85_OVERLAP_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_OVERLAP_HPP_INCLUDED

#include <pw85/contact/contact.hpp>
#include <pw85/overlap/decide_overlap.hpp>
#include <pw85/overlap/exact.hpp>

namespace pw85 {

/// Whether two ellipsoids overlap; false if the status is not success.
struct Overlap {
    bool overlap;
    OverlapTier tier;
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// The last tier, for a valid pair. For multiprecision numbers it compares μ² with 1, up to rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Overlap
overlap_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    if constexpr (exact::is_decidable<T>)
        return {decide_exactly(r12, q1, q2) == Decision::overlap, OverlapTier::exact, Status::success};
    else
        return {contact(r12, q1, q2).mu2 < T(1), OverlapTier::contact, Status::success};
}

/// Whether two ellipsoids overlap, μ² < 1. The first tier is evaluated at as many points at once as `Lanes` has lanes.
template <class Lanes, class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Overlap
overlap_by_lanes(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const [decision, tier, status] = decide_overlap_by_lanes<Lanes>(r12, q1, q2);
    if (decision == Decision::none && status == Status::success) return overlap_exactly(r12, q1, q2);
    return {decision == Decision::overlap, tier, status};
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                               SymmetricMatrix<T, D> const &q2) noexcept
{
    return detail::overlap_by_lanes<T>(r12, q1, q2);
}

} // namespace pw85

#endif
