// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: ellipsoids by their factors.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                double *mu2, double *lambda)
{
    static constexpr char const *names[] = {"pw85_contact_factored_batch", "r12", "s1", "s2",
                                            "mu2"};
    return each_row(names, n, pw85_contact_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2},
                    TwoNumbers{mu2, lambda});
}

int pw85_contact_geometry_factored_batch(size_t n, double const *r12, double const *s1,
                                         double const *s2, double const *lambda, double *point,
                                         double *normal)
{
    static constexpr char const *names[] = {"pw85_contact_geometry_factored_batch", "r12", "s1",
                                            "s2", "lambda", "point", "normal"};
    return each_row(names, n, pw85_contact_geometry_factored, RowsOf<3>{r12}, RowsOf<9>{s1},
                    RowsOf<9>{s2}, Numbers{lambda}, OptionalRowsOf<3>{point},
                    OptionalRowsOf<3>{normal});
}

int pw85_contact_gradient_factored_batch(size_t n, double const *r12, double const *s1,
                                         double const *s2, double const *lambda, double *d_r12,
                                         double *d_s1, double *d_s2)
{
    static constexpr char const *names[] = {"pw85_contact_gradient_factored_batch", "r12", "s1",
                                            "s2", "lambda", "d_r12", "d_s1", "d_s2"};
    return each_row(names, n, pw85_contact_gradient_factored, RowsOf<3>{r12}, RowsOf<9>{s1},
                    RowsOf<9>{s2}, Numbers{lambda}, OptionalRowsOf<3>{d_r12},
                    OptionalRowsOf<9>{d_s1}, OptionalRowsOf<9>{d_s2});
}

int pw85_overlap_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_factored_batch", "r12", "s1", "s2",
                                            "overlap"};
    return each_row(names, n, pw85_overlap_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2},
                    Bytes{overlap});
}
