// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: distance.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_distance_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                    double *d_r12, double *d_rot1, double *d_rot2, double *hessian)
{
    static constexpr char const *names[] = {"pw85_distance_derivatives_batch", "r12", "q1", "q2",
                                            "d_r12", "d_rot1", "d_rot2", "hessian"};
    return each_row(names, n, pw85_distance_derivatives, RowsOf<3>{r12}, RowsOf<6>{q1},
                    RowsOf<6>{q2}, OptionalRowsOf<3>{d_r12}, OptionalRowsOf<3>{d_rot1},
                    OptionalRowsOf<3>{d_rot2}, OptionalRowsOf<81>{hessian});
}

int pw85_signed_distance_derivatives_batch(size_t n, double const *r12, double const *q1,
                                           double const *q2, double *d_r12, double *d_rot1,
                                           double *d_rot2, double *hessian)
{
    static constexpr char const *names[] = {"pw85_signed_distance_derivatives_batch", "r12", "q1",
                                            "q2", "d_r12", "d_rot1", "d_rot2", "hessian"};
    return each_row(names, n, pw85_signed_distance_derivatives, RowsOf<3>{r12}, RowsOf<6>{q1},
                    RowsOf<6>{q2}, OptionalRowsOf<3>{d_r12}, OptionalRowsOf<3>{d_rot1},
                    OptionalRowsOf<3>{d_rot2}, OptionalRowsOf<81>{hessian});
}
