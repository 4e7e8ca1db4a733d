// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Both bodies and the points of the rim relative to its axis (rim_frame.hpp), in the half-planes
/// through it: the roots of the equation of the rim, and their derivatives along the rim.
/// rim_integrals.hpp calls rim_roots(), rim_root() and rim_point().
#ifndef PW85_VOLUME_RIM_POINTS_HPP_INCLUDED
#define PW85_VOLUME_RIM_POINTS_HPP_INCLUDED

#include <pw85/algebra/two_doubled.hpp>
#include <pw85/volume/pencil_roots.hpp>

namespace pw85::detail {

/// A body in its metric, relative to the axis of the rim.
template <class T> struct BodyOnAxis {
    T stretch, start; ///< s = start + stretch·z on the axis
    T high, low;      ///< z of the ends of the axis inside the body
    T half_chord;     ///< half of the length of the axis inside the body, in the metric
    T along[2];       ///< the coordinate s of the image of each g_i
    T across[2];      ///< ζ κ of each g_i
    T products[2]
              /// κ²: products of the images of g_i, less their parts along the axis
              [2];
    // In space, with the unit vector k along the image of the axis, the point f of the axis next to
    // the centre, and g_i⊥ across the axis:
    T twists[2];    ///< k·(f × g_i⊥)
    T turn;         ///< k·(g_1⊥ × g_2⊥)
    T above, below; ///< z of the ends of the ball's axis less z of those of this body
};

/// Flags: true if that end of the common part of the axis is an end of the chord of the ball.
template <class Mask> struct AxisEnds {
    Mask ball_above, ball_below;
};

/// The equation of the rim: αZ² - TZ + γ = 0 with α > 0 or α = 0 > γ.
template <class T> struct RimEquation {
    T alpha, gamma;
    T least;     ///< 2√(αγ), or 0 if αγ < 0: the T with one solution
    T excess[2]; ///< T - least at each vertex
};

/// The roots of αZ² - TZ + γ = 0, each as a ratio, the larger one first, without cancellation.
/// Where rounding errors leave no solution, both are where the rim would just touch itself.
template <class T> struct RimRoots {
    T numerators[2], denominators[2];
};

/// `excess` is T less `least` of the rim.
template <class T>
PW85_FUNCTION inline RimRoots<T> rim_roots(RimEquation<T> const &rim, T const &excess) noexcept
{
    T const two_alpha = T(T(2) * rim.alpha), two_gamma = T(T(2) * rim.gamma);
    auto const two = rim.least > T(0), is_positive = excess > T(0);
    T const above = maximum(excess, T(0));
    T const root = square_root(select(two, T(above * T(above + T(2) * rim.least)),
                                      T(excess * excess - two_alpha * two_gamma)));
    T const sum = above + rim.least + root;
    return {{select(two || is_positive, sum, T(-two_gamma)), select(two, two_gamma, T(0))},
            {select(two || is_positive, two_alpha, T(root - excess)), select(two, sum, T(1))}};
}

/// Selects both lanes by one mask of a pack.
template <class T>
requires(ScalarTraits<T>::lanes > 1) PW85_FUNCTION
    constexpr TwoLanes<T> select(typename ScalarTraits<T>::Mask const &mask, TwoLanes<T> const &yes,
                                 TwoLanes<T> const &no) noexcept
{
    return {select(mask, yes.first, no.first), select(mask, yes.second, no.second)};
}

/// The number of a pair, or of one pair per lane, for a type that has a number for each of its two
/// half-planes.
template <class T> struct NumberOfPair {
    using type = T;
};
template <class T> struct NumberOfPair<TwoLanes<T>> {
    using type = T;
};

/// Tests if T has the numbers of one pair. Packs leave pairs with two rims over.
template <class T> inline constexpr bool may_have_two_rims =
    ScalarTraits<typename NumberOfPair<T>::type>::lanes == 1;

/// The mask that two half-planes of a pair share.
template <class T> using RowMask = typename ScalarTraits<typename NumberOfPair<T>::type>::Mask;

/// x == y for masks.
template <class Mask> PW85_FUNCTION inline Mask are_equal(Mask const &x, Mask const &y) noexcept
{
    return (x && y) || !(x || y);
}

/// A root Z as q = min(√Z, 1/√Z), with the square of q.
template <class T> struct RimRoot {
    T q, square;
    RowMask<T> up; ///< Z >= 1
};

template <class T>
PW85_FUNCTION inline RimRoot<T> rim_root(RimRoots<T> const &roots, int k) noexcept
{
    T const numerator = roots.numerators[k], denominator = roots.denominators[k];
    auto const up = numerator >= denominator;
    T const larger = select(up, numerator, denominator),
            smaller = select(up, denominator, numerator);
    T const square = positive_quotient(smaller, larger, T(1));
    return {square_root(square), square, up};
}

/// A point of the rim in a half-plane, and its derivatives with respect to the parameter of the
/// rule.
template <class T> struct RimPoint {
    T z, rho, dz, drho;
    T gap; ///< h - |z|, the distance from the end of the ball's axis that is nearer along it
    RowMask<T> up; ///< true if this is the upper end
};

/// A half-plane, with the derivative of its direction by the parameter.
template <class T> struct MovingHalfPlane {
    T weights[2], derivatives[2];
    T lift, tilt_derivative; ///< 2 + tilt, with 2h times the height of its vertex as tilt
};

/// The point at a root, with half of the derivative of ln Z.
///
/// In half-planes X = z ℓ + ρ f(ψ) with z = h (1 - q²)/d and ρ = 2hq/d, d = 1 + q² + tilt q, where
/// q² = Z or 1/Z is the smaller root of αZ² - TZ + γ = 0. As d(ln Z)/dψ = ±T'/√E, the derivatives
/// with respect to the parameter of the rule are free of √E (EllipticRule::pace).
template <class T> PW85_FUNCTION inline RimPoint<T> rim_point(RimRoot<T> const &root,
                                                              T const &half_log_derivative,
                                                              MovingHalfPlane<T> const &plane,
                                                              T const &half_chord) noexcept
{
    T const q = root.q,
            // d = (1 - q)² + (2 + tilt) q does not cancel where the rim nearly touches itself
        rest = T(T(1) - q);
    T const scale = T(1) / T(rest * rest + plane.lift * q),
            rho = T(T(T(2) * q) * T(half_chord * scale));
    T const speed = select(root.up, half_log_derivative, T(-half_log_derivative));
    T const drho =
        T(-rho) * T(T(T(rest * T(T(1) + q)) * speed + q * plane.tilt_derivative) * scale);
    // h - |z| = ρ (q + tilt/2): near an end of the axis all terms of the integrands are small, and
    // so are their errors
    T const ratio = T(T(0.5) * plane.lift) - rest, gap = T(rho * ratio);
    T const change = drho * ratio + rho * T(T(T(0.5) * plane.tilt_derivative) - q * speed),
            z = half_chord - gap;
    return {
        select(root.up, z, T(-z)), rho, select(root.up, T(-change), change), drho, gap, root.up};
}

} // namespace pw85::detail

#endif
