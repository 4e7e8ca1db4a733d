// SPDX-License-Identifier: BSD-3-Clause
// The C API: witnesses.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/overlap/witness.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_overlap_witness(int status, double const r12[3],
                                                               double const q1[6],
                                                               double const q2[6],
                                                               int *overlap) noexcept
{
    return refuse_call(status, "pw85_overlap_witness", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite), Argument("overlap", overlap));
}

int pw85_overlap_witness(double const r12[3], double const q1[6], double const q2[6], int *overlap,
                         double *lambda, double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_overlap_witness(status, r12, q1, q2, overlap);
    };
    store_nan(lambda, 1);
    store_nan(point, 3);
    if (any_null(overlap)) return refused(PW85_EINVAL);
    *overlap = -1;
    if (any_null(r12, q1, q2)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::overlap_witness(load_vector<3>(r12), load_matrix<3>(q1),
                                                  load_matrix<3>(q2));
        return put(result.status, result.overlap, overlap, result.lambda, lambda, result.point,
                   point);
    });
    return checked(status, refused);
}
