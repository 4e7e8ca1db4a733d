// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The common part of two ellipses as a polygon with segments of ellipses, for overlap_volume.hpp
/// and overlap_area_derivatives.hpp.
///
/// Let o + z ℓ be the axis of the rim (rim_axis.hpp), and y the distance from it in units of |g|,
/// along g. The rim is one or two points on each side of the axis. They are the vertices of a
/// polygon, and between two neighbouring ones the border of the common part is an arc of one of the
/// ellipses. So the area is that of the polygon, which is a chord or a quadrilateral, and of a
/// segment of an ellipse on each of its sides. All parts are positive: nothing cancels, however
/// thin the lens and however different the bodies.
#ifndef PW85_VOLUME_SECTION_HPP_INCLUDED
#define PW85_VOLUME_SECTION_HPP_INCLUDED

#include <pw85/volume/circular_segment.hpp>
#include <pw85/volume/rim_frame.hpp>

namespace pw85::detail {

/// A point of the plane.
template <class T> struct PlanePoint {
    T z, y;
};

/// A body in its metric, where it is a circle about (0, zeta): s = start + stretch z + along y and
/// r = kappa y.
template <class T> struct Circle {
    T stretch, start, along, kappa, zeta, radius, half_chord;
};

template <class T> PW85_FUNCTION inline Circle<T> circle_of(BodyOnAxis<T, 2> const &body) noexcept
{
    T const kappa = square_root(body.products[0][0]), zeta = T(body.across[0] / kappa);
    T const radius = square_root(T(body.half_chord * body.half_chord + zeta * zeta));
    return {body.stretch, body.start, body.along[0], kappa, zeta, radius, body.half_chord};
}

/// Moves a point of the rim along the circle of the ball by one step of Newton's method for the
/// other surface. The axis is only as accurate as the vertices, which are ill-conditioned where the
/// rim nearly touches itself. Points that are moved are on both surfaces, to rounding. A long step
/// is not made: surfaces that nearly touch need no better point.
template <class T> PW85_FUNCTION inline PlanePoint<T>
corrected(PlanePoint<T> const &p, Circle<T> const &ball, Circle<T> const &other) noexcept
{
    T const s = other.start + other.stretch * p.z + other.along * p.y, r = T(other.kappa * p.y);
    T const excess =
        T(T(s - other.half_chord) * T(s + other.half_chord)) + r * T(r - T(2) * other.zeta);
    T const dz = T(ball.zeta - ball.kappa * p.y), dy = T(p.z / ball.kappa);
    T const slope = T(2) * T(s * T(other.stretch * dz + other.along * dy) +
                             T(T(r - other.zeta) * T(other.kappa * dy)));
    T const step = T(excess / slope), limit = negative_power_of_two<T>(16);
    bool const is_short =
        absolute(T(step * dy)) <= T(limit * absolute(p.y)) && absolute(step) <= limit;
    return is_short ? PlanePoint<T>{p.z - step * dz, p.y - step * dy} : p;
}

/// The points of the rim at a root, on both sides of the axis.
template <class T> struct RimChord {
    PlanePoint<T> plus, minus;
};

template <class T> PW85_FUNCTION inline RimChord<T>
rim_chord(RimFrame<T, 2> const &rim, Circle<T> const (&circles)[2], RimRoot<T> const &root) noexcept
{
    T const tilt = T(T(T(2) * T(rim.half_chord * rim.heights[0])) * root.q),
            one = T(T(1) + root.square);
    T const rest = T(T(1) - root.square), twice = T(T(2) * root.q),
            up = root.up ? rim.half_chord : T(-rim.half_chord);
    T const plus = T(1) / T(one + tilt), minus = T(1) / T(one - tilt),
            across = T(twice * rim.half_chord);
    PlanePoint<T> const p{T(T(rest * plus) * up), T(across * plus)},
        m{T(T(rest * minus) * up), -T(across * minus)};
    return {corrected(p, circles[0], circles[1]), corrected(m, circles[0], circles[1])};
}

/// The rim: the chord whose arcs are the upper end of the common part, and that of the lower end if
/// `two` is set.
template <class T> struct PlaneRim {
    Circle<T> circles[2];
    RimChord<T> upper, lower;
    bool two;
    int top, bottom; ///< the bodies of these ends
};

template <class T> PW85_FUNCTION inline PlaneRim<T> plane_rim(RimFrame<T, 2> const &rim) noexcept
{
    auto const interval = axis_interval(rim);
    PlaneRim<T> r{{circle_of(rim.bodies[0]), circle_of(rim.bodies[1])}, {}, {}, false, 0, 0};
    r.top = interval.ball_above ? 0 : 1;
    r.bottom = interval.ball_below ? 0 : 1;
    r.two = r.top == r.bottom;
    auto const roots = rim_roots(rim, rim.excess[0]);
    r.upper = rim_chord(rim, r.circles, rim_root(roots, 0));
    // least = 0 says that there is one root, where rounding errors leave one chord of two
    r.lower = r.two && rim.least > T(0) ? rim_chord(rim, r.circles, rim_root(roots, 1)) : r.upper;
    return r;
}

/// T/least - 1 of the rim below which more digits are needed: both roots Z then differ by a factor
/// below 2.7.
inline constexpr double least_excess = 1.0 / 8.0;

/// Whether no two points of the rim are next to each other, on both sides of the axis or on one.
/// Where they are, their distance is less accurate than they are.
template <class T> PW85_FUNCTION inline bool are_points_apart(RimFrame<T, 2> const &rim) noexcept
{
    return rim.half_chord >= T(shortest_axis) &&
           !(rim.least > T(0) && rim.excess[0] < T(least_excess * rim.least));
}

/// The chord of an arc that leads from p counter-clockwise to q, in the metric of the body: half of
/// its length, its outward normal, and the cosine of half of the angle of the arc.
template <class T> struct ChordOfArc {
    T half_length, normal_s, normal_r, cosine;
};

template <class T> PW85_FUNCTION inline ChordOfArc<T>
chord_of(Circle<T> const &circle, PlanePoint<T> const &p, PlanePoint<T> const &q) noexcept
{
    T const dy = T(q.y - p.y), ds = T(circle.stretch * T(q.z - p.z) + circle.along * dy),
            dr = T(circle.kappa * dy);
    T const length = square_root(T(ds * ds + dr * dr));
    if (!(length > T(0))) return {T(0), T(0), T(0), T(1)};
    T const z = T(T(0.5) * T(p.z + q.z)), y = T(T(0.5) * T(p.y + q.y)), inverse = T(T(1) / length);
    T const normal_s = T(dr * inverse), normal_r = T(-(ds * inverse));
    T const s = circle.start + circle.stretch * z + circle.along * y, r = T(circle.kappa * y);
    return {T(T(0.5) * length), normal_s, normal_r,
            T(T(s * normal_s + T(r - circle.zeta) * normal_r) / circle.radius)};
}

/// The area of the segment between an arc and its chord, in the metric.
template <class T>
PW85_FUNCTION inline T segment_of(Circle<T> const &circle, ChordOfArc<T> const &chord) noexcept
{
    if (!(chord.half_length > T(0))) return T(0);
    return circular_segment(chord.half_length, circle.radius, chord.cosine);
}

/// Calls arc(body, p, q) for each arc of the border.
template <class T, class Function>
PW85_FUNCTION inline void for_each_arc(PlaneRim<T> const &rim, Function const &arc) noexcept
{
    arc(rim.top, rim.upper.minus, rim.upper.plus);
    arc(rim.bottom, rim.lower.plus, rim.lower.minus);
    if (!rim.two) return;
    arc(1 - rim.top, rim.upper.plus, rim.lower.plus);
    arc(1 - rim.top, rim.lower.minus, rim.upper.minus);
}

/// The area of the common part, in units of |g|.
template <class T> PW85_FUNCTION inline T area_inside(PlaneRim<T> const &rim) noexcept
{
    T areas[2] = {T(0), T(0)};
    for_each_arc(rim, [&](int body, PlanePoint<T> const &p, PlanePoint<T> const &q) {
        areas[body] =
            areas[body] + segment_of(rim.circles[body], chord_of(rim.circles[body], p, q));
    });
    T sum = T(0);
    for (int i = 0; i < 2; ++i)
        sum = sum + T(areas[i] / T(rim.circles[i].stretch * rim.circles[i].kappa));
    if (!rim.two) return sum;
    // half of the product of the diagonals
    auto const &a = rim.upper, &b = rim.lower;
    T const polygon = T(T(a.plus.z - b.minus.z) * T(b.plus.y - a.minus.y)) +
                      T(T(a.plus.y - b.minus.y) * T(a.minus.z - b.plus.z));
    return T(sum + T(0.5) * polygon);
}

} // namespace pw85::detail

#endif
