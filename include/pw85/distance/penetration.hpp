// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The depth of an overlap: the shortest translation that separates two ellipsoids.
/// src/pair/distance.cpp calls penetration_overlapping().
///
/// Turns of the normal find a local minimum (depth_search.hpp). For most pairs the curvatures there
/// prove that it is the global one (depth_certificate.hpp). Otherwise two proofs show that the best
/// minimum is the global one, or find a better one: around it depth_minimum.hpp, and elsewhere
/// depth_intervals.hpp.
#ifndef PW85_DISTANCE_PENETRATION_HPP_INCLUDED
#define PW85_DISTANCE_PENETRATION_HPP_INCLUDED

#include <pw85/distance/depth_certificate.hpp>
#include <pw85/distance/depth_intervals.hpp>
#include <pw85/distance/depth_minimum.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids. If they are apart, the
/// depth is zero and the direction is NaN.
template <class T, int D> struct Penetration {
    T depth;
    Vector<T, D> direction; ///< unit vector
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> no_penetration(StatusCode status) noexcept
{
    auto result = all_nan<Penetration<T, D>>(status);
    if (status == StatusCode::success) result.depth = T(0);
    return result;
}

/// Proves that the best minimum is the global one, or finds a better one.
template <class T, int D> PW85_FUNCTION inline DepthProof
prove_once(DepthSearch<T, D> &search, RatioRange<T> const &range) noexcept
{
    RatioRange<T> around = proved_range(search, range);
    if (!(around.lower < around.upper)) { // no isolated minimum; a better one may be
        descend_from_all(search, range);
        around = proved_range(search, range);
    }
    T const d = search.best.length, sigma = d * (dot(search.direction, search.r12) + d);
    auto const below = prove_depth(search, {range.lower, around.lower}, sigma);
    return below == DepthProof::complete ? prove_depth(search, {around.upper, range.upper}, sigma)
                                         : below;
}

/// The largest number of minima that the proof starts from. Each is lower than the last one. More
/// than two are rare.
inline constexpr int max_depth_minima = 64;

template <class T, int D> PW85_FUNCTION inline bool
prove_globally(DepthSearch<T, D> &search, RatioRange<T> const &range) noexcept
{
    for (int i = 0; i < max_depth_minima; ++i) {
        auto const proof = prove_once(search, range);
        if (proof != DepthProof::better) return proof == DepthProof::complete;
        if (follow_normal(search, search.direction).converged) continue;
        descend(search, search.best.ratio);
        follow_normal(search, search.direction);
    }
    return false;
}

/// Computes penetration() of a valid pair that overlaps and is in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_in_range(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2) noexcept
{
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    auto const minimum = descend_from_touching(search);
    if (!(minimum.found && is_certified(search, minimum.at))) {
        RatioRange<T> const range = ratio_range(axis_bounds(q1), axis_bounds(q2));
        if (!prove_globally(search, range)) return no_penetration<T, D>(StatusCode::no_convergence);
    }
    return {maximum(T(0), search.best.length), search.direction, StatusCode::success};
}

/// Computes penetration() of a valid pair that overlaps. A pair of like sizes is scaled to sizes of
/// order one, so that it gets the bits of a pair that needs no scaling. Otherwise the larger
/// ellipsoid is scaled to size 2^room, so that cQ1 and Q2/c are in range for any aspect ratio. A
/// smaller ellipsoid that would leave the range is made larger. This change is far below rounding.
template <class T, int D> PW85_FUNCTION inline Penetration<T, D>
penetration_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int limit = std::numeric_limits<T>::max_exponent, room = limit / 5 * 2,
                  least = 16 - limit / 2;
    T const size1 = largest_diagonal(q1), size2 = largest_diagonal(q2);
    if (is_in_range(T(1), size1, size2)) return penetration_in_range(r12, q1, q2);
    int const e1 = half_exponent(size1), e2 = half_exponent(size2), larger = maximum(e1, e2);
    bool const alike = is_in_range(T(1), T(times_power_of_two(size1, -2 * larger)),
                                   T(times_power_of_two(size2, -2 * larger)));
    int const unit = alike ? larger : larger - room;
    int const unit1 = minimum(unit, e1 - least), unit2 = minimum(unit, e2 - least);
    auto result =
        penetration_in_range(times_power_of_two(r12, -unit), times_power_of_two(q1, -2 * unit1),
                             times_power_of_two(q2, -2 * unit2));
    result.depth = times_power_of_two(result.depth, unit);
    return result;
}

} // namespace pw85::detail

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids.
template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> penetration(Vector<T, D> const &r12,
                                                   SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = detail::call_overlap(r12, q1, q2);
    if (decision.status != StatusCode::success || !decision.overlap)
        return detail::no_penetration<T, D>(decision.status);
    return detail::penetration_overlapping(r12, q1, q2);
}

} // namespace pw85

#endif
