// SPDX-License-Identifier: BSD-3-Clause
// The C API: volumes and intersections.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/volume/overlap_volume.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>
#include <pw85/volume/volume.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_volume(int status, double const q[6],
                                                      double *volume) noexcept
{
    return refuse_call(status, "pw85_volume", Argument("q", q, 6, limit::definite),
                       Argument("volume", volume));
}

int pw85_volume(double const q[6], double *volume)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_volume(status, q, volume);
    };
    if (any_null(q, volume)) return refused(null_pointer(volume, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::volume(load_matrix<3>(q));
        return put(result.status, result.volume, volume);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_volume(int status, double const r12[3],
                                                              double const q1[6],
                                                              double const q2[6],
                                                              double *volume) noexcept
{
    return refuse_call(status, "pw85_overlap_volume", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("volume", volume));
}

int pw85_overlap_volume(double const r12[3], double const q1[6], double const q2[6], double *volume)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_volume(status, r12, q1, q2, volume);
    };
    if (any_null(r12, q1, q2, volume)) return refused(null_pointer(volume, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_volume(load_vector<3>(r12), load_matrix<3>(q1),
                                                 load_matrix<3>(q2));
        return put(result.status, result.volume, volume);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_volume_gradient(int status,
                                                                       double const r12[3],
                                                                       double const q1[6],
                                                                       double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_overlap_volume_gradient", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_overlap_volume_gradient(double const r12[3], double const q1[6], double const q2[6],
                                 double d_r12[3], double d_q1[6], double d_q2[6])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_volume_gradient(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_r12, 3, d_q1, 6, d_q2, 6));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_volume_gradient(load_vector<3>(r12), load_matrix<3>(q1),
                                                          load_matrix<3>(q2));
        return put(result.status, result.r12, d_r12, result.q1, d_q1, result.q2, d_q2);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_overlap_volume_torque(int status,
                                                                     double const r12[3],
                                                                     double const q1[6],
                                                                     double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_overlap_volume_torque", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_overlap_volume_torque(double const r12[3], double const q1[6], double const q2[6],
                               double d_rot1[3], double d_rot2[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_volume_torque(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(d_rot1, 3, d_rot2, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_volume_torque(load_vector<3>(r12), load_matrix<3>(q1),
                                                        load_matrix<3>(q2));
        return put(result.status, result.rotation1, d_rot1, result.rotation2, d_rot2);
    });
    return checked(status, refused);
}
