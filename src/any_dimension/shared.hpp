// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Templates of `include/pw85/any_dimension` that several units need. They are compiled once, in
/// any_dimension.cpp.
#ifndef PW85_SRC_ANY_DIMENSION_SHARED_HPP_INCLUDED
#define PW85_SRC_ANY_DIMENSION_SHARED_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/any_dimension/containment.hpp>

namespace pw85::detail::any_dimension {

/// status_of_form().
StatusCode exact_status_of_form(int n, double const *q) noexcept;

/// minimize_dual() for the pair in the memory, until the bounds of κ² agree to rounding.
void find_dual(ReachWorkspace<double> &memory) noexcept;

/// Returns whether one of two ν proves that ellipsoid 2 is inside, with r12 of twice the digits of
/// double: shows_inside(). r12 of `in` is not used.
bool shows_inside_wider(Input const &in, Doubled<double> const *r12, double nu,
                        double other) noexcept;

} // namespace pw85::detail::any_dimension

#endif
