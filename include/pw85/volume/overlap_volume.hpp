// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the intersection of two ellipsoids, and the area of the intersection of two
/// ellipses.
///
/// Exact tests (overlap/) decide whether the intersection is empty, and whether it is one of the
/// ellipsoids. All other pairs are transformed to their joint frame (joint_frame.hpp). A volume is
/// a sum of integrals along the rim, the curve in which the surfaces intersect (common_volume.hpp).
/// Their trapezoidal rules converge geometrically (elliptic_rule.hpp). An area has a closed form.
/// It is computed from chords (chord_area.hpp), or, if the error of chords may exceed the bound,
/// from the crossings of a circle and an ellipse (section.hpp).
#ifndef PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_VOLUME_HPP_INCLUDED

#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/volume/chord_area.hpp>
#include <pw85/volume/common_volume.hpp>
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

/// Decides for a pair that overlaps. `tier` is the method that decided the overlap. Pairs that
/// OverlapTier::quartic decided have passed the fast checks.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonPartDecision
decide_containment_of(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                      SymmetricMatrix<T, D> const &q2, OverlapTier tier) noexcept
{
    if ((tier == OverlapTier::quartic || passes_fast_checks(r12, q1, q2)) &&
        exceed_each_other(r12, q1, q2))
        return {CommonPart::part, StatusCode::success};
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
    return decide_containment_of(r12, q1, q2, tier);
}

/// The area of the intersection in the joint frame. Not inlined, for the reason given for volumes.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline CheckedMeasure<ResultOf<T>>
common_measure(JointFrame<T, 2> const &frame) noexcept
{
    return {area_inside(plane_border(frame)), true};
}

/// The largest displacement of surfaces by rounded forms (displacement_of()) that the bound covers.
///
/// The bound estimates the effect of rounded forms by the derivatives of the volume or area. These
/// are too small where one body extends beyond the surface of the other one by less than the
/// displacement η. The part beyond the surface and its error are then of the order of a lens of
/// depth η: πη² in the unit ball, 4√2/3 η^(3/2) in the unit circle. For doubles the largest η is
/// 10.5u 2^24 or 7u 2^16, and the lens is below 11u or 7u. The bound has the term 64u times the
/// ball.
template <class T, int D> PW85_FUNCTION inline T largest_displacement() noexcept
{
    return T(1) / negative_power_of_two<T>((mantissa_digits<T>() - 5) / (D == 3 ? 2 : 3));
}

/// The shortest semi-axis, in units of the ball, for which the integrals resolve the two sides of
/// the ellipsoid: their distance then has about eight accurate digits. For example, two ellipsoids
/// of aspect ratio 10⁶ can have so short an axis in their joint frame if one is a disc across the
/// other.
template <class T> PW85_FUNCTION constexpr T thinnest_axis() noexcept
{
    return negative_power_of_two<T>(2 * mantissa_digits<T>() / 5);
}

inline constexpr double largest_number_of_frame = 16.0;

/// Tests if the digits of the result suffice for the frame and, in two dimensions, for the
/// crossings. The errors of the numbers of the joint frame are a few u times the largest of them,
/// or times this and l10/l11 of the Cholesky factor. These errors, and errors of F (section.hpp),
/// move the border by as much. In three dimensions rim_frame.hpp and common_volume.hpp have the
/// tests for the other steps.
template <class T, int D>
PW85_FUNCTION inline bool is_frame_accurate(JointFrame<T, D> const &frame) noexcept
{
    if (!(frame.displacement <= largest_displacement<T, D>())) return false;
    if constexpr (D == 3) return true;
    T const largest = maximum(distance_of_centers(frame), frame.axes[0]);
    T const skew = absolute(T(frame.lower[0][1] / frame.lower[1][1]));
    return T(largest * T(T(1) + skew)) <= T(largest_number_of_frame);
}

/// Tests if the bound holds for a part that was computed with twice the digits. The displacement η
/// by rounded forms is then 16u times that for the digits of the result. Either η is below the
/// limit above, or the part and the rest of the smaller body are both larger than a lens of depth
/// 8η (12η in two dimensions).
template <class T, int D>
PW85_FUNCTION inline bool is_resolved(T const &displacement, T const &part) noexcept
{
    T const u = T(unit_roundoff<T>()), fine = T(T(T(16) * u) * displacement);
    if (fine <= largest_displacement<T, D>()) return true;
    T const depth = T(T(T(84) * u) * fine);
    T const lens =
        D == 3 ? T(T(3.2) * T(depth * depth)) : T(T(1.9) * T(depth * square_root(depth)));
    return part >= lens && T(unit_measure<T, D>() - part) >= lens;
}

/// The volume or area in the unit of the caller. It is limited to that of the smaller ellipsoid;
/// the comparison is needed only if the result is near this limit.
template <class T, int D>
PW85_FUNCTION inline T measure_in_space(JointFrame<T, D> const &frame, T const &part,
                                        SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2) noexcept
{
    T const measure = frame.unit.to_caller(T(part * frame.determinant), D);
    return part > T(T(0.999) * unit_measure<T, D>())
               ? minimum(measure, measure_of(frame.swapped ? q2 : q1))
               : measure;
}

/// The volume or area of a part, computed from the forms with twice the digits; NaN if its error
/// may exceed the bound.
template <class T, int D> PW85_RARE T measure_part_finely(Vector<T, D> const &r12,
                                                          SymmetricMatrix<T, D> const &q1,
                                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    using Fine = Finer<T>;
    auto const frame = joint_frame(converted<Fine>(r12), converted<Fine>(q1), converted<Fine>(q2));
    Fine const thinnest = D == 3 ? Fine(thinnest_axis<T>()) : thinnest_axis<Fine>();
    if (!(frame.axes[std::size_t(D - 1)] >= thinnest)) return quiet_nan<T>();
    T const part = T(common_measure(frame).measure);
    if (!is_resolved<T, D>(T(rounded(frame.displacement)), part)) return quiet_nan<T>();
    return measure_in_space(rounded(frame), part, q1, q2);
}

PW85_RARE_TIER(measure_part_finely)

/// The volume or area of a part; NaN if its error may exceed the bound.
template <class T, int D>
PW85_FUNCTION inline T measure_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                    SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const frame = joint_frame(r12, q1, q2);
    if constexpr (std::is_floating_point_v<T>)
        if (!is_frame_accurate(frame)) return measure_part_finely(r12, q1, q2);
    if (!(frame.axes[std::size_t(D - 1)] >= thinnest_axis<T>())) return quiet_nan<T>();
    auto const part = common_measure(frame);
    if constexpr (std::is_floating_point_v<T>)
        if (!part.is_accurate) return measure_part_finely(r12, q1, q2);
    return measure_in_space(frame, part.measure, q1, q2);
}

/// The volume or area of the intersection of any pair: at most that of the smaller ellipsoid.
template <class T> struct CommonMeasure {
    T measure;
    StatusCode status;
};

/// Computes the volume or area for a pair with this decision.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline CommonMeasure<T>
measure_decided_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2, CommonPartDecision const &decision) noexcept
{
    auto const [part, status] = decision;
    if (status != StatusCode::success) return {quiet_nan<T>(), status};
    if (part == CommonPart::nothing) return {T(0), status};
    if (part != CommonPart::part) return {measure_of(part == CommonPart::first ? q1 : q2), status};
    T const measure = measure_part(r12, q1, q2);
    if (!(measure >= T(0))) return {quiet_nan<T>(), StatusCode::no_convergence};
    return {measure, status};
}

} // namespace pw85::detail

namespace pw85 {

/// The volume of the intersection of two ellipsoids.
template <class T>
PW85_FUNCTION inline Volume<T> overlap_volume(Vector<T, 3> const &r12,
                                              SymmetricMatrix<T, 3> const &q1,
                                              SymmetricMatrix<T, 3> const &q2) noexcept
{
    using namespace detail;
    auto const [volume, status] =
        measure_decided_part(r12, q1, q2, decide_common_part(r12, q1, q2));
    return {volume, status};
}

/// The area of the intersection of two ellipses. For double, chords suffice for nearly all pairs.
/// The other pairs use crossings.
template <class T>
PW85_FUNCTION inline Area<T> overlap_area(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                                          SymmetricMatrix<T, 2> const &q2) noexcept
{
    using namespace detail;
    auto const [overlaps, tier, decided] = call_overlap(r12, q1, q2);
    CommonPartDecision decision{CommonPart::nothing, decided};
    if (overlaps) {
        if constexpr (std::is_same_v<T, double>)
            if (passes_fast_checks(r12, q1, q2)) {
                auto const fast = chord_area(r12, q1, q2);
                if (fast.certain) return {fast.area, decided};
            }
        decision = decide_containment_of(r12, q1, q2, tier);
    }
    auto const [area, status] = measure_decided_part(r12, q1, q2, decision);
    return {area, status};
}

} // namespace pw85

#endif
