/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions that R calls: the made questions, and these. */
#include "pw85_r.h"

#include <math.h>
#include <pthread.h>

int pw85_num_threads = 1;

#if defined _OPENMP
#include <omp.h>

int pw85_thread(void) { return omp_get_thread_num(); }
#else
int pw85_thread(void) { return 0; }
#endif

/* Threads do not survive a fork, as that of parallel::mclapply(). */
static void use_one_thread(void) { pw85_num_threads = 1; }

/* Ends the call with the cause for which an ellipsoid around points or ellipsoids is refused. */
static void refuse_enclosing(int status, char const *argument, int dimensions, R_xlen_t rows,
                             bool of_points)
{
    if (status == PW85_EINVAL && of_points && rows <= dimensions)
        pw85_refuse(argument, -1, NULL, "must have more rows than columns");
    if (status == PW85_ENOTPD)
        pw85_refuse(argument, -1, NULL,
                    of_points ? "must not be in a plane or nearly so"
                              : "must be positive definite, and not too flat together");
    if (status != PW85_SUCCESS && status != PW85_ECONVERGENCE)
        pw85_refuse(argument, -1, NULL, pw85_strerror(status));
}

/* Smallest ellipsoid around points, or around ellipsoids if there are forms: center, form and
 * excess in one vector. `points` and `forms` have a column for each point or ellipsoid. */
static SEXP call_enclosing(SEXP points, SEXP forms, SEXP tolerance)
{
    int const n = Rf_nrows(points), m = Rf_ncols(points), packed = n * (n + 1) / 2;
    bool const of_points = Rf_isNull(forms);
    SEXP const result = PROTECT(Rf_allocVector(REALSXP, n + packed + 1));
    double *const to = REAL(result), accuracy = Rf_asReal(tolerance);
    int const status =
        of_points ? pw85_enclosing_ellipsoid(n, (size_t)m, REAL_RO(points), accuracy, to, to + n,
                                             to + n + packed)
                  : pw85_enclosing_ellipsoid_of(n, (size_t)m, REAL_RO(points), REAL_RO(forms),
                                                accuracy, to, to + n, to + n + packed);
    refuse_enclosing(status, of_points ? "points" : "x", n, m, of_points);
    UNPROTECT(1);
    return result;
}

static SEXP call_reproducible(SEXP on)
{
    int is_on = 0;
    pw85_is_reproducible(&is_on);
    if (!Rf_isNull(on)) pw85_set_reproducible(Rf_asLogical(on) == TRUE);
    return Rf_ScalarLogical(is_on);
}

/* Sets the number of threads, if it is given and R was built with OpenMP. Returns that before. */
static SEXP call_threads(SEXP number)
{
    int const before = pw85_num_threads;
    (void)number;
#if defined _OPENMP
    if (!Rf_isNull(number)) pw85_num_threads = Rf_asInteger(number);
#endif
    return Rf_ScalarInteger(before);
}

static SEXP call_version(void) { return Rf_mkString(pw85_version()); }

/* A routine as R stores it. GCC warns of a direct cast to DL_FUNC. */
#define ROUTINE(function) ((DL_FUNC)(void (*)(void))(function))

void R_init_pw85(DllInfo *info)
{
    static R_CallMethodDef const methods[] = {
        {"enclosing", ROUTINE(call_enclosing), 3},
        {"reproducible", ROUTINE(call_reproducible), 1},
        {"threads", ROUTINE(call_threads), 1},
        {"version", ROUTINE(call_version), 0},
        {NULL, NULL, 0},
    };
    static R_ExternalMethodDef const externals[] = {
        {"ask", ROUTINE(pw85_ask), -1},
        {NULL, NULL, 0},
    };
    pthread_atfork(NULL, NULL, use_one_thread);
    R_registerRoutines(info, NULL, methods, NULL, externals);
    R_useDynamicSymbols(info, FALSE);
    R_forceSymbols(info, TRUE);
}
