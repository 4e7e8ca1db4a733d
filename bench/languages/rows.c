/* SPDX-License-Identifier: BSD-3-Clause */
/* The program of bench/languages.py in C: see there. */
#include <pw85_batch.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { PAIRS = 1000, MOST_COPIES = 16, ROWS = PAIRS * MOST_COPIES };

static double r12[ROWS][3], q1[ROWS][6], q2[ROWS][6];
static double numbers[2][ROWS], points[2][ROWS][3];
static unsigned char bytes[ROWS];

static int overlap_call(int i, int j)
{
    int overlap = 0;
    int const status = pw85_overlap(r12[i], q1[j], q2[i], &overlap);
    numbers[0][i] = overlap;
    return status;
}

static int overlap_rows(size_t n) { return pw85_overlap_batch(n, r12[0], q1[0], q2[0], bytes); }

static int contact_call(int i, int j)
{
    double out[2];
    int const status = pw85_contact(r12[i], q1[j], q2[i], out);
    numbers[0][i] = out[0];
    numbers[1][i] = out[1];
    return status;
}

static int contact_rows(size_t n)
{
    return pw85_contact_batch(n, r12[0], q1[0], q2[0], numbers[0], numbers[1]);
}

static int distance_call(int i, int j)
{
    return pw85_distance(r12[i], q1[j], q2[i], &numbers[0][i], points[0][i], points[1][i]);
}

static int distance_rows(size_t n)
{
    return pw85_distance_batch(n, r12[0], q1[0], q2[0], numbers[0], points[0][0], points[1][0]);
}

static int volume_call(int i, int j)
{
    return pw85_overlap_volume(r12[i], q1[j], q2[i], &numbers[0][i]);
}

static int volume_rows(size_t n)
{
    return pw85_overlap_volume_batch(n, r12[0], q1[0], q2[0], numbers[0]);
}

/* A function of pairs. A call takes the first form of pair j and the other arguments of pair i.
 * Results are in `numbers` and `points`, truth values of rows in `bytes`. */
struct function {
    char const *name;
    int (*call)(int i, int j);
    int (*rows)(size_t n);
    int copies; /* of the pairs, that are computed as rows */
    int num_numbers, num_points;
    bool is_truth;
};

static struct function const functions[] = {
    {"overlap", overlap_call, overlap_rows, 16, 1, 0, true},
    {"contact", contact_call, contact_rows, 16, 2, 0, false},
    {"distance", distance_call, distance_rows, 4, 1, 2, false},
    {"overlap_volume", volume_call, volume_rows, 1, 1, 0, false},
};

static void check(int status)
{
    if (status == 0) return;
    fprintf(stderr, "%s\n", pw85_strerror(status));
    exit(1);
}

/* In seconds. They are rounded, which sets the flag of inexact results as in most programs. A call
 * of the library would have to clear it otherwise, which takes 80 ns. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void call_each(struct function const *f, int shift)
{
    for (int i = 0; i < PAIRS; ++i) check(f->call(i, i + shift));
}

static void write_results(struct function const *f, FILE *file)
{
    for (int k = 0; k < f->num_numbers; ++k) fwrite(numbers[k], sizeof(double), PAIRS, file);
    for (int k = 0; k < f->num_points; ++k) fwrite(points[k], sizeof(double), 3 * PAIRS, file);
}

static void run(struct function const *f, int rounds, FILE *file)
{
    size_t const n = (size_t)f->copies * PAIRS;
    double call = 1e300, row = 1e300;
    for (int k = 0; k < rounds; ++k) {
        double const start = now();
        call_each(f, k);
        double const middle = now();
        check(f->rows(n));
        double const end = now();
        if (middle - start < call) call = middle - start;
        if (end - middle < row) row = end - middle;
    }
    for (int i = 0; f->is_truth && i < PAIRS; ++i) numbers[0][i] = bytes[i];
    write_results(f, file);
    call_each(f, 0);
    write_results(f, file);
    printf("%s,%.17g,%.17g\n", f->name, 1e9 * call / PAIRS, 1e9 * row / (double)n);
}

static bool read_pairs(char const *path)
{
    FILE *const file = fopen(path, "rb");
    if (!file) return false;
    bool const complete = fread(r12, sizeof *r12, PAIRS, file) == PAIRS &&
                          fread(q1, sizeof *q1, PAIRS, file) == PAIRS &&
                          fread(q2, sizeof *q2, PAIRS, file) == PAIRS;
    fclose(file);
    return complete;
}

int main(int argc, char **argv)
{
    if (argc != 4 || !read_pairs(argv[1])) return 1;
    FILE *const file = fopen(argv[2], "wb");
    if (!file) return 1;
    for (int k = 1; k < MOST_COPIES; ++k) {
        memcpy(r12 + k * PAIRS, r12, PAIRS * sizeof *r12);
        memcpy(q1 + k * PAIRS, q1, PAIRS * sizeof *q1);
        memcpy(q2 + k * PAIRS, q2, PAIRS * sizeof *q2);
    }
    for (int k = 0; k < 4; ++k) run(&functions[k], atoi(argv[3]), file);
    return fclose(file) != 0;
}
