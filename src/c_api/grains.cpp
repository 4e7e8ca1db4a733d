// SPDX-License-Identifier: BSD-3-Clause
// The C API: curvature and contact of grains.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/distance/grain_contact.hpp>
#include <pw85/distance/grain_contact_wall.hpp>
#include <pw85/distance/hertz.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_curvature(double const normal[3], double const q[6], double curvatures[2],
                   double directions[6])
{
    if (any_null(normal, q)) return null_pointer(curvatures, 2, directions, 6);
    return in_default_environment([&] {
        auto const result = pw85::curvature(load_vector<3>(normal), load_matrix<3>(q));
        return put(result.status, result.curvatures, curvatures, result.direction1, directions,
                   result.direction2, part(directions, 3));
    });
}

int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2])
{
    if (any_null(curvatures)) return null_pointer(radius, 1, ellipse, 2);
    return in_default_environment([&] {
        auto const result = pw85::hertz(load_vector<2>(curvatures));
        return put(result.status, result.radius, radius, result.ellipse, ellipse);
    });
}

int pw85_hertz_contact(double const r12[3], double const q1[6], double const q2[6],
                       double const normal[3], double *depth, double point[3], double curvatures[2],
                       double directions[6], double *radius, double ellipse[2])
{
    if (any_null(r12, q1, q2, normal))
        return null_pointer(depth, 1, point, 3, curvatures, 2, directions, 6, radius, 1, ellipse,
                            2);
    return in_default_environment([&] {
        auto const result = pw85::hertz_contact(load_vector<3>(r12), load_matrix<3>(q1),
                                                load_matrix<3>(q2), load_vector<3>(normal));
        return put(result.status, result.depth, depth, result.point, point,
                   result.relative.curvatures, curvatures, result.relative.direction1, directions,
                   result.relative.direction2, part(directions, 3), result.hertz.radius, radius,
                   result.hertz.ellipse, ellipse);
    });
}

int pw85_grain_contact(double const r12[3], double const q1[6], double const q2[6],
                       double const start[3], double normal[3], double *depth, double point[3],
                       double curvatures[2], double *radius)
{
    if (any_null(r12, q1, q2, start))
        return null_pointer(normal, 3, depth, 1, point, 3, curvatures, 2, radius, 1);
    return in_default_environment([&] {
        auto const result = pw85::grain_contact(load_vector<3>(r12), load_matrix<3>(q1),
                                                load_matrix<3>(q2), load_vector<3>(start));
        return put(result.status, result.normal, normal, result.depth, depth, result.point, point,
                   result.curvatures, curvatures, result.radius, radius);
    });
}

int pw85_grain_radius_gradient(double const r12[3], double const q1[6], double const q2[6],
                               double const normal[3], double d_r12[3], double d_rot1[3],
                               double d_rot2[3])
{
    if (any_null(r12, q1, q2, normal)) return null_pointer(d_r12, 3, d_rot1, 3, d_rot2, 3);
    return in_default_environment([&] {
        auto const result = pw85::grain_radius_gradient(load_vector<3>(r12), load_matrix<3>(q1),
                                                        load_matrix<3>(q2), load_vector<3>(normal));
        return put(result.status, result.r12, d_r12, result.rotation1, d_rot1, result.rotation2,
                   d_rot2);
    });
}

int pw85_grain_contact_wall(double const normal[3], double offset, double const direction[3],
                            double curvature, double const q[6], double *depth, double point[3],
                            double curvatures[2], double *radius)
{
    if (any_null(normal, direction, q))
        return null_pointer(depth, 1, point, 3, curvatures, 2, radius, 1);
    return in_default_environment([&] {
        auto const result = pw85::grain_contact_wall(load_vector<3>(normal), offset,
                                                     load_vector<3>(direction), curvature,
                                                     load_matrix<3>(q));
        return put(result.status, result.depth, depth, result.point, point, result.curvatures,
                   curvatures, result.radius, radius);
    });
}
