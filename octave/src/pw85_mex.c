/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of pw85 for Octave and MATLAB: pw85_mex (NAME, ...) calls the function pw85_NAME of
 * the C API for each row of matrices. Both have all functions of MEX that are used here. */
#include "pw85_octave.h"

#include "columns.h"

#include <math.h>
#include <mex.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rows of a block. The numbers of a block stay in the first cache of a core, and they are too few
 * for the library to start threads, which would not survive a fork, as that of parcellfun(). */
enum { BLOCK = 128, MOST_NAME = 64 };

/* The name of the function that the user called. */
static char function_name[MOST_NAME];

/* A matrix of numbers, column by column. */
struct matrix {
    char const *name; /* of the argument */
    size_t rows;
    double const *numbers;
};

/* Ends the call with an error "FUNCTION: ARGUMENT, row ROW: TEXT". `row` counts from 0 and is -1 if
 * the cause is not one row; `argument` may be null. In Octave mexErrMsgIdAndTxt() would put the
 * name of this file in front. */
static void refuse(char const *id, char const *argument, long row, char const *format, ...)
{
    char text[400], place[100] = "", number[40] = "";
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (row >= 0) snprintf(number, sizeof number, "%srow %ld", argument ? ", " : "", row + 1);
    if (argument || row >= 0)
        snprintf(place, sizeof place, "%s%s: ", argument ? argument : "", number);
    char message[600];
    snprintf(message, sizeof message, "pw85_%s: %s%s", function_name, place, text);
    mxArray *given[3] = {mxCreateString(id), mxCreateString("%s"), mxCreateString(message)};
    mexCallMATLAB(0, NULL, 3, given, "error");
}

/* The numbers of a row that an argument has: a column with one row's numbers is such a row. */
static size_t width(mxArray const *given, size_t size)
{
    return mxGetN(given) == 1 && mxGetM(given) == size ? size : mxGetN(given);
}

static void check_class(mxArray const *given, char const *name)
{
    if (!mxIsNumeric(given))
        refuse("pw85:class", name, -1, "must be a numeric matrix, not %s", mxGetClassName(given));
    if (mxIsComplex(given)) refuse("pw85:class", name, -1, "must be real, not complex");
    if (mxIsSparse(given)) refuse("pw85:class", name, -1, "must be full, not sparse: see full()");
    if (mxGetNumberOfDimensions(given) != 2)
        refuse("pw85:size", name, -1, "must be a matrix, not an array of %d dimensions",
               (int)mxGetNumberOfDimensions(given));
}

/* The same numbers as doubles. */
static double const *doubles_of(mxArray const *given)
{
    if (mxIsDouble(given)) return mxGetPr(given);
    mxArray *made = NULL, *from = (mxArray *)given; /* it is not changed */
    mexCallMATLAB(1, &made, 1, &from, "double");
    return mxGetPr(made);
}

/* The numbers of an array in the order of its rows. */
static double const *transposed(double const *numbers, size_t rows, size_t columns)
{
    double *const made = mxMalloc(rows * columns * sizeof(double) + 1);
    for (size_t j = 0; j < columns; ++j)
        for (size_t i = 0; i < rows; ++i) made[i * columns + j] = numbers[j * rows + i];
    return made;
}

/* An argument with `size` numbers in a row. One number in a row may be any vector, and a rotation
 * of nine numbers a matrix of 3×3. */
static struct matrix read_matrix(mxArray const *given, char const *name, size_t size)
{
    check_class(given, name);
    size_t const m = mxGetM(given), n = mxGetN(given);
    struct matrix made = {name, m, doubles_of(given)};
    if (size == 1 && (m == 1 || n == 1))
        made.rows = m * n;
    else if (size == 9 && m == 3 && n == 3) {
        made.rows = 1;
        made.numbers = transposed(made.numbers, 3, 3);
    } else if (n == 1 && m == size)
        made.rows = 1;
    else if (n != size)
        refuse("pw85:size", name, -1, "must have %d column%s, not %ld", (int)size,
               size == 1 ? "" : "s", (long)n);
    return made;
}

/* Rows of the result. Arguments that do not have one row have the same number of rows. */
static size_t common_rows(struct matrix const *matrices, int count)
{
    struct matrix const *longest = matrices;
    for (int k = 0; k < count; ++k)
        if (longest->rows == 1)
            longest = &matrices[k];
        else if (matrices[k].rows != 1 && matrices[k].rows != longest->rows)
            refuse("pw85:size", matrices[k].name, -1, "has %ld rows, and %s has %ld",
                   (long)matrices[k].rows, longest->name, (long)longest->rows);
    return longest->rows;
}

/* An angle in degrees as quarters of a turn, 0 to 3, and the rest in radians, from about -pi/4 to
 * pi/4. The subtraction is exact: both numbers are multiples of the last place of the angle. */
static int reduce(double degrees, double *rest)
{
    double const near = fabs(degrees) < 1e12 ? degrees : fmod(degrees, 360);
    double const quarters = floor(near / 90 + 0.5);
    *rest = (near - 90 * quarters) * (acos(-1.0) / 180);
    return (int)((long long)quarters & 3);
}

/* Cosine and sine of an angle in degrees, exact at right angles. */
static void turn(double degrees, double *cosine, double *sine)
{
    double rest;
    int const quarters = reduce(degrees, &rest);
    double const c = cos(rest), s = sin(rest);
    double const turned[5] = {c, s, -c, -s, c}; /* cos of the angle less 0, 1, 2, 3 quarters */
    *cosine = turned[(4 - quarters) & 3];
    *sine = turned[(5 - quarters) & 3];
}

/* Form of an ellipsoid [a b c phi theta psi] of matGeom: turned by psi about x, then by theta about
 * y, then by phi about z, in degrees (drawEllipsoid, eulerAnglesToRotation3d). */
static int ellipsoid_of_matgeom(double const row[6], double q[6])
{
    double cx, sx, cy, sy, cz, sz;
    turn(row[3], &cz, &sz);
    turn(row[4], &cy, &sy);
    turn(row[5], &cx, &sx);
    double const rotation[9] = {
        cz * cy,
        cz * sy * sx - sz * cx,
        cz * sy * cx + sz * sx,
        sz * cy,
        sz * sy * sx + cz * cx,
        sz * sy * cx - cz * sx,
        -sy,
        cy * sx,
        cy * cx,
    };
    return pw85_ellipsoid(row, rotation, q);
}

/* Form of an ellipse [a b theta] of matGeom: turned by theta degrees (drawEllipse). */
static int ellipse_of_matgeom(double const row[3], double q[3])
{
    double rest;
    bool const is_turned = reduce(row[2], &rest) % 2 != 0;
    return pw85_ellipse(row[is_turned], row[!is_turned], rest, q);
}

/* Identifier of the errors for which the library has a status. */
static char const *id_of(int status)
{
    return status == PW85_ECONVERGENCE ? "pw85:convergence" : "pw85:value";
}

/* Ends the call with the cause for which the library refuses a row of one argument. */
static void refuse_row(char const *name, long row, int status)
{
    pw85_error error;
    pw85_last_error(&error);
    refuse(id_of(status), name, row, "%s",
           error.function ? error.requirement : pw85_strerror(status));
}

/* The forms of rows of matGeom in d dimensions. */
static struct matrix forms_of(struct matrix const *rows, int d)
{
    int const columns = d == 2 ? 5 : 9, size = d == 2 ? 3 : 6;
    double *const made = mxMalloc(rows->rows * (size_t)size * sizeof(double) + 1);
    for (size_t i = 0; i < rows->rows; ++i) {
        double row[9], q[6];
        for (int j = 0; j < columns; ++j) {
            row[j] = rows->numbers[(size_t)j * rows->rows + i];
            if (!isfinite(row[j]))
                refuse("pw85:value", rows->name, (long)i, "column %d must be finite", j + 1);
        }
        int const status =
            d == 2 ? ellipse_of_matgeom(row + d, q) : ellipsoid_of_matgeom(row + d, q);
        if (status != 0) refuse_row(rows->name, (long)i, status);
        for (int j = 0; j < size; ++j) made[(size_t)j * rows->rows + i] = q[j];
    }
    struct matrix const forms = {rows->name, rows->rows, made};
    return forms;
}

/* The centres of y minus those of x. */
static struct matrix separations_of(struct matrix const *x, struct matrix const *y, int d)
{
    struct matrix const both[2] = {*x, *y};
    size_t const n = common_rows(both, 2);
    double *const made = mxMalloc(n * (size_t)d * sizeof(double) + 1);
    for (size_t j = 0; j < (size_t)d; ++j) {
        double const *const from = x->numbers + j * x->rows, *const to = y->numbers + j * y->rows;
        for (size_t i = 0; i < n; ++i)
            made[j * n + i] = to[y->rows == 1 ? 0 : i] - from[x->rows == 1 ? 0 : i];
    }
    struct matrix const separations = {y->name, n, made};
    return separations;
}

/* Everything that a call needs. */
struct call {
    struct pw85_question const *question;
    struct pw85_function const *function;
    bool is_of_rows; /* of matGeom */
    struct matrix inputs[PW85_INPUTS];
};

/* Chooses the function by the columns of the first argument. */
static void choose_function(struct call *call, int count, mxArray const *const *given)
{
    struct pw85_question const *const question = call->question;
    if (question->num_ellipsoids == 0) {
        call->function = &question->functions[question->functions[0].call ? 0 : 1];
        return;
    }
    bool const is_pair = question->num_ellipsoids == 2;
    char const *const name = is_pair ? "r12 or x" : "q or x";
    if (count == 0) refuse("pw85:arguments", name, -1, "is missing");
    check_class(given[0], name);
    size_t const solid = is_pair ? 3 : 6, flat = is_pair ? 2 : 3;
    size_t const sizes[4] = {flat, solid, 5, 9};
    for (int k = 0; k < 4; ++k) {
        if (width(given[0], sizes[k]) != sizes[k]) continue;
        call->function = &question->functions[k % 2];
        call->is_of_rows = k >= 2;
        if (!call->function->call)
            refuse("pw85:size", name, -1, "must be %s",
                   k % 2 ? "an ellipse" : "an ellipsoid, in 3-D");
        return;
    }
    refuse("pw85:size", name, -1,
           "must have %d (ellipsoids), %d (ellipses), 9 or 5 columns (rows of matGeom), not %ld",
           (int)solid, (int)flat, (long)mxGetN(given[0]));
}

static void check_count(struct call const *call, int count)
{
    int most = call->is_of_rows ? call->question->num_ellipsoids : call->function->num_inputs;
    for (int k = 0; call->is_of_rows && k < call->function->num_inputs; ++k)
        most += call->function->inputs[k].kind == PW85_VALUES;
    if (count == most || (count == most - 1 && call->question->is_endless)) return;
    refuse("pw85:arguments", NULL, -1, "takes %d argument%s, not %d: see help pw85_%s", most,
           most == 1 ? "" : "s", count, function_name);
}

static double const infinite = HUGE_VAL;

/* The inputs of C from the arguments in its order. A last one that is missing is infinite. */
static void read_inputs(struct call *call, int count, mxArray const *const *given)
{
    for (int k = 0; k < call->function->num_inputs; ++k) {
        struct pw85_input const *const input = &call->function->inputs[k];
        struct matrix const endless = {input->name, 1, &infinite};
        call->inputs[k] =
            k < count ? read_matrix(given[k], input->name, (size_t)input->size) : endless;
    }
}

/* The inputs of C from rows of matGeom and the other arguments. */
static void read_rows(struct call *call, int count, mxArray const *const *given)
{
    int const num_rows = call->question->num_ellipsoids,
              d = call->function == call->question->functions ? 2 : 3;
    struct matrix rows[2], forms[2];
    for (int k = 0; k < num_rows; ++k) {
        rows[k] = read_matrix(given[k], k == 0 ? "x" : "y", d == 2 ? 5 : 9);
        forms[k] = forms_of(&rows[k], d);
    }
    int next = num_rows;
    for (int k = 0; k < call->function->num_inputs; ++k) {
        struct pw85_input const *const input = &call->function->inputs[k];
        struct matrix const endless = {input->name, 1, &infinite};
        switch (input->kind) {
        case PW85_SEPARATION:
            call->inputs[k] = separations_of(&rows[0], &rows[1], d);
            break;
        case PW85_FORM1:
        case PW85_FORM2:
            call->inputs[k] = forms[input->kind == PW85_FORM2];
            break;
        default:
            call->inputs[k] =
                next < count ? read_matrix(given[next], input->name, (size_t)input->size) : endless;
            ++next;
        }
    }
}

/* Ends the call with the cause that the library tells, about a row of a block. */
static void refuse_block(struct call const *call, int status, size_t row)
{
    pw85_error error;
    pw85_last_error(&error);
    if (!error.function) refuse(id_of(status), NULL, (long)row, "%s", pw85_strerror(status));
    row += error.row;
    for (int k = 0; error.argument && k < call->function->num_inputs; ++k) {
        if (strcmp(call->function->inputs[k].name, error.argument) != 0) continue;
        struct matrix const *const matrix = &call->inputs[k];
        long const own = matrix->rows == 1 ? 0 : (long)row;
        if (call->is_of_rows && call->function->inputs[k].kind == PW85_SEPARATION)
            refuse("pw85:value", "y", (long)row,
                   "must have another centre than x, at a finite distance");
        refuse("pw85:value", matrix->name, own, "%s", error.requirement);
    }
    refuse(id_of(status), error.argument, (long)row, "%s", error.requirement);
}

/* Writes n rows from row `from` on, one behind the other. One row stands for all. */
static void gather(struct matrix const *matrix, size_t size, size_t from, size_t n, double *to)
{
    double const *columns[PW85_COLUMNS];
    if (matrix->rows == 1) {
        for (size_t k = 0; k < n * size; ++k) to[k] = matrix->numbers[k % size];
        return;
    }
    for (size_t j = 0; j < size; ++j) columns[j] = matrix->numbers + j * matrix->rows + from;
    pw85_rows_of_columns(columns, size, n, to);
}

/* Writes the results of a block to the matrices of the user. */
static void scatter(struct pw85_function const *function, void *const *out, size_t from, size_t n,
                    int count, mxArray **results)
{
    for (int k = 0; k < count; ++k) {
        size_t const size = (size_t)function->sizes[k], rows = (size_t)mxGetM(results[k]);
        if (function->is_truth) {
            unsigned char const *const bytes = out[k];
            mxLogical *const to = mxGetLogicals(results[k]) + from;
            for (size_t i = 0; i < n; ++i) to[i] = bytes[i] == 1;
            continue;
        }
        double *columns[PW85_COLUMNS];
        for (size_t j = 0; j < size; ++j) columns[j] = mxGetPr(results[k]) + j * rows + from;
        pw85_columns_of_rows(out[k], size, n, columns);
    }
}

static void compute(struct call const *call, size_t rows, int count, mxArray **results)
{
    static double pool[BLOCK * PW85_COLUMNS];
    struct pw85_function const *const function = call->function;
    double *in[PW85_INPUTS], *next = pool;
    void *out[PW85_OUTPUTS];
    for (int k = 0; k < function->num_inputs; next += BLOCK * function->inputs[k++].size)
        in[k] = next;
    for (int k = 0; k < function->num_outputs; next += BLOCK * function->sizes[k++]) out[k] = next;
    for (size_t from = 0; from < rows; from += BLOCK) {
        size_t const n = rows - from < BLOCK ? rows - from : BLOCK;
        size_t bad = 0;
        for (int k = 0; k < function->num_inputs; ++k)
            if (from == 0 || call->inputs[k].rows != 1)
                gather(&call->inputs[k], (size_t)function->inputs[k].size, from, n, in[k]);
        int const status = function->call(n, (double const *const *)in, out, &bad);
        if (status != 0) refuse_block(call, status, from + bad);
        scatter(function, out, from, n, count, results);
    }
}

static int order(void const *name, void const *question)
{
    return strcmp(name, ((struct pw85_question const *)question)->name);
}

static void answer(struct pw85_question const *question, int nlhs, mxArray **results, int count,
                   mxArray const *const *given)
{
    struct call call = {question, NULL, false, {{NULL, 0, NULL}}};
    choose_function(&call, count, given);
    check_count(&call, count);
    if (call.is_of_rows)
        read_rows(&call, count, given);
    else
        read_inputs(&call, count, given);
    struct pw85_function const *const function = call.function;
    size_t const rows = common_rows(call.inputs, function->num_inputs);
    int const wanted = nlhs < 1 ? 1 : nlhs < function->num_outputs ? nlhs : function->num_outputs;
    for (int k = 0; k < wanted; ++k)
        results[k] = function->is_truth
                         ? mxCreateLogicalMatrix((mwSize)rows, 1)
                         : mxCreateDoubleMatrix((mwSize)rows, (mwSize)function->sizes[k], mxREAL);
    compute(&call, rows, wanted, results);
}

static mxArray *new_matrix(struct matrix const *matrix, int columns)
{
    mxArray *const made = mxCreateDoubleMatrix((mwSize)matrix->rows, (mwSize)columns, mxREAL);
    if (matrix->rows > 0)
        memcpy(mxGetPr(made), matrix->numbers, matrix->rows * (size_t)columns * sizeof(double));
    return made;
}

/* Dimension of rows of matGeom, or 0. */
static int dimension_of_rows(mxArray const *given)
{
    return width(given, 9) == 9 ? 3 : width(given, 5) == 5 ? 2 : 0;
}

/* [r, q] = from_matgeom (x) */
static void from_matgeom(int nlhs, mxArray **results, int count, mxArray const *const *given)
{
    if (count != 1) refuse("pw85:arguments", NULL, -1, "takes one argument, not %d", count);
    check_class(given[0], "x");
    int const d = dimension_of_rows(given[0]);
    if (d == 0)
        refuse("pw85:size", "x", -1, "must have 9 columns (ellipsoids) or 5 (ellipses), not %ld",
               (long)mxGetN(given[0]));
    struct matrix const rows = read_matrix(given[0], "x", d == 2 ? 5 : 9),
                        forms = forms_of(&rows, d);
    results[0] = new_matrix(&rows, d); /* the first d columns */
    if (nlhs > 1) results[1] = new_matrix(&forms, 3 * d - 3);
}

/* The tolerance, which is the last argument if it is given. */
static double tolerance_of(int count, mxArray const *const *given, int place)
{
    if (count <= place) return 1e-6;
    struct matrix const tolerance = read_matrix(given[place], "tolerance", 1);
    if (tolerance.rows != 1 || !isfinite(*tolerance.numbers) || *tolerance.numbers <= 0)
        refuse("pw85:value", "tolerance", -1, "must be one positive number");
    return *tolerance.numbers;
}

static void check_finite(struct matrix const *matrix, size_t columns)
{
    for (size_t k = 0; k < matrix->rows * columns; ++k)
        if (!isfinite(matrix->numbers[k]))
            refuse("pw85:value", matrix->name, (long)(k % matrix->rows), "must be finite");
}

/* [center, q, excess] of the smallest ellipsoid around points, or around ellipsoids with forms. */
static void enclose(int nlhs, mxArray **results, struct matrix const *centers,
                    struct matrix const *forms, int d, double tolerance)
{
    size_t const packed = (size_t)d * ((size_t)d + 1) / 2, n = centers->rows;
    double const *const r = transposed(centers->numbers, n, (size_t)d);
    double center[16], q[136], excess;
    int const status =
        forms ? pw85_enclosing_ellipsoid_of(d, n, r, transposed(forms->numbers, n, packed),
                                            tolerance, center, q, &excess)
              : pw85_enclosing_ellipsoid(d, n, r, tolerance, center, q, &excess);
    if (status == PW85_EINVAL && !forms && n <= (size_t)d)
        refuse("pw85:value", "points", -1, "must have more rows than columns");
    if (status == PW85_ENOTPD && !forms)
        refuse("pw85:value", "points", -1, "must not be in a plane or nearly so");
    if (status != PW85_SUCCESS && status != PW85_ECONVERGENCE)
        refuse("pw85:value", forms ? forms->name : "points", -1, "%s", pw85_strerror(status));
    struct matrix const made[3] = {{NULL, 1, center}, {NULL, 1, q}, {NULL, 1, &excess}};
    int const columns[3] = {d, (int)packed, 1};
    for (int k = 0; k < 3 && (k == 0 || k < nlhs); ++k)
        results[k] = new_matrix(&made[k], columns[k]);
}

/* enclosing_ellipsoid (points [, tolerance]) */
static void enclose_points(int nlhs, mxArray **results, int count, mxArray const *const *given)
{
    if (count < 1 || count > 2)
        refuse("pw85:arguments", NULL, -1, "takes one or two arguments, not %d", count);
    check_class(given[0], "points");
    size_t const d = mxGetN(given[0]);
    if (d < 1 || d > 16)
        refuse("pw85:size", "points", -1, "must have 1 to 16 columns, not %ld", (long)d);
    struct matrix const points = {"points", mxGetM(given[0]), doubles_of(given[0])};
    check_finite(&points, d);
    enclose(nlhs, results, &points, NULL, (int)d, tolerance_of(count, given, 1));
}

/* Refuses the first form that is not one. */
static void check_forms(struct matrix const *forms, int d)
{
    for (size_t i = 0; i < forms->rows; ++i) {
        double q[6], moments[6];
        for (int j = 0; j < 3 * d - 3; ++j) q[j] = forms->numbers[(size_t)j * forms->rows + i];
        int const status =
            d == 2 ? pw85_second_moments_2d(q, moments) : pw85_second_moments(q, moments);
        if (status != 0) refuse_row(forms->name, (long)i, status);
    }
}

/* enclosing_ellipsoid_of (r, q [, tolerance]) or (x [, tolerance]) */
static void enclose_ellipsoids(int nlhs, mxArray **results, int count, mxArray const *const *given)
{
    if (count < 1 || count > 3)
        refuse("pw85:arguments", NULL, -1, "takes one to three arguments, not %d", count);
    check_class(given[0], "r or x");
    int const of_rows = dimension_of_rows(given[0]), others = of_rows ? 1 : 2;
    int const d = of_rows ? of_rows : width(given[0], 2) == 2 ? 2 : 3;
    struct matrix const centers = read_matrix(given[0], of_rows ? "x" : "r",
                                              of_rows == 0 ? (size_t)d
                                              : d == 2     ? 5
                                                           : 9);
    if (count < others) refuse("pw85:arguments", "q", -1, "is missing");
    if (count > others + 1)
        refuse("pw85:arguments", NULL, -1, "takes %d arguments, not %d", others + 1, count);
    if (centers.rows == 0) refuse("pw85:size", centers.name, -1, "must have at least one row");
    struct matrix const forms =
        of_rows ? forms_of(&centers, d) : read_matrix(given[1], "q", (size_t)(3 * d - 3));
    if (forms.rows != centers.rows)
        refuse("pw85:size", "q", -1, "has %ld rows, and r has %ld", (long)forms.rows,
               (long)centers.rows);
    check_finite(&centers, (size_t)d);
    check_forms(&forms, d);
    enclose(nlhs, results, &centers, &forms, d, tolerance_of(count, given, others));
}

/* was = reproducible ([on]) */
static void reproducible(int nlhs, mxArray **results, int count, mxArray const *const *given)
{
    (void)nlhs;
    int is_on = 0;
    pw85_is_reproducible(&is_on);
    if (count > 1 || (count == 1 && (mxGetNumberOfElements(given[0]) != 1 ||
                                     !(mxIsLogical(given[0]) || mxIsNumeric(given[0])))))
        refuse("pw85:value", "on", -1, "must be true or false");
    if (count == 1) pw85_set_reproducible(mxGetScalar(given[0]) != 0);
    results[0] = mxCreateLogicalScalar(is_on == 1);
}

static void version(int nlhs, mxArray **results, int count, mxArray const *const *given)
{
    (void)nlhs;
    (void)given;
    if (count != 0) refuse("pw85:arguments", NULL, -1, "takes no argument");
    results[0] = mxCreateString(pw85_version());
}

static struct {
    char const *name;
    void (*call)(int nlhs, mxArray **results, int count, mxArray const *const *given);
} const others[] = {
    {"from_matgeom", from_matgeom},
    {"enclosing_ellipsoid", enclose_points},
    {"enclosing_ellipsoid_of", enclose_ellipsoids},
    {"reproducible", reproducible},
    {"version", version},
};

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, mxArray const *prhs[])
{
    strcpy(function_name, "mex");
    if (nrhs < 1 || !mxIsChar(prhs[0]) || mxGetString(prhs[0], function_name, MOST_NAME) != 0) {
        strcpy(function_name, "mex");
        refuse("pw85:arguments", NULL, -1, "the first argument must be the name of a function");
    }
    struct pw85_question const *const question =
        bsearch(function_name, pw85_questions, pw85_num_questions, sizeof *pw85_questions, order);
    if (question) {
        answer(question, nlhs, plhs, nrhs - 1, prhs + 1);
        return;
    }
    for (size_t k = 0; k < sizeof others / sizeof *others; ++k)
        if (strcmp(function_name, others[k].name) == 0) {
            others[k].call(nlhs, plhs, nrhs - 1, prhs + 1);
            return;
        }
    refuse("pw85:arguments", NULL, -1, "there is no function of this name");
}
