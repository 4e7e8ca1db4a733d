// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Reads 3×3 matrices of any type: T[3][3], arrays of arrays, matrices of Eigen, factors.
/// contact/rotations.hpp calls matrix_entry().
#ifndef PW85_ALGEBRA_MATRIX_ENTRIES_HPP_INCLUDED
#define PW85_ALGEBRA_MATRIX_ENTRIES_HPP_INCLUDED

#include <concepts>
#include <utility>

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// r(i, j), as of SymmetricMatrix, Factor and Eigen.
template <class T, class Matrix>
concept HasCall = requires(Matrix const &r, int i)
{
    {
        T(r(i, i))
        } -> std::same_as<T>;
};

/// r[i][j].
template <class T, class Matrix>
concept HasRows = requires(Matrix const &r, int i)
{
    {
        T(r[i][i])
        } -> std::same_as<T>;
}
|| requires(Matrix const &r, std::size_t i)
{
    {
        T(r[i][i])
        } -> std::same_as<T>;
};

/// r[3 i + j] of nine numbers.
template <class T, class Matrix>
concept IsFlat = std::tuple_size<Matrix>::value == 9 && requires(Matrix const &r)
{
    {
        T(r[8])
        } -> std::same_as<T>;
};

template <class T, class Matrix>
concept IsRotationOf = HasCall<T, Matrix> || HasRows<T, Matrix> || IsFlat<T, Matrix>;

/// The element with a number. Containers of the standard library take it as their unsigned type,
/// arrays and the types of this library as an int.
template <class Array>
PW85_FUNCTION constexpr decltype(auto) element(Array const &a, int i) noexcept
{
    if constexpr (requires { typename Array::size_type; })
        return a[static_cast<typename Array::size_type>(i)];
    else
        return a[i];
}

/// The entry in row i and column j.
template <class T, class Matrix>
requires IsRotationOf<T, Matrix> PW85_FUNCTION constexpr T matrix_entry(Matrix const &r, int i,
                                                                        int j) noexcept
{
    if constexpr (HasCall<T, Matrix>)
        return T(r(i, j));
    else if constexpr (HasRows<T, Matrix>)
        return T(element(element(r, i), j));
    else
        return T(element(r, 3 * i + j));
}

} // namespace pw85::detail

#endif
