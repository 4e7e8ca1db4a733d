// SPDX-License-Identifier: BSD-3-Clause
// The entrywise condition number of μ²: if each stored entry of a pair changes by at most ε
// relative to itself, μ² changes by at most ε·cond relative to itself, to first order. Accuracy is
// judged in units of u·cond.
#ifndef PW85_TESTS_CONDITION_NUMBER_HPP_INCLUDED
#define PW85_TESTS_CONDITION_NUMBER_HPP_INCLUDED

#include "sample.hpp"

namespace pw85_tests {

/// Σ |s_i A_ij s_j|.
template <class T, int D>
T absolute_form(pw85::SymmetricMatrix<T, D> const &a, pw85::Vector<T, D> const &s)
{
    T sum = T(0);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) sum = sum + pw85::detail::absolute(T(s[i] * a(i, j) * s[j]));
    return sum;
}

/// cond = [λ(1-λ) ((1-λ) Σ|s_i Q1_ij s_j| + λ Σ|s_i Q2_ij s_j|) + 2 λ(1-λ) Σ|r_i s_i|] / f(λ), s =
/// Q(λ)⁻¹ r: the condition number of f at λ, and at the maximiser that of μ².
template <class T, int D> T condition_number(Sample<T, D> const &p, T const &lambda)
{
    T const alpha = T(1) - lambda;
    auto const s =
        pw85::detail::solve(pw85::detail::factorize_blend(alpha, p.q1, lambda, p.q2), p.r12);
    T rs = T(0);
    for (int i = 0; i < D; ++i) rs = rs + pw85::detail::absolute(T(p.r12[i] * s[i]));
    T const forms = alpha * absolute_form(p.q1, s) + lambda * absolute_form(p.q2, s);
    return (forms + T(2) * rs) / pw85::dot(p.r12, s);
}

} // namespace pw85_tests

#endif
