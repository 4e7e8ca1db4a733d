/* SPDX-License-Identifier: BSD-3-Clause */
/** @file last_error.h
 * @brief The cause of a refusal: which argument, which row, and what it must be. pw85.h includes
 * it. */
#ifndef PW85_LAST_ERROR_H_INCLUDED
#define PW85_LAST_ERROR_H_INCLUDED

#include <stddef.h>

#include <pw85/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The cause of a refusal, a call that returned a status other than #PW85_SUCCESS because of an
 * argument. With these members a program writes a sentence such as "pw85_contact: q2 must be
 * positive definite". Where `argument` is null, `requirement` is a whole clause. All texts are
 * constants of the library. */
typedef struct {
    /** Status that the function returned. */
    int status;
    /** Name of the function; null if there is no refusal. For a function of many rows this is the
     * name of the function of one row: a bad row of pw85_distance_box_batch() gives
     * pw85_distance_box. */
    char const *function;
    /** Name of the argument in the declaration of the function; null if the cause is not one
     * argument. */
    char const *argument;
    /** What is required, as "must be positive definite"; a sentence or the text of the status if the
     * cause is not one argument. */
    char const *requirement;
    /** Row of the arrays, from 0; 0 for functions of one row. */
    size_t row;
    /** Entry of the row, from 0; 0 if the cause is not one entry. */
    size_t entry;
    /** The entry; the first entry of the argument if the cause is not one entry, as of a form that
     * is not positive definite; NaN for a null pointer. */
    double value;
} pw85_error;

/** Returns the cause of the last refusal in the calling thread, and clears the record, so that a
 * second call returns none.
 *
 * Call it directly after a function of one row, of many rows or of pair lists has returned a status
 * other than success, in the same thread. For many rows it tells of the first bad row. For pair
 * lists `row` is the number of the pair, and r12, q1 and q2 are those of the centres and forms of
 * its particles. Success does not change what it tells, and costs no time. `argument` is
 * `simulation` or `system` if the object or the system as a whole does not allow the call. The
 * functions of ellipsoids around points and those of the other libraries tell nothing; `function`
 * is null then, unless an earlier refusal has not been read.
 *
 * @param[out] error the cause; `function` is null and `status` is #PW85_SUCCESS if there is none
 * @return #PW85_SUCCESS or #PW85_EINVAL, if `error` is null */
PW85_API int pw85_last_error(pw85_error *error);

#ifdef __cplusplus
}
#endif

#endif
