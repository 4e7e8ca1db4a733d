// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides whether a form is positive definite. contact/scaling.hpp calls is_positive_definite().
/// The solver and the geometry of contact/ use Widened and has_extended_numbers.
/// is_positive_definite() calls is_clearly_definite() and, if that is not sufficient, the
/// arithmetic of extended_number.hpp. The decision is the same in every function, for either order
/// of the ellipsoids, and for every instruction set.
#ifndef PW85_ALGEBRA_DEFINITE_HPP_INCLUDED
#define PW85_ALGEBRA_DEFINITE_HPP_INCLUDED

#include <pw85/algebra/extended_number.hpp>

namespace pw85::detail {

/// The type with more digits that belongs to T. It is T itself if there is none.
template <class T> using Widened =
    std::conditional_t<exact::is_decidable<T>, exact::Extended<T>, T>;

/// The leading principal minors, from the smallest to the largest.
template <class T>
PW85_FUNCTION inline Vector<T, 2> leading_minors(SymmetricMatrix<T, 2> const &a) noexcept
{
    return {a[0], determinant(a, adjugate(a))};
}

template <class T>
PW85_FUNCTION inline Vector<T, 3> leading_minors(SymmetricMatrix<T, 3> const &a) noexcept
{
    auto const adj = adjugate(a);
    return {a[0], adj[5], determinant(a, adj)};
}

/// The smallest ratio of the determinant to the product of the diagonal at which a form counts as
/// positive definite: 2^-212 for double. If entries of similar magnitude are multiples of u, a
/// determinant is a multiple of u³, which is far above this limit.
template <class T> PW85_FUNCTION constexpr T least_determinant() noexcept
{
    return negative_power_of_two<T>(4 * result_digits<T>());
}

/// Decides by Sylvester's criterion for a matrix with a positive diagonal. Rounding errors do not
/// matter: for a matrix scaled to a unit diagonal the minors err by less than 2^(5-bits). Where the
/// determinant exceeds least_determinant(), the other minors exceed half of least_determinant().
/// Pivots are ratios of minors. They must exceed the fourth root of the smallest number times the
/// largest diagonal entry. (In double an ellipsoid of aspect ratio 1e38 has such a small pivot. Its
/// inverse leaves room for products of four entries.)
template <class T, int D>
PW85_RARE bool has_positive_minors(SymmetricMatrix<T, D> const &a) noexcept
{
    using W = Widened<T>;
    auto const w = converted<W>(a);
    auto const minors = leading_minors(w);
    W const floor = W(square_root(square_root(smallest_number<T>()))) * largest_diagonal(w);
    bool positive = minors[0] > floor;
    for (int i = 1; i < D; ++i) positive = positive && minors[i] > W(floor * minors[i - 1]);
    return positive && minors[D - 1] > W(least_determinant<W>() * diagonal_product(w));
}

PW85_RARE_TIER(has_positive_minors)

/// Decides up to rounding errors, for types with digits to spare and for devices. The function uses
/// pivots, which lose fewer digits than minors.
template <class T, int D>
PW85_FUNCTION inline bool has_positive_pivots(SymmetricMatrix<T, D> const &a) noexcept
{
    T const floor = square_root(square_root(smallest_number<T>())) * largest_diagonal(a);
    Factorization<T, D> const factors = factorize(a, T(0));
    bool positive = factors.pivots[0] > floor;
    for (int i = 1; i < D; ++i) positive = positive && factors.pivots[i] > floor;
    return positive;
}

/// True if T has extended numbers. They decide where the digits of T do not suffice.
template <class T> static constexpr bool has_extended_numbers =
    exact::is_decidable<T> && !is_for_device;

/// Returns whether a matrix is positive definite. The diagonal must be positive, with its largest
/// entry near one. The decision is exact for types with extended numbers, and correct up to
/// rounding for others. An off-diagonal entry that overflowed when the matrix was scaled is
/// infinite. Such a matrix is not positive definite: the entry makes NaN, and no comparison with
/// NaN is true.
template <class T, int D>
PW85_FUNCTION inline bool is_positive_definite(SymmetricMatrix<T, D> const &a) noexcept
{
    if constexpr (has_extended_numbers<T>)
        return is_clearly_definite(a) || has_positive_minors(a);
    else
        return is_clearly_definite(a) || has_positive_pivots(a);
}

} // namespace pw85::detail

#endif
