/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_legacy.h
 * @brief Superseded methods for the contact function, for reference and comparison (library
 * pw85_legacy).
 *
 * Conventions are those of pw85.h. The error of the rational form grows at least as the square of
 * the aspect ratio: see the chapter on the implementation.
 */
#ifndef PW85_LEGACY_H_INCLUDED
#define PW85_LEGACY_H_INCLUDED

/* As pw85.h of version 1.0 did: programs for it need not include these themselves. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Computes the determinant of a symmetric matrix.
 *
 * @param a the matrix
 * @return det A */
PW85_API double pw85_legacy__det_sym(double const a[6]);

/** Computes the quadratic form of the adjugate (the transpose of the matrix of cofactors).
 *
 * @param x vector
 * @param a symmetric matrix
 * @return xᵀ adj(A) x */
PW85_API double pw85_legacy__xT_adjA_x(double const x[3], double const a[6]);

/** Computes the coefficients of det[(1-λ) Q1 + λ Q2] in increasing powers of λ.
 *
 * @param q1,q2 forms of the ellipsoids
 * @param q3 2 Q1 - Q2, the value of (1-λ) Q1 + λ Q2 at λ = -1
 * @param q4 (Q1 + Q2)/2, its value at λ = 1/2
 * @param[out] b b[0] + b[1] λ + b[2] λ² + b[3] λ³ */
PW85_API void pw85_legacy__detQ_as_poly(double const q1[6], double const q2[6], double const q3[6],
                                        double const q4[6], double b[4]);

/** Computes the coefficients of rᵀ adj[(1-λ) Q1 + λ Q2] r in increasing powers of λ.
 *
 * @param r vector
 * @param q1,q2 forms of the ellipsoids
 * @param q3 2 Q1 - Q2, the value of (1-λ) Q1 + λ Q2 at λ = -1
 * @param[out] a a[0] + a[1] λ + a[2] λ² */
PW85_API void pw85_legacy__rT_adjQ_r_as_poly(double const r[3], double const q1[6],
                                             double const q2[6], double const q3[6], double a[3]);

/** Computes f(λ) and its derivatives by factorisation.
 *
 * @param lambda in [0, 1]
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [3; optional] f, f', f''
 * @return [NaN on error] f(λ); NaN for invalid input */
PW85_API double pw85_legacy_f1(double lambda, double const r12[3], double const q1[6],
                               double const q2[6], double *out);

/** Computes f(λ) as a rational function of λ.
 *
 * @param lambda,r12,q1,q2 [as pw85_legacy_f1()]
 * @param[out] out [1; optional] f
 * @return [NaN on error] f(λ); NaN for invalid input */
PW85_API double pw85_legacy_f2(double lambda, double const r12[3], double const q1[6],
                               double const q2[6], double *out);

/** Computes f(λ) and its derivatives as a rational function of λ.
 *
 * @param lambda,r12,q1,q2 [as pw85_legacy_f1()]
 * @param[out] out [NaN on error] (f, f', f''); NaN for invalid input */
PW85_API void pw85_legacy_f2_derivatives(double lambda, double const r12[3], double const q1[6],
                                         double const q2[6], double out[3]);

/** Computes the contact function by plain Newton-Raphson iterations on f' from λ = 1/2, which often
 * fail.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the iterations leave [0,
 *        1] or do not converge) */
PW85_API int pw85_legacy_contact_function1(double const r12[3], double const q1[6],
                                           double const q2[6], double out[2]);

/** Computes the contact function by bisection on the numerator of f' in rational form. Statuses are
 * as for pw85_contact(). The result is less accurate than that of pw85_contact(): see the top of
 * this header.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()] */
PW85_API int pw85_legacy_contact_function2(double const r12[3], double const q1[6],
                                           double const q2[6], double out[2]);

#ifdef __cplusplus
}
#endif

#endif
