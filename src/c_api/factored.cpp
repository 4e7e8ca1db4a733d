// SPDX-License-Identifier: BSD-3-Clause
// The C API: ellipsoids by their factors.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"
#include "../simd/one_pair.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_contact_factored(int status, double const r12[3],
                                                                double const s1[9],
                                                                double const s2[9],
                                                                double out[2]) noexcept
{
    return refuse_call(status, "pw85_contact_factored", Argument("r12", r12, 3),
                       Argument("s1", s1, 9, limit::independent),
                       Argument("s2", s2, 9, limit::independent), Argument("out", out));
}

int pw85_contact_factored(double const r12[3], double const s1[9], double const s2[9],
                          double out[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_factored(status, r12, s1, s2, out);
    };
    if (any_null(r12, s1, s2, out)) return refused(null_pointer(out, 2));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_factored), r12,
                                          s1, s2, out), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_geometry_factored(int status,
                                                                         double const r12[3],
                                                                         double const s1[9],
                                                                         double const s2[9],
                                                                         double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_geometry_factored",
                       Argument("r12", r12, 3, limit::not_zero),
                       Argument("s1", s1, 9, limit::independent),
                       Argument("s2", s2, 9, limit::independent),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_geometry_factored(double const r12[3], double const s1[9], double const s2[9],
                                   double lambda, double point[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_geometry_factored(status, r12, s1, s2, lambda);
    };
    if (any_null(r12, s1, s2)) return refused(null_pointer(point, 3, normal, 3));
    return checked(in_default_environment(
        PW85_OF_PAIR(kernels::chosen(), contact_geometry_factored), r12, s1, s2, lambda, point,
        normal), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_gradient_factored(int status,
                                                                         double const r12[3],
                                                                         double const s1[9],
                                                                         double const s2[9],
                                                                         double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_gradient_factored", Argument("r12", r12, 3),
                       Argument("s1", s1, 9, limit::independent),
                       Argument("s2", s2, 9, limit::independent),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_gradient_factored(double const r12[3], double const s1[9], double const s2[9],
                                   double lambda, double d_r12[3], double d_s1[9], double d_s2[9])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_gradient_factored(status, r12, s1, s2, lambda);
    };
    if (any_null(r12, s1, s2)) return refused(null_pointer(d_r12, 3, d_s1, 9, d_s2, 9));
    return checked(in_default_environment(
        PW85_OF_PAIR(kernels::chosen(), contact_gradient_factored), r12, s1, s2, lambda, d_r12,
        d_s1, d_s2), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_factored(int status, double const r12[3],
                                                                double const s1[9],
                                                                double const s2[9],
                                                                int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_factored", Argument("r12", r12, 3),
                       Argument("s1", s1, 9, limit::independent),
                       Argument("s2", s2, 9, limit::independent), Argument("overlap", overlap));
}

int pw85_overlap_factored(double const r12[3], double const s1[9], double const s2[9], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_factored(status, r12, s1, s2, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(r12, s1, s2)) return refused(PW85_EINVAL);
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), overlap_factored), r12,
                                          s1, s2, overlap), refused);
}
