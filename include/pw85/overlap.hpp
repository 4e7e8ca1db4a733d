/// @file
/// Whether two ellipsoids overlap, decided by the cheapest means that is certain: the sign of a quartic (quartic.hpp), μ² by the
/// solver (comparison.hpp), exact arithmetic (exact.hpp). The first two need nothing that a device lacks; what they leave is for
/// the third.
#ifndef PW85_OVERLAP_HPP_INCLUDED
#define PW85_OVERLAP_HPP_INCLUDED

#include <pw85/comparison.hpp>
#include <pw85/exact.hpp>
#include <pw85/geometry.hpp>
#include <pw85/quartic.hpp>

namespace pw85 {

/// The means by which a pair was decided.
enum class OverlapTier { quartic, contact, exact };

/// Whether two ellipsoids overlap; false where the status is not success.
struct Overlap {
    bool overlap;
    OverlapTier tier;
    Status status;
};

/// What shows that two ellipsoids overlap or not. Near tangency it is right to rounding only.
template <class T, int D> struct OverlapWitness {
    bool overlap;
    T lambda;               ///< where f > 1 if they are apart
    Vector<T, D> direction; ///< unit normal of a plane that separates them, from 1 to 2, if they are apart
    Vector<T, D> point;     ///< inside both, relative to the centre of ellipsoid 1, if they overlap
    Status status;
};

/// The tiers after the first, for any pair. A multiprecision number is compared to rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Overlap
overlap_near_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return {false, OverlapTier::contact, status};
    if (largest_coordinate(r12) == T(0)) return {true, OverlapTier::contact, Status::success};
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    Decision const decision = decide_by_comparison(scaled.pair, tangent);
    if (decision != Decision::none) return {decision == Decision::overlap, OverlapTier::contact, Status::success};
    if constexpr (exact::is_decidable<T>)
        return {decide_exactly(r12, q1, q2) == Decision::overlap, OverlapTier::exact, Status::success};
    else
        return {maximize(scaled.pair).mu2 < tangent, OverlapTier::contact, Status::success};
}

/// Whether two ellipsoids overlap, μ² < 1; with the first tier at as many points at once as `Lanes` has lanes.
template <class Lanes, class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Overlap
overlap_by_lanes(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Decision const decision = decide_by_quartic<Lanes>(r12, q1, q2);
    if (decision != Decision::none) return {decision == Decision::overlap, OverlapTier::quartic, Status::success};
    return overlap_near_contact(r12, q1, q2);
}

template <class T, int D> PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                               SymmetricMatrix<T, D> const &q2) noexcept
{
    return overlap_by_lanes<T>(r12, q1, q2);
}

template <class T, int D> PW85_FUNCTION inline OverlapWitness<T, D>
overlap_witness(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const answer = overlap(r12, q1, q2);
    T const lambda = contact(r12, q1, q2).lambda;
    auto const geometry = contact_geometry(r12, q1, q2, lambda);
    OverlapWitness<T, D> witness{answer.overlap, lambda, geometry.normal, geometry.point, answer.status};
    for (int i = 0; i < D; ++i) {
        if (answer.overlap) witness.direction[i] = quiet_nan<T>();
        if (answer.status != Status::success || !answer.overlap)
            witness.point[i] = quiet_nan<T>();
        else if (geometry.status != Status::success)
            witness.point[i] = T(0);
    }
    return witness;
}

} // namespace pw85

#endif
