// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: whether one ellipsoid overlaps any of others.
#include <pw85_batch.h>

#include "../base/c_arrays.hpp"
#include "../rows/many_pairs.hpp"

using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

int pw85_overlap_any(double const q1[PW85_SYM], size_t n, double const *r12, double const *q2,
                     int *any)
{
    if (any_null(any)) return refuse_arrays("pw85_overlap_any", "n", n, NamedArray{"any", any});
    *any = 0;
    if (n == 0) return PW85_SUCCESS;
    *any = -1;
    if (n > max_rows || any_null(q1, r12, q2))
        return refuse_arrays("pw85_overlap_any", "n", n, NamedArray{"q1", q1},
                             NamedArray{"r12", r12}, NamedArray{"q2", q2});
    return in_default_environment([&] { return find_overlap(OneToMany{q1, r12, q2}, n, *any); });
}
