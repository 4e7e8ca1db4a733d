/* SPDX-License-Identifier: BSD-3-Clause */
/* The public C headers in C89. */
#include <pw85.h>
#include <pw85_enclosing.h>
#include <pw85_gpu.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#ifdef __STDC_VERSION__
#error "not compiled as C89"
#endif

int overlap_in_cpp98(void);

int main(void)
{
    double const r12[PW85_DIM] = {3.0, 0.0, 0.0}, q[PW85_SYM] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double out[2];
    if (PW85_EDEVICE != 5 || pw85_contact(r12, q, q, out) != PW85_SUCCESS || out[0] != 2.25)
        return 1;
    return overlap_in_cpp98();
}
