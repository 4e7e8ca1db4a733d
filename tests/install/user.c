/* SPDX-License-Identifier: BSD-3-Clause */
/* A shared library that uses pw85, and exports one function. */
#include <pw85.h>
#include <pw85_batch.h>

int user_overlap(double const *r12, double const *q1, double const *q2);

int user_overlap(double const *r12, double const *q1, double const *q2)
{
    double mu2;
    int overlap;
    if (pw85_contact_batch(1, r12, q1, q2, &mu2, NULL) != PW85_SUCCESS) return -1;
    return pw85_overlap(r12, q1, q2, &overlap) == PW85_SUCCESS ? overlap : -1;
}
