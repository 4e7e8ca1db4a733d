// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The derivatives of the area of the common part of two ellipses. pw85.hpp and the C API call
/// them.
///
/// 1. As in space (overlap_volume_derivatives.hpp), ∂A/∂r12 is ∫ n ds along the arcs of ellipse 2,
///    and ∂A/∂Q = ½ ∫ n (Q⁻¹(x - c))ᵀ ds along those of its own. The former is the sum of the
///    chords, each turned by a right angle.
/// 2. In the metric in which a body is a circle of radius R, n = y/R. Let an arc have the half
///    angle α and the unit vector m from the centre to its middle. Then ∫ y yᵀ ds/R = R² (α - sin α
///    cos α) I + 2 R² sin α cos α m mᵀ. The first factor is the area of the segment
///    (circular_segment.hpp). All terms are positive for α <= π/2.
#ifndef PW85_VOLUME_OVERLAP_AREA_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_AREA_DERIVATIVES_HPP_INCLUDED

#include <pw85/volume/chord_derivatives.hpp>
#include <pw85/volume/common_part_derivatives.hpp>

namespace pw85 {

/// Derivatives of the area of the common part with respect to r12 and to the stored entries of both
/// forms (an off-diagonal entry stands for two entries of the matrix).
template <class T> struct OverlapAreaGradient {
    Vector<T, 2> r12;
    SymmetricMatrix<T, 2> q1, q2;
    StatusCode status;
};

/// Derivatives of the area of the common part with respect to the angles of both ellipses, per
/// radian.
template <class T> struct OverlapAreaTorque {
    T rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The integrals along the arcs of a body: ∫ n ds by its components along ℓ and g, and ∫ y yᵀ ds/R
/// by those along the image of the axis and across it.
template <class T> struct ArcIntegrals {
    T axial, radial;
    T along, mixed, across;
};

/// Adds those of an arc from p counter-clockwise to q.
template <class T>
PW85_FUNCTION inline void add_integrals(ArcIntegrals<T> &sums, Circle<T> const &circle,
                                        PlanePoint<T> const &p, PlanePoint<T> const &q) noexcept
{
    auto const chord = chord_of(circle, p, q);
    T const segment = segment_of(circle, chord), s = chord.normal_s, r = chord.normal_r;
    T const factor = T(T(T(2) * chord.half_length) * T(circle.radius * chord.cosine));
    sums.axial = sums.axial + T(q.y - p.y);
    sums.radial = sums.radial + T(p.z - q.z);
    sums.along = sums.along + T(segment + factor * T(s * s));
    sums.mixed = sums.mixed + T(factor * T(s * r));
    sums.across = sums.across + T(segment + factor * T(r * r));
}

/// ½ ∫ y yᵀ ds/R in the coordinates of the frame, from the image of ℓ in the metric and that of g.
template <class T>
PW85_FUNCTION inline SymmetricMatrix<T, 2> arc_tensor(ArcIntegrals<T> const &sums,
                                                      Vector<T, 2> const &direction,
                                                      Vector<T, 2> const &ray) noexcept
{
    Vector<T, 2> const k = direction / magnitude(direction);
    T const sign = T(k[0] * ray[1] - k[1] * ray[0]) < T(0) ? T(-1) : T(1), half = T(0.5);
    Vector<T, 2> const e{T(-(sign * k[1])), T(sign * k[0])};
    SymmetricMatrix<T, 2> tensor{};
    for (int i = 0; i < 2; ++i)
        for (int j = i; j < 2; ++j) {
            T const mixed = T(k[i] * e[j] + e[i] * k[j]);
            T const sum = T(sums.along * T(k[i] * k[j]) + sums.across * T(e[i] * e[j])) +
                          T(sums.mixed * mixed);
            tensor(i, j) = T(half * sum);
        }
    return tensor;
}

template <class T> PW85_FUNCTION inline FrameDerivatives<T, 2>
frame_derivatives(JointFrame<T, 2> const &frame) noexcept
{
    auto const rim = accurate_rim_frame(frame);
    if constexpr (std::is_floating_point_v<T>)
        if (!are_points_apart(rim)) return frame_derivatives_finely(frame);
    auto const border = plane_rim(rim);
    ArcIntegrals<T> sums[2] = {};
    for_each_arc(border, [&](int body, PlanePoint<T> const &p, PlanePoint<T> const &q) {
        add_integrals(sums[body], border.circles[body], p, q);
    });
    auto const &ball = sums[0], &other = sums[1];
    T const ratio = T(frame.axes[1] / frame.axes[0]), size = magnitude(rim.rays[0]);
    Vector<T, 2> const &direction = rim.direction, &ray = rim.rays[0];
    FrameDerivatives<T, 2> d{{}, arc_tensor(ball, direction, ray), {}};
    d.center = T(other.axial * size) * direction + T(other.radial / size) * ray;
    auto const tensor =
        arc_tensor(other, {T(ratio * direction[0]), direction[1]}, {T(ratio * ray[0]), ray[1]});
    // det S S⁻ᵀ (tensor/R²) S⁻¹ with R the shorter axis
    d.other(0, 0) = T(T(tensor(0, 0) / frame.axes[0]) / frame.axes[1]);
    d.other(0, 1) = T(T(tensor(0, 1) / frame.axes[1]) / frame.axes[1]);
    d.other(1, 1) = T(T(T(tensor(1, 1) / frame.axes[1]) / frame.axes[1]) / ratio);
    return d;
}

/// The chords of doubles are accurate for most pairs; the rim has the other ones.
PW85_FUNCTION inline PartDerivatives<double, 2>
common_part_derivatives(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                        SymmetricMatrix<double, 2> const &q2) noexcept
{
    auto const [overlaps, tier, status] = call_overlap(r12, q1, q2);
    if (status != StatusCode::success || !overlaps)
        return derivatives_of_decided_part(r12, q1, q2, {CommonPart::nothing, status});
    if (passes_fast_checks(pair_of(r12, q1, q2))) {
        auto const fast = chord_derivatives(r12, q1, q2);
        if (fast.certain) return {fast.r12, fast.q1, fast.q2, status};
    }
    return derivatives_of_decided_part(r12, q1, q2, decide_containment_of(r12, q1, q2));
}

} // namespace pw85::detail

namespace pw85 {

/// The derivatives of the area of the common part.
template <class T> PW85_FUNCTION inline OverlapAreaGradient<T>
overlap_area_gradient(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                      SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const d = detail::common_part_derivatives(r12, q1, q2);
    return {d.r12, detail::by_entries(d.q1), detail::by_entries(d.q2), d.status};
}

/// The derivatives with respect to the angles.
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
