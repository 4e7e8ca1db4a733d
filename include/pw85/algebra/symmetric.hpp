// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Packed symmetric matrices, their products, and the factorisations that solve linear equations
/// with them. All algorithms of contact/, distance/, motion/ and overlap/ call them.
#ifndef PW85_ALGEBRA_SYMMETRIC_HPP_INCLUDED
#define PW85_ALGEBRA_SYMMETRIC_HPP_INCLUDED

#include <pw85/algebra/vector.hpp>

#include <utility>

namespace pw85 {

/// A symmetric matrix: its upper triangle in row-major order, (xx, xy, xz, yy, yz, zz) in three
/// dimensions.
template <class T, int D> struct SymmetricMatrix {
    static_assert(detail::require_scalar<T>());
    static constexpr int size = D * (D + 1) / 2;

    T entries[std::size_t(size)];

    /// Position of the entry in row i and column j of the upper triangle, i <= j.
    PW85_MEMBER static constexpr int index(int i, int j) noexcept
    {
        return i * D - i * (i - 1) / 2 + (j - i);
    }

    PW85_MEMBER constexpr T &operator[](int k) noexcept { return entries[k]; }
    PW85_MEMBER constexpr T const &operator[](int k) const noexcept { return entries[k]; }
    PW85_MEMBER constexpr T &operator()(int i, int j) noexcept
    {
        return entries[i <= j ? index(i, j) : index(j, i)];
    }
    PW85_MEMBER constexpr T const &operator()(int i, int j) const noexcept
    {
        return entries[i <= j ? index(i, j) : index(j, i)];
    }
};

template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
operator*(T const &factor, SymmetricMatrix<T, D> a) noexcept
{
    for (int k = 0; k < a.size; ++k) a[k] = factor * a[k];
    return a;
}

/// The product A x.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
product(SymmetricMatrix<T, D> const &a, Vector<T, D> const &x) noexcept
{
    Vector<T, D> y{};
    for (int i = 0; i < D; ++i) {
        y[i] = a(i, 0) * x[0];
        for (int j = 1; j < D; ++j) y[i] = y[i] + a(i, j) * x[j];
    }
    return y;
}

} // namespace pw85

namespace pw85::detail {

/// Converts the entries to another type, by a constructor that takes a T.
template <class To, class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<To, D> converted(SymmetricMatrix<T, D> const &a) noexcept
{
    SymmetricMatrix<To, D> b{};
    for (int k = 0; k < a.size; ++k) b[k] = To(a[k]);
    return b;
}

/// The weights w with xᵀ A x = Σ w_k a_k over the stored entries of A. One set of weights serves
/// several forms. The function is always inlined, like entrywise_sums(): in programs that use only
/// the headers, GCC would otherwise call both from the fast search.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<T, D>
outer_weights(Vector<T, D> const &x) noexcept
{
    SymmetricMatrix<T, D> w{};
    for (int i = 0; i < D; ++i) {
        T const twice = x[i] + x[i];
        w(i, i) = x[i] * x[i];
        for (int j = i + 1; j < D; ++j) w(i, j) = twice * x[j];
    }
    return w;
}

/// Σ a_ii b_ii and Σ a_ij b_ij over i < j.
template <class T> struct EntrywiseSums {
    T diagonal, rest;
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr EntrywiseSums<T>
entrywise_sums(SymmetricMatrix<T, D> const &a, SymmetricMatrix<T, D> const &b) noexcept
{
    T diagonal = a(0, 0) * b(0, 0), rest = a(0, 1) * b(0, 1);
    for (int i = 1; i < D; ++i) diagonal = diagonal + a(i, i) * b(i, i);
    for (int j = 2; j < D; ++j)
        for (int i = 0; i < j; ++i) rest = rest + a(i, j) * b(i, j);
    return {diagonal, rest};
}

/// The contraction A:B = tr(A·B).
template <class T, int D> PW85_FUNCTION constexpr T
contraction(SymmetricMatrix<T, D> const &a, SymmetricMatrix<T, D> const &b) noexcept
{
    auto const sums = entrywise_sums(a, b);
    return sums.diagonal + T(2) * sums.rest;
}

/// The quadratic form xᵀ A x, from the outer weights of x.
template <class T, int D> PW85_FUNCTION constexpr T
quadratic_form(SymmetricMatrix<T, D> const &a, SymmetricMatrix<T, D> const &weights) noexcept
{
    auto const sums = entrywise_sums(a, weights);
    return sums.diagonal + sums.rest;
}

/// The quadratic form xᵀ A x.
template <class T, int D> PW85_FUNCTION constexpr T quadratic_form(SymmetricMatrix<T, D> const &a,
                                                                   Vector<T, D> const &x) noexcept
{
    return quadratic_form(a, outer_weights(x));
}

/// The sum of the magnitudes of the products in xᵀAx. Relative errors ε of the entries of A change
/// xᵀAx by at most ε times this sum.
template <class T, int D> PW85_FUNCTION constexpr T
magnitude_of_form(SymmetricMatrix<T, D> const &a, Vector<T, D> const &x) noexcept
{
    auto const weights = outer_weights(x);
    T sum = absolute(T(weights[0] * a[0]));
    for (int k = 1; k < a.size; ++k) sum = sum + absolute(T(weights[k] * a[k]));
    return sum;
}

/// The blend α A + β B.
template <class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> blend(T const &alpha, SymmetricMatrix<T, D> const &a,
                                                    T const &beta,
                                                    SymmetricMatrix<T, D> const &b) noexcept
{
    SymmetricMatrix<T, D> c{};
    for (int k = 0; k < c.size; ++k) c[k] = alpha * a[k] + beta * b[k];
    return c;
}

/// The sum A + β B. It is not a loop, because compilers do not unroll all loops with -O2.
template <class T, int D, int... k>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> blend(SymmetricMatrix<T, D> const &a, T const &beta,
                                                    SymmetricMatrix<T, D> const &b,
                                                    std::integer_sequence<int, k...>) noexcept
{
    return {{a[k] + beta * b[k]...}};
}

template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
blend(SymmetricMatrix<T, D> const &a, T const &beta, SymmetricMatrix<T, D> const &b) noexcept
{
    return blend(a, beta, b, std::make_integer_sequence<int, SymmetricMatrix<T, D>::size>());
}

/// Returns whether all entries are finite.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_finite(SymmetricMatrix<T, D> const &a) noexcept
{
    T zero = a[0] * T(0);
    for (int k = 1; k < a.size; ++k) zero = zero + a[k] * T(0);
    return zero == T(0);
}

/// A + x I.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
plus_multiple_of_identity(SymmetricMatrix<T, D> a, T const &x) noexcept
{
    for (int i = 0; i < D; ++i) a(i, i) = a(i, i) + x;
    return a;
}

template <class T, int D> PW85_FUNCTION constexpr T trace(SymmetricMatrix<T, D> const &a) noexcept
{
    T sum = a(0, 0);
    for (int i = 1; i < D; ++i) sum = sum + a(i, i);
    return sum;
}

template <class T, int D>
PW85_FUNCTION constexpr T largest_diagonal(SymmetricMatrix<T, D> const &a) noexcept
{
    T largest = a(0, 0);
    for (int i = 1; i < D; ++i) largest = maximum(largest, a(i, i));
    return largest;
}

/// Returns whether all diagonal entries are positive.
template <class T, int D>
PW85_FUNCTION constexpr bool has_positive_diagonal(SymmetricMatrix<T, D> const &a) noexcept
{
    T smallest = a(0, 0);
    for (int i = 1; i < D; ++i) smallest = minimum(smallest, a(i, i));
    return smallest > T(0);
}

template <class T, int D>
PW85_FUNCTION constexpr T diagonal_product(SymmetricMatrix<T, D> const &a) noexcept
{
    T product = a(0, 0);
    for (int i = 1; i < D; ++i) product = product * a(i, i);
    return product;
}

/// The factorisation A = L·diag(d)·Lᵀ with L unit lower triangular.
template <class T, int D> struct Factorization {
    T lower[std::size_t(D)][std::size_t(D)]; ///< l[i][j] for j < i; other entries are not used
    T pivots[std::size_t(D)];                ///< d
    T reciprocals[std::size_t(D)];           ///< 1/d
};

/// Factorises a symmetric matrix. Pivots smaller than `floor` times the diagonal entry of `a` in
/// their place are raised to this value. With floor = u this changes `a` by no more than its own
/// rounding, and every pivot of a matrix with positive diagonal is positive. With floor = 0 and all
/// pivots positive, `a` is positive definite.
template <class T, int D> PW85_FUNCTION constexpr Factorization<T, D>
factorize(SymmetricMatrix<T, D> const &a, T const &floor) noexcept
{
    Factorization<T, D> f{};
    for (int j = 0; j < D; ++j) {
        T pivot = a(j, j);
        for (int k = 0; k < j; ++k) pivot = pivot - f.lower[j][k] * (f.lower[j][k] * f.pivots[k]);
        f.pivots[j] = maximum(pivot, T(floor * a(j, j)));
        f.reciprocals[j] = T(1) / f.pivots[j];
        for (int i = j + 1; i < D; ++i) {
            T entry = a(j, i);
            for (int k = 0; k < j; ++k)
                entry = entry - f.lower[i][k] * (f.lower[j][k] * f.pivots[k]);
            f.lower[i][j] = entry * f.reciprocals[j];
        }
    }
    return f;
}

/// L⁻¹ x.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
substitute_forward(Factorization<T, D> const &f, Vector<T, D> x) noexcept
{
    for (int i = 1; i < D; ++i)
        for (int j = 0; j < i; ++j) x[i] = x[i] - f.lower[i][j] * x[j];
    return x;
}

/// L⁻ᵀ diag(d)⁻¹ y.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
substitute_back(Factorization<T, D> const &f, Vector<T, D> y) noexcept
{
    for (int i = D - 1; i >= 0; --i) {
        y[i] = y[i] * f.reciprocals[i];
        for (int j = i + 1; j < D; ++j) y[i] = y[i] - f.lower[j][i] * y[j];
    }
    return y;
}

/// Solves A x = b by substitution.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D> solve(Factorization<T, D> const &f,
                                                                     Vector<T, D> const &b) noexcept
{
    return substitute_back(f, substitute_forward(f, b));
}

/// yᵀ diag(d)⁻¹ z. For y = L⁻¹ x and z = L⁻¹ w this is xᵀ A⁻¹ w.
template <class T, int D> PW85_FUNCTION constexpr T
dot_over_pivots(Factorization<T, D> const &f, Vector<T, D> const &y, Vector<T, D> const &z) noexcept
{
    T sum = y[0] * z[0] * f.reciprocals[0];
    for (int i = 1; i < D; ++i) sum = sum + y[i] * z[i] * f.reciprocals[i];
    return sum;
}

/// xᵀ A⁻¹ x, a sum of squares. It needs only forward substitution.
template <class T, int D>
PW85_FUNCTION constexpr T inverse_form(Factorization<T, D> const &f, Vector<T, D> const &x) noexcept
{
    Vector<T, D> const y = substitute_forward(f, x);
    return dot_over_pivots(f, y, y);
}

} // namespace pw85::detail

namespace pw85 {

/// The Cholesky factor L, A = L·Lᵀ, stored by columns like the upper triangle of its transpose. All
/// entries are NaN unless A is positive definite to working precision.
template <class T, int D>
PW85_FUNCTION inline SymmetricMatrix<T, D> cholesky(SymmetricMatrix<T, D> const &a) noexcept
{
    using namespace detail;
    Factorization<T, D> const f = factorize(a, T(0));
    SymmetricMatrix<T, D> l{};
    bool positive = true;
    for (int j = 0; j < D; ++j) {
        positive = positive && f.pivots[j] > T(0);
        T const root = positive ? square_root(f.pivots[j]) : quiet_nan<T>();
        l(j, j) = root;
        for (int i = j + 1; i < D; ++i) l(j, i) = f.lower[i][j] * root;
    }
    for (int k = 0; !positive && k < l.size; ++k) l[k] = quiet_nan<T>();
    return l;
}

/// Solves L·Lᵀ x = b with L from cholesky().
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
cholesky_solve(SymmetricMatrix<T, D> const &l, Vector<T, D> x) noexcept
{
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < i; ++j) x[i] = x[i] - l(j, i) * x[j];
        x[i] = x[i] / l(i, i);
    }
    for (int i = D - 1; i >= 0; --i) {
        for (int j = i + 1; j < D; ++j) x[i] = x[i] - l(i, j) * x[j];
        x[i] = x[i] / l(i, i);
    }
    return x;
}

} // namespace pw85

namespace pw85::detail {

/// The adjugate adj(A) = det(A)·A⁻¹ in two dimensions.
template <class T>
PW85_FUNCTION constexpr SymmetricMatrix<T, 2> adjugate(SymmetricMatrix<T, 2> const &a) noexcept
{
    return {a[2], -a[1], a[0]};
}

/// The adjugate adj(A) = det(A)·A⁻¹ in three dimensions.
template <class T>
PW85_FUNCTION constexpr SymmetricMatrix<T, 3> adjugate(SymmetricMatrix<T, 3> const &a) noexcept
{
    return {a[3] * a[5] - a[4] * a[4], a[2] * a[4] - a[1] * a[5], a[1] * a[4] - a[2] * a[3],
            a[0] * a[5] - a[2] * a[2], a[1] * a[2] - a[0] * a[4], a[0] * a[3] - a[1] * a[1]};
}

/// The determinant from a matrix and its adjugate, expanded along the first row. The function is
/// always inlined. Otherwise GCC 12 merges it with dot(), whose code is the same if numbers are
/// structures, and warns of the array sizes.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr T
determinant(SymmetricMatrix<T, D> const &a, SymmetricMatrix<T, D> const &adjugate_of_a) noexcept
{
    T sum = a(0, 0) * adjugate_of_a(0, 0);
    for (int j = 1; j < D; ++j) sum = sum + a(0, j) * adjugate_of_a(0, j);
    return sum;
}

/// The smallest product of the diagonal for which is_clearly_definite() can be true. This is far
/// above the pivots that is_positive_definite() (definite.hpp) still accepts.
template <class T> PW85_FUNCTION constexpr T least_diagonal_product() noexcept
{
    constexpr int exponent = std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8;
    return negative_power_of_two<T>(exponent < 128 ? exponent : 128);
}

/// A bound on the errors of a determinant near zero, in units of u times the product of the
/// diagonal: the sum of those of the expanded determinant and of the product of the pivots (theorem
/// `definite` of tests/bounds/proofs.cpp).
template <int D> inline constexpr int definite_margin = D == 2 ? 8 : 16;

/// Returns whether products alone (Sylvester's criterion) show that a symmetric matrix with entries
/// near order one is positive definite. If they do, is_positive_definite() is true as well, and the
/// pivots of factorize() are positive.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_clearly_definite(SymmetricMatrix<T, 2> const &a, SymmetricMatrix<T, 2> const &) noexcept
{
    T const bound = T(definite_margin<2> * unit_roundoff<T>()), product = a[0] * a[2];
    return a[0] > T(0) && product > least_diagonal_product<T>() &&
           product - a[1] * a[1] > bound * product;
}

template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_clearly_definite(SymmetricMatrix<T, 3> const &a,
                    SymmetricMatrix<T, 3> const &adjugate_of_a) noexcept
{
    auto const u = unit_roundoff<T>();
    T const leading = a[0] * a[3], product = leading * a[5];
    return a[0] > T(0) && product > least_diagonal_product<T>() &&
           adjugate_of_a[5] > T(definite_margin<2> * u) * leading &&
           determinant(a, adjugate_of_a) > T(definite_margin<3> * u) * product;
}

template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_clearly_definite(SymmetricMatrix<T, D> const &a) noexcept
{
    return is_clearly_definite(a, adjugate(a));
}

} // namespace pw85::detail

#endif
