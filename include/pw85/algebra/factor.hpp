// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factors S of quadratic forms Q = S Sᵀ. They keep the digits that squares of lengths lose.
/// contact/factor.hpp, the batches and the C arrays use them.
#ifndef PW85_ALGEBRA_FACTOR_HPP_INCLUDED
#define PW85_ALGEBRA_FACTOR_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>

namespace pw85 {

/// A square matrix S that represents the form S Sᵀ. The columns of the factor of an ellipsoid may
/// be its semi-axes, as vectors.
template <class T, int D> struct Factor {
    static_assert(detail::require_scalar<T>());

    T entries[std::size_t(D * D)]; ///< row-major

    PW85_MEMBER constexpr T &operator()(int i, int j) noexcept { return entries[D * i + j]; }
    PW85_MEMBER constexpr T const &operator()(int i, int j) const noexcept
    {
        return entries[D * i + j];
    }
};

} // namespace pw85

namespace pw85::detail {

/// Converts the entries to another type by a constructor that takes a T.
template <class To, class T, int D>
PW85_FUNCTION constexpr Factor<To, D> converted(Factor<T, D> const &s) noexcept
{
    Factor<To, D> copy{};
    for (int i = 0; i < D * D; ++i) copy.entries[i] = To(s.entries[i]);
    return copy;
}

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> column(Factor<T, D> const &s, int j) noexcept
{
    Vector<T, D> x{};
    for (int i = 0; i < D; ++i) x[i] = s(i, j);
    return x;
}

template <class T, int D> PW85_FUNCTION constexpr T largest_entry(Factor<T, D> const &s) noexcept
{
    T largest = T(0);
    for (T const &x : s.entries) largest = maximum(largest, absolute(x));
    return largest;
}

template <class T, int D> PW85_FUNCTION constexpr bool is_finite(Factor<T, D> const &s) noexcept
{
    T zero = T(0);
    for (T const &x : s.entries) zero = zero + x * T(0);
    return zero == T(0);
}

template <class T, int D>
PW85_FUNCTION inline Factor<T, D> times_power_of_two(Factor<T, D> s, int exponent) noexcept
{
    multiply_by_power_of_two<D * D>(s.entries, exponent);
    return s;
}

/// S x.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> times(Factor<T, D> const &s, Vector<T, D> const &x) noexcept
{
    Vector<T, D> y{};
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) y[i] = y[i] + s(i, j) * x[j];
    return y;
}

/// Sᵀx.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
transposed_times(Factor<T, D> const &s, Vector<T, D> const &x) noexcept
{
    Vector<T, D> y{};
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) y[j] = y[j] + s(i, j) * x[i];
    return y;
}

/// S Sᵀ, with rounding errors.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<T, D>
form_of_factor(Factor<T, D> const &s) noexcept
{
    SymmetricMatrix<T, D> q{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            for (int k = 0; k < D; ++k) q(i, j) = q(i, j) + s(i, k) * s(j, k);
    return q;
}

} // namespace pw85::detail

#endif
