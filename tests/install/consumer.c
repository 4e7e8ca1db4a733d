/* SPDX-License-Identifier: BSD-3-Clause */
/* The pair of the tutorial, by installed libraries, from C99. */
#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>
#ifndef WITHOUT_SYSTEMS
#include <pw85_gpu.h>
#endif

#include <stdio.h>
#include <string.h>

#if !(PW85_VERSION_MAJOR >= 3 && PW85_VERSION_MINOR >= 0 && PW85_VERSION_PATCH >= 0)
#error "the header has no version"
#endif

int main(void)
{
    double const r12[PW85_DIM] = {0.7, -0.7, 1.1}, n1[PW85_DIM] = {0.0, 0.0, 1.0},
                 n2[PW85_DIM] = {1.0, 0.0, 0.0};
    double q1[PW85_SYM], q2[PW85_SYM], out[2], legacy[2], mu2;
    char version[40];
    snprintf(version, sizeof version, "%d.%d.%d", PW85_VERSION_MAJOR, PW85_VERSION_MINOR,
             PW85_VERSION_PATCH);
    if (strcmp(version, PW85_VERSION) != 0 || strcmp(version, pw85_version()) != 0) return 1;
    pw85_spheroid(10.0, 0.1, n1, q1);
    pw85_spheroid(0.5, 5.0, n2, q2);
    if (pw85_contact_function(r12, q1, q2, out) != PW85_SUCCESS) return 2;
    if (pw85_contact_batch(1, r12, q1, q2, &mu2, NULL) != PW85_SUCCESS) return 3;
    if (pw85_legacy_contact_function2(r12, q1, q2, legacy) != PW85_SUCCESS) return 4;
#ifndef WITHOUT_SYSTEMS
    int devices;
    if (pw85_gpu_count(&devices) != (devices > 0 ? PW85_SUCCESS : PW85_EDEVICE)) return 5;
#endif
    printf("mu^2 = %g\nlambda = %g\n", out[0], out[1]);
    return 0;
}
