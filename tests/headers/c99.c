/* SPDX-License-Identifier: BSD-3-Clause */
/* The public C headers stand alone in C99, include each other in any order, and leave no macro
 * without the prefix. */
#include <pw85.h>
#include <pw85_enclosing.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#if !defined(__STDC_VERSION__) || __STDC_VERSION__ != 199901L
#error "not compiled as C99"
#endif

int main(void)
{
    double const r12[PW85_DIM] = {3.0, 0.0, 0.0}, q[PW85_SYM] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double out[2], f;
    int overlap;
    if (pw85_contact(r12, q, q, out) != PW85_SUCCESS || out[0] != 2.25) return 1;
    if (pw85_overlap(r12, q, q, &overlap) != PW85_SUCCESS || overlap != 0) return 2;
    f = pw85_legacy_f1(0.5, r12, q, q, NULL);
    return f == 2.25 ? 0 : 3;
}
