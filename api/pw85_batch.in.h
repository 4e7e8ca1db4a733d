/** @file pw85_batch.h
 * @brief Many rows: the functions of pw85.h for arrays.
 *
 * The conventions are those of pw85.h, and so is what the description of an argument leaves out. Made of api/pw85_batch.in.h and pw85.h
 * by api/committed.py.
 */
#ifndef PW85_BATCH_H_INCLUDED
#define PW85_BATCH_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Many pairs
 *
 * Arrays are contiguous, and row i belongs to pair i. There may be 0 rows; pointers may then be null. A bad pair (NaN, infinity, a form that is not positive definite) is
 * marked with NaN, or 255 for overlaps. The function still computes the other pairs, and returns the status of the first bad pair.
 * If the call as a whole is wrong (a null pointer, a size that overflows, an index out of range), the function returns #PW85_EINVAL
 * before it writes anything.
 *
 * The result for a pair depends on the pair and on the instruction set alone: not on its position, the number of pairs, or the
 * number of threads. The library uses the newest instruction set of the processor that it knows. The environment variable
 * PW85_TARGET (baseline, avx2, avx512), which is read once, makes it use an older one. pw85_set_reproducible() makes the result
 * independent of the instruction set.
 *
 * With OpenMP, threads share the pairs; OMP_NUM_THREADS or omp_set_num_threads() sets their number. The threads of GNU OpenMP do
 * not survive fork(): a process that was forked after a threaded call must set one thread before it calls these functions.
 * @{ */

@rows pw85_contact: The relative error of μ² is below 4 u cond, too; the last bits may differ from those of pw85_contact().
    mu2: n
    lambda: n, or null

@rows pw85_overlap

@rows pw85_contact_rounded

@rows pw85_overlap_factored

@rows pw85_compare: the signs are the same.
    sign: n: -1, 0 or 1, or 2 for a bad pair

@rows pw85_overlap_witness: the results are the same.
    lambda: n, or null; NaN where the ellipsoids are not apart
    point: n×3, or null; NaN where they do not overlap

@rows pw85_contains

@rows pw85_containment

@rows pw85_closest_passage: The error of μ² is below 8 u S, too; the last bits may differ from those of pw85_closest_passage().
    mu2: n
    t: n, or null

@rows pw85_free_path

@rows pw85_closest_approach: The relative error is below 2 u cond + 4 u; the last bits may differ from those of pw85_closest_approach().

@rows pw85_contact_factored

@rows pw85_condition

@rows pw85_contact_function

@rows pw85_contact_geometry

@rows pw85_contact_gradient

@rows pw85_contact_geometry_factored

@rows pw85_contact_gradient_factored

@rows pw85_contact_torque

@rows pw85_contact_hessian

@rows pw85_contact_2d: see pw85_contact_batch().
    mu2: n
    lambda: n, or null

@rows pw85_overlap_2d: see pw85_overlap_batch().

@rows pw85_contact_geometry_2d

@rows pw85_contact_gradient_2d

@rows pw85_contact_torque_2d

@rows pw85_contact_hessian_2d

@rows pw85_closest_approach_2d

/** pw85_contact(), pw85_contact_geometry(), pw85_contact_gradient() and pw85_contact_torque() for n pairs: all that the forces
 * and torques of an energy U(μ²) need. A pair with r12 = 0 is valid: its derivatives are zero, its point and normal NaN.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] mu2,lambda n each; any output may be null
 * @param[out] point,normal n×3 each: contact points relative to the centres of the first ellipsoids, unit normals
 * @param[out] d_r12 n×3: ∂μ²/∂r12
 * @param[out] d_rot1,d_rot2 n×3 each: ∂μ²/∂(rotation vector) of either ellipsoid about its own centre, per radian
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                            double *mu2, double *lambda, double *point, double *normal, double *d_r12,
                                            double *d_rot1, double *d_rot2);

@rows pw85_distance: Points of pairs that overlap are NaN.

@rows pw85_distance_derivatives

@rows pw85_distance_2d

@rows pw85_penetration

@rows pw85_signed_distance

@rows pw85_signed_distance_derivatives

@rows pw85_curvature ellipsoids

@rows pw85_hertz contacts

@rows pw85_hertz_contact

@rows pw85_distance_plane ellipsoids and half-spaces

@rows pw85_distance_plane_derivatives ellipsoids and half-spaces

@rows pw85_contact_plane ellipsoids and half-spaces

@rows pw85_contact_plane_derivatives ellipsoids and half-spaces

@rows pw85_distance_box ellipsoids and boxes

@rows pw85_distance_cylinder ellipsoids and cylinders

@rows pw85_distance_point points and ellipsoids

@rows pw85_intersect_line lines and ellipsoids

@rows pw85_contact_segment ellipsoids and segments: The bound of the error is the same; the last bits may differ.

@rows pw85_contact_triangle ellipsoids and triangles: The bound of the error is the same; the last bits may differ.

@rows pw85_contact_box ellipsoids and boxes: The bound of the error is the same; the last bits may differ.

@rows pw85_overlap_segment ellipsoids and segments

@rows pw85_overlap_triangle ellipsoids and triangles

@rows pw85_overlap_box ellipsoids and boxes

/** pw85_contact_polytope() for many ellipsoids and one polytope, which need not be at their centres.
 *
 * The bound of the error has |offset_k| + |normal_k|·|center| in the place of |offset_k|, and 40 in the place of 32.
 *
 * @param num_ellipsoids number of ellipsoids; 0 is fine
 * @param centers num_ellipsoids×3
 * @param q num_ellipsoids×6
 * @param num_planes number of planes; 0 is fine
 * @param normals num_planes×3: out of the polytope, of any lengths > 0
 * @param offsets num_planes
 * @param[out] mu2 num_ellipsoids, or null
 * @param[out] point num_ellipsoids×3, or null: where the scaled ellipsoid touches, relative to its centre
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_contact_polytope_batch(size_t num_ellipsoids, double const *centers, double const *q,
                                         size_t num_planes, double const *normals, double const *offsets, double *mu2,
                                         double *point);

/** pw85_overlap_polytope() for many ellipsoids and one polytope, as which of them a camera sees. The answers are exact for the centres
 * and planes given.
 *
 * @param num_ellipsoids number of ellipsoids; 0 is fine
 * @param centers,q,num_planes,normals,offsets as for pw85_contact_polytope_batch()
 * @param[out] overlap num_ellipsoids: 1 or 0, 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_polytope_batch(size_t num_ellipsoids, double const *centers, double const *q,
                                         size_t num_planes, double const *normals, double const *offsets,
                                         unsigned char *overlap);

@rows pw85_first_contact

/** Whether an ellipsoid overlaps any of n others.
 *
 * The function tests the others one after the other, as pw85_overlap() does, and stops at the first that overlaps or is bad. It
 * runs in the calling thread, and uses SIMD.
 *
 * @param q1 form of the ellipsoid
 * @param n number of others; 0 is fine
 * @param r12 n×3: centres of the others relative to that of the ellipsoid
 * @param q2 n×6
 * @param[out] any 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad pair if no pair before it overlaps */
PW85_API int pw85_overlap_any(double const q1[PW85_SYM], size_t n, double const *r12, double const *q2, int *any);

/** @}
 * @name Many forms
 *
 * Rows, bad rows and threads are as for many pairs. Bad rows are marked with NaN.
 * @{ */

@rows pw85_ellipsoid_factor ellipsoids

@rows pw85_ellipsoid_quaternion ellipsoids

/** Tight boxes, with sides along the axes, around n ellipsoids.
 *
 * @param n number of ellipsoids
 * @param q n×6
 * @param[out] half_widths n×3: √Qxx, √Qyy, √Qzz, in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad form */
PW85_API int pw85_bounding_boxes(size_t n, double const *q, double *half_widths);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
