// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Types for the bodies, the rim, and the points of the rim, relative to the axis (rim_axis.hpp)
/// and in the half-planes through it. rim_frame.hpp computes the bodies and the equation of the
/// rim, and rim_integrals.hpp computes the points.
#ifndef PW85_VOLUME_RIM_POINTS_HPP_INCLUDED
#define PW85_VOLUME_RIM_POINTS_HPP_INCLUDED

#include <pw85/algebra/two_doubled.hpp>

namespace pw85::detail {

/// A body in its metric, relative to the axis of the rim.
template <class T> struct BodyOnAxis {
    T stretch, start; ///< s = start + stretch·z on the axis
    T high, low;      ///< z of the ends of the axis inside the body
    T half_chord;     ///< half of the length of the axis inside the body, in the metric
    T along[2];       ///< the coordinate s of the image of each g_i
    T across[2];      ///< ζ κ of each g_i
    T products[2]
              /// κ²: dot products of the images of g_i, without their components along the axis
              [2];
    // With the unit vector k along the image of the axis, the point f of this image that is nearest
    // to the centre, and the components g_i⊥ of the images of g_i perpendicular to k:
    T twists[2];    ///< k·(f × g_i⊥)
    T turn;         ///< k·(g_1⊥ × g_2⊥)
    T above, below; ///< z of the ends of the ball's axis less z of those of this body
};

/// The numbers of a body as those of another type.
template <class Y, class T, class Function> PW85_FUNCTION inline BodyOnAxis<Y>
converted_by(Function const &convert, BodyOnAxis<T> const &x) noexcept
{
    BodyOnAxis<Y> y{};
    y.stretch = convert(x.stretch);
    y.start = convert(x.start);
    y.high = convert(x.high);
    y.low = convert(x.low);
    y.half_chord = convert(x.half_chord);
    y.turn = convert(x.turn);
    y.above = convert(x.above);
    y.below = convert(x.below);
    for (int i = 0; i < 2; ++i) {
        y.along[i] = convert(x.along[i]);
        y.across[i] = convert(x.across[i]);
        y.twists[i] = convert(x.twists[i]);
        for (int j = 0; j < 2; ++j) y.products[i][j] = convert(x.products[i][j]);
    }
    return y;
}

/// The numbers of a body for the two half-planes of a pair.
template <class T>
PW85_FUNCTION inline BodyOnAxis<TwoLanes<T>> side_by_side(BodyOnAxis<T> const &body) noexcept
{
    return converted_by<TwoLanes<T>>([](T const &x) { return TwoLanes<T>(x); }, body);
}

/// Flags: true if that end of the segment of the axis inside both bodies is an end of the chord of
/// the ball.
template <class Mask> struct AxisEnds {
    Mask ball_above, ball_below;
};

/// The equation of the rim: αZ² - TZ + γ = 0 with α > 0 or α = 0 > γ.
template <class T> struct RimEquation {
    T alpha, gamma;
    T least;     ///< 2√(αγ), or 0 if αγ < 0: the T with one solution
    T excess[2]; ///< T - least at each vertex
};

/// Selects both lanes by one mask of a pack.
template <class T>
requires(ScalarTraits<T>::lanes > 1) PW85_FUNCTION
    constexpr TwoLanes<T> select(typename ScalarTraits<T>::Mask const &mask, TwoLanes<T> const &yes,
                                 TwoLanes<T> const &no) noexcept
{
    return {select(mask, yes.first, no.first), select(mask, yes.second, no.second)};
}

/// The type of a number of a pair (or of one pair per lane), given a type that has a number for
/// each of the two half-planes.
template <class T> struct NumberOfPair {
    using type = T;
};
template <class T> struct NumberOfPair<TwoLanes<T>> {
    using type = T;
};

/// True if T has the numbers of one pair. Packs do not compute pairs with two rims.
template <class T> inline constexpr bool may_have_two_rims =
    ScalarTraits<typename NumberOfPair<T>::type>::lanes == 1;

/// The mask that two half-planes of a pair share.
template <class T> using RowMask = typename ScalarTraits<typename NumberOfPair<T>::type>::Mask;

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

} // namespace pw85::detail

#endif
