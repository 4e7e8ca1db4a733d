// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rational form of f: rᵀ(Q1 + t Q2)⁻¹r = a(t)/b(t) with a = rᵀ adj(Q1 + t Q2) r and b =
/// det(Q1 + t Q2).
///
/// Its coefficients cost little more than one factorisation, and then each evaluation costs a few
/// products. All coefficients are positive, and an evaluation at t > 0 cancels little. But the
/// coefficients lose accuracy with the aspect ratio. So the search uses the rational form
/// (iteration.hpp), and its last evaluation uses the quadratic forms.
#ifndef PW85_CONTACT_RATIONAL_HPP_INCLUDED
#define PW85_CONTACT_RATIONAL_HPP_INCLUDED

#include <pw85/contact/evaluation.hpp>

namespace pw85::detail {

/// The coefficients, in increasing powers of t. In two dimensions the last coefficient of each
/// polynomial is zero.
template <class T> struct RationalForm {
    T a[3]; ///< of a(t)
    T b[4]; ///< of b(t)
};

/// The coefficient of t in adj(P + t Q).
template <class T> PW85_FUNCTION constexpr SymmetricMatrix<T, 3>
mixed_adjugate(SymmetricMatrix<T, 3> const &p, SymmetricMatrix<T, 3> const &q) noexcept
{
    return {(p[3] * q[5] + q[3] * p[5]) - T(2) * p[4] * q[4],
            (p[2] * q[4] + q[2] * p[4]) - (p[1] * q[5] + q[1] * p[5]),
            (p[1] * q[4] + q[1] * p[4]) - (p[2] * q[3] + q[2] * p[3]),
            (p[0] * q[5] + q[0] * p[5]) - T(2) * p[2] * q[2],
            (p[1] * q[2] + q[1] * p[2]) - (p[0] * q[4] + q[0] * p[4]),
            (p[0] * q[3] + q[0] * p[3]) - T(2) * p[1] * q[1]};
}

template <class T>
PW85_FUNCTION constexpr RationalForm<T> rational_form(Pair<T, 2> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    auto const adj1 = adjugate(pair.q1), adj2 = adjugate(pair.q2);
    return {
        {quadratic_form(adj1, weights), quadratic_form(adj2, weights), T(0)},
        {determinant(pair.q1, adj1), contraction(adj1, pair.q2), determinant(pair.q2, adj2), T(0)}};
}

template <class T>
PW85_FUNCTION constexpr RationalForm<T> rational_form(Pair<T, 3> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    auto const adj1 = adjugate(pair.q1), adj2 = adjugate(pair.q2);
    return {{quadratic_form(adj1, weights),
             quadratic_form(mixed_adjugate(pair.q1, pair.q2), weights),
             quadratic_form(adj2, weights)},
            {determinant(pair.q1, adj1), contraction(adj1, pair.q2), contraction(adj2, pair.q1),
             determinant(pair.q2, adj2)}};
}

template <class T>
PW85_FUNCTION constexpr T evaluate_a(RationalForm<T> const &form, T const &t) noexcept
{
    return (form.a[2] * t + form.a[1]) * t + form.a[0];
}

template <class T>
PW85_FUNCTION constexpr T evaluate_b(RationalForm<T> const &form, T const &t) noexcept
{
    return (form.b[1] * t + form.b[0]) + (t * t) * (form.b[3] * t + form.b[2]);
}

/// A and B and their derivatives, all times b². With R = a/b: B = -R' and A = R + tR'. Hence b²B =
/// N and b²A = ab - tN, where N = ab' - a'b.
template <class T>
PW85_FUNCTION constexpr Jet<T> evaluate_jet(RationalForm<T> const &form, T const &t) noexcept
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

// The conditioning of M at t is the determinant of M divided by the product P of its diagonal. It
// is in (0, 1]. Scale M to a unit diagonal. Then the entries of M and of adj M are at most 1. Let d
// be its determinant.

/// The conditioning above which the rational form is correct to some per cent, which is enough to
/// guide a search to the root. Computed from the coefficients, b errs by 60 u/d of itself: 10
/// roundings in a sum of products that is at most 6. a errs by 198 u/d: 11 roundings in a sum that
/// is at most 6|r|², where a is at least d|r|²/3. (Theorem `counts` of tests/bounds/proofs.cpp has
/// the roundings and sums.)
template <class T> PW85_FUNCTION constexpr T rough_conditioning() noexcept
{
    return T(1024 * unit_roundoff<T>());
}

/// The solution of M s = det(M) x by the adjugate.
template <class T, int D> struct AdjugateSolution {
    Vector<T, D> s;
    T determinant;
    T diagonal; ///< product of the diagonal of M
};

template <class T, int D> PW85_FUNCTION constexpr AdjugateSolution<T, D>
solve_by_adjugate(SymmetricMatrix<T, D> const &m, Vector<T, D> const &x) noexcept
{
    auto const adj = adjugate(m);
    return {product(adj, x), determinant(m, adj), diagonal_product(m)};
}

} // namespace pw85::detail

#endif
