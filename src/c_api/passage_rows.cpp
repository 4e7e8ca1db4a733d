// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: closest passages and free paths.
//
// Made from pw85.h, pw85_grains.h, pw85_shapes.h and api/pw85_batch.h.in by api/committed.py.
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_free_path_batch(size_t n, double const *r12, double const *q1, double const *q2,
                         double const *directions, double const *t_max, double *t)
{
    return each_row("pw85_free_path_batch", n, pw85_free_path, RowsOf<3>{"r12", r12},
                    RowsOf<6>{"q1", q1}, RowsOf<6>{"q2", q2}, RowsOf<3>{"directions", directions},
                    Numbers{"t_max", t_max}, RowsOf<1, double>{"t", t});
}
