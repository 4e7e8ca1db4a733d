// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An orthonormal basis that grows vector by vector, by the method of Gram and Schmidt.
#ifndef PW85_ENCLOSING_BASIS_HPP_INCLUDED
#define PW85_ENCLOSING_BASIS_HPP_INCLUDED

#include "cloud.hpp"

namespace pw85::detail::enclosing {

/// Unit vectors that are orthogonal to each other.
struct Basis {
    int n, size;
    double vectors[max_dimension][max_dimension];
};

/// Subtracts the projection onto the basis, twice: a single subtraction leaves the rounding errors
/// of a large vector.
void subtract_projection(Basis const &basis, double *x) noexcept;

/// Divides a vector by its length, unless it is zero. Returns the length.
double normalize(int n, double *x) noexcept;

} // namespace pw85::detail::enclosing

#endif
