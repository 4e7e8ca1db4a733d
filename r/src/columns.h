/* SPDX-License-Identifier: BSD-3-Clause */
/* Copies columns, which R, Octave and MATLAB store, to rows, which the library takes, and back. The
 * package for Octave has this file by a link. */
#ifndef PW85_COLUMNS_H_INCLUDED
#define PW85_COLUMNS_H_INCLUDED

#include <stddef.h>

#if defined __GNUC__
/* Two numbers, which one instruction loads or stores. */
typedef double pw85_two __attribute__((vector_size(16), aligned(8), may_alias));
#endif

/* Writes two columns of n numbers into rows that begin `step` numbers apart. */
static inline void pw85_write_two(double const *first, double const *second, size_t n, size_t step,
                                  double *to)
{
    size_t i = 0;
#if defined __GNUC__
    for (; i + 1 < n; i += 2, to += 2 * step) {
        pw85_two const x = *(pw85_two const *)(first + i), y = *(pw85_two const *)(second + i);
        *(pw85_two *)to = (pw85_two){x[0], y[0]};
        *(pw85_two *)(to + step) = (pw85_two){x[1], y[1]};
    }
#endif
    for (; i < n; ++i, to += step) {
        to[0] = first[i];
        to[1] = second[i];
    }
}

/* Reads two columns from rows. */
static inline void pw85_read_two(double const *from, size_t n, size_t step, double *first,
                                 double *second)
{
    size_t i = 0;
#if defined __GNUC__
    for (; i + 1 < n; i += 2, from += 2 * step) {
        pw85_two const x = *(pw85_two const *)from, y = *(pw85_two const *)(from + step);
        *(pw85_two *)(first + i) = (pw85_two){x[0], y[0]};
        *(pw85_two *)(second + i) = (pw85_two){x[1], y[1]};
    }
#endif
    for (; i < n; ++i, from += step) {
        first[i] = from[0];
        second[i] = from[1];
    }
}

/* Writes the differences of n numbers. */
static inline void pw85_subtract(double const *from, double const *less, size_t n, double *to)
{
    size_t i = 0;
#if defined __GNUC__
    for (; i + 1 < n; i += 2)
        *(pw85_two *)(to + i) = *(pw85_two const *)(from + i) - *(pw85_two const *)(less + i);
#endif
    for (; i < n; ++i) to[i] = from[i] - less[i];
}

/* Writes n rows of `size` numbers, one behind the other, from their columns. */
static inline void pw85_rows_of_columns(double const *const *columns, size_t size, size_t n,
                                        double *to)
{
    size_t j = 0;
    for (; j + 1 < size; j += 2) pw85_write_two(columns[j], columns[j + 1], n, size, to + j);
    for (size_t i = 0; j < size && i < n; ++i) to[i * size + j] = columns[j][i];
}

/* Writes the columns of n rows. */
static inline void pw85_columns_of_rows(double const *from, size_t size, size_t n,
                                        double *const *columns)
{
    size_t j = 0;
    for (; j + 1 < size; j += 2) pw85_read_two(from + j, n, size, columns[j], columns[j + 1]);
    for (size_t i = 0; j < size && i < n; ++i) columns[j][i] = from[i * size + j];
}

#endif
