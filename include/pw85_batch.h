/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_batch.h
 * @brief Batch functions: the functions of pw85.h for arrays of pairs or ellipsoids.
 *
 * The conventions are those of pw85.h. The contract of a batch function states only the differences
 * from the function for one pair or ellipsoid. This header is generated from pw85.h: see
 * CONTRIBUTING.md.
 */
#ifndef PW85_BATCH_H_INCLUDED
#define PW85_BATCH_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Many pairs
 *
 * Arrays are contiguous, and row i belongs to pair i. The number of rows may be 0; pointers may
 * then be null. A pair is bad if the function for one pair would return an error, for example
 * because a number is NaN or a form is not positive definite. The results of a bad pair are NaN, or
 * 255 for overlaps. The function still computes the other pairs, and returns the status of the
 * first bad pair. If the call as a whole is invalid (a null pointer, a size that overflows, an
 * index out of range), the function returns #PW85_EINVAL and writes nothing.
 *
 * The result for a pair depends only on the pair and the instruction set, not on its position, the
 * number of pairs or the number of threads. The library uses the newest instruction set that the
 * processor supports and for which the library was compiled. The environment variable PW85_TARGET
 * selects an older one: baseline, avx2 or avx512 on x86-64; baseline, neon, sve256 or sve512 on
 * 64-bit ARM. The library reads it once. pw85_set_reproducible() makes the result independent of
 * the instruction set.
 *
 * If the library was built with OpenMP, these functions run in several threads; OMP_NUM_THREADS or
 * omp_set_num_threads() sets their number. The threads of GNU OpenMP do not survive fork(): if a
 * process calls these functions with several threads and then forks, the child must set the number
 * of threads to one before it calls them.
 * @{ */

/* Made by api/committed.py: rows of pw85.h, pw85_grains.h and pw85_shapes.h */
/* clang-format off */
/** Computes pw85_ellipsoid_quaternion() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param semi_axes [n×3; length; > 0; finite square]
 * @param quaternions [n×4; != 0]
 * @param[out] q [n×6; length²]
 * @return as for pw85_ellipsoid_quaternion(), of the first bad ellipsoid */
PW85_API int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes,
                                             double const *quaternions, double *q);

/** Computes pw85_ellipsoid_factor() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param semi_axes [n×3; length; > 0; finite square]
 * @param quaternions [n×4; != 0]
 * @param[out] s [n×3×3; length]
 * @return as for pw85_ellipsoid_factor(), of the first bad ellipsoid */
PW85_API int pw85_ellipsoid_factor_batch(size_t n, double const *semi_axes,
                                         double const *quaternions, double *s);

/** Computes pw85_contact() for n pairs. The relative error of μ² is below 4 u cond as for one pair.
 * The last bits may differ from those of pw85_contact().
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return as for pw85_contact(), of the first bad pair */
PW85_API int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                double *mu2, double *lambda);

/** Computes pw85_contact_rounded() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2,lambda [n; optional]
 * @return as for pw85_contact_rounded(), of the first bad pair */
PW85_API int pw85_contact_rounded_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, double *mu2, double *lambda);

/** Computes pw85_contact_factored() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param s1,s2 [n×3×3; length]
 * @param[out] mu2,lambda [n; optional]
 * @return as for pw85_contact_factored(), of the first bad pair */
PW85_API int pw85_contact_factored_batch(size_t n, double const *r12, double const *s1,
                                         double const *s2, double *mu2, double *lambda);

/** Computes pw85_condition() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] cond [n]
 * @return as for pw85_condition(), of the first bad pair */
PW85_API int pw85_condition_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                  double const *lambda, double *cond);

/** Computes pw85_contact_function() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2,lambda [n; optional]
 * @return as for pw85_contact_function(), of the first bad pair */
PW85_API int pw85_contact_function_batch(size_t n, double const *r12, double const *q1,
                                         double const *q2, double *mu2, double *lambda);

/** Computes pw85_contact_geometry() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length; != 0]
 * @param q1,q2 [n×6; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_contact_geometry(), of the first bad pair */
PW85_API int pw85_contact_geometry_batch(size_t n, double const *r12, double const *q1,
                                         double const *q2, double const *lambda, double *point,
                                         double *normal);

/** Computes pw85_contact_geometry_factored() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length; != 0]
 * @param s1,s2 [n×3×3; length]
 * @param lambda [n; 0..1]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_contact_geometry_factored(), of the first bad pair */
PW85_API int pw85_contact_geometry_factored_batch(size_t n, double const *r12, double const *s1,
                                                  double const *s2, double const *lambda,
                                                  double *point, double *normal);

/** Computes pw85_contact_gradient() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] d_r12 [n×3; 1/length; optional]
 * @param[out] d_q1,d_q2 [n×6; 1/length²; optional]
 * @return as for pw85_contact_gradient(), of the first bad pair */
PW85_API int pw85_contact_gradient_batch(size_t n, double const *r12, double const *q1,
                                         double const *q2, double const *lambda, double *d_r12,
                                         double *d_q1, double *d_q2);

/** Computes pw85_contact_gradient_factored() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param s1,s2 [n×3×3; length]
 * @param lambda [n; 0..1]
 * @param[out] d_r12 [n×3; 1/length; optional]
 * @param[out] d_s1,d_s2 [n×3×3; 1/length; optional]
 * @return as for pw85_contact_gradient_factored(), of the first bad pair */
PW85_API int pw85_contact_gradient_factored_batch(size_t n, double const *r12, double const *s1,
                                                  double const *s2, double const *lambda,
                                                  double *d_r12, double *d_s1, double *d_s2);

/** Computes pw85_contact_torque() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] d_rot1,d_rot2 [n×3; optional]
 * @return as for pw85_contact_torque(), of the first bad pair */
PW85_API int pw85_contact_torque_batch(size_t n, double const *r12, double const *q1,
                                       double const *q2, double const *lambda, double *d_rot1,
                                       double *d_rot2);

/** Computes pw85_contact_hessian() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length; != 0]
 * @param q1,q2 [n×6; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] hessian [n×9×9; mixed units]
 * @return as for pw85_contact_hessian(), of the first bad pair */
PW85_API int pw85_contact_hessian_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, double const *lambda, double *hessian);

/** Computes pw85_overlap() for n pairs, with the same answers.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_overlap(), of the first bad pair */
PW85_API int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                unsigned char *overlap);

/** Computes pw85_overlap_factored() for n pairs, with the same answers.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param s1,s2 [n×3×3; length]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_overlap_factored(), of the first bad pair */
PW85_API int pw85_overlap_factored_batch(size_t n, double const *r12, double const *s1,
                                         double const *s2, unsigned char *overlap);

/** Computes pw85_compare() for n pairs, with the same signs.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param mu2 [n; >= 0; or infinite]
 * @param[out] sign [n] -1, 0 or 1, or 2 for a bad pair
 * @return as for pw85_compare(), of the first bad pair */
PW85_API int pw85_compare_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                double const *mu2, int *sign);

/** Computes pw85_overlap_witness() for n pairs, with the same results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @param[out] lambda [n; optional] NaN where the ellipsoids are not apart
 * @param[out] point [n×3; length; optional] NaN where they do not overlap
 * @return as for pw85_overlap_witness(), of the first bad pair */
PW85_API int pw85_overlap_witness_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, unsigned char *overlap, double *lambda,
                                        double *point);

/** Computes pw85_contains() for n pairs, with the same answers.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] contains [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_contains(), of the first bad pair */
PW85_API int pw85_contains_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                 unsigned char *contains);

/** Computes pw85_containment() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_containment(), of the first bad pair */
PW85_API int pw85_containment_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                    double *mu2, double *point);

/** Computes pw85_closest_approach() for n pairs. The relative error is below 2 u cond + 4 u. The
 * last bits may differ from those of pw85_closest_approach().
 *
 * @param n [number of pairs]
 * @param directions [n×3; != 0]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] distance [n; length]
 * @return as for pw85_closest_approach(), of the first bad pair */
PW85_API int pw85_closest_approach_batch(size_t n, double const *directions, double const *q1,
                                         double const *q2, double *distance);

/** Computes pw85_volume() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param[out] volume [n; length³]
 * @return as for pw85_volume(), of the first bad ellipsoid */
PW85_API int pw85_volume_batch(size_t n, double const *q, double *volume);

/** Computes pw85_overlap_volume() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] volume [n; length³]
 * @return as for pw85_overlap_volume(), of the first bad pair */
PW85_API int pw85_overlap_volume_batch(size_t n, double const *r12, double const *q1,
                                       double const *q2, double *volume);

/** Computes pw85_overlap_volume_gradient() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] d_r12 [n×3; length²; optional]
 * @param[out] d_q1,d_q2 [n×6; length; optional]
 * @return as for pw85_overlap_volume_gradient(), of the first bad pair */
PW85_API int pw85_overlap_volume_gradient_batch(size_t n, double const *r12, double const *q1,
                                                double const *q2, double *d_r12, double *d_q1,
                                                double *d_q2);

/** Computes pw85_overlap_volume_torque() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] d_rot1,d_rot2 [n×3; length³; optional]
 * @return as for pw85_overlap_volume_torque(), of the first bad pair */
PW85_API int pw85_overlap_volume_torque_batch(size_t n, double const *r12, double const *q1,
                                              double const *q2, double *d_rot1, double *d_rot2);

/** Computes pw85_area_2d() for n ellipses, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param q [n×3; length²; definite]
 * @param[out] area [n; length²]
 * @return as for pw85_area_2d(), of the first bad ellipse */
PW85_API int pw85_area_batch_2d(size_t n, double const *q, double *area);

/** Computes pw85_overlap_area_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] area [n; length²]
 * @return as for pw85_overlap_area_2d(), of the first bad pair */
PW85_API int pw85_overlap_area_batch_2d(size_t n, double const *r12, double const *q1,
                                        double const *q2, double *area);

/** Computes pw85_overlap_area_gradient_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] d_r12 [n×2; length; optional]
 * @param[out] d_q1,d_q2 [n×3; no unit; optional]
 * @return as for pw85_overlap_area_gradient_2d(), of the first bad pair */
PW85_API int pw85_overlap_area_gradient_batch_2d(size_t n, double const *r12, double const *q1,
                                                 double const *q2, double *d_r12, double *d_q1,
                                                 double *d_q2);

/** Computes pw85_overlap_area_torque_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] d_rot1,d_rot2 [n; length²; optional]
 * @return as for pw85_overlap_area_torque_2d(), of the first bad pair */
PW85_API int pw85_overlap_area_torque_batch_2d(size_t n, double const *r12, double const *q1,
                                               double const *q2, double *d_rot1, double *d_rot2);

/** Computes pw85_contact_2d() for n pairs; see pw85_contact_batch().
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] mu2 [n]
 * @param[out] lambda [n; optional]
 * @return as for pw85_contact_2d(), of the first bad pair */
PW85_API int pw85_contact_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *mu2, double *lambda);

/** Computes pw85_contact_geometry_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length; != 0]
 * @param q1,q2 [n×3; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] point [n×2; length; optional]
 * @param[out] normal [n×2; optional]
 * @return as for pw85_contact_geometry_2d(), of the first bad pair */
PW85_API int pw85_contact_geometry_batch_2d(size_t n, double const *r12, double const *q1,
                                            double const *q2, double const *lambda, double *point,
                                            double *normal);

/** Computes pw85_contact_gradient_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] d_r12 [n×2; 1/length; optional]
 * @param[out] d_q1,d_q2 [n×3; 1/length²; optional]
 * @return as for pw85_contact_gradient_2d(), of the first bad pair */
PW85_API int pw85_contact_gradient_batch_2d(size_t n, double const *r12, double const *q1,
                                            double const *q2, double const *lambda, double *d_r12,
                                            double *d_q1, double *d_q2);

/** Computes pw85_contact_torque_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] d_rot1,d_rot2 [n; optional]
 * @return as for pw85_contact_torque_2d(), of the first bad pair */
PW85_API int pw85_contact_torque_batch_2d(size_t n, double const *r12, double const *q1,
                                          double const *q2, double const *lambda, double *d_rot1,
                                          double *d_rot2);

/** Computes pw85_contact_hessian_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length; != 0]
 * @param q1,q2 [n×3; length²; definite]
 * @param lambda [n; 0..1]
 * @param[out] hessian [n×4×4; mixed units]
 * @return as for pw85_contact_hessian_2d(), of the first bad pair */
PW85_API int pw85_contact_hessian_batch_2d(size_t n, double const *r12, double const *q1,
                                           double const *q2, double const *lambda, double *hessian);

/** Computes pw85_overlap_2d() for n pairs; see pw85_overlap_batch().
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad pair
 * @return as for pw85_overlap_2d(), of the first bad pair */
PW85_API int pw85_overlap_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   unsigned char *overlap);

/** Computes pw85_closest_approach_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param directions [n×2; != 0]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] distance [n; length]
 * @return as for pw85_closest_approach_2d(), of the first bad pair */
PW85_API int pw85_closest_approach_batch_2d(size_t n, double const *directions, double const *q1,
                                            double const *q2, double *distance);

/** Computes pw85_distance() for n pairs. Points of pairs that overlap are NaN.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @return as for pw85_distance(), of the first bad pair */
PW85_API int pw85_distance_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                 double *distance, double *point1, double *point2);

/** Computes pw85_distance_geometry() for n pairs. Points and normals of pairs that overlap are NaN.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_geometry(), of the first bad pair */
PW85_API int pw85_distance_geometry_batch(size_t n, double const *r12, double const *q1,
                                          double const *q2, double *distance, double *point1,
                                          double *point2, double *normal);

/** Computes pw85_distance_derivatives() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] d_r12 [n×3; optional]
 * @param[out] d_rot1,d_rot2 [n×3; length; optional]
 * @param[out] hessian [n×9×9; mixed units; optional]
 * @return as for pw85_distance_derivatives(), of the first bad pair */
PW85_API int pw85_distance_derivatives_batch(size_t n, double const *r12, double const *q1,
                                             double const *q2, double *d_r12, double *d_rot1,
                                             double *d_rot2, double *hessian);

/** Computes pw85_penetration() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] depth [n; length; optional]
 * @param[out] direction [n×3; optional]
 * @return as for pw85_penetration(), of the first bad pair */
PW85_API int pw85_penetration_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                    double *depth, double *direction);

/** Computes pw85_signed_distance() for n pairs. The errors have the same bounds. The results are
 * bitwise equal where the ellipsoids overlap; where they are apart, the last bits may differ.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @return as for pw85_signed_distance(), of the first bad pair */
PW85_API int pw85_signed_distance_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, double *distance, double *point1,
                                        double *point2);

/** Computes pw85_signed_distance_geometry() for n pairs. The errors have the same bounds. The
 * results are bitwise equal where the ellipsoids overlap; where they are apart, the last bits may
 * differ.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_signed_distance_geometry(), of the first bad pair */
PW85_API int pw85_signed_distance_geometry_batch(size_t n, double const *r12, double const *q1,
                                                 double const *q2, double *distance, double *point1,
                                                 double *point2, double *normal);

/** Computes pw85_signed_distance_derivatives() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] d_r12 [n×3; optional]
 * @param[out] d_rot1,d_rot2 [n×3; length; optional]
 * @param[out] hessian [n×9×9; mixed units; optional]
 * @return as for pw85_signed_distance_derivatives(), of the first bad pair */
PW85_API int pw85_signed_distance_derivatives_batch(size_t n, double const *r12, double const *q1,
                                                    double const *q2, double *d_r12, double *d_rot1,
                                                    double *d_rot2, double *hessian);

/** Computes pw85_gap_inside() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] gap [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_gap_inside(), of the first bad pair */
PW85_API int pw85_gap_inside_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                   double *gap, double *point1, double *point2, double *normal);

/** Computes pw85_distance_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×2; length; optional]
 * @return as for pw85_distance_2d(), of the first bad pair */
PW85_API int pw85_distance_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                    double *distance, double *point1, double *point2);

/** Computes pw85_distance_geometry_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×2; length; optional]
 * @param[out] normal [n×2; optional]
 * @return as for pw85_distance_geometry_2d(), of the first bad pair */
PW85_API int pw85_distance_geometry_batch_2d(size_t n, double const *r12, double const *q1,
                                             double const *q2, double *distance, double *point1,
                                             double *point2, double *normal);

/** Computes pw85_penetration_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] depth [n; length; optional]
 * @param[out] direction [n×2; optional]
 * @return as for pw85_penetration_2d(), of the first bad pair */
PW85_API int pw85_penetration_batch_2d(size_t n, double const *r12, double const *q1,
                                       double const *q2, double *depth, double *direction);

/** Computes pw85_signed_distance_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×2; length; optional]
 * @return as for pw85_signed_distance_2d(), of the first bad pair */
PW85_API int pw85_signed_distance_batch_2d(size_t n, double const *r12, double const *q1,
                                           double const *q2, double *distance, double *point1,
                                           double *point2);

/** Computes pw85_signed_distance_geometry_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×2; length; optional]
 * @param[out] normal [n×2; optional]
 * @return as for pw85_signed_distance_geometry_2d(), of the first bad pair */
PW85_API int pw85_signed_distance_geometry_batch_2d(size_t n, double const *r12, double const *q1,
                                                    double const *q2, double *distance,
                                                    double *point1, double *point2, double *normal);

/** Computes pw85_gap_inside_2d() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×2; length]
 * @param q1,q2 [n×3; length²; definite]
 * @param[out] gap [n; length; optional]
 * @param[out] point1,point2 [n×2; length; optional]
 * @param[out] normal [n×2; optional]
 * @return as for pw85_gap_inside_2d(), of the first bad pair */
PW85_API int pw85_gap_inside_batch_2d(size_t n, double const *r12, double const *q1,
                                      double const *q2, double *gap, double *point1, double *point2,
                                      double *normal);

/** Computes pw85_first_contact() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param motion1,motion2 [n; mixed units; > 0 until t_max]
 * @param t_max [as pw85_first_contact()] for all rows
 * @param[out] t [n; time]
 * @return as for pw85_first_contact(), of the first bad pair */
PW85_API int pw85_first_contact_batch(size_t n, double const *r12, double const *q1,
                                      double const *q2, pw85_motion const *motion1,
                                      pw85_motion const *motion2, double t_max, double *t);

/** Computes pw85_closest_passage() for n pairs. The error of μ² is below 8 u S as for one pair. The
 * last bits may differ from those of pw85_closest_passage().
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param velocity [n×3; length/time]
 * @param t_max [as pw85_closest_passage()] for all rows
 * @param[out] mu2 [n]
 * @param[out] t [n; time; optional]
 * @return as for pw85_closest_passage(), of the first bad pair */
PW85_API int pw85_closest_passage_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, double const *velocity, double t_max,
                                        double *mu2, double *t);

/** Computes pw85_free_path() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param directions [n×3; != 0]
 * @param t_max [n; length; >= 0; or infinite]
 * @param[out] t [n; length]
 * @return as for pw85_free_path(), of the first bad pair */
PW85_API int pw85_free_path_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                  double const *directions, double const *t_max, double *t);

/** Computes pw85_curvature() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param q [n×6; length²; definite]
 * @param[out] curvatures [n×2; 1/length; optional]
 * @param[out] directions [n×2×3; optional]
 * @return as for pw85_curvature(), of the first bad ellipsoid */
PW85_API int pw85_curvature_batch(size_t n, double const *normals, double const *q,
                                  double *curvatures, double *directions);

/** Computes pw85_hertz() for n contacts, with bitwise equal results.
 *
 * @param n [number of contacts]
 * @param curvatures [n×2; 1/length; > 0]
 * @param[out] radius [n; length; optional]
 * @param[out] ellipse [n×2; length; optional]
 * @return as for pw85_hertz(), of the first bad contact */
PW85_API int pw85_hertz_batch(size_t n, double const *curvatures, double *radius, double *ellipse);

/** Computes pw85_hertz_contact() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param normals [n×3; != 0]
 * @param[out] depth [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] curvatures [n×2; 1/length; optional]
 * @param[out] directions [n×2×3; optional]
 * @param[out] radius [n; length; optional]
 * @param[out] ellipse [n×2; length; optional]
 * @return as for pw85_hertz_contact(), of the first bad pair */
PW85_API int pw85_hertz_contact_batch(size_t n, double const *r12, double const *q1,
                                      double const *q2, double const *normals, double *depth,
                                      double *point, double *curvatures, double *directions,
                                      double *radius, double *ellipse);

/** Computes pw85_grain_contact() for n pairs. The errors have the same bounds. The last bits may
 * differ from those of pw85_grain_contact().
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param starts [n×3; != 0]
 * @param[out] normal [n×3; optional]
 * @param[out] depth [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] curvatures [n×2; 1/length; optional]
 * @param[out] radius [n; length; optional]
 * @return as for pw85_grain_contact(), of the first bad pair */
PW85_API int pw85_grain_contact_batch(size_t n, double const *r12, double const *q1,
                                      double const *q2, double const *starts, double *normal,
                                      double *depth, double *point, double *curvatures,
                                      double *radius);

/** Computes pw85_grain_radius_gradient() for n pairs, with bitwise equal results.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param normals [n×3; != 0]
 * @param[out] d_r12 [n×3; optional]
 * @param[out] d_rot1,d_rot2 [n×3; length; optional]
 * @return as for pw85_grain_radius_gradient(), of the first bad pair */
PW85_API int pw85_grain_radius_gradient_batch(size_t n, double const *r12, double const *q1,
                                              double const *q2, double const *normals,
                                              double *d_r12, double *d_rot1, double *d_rot2);

/** Computes pw85_grain_contact_wall() for n ellipsoids and walls, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param offsets [n; length]
 * @param directions [n×3; != 0]
 * @param curvature [n; 1/length]
 * @param q [n×6; length²; definite]
 * @param[out] depth [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] curvatures [n×2; 1/length; optional]
 * @param[out] radius [n; length; optional]
 * @return as for pw85_grain_contact_wall(), of the first bad ellipsoid */
PW85_API int pw85_grain_contact_wall_batch(size_t n, double const *normals, double const *offsets,
                                           double const *directions, double const *curvature,
                                           double const *q, double *depth, double *point,
                                           double *curvatures, double *radius);

/** Computes pw85_surface_area() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param[out] area [n; length²]
 * @return as for pw85_surface_area(), of the first bad ellipsoid */
PW85_API int pw85_surface_area_batch(size_t n, double const *q, double *area);

/** Computes pw85_second_moments() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param[out] moments [n×6; length²]
 * @return as for pw85_second_moments(), of the first bad ellipsoid */
PW85_API int pw85_second_moments_batch(size_t n, double const *q, double *moments);

/** Computes pw85_from_moments() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param second_moments [n×6; length²; definite]
 * @param[out] q [n×6; length²]
 * @return as for pw85_from_moments(), of the first bad ellipsoid */
PW85_API int pw85_from_moments_batch(size_t n, double const *second_moments, double *q);

/** Computes pw85_shell_moments() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param[out] moments [n×6; length²]
 * @return as for pw85_shell_moments(), of the first bad ellipsoid */
PW85_API int pw85_shell_moments_batch(size_t n, double const *q, double *moments);

/** Computes pw85_inertia() for n ellipsoids, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param shell [as pw85_inertia()] for all rows
 * @param[out] inertia [n×6; mixed units]
 * @return as for pw85_inertia(), of the first bad ellipsoid */
PW85_API int pw85_inertia_batch(size_t n, double const *q, int shell, double *inertia);

/** Computes pw85_perimeter_2d() for n ellipses, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param q [n×3; length²; definite]
 * @param[out] perimeter [n; length]
 * @return as for pw85_perimeter_2d(), of the first bad ellipse */
PW85_API int pw85_perimeter_batch_2d(size_t n, double const *q, double *perimeter);

/** Computes pw85_second_moments_2d() for n ellipses, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param q [n×3; length²; definite]
 * @param[out] moments [n×3; length²]
 * @return as for pw85_second_moments_2d(), of the first bad ellipse */
PW85_API int pw85_second_moments_batch_2d(size_t n, double const *q, double *moments);

/** Computes pw85_from_moments_2d() for n ellipses, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param second_moments [n×3; length²; definite]
 * @param[out] q [n×3; length²]
 * @return as for pw85_from_moments_2d(), of the first bad ellipse */
PW85_API int pw85_from_moments_batch_2d(size_t n, double const *second_moments, double *q);

/** Computes pw85_shell_moments_2d() for n ellipses, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param q [n×3; length²; definite]
 * @param[out] moments [n×3; length²]
 * @return as for pw85_shell_moments_2d(), of the first bad ellipse */
PW85_API int pw85_shell_moments_batch_2d(size_t n, double const *q, double *moments);

/** Computes pw85_distance_plane() for n ellipsoids and half-spaces, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param offsets [n; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_distance_plane(), of the first bad ellipsoid */
PW85_API int pw85_distance_plane_batch(size_t n, double const *normals, double const *offsets,
                                       double const *q, double *distance, double *point);

/** Computes pw85_distance_plane_derivatives() for n ellipsoids and half-spaces, with bitwise equal
 * results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param q [n×6; length²; definite]
 * @param[out] d_center [n×3; optional]
 * @param[out] d_rot [n×3; length; optional]
 * @return as for pw85_distance_plane_derivatives(), of the first bad ellipsoid */
PW85_API int pw85_distance_plane_derivatives_batch(size_t n, double const *normals, double const *q,
                                                   double *d_center, double *d_rot);

/** Computes pw85_contact_plane() for n ellipsoids and half-spaces, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param offsets [n; length]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_contact_plane(), of the first bad ellipsoid */
PW85_API int pw85_contact_plane_batch(size_t n, double const *normals, double const *offsets,
                                      double const *q, double *mu2, double *point);

/** Computes pw85_contact_plane_derivatives() for n ellipsoids and half-spaces, with bitwise equal
 * results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param offsets [n; length]
 * @param q [n×6; length²; definite]
 * @param[out] d_center [n×3; 1/length; optional]
 * @param[out] d_rot [n×3; optional]
 * @return as for pw85_contact_plane_derivatives(), of the first bad ellipsoid */
PW85_API int pw85_contact_plane_derivatives_batch(size_t n, double const *normals,
                                                  double const *offsets, double const *q,
                                                  double *d_center, double *d_rot);

/** Computes pw85_distance_box() for n ellipsoids and boxes, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param lower,upper [n×3; length; lower <= upper]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_box(), of the first bad ellipsoid */
PW85_API int pw85_distance_box_batch(size_t n, double const *lower, double const *upper,
                                     double const *q, double *distance, double *point,
                                     double *normal);

/** Computes pw85_distance_cylinder() for n ellipsoids and cylinders, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param axis [n×3; != 0]
 * @param radius [n; length; > 0]
 * @param center [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_cylinder(), of the first bad ellipsoid */
PW85_API int pw85_distance_cylinder_batch(size_t n, double const *axis, double const *radius,
                                          double const *center, double const *q, double *distance,
                                          double *point, double *normal);

/** Computes pw85_distance_point() for n points and ellipsoids, with bitwise equal results.
 *
 * @param n [number of points]
 * @param r [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_point(), of the first bad point */
PW85_API int pw85_distance_point_batch(size_t n, double const *r, double const *q, double *distance,
                                       double *point, double *normal);

/** Computes pw85_intersect_line() for n lines and ellipsoids, with bitwise equal results.
 *
 * @param n [number of lines]
 * @param origin [n×3; length]
 * @param directions [n×3; != 0]
 * @param q [n×6; length²; definite]
 * @param[out] enter,leave [n; length; optional]
 * @return as for pw85_intersect_line(), of the first bad line */
PW85_API int pw85_intersect_line_batch(size_t n, double const *origin, double const *directions,
                                       double const *q, double *enter, double *leave);

/** Computes pw85_overlap_volume_plane() for n ellipsoids and half-spaces, with bitwise equal
 * results.
 *
 * @param n [number of ellipsoids]
 * @param normals [n×3; != 0]
 * @param offsets [n; length]
 * @param q [n×6; length²; definite]
 * @param[out] volume [n; length³]
 * @return as for pw85_overlap_volume_plane(), of the first bad ellipsoid */
PW85_API int pw85_overlap_volume_plane_batch(size_t n, double const *normals, double const *offsets,
                                             double const *q, double *volume);

/** Computes pw85_contact_segment() for n ellipsoids and segments. The error has the same bound. The
 * last bits may differ.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_contact_segment(), of the first bad ellipsoid */
PW85_API int pw85_contact_segment_batch(size_t n, double const *end1, double const *end2,
                                        double const *q, double *mu2, double *point);

/** Computes pw85_contact_triangle() for n ellipsoids and triangles. The error has the same bound.
 * The last bits may differ.
 *
 * @param n [number of ellipsoids]
 * @param vertex1,vertex2,vertex3 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_contact_triangle(), of the first bad ellipsoid */
PW85_API int pw85_contact_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                         double const *vertex3, double const *q, double *mu2,
                                         double *point);

/** Computes pw85_contact_box() for n ellipsoids and boxes. The error has the same bound. The last
 * bits may differ.
 *
 * @param n [number of ellipsoids]
 * @param lower,upper [n×3; length; lower <= upper]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_contact_box(), of the first bad ellipsoid */
PW85_API int pw85_contact_box_batch(size_t n, double const *lower, double const *upper,
                                    double const *q, double *mu2, double *point);

/** Computes pw85_overlap_segment() for n ellipsoids and segments, with the same answers.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipsoid
 * @return as for pw85_overlap_segment(), of the first bad ellipsoid */
PW85_API int pw85_overlap_segment_batch(size_t n, double const *end1, double const *end2,
                                        double const *q, unsigned char *overlap);

/** Computes pw85_overlap_triangle() for n ellipsoids and triangles, with the same answers.
 *
 * @param n [number of ellipsoids]
 * @param vertex1,vertex2,vertex3 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipsoid
 * @return as for pw85_overlap_triangle(), of the first bad ellipsoid */
PW85_API int pw85_overlap_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                         double const *vertex3, double const *q,
                                         unsigned char *overlap);

/** Computes pw85_overlap_box() for n ellipsoids and boxes, with the same answers.
 *
 * @param n [number of ellipsoids]
 * @param lower,upper [n×3; length; lower <= upper]
 * @param q [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipsoid
 * @return as for pw85_overlap_box(), of the first bad ellipsoid */
PW85_API int pw85_overlap_box_batch(size_t n, double const *lower, double const *upper,
                                    double const *q, unsigned char *overlap);

/** Computes pw85_distance_segment() for n ellipsoids and segments, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_segment(), of the first bad ellipsoid */
PW85_API int pw85_distance_segment_batch(size_t n, double const *end1, double const *end2,
                                         double const *q, double *distance, double *point1,
                                         double *point2, double *normal);

/** Computes pw85_distance_triangle() for n ellipsoids and triangles, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param vertex1,vertex2,vertex3 [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_triangle(), of the first bad ellipsoid */
PW85_API int pw85_distance_triangle_batch(size_t n, double const *vertex1, double const *vertex2,
                                          double const *vertex3, double const *q, double *distance,
                                          double *point1, double *point2, double *normal);

/** Computes pw85_distance_solid_box() for n ellipsoids and boxes, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param lower,upper [n×3; length; lower <= upper]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_solid_box(), of the first bad ellipsoid */
PW85_API int pw85_distance_solid_box_batch(size_t n, double const *lower, double const *upper,
                                           double const *q, double *distance, double *point1,
                                           double *point2, double *normal);

/** Computes pw85_contact_capsule() for n ellipsoids and capsules, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param radius [n; length; >= 0]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @return as for pw85_contact_capsule(), of the first bad ellipsoid */
PW85_API int pw85_contact_capsule_batch(size_t n, double const *end1, double const *end2,
                                        double const *radius, double const *q, double *mu2,
                                        double *point);

/** Computes pw85_overlap_capsule() for n ellipsoids and capsules, with the same answers.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param radius [n; length; >= 0]
 * @param q [n×6; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipsoid
 * @return as for pw85_overlap_capsule(), of the first bad ellipsoid */
PW85_API int pw85_overlap_capsule_batch(size_t n, double const *end1, double const *end2,
                                        double const *radius, double const *q,
                                        unsigned char *overlap);

/** Computes pw85_distance_capsule() for n ellipsoids and capsules, with bitwise equal results.
 *
 * @param n [number of ellipsoids]
 * @param end1,end2 [n×3; length]
 * @param radius [n; length; >= 0]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @return as for pw85_distance_capsule(), of the first bad ellipsoid */
PW85_API int pw85_distance_capsule_batch(size_t n, double const *end1, double const *end2,
                                         double const *radius, double const *q, double *distance,
                                         double *point1, double *point2, double *normal);

/** Computes pw85_distance_point_2d() for n points and ellipses, with bitwise equal results.
 *
 * @param n [number of points]
 * @param r [n×2; length]
 * @param q [n×3; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point [n×2; length; optional]
 * @param[out] normal [n×2; optional]
 * @return as for pw85_distance_point_2d(), of the first bad point */
PW85_API int pw85_distance_point_batch_2d(size_t n, double const *r, double const *q,
                                          double *distance, double *point, double *normal);

/** Computes pw85_contact_segment_2d() for n ellipses and segments, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param end1,end2 [n×2; length]
 * @param q [n×3; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×2; length; optional]
 * @return as for pw85_contact_segment_2d(), of the first bad ellipse */
PW85_API int pw85_contact_segment_batch_2d(size_t n, double const *end1, double const *end2,
                                           double const *q, double *mu2, double *point);

/** Computes pw85_contact_box_2d() for n ellipses and boxes, with bitwise equal results.
 *
 * @param n [number of ellipses]
 * @param lower,upper [n×2; length; lower <= upper]
 * @param q [n×3; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×2; length; optional]
 * @return as for pw85_contact_box_2d(), of the first bad ellipse */
PW85_API int pw85_contact_box_batch_2d(size_t n, double const *lower, double const *upper,
                                       double const *q, double *mu2, double *point);

/** Computes pw85_overlap_segment_2d() for n ellipses and segments, with the same answers.
 *
 * @param n [number of ellipses]
 * @param end1,end2 [n×2; length]
 * @param q [n×3; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipse
 * @return as for pw85_overlap_segment_2d(), of the first bad ellipse */
PW85_API int pw85_overlap_segment_batch_2d(size_t n, double const *end1, double const *end2,
                                           double const *q, unsigned char *overlap);

/** Computes pw85_overlap_box_2d() for n ellipses and boxes, with the same answers.
 *
 * @param n [number of ellipses]
 * @param lower,upper [n×2; length; lower <= upper]
 * @param q [n×3; length²; definite]
 * @param[out] overlap [n] 1, 0, or 255 for a bad ellipse
 * @return as for pw85_overlap_box_2d(), of the first bad ellipse */
PW85_API int pw85_overlap_box_batch_2d(size_t n, double const *lower, double const *upper,
                                       double const *q, unsigned char *overlap);
/* clang-format on */

/** Computes pw85_contact(), pw85_contact_geometry(), pw85_contact_gradient() and
 * pw85_contact_torque() for n pairs in one call. The forces and torques of an energy U(μ²) follow
 * from the results. If r12 = 0, the derivatives are zero, and the point and the normal are NaN.
 *
 * @param n [number of pairs]
 * @param r12 [n×3; length]
 * @param q1,q2 [n×6; length²; definite]
 * @param[out] mu2,lambda [n; optional] the results of pw85_contact()
 * @param[out] point [n×3; length; optional] contact points relative to the centres of the first
 *        ellipsoids
 * @param[out] normal [n×3; optional] unit normals
 * @param[out] d_r12 [n×3; 1/length; optional] ∂μ²/∂r12
 * @param[out] d_rot1,d_rot2 [n×3; optional] derivatives with respect to rotations, as for
 *        pw85_contact_torque()
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_derivatives_batch(size_t n, double const *r12, double const *q1,
                                            double const *q2, double *mu2, double *lambda,
                                            double *point, double *normal, double *d_r12,
                                            double *d_rot1, double *d_rot2);

/** Computes pw85_contact_polytope() for many ellipsoids and one polytope. The centres may be
 * anywhere.
 *
 * The bound on the error is that of pw85_contact_polytope(), with |offset_k| + |normal_k|·|center|
 * instead of |offset_k|, and 40 instead of 32.
 *
 * @param num_ellipsoids [number of ellipsoids] 0 is allowed
 * @param centers [num_ellipsoids×3; length]
 * @param q [num_ellipsoids×6; length²; definite]
 * @param num_planes [number of planes] 0 is allowed
 * @param normals [num_planes×3; != 0] out of the polytope, of any lengths
 * @param offsets [num_planes; length]
 * @param[out] mu2 [num_ellipsoids; optional]
 * @param[out] point [num_ellipsoids×3; length; optional] the point at which the scaled ellipsoid
 *        touches, relative to its centre
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_polytope_batch(size_t num_ellipsoids, double const *centers,
                                         double const *q, size_t num_planes, double const *normals,
                                         double const *offsets, double *mu2, double *point);

/** Tests which of many ellipsoids overlap one polytope, such as the frustum of a camera; see
 * pw85_overlap_polytope(). The answers are exact for the centres and planes given.
 *
 * @param num_ellipsoids [number of ellipsoids] 0 is allowed
 * @param centers,q,num_planes,normals,offsets [as pw85_contact_polytope_batch()]
 * @param[out] overlap [num_ellipsoids] 1 or 0, 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_polytope_batch(size_t num_ellipsoids, double const *centers,
                                         double const *q, size_t num_planes, double const *normals,
                                         double const *offsets, unsigned char *overlap);

/** Tests whether an ellipsoid overlaps any of n others.
 *
 * The function tests the other ellipsoids in order, as pw85_overlap() does, and stops at the first
 * one that overlaps or is bad. It runs in the calling thread, and uses SIMD.
 *
 * @param q1 [length²; definite] form of the ellipsoid
 * @param n [number of others] 0 is allowed
 * @param r12 [n×3; length] centres of the others, relative to the centre of the ellipsoid
 * @param q2 [n×6; length²; definite]
 * @param[out] any [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad pair if no pair before it
 *        overlaps */
PW85_API int pw85_overlap_any(double const q1[6], size_t n, double const *r12, double const *q2,
                              int *any);

/** @}
 * @name Many forms
 *
 * Rows and threads are as for many pairs. The results of a bad row are NaN.
 * @{ */

/** Computes the bounding boxes of n ellipsoids, with sides along the coordinate axes.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; length²; definite]
 * @param[out] half_widths [n×3; length] √Qxx, √Qyy, √Qzz, in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad form */
PW85_API int pw85_bounding_boxes(size_t n, double const *q, double *half_widths);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
