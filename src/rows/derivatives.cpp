// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: derivatives of the contact function.
#include <pw85.h>
#include <pw85_batch.h>

#include "../base/c_arrays.hpp"
#include "many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

int pw85_contact_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *mu2, double *lambda, double *point, double *normal,
                                   double *d_r12, double *d_rot1, double *d_rot2)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2))
        return refuse_arrays("pw85_contact_derivatives_batch", "n", n, NamedArray{"r12", r12},
                             NamedArray{"q1", q1}, NamedArray{"q2", q2});
    return compute_all(n, PairArrays<3>{r12, q1, q2},
                       DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2});
}
