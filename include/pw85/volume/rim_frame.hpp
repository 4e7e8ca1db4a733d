// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers that all half-planes through the axis of a rim (rim_axis.hpp) share: both bodies
/// relative to the axis, and the equation of the rim (rim_points.hpp). rim_integrals.hpp uses this
/// file.
///
/// Let o + z ℓ be the axis, g a vector perpendicular to it, the direction of a half-plane, and ρ
/// the distance from the axis in units of |g|. For each body there is a metric in which it is a
/// ball of radius R. There the half-plane has coordinates (s, r) with r = κ ρ and s along the image
/// of the axis, and the surface of the body is a circle about (0, ζ).
///
/// The rim is ill-conditioned where it nearly touches itself: two vertices nearly coincide on the
/// sphere, and only a short part of the axis is inside the ball. The length of this part goes to
/// zero as the fourth root of the distance from touching. The relative errors of the numbers in
/// this file grow as its inverse square. So below a certain length they are computed from the joint
/// frame with twice the digits, and rounded.
#ifndef PW85_VOLUME_RIM_FRAME_HPP_INCLUDED
#define PW85_VOLUME_RIM_FRAME_HPP_INCLUDED

#include <pw85/algebra/two_doubled.hpp>
#include <pw85/volume/rim_axis.hpp>
#include <pw85/volume/rim_points.hpp>

namespace pw85::detail {

/// Data that all half-planes of a pair share: the two bodies, the ball first, and the quadratic
/// equation of the rim.
template <class T> struct RimFrame : RimEquation<T> {
    BodyOnAxis<T> bodies[2];
    T heights[2];
    T half_chord;                            ///< of the axis inside the ball
    Vector<T, 3> origin, direction, rays[2]; ///< o, ℓ and g_i
    T heading[2];                            ///< the unit vector along the heights
    /// t = 2h √Σ height² = 2√(1 - h²), and 2 - t
    T tilt, clearance;
    AxisEnds<typename ScalarTraits<T>::Mask> ends;
};

/// The ball, for which ℓ is perpendicular to o and to all g_i.
template <class T> PW85_FUNCTION inline BodyOnAxis<T>
ball_on_axis(RimAxis<T> const &axis, Vector<T, 3> const (&rays)[2]) noexcept
{
    BodyOnAxis<T> ball{};
    ball.stretch = T(1);
    ball.half_chord = ball.high = axis.half_chord;
    ball.low = -axis.half_chord;
    for (int i = 0; i < 2; ++i) {
        ball.across[i] = -dot(axis.origin, rays[i]);
        for (int j = 0; j <= i; ++j)
            ball.products[i][j] = ball.products[j][i] = dot(rays[i], rays[j]);
        ball.twists[i] = dot(axis.direction, cross(axis.origin, rays[i]));
    }
    ball.turn = dot(axis.direction, cross(rays[0], rays[1]));
    return ball;
}

/// The other body, from the images of the axis, of the vectors g_i, and of o minus the centre.
template <class T> PW85_FUNCTION inline BodyOnAxis<T> body_on_axis(Vector<T, 3> const &direction,
                                                                   Vector<T, 3> const &origin,
                                                                   Vector<T, 3> const (&rays)[2],
                                                                   T const &radius) noexcept
{
    BodyOnAxis<T> body{};
    body.stretch = magnitude(direction);
    Vector<T, 3> const unit = direction / body.stretch;
    body.start = dot(origin, unit);
    Vector<T, 3> const foot = add_scaled(origin, T(-body.start), unit);
    T const distance = magnitude(foot);
    body.half_chord = square_root(maximum(T(T(radius - distance) * T(radius + distance)), T(0)));
    body.high = T(body.half_chord - body.start) / body.stretch;
    body.low = -(T(body.half_chord + body.start) / body.stretch);
    Vector<T, 3> perpendicular[2];
    for (int i = 0; i < 2; ++i) {
        body.along[i] = dot(rays[i], unit);
        perpendicular[i] = add_scaled(rays[i], T(-body.along[i]), unit);
        body.across[i] = -dot(foot, rays[i]);
        for (int j = 0; j <= i; ++j)
            body.products[i][j] = body.products[j][i] = dot(perpendicular[i], perpendicular[j]);
        body.twists[i] = dot(unit, cross(foot, perpendicular[i]));
    }
    body.turn = dot(unit, cross(perpendicular[0], perpendicular[1]));
    return body;
}

/// If the distance of two ends, in units of half of the chord of the ball, is below this limit,
/// they count as equal. The limit is for numbers that are rounded to fewer digits afterwards. Let η
/// be this distance, or that of shifted_end(). The rim moves by η/s at a distance s from a point
/// where it crosses itself, and the angle between the surfaces is of the order s there. So the
/// volume changes by O(η² log(1/η)), and its derivatives by O(η log(1/η)). Both are below the
/// errors of the rounded numbers.
template <class T> PW85_FUNCTION constexpr T common_end() noexcept
{
    if constexpr (std::is_floating_point_v<typename ScalarTraits<T>::Lane>) return T(0);
    return negative_power_of_two<T>(2 * mantissa_digits<T>() / 3);
}

/// The value of -α/γ or -γ/α that is set at an end that both chords have in common. The larger it
/// is, the fewer nodes are needed.
template <class T> PW85_FUNCTION constexpr T shifted_end() noexcept
{
    return negative_power_of_two<T>(result_digits<T>() + 8);
}

/// Measures the ends of the chord of the other body from those of the ball's chord. Ends within
/// `nearest`, in units of half of the ball's chord, count as common.
///
/// The ends of the segment of the axis inside both bodies must agree with the signs of α and γ,
/// which are products of the same differences: αγ < 0, so that there is one rim, if the ends belong
/// to different bodies, and αγ > 0 if both belong to one body and the chords intersect.
///
/// Where both chords have an end in common, α or γ is zero, and one root of the equation of the rim
/// is this end in each half-plane. The other root is the one rim. So the common end counts as an
/// end of the body to which the other end does not belong. This also holds where that rim passes
/// through the common end. The volume is a continuous function of α and γ, so it does not matter
/// whether ends are equal only by rounding. Where both ends are common, the rim passes through the
/// lower one in half-planes in which the other body is inside the ball, and through the upper one
/// elsewhere.
///
/// Packs of numbers do not compute pairs with a common end (has_common_end()).
template <class T> PW85_FUNCTION inline void set_ends(RimFrame<T> &rim, T const &nearest) noexcept
{
    auto &other = rim.bodies[1];
    T const limit = T(nearest * rim.half_chord);
    other.above = T(rim.half_chord - other.high);
    other.below = T(-rim.half_chord - other.low);
    other.above = select(absolute(other.above) <= limit, T(0), other.above);
    other.below = select(absolute(other.below) <= limit, T(0), other.below);
    auto const above = other.above<T(0), below = other.below> T(0);
    rim.ends = {above, below};
    if constexpr (ScalarTraits<T>::lanes == 1) {
        bool const common_above = other.above == T(0), common_below = other.below == T(0);
        if (common_above && common_below)
            rim.ends = {false, true}; // as α > 0 > γ
        else if (common_above)
            rim.ends = {!below, below};
        else if (common_below)
            rim.ends = {above, !above};
    }
}

template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
has_common_end(BodyOnAxis<T> const &other) noexcept
{
    return other.above == T(0) || other.below == T(0);
}

/// α and γ divided by the square of the stretch of the axis. If an end is common, the product that
/// would be zero is replaced by a tiny one (shifted_end()). Each half-plane then has a point of the
/// rim that is not on the axis.
template <class T> struct AxisProducts {
    T alpha, gamma;
};

template <class T>
PW85_FUNCTION inline AxisProducts<T> axis_products(BodyOnAxis<T> const &other, T const &h) noexcept
{
    T const alpha = T(other.above * T(h - other.low)), gamma = T(T(h + other.high) * -other.below);
    if constexpr (ScalarTraits<T>::lanes == 1) {
        T const shift = shifted_end<T>();
        if (other.above == T(0) && other.below == T(0))
            return {T(shift * T(h * h)), T(-shift * T(h * h))};
        if (other.above == T(0)) return {T(-shift * gamma), gamma};
        if (other.below == T(0)) return {alpha, T(-shift * alpha)};
    }
    return {alpha, gamma};
}

/// The quadratic equation of the rim, from A(n1, n1), A(n1, n2), A(n2, n2) and A(w, w) = t, over
/// the square of the stretch of the axis. With h half of the chord of the ball, α and γ are (h -
/// z1)(h - z2) and (h + z1)(h + z2) for the ends z1, z2 of the other chord, and T is m - 4h²A(w, w)
/// with m = 2(h² - z1 z2). As m² - 4αγ = 4h²(z1 - z2)², nothing cancels in m - 2√(αγ) for a thin
/// disc.
template <class T> PW85_FUNCTION inline void
set_rim_equation(RimFrame<T> &rim, RimAxis<T> const &axis, T const &shortest) noexcept
{
    auto const &other = rim.bodies[1];
    T const h = rim.half_chord, scale = T(shortest / other.stretch) / other.stretch,
            inside = T(other.high * other.low);
    auto const [alpha, gamma] = axis_products(other, h);
    T const sign = select(alpha < T(0) || (alpha == T(0) && gamma > T(0)), T(-1), T(1)),
            product = T(alpha * gamma);
    rim.alpha = sign * alpha;
    rim.gamma = sign * gamma;
    rim.least = T(2) * square_root(maximum(product, T(0)));
    T const mean = T(T(2) * T(h * h - inside)),
            chord = T(T(T(4) * h) * T(other.half_chord / other.stretch));
    auto const is_small = sign > T(0) && rim.least > T(0);
    T rest = sign * mean - rim.least;
    if (any_of(is_small)) rest = select(is_small, T(T(chord * chord) / T(mean + rim.least)), rest);
    for (int i = 0; i < 2; ++i)
        rim.excess[i] = rest - T(T(T(4) * sign) * T(h * h)) * T(scale * axis.roots[i]);
    // If there are two rims, T can be below `least` only by rounding errors. The rims then
    // coincide.
    for (T &excess : rim.excess) excess = select(rim.least > T(0), maximum(excess, T(0)), excess);
}

/// Sets tilt, clearance and heading. A half-plane has 2 + tilt = clearance + ½ t |heading +
/// w|², without cancellation.
template <class T> PW85_FUNCTION inline void set_tilt(RimFrame<T> &rim) noexcept
{
    T sum = T(0);
    for (T const &height : rim.heights) sum = sum + height * height;
    T const length = square_root(sum), half_tilt = T(rim.half_chord * length); // √(1 - h²)
    rim.tilt = T(T(2) * half_tilt);
    rim.clearance = T(T(2) * T(rim.half_chord * rim.half_chord)) / T(T(1) + half_tilt);
    for (int i = 0; i < 2; ++i)
        rim.heading[i] = positive_quotient(rim.heights[i], length, T(i == 0 ? 1 : 0));
}

template <class T> PW85_FUNCTION inline RimFrame<T> rim_frame(JointFrame<T, 3> const &frame,
                                                              RimAxis<T> const &axis) noexcept
{
    T const radius = frame.axes[2];
    RimFrame<T> rim{};
    rim.half_chord = axis.half_chord;
    rim.origin = axis.origin;
    rim.direction = axis.direction;
    Vector<T, 3> images[2], origin, direction;
    for (int j = 0; j < 2; ++j) rim.heights[j] = axis.heights[j];
    for (int i = 0; i < 3; ++i) {
        T const ratio = radius / frame.axes[i];
        origin[i] = ratio * axis.origin[i] - radius * frame.center[i];
        direction[i] = ratio * axis.direction[i];
        for (int j = 0; j < 2; ++j) {
            rim.rays[j][i] = axis.vertices[j][i] - axis.heights[j] * axis.origin[i];
            images[j][i] = ratio * rim.rays[j][i];
        }
    }
    rim.bodies[0] = ball_on_axis(axis, rim.rays);
    rim.bodies[1] = body_on_axis(direction, origin, images, radius);
    T const square = T(T(highest_vertex_beside_pole) * T(highest_vertex_beside_pole));
    set_ends(rim, axis.touches_at_end ? T(T(1) / T(square * square)) : common_end<T>());
    set_rim_equation(rim, axis, radius);
    set_tilt(rim);
    return rim;
}

/// Rounds the numbers of a rim.
template <class T, class Fine>
PW85_FUNCTION inline void round_to(RimFrame<T> &y, RimFrame<Fine> const &x) noexcept
{
    auto const round = [](Fine const &number) { return rounded(number); };
    for (int i = 0; i < 2; ++i) y.bodies[i] = converted_by<T>(round, x.bodies[i]);
    y.half_chord = rounded(x.half_chord);
    y.alpha = rounded(x.alpha);
    y.gamma = rounded(x.gamma);
    y.least = rounded(x.least);
    y.tilt = rounded(x.tilt);
    y.clearance = rounded(x.clearance);
    y.ends = x.ends; // those of rounded chords may contradict α and γ
    y.origin = rounded(x.origin);
    y.direction = rounded(x.direction);
    for (int i = 0; i < 2; ++i) {
        y.heights[i] = rounded(x.heights[i]);
        y.excess[i] = rounded(x.excess[i]);
        y.heading[i] = rounded(x.heading[i]);
        y.rays[i] = rounded(x.rays[i]);
    }
}

/// The rim, computed with twice the digits from the joint frame that has the digits of T.
template <class T> PW85_RARE RimFrame<T> rim_frame_finely(JointFrame<T, 3> const &frame) noexcept
{
    auto const wide = widened(frame);
    RimFrame<T> rim{};
    round_to(rim, rim_frame(wide, rim_axis(wide)));
    return rim;
}

PW85_RARE_TIER_OF(rim_frame_finely, double)

/// Half of the length of the axis below which more digits are needed: above it, no more than three
/// bits are lost.
inline constexpr double shortest_axis = 0.375;

/// The distance of the centres over the fourth power of that length, with the ball as unit, above
/// which more digits are needed. Points in the metric of the other body are small differences of
/// numbers like its centre. So their errors are u times the distance. The errors of the numbers of
/// the rim are larger by the inverse square of the length, and so are those of the axis, from which
/// the rim is computed. At the limit the error is 16 u: a quarter of 64 u, the term of the bound
/// that does not depend on the pair.
inline constexpr double largest_distance_of_rim = 16.0;

/// Tests whether the digits of the result are enough for the rim.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_rim_accurate(JointFrame<T, 3> const &frame, T const &half_chord) noexcept
{
    T const square = T(half_chord * half_chord);
    return half_chord >= T(shortest_axis) &&
           distance_of_centers(frame) <= T(T(largest_distance_of_rim) * T(square * square));
}

/// The distance of two ends, in units of half of the chord of the ball, below which more digits are
/// needed if the rim passes near these ends. The distance ρ of the rim from the axis is then about
/// the square root of the distance of the ends, and the error of the direction from the end to the
/// rim is u/ρ.
inline constexpr double nearest_ends = 1.0 / 256.0;

/// The distance of two ends, as above, and the value of (T - `least`)/T, below which more digits
/// are needed for any rim. Above it, rounding errors change neither the number of rims nor the
/// choice of the axis. Ellipsoids that nearly touch along a curve have such numbers.
inline constexpr double nearest_rims = 0x1p-26;

/// Tests if the digits of the result are enough for a rim near an end of the axis, or near touching
/// itself. A rim passes near an end in some half-planes and not in the other ones if T changes its
/// sign.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_rim_apart_from_ends(RimFrame<T> const &rim) noexcept
{
    auto const &other = rim.bodies[1];
    T const distance = minimum(absolute(other.above), absolute(other.below)) / rim.half_chord;
    T const limit = T(nearest_rims), t1 = T(rim.excess[0] + rim.least),
            t2 = T(rim.excess[1] + rim.least);
    auto const has_one_sign = T(t1 * t2) > T(0);
    return distance >= select(has_one_sign, limit, T(nearest_ends)) &&
           (!has_one_sign || (absolute(rim.excess[0]) >= T(limit * absolute(t1)) &&
                              absolute(rim.excess[1]) >= T(limit * absolute(t2))));
}

template <class T>
PW85_FUNCTION inline RimFrame<T> accurate_rim_frame(JointFrame<T, 3> const &frame) noexcept
{
    auto const axis = rim_axis(frame);
    if constexpr (std::is_floating_point_v<T>)
        if (!is_rim_accurate(frame, axis.half_chord)) return rim_frame_finely(frame);
    auto const rim = rim_frame(frame, axis);
    if constexpr (std::is_floating_point_v<T>)
        if (!is_rim_apart_from_ends(rim)) return rim_frame_finely(frame);
    return rim;
}

} // namespace pw85::detail

#endif
