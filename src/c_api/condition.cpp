// SPDX-License-Identifier: BSD-3-Clause
// The C API: condition numbers.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/contact/condition.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_condition(int status, double const r12[3],
                                                         double const q1[6], double const q2[6],
                                                         double lambda, double *cond) noexcept
{
    return refuse_call(status, "pw85_condition", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite),
                       Argument("lambda", lambda, limit::unit_interval), Argument("cond", cond));
}

int pw85_condition(double const r12[3], double const q1[6], double const q2[6], double lambda,
                   double *cond)
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_condition(status, r12, q1, q2, lambda, cond);
    };
    if (any_null(r12, q1, q2, cond)) return refused(null_pointer(cond, 1));
    int const status = in_default_environment([&] {
        auto const result = pw85::condition(load_vector<3>(r12), load_matrix<3>(q1),
                                            load_matrix<3>(q2), lambda);
        return put(result.status, result.condition, cond);
    });
    return checked(status, refused);
}
