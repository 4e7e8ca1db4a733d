// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: derivatives of the contact function.
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/derivatives.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *mu2, double *lambda, double *point, double *normal,
                                   double *d_r12, double *d_rot1, double *d_rot2)
{
    static constexpr char const *names[] = {"pw85_contact_derivatives_batch", "r12", "q1", "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        DerivativeArrays{mu2, lambda, point, normal, d_r12, d_rot1, d_rot2}, r12,
                        q1, q2);
}
