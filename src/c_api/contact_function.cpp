// SPDX-License-Identifier: BSD-3-Clause
// The C API: the contact function by Brent's method.
#include <pw85.h>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"
#include "../brent/brent.hpp"
#include "../simd/targets.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_contact_function(double const r12[3], double const q1[6], double const q2[6],
                          double out[2])
{
    auto const refused = [&](int status) PW85_IN_COLD_PATH {
        return refuse_call(status, "pw85_contact_function", Argument("r12", r12, 3),
                           Argument("q1", q1, 6, limit::definite),
                           Argument("q2", q2, 6, limit::definite), Argument("out", out));
    };
    if (any_null(r12, q1, q2, out)) return refused(null_pointer(out, 2));
    constexpr brent::Options options{PW85_LAMBDA_ATOL, PW85_MAX_ITER, PW85_NR_ITER};
    // Brent's method is that of another library, whose arithmetic depends on how that was compiled.
    if (kernels::is_reproducible()) return checked(pw85_contact(r12, q1, q2, out), refused);
    return checked(in_default_environment([&] {
                       auto const result = brent::contact_function(
                           load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), options);
                       return put(result.status, result.mu2, out, result.lambda, out + 1);
                   }),
                   refused);
}
