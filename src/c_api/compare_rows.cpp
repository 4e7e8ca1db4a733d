// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: comparisons.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_compare_batch(size_t n, double const *r12, double const *q1, double const *q2,
                       double const *mu2, int *sign)
{
    static constexpr char const *names[] = {"pw85_compare_batch", "r12", "q1", "q2", "mu2", "sign"};
    return each_row(names, n, pw85_compare, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Numbers{mu2}, RowsOf<1, int>{sign});
}
