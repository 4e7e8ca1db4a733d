// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions of this folder that the C API calls.
#ifndef PW85_SRC_ENCLOSING_FUNCTIONS_HPP_INCLUDED
#define PW85_SRC_ENCLOSING_FUNCTIONS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85/algebra/symmetric.hpp>

#include "around_ellipsoids.hpp"

namespace pw85::detail::enclosing {

/// The arrays of the caller for an ellipsoid in n dimensions. Each may be null.
struct Outputs {
    int n;
    double *center, *q, *excess;
};

/// Searches for the smallest ellipsoid around m points in n dimensions, and stores what it finds.
/// Points in a hyperplane have the ellipsoid of their affine hull, and the status
/// not_positive_definite.
Status enclose(int n, std::size_t m, double const *points, double tolerance,
               Outputs const &outputs) noexcept;

/// Searches for the smallest ellipsoid around ellipsoids, and stores what it finds.
Status enclose(Ellipsoids const &bodies, double tolerance, Outputs const &outputs) noexcept;

/// Draws random points of an ellipsoid, whose form is positive definite.
void draw_points(SymmetricMatrix<double, 3> const &q, bool surface, std::uint64_t seed,
                 std::size_t num_points, double *points) noexcept;

} // namespace pw85::detail::enclosing

#endif
