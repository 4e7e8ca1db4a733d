// SPDX-License-Identifier: BSD-3-Clause
// The C API of the algorithms of Zheng and Palffy-Muhoray (pw85_zheng.h). It calls
// history/zheng.hpp.
#define PW85_ALL_HERE
#include <pw85_zheng.h>

#include <pw85/history/zheng.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

int store_distance(ClosestApproach<double> const &result, double *distance) noexcept
{
    *distance = result.distance;
    return static_cast<int>(result.status);
}

} // namespace

int pw85_zheng_ellipses(double const direction[2], double const q1[3], double const q2[3],
                        double *distance)
{
    if (any_null(direction, q1, q2, distance)) return null_pointer(distance, 1);
    return in_default_environment([&] {
        return store_distance(pw85::zheng::ellipses(load_vector<2>(direction), load_matrix<2>(q1),
                                                    load_matrix<2>(q2)),
                              distance);
    });
}

int pw85_zheng_ellipsoids(double const direction[3], double const q1[6], double const q2[6],
                          double *distance)
{
    if (any_null(direction, q1, q2, distance)) return null_pointer(distance, 1);
    return in_default_environment([&] {
        return store_distance(pw85::zheng::ellipsoids(load_vector<3>(direction), load_matrix<3>(q1),
                                                      load_matrix<3>(q2)),
                              distance);
    });
}
