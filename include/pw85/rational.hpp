/// @file
/// The rational form of f: rᵀ(Q1 + t Q2)⁻¹r = a(t)/b(t) with a = rᵀ adj(Q1 + t Q2) r and b = det(Q1 + t Q2).
///
/// Its coefficients cost little more than one factorisation, and every evaluation after that is a handful of
/// products. All coefficients are positive, so evaluation at t > 0 cancels little; the coefficients themselves lose
/// accuracy with the aspect ratio, which is why the rational form prepares what the quadratic forms finish.
#ifndef PW85_RATIONAL_HPP_INCLUDED
#define PW85_RATIONAL_HPP_INCLUDED

#include <pw85/evaluation.hpp>

namespace pw85::inline PW85_TARGET {

/// Coefficients in increasing powers of t; in two dimensions the last of each is zero.
template <class T, int D> struct RationalForm {
    Vector<T, D> v[3]; ///< adj(Q1 + t Q2) r12
    T a[3];            ///< a(t)
    T b[4];            ///< b(t)
};

/// The coefficient of t in adj(P + t Q).
template <class T>
constexpr SymmetricMatrix<T, 3> mixed_adjugate(SymmetricMatrix<T, 3> const &p, SymmetricMatrix<T, 3> const &q) noexcept
{
    return {(p[3] * q[5] + q[3] * p[5]) - T(2) * p[4] * q[4],
            (p[2] * q[4] + q[2] * p[4]) - (p[1] * q[5] + q[1] * p[5]),
            (p[1] * q[4] + q[1] * p[4]) - (p[2] * q[3] + q[2] * p[3]),
            (p[0] * q[5] + q[0] * p[5]) - T(2) * p[2] * q[2],
            (p[1] * q[2] + q[1] * p[2]) - (p[0] * q[4] + q[0] * p[4]),
            (p[0] * q[3] + q[0] * p[3]) - T(2) * p[1] * q[1]};
}

template <class T> constexpr RationalForm<T, 2> rational_form(Pair<T, 2> const &pair) noexcept
{
    auto const adj1 = adjugate(pair.q1), adj2 = adjugate(pair.q2);
    auto const v0 = product(adj1, pair.r12), v1 = product(adj2, pair.r12);
    return {{v0, v1, {T(0), T(0)}},
            {dot(pair.r12, v0), dot(pair.r12, v1), T(0)},
            {determinant(pair.q1, adj1), contraction(adj1, pair.q2), determinant(pair.q2, adj2), T(0)}};
}

template <class T> constexpr RationalForm<T, 3> rational_form(Pair<T, 3> const &pair) noexcept
{
    auto const adj1 = adjugate(pair.q1), adj2 = adjugate(pair.q2);
    auto const v0 = product(adj1, pair.r12), v2 = product(adj2, pair.r12);
    auto const v1 = product(mixed_adjugate(pair.q1, pair.q2), pair.r12);
    return {{v0, v1, v2},
            {dot(pair.r12, v0), dot(pair.r12, v1), dot(pair.r12, v2)},
            {determinant(pair.q1, adj1), contraction(adj1, pair.q2), contraction(adj2, pair.q1),
             determinant(pair.q2, adj2)}};
}

template <class T, int D> constexpr T evaluate_a(RationalForm<T, D> const &form, T const &t) noexcept
{
    return (form.a[2] * t + form.a[1]) * t + form.a[0];
}

template <class T, int D> constexpr T evaluate_b(RationalForm<T, D> const &form, T const &t) noexcept
{
    return (form.b[1] * t + form.b[0]) + (t * t) * (form.b[3] * t + form.b[2]);
}

/// s = (Q1 + t Q2)⁻¹ r12 times det(Q1 + t Q2).
template <class T, int D> constexpr Vector<T, D> evaluate_s(RationalForm<T, D> const &form, T const &t) noexcept
{
    Vector<T, D> s{};
    for (int i = 0; i < D; ++i) s[i] = (form.v[2][i] * t + form.v[1][i]) * t + form.v[0][i];
    return s;
}

/// A and B and their derivatives, all times b². With R = a/b: B = -R' and A = R + tR', hence b²B = N and
/// b²A = ab - tN with N = ab' - a'b.
template <class T, int D> constexpr Jet<T> evaluate_jet(RationalForm<T, D> const &form, T const &t) noexcept
{
    T const c = form.b[3] * t;
    T const a = evaluate_a(form, t), b = evaluate_b(form, t);
    T const a1 = T(2) * form.a[2] * t + form.a[1], a2 = T(2) * form.a[2];
    T const b1 = (T(3) * c + T(2) * form.b[2]) * t + form.b[1], b2 = T(6) * c + T(2) * form.b[2];
    T const b3 = T(6) * form.b[3];
    T const n = a * b1 - a1 * b, n1 = a * b2 - a2 * b, n2 = (a * b3 - a2 * b1) + a1 * b2;
    return {a * b - t * n,
            T(2) * a1 * b - t * n1,
            T(2) * (a2 * b + a1 * b1) - n1 - t * n2,
            n,
            n1,
            n2,
            rough_quotient(T(t * b1), b)};
}

/// det M over the product of its diagonal, in (0, 1]: what the accuracy of the rational form at t depends on.
///
/// Scale M to a unit diagonal, with determinant d. Every product in a cofactor scales alike, so the entries of the
/// adjugate err by at most 12 u, b by 16 u/d of itself, and s by e with |e| <= 3·3·12 u/d of itself in the norm of M,
/// since the largest eigenvalue is at most 3.
template <class T, int D>
constexpr T conditioning(RationalForm<T, D> const &form, Pair<T, D> const &pair, T const &t) noexcept
{
    T diagonal = pair.q1(0, 0) + t * pair.q2(0, 0);
    for (int i = 1; i < D; ++i) diagonal = diagonal * (pair.q1(i, i) + t * pair.q2(i, i));
    return evaluate_b(form, t) / diagonal;
}

/// Conditioning above which the rational form is right to some per cent: a fair guide to the root.
template <class T> constexpr T rough_conditioning() noexcept { return T(1024) * unit_roundoff<T>(); }

/// Conditioning above which |e|² < u/8: the error of s adds less than a rounding error to a stationary value.
template <class T> constexpr T fine_conditioning() noexcept
{
    return negative_power_of_two<T>(maximum(mantissa_digits<T>() / 2 - 8, 0));
}

} // namespace pw85::inline PW85_TARGET

#endif
