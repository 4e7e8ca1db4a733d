// SPDX-License-Identifier: BSD-3-Clause
// The C API: first contacts.
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

[[gnu::cold, gnu::noinline]] static int refuse_first_contact(int status, double const r12[3],
                                                             double const q1[6], double const q2[6],
                                                             pw85_motion const *motion1,
                                                             pw85_motion const *motion2,
                                                             double t_max, double *t) noexcept
{
    return refuse_call(status, "pw85_first_contact", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("motion1", motion1, 7, limit::until_t_max),
                       Argument("motion2", motion2, 7, limit::until_t_max),
                       Argument("t_max", t_max, limit::from_zero | limit::may_be_infinite),
                       Argument("t", t));
}

int pw85_first_contact(double const r12[3], double const q1[6], double const q2[6],
                       pw85_motion const *motion1, pw85_motion const *motion2, double t_max,
                       double *t)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_first_contact(status, r12, q1, q2, motion1, motion2, t_max, t);
    };
    if (any_null(r12, q1, q2, motion1, motion2, t)) return refused(null_pointer(t, 1));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), first_contact), r12, q1,
                                          q2, motion1, motion2, t_max, t), refused);
}
