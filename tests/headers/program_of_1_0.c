/* SPDX-License-Identifier: BSD-3-Clause */
/* A program for pw85 1.0: its headers were the only ones, and two numbers of room were enough
 * for pw85_legacy_f2(). */
#include <pw85.h>
#include <pw85_legacy.h>

int main(void)
{
    double const r12[PW85_DIM] = {3.0, 0.0, 0.0}, q[PW85_SYM] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double *out = malloc(2 * sizeof(double));
    if (!out) return 1;
    out[1] = -1.0;
    pw85_legacy_f2(0.5, r12, q, q, out);
    printf("%g digits\n", floor(-log10(fabs(out[0] / 2.25 - 1.0) + 1e-16)));
    int const wrong = fabs(out[0] - 2.25) > 1e-15 || out[1] != -1.0;
    free(out);
    return wrong;
}
