// SPDX-License-Identifier: BSD-3-Clause
// The C API of depths and signed distances, which ask first whether a pair overlaps.
#include <pw85.h>

#include <pw85/distance/signed_distance.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"
#include "../simd/one_pair.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

/// Returns whether a valid pair overlaps. The answer is from the same code as pw85_overlap(), so
/// that both agree on forms that are barely positive definite.
static int overlaps(double const *r12, double const *q1, double const *q2,
                    int &overlapping) noexcept
{
    overlapping = 0;
    return PW85_OF_PAIR(kernels::chosen(), overlap)(r12, q1, q2, &overlapping);
}

int pw85_penetration(double const r12[3], double const q1[6], double const q2[6], double *depth,
                     double direction[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_penetration", Argument("r12", r12, 3),
                           Argument("q1", q1, 6, limit::definite),
                           Argument("q2", q2, 6, limit::definite));
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(depth, 1, direction, PW85_DIM));
    return checked(in_default_environment([&] {
                       int overlapping;
                       auto const status = static_cast<Status>(overlaps(r12, q1, q2, overlapping));
                       auto const p =
                           overlapping == 1
                               ? penetration_overlapping(load_vector<3>(r12), load_matrix<3>(q1),
                                                         load_matrix<3>(q2))
                               : no_penetration<double, 3>(status);
                       return put(p.status, p.depth, depth, p.direction, direction);
                   }),
                   refused);
}

int pw85_signed_distance(double const r12[3], double const q1[6], double const q2[6],
                         double *distance, double point1[3], double point2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_signed_distance", Argument("r12", r12, 3),
                           Argument("q1", q1, 6, limit::definite),
                           Argument("q2", q2, 6, limit::definite));
    };
    if (any_null(r12, q1, q2))
        return refused(null_pointer(distance, 1, point1, PW85_DIM, point2, PW85_DIM));
    return checked(in_default_environment([&] {
                       int overlapping;
                       overlaps(r12, q1, q2, overlapping);
                       if (overlapping != 1)
                           return PW85_OF_PAIR(kernels::chosen(), distance)(r12, q1, q2, distance,
                                                                            point1, point2);
                       auto const result = signed_distance_overlapping(
                           load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
                       return put(result.status, result.distance, distance, result.point1, point1,
                                  result.point2, point2);
                   }),
                   refused);
}

int pw85_signed_distance_derivatives(double const r12[3], double const q1[6], double const q2[6],
                                     double d_r12[3], double d_rot1[3], double d_rot2[3],
                                     double hessian[81])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_signed_distance_derivatives", Argument("r12", r12, 3),
                           Argument("q1", q1, 6, limit::definite),
                           Argument("q2", q2, 6, limit::definite));
    };
    if (any_null(r12, q1, q2))
        return refused(
            null_pointer(d_r12, PW85_DIM, d_rot1, PW85_DIM, d_rot2, PW85_DIM, hessian, 81));
    return checked(in_default_environment([&] {
                       int overlapping;
                       overlaps(r12, q1, q2, overlapping);
                       if (overlapping != 1)
                           return PW85_OF_PAIR(kernels::chosen(), distance_derivatives)(
                               r12, q1, q2, d_r12, d_rot1, d_rot2, hessian);
                       auto const result = signed_derivatives_overlapping(
                           load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
                       return put(result.status, result.r12, d_r12, result.rotation1, d_rot1,
                                  result.rotation2, d_rot2, result.hessian, hessian);
                   }),
                   refused);
}
