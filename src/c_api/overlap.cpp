// SPDX-License-Identifier: BSD-3-Clause
// The C API: overlaps.
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

[[gnu::cold, gnu::noinline]] static int refuse_overlap(int status, double const r12[3],
                                                       double const q1[6], double const q2[6],
                                                       int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("overlap", overlap));
}

int pw85_overlap(double const r12[3], double const q1[6], double const q2[6], int *overlap)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap(status, r12, q1, q2, overlap);
    };
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(r12, q1, q2)) return refused(PW85_EINVAL);
    return checked(in_default_environment(PW85_OF_PAIR(kernels::chosen(), overlap), r12, q1, q2,
                                          overlap), refused);
}
