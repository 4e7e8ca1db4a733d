// SPDX-License-Identifier: BSD-3-Clause
// The C API: first contacts.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../simd/one_pair.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_first_contact(double const r12[3], double const q1[6], double const q2[6],
                       pw85_motion const *motion1, pw85_motion const *motion2, double t_max,
                       double *t)
{
    if (any_null(r12, q1, q2, motion1, motion2, t)) return null_pointer(t, 1);
    return in_default_environment(PW85_OF_PAIR(kernels::chosen(), first_contact), r12, q1, q2,
                                  motion1, motion2, t_max, t);
}
