// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: the contact function.
#include <pw85.h>
#include <pw85_batch.h>

#include "../base/c_arrays.hpp"
#include "many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                       double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2))
        return refuse_arrays("pw85_contact_batch", "n", n, NamedArray{"r12", r12},
                             NamedArray{"q1", q1}, NamedArray{"q2", q2}, NamedArray{"mu2", mu2});
    return compute_all(n, PairArrays<3>{r12, q1, q2}, ContactArrays{mu2, lambda});
}

int pw85_closest_approach_batch(size_t n, double const *directions, double const *q1,
                                double const *q2, double *distance)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(directions, q1, q2, distance))
        return refuse_arrays("pw85_closest_approach_batch", "n", n,
                             NamedArray{"directions", directions}, NamedArray{"q1", q1},
                             NamedArray{"q2", q2}, NamedArray{"distance", distance});
    return compute_all(n, Directions{{directions, q1, q2}}, ApproachArray{distance});
}
