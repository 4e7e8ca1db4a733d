// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipse or ellipsoid around points, and random points of an ellipsoid, from C++:
/// the functions of pw85_enclosing.h (link with pw85), and their contracts. Here the smallest
/// ellipsoid is for two and three dimensions; the functions of C are for 1 to 16.
#ifndef PW85_ENCLOSING_HPP_INCLUDED
#define PW85_ENCLOSING_HPP_INCLUDED

#include <pw85_enclosing.h>

#include <span>

#include <pw85/algebra/symmetric.hpp>
#include <pw85/status.hpp>

namespace pw85 {

/// An ellipsoid around points.
template <int D> struct EnclosingEllipsoid {
    Vector<double, D> center;
    SymmetricMatrix<double, D> q; ///< form of the ellipsoid
    double excess;                ///< upper bound of volume/(least volume) - 1
    StatusCode status;            ///< `no_convergence` if the excess exceeds the tolerance
};

/// Returns the ellipsoid of least volume around points, up to a tolerance, in two or three
/// dimensions. The contract is that of the C function.
///
/// @param points at least D + 1
/// @param tolerance of the volume, relative; above zero
/// @return the ellipsoid; Status::invalid_argument, Status::not_positive_definite for points in a
///         line or plane, with the ellipsoid of their affine hull, Status::no_convergence if the
///         excess exceeds the tolerance, or Status::out_of_memory
template <int D> static inline EnclosingEllipsoid<D>
enclosing_ellipsoid(std::span<Vector<double, D> const> points, double tolerance) noexcept
{
    static_assert(sizeof(Vector<double, D>) == D * sizeof(double));
    EnclosingEllipsoid<D> found;
    auto const *const numbers = reinterpret_cast<double const *>(points.data());
    int const status =
        pw85_enclosing_ellipsoid(D, points.size(), numbers, tolerance, found.center.coordinates,
                                 found.q.entries, &found.excess);
    found.status = static_cast<StatusCode>(status);
    return found;
}

/// Returns the ellipsoid of least volume around ellipsoids, up to a tolerance, in two or three
/// dimensions. The contract is that of the C function.
///
/// @param centers of the ellipsoids, at least one
/// @param forms of the ellipsoids, as many
/// @param tolerance of the volume, relative; above zero
/// @return as enclosing_ellipsoid(); Status::invalid_argument also for unequal numbers of centres
///         and forms
template <int D> static inline EnclosingEllipsoid<D>
enclosing_ellipsoid_of(std::span<Vector<double, D> const> centers,
                       std::span<SymmetricMatrix<double, D> const> forms, double tolerance) noexcept
{
    static_assert(sizeof(Vector<double, D>) == D * sizeof(double));
    static_assert(sizeof(SymmetricMatrix<double, D>) == D * (D + 1) / 2 * sizeof(double));
    EnclosingEllipsoid<D> found;
    std::size_t const m = centers.size() == forms.size() ? centers.size() : 0;
    int const status =
        pw85_enclosing_ellipsoid_of(D, m, reinterpret_cast<double const *>(centers.data()),
                                    reinterpret_cast<double const *>(forms.data()), tolerance,
                                    found.center.coordinates, found.q.entries, &found.excess);
    found.status = static_cast<StatusCode>(status);
    return found;
}

/// Random points of an ellipsoid with its centre at 0, uniform in its volume or on its surface. The
/// contract is that of pw85_random_points().
///
/// @param q form of the ellipsoid
/// @param surface whether the points are on the surface
/// @param seed selects the random numbers
/// @param[out] points NaN if the status is not success
/// @return Status::success, Status::invalid_argument or Status::not_positive_definite
static inline StatusCode random_points(SymmetricMatrix<double, 3> const &q, bool surface,
                                       std::size_t seed,
                                       std::span<Vector<double, 3>> points) noexcept
{
    static_assert(sizeof(Vector<double, 3>) == 3 * sizeof(double));
    auto *const numbers = reinterpret_cast<double *>(points.data());
    return static_cast<StatusCode>(
        pw85_random_points(q.entries, surface, seed, points.size(), numbers));
}

} // namespace pw85

#endif
