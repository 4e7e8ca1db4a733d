// SPDX-License-Identifier: BSD-3-Clause
// The distance of one pair. It is compiled for the baseline and for one newer instruction set
// (meson.build).
#include "one_pair.hpp"

#include <pw85/distance/distance_derivatives.hpp>

#include "../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_COMPILED_FOR {

int distance(double const *r12, double const *q1, double const *q2, double *distance,
             double *point1, double *point2) noexcept
{
    return put(pw85::distance(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)),
               distance, point1, point2, nullptr);
}

int distance_derivatives(double const *r12, double const *q1, double const *q2, double *d_r12,
                         double *d_rot1, double *d_rot2, double *hessian) noexcept
{
    return put(
        pw85::distance_derivatives(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)),
        d_r12, d_rot1, d_rot2, hessian);
}

} // namespace PW85_COMPILED_FOR

} // namespace pw85::detail::kernels
