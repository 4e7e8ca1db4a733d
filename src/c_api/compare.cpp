// SPDX-License-Identifier: BSD-3-Clause
// The C API: comparisons.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/overlap/compare.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_compare(int status, double const r12[3],
                                                       double const q1[6], double const q2[6],
                                                       double mu2, int *sign) noexcept
{
    return refuse_call(status, "pw85_compare", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("mu2", mu2, limit::from_zero | limit::may_be_infinite),
                       Argument("sign", sign));
}

int pw85_compare(double const r12[3], double const q1[6], double const q2[6], double mu2, int *sign)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_compare(status, r12, q1, q2, mu2, sign);
    };
    if (any_null(sign)) return refused(PW85_EINVAL);
    *sign = 2;
    if (any_null(r12, q1, q2)) return refused(PW85_EINVAL);
    int const status = in_default_environment([&] {
        auto const result = pw85::compare(load_vector<3>(r12), load_matrix<3>(q1),
                                          load_matrix<3>(q2), mu2);
        return put(result.status, result.sign, sign);
    });
    return checked(status, refused);
}
