/// @file
/// What the shapes share: the result of a contact function, the point where it is reached, and the units in which it is computed.
/// segment.hpp, triangle.hpp, box.hpp and polytope.hpp use this file.
///
/// An ellipsoid with its centre at 0, scaled about the centre by μ, first touches a convex set at the point x of the set where
/// xᵀQ⁻¹x is least, and μ² is that value. Let s = Q⁻¹x. Then s is the normal of the ellipsoid at x, and s·y >= μ² for every point y
/// of the set. Where x is inside a face, s is orthogonal to the face, so that Q alone gives μ² without Q⁻¹:
///
/// 1. On a plane n·x = d, s is a multiple of n, μ² = d²/(nᵀQn) and x = Qn d/(nᵀQn).
/// 2. On the line a + t e, s = N λ, where the two columns of N span the vectors orthogonal to e. (NᵀQN) λ = Nᵀa, and μ² = λ·Nᵀa.
/// 3. At a point x, μ² = xᵀQ⁻¹x by the pivots of Q.
///
/// A relative change of the entries of Q by ε changes μ² by at most ε Σ|s_i Q_ij s_j|, to first order, and one of the coordinates of
/// the points v_k of which x = Σ w_k v_k is the mean by at most 2 ε Σ w_k |s_i v_ki|. S is the sum of the two. Rounding errors of the
/// pivots of a positive definite matrix act like such a change of the entries, for any aspect ratio. So each of the three formulas
/// errs by some u S.
#ifndef PW85_SHAPES_NEAREST_POINT_HPP_INCLUDED
#define PW85_SHAPES_NEAREST_POINT_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/validate.hpp>

namespace pw85 {

/// The contact function of an ellipsoid and a convex set.
template <class T> struct ShapeContact {
    T mu2; ///< square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in the set
    Vector<T, 3> point; ///< where the scaled ellipsoid touches, relative to its centre
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// A multiple of s, if it is wanted; nothing otherwise.
template <class T, int D, bool wanted> struct Normal {
    Vector<T, D> direction;
};

template <class T, int D> struct Normal<T, D, false> {
    Normal() = default;
    PW85_MEMBER constexpr explicit Normal(Vector<T, D> const &) noexcept {}
};

/// The least xᵀQ⁻¹x of a set, and where it is.
template <class T, bool with_normal> struct Nearest {
    using Mask = typename ScalarTraits<T>::Mask;

    T mu2;
    Vector<T, 3> point;
    [[no_unique_address]] Normal<T, 3, with_normal> normal;
    Mask certain; ///< whether the digits of T suffice
};

template <class Mask, class T, int D>
PW85_FUNCTION constexpr Vector<T, D> choose(Mask const &mask, Vector<T, D> const &yes, Vector<T, D> const &no) noexcept
{
    Vector<T, D> x{};
    for (int i = 0; i < D; ++i) x[i] = select(mask, yes[i], no[i]);
    return x;
}

template <class Mask, class T, int D, bool wanted> PW85_FUNCTION constexpr Normal<T, D, wanted>
choose(Mask const &mask, Normal<T, D, wanted> const &yes, Normal<T, D, wanted> const &no) noexcept
{
    if constexpr (wanted)
        return {choose(mask, yes.direction, no.direction)};
    else
        return yes;
}

template <class Mask, class T, bool with_normal> [[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
choose(Mask const &mask, Nearest<T, with_normal> const &yes, Nearest<T, with_normal> const &no) noexcept
{
    return {select(mask, yes.mu2, no.mu2), choose(mask, yes.point, no.point), choose(mask, yes.normal, no.normal),
            (mask && yes.certain) || (!mask && no.certain)};
}

/// Item 3, with the pivots of Q.
template <bool with_normal, class T> [[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_on(Vector<T, 3> const &x, Factorization<T, 3> const &factors) noexcept
{
    using WantedNormal = Normal<T, 3, with_normal>;
    Vector<T, 3> const y = substitute_forward(factors, x);
    T const mu2 = dot_over_pivots(factors, y, y);
    if constexpr (with_normal)
        return {mu2, x, WantedNormal{substitute_back(factors, y)}, mu2 == mu2};
    else
        return {mu2, x, {}, mu2 == mu2};
}

template <class T, int N> PW85_FUNCTION constexpr bool is_finite(Vector<T, 3> const (&points)[N]) noexcept
{
    bool finite = true;
    for (auto const &x : points) finite = finite && is_finite(x);
    return finite;
}

/// Whether the sizes of the points and of the form are between `limit` and its inverse, and the form passes the fast checks.
template <class T, int N> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q, T const &limit) noexcept
{
    T smallest = sum_of_magnitudes(points[0]), total = smallest; // NaN if a number is NaN
    for (int k = 1; k < N; ++k) {
        T const size = sum_of_magnitudes(points[k]);
        smallest = minimum(smallest, size);
        total = total + size;
    }
    T const form = largest_diagonal(q);
    return total < limit && smallest * limit > T(1) && form < limit && form * limit > T(1) && is_clearly_definite(q);
}

/// Computes a contact with numbers of more digits and a wider range, where there are such numbers.
template <class T, int N, class Careful> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline ShapeContact<T>
contact_extended(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q, Careful const &careful) noexcept
{
    using W = Widened<T>;
    Vector<W, 3> wide[N];
    for (int k = 0; k < N; ++k) wide[k] = converted<W>(points[k]);
    auto const found = careful(wide, converted<W>(q));
    if constexpr (std::is_same_v<T, W>)
        return {found.mu2, found.point, Status::success};
    else
        return {rounded(found.mu2),
                {rounded(found.point[0]), rounded(found.point[1]), rounded(found.point[2])},
                Status::success};
}

/// Computes a contact in units in which the points and the form are of order one. The scaling changes no bit of the results of
/// contact_of(). The limit is wider than that of contact_of() in any units.
template <class T, int N, class Fast, class Careful>
[[gnu::noinline]] PW85_FUNCTION inline ShapeContact<T> contact_scaled(Vector<T, 3> const (&points)[N],
                                                                      SymmetricMatrix<T, 3> const &q, Fast const &fast,
                                                                      Careful const &careful) noexcept
{
    Status const status = is_finite(points) ? validate(q) : Status::invalid_argument;
    if (status != Status::success) return all_nan<ShapeContact<T>>(status);
    T largest = T(0);
    for (auto const &x : points) largest = maximum(largest, largest_coordinate(x));
    int const length = largest > T(0) ? binary_exponent(largest) : 0, form = half_exponent(largest_diagonal(q));
    Vector<T, 3> scaled[N];
    for (int k = 0; k < N; ++k) scaled[k] = times_power_of_two(points[k], -length);
    auto const unit = times_power_of_two(q, -2 * form);
    T const limit = T(16) * T(unscaled_limit<T>() * unscaled_limit<T>());
    if (has_extended_numbers<T> && !passes_fast_checks(scaled, unit, limit))
        return contact_extended(points, q, careful);
    auto found = fast(scaled, unit);
    if (!found.certain) found = careful(scaled, unit);
    if (!found.certain) return contact_extended(points, q, careful);
    return {times_power_of_two(found.mu2, 2 * (length - form)), times_power_of_two(found.point, length),
            Status::success};
}

/// The contact function of a set that is given by points. `fast` and `careful` find the nearest point in units of order one.
template <class T, int N, class Fast, class Careful>
[[gnu::always_inline]] PW85_FUNCTION inline ShapeContact<T> contact_of(Vector<T, 3> const (&points)[N],
                                                                       SymmetricMatrix<T, 3> const &q, Fast const &fast,
                                                                       Careful const &careful) noexcept
{
    if (passes_fast_checks(points, q, unscaled_limit<T>())) {
        auto const found = fast(points, q);
        if (found.certain) return {found.mu2, found.point, Status::success};
    }
    return contact_scaled(points, q, fast, careful);
}

} // namespace pw85::detail

#endif
