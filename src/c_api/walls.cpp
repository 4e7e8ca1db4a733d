// SPDX-License-Identifier: BSD-3-Clause
// The C API: walls, points and lines.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/distance/line.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/distance/walls.hpp>
#include <pw85/volume/half_space.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_distance_plane(int status, double const normal[3],
                                                              double offset,
                                                              double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_plane",
                       Argument("normal", normal, 3, limit::not_zero), Argument("offset", offset),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_plane(double const normal[3], double offset, double const q[6], double *distance,
                        double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_plane(status, normal, offset, q);
    };
    if (any_null(normal, q)) return refused(null_pointer(distance, 1, point, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_plane(load_vector<3>(normal), offset, load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_plane_derivatives(
    int status, double const normal[3], double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_plane_derivatives",
                       Argument("normal", normal, 3, limit::not_zero),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_plane_derivatives(double const normal[3], double const q[6], double d_center[3],
                                    double d_rot[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_plane_derivatives(status, normal, q);
    };
    if (any_null(normal, q)) return refused(null_pointer(d_center, 3, d_rot, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_plane_derivatives(load_vector<3>(normal),
                                                             load_matrix<3>(q));
        return put(result.status, result.center, d_center, result.rotation, d_rot);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_plane(int status, double const normal[3],
                                                             double offset,
                                                             double const q[6]) noexcept
{
    return refuse_call(status, "pw85_contact_plane", Argument("normal", normal, 3, limit::not_zero),
                       Argument("offset", offset), Argument("q", q, 6, limit::definite));
}

int pw85_contact_plane(double const normal[3], double offset, double const q[6], double *mu2,
                       double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_plane(status, normal, offset, q);
    };
    if (any_null(normal, q)) return refused(null_pointer(mu2, 1, point, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_plane(load_vector<3>(normal), offset, load_matrix<3>(q));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_plane_derivatives(int status,
                                                                         double const normal[3],
                                                                         double offset,
                                                                         double const q[6]) noexcept
{
    return refuse_call(status, "pw85_contact_plane_derivatives",
                       Argument("normal", normal, 3, limit::not_zero), Argument("offset", offset),
                       Argument("q", q, 6, limit::definite));
}

int pw85_contact_plane_derivatives(double const normal[3], double offset, double const q[6],
                                   double d_center[3], double d_rot[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_plane_derivatives(status, normal, offset, q);
    };
    if (any_null(normal, q)) return refused(null_pointer(d_center, 3, d_rot, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_plane_derivatives(load_vector<3>(normal), offset,
                                                            load_matrix<3>(q));
        return put(result.status, result.center, d_center, result.rotation, d_rot);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_box(int status, double const lower[3],
                                                            double const upper[3],
                                                            double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_box", Argument("lower", lower, 3, limit::below_next),
                       Argument("upper", upper, 3, limit::below_next),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_box(double const lower[3], double const upper[3], double const q[6],
                      double *distance, double point[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_box(status, lower, upper, q);
    };
    if (any_null(lower, upper, q)) return refused(null_pointer(distance, 1, point, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_box(load_vector<3>(lower), load_vector<3>(upper),
                                               load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point, point, result.normal,
                   normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_cylinder(int status, double const axis[3],
                                                                 double radius,
                                                                 double const center[3],
                                                                 double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_cylinder", Argument("axis", axis, 3, limit::not_zero),
                       Argument("radius", radius, limit::positive), Argument("center", center, 3),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_cylinder(double const axis[3], double radius, double const center[3],
                           double const q[6], double *distance, double point[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_cylinder(status, axis, radius, center, q);
    };
    if (any_null(axis, center, q)) return refused(null_pointer(distance, 1, point, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_cylinder(load_vector<3>(axis), radius,
                                                    load_vector<3>(center), load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point, point, result.normal,
                   normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_point(int status, double const r[3],
                                                              double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_point", Argument("r", r, 3),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_point(double const r[3], double const q[6], double *distance, double point[3],
                        double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_point(status, r, q);
    };
    if (any_null(r, q)) return refused(null_pointer(distance, 1, point, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_point(load_vector<3>(r), load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point, point, result.normal,
                   normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_intersect_line(int status, double const origin[3],
                                                              double const direction[3],
                                                              double const q[6],
                                                              double t[2]) noexcept
{
    return refuse_call(status, "pw85_intersect_line", Argument("origin", origin, 3),
                       Argument("direction", direction, 3, limit::not_zero),
                       Argument("q", q, 6, limit::definite), Argument("t", t));
}

int pw85_intersect_line(double const origin[3], double const direction[3], double const q[6],
                        double t[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_intersect_line(status, origin, direction, q, t);
    };
    if (any_null(origin, direction, q, t)) return refused(null_pointer(t, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::intersect_line(load_vector<3>(origin), load_vector<3>(direction),
                                                 load_matrix<3>(q));
        return put(result.status, result.enter, t, result.leave, t + 1);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_volume_plane(int status,
                                                                    double const normal[3],
                                                                    double offset,
                                                                    double const q[6],
                                                                    double *volume) noexcept
{
    return refuse_call(status, "pw85_overlap_volume_plane",
                       Argument("normal", normal, 3, limit::not_zero), Argument("offset", offset),
                       Argument("q", q, 6, limit::definite), Argument("volume", volume));
}

int pw85_overlap_volume_plane(double const normal[3], double offset, double const q[6],
                              double *volume)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_volume_plane(status, normal, offset, q, volume);
    };
    if (any_null(normal, q, volume)) return refused(null_pointer(volume, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_volume_plane(load_vector<3>(normal), offset,
                                                       load_matrix<3>(q));
        return put(result.status, result.volume, volume);
    });
    return checked(status, refused);
}
