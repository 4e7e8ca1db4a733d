// SPDX-License-Identifier: BSD-3-Clause
// The C API: the contact function, correctly rounded.
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

[[gnu::cold, gnu::noinline]] static int refuse_contact_rounded(int status, double const r12[3],
                                                               double const q1[6],
                                                               double const q2[6],
                                                               double out[2]) noexcept
{
    return refuse_call(status, "pw85_contact_rounded", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("out", out));
}

int pw85_contact_rounded(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_contact_rounded(status, r12, q1, q2, out);
    };
    if (any_null(r12, q1, q2, out)) return refused(null_pointer(out, 2));
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), contact_rounded), r12, q1,
                                          q2, out), refused);
}
