// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: quadratic forms.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes, double const *quaternions,
                                    double *q)
{
    static constexpr char const *names[] = {"pw85_ellipsoid_quaternion_batch", "semi_axes",
                                            "quaternions", "q"};
    return each_row(names, n, pw85_ellipsoid_quaternion, RowsOf<3>{semi_axes},
                    RowsOf<4>{quaternions}, RowsOf<6, double>{q});
}

int pw85_ellipsoid_factor_batch(size_t n, double const *semi_axes, double const *quaternions,
                                double *s)
{
    static constexpr char const *names[] = {"pw85_ellipsoid_factor_batch", "semi_axes",
                                            "quaternions", "s"};
    return each_row(names, n, pw85_ellipsoid_factor, RowsOf<3>{semi_axes}, RowsOf<4>{quaternions},
                    RowsOf<9, double>{s});
}
