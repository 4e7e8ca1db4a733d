// SPDX-License-Identifier: BSD-3-Clause
// The C API: closest passages and free paths.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/motion/closest_passage.hpp>
#include <pw85/motion/free_path.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_closest_passage(int status, double const r12[3],
                                                               double const q1[6],
                                                               double const q2[6],
                                                               double const velocity[3],
                                                               double t_max) noexcept
{
    return refuse_call(status, "pw85_closest_passage", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("velocity", velocity, 3),
                       Argument("t_max", t_max, limit::from_zero | limit::may_be_infinite));
}

int pw85_closest_passage(double const r12[3], double const q1[6], double const q2[6],
                         double const velocity[3], double t_max, double *mu2, double *t)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_closest_passage(status, r12, q1, q2, velocity, t_max);
    };
    if (any_null(r12, q1, q2, velocity)) return refused(null_pointer(mu2, 1, t, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::closest_passage(load_vector<3>(r12), load_matrix<3>(q1),
                                                  load_matrix<3>(q2), load_vector<3>(velocity),
                                                  t_max);
        return put(result.status, result.mu2, mu2, result.time, t);
    });
    return checked(status, refused);
}

[[gnu::cold, gnu::noinline]] static int refuse_free_path(int status, double const r12[3],
                                                         double const q1[6], double const q2[6],
                                                         double const direction[3], double t_max,
                                                         double *t) noexcept
{
    return refuse_call(status, "pw85_free_path", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("direction", direction, 3, limit::not_zero),
                       Argument("t_max", t_max, limit::from_zero | limit::may_be_infinite),
                       Argument("t", t));
}

int pw85_free_path(double const r12[3], double const q1[6], double const q2[6],
                   double const direction[3], double t_max, double *t)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_free_path(status, r12, q1, q2, direction, t_max, t);
    };
    if (any_null(r12, q1, q2, direction, t)) return refused(null_pointer(t, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::free_path(load_vector<3>(r12), load_matrix<3>(q1),
                                            load_matrix<3>(q2), load_vector<3>(direction), t_max);
        return put(result.status, result.length, t);
    });
    return checked(status, refused);
}
