// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: first contacts.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_first_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                             pw85_motion const *motion1, pw85_motion const *motion2, double t_max,
                             double *t)
{
    static constexpr char const *names[] = {"pw85_first_contact_batch", "r12", "q1", "q2",
                                            "motion1", "motion2", "t_max", "t"};
    return each_row(names, n, pw85_first_contact, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    RowsOf<1, pw85_motion const>{motion1}, RowsOf<1, pw85_motion const>{motion2},
                    SameNumber{t_max}, RowsOf<1, double>{t});
}
