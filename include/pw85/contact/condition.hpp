// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The entrywise condition number of the contact function. It states how many digits of μ² the data
/// determine. The overlap test (certified_value.hpp) uses it to bound the error of μ². The linear
/// equations are solved by geometry.hpp.
#ifndef PW85_CONTACT_CONDITION_HPP_INCLUDED
#define PW85_CONTACT_CONDITION_HPP_INCLUDED

#include <pw85/contact/geometry.hpp>

namespace pw85 {

/// A condition number. It is NaN if the status is not success.
template <class T> struct Condition {
    T condition;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The sum Σ(|Q1_ij| + t |Q2_ij|)|s_i s_j| + 2 Σ|r_i s_i|, where s = (Q1 + tQ2)⁻¹r. The condition
/// number is this sum divided by rᵀs.
template <class T, int D> PW85_FUNCTION inline T condition_sum(Pair<T, D> const &pair, T const &t,
                                                               Vector<T, D> const &s) noexcept
{
    T forms = T(0);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            forms = forms + (absolute(pair.q1(i, j)) + t * absolute(pair.q2(i, j))) *
                                absolute(T(s[i] * s[j]));
    return forms + T(2) * magnitude_of_dot(pair.r12, s);
}

/// The condition number at λ of a pair that is in range.
template <class T, int D> PW85_FUNCTION inline T
condition_number(Pair<T, D> const &pair, T const &lambda, T const &complement) noexcept
{
    T const t = lambda / pair.ratio / complement / pair.ratio;
    Vector<T, D> const s = solve_blend(T(1), pair.q1, t, pair.q2, pair.r12);
    return condition_sum(pair, t, s) / dot(pair.r12, s);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Condition<T>
condition(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
          T const &lambda) noexcept
{
    using namespace detail;
    ScaledPair<T, D> scaled;
    StatusCode const status = lambda >= T(0) && lambda <= T(1)
                                  ? validate_pair(pair_of(r12, q1, q2), scaled)
                                  : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<Condition<T>>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), StatusCode::success};
    T const complement = complement_of(lambda);
    return {scaled.units.swapped ? condition_number(scaled.pair, complement, lambda)
                                 : condition_number(scaled.pair, lambda, complement),
            StatusCode::success};
}

} // namespace pw85

#endif
