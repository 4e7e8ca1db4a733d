/* SPDX-License-Identifier: BSD-3-Clause */
/* Prints the bits that the C API gives for 1,000 pairs: the table tests/testthat/pairs.txt. The
 * tests make the same pairs in R.
 *
 * cc -std=c99 r/data-raw/pairs.c -o pairs $(pkg-config --cflags --libs pw85) && ./pairs */
#include <inttypes.h>
#include <pw85_batch.h>
#include <stdio.h>
#include <string.h>

/* A multiple of 1/65536 in [0, 1), by the generator of Lehmer. */
static double uniform(void)
{
    static uint64_t state = 1;
    state = state * 16807 % 2147483647;
    return (double)(state % 65536) / 65536;
}

static int print(double const *numbers, int count)
{
    for (int k = 0; k < count; ++k) {
        uint64_t bits;
        memcpy(&bits, &numbers[k], sizeof bits);
        printf("%s%016" PRIx64, k == 0 ? "" : " ", bits);
    }
    return printf("\n");
}

static int make_ellipsoid(double q[6])
{
    double axes[3], quaternion[4];
    for (int k = 0; k < 3; ++k) axes[k] = 0.25 + 2 * uniform();
    for (int k = 0; k < 4; ++k) quaternion[k] = uniform() - 0.5 + (k == 0);
    return pw85_ellipsoid_quaternion(axes, quaternion, q);
}

int main(void)
{
    pw85_set_reproducible(1);
    for (int i = 0; i < 1000; ++i) {
        double r12[3], q1[6], q2[6], numbers[8];
        for (int k = 0; k < 3; ++k) r12[k] = 5 * uniform() - 2;
        int status = make_ellipsoid(q1);
        if (status == 0) status = make_ellipsoid(q2);
        /* mu2, lambda, distance and the common volume */
        if (status == 0) status = pw85_contact_batch(1, r12, q1, q2, numbers, numbers + 1);
        if (status == 0) status = pw85_distance_batch(1, r12, q1, q2, numbers + 2, NULL, NULL);
        if (status == 0) status = pw85_overlap_volume_batch(1, r12, q1, q2, numbers + 3);
        if (status != 0) return 1;
        print(numbers, 4);
    }
    return 0;
}
