// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Matrices whose size is known at run time, with rows of that length, and their Cholesky factors.
/// The searches for weights (core_set.hpp) and for moments (max_det.hpp) use them.
#ifndef PW85_ENCLOSING_CHOLESKY_HPP_INCLUDED
#define PW85_ENCLOSING_CHOLESKY_HPP_INCLUDED

#include "cloud.hpp"

namespace pw85::detail::enclosing {

inline constexpr std::size_t max_lifted = max_dimension + 1;

/// A d×d matrix, with rows of the length d.
template <class T> struct Square {
    T x[max_lifted * max_lifted];
};

template <class T> PW85_FUNCTION inline T dot(std::size_t n, T const *x, T const *y) noexcept
{
    T sum = T(0);
    for (std::size_t i = 0; i < n; ++i) sum = sum + x[i] * y[i];
    return sum;
}

/// Replaces the lower triangle of a matrix by its Cholesky factor L. A pivot that is not above
/// `share` of its diagonal entry is raised to that value, and its direction then has no influence.
/// Returns false if there was such a pivot.
template <class T> PW85_FUNCTION inline bool factorize(std::size_t n, T *a, double share) noexcept
{
    bool definite = true;
    for (std::size_t i = 0; i < n; ++i) {
        T *const row = a + i * n;
        T const least = T(share) * row[i];
        for (std::size_t j = 0; j < i; ++j)
            row[j] = (row[j] - dot(j, row, a + j * n)) / a[j * n + j];
        T const pivot = row[i] - dot(i, row, row);
        definite &= pivot > least;
        row[i] = square_root(pivot > least ? pivot : least);
    }
    return definite;
}

/// The template for numbers with twice the digits, compiled once, in frame.cpp.
bool factorize(std::size_t n, Wide *a, double share) noexcept;

/// Replaces x by L⁻¹ x.
template <class T> PW85_FUNCTION inline void substitute(std::size_t n, T const *a, T *x) noexcept
{
    for (std::size_t i = 0; i < n; ++i) x[i] = (x[i] - dot(i, a + i * n, x)) / a[i * n + i];
}

/// Replaces x by L⁻ᵀ x.
template <class T>
PW85_FUNCTION inline void substitute_back(std::size_t n, T const *a, T *x) noexcept
{
    for (std::size_t i = n; i-- > 0;) {
        x[i] = x[i] / a[i * n + i];
        for (std::size_t j = 0; j < i; ++j) x[j] = x[j] - a[i * n + j] * x[i];
    }
}

} // namespace pw85::detail::enclosing

#endif
