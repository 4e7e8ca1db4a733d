// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The derivatives of the volume of the common part of two ellipsoids. pw85.hpp and the C API call them.
///
/// 1. If a point x of a surface moves by δx, the volume V of the common part changes by the integral of n·δx over the part of that surface
///    that is inside the other ellipsoid. n is the outward normal. So ∂V/∂r12 is N2 = ∫ n dA over surface 2, which is
///    -N1, because both parts close a surface. A change dQ of a form moves the surface by n·δx = nᵀ dQ Q⁻¹(x - c)/2, so that
///    ∂V/∂Q = ½ ∫ n (Q⁻¹(x - c))ᵀ dA, which is symmetric.
/// 2. Let o + z ℓ + ρ f be the rim, with the unit vector f across the axis at the angle φ, f' = ∂f/∂φ, z' = ∂z/∂φ. By Stokes' theorem, with
///    x relative to o and v the volume between the arcs of a body and the axis, its part of the surface has
///    ∫ n dA = ∮ (½ρ² ℓ - ρ z' f') dφ and
///    ∫ n xᵀ dA = v I + ∮ (½ρ² z ℓ ℓᵀ + ⅓ρ³ ℓ fᵀ - ρ z z' f' ℓᵀ - ½ρ² z' f' fᵀ) dφ.
///    The integrals along the rim have opposite signs for the two bodies, so that action and reaction are equal, and the sum of both
///    tensors is V I.
/// 3. A rotation ω of an ellipsoid about its centre changes its form by [ω]Q - Q[ω]. So the torque is the axial vector of
///    2(Q ∂V/∂Q).
#ifndef PW85_VOLUME_OVERLAP_VOLUME_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_OVERLAP_VOLUME_DERIVATIVES_HPP_INCLUDED

#include <pw85/volume/overlap_volume.hpp>

namespace pw85 {

/// Derivatives of the volume of the common part with respect to r12 and to the stored entries of both forms (an off-diagonal
/// entry stands for two entries of the matrix).
template <class T> struct OverlapVolumeGradient {
    Vector<T, 3> r12;
    SymmetricMatrix<T, 3> q1, q2;
    StatusCode status;
};

/// Derivatives of the volume of the common part with respect to rotations of both ellipsoids about their centres, per radian.
template <class T> struct OverlapVolumeTorque {
    Vector<T, 3> rotation1, rotation2;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The integrals of item 2, or their integrands. The vectors and tensors are by their components along ℓ, along the rays g_i of the
/// vertices, and along their turned images k_i = ℓ×g_i/half_chord.
template <class T> struct RimIntegrals {
    T volumes[2];     ///< v of the ball, and of the other body
    T normal_axis;    ///< ½ρ²
    T normal_turn[2]; ///< -ρ z', along k_i
    T axis_axis;      ///< ½ρ² z
    T axis_ray[2];    ///< ⅓ρ³, along ℓ g_iᵀ
    T turn_axis[2];   ///< -ρ z z', along k_i ℓᵀ
    T turn_ray[2][2]; ///< -½ρ² z', along k_i g_jᵀ
};

/// The slope dz/dψ of the rim: both surfaces are F(z, ρ, ψ) = 0, with F half of s² + r² - 2rζ - (half of the chord)².
template <class T> PW85_FUNCTION inline T slope_of_rim(RimFrame<T, 3> const &rim, HalfPlane<T, 3> const &half_plane,
                                                       HalfPlanePoint<T> const &p) noexcept
{
    T const(&w)[2] = half_plane.weights;
    T const turned[2] = {-w[1], w[0]};
    T by_z[2], by_rho[2], by_psi[2];
    for (int b = 0; b < 2; ++b) {
        auto const &body = rim.bodies[b];
        T const along = linear(body.along, w), s = body.start + body.stretch * p.z + along * p.rho;
        by_z[b] = T(s * body.stretch);
        by_rho[b] = T(s * along) + quadratic(body.products, w) * p.rho - linear(body.across, w);
        T const mixed = T(turned[0] * linear(body.products[0], w)) + T(turned[1] * linear(body.products[1], w));
        by_psi[b] = T(p.rho * T(s * linear(body.along, turned) + T(p.rho * mixed) - linear(body.across, turned)));
    }
    T const determinant = T(by_z[0] * by_rho[1] - by_z[1] * by_rho[0]);
    T const slope = T(by_rho[0] * by_psi[1] - by_rho[1] * by_psi[0]) / determinant;
    return absolute(slope) < largest_number<T>() ? slope : T(0); // where the rim touches itself
}

/// Adds the integrand at a point of the rim, times a sign.
template <class T> PW85_FUNCTION inline void add_rim_point(RimIntegrals<T> &sum, RimFrame<T, 3> const &rim,
                                                           HalfPlane<T, 3> const &half_plane,
                                                           HalfPlanePoint<T> const &p, T const &sign) noexcept
{
    T const slope = slope_of_rim(rim, half_plane, p), square = T(T(T(0.5) * sign) * T(p.rho * p.rho));
    T const turn = T(T(-sign) * T(p.rho * slope));
    sum.normal_axis = sum.normal_axis + square;
    sum.axis_axis = sum.axis_axis + square * p.z;
    for (int i = 0; i < 2; ++i) {
        T const w = half_plane.weights[i];
        sum.normal_turn[i] = sum.normal_turn[i] + w * turn;
        sum.axis_ray[i] = sum.axis_ray[i] + T(w * p.rho) * T(square * T(2)) / T(3);
        sum.turn_axis[i] = sum.turn_axis[i] + T(w * turn) * p.z;
        for (int j = 0; j < 2; ++j)
            sum.turn_ray[i][j] = sum.turn_ray[i][j] + T(w * half_plane.weights[j]) * T(T(T(0.5) * turn) * p.rho);
    }
}

/// The integrands in a half-plane. The signs are those of the ball: its arcs end at the upper point or begin there.
template <class T> PW85_FUNCTION inline RimIntegrals<T>
rim_integrands(RimFrame<T, 3> const &rim, AxisInterval<T> const &interval, HalfPlane<T, 3> const &half_plane) noexcept
{
    Arc<T> const arcs[2] = {arc_of(rim.bodies[0], half_plane), arc_of(rim.bodies[1], half_plane)};
    auto const points = corrected_rim_points(rim, half_plane, arcs);
    RimIntegrals<T> sum{};
    for (int body = 0; body < 2; ++body)
        sum.volumes[body] =
            sum_over_arcs<T, 3>(interval, points, body, [&](HalfPlanePoint<T> const &p, HalfPlanePoint<T> const &q) {
                return segment_under(arcs[body], p, q) + trapezoid_under(p, q);
            }).rho;
    T const sign = interval.ball_above ? T(1) : T(-1);
    add_rim_point(sum, rim, half_plane, points.upper, sign);
    if (interval.ball_above == interval.ball_below) add_rim_point(sum, rim, half_plane, points.lower, T(-sign));
    return sum;
}

/// The mean of integrands, for mean_over_half_planes().
template <class T> struct MeanRimIntegrals {
    RimIntegrals<T> integrals;

    PW85_MEMBER void add(T const &weight, RimIntegrals<T> const &x) noexcept
    {
        for_each([&](T &sum, T const &term) { sum = sum + weight * term; }, integrals, x);
    }
    PW85_MEMBER MeanRimIntegrals over(T const &count) const noexcept
    {
        MeanRimIntegrals mean{};
        mean.add(T(T(1) / count), integrals);
        return mean;
    }
    /// Calls function(x_k, y_k) for all numbers.
    template <class Function>
    PW85_MEMBER static void for_each(Function const &function, RimIntegrals<T> &x, RimIntegrals<T> const &y) noexcept
    {
        function(x.normal_axis, y.normal_axis);
        function(x.axis_axis, y.axis_axis);
        for (int i = 0; i < 2; ++i) {
            function(x.volumes[i], y.volumes[i]);
            function(x.normal_turn[i], y.normal_turn[i]);
            function(x.axis_ray[i], y.axis_ray[i]);
            function(x.turn_axis[i], y.turn_axis[i]);
            for (int j = 0; j < 2; ++j) function(x.turn_ray[i][j], y.turn_ray[i][j]);
        }
    }
};

/// Whether the volumes and the area vector agree, the numbers that are not small of a higher order.
template <class T>
PW85_FUNCTION inline bool agree(MeanRimIntegrals<T> const &x, MeanRimIntegrals<T> const &y, T const &tolerance) noexcept
{
    auto const &a = x.integrals, &b = y.integrals;
    T const volume = T(a.volumes[0] + a.volumes[1]);
    T const area = absolute(a.normal_axis) + absolute(a.normal_turn[0]) + absolute(a.normal_turn[1]);
    bool yes = absolute(T(a.normal_axis - b.normal_axis)) <= T(tolerance * area);
    for (int i = 0; i < 2; ++i)
        yes = yes && absolute(T(a.volumes[i] - b.volumes[i])) <= T(tolerance * volume) &&
              absolute(T(a.normal_turn[i] - b.normal_turn[i])) <= T(tolerance * area);
    return yes;
}

/// Derivatives over 2π in the joint frame: with respect to the centre of the other ellipsoid, and to both forms as matrices.
template <class T> struct FrameDerivatives {
    Vector<T, 3> center;
    SymmetricMatrix<T, 3> ball, other;
};

/// The vectors of item 2 in the joint frame.
template <class T> struct RimBasis {
    Vector<T, 3> axis, rays[2], turned[2];
};

template <class T> PW85_FUNCTION inline RimBasis<T> rim_basis(RimAxis<T, 3> const &axis) noexcept
{
    RimBasis<T> basis{axis.direction, {}, {}};
    for (int i = 0; i < 2; ++i) basis.rays[i] = add_scaled(axis.vertices[i], T(-axis.heights[i]), axis.origin);
    // φ grows with ψ.
    T const sign = dot(basis.axis, cross(basis.rays[0], basis.rays[1])) < T(0) ? T(-1) : T(1);
    for (int i = 0; i < 2; ++i) basis.turned[i] = T(sign / axis.half_chord) * cross(basis.axis, basis.rays[i]);
    return basis;
}

/// ∮ ... dφ of ∫ n dA for the ball.
template <class T>
PW85_FUNCTION inline Vector<T, 3> rim_vector(RimIntegrals<T> const &m, RimBasis<T> const &basis) noexcept
{
    return add_scaled(add_scaled(m.normal_axis * basis.axis, m.normal_turn[0], basis.turned[0]), m.normal_turn[1],
                      basis.turned[1]);
}

/// ½ ∫ n (W(x - c))ᵀ dA for a body, with the diagonal matrix W and the offset o - c: its symmetric part. `sign` is 1 for the ball and -1 for
/// the other body, and `volume` is its v.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3> form_derivative(RimIntegrals<T> const &m,
                                                                              RimBasis<T> const &basis, T const &volume,
                                                                              T const &sign, Vector<T, 3> const &offset,
                                                                              Vector<T, 3> const &weights) noexcept
{
    T full[3][3] = {};
    auto const add = [&](Vector<T, 3> const &n, Vector<T, 3> const &x) {
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) full[a][b] = full[a][b] + n[a] * T(x[b] * weights[b]);
    };
    add(sign * rim_vector(m, basis), offset);
    Vector<T, 3> row = m.axis_axis * basis.axis;
    for (int i = 0; i < 2; ++i) row = add_scaled(row, m.axis_ray[i], basis.rays[i]);
    add(sign * basis.axis, row);
    for (int i = 0; i < 2; ++i) {
        row = m.turn_axis[i] * basis.axis;
        for (int j = 0; j < 2; ++j) row = add_scaled(row, m.turn_ray[i][j], basis.rays[j]);
        add(sign * basis.turned[i], row);
    }
    SymmetricMatrix<T, 3> g{};
    for (int a = 0; a < 3; ++a) {
        full[a][a] = full[a][a] + volume * weights[a];
        for (int b = 0; b <= a; ++b) g(b, a) = T(T(0.25) * T(full[a][b] + full[b][a]));
    }
    return g;
}

template <class T> PW85_FUNCTION inline FrameDerivatives<T> frame_derivatives(JointFrame<T, 3> const &frame,
                                                                              RimAxis<T, 3> const &axis) noexcept
{
    auto const rim = rim_frame(frame, axis);
    auto const interval = axis_interval(rim);
    auto const m =
        mean_over_half_planes<MeanRimIntegrals<T>>(elliptic_rule(rim), [&](HalfPlane<T, 3> const &half_plane) {
            return rim_integrands(rim, interval, half_plane);
        }).integrals;
    auto const basis = rim_basis(axis);
    Vector<T, 3> weights, offset;
    for (int i = 0; i < 3; ++i) {
        weights[i] = T(T(1) / frame.axes[i]) / frame.axes[i];
        offset[i] = axis.origin[i] - frame.axes[i] * frame.center[i];
    }
    T const factor = rim.half_chord;
    auto const ball = form_derivative(m, basis, m.volumes[0], T(1), axis.origin, Vector<T, 3>{T(1), T(1), T(1)});
    auto const other = form_derivative(m, basis, m.volumes[1], T(-1), offset, weights);
    return {T(-factor) * rim_vector(m, basis), factor * ball, factor * other};
}

/// L⁻ᵀx for a lower triangular L.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_transposed(Columns<T, D> const &l, Vector<T, D> x) noexcept
{
    for (int j = D - 1; j >= 0; --j) {
        for (int i = j + 1; i < D; ++i) x[j] = x[j] - l[j][i] * x[i];
        x[j] = x[j] / l[j][j];
    }
    return x;
}

/// The map of gradients from the frame to space: L⁻ᵀ·turn, by its columns.
template <class T> PW85_FUNCTION inline Columns<T, 3> gradient_map(JointFrame<T, 3> const &frame) noexcept
{
    Columns<T, 3> map{};
    for (int j = 0; j < 3; ++j) map[j] = solve_transposed(frame.lower, frame.turn[j]);
    return map;
}

/// C G Cᵀ times a factor.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3>
congruent(Columns<T, 3> const &c, SymmetricMatrix<T, 3> const &g, T const &factor) noexcept
{
    SymmetricMatrix<T, 3> result{};
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) {
            T sum = T(0);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) sum = sum + T(c[i][a] * g(i, j)) * c[j][b];
            result(a, b) = T(factor * sum);
        }
    return result;
}

/// The derivatives over 2π for a pair, as symmetric matrices, and the length of the axis in the ball.
template <class T> struct PartDerivatives {
    Vector<T, 3> r12;
    SymmetricMatrix<T, 3> q1, q2;
    T half_chord;
};

template <class T> PW85_FUNCTION inline PartDerivatives<T>
part_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1, SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const frame = joint_frame(r12, q1, q2);
    auto const axis = rim_axis(pencil(frame));
    auto const d = frame_derivatives(frame, axis);
    auto const map = gradient_map(frame);
    Vector<T, 3> center{};
    for (int i = 0; i < 3; ++i) center = add_scaled(center, d.center[i], map[i]);
    bool const is_thin = !(frame.axes[2] >= thinnest_axis<T>());
    T const scale = is_thin ? quiet_nan<T>() : frame.determinant;
    auto const ball = times_power_of_two(congruent(map, d.ball, scale), frame.exponent);
    auto const other = times_power_of_two(congruent(map, d.other, scale), frame.exponent);
    Vector<T, 3> const force = times_power_of_two(scale * center, 2 * frame.exponent);
    if (frame.swapped) return {-force, other, ball, axis.half_chord};
    return {force, ball, other, axis.half_chord};
}

/// The same with twice the digits (see shortest_axis).
template <class T> PW85_RARE PartDerivatives<T> part_derivatives_finely(Vector<T, 3> const &r12,
                                                                        SymmetricMatrix<T, 3> const &q1,
                                                                        SymmetricMatrix<T, 3> const &q2) noexcept
{
    using Fine = Finer<T>;
    auto const fine = part_derivatives(converted<Fine>(r12), converted<Fine>(q1), converted<Fine>(q2));
    PartDerivatives<T> d{rounded(fine.r12), {}, {}, rounded(fine.half_chord)};
    for (int k = 0; k < d.q1.size; ++k) {
        d.q1[k] = rounded(fine.q1[k]);
        d.q2[k] = rounded(fine.q2[k]);
    }
    return d;
}

#define PW85_RARE_COMMON_PART_DERIVATIVES(rare, T)                                                                     \
    rare(part_derivatives_finely,                                                                                      \
         (Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1, SymmetricMatrix<T, 3> const &q2), (r12, q1, q2))
PW85_RARE_TIER_IN_SPACE(PW85_RARE_COMMON_PART_DERIVATIVES)

/// The derivatives for a pair: ∂V/∂r12 and ∂V/∂Q1, ∂V/∂Q2 as symmetric matrices.
template <class T> PW85_FUNCTION inline OverlapVolumeGradient<T>
derivatives_of_part(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1, SymmetricMatrix<T, 3> const &q2) noexcept
{
    int const e = half_exponent(largest_diagonal(q1));
    auto const r = times_power_of_two(r12, -e);
    auto const a = times_power_of_two(q1, -2 * e), b = times_power_of_two(q2, -2 * e);
    auto d = part_derivatives(r, a, b);
    if constexpr (std::is_floating_point_v<T>)
        if (d.half_chord < T(shortest_axis)) d = part_derivatives_finely(r, a, b);
    if (!is_finite(d.r12) || !is_finite(d.q1) || !is_finite(d.q2))
        return all_nan<OverlapVolumeGradient<T>>(StatusCode::no_convergence);
    T const turn = T(T(2) * circle_constant<T>());
    return {times_power_of_two(turn * d.r12, 2 * e), times_power_of_two(turn * d.q1, e),
            times_power_of_two(turn * d.q2, e), StatusCode::success};
}

/// ∂V/∂Q of the volume of an ellipsoid as a whole, ½ V Q⁻¹.
template <class T>
PW85_FUNCTION inline SymmetricMatrix<T, 3> derivative_of_volume(SymmetricMatrix<T, 3> const &q) noexcept
{
    int const e = half_exponent(largest_diagonal(q));
    auto const scaled = times_power_of_two(q, -2 * e);
    auto const f = factorize(scaled, T(unit_roundoff<T>()));
    T const half = T(T(0.5) * measure_of(scaled));
    SymmetricMatrix<T, 3> g{};
    for (int j = 0; j < 3; ++j) {
        Vector<T, 3> unit{};
        unit[j] = T(1);
        Vector<T, 3> const column = solve(f, unit);
        for (int i = 0; i <= j; ++i) g(i, j) = T(half * column[i]);
    }
    return times_power_of_two(g, e);
}

/// The same for any pair. Where one ellipsoid is inside the other one, only its own form counts.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline OverlapVolumeGradient<T>
overlap_volume_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                           SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const [part, status] = decide_common_part(r12, q1, q2);
    if (status != StatusCode::success) return all_nan<OverlapVolumeGradient<T>>(status);
    OverlapVolumeGradient<T> whole{{}, {}, {}, status};
    if (part == CommonPart::part) return derivatives_of_part(r12, q1, q2);
    if (part == CommonPart::first) whole.q1 = derivative_of_volume(q1);
    if (part == CommonPart::second) whole.q2 = derivative_of_volume(q2);
    return whole;
}

/// The axial vector of 2QG: its dot product with ω is the contraction of G with [ω]Q - Q[ω].
template <class T>
PW85_FUNCTION inline Vector<T, 3> torque_of(SymmetricMatrix<T, 3> const &q, SymmetricMatrix<T, 3> const &g) noexcept
{
    Vector<T, 3> torque{};
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        T sum = T(0);
        for (int m = 0; m < 3; ++m) sum = sum + T(q(j, m) * g(m, k) - q(k, m) * g(m, j));
        torque[i] = T(2) * sum;
    }
    return torque;
}

/// The derivatives with respect to the stored entries.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3> by_entries(SymmetricMatrix<T, 3> g) noexcept
{
    for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 3; ++j) g(i, j) = g(i, j) + g(i, j);
    return g;
}

} // namespace pw85::detail

namespace pw85 {

/// The derivatives of the volume of the common part.
template <class T>
PW85_FUNCTION inline OverlapVolumeGradient<T> overlap_volume_gradient(Vector<T, 3> const &r12,
                                                                      SymmetricMatrix<T, 3> const &q1,
                                                                      SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const d = detail::overlap_volume_derivatives(r12, q1, q2);
    return {d.r12, detail::by_entries(d.q1), detail::by_entries(d.q2), d.status};
}

/// The derivatives with respect to rotations about the centres.
template <class T>
PW85_FUNCTION inline OverlapVolumeTorque<T> overlap_volume_torque(Vector<T, 3> const &r12,
                                                                  SymmetricMatrix<T, 3> const &q1,
                                                                  SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const d = detail::overlap_volume_derivatives(r12, q1, q2);
    return {detail::torque_of(q1, d.q1), detail::torque_of(q2, d.q2), d.status};
}

} // namespace pw85

#endif
