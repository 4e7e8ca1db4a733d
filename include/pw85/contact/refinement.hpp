// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Iterative refinement of a solution of (Q1 + t Q2) s = r12, with a residual in twice the working
/// precision. Each coordinate of the refined s is correct to rounding, even if the matrix is
/// ill-conditioned. factorized_search.hpp calls refine().
#ifndef PW85_CONTACT_REFINEMENT_HPP_INCLUDED
#define PW85_CONTACT_REFINEMENT_HPP_INCLUDED

#include <pw85/algebra/error_free.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85::detail {

/// r12 - (Q1 + t Q2) s.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
residual(Pair<T, D> const &pair, T const &t, Vector<T, D> const &s) noexcept
{
    Parts<T> const tau = split(t);
    Vector<T, D> result{};
    for (int i = 0; i < D; ++i) {
        CompensatedSum<T> sum{pair.r12[i], T(0)};
        for (int j = 0; j < D; ++j) {
            Parts<T> const x = split(s[j]), q = split(pair.q2(i, j));
            subtract_product(sum, split(pair.q1(i, j)), x);
            T const products[4] = {tau.high * q.high, tau.high * q.low, tau.low * q.high,
                                   tau.low * q.low};
            for (T const &product : products) subtract_product(sum, split(product), x);
        }
        result[i] = sum.sum + sum.rest;
    }
    return result;
}

/// Corrects s three times. Each correction reduces the error by the factor u κ, where κ is the
/// condition number of the matrix, scaled to a unit diagonal.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> refine(Pair<T, D> const &pair, T const &t,
                                         Factorization<T, D> const &factors,
                                         Vector<T, D> s) noexcept
{
    for (int n = 0; n < 3; ++n) s = s + solve(factors, residual(pair, t, s));
    return s;
}

} // namespace pw85::detail

#endif
