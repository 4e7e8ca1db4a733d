// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The first points: the two outermost ones along each of n directions, each orthogonal to the
/// differences of the pairs before (P. Kumar and E. A. Yıldırım, J. Optim. Theory Appl. 126, 1,
/// 2005). The ellipsoid around them has at least a share of the least volume that depends on n
/// alone.
#ifndef PW85_ENCLOSING_START_HPP_INCLUDED
#define PW85_ENCLOSING_START_HPP_INCLUDED

#include "cloud.hpp"

namespace pw85::detail::enclosing {

/// Finds the pairs. Returns false if the points are in a hyperplane, or so close to one that no
/// packed form with numbers of double precision is positive definite: their width along a direction
/// is below 2^-24 of their extents.
bool find_outermost(Cloud const &cloud, std::size_t pairs[][2]) noexcept;

} // namespace pw85::detail::enclosing

#endif
