// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: closest passages.
#include <pw85.h>
#include <pw85_batch.h>

#include "../base/c_arrays.hpp"
#include "many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

int pw85_closest_passage_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               double const *velocity, double t_max, double *mu2, double *t)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, velocity, mu2))
        return refuse_arrays("pw85_closest_passage_batch", "n", n, NamedArray{"r12", r12},
                             NamedArray{"q1", q1}, NamedArray{"q2", q2},
                             NamedArray{"velocity", velocity}, NamedArray{"mu2", mu2});
    return compute_all(n, PairArrays<3>{r12, q1, q2}, PassageArrays{mu2, t, velocity, t_max});
}
