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

#include <pw85/algebra/two_lanes.hpp>
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

/// Returns whether the rational form is that accurate at t. `diagonal` is P.
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr bool
guides_search(RationalForm<T> const &form, T const &t, T const &diagonal) noexcept
{
    return evaluate_b(form, t) >= rough_conditioning<T>() * diagonal;
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

// The rational form of one pair, computed from both forms side by side (two_lanes.hpp). Packs of
// lanes, which have one pair per lane, use the functions above.

/// A matrix of products of an entry of P with one of Q. The coefficient of t in adj(P + t Q) is the
/// sum of those of (P, Q) and (Q, P).
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<T, 3>
polar_adjugate(SymmetricMatrix<T, 3> const &p, SymmetricMatrix<T, 3> const &q) noexcept
{
    return {p[3] * q[5] - p[4] * q[4], p[2] * q[4] - p[1] * q[5], p[1] * q[4] - p[2] * q[3],
            p[0] * q[5] - p[2] * q[2], p[1] * q[2] - p[0] * q[4], p[0] * q[3] - p[1] * q[1]};
}

// The arguments are, in both lanes: q, which is Q1 and Q2; other, which is Q2 and Q1; the adjugate
// of q; the outer weights of r12. They are not a structure, because compilers would keep it in
// memory.

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr RationalForm<T>
rational_form(SymmetricMatrix<TwoLanes<T>, 2> const &q,
              SymmetricMatrix<TwoLanes<T>, 2> const &other,
              SymmetricMatrix<TwoLanes<T>, 2> const &adjugate_of_q,
              SymmetricMatrix<TwoLanes<T>, 2> const &weights) noexcept
{
    auto const a = quadratic_form(adjugate_of_q, weights), b = determinant(q, adjugate_of_q);
    return {{first_of(a), second_of(a), T(0)},
            {first_of(b), first_of(contraction(adjugate_of_q, other)), second_of(b), T(0)}};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr RationalForm<T>
rational_form(SymmetricMatrix<TwoLanes<T>, 3> const &q,
              SymmetricMatrix<TwoLanes<T>, 3> const &other,
              SymmetricMatrix<TwoLanes<T>, 3> const &adjugate_of_q,
              SymmetricMatrix<TwoLanes<T>, 3> const &weights) noexcept
{
    auto const a = quadratic_form(adjugate_of_q, weights), b = determinant(q, adjugate_of_q);
    auto const mixed_a = quadratic_form(polar_adjugate(q, other), weights);
    auto const mixed_b = contraction(adjugate_of_q, other);
    return {{first_of(a), first_of(mixed_a) + second_of(mixed_a), second_of(a)},
            {first_of(b), first_of(mixed_b), second_of(mixed_b), second_of(b)}};
}

/// b²A (first lanes) and b²B (second lanes) as polynomials in t of degree four. So a step waits for
/// no product of a and b. In two dimensions their degree is two. Their coefficients are positive.
template <class T> struct QuarticForms {
    TwoLanes<T> c[5];
    T b[4]; ///< the coefficients of b
};

/// The coefficients of b²B = ab' - a'b and of b²A = ab - t (ab' - a'b).
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr QuarticForms<T>
quartic_forms(RationalForm<T> const &form) noexcept
{
    auto const &[a, b] = form;
    TwoLanes<T> const a02(a[0], a[2]), a20(a[2], a[0]), a1(a[1]);
    TwoLanes<T> const b03(b[0], b[3]), b30(b[3], b[0]), b12(b[1], b[2]), b21(b[2], b[1]);
    // The coefficients of b²A from the first to the last, and those of b²B from the last to the
    // first, have the same formulas.
    auto const two = TwoLanes<T>(2), e0 = a02 * b03, e1 = two * a1 * b03;
    auto const e2 = TwoLanes<T>(3) * a20 * b03 + (a1 * b12 - a02 * b21);
    auto const e3 = two * (a20 * b12 - a02 * b30), e4 = a20 * b21 - a1 * b30;
    return {{{first_of(e0), second_of(e4)},
             {first_of(e1), second_of(e3)},
             e2,
             {first_of(e3), second_of(e1)},
             {first_of(e4), second_of(e0)}},
            {b[0], b[1], b[2], b[3]}};
}

/// A and B and their derivatives, all times b².
template <class T>
PW85_FUNCTION constexpr Jet<T> evaluate_jet(QuarticForms<T> const &form, T const &t) noexcept
{
    auto const &[c, b] = form;
    TwoLanes<T> const x(t), square(T(t * t)), two(2), three(3), four(4), six(6), twelve(12);
    auto const value = ((c[4] * x + c[3]) * square + (c[2] * x + c[1])) * x + c[0];
    auto const slope = (four * c[4] * x + three * c[3]) * square + (two * c[2] * x + c[1]);
    auto const curvature = twelve * c[4] * square + (six * c[3] * x + two * c[2]);
    T const b_value = (b[1] * t + b[0]) + (t * t) * (b[3] * t + b[2]);
    T const b_slope = (T(3) * b[3] * t + T(2) * b[2]) * t + b[1];
    return {first_of(value),
            first_of(slope),
            first_of(curvature),
            second_of(value),
            second_of(slope),
            second_of(curvature),
            rough_quotient(T(t * b_slope), b_value)};
}

/// The form on which a search of one pair takes its steps. On devices it is the one that needs
/// fewer registers.
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr auto
form_of_steps(RationalForm<T> const &form) noexcept
{
    if constexpr (is_for_device)
        return form;
    else
        return quartic_forms(form);
}

template <class T> using FormOfSteps =
    std::conditional_t<is_for_device, RationalForm<T>, QuarticForms<T>>;

} // namespace pw85::detail

#endif
