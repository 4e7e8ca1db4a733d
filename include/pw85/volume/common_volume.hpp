// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the intersection in the joint frame, for overlap_volume.hpp: tests whether the
/// digits of the type suffice for the integrals along the rim (rim_integrals.hpp), and their sum
/// with twice the digits where they do not.
#ifndef PW85_VOLUME_COMMON_VOLUME_HPP_INCLUDED
#define PW85_VOLUME_COMMON_VOLUME_HPP_INCLUDED

#include <pw85/algebra/unit_ball.hpp>
#include <pw85/volume/rim_integrals.hpp>

namespace pw85::detail {

/// The largest distance of the centres over the fourth power of half of the length of the axis,
/// with the ball as unit, up to which c·∫ n dA is computed with the digits of the result. The error
/// of each component of the area vector ∫ n dA is about u/2, also if the component is small. It is
/// larger if the axis inside the ball is short, as for the rim (largest_distance_of_rim). So the
/// error of the product is about u |c|/2, which the terms of the bound that depend on the pair do
/// not always cover. At the limit it is 32 u. As 3V of the ball is 2 in units of 2π, this is a
/// quarter of 64 u v, the term of the bound that does not depend on the pair.
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

/// The axis of a pair whose centre is moved by four roundoffs: a change as large as the rounding
/// errors of h.
template <class T> PW85_FUNCTION inline RimAxis<T> rounded_axis(JointFrame<T, 3> frame) noexcept
{
    frame.center = T(T(1) + T(T(4) * T(unit_roundoff<T>()))) * frame.center;
    return rim_axis(frame);
}

/// The sum with the axis of rounded_axis() and the bodies of the frame. Not inlined, to keep its
/// arrays out of the stack frame of the caller.
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T sum_by_rounded_axis(JointFrame<T, 3> const &frame) noexcept
{
    return sum_of_terms(frame, rim_integration(frame, rim_frame(frame, rounded_axis(frame))));
}

/// Limits up to which one sum with twice the digits is enough: of the distance c of the centres,
/// with the radius of the ball as unit; and of c/h⁴ in units of u/ε = 2^51, with half the length h
/// of the axis and the roundoff ε of twice the digits.
///
/// Where the surfaces touch except for a depth δ, and cross elsewhere, h⁴ is of the order of δ. D
/// A2 and c·∫ n dA each have an error of ε c/h⁴ times the areas, and these errors do not cancel. In
/// a search of pairs with c up to 1024 and δ from 10⁻¹² to 10⁻²⁴, with 38 digits as truth, the
/// error was at most 0.044 c ε/(u h⁴) times its bound. So it is at most 0.53 times the bound up to
/// the second limit. Beyond this limit it was up to 112 times the bound.
inline constexpr double largest_distance_of_one_sum = 1024.0, largest_distance_of_short_axis = 12.0;

/// Tests whether one sum with twice the digits is enough.
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
/// touch. They are moved by 2^-33 for doubles, and h⁴ is of this order there. The second derivative
/// of 3V grows as the logarithm of the depth, so the mean differs from 3V by about 2^-66 times the
/// distance.
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T mean_of_moved_pairs(JointFrame<T, 3> const &frame) noexcept
{
    T const part =
        T(negative_power_of_two<T>(5 * result_digits<T>() / 8) / distance_of_centers(frame));
    return T(T(0.5) * T(sum_of_moved_pair(frame, part) + sum_of_moved_pair(frame, T(-part))));
}

/// 3V over 2π, computed with twice the digits of the result; NaN if these do not suffice.
///
/// The terms cancel for a large body, and the vertices lose digits where its section in the ball is
/// thin. So the sum is computed again with the same bodies and an axis that is moved by about its
/// rounding error. The sum may change by at most a quarter of the least value of the bound. This
/// least value is u (128 + 24 (A1 + D A2)) in these units, because s is above half of the areas.
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

/// A volume or area, and a flag: true if the digits of the type suffice for it.
template <class T> struct CheckedMeasure {
    T measure;
    bool is_accurate;
};

/// The volume of the intersection from 3V over 2π.
template <class T> PW85_FUNCTION inline T part_of_sum(T const &sum) noexcept
{
    T const third = maximum(T(sum / T(3)), T(0));
    return T(T(T(2) * circle_constant<T>()) * third);
}

/// The volume of the intersection in the joint frame; NaN if the integral has not converged. Not
/// inlined, so that its arrays and those of the exact decisions share the stack.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline CheckedMeasure<ResultOf<T>>
common_measure(JointFrame<T, 3> const &frame) noexcept
{
    using Result = ResultOf<T>;
    auto const integration = rim_integration(frame);
    if constexpr (std::is_floating_point_v<T>)
        if (!are_integrals_accurate(frame, integration)) return {quiet_nan<Result>(), false};
    Result const sum =
        rounded(std::is_same_v<T, Result> ? sum_of_terms(frame, integration)
                                          : resolved_sum_of_terms(frame, integration));
    if (!(absolute(sum) < infinity<Result>())) return {quiet_nan<Result>(), true};
    return {part_of_sum(sum), true};
}

} // namespace pw85::detail

#endif
