// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The derivatives of the area of the intersection of two ellipses: overlap_area_gradient() and
/// overlap_area_torque().
///
/// 1. As in space (overlap_volume_derivatives.hpp), ∂A/∂r12 is ∫ n ds along the arcs of ellipse 2,
///    and ∂A/∂Q = ½ ∫ n (Q⁻¹(x - c))ᵀ ds along the arcs of the ellipse of Q. The integral ∫ n ds is
///    the sum of the chords as vectors, each rotated by π/2.
/// 2. In the metric in which a body is a circle of radius R, n = y/R. Let an arc have the half
///    angle α and the unit vector m from the centre to its middle. Then ∫ y yᵀ ds/R = R² (α - sin α
///    cos α) I + 2 R² sin α cos α m mᵀ. The first factor is the area of the segment
///    (circular_segment.hpp). All terms are positive for α <= π/2.
#ifndef PW85_VOLUME_OVERLAP_AREA_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_AREA_DERIVATIVES_HPP_INCLUDED

#include <pw85/volume/chord_derivatives.hpp>
#include <pw85/volume/common_part_derivatives.hpp>

namespace pw85 {

/// Derivatives of the area of the intersection with respect to r12 and to the stored entries of
/// both forms (an off-diagonal entry stands for two entries of the matrix).
template <class T> struct OverlapAreaGradient {
    Vector<T, 2> r12;
    SymmetricMatrix<T, 2> q1, q2;
    StatusCode status;
};

/// Derivatives of the area of the intersection with respect to the angles of both ellipses, per
/// radian.
template <class T> struct OverlapAreaTorque {
    T rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Adds ½ ∫ y yᵀ ds/R along an arc in its metric.
template <class T>
PW85_FUNCTION inline void add_tensor(SymmetricMatrix<T, 2> &sum, BorderArc<T> const &arc) noexcept
{
    T const half_segment = T(T(0.5) * segment_of(arc)), x = arc.normal.x, y = arc.normal.y;
    T const factor = T(arc.half_length * T(arc.radius * arc.cosine));
    sum(0, 0) = sum(0, 0) + (half_segment + factor * T(x * x));
    sum(0, 1) = sum(0, 1) + T(factor * T(x * y));
    sum(1, 1) = sum(1, 1) + (half_segment + factor * T(y * y));
}

/// Derivatives in the joint frame. The metric of the circle is that of the frame, and the tensor of
/// the ellipse follows from det S S⁻ᵀ (tensor/R²) S⁻¹ with R the shorter axis.
template <class T> PW85_FUNCTION inline FrameDerivatives<ResultOf<T>, 2>
derivatives_inside(PlaneBorder<T> const &border) noexcept
{
    using Result = ResultOf<T>;
    Vector<T, 2> normal{};
    SymmetricMatrix<Result, 2> circle{}, t{};
    for_each_arc(border, [&](bool of_ellipse, BorderArc<Result> const &arc, int k, int next) {
        add_tensor(of_ellipse ? t : circle, arc);
        if (!of_ellipse || k == next) return;
        auto const &p = border.vertices[k].on_circle, &q = border.vertices[next].on_circle;
        normal[0] = normal[0] + (q.y - p.y);
        normal[1] = normal[1] + (p.x - q.x);
    });
    Result const ratio = rounded(border.ellipse.ratio), axis = rounded(border.ellipse.radius);
    FrameDerivatives<Result, 2> d{rounded(normal), circle, {}};
    d.other(0, 0) = Result(Result(Result(t(0, 0) / axis) / axis) * ratio);
    d.other(0, 1) = Result(Result(t(0, 1) / axis) / axis);
    d.other(1, 1) = Result(Result(Result(t(1, 1) / axis) / axis) / ratio);
    return d;
}

/// Derivatives in the joint frame, and a flag: false if the crossings are not clear
/// (are_crossings_clear()). The derivatives are then not valid.
template <class T> struct AreaDerivatives {
    FrameDerivatives<T, 2> derivatives;
    bool clear;
};

/// The derivatives with twice the digits, from the joint frame that was computed with the digits of
/// T.
template <class T>
PW85_RARE AreaDerivatives<T> area_derivatives_finely(JointFrame<T, 2> const &frame) noexcept
{
    auto const border = plane_border(widened(frame));
    if (!are_crossings_clear(border.ellipse, border.crossings)) return {};
    return {derivatives_inside(border), true};
}

PW85_RARE_TIER_OF(area_derivatives_finely, double)

template <class T>
PW85_FUNCTION inline AreaDerivatives<T> area_derivatives(JointFrame<T, 2> const &frame) noexcept
{
    if (!has_accurate_derivatives(frame)) return area_derivatives_finely(frame);
    auto const border = plane_border(frame);
    if (!are_crossings_clear(border.ellipse, border.crossings)) return {};
    return {derivatives_inside(border), true};
}

/// The derivatives with twice the digits, from the forms.
template <class T> PW85_RARE PartDerivatives<T, 2>
plane_part_derivatives_finely(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                              SymmetricMatrix<T, 2> const &q2) noexcept
{
    using Fine = Finer<T>;
    auto const frame = joint_frame(converted<Fine>(r12), converted<Fine>(q1), converted<Fine>(q2));
    return derivatives_in_space(rounded(frame), derivatives_inside(plane_border(frame)));
}

PW85_RARE_TIER_OF(plane_part_derivatives_finely, double)

template <class T> PW85_FUNCTION inline PartDerivatives<T, 2>
part_derivatives(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                 SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const frame = joint_frame(r12, q1, q2);
    if constexpr (std::is_floating_point_v<T>) {
        if (!(frame.displacement <= largest_displacement<T, 2>()))
            return plane_part_derivatives_finely(r12, q1, q2);
        auto const d = area_derivatives(frame);
        if (!d.clear) return plane_part_derivatives_finely(r12, q1, q2);
        return derivatives_in_space(frame, d.derivatives);
    } else {
        return derivatives_in_space(frame, derivatives_inside(plane_border(frame)));
    }
}

/// For double, chords (chord_derivatives.hpp) suffice for most pairs. The other pairs use
/// crossings. A unit that does not call this template does not compile what it calls.
template <class T>
requires std::is_same_v<T, double> PW85_FUNCTION inline PartDerivatives<T, 2>
common_part_derivatives(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                        SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const [overlaps, tier, status] = call_overlap(r12, q1, q2);
    if (status != StatusCode::success || !overlaps)
        return derivatives_of_decided_part(r12, q1, q2, {CommonPart::nothing, status});
    if (passes_fast_checks(r12, q1, q2)) {
        auto const fast = chord_derivatives(r12, q1, q2);
        if (fast.certain) return {fast.r12, fast.q1, fast.q2, status};
    }
    return derivatives_of_decided_part(r12, q1, q2, decide_containment_of(r12, q1, q2, tier));
}

} // namespace pw85::detail

namespace pw85 {

/// Computes the derivatives with respect to r12 and the stored entries of both forms.
template <class T> PW85_FUNCTION inline OverlapAreaGradient<T>
overlap_area_gradient(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                      SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const d = detail::common_part_derivatives(r12, q1, q2);
    return {d.r12, detail::by_entries(d.q1), detail::by_entries(d.q2), d.status};
}

/// Computes the derivatives with respect to the angles of both ellipses.
template <class T> PW85_FUNCTION inline OverlapAreaTorque<T>
overlap_area_torque(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                    SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const d = detail::common_part_derivatives(r12, q1, q2);
    return {detail::axial_component(q1, d.q1, 0, 1), detail::axial_component(q2, d.q2, 0, 1),
            d.status};
}

} // namespace pw85

#endif
