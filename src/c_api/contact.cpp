// SPDX-License-Identifier: BSD-3-Clause
// The C API: contact of two ellipsoids.
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

[[gnu::cold, gnu::noinline]] static int refuse_contact(int status, double const r12[3],
                                                       double const q1[6], double const q2[6],
                                                       double out[2]) noexcept
{
    return refuse_call(status, "pw85_contact", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("out", out));
}

int pw85_contact(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact(status, r12, q1, q2, out);
    };
    if (any_null(r12, q1, q2, out)) return refused(null_pointer(out, 2));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact), r12, q1, q2,
                                          out), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_geometry(int status, double const r12[3],
                                                                double const q1[6],
                                                                double const q2[6],
                                                                double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_geometry", Argument("r12", r12, 3, limit::not_zero),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_geometry(double const r12[3], double const q1[6], double const q2[6],
                          double lambda, double point[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_geometry(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(point, 3, normal, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_geometry), r12,
                                          q1, q2, lambda, point, normal), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_gradient(int status, double const r12[3],
                                                                double const q1[6],
                                                                double const q2[6],
                                                                double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_gradient", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_gradient(double const r12[3], double const q1[6], double const q2[6],
                          double lambda, double d_r12[3], double d_q1[6], double d_q2[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_gradient(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_r12, 3, d_q1, 6, d_q2, 6));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_gradient), r12,
                                          q1, q2, lambda, d_r12, d_q1, d_q2), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_torque(int status, double const r12[3],
                                                              double const q1[6],
                                                              double const q2[6],
                                                              double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_torque", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_torque(double const r12[3], double const q1[6], double const q2[6], double lambda,
                        double d_rot1[3], double d_rot2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_torque(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_rot1, 3, d_rot2, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_torque), r12, q1,
                                          q2, lambda, d_rot1, d_rot2), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_hessian(int status, double const r12[3],
                                                               double const q1[6],
                                                               double const q2[6], double lambda,
                                                               double hessian[81]) noexcept
{
    return refuse_call(status, "pw85_contact_hessian", Argument("r12", r12, 3, limit::not_zero),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval),
                       Argument("hessian", hessian));
}

int pw85_contact_hessian(double const r12[3], double const q1[6], double const q2[6], double lambda,
                         double hessian[81])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_hessian(status, r12, q1, q2, lambda, hessian);
    };
    if (any_null(r12, q1, q2, hessian)) return refused(null_pointer(hessian, 81));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_hessian), r12, q1,
                                          q2, lambda, hessian), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_closest_approach(int status,
                                                                double const direction[3],
                                                                double const q1[6],
                                                                double const q2[6],
                                                                double *distance) noexcept
{
    return refuse_call(status, "pw85_closest_approach",
                       Argument("direction", direction, 3, limit::not_zero),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("distance", distance));
}

int pw85_closest_approach(double const direction[3], double const q1[6], double const q2[6],
                          double *distance)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_closest_approach(status, direction, q1, q2, distance);
    };
    if (any_null(direction, q1, q2, distance)) return refused(null_pointer(distance, 1));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), closest_approach),
                                          direction, q1, q2, distance), refused);
}
