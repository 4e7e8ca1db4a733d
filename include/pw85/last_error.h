/* SPDX-License-Identifier: BSD-3-Clause */
/** @file last_error.h
 * @brief The cause of an error: the argument, the row, and the requirement that the argument does
 * not meet. pw85.h includes this header.
 */
#ifndef PW85_LAST_ERROR_H_INCLUDED
#define PW85_LAST_ERROR_H_INCLUDED

#include <stddef.h>

#include <pw85/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The cause of an error, that is, of a call that returned a status other than #PW85_SUCCESS. The
 * library owns all strings, which are constants.
 *
 * If the cause is one argument, `function`, `argument` and `requirement` make a sentence, such as
 * "pw85_contact: q2 must be positive definite". Otherwise `requirement` is a sentence by itself,
 * such as "the iterations did not converge". */
typedef struct pw85_error {
    /** Status that the function returned. */
    int status;
    /** Name of the function; null if there is no error to report. For a bad row of a batch
     * function, this is the function for one row, such as "pw85_distance_box" after
     * pw85_distance_box_batch(). For a bad pair of a pair list, it is the function for one pair,
     * such as "pw85_contact" after pw85_contact_pairs(). */
    char const *function;
    /** Name of the argument in the declaration of the function, or of the member of a struct; null
     * if the cause is not one argument. For a pair of a pair list, the names are r12, q1 and q2:
     * the library computes these from the centres and forms of the two particles. */
    char const *argument;
    /** The requirement that is not met, such as "must be positive definite"; a sentence or the text
     * of the status if the cause is not one argument. */
    char const *requirement;
    /** Index of the row of the arrays, or of the pair of a list, from 0; also 0 if the cause is not
     * one row, such as a null pointer. */
    size_t row;
    /** Index of the entry in the row, from 0; also 0 if the cause is not one entry. */
    size_t entry;
    /** Value of this entry. It is NaN if the entry is NaN, or if the cause is not one entry, such
     * as a null pointer or a form that is not positive definite. A program prints the value unless
     * it is NaN. */
    double value;
} pw85_error;

/** Returns the cause of the last error in the calling thread, and clears the record: a second call
 * returns no cause.
 *
 * Call this function in the same thread, directly after a function has returned a status other than
 * success. After a batch function, the cause is that of the first bad row. A call that succeeds
 * does not change the record, and takes no extra time. `argument` is `simulation` or `system` if
 * the object or the system as a whole does not allow the call. The functions of the libraries
 * pw85_gpu and pw85_legacy keep no record: after them `function` is null, unless an earlier error
 * has not been read.
 *
 * @param[out] error the cause; `function` is null and `status` is #PW85_SUCCESS if there is none
 * @return #PW85_SUCCESS, or #PW85_EINVAL if `error` is null */
PW85_API int pw85_last_error(pw85_error *error);

#ifdef __cplusplus
}
#endif

#endif
