// SPDX-License-Identifier: BSD-3-Clause
// The C API: condition numbers.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/contact/condition.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_condition(double const r12[3], double const q1[6], double const q2[6], double lambda,
                   double *cond)
{
    if (any_null(r12, q1, q2, cond)) return null_pointer(cond, 1);
    return in_default_environment([&] {
        auto const result = pw85::condition(load_vector<3>(r12), load_matrix<3>(q1),
                                            load_matrix<3>(q2), lambda);
        return put(result.status, result.condition, cond);
    });
}
