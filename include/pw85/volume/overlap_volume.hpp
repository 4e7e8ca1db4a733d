// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the common part of two ellipsoids, and the area of that of two ellipses. pw85.hpp and the C API call them.
///
/// Whether there is a common part, and whether it is a whole ellipsoid, is decided without rounding errors (overlap/). Otherwise the pair
/// is taken to its joint frame (joint_frame.hpp), and the common part is cut by half-planes through the axis of its rim
/// (rim_axis.hpp). Each section is a sum of positive parts in closed form (section.hpp). Two sections make up an area. A volume is the integral
/// of their first moments, which converges geometrically (elliptic_rule.hpp).
#ifndef PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED

#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/volume/elliptic_rule.hpp>
#include <pw85/volume/volume.hpp>

namespace pw85::detail {

/// What two ellipsoids have in common: nothing, one of them as a whole, or a part of each.
enum class CommonPart { nothing, first, second, part };

/// The status of a pair, and what it has in common. Only an ellipsoid that is not clearly the larger one can be inside.
struct CommonPartDecision {
    CommonPart part;
    StatusCode status;
};

template <class T, int D> PW85_FUNCTION inline CommonPartDecision
decide_common_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const [overlaps, tier, status] = overlap(r12, q1, q2);
    if (status != StatusCode::success || !overlaps) return {CommonPart::nothing, status};
    auto const second = contains(r12, q1, q2);
    if (second.status != StatusCode::success) return {CommonPart::nothing, second.status};
    if (second.contains) return {CommonPart::second, status};
    auto const first = contains(-r12, q2, q1);
    return {first.contains ? CommonPart::first : CommonPart::part, first.status};
}

/// The mean of sections, for mean_over_half_planes(). The volume needs the sum of two of its four numbers. The others are there so that
/// the means agree by chance only if all four do.
template <class T> struct MeanSection {
    T volume, numbers[4];

    PW85_MEMBER void add(T const &weight, SectionParts<T> const &section) noexcept
    {
        T const values[] = {section.ball.rho, section.other.rho, section.ball.area, section.other.area};
        volume = volume + weight * T(values[0] + values[1]);
        for (int i = 0; i < 4; ++i) numbers[i] = numbers[i] + weight * values[i];
    }
    PW85_MEMBER MeanSection over(T const &count) const noexcept
    {
        MeanSection mean{volume / count, {}};
        for (int i = 0; i < 4; ++i) mean.numbers[i] = numbers[i] / count;
        return mean;
    }
};

template <class T>
PW85_FUNCTION inline bool agree(MeanSection<T> const &x, MeanSection<T> const &y, T const &tolerance) noexcept
{
    bool yes = true;
    for (int i = 0; i < 4; ++i)
        yes = yes && absolute(T(x.numbers[i] - y.numbers[i])) <= T(tolerance * T(x.numbers[i & 2] + x.numbers[i | 1]));
    return yes;
}

/// The measure of the common part in the joint frame; in space over 2π.
template <class T> PW85_FUNCTION inline T common_measure(RimFrame<T, 2> const &rim) noexcept
{
    auto const interval = axis_interval(rim);
    T sum = T(0);
    for (int side = -1; side < 2; side += 2) {
        auto const [ball, other] = section(rim, interval, HalfPlane<T, 2>{{T(side)}});
        sum = sum + T(ball.area + other.area);
    }
    return T(rim.half_chord * sum);
}

template <class T> PW85_FUNCTION inline T common_measure(RimFrame<T, 3> const &rim) noexcept
{
    auto const interval = axis_interval(rim);
    auto const mean = mean_over_half_planes<MeanSection<T>>(
        elliptic_rule(rim), [&](HalfPlane<T, 3> const &half_plane) { return section(rim, interval, half_plane); });
    return T(rim.half_chord * mean.volume);
}

/// The measure of a part, in its unit and over 2π in space, and the length of the axis in the ball.
template <class T> struct PartMeasure {
    T measure, half_chord;
    int exponent;
    bool swapped;
};

template <class T, int D> PW85_FUNCTION inline PartMeasure<T>
measure_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const frame = joint_frame(r12, q1, q2);
    auto const axis = rim_axis(pencil(frame));
    bool const is_thin = !(frame.axes[std::size_t(D - 1)] >= thinnest_axis<T>());
    T const measure = is_thin ? quiet_nan<T>() : T(common_measure(rim_frame(frame, axis)) * frame.determinant);
    return {measure, axis.half_chord, frame.exponent, frame.swapped};
}

/// Where a rim nearly touches itself, two vertices nearly coincide on the sphere, and the axis leaves the ball: its length in it goes to zero as
/// the fourth root of the distance from touching. Below this length more digits are needed.
inline constexpr double shortest_axis = 0.25;

/// The same with twice the digits.
template <class T, int D>
PW85_RARE PartMeasure<T> measure_part_finely(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                             SymmetricMatrix<T, D> const &q2, int exponent) noexcept
{
    using Fine = Finer<T>;
    auto const fine = measure_part(converted<Fine>(times_power_of_two(r12, -exponent)),
                                   converted<Fine>(times_power_of_two(q1, -2 * exponent)),
                                   converted<Fine>(times_power_of_two(q2, -2 * exponent)));
    return {rounded(fine.measure), rounded(fine.half_chord), fine.exponent, fine.swapped};
}

#define PW85_RARE_COMMON_PART(rare, T, D)                                                                              \
    rare(measure_part_finely,                                                                                          \
         (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2, int exponent),    \
         (r12, q1, q2, exponent))
PW85_RARE_TIER(PW85_RARE_COMMON_PART)

/// The measure of the common part, for any pair. It is at most that of the smaller ellipsoid.
template <class T, int D> struct CommonMeasure {
    T measure;
    StatusCode status;
};

template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonMeasure<T, D>
measure_common_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const [part, status] = decide_common_part(r12, q1, q2);
    if (status != StatusCode::success) return {quiet_nan<T>(), status};
    if (part == CommonPart::nothing) return {T(0), status};
    if (part != CommonPart::part) return {measure_of(part == CommonPart::first ? q1 : q2), status};
    int const e = half_exponent(largest_diagonal(q1));
    auto measured =
        measure_part(times_power_of_two(r12, -e), times_power_of_two(q1, -2 * e), times_power_of_two(q2, -2 * e));
    if constexpr (std::is_floating_point_v<T>)
        if (measured.half_chord < T(shortest_axis)) measured = measure_part_finely(r12, q1, q2, e);
    if (!(measured.measure >= T(0))) return {quiet_nan<T>(), StatusCode::no_convergence};
    T const scaled = D == 3 ? T(T(T(2) * circle_constant<T>()) * measured.measure) : measured.measure;
    T const measure = times_power_of_two(scaled, D * (e + measured.exponent));
    return {minimum(measure, measure_of(measured.swapped ? q2 : q1)), status};
}

} // namespace pw85::detail

namespace pw85 {

/// The volume of the common part of two ellipsoids.
template <class T> PW85_FUNCTION inline Volume<T>
overlap_volume(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1, SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const [measure, status] = detail::measure_common_part(r12, q1, q2);
    return {measure, status};
}

/// The area of the common part of two ellipses.
template <class T> PW85_FUNCTION inline Area<T> overlap_area(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                                                             SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const [measure, status] = detail::measure_common_part(r12, q1, q2);
    return {measure, status};
}

} // namespace pw85

#endif
