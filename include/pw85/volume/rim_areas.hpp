// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The area of the part of a body that bounds the intersection, as an integral along the rim.
/// rim_integrals.hpp calls area_integrand().
///
/// Let y be a point of a body relative to its centre, in the metric in which the body is a ball of
/// radius one, and A the area of its part in this metric. area_beyond() and area_between() compute
/// the integrands of A. They are algebraic: they contain only square roots and divisions.
#ifndef PW85_VOLUME_RIM_AREAS_HPP_INCLUDED
#define PW85_VOLUME_RIM_AREAS_HPP_INCLUDED

#include <pw85/volume/rim_points.hpp>

namespace pw85::detail {

/// a·w of a row.
template <class T> PW85_FUNCTION inline T linear_form(T const (&row)[2], T const (&w)[2]) noexcept
{
    return row[0] * w[0] + row[1] * w[1];
}

/// A point in the metric of a body, with the numbers that all integrands of areas use.
template <class T> struct PointOnBody {
    T along, s, ds, twist, twist_derivative, square;
};

/// The ball has start 0, stretch 1, and `along` 0 (ball_on_axis()).
template <bool is_ball, class T>
PW85_FUNCTION inline PointOnBody<T> point_on_body(BodyOnAxis<T> const &body,
                                                  MovingHalfPlane<T> const &plane,
                                                  RimPoint<T> const &p) noexcept
{
    T const twist = linear_form(body.twists, plane.weights),
            twist_derivative = linear_form(body.twists, plane.derivatives),
            square = T(p.rho * p.rho);
    if constexpr (is_ball) return {T(0), p.z, p.dz, twist, twist_derivative, square};
    T const along = linear_form(body.along, plane.weights);
    return {along,
            body.start + body.stretch * p.z + along * p.rho,
            body.stretch * p.dz + along * p.drho +
                linear_form(body.along, plane.derivatives) * p.rho,
            twist,
            twist_derivative,
            square};
}

/// A point relative to the upper or the lower end of the chord of a body: its coordinate along the
/// axis, and its squared distance.
template <class T> struct PointFromEnd {
    T s, distance2;
    T side; ///< 1 for the upper end, -1 for the lower one
};

template <bool is_ball, class T> PW85_FUNCTION inline PointFromEnd<T>
from_end(BodyOnAxis<T> const &body, MovingHalfPlane<T> const &plane, RimPoint<T> const &p,
         PointOnBody<T> const &on, RowMask<T> const &is_upper) noexcept
{
    T const side = select(is_upper, T(1), T(-1)), // z of the end, and of the ball's end less that
        height = select(is_upper, body.high, body.low),
            beyond = select(is_upper, body.above, body.below);
    T const z = select(are_equal(p.up, is_upper), T(beyond - side * p.gap), T(p.z - height));
    T s = z;
    if constexpr (!is_ball) s = body.stretch * z + on.along * p.rho;
    T const kappa2 = T(plane.weights[0] * T(plane.weights[0] * body.products[0][0] +
                                            T(2) * T(plane.weights[1] * body.products[0][1]))) +
                     T(T(plane.weights[1] * plane.weights[1]) * body.products[1][1]);
    return {s, T(kappa2 * on.square + s * s), side};
}

/// 2 e·(d × dy)/|d|² for an end of the chord.
///
/// Let a part of the unit sphere have one rim, which is traversed counter-clockwise. For a point e
/// of the sphere outside the part, A is ∮ 2 e·(dy × d)/|d|² with d = y - e. Here e is one of the
/// ends of the chord on the axis.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_beyond(BodyOnAxis<T> const &body, MovingHalfPlane<T> const &plane,
                                   RimPoint<T> const &p, T const &turn,
                                   RowMask<T> const &is_upper) noexcept
{
    auto const on = point_on_body<is_ball>(body, plane, p);
    auto const [s, distance2, side] = from_end<is_ball>(body, plane, p, on, is_upper);
    T const h = T(side * body.half_chord);
    T const numerator = T(h * T(on.square * turn)) - T(s * p.drho - p.rho * on.ds) * on.twist -
                        T(T(s * p.rho) * on.twist_derivative);
    return T(T(numerator + numerator) / distance2);
}

/// The integrand for a part between two rims, which has neither end inside: the mean of the
/// integrands of area_beyond() with both ends. In closed form it is (f·m a + h² s k·m)/(a² - h²s²),
/// with m = y × dy, a = h² - f·ρg⊥, and with k, f, s and h of rim_frame.hpp. The closed form is
/// used in the middle of the chord, where the mean may be small. Near the ends of the chord the
/// terms of the closed form cancel, and the mean is used.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_between(BodyOnAxis<T> const &body, MovingHalfPlane<T> const &plane,
                                    RimPoint<T> const &p, T const &turn) noexcept
{
    auto const on = point_on_body<is_ball>(body, plane, p);
    auto const is_outer = absolute(on.s) > T(T(0.5) * body.half_chord);
    T mean = T(0);
    if (any_of(is_outer))
        mean = T(T(0.5) * T(area_beyond<is_ball>(body, plane, p, turn, true) +
                            area_beyond<is_ball>(body, plane, p, turn, false)));
    if (all_of(is_outer)) return mean;
    T const h2 = T(body.half_chord * body.half_chord);
    T const foot =
        T(T(p.rho * on.ds - on.s * p.drho) * on.twist) - T(T(on.s * p.rho) * on.twist_derivative);
    T const axial = p.drho * on.twist + p.rho * on.twist_derivative + on.square * turn;
    T const a = h2 + p.rho * linear_form(body.across, plane.weights),
            hs = T(body.half_chord * on.s);
    return select(is_outer, mean, T(T(foot * a + T(h2 * on.s) * axial) / T(T(a - hs) * T(a + hs))));
}

/// The area of the part of a body by integrals along the rim. The end e of
/// area_beyond() is not inside the part: for one rim, it is the end that does not belong to the
/// body.
///
/// The integrand has a pole near the real axis if e is near the rim. So, if the rim is near an end
/// of the axis, e is the other end. The integral is then the area on the other side of the rim, and
/// the area of the part is the whole surface minus this integral. The area of a part between two
/// rims is the whole surface minus two caps. The errors of both differences are a few u times the
/// whole surface. They are used only if the body is not much larger than the ball.
template <class Mask> struct AreaRule {
    Mask above, below; ///< true if this end of the segment inside both bodies is the body's
    Mask is_upper;     ///< true if the end e for one rim is the upper end
    Mask is_rest;      ///< true if the area is the rest of the surface

    PW85_MEMBER Mask has_two_rims() const noexcept { return are_equal(above, below); }
};

/// The integrand of the area of the part of a body at one or two points, or that of the rest of the
/// surface, with the opposite sign.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_integrand(BodyOnAxis<T> const &body, MovingHalfPlane<T> const &plane,
                                      RimPoint<T> const (&points)[2], T const &speed,
                                      AreaRule<RowMask<T>> const &rule) noexcept
{
    T const turn = T(speed * body.turn);
    if constexpr (may_have_two_rims<T>)
        if (rule.has_two_rims()) {
            if (!rule.above && !rule.is_rest)
                return area_between<is_ball>(body, plane, points[0], turn) -
                       area_between<is_ball>(body, plane, points[1], turn);
            T const caps = area_beyond<is_ball>(body, plane, points[1], turn, true) -
                           area_beyond<is_ball>(body, plane, points[0], turn, false);
            return rule.above ? caps : -caps;
        }
    T const area = area_beyond<is_ball>(body, plane, points[0], turn, rule.is_upper);
    return select(rule.above, T(-area), area);
}

} // namespace pw85::detail

#endif
