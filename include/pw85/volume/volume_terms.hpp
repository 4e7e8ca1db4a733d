// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the common part by integrals along the rim (rim_integrals.hpp), for
/// overlap_volume.hpp: three terms, tests whether the digits of a number are enough for them, and
/// their sum by twice the digits where they are not.
#ifndef PW85_VOLUME_VOLUME_TERMS_HPP_INCLUDED
#define PW85_VOLUME_VOLUME_TERMS_HPP_INCLUDED

#include <pw85/volume/rim_integrals.hpp>
#include <pw85/volume/rule_ladder.hpp>

namespace pw85::detail {

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
template <class T> PW85_FUNCTION inline RimAxis<T> rounded_axis(JointFrame<T, 3> frame) noexcept
{
    frame.center = T(T(1) + T(T(4) * T(unit_roundoff<T>()))) * frame.center;
    return rim_axis(frame);
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
