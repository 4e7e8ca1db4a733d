// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Integrals along the rim, which give the volume of the intersection. This file has the points of
/// the rim in a pair of opposite half-planes (rim_points.hpp), and the integrands at these points:
/// those of the areas of the parts of both surfaces (rim_areas.hpp), and X × dX. common_volume.hpp
/// and overlap_volume_derivatives.hpp use this file.
///
/// The pair is in its joint frame. P1 and P2 are the parts of the surfaces of the ball and of the
/// other body that bound the intersection.
#ifndef PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED
#define PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED

#include <pw85/volume/rim_areas.hpp>
#include <pw85/volume/rim_frame.hpp>
#include <pw85/volume/rule_ladder.hpp>

namespace pw85::detail {

/// The components of X × dX along ℓ × g1, ℓ × g2 and g1 × g2.
template <class T> PW85_FUNCTION inline Vector<T, 3>
swept(MovingHalfPlane<T> const &plane, RimPoint<T> const &p, T const &z, T const &speed) noexcept
{
    T const radial = z * p.drho - p.rho * p.dz, around = T(z * p.rho);
    return {radial * plane.weights[0] + around * plane.derivatives[0],
            radial * plane.weights[1] + around * plane.derivatives[1], T(T(p.rho * p.rho) * speed)};
}

/// The roots of αZ² - TZ + γ = 0, each as a ratio, the larger one first, without cancellation. If
/// rounding errors leave no real root, both roots are set to the double root, for which the rim
/// touches itself.
template <class T> struct RimRoots {
    T numerators[2], denominators[2];
};

/// `excess` is T minus `least` of the rim.
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

/// A root for both half-planes of a pair.
template <class T>
PW85_FUNCTION inline RimRoot<TwoLanes<T>> in_lanes(RimRoot<T> const &root) noexcept
{
    return {TwoLanes<T>(root.q), TwoLanes<T>(root.square), root.up};
}

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

/// Data that all integrands use: the rim, the segment of its axis inside both bodies, and copies of
/// both bodies for the two half-planes of a pair, which are computed at the same time. Packs of
/// numbers need no copies of the bodies.
template <class T> struct RimIntegration {
    struct Nothing {};
    static constexpr bool has_copies = ScalarTraits<T>::lanes == 1;
    using Two = TwoLanes<T>;
    using Mask = typename ScalarTraits<T>::Mask;

    RimFrame<T> rim;
    std::conditional_t<has_copies, BodyOnAxis<Two>, Nothing> bodies[2];
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

    /// Tests whether there is no rim because both ends of the axis belong to one body and T is at
    /// most `least` in all half-planes. Up to rounding, this body is inside the other one.
    PW85_MEMBER Mask is_whole() const noexcept
    {
        return is_of_one_body() && rim.least > T(0) && !(rim.excess[0] > T(0)) &&
               !(rim.excess[1] > T(0));
    }

    /// Tests whether there is no rim, because one body is inside the other one, or because the
    /// chords of the axis are disjoint. In the second case the ellipsoids touch from outside up to
    /// rounding, and the intersection counts as empty.
    PW85_MEMBER Mask has_no_rim() const noexcept
    {
        return is_whole() || (!is_of_one_body() && rim.least > T(0));
    }

    /// If there is no rim, returns the whole area of a body over 2π and the radius of the metric if
    /// the body is inside the other one, and 0 otherwise.
    PW85_MEMBER T area_without_rim(int body, T const &radius) const noexcept
    {
        return is_whole() && rim.ends.ball_above == (body == 0) ? T(T(2) * radius) : T(0);
    }

    /// Calls add(plane, points, speed) with both half-planes of a pair, and with those of its
    /// mirror image, which has the same roots.
    template <class Add> PW85_MEMBER void for_each(RimDirection<T> const &pair, bool has_image,
                                                   Add const &add) const noexcept
    {
        T const c = pair.direction.cosine;
        Two const w(pair.weight), tilt(rim.tilt), half_chord(rim.half_chord);
        Two const heading0(rim.heading[0]), heading1(rim.heading[1]);
        auto const both = rim_roots(rim, pair.excess);
        RimRoot<Two> const root = in_lanes(rim_root(both, 0)),
                           other = has_two_rims() ? in_lanes(rim_root(both, 1)) : root;
        for (int k = 0; k < (has_image ? 2 : 1); ++k) {
            T const s = k == 0 ? pair.direction.sine : T(-pair.direction.sine);
            Two const speed(T(T(pair.pace * T(rim.excess[1] - rim.excess[0])) * T(c * s)));
            Two const x(c, -c), y(s, -s);
            Two const v0 = heading0 + x, v1 = heading1 + y;
            Two const turn = tilt * w * (v0 * heading1 - v1 * heading0);
            Two const lift = Two(rim.clearance) + Two(T(0.5)) * tilt * (v0 * v0 + v1 * v1);
            MovingHalfPlane<Two> const plane{{x, y}, {-(w * y), w * x}, lift, turn};
            RimPoint<Two> points[2] = {rim_point(root, speed, plane, half_chord), {}};
            points[1] = has_two_rims() ? rim_point(other, -speed, plane, half_chord) : points[0];
            add(plane, points, w);
        }
    }

    /// Returns the areas A1 and, over the radius of the metric, A2.
    template <int k> PW85_MEMBER T area(MovingHalfPlane<Two> const &plane,
                                        RimPoint<Two> const (&points)[2],
                                        Two const &speed) const noexcept
    {
        // a separate copy of the code for the ball would take 28 kB for wider types
        constexpr bool is_ball = k == 0 && std::is_floating_point_v<typename ScalarTraits<T>::Lane>;
        return sum_of_lanes(area_integrand<is_ball>(numbers_of(k), plane, points, speed, rules[k]));
    }

    /// Returns the term to add to the mean of area(): the area of a whole sphere of this radius
    /// over 2π and the radius if area() integrates over the rest of the surface, and 0 otherwise.
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
            for_each(
                pair, false,
                [&](MovingHalfPlane<Two> const &plane, RimPoint<Two> const(&points)[2],
                    Two const &) {
                    auto const on = point_on_body<false>(bodies[body], plane, points[0]);
                    Two const distance2 =
                        from_end<false>(bodies[body], plane, points[0], on, side > 0).distance2;
                    least = minimum(least, minimum(first_of(distance2), second_of(distance2)));
                });
        }
        return least;
    }

    /// For a rim that is near an end of the axis, chooses the ends e (AreaRule) that are farther
    /// from it.
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

/// The largest volume of a body, in units of the ball, for which the area of a part may be computed
/// as the whole surface minus caps. A relative error u of the whole surface changes the volume by u
/// times this limit. The bound has 64 u.
inline constexpr double largest_volume_of_rest = 8.0;

template <class Mask>
PW85_FUNCTION inline AreaRule<Mask> area_rule(AxisEnds<Mask> const &ends, int body) noexcept
{
    auto const [ball_above, ball_below] = ends;
    auto const none = are_equal(ball_above, !ball_above);
    if (body == 0) return {ball_above, ball_below, !ball_above, none};
    return {!ball_above, !ball_below, ball_above, none};
}

template <class T> PW85_FUNCTION inline RimIntegration<T>
rim_integration(JointFrame<T, 3> const &frame, RimFrame<T> const &rim) noexcept
{
    RimIntegration<T> integration{rim, {}, {area_rule(rim.ends, 0), area_rule(rim.ends, 1)}};
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

/// Not inlined, so that the frame of the rim is not in the stack frame of the caller, which
/// computes the sum.
template <class T>
PW85_FUNCTION inline RimIntegration<T> rim_integration(JointFrame<T, 3> const &frame) noexcept
{
    return rim_integration(frame, accurate_rim_frame(frame));
}

/// The three terms of 3V over 2π: A1, D A2 and c·N2, in this order.
///
/// The cone over P1 has the volume A1/3, and the cone over P2 has D A2/3 with the determinant D of
/// the metric. As 3V = ∮ x·n dA, 3V = A1 + D A2 + c·∫ n dA over P2. By Stokes' theorem ∫ n dA = ½ ∮
/// x × dx, and P1 has the opposite orientation.
///
/// If a point X of the rim has an error δ, the computed V is the volume of a body that differs from
/// the intersection by a sliver. Its width and thickness are of the order δ, so the error of V is
/// only O(δ²).
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
};

/// Adds the integrands at both half-planes of a pair, and at those of its mirror image. The
/// function is not a member, because Clang gives external linkage to lambdas in members.
template <class T> PW85_FUNCTION inline void add_integrands(VolumeIntegrands<T> const &integrands,
                                                            RimDirection<T> const &pair,
                                                            bool has_image,
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
    T const units[3] = {T(1), T(1), T(1)};
    auto const [means, converged] = mean_over_half_planes<3>(elliptic_rule(rim), integrands, units);
    return {{means.numbers[0] + integration.whole(0, T(1)),
             means.numbers[1] + integrands.scale * integration.whole(1, frame.axes[2]),
             means.numbers[2]},
            converged};
}

} // namespace pw85::detail

#endif
