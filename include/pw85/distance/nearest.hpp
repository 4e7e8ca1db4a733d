// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The nearest and the farthest point of an ellipsoid's surface from a point. walls.hpp and
/// penetration.hpp call extreme_normal(), which calls principal_axes() and secular_root().
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
///    part makes F = 1 and may have either sign.
#ifndef PW85_DISTANCE_NEAREST_HPP_INCLUDED
#define PW85_DISTANCE_NEAREST_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/validate.hpp>
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

/// Turns the point (x, y) about the origin by an angle with cosine c and sine s.
template <class T> PW85_FUNCTION constexpr void turn(T const &c, T const &s, T &x, T &y) noexcept
{
    T const old = x;
    x = c * old - s * y;
    y = s * old + c * y;
}

/// Jacobi's rotation in the plane of columns i and j, which makes a(i, j) zero.
template <class T, int D> PW85_FUNCTION inline void
rotate(SymmetricMatrix<T, D> &a, PrincipalAxes<T, D> &p, int i, int j) noexcept
{
    T const cotangent = (a(j, j) - a(i, i)) / (T(2) * a(i, j)); // cotangent of twice the angle
    T const root = square_root(T(T(1) + cotangent * cotangent));
    T const t = cotangent < T(0) ? T(T(1) / (cotangent - root)) : T(T(1) / (cotangent + root));
    T const c = T(1) / square_root(T(T(1) + t * t)), s = t * c, shift = t * a(i, j);
    a(i, i) = a(i, i) - shift;
    a(j, j) = a(j, j) + shift;
    a(i, j) = T(0);
    for (int k = 0; k < D; ++k) {
        turn(c, s, p.axes[k][i], p.axes[k][j]);
        if (k != i && k != j) turn(c, s, a(k, i), a(k, j));
    }
}

/// Computes the principal axes by Jacobi's rotations. They find small eigenvalues of a positive
/// definite matrix to the accuracy that its entries allow. They converge quadratically, to any
/// precision in far fewer than 50 sweeps.
template <class T, int D>
PW85_FUNCTION inline PrincipalAxes<T, D> principal_axes(SymmetricMatrix<T, D> a) noexcept
{
    PrincipalAxes<T, D> p{};
    for (int i = 0; i < D; ++i) p.axes[i][i] = T(1);
    bool rotated = true;
    for (int sweep = 0; rotated && sweep < 50; ++sweep) {
        rotated = false;
        for (int i = 0; i < D; ++i)
            for (int j = i + 1; j < D; ++j) {
                T const bound = unit_roundoff<T>() * square_root(a(i, i)) * square_root(a(j, j));
                if (!(absolute(a(i, j)) > bound)) continue;
                rotate(a, p, i, j);
                rotated = true;
            }
    }
    T const largest = largest_diagonal(a);
    for (int i = 0; i < D; ++i)
        p.squares[i] = a(i, i) > T(0) ? a(i, i) : T(unit_roundoff<T>() * largest);
    return p;
}

/// The root of item 2 if F(0) >= 1, and zero otherwise. `roots` are √q_i |r_i|. 170 steps are more
/// than any shape needs: see find_shift().
template <class T, std::size_t D>
PW85_FUNCTION inline T secular_root(T const (&gaps)[D], T const (&roots)[D]) noexcept
{
    T sigma = T(0);
    for (std::size_t i = 0; i < D; ++i) sigma = maximum(sigma, T(roots[i] - gaps[i]));
    for (int n = 0; n < 170; ++n) {
        T f2 = T(0), slope = T(0);
        for (std::size_t i = 0; i < D; ++i) {
            if (!(roots[i] > T(0))) continue;
            T const x = roots[i] / (gaps[i] + sigma);
            f2 = f2 + x * x;
            slope = slope + x * x / (gaps[i] + sigma);
        }
        T const f = square_root(f2), step = (f - T(1)) * f2 / slope;
        if (!(step > unit_roundoff<T>() * sigma)) break;
        sigma = sigma + step;
    }
    return sigma;
}

/// The exponent of the unit of length for r, if `exponent` is that for the ellipsoid. The unit for
/// r is larger only if r is so far away that its distance makes no difference to directions.
template <class T, int D>
PW85_FUNCTION inline int point_exponent(Vector<T, D> const &r, int exponent) noexcept
{
    T const largest = largest_coordinate(r);
    if (!(largest > T(0))) return exponent;
    int const least = binary_exponent(largest) - std::numeric_limits<T>::max_exponent / 2;
    return exponent < least ? least : exponent;
}

/// A point in the basis of the principal axes: the numbers of items 1 and 2.
template <class T, int D> struct AxisComponents {
    T gaps[std::size_t(D)];  ///< g_i
    T along[std::size_t(D)]; ///< r_i
    T roots[std::size_t(D)]; ///< √q_i |r_i|
    int last;                ///< the axis with g_i = 0
};

template <class T, int D> PW85_FUNCTION inline AxisComponents<T, D>
axis_components(PrincipalAxes<T, D> const &p, Vector<T, D> const &x, bool nearest) noexcept
{
    AxisComponents<T, D> c{};
    for (int i = 1; i < D; ++i)
        if (nearest ? p.squares[i] < p.squares[c.last] : p.squares[i] > p.squares[c.last])
            c.last = i;
    for (int i = 0; i < D; ++i) {
        c.along[i] = p.axes[0][i] * x[0];
        for (int k = 1; k < D; ++k) c.along[i] = c.along[i] + p.axes[k][i] * x[k];
        c.gaps[i] = absolute(T(p.squares[i] - p.squares[c.last]));
        c.roots[i] = square_root(p.squares[i]) * absolute(c.along[i]);
    }
    return c;
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

/// extreme_normal() of a point x in the unit of the principal axes.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
extreme_normal(PrincipalAxes<T, D> const &p, Vector<T, D> const &x, bool nearest) noexcept
{
    AxisComponents<T, D> const c = axis_components(p, x, nearest);
    T const sigma = secular_root(c.gaps, c.roots);
    T rest = T(1), v[std::size_t(D)];
    for (int i = 0; i < D; ++i) {
        v[i] = c.roots[i] > T(0) ? T(c.along[i] / (c.gaps[i] + sigma)) : T(0);
        rest = rest - p.squares[i] * v[i] * v[i];
    }
    if (!(sigma > T(0))) v[c.last] = square_root(T(maximum(T(0), rest) / p.squares[c.last]));
    return unit_vector_along<T, D>(p, v);
}

/// The unit normal at the point of a valid ellipsoid that is nearest to r, or farthest from r.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
extreme_normal(SymmetricMatrix<T, D> const &q, Vector<T, D> const &r, bool nearest) noexcept
{
    int const exponent = half_exponent(largest_diagonal(q));
    PrincipalAxes<T, D> const p = principal_axes(times_power_of_two(q, -2 * exponent));
    return extreme_normal(p, times_power_of_two(r, -point_exponent(r, exponent)), nearest);
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
