// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The function f and its derivatives, by factorisation of the blended form. The searches
/// (iteration.hpp), the rational form and the derivatives (geometry.hpp, contact_hessian.hpp) use
/// this file.
///
/// With N = α Q1 + β Q2 and s = N⁻¹ r:
///
/// 1. (α, β) = (1-λ, λ) gives f(λ) = λ(1-λ) rᵀs, f' = (1-λ)² sᵀQ1s - λ² sᵀQ2s = μ1² - μ2², and f''
///    = -2 rᵀs - 2(1-2λ) sᵀu + 2λ(1-λ) uᵀv, where u = (Q2 - Q1) s and v = N⁻¹u.
/// 2. (α, β) = (1, t) gives A = sᵀQ1s and B = sᵀQ2s. With v = N⁻¹Q2s, A' = -2 vᵀQ1s, B' = -2 vᵀQ2s,
///    A'' = 6 vᵀQ1v and B'' = 6 vᵀQ2v. To see this, use the eigenbasis of the pencil (Q1, Q2), with
///    eigenvalues d and p = 1/(1 + t d). In this basis the six values are sums of the terms p², d
///    p², -2 d p³, -2 d² p³, 6 d² p⁴ and 6 d³ p⁴. So one more solve gives two derivatives of both A
///    and B.
#ifndef PW85_CONTACT_EVALUATION_HPP_INCLUDED
#define PW85_CONTACT_EVALUATION_HPP_INCLUDED

#include <pw85/contact/scaling.hpp>

namespace pw85::detail {

/// f and its first two derivatives at one λ.
template <class T> struct Derivatives {
    T f;
    T first;
    T second;
};

/// A and B of item 2 with their derivatives in t. All are multiplied by the same positive factor
/// g(t).
template <class T> struct Jet {
    T a, a1, a2;
    T b, b1, b2;
    T log_factor; ///< ½ d(log g)/d(log t)
};

/// The factorisation of N = α Q1 + β Q2. A blend of two positive definite forms is positive
/// definite. So pivots that rounding errors make too small are raised to the size of these errors.
template <class T, int D> PW85_FUNCTION constexpr Factorization<T, D>
factorize_blend(T const &alpha, SymmetricMatrix<T, D> const &q1, T const &beta,
                SymmetricMatrix<T, D> const &q2) noexcept
{
    return factorize(blend(alpha, q1, beta, q2), T(unit_roundoff<T>()));
}

/// f at λ (item 1).
template <class T, int D>
PW85_FUNCTION constexpr T evaluate_f(T const &lambda, Vector<T, D> const &r12,
                                     SymmetricMatrix<T, D> const &q1,
                                     SymmetricMatrix<T, D> const &q2) noexcept
{
    T const alpha = T(1) - lambda;
    return lambda * alpha * inverse_form(factorize_blend(alpha, q1, lambda, q2), r12);
}

/// f, f' and f'' at λ (item 1).
template <class T, int D> PW85_FUNCTION constexpr Derivatives<T>
evaluate_derivatives(T const &lambda, Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2) noexcept
{
    T const alpha = T(1) - lambda, weight = lambda * alpha;
    auto const factors = factorize_blend(alpha, q1, lambda, q2);
    Vector<T, D> const s = solve(factors, r12);
    Vector<T, D> const p = product(q1, s), q = product(q2, s);
    Vector<T, D> const u = q - p;
    T const rs = inverse_form(factors, r12), su = dot(s, u), uv = dot(u, solve(factors, u));
    return {weight * rs, alpha * alpha * dot(s, p) - lambda * lambda * dot(s, q),
            T(2) * (weight * uv - rs - (alpha - lambda) * su)};
}

/// Σ Q_ii s_i² from the outer weights of s. Divided by D, it is a lower bound on the largest sᵀQs
/// among all s with these magnitudes of coordinates. Times D, it is an upper bound on Σ |s_i Q_ij
/// s_j|.
template <class T, int D> PW85_FUNCTION constexpr T
diagonal_form(SymmetricMatrix<T, D> const &q, SymmetricMatrix<T, D> const &weights) noexcept
{
    T sum = weights(0, 0) * q(0, 0);
    for (int i = 1; i < D; ++i) sum = sum + weights(i, i) * q(i, i);
    return sum;
}

/// A computed sᵀQs, raised to at least its own rounding error. So it is positive if s != 0 and the
/// diagonal is positive. `weights` are the outer weights of s.
template <class T, int D>
PW85_FUNCTION constexpr T raise_form(T const &form, SymmetricMatrix<T, D> const &q,
                                     SymmetricMatrix<T, D> const &weights) noexcept
{
    return maximum(form, T(T(unit_roundoff<T>()) * diagonal_form(q, weights)));
}

/// sᵀQs from the outer weights of s. It is positive.
template <class T, int D> PW85_FUNCTION constexpr T
positive_form(SymmetricMatrix<T, D> const &q, SymmetricMatrix<T, D> const &weights) noexcept
{
    return raise_form(quadratic_form(q, weights), q, weights);
}

/// sᵀQs from Qs. It is positive.
template <class T, int D> PW85_FUNCTION constexpr T positive_form(SymmetricMatrix<T, D> const &q,
                                                                  Vector<T, D> const &s,
                                                                  Vector<T, D> const &qs) noexcept
{
    return raise_form(dot(s, qs), q, outer_weights(s));
}

/// A, B and their derivatives at t (item 2), divided by A, from the factors of M and s = M⁻¹r12.
/// These numbers have similar magnitudes for any aspect ratio.
template <class T, int D>
PW85_FUNCTION constexpr Jet<T> evaluate_jet(Pair<T, D> const &pair,
                                            Factorization<T, D> const &factors,
                                            Vector<T, D> const &s) noexcept
{
    Vector<T, D> const p = product(pair.q1, s), q = product(pair.q2, s), v = solve(factors, q);
    auto const weights = outer_weights(s), change = outer_weights(v);
    T const a = positive_form(pair.q1, weights), b = positive_form(pair.q2, weights);
    return {T(1),  T(-2) * (dot(p, v) / a), T(6) * (quadratic_form(pair.q1, change) / a),
            b / a, T(-2) * (dot(q, v) / a), T(6) * (quadratic_form(pair.q2, change) / a),
            T(0)};
}

} // namespace pw85::detail

#endif
