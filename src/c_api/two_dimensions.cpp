// SPDX-License-Identifier: BSD-3-Clause
// The C API: two dimensions.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/bodies/inertia.hpp>
#include <pw85/bodies/surface.hpp>
#include <pw85/contact/closest_approach.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/contact_hessian.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/distance/distance.hpp>
#include <pw85/distance/gap_inside.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/distance/penetration.hpp>
#include <pw85/distance/signed_distance.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/containment_factor.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/shapes/box.hpp>
#include <pw85/shapes/in_plane.hpp>
#include <pw85/shapes/overlap_shapes.hpp>
#include <pw85/shapes/segment.hpp>
#include <pw85/volume/overlap_area_derivatives.hpp>
#include <pw85/volume/overlap_volume.hpp>
#include <pw85/volume/volume.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_area_2d(int status, double const q[3],
                                                       double *area) noexcept
{
    return refuse_call(status, "pw85_area_2d", Argument("q", q, 3, limit::definite),
                       Argument("area", area));
}

int pw85_area_2d(double const q[3], double *area)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_area_2d(status, q, area);
    };
    if (any_null(q, area)) return refused(null_pointer(area, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::area(load_matrix<2>(q));
        return put(result.status, result.area, area);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_area_2d(int status, double const r12[2],
                                                               double const q1[3],
                                                               double const q2[3],
                                                               double *area) noexcept
{
    return refuse_call(status, "pw85_overlap_area_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite), Argument("area", area));
}

int pw85_overlap_area_2d(double const r12[2], double const q1[3], double const q2[3], double *area)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_area_2d(status, r12, q1, q2, area);
    };
    if (any_null(r12, q1, q2, area)) return refused(null_pointer(area, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_area(load_vector<2>(r12), load_matrix<2>(q1),
                                               load_matrix<2>(q2));
        return put(result.status, result.area, area);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_area_gradient_2d(int status,
                                                                        double const r12[2],
                                                                        double const q1[3],
                                                                        double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_overlap_area_gradient_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_overlap_area_gradient_2d(double const r12[2], double const q1[3], double const q2[3],
                                  double d_r12[2], double d_q1[3], double d_q2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_area_gradient_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_r12, 2, d_q1, 3, d_q2, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_area_gradient(load_vector<2>(r12), load_matrix<2>(q1),
                                                        load_matrix<2>(q2));
        return put(result.status, result.r12, d_r12, result.q1, d_q1, result.q2, d_q2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_area_torque_2d(int status,
                                                                      double const r12[2],
                                                                      double const q1[3],
                                                                      double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_overlap_area_torque_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_overlap_area_torque_2d(double const r12[2], double const q1[3], double const q2[3],
                                double *d_rot1, double *d_rot2)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_area_torque_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_rot1, 1, d_rot2, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_area_torque(load_vector<2>(r12), load_matrix<2>(q1),
                                                      load_matrix<2>(q2));
        return put(result.status, result.rotation1, d_rot1, result.rotation2, d_rot2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_2d(int status, double const r12[2],
                                                          double const q1[3], double const q2[3],
                                                          double out[2]) noexcept
{
    return refuse_call(status, "pw85_contact_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite), Argument("out", out));
}

int pw85_contact_2d(double const r12[2], double const q1[3], double const q2[3], double out[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_2d(status, r12, q1, q2, out);
    };
    if (any_null(r12, q1, q2, out)) return refused(null_pointer(out, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact(load_vector<2>(r12), load_matrix<2>(q1),
                                          load_matrix<2>(q2));
        return put(result.status, result.mu2, out, result.lambda, out + 1);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_geometry_2d(int status, double const r12[2],
                                                                   double const q1[3],
                                                                   double const q2[3],
                                                                   double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_geometry_2d", Argument("r12", r12, 2, limit::not_zero),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                             double lambda, double point[2], double normal[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_geometry_2d(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(point, 2, normal, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_geometry(load_vector<2>(r12), load_matrix<2>(q1),
                                                   load_matrix<2>(q2), lambda);
        return put(result.status, result.point, point, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_gradient_2d(int status, double const r12[2],
                                                                   double const q1[3],
                                                                   double const q2[3],
                                                                   double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_gradient_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_gradient_2d(double const r12[2], double const q1[3], double const q2[3],
                             double lambda, double d_r12[2], double d_q1[3], double d_q2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_gradient_2d(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_r12, 2, d_q1, 3, d_q2, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_gradient(load_vector<2>(r12), load_matrix<2>(q1),
                                                   load_matrix<2>(q2), lambda);
        return put(result.status, result.r12, d_r12, result.q1, d_q1, result.q2, d_q2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_torque_2d(int status, double const r12[2],
                                                                 double const q1[3],
                                                                 double const q2[3],
                                                                 double lambda) noexcept
{
    return refuse_call(status, "pw85_contact_torque_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval));
}

int pw85_contact_torque_2d(double const r12[2], double const q1[3], double const q2[3],
                           double lambda, double *d_rot1, double *d_rot2)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_torque_2d(status, r12, q1, q2, lambda);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_rot1, 1, d_rot2, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_torque(load_vector<2>(r12), load_matrix<2>(q1),
                                                 load_matrix<2>(q2), lambda);
        return put(result.status, result.rotation1, d_rot1, result.rotation2, d_rot2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_hessian_2d(int status, double const r12[2],
                                                                  double const q1[3],
                                                                  double const q2[3], double lambda,
                                                                  double hessian[16]) noexcept
{
    return refuse_call(status, "pw85_contact_hessian_2d", Argument("r12", r12, 2, limit::not_zero),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval),
                       Argument("hessian", hessian));
}

int pw85_contact_hessian_2d(double const r12[2], double const q1[3], double const q2[3],
                            double lambda, double hessian[16])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_hessian_2d(status, r12, q1, q2, lambda, hessian);
    };
    if (any_null(r12, q1, q2, hessian)) return refused(null_pointer(hessian, 16));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_hessian(load_vector<2>(r12), load_matrix<2>(q1),
                                                  load_matrix<2>(q2), lambda);
        return put(result.status, result.entries, hessian);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_2d(int status, double const r12[2],
                                                          double const q1[3], double const q2[3],
                                                          int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite), Argument("overlap", overlap));
}

int pw85_overlap_2d(double const r12[2], double const q1[3], double const q2[3], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_2d(status, r12, q1, q2, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(r12, q1, q2)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap(load_vector<2>(r12), load_matrix<2>(q1),
                                          load_matrix<2>(q2));
        return put(result.status, result.overlap, overlap);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contains_2d(int status, double const r12[2],
                                                           double const q1[3], double const q2[3],
                                                           int *contains) noexcept
{
    return refuse_call(status, "pw85_contains_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite), Argument("contains", contains));
}

int pw85_contains_2d(double const r12[2], double const q1[3], double const q2[3], int *contains)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contains_2d(status, r12, q1, q2, contains);
    };
    if (any_null(contains)) return refused(PW85_EINVAL);
    *contains = -1;
    if (any_null(r12, q1, q2)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::contains(load_vector<2>(r12), load_matrix<2>(q1),
                                           load_matrix<2>(q2));
        return put(result.status, result.contains, contains);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_containment_2d(int status, double const r12[2],
                                                              double const q1[3],
                                                              double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_containment_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_containment_2d(double const r12[2], double const q1[3], double const q2[3], double *mu2,
                        double point[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_containment_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(mu2, 1, point, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::containment(load_vector<2>(r12), load_matrix<2>(q1),
                                              load_matrix<2>(q2));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_closest_approach_2d(int status,
                                                                   double const direction[2],
                                                                   double const q1[3],
                                                                   double const q2[3],
                                                                   double *distance) noexcept
{
    return refuse_call(status, "pw85_closest_approach_2d",
                       Argument("direction", direction, 2, limit::not_zero),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite), Argument("distance", distance));
}

int pw85_closest_approach_2d(double const direction[2], double const q1[3], double const q2[3],
                             double *distance)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_closest_approach_2d(status, direction, q1, q2, distance);
    };
    if (any_null(direction, q1, q2, distance)) return refused(null_pointer(distance, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::closest_approach(load_vector<2>(direction), load_matrix<2>(q1),
                                                   load_matrix<2>(q2));
        return put(result.status, result.distance, distance);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_2d(int status, double const r12[2],
                                                           double const q1[3],
                                                           double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_distance_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_distance_2d(double const r12[2], double const q1[3], double const q2[3], double *distance,
                     double point1[2], double point2[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(distance, 1, point1, 2, point2, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance(load_vector<2>(r12), load_matrix<2>(q1),
                                           load_matrix<2>(q2));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_geometry_2d(int status, double const r12[2],
                                                                    double const q1[3],
                                                                    double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_distance_geometry_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_distance_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                              double *distance, double point1[2], double point2[2],
                              double normal[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_geometry_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(distance, 1, point1, 2, point2, 2, normal, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance(load_vector<2>(r12), load_matrix<2>(q1),
                                           load_matrix<2>(q2));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_penetration_2d(int status, double const r12[2],
                                                              double const q1[3],
                                                              double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_penetration_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_penetration_2d(double const r12[2], double const q1[3], double const q2[3], double *depth,
                        double direction[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_penetration_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(depth, 1, direction, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::penetration(load_vector<2>(r12), load_matrix<2>(q1),
                                              load_matrix<2>(q2));
        return put(result.status, result.depth, depth, result.direction, direction);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_signed_distance_2d(int status, double const r12[2],
                                                                  double const q1[3],
                                                                  double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_signed_distance_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_signed_distance_2d(double const r12[2], double const q1[3], double const q2[3],
                            double *distance, double point1[2], double point2[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_signed_distance_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(distance, 1, point1, 2, point2, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::signed_distance(load_vector<2>(r12), load_matrix<2>(q1),
                                                  load_matrix<2>(q2));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_signed_distance_geometry_2d(
    int status, double const r12[2], double const q1[3], double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_signed_distance_geometry_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_signed_distance_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                                     double *distance, double point1[2], double point2[2],
                                     double normal[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_signed_distance_geometry_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(distance, 1, point1, 2, point2, 2, normal, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::signed_distance(load_vector<2>(r12), load_matrix<2>(q1),
                                                  load_matrix<2>(q2));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_gap_inside_2d(int status, double const r12[2],
                                                             double const q1[3],
                                                             double const q2[3]) noexcept
{
    return refuse_call(status, "pw85_gap_inside_2d", Argument("r12", r12, 2),
                       Argument("q1", q1, 3, limit::definite),
                       Argument("q2", q2, 3, limit::definite));
}

int pw85_gap_inside_2d(double const r12[2], double const q1[3], double const q2[3], double *gap,
                       double point1[2], double point2[2], double normal[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_gap_inside_2d(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(gap, 1, point1, 2, point2, 2, normal, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::gap_inside(load_vector<2>(r12), load_matrix<2>(q1),
                                             load_matrix<2>(q2));
        return put(result.status, result.gap, gap, result.point1, point1, result.point2, point2,
                   result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_perimeter_2d(int status, double const q[3],
                                                            double *perimeter) noexcept
{
    return refuse_call(status, "pw85_perimeter_2d", Argument("q", q, 3, limit::definite),
                       Argument("perimeter", perimeter));
}

int pw85_perimeter_2d(double const q[3], double *perimeter)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_perimeter_2d(status, q, perimeter);
    };
    if (any_null(q, perimeter)) return refused(null_pointer(perimeter, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::perimeter(load_matrix<2>(q));
        return put(result.status, result.perimeter, perimeter);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_second_moments_2d(int status, double const q[3],
                                                                 double moments[3]) noexcept
{
    return refuse_call(status, "pw85_second_moments_2d", Argument("q", q, 3, limit::definite),
                       Argument("moments", moments));
}

int pw85_second_moments_2d(double const q[3], double moments[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_second_moments_2d(status, q, moments);
    };
    if (any_null(q, moments)) return refused(null_pointer(moments, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::second_moments(load_matrix<2>(q));
        return put(result.status, result.moments, moments);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_from_moments_2d(int status,
                                                               double const second_moments[3],
                                                               double q[3]) noexcept
{
    return refuse_call(status, "pw85_from_moments_2d",
                       Argument("second_moments", second_moments, 3, limit::definite),
                       Argument("q", q));
}

int pw85_from_moments_2d(double const second_moments[3], double q[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_from_moments_2d(status, second_moments, q);
    };
    if (any_null(second_moments, q)) return refused(null_pointer(q, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::from_moments(load_matrix<2>(second_moments));
        return put(result.status, result.q, q);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_shell_moments_2d(int status, double const q[3],
                                                                double moments[3]) noexcept
{
    return refuse_call(status, "pw85_shell_moments_2d", Argument("q", q, 3, limit::definite),
                       Argument("moments", moments));
}

int pw85_shell_moments_2d(double const q[3], double moments[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_shell_moments_2d(status, q, moments);
    };
    if (any_null(q, moments)) return refused(null_pointer(moments, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::shell_moments(load_matrix<2>(q));
        return put(result.status, result.moments, moments);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_point_2d(int status, double const r[2],
                                                                 double const q[3]) noexcept
{
    return refuse_call(status, "pw85_distance_point_2d", Argument("r", r, 2),
                       Argument("q", q, 3, limit::definite));
}

int pw85_distance_point_2d(double const r[2], double const q[3], double *distance, double point[2],
                           double normal[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_point_2d(status, r, q);
    };
    if (any_null(r, q)) return refused(null_pointer(distance, 1, point, 2, normal, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_point(load_vector<2>(r), load_matrix<2>(q));
        return put(result.status, result.distance, distance, result.point, point, result.normal,
                   normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_segment_2d(int status, double const end1[2],
                                                                  double const end2[2],
                                                                  double const q[3]) noexcept
{
    return refuse_call(status, "pw85_contact_segment_2d", Argument("end1", end1, 2),
                       Argument("end2", end2, 2), Argument("q", q, 3, limit::definite));
}

int pw85_contact_segment_2d(double const end1[2], double const end2[2], double const q[3],
                            double *mu2, double point[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_segment_2d(status, end1, end2, q);
    };
    if (any_null(end1, end2, q)) return refused(null_pointer(mu2, 1, point, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_segment(load_vector<2>(end1), load_vector<2>(end2),
                                                  load_matrix<2>(q));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_box_2d(int status, double const lower[2],
                                                              double const upper[2],
                                                              double const q[3]) noexcept
{
    return refuse_call(status, "pw85_contact_box_2d",
                       Argument("lower", lower, 2, limit::below_next),
                       Argument("upper", upper, 2, limit::below_next),
                       Argument("q", q, 3, limit::definite));
}

int pw85_contact_box_2d(double const lower[2], double const upper[2], double const q[3],
                        double *mu2, double point[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_box_2d(status, lower, upper, q);
    };
    if (any_null(lower, upper, q)) return refused(null_pointer(mu2, 1, point, 2));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_box(load_vector<2>(lower), load_vector<2>(upper),
                                              load_matrix<2>(q));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_segment_2d(int status, double const end1[2],
                                                                  double const end2[2],
                                                                  double const q[3],
                                                                  int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_segment_2d", Argument("end1", end1, 2),
                       Argument("end2", end2, 2), Argument("q", q, 3, limit::definite),
                       Argument("overlap", overlap));
}

int pw85_overlap_segment_2d(double const end1[2], double const end2[2], double const q[3],
                            int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_segment_2d(status, end1, end2, q, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(end1, end2, q)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_segment(load_vector<2>(end1), load_vector<2>(end2),
                                                  load_matrix<2>(q));
        return put(result.status, result.overlap, overlap);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_box_2d(int status, double const lower[2],
                                                              double const upper[2],
                                                              double const q[3],
                                                              int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_box_2d",
                       Argument("lower", lower, 2, limit::below_next),
                       Argument("upper", upper, 2, limit::below_next),
                       Argument("q", q, 3, limit::definite), Argument("overlap", overlap));
}

int pw85_overlap_box_2d(double const lower[2], double const upper[2], double const q[3],
                        int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_box_2d(status, lower, upper, q, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(lower, upper, q)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_box(load_vector<2>(lower), load_vector<2>(upper),
                                              load_matrix<2>(q));
        return put(result.status, result.overlap, overlap);
    });
    return checked(status, refused);
}
