/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers questions of rows: reads the arguments of R, which have columns, into blocks of rows,
 * calls the function of C for each block, and writes its results to columns. */
#include "pw85_r.h"

#include "columns.h"

#include <math.h>
#include <string.h>

/* Rows of a block. The numbers of a block stay in the first cache of a core. They are too few for
 * the library to start threads. */
enum { BLOCK = 128, MOST_NUMBERS = 9, MOST_ARGUMENTS = 6 };

/* Rows that a thread computes before the user can interrupt the call. */
enum { INTERRUPTED = 64 * BLOCK };

/* The truth value NA as a byte. */
enum { MISSING_BYTE = 255 };

static char const *const forms[2][6] = {{"xx", "xy", "yy"}, {"xx", "xy", "xz", "yy", "yz", "zz"}};
static char const *const coordinates[3] = {"x", "y", "z"};

/* A column of numbers: of doubles, or of integers, of which the smallest is NA. */
struct column {
    double const *doubles;
    int const *integers;
};

/* An argument: its columns, all of the same length. */
struct table {
    char const *name;
    R_xlen_t rows;
    int dimension; /* of ellipsoids; 0 of other arguments */
    struct column center[3];
    struct column numbers[MOST_NUMBERS];
};

void pw85_refuse(char const *argument, R_xlen_t row, char const *column, char const *requirement)
{
    SEXP const package = PROTECT(Rf_mkString("pw85"));
    SEXP const space = PROTECT(R_FindNamespace(package));
    SEXP const name = PROTECT(argument ? Rf_mkString(argument) : R_NilValue);
    SEXP const number = PROTECT(row < 0 ? R_NilValue : Rf_ScalarReal((double)row + 1));
    SEXP const entry = PROTECT(column ? Rf_mkString(column) : R_NilValue);
    SEXP const text = PROTECT(Rf_mkString(requirement));
    SEXP const call = PROTECT(Rf_lang5(Rf_install(".refuse"), name, number, entry, text));
    Rf_eval(call, space);
    Rf_error("%s", requirement); /* not reached */
}

/* Whether all elements of a vector of truth values are NA, as in a column without other values. */
static bool is_all_missing(SEXP values)
{
    for (R_xlen_t k = 0; k < Rf_xlength(values); ++k)
        if (LOGICAL_RO(values)[k] != NA_LOGICAL) return false;
    return true;
}

/* The numbers of a vector, from an offset. */
static struct column column_of(SEXP values, R_xlen_t offset, char const *argument, char const *name)
{
    struct column found = {NULL, NULL};
    if (Rf_isFactor(values)) pw85_refuse(argument, -1, name, "must be numeric, not a factor");
    if (Rf_inherits(values, "integer64")) /* integers in the place of doubles */
        pw85_refuse(argument, -1, name, "must be numeric, not integer64: see as.double()");
    /* Their numbers depend on an origin or a unit; R's is.numeric() is false for them. */
    if (Rf_inherits(values, "Date") || Rf_inherits(values, "POSIXt") ||
        Rf_inherits(values, "difftime"))
        pw85_refuse(argument, -1, name, "must be numeric, not a date or time");
    if (TYPEOF(values) == REALSXP)
        found.doubles = REAL_RO(values) + offset;
    else if (TYPEOF(values) == INTSXP)
        found.integers = INTEGER_RO(values) + offset;
    else if (TYPEOF(values) == LGLSXP && is_all_missing(values))
        found.integers = LOGICAL_RO(values) + offset;
    else {
        char text[80];
        snprintf(text, sizeof text, "must be numeric, not %s",
                 Rf_type2char((SEXPTYPE)TYPEOF(values)));
        pw85_refuse(argument, -1, name, text);
    }
    return found;
}

static double number(struct column column, R_xlen_t row)
{
    if (column.doubles) return column.doubles[row];
    int const value = column.integers[row];
    return value == NA_INTEGER ? NA_REAL : value;
}

/* Whether a value is a data frame, and not a vector with this class alone. */
static bool is_data_frame(SEXP values)
{
    return TYPEOF(values) == VECSXP && Rf_inherits(values, "data.frame");
}

/* Whether a value is a vector of numbers without dimensions, as a row of a matrix with names. */
static bool is_named_row(SEXP values)
{
    return (TYPEOF(values) == REALSXP || TYPEOF(values) == INTSXP) && !Rf_isObject(values) &&
           Rf_getAttrib(values, R_DimSymbol) == R_NilValue;
}

/* The names of the columns of a data frame or matrix, or of the numbers of one row, or NULL. */
static SEXP names_of(SEXP values)
{
    if (is_data_frame(values) || is_named_row(values)) return Rf_getAttrib(values, R_NamesSymbol);
    if (!Rf_isMatrix(values) || TYPEOF(values) == VECSXP) return R_NilValue;
    SEXP const names = Rf_getAttrib(values, R_DimNamesSymbol);
    return names == R_NilValue ? names : VECTOR_ELT(names, 1);
}

/* The place of a name from place k on, or -1. */
static R_xlen_t find_name(SEXP names, char const *name, R_xlen_t k)
{
    for (; k < Rf_xlength(names); ++k)
        if (strcmp(CHAR(STRING_ELT(names, k)), name) == 0) return k;
    return -1;
}

/* Column k of a data frame or matrix. The first one decides how many rows there are. */
static struct column column_at(SEXP values, R_xlen_t k, struct table *table, char const *name)
{
    if (TYPEOF(values) != VECSXP) return column_of(values, k * table->rows, table->name, name);
    SEXP const found = VECTOR_ELT(values, k);
    if (Rf_isMatrix(found) || Rf_xlength(found) != table->rows)
        pw85_refuse(table->name, -1, name, "must be a vector with a number for each row");
    return column_of(found, 0, table->name, name);
}

static R_xlen_t rows_of(SEXP values)
{
    if (is_named_row(values)) return 1;
    if (TYPEOF(values) != VECSXP) return Rf_nrows(values);
    return Rf_xlength(values) == 0 ? 0 : Rf_xlength(VECTOR_ELT(values, 0));
}

static struct column named_column(SEXP values, SEXP names, char const *name, struct table *table)
{
    R_xlen_t const k = find_name(names, name, 0);
    if (k >= 0 && find_name(names, name, k + 1) >= 0)
        pw85_refuse(table->name, -1, name, "is there twice");
    if (k < 0)
        pw85_refuse(table->name, -1, name,
                    table->dimension == 2 ? "is missing: ellipses have columns x, y, xx, xy, yy"
                                          : "is missing: ellipsoids have columns x, y, z, xx, xy, "
                                            "xz, yy, yz, zz");
    return column_at(values, k, table, name);
}

/* Whether there are entries of forms in space. A column z alone may be another one of ellipses. */
static bool is_solid(SEXP names)
{
    return find_name(names, "xz", 0) >= 0 || find_name(names, "yz", 0) >= 0 ||
           find_name(names, "zz", 0) >= 0;
}

static void read_ellipsoids(SEXP values, struct table *table)
{
    SEXP const names = names_of(values);
    if (names == R_NilValue)
        pw85_refuse(table->name, -1, NULL,
                    "must be a data frame of ellipses or ellipsoids: see ellipses(), ellipsoids()");
    table->dimension = is_solid(names) ? 3 : 2;
    table->rows = rows_of(values);
    for (int k = 0; k < table->dimension; ++k)
        table->center[k] = named_column(values, names, coordinates[k], table);
    for (int k = 0; k < 3 * table->dimension - 3; ++k)
        table->numbers[k] = named_column(values, names, forms[table->dimension - 2][k], table);
}

/* An argument with `size` numbers in a row: columns, or a vector of one number for each row or of
 * one row. */
static void read_values(SEXP values, int size, struct table *table)
{
    bool const is_frame = is_data_frame(values);
    if (TYPEOF(values) == VECSXP && !is_frame)
        pw85_refuse(table->name, -1, NULL, "must be numbers, not a list");
    bool const has_columns = is_frame || Rf_isMatrix(values);
    if (has_columns && (is_frame ? Rf_length(values) : Rf_ncols(values)) == size) {
        table->rows = rows_of(values);
        for (int k = 0; k < size; ++k) table->numbers[k] = column_at(values, k, table, NULL);
        return;
    }
    bool const is_row = size > 1 && !has_columns && Rf_xlength(values) == size;
    bool const is_line = !is_frame && size == 1; /* a vector, whatever its dimensions */
    bool const is_turned = size > 1 && !is_frame && Rf_isMatrix(values) && Rf_ncols(values) == 1 &&
                           Rf_nrows(values) == size; /* a vector that is a column */
    if (!is_row && !is_line && !is_turned) {
        char text[80];
        snprintf(text, sizeof text, "must have %d column%s", size, size == 1 ? "" : "s");
        pw85_refuse(table->name, -1, NULL, text);
    }
    table->rows = is_line ? Rf_xlength(values) : 1;
    for (int k = 0; k < size; ++k) table->numbers[k] = column_of(values, k, table->name, NULL);
}

/* How many rows the result has: as many as the longest argument, or none if one has none. */
static R_xlen_t common_rows(struct table const *tables, int count)
{
    R_xlen_t most = 0;
    for (int k = 0; k < count; ++k) {
        if (tables[k].rows == 0) return 0;
        most = tables[k].rows > most ? tables[k].rows : most;
    }
    for (int k = 0; k < count; ++k)
        if (most % tables[k].rows != 0) {
            char text[120];
            snprintf(text, sizeof text, "has %lld rows, of which %lld rows are not a multiple",
                     (long long)tables[k].rows, (long long)most);
            pw85_refuse(tables[k].name, -1, NULL, text);
        }
    return most;
}

static bool are_doubles(struct column const *columns, int size)
{
    for (int j = 0; j < size; ++j)
        if (!columns[j].doubles) return false;
    return true;
}

/* Writes n rows, which do not begin again, one behind the other. */
static void gather_run(struct column const *columns, int size, R_xlen_t row, R_xlen_t n, double *to)
{
    if (!are_doubles(columns, size)) {
        for (R_xlen_t i = 0; i < n; ++i)
            for (int j = 0; j < size; ++j) to[i * size + j] = number(columns[j], row + i);
        return;
    }
    double const *first[MOST_NUMBERS];
    for (int j = 0; j < size; ++j) first[j] = columns[j].doubles + row;
    pw85_rows_of_columns(first, (size_t)size, (size_t)n, to);
}

/* Writes n rows from a row of the result on, one behind the other. After the last row of the
 * columns comes their first one. */
static void gather(struct column const *columns, int size, R_xlen_t rows, R_xlen_t from, R_xlen_t n,
                   double *to)
{
    R_xlen_t const different = rows < n ? rows : n;
    R_xlen_t const row = from < rows ? from : from % rows,
                   first = different < rows - row ? different : rows - row;
    gather_run(columns, size, row, first, to);
    gather_run(columns, size, 0, different - first, to + first * size);
    for (R_xlen_t i = different * size; i < n * size; ++i) to[i] = to[i - different * size];
}

/* Everything that a call needs. */
struct call {
    struct pw85_function const *function;
    struct table tables[MOST_ARGUMENTS];
    int num_ellipsoids, num_tables;
};

/* The numbers of a block of rows. Each thread has one. */
struct block {
    struct call const *call;
    R_xlen_t from;
    size_t n;
    bool has_constants; /* the rows of arguments with one row, which are the same in all blocks */
    double *in[PW85_INPUTS], *centers[2];
    void *out[PW85_OUTPUTS];
};

static struct table const *table_of(struct call const *call, struct pw85_input const *input)
{
    switch (input->kind) {
    case PW85_FORM2:
        return &call->tables[1];
    case PW85_VALUES: {
        struct table const *table = &call->tables[call->num_ellipsoids];
        for (struct pw85_input const *one = call->function->inputs; one < input; ++one)
            if (one->kind == PW85_VALUES) ++table;
        return table;
    }
    default:
        return &call->tables[0];
    }
}

static void gather_rows(struct block const *block, struct table const *table,
                        struct column const *columns, int size, double *to)
{
    if (table->rows == 1 && block->has_constants) return;
    gather(columns, size, table->rows, block->from, (R_xlen_t)block->n, to);
}

/* The separations of a block: the centres of y minus those of x. */
static void gather_separation(struct block const *block, double *to)
{
    struct table const *const x = &block->call->tables[0], *const y = &block->call->tables[1];
    size_t const count = block->n * (size_t)x->dimension;
    gather_rows(block, x, x->center, x->dimension, block->centers[0]);
    gather_rows(block, y, y->center, x->dimension, block->centers[1]);
    pw85_subtract(block->centers[1], block->centers[0], count, to);
}

static void gather_inputs(struct block *block)
{
    struct pw85_function const *const function = block->call->function;
    for (int k = 0; k < function->num_inputs; ++k) {
        struct pw85_input const *const input = &function->inputs[k];
        struct table const *const table = table_of(block->call, input);
        if (input->kind == PW85_SEPARATION)
            gather_separation(block, block->in[k]);
        else
            gather_rows(block, table, table->numbers, input->size, block->in[k]);
    }
    block->has_constants = true;
}

/* Writes the results of a block to the columns: vectors, of doubles or of truth values. */
static void scatter_outputs(struct block const *block, void *const *columns)
{
    struct pw85_function const *const function = block->call->function;
    if (function->is_truth) {
        unsigned char const *const bytes = block->out[0];
        int *const to = (int *)columns[0] + block->from;
        for (size_t i = 0; i < block->n; ++i)
            to[i] = bytes[i] == MISSING_BYTE ? NA_LOGICAL : bytes[i];
        return;
    }
    for (int k = 0, column = 0; k < function->num_outputs; ++k) {
        size_t const size = (size_t)function->sizes[k];
        double *first[PW85_COLUMNS];
        for (size_t j = 0; j < size; ++j, ++column)
            first[j] = (double *)columns[column] + block->from;
        pw85_columns_of_rows(block->out[k], size, block->n, first);
    }
}

static int sum_of(int const *sizes, int count)
{
    int sum = 0;
    for (int k = 0; k < count; ++k) sum += sizes[k];
    return sum;
}

/* The centre that is to blame for a separation that is refused. */
static struct table const *blamed_center(struct call const *call, R_xlen_t row, char const **column)
{
    for (int t = 0; t < 2; ++t)
        for (int k = 0; k < call->tables[t].dimension; ++k)
            if (!R_FINITE(number(call->tables[t].center[k], row % call->tables[t].rows))) {
                *column = coordinates[k];
                return &call->tables[t];
            }
    return &call->tables[1];
}

/* Ends the call with the cause that the library tells, in the words of R. `rows` are those that the
 * library had, of which it refused number `bad`, or a later one that it tells. */
static void NORET refuse_row(struct call const *call, int status, R_xlen_t const *rows, size_t bad)
{
    pw85_error error;
    pw85_last_error(&error);
    char const *const text = error.function ? error.requirement : pw85_strerror(status);
    R_xlen_t const row = rows[bad + (error.function ? error.row : 0)];
    struct table const *table = NULL;
    char const *column = NULL;
    for (int k = 0; error.function && error.argument && k < call->function->num_inputs; ++k) {
        struct pw85_input const *const input = &call->function->inputs[k];
        if (strcmp(input->name, error.argument) != 0) continue;
        bool const is_form = input->kind == PW85_FORM1 || input->kind == PW85_FORM2;
        table = table_of(call, input);
        if (input->kind == PW85_SEPARATION) table = blamed_center(call, row, &column);
        if (input->kind == PW85_SEPARATION && !column) /* a matter of both centres */
            pw85_refuse("y", row, NULL, "must have another centre than x, at a finite distance");
        if (is_form && !R_FINITE(number(table->numbers[error.entry], row % table->rows)))
            column = forms[table->dimension - 2][error.entry];
    }
    pw85_refuse(table ? table->name : NULL, table ? row % table->rows : row, column, text);
}

static bool has_missing(struct table const *table, struct column const *columns, int size,
                        R_xlen_t row)
{
    for (int k = 0; k < size; ++k)
        if (ISNAN(number(columns[k], row % table->rows))) return true;
    return false;
}

/* Whether one of the numbers for a row of the result is NA or NaN. */
static bool is_missing(struct call const *call, R_xlen_t row)
{
    for (int k = 0; k < call->function->num_inputs; ++k) {
        struct pw85_input const *const input = &call->function->inputs[k];
        struct table const *table = table_of(call, input);
        if (input->kind != PW85_SEPARATION) {
            if (has_missing(table, table->numbers, input->size, row)) return true;
            continue;
        }
        for (table = call->tables; table < call->tables + 2; ++table)
            if (has_missing(table, table->center, table->dimension, row)) return true;
    }
    return false;
}

/* Moves the inputs of the rows of a block without missing numbers to its beginning, and writes
 * which rows these are. Returns how many. */
static size_t keep_complete(struct block const *block, R_xlen_t *rows)
{
    struct pw85_function const *const function = block->call->function;
    size_t count = 0;
    for (size_t i = 0; i < block->n; ++i) {
        if (is_missing(block->call, block->from + (R_xlen_t)i)) continue;
        for (int k = 0; k < function->num_inputs; ++k) {
            size_t const size = (size_t)function->inputs[k].size;
            double *const numbers = block->in[k];
            memmove(numbers + size * count, numbers + size * i, size * sizeof(double));
        }
        rows[count++] = block->from + (R_xlen_t)i;
    }
    return count;
}

/* Writes the results of one row of a block, or NA if there is none, to row i. */
static void move_output(struct block const *block, size_t const *row, size_t i)
{
    struct pw85_function const *const function = block->call->function;
    if (function->is_truth) {
        unsigned char *const bytes = block->out[0];
        bytes[i] = row ? bytes[*row] : MISSING_BYTE;
        return;
    }
    for (int k = 0; k < function->num_outputs; ++k) {
        size_t const size = (size_t)function->sizes[k];
        double *const numbers = block->out[k];
        for (size_t j = 0; j < size; ++j)
            numbers[i * size + j] = row ? numbers[*row * size + j] : NA_REAL;
    }
}

/* Calls the function of C for the complete rows of a block, which `rows` receives. */
static int compute_complete(struct block *block, R_xlen_t *rows, size_t *count, size_t *bad)
{
    *bad = 0;
    *count = keep_complete(block, rows);
    if (*count == 0) return 0;
    return block->call->function->call(*count, (double const *const *)block->in, block->out, bad);
}

/* Computes a block, and returns false if the library refuses a row. If numbers of a row are
 * missing, as are those that a user has not measured, its result is, too. The block is searched for
 * such numbers only if it is refused with them. */
static bool compute_block(struct block *block)
{
    R_xlen_t rows[BLOCK];
    size_t count, bad = 0;
    gather_inputs(block);
    if (block->call->function->call(block->n, (double const *const *)block->in, block->out, &bad) ==
        0)
        return true;
    if (compute_complete(block, rows, &count, &bad) != 0) return false;
    for (size_t i = block->n; i-- > 0;) {
        bool const is_complete = count > 0 && rows[count - 1] == block->from + (R_xlen_t)i;
        if (is_complete) --count;
        move_output(block, is_complete ? &count : NULL, i);
    }
    return true;
}

/* Ends the call with the cause for which the library refuses a row of a block. */
static void NORET refuse_block(struct block *block)
{
    R_xlen_t rows[BLOCK];
    size_t count, bad;
    gather_inputs(block);
    int const status = compute_complete(block, rows, &count, &bad);
    refuse_row(block->call, status, rows, bad);
}

static struct block new_block(struct call const *call, size_t n)
{
    struct pw85_function const *const function = call->function;
    struct block block = {call, 0, n, false, {NULL}, {NULL}, {NULL}};
    for (int k = 0; k < 2; ++k) block.centers[k] = (double *)R_alloc(3 * n, sizeof(double));
    for (int k = 0; k < function->num_inputs; ++k)
        block.in[k] = (double *)R_alloc(n * (size_t)function->inputs[k].size, sizeof(double));
    for (int k = 0; k < function->num_outputs; ++k)
        block.out[k] = R_alloc(n * (size_t)function->sizes[k], sizeof(double));
    return block;
}

static void set_rows(struct block *block, R_xlen_t from, R_xlen_t end)
{
    block->from = from;
    block->n = end - from < BLOCK ? (size_t)(end - from) : BLOCK;
}

/* Computes rows in threads. Returns the first row of the first block of which the library refuses a
 * row, or `end`. No thread calls R. */
static R_xlen_t compute_rows(struct block *blocks, int threads, R_xlen_t from, R_xlen_t end,
                             void *const *columns)
{
    R_xlen_t refused = end;
    (void)threads;
#if defined _OPENMP
#pragma omp parallel for num_threads(threads)
#endif
    for (R_xlen_t i = from; i < end; i += BLOCK) {
        struct block *const block = &blocks[pw85_thread()];
        set_rows(block, i, end);
        if (compute_block(block)) {
            scatter_outputs(block, columns);
            continue;
        }
#if defined _OPENMP
#pragma omp critical
#endif
        if (i < refused) refused = i;
    }
    return refused;
}

static void compute(struct call *call, R_xlen_t rows, void *const *columns)
{
    int const threads = rows <= BLOCK ? 1 : pw85_num_threads;
    R_xlen_t const most = (R_xlen_t)threads * INTERRUPTED;
    struct block *const blocks = (struct block *)R_alloc((size_t)threads, sizeof(struct block));
    for (int k = 0; k < threads; ++k)
        blocks[k] = new_block(call, rows < BLOCK ? (size_t)rows : BLOCK);
    for (R_xlen_t from = 0; from < rows; from += most) {
        R_xlen_t const end = rows - from < most ? rows : from + most,
                       refused = compute_rows(blocks, threads, from, end, columns);
        if (refused < end) {
            set_rows(&blocks[0], refused, end);
            refuse_block(&blocks[0]);
        }
        R_CheckUserInterrupt();
    }
}

static SEXP names_of_columns(struct pw85_function const *function, int count)
{
    SEXP const names = PROTECT(Rf_allocVector(STRSXP, count));
    for (int k = 0; k < count; ++k) SET_STRING_ELT(names, k, Rf_mkChar(function->columns[k]));
    UNPROTECT(1);
    return names;
}

/* One output: a vector, or a matrix if a row has several numbers. */
static SEXP one_output(struct call *call, R_xlen_t rows, int count)
{
    bool const is_truth = call->function->is_truth;
    SEXP const result = PROTECT(count == 1 ? Rf_allocVector(is_truth ? LGLSXP : REALSXP, rows)
                                           : Rf_allocMatrix(REALSXP, (int)rows, count));
    void *columns[PW85_COLUMNS] = {NULL};
    for (int k = 0; k < count; ++k)
        columns[k] = is_truth ? (void *)LOGICAL(result) : (void *)(REAL(result) + k * rows);
    compute(call, rows, columns);
    if (count > 1) {
        SEXP const names = PROTECT(Rf_allocVector(VECSXP, 2));
        SET_VECTOR_ELT(names, 1, names_of_columns(call->function, count));
        Rf_setAttrib(result, R_DimNamesSymbol, names);
        UNPROTECT(1);
    }
    UNPROTECT(1);
    return result;
}

/* Several outputs: a data frame. */
static SEXP frame_of_outputs(struct call *call, R_xlen_t rows, int count)
{
    SEXP const result = PROTECT(Rf_allocVector(VECSXP, count));
    void *columns[PW85_COLUMNS];
    for (int k = 0; k < count; ++k) {
        SET_VECTOR_ELT(result, k, Rf_allocVector(REALSXP, rows));
        columns[k] = REAL(VECTOR_ELT(result, k));
    }
    compute(call, rows, columns);
    Rf_setAttrib(result, R_NamesSymbol, names_of_columns(call->function, count));
    SEXP const numbers = PROTECT(Rf_allocVector(INTSXP, 2));
    INTEGER(numbers)[0] = NA_INTEGER;
    INTEGER(numbers)[1] = -(int)rows;
    Rf_setAttrib(result, R_RowNamesSymbol, numbers);
    SEXP const name = PROTECT(Rf_mkString("data.frame"));
    Rf_setAttrib(result, R_ClassSymbol, name);
    UNPROTECT(3);
    return result;
}

/* The dimension of the question: that of the ellipsoids, or the only one of a constructor. */
static int dimension_of(struct pw85_question const *question, struct call const *call)
{
    if (call->num_ellipsoids == 0) return question->functions[0].call ? 2 : 3;
    int const d = call->tables[0].dimension;
    if (call->num_ellipsoids == 2 && call->tables[1].dimension != d)
        pw85_refuse("y", -1, NULL, d == 2 ? "must be ellipses, as x" : "must be ellipsoids, as x");
    if (!question->functions[d - 2].call)
        pw85_refuse("x", -1, NULL,
                    d == 2 ? "must be ellipsoids, in three dimensions" : "must be ellipses");
    return d;
}

static struct pw85_question const *find_question(char const *name)
{
    size_t k = 0;
    while (k + 1 < pw85_num_questions && strcmp(pw85_questions[k].name, name) != 0) ++k;
    return &pw85_questions[k];
}

SEXP pw85_ask(SEXP arguments)
{
    static char const *const ellipsoids[] = {"x", "y"};
    SEXP left = CDR(arguments); /* behind the name of this function */
    struct pw85_question const *const question = find_question(CHAR(STRING_ELT(CAR(left), 0)));
    struct call call = {.num_ellipsoids = question->num_ellipsoids,
                        .num_tables = question->num_ellipsoids};
    for (int k = 0; k < call.num_ellipsoids; ++k) {
        left = CDR(left);
        call.tables[k].name = ellipsoids[k];
        read_ellipsoids(CAR(left), &call.tables[k]);
    }
    call.function = &question->functions[dimension_of(question, &call) - 2];
    for (int k = 0; k < call.function->num_inputs; ++k) {
        struct pw85_input const *const input = &call.function->inputs[k];
        if (input->kind != PW85_VALUES) continue;
        left = CDR(left);
        call.tables[call.num_tables].name = input->name;
        read_values(CAR(left), input->size, &call.tables[call.num_tables++]);
    }
    R_xlen_t const rows = common_rows(call.tables, call.num_tables);
    int const count = sum_of(call.function->sizes, call.function->num_outputs);
    if (count > 1 && rows > INT_MAX) pw85_refuse(NULL, -1, NULL, "there are too many rows");
    bool const is_one = call.function->num_outputs == 1;
    return is_one ? one_output(&call, rows, count) : frame_of_outputs(&call, rows, count);
}
