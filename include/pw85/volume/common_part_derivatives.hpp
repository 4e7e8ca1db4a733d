// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Derivatives of the volume or area of the intersection of a pair, from the derivatives in the
/// joint frame, which frame_derivatives() of overlap_volume_derivatives.hpp and
/// overlap_area_derivatives.hpp computes.
///
/// 1. The map L·turn takes the joint frame to space. So ∂V/∂r12 is L⁻ᵀ·turn times the derivative
///    with respect to the centre, and ∂V/∂Q is (L⁻ᵀ·turn) G (L⁻ᵀ·turn)ᵀ, both times the
///    determinant.
/// 2. A rotation ω of an ellipsoid about its centre changes its form by [ω]Q - Q[ω]. So the torque
///    is the axial vector of 2(Q ∂V/∂Q).
#ifndef PW85_VOLUME_COMMON_PART_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_COMMON_PART_DERIVATIVES_HPP_INCLUDED

#include <pw85/algebra/unit_ball.hpp>
#include <pw85/volume/overlap_volume.hpp>

namespace pw85::detail {

/// Derivatives in the joint frame, for D = 3 divided by 2π: with respect to the centre of the other
/// ellipsoid, and to both forms as matrices.
template <class T, int D> struct FrameDerivatives {
    Vector<T, D> center;
    SymmetricMatrix<T, D> ball, other;
};

/// The leading digits of derivatives.
template <class T, class Fine, int D> PW85_FUNCTION inline void
round_to(FrameDerivatives<T, D> &y, FrameDerivatives<Fine, D> const &x) noexcept
{
    y.center = rounded(x.center);
    for (int k = 0; k < y.ball.size; ++k) {
        y.ball[k] = rounded(x.ball[k]);
        y.other[k] = rounded(x.other[k]);
    }
}

/// The largest distance of the centres and the shortest semi-axis of the other ellipsoid, with the
/// ball as unit, for which the digits of the result are enough. A point of the rim errs by about u
/// in this unit. In the metric of the other body it then errs by u over the shortest semi-axis. Far
/// from the centre of this body the tensor of its part is that of its normal up to small entries,
/// which err by u times its distance. So the first limit costs at most three bits, and the second
/// at most six bits, of the bound of the derivatives.
inline constexpr double largest_distance_of_derivatives = 8.0,
                        shortest_axis_of_derivatives = 1.0 / 64.0;

template <class T, int D>
PW85_FUNCTION inline bool has_accurate_derivatives(JointFrame<T, D> const &frame) noexcept
{
    return distance_of_centers(frame) <= T(largest_distance_of_derivatives) &&
           frame.axes[std::size_t(D - 1)] >= T(shortest_axis_of_derivatives);
}

/// L⁻ᵀx for a lower triangular L.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
solve_transposed(MatrixColumns<T, D> const &l, Vector<T, D> x) noexcept
{
    for (int j = D - 1; j >= 0; --j) {
        for (int i = j + 1; i < D; ++i) x[j] = x[j] - l[j][i] * x[i];
        x[j] = x[j] / l[j][j];
    }
    return x;
}

/// The map of gradients from the frame to space: L⁻ᵀ·turn, by its columns.
template <class T, int D>
PW85_FUNCTION inline MatrixColumns<T, D> gradient_map(JointFrame<T, D> const &frame) noexcept
{
    MatrixColumns<T, D> map{};
    for (int j = 0; j < D; ++j) map[j] = solve_transposed(frame.lower, frame.turn[j]);
    return map;
}

/// C G Cᵀ times a factor.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
congruent(MatrixColumns<T, D> const &c, SymmetricMatrix<T, D> const &g, T const &factor) noexcept
{
    SymmetricMatrix<T, D> result{};
    for (int a = 0; a < D; ++a)
        for (int b = a; b < D; ++b) {
            T sum = T(0);
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j) sum = sum + T(c[i][a] * g(i, j)) * c[j][b];
            result(a, b) = T(factor * sum);
        }
    return result;
}

/// The derivatives for a pair, as symmetric matrices.
template <class T, int D> struct PartDerivatives {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    StatusCode status;
};

/// Computes the derivatives for a pair from those in the joint frame.
template <class T, int D> PW85_FUNCTION inline PartDerivatives<T, D>
derivatives_in_space(JointFrame<T, D> const &frame, FrameDerivatives<T, D> const &d) noexcept
{
    auto const map = gradient_map(frame);
    Vector<T, D> center{};
    for (int i = 0; i < D; ++i) center = add_scaled(center, d.center[i], map[i]);
    bool const is_thin = !(frame.axes[std::size_t(D - 1)] >= thinnest_axis<T>());
    T scale = is_thin ? quiet_nan<T>() : frame.determinant;
    if constexpr (D == 3) scale = T(T(T(2) * circle_constant<T>()) * scale);
    auto const ball = frame.unit.to_caller(congruent(map, d.ball, scale), D - 2);
    auto const other = frame.unit.to_caller(congruent(map, d.other, scale), D - 2);
    Vector<T, D> const force = frame.unit.to_caller(scale * center, D - 1);
    if (frame.swapped) return {-force, other, ball, StatusCode::success};
    return {force, ball, other, StatusCode::success};
}

/// Half of the length of the axis of the rim. Not inlined, to keep its arrays out of the stack
/// frame of the caller.
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline T half_of_axis(JointFrame<T, 3> const &frame) noexcept
{
    return rim_axis(frame).half_chord;
}

/// Tests if computing with twice the digits gives the volume within its bound, and therefore also
/// the derivatives. The result can be false only in three cases: rounding of the forms moves the
/// surfaces far; the other body is far from the ball; the surfaces nearly touch, so that the axis
/// of the rim is short.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool
is_part_resolved(JointFrame<Finer<T>, 3> const &frame) noexcept
{
    T const displacement = rounded(frame.displacement);
    bool const is_near = distance_of_centers(frame) <= Finer<T>(largest_distance_of_one_sum);
    if (is_near && !is_one_sum_enough(frame, half_of_axis(frame))) return false;
    if (is_near && displacement <= largest_displacement<T, 3>()) return true;
    T const part = common_measure(frame).measure;
    return part >= T(0) && is_resolved<T, 3>(displacement, part);
}

/// The derivatives in a frame with twice the digits, rounded. Not inlined, to keep its arrays out
/// of the stack frame of the caller.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline FrameDerivatives<T, 3>
rounded_frame_derivatives(JointFrame<Finer<T>, 3> const &frame) noexcept
{
    FrameDerivatives<T, 3> d{};
    round_to(d, frame_derivatives(frame));
    return d;
}

/// The derivatives, computed from the forms with twice the digits; NaN if these do not suffice.
template <class T>
PW85_RARE PartDerivatives<T, 3> part_derivatives_finely(Vector<T, 3> const &r12,
                                                        SymmetricMatrix<T, 3> const &q1,
                                                        SymmetricMatrix<T, 3> const &q2) noexcept
{
    using Fine = Finer<T>;
    auto const frame = joint_frame(converted<Fine>(r12), converted<Fine>(q1), converted<Fine>(q2));
    auto d = rounded_frame_derivatives<T>(frame);
    if (!is_part_resolved<T>(frame)) d.center[0] = quiet_nan<T>();
    return derivatives_in_space(rounded(frame), d);
}

PW85_RARE_TIER_OF(part_derivatives_finely, double)

template <class T> PW85_FUNCTION inline PartDerivatives<T, 3>
part_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                 SymmetricMatrix<T, 3> const &q2) noexcept
{
    auto const frame = joint_frame(r12, q1, q2);
    if constexpr (std::is_floating_point_v<T>)
        if (!(frame.displacement <= largest_displacement<T, 3>()) ||
            !has_accurate_derivatives(frame))
            return part_derivatives_finely(r12, q1, q2);
    return derivatives_in_space(frame, frame_derivatives(frame));
}

/// The function for ellipses is in overlap_area_derivatives.hpp.
template <class T> PW85_FUNCTION inline PartDerivatives<T, 2>
part_derivatives(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                 SymmetricMatrix<T, 2> const &q2) noexcept;

/// Computes the derivatives for a pair in any unit; NaN if the integrals have not converged.
template <class T, int D> PW85_FUNCTION inline PartDerivatives<T, D>
derivatives_of_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                    SymmetricMatrix<T, D> const &q2) noexcept
{
    Unit const unit = unit_of(q1);
    auto const d = part_derivatives(unit.to_local(r12), unit.to_local(q1), unit.to_local(q2));
    if (!is_finite(d.r12) || !is_finite(d.q1) || !is_finite(d.q2))
        return all_nan<PartDerivatives<T, D>>(StatusCode::no_convergence);
    return {unit.to_caller(d.r12, D - 1), unit.to_caller(d.q1, D - 2), unit.to_caller(d.q2, D - 2),
            StatusCode::success};
}

/// ∂V/∂Q of an ellipsoid as a whole, ½ V Q⁻¹.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
derivative_of_measure(SymmetricMatrix<T, D> const &q) noexcept
{
    Unit const unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    auto const f = factorize(scaled, T(unit_roundoff<T>()));
    T const half = T(T(0.5) * measure_of(scaled));
    SymmetricMatrix<T, D> g{};
    for (int j = 0; j < D; ++j) {
        Vector<T, D> axis{};
        axis[j] = T(1);
        Vector<T, D> const column = solve(f, axis);
        for (int i = 0; i <= j; ++i) g(i, j) = T(half * column[i]);
    }
    return unit.to_caller(g, D - 2);
}

/// Computes the derivatives for a pair with this decision. If one ellipsoid is inside the other
/// one, only the derivative with respect to its own form is not zero.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline PartDerivatives<T, D>
derivatives_of_decided_part(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                            SymmetricMatrix<T, D> const &q2,
                            CommonPartDecision const &decision) noexcept
{
    auto const [part, status] = decision;
    if (status != StatusCode::success) return all_nan<PartDerivatives<T, D>>(status);
    if (part == CommonPart::part) return derivatives_of_part(r12, q1, q2);
    PartDerivatives<T, D> whole{{}, {}, {}, status};
    if (part == CommonPart::first) whole.q1 = derivative_of_measure(q1);
    if (part == CommonPart::second) whole.q2 = derivative_of_measure(q2);
    return whole;
}

/// Computes the derivatives for any pair.
template <class T, int D> PW85_FUNCTION inline PartDerivatives<T, D>
common_part_derivatives(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    return derivatives_of_decided_part(r12, q1, q2, decide_common_part(r12, q1, q2));
}

/// A component of the axial vector of 2QG: its dot product with ω is the contraction of G with
/// [ω]Q - Q[ω].
template <class T, int D> PW85_FUNCTION inline T axial_component(SymmetricMatrix<T, D> const &q,
                                                                 SymmetricMatrix<T, D> const &g,
                                                                 int j, int k) noexcept
{
    T sum = T(0);
    for (int m = 0; m < D; ++m) sum = sum + T(q(j, m) * g(m, k) - q(k, m) * g(m, j));
    return T(T(2) * sum);
}

/// Converts derivatives with respect to a matrix to derivatives with respect to its stored entries.
template <class T, int D>
PW85_FUNCTION inline SymmetricMatrix<T, D> by_entries(SymmetricMatrix<T, D> g) noexcept
{
    for (int i = 0; i < D; ++i)
        for (int j = i + 1; j < D; ++j) g(i, j) = g(i, j) + g(i, j);
    return g;
}

} // namespace pw85::detail

#endif
