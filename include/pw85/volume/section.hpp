// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The section of the common part by a half-plane through the axis of its rim (rim_axis.hpp), for overlap_volume.hpp.
///
/// Let o + z ℓ be the axis, and ρ the distance from it in units of |g|, where g is the direction of the half-plane. Both surfaces are
/// arcs of conics that meet at one or two points of the rim. So the section is a polygon, with its vertices on the axis and on the rim, and
/// a segment of an ellipse on each of its outer sides. All parts are positive: nothing cancels, however thin the lens and however different
/// the bodies.
#ifndef PW85_VOLUME_SECTION_HPP_INCLUDED
#define PW85_VOLUME_SECTION_HPP_INCLUDED

#include <pw85/volume/circular_segment.hpp>
#include <pw85/volume/rim_frame.hpp>

namespace pw85::detail {

/// The point of the rim with p²/q² = (numerator/denominator)², both >= 0; tilt = 2 half_chord·height of the vertex.
template <class T> PW85_FUNCTION inline HalfPlanePoint<T> rim_point(T const &numerator, T const &denominator,
                                                                    T const &half_chord, T const &tilt) noexcept
{
    bool const up = numerator >= denominator;
    T const larger = up ? numerator : denominator, smaller = up ? denominator : numerator;
    T const square = larger > T(0) ? T(smaller / larger) : T(1), root = square_root(square);
    T const scale = half_chord / T(T(1) + square + tilt * root), z = T(T(1) - square) * scale;
    return {up ? z : T(-z), T(T(2) * root) * scale};
}

/// A body in a half-plane.
template <class T> struct Arc {
    T stretch, start, along, kappa, zeta, radius, half_chord;
};

template <class T, int D>
PW85_FUNCTION inline Arc<T> arc_of(BodyOnAxis<T, D> const &body, HalfPlane<T, D> const &half_plane) noexcept
{
    T const kappa = square_root(quadratic(body.products, half_plane.weights));
    T const zeta = T(linear(body.across, half_plane.weights) / kappa);
    T const radius = square_root(T(body.half_chord * body.half_chord + zeta * zeta));
    return {body.stretch, body.start, linear(body.along, half_plane.weights), kappa, zeta, radius, body.half_chord};
}

/// Moves a point of the rim along the circle of the ball by one step of Newton's method for the other surface. The axis is only as
/// accurate as the vertices, which are ill-conditioned where the rim nearly touches itself. Points that are moved are
/// in the same half-plane and on both surfaces, to rounding. A long step is not made: surfaces that nearly touch need no better point.
template <class T> PW85_FUNCTION inline HalfPlanePoint<T> corrected(HalfPlanePoint<T> const &p, Arc<T> const &ball,
                                                                    Arc<T> const &other) noexcept
{
    T const s = other.start + other.stretch * p.z + other.along * p.rho, r = T(other.kappa * p.rho);
    T const excess = T(T(s - other.half_chord) * T(s + other.half_chord)) + r * T(r - T(2) * other.zeta);
    T const dz = T(ball.zeta - ball.kappa * p.rho), drho = T(p.z / ball.kappa);
    T const slope =
        T(2) * T(s * T(other.stretch * dz + other.along * drho) + T(T(r - other.zeta) * T(other.kappa * drho)));
    T const step = T(excess / slope), limit = negative_power_of_two<T>(16);
    bool const is_short = absolute(T(step * drho)) <= T(limit * p.rho) && absolute(step) <= limit;
    return is_short ? HalfPlanePoint<T>{p.z - step * dz, p.rho - step * drho} : p;
}

/// The two points of the rim in a half-plane, the upper one first. If there is only one, both are the same.
template <class T> struct RimPoints {
    HalfPlanePoint<T> upper, lower;
};

/// Solves αZ² - TZ + γ = 0 for Z = p/q > 0, without cancellation. Where rounding errors leave no solution, the points are where both
/// would just meet.
template <class T, int D>
PW85_FUNCTION inline RimPoints<T> rim_points(RimFrame<T, D> const &rim, HalfPlane<T, D> const &half_plane) noexcept
{
    T const tilt = T(T(2) * T(rim.half_chord * linear(rim.heights, half_plane.weights)));
    T const excess = sum_of_squares(rim.excess, half_plane.weights), two_alpha = T(T(2) * rim.alpha);
    if (rim.least > T(0)) {
        T const above = maximum(excess, T(0)),
                sum = above + rim.least + square_root(T(above * T(above + T(2) * rim.least)));
        return {rim_point(sum, two_alpha, rim.half_chord, tilt),
                rim_point(T(T(2) * rim.gamma), sum, rim.half_chord, tilt)};
    }
    T const root = square_root(T(excess * excess - T(4) * T(rim.alpha * rim.gamma)));
    auto const point = excess > T(0) ? rim_point(T(excess + root), two_alpha, rim.half_chord, tilt)
                                     : rim_point(T(T(-2) * rim.gamma), T(root - excess), rim.half_chord, tilt);
    return {point, point};
}

template <class T, int D> PW85_FUNCTION inline RimPoints<T>
corrected_rim_points(RimFrame<T, D> const &rim, HalfPlane<T, D> const &half_plane, Arc<T> const (&arcs)[2]) noexcept
{
    auto const points = rim_points(rim, half_plane);
    return {corrected(points.upper, arcs[0], arcs[1]), corrected(points.lower, arcs[0], arcs[1])};
}

/// The chord of an arc from p down to q, in the metric of the body: half of its length, its outward normal, and the cosine of half of the
/// angle of the arc.
template <class T> struct ArcChord {
    T half_length, normal_s, normal_r, cosine;
};

template <class T> PW85_FUNCTION inline ArcChord<T> chord_of(Arc<T> const &arc, HalfPlanePoint<T> const &p,
                                                             HalfPlanePoint<T> const &q) noexcept
{
    T const drho = T(q.rho - p.rho), ds = T(arc.stretch * T(q.z - p.z) + arc.along * drho), dr = T(arc.kappa * drho);
    T const length = square_root(T(ds * ds + dr * dr));
    if (!(length > T(0))) return {T(0), T(0), T(0), T(1)};
    T const z = T(T(0.5) * T(p.z + q.z)), rho = T(T(0.5) * T(p.rho + q.rho));
    T const normal_s = T(dr / length), normal_r = T(-(ds / length));
    T const s = arc.start + arc.stretch * z + arc.along * rho, r = T(arc.kappa * rho);
    return {T(T(0.5) * length), normal_s, normal_r, T(T(s * normal_s + T(r - arc.zeta) * normal_r) / arc.radius)};
}

/// The area of the segment between an arc and its chord.
template <class T>
PW85_FUNCTION inline T segment_under(Arc<T> const &arc, HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q) noexcept
{
    auto const chord = chord_of(arc, p, q);
    if (!(chord.half_length > T(0))) return T(0);
    return T(circular_segment(chord.half_length, arc.radius, chord.cosine) / T(arc.stretch * arc.kappa));
}

/// The area of the triangle p, q, (z, 0), with p above q.
template <class T>
PW85_FUNCTION inline T triangle_under(HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q, T const &z) noexcept
{
    return T(T(0.5) * T(T(p.z - z) * q.rho - T(q.z - z) * p.rho));
}

/// Calls arc(p, q) for each arc of a body in a half-plane, from its upper to its lower end, and returns the sum.
template <class T, int D, class Function> PW85_FUNCTION inline auto
sum_over_arcs(AxisInterval<T> const &interval, RimPoints<T> const &points, int body, Function const &arc) noexcept
{
    bool const above = interval.ball_above == (body == 0), below = interval.ball_below == (body == 0);
    HalfPlanePoint<T> const top{interval.top, T(0)}, bottom{interval.bottom, T(0)};
    if (above && below) return arc(top, points.upper) + arc(points.lower, bottom);
    if (above) return arc(top, points.upper);
    if (below) return arc(points.lower, bottom);
    return arc(points.upper, points.lower);
}

/// The area of the section of the common part by a half-plane: what is seen from the middle of the axis on the arcs of both bodies.
template <class T, int D> PW85_FUNCTION inline T
section_area(RimFrame<T, D> const &rim, AxisInterval<T> const &interval, HalfPlane<T, D> const &half_plane) noexcept
{
    Arc<T> const arcs[2] = {arc_of(rim.bodies[0], half_plane), arc_of(rim.bodies[1], half_plane)};
    auto const points = corrected_rim_points(rim, half_plane, arcs);
    T sum = T(0);
    for (int body = 0; body < 2; ++body) {
        auto const &arc = arcs[body];
        sum = sum +
              sum_over_arcs<T, D>(interval, points, body, [&](HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q) {
                  return T(segment_under(arc, p, q) + triangle_under(p, q, interval.middle));
              });
    }
    return sum;
}

} // namespace pw85::detail

#endif
