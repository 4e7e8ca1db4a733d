/* SPDX-License-Identifier: BSD-3-Clause */
/* Prints the bits that the C API gives for 100 pairs of ellipses: the table ellipses.txt. The tests
 * make the same pairs in JavaScript.
 *
 * cc -std=c99 js/tests/ellipses.c -o ellipses $(pkg-config --cflags --libs pw85) && ./ellipses */
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

static void print(double number, char end)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    printf("%016" PRIx64 "%c", bits, end);
}

int main(void)
{
    pw85_set_reproducible(1);
    for (int i = 0; i < 100; ++i) {
        double r12[2], q[2][3], mu2, lambda, distance, area;
        for (int k = 0; k < 2; ++k) r12[k] = 5 * uniform() - 2;
        for (int k = 0; k < 2; ++k) {
            double const a = 0.25 + 2 * uniform(), b = 0.25 + 2 * uniform();
            if (pw85_ellipse(a, b, 4 * uniform(), q[k]) != 0) return 1;
        }
        int status = pw85_contact_batch_2d(1, r12, q[0], q[1], &mu2, &lambda);
        if (status == 0) status = pw85_distance_batch_2d(1, r12, q[0], q[1], &distance, NULL, NULL);
        if (status == 0) status = pw85_overlap_area_batch_2d(1, r12, q[0], q[1], &area);
        if (status != 0) return 1;
        print(mu2, ' ');
        print(lambda, ' ');
        print(distance, ' ');
        print(area, '\n');
    }
    return 0;
}
