// SPDX-License-Identifier: BSD-3-Clause
// One pair of ellipsoids by their factors. It is compiled for the baseline and for one newer
// instruction set (meson.build).
#include "../one_pair.hpp"

#include <pw85/contact/contact_factored.hpp>
#include <pw85/contact/geometry_factored.hpp>
#include <pw85/overlap/overlap_factored.hpp>

#include "../../base/c_arrays.hpp"

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int contact_factored(double const *r12, double const *s1, double const *s2, double *out) noexcept
{
    auto const result =
        pw85::contact_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2));
    return put(result.status, result.mu2, out, result.lambda, out + 1);
}

int overlap_factored(double const *r12, double const *s1, double const *s2, int *overlap) noexcept
{
    auto const result =
        pw85::overlap_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2));
    return put(result.status, result.overlap, overlap);
}

int contact_geometry_factored(double const *r12, double const *s1, double const *s2, double lambda,
                              double *point, double *normal) noexcept
{
    auto const result = pw85::contact_geometry_factored(load_vector<3>(r12), load_factor<3>(s1),
                                                        load_factor<3>(s2), lambda);
    return put(result.status, result.point, point, result.normal, normal);
}

int contact_gradient_factored(double const *r12, double const *s1, double const *s2, double lambda,
                              double *d_r12, double *d_s1, double *d_s2) noexcept
{
    auto const result = pw85::contact_gradient_factored(load_vector<3>(r12), load_factor<3>(s1),
                                                        load_factor<3>(s2), lambda);
    return put(result.status, result.r12, d_r12, result.s1, d_s1, result.s2, d_s2);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
