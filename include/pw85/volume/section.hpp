// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The section of the common part by a half-plane through the axis of its rim (rim_axis.hpp), for overlap_volume.hpp.
///
/// Let o + z ℓ be the axis, and ρ the distance from it in units of |g|, where g is the direction of the half-plane. Both surfaces are
/// arcs of conics that meet at one or two points of the rim. So the section is a polygon, with its vertices on the axis and on the rim, and
/// a segment of an ellipse on each of its outer sides. All parts are positive: nothing cancels, however thin the lens and however different
/// the bodies.
///
/// For each body there is a metric in which it is a ball of radius R. There the half-plane has coordinates (s, r) with r = κ ρ
/// and s along the image of the axis, and the arc is that of a circle about (0, ζ).
#ifndef PW85_VOLUME_SECTION_HPP_INCLUDED
#define PW85_VOLUME_SECTION_HPP_INCLUDED

#include <pw85/volume/circular_segment.hpp>
#include <pw85/volume/rim_axis.hpp>

namespace pw85::detail {

/// A body in its metric, relative to the axis of the rim.
template <class T, int D> struct BodyOnAxis {
    T stretch, start;             ///< s = start + stretch·z on the axis
    T high, low;                  ///< z of the ends of the axis inside the body
    T half_chord;                 ///< half of the length of the axis inside the body, in the metric
    T along[std::size_t(D - 1)];  ///< the coordinate s of the image of each g_i
    T across[std::size_t(D - 1)]; ///< ζ κ of each g_i
    T products[std::size_t(D - 1)]
              [std::size_t(D - 1)]; ///< κ²: products of the images of g_i, less their parts along the axis
};

/// What all half-planes of a pair share: the two bodies, the ball first, and the quadratic equation of the rim.
template <class T, int D> struct RimFrame {
    BodyOnAxis<T, D> bodies[2];
    T heights[std::size_t(D - 1)];
    T half_chord; ///< of the axis inside the ball
    // The rim: αZ² - TZ + γ = 0 with α > 0 or α = 0 > γ.
    T alpha, gamma;
    T least;                      ///< 2√(αγ), or 0 if αγ < 0: the T with one solution
    T excess[std::size_t(D - 1)]; ///< T - least at each vertex
};

/// A point of a half-plane.
template <class T> struct HalfPlanePoint {
    T z, rho;
};

/// A half-plane: that of the direction Σ weights_i g_i.
template <class T, int D> struct HalfPlane {
    T weights[std::size_t(D - 1)];
};

/// Area and ∫ρ of a region of a half-plane.
template <class T> struct RegionMoments {
    T area, rho;
};

template <class T>
PW85_FUNCTION inline RegionMoments<T> operator+(RegionMoments<T> const &a, RegionMoments<T> const &b) noexcept
{
    return {a.area + b.area, a.rho + b.rho};
}

/// A body from the images of the axis and of the vectors g_i, and of o less the centre. `half_chord` is only for the ball; it is computed
/// if it is zero.
template <class T, int D>
PW85_FUNCTION inline BodyOnAxis<T, D> body_on_axis(Vector<T, D> const &direction, Vector<T, D> const &origin,
                                                   Vector<T, D> const (&rays)[std::size_t(D - 1)], T const &radius,
                                                   T const &half_chord) noexcept
{
    BodyOnAxis<T, D> body{};
    body.stretch = magnitude(direction);
    Vector<T, D> const unit = direction / body.stretch;
    body.start = dot(origin, unit);
    Vector<T, D> const foot = add_scaled(origin, T(-body.start), unit);
    T const distance = magnitude(foot);
    body.half_chord =
        half_chord > T(0) ? half_chord : square_root(maximum(T(T(radius - distance) * T(radius + distance)), T(0)));
    body.high = T(body.half_chord - body.start) / body.stretch;
    body.low = -(T(body.half_chord + body.start) / body.stretch);
    Vector<T, D> perpendicular[std::size_t(D - 1)];
    for (int i = 0; i < D - 1; ++i) {
        body.along[i] = dot(rays[i], unit);
        perpendicular[i] = add_scaled(rays[i], T(-body.along[i]), unit);
        body.across[i] = -dot(foot, rays[i]);
        for (int j = 0; j <= i; ++j)
            body.products[i][j] = body.products[j][i] = dot(perpendicular[i], perpendicular[j]);
    }
    return body;
}

/// The quadratic equation of the rim, from A(n1, n1), A(n1, n2), A(n2, n2) and A(w, w) = t, over the square of the stretch of the axis. With
/// h half of the chord of the ball, α and γ are (h - z1)(h - z2) and (h + z1)(h + z2) for the ends z1, z2 of the other chord, and T is
/// m - 4h²A(w, w) with m = 2(h² - z1 z2). As m² - 4αγ = 4h²(z1 - z2)², nothing cancels in m - 2√(αγ) for a thin disc.
template <class T, int D>
PW85_FUNCTION inline void set_rim_equation(RimFrame<T, D> &rim, RimAxis<T, D> const &axis, T const &shortest) noexcept
{
    auto const &other = rim.bodies[1];
    T const h = rim.half_chord, scale = T(shortest / other.stretch) / other.stretch, inside = T(other.high * other.low);
    T const alpha = T(T(h - other.high) * T(h - other.low)), gamma = T(T(h + other.high) * T(h + other.low));
    T const sign = alpha < T(0) || (alpha == T(0) && gamma > T(0)) ? T(-1) : T(1), product = T(alpha * gamma);
    rim.alpha = sign * alpha;
    rim.gamma = sign * gamma;
    rim.least = product > T(0) ? T(T(2) * square_root(product)) : T(0);
    T const mean = T(T(2) * T(h * h - inside)), chord = T(T(T(4) * h) * T(other.half_chord / other.stretch));
    T const rest =
        sign > T(0) && rim.least > T(0) ? T(T(chord * chord) / T(mean + rim.least)) : T(sign * mean - rim.least);
    for (int i = 0; i < D - 1; ++i) rim.excess[i] = rest - T(T(T(4) * sign) * T(h * h)) * T(scale * axis.roots[i]);
}

template <class T, int D>
PW85_FUNCTION inline RimFrame<T, D> rim_frame(JointFrame<T, D> const &frame, RimAxis<T, D> const &axis) noexcept
{
    T const radius = frame.axes[std::size_t(D - 1)];
    RimFrame<T, D> rim{};
    rim.half_chord = axis.half_chord;
    Vector<T, D> rays[std::size_t(D - 1)], images[std::size_t(D - 1)], origin, direction;
    for (int j = 0; j < D - 1; ++j) rim.heights[j] = axis.heights[j];
    for (int i = 0; i < D; ++i) {
        T const ratio = radius / frame.axes[i];
        origin[i] = ratio * axis.origin[i] - radius * frame.center[i];
        direction[i] = ratio * axis.direction[i];
        for (int j = 0; j < D - 1; ++j) {
            rays[j][i] = axis.vertices[j][i] - axis.heights[j] * axis.origin[i];
            images[j][i] = ratio * rays[j][i];
        }
    }
    rim.bodies[0] = body_on_axis(axis.direction, axis.origin, rays, T(1), axis.half_chord);
    rim.bodies[0].high = axis.half_chord; // the axis is perpendicular to o
    rim.bodies[0].low = -axis.half_chord;
    rim.bodies[1] = body_on_axis(direction, origin, images, radius, T(0));
    set_rim_equation(rim, axis, radius);
    return rim;
}

template <class T, std::size_t N> PW85_FUNCTION inline T linear(T const (&row)[N], T const (&weights)[N]) noexcept
{
    T sum = row[0] * weights[0];
    for (std::size_t i = 1; i < N; ++i) sum = sum + row[i] * weights[i];
    return sum;
}

template <class T, std::size_t N>
PW85_FUNCTION inline T quadratic(T const (&rows)[N][N], T const (&weights)[N]) noexcept
{
    T sum = weights[0] * linear(rows[0], weights);
    for (std::size_t i = 1; i < N; ++i) sum = sum + weights[i] * linear(rows[i], weights);
    return sum;
}

/// Σ row_i weights_i².
template <class T, std::size_t N>
PW85_FUNCTION inline T sum_of_squares(T const (&row)[N], T const (&weights)[N]) noexcept
{
    T sum = row[0] * T(weights[0] * weights[0]);
    for (std::size_t i = 1; i < N; ++i) sum = sum + row[i] * T(weights[i] * weights[i]);
    return sum;
}

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

/// The segment between an arc and its chord from p down to q.
template <class T> PW85_FUNCTION inline RegionMoments<T> segment_under(Arc<T> const &arc, HalfPlanePoint<T> const &p,
                                                                       HalfPlanePoint<T> const &q) noexcept
{
    T const drho = T(q.rho - p.rho), ds = T(arc.stretch * T(q.z - p.z) + arc.along * drho), dr = T(arc.kappa * drho);
    T const length = square_root(T(ds * ds + dr * dr));
    if (!(length > T(0))) return {T(0), T(0)};
    T const z = T(T(0.5) * T(p.z + q.z)), rho = T(T(0.5) * T(p.rho + q.rho));
    T const normal_s = T(dr / length), normal_r = T(-(ds / length)); // outward
    T const s = arc.start + arc.stretch * z + arc.along * rho, r = T(arc.kappa * rho);
    T const cosine = T(s * normal_s + T(r - arc.zeta) * normal_r) / arc.radius;
    auto const segment = circular_segment(T(T(0.5) * length), arc.radius, cosine);
    T const density = T(1) / T(arc.stretch * arc.kappa);
    return {segment.area * density, T(T(r * segment.area + normal_r * segment.moment) * density) / arc.kappa};
}

/// The triangle p, q, (z, 0), with p above q.
template <class T> PW85_FUNCTION inline RegionMoments<T> triangle_under(HalfPlanePoint<T> const &p,
                                                                        HalfPlanePoint<T> const &q, T const &z) noexcept
{
    T const area = T(T(0.5) * T(T(p.z - z) * q.rho - T(q.z - z) * p.rho)), third = T(area / T(3));
    return {area, T(third * T(p.rho + q.rho))};
}

/// What is between the chord from p down to q and the axis.
template <class T>
PW85_FUNCTION inline RegionMoments<T> trapezoid_under(HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q) noexcept
{
    T const height = T(p.z - q.z), sum = T(p.rho + q.rho), sixth = T(height / T(6));
    return {T(T(0.5) * T(height * sum)), T(sixth * T(sum * sum - p.rho * q.rho))};
}

/// The common part on the axis, and the point of the axis from which both bodies' parts of a section are seen.
template <class T> struct AxisInterval {
    T top, bottom, middle;
    bool ball_above, ball_below; ///< whether the end is one of the ball
};

template <class T, int D> PW85_FUNCTION inline AxisInterval<T> axis_interval(RimFrame<T, D> const &rim) noexcept
{
    auto const &ball = rim.bodies[0], &other = rim.bodies[1];
    bool const above = other.high >= ball.high, below = other.low <= ball.low;
    T const top = above ? ball.high : other.high, bottom = below ? ball.low : other.low;
    return {top, bottom, T(T(0.5) * T(top + bottom)), above, below};
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

/// A section of the common part: what is seen from the middle of the axis on the arcs of the ball, and on those of the other body.
template <class T> struct SectionParts {
    RegionMoments<T> ball, other;
};

template <class T, int D> PW85_FUNCTION inline SectionParts<T>
section(RimFrame<T, D> const &rim, AxisInterval<T> const &interval, HalfPlane<T, D> const &half_plane) noexcept
{
    Arc<T> const arcs[2] = {arc_of(rim.bodies[0], half_plane), arc_of(rim.bodies[1], half_plane)};
    auto const points = corrected_rim_points(rim, half_plane, arcs);
    auto const part = [&](int body) {
        auto const &arc = arcs[body];
        return sum_over_arcs<T, D>(interval, points, body, [&](HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q) {
            return segment_under(arc, p, q) + triangle_under(p, q, interval.middle);
        });
    };
    return {part(0), part(1)};
}

} // namespace pw85::detail

#endif
