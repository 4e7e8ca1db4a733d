// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The depth of an overlap: the shortest translation that separates two ellipsoids.
/// src/pair/distance.cpp calls penetration_overlapping().
///
/// A search over one number finds local minima (depth_search.hpp). A shallow depth follows from the
/// curvatures (is_shallow() below). Otherwise two proofs show that the best minimum is the global
/// one, or find a better one: around it depth_minimum.hpp, and elsewhere depth_intervals.hpp.
#ifndef PW85_DISTANCE_PENETRATION_HPP_INCLUDED
#define PW85_DISTANCE_PENETRATION_HPP_INCLUDED

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

/// A lower bound of the radii of curvature of an ellipsoid; zero if rounding hides them. With the
/// longest semi-axis a and the shortest one b the least radius is b²/a.
template <class T> PW85_FUNCTION inline T least_radius(AxisBounds<T> const &axes) noexcept
{
    return times_power_of_two(T(axes.least / square_root(axes.most)), axes.unit);
}

/// Returns whether the curvatures prove the best depth d to its rounding error. `radius` is R = R1
/// + R2, with the least radii of curvature of both ellipsoids.
///
/// An ellipsoid is a union of balls of its least radius of curvature (Blaschke's rolling theorem).
/// So the sum of the ellipsoids is a union of balls of the radius R. Let P = p1 + p2 be its
/// boundary point with the normal n, r = P - d n + w with w across n, and d < R. The ball of radius
/// R that touches the boundary at P is in the sum. So no direction needs less than the depth of r
/// in this ball, R - |(R - d)n + w| >= d - |w|²/(2(R - d)). Half of R is left for R - d.
///
/// The points are computed by accurate_product(), so that they err by less than (3 + 2√X)u times
/// the longest semi-axis (support.hpp). The factor of 8 covers the sum and the projection.
template <class T, int D>
PW85_FUNCTION inline bool is_shallow(DepthSearch<T, D> const &search, T const &radius) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    if (!(T(2) * best.length <= radius)) return false;
    auto const s1 = support_from(accurate_product(q1, n), n),
               s2 = support_from(accurate_product(q2, n), n);
    T const size1 = square_root(trace(q1)), size2 = square_root(trace(q2));
    T const x1 = size1 / s1.extent, x2 = size2 / s2.extent; // the roots of X
    if (!(maximum(T(x1 * x1), T(x2 * x2)) <= largest_spread<T>())) return false;
    T const size = sum_of_magnitudes(r12) + size1 * (T(1) + x1) + size2 * (T(1) + x2);
    Vector<T, D> const off = project(r12 - (s1.point + s2.point), n);
    T const across = square_root(dot(off, off)) + T(8 * unit_roundoff<T>()) * size;
    return across * across <= radius * best.rounding;
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
        if (follow_normal(search, search.direction)) continue;
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
    AxisBounds<T> const axes1 = axis_bounds(q1), axes2 = axis_bounds(q2);
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    descend_from_touching(search);
    if (!is_shallow(search, T(least_radius(axes1) + least_radius(axes2)))) {
        RatioRange<T> const range = ratio_range(axes1, axes2);
        if (!prove_globally(search, range)) return no_penetration<T, D>(StatusCode::no_convergence);
    }
    return {maximum(T(0), search.best.length), search.direction, StatusCode::success};
}

/// Computes penetration() of a valid pair that overlaps. A pair of like sizes is scaled to sizes of
/// order one, so that it gets the bits of a pair that needs no scaling. Otherwise the larger
/// ellipsoid is scaled to size 2^headroom, so that cQ1 and Q2/c are in range for any aspect ratio.
/// A smaller ellipsoid that would leave the range is made larger. This change is far below
/// rounding.
template <class T, int D> PW85_FUNCTION inline Penetration<T, D>
penetration_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int limit = std::numeric_limits<T>::max_exponent, headroom = limit / 5 * 2,
                  least = 16 - limit / 2;
    T const size1 = largest_diagonal(q1), size2 = largest_diagonal(q2);
    if (is_in_range(T(1), size1, size2)) return penetration_in_range(r12, q1, q2);
    int const e1 = half_exponent(size1), e2 = half_exponent(size2), larger = maximum(e1, e2);
    bool const alike = is_in_range(T(1), T(times_power_of_two(size1, -2 * larger)),
                                   T(times_power_of_two(size2, -2 * larger)));
    int const unit = alike ? larger : larger - headroom;
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
