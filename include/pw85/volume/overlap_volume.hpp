// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the common part of two ellipsoids, and the area of that of two ellipses. pw85.hpp
/// and the C API call them.
///
/// Whether there is a common part, and whether it is a whole ellipsoid, is decided without rounding
/// errors (overlap/). Otherwise the pair is taken to its joint frame (joint_frame.hpp). A volume is
/// a sum of integrals along the rim (common_volume.hpp), which converge geometrically
/// (elliptic_rule.hpp). An area is in closed form: by chords (chord_area.hpp), or, where these
/// have no margin, by the crossings of a circle and an ellipse (section.hpp).
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

/// For a pair that overlaps by a test of this tier. The first tier takes only pairs that pass the
/// fast checks.
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

/// The area of the common part in the joint frame. It is not inlined, as for a volume.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline CheckedMeasure<ResultOf<T>>
common_measure(JointFrame<T, 2> const &frame) noexcept
{
    return {area_inside(plane_border(frame)), true};
}

/// The largest displacement of surfaces by rounded forms (displacement_of()) that the bound covers.
///
/// The bound counts roundings of the forms by the derivatives of the measure. They are too small
/// where surfaces meet by less than the displacement η. Both the part that is beyond one surface
/// and its error are then of the order of a lens of depth η: πη² in the unit ball, 4√2/3 η^(3/2) in
/// the unit circle. For doubles η is 10.5u 2^24 or 7u 2^16, and the lens is 11u or 7u. The bound
/// has 64u times the ball.
template <class T, int D> PW85_FUNCTION inline T largest_displacement() noexcept
{
    return T(1) / negative_power_of_two<T>((mantissa_digits<T>() - 5) / (D == 3 ? 2 : 3));
}

/// The thinnest ellipsoid in units of the ball that the sections resolve: its two surfaces are told
/// apart to eight digits or so. In space, two ellipsoids of aspect ratio 10⁶ can be so different,
/// if one is a disc across the other.
template <class T> PW85_FUNCTION constexpr T thinnest_axis() noexcept
{
    return negative_power_of_two<T>(2 * mantissa_digits<T>() / 5);
}

inline constexpr double largest_number_of_frame = 16.0;

/// Tests if the digits of the result are enough for the frame and, in the plane, for crossings. The
/// numbers of the joint frame err by a few u of the largest one, or of that times l10/l11 of the
/// Cholesky factor. They move the border by as much, and so does an error of F, whatever its
/// extrema (section.hpp). In space rim_frame.hpp and common_volume.hpp decide it.
template <class T, int D>
PW85_FUNCTION inline bool is_frame_accurate(JointFrame<T, D> const &frame) noexcept
{
    if (!(frame.displacement <= largest_displacement<T, D>())) return false;
    if constexpr (D == 3) return true;
    T const largest = maximum(distance_of_centers(frame), frame.axes[0]);
    T const skew = absolute(T(frame.lower[0][1] / frame.lower[1][1]));
    return T(largest * T(T(1) + skew)) <= T(largest_number_of_frame);
}

/// Tests if the bound holds for a part by twice the digits: the displacement η by rounded forms,
/// which is 16u times that of the digits of the result, is small enough, or the part and what is
/// left of the smaller body are larger than a lens of depth 8η.
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

/// The measure in the unit of the caller. It is at most that of the smaller ellipsoid: only a
/// result near it is compared.
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

/// The measure of a part by twice the digits, from the forms; NaN if there is none within the
/// bound.
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

/// The measure of a part; NaN if there is none within the bound.
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

/// The measure of the common part, for any pair. It is at most that of the smaller ellipsoid.
template <class T> struct CommonMeasure {
    T measure;
    StatusCode status;
};

/// For a pair with this decision.
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

/// The volume of the common part of two ellipsoids.
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

/// The area of the common part of two ellipses. The chords of doubles are accurate for nearly all
/// pairs; crossings have the other ones.
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
