// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the common part of two ellipsoids, and the area of that of two ellipses. pw85.hpp
/// and the C API call them.
///
/// Whether there is a common part, and whether it is a whole ellipsoid, is decided without rounding
/// errors (overlap/). Otherwise the pair is taken to its joint frame (joint_frame.hpp). A volume is
/// a sum of integrals along the rim (rim_integrals.hpp), which converge geometrically
/// (elliptic_rule.hpp). An area is in closed form: by chords (chord_area.hpp), or, where these
/// have no margin, by the crossings of a circle and an ellipse (section.hpp).
#ifndef PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED

#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/volume/chord_area.hpp>
#include <pw85/volume/rim_integrals.hpp>
#include <pw85/volume/section.hpp>
#include <pw85/volume/volume.hpp>

namespace pw85::detail {

/// Types of the intersection of two ellipsoids: empty, one of them as a whole, or a part of each.
enum class CommonPart { nothing, first, second, part };

/// The status of a pair, and the type of its intersection.
struct CommonPartDecision {
    CommonPart part;
    StatusCode status;
};

/// Tests whether each ellipsoid certainly exceeds the bounding box of the other one. Then neither is
/// inside the other one. Returns false outside of the range in which exceeds() holds.
template <class T, int D>
PW85_FUNCTION inline bool both_reach_beyond(Vector<T, D> const &r12,
                                            SymmetricMatrix<T, D> const &q1,
                                            SymmetricMatrix<T, D> const &q2) noexcept
{
    if (!passes_fast_checks(pair_of(r12, q1, q2))) return false;
    bool first = false, second = false;
    for (int i = 0; i < D; ++i) {
        T const distance = absolute(r12[i]);
        first |= exceeds(q2(i, i), q1(i, i), distance);
        second |= exceeds(q1(i, i), q2(i, i), distance);
    }
    return first && second;
}

/// For a pair that overlaps.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonPartDecision
decide_containment_of(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                      SymmetricMatrix<T, D> const &q2) noexcept
{
    if (both_reach_beyond(r12, q1, q2)) return {CommonPart::part, StatusCode::success};
    auto const second = call_contains(r12, q1, q2);
    if (second.status != StatusCode::success) return {CommonPart::nothing, second.status};
    if (second.contains) return {CommonPart::second, second.status};
    auto const first = call_contains(-r12, q2, q1);
    return {first.contains ? CommonPart::first : CommonPart::part, first.status};
}

template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonPartDecision
decide_common_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                   SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const [overlaps, tier, status] = call_overlap(r12, q1, q2);
    if (status != StatusCode::success || !overlaps) return {CommonPart::nothing, status};
    return decide_containment_of(r12, q1, q2);
}

/// The measure of the common part in the joint frame; in space over 2π. NaN if the integral has not
/// converged. It is not inlined, so that its memory and that of the exact decisions are not needed
/// at the same time.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ResultOf<T>
common_measure(JointFrame<T, 2> const &frame) noexcept
{
    return area_inside(plane_border(frame));
}

template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T common_measure(JointFrame<T, 3> const &frame) noexcept
{
    T const sum = accurate_sum_of_terms(frame);
    return absolute(sum) < infinity<T>() ? maximum(T(sum / T(3)), T(0)) : quiet_nan<T>();
}

/// The area by twice the digits, from the forms.
template <class T> PW85_RARE T common_area_finely(Vector<T, 2> const &r12,
                                                  SymmetricMatrix<T, 2> const &q1,
                                                  SymmetricMatrix<T, 2> const &q2) noexcept
{
    using Fine = Finer<T>;
    auto const frame = joint_frame(Vector<Fine, 2>{Fine(r12[0]), Fine(r12[1])}, converted<Fine>(q1),
                                   converted<Fine>(q2));
    if (!(frame.axes[1] >= thinnest_axis<Fine>())) return quiet_nan<T>();
    T const area = T(common_measure(frame) * rounded(frame.determinant));
    return times_power_of_two(area, 2 * frame.exponent);
}

#define PW85_RARE_AREA(rare, T)                                                                    \
    rare(common_area_finely,                                                                       \
         (Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,                                \
          SymmetricMatrix<T, 2> const &q2),                                                        \
         (r12, q1, q2))
PW85_RARE_TIER_IN_SPACE(PW85_RARE_AREA)

inline constexpr double largest_number_of_frame = 16.0;

/// Tests if the digits of the result are enough for an area by crossings. The numbers of the joint
/// frame err by a few u of the largest one, or of that times l10/l11 of the Cholesky factor. They
/// move the border by as much, and so does an error of F, whatever its extrema (section.hpp).
template <class T>
PW85_FUNCTION inline bool is_area_accurate(JointFrame<T, 2> const &frame) noexcept
{
    T const largest = maximum(distance_of_centers(frame), frame.axes[0]);
    T const skew = absolute(T(frame.lower[0][1] / frame.lower[1][1]));
    return T(largest * T(T(1) + skew)) <= T(largest_number_of_frame);
}

/// The measure of the common part, for any pair. It is at most that of the smaller ellipsoid.
template <class T, int D> struct CommonMeasure {
    T measure;
    StatusCode status;
};

/// For a pair with this decision.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonMeasure<T, D>
measure_decided_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2, CommonPartDecision const &decision) noexcept
{
    auto const [part, status] = decision;
    if (status != StatusCode::success) return {quiet_nan<T>(), status};
    if (part == CommonPart::nothing) return {T(0), status};
    if (part != CommonPart::part) return {measure_of(part == CommonPart::first ? q1 : q2), status};
    auto const frame = joint_frame(r12, q1, q2);
    if constexpr (D == 2 && std::is_floating_point_v<T>)
        if (!is_area_accurate(frame)) {
            T const area = common_area_finely(r12, q1, q2);
            return area >= T(0)
                       ? CommonMeasure<T, D>{minimum(area, measure_of(frame.swapped ? q2 : q1)),
                                             status}
                       : CommonMeasure<T, D>{quiet_nan<T>(), StatusCode::no_convergence};
        }
    bool const is_thin = !(frame.axes[std::size_t(D - 1)] >= thinnest_axis<T>());
    T const unit = is_thin ? quiet_nan<T>() : common_measure(frame);
    if (!(unit >= T(0))) return {quiet_nan<T>(), StatusCode::no_convergence};
    T const scaled =
        T((D == 3 ? T(T(T(2) * circle_constant<T>()) * unit) : unit) * frame.determinant);
    T const measure = times_power_of_two(scaled, D * frame.exponent);
    // The exact value is at most that of the smaller ellipsoid. Only a result near it is compared.
    T const near_whole = T(T(0.999) * unit_measure<T, D>());
    bool const may_exceed = (D == 3 ? T(T(T(2) * circle_constant<T>()) * unit) : unit) > near_whole;
    return {may_exceed ? minimum(measure, measure_of(frame.swapped ? q2 : q1)) : measure, status};
}

template <class T, int D> PW85_FUNCTION inline CommonMeasure<T, D>
measure_common_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                    SymmetricMatrix<T, D> const &q2) noexcept
{
    return measure_decided_part(r12, q1, q2, decide_common_part(r12, q1, q2));
}

/// The chords of doubles are accurate for nearly all pairs; crossings have the other ones.
PW85_FUNCTION inline CommonMeasure<double, 2>
measure_common_part(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                    SymmetricMatrix<double, 2> const &q2) noexcept
{
    auto const [overlaps, tier, status] = call_overlap(r12, q1, q2);
    if (status != StatusCode::success || !overlaps)
        return measure_decided_part(r12, q1, q2, {CommonPart::nothing, status});
    if (passes_fast_checks(pair_of(r12, q1, q2))) {
        auto const fast = chord_area(r12, q1, q2);
        if (fast.certain) return {fast.area, status};
    }
    return measure_decided_part(r12, q1, q2, decide_containment_of(r12, q1, q2));
}

} // namespace pw85::detail

namespace pw85 {

/// The volume of the common part of two ellipsoids.
template <class T>
PW85_FUNCTION inline Volume<T> overlap_volume(Vector<T, 3> const &r12,
                                              SymmetricMatrix<T, 3> const &q1,
                                              SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const [measure, status] = detail::measure_common_part(r12, q1, q2);
    return {measure, status};
}

/// The area of the common part of two ellipses.
template <class T>
PW85_FUNCTION inline Area<T> overlap_area(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                                          SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const [measure, status] = detail::measure_common_part(r12, q1, q2);
    return {measure, status};
}

} // namespace pw85

#endif
