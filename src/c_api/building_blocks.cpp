// SPDX-License-Identifier: BSD-3-Clause
// The C API: the building blocks of the contact function.
#include <pw85.h>

#include <algorithm>

#include <pw85/contact/contact.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "../base/last_error.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

void pw85__cholesky_decomp(double const a[6], double l[6])
{
    if (any_null(a, l)) return store_nan(l, PW85_SYM);
    in_default_environment([&] { store(cholesky(load_matrix<3>(a)), l); });
    int const status = in_default_environment([&] {
        if (!elementary::isnan(l[PW85_SYM - 1])) return PW85_SUCCESS;
        return std::all_of(a, a + PW85_SYM, [](double x) { return elementary::isfinite(x); })
                   ? PW85_ENOTPD
                   : PW85_EINVAL;
    });
    checked(status, [&](int bad) {
        return refuse_call(bad, "pw85__cholesky_decomp",
                           Argument("a", a, PW85_SYM, limit::definite));
    });
}

void pw85__cholesky_solve(double const l[6], double const b[3], double x[3])
{
    if (any_null(l, b, x)) return store_nan(x, PW85_DIM);
    in_default_environment([&] { store(cholesky_solve(load_matrix<3>(l), load_vector<3>(b)), x); });
}

void pw85__residual(double lambda, double const r12[3], double const q1[6], double const q2[6],
                    double out[3])
{
    if (any_null(r12, q1, q2, out)) return store_nan(out, 3);
    in_default_environment([&] {
        auto const f = checked_derivatives(lambda, load_vector<3>(r12), load_matrix<3>(q1),
                                           load_matrix<3>(q2));
        out[0] = f.f;
        out[1] = -f.first;
        out[2] = -f.second;
    });
}

double pw85_f_neg(double lambda, double const *params)
{
    if (any_null(params)) return quiet_nan<double>();
    return in_default_environment([&] {
        return -checked_f(lambda, load_vector<3>(params), load_matrix<3>(params + 3),
                          load_matrix<3>(params + 9));
    });
}
