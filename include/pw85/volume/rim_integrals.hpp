// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The integrands along the rim in a pair of opposite half-planes: the areas of both bodies' parts
/// (rim_areas.hpp) and X × dX. volume_terms.hpp and overlap_volume_derivatives.hpp sum them over
/// half-planes (elliptic_rule.hpp, rule_ladder.hpp).
///
/// The pair is in its joint frame. P1 and P2 are the parts of the surfaces of the ball and of the
/// other body that bound the common part.
#ifndef PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED
#define PW85_VOLUME_RIM_INTEGRALS_HPP_INCLUDED

#include <pw85/algebra/two_doubled.hpp>
#include <pw85/volume/elliptic_rule.hpp>
#include <pw85/volume/rim_areas.hpp>
#include <pw85/volume/rim_frame.hpp>

namespace pw85::detail {

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
PW85_FUNCTION inline BodyOnAxis<TwoLanes<T>> side_by_side(BodyOnAxis<T> const &body) noexcept
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
    /// chords of the axis are disjoint. The ellipsoids then touch from outside to rounding, and the
    /// common part counts as empty.
    PW85_MEMBER Mask has_no_rim() const noexcept
    {
        return is_whole() || (!is_of_one_body() && rim.least > T(0));
    }

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

/// The frame of the rim is not in the memory of the caller, which computes the sum.
template <class T>
PW85_FUNCTION inline RimIntegration<T> rim_integration(JointFrame<T, 3> const &frame) noexcept
{
    return rim_integration(frame, accurate_rim_frame(frame));
}

} // namespace pw85::detail

#endif
