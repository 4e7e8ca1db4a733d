/* SPDX-License-Identifier: BSD-3-Clause */
/* What the made tables of questions say to the code that reads arguments of R: see rows.c. */
#ifndef PW85_R_H_INCLUDED
#define PW85_R_H_INCLUDED

#include <stdbool.h>
#include <stddef.h>

#include <pw85_batch.h>
#include <pw85_enclosing.h>

#define R_NO_REMAP
#include <R.h>
#include <R_ext/Rdynload.h>
#include <Rinternals.h>

/* The largest numbers of inputs, outputs and columns of results. */
enum { PW85_INPUTS = 6, PW85_OUTPUTS = 8, PW85_COLUMNS = 96 };

/* What an input is: the difference of two centres, a form of x or y, or an argument of its own. */
enum pw85_kind { PW85_SEPARATION, PW85_FORM1, PW85_FORM2, PW85_VALUES };

struct pw85_input {
    char const *name; /* in C */
    enum pw85_kind kind;
    int size; /* numbers in a row */
};

/* A function of C. `call` computes n rows and returns a status. If it computes them one by one, it
 * stops at the first bad row and writes its index to `row`; otherwise pw85_last_error() knows the
 * row. */
struct pw85_function {
    int (*call)(size_t n, double const *const *in, void *const *out, size_t *row);
    bool is_truth; /* the output is a byte: 0, 1, or 255 for a bad row */
    int num_inputs;
    struct pw85_input inputs[PW85_INPUTS];
    int num_outputs;
    int sizes[PW85_OUTPUTS]; /* numbers in a row of each output */
    char const *columns[PW85_COLUMNS];
};

/* A question, in two and three dimensions; `call` is null where there is no function. */
struct pw85_question {
    char const *name;
    int num_ellipsoids; /* 0 for those that make forms */
    struct pw85_function functions[2];
};

/* In the order of strcmp(). */
extern struct pw85_question const pw85_questions[];
extern size_t const pw85_num_questions;

/* Threads for rows, and the number of the one that calls, from 0. */
extern int pw85_num_threads;
int pw85_thread(void);

/* Answers a question. The arguments of .External() are its name, ellipsoids, and the others. */
SEXP pw85_ask(SEXP arguments);

/* Ends the call with a condition of class pw85_error. `row` counts from 0 and is -1 if the cause is
 * not one row; `argument` and `column` may be null. */
void NORET pw85_refuse(char const *argument, R_xlen_t row, char const *column,
                       char const *requirement);

#endif
