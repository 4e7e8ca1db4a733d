// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: the contact function, correctly rounded.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_rounded_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               double *mu2, double *lambda)
{
    static constexpr char const *names[] = {"pw85_contact_rounded_batch", "r12", "q1", "q2", "mu2"};
    return each_row(names, n, pw85_contact_rounded, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    TwoNumbers{mu2, lambda});
}
