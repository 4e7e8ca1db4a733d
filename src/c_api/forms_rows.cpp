// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: quadratic forms.
//
// Made from pw85.h, pw85_grains.h, pw85_shapes.h and api/pw85_batch.h.in by api/committed.py.
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_ellipsoid_factor_batch(size_t n, double const *semi_axes, double const *quaternions,
                                double *s)
{
    return each_row("pw85_ellipsoid_factor_batch", n, pw85_ellipsoid_factor,
                    RowsOf<3>{"semi_axes", semi_axes}, RowsOf<4>{"quaternions", quaternions},
                    RowsOf<9, double>{"s", s});
}

int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes, double const *quaternions,
                                    double *q)
{
    return each_row("pw85_ellipsoid_quaternion_batch", n, pw85_ellipsoid_quaternion,
                    RowsOf<3>{"semi_axes", semi_axes}, RowsOf<4>{"quaternions", quaternions},
                    RowsOf<6, double>{"q", q});
}
