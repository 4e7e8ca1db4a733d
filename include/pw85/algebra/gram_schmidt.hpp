/// @file
/// The factorisation K = U R of two stacked square matrices by pivoted Gram–Schmidt orthogonalisation, for forms that are given by
/// square roots. contact/contact_factored.hpp calls orthogonalize() and the solvers below.
///
/// Each place takes the longest column that remains. A column that has mostly cancelled is made orthogonal to the earlier ones once
/// more. Then the rounding errors in a row of K are a few u times the entries of that row. This holds also if the lengths of the
/// rows differ by many orders of magnitude. (For Householder's method this is a theorem of A. J. Cox and N. J. Higham, in:
/// Numerical Analysis 1997, Longman, 57, 1998. Here tests/test_factored.cpp checks it.)
#ifndef PW85_ALGEBRA_GRAM_SCHMIDT_HPP_INCLUDED
#define PW85_ALGEBRA_GRAM_SCHMIDT_HPP_INCLUDED

#include <pw85/algebra/vector.hpp>

namespace pw85::detail {

/// A vector of 2D coordinates, in two halves.
template <class T, int D> struct StackedVector {
    Vector<T, D> upper, lower;
};

template <class T, int D>
PW85_FUNCTION constexpr T dot(StackedVector<T, D> const &x, StackedVector<T, D> const &y) noexcept
{
    return dot(x.upper, y.upper) + dot(x.lower, y.lower);
}

template <class T, int D>
PW85_FUNCTION constexpr StackedVector<T, D> operator*(T const &factor, StackedVector<T, D> const &x) noexcept
{
    return {factor * x.upper, factor * x.lower};
}

template <class T, int D> PW85_FUNCTION constexpr StackedVector<T, D>
add_scaled(StackedVector<T, D> const &x, T const &factor, StackedVector<T, D> const &y) noexcept
{
    return {add_scaled(x.upper, factor, y.upper), add_scaled(x.lower, factor, y.lower)};
}

/// The factors of K = U R. The columns of U are orthonormal. Place j belongs to column order[j] of K, and to the same column of U
/// and R.
template <class T, int D> struct OrthogonalFactors {
    StackedVector<T, D> u[D]; ///< by column of K
    T r[D][D];                ///< by place and column of K, beside the diagonal
    T reciprocals[D];         ///< by place, of the diagonal of R
    int order[D];
};

/// Puts the longest of the remaining columns in place j. Returns the square of its length.
template <class T, int D> PW85_FUNCTION inline T choose_pivot(OrthogonalFactors<T, D> &f, int j) noexcept
{
    int const first = f.order[j];
    int longest = j;
    T square = dot(f.u[first], f.u[first]);
    for (int k = j + 1; k < D; ++k) {
        T const other = dot(f.u[f.order[k]], f.u[f.order[k]]);
        longest = other > square ? k : longest;
        square = maximum(square, other);
    }
    f.order[j] = f.order[longest];
    f.order[longest] = first;
    return square;
}

/// Subtracts from a column its component along the column in place i.
template <class T, int D> PW85_FUNCTION inline void project_out(OrthogonalFactors<T, D> &f, int i, int column) noexcept
{
    auto const &unit = f.u[f.order[i]];
    T const component = dot(unit, f.u[column]);
    f.r[i][column] = f.r[i][column] + component;
    f.u[column] = add_scaled(f.u[column], T(-component), unit);
}

/// The square of the length of the column in place j. If the first projection leaves less than 2^-20 of the square, a second
/// one follows. The errors of the first projection are then at most some 2^10 u, and matter less than those of the coefficients.
template <class T, int D>
PW85_FUNCTION inline T project_again(OrthogonalFactors<T, D> &f, int j, T const &square) noexcept
{
    int const column = f.order[j];
    T removed = T(0);
    for (int i = 0; i < j; ++i) removed = removed + f.r[i][column] * f.r[i][column];
    if (square > negative_power_of_two<T>(20) * removed) return square;
    for (int i = 0; i < j; ++i) project_out(f, i, column);
    return dot(f.u[column], f.u[column]);
}

/// Computes the factors of the matrix with these columns.
template <class T, int D>
PW85_FUNCTION inline OrthogonalFactors<T, D> orthogonalize(StackedVector<T, D> const (&columns)[D]) noexcept
{
    OrthogonalFactors<T, D> f{};
    for (int j = 0; j < D; ++j) {
        f.u[j] = columns[j];
        f.order[j] = j;
    }
    for (int j = 0; j < D; ++j) {
        T const square = project_again(f, j, choose_pivot(f, j));
        f.reciprocals[j] = T(1) / square_root(square);
        f.u[f.order[j]] = f.reciprocals[j] * f.u[f.order[j]];
        for (int k = j + 1; k < D; ++k) project_out(f, j, f.order[k]);
    }
    return f;
}

/// y = R⁻ᵀ x, by place, so that y·y = xᵀ(KᵀK)⁻¹x.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_transposed(OrthogonalFactors<T, D> const &f, Vector<T, D> const &x) noexcept
{
    Vector<T, D> y{};
    for (int j = 0; j < D; ++j) {
        T sum = x[f.order[j]];
        for (int i = 0; i < j; ++i) sum = sum - f.r[i][f.order[j]] * y[i];
        y[j] = sum * f.reciprocals[j];
    }
    return y;
}

/// R⁻¹ y. For y from solve_transposed() the result is (KᵀK)⁻¹x.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_triangle(OrthogonalFactors<T, D> const &f, Vector<T, D> const &y) noexcept
{
    Vector<T, D> x{};
    for (int j = D - 1; j >= 0; --j) {
        T sum = y[j];
        for (int k = j + 1; k < D; ++k) sum = sum - f.r[j][f.order[k]] * x[f.order[k]];
        x[f.order[j]] = sum * f.reciprocals[j];
    }
    return x;
}

/// U y, with y by place.
template <class T, int D>
PW85_FUNCTION inline StackedVector<T, D> combine(OrthogonalFactors<T, D> const &f, Vector<T, D> const &y) noexcept
{
    StackedVector<T, D> sum = y[0] * f.u[f.order[0]];
    for (int j = 1; j < D; ++j) sum = add_scaled(sum, y[j], f.u[f.order[j]]);
    return sum;
}

} // namespace pw85::detail

#endif
