// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest and the farthest point of an ellipsoid's surface from a point. walls.hpp,
/// solids.hpp, depth_search.hpp and depth_intervals.hpp call extreme_normal(), which calls
/// principal_axes() and searches for a root.
///
/// The support is α(n) = √(nᵀQn), and r is a point relative to the centre. The signed distance of r
/// from the surface (negative inside) is the largest n·r - α over unit vectors n. The farthest
/// point is at the largest n·r + α. Both functions may have several local maxima. The largest one
/// is found without a search:
///
/// 1. In the basis of the principal axes, let q_i be the squares of the semi-axes. For the nearest
///    point let g_i = q_i - q_min, and for the farthest g_i = q_max - q_i. Then n is along v with
///    v_i = r_i/(g_i + σ), and the point is Qv. Here σ >= 0 is the root of F(σ) = 1, with F² = Σ
///    q_i r_i²/(g_i + σ)². This stationary point is the global one by the S-lemma, because Q⁻¹ +
///    s⁻¹I, or its counterpart, is semidefinite there.
/// 2. F decreases and 1/F is concave. So Newton's method is monotone from the σ at which the
///    largest term is 1, and each step divides residual times slope by at least 4.
/// 3. If F(0) < 1, as at the centre, σ is 0, and v has a part along the axis with g_i = 0. This
///    part has the length for which F = 1, and may have either sign.
#ifndef PW85_DISTANCE_NEAREST_HPP_INCLUDED
#define PW85_DISTANCE_NEAREST_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/scaling.hpp>
#include <pw85/distance/support.hpp>

namespace pw85 {

/// The distance of something from an ellipsoid, and the point where it is reached. All numbers are
/// NaN if the status is not success.
template <class T, int D> struct SurfaceDistance {
    /// negative where the two overlap, or where the ellipsoid pierces an enclosure
    T distance;
    Vector<T, D> point;  ///< of the ellipsoid, relative to its centre
    Vector<T, D> normal; ///< unit vector, out of the ellipsoid at this point
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The squares of the semi-axes, which are positive, and the directions of the semi-axes as
/// columns.
template <class T, int D> struct PrincipalAxes {
    T squares[std::size_t(D)];
    T axes[std::size_t(D)][std::size_t(D)];
};

/// Rotates the point (x, y) about the origin by an angle with cosine c and sine s.
template <class T> PW85_FUNCTION constexpr void turn(T const &c, T const &s, T &x, T &y) noexcept
{
    T const old = x;
    x = c * old - s * y;
    y = s * old + c * y;
}

/// The search for the principal axes, by Jacobi's rotations. They find small eigenvalues of a
/// positive definite matrix to the accuracy that its entries allow. They converge quadratically, to
/// any precision in far fewer than 50 sweeps.
template <class T, int D> struct AxesSearch {
    SymmetricMatrix<T, D> a; ///< the matrix in the basis of the axes
    T axes[std::size_t(D)][std::size_t(D)];
    typename ScalarTraits<T>::Mask active; ///< true while the last sweep has rotated
};

inline constexpr int max_axes_steps = 50;

template <class T, int D>
PW85_FUNCTION inline AxesSearch<T, D> start_axes_search(SymmetricMatrix<T, D> const &a) noexcept
{
    AxesSearch<T, D> search{a, {}, T(0) <= T(0)};
    for (int i = 0; i < D; ++i) search.axes[i][i] = T(1);
    return search;
}

/// Rotates in the plane of columns i and j, so that a(i, j) becomes zero where `mask` is true.
template <class T, int D> PW85_FUNCTION inline void
rotate(AxesSearch<T, D> &search, typename ScalarTraits<T>::Mask const &mask, int i, int j) noexcept
{
    auto &[a, axes, active] = search;
    T const twice = a(i, j) + a(i, j), difference = a(j, j) - a(i, i);
    T const root = square_root(T(difference * difference + twice * twice));
    T const sum = select(difference < T(0), T(difference - root), T(difference + root));
    T const t = select(mask, T(twice / sum), T(0)), shift = t * a(i, j);
    T const c = T(1) / square_root(T(T(1) + t * t)), s = t * c;
    a(i, i) = a(i, i) - shift;
    a(j, j) = a(j, j) + shift;
    a(i, j) = select(mask, T(0), a(i, j));
    for (int k = 0; k < D; ++k) {
        turn(c, s, axes[k][i], axes[k][j]);
        if (k != i && k != j) turn(c, s, a(k, i), a(k, j));
    }
}

/// Rotates once in each plane whose entry is larger than its rounding error. In double, diagonal
/// entries of valid forms are above 2^-256 of the largest one (definite.hpp), so the products here
/// are above 2^-618 of its square.
template <class T, int D> PW85_FUNCTION inline void take_step(AxesSearch<T, D> &search) noexcept
{
    auto &[a, axes, active] = search;
    active = T(0) < T(0);
    for (int i = 0; i < D; ++i)
        for (int j = i + 1; j < D; ++j) {
            T const u = T(unit_roundoff<T>()), bound = T(u * u) * T(a(i, i) * a(j, j));
            auto const is_large = T(a(i, j) * a(i, j)) > maximum(T(0), bound);
            if (!any_of(is_large)) continue;
            rotate(search, is_large, i, j);
            active = active || is_large;
        }
}

template <class T, int D>
PW85_FUNCTION inline PrincipalAxes<T, D> found_axes(AxesSearch<T, D> const &search) noexcept
{
    PrincipalAxes<T, D> p{};
    T const least = T(unit_roundoff<T>()) * largest_diagonal(search.a);
    for (int i = 0; i < D; ++i) {
        p.squares[i] = select(search.a(i, i) > T(0), search.a(i, i), least);
        for (int k = 0; k < D; ++k) p.axes[i][k] = search.axes[i][k];
    }
    return p;
}

/// The principal axes of a form whose largest diagonal entry is of order one.
template <class T, int D>
PW85_FUNCTION inline PrincipalAxes<T, D> principal_axes(SymmetricMatrix<T, D> const &a) noexcept
{
    auto search = start_axes_search(a);
    for (int n = 0; n < max_axes_steps && any_of(search.active); ++n) take_step(search);
    return found_axes(search);
}

/// The unit of length for r, if `own` is that of the ellipsoid. It is larger only if r is so far
/// away that its distance makes no difference to directions.
template <class T, int D>
PW85_FUNCTION inline Unit unit_of_point(Vector<T, D> const &r, Unit own) noexcept
{
    return larger_unit(own, largest_coordinate(r),
                       Unit{-(std::numeric_limits<T>::max_exponent / 2)});
}

/// A point in the basis of the principal axes: the numbers of items 1 and 2.
template <class T, int D> struct AxisComponents {
    T gaps[std::size_t(D)];  ///< g_i
    T along[std::size_t(D)]; ///< r_i
    T roots[std::size_t(D)]; ///< √q_i |r_i|
};

template <class T, int D> PW85_FUNCTION inline AxisComponents<T, D>
axis_components(PrincipalAxes<T, D> const &p, Vector<T, D> const &x, bool nearest) noexcept
{
    AxisComponents<T, D> c{};
    T last = p.squares[0];
    for (int i = 1; i < D; ++i)
        last = nearest ? minimum(last, p.squares[i]) : maximum(last, p.squares[i]);
    for (int i = 0; i < D; ++i) {
        c.along[i] = p.axes[0][i] * x[0];
        for (int k = 1; k < D; ++k) c.along[i] = c.along[i] + p.axes[k][i] * x[k];
        c.gaps[i] = absolute(T(p.squares[i] - last));
        c.roots[i] = square_root(p.squares[i]) * absolute(c.along[i]);
    }
    return c;
}

/// The search for the root of item 2. σ stays zero if F(0) < 1.
template <class T, int D> struct ShiftSearch {
    AxisComponents<T, D> point;
    T sigma;
    typename ScalarTraits<T>::Mask active;
};

/// More steps than any shape needs: see find_shift().
inline constexpr int max_shift_steps = 170;

template <class T, int D> PW85_FUNCTION inline ShiftSearch<T, D>
start_shift_search(AxisComponents<T, D> const &point) noexcept
{
    T sigma = T(0);
    for (int i = 0; i < D; ++i) sigma = maximum(sigma, T(point.roots[i] - point.gaps[i]));
    return {point, sigma, T(0) <= T(0)};
}

template <class T, int D> PW85_FUNCTION inline void take_step(ShiftSearch<T, D> &search) noexcept
{
    auto &[point, sigma, active] = search;
    T f2 = T(0), slope = T(0);
    for (int i = 0; i < D; ++i) {
        T const inverse = T(1) / (point.gaps[i] + sigma), x = point.roots[i] * inverse,
                square = select(point.roots[i] > T(0), T(x * x), T(0));
        f2 = f2 + square;
        slope = slope + select(point.roots[i] > T(0), T(square * inverse), T(0));
    }
    T const f = square_root(f2), step = (f - T(1)) * f2 / slope;
    active = step > T(T(unit_roundoff<T>()) * sigma);
    sigma = select(active, T(sigma + step), sigma);
}

/// The unit vector along a vector that is given in the basis of the principal axes.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
unit_vector_along(PrincipalAxes<T, D> const &p, T const (&v)[std::size_t(D)]) noexcept
{
    Vector<T, D> n{};
    T largest = T(0);
    for (int i = 0; i < D; ++i) largest = maximum(largest, absolute(v[i]));
    for (int k = 0; k < D; ++k)
        for (int i = 0; i < D; ++i) n[k] = n[k] + p.axes[k][i] * (v[i] / largest);
    return unit_along(n);
}

/// The unit normal at the root of item 2, or by item 3 where that is zero.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
normal_at(PrincipalAxes<T, D> const &p, ShiftSearch<T, D> const &search) noexcept
{
    auto const &[point, sigma, active] = search;
    T rest = T(1), v[std::size_t(D)];
    for (int i = 0; i < D; ++i) {
        v[i] = select(point.roots[i] > T(0), T(point.along[i] / T(point.gaps[i] + sigma)), T(0));
        rest = rest - p.squares[i] * v[i] * v[i];
    }
    auto without_root = !(sigma > T(0));
    if (!any_of(without_root)) return unit_vector_along<T, D>(p, v);
    for (int i = 0; i < D; ++i) { // the first axis with g_i = 0
        auto const is_last = point.gaps[i] == T(0) && without_root;
        v[i] = select(is_last, square_root(T(maximum(T(0), rest) / p.squares[i])), v[i]);
        without_root = without_root && !is_last;
    }
    return unit_vector_along<T, D>(p, v);
}

/// extreme_normal() of a point x in the unit of the principal axes.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
extreme_normal(PrincipalAxes<T, D> const &p, Vector<T, D> const &x, bool nearest) noexcept
{
    auto search = start_shift_search(axis_components(p, x, nearest));
    for (int n = 0; n < max_shift_steps && any_of(search.active); ++n) take_step(search);
    return normal_at(p, search);
}

/// The unit normal at the point of a valid ellipsoid that is nearest to r, or farthest from r.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
extreme_normal(SymmetricMatrix<T, D> const &q, Vector<T, D> const &r, bool nearest) noexcept
{
    Unit const unit = unit_of(q);
    PrincipalAxes<T, D> const p = principal_axes(unit.to_local(q));
    return extreme_normal(p, unit_of_point(r, unit).to_local(r), nearest);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_point(Vector<T, D> const &r, SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace detail;
    StatusCode const status = is_finite(r) ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<SurfaceDistance<T, D>>(status);
    Vector<T, D> const n = extreme_normal(q, r, true);
    Support<T, D> const s = support(q, n);
    return {dot(n, r) - s.extent, s.point, n, StatusCode::success};
}

} // namespace pw85

#endif
