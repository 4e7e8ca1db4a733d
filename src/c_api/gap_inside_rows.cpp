// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: gaps of contained ellipsoids.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_gap_inside_batch(size_t n, double const *r12, double const *q1, double const *q2,
                          double *gap, double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_gap_inside_batch", "r12", "q1", "q2", "gap",
                                            "point1", "point2", "normal"};
    return each_row(names, n, pw85_gap_inside, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    OptionalRowsOf<1>{gap}, OptionalRowsOf<3>{point1}, OptionalRowsOf<3>{point2},
                    OptionalRowsOf<3>{normal});
}
