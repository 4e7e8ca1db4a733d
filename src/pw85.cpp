// SPDX-License-Identifier: BSD-3-Clause
// The C API: version, errors, the reproducible mode, and the functions of one pair that are not those of their templates, argument by
// argument (api/shims.py makes the others).
#include <pw85.h>

#include <pw85/pw85.hpp>

#include "brent.hpp"
#include "c_arrays.hpp"
#include "floating_point_environment.hpp"
#include "kernels/kernels.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

char const *pw85_version(void) { return PW85_VERSION; }

char const *pw85_strerror(int status) { return pw85::strerror(static_cast<Status>(status)); }

int pw85_set_reproducible(int on)
{
    if (on != 0 && on != 1) return PW85_EINVAL;
    kernels::set_reproducible(on == 1);
    return PW85_SUCCESS;
}

int pw85_is_reproducible(int *on)
{
    if (any_null(on)) return PW85_EINVAL;
    *on = kernels::is_reproducible() ? 1 : 0;
    return PW85_SUCCESS;
}

void pw85_spheroid(double a, double c, double const n[3], double q[6])
{
    if (any_null(n, q)) return store_nan(q, PW85_SYM);
    in_default_environment([&] { store(spheroid(a, c, load_vector<3>(n)).q, q); });
}

int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6])
{
    if (any_null(semi_axes, rotation, q)) return null_pointer(q, PW85_SYM);
    double r[9];
    for (int i = 0; i < 9; ++i) r[i] = rotation[i];
    return in_default_environment([&] { return put(ellipsoid(load_vector<3>(semi_axes), r), q); });
}

int pw85_contact_function(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    constexpr brent::Options options{PW85_LAMBDA_ATOL, PW85_MAX_ITER, PW85_NR_ITER};
    // Brent's method is that of another library, whose arithmetic depends on how that was compiled.
    if (kernels::is_reproducible()) return pw85_contact(r12, q1, q2, out);
    return in_default_environment([&] {
        return put(brent::contact_function(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), options), out,
                   out + 1);
    });
}

void pw85__cholesky_decomp(double const a[6], double l[6])
{
    if (any_null(a, l)) return store_nan(l, PW85_SYM);
    in_default_environment([&] { store(cholesky(load_matrix<3>(a)), l); });
}

void pw85__cholesky_solve(double const l[6], double const b[3], double x[3])
{
    if (any_null(l, b, x)) return store_nan(x, PW85_DIM);
    in_default_environment([&] { store(cholesky_solve(load_matrix<3>(l), load_vector<3>(b)), x); });
}

void pw85__residual(double lambda, double const r12[3], double const q1[6], double const q2[6], double out[3])
{
    if (any_null(r12, q1, q2, out)) return store_nan(out, 3);
    in_default_environment([&] {
        auto const f = checked_derivatives(lambda, load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
        out[0] = f.f;
        out[1] = -f.first;
        out[2] = -f.second;
    });
}

double pw85_f_neg(double lambda, double const *params)
{
    if (any_null(params)) return quiet_nan<double>();
    return in_default_environment([&] {
        return -checked_f(lambda, load_vector<3>(params), load_matrix<3>(params + 3), load_matrix<3>(params + 9));
    });
}
