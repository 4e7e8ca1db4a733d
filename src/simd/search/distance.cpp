// SPDX-License-Identifier: BSD-3-Clause
// The distance of one pair. It is compiled for the baseline and for one newer instruction set
// (meson.build).
#include "../one_pair.hpp"

#include <pw85/distance/distance_derivatives.hpp>

#include "../../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int distance_geometry(double const *r12, double const *q1, double const *q2, double *distance,
                      double *point1, double *point2, double *normal) noexcept
{
    auto const result = pw85::distance(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    return put(result.status, result.distance, distance, result.point1, point1, result.point2,
               point2, result.normal, normal);
}

int distance(double const *r12, double const *q1, double const *q2, double *distance,
             double *point1, double *point2) noexcept
{
    return distance_geometry(r12, q1, q2, distance, point1, point2, nullptr);
}

int distance_derivatives(double const *r12, double const *q1, double const *q2, double *d_r12,
                         double *d_rot1, double *d_rot2, double *hessian) noexcept
{
    auto const result =
        pw85::distance_derivatives(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    return put(result.status, result.r12, d_r12, result.rotation1, d_rot1, result.rotation2, d_rot2,
               result.hessian, hessian);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
