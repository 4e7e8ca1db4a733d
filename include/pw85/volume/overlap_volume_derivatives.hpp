// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The derivatives of the volume of the intersection of two ellipsoids: overlap_volume_gradient()
/// and overlap_volume_torque().
///
/// 1. If a point x of a surface moves by δx, the volume V of the intersection changes by the
///    integral of n·δx over the part of that surface that is inside the other ellipsoid. Here n is
///    the outward normal. So ∂V/∂r12 is N2 = ∫ n dA over the part of surface 2. It equals -N1,
///    because the parts of both surfaces together are a closed surface. A change dQ of a form moves
///    the surface by n·δx = nᵀ dQ Q⁻¹(x - c)/2, so ∂V/∂Q = ½ ∫ n (Q⁻¹(x - c))ᵀ dA, a symmetric
///    matrix.
/// 2. Both ∫ n dA and ∫ n xᵀ dA are integrals along the rim. Let y be a point of a body relative to
///    its centre, in the metric in which the body is the unit ball, so that n = y there. Let A be
///    the area of its part of the surface. By Stokes' theorem ∫ y dA = ½ ∮ y × dy, and 3 ∫ y yᵀ dA
///    is A I plus the symmetric part of ∮ y (y × dy)ᵀ. With y = o + X, where o is on the axis, ∮ y
///    (y × dy)ᵀ = 3 o Nᵀ - (o·N) I + ∮ X (X × dX)ᵀ and N = ½ ∮ X × dX. As X = z ℓ + ρ f, both
///    bodies share 12 integrals. They have opposite orientations, so action and reaction are equal.
#ifndef PW85_VOLUME_OVERLAP_VOLUME_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_VOLUME_DERIVATIVES_HPP_INCLUDED

#include <pw85/volume/common_part_derivatives.hpp>

namespace pw85 {

/// Derivatives of the volume of the intersection with respect to r12 and to the stored entries of
/// both forms (an off-diagonal entry stands for two entries of the matrix).
template <class T> struct OverlapVolumeGradient {
    Vector<T, 3> r12;
    SymmetricMatrix<T, 3> q1, q2;
    StatusCode status;
};

/// Derivatives of the volume of the intersection with respect to rotations of both ellipsoids about
/// their centres, per radian.
template <class T> struct OverlapVolumeTorque {
    Vector<T, 3> rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The number of integrals: A1, A2 over the radius of the metric, X × dX by three components, and X
/// (X × dX)ᵀ by nine, whose rows are the components of X along ℓ, g1 and g2.
inline constexpr int rim_moments = 14;

/// Adds X × dX and X (X × dX)ᵀ at a point of each of both half-planes, times a sign.
template <class T>
PW85_FUNCTION inline void add_moments(T (&sums)[rim_moments],
                                      MovingHalfPlane<TwoLanes<T>> const &plane,
                                      RimPoint<TwoLanes<T>> const &p, TwoLanes<T> const &z,
                                      TwoLanes<T> const &speed, TwoLanes<T> const &sign) noexcept
{
    using Two = TwoLanes<T>;
    Vector<Two, 3> const m = sign * swept(plane, p, z, speed);
    Vector<Two, 3> const x{z, p.rho * plane.weights[0], p.rho * plane.weights[1]};
    for (int j = 0; j < 3; ++j) {
        sums[2 + j] = sums[2 + j] + sum_of_lanes(m[j]);
        for (int i = 0; i < 3; ++i)
            sums[5 + 3 * i + j] = sums[5 + 3 * i + j] + sum_of_lanes(x[i] * m[j]);
    }
}

/// z of the middle of the segment of the axis inside both bodies.
template <class T> PW85_FUNCTION inline T middle_of_common_part(RimFrame<T> const &rim) noexcept
{
    auto const &ball = rim.bodies[0], &other = rim.bodies[1];
    T const top = other.high >= ball.high ? ball.high : other.high,
            bottom = other.low <= ball.low ? ball.low : other.low;
    return T(T(0.5) * T(top + bottom));
}

/// The integrands of the moments, with the orientation of the ball. X is relative to the middle of
/// the segment of the axis inside both bodies.
template <class T> struct MomentIntegrands {
    RimIntegration<T> const &integration;
    TwoLanes<T> sign, middle;
};

template <class T> PW85_FUNCTION inline void add_integrands(MomentIntegrands<T> const &integrands,
                                                            RimDirection<T> const &pair,
                                                            bool has_image,
                                                            RimSums<T, rim_moments> &sums) noexcept
{
    using Two = TwoLanes<T>;
    auto const &integration = integrands.integration;
    Two const sign = integrands.sign, middle = integrands.middle;
    integration.for_each(
        pair, has_image,
        [&](MovingHalfPlane<Two> const &plane, RimPoint<Two> const(&points)[2], Two const &speed) {
            sums.numbers[0] = sums.numbers[0] + integration.template area<0>(plane, points, speed);
            sums.numbers[1] = sums.numbers[1] + integration.template area<1>(plane, points, speed);
            add_moments(sums.numbers, plane, points[0], points[0].z - middle, speed, sign);
            if (integration.has_two_rims())
                add_moments(sums.numbers, plane, points[1], points[1].z - middle, speed, -sign);
        });
}

/// The integrals over 2π.
template <class T> PW85_FUNCTION inline RimMeans<T, rim_moments>
moments_of(RimIntegration<T> const &integration, T const &scale, T const &shortest) noexcept
{
    auto const &rim = integration.rim;
    if (integration.has_no_rim())
        return {
            {{integration.area_without_rim(0, T(1)), integration.area_without_rim(1, shortest)}, 0},
            true};
    using Two = TwoLanes<T>;
    MomentIntegrands<T> const integrands{integration, rim.ends.ball_above ? Two(1) : Two(-1),
                                         Two(middle_of_common_part(rim))};
    T const ray0 = magnitude(rim.rays[0]), ray1 = magnitude(rim.rays[1]);
    T const units[5] = {T(1), scale, ray0, ray1, T(ray0 * ray1)};
    auto moments = mean_over_half_planes<rim_moments>(elliptic_rule(rim), integrands, units);
    for (int body = 0; body < 2; ++body)
        moments.means.numbers[body] =
            moments.means.numbers[body] + integration.whole(body, body == 0 ? T(1) : shortest);
    return moments;
}

/// ∫ y yᵀ dA over 2π for a body, from the images of o, ℓ, g1 and g2 in its metric. `sign` is 1 for
/// the ball and -1 for the other body.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3>
surface_tensor(RimSums<T, rim_moments> const &m, T const &area, T const &sign,
               Vector<T, 3> const &origin, Vector<T, 3> const (&vectors)[3]) noexcept
{
    Vector<T, 3> const turned[3] = {cross(vectors[0], vectors[1]), cross(vectors[0], vectors[2]),
                                    cross(vectors[1], vectors[2])};
    Vector<T, 3> rows[3] = {};
    Vector<T, 3> normal{};
    for (int j = 0; j < 3; ++j) {
        normal = add_scaled(normal, T(T(0.5) * T(sign * m.numbers[2 + j])), turned[j]);
        for (int i = 0; i < 3; ++i)
            rows[i] = add_scaled(rows[i], T(sign * m.numbers[5 + 3 * i + j]), turned[j]);
    }
    T const rest = area - dot(origin, normal), sixth = T(T(1) / T(6));
    SymmetricMatrix<T, 3> tensor{};
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) {
            T sum = T(T(3) * T(origin[a] * normal[b] + origin[b] * normal[a]));
            for (int i = 0; i < 3; ++i)
                sum = sum + T(vectors[i][a] * rows[i][b] + vectors[i][b] * rows[i][a]);
            tensor(a, b) = T(sixth * T(a == b ? T(sum + T(2) * rest) : sum));
        }
    return tensor;
}

/// Not inlined, to keep its arrays out of the stack frames of its callers, which also call the
/// functions for twice the digits.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline FrameDerivatives<T, 3>
frame_derivatives(JointFrame<T, 3> const &frame) noexcept
{
    auto const integration = rim_integration(frame);
    auto const &rim = integration.rim;
    T const scale = T(frame.axes[0] * frame.axes[1]);
    auto const [m, converged] = moments_of(integration, scale, frame.axes[2]);
    Vector<T, 3> const vectors[3] = {rim.direction, rim.rays[0], rim.rays[1]};
    Vector<T, 3> const origin = add_scaled(rim.origin, middle_of_common_part(rim), rim.direction);
    Vector<T, 3> images[3], offset;
    for (int i = 0; i < 3; ++i) {
        offset[i] = origin[i] / frame.axes[i] - frame.center[i];
        for (int k = 0; k < 3; ++k) images[k][i] = vectors[k][i] / frame.axes[i];
    }
    T const unit = converged ? T(1) : quiet_nan<T>(), half = T(T(0.5) * unit),
            shortest = frame.axes[2];
    Vector<T, 3> normal{};
    for (int j = 0; j < 3; ++j)
        normal = add_scaled(normal, m.numbers[2 + j],
                            cross(vectors[j == 2 ? 1 : 0], vectors[j == 0 ? 1 : 2]));
    auto ball = surface_tensor(m, m.numbers[0], T(1), origin, vectors);
    auto other = surface_tensor(m, T(m.numbers[1] / shortest), T(-1), offset, images);
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            ball(i, j) = T(half * ball(i, j));
            other(i, j) = T(T(half * other(i, j)) *
                            T(T(scale / frame.axes[i]) * T(shortest / frame.axes[j])));
        }
    return {-half * normal, ball, other};
}

/// The axial vector of 2QG for a valid form Q. The products are in the unit of Q. So a component
/// that is zero remains zero even if products in the unit of the caller would overflow.
template <class T> PW85_FUNCTION inline Vector<T, 3>
torque_of(SymmetricMatrix<T, 3> const &q, SymmetricMatrix<T, 3> const &g) noexcept
{
    Unit const unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    return unit.to_caller(Vector<T, 3>{axial_component(scaled, g, 1, 2),
                                       axial_component(scaled, g, 2, 0),
                                       axial_component(scaled, g, 0, 1)},
                          2);
}

} // namespace pw85::detail

namespace pw85 {

/// Computes the derivatives with respect to r12 and the stored entries of both forms.
template <class T> PW85_FUNCTION inline OverlapVolumeGradient<T>
overlap_volume_gradient(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                        SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const d = detail::common_part_derivatives(r12, q1, q2);
    return {d.r12, detail::by_entries(d.q1), detail::by_entries(d.q2), d.status};
}

/// Computes the derivatives with respect to rotations of the ellipsoids about their centres.
template <class T> PW85_FUNCTION inline OverlapVolumeTorque<T>
overlap_volume_torque(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                      SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const d = detail::common_part_derivatives(r12, q1, q2);
    if (d.status != StatusCode::success) return detail::all_nan<OverlapVolumeTorque<T>>(d.status);
    return {detail::torque_of(q1, d.q1), detail::torque_of(q2, d.q2), d.status};
}

} // namespace pw85

#endif
