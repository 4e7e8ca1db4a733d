/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_pre1.h
 * @brief Header for programs that were written for the API before pw85 1.0.
 *
 * Include it instead of pw85.h, and link with pw85 and pw85_legacy. It brings back
 *
 * - `double pw85_contact_function(r12, q1, q2, out)`: returns μ², and writes (μ², λ) to `out`
 *   unless that is null. Both are NaN if pw85_contact_function() of pw85.h fails, because there was
 *   no status then;
 * - `pw85__det_sym`, `pw85__xT_adjA_x`, `pw85__detQ_as_poly` and `pw85__rT_adjQ_r_as_poly`, now in
 *   pw85_legacy.h.
 *
 * These are other names for the functions of pw85.h and pw85_legacy.h. In a source file that
 * includes this header, pw85_contact_function is the old function, whatever the order of the
 * includes. There the new one is pw85_pre1_current_contact_function.
 */
#ifndef PW85_PRE1_H_INCLUDED
#define PW85_PRE1_H_INCLUDED

#include <pw85.h>
#include <pw85_legacy.h>

/* Inline functions are not in C89, but under this name in all compilers for it. */
#if defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define PW85_PRE1_FUNCTION static inline
#else
#define PW85_PRE1_FUNCTION static __inline
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Computes the contact function as pw85_contact_function() of pw85.h, whose name this header gives
 * to the old function; contract as for pw85_contact().
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()] */
PW85_PRE1_FUNCTION int pw85_pre1_current_contact_function(double const r12[3], double const q1[6],
                                                          double const q2[6], double out[2])
{
    return pw85_contact_function(r12, q1, q2, out);
}

/** Computes the contact function with the arguments and results of versions before pw85 1.0.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [optional] (μ², λ)
 * @return [NaN on error] μ²; NaN for invalid input */
PW85_PRE1_FUNCTION double pw85_pre1_contact_function(double const r12[3], double const q1[6],
                                                     double const q2[6], double *out)
{
    double result[2];
    pw85_contact_function(r12, q1, q2, result);
    if (out) {
        out[0] = result[0];
        out[1] = result[1];
    }
    return result[0];
}

#ifdef __cplusplus
}
#endif

#define pw85_contact_function pw85_pre1_contact_function
#define pw85__det_sym pw85_legacy__det_sym
#define pw85__xT_adjA_x pw85_legacy__xT_adjA_x
#define pw85__detQ_as_poly pw85_legacy__detQ_as_poly
#define pw85__rT_adjQ_r_as_poly pw85_legacy__rT_adjQ_r_as_poly

#endif
