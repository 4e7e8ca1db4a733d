/* SPDX-License-Identifier: BSD-3-Clause */
/* What the made tables of functions say to the code that reads matrices: see pw85_mex.c. */
#ifndef PW85_OCTAVE_H_INCLUDED
#define PW85_OCTAVE_H_INCLUDED

#include <stdbool.h>
#include <stddef.h>

#include <pw85_batch.h>
#include <pw85_enclosing.h>

/* The largest numbers of inputs and outputs of a function, and of the columns of all of them. */
enum { PW85_INPUTS = 6, PW85_OUTPUTS = 8, PW85_COLUMNS = 128 };

/* What an input is: the difference of two centres, a form, or an argument of its own. */
enum pw85_kind { PW85_SEPARATION, PW85_FORM1, PW85_FORM2, PW85_VALUES };

struct pw85_input {
    char const *name;
    enum pw85_kind kind;
    int size; /* numbers in a row */
};

/* A function of C in two or three dimensions. `call` computes n rows and returns a status. If it
 * computes them one by one, it stops at the first bad row and writes its index to `row`; otherwise
 * pw85_last_error() knows the row. */
struct pw85_function {
    int (*call)(size_t n, double const *const *in, void *const *out, size_t *row);
    bool is_truth; /* the output is a byte: 0, 1, or 255 for a bad row */
    int num_inputs;
    struct pw85_input inputs[PW85_INPUTS];
    int num_outputs;
    int sizes[PW85_OUTPUTS]; /* numbers in a row of each output */
};

/* A function of Octave; `call` is null where there is no function of C. */
struct pw85_question {
    char const *name;
    int num_ellipsoids; /* 0 for those that make forms */
    bool is_endless;    /* the last argument may be missing: it is infinite then */
    struct pw85_function functions[2];
};

/* In the order of strcmp(). */
extern struct pw85_question const pw85_questions[];
extern size_t const pw85_num_questions;

#endif
