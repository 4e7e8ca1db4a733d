// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The principal curvatures of an ellipsoid's surface at the point with a given normal.
///
/// Let n be the unit normal, e1 and e2 an orthonormal basis of the tangent plane, α = √(nᵀQn) and p
/// = Qn/α the point of the surface.
///
/// 1. If the normal turns by e_j, the point moves by A e_j with A = (Q - ppᵀ)/α (curvature.hpp). So
///    the matrix of the radii of curvature in this basis is S/α, where S_ij = e_iᵀQ e_j -
///    (e_iᵀQn)(e_jᵀQn)/(nᵀQn). S is the Schur complement of Q after the elimination of n. The
///    matrix of the second fundamental form, K = α S⁻¹, is the inverse of the matrix of the radii.
/// 2. Elimination is backward stable: with plain arithmetic each entry of S errs by less than 10 u
///    tr Q, and det S by less than 20 u tr Q tr S. If det S/tr S and nᵀQn exceed 2^-8 tr Q (in
///    double), which holds up to aspect ratios of about ten, the relative errors of α, of the
///    eigenvalues of S and of those of K are some 2^13 u, which is 2^-40.
/// 3. Other forms take numbers with twice the digits. tr S/det S is at most some 2^42/tr Q at
///    aspect 10⁶. Errors of 2^-104 then grow to 2^-60. The ratio of the two curvatures is at most
///    the square of the aspect ratio, so the smaller one is accurate enough, too.
#ifndef PW85_DISTANCE_PRINCIPAL_CURVATURES_HPP_INCLUDED
#define PW85_DISTANCE_PRINCIPAL_CURVATURES_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/distance/walls.hpp>

namespace pw85 {

/// Principal curvatures, the smaller one first, and the unit vectors of their directions.
template <class T> struct Curvature {
    Vector<T, 2> curvatures;
    Vector<T, 3> direction1, direction2; ///< direction1 × direction2 is the unit normal
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A unit normal and two unit vectors e1 and e2 across it. e1 × e2 is the normal.
template <class T> struct TangentFrame {
    Vector<T, 3> normal, e1, e2;
};

template <class T>
PW85_FUNCTION inline TangentFrame<T> tangent_frame(Vector<T, 3> const &normal) noexcept
{
    TangentFrame<T> frame{T(T(1) / magnitude(normal)) * normal, {}, {}};
    complete_basis(frame.normal, frame.e1, frame.e2);
    return frame;
}

/// The surface of an ellipsoid at the point with the normal of a frame.
template <class T> struct CurvedSurface {
    Support<T, 3> support;
    SymmetricMatrix<T, 2> shape; ///< K in the basis of the frame
    bool accurate;               ///< true if item 2 holds
};

template <class T> PW85_FUNCTION inline CurvedSurface<T>
curved_surface(SymmetricMatrix<T, 3> const &q, TangentFrame<T> const &frame) noexcept
{
    Vector<T, 3> const qn = product(q, frame.normal), q1 = product(q, frame.e1),
                       q2 = product(q, frame.e2);
    T const square = dot(frame.normal, qn), g1 = dot(frame.e1, qn), g2 = dot(frame.e2, qn);
    SymmetricMatrix<T, 2> const s{square * dot(frame.e1, q1) - g1 * g1,
                                  square * dot(frame.e2, q1) - g1 * g2,
                                  square * dot(frame.e2, q2) - g2 * g2}; // nᵀQn S
    T const det = s[0] * s[2] - s[1] * s[1], extent = square_root(square), size = trace(q);
    T const least = negative_power_of_two<T>(mantissa_digits<T>() / 6) * size;
    return {{T(T(1) / extent) * qn, extent},
            T(T(square * extent) / det) * adjugate(s),
            square > least && s[0] > T(0) && det > T(least * square) * (s[0] + s[2])};
}

/// The eigenvalues of a symmetric matrix (xx, xy, yy), half of the difference of its diagonal, and
/// half of the difference of the eigenvalues. The smaller one is the determinant over the larger
/// one: it does not come from a difference.
template <class T> struct PrincipalValues {
    T smaller, larger, half, root;
};

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline PrincipalValues<T>
principal_values(SymmetricMatrix<T, 2> const &k) noexcept
{
    T const half = T(0.5) * (k[0] - k[2]), root = square_root(T(half * half + k[1] * k[1]));
    T const larger = T(0.5) * (k[0] + k[2]) + root;
    return {T(k[0] * k[2] - k[1] * k[1]) / larger, larger, half, root};
}

/// The eigenvalues of K and their directions.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Curvature<T>
principal_curvatures(SymmetricMatrix<T, 2> const &k, TangentFrame<T> const &frame) noexcept
{
    auto const [smaller, larger, half, root] = principal_values(k);
    // The eigenvector of the larger one is (x, y).
    bool const first = half >= T(0);
    T const long_side = absolute(half) + root;
    T const x = first ? long_side : k[1], y = first ? k[1] : long_side, square = x * x + y * y;
    bool const umbilic = !(square > T(0));
    T const reciprocal = T(1) / square_root(square);
    T const c = umbilic ? T(0) : T(x * reciprocal), s = umbilic ? T(1) : T(y * reciprocal);
    return {{smaller, larger},
            add_scaled(s * frame.e1, T(-c), frame.e2),
            add_scaled(c * frame.e1, s, frame.e2),
            StatusCode::success};
}

/// Rounds to a type with fewer digits.
template <class T, class W>
PW85_FUNCTION inline Curvature<T> rounded_curvature(Curvature<W> const &c) noexcept
{
    return {rounded(c.curvatures), rounded(c.direction1), rounded(c.direction2), c.status};
}

/// A unit in which a valid form is in range: its half-widths along the axes are at most of order
/// one, or the form is in range as it is.
template <class T> PW85_FUNCTION inline Unit unit_in_range(SymmetricMatrix<T, 3> const &q) noexcept
{
    T const largest = largest_diagonal(q);
    return is_in_range(largest, largest, largest) ? Unit{} : unit_of(q);
}

/// Brings a normal into range. Returns Status::invalid_argument if it is zero or not finite.
template <class T> PW85_FUNCTION inline StatusCode scale_normal(Vector<T, 3> &normal) noexcept
{
    if (is_in_range(sum_of_magnitudes(normal), T(1), T(1))) return StatusCode::success;
    T const largest = largest_coordinate(normal);
    if (!(is_finite(normal) && largest > T(0))) return StatusCode::invalid_argument;
    normal = unit_of(normal).to_local(normal);
    return StatusCode::success;
}

/// The curvature in units of order one, by numbers of type W; `accurate` says whether they suffice.
template <class W, class T>
PW85_FUNCTION inline Curvature<T> curvature_with(Vector<T, 3> const &normal,
                                                 SymmetricMatrix<T, 3> const &scaled,
                                                 bool &accurate) noexcept
{
    auto const frame = tangent_frame(converted<W>(normal));
    auto const surface = curved_surface(converted<W>(scaled), frame);
    accurate = surface.accurate;
    return rounded_curvature<T>(principal_curvatures(surface.shape, frame));
}

/// Computes the principal curvatures with twice the digits.
template <class T> PW85_RARE Curvature<T>
curvature_finer(Vector<T, 3> const &normal, SymmetricMatrix<T, 3> const &scaled) noexcept
{
    bool accurate;
    return curvature_with<Finer<T>>(normal, scaled, accurate);
}

PW85_RARE_TIER_OF(curvature_finer, double)

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline Curvature<T>
curvature(Vector<T, 3> normal, SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    StatusCode status = scale_normal(normal);
    if (status == StatusCode::success) status = validate(q);
    if (status != StatusCode::success) return all_nan<Curvature<T>>(status);
    Unit const unit = unit_in_range(q);
    SymmetricMatrix<T, 3> const scaled = unit.to_local(q);
    bool accurate;
    auto result = curvature_with<T>(normal, scaled, accurate);
    if (!accurate) result = curvature_finer(normal, scaled);
    result.curvatures = unit.to_caller(result.curvatures, -1);
    return result;
}

} // namespace pw85

#endif
