// SPDX-License-Identifier: BSD-3-Clause
// The C API: curvature and contact of grains.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/distance/grain_contact.hpp>
#include <pw85/distance/grain_contact_wall.hpp>
#include <pw85/distance/hertz.hpp>
#include <pw85/distance/principal_curvatures.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_curvature(int status, double const normal[3],
                                                         double const q[6]) noexcept
{
    return refuse_call(status, "pw85_curvature", Argument("normal", normal, 3, limit::not_zero),
                       Argument("q", q, 6, limit::definite));
}

int pw85_curvature(double const normal[3], double const q[6], double curvatures[2],
                   double directions[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_curvature(status, normal, q);
    };
    if (any_null(normal, q)) return refused(null_pointer(curvatures, 2, directions, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::curvature(load_vector<3>(normal), load_matrix<3>(q));
        return put(result.status, result.curvatures, curvatures, result.direction1, directions,
                   result.direction2, part(directions, 3));
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_hertz(int status,
                                                     double const curvatures[2]) noexcept
{
    return refuse_call(status, "pw85_hertz",
                       Argument("curvatures", curvatures, 2, limit::positive));
}

int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_hertz(status, curvatures);
    };
    if (any_null(curvatures)) return refused(null_pointer(radius, 1, ellipse, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::hertz(load_vector<2>(curvatures));
        return put(result.status, result.radius, radius, result.ellipse, ellipse);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_hertz_contact(int status, double const r12[3],
                                                             double const q1[6], double const q2[6],
                                                             double const normal[3]) noexcept
{
    return refuse_call(status, "pw85_hertz_contact", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("normal", normal, 3, limit::not_zero));
}

int pw85_hertz_contact(double const r12[3], double const q1[6], double const q2[6],
                       double const normal[3], double *depth, double point[3], double curvatures[2],
                       double directions[6], double *radius, double ellipse[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_hertz_contact(status, r12, q1, q2, normal);
    };
    if (any_null(r12, q1, q2, normal))
        return refused(null_pointer(depth, 1, point, 3, curvatures, 2, directions, 6, radius, 1,
                                    ellipse, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::hertz_contact(load_vector<3>(r12), load_matrix<3>(q1),
                                                load_matrix<3>(q2), load_vector<3>(normal));
        return put(result.status, result.depth, depth, result.point, point,
                   result.relative.curvatures, curvatures, result.relative.direction1, directions,
                   result.relative.direction2, part(directions, 3), result.hertz.radius, radius,
                   result.hertz.ellipse, ellipse);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_grain_contact(int status, double const r12[3],
                                                             double const q1[6], double const q2[6],
                                                             double const start[3]) noexcept
{
    return refuse_call(status, "pw85_grain_contact", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("start", start, 3, limit::not_zero));
}

int pw85_grain_contact(double const r12[3], double const q1[6], double const q2[6],
                       double const start[3], double normal[3], double *depth, double point[3],
                       double curvatures[2], double *radius)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_grain_contact(status, r12, q1, q2, start);
    };
    if (any_null(r12, q1, q2, start))
        return refused(null_pointer(normal, 3, depth, 1, point, 3, curvatures, 2, radius, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::grain_contact(load_vector<3>(r12), load_matrix<3>(q1),
                                                load_matrix<3>(q2), load_vector<3>(start));
        return put(result.status, result.normal, normal, result.depth, depth, result.point, point,
                   result.curvatures, curvatures, result.radius, radius);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_grain_radius_gradient(
    int status, double const r12[3], double const q1[6], double const q2[6],
    double const normal[3]) noexcept
{
    return refuse_call(status, "pw85_grain_radius_gradient", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("normal", normal, 3, limit::not_zero));
}

int pw85_grain_radius_gradient(double const r12[3], double const q1[6], double const q2[6],
                               double const normal[3], double d_r12[3], double d_rot1[3],
                               double d_rot2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_grain_radius_gradient(status, r12, q1, q2, normal);
    };
    if (any_null(r12, q1, q2, normal)) return refused(null_pointer(d_r12, 3, d_rot1, 3, d_rot2, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::grain_radius_gradient(load_vector<3>(r12), load_matrix<3>(q1),
                                                        load_matrix<3>(q2), load_vector<3>(normal));
        return put(result.status, result.r12, d_r12, result.rotation1, d_rot1, result.rotation2,
                   d_rot2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_grain_contact_wall(int status,
                                                                  double const normal[3],
                                                                  double offset,
                                                                  double const direction[3],
                                                                  double curvature,
                                                                  double const q[6]) noexcept
{
    return refuse_call(status, "pw85_grain_contact_wall",
                       Argument("normal", normal, 3, limit::not_zero), Argument("offset", offset),
                       Argument("direction", direction, 3, limit::not_zero),
                       Argument("curvature", curvature), Argument("q", q, 6, limit::definite));
}

int pw85_grain_contact_wall(double const normal[3], double offset, double const direction[3],
                            double curvature, double const q[6], double *depth, double point[3],
                            double curvatures[2], double *radius)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_grain_contact_wall(status, normal, offset, direction, curvature, q);
    };
    if (any_null(normal, direction, q))
        return refused(null_pointer(depth, 1, point, 3, curvatures, 2, radius, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::grain_contact_wall(load_vector<3>(normal), offset,
                                                     load_vector<3>(direction), curvature,
                                                     load_matrix<3>(q));
        return put(result.status, result.depth, depth, result.point, point, result.curvatures,
                   curvatures, result.radius, radius);
    });
    return checked(status, refused);
}
