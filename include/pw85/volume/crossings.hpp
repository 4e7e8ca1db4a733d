// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points in which the unit circle and an ellipse cross. section.hpp computes the area of the
/// intersection from them.
///
/// The pair is in its joint frame (joint_frame.hpp). With the metric in which the ellipse is a
/// circle of its shorter semi-axis a1 about the centre d, a point (x, y) of the unit circle is
/// inside the ellipse where F = (ρ x - d0)² + (y - d1)² - a1² <= 0, ρ = a1/a0.
///
/// 1. Half of the derivative of F along the circle is G = P x y + d1' y - d0' x, with P = 1 - ρ².
///    In a quarter of the circle it is ±P sin φ cos φ + g0 cos φ + g1 sin φ, where φ begins at the
///    first end of the quarter and g0 and g1 are its values at both ends. Over sin φ cos φ it is ±P
///    + g0/sin φ + g1/cos φ. This is monotone if g0 and g1 have opposite signs: G has one root. If
///    they have the same sign, it has one extremum, at tan³φ = g0/g1: there are two roots or none,
///    and the extremum separates them.
/// 2. So the ends of the quarters and the roots of G divide the circle into pieces on which F is
///    monotone. A piece has a crossing if F has opposite signs at its ends.
///
/// There are no other decisions. Each decision is the sign of F at a point, and all integrals use
/// the same signs, so the decisions cannot contradict each other. A sign can be wrong only if |F|
/// is below its rounding error δ at an extremum of F. Two crossings are then lost or added. Between
/// them the border is within about δ/|∇F| of both curves. section.hpp bounds the resulting error.
#ifndef PW85_VOLUME_CROSSINGS_HPP_INCLUDED
#define PW85_VOLUME_CROSSINGS_HPP_INCLUDED

#include <pw85/volume/joint_frame.hpp>

namespace pw85::detail {

/// A point of the plane.
template <class T> struct PlanePoint {
    T x, y;
};

/// A point on the unit circle at the angle quarter·π/2 + 2 arctan t, 0 <= t <= 1.
template <class T> struct CirclePlace {
    int quarter;
    T t;
};

template <class T> PW85_FUNCTION inline PlanePoint<T> point_at(CirclePlace<T> const &place) noexcept
{
    T const t = place.t, scale = T(T(1) / T(T(1) + t * t));
    T const c = T(T(T(T(1) - t) * T(T(1) + t)) * scale), s = T(T(t + t) * scale);
    switch (place.quarter % 4) {
    case 0:
        return {c, s};
    case 1:
        return {T(-s), c};
    case 2:
        return {T(-c), T(-s)};
    default:
        return {s, T(-c)};
    }
}

/// A number and its derivative with respect to t.
template <class T> struct ValueAndSlope {
    T value, slope;
};

/// Numbers that end the search for a root: the rounding error of the function, and a bound on half
/// of its second derivative.
template <class T> struct Accuracy {
    T noise, half_second;
};

/// The ellipse in its metric: the ratio ρ of the semi-axes, the shorter one, and the centre. P and
/// the shortfall, 1 - a1², keep their digits where they are small.
template <class T> struct FlattenedEllipse {
    T ratio, radius, d0, d1, flattening, shortfall;

    PW85_MEMBER PlanePoint<T> from_center(PlanePoint<T> const &p) const noexcept
    {
        return {T(ratio * p.x - d0), T(p.y - d1)};
    }

    /// Tests whether the ellipse is nearly equal to the circle. Then F = 1 - a1² + d² - P x² - 2 (ρ
    /// d0 x + d1 y), which follows from x² + y² = 1, has terms of a few units at most. This sum is
    /// as accurate as the differences of both shapes, also for equal ellipses with nearly the same
    /// centre.
    PW85_MEMBER bool is_near_circle() const noexcept
    {
        return radius >= T(0.5) && radius <= T(2) && ratio >= T(0.5);
    }

    /// F.
    PW85_MEMBER T excess(PlanePoint<T> const &p) const noexcept
    {
        if (is_near_circle()) {
            T const constant = T(shortfall + T(d0 * d0)) + T(d1 * d1);
            T const linear = T(T(T(ratio * d0) * p.x) + T(d1 * p.y));
            return T(constant - T(flattening * T(p.x * p.x))) - T(linear + linear);
        }
        auto const m = from_center(p);
        return T(T(m.y - radius) * T(m.y + radius)) + T(m.x * m.x);
    }

    /// Returns the factors of y and -x in G.
    PW85_MEMBER T along() const noexcept { return T(ratio * d0); }
    PW85_MEMBER T across() const noexcept { return d1; }

    /// G at a point: half of the derivative of F with respect to the angle.
    PW85_MEMBER T half_derivative(PlanePoint<T> const &p) const noexcept
    {
        return T(T(flattening * T(p.x * p.y)) + T(along() * p.y)) - T(across() * p.x);
    }

    /// Half of the second derivative.
    PW85_MEMBER T half_second_derivative(PlanePoint<T> const &p) const noexcept
    {
        return T(T(flattening * T(T(p.x - p.y) * T(p.x + p.y))) + T(along() * p.x)) +
               T(across() * p.y);
    }

    /// |F''| and |G''| are at most twice this along the circle, and their second derivatives with
    /// respect to t at most eleven times.
    PW85_MEMBER T size_of_derivatives() const noexcept
    {
        return flattening + absolute(along()) + absolute(across());
    }

    /// Returns the size of the terms of F: that of a1 and of the largest number, or that of the
    /// differences from a nearly equal circle.
    PW85_MEMBER T size_of_excess() const noexcept
    {
        if (is_near_circle())
            return T(absolute(shortfall) + T(d0 * d0)) + T(d1 * d1) +
                   T(size_of_derivatives() + size_of_derivatives());
        return T(radius * T(T(1) + absolute(d0) + absolute(d1) + radius));
    }

    PW85_MEMBER Accuracy<T> accuracy_of_excess() const noexcept
    {
        return {T(T(unit_roundoff<T>()) * size_of_excess()), T(T(6) * size_of_derivatives())};
    }
    PW85_MEMBER Accuracy<T> accuracy_of_half_derivative() const noexcept
    {
        T const size = size_of_derivatives();
        return {T(T(unit_roundoff<T>()) * size), T(T(6) * size)};
    }

    PW85_MEMBER ValueAndSlope<T> excess_at(CirclePlace<T> const &place) const noexcept
    {
        auto const p = point_at(place);
        return {excess(p), T(T(T(4) * half_derivative(p)) / T(T(1) + place.t * place.t))};
    }

    PW85_MEMBER ValueAndSlope<T> half_derivative_at(CirclePlace<T> const &place) const noexcept
    {
        auto const p = point_at(place);
        T const half_second = half_second_derivative(p);
        return {half_derivative(p), T(T(half_second + half_second) / T(T(1) + place.t * place.t))};
    }
};

template <class T>
PW85_FUNCTION inline FlattenedEllipse<T> flattened_ellipse(JointFrame<T, 2> const &frame) noexcept
{
    T const radius = frame.axes[1], ratio = T(radius / frame.axes[0]);
    return {ratio,
            radius,
            T(radius * frame.center[0]),
            T(radius * frame.center[1]),
            T(T(T(1) - ratio) * T(T(1) + ratio)),
            T(T(T(1) - radius) * T(T(1) + radius))};
}

/// The leading digits.
template <class T> PW85_FUNCTION inline auto rounded(FlattenedEllipse<T> const &e) noexcept
{
    return FlattenedEllipse<decltype(rounded(e.ratio))>{
        rounded(e.ratio), rounded(e.radius),     rounded(e.d0),
        rounded(e.d1),    rounded(e.flattening), rounded(e.shortfall)};
}

/// Finds a change of sign of a function of t between `low` and `high`, at which the function has
/// opposite signs, from a start between them. The method is Newton's. A bisection replaces a step
/// that leaves the bracket, or that is longer than half of the last step but one. The search ends
/// after a step that leaves an error half_second step²/|slope| below u. If the value of the
/// function is a rounding error, the search ends after a step that changes the function by at most
/// another rounding error, half_second step². A longer step means that the slope is a rounding
/// error, too, as near a root of multiplicity three.
template <class T, class Function>
PW85_FUNCTION inline T sign_change(T low, T high, T t, bool is_negative_at_low,
                                   Accuracy<T> const &accuracy, Function const &function) noexcept
{
    T const u = T(unit_roundoff<T>()), half = T(0.5);
    T last = T(high - low), before = last;
    for (int step = 0; step < 4 * mantissa_digits<T>() && last > u; ++step) {
        auto const at = function(t);
        ((at.value < T(0)) == is_negative_at_low ? low : high) = t;
        T const newton = T(t - at.value / at.slope), length = absolute(T(newton - t));
        bool const is_inside = newton > low && newton < high;
        T const half_second = T(accuracy.half_second * T(length * length));
        if (absolute(at.value) <= accuracy.noise)
            return is_inside && half_second <= accuracy.noise ? newton : t;
        bool const is_good = is_inside && length <= T(half * before);
        if (is_good && half_second <= T(u * absolute(at.slope))) return newton;
        T const next = is_good ? newton : T(half * T(low + high));
        before = last;
        last = absolute(T(next - t));
        t = next;
    }
    return t;
}

/// The cube root of a positive number, by Halley's method from a power of two. The relative errors
/// are at most 0.6, 0.2, 0.003, 1.5e-8 and so on: each is 2/3 of the cube of the one before, once
/// it is small.
template <class T> PW85_FUNCTION inline T cube_root_of(T const &x) noexcept
{
    int const exponent = binary_exponent(x);
    T z = times_power_of_two(T(1), exponent >= 0 ? exponent / 3 : -(-exponent / 3));
    for (int step = 0; step < 8; ++step) {
        T const cube = T(T(z * z) * z);
        z = T(T(z * T(cube + T(x + x))) / T(T(cube + cube) + x));
    }
    return z;
}

/// tan(φ/2) of the angle φ in (0, π/2) with this tangent.
template <class T> PW85_FUNCTION inline T half_tangent(T const &tangent) noexcept
{
    return T(tangent / T(T(1) + square_root(T(T(1) + tangent * tangent))));
}

/// Values of t at the extrema of F in a quarter that separate its crossings, in increasing order.
template <class T> struct Extrema {
    T places[2];
    int size;
};

/// F has one extremum in a quarter if its derivatives at both ends have opposite signs. It has none
/// or two if they have the same sign. With a single extremum, F changes its sign once if it has
/// opposite signs at the ends. If F has the same sign at both ends, it can change its sign twice in
/// two cases: a maximum between ends inside the ellipse, and a minimum between ends outside. In all
/// other cases the extremum is not needed.
template <class T>
PW85_FUNCTION inline Extrema<T> needed_extrema(FlattenedEllipse<T> const &ellipse, int quarter,
                                               bool begins_inside, bool ends_inside) noexcept
{
    T const first = ellipse.half_derivative(point_at<T>({quarter, T(0)})),
            last = ellipse.half_derivative(point_at<T>({quarter, T(1)})),
            mixed = quarter % 2 == 0 ? ellipse.flattening : T(-ellipse.flattening);
    // Next to an end at which G is zero, G has the sign of its derivative.
    T const begin = first == T(0) ? T(mixed + last) : first,
            end = last == T(0) ? T(mixed + first) : last;
    auto const value = [&](T const &t) {
        return ellipse.half_derivative_at(CirclePlace<T>{quarter, t});
    };
    auto const root = [&](T const &low, T const &high, bool is_negative_at_low) {
        return sign_change(low, high, T(T(0.5) * T(low + high)), is_negative_at_low,
                           ellipse.accuracy_of_half_derivative(), value);
    };
    if ((begin < T(0) && end > T(0)) || (begin > T(0) && end < T(0))) {
        bool const has_maximum = begin > T(0);
        if (begins_inside != ends_inside || begins_inside != has_maximum) return {};
        return {{root(T(0), T(1), begin < T(0)), T(0)}, 1};
    }
    bool const may_turn = (first > T(0) && last > T(0) && mixed < T(0)) ||
                          (first < T(0) && last < T(0) && mixed > T(0));
    if (!may_turn) return {};
    T const middle = half_tangent(cube_root_of(T(first / last))), extremum = value(middle).value;
    if (!(first > T(0) ? extremum < T(0) : extremum > T(0))) return {};
    return {{root(T(0), middle, first < T(0)), root(middle, T(1), first > T(0))}, 2};
}

/// The crossings in their order on the circle. Between the first and the second crossing, the
/// circle is inside the ellipse if `first_inside` is true. After each crossing it is inside and
/// outside in turn.
template <class T> struct Crossings {
    static constexpr int most = 12; // three for each quarter, by rounding errors alone
    CirclePlace<T> places[std::size_t(most)];
    int size;
    bool first_inside; ///< for no crossing: whether the circle is inside the ellipse
    T least;           ///< the smallest |F| at ends of quarters and extrema
};

/// The crossing between two points of a quarter, from a start.
template <class T>
PW85_FUNCTION inline T crossing_from(FlattenedEllipse<T> const &ellipse, int quarter, T const &low,
                                     T const &high, T const &start, bool is_inside_at_low) noexcept
{
    return sign_change(low, high, start, is_inside_at_low, ellipse.accuracy_of_excess(),
                       [&](T const &t) {
                           return ellipse.excess_at(CirclePlace<T>{quarter, t});
                       });
}

/// The crossing between two points of a quarter. The search starts at the crossing in the narrower
/// type.
template <class T, class Coarse> PW85_FUNCTION inline CirclePlace<T>
crossing_between(FlattenedEllipse<T> const &ellipse, FlattenedEllipse<Coarse> const &coarse,
                 int quarter, Coarse const &low, Coarse const &high, bool is_inside_at_low) noexcept
{
    Coarse const middle = Coarse(Coarse(0.5) * Coarse(low + high)),
                 start = crossing_from(coarse, quarter, low, high, middle, is_inside_at_low);
    if constexpr (std::is_same_v<T, Coarse>)
        return {quarter, start};
    else
        return {quarter,
                crossing_from(ellipse, quarter, T(low), T(high), T(start), is_inside_at_low)};
}

/// F at a point. The narrower type suffices where |F| is far above its rounding error, which is a
/// few u times the square of the largest number: the margin is √u times this square.
template <class T, class Coarse>
PW85_FUNCTION inline T excess_at_turn(FlattenedEllipse<T> const &ellipse,
                                      FlattenedEllipse<Coarse> const &coarse,
                                      CirclePlace<Coarse> const &place) noexcept
{
    if constexpr (!std::is_same_v<T, Coarse>) {
        Coarse const excess = coarse.excess(point_at(place)),
                     size = Coarse(1) + absolute(coarse.d0) + absolute(coarse.d1) + coarse.radius;
        Coarse const margin = negative_power_of_two<Coarse>(mantissa_digits<Coarse>() / 2);
        if (absolute(excess) > margin * (size * size)) return T(excess);
    }
    return ellipse.excess(point_at(CirclePlace<T>{place.quarter, T(place.t)}));
}

/// Adds the crossings of a quarter, given F at its ends.
template <class T, class Coarse>
PW85_FUNCTION inline void add_quarter(Crossings<T> &found, FlattenedEllipse<T> const &ellipse,
                                      FlattenedEllipse<Coarse> const &coarse, int quarter,
                                      T const &first, T const &last) noexcept
{
    auto const extrema = needed_extrema(coarse, quarter, first <= T(0), last <= T(0));
    bool is_inside = first <= T(0);
    Coarse low = Coarse(0);
    for (int k = 0; k <= extrema.size; ++k) {
        bool const at_end = k == extrema.size;
        Coarse const high = at_end ? Coarse(1) : extrema.places[k];
        T const excess = at_end ? last : excess_at_turn(ellipse, coarse, {quarter, high});
        bool const was_inside = is_inside;
        is_inside = excess <= T(0);
        found.least = minimum(found.least, absolute(excess));
        if (is_inside != was_inside) {
            if (found.size == 0) found.first_inside = is_inside;
            found.places[found.size++] =
                crossing_between(ellipse, coarse, quarter, low, high, was_inside);
        }
        low = high;
    }
}

/// For a wider type, the extrema are found in the narrower type. An error ε of an extremum changes
/// F there by ε² F''/2, which is a rounding error of the wider type.
template <class T>
PW85_FUNCTION inline Crossings<T> crossings(FlattenedEllipse<T> const &ellipse) noexcept
{
    auto const coarse = rounded(ellipse);
    using Coarse = decltype(coarse.ratio);
    T ends[4];
    for (int quarter = 0; quarter < 4; ++quarter)
        ends[quarter] = excess_at_turn(ellipse, coarse, CirclePlace<Coarse>{quarter, Coarse(0)});
    Crossings<T> found{};
    found.first_inside = ends[0] <= T(0);
    found.least = absolute(ends[0]);
    for (int quarter = 0; quarter < 4; ++quarter)
        add_quarter(found, ellipse, coarse, quarter, ends[quarter], ends[(quarter + 1) % 4]);
    return found;
}

/// Tests whether all crossings and extrema are accurate enough for derivatives.
///
/// 1. An error η of a curve, perpendicular to it, moves a crossing by η over the sine of the angle
///    at which the curves cross. η is a few u. So the errors of the derivatives are about 256u at
///    most if the sine is at least 1/64.
/// 2. For centres and axes within the limits of the derivatives, the error of F is below 2⁻⁴⁰ a1².
///    The test requires |F| > 2⁻³⁶ a1² at extrema and ends of quarters, so these signs are right.
template <class T> PW85_FUNCTION inline bool are_crossings_clear(FlattenedEllipse<T> const &ellipse,
                                                                 Crossings<T> const &found) noexcept
{
    T const least_square = negative_power_of_two<T>(12);
    if (!(found.least > T(T(negative_power_of_two<T>(36)) * T(ellipse.radius * ellipse.radius))))
        return false;
    for (int k = 0; k < found.size; ++k) {
        auto const p = point_at(found.places[k]);
        auto const m = ellipse.from_center(p);
        T const x = T(ellipse.ratio * m.x), slope = ellipse.half_derivative(p);
        if (!(T(slope * slope) >= T(least_square * T(x * x + m.y * m.y)))) return false;
    }
    return true;
}

} // namespace pw85::detail

#endif
