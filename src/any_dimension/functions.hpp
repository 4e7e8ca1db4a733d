// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions nd_*() of include/pw85/any_dimension for doubles. They are compiled once, with the
/// flags of this folder; the C API calls them.
#ifndef PW85_SRC_ANY_DIMENSION_FUNCTIONS_HPP_INCLUDED
#define PW85_SRC_ANY_DIMENSION_FUNCTIONS_HPP_INCLUDED

#include <pw85/any_dimension/containment.hpp>
#include <pw85/any_dimension/distance.hpp>
#include <pw85/any_dimension/geometry.hpp>
#include <pw85/any_dimension/overlap.hpp>

namespace pw85::detail::compiled {

Contact<double> nd_contact(int n, double const *r12, double const *q1, double const *q2) noexcept;

Status nd_contact_geometry(int n, double const *r12, double const *q1, double const *q2,
                           double lambda, NdGeometry const &out) noexcept;

NdComparison nd_compare(int n, double const *r12, double const *q1, double const *q2,
                        double mu2) noexcept;

NdOverlap nd_overlap(int n, double const *r12, double const *q1, double const *q2) noexcept;

NdContainment nd_contains(int n, double const *r12, double const *q1, double const *q2) noexcept;

NdContainmentScale nd_containment(int n, double const *r12, double const *q1, double const *q2,
                                  double *point) noexcept;

NdDistance nd_distance(int n, double const *r12, double const *q1, double const *q2,
                       NdClosestPoints const &out) noexcept;

} // namespace pw85::detail::compiled

#endif
