// SPDX-License-Identifier: BSD-3-Clause
// The C API: distances to shapes.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/distance/capsule.hpp>
#include <pw85/distance/solids.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_distance_segment(int status, double const end1[3],
                                                                double const end2[3],
                                                                double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_segment", Argument("end1", end1, 3),
                       Argument("end2", end2, 3), Argument("q", q, 6, limit::definite));
}

int pw85_distance_segment(double const end1[3], double const end2[3], double const q[6],
                          double *distance, double point1[3], double point2[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_segment(status, end1, end2, q);
    };
    if (any_null(end1, end2, q))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_segment(load_vector<3>(end1), load_vector<3>(end2),
                                                   load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_triangle(int status,
                                                                 double const vertex1[3],
                                                                 double const vertex2[3],
                                                                 double const vertex3[3],
                                                                 double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_triangle", Argument("vertex1", vertex1, 3),
                       Argument("vertex2", vertex2, 3), Argument("vertex3", vertex3, 3),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_triangle(double const vertex1[3], double const vertex2[3],
                           double const vertex3[3], double const q[6], double *distance,
                           double point1[3], double point2[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_triangle(status, vertex1, vertex2, vertex3, q);
    };
    if (any_null(vertex1, vertex2, vertex3, q))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_triangle(load_vector<3>(vertex1),
                                                    load_vector<3>(vertex2),
                                                    load_vector<3>(vertex3), load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_solid_box(int status, double const lower[3],
                                                                  double const upper[3],
                                                                  double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_solid_box",
                       Argument("lower", lower, 3, limit::below_next),
                       Argument("upper", upper, 3, limit::below_next),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_solid_box(double const lower[3], double const upper[3], double const q[6],
                            double *distance, double point1[3], double point2[3], double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_solid_box(status, lower, upper, q);
    };
    if (any_null(lower, upper, q))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_solid_box(load_vector<3>(lower), load_vector<3>(upper),
                                                     load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_contact_capsule(int status, double const end1[3],
                                                               double const end2[3], double radius,
                                                               double const q[6]) noexcept
{
    return refuse_call(status, "pw85_contact_capsule", Argument("end1", end1, 3),
                       Argument("end2", end2, 3), Argument("radius", radius, limit::from_zero),
                       Argument("q", q, 6, limit::definite));
}

int pw85_contact_capsule(double const end1[3], double const end2[3], double radius,
                         double const q[6], double *mu2, double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_capsule(status, end1, end2, radius, q);
    };
    if (any_null(end1, end2, q)) return refused(null_pointer(mu2, 1, point, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::contact_capsule(load_vector<3>(end1), load_vector<3>(end2),
                                                  radius, load_matrix<3>(q));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_capsule(int status, double const end1[3],
                                                               double const end2[3], double radius,
                                                               double const q[6],
                                                               int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_capsule", Argument("end1", end1, 3),
                       Argument("end2", end2, 3), Argument("radius", radius, limit::from_zero),
                       Argument("q", q, 6, limit::definite), Argument("overlap", overlap));
}

int pw85_overlap_capsule(double const end1[3], double const end2[3], double radius,
                         double const q[6], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_capsule(status, end1, end2, radius, q, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(end1, end2, q)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_capsule(load_vector<3>(end1), load_vector<3>(end2),
                                                  radius, load_matrix<3>(q));
        return put(result.status, result.overlap, overlap);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_distance_capsule(int status, double const end1[3],
                                                                double const end2[3], double radius,
                                                                double const q[6]) noexcept
{
    return refuse_call(status, "pw85_distance_capsule", Argument("end1", end1, 3),
                       Argument("end2", end2, 3), Argument("radius", radius, limit::from_zero),
                       Argument("q", q, 6, limit::definite));
}

int pw85_distance_capsule(double const end1[3], double const end2[3], double radius,
                          double const q[6], double *distance, double point1[3], double point2[3],
                          double normal[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_distance_capsule(status, end1, end2, radius, q);
    };
    if (any_null(end1, end2, q))
        return refused(null_pointer(distance, 1, point1, 3, point2, 3, normal, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::distance_capsule(load_vector<3>(end1), load_vector<3>(end2),
                                                   radius, load_matrix<3>(q));
        return put(result.status, result.distance, distance, result.point1, point1, result.point2,
                   point2, result.normal, normal);
    });
    return checked(status, refused);
}
