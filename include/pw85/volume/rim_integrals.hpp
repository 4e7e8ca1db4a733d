// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The integrals along the rim that give the volume of the common part and its derivatives, for
/// overlap_volume.hpp and overlap_volume_derivatives.hpp. All integrands are algebraic: nothing but
/// square roots and divisions.
///
/// The pair is in its joint frame. P1 and P2 are the parts of the surfaces of the ball and of the
/// other body that bound the common part. Let y be a point of a body relative to its centre, in the
/// metric in which the body is a ball of radius one, and A the area of its part in this metric.
/// volume_terms() gives the volume by both areas and a flux, and area_beyond() and area_between()
/// give the areas.
#ifndef PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED
#define PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED

#include <pw85/algebra/two_lanes.hpp>
#include <pw85/volume/elliptic_rule.hpp>

namespace pw85::detail {

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

/// a·w of a row.
template <class T> PW85_FUNCTION inline T linear_form(T const (&row)[2], T const (&w)[2]) noexcept
{
    return row[0] * w[0] + row[1] * w[1];
}

/// A point in the metric of a body: what the integrands of the areas have in common.
template <class T> struct PointOnBody {
    T along, s, ds, twist, twist_derivative, square;
};

/// The ball has start 0, stretch 1, and `along` 0 (ball_on_axis()).
template <bool is_ball, class T>
PW85_FUNCTION inline PointOnBody<T> point_on_body(BodyOnAxis<T, 3> const &body,
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

/// The upper or the lower end of the chord of a body.
template <class T> struct ChordEnd {
    T side;           ///< 1 for the upper one, -1 for the lower one
    T beyond, height; ///< z of the end of the ball's axis less z of this end, and z of this end
    RowMask<T> is_upper;
};

template <class T> PW85_FUNCTION inline ChordEnd<T> chord_end(BodyOnAxis<T, 3> const &body,
                                                              RowMask<T> const &is_upper) noexcept
{
    return {select(is_upper, T(1), T(-1)), select(is_upper, body.above, body.below),
            select(is_upper, body.high, body.low), is_upper};
}

/// A point relative to an end of the chord: its coordinate along the axis, and its squared
/// distance.
template <class T> struct PointFromEnd {
    T s, distance2;
};

template <bool is_ball, class T> PW85_FUNCTION inline PointFromEnd<T>
from_end(BodyOnAxis<T, 3> const &body, MovingHalfPlane<T> const &plane, RimPoint<T> const &p,
         PointOnBody<T> const &on, ChordEnd<T> const &end) noexcept
{
    T const z = select(are_equal(p.up, end.is_upper), T(end.beyond - end.side * p.gap),
                       T(p.z - end.height));
    T s = z;
    if constexpr (!is_ball) s = body.stretch * z + on.along * p.rho;
    T const kappa2 = T(plane.weights[0] * T(plane.weights[0] * body.products[0][0] +
                                            T(2) * T(plane.weights[1] * body.products[0][1]))) +
                     T(T(plane.weights[1] * plane.weights[1]) * body.products[1][1]);
    return {s, T(kappa2 * on.square + s * s)};
}

/// 2 e·(d × dy)/|d|² for an end of the chord.
///
/// A is ∮ 2 e·(dy × d)/|d|² with d = y - e, if e is a point of the unit sphere outside of a part
/// with one rim that is traversed counterclockwise. e is one of the ends of the chord on the axis.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_beyond(BodyOnAxis<T, 3> const &body, MovingHalfPlane<T> const &plane,
                                   RimPoint<T> const &p, T const &turn,
                                   RowMask<T> const &is_upper) noexcept
{
    auto const on = point_on_body<is_ball>(body, plane, p);
    auto const end = chord_end(body, is_upper);
    auto const [s, distance2] = from_end<is_ball>(body, plane, p, on, end);
    T const h = T(end.side * body.half_chord);
    T const numerator = T(h * T(on.square * turn)) - T(s * p.drho - p.rho * on.ds) * on.twist -
                        T(T(s * p.rho) * on.twist_derivative);
    return T(T(numerator + numerator) / distance2);
}

/// The integrand for a part between two rims, which has neither end inside: the mean of the
/// integrands of area_beyond() with both ends. In closed form it is (f·m a + h² s k·m)/(a² - h²s²),
/// with m = y × dy, a = h² - f·ρg⊥, and with k, f, s and h of rim_frame.hpp. That form is taken
/// where the mean may be small: in the middle of the chord. Near its ends that form cancels.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_between(BodyOnAxis<T, 3> const &body, MovingHalfPlane<T> const &plane,
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
/// The integrand has a pole near the real axis if e is near the rim. So, where the rim is near an
/// end of the axis, e is the end that is farther from it. The integral is then the area on the
/// other side of the rim, and the rest of the whole surface is that of the side of e. A part
/// between two rims is what two caps leave of the whole surface. Both differences err by a few u of
/// the whole surface. They are taken only if the body is not much larger than the ball.
template <class Mask> struct AreaRule {
    Mask above, below; ///< true if that end of the common part of the axis is the body's
    Mask is_upper;     ///< true if the end e for one rim is the upper end
    Mask is_rest;      ///< true if the area is the rest of the surface

    PW85_MEMBER Mask has_two_rims() const noexcept { return are_equal(above, below); }
};

/// The largest volume of a body, in units of the ball, for which a part may be the rest of caps. An
/// error of u of the surface changes the volume by u times this, and the bound has 64 u.
inline constexpr double largest_volume_of_rest = 8.0;

template <class T> PW85_FUNCTION inline AreaRule<typename ScalarTraits<T>::Mask>
area_rule(RimFrame<T, 3> const &rim, int body) noexcept
{
    auto const [ball_above, ball_below] = rim.ends;
    auto const none = ball_above && !ball_above;
    if (body == 0) return {ball_above, ball_below, !ball_above, none};
    return {!ball_above, !ball_below, ball_above, none};
}

/// The area of the part of a body at one or two points, or of the rest of the surface with the
/// opposite sign.
template <bool is_ball, class T>
PW85_FUNCTION inline T area_integrand(BodyOnAxis<T, 3> const &body, MovingHalfPlane<T> const &plane,
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

/// The components of X × dX along ℓ × g1, ℓ × g2 and g1 × g2.
template <class T> PW85_FUNCTION inline Vector<T, 3>
swept(MovingHalfPlane<T> const &plane, RimPoint<T> const &p, T const &z, T const &speed) noexcept
{
    T const radial = z * p.drho - p.rho * p.dz, around = T(z * p.rho);
    return {radial * plane.weights[0] + around * plane.derivatives[0],
            radial * plane.weights[1] + around * plane.derivatives[1], T(T(p.rho * p.rho) * speed)};
}

/// A root for both half-planes of a pair.
template <class T>
PW85_FUNCTION inline RimRoot<TwoLanes<T>> in_lanes(RimRoot<T> const &root) noexcept
{
    return {TwoLanes<T>(root.q), TwoLanes<T>(root.square), root.up};
}

/// The numbers of a body for the two half-planes of a pair.
template <class T>
PW85_FUNCTION inline BodyOnAxis<TwoLanes<T>, 3> side_by_side(BodyOnAxis<T, 3> const &body) noexcept
{
    return converted_by<TwoLanes<T>>([](T const &x) { return TwoLanes<T>(x); }, body);
}

/// Data of all integrands: the rim, the common part of its axis, and both bodies for the two
/// half-planes of a pair, which are computed side by side. Packs of numbers need no copies of the
/// bodies.
template <class T> struct RimIntegration {
    struct Nothing {};
    static constexpr bool has_copies = ScalarTraits<T>::lanes == 1;
    using Two = TwoLanes<T>;
    using Mask = typename ScalarTraits<T>::Mask;

    RimFrame<T, 3> rim;
    std::conditional_t<has_copies, BodyOnAxis<Two, 3>, Nothing> bodies[2];
    AreaRule<typename ScalarTraits<T>::Mask> rules[2];

    PW85_MEMBER decltype(auto) numbers_of(int k) const noexcept
    {
        if constexpr (has_copies)
            return (bodies[k]);
        else
            return side_by_side(rim.bodies[k]);
    }

    /// Tests if both ends of the axis belong to one body.
    PW85_MEMBER Mask is_of_one_body() const noexcept
    {
        return are_equal(rim.ends.ball_above, rim.ends.ball_below);
    }

    PW85_MEMBER bool has_two_rims() const noexcept
    {
        if constexpr (may_have_two_rims<T>)
            return is_of_one_body();
        else
            return false;
    }

    /// Tests if the chords of the axis are disjoint and there is no rim. The ellipsoids then touch
    /// from outside to rounding, and the common part counts as empty.
    PW85_MEMBER Mask is_empty() const noexcept { return !is_of_one_body() && rim.least > T(0); }

    /// Tests whether there is no rim because both ends of the axis belong to one body and T is at
    /// most `least` in all half-planes. Up to rounding, this body is inside the other one.
    PW85_MEMBER Mask is_whole() const noexcept
    {
        return is_of_one_body() && rim.least > T(0) && !(rim.excess[0] > T(0)) &&
               !(rim.excess[1] > T(0));
    }

    PW85_MEMBER Mask has_no_rim() const noexcept { return is_empty() || is_whole(); }

    /// Returns the area of the whole body over 2π and the radius of the metric, or nothing for the
    /// other one, where there is no rim.
    PW85_MEMBER T area_without_rim(int body, T const &radius) const noexcept
    {
        return is_whole() && rim.ends.ball_above == (body == 0) ? T(T(2) * radius) : T(0);
    }

    /// Calls add(plane, points, speed) with both half-planes of a pair, and with those of its
    /// mirror image. These have the same roots.
    template <class Add> PW85_MEMBER void for_each(RimDirection<T> const &pair, bool has_image,
                                                   Add const &add) const noexcept
    {
        auto const both = rim_roots(rim, pair.excess);
        RimRoot<Two> const first = in_lanes(rim_root(both, 0));
        RimRoot<Two> const roots[2] = {first, has_two_rims() ? in_lanes(rim_root(both, 1)) : first};
        auto image = pair;
        image.direction.sine = -pair.direction.sine;
        for (int k = 0; k < (has_image ? 2 : 1); ++k) for_both(k == 0 ? pair : image, roots, add);
    }

    /// Calls add(plane, points, speed) with both half-planes of a pair.
    template <class Add> PW85_MEMBER void for_both(RimDirection<T> const &pair,
                                                   RimRoot<Two> const (&roots)[2],
                                                   Add const &add) const noexcept
    {
        T const c = pair.direction.cosine, s = pair.direction.sine;
        Two const speed(T(T(pair.pace * T(rim.excess[1] - rim.excess[0])) * T(c * s)));
        Two const x(c, -c), y(s, -s), w(pair.weight), tilt(rim.tilt), half_chord(rim.half_chord);
        Two const heading0(rim.heading[0]), heading1(rim.heading[1]);
        Two const v0 = heading0 + x, v1 = heading1 + y;
        Two const turn = tilt * w * (v0 * heading1 - v1 * heading0);
        Two const lift = Two(rim.clearance) + Two(T(0.5)) * tilt * (v0 * v0 + v1 * v1);
        MovingHalfPlane<Two> const plane{{x, y}, {-(w * y), w * x}, lift, turn};
        RimPoint<Two> points[2] = {rim_point(roots[0], speed, plane, half_chord), {}};
        points[1] = has_two_rims() ? rim_point(roots[1], -speed, plane, half_chord) : points[0];
        add(plane, points, w);
    }

    /// Returns the areas A1 and, over the radius of the metric, A2.
    template <int k> PW85_MEMBER T area(MovingHalfPlane<Two> const &plane,
                                        RimPoint<Two> const (&points)[2],
                                        Two const &speed) const noexcept
    {
        // a copy of the code for the ball takes 28 kB of wider numbers
        constexpr bool is_ball = k == 0 && std::is_floating_point_v<typename ScalarTraits<T>::Lane>;
        return sum_of_lanes(area_integrand<is_ball>(numbers_of(k), plane, points, speed, rules[k]));
    }

    /// Summand that completes the mean of area(): the area of a whole sphere of this radius over 2π
    /// and the radius, or nothing.
    PW85_MEMBER T whole(int body, T const &radius) const noexcept
    {
        return select(rules[body].is_rest, T(T(2) * radius), T(0));
    }

    /// Returns the least squared distance of an end of a body from the rim in the planes of the
    /// vertices.
    PW85_MEMBER T distance_from_end(int body, int side) const noexcept
    {
        T least = T(64); // above the square of a diameter of bodies of this volume
        for (int vertex = 0; vertex < 2; ++vertex) {
            RimDirection<T> const pair{{T(1 - vertex), T(vertex)}, T(0), T(0), rim.excess[vertex]};
            for_each(pair, false,
                     [&](MovingHalfPlane<Two> const &plane, RimPoint<Two> const(&points)[2],
                         Two const &) {
                         auto const on = point_on_body<false>(bodies[body], plane, points[0]);
                         auto const end = chord_end(bodies[body], side > 0);
                         Two const distance2 =
                             from_end<false>(bodies[body], plane, points[0], on, end).distance2;
                         least = minimum(least, minimum(first_of(distance2), second_of(distance2)));
                     });
        }
        return least;
    }

    /// Takes the ends that are farther from a rim that is near an end of the axis.
    PW85_MEMBER void take_farther_ends(int body) noexcept
    {
        auto &rule = rules[body];
        if (rule.has_two_rims()) {
            rule.is_rest = !rule.above;
            return;
        }
        rule.is_upper = distance_from_end(body, 1) > distance_from_end(body, -1);
        rule.is_rest = rule.above == rule.is_upper;
    }
};

template <class T> PW85_FUNCTION inline RimIntegration<T>
rim_integration(JointFrame<T, 3> const &frame, RimFrame<T, 3> const &rim) noexcept
{
    RimIntegration<T> integration{rim, {}, {area_rule(rim, 0), area_rule(rim, 1)}};
    if constexpr (RimIntegration<T>::has_copies)
        for (int k = 0; k < 2; ++k) integration.bodies[k] = side_by_side(rim.bodies[k]);
    if constexpr (ScalarTraits<T>::lanes == 1)
        if (!is_rim_apart_from_ends(rim)) {
            integration.take_farther_ends(0);
            if (T(T(frame.axes[0] * frame.axes[1]) * frame.axes[2]) <= T(largest_volume_of_rest))
                integration.take_farther_ends(1);
        }
    return integration;
}

template <class T>
PW85_FUNCTION inline RimIntegration<T> rim_integration(JointFrame<T, 3> const &frame) noexcept
{
    return rim_integration(frame, accurate_rim_frame(frame));
}

/// The fraction of a scale by which numbers differ; 0 if this is below `floor`, which is what
/// rounding errors may do.
template <class T>
PW85_FUNCTION inline T fraction_of(T const &difference, T const &scale, T const &floor) noexcept
{
    return select(difference <= floor, T(0), T(difference / scale));
}

/// A change of 3V by this much, with the ball as unit, is below rounding: V changes by less than 22
/// u, which is below 6 u v.
template <class T> PW85_FUNCTION constexpr T rim_integral_floor() noexcept
{
    return T(T(64) * negative_power_of_two<T>(result_digits<T>()));
}

/// The change of all terms by a rule, as a fraction of both areas: the error of V may be one, as
/// the sensitivity is above half of their sum. Where one area is less than a 64th of both, its
/// change counts as a fraction of 64 times itself. It converges at a rate of its own, which the
/// changes of the other terms do not show: A1 of the end of a huge disc in a ball is 10⁻⁹ of D A2.
template <class T> PW85_FUNCTION inline T
fraction_of_areas(T const (&areas)[2], T const (&changes)[2], T const &rest) noexcept
{
    T const floor = rim_integral_floor<T>(), a = absolute(areas[0]), b = absolute(areas[1]);
    T const all = fraction_of(T(T(changes[0] + changes[1]) + rest), T(a + b), floor);
    return maximum(all, maximum(fraction_of(changes[0], T(T(64) * a), floor),
                                fraction_of(changes[1], T(T(64) * b), floor)));
}

/// 3V over 2π as the sum of A1, D A2 and c·N2, in this order.
///
/// The cone over P1 has the volume A1/3, and the cone over P2 has D A2/3 with the determinant D of
/// the metric. As 3V = ∮ x·n dA, 3V = A1 + D A2 + c·∫ n dA over P2. By Stokes' theorem ∫ n dA = ½ ∮
/// x × dx, and P1 has the opposite orientation.
///
/// If a point X of the rim is off by δ, this V is the volume of a body that differs by a sliver of
/// width and thickness of the order δ. So V errs by a term of the order δ² only.
template <class T> struct VolumeTerms {
    T terms[3];
    bool converged;
};

/// The integrands of the terms.
template <class T> struct VolumeIntegrands {
    using Two = TwoLanes<T>;

    RimIntegration<T> const &integration;
    T scale, sign; ///< D over the radius of the metric, and ½ with the sign of the flux
    Vector<Two, 3> flux;

    PW85_MEMBER static T change(RimSums<T, 3> const &x, RimSums<T, 3> const &y) noexcept
    {
        auto const of = [&](int i) { return absolute(T(x.numbers[i] - y.numbers[i])); };
        return fraction_of_areas({x.numbers[0], x.numbers[1]}, {of(0), of(1)}, of(2));
    }
};

/// Adds the integrands at both half-planes of a pair, and at those of its mirror image. The
/// function is not a member: Clang gives the symbol of a lambda in a member to the whole program.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline void
add_integrands(VolumeIntegrands<T> const &integrands, RimDirection<T> const &pair, bool has_image,
               RimSums<T, 3> &sums) noexcept
{
    using Two = TwoLanes<T>;
    auto const &integration = integrands.integration;
    integration.for_each(
        pair, has_image,
        [&](MovingHalfPlane<Two> const &plane, RimPoint<Two> const(&points)[2], Two const &speed) {
            sums.numbers[0] = sums.numbers[0] + integration.template area<0>(plane, points, speed);
            sums.numbers[1] = sums.numbers[1] +
                              integrands.scale * integration.template area<1>(plane, points, speed);
            Two flow = dot(integrands.flux, swept(plane, points[0], points[0].z, speed));
            if (integration.has_two_rims())
                flow = flow - dot(integrands.flux, swept(plane, points[1], points[1].z, speed));
            sums.numbers[2] = sums.numbers[2] + integrands.sign * sum_of_lanes(flow);
        });
}

template <class T> PW85_FUNCTION inline VolumeIntegrands<T>
volume_integrands(Vector<T, 3> const &axes, Vector<T, 3> center,
                  RimIntegration<T> const &integration) noexcept
{
    using Two = TwoLanes<T>;
    auto const &rim = integration.rim;
    for (int i = 0; i < 3; ++i) center[i] = axes[i] * center[i];
    return {integration,
            T(axes[0] * axes[1]),
            select(rim.ends.ball_above, T(-0.5), T(0.5)),
            {Two(dot(center, cross(rim.direction, rim.rays[0]))),
             Two(dot(center, cross(rim.direction, rim.rays[1]))),
             Two(dot(center, cross(rim.rays[0], rim.rays[1])))}};
}

template <class T> PW85_FUNCTION inline VolumeTerms<T>
volume_terms(JointFrame<T, 3> const &frame, RimIntegration<T> const &integration) noexcept
{
    auto const &rim = integration.rim;
    auto const integrands = volume_integrands(frame.axes, frame.center, integration);
    if (integration.has_no_rim())
        return {{integration.area_without_rim(0, T(1)),
                 integrands.scale * integration.area_without_rim(1, frame.axes[2]), T(0)},
                true};
    auto const add = [&](RimDirection<T> const &pair, bool has_image, RimSums<T, 3> &sums) {
        add_integrands(integrands, pair, has_image, sums);
    };
    auto const change = [&](RimSums<T, 3> const &x, RimSums<T, 3> const &y) {
        return integrands.change(x, y);
    };
    auto const [means, converged] = mean_over_half_planes<T, 3>(elliptic_rule(rim), add, change);
    return {{means.numbers[0] + integration.whole(0, T(1)),
             means.numbers[1] + integrands.scale * integration.whole(1, frame.axes[2]),
             means.numbers[2]},
            converged};
}

/// The largest distance of the centres over the fourth power of half of the length of the axis,
/// with the ball as unit, up to which c·∫ n dA is computed by the digits of the result. Components
/// of the area vector err by about u/2, also those that are small, and by more on a short axis
/// inside the ball, as the rim does (largest_distance_of_rim). So the product errs by about u
/// |c|/2, which the sensitivity need not cover. As 3V of the ball is 2 in units of 2π, 32 u is a
/// quarter of the part of the bound that does not depend on the pair, 64 u v.
inline constexpr double largest_distance_of_integrals = 64.0;

/// Tests whether the digits of the result are enough for the integrals.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
are_integrals_accurate(JointFrame<T, 3> const &frame, RimIntegration<T> const &integration) noexcept
{
    T const square = T(integration.rim.half_chord * integration.rim.half_chord);
    return distance_of_centers(frame) <= T(T(largest_distance_of_integrals) * T(square * square));
}

/// 3V over 2π; NaN if the integrals have not converged.
template <class T> PW85_FUNCTION inline T
sum_of_terms(JointFrame<T, 3> const &frame, RimIntegration<T> const &integration) noexcept
{
    auto const [terms, converged] = volume_terms(frame, integration);
    T const sum = T(T(terms[0] + terms[1]) + terms[2]);
    return converged ? sum : quiet_nan<T>();
}

/// The axis of a pair whose centre is off by four roundoffs, which stands for the roundings of h.
template <class T> PW85_FUNCTION inline RimAxis<T, 3> rounded_axis(JointFrame<T, 3> frame) noexcept
{
    frame.center = T(T(1) + T(T(4) * T(unit_roundoff<T>()))) * frame.center;
    return rim_axis(pencil(frame));
}

/// The sum by that axis and the bodies of the frame. It is not inlined, because of its memory.
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T sum_by_rounded_axis(JointFrame<T, 3> const &frame) noexcept
{
    return sum_of_terms(frame, rim_integration(frame, rim_frame(frame, rounded_axis(frame))));
}

/// The distance of the centres, with the ball as unit, up to which one sum by twice the digits is
/// enough, also over the fourth power of half of the length of the axis in units of u/ε = 2^51.
///
/// Where the surfaces touch except for a depth δ, and cross elsewhere, h⁴ is of the order of δ. D
/// A2 and c·∫ n dA each lose ε c/h⁴ of the areas, and do not lose the same. In a search of pairs
/// with c to 1024 and δ from 10⁻¹² to 10⁻²⁴, with 38 digits as truth, the error was at most 0.044 c
/// ε/(u h⁴) of the bound. So it is at most 0.53 of the bound up to the second limit, and was up to
/// 112 times the bound beyond it.
inline constexpr double largest_distance_of_one_sum = 1024.0, largest_distance_of_short_axis = 12.0;

/// Tests whether one sum by twice the digits is enough.
template <class T> PW85_FUNCTION inline bool is_one_sum_enough(JointFrame<T, 3> const &frame,
                                                               T const &half_chord) noexcept
{
    T const distance = distance_of_centers(frame), square = T(half_chord * half_chord),
            lost = negative_power_of_two<T>(mantissa_digits<T>() - result_digits<T>());
    return distance <= T(largest_distance_of_one_sum) &&
           T(lost * distance) <= T(T(largest_distance_of_short_axis) * T(square * square));
}

/// The sum for a pair whose centre is moved, times 1 + `part`; NaN if one sum is not enough there.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline T
sum_of_moved_pair(JointFrame<T, 3> frame, T const &part) noexcept
{
    frame.center = T(T(1) + part) * frame.center;
    auto const integration = rim_integration(frame);
    if (!is_one_sum_enough(frame, integration.rim.half_chord)) return quiet_nan<T>();
    return sum_of_terms(frame, integration);
}

/// The mean of the sums for pairs whose centres are moved to both sides, where the surfaces nearly
/// touch. They are moved by 2^-33 for doubles, and h⁴ is of this order there. By its second
/// derivative, which grows as the logarithm of the depth, 3V changes by some 2^-66 times the
/// distance.
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T mean_of_moved_pairs(JointFrame<T, 3> const &frame) noexcept
{
    T const part =
        T(negative_power_of_two<T>(5 * result_digits<T>() / 8) / distance_of_centers(frame));
    return T(T(0.5) * T(sum_of_moved_pair(frame, part) + sum_of_moved_pair(frame, T(-part))));
}

/// 3V over 2π by twice the digits of the result; NaN if these are not enough.
///
/// The terms cancel for a large body, and the vertices lose digits where its section in the ball is
/// thin. So the sum is computed again by an axis that is off by what roundings do, with the same
/// bodies. It may change by a quarter of what the bound is at least: the bound is u (128 + 24 (A1 +
/// D A2)) in these units, as s is above half of the areas.
template <class T> PW85_FUNCTION inline T
resolved_sum_of_terms(JointFrame<T, 3> const &frame, RimIntegration<T> const &integration) noexcept
{
    auto const [terms, converged] = volume_terms(frame, integration);
    T const areas = T(terms[0] + terms[1]), sum = T(areas + terms[2]);
    if (!converged) return quiet_nan<T>();
    if (is_one_sum_enough(frame, integration.rim.half_chord)) return sum;
    if (distance_of_centers(frame) <= T(largest_distance_of_one_sum))
        return mean_of_moved_pairs(frame);
    T const change = absolute(T(sum - sum_by_rounded_axis(frame)));
    T const u = negative_power_of_two<T>(result_digits<T>());
    return change <= T(u * T(T(32) + T(6) * areas)) ? sum : quiet_nan<T>();
}

} // namespace pw85::detail

#endif
