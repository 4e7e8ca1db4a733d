// SPDX-License-Identifier: BSD-3-Clause
// Points, normals and derivatives of the contact function of one pair. It is compiled for the
// baseline and for one newer instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/contact/contact_hessian.hpp>
#include <pw85/contact/geometry.hpp>

#include "../../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int contact_geometry(double const *r12, double const *q1, double const *q2, double lambda,
                     double *point, double *normal) noexcept
{
    auto const result =
        pw85::contact_geometry(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda);
    return put(result.status, result.point, point, result.normal, normal);
}

int contact_gradient(double const *r12, double const *q1, double const *q2, double lambda,
                     double *d_r12, double *d_q1, double *d_q2) noexcept
{
    auto const result =
        pw85::contact_gradient(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda);
    return put(result.status, result.r12, d_r12, result.q1, d_q1, result.q2, d_q2);
}

int contact_torque(double const *r12, double const *q1, double const *q2, double lambda,
                   double *d_rot1, double *d_rot2) noexcept
{
    auto const result =
        pw85::contact_torque(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda);
    return put(result.status, result.rotation1, d_rot1, result.rotation2, d_rot2);
}

int contact_hessian(double const *r12, double const *q1, double const *q2, double lambda,
                    double *hessian) noexcept
{
    auto const result =
        pw85::contact_hessian(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda);
    return put(result.status, result.entries, hessian);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
