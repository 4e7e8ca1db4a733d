// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Code that all shapes share: the result of a contact function, the nearest point, and the units
/// of the computation. segment.hpp, triangle.hpp, box.hpp and polytope.hpp use this file.
///
/// An ellipsoid with its centre at 0, scaled about the centre by μ, first touches a convex set at
/// the point x of the set where xᵀQ⁻¹x is least, and μ² is that value. Let s = Q⁻¹x. Then s is the
/// normal of the ellipsoid at x, and s·y >= μ² for every point y of the set. Where x is inside a
/// face, s is orthogonal to the face, and Q alone gives μ² without Q⁻¹: on a plane n·x = d, s is a
/// multiple of n, μ² = d²/(nᵀQn) and x = Qn d/(nᵀQn).
///
/// Let x = Σ w_k v_k be a weighted mean of points v_k of the set. To first order, relative changes
/// of the entries of Q by ε change μ² by at most ε Σ|s_i Q_ij s_j|, and relative changes of the
/// coordinates of the v_k by ε change μ² by at most 2 ε Σ w_k |s_i v_ki|. S is the sum of both
/// terms over ε.
#ifndef PW85_SHAPES_NEAREST_POINT_HPP_INCLUDED
#define PW85_SHAPES_NEAREST_POINT_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85 {

/// The contact function of an ellipsoid and a convex set.
template <class T, int D = 3> struct ShapeContact {
    /// square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in
    /// the set
    T mu2;
    Vector<T, D> point; ///< at which the scaled ellipsoid touches, relative to its centre
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T> PW85_FUNCTION constexpr T sum_of(Vector<T, 3> const &x) noexcept
{
    return x[0] + x[1] + x[2];
}

/// A multiple of s if `wanted` is true; empty otherwise.
template <class T, int D, bool wanted> struct Normal {
    Vector<T, D> direction;
};

template <class T, int D> struct Normal<T, D, false> {
    Normal() = default;
    PW85_MEMBER constexpr explicit Normal(Vector<T, D> const &) noexcept {}
};

/// The least xᵀQ⁻¹x of a set, and its point x.
template <class T, bool with_normal> struct Nearest {
    using Mask = typename ScalarTraits<T>::Mask;

    T mu2;
    Vector<T, 3> point;
    [[no_unique_address]] Normal<T, 3, with_normal> normal;
    Mask certified; ///< true if the digits of T suffice
};

template <class Mask, class T, int D> PW85_FUNCTION constexpr Vector<T, D>
choose(Mask const &mask, Vector<T, D> const &yes, Vector<T, D> const &no) noexcept
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

template <class Mask, class T, bool with_normal>
[[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
choose(Mask const &mask, Nearest<T, with_normal> const &yes,
       Nearest<T, with_normal> const &no) noexcept
{
    return {select(mask, yes.mu2, no.mu2), choose(mask, yes.point, no.point),
            choose(mask, yes.normal, no.normal),
            (mask && yes.certified) || (!mask && no.certified)};
}

/// The pivots of Q, by elimination without divisions. At a point x they give μ² = xᵀQ⁻¹x. With p =
/// Q_00, S_ij = p Q_ij - Q_0i Q_0j and d = S_11 S_22 - S_12², the map
///     z_0 = x_0,   z_1 = p x_1 - Q_01 x_0,   z_2 = S_11 (p x_2 - Q_02 x_0) - S_12 z_1
/// gives xᵀQ⁻¹x = (S_11 d z_0² + d z_1² + z_2²)/(p S_11 d).
///
/// Rounding errors of the pivots of a positive definite matrix act like a relative change of the
/// entries by a few u, for any aspect ratio. This also holds for elimination without divisions. So
/// the error of each formula is a few u S, to first order.
template <class T> struct Elimination {
    T p, q01, q02, s11, s12;
    T weight0, weight1; ///< of z_0² and z_1²
    T reciprocal;       ///< 1/(p S_11 d)

    PW85_MEMBER constexpr explicit Elimination(SymmetricMatrix<T, 3> const &q) noexcept
        : p(q[0]), q01(q[1]), q02(q[2]), s11(q[0] * q[3] - q[1] * q[1]),
          s12(q[0] * q[4] - q[1] * q[2])
    {
        T const s22 = q[0] * q[5] - q[2] * q[2], product = s11 * s22;
        weight1 = maximum(T(product - s12 * s12), T(T(unit_roundoff<T>()) * product));
        weight0 = s11 * weight1;
        reciprocal = T(1) / T(p * weight0);
    }

    PW85_MEMBER constexpr Vector<T, 3> map(Vector<T, 3> const &x) const noexcept
    {
        T const z1 = p * x[1] - q01 * x[0], rest = p * x[2] - q02 * x[0];
        return {x[0], z1, s11 * rest - s12 * z1};
    }

    /// Returns the coordinates of z times their weights.
    PW85_MEMBER constexpr Vector<T, 3> weighted(Vector<T, 3> const &z) const noexcept
    {
        return {weight0 * z[0], weight1 * z[1], z[2]};
    }

    /// p S_11 d Q⁻¹x, from the weighted z of x.
    PW85_MEMBER constexpr Vector<T, 3> normal(Vector<T, 3> const &weighted) const noexcept
    {
        T const second = weighted[1] - s12 * weighted[2], third = s11 * weighted[2];
        return {weighted[0] - q01 * second - q02 * third, p * second, p * third};
    }
};

/// R, a bound on the lengths of the points v_k.
template <class T, std::size_t N>
PW85_FUNCTION constexpr T reach_of(Vector<T, 3> const (&points)[N]) noexcept
{
    T sum = sum_of_magnitudes(points[0]);
    for (std::size_t k = 1; k < N; ++k) sum = sum + sum_of_magnitudes(points[k]);
    return sum;
}

/// The square of the unit roundoff of T, divided by the unit roundoff of the results, times 2^bits.
/// For the widest types this number would be too small for the function. Their results do not
/// depend on it, because no type with more digits follows.
template <class T> PW85_FUNCTION constexpr T square_of_roundoff(int bits) noexcept
{
    int const exponent = 2 * mantissa_digits<T>() - result_digits<T>() - bits;
    return negative_power_of_two<T>(exponent < 1022 ? exponent : 1022);
}

/// The change of μ² of second order as the quotient error/divisor, divided by 50 u for the u of the
/// results.
///
/// Rounding errors of a point of the set are of the order of u R (reach_of()). If they move the
/// point by the vector e, μ² changes to second order by eᵀQ⁻¹e <= |e|² tr Q⁻¹. S does not bound
/// this term. It can exceed u S if the set is long or the ellipsoid is thin.
template <class T> struct SecondOrder {
    T error, divisor;

    /// Returns whether the digits of T suffice for this μ².
    PW85_MEMBER constexpr typename ScalarTraits<T>::Mask is_small(T const &mu2) const noexcept
    {
        return error < T(divisor * mu2);
    }
};

/// The term for rounding errors that move a point by up to 20 u (square/divisor)^(1/2), with the u
/// of T. If it is small, it is at most 50 u μ² with the u of the results, and that is at most 50 u
/// S.
template <class T> PW85_FUNCTION constexpr SecondOrder<T>
second_order(SymmetricMatrix<T, 3> const &q, T const &square, T const &divisor) noexcept
{
    auto const adj = adjugate(q);
    T const trace = adj(0, 0) + adj(1, 1) + adj(2, 2);
    return {T(square_of_roundoff<T>(3) * trace) * square, determinant(q, adj) * divisor};
}

template <class T, std::size_t N>
PW85_FUNCTION constexpr bool is_finite(Vector<T, 3> const (&points)[N]) noexcept
{
    bool finite = true;
    for (auto const &x : points) finite = finite && is_finite(x);
    return finite;
}

/// Returns whether the sizes of the points and of the form are between `limit` and its inverse, and
/// the form passes the fast checks.
template <class T, std::size_t N> [[gnu::always_inline]] PW85_FUNCTION inline
    typename ScalarTraits<T>::Mask
    passes_fast_checks(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q,
                       T const &limit) noexcept
{
    T smallest = sum_of_magnitudes(points[0]), total = smallest; // NaN if a number is NaN
    for (std::size_t k = 1; k < N; ++k) {
        T const size = sum_of_magnitudes(points[k]);
        smallest = minimum(smallest, size);
        total = total + size;
    }
    T const form = largest_diagonal(q);
    return total < limit && smallest * limit > T(1) && form < limit && form * limit > T(1) &&
           is_clearly_definite(q);
}

/// Finds the nearest point with numbers of type W, which have more digits.
template <class W, class T, std::size_t N, class Find>
PW85_FUNCTION inline Nearest<T, false> find_with_digits(Vector<T, 3> const (&points)[N],
                                                        SymmetricMatrix<T, 3> const &q,
                                                        Find const &find) noexcept
{
    Vector<W, 3> wide[N];
    for (std::size_t k = 0; k < N; ++k) wide[k] = converted<W>(points[k]);
    auto const found = find(wide, converted<W>(q));
    if constexpr (std::is_same_v<T, W>)
        return found;
    else
        return Nearest<T, false>{
            rounded(found.mu2),
            {rounded(found.point[0]), rounded(found.point[1]), rounded(found.point[2])},
            {},
            found.certified};
}

/// Returns whether the centre is on a segment. Numbers of type W represent products of two
/// coordinates exactly.
template <class W>
PW85_FUNCTION inline bool has_center(Vector<W, 3> const &a, Vector<W, 3> const &b) noexcept
{
    return largest_coordinate(cross(a, b)) == W(0) && dot(a, b) <= W(0);
}

template <class W> PW85_FUNCTION inline bool has_center(Vector<W, 3> const (&ends)[2]) noexcept
{
    return has_center(ends[0], ends[1]);
}

/// Returns whether the centre is in a triangle: on an edge, or in its plane with all three edges in
/// the same sense of rotation about the centre.
template <class W> PW85_FUNCTION inline bool has_center(Vector<W, 3> const (&vertices)[3]) noexcept
{
    auto const &[a, b, c] = vertices;
    if (has_center(a, b) || has_center(b, c) || has_center(c, a)) return true;
    auto const ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    return dot(a, bc) == W(0) && dot(ab, bc) > W(0) && dot(bc, ca) > W(0);
}

/// Finds the nearest point with twice the digits.
template <class T, std::size_t N, class Find>
PW85_RARE Nearest<T, false> find_finer(Vector<T, 3> const (&points)[N],
                                       SymmetricMatrix<T, 3> const &q, Find const &find) noexcept
{
    return find_with_digits<Finer<T>>(points, q, find);
}

/// The contact, computed with the most digits. All numbers are 0 if the centre is in the set.
template <class T, std::size_t N, class Find>
PW85_RARE ShapeContact<T, 3> contact_with_all_digits(Vector<T, 3> const (&points)[N],
                                                     SymmetricMatrix<T, 3> const &q,
                                                     Find const &find) noexcept
{
    Vector<Widened<T>, 3> wide[N];
    for (std::size_t k = 0; k < N; ++k) wide[k] = converted<Widened<T>>(points[k]);
    if (has_center(wide)) return {T(0), {T(0), T(0), T(0)}, StatusCode::success};
    auto const found = find_with_digits<Widened<T>>(points, q, find);
    return {found.mu2, found.point, StatusCode::success};
}

/// Converts a contact from the units of the shape and of the ellipsoid to those of the caller.
template <class T> PW85_FUNCTION inline ShapeContact<T, 3>
to_caller(T const &mu2, Vector<T, 3> const &point, Unit shape, Unit ellipsoid) noexcept
{
    return {(shape / ellipsoid).to_caller(mu2, 2), shape.to_caller(point), StatusCode::success};
}

/// Computes a contact in units in which the points and the form are of order one. The scaling
/// changes no bit of the results of contact_of(). The limit is wider than that of contact_of(),
/// whatever the units are. If digits are lost, the function tries numbers with twice the digits,
/// and then numbers with more digits and a wider range if the type has them.
template <class T, std::size_t N, class Find>
[[gnu::noinline]] PW85_FUNCTION inline ShapeContact<T, 3>
contact_points_scaled(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q,
                      Find const &find) noexcept
{
    StatusCode const status = is_finite(points) ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<ShapeContact<T, 3>>(status);
    T largest = T(0);
    for (auto const &x : points) largest = maximum(largest, largest_coordinate(x));
    Unit const length{largest > T(0) ? binary_exponent(largest) : 0}, size = unit_of(q);
    Vector<T, 3> scaled[N];
    for (std::size_t k = 0; k < N; ++k) scaled[k] = length.to_local(points[k]);
    auto const form = size.to_local(q);
    T const limit = T(16) * T(unscaled_limit<T>() * unscaled_limit<T>());
    if (!has_extended_numbers<T> || passes_fast_checks(scaled, form, limit)) {
        auto found = find(scaled, form);
        if (!found.certified) found = find_finer(scaled, form, find);
        if (found.certified) return to_caller(found.mu2, found.point, length, size);
    }
    return contact_with_all_digits(points, q, find);
}

/// The contact function of a set that is given by points. `find` finds the nearest point in units
/// of order one.
template <class T, std::size_t N, class Find>
[[gnu::always_inline]] PW85_FUNCTION inline ShapeContact<T, 3>
contact_of(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q,
           Find const &find) noexcept
{
    if (passes_fast_checks(points, q, unscaled_limit<T>())) {
        auto const found = find(points, q);
        if (found.certified) return {found.mu2, found.point, StatusCode::success};
    }
    return contact_points_scaled(points, q, find);
}

} // namespace pw85::detail

#endif
