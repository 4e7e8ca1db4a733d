// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: witnesses.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_overlap_witness_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               unsigned char *overlap, double *lambda, double *point)
{
    static constexpr char const *names[] = {"pw85_overlap_witness_batch", "r12", "q1", "q2",
                                            "overlap", "lambda", "point"};
    return each_row(names, n, pw85_overlap_witness, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Bytes{overlap}, OptionalRowsOf<1>{lambda}, OptionalRowsOf<3>{point});
}
