/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_any_dimension.h
 * @brief Two ellipsoids in n dimensions, 1 <= n <= 16, in C.
 *
 * A vector has n numbers. A form has n (n + 1)/2 numbers: the rows of the upper triangle, one after
 * the other. For n = 3 the order is (xx, xy, xz, yy, yz, zz). The conventions are those of pw85.h,
 * with these exceptions:
 *
 * - The test whether a form is positive definite is exact, without limits. Functions that compute a
 *   factor or a distance have a limit: if semi-axes, or widths along coordinates, differ by a
 *   factor above 2⁴⁰⁰, the status is #PW85_ECONVERGENCE.
 * - For nearly singular forms and ties (pairs that only integers can decide) the functions may
 *   allocate memory, and free it. If there is not enough memory, the status is #PW85_ENOMEM.
 * - #PW85_EINVAL also means that n is not in 1 … 16.
 */
#ifndef PW85_ANY_DIMENSION_H_INCLUDED
#define PW85_ANY_DIMENSION_H_INCLUDED

#include <stddef.h>

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The largest number of dimensions. */
#define PW85_ND_MAX 16

/** @name One pair
 * @{ */

/** Computes the contact function of two ellipsoids in n dimensions.
 *
 * The relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the condition number cond as for
 * pw85_condition(), with sums over n coordinates. For n = 2 and 3 the results agree with those of
 * pw85_contact_2d() and pw85_contact() within the error bounds.
 *
 * @param n [1..16] number of dimensions
 * @param r12 [n; length] vector from the centre of ellipsoid 1 to that of ellipsoid 2
 * @param q1,q2 [n(n+1)/2; length²; definite] the forms
 * @param[out] out [members mu2, lambda] μ², and the maximiser λ
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM, or #PW85_ECONVERGENCE if a form
 *        is too close to singular for numbers of 384 binary digits */
PW85_API int pw85_nd_contact(int n, double const *r12, double const *q1, double const *q2,
                             double out[2]);

/** Computes the point at which the ellipsoids, scaled by μ, touch, their common normal, and the
 * derivatives of μ², in n dimensions.
 *
 * The derivatives follow from the envelope theorem, without another linear system. Derivatives with
 * respect to a form are those with respect to its stored entries. A stored off-diagonal entry is
 * two entries of the matrix.
 *
 * @param n,q1,q2 [as pw85_nd_contact()]
 * @param r12 [n; length; != 0] vector from the centre of ellipsoid 1 to that of ellipsoid 2
 * @param lambda [0..1] from pw85_nd_contact()
 * @param[out] point [n; length; optional] relative to the centre of ellipsoid 1
 * @param[out] normal [n; optional] unit vector, outward from ellipsoid 1
 * @param[out] d_r12 [n; 1/length; optional] ∂μ²/∂r12
 * @param[out] d_q1,d_q2 [n(n+1)/2; 1/length²; optional] derivatives with respect to the entries of
 *        q1 and q2
 * @return as pw85_nd_contact() */
PW85_API int pw85_nd_contact_geometry(int n, double const *r12, double const *q1, double const *q2,
                                      double lambda, double *point, double *normal, double *d_r12,
                                      double *d_q1, double *d_q2);

/** Tests whether two ellipsoids in n dimensions overlap. Ellipsoids that touch do not overlap. The
 * answer is exact for the numbers given.
 *
 * Floating-point arithmetic decides if it can prove the answer. Otherwise, in a tie, integers of
 * many digits decide. If the entries of the forms have similar sizes, a tie takes up to 0.2 ms (n =
 * 4) or 0.1 s (n = 16). The time grows with the square of the range of the exponents of the
 * entries, after each axis is scaled to length one: a tie with entries from 1e-300 to 1 takes 15 ms
 * (n = 4) or 50 s (n = 16).
 *
 * @param n,r12,q1,q2 [as pw85_nd_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM */
PW85_API int pw85_nd_overlap(int n, double const *r12, double const *q1, double const *q2,
                             int *overlap);

/** Compares μ² with a number mu2 in n dimensions, and returns the sign of μ² - mu2. The sign is
 * exact for the numbers given; see pw85_nd_overlap().
 *
 * @param n,r12,q1,q2 [as pw85_nd_contact()]
 * @param mu2 [>= 0; or infinite] the number to compare with
 * @param[out] sign [2 on error] -1, 0 or 1
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM */
PW85_API int pw85_nd_compare(int n, double const *r12, double const *q1, double const *q2,
                             double mu2, int *sign);

/** Tests whether ellipsoid 2 is inside ellipsoid 1 in n dimensions. An ellipsoid 2 that touches the
 * surface from inside counts as inside. The answer is exact for the numbers given. Every ellipsoid
 * contains itself.
 *
 * Floating-point arithmetic decides if it can prove the answer. Otherwise, in a tie, integers of
 * many digits decide. If the entries of the forms have similar sizes, a tie takes up to 1 ms (n =
 * 4) or 0.1 s (n = 16). The time grows with the range of the exponents, as for pw85_nd_overlap().
 *
 * @param n,r12,q1,q2 [as pw85_nd_contact()]
 * @param[out] contains [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM */
PW85_API int pw85_nd_contains(int n, double const *r12, double const *q1, double const *q2,
                              int *contains);

/** Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
 * ellipsoid 2 in n dimensions, and a point where the two then touch.
 *
 * The relative error of the square is below (2n + 20) u c, with u = 2⁻⁵³ and c as for
 * pw85_containment(), with sums over n coordinates. A lower and an upper bound prove the result.
 *
 * @param n,r12,q1,q2 [as pw85_nd_contact()]
 * @param[out] mu2 [optional] square of the factor, at most 1 if ellipsoid 2 is inside
 * @param[out] point [n; length; optional] a point of contact on the surface of ellipsoid 2,
 *        relative to the centre of ellipsoid 1; one of them if there are several, as for
 *        pw85_containment()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM, or #PW85_ECONVERGENCE if
 *        semi-axes differ by a factor above 2⁴⁰⁰ */
PW85_API int pw85_nd_containment(int n, double const *r12, double const *q1, double const *q2,
                                 double *mu2, double *point);

/** Computes the distance of the surfaces of two ellipsoids in n dimensions, the points where they
 * are closest, and the common normal there.
 *
 * The error of the distance is below 4 u Σ, with u = 2⁻⁵³ and Σ as for pw85_distance(), with sums
 * over n coordinates. Two bounds prove it. The lower bound is the width of the slab between the
 * ellipsoids that is perpendicular to `normal`; it is `distance` up to rounding. The upper bound is
 * the distance between the points. The vector point2 - point1 differs from `distance` times
 * `normal` by less than 2¹⁸ u |r12|, plus the rounding errors u |point1| and u |point2|.
 *
 * @param n,r12,q1,q2 [as pw85_nd_contact()]
 * @param[out] distance [length; optional] the distance; zero if the ellipsoids overlap, as
 *        pw85_nd_overlap() decides
 * @param[out] point1,point2 [n; length; optional] the closest points of ellipsoids 1 and 2, both
 *        relative to the centre of ellipsoid 1; NaN if the ellipsoids overlap, also on success
 * @param[out] normal [n; optional] unit vector, outward from ellipsoid 1: the derivative of the
 *        distance with respect to r12; NaN if the ellipsoids overlap, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM, or #PW85_ECONVERGENCE if
 *        half-widths along coordinates are below 2⁻⁴⁰⁰ or above 2⁵⁰⁰ times the largest coordinate
 *        of r12, or if the pair is too close to singular for numbers of 384 binary digits (never
 *        seen)
 */
PW85_API int pw85_nd_distance(int n, double const *r12, double const *q1, double const *q2,
                              double *distance, double *point1, double *point2, double *normal);

/** @}
 * @name Many pairs
 *
 * All pairs have the same n, which is checked even if there are no pairs. A pair has a row of n
 * numbers in r12 and rows of n (n + 1)/2 numbers in q1 and q2. The results of a bad pair are NaN,
 * or 255 for a yes-or-no answer. The functions still compute the other pairs, and return the status
 * of the first bad pair. They run in the calling thread.
 * @{ */

/** Computes pw85_nd_contact() for many pairs, with bitwise equal results.
 *
 * @param num_pairs [number of pairs]
 * @param n [1..16] number of dimensions
 * @param r12 [num_pairs×n; length] as for pw85_nd_contact()
 * @param q1,q2 [num_pairs×n(n+1)/2; length²; definite] as for pw85_nd_contact()
 * @param[out] mu2 [num_pairs]
 * @param[out] lambda [num_pairs; optional]
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_contact_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, double *mu2, double *lambda);

/** Computes pw85_nd_contact_geometry() for many pairs, with bitwise equal results.
 *
 * @param num_pairs [number of pairs]
 * @param n,q1,q2 [as pw85_nd_contact_batch()]
 * @param r12 [num_pairs×n; length; != 0] as for pw85_nd_contact()
 * @param lambda [num_pairs; 0..1] from pw85_nd_contact_batch()
 * @param[out] point [num_pairs×n; length; optional] as for pw85_nd_contact_geometry()
 * @param[out] normal [num_pairs×n; optional] as for pw85_nd_contact_geometry()
 * @param[out] d_r12 [num_pairs×n; 1/length; optional] as for pw85_nd_contact_geometry()
 * @param[out] d_q1,d_q2 [num_pairs×n(n+1)/2; 1/length²; optional] as for pw85_nd_contact_geometry()
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_contact_geometry_batch(size_t num_pairs, int n, double const *r12,
                                            double const *q1, double const *q2,
                                            double const *lambda, double *point, double *normal,
                                            double *d_r12, double *d_q1, double *d_q2);

/** Computes pw85_nd_overlap() for many pairs.
 *
 * @param num_pairs [number of pairs]
 * @param n,r12,q1,q2 [as pw85_nd_contact_batch()]
 * @param[out] overlap [num_pairs] 1 or 0; 255 for a bad pair
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_overlap_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, unsigned char *overlap);

/** Computes pw85_nd_compare() for many pairs.
 *
 * @param num_pairs [number of pairs]
 * @param n,r12,q1,q2 [as pw85_nd_contact_batch()]
 * @param mu2 [num_pairs; >= 0; or infinite] as for pw85_nd_compare()
 * @param[out] sign [num_pairs] -1, 0 or 1; 2 for a bad pair
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_compare_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, double const *mu2, int *sign);

/** Computes pw85_nd_contains() for many pairs.
 *
 * @param num_pairs [number of pairs]
 * @param n,r12,q1,q2 [as pw85_nd_contact_batch()]
 * @param[out] contains [num_pairs] 1 or 0; 255 for a bad pair
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_contains_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                    double const *q2, unsigned char *contains);

/** Computes pw85_nd_containment() for many pairs, with bitwise equal results.
 *
 * @param num_pairs [number of pairs]
 * @param n,r12,q1,q2 [as pw85_nd_contact_batch()]
 * @param[out] mu2 [num_pairs; optional] as for pw85_nd_containment()
 * @param[out] point [num_pairs×n; length; optional] as for pw85_nd_containment()
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_containment_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                       double const *q2, double *mu2, double *point);

/** Computes pw85_nd_distance() for many pairs, with bitwise equal results.
 *
 * @param num_pairs [number of pairs]
 * @param n,r12,q1,q2 [as pw85_nd_contact_batch()]
 * @param[out] distance [num_pairs; length; optional] as for pw85_nd_distance()
 * @param[out] point1,point2 [num_pairs×n; length; optional] as for pw85_nd_distance()
 * @param[out] normal [num_pairs×n; optional] as for pw85_nd_distance()
 * @return #PW85_SUCCESS, or the status of the first bad pair */
PW85_API int pw85_nd_distance_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                    double const *q2, double *distance, double *point1,
                                    double *point2, double *normal);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
