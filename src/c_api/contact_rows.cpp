// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: contact of two ellipsoids.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_geometry_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                double const *lambda, double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_contact_geometry_batch", "r12", "q1", "q2",
                                            "lambda", "point", "normal"};
    return each_row(names, n, pw85_contact_geometry, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Numbers{lambda}, OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_contact_gradient_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                double const *lambda, double *d_r12, double *d_q1, double *d_q2)
{
    static constexpr char const *names[] = {"pw85_contact_gradient_batch", "r12", "q1", "q2",
                                            "lambda", "d_r12", "d_q1", "d_q2"};
    return each_row(names, n, pw85_contact_gradient, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Numbers{lambda}, OptionalRowsOf<3>{d_r12}, OptionalRowsOf<6>{d_q1},
                    OptionalRowsOf<6>{d_q2});
}

int pw85_contact_torque_batch(size_t n, double const *r12, double const *q1, double const *q2,
                              double const *lambda, double *d_rot1, double *d_rot2)
{
    static constexpr char const *names[] = {"pw85_contact_torque_batch", "r12", "q1", "q2",
                                            "lambda", "d_rot1", "d_rot2"};
    return each_row(names, n, pw85_contact_torque, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Numbers{lambda}, OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2});
}

int pw85_contact_hessian_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               double const *lambda, double *hessian)
{
    static constexpr char const *names[] = {"pw85_contact_hessian_batch", "r12", "q1", "q2",
                                            "lambda", "hessian"};
    return each_row(names, n, pw85_contact_hessian, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    Numbers{lambda}, RowsOf<81, double>{hessian});
}
