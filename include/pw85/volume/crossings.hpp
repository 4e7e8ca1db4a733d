// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The crossings of the unit circle with an ellipse, as places on the circle. section.hpp measures
/// the common part between them.
///
/// The pair is in its joint frame (joint_frame.hpp). With the metric in which the ellipse is a
/// circle of its shorter semi-axis a1 about the centre d, a point (x, y) of the unit circle is
/// inside the ellipse where F = (ρ x - d0)² + (y - d1)² - a1² <= 0, ρ = a1/a0.
///
/// 1. Half of the derivative of F along the circle is G = P x y + d1' y - d0' x, with P = 1 - ρ². In
///    a quarter of the circle it is ±P sin φ cos φ + g0 cos φ + g1 sin φ, where φ begins at the first
///    end of the quarter and g0 and g1 are its values at both ends. Over sin φ cos φ it is ±P + g0/sin
///    φ + g1/cos φ. This is monotone if g0 and g1 have opposite signs: G has one root. If they have
///    the same sign, it has one extremum, at tan³φ = g0/g1: there are two roots or none, and the
///    extremum separates them.
/// 2. So the ends of the quarters and the roots of G divide the circle into pieces on which F is
///    monotone. A piece has a crossing if F has opposite signs at its ends.
///
/// Nothing else is decided. Each decision is the sign of a number F at a point, which all integrals
/// share, so that they cannot contradict each other. A wrong sign means that |F| is below its
/// rounding error δ at an extremum of F: two crossings are lost or invented, between which the
/// border is within about δ/|∇F| of both curves. section.hpp has what this costs.
#ifndef PW85_VOLUME_CROSSINGS_HPP_INCLUDED
#define PW85_VOLUME_CROSSINGS_HPP_INCLUDED

#include <pw85/volume/joint_frame.hpp>

namespace pw85::detail {

/// A point of the plane.
template <class T> struct PlanePoint {
    T x, y;
};

/// A place on the unit circle: the angle is that of the quarter and 2 arctan t, 0 <= t <= 1.
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

/// The ellipse in its metric: the ratio ρ of the semi-axes, the shorter one, and the centre.
template <class T> struct FlattenedEllipse {
    T ratio, radius, d0, d1;

    PW85_MEMBER PlanePoint<T> from_center(PlanePoint<T> const &p) const noexcept
    {
        return {T(ratio * p.x - d0), T(p.y - d1)};
    }

    /// F. For an ellipse that is nearly the circle, from x² + y² = 1: it is as accurate as the
    /// differences are, also for copies whose centres nearly coincide.
    PW85_MEMBER T excess(PlanePoint<T> const &p) const noexcept
    {
        if (is_near_circle()) {
            T const constant = T(T(T(T(1) - radius) * T(T(1) + radius)) + T(d0 * d0)) + T(d1 * d1);
            T const linear = T(T(T(ratio * d0) * p.x) + T(d1 * p.y));
            return T(constant - T(flattening() * T(p.x * p.x))) - T(linear + linear);
        }
        auto const m = from_center(p);
        return T(T(m.y - radius) * T(m.y + radius)) + T(m.x * m.x);
    }

    /// Whether no term of that sum is more than a few units.
    PW85_MEMBER bool is_near_circle() const noexcept
    {
        return radius >= T(0.5) && radius <= T(2) && ratio >= T(0.5);
    }

    /// P, d0' and d1' of G, without the smallest numbers, of which powers would underflow.
    PW85_MEMBER T flattening() const noexcept { return T(T(T(1) - ratio) * T(T(1) + ratio)); }
    PW85_MEMBER T along() const noexcept { return cut(T(ratio * d0)); }
    PW85_MEMBER T across() const noexcept { return cut(d1); }

    /// G at a point: half of the derivative of F by the angle.
    PW85_MEMBER T half_derivative(PlanePoint<T> const &p) const noexcept
    {
        return T(T(flattening() * T(p.x * p.y)) + T(along() * p.y)) - T(across() * p.x);
    }

    PW85_MEMBER ValueAndSlope<T> excess_at(CirclePlace<T> const &place) const noexcept
    {
        auto const p = point_at(place);
        return {excess(p), T(T(T(4) * half_derivative(p)) / T(T(1) + place.t * place.t))};
    }

    PW85_MEMBER ValueAndSlope<T> half_derivative_at(CirclePlace<T> const &place) const noexcept
    {
        auto const p = point_at(place);
        T const slope = T(T(flattening() * T(T(p.x - p.y) * T(p.x + p.y))) + T(along() * p.x)) +
                        T(across() * p.y);
        return {half_derivative(p), T(T(slope + slope) / T(T(1) + place.t * place.t))};
    }

  private:
    PW85_MEMBER static T cut(T const &x) noexcept
    {
        constexpr int range = std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 4;
        T const least = negative_power_of_two<T>(range < 128 ? range : 128);
        return absolute(x) < least ? T(0) : x;
    }
};

template <class T>
PW85_FUNCTION inline FlattenedEllipse<T> flattened_ellipse(JointFrame<T, 2> const &frame) noexcept
{
    T const radius = frame.axes[1];
    return {T(radius / frame.axes[0]), radius, T(radius * frame.center[0]),
            T(radius * frame.center[1])};
}

/// A change of sign of a function between low and high, where it has the opposite sign of that at
/// low. Newton's method; a bisection replaces a step that leaves the bracket, or that does not halve
/// the last but one. It ends at a step below u, which is u on the circle.
template <class T, class Function> PW85_FUNCTION inline T
sign_change(T low, T high, bool is_negative_at_low, Function const &function) noexcept
{
    T const resolution = T(unit_roundoff<T>()), half = T(0.5);
    T t = T(half * T(low + high)), last = T(high - low), before = last;
    for (int step = 0; step < 4 * mantissa_digits<T>(); ++step) {
        auto const at = function(t);
        if (at.value == T(0)) return t;
        ((at.value < T(0)) == is_negative_at_low ? low : high) = t;
        T const middle = T(half * T(low + high)), newton = T(t - at.value / at.slope);
        bool const is_good =
            newton > low && newton < high && absolute(T(newton - t)) <= T(half * before);
        T const next = is_good ? newton : middle;
        before = last;
        last = absolute(T(next - t));
        t = next;
        if (!(last > resolution)) return t;
    }
    return t;
}

/// A cube root for a positive number, by Halley's method from a power of two: the relative error is
/// 0.6, 0.3, 0.02, 4e-6 and so on, with the cube of the one before.
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

/// A place with F there.
template <class T> struct Turn {
    CirclePlace<T> place;
    T excess;
};

/// The places between which F is monotone, in their order.
template <class T> struct Turns {
    static constexpr int most = 12; // an end and at most two roots for each quarter
    Turn<T> places[std::size_t(most)];
    int size;

    PW85_MEMBER void add(FlattenedEllipse<T> const &ellipse, CirclePlace<T> const &place) noexcept
    {
        places[size++] = {place, ellipse.excess(point_at(place))};
    }
};

/// Adds a quarter's first end and the roots of G in it.
template <class T> PW85_FUNCTION inline void
add_quarter(Turns<T> &turns, FlattenedEllipse<T> const &ellipse, int quarter) noexcept
{
    turns.add(ellipse, {quarter, T(0)});
    T const first = ellipse.half_derivative(point_at<T>({quarter, T(0)})),
            last = ellipse.half_derivative(point_at<T>({quarter, T(1)})),
            mixed = quarter % 2 == 0 ? ellipse.flattening() : T(-ellipse.flattening());
    // Next to an end where G is zero, it has the sign of its derivative.
    T const begin = first == T(0) ? T(mixed + last) : first,
            end = last == T(0) ? T(mixed + first) : last;
    auto const value = [&](T const &t) {
        return ellipse.half_derivative_at(CirclePlace<T>{quarter, t});
    };
    auto const root = [&](T const &low, T const &high, bool is_negative_at_low) {
        turns.add(ellipse, {quarter, sign_change(low, high, is_negative_at_low, value)});
    };
    if ((begin < T(0) && end > T(0)) || (begin > T(0) && end < T(0))) {
        root(T(0), T(1), begin < T(0));
    } else if ((first > T(0) && last > T(0) && mixed < T(0)) ||
               (first < T(0) && last < T(0) && mixed > T(0))) {
        T const middle = half_tangent(cube_root_of(T(first / last)));
        T const extremum = value(middle).value;
        if (!(first > T(0) ? extremum < T(0) : extremum > T(0))) return;
        root(T(0), middle, first < T(0));
        root(middle, T(1), first > T(0));
    }
}

template <class T>
PW85_FUNCTION inline Turns<T> turns_of(FlattenedEllipse<T> const &ellipse) noexcept
{
    Turns<T> turns{};
    for (int quarter = 0; quarter < 4; ++quarter) add_quarter(turns, ellipse, quarter);
    return turns;
}

/// The crossings in their order on the circle. Between the first and the second, the circle is
/// inside the ellipse if `first_inside` is set, and so on in turn.
template <class T> struct Crossings {
    static constexpr int most = Turns<T>::most;
    CirclePlace<T> places[std::size_t(most)];
    int size;
    bool first_inside; ///< for no crossing: whether the circle is inside the ellipse
    T least;           ///< the smallest |F| at the turns
};

template <class T> PW85_FUNCTION inline bool is_inside(Turn<T> const &turn) noexcept
{
    return turn.excess <= T(0);
}

template <class T>
PW85_FUNCTION inline Crossings<T> crossings(FlattenedEllipse<T> const &ellipse) noexcept
{
    auto const turns = turns_of(ellipse);
    Crossings<T> found{};
    found.first_inside = is_inside(turns.places[0]);
    found.least = absolute(turns.places[0].excess);
    for (int k = 0; k < turns.size; ++k) {
        auto const &turn = turns.places[k], &next = turns.places[(k + 1) % turns.size];
        found.least = minimum(found.least, absolute(turn.excess));
        if (is_inside(turn) == is_inside(next)) continue;
        int const quarter = turn.place.quarter;
        T const end = next.place.quarter == quarter && k + 1 < turns.size ? next.place.t : T(1);
        T const t = sign_change(turn.place.t, end, is_inside(turn), [&](T const &x) {
            return ellipse.excess_at(CirclePlace<T>{quarter, x});
        });
        if (found.size == 0) found.first_inside = is_inside(next);
        found.places[found.size++] = {quarter, t};
    }
    return found;
}

} // namespace pw85::detail

#endif
