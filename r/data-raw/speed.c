/* SPDX-License-Identifier: BSD-3-Clause */
/* Nanoseconds per row of functions of the C API, for the pairs that speed.R writes, and of the copy
 * of 15 columns that the packages for R and Octave make. Usage: speed N <FILE, with N at most
 * 16384; compile it with -D_POSIX_C_SOURCE=199309L */
#include <pw85_batch.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "../src/columns.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define BEST(name, call)                                                                           \
    do {                                                                                           \
        double best = 1e9;                                                                         \
        for (int k = 0; k < 200; ++k) {                                                            \
            double const start = now();                                                            \
            if (call != 0) return 1;                                                               \
            double const taken = now() - start;                                                    \
            best = taken < best ? taken : best;                                                    \
        }                                                                                          \
        printf("%s %.2f\n", name, 1e9 * best / (double)n);                                         \
    } while (0)

/* Copies 15 columns of n numbers to rows, as if for pairs, in blocks. */
static int copy(double const *numbers, size_t n)
{
    enum { BLOCK = 128, COLUMNS = 15 };
    static double rows[COLUMNS * BLOCK];
    for (size_t from = 0; from < n; from += BLOCK) {
        size_t const count = n - from < BLOCK ? n - from : BLOCK;
        double const *columns[COLUMNS];
        for (size_t k = 0; k < COLUMNS; ++k) columns[k] = numbers + k * n + from;
        pw85_rows_of_columns(columns, 3, count, rows);
        pw85_rows_of_columns(columns + 3, 6, count, rows + 3 * BLOCK);
        pw85_rows_of_columns(columns + 9, 6, count, rows + 9 * BLOCK);
    }
    return rows[0] > 1e300;
}

int main(int argc, char **argv)
{
    static double numbers[48 * 16384];
    size_t const n = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    double *const r12 = numbers, *const q1 = r12 + 3 * n, *const q2 = q1 + 6 * n;
    double *const r2 = numbers + 15 * n, *const f1 = r2 + 2 * n, *const f2 = f1 + 3 * n;
    double *const out = numbers + 40 * n;
    unsigned char *const bytes = (unsigned char *)(numbers + 30 * n);
    if (n < 1 || n > 16384 || fread(numbers, sizeof(double), 23 * n, stdin) != 23 * n) return 1;
    BEST("copy", copy(numbers, n));
    BEST("overlaps", pw85_overlap_batch(n, r12, q1, q2, bytes));
    BEST("contains", pw85_contains_batch(n, r12, q1, q2, bytes));
    BEST("contact", pw85_contact_batch(n, r12, q1, q2, out, out + n));
    BEST("distance", pw85_distance_batch(n, r12, q1, q2, out, out + n, out + 4 * n));
    BEST("overlap_volume", pw85_overlap_volume_batch(n, r12, q1, q2, out));
    BEST("overlap_area", pw85_overlap_area_batch_2d(n, r2, f1, f2, out));
    return 0;
}
