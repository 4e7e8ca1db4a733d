// SPDX-License-Identifier: BSD-3-Clause
// The C API: distance.
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

[[gnu::cold, gnu::noinline]] static int refuse_distance(int status, double const r12[3],
                                                        double const q1[6],
                                                        double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_distance", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_distance(double const r12[3], double const q1[6], double const q2[6], double *distance,
                  double point1[3], double point2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(distance, 1, point1, 3, point2, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), distance), r12, q1, q2,
                                          distance, point1, point2), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_geometry(int status, double const r12[3],
                                                                 double const q1[6],
                                                                 double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_distance_geometry", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_distance_geometry(double const r12[3], double const q1[6], double const q2[6],
                           double *distance, double point1[3], double point2[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_geometry(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), distance_geometry), r12,
                                          q1, q2, distance, point1, point2, normal), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_derivatives(int status, double const r12[3],
                                                                    double const q1[6],
                                                                    double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_distance_derivatives", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_distance_derivatives(double const r12[3], double const q1[6], double const q2[6],
                              double d_r12[3], double d_rot1[3], double d_rot2[3],
                              double hessian[81])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_derivatives(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(d_r12, 3, d_rot1, 3, d_rot2, 3, hessian, 81));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), distance_derivatives),
                                          r12, q1, q2, d_r12, d_rot1, d_rot2, hessian), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_penetration(int status, double const r12[3],
                                                           double const q1[6],
                                                           double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_penetration", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_penetration(double const r12[3], double const q1[6], double const q2[6], double *depth,
                     double direction[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_penetration(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(depth, 1, direction, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), penetration), r12, q1, q2,
                                          depth, direction), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_signed_distance(int status, double const r12[3],
                                                               double const q1[6],
                                                               double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_signed_distance", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_signed_distance(double const r12[3], double const q1[6], double const q2[6],
                         double *distance, double point1[3], double point2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_signed_distance(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(distance, 1, point1, 3, point2, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), signed_distance), r12, q1,
                                          q2, distance, point1, point2), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_signed_distance_geometry(int status,
                                                                        double const r12[3],
                                                                        double const q1[6],
                                                                        double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_signed_distance_geometry", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_signed_distance_geometry(double const r12[3], double const q1[6], double const q2[6],
                                  double *distance, double point1[3], double point2[3],
                                  double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_signed_distance_geometry(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), signed_distance_geometry),
                                          r12, q1, q2, distance, point1, point2, normal), refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_signed_distance_derivatives(
    int status, double const r12[3], double const q1[6], double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_signed_distance_derivatives", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_signed_distance_derivatives(double const r12[3], double const q1[6], double const q2[6],
                                     double d_r12[3], double d_rot1[3], double d_rot2[3],
                                     double hessian[81])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_signed_distance_derivatives(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(d_r12, 3, d_rot1, 3, d_rot2, 3, hessian, 81));
    return checked(in_default_environment(
        PW85_OF_PAIR(kernels::chosen(), signed_distance_derivatives), r12, q1, q2, d_r12, d_rot1,
        d_rot2, hessian), refused);
}
