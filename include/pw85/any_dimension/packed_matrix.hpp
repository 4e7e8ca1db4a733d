// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Linear algebra in n dimensions, 1 <= n <= 16, with n known at run time: packed symmetric
/// matrices, their factorisation L D Lᵀ, solution of linear equations, determinant. All headers of
/// any_dimension/ use it.
///
/// The functions with loops over a matrix are not inlined, because their code is long and their
/// loops are longer than a call.
///
/// A packed matrix consists of the rows of its upper triangle, one after the other: n (n + 1)/2
/// numbers, in the order xx, xy, xz, yy, yz, zz for n = 3. Functions use arrays of the caller,
/// because the memory for wide numbers is not always on the stack.
#ifndef PW85_ANY_DIMENSION_PACKED_MATRIX_HPP_INCLUDED
#define PW85_ANY_DIMENSION_PACKED_MATRIX_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>

namespace pw85::detail::any_dimension {

inline constexpr int max_dimension = 16;

/// Returns the number of entries of a packed matrix.
PW85_FUNCTION constexpr int packed_size(int n) noexcept { return n * (n + 1) / 2; }

inline constexpr int max_packed_size = packed_size(max_dimension);

/// A number of dimensions that is known at compile time. Functions whose type of n is a template
/// parameter N take such a number, or an int. The results have the same bits.
template <int D> struct Dimension {
    PW85_MEMBER constexpr operator int() const noexcept { return D; }
};

/// The largest number of dimensions of a type N.
template <class N> inline constexpr int capacity = max_dimension;
template <int D> inline constexpr int capacity<Dimension<D>> = D;

/// Returns the position at which row i would begin if it had entries below the diagonal: entry (i,
/// j) with i <= j is at row_offset(n, i) + j.
PW85_FUNCTION constexpr int row_offset(int n, int i) noexcept { return i * (2 * n - i - 1) / 2; }

/// Returns the place of entry (i, j) = (j, i).
PW85_FUNCTION constexpr int packed_index(int n, int i, int j) noexcept
{
    return i <= j ? row_offset(n, i) + j : row_offset(n, j) + i;
}

/// A bound on the relative error of one operation. For Doubled numbers it is 16 u² with the u of
/// double, four times the declared unit roundoff.
template <class T> PW85_FUNCTION constexpr T operation_error() noexcept
{
    return T(4) * T(unit_roundoff<T>());
}

/// Σ x_i y_i. Four partial sums shorten the chain of additions, and the error.
template <class T, class N> PW85_FUNCTION inline T dot(N n, T const *x, T const *y) noexcept
{
    T sums[4] = {T(0), T(0), T(0), T(0)};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; ++k) sums[k] = sums[k] + x[i + k] * y[i + k];
    for (; i < n; ++i) sums[0] = sums[0] + x[i] * y[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// y = A x.
template <class T, class N>
[[gnu::noinline]] PW85_FUNCTION inline void product(N n, T const *a, T const *x, T *y) noexcept
{
    for (int i = 0; i < n; ++i) y[i] = T(0);
    for (int i = 0; i < n; ++i) {
        T const *const row = a + row_offset(n, i);
        T const xi = x[i];
        for (int j = i + 1; j < n; ++j) y[j] = y[j] + row[j] * xi;
        y[i] = y[i] + dot(n - i, row + i, x + i);
    }
}

/// xᵀAx, with half of the operations of product().
template <class T, class N>
[[gnu::noinline]] PW85_FUNCTION inline T quadratic_form(N n, T const *a, T const *x) noexcept
{
    T diagonal = T(0), rest = T(0);
    for (int i = 0; i < n; ++i) {
        T const *const row = a + row_offset(n, i);
        diagonal = diagonal + row[i] * (x[i] * x[i]);
        rest = rest + x[i] * dot(n - i - 1, row + i + 1, x + i + 1);
    }
    return diagonal + (rest + rest);
}

/// Factorises a matrix in place, A = L D Lᵀ. The rows of Lᵀ replace the rows of A, and the pivots D
/// are on the diagonal. Returns whether all pivots are positive. If a pivot is not, the rest is not
/// computed.
template <class T, class N>
[[gnu::noinline]] PW85_FUNCTION inline bool factorize(N n, T *a) noexcept
{
    for (int k = 0; k < n; ++k) {
        T *const pivot_row = a + row_offset(n, k);
        if (!(pivot_row[k] > T(0))) return false;
        T const inverse = T(1) / pivot_row[k];
        for (int i = k + 1; i < n; ++i) {
            T const multiplier = pivot_row[i] * inverse;
            T *const row = a + row_offset(n, i);
            for (int j = i; j < n; ++j) row[j] = row[j] - multiplier * pivot_row[j];
            pivot_row[i] = multiplier; // later rows need the entries j > i alone
        }
    }
    return true;
}

/// x = A⁻¹ b from the factors of A. x may be b.
template <class T, class N>
[[gnu::noinline]] PW85_FUNCTION inline void solve(N n, T const *factors, T const *b, T *x) noexcept
{
    for (int i = 0; i < n; ++i) x[i] = b[i];
    for (int k = 0; k < n; ++k) {
        T const *const row = factors + row_offset(n, k);
        for (int j = k + 1; j < n; ++j) x[j] = x[j] - row[j] * x[k];
    }
    for (int k = n - 1; k >= 0; --k) {
        T const *const row = factors + row_offset(n, k);
        x[k] = x[k] / row[k] - dot(n - k - 1, row + k + 1, x + k + 1);
    }
}

/// det A from the factors of A: the product of the pivots.
template <class T> PW85_FUNCTION inline T determinant(int n, T const *factors) noexcept
{
    T det = factors[0];
    for (int k = 1; k < n; ++k) det = det * factors[packed_index(n, k, k)];
    return det;
}

/// Returns a bound, in units of u, on the norm of E in A + E = L D Lᵀ relative to the diagonal:
/// xᵀEx <= n (n + 4) u Σ a_ii x_i². An entry is at most (n + 3) u √(a_ii a_jj)/(1 - (n + 3) u): N.
/// J. Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.5, with two more roundings
/// by the reciprocal of the pivot; |L| D |Lᵀ| has such entries by Cauchy and Schwarz. A matrix
/// whose entries have these bounds has the norm n times that of an entry.
///
/// For Doubled numbers the bound is n (n + 8) u, to first order in u. Their u is 4 · 2⁻¹⁰⁶. Sums
/// err by u times their terms, products by 2u and quotients by 4u (doubled.hpp). So a product adds
/// 2u instead of u, and the multiplier, a product with a reciprocal, 6u instead of 2u: 5u more.
PW85_FUNCTION constexpr int factorization_error(int n) noexcept { return n * (n + 4); }

/// Returns whether A - shift diag(A) has positive pivots. Then xᵀAx >= (shift - e) Σ a_ii x_i² for
/// every x, where e is the bound of factorization_error() and u for the rounding of the diagonal. A
/// is positive definite if the shift is larger than e. `memory` is for one matrix, and may be A.
template <class T, class N> PW85_FUNCTION inline bool
is_definite_with_shift(N n, T const *a, T const &shift, T *memory) noexcept
{
    for (int i = 0, k = 0; i < n; ++i)
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): a has all entries
        for (int j = i; j < n; ++j, ++k) memory[k] = i == j ? T(a[k] - shift * a[k]) : a[k];
    return factorize(n, memory);
}

} // namespace pw85::detail::any_dimension

#endif
