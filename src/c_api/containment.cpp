// SPDX-License-Identifier: BSD-3-Clause
// The C API: factors of containment.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/overlap/containment_factor.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

[[gnu::cold, gnu::noinline]] static int refuse_containment(int status, double const r12[3],
                                                           double const q1[6],
                                                           double const q2[6]) noexcept
{
    return refuse_call(status, "pw85_containment", Argument("r12", r12, 3),
                       Argument("q1", q1, 6, limit::definite),
                       Argument("q2", q2, 6, limit::definite));
}

int pw85_containment(double const r12[3], double const q1[6], double const q2[6], double *mu2,
                     double point[3])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_containment(status, r12, q1, q2);
    };
    if (any_null(r12, q1, q2)) return refused(null_pointer(mu2, 1, point, 3));
    int const status = in_default_environment([&] {
        auto const result = pw85::containment(load_vector<3>(r12), load_matrix<3>(q1),
                                              load_matrix<3>(q2));
        return put(result.status, result.mu2, mu2, result.point, point);
    });
    return checked(status, refused);
}
