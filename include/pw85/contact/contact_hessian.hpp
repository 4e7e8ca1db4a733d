// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The second derivatives of μ² with respect to positions and rotations, from the maximiser λ.
/// pw85.hpp and the C API (src/simd/) use this file. It takes the units and the linear solver from
/// geometry.hpp.
///
/// With λ1 = 1-λ, λ2 = λ, N = λ1 Q1 + λ2 Q2, n = N⁻¹ r12, w = λ1 λ2 and Pe = λe Qe n, so that P1 +
/// P2 = r12:
///
/// 1. μ² is the maximum over n and λ of w (2 n·r12 - nᵀN n). This expression is linear in the
///    forms. For each ellipsoid e and each axis of rotation i, with G x = axis × x, let g = G n and
///    k = λe (Qe G n - G Qe n). Then k = N dn for that rotation at fixed λ. For a shift of r12
///    along axis i, k is the axis itself. At fixed λ the Hessian is 2w kᵀN⁻¹k'. If both changes are
///    rotations of the same ellipsoid, w (g·k' + g'·k) is subtracted.
/// 2. f'' = -2w⁻¹ P1ᵀN⁻¹P2 for every λ. So f'' is negative, and its sign does not depend on a
///    difference of large terms. Let b = N⁻¹(λ1 P1 - λ2 P2). Then f' changes by 2c, where c is k·b
///    for a shift of r12, k·b - λ1 g·P1 for a rotation of ellipsoid 1, and k·b + λ2 g·P2 for a
///    rotation of ellipsoid 2. As λ follows the changes, it adds 2w c c'/(P1ᵀN⁻¹P2) to the Hessian.
#ifndef PW85_CONTACT_CONTACT_HESSIAN_HPP_INCLUDED
#define PW85_CONTACT_CONTACT_HESSIAN_HPP_INCLUDED

#include <pw85/contact/evaluation.hpp>
#include <pw85/contact/geometry.hpp>

namespace pw85 {

/// The second derivatives of μ² with respect to r12, rotation 1 and rotation 2, in this order. The
/// matrix is 9×9 in three dimensions and 4×4 in two.
template <class T, int D> struct ContactHessian {
    static constexpr int size = D + 2 * detail::rotation_axes<D>;

    T entries[std::size_t(size)][std::size_t(size)];
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The cross product of axis i with x. This is how x changes in a rotation about the axis. In two
/// dimensions there is one axis, which points at the reader.
template <class T> PW85_FUNCTION constexpr Vector<T, 2> turned(int, Vector<T, 2> const &x) noexcept
{
    return {-x[1], x[0]};
}

template <class T>
PW85_FUNCTION constexpr Vector<T, 3> turned(int i, Vector<T, 3> const &x) noexcept
{
    Vector<T, 3> y{};
    y[(i + 1) % 3] = -x[(i + 2) % 3];
    y[(i + 2) % 3] = x[(i + 1) % 3];
    return y;
}

/// A change of r12 or of an orientation, in the terms of items 1 and 2.
template <class T, int D> struct Change {
    int ellipsoid;         ///< 0 for a change of r12, otherwise the ellipsoid that turns
    Vector<T, D> load, dn; ///< k, N⁻¹k
    Vector<T, D> turn;     ///< g; zero for r12
    T slope;               ///< c
};

/// The terms of items 1 and 2 that all changes share, for a pair at λ. The shares are divided by a
/// power of two near the larger one. So are b and every slope. Then their squares stay in range for
/// any ratio of sizes.
template <class T, int D> struct Balance {
    Factorization<T, D> factors; ///< of N
    Vector<T, D> n;
    Vector<T, D> shares[2]; ///< λ1 P1, λ2 P2
    Vector<T, D> bias;      ///< b
    T stiffness;            ///< (Q1 n)ᵀN⁻¹(Q2 n)
    /// the product of two slopes over the stiffness is multiplied by 2 to this power
    int exponent;
};

/// The binary exponent of the largest coordinate. For zero it is a very small number.
template <class T, int D> PW85_FUNCTION inline int largest_exponent(Vector<T, D> const &x) noexcept
{
    T const largest = largest_coordinate(x);
    return largest > T(0) ? binary_exponent(largest) : -(1 << 20);
}

template <class T, int D>
PW85_FUNCTION inline Balance<T, D> balance(Tangency<T, D> const &at,
                                           SymmetricMatrix<T, D> const &q1,
                                           SymmetricMatrix<T, D> const &q2) noexcept
{
    Vector<T, D> const p1 = product(q1, at.v), p2 = product(q2, at.v);
    Vector<T, D> const share1 = T(at.lambda1 * at.weight1) * p1,
                       share2 = T(at.lambda2 * at.weight2) * p2;
    int const exponent1 = largest_exponent(share1),
              exponent2 = largest_exponent(share2) + at.lambda_exponent;
    int const unit = exponent1 > exponent2 ? exponent1 : exponent2;
    Balance<T, D> b{
        factorize_blend(at.weight1, q1, at.weight2, q2),
        at.v,
        {times_power_of_two(share1, -unit), times_power_of_two(share2, at.lambda_exponent - unit)},
        {},
        {},
        at.weights_exponent + 2 * unit};
    b.bias = solve(b.factors, b.shares[0] - b.shares[1]);
    b.stiffness = dot(p1, solve(b.factors, p2));
    return b;
}

/// The change of r12 along an axis, as in item 1.
template <class T, int D>
PW85_FUNCTION inline Change<T, D> shift(Balance<T, D> const &b, int axis) noexcept
{
    Vector<T, D> load{};
    load[axis] = T(1);
    return {0, load, solve(b.factors, load), {}, dot(load, b.bias)};
}

/// The rotation of an ellipsoid (1 or 2) about an axis. `q` is the form of the ellipsoid times its
/// weight.
template <class T, int D> PW85_FUNCTION inline Change<T, D>
turn(Balance<T, D> const &b, int ellipsoid, SymmetricMatrix<T, D> const &q, int axis) noexcept
{
    Vector<T, D> const g = turned(axis, b.n);
    Vector<T, D> const load = product(q, g) - turned(axis, product(q, b.n));
    T const own = dot(g, b.shares[ellipsoid - 1]);
    return {ellipsoid, load, solve(b.factors, load), g,
            dot(load, b.bias) + (ellipsoid == 1 ? -own : own)};
}

/// The entry of the Hessian for two changes, in the units of a Tangency. `weight` is λ1 λ2 in these
/// units.
template <class T, int D>
PW85_FUNCTION inline T second_derivative(Balance<T, D> const &b, T const &weight,
                                         Change<T, D> const &x, Change<T, D> const &y) noexcept
{
    T fixed = dot(x.dn, y.load);
    if (x.ellipsoid == y.ellipsoid)
        fixed = fixed - T(0.5) * (dot(x.turn, y.load) + dot(y.turn, x.load));
    T const follows = b.stiffness > T(0) ? T(x.slope * (y.slope / b.stiffness)) : T(0);
    return T(2) * (weight * fixed + times_power_of_two(follows, b.exponent));
}

/// The Hessian by items 1 and 2, in the units of a Tangency.
template <class T, int D>
PW85_FUNCTION inline ContactHessian<T, D> hessian_at(Tangency<T, D> const &at,
                                                     SymmetricMatrix<T, D> const &q1,
                                                     SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int size = ContactHessian<T, D>::size, axes = rotation_axes<D>;
    Balance<T, D> const b = balance(at, q1, q2);
    T const weight = at.lambda1 * at.lambda2;
    Change<T, D> changes[std::size_t(size)];
    for (int i = 0; i < D; ++i) changes[i] = shift(b, i);
    for (int i = 0; i < axes; ++i) {
        changes[D + i] = turn(b, 1, at.weight1 * q1, i);
        changes[D + axes + i] = turn(b, 2, at.weight2 * q2, i);
    }
    ContactHessian<T, D> result{{}, StatusCode::success};
    for (int i = 0; i < size; ++i)
        for (int j = i; j < size; ++j)
            result.entries[i][j] = result.entries[j][i] =
                second_derivative(b, weight, changes[i], changes[j]);
    return result;
}

template <class T, int D>
PW85_FUNCTION inline void rescale(ContactHessian<T, D> &h, TangencyUnits const &units) noexcept
{
    Unit const mixed = units.normal * units.lambda,
               of_entries[] = {mixed / units.length, mixed, mixed * units.length};
    for (int i = 0; i < h.size; ++i)
        for (int j = 0; j < h.size; ++j)
            h.entries[i][j] = of_entries[(i >= D) + (j >= D)].to_caller(h.entries[i][j]);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline ContactHessian<T, D>
contact_hessian(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    using namespace detail;
    return at_tangency(
        [](Tangency<T, D> const &at, SymmetricMatrix<T, D> const &p1,
           SymmetricMatrix<T, D> const &p2) {
            if (dot(at.v, at.v) > T(0)) return hessian_at(at, p1, p2);
            return all_nan<ContactHessian<T, D>>(StatusCode::invalid_argument);
        },
        r12, q1, q2, lambda);
}

} // namespace pw85

#endif
