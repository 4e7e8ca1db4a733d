/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85.h
 * @brief The contact function of Perram and Wertheim for two ellipsoids: one pair, in C.
 *
 * For an example, see examples/c/pair.c.
 *
 * This header includes pw85_shapes.h (an ellipsoid and a wall, a point, a line or another shape)
 * and pw85_grains.h (curvatures and contacts of grains). Other headers are for arrays of pairs
 * (pw85_batch.h), systems of particles (pw85_systems.h) and Monte Carlo simulations
 * (pw85_simulation.h).
 *
 * The ellipsoid with centre c and quadratic form Q is the set of the points m for which (m-c)ᵀ Q⁻¹
 * (m-c) <= 1. The matrix Q is symmetric and positive definite. Its eigenvalues are the squares of
 * the semi-axes, and its eigenvectors are their directions. For two ellipsoids with centres c1 and
 * c2, forms Q1 and Q2, and r12 = c2 - c1, the contact function is
 *
 *     μ² = max { f(λ), 0 <= λ <= 1 },    f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12.
 *
 * The square root μ is a scale factor: if both ellipsoids are scaled by μ about their centres, they
 * touch from outside. The ellipsoids overlap if μ² < 1, touch if μ² = 1, and are apart if μ² > 1
 * (J. W. Perram and M. S. Wertheim, J. Comp. Phys. 58, 409, 1985).
 *
 * These conventions hold for every function of these headers unless its contract says otherwise:
 *
 * - Vectors are `double[3]`. Symmetric matrices are `double[6]`: the upper triangle in row-major
 *   order, (xx, xy, xz, yy, yz, zz). In two dimensions they are `double[2]` and `double[3]` (xx,
 *   xy, yy).
 * - All lengths have the same unit, which the caller chooses. Forms have the square of this unit.
 *   μ² and λ are dimensionless.
 * - The caller owns all arrays, and the library does not use them after the call. Arrays need only
 *   the alignment of double. Outputs must not share memory with inputs.
 * - Brackets after the name of a parameter state the shape of an array, such as n×3, the unit, such
 *   as length², and the allowed values, such as > 0. A pointer that is marked `optional` may be
 *   null. An input that is marked `or infinite` may be infinite. A form that is marked `definite`
 *   must be positive definite. An `index` is at least 0 and below the number of particles or
 *   vertices. `as pw85_contact()` means that pw85_contact() describes the parameter of this name.
 *   `member` names the member of the C++ result that receives an output.
 * - A function whose name ends in `_2d` is the two-dimensional version, for ellipses. Its contract
 *   states only the differences from the function for ellipsoids. The statuses are the same.
 * - A function that returns `int` returns a status, which is zero for success. If the status is not
 *   zero, all outputs are NaN, except those whose brackets state another value, such as "-1 on
 *   error". The function does not write an output whose pointer is null.
 * - Every function returns #PW85_EINVAL in three cases: a pointer that is not optional is null; a
 *   number is NaN or infinite, and its brackets do not allow that; an argument violates another
 *   condition in its brackets. #PW85_ENOTPD means that a form is not positive definite.
 *   pw85_last_error() returns the argument, the row and the cause. The chapter on errors has a
 *   table of all causes.
 * - In bounds on errors, u = 2⁻⁵³ is the unit roundoff of double.
 * - No function prints anything or ends the process. The functions for neighbour lists, meshes,
 *   simulations, enclosing ellipsoids, n dimensions and GPUs can allocate memory, and so can
 *   pw85_law_forces_pairs(). Their contracts list #PW85_ENOMEM or #PW85_EDEVICE. All other
 *   functions allocate no memory.
 * - Any number of threads may call any functions at the same time, but only one thread at a time
 *   may use a simulation. The library keeps two pieces of state: the mode that
 *   pw85_set_reproducible() sets, for the whole process, and the error that pw85_last_error()
 *   returns, for each thread.
 * - A function needs at most 16 KiB of stack, or 24 KiB if it works on a mesh. If the dynamic
 *   linker binds symbols lazily, the first call needs more. The threads that a batch function
 *   starts have their own stacks, whose size OMP_STACKSIZE sets.
 * - Functions compute in the default floating-point environment. The rounding mode, status flags
 *   and traps of the caller do not change the results, and the functions restore them.
 * - If semi-axes and distances are from 1e-150 to 1e150, no intermediate result overflows or
 *   underflows. A result beyond the range of double is infinity or zero.
 * - A form is positive definite if its leading principal minors are positive. This test is exact:
 *   all functions and instruction sets give the same result for the same doubles. There are two
 *   limits: the determinant must exceed 2⁻²¹² times the product of the diagonal entries, and
 *   semi-axes may differ by a factor of at most about 1e38.
 */
#ifndef PW85_H_INCLUDED
#define PW85_H_INCLUDED

#include <stddef.h>
#include <stdint.h>

#include <pw85/export.h>
#include <pw85/last_error.h>
#include <pw85/status.h>
#include <pw85/version.h>
#include <pw85_grains.h>
#include <pw85_shapes.h>

/** Dimension of the physical space. */
#define PW85_DIM 3

/** Number of stored entries of a symmetric matrix. */
#define PW85_SYM 6

/** Absolute tolerance on λ in Brent's method in pw85_contact_function(), which first scales the
 * ellipsoids to similar size. */
#define PW85_LAMBDA_ATOL 1e-6

/** Maximum number of iterations of Brent's method in pw85_contact_function(). */
#define PW85_MAX_ITER 25

/** Maximum number of iterations of Halley's method in pw85_contact_function(), which refines the
 * result of Brent's method. */
#define PW85_NR_ITER 3

#ifdef __cplusplus
extern "C" {
#endif

/** Status codes, which functions of type `int` return. */
enum pw85_status {
#define PW85_STATUS_ENUMERATOR(c_name, cpp_name, value, text) , c_name = value
    PW85_SUCCESS = 0 PW85_ERROR_LIST(PW85_STATUS_ENUMERATOR)
#undef PW85_STATUS_ENUMERATOR
};

/** @name Version and errors
 * @{ */

/** Returns the version of the library that is linked. #PW85_VERSION is the version of the header.
 *
 * @return "major.minor.patch", a constant */
PW85_API char const *pw85_version(void);

/** Returns the meaning of a status, as a short text without a full stop.
 *
 * @param status any number
 * @return the text, a constant; never null */
PW85_API char const *pw85_strerror(int status);

/** Switches the reproducible mode on or off, for all threads of the process.
 *
 * In this mode the results of all functions are bitwise equal on every processor and with every
 * number of threads. This holds for x86-64 with any instruction set, 32-bit x86 with SSE2, 64-bit
 * ARM and z/Architecture, with either byte order. The functions then use no fused multiply-add
 * instructions, and SIMD registers of at most two doubles, so batch functions are slower.
 * pw85_contact_function() returns the results of pw85_contact(), because the bits of Brent's method
 * depend on how GSL or Boost was compiled.
 *
 * The mode does not apply to the functions of pw85_gpu.h and pw85_zheng.h, nor to the templates of
 * the C++ headers.
 *
 * To start a process in this mode, set the environment variable PW85_REPRODUCIBLE to 1. The library
 * reads it at the first call of a function. Any value except 0 and the empty string switches the
 * mode on. If the mode changes while another thread is in a call, that call may compute some of its
 * pairs in one mode and some in the other.
 *
 * @param on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_set_reproducible(int on);

/** Returns whether the reproducible mode of pw85_set_reproducible() is on.
 *
 * @param[out] on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_is_reproducible(int *on);

/** @}
 * @name Quadratic forms
 * @{ */

/** Computes the quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ with |n| = 1.
 *
 * @param a [length; > 0] equatorial radius
 * @param c [length; > 0] polar radius
 * @param n [!= 0] direction of the axis of revolution, of any length
 * @param[out] q [length²; NaN on error] the form; NaN if a length is not positive, the square of a
 *        length leaves the range of double, or n is zero or not finite */
PW85_API void pw85_spheroid(double a, double c, double const n[3], double q[6]);

/** Computes the quadratic form of an ellipsoid, Q = R diag(semi_axes²) Rᵀ.
 *
 * @param semi_axes [length; > 0; finite square] lengths of the principal semi-axes (not diameters),
 *        whose squares are in the range of double
 * @param rotation [3×3; rotation] row-major matrix R, which takes the body frame to the space
 *        frame; its columns are the directions of the semi-axes. Each entry of RᵀR - I must be at
 *        most 1e-6 in magnitude: single precision is enough. R may be a reflection.
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6]);

/** Computes the quadratic form of an ellipsoid whose orientation is a quaternion.
 *
 * @param semi_axes [as pw85_ellipsoid()]
 * @param quaternion [!= 0] (w, x, y, z), scalar first, which rotates the body frame into the space
 *        frame; of any length, because the function normalises it
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_quaternion(double const semi_axes[3], double const quaternion[4],
                                       double q[6]);

/** Computes a factor S of the quadratic form of an ellipsoid, Q = S Sᵀ. The factor keeps digits
 * that the form loses: see pw85_contact_factored().
 *
 * @param semi_axes,quaternion [as pw85_ellipsoid_quaternion()]
 * @param[out] s [3×3; length] row-major matrix; column k is semi-axis k as a vector
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_factor(double const semi_axes[3], double const quaternion[4],
                                   double s[9]);

/** Computes the quadratic form (xx, xy, yy) of an ellipse.
 *
 * @param a,b [length; > 0; finite square] semi-axes, whose squares are in the range of double
 * @param angle from the x axis to the first semi-axis, counter-clockwise, in radians
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipse(double a, double b, double angle, double q[3]);

/** @}
 * @name Contact of two ellipsoids
 * @{ */

/** Computes the contact function of two ellipsoids.
 *
 * The method is a third-order iteration on log(λ/(1-λ)), which evaluates f at most 157 times. The
 * relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the condition number cond of
 * pw85_condition(). The bound also holds for forms that are singular to working precision.
 *
 * @param r12 [length] vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero:
 *        then μ² = 0 and λ = 1/2
 * @param q1,q2 [length²; definite] forms of the ellipsoids, in the square of the unit of r12
 * @param[out] out [members mu2, lambda] μ², and the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the bound on the error
 *        cannot be proved; this has never been seen) */
PW85_API int pw85_contact(double const r12[3], double const q1[6], double const q2[6],
                          double out[2]);

/** Computes the contact function of two ellipsoids, with μ² correctly rounded.
 *
 * μ² is the double nearest to the exact value for the numbers given. If two doubles are equally
 * near, it is the one whose last bit is 0. This rule includes underflow and overflow: a value of
 * 2¹⁰²⁴ - 2⁹⁷⁰ or more becomes infinity. The error of λ is less than one unit in the last place.
 *
 * Every processor and every instruction set therefore gives the same μ². Exchanging the two
 * ellipsoids does not change it. Multiplying the unit of length by a power of two does not change
 * it if the data stay in the range of normal doubles.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the last digit of λ cannot
 *        be proved; this has never been seen) */
PW85_API int pw85_contact_rounded(double const r12[3], double const q1[6], double const q2[6],
                                  double out[2]);

/** Computes the contact function of two ellipsoids that are given by factors of their forms, Q1 =
 * S1 S1ᵀ and Q2 = S2 S2ᵀ.
 *
 * Use this function for slender ellipsoids. An entry of a form is a sum of squares of long and
 * short semi-axes, so rounding the entry loses digits of the short ones. At aspect ratios 100, 10⁴
 * and 10⁶, rounding the forms changes μ² by about 1e-12, 1e-8 and 1e-4, and rounding the factors
 * changes μ² by less than 1e-14, 1e-12 and 1e-12.
 *
 * The relative error of μ² is below 4 u c, with u = 2⁻⁵³. If each entry of s1, s2 and r12 changes
 * by at most a fraction ε of itself, μ² changes by at most a fraction ε c, to first order in ε.
 *
 * @param r12 [as pw85_contact()]
 * @param s1,s2 [3×3; length] row-major factors, as from pw85_ellipsoid_factor(). Any matrix S is
 *        accepted if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
 *        lengths of its columns differ by a factor below 2¹²⁷.
 * @param[out] out [members mu2, lambda] μ², and the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly),
 *        #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_contact_factored(double const r12[3], double const s1[9], double const s2[9],
                                   double out[2]);

/** Computes the entrywise condition number of the contact function.
 *
 * If each entry of r12, q1 and q2 changes by at most a fraction ε of itself, μ² changes by at most
 * a fraction ε cond, to first order in ε. If the data have d accurate digits, μ² has d -
 * log10(cond) accurate digits. The condition number is of the order of one for typical pairs, and
 * of the order of the squared aspect ratio for slender ones. It is [λ(1-λ) Σ |n_i| ((1-λ) |q1_ij| +
 * λ |q2_ij|) |n_j| + 2 λ(1-λ) Σ |r12_i n_i|]/μ² with n = [(1-λ) q1 + λ q2]⁻¹ r12, summed over i and
 * j.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact()
 * @param[out] cond [member condition] the condition number: at least 3, or 0 for r12 = 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_condition(double const r12[3], double const q1[6], double const q2[6],
                            double lambda, double *cond);

/** Computes the contact function of two ellipsoids as pw85 1.0 did, by Brent's method.
 *
 * Use pw85_contact() instead: it is several times faster, with the same error bound. This function
 * scales the ellipsoids to similar size, so that #PW85_LAMBDA_ATOL has the same meaning for all
 * sizes. Brent's method then maximises f, and Halley's method (in pw85 1.0, Newton's method)
 * refines the result.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_contact_function(double const r12[3], double const q1[6], double const q2[6],
                                   double out[2]);

/** Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal there.
 *
 * @param r12 [as pw85_contact(); != 0]
 * @param q1,q2 [as pw85_contact()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact(). For another λ in [0, 1] the point
 *        is x0(λ) of the chapter on theory. It is on the surface of ellipsoid 1 scaled by μ1, and
 *        on that of ellipsoid 2 scaled by μ2, where f(λ) = λ μ1² + (1-λ) μ2².
 * @param[out] point [length; optional] the point, relative to the centre of ellipsoid 1
 * @param[out] normal [optional] unit vector, outward from ellipsoid 1 and into ellipsoid 2
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_geometry(double const r12[3], double const q1[6], double const q2[6],
                                   double lambda, double point[3], double normal[3]);

/** Computes the contact point and the normal of ellipsoids that are given by factors of their
 * forms; see pw85_contact_geometry().
 *
 * Errors are below 4 u C for the given λ, with u = 2⁻⁵³. C is the largest change of the result, to
 * first order, if each entry of s1 and s2 changes by the largest magnitude in its column, and each
 * coordinate of r12 changes by its own magnitude.
 *
 * @param r12 [as pw85_contact_factored(); != 0]
 * @param s1,s2 [as pw85_contact_factored()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact_factored()
 * @param[out] point,normal [as pw85_contact_geometry()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly) */
PW85_API int pw85_contact_geometry_factored(double const r12[3], double const s1[9],
                                            double const s2[9], double lambda, double point[3],
                                            double normal[3]);

/** Computes the derivatives of μ² with respect to r12 and the forms.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact()
 * @param[out] d_r12 [1/length; optional; member r12] ∂μ²/∂r12; its negative is the derivative with
 *        respect to the centre of ellipsoid 1
 * @param[out] d_q1,d_q2 [1/length²; optional; member q1, q2] derivatives with respect to the stored
 *        entries of q1 and q2 (a stored off-diagonal entry is two entries of the matrix)
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_gradient(double const r12[3], double const q1[6], double const q2[6],
                                   double lambda, double d_r12[3], double d_q1[6], double d_q2[6]);

/** Computes the derivatives of μ² for ellipsoids that are given by factors of their forms.
 *
 * The derivative with respect to a factor S is 2 (∂μ²/∂Q) S, where ∂μ²/∂Q is a symmetric matrix. A
 * change dS of the factor changes μ² by Σ d_s_ij dS_ij. The bound on the errors is 4 u C, as for
 * pw85_contact_geometry_factored().
 *
 * @param r12,s1,s2 [as pw85_contact_factored()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact_factored()
 * @param[out] d_r12 [as pw85_contact_gradient()]
 * @param[out] d_s1,d_s2 [3×3; 1/length; optional; member s1, s2] row-major: derivatives with
 *        respect to the entries of s1 and s2
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly) */
PW85_API int pw85_contact_gradient_factored(double const r12[3], double const s1[9],
                                            double const s2[9], double lambda, double d_r12[3],
                                            double d_s1[9], double d_s2[9]);

/** Computes the derivatives of μ² with respect to rotations of the ellipsoids.
 *
 * If an ellipsoid rotates about its own centre by a small rotation vector ω, μ² changes by d_rot·ω.
 * An energy U(μ²) exerts the torque -U'(μ²) d_rot on the ellipsoid.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact()
 * @param[out] d_rot1,d_rot2 [optional; member rotation1, rotation2] derivatives for ellipsoids 1
 *        and 2, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_torque(double const r12[3], double const q1[6], double const q2[6],
                                 double lambda, double d_rot1[3], double d_rot2[3]);

/** Computes the second derivatives of μ² with respect to r12 and rotations of the ellipsoids.
 *
 * The relative error of the second derivatives is a few times the relative errors of λ and of 1-λ.
 * If λ comes from pw85_contact(), its relative error is a few u times the squared aspect ratio,
 * with u = 2⁻⁵³. If ellipsoid 1 is much larger than ellipsoid 2, the relative error of 1-λ is
 * u/(1-λ).
 *
 * @param r12 [as pw85_contact(); != 0]
 * @param q1,q2 [as pw85_contact()]
 * @param lambda [0..1] the maximiser λ of f, from pw85_contact()
 * @param[out] hessian [9×9; mixed units; member entries] symmetric matrix of second derivatives
 *        with respect to r12, rotation 1 and rotation 2. A rotation vector ω is the rotation by the
 *        angle |ω| about the direction of ω. λ varies with the pair: it always maximises f.
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_hessian(double const r12[3], double const q1[6], double const q2[6],
                                  double lambda, double hessian[81]);

/** Tests whether two ellipsoids overlap, μ² < 1. Tangent ellipsoids (μ² = 1) do not overlap.
 *
 * The answer is exact for the numbers given. Bounds that account for rounding decide almost all
 * pairs, and exact arithmetic decides the others.
 *
 * @param r12 [as pw85_contact()] zero is an overlap
 * @param q1,q2 [as pw85_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap(double const r12[3], double const q1[6], double const q2[6],
                          int *overlap);

/** Tests whether two ellipsoids that are given by factors of their forms overlap, Q1 = S1 S1ᵀ and
 * Q2 = S2 S2ᵀ.
 *
 * The answer is exact for the unrounded products S Sᵀ of the given factors. pw85_overlap() may give
 * another answer, because its forms are rounded. Separating planes and common points, with bounds
 * that account for rounding, decide almost all pairs. Integer arithmetic decides the others, if r12
 * and the entries of s1 and s2 are multiples of one power of two and smaller than 2¹⁵⁰⁰ times this
 * power.
 *
 * @param r12 [as pw85_contact_factored()] zero is an overlap
 * @param s1,s2 [as pw85_contact_factored()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly),
 *        #PW85_ECONVERGENCE (the ellipsoids nearly touch, so that only integer arithmetic can
 *        decide, and the numbers do not meet the condition above) */
PW85_API int pw85_overlap_factored(double const r12[3], double const s1[9], double const s2[9],
                                   int *overlap);

/** Compares μ² with a number mu2 >= 0, and returns the sign of μ² - mu2.
 *
 * The sign is exact for the numbers given. pw85_overlap() is the case mu2 = 1. A bound on the error
 * of μ² decides almost all pairs, and exact arithmetic decides the others.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param mu2 [>= 0; or infinite] the number to compare with
 * @param[out] sign [2 on error] -1 if μ² < mu2, 0 if they are equal, 1 if μ² > mu2
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_compare(double const r12[3], double const q1[6], double const q2[6], double mu2,
                          int *sign);

/** Tests whether two ellipsoids overlap, as pw85_overlap() does, and returns a number or a point
 * that proves the answer.
 *
 * If the ellipsoids are apart, the proof is a double λ with f(λ) > 1. The function finds such a
 * double if there is one. If the ellipsoids overlap, the proof is a point inside both. The function
 * searches for this point near the contact point of the ellipsoids scaled by μ; the search may fail
 * if 1 - μ² is below 1e-13. For tangent ellipsoids there is no proof: `lambda` and `point` are then
 * NaN, also on success. A proof is exact for the given doubles, and a program can verify it in
 * rational arithmetic.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @param[out] lambda [optional] λ from 0 to 1, with f(λ) > 1, if the ellipsoids are apart;
 *        otherwise NaN, also on success
 * @param[out] point [length; optional] a point inside both ellipsoids and on neither surface,
 *        relative to the centre of ellipsoid 1, if they overlap; otherwise NaN, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the function finds no
 *        proof among the doubles; this was seen only if μ² differs from 1 by less than 1e-13, at
 *        aspect ratios up to 10⁸) */
PW85_API int pw85_overlap_witness(double const r12[3], double const q1[6], double const q2[6],
                                  int *overlap, double *lambda, double point[3]);

/** Tests whether ellipsoid 2 is inside ellipsoid 1. Ellipsoid 2 may touch the surface of ellipsoid
 * 1 from inside.
 *
 * The answer is exact for the numbers given. Every ellipsoid contains itself.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] contains [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contains(double const r12[3], double const q1[6], double const q2[6],
                           int *contains);

/** Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
 * ellipsoid 2, and a point where the two then touch.
 *
 * The square of the factor is the largest value of xᵀ q1⁻¹ x over the points x of ellipsoid 2,
 * relative to the centre of ellipsoid 1. It is at most 1 if ellipsoid 2 is inside ellipsoid 1;
 * pw85_contains() decides this exactly.
 *
 * The relative error of the square is below 16 u c, with u = 2⁻⁵³. If each entry of r12, q1 and q2
 * changes by at most a fraction ε of itself, the square changes by at most a fraction ε c, to first
 * order in ε. A lower and an upper bound prove the result.
 *
 * @param r12 [as pw85_contact()] it may be zero
 * @param q1,q2 [as pw85_contact()]
 * @param[out] mu2 [optional] square of the factor
 * @param[out] point [length; optional] a point of contact on the surface of ellipsoid 2, relative
 *        to the centre of ellipsoid 1. If r12 = 0, there are several such points, and the result is
 *        one of them. The same holds for a short r12 that has no component along the longest
 *        semi-axis of ellipsoid 2, after the linear map that makes ellipsoid 1 a unit ball.
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the lower and the upper
 *        bound do not agree; this has never been seen) */
PW85_API int pw85_containment(double const r12[3], double const q1[6], double const q2[6],
                              double *mu2, double point[3]);

/** Computes the distance of closest approach of two ellipsoids along a direction.
 *
 * This is the distance of the centres at which the ellipsoids touch from outside, if their
 * orientations are fixed and the centres are on a line along d = `direction`. It is |d|/μ(d), where
 * μ(d) is μ for r12 = d.
 *
 * @param direction [!= 0] from centre 1 to centre 2, of any length
 * @param q1,q2 [length²; definite] forms of the ellipsoids
 * @param[out] distance [length] distance of the centres, in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_approach(double const direction[3], double const q1[6],
                                   double const q2[6], double *distance);

/** @}
 * @name Volumes and intersections
 * @{ */

/** Computes the volume of an ellipsoid, (4/3)π √det q.
 *
 * The relative error is below 2⁻⁵² for aspect ratios below 10⁷. For a larger aspect ratio k it is
 * below 2⁻⁵² k²/10¹⁴.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] volume [length³] the volume, in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_volume(double const q[6], double *volume);

/** Computes the volume V of the intersection of two ellipsoids.
 *
 * V is 0 if the ellipsoids do not overlap, as pw85_overlap() decides. V is pw85_volume() of the
 * smaller ellipsoid if it is inside the other one, as pw85_contains() decides. Otherwise the error
 * is below u (64 v + 16 s), with u = 2⁻⁵³ and the volume v of the smaller ellipsoid. The term s is
 * Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + Σ √(q2_ii q2_jj) |∂V/∂q2_ij|, summed over
 * coordinates and stored entries, with the derivatives of pw85_overlap_volume_gradient().
 *
 * If the intersection is as thin as rounding errors, V may be 0. If the part of the smaller
 * ellipsoid outside the other one is as thin as rounding errors, V may be the volume of the smaller
 * ellipsoid.
 *
 * @param r12 [as pw85_contact()] it may be zero
 * @param q1,q2 [as pw85_contact()]
 * @param[out] volume [length³] the volume, in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (one of three: the linear
 *        map that makes the smaller ellipsoid a unit ball makes the other one a disc thinner than
 *        2⁻²¹; the integral does not converge; 32 digits are not enough for the bound on the error,
 *        which was seen at aspect ratios above 10⁵) */
PW85_API int pw85_overlap_volume(double const r12[3], double const q1[6], double const q2[6],
                                 double *volume);

/** Computes the derivatives of the volume V of the intersection of two ellipsoids.
 *
 * The derivatives are 0 if the ellipsoids do not overlap. If one ellipsoid is inside the other one,
 * V is its volume, and only the derivatives with respect to its form are not 0.
 *
 * The error of the derivative with respect to a number p is below u (256 m + 64 s), with u = 2⁻⁵³.
 * The term s is defined as for pw85_overlap_volume(), with ∂V/∂p instead of V. The term m depends
 * on the volume v of the smaller ellipsoid, the inverse P of its form, and the inverse P' of the
 * form to which p belongs. It is v √P_ii for p = r12_i, v √(P_ii P'_ii) for a diagonal entry p of a
 * form, and v (√(P_ii P'_jj) + √(P_jj P'_ii)) for another entry.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] d_r12 [length²; optional; member r12] ∂V/∂r12; its negative is the derivative with
 *        respect to the centre of ellipsoid 1
 * @param[out] d_q1,d_q2 [length; optional; member q1, q2] derivatives with respect to the stored
 *        entries of q1 and q2 (a stored off-diagonal entry is two entries of the matrix)
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the causes of
 *        pw85_overlap_volume(); or the surfaces touch from inside at one point, up to about 10⁻¹⁷
 *        of their size, and cross elsewhere) */
PW85_API int pw85_overlap_volume_gradient(double const r12[3], double const q1[6],
                                          double const q2[6], double d_r12[3], double d_q1[6],
                                          double d_q2[6]);

/** Computes the derivatives of the volume V of the intersection with respect to rotations of the
 * ellipsoids.
 *
 * If an ellipsoid rotates about its own centre by a small rotation vector ω, V changes by d_rot·ω.
 * An energy U(V) exerts the torque -U'(V) d_rot on the ellipsoid. With ∂V/∂r12 from
 * pw85_overlap_volume_gradient(), d_rot1 + d_rot2 + r12 × ∂V/∂r12 = 0.
 *
 * The derivatives are the axial vectors of 2 q1 G1 and 2 q2 G2, where G is the matrix of the
 * derivatives ∂V/∂q. Each component is a sum of products 2 q_ij G_jk. The error of a component is
 * below the sum of 2 |q_ij| times the bound on the error of G_jk.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] d_rot1,d_rot2 [length³; optional; member rotation1, rotation2] derivatives for
 *        ellipsoids 1 and 2, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for
 *        pw85_overlap_volume_gradient() */
PW85_API int pw85_overlap_volume_torque(double const r12[3], double const q1[6], double const q2[6],
                                        double d_rot1[3], double d_rot2[3]);

/** Computes the area of an ellipse, π √det q. The bound on the error is that of pw85_volume().
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] area [length²] the area, in the square of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_area_2d(double const q[3], double *area);

/** Computes the area of the intersection of two ellipses; see pw85_overlap_volume(). The bound on
 * the error is that of pw85_overlap_volume(), with areas instead of volumes.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] area [length²] the area, in the square of the unit of length */
PW85_API int pw85_overlap_area_2d(double const r12[2], double const q1[3], double const q2[3],
                                  double *area);

/** Computes the derivatives of the area of the intersection of two ellipses; see
 * pw85_overlap_volume_gradient(). The bounds on the errors are those of
 * pw85_overlap_volume_gradient(), with areas instead of volumes.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume_gradient()]
 * @param[out] d_r12 [as pw85_overlap_volume_gradient(); length]
 * @param[out] d_q1,d_q2 [as pw85_overlap_volume_gradient(); no unit] */
PW85_API int pw85_overlap_area_gradient_2d(double const r12[2], double const q1[3],
                                           double const q2[3], double d_r12[2], double d_q1[3],
                                           double d_q2[3]);

/** Computes the derivatives of the area of the intersection with respect to the angles of both
 * ellipses; see pw85_overlap_volume_torque(). Angles are counter-clockwise.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume_torque()]
 * @param[out] d_rot1,d_rot2 [length²; optional; member rotation1, rotation2] per radian */
PW85_API int pw85_overlap_area_torque_2d(double const r12[2], double const q1[3],
                                         double const q2[3], double *d_rot1, double *d_rot2);

/** @}
 * @name Two dimensions
 * @{ */

/** Computes the contact function of two ellipses; see pw85_contact().
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()] */
PW85_API int pw85_contact_2d(double const r12[2], double const q1[3], double const q2[3],
                             double out[2]);

/** Computes the point at which the ellipses, scaled by μ, touch, and their common normal there; see
 * pw85_contact_geometry().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_geometry()]
 * @param[out] point,normal [as pw85_contact_geometry()] */
PW85_API int pw85_contact_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                                      double lambda, double point[2], double normal[2]);

/** Computes the derivatives of μ² of two ellipses; see pw85_contact_gradient().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_gradient()]
 * @param[out] d_r12,d_q1,d_q2 [as pw85_contact_gradient()] */
PW85_API int pw85_contact_gradient_2d(double const r12[2], double const q1[3], double const q2[3],
                                      double lambda, double d_r12[2], double d_q1[3],
                                      double d_q2[3]);

/** Computes the derivatives of μ² with respect to the angles of two ellipses; see
 * pw85_contact_torque(). Angles are counter-clockwise.
 *
 * @param r12,q1,q2,lambda [as pw85_contact_torque()]
 * @param[out] d_rot1,d_rot2 [optional; member rotation1, rotation2] per radian */
PW85_API int pw85_contact_torque_2d(double const r12[2], double const q1[3], double const q2[3],
                                    double lambda, double *d_rot1, double *d_rot2);

/** Computes the second derivatives of μ² of two ellipses; see pw85_contact_hessian().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_hessian()]
 * @param[out] hessian [4×4; mixed units; member entries] symmetric matrix of second derivatives
 *        with respect to r12, angle 1 and angle 2 */
PW85_API int pw85_contact_hessian_2d(double const r12[2], double const q1[3], double const q2[3],
                                     double lambda, double hessian[16]);

/** Tests whether two ellipses overlap; see pw85_overlap().
 *
 * @param r12,q1,q2 [as pw85_overlap()]
 * @param[out] overlap [as pw85_overlap()] */
PW85_API int pw85_overlap_2d(double const r12[2], double const q1[3], double const q2[3],
                             int *overlap);

/** Tests whether ellipse 2 is inside ellipse 1; see pw85_contains().
 *
 * @param r12,q1,q2 [as pw85_contains()]
 * @param[out] contains [as pw85_contains()] */
PW85_API int pw85_contains_2d(double const r12[2], double const q1[3], double const q2[3],
                              int *contains);

/** Computes the least factor by which ellipse 1 must be scaled to contain ellipse 2; see
 * pw85_containment().
 *
 * @param r12,q1,q2 [as pw85_containment()]
 * @param[out] mu2,point [as pw85_containment()] */
PW85_API int pw85_containment_2d(double const r12[2], double const q1[3], double const q2[3],
                                 double *mu2, double point[2]);

/** Computes the distance of closest approach of two ellipses; see pw85_closest_approach().
 *
 * @param direction,q1,q2 [as pw85_closest_approach()]
 * @param[out] distance [as pw85_closest_approach()] */
PW85_API int pw85_closest_approach_2d(double const direction[2], double const q1[3],
                                      double const q2[3], double *distance);

/** @}
 * @name Distance
 * @{ */

/** Computes the distance of the surfaces of two ellipsoids, and the points where they are closest.
 *
 * The distance is the largest value of n·r12 - α - β over unit vectors n, with the half-widths α
 * and β of the ellipsoids along n. Its error is below 8 u Σ, with u = 2⁻⁵³. Here Σ = Σ|n_i r12_i| +
 * Σ|n_i q1_ij n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β), summed over all i and j, with n, α and β at the
 * closest points. Rounding the data entry by entry can change the distance by u Σ.
 *
 * A program can verify the result by a lower and an upper bound. For any unit vector n, n·r12 - α -
 * β is a lower bound of the distance; `distance` is this bound for the normal of
 * pw85_distance_derivatives(). The distance between any point of ellipsoid 1 and any point of
 * ellipsoid 2 is an upper bound, such as |point2 - point1|.
 *
 * Let ε = 2¹⁸ u (|r12| + |point1| + |r12 - point2|). The vector point2 - point1 differs from
 * `distance` times n by less than ε, and the length of this vector differs from `distance` by at
 * most ε. The points are the exact closest points for a pair whose r12 differs by at most ε. Each
 * point is off its surface by less than 2¹⁸ u times the longest semi-axis of its ellipsoid, plus
 * the rounding error u |point2| of its coordinates.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance [length; optional] the distance, in the unit of r12; zero if the ellipsoids
 *        overlap, as pw85_overlap() decides
 * @param[out] point1,point2 [length; optional] the closest points of ellipsoids 1 and 2, both
 *        relative to the centre of ellipsoid 1; NaN if the ellipsoids overlap, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the error bound cannot be
 *        proved with 384 binary digits; not seen up to aspect ratio 2¹⁰⁰) */
PW85_API int pw85_distance(double const r12[3], double const q1[6], double const q2[6],
                           double *distance, double point1[3], double point2[3]);

/** Computes the distance of two ellipsoids, as pw85_distance() does, with the closest points and
 * the normal there.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance,point1,point2 [as pw85_distance()]
 * @param[out] normal [optional] unit vector, outward from ellipsoid 1 and into ellipsoid 2: the
 *        derivative of the distance with respect to r12; NaN if the ellipsoids overlap, also on
 *        success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() */
PW85_API int pw85_distance_geometry(double const r12[3], double const q1[6], double const q2[6],
                                    double *distance, double point1[3], double point2[3],
                                    double normal[3]);

/** Computes the derivatives of the distance of two ellipsoids. The derivatives are NaN if the
 * ellipsoids overlap, also on success.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] d_r12 [optional; member r12] derivative with respect to r12: the unit normal at the
 *        closest points, into ellipsoid 2
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] derivatives with
 *        respect to rotations, as for pw85_contact_torque()
 * @param[out] hessian [9×9; mixed units; optional] symmetric matrix of second derivatives with
 *        respect to r12, rotation 1 and rotation 2, as for pw85_contact_hessian()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() */
PW85_API int pw85_distance_derivatives(double const r12[3], double const q1[6], double const q2[6],
                                       double d_r12[3], double d_rot1[3], double d_rot2[3],
                                       double hessian[81]);

/** Computes the penetration depth of two ellipsoids that overlap, and its direction. The depth is
 * the length of the shortest translation of ellipsoid 2 that separates them.
 *
 * The depth is the smallest value of α + β - n·r12 over unit vectors n, with the half-widths α and
 * β of the ellipsoids along n. This function of n may have several local minima. The library proves
 * that its result is the global minimum. If several directions give the same value, the result is
 * one of them.
 *
 * `depth` is the value of α + β - n·r12 for the returned direction n. Its error is below 8 u Σ,
 * with u = 2⁻⁵³ and Σ as for pw85_distance(). No other direction has a value that is smaller by
 * more than 32 u Σ, where Σ is the larger one of the two directions.
 *
 * For more than 90 % of random pairs a simple sufficient condition proves the minimum, and the time
 * is 3 to 8 times that of pw85_contact(). For the other pairs the time is 10 to 60 times that of
 * pw85_contact(), and about 1000 times if the minimum is not isolated.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] depth [length; optional] the depth, in the unit of r12; zero if the ellipsoids do not
 *        overlap, as pw85_overlap() decides
 * @param[out] direction [optional] unit vector along which ellipsoid 2 must move; NaN if the
 *        ellipsoids do not overlap, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the proof takes too long;
 *        this was seen only for forms that are singular to working precision) */
PW85_API int pw85_penetration(double const r12[3], double const q1[6], double const q2[6],
                              double *depth, double direction[3]);

/** Computes the signed distance of two ellipsoids, and the points where it is reached. The signed
 * distance is the distance if the ellipsoids are apart, and minus the penetration depth if they
 * overlap.
 *
 * In both cases the signed distance is the largest value of n·r12 - α - β over unit vectors n, with
 * the half-widths α and β of the ellipsoids along n. It is a continuous, convex function of r12,
 * whose gradient is a unit vector. The sign is exact: positive only if the ellipsoids are apart,
 * and negative only if they overlap, as pw85_overlap() decides.
 *
 * If the ellipsoids overlap, moving ellipsoid 2 by point1 - point2 is the shortest translation that
 * separates them. If several translations have this length, the result is one of them.
 *
 * Errors and times are as for pw85_distance() if the ellipsoids are apart, and as for
 * pw85_penetration() if they overlap. If the ellipsoids overlap, point2 - point1 differs from
 * `distance` times the unit normal by less than 2¹⁸ u (|r12| + |point1| + |r12 - point2|), with u =
 * 2⁻⁵³. This bound holds if the minimum is isolated, for aspect ratios up to 10³.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance [length; optional] the signed distance, in the unit of r12
 * @param[out] point1,point2 [length; optional] the closest points of ellipsoids 1 and 2 if they are
 *        apart, or the deepest points if they overlap, both relative to the centre of ellipsoid 1.
 *        The outward normals there are opposite, and along point2 - point1.
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() and
 *        pw85_penetration() */
PW85_API int pw85_signed_distance(double const r12[3], double const q1[6], double const q2[6],
                                  double *distance, double point1[3], double point2[3]);

/** Computes the signed distance of two ellipsoids, as pw85_signed_distance() does, with the points
 * where it is reached and the normal there.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance,point1,point2 [as pw85_signed_distance()]
 * @param[out] normal [optional] unit vector, outward from ellipsoid 1 and into ellipsoid 2: the
 *        derivative of the signed distance with respect to r12
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for
 *        pw85_signed_distance() */
PW85_API int pw85_signed_distance_geometry(double const r12[3], double const q1[6],
                                           double const q2[6], double *distance, double point1[3],
                                           double point2[3], double normal[3]);

/** Computes the derivatives of the signed distance of two ellipsoids.
 *
 * At contact, the derivatives are the limits from both sides. The function has no output for
 * derivatives with respect to the entries of the forms. They are -n_i n_j/(2α) for q1 and -n_i
 * n_j/(2β) for q2, and twice that for entries off the diagonal, with n = d_r12 and the half-widths
 * α and β along n.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] d_r12 [optional; member r12] derivative with respect to r12: the unit normal to both
 *        surfaces at the points of pw85_signed_distance(), out of ellipsoid 1. If several
 *        directions give the same signed distance, the derivative does not exist, and the result is
 *        one of the subgradients
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] derivatives with
 *        respect to rotations, as for pw85_contact_torque()
 * @param[out] hessian [9×9; mixed units; optional] symmetric matrix of second derivatives, as for
 *        pw85_distance_derivatives(); NaN, also on success, if the extremum over the directions is
 *        not isolated, or so nearly degenerate that half of the digits would be lost
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for
 *        pw85_signed_distance() */
PW85_API int pw85_signed_distance_derivatives(double const r12[3], double const q1[6],
                                              double const q2[6], double d_r12[3], double d_rot1[3],
                                              double d_rot2[3], double hessian[81]);

/** Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2 inside it.
 *
 * Ellipsoid 2 can move by the gap in any direction without leaving ellipsoid 1. The gap is the
 * smallest value of α - β - n·r12 over unit vectors n, with the half-widths α and β of ellipsoids 1
 * and 2 along n. This function of n may have several local minima. The library proves that its
 * result is the global minimum. If several directions give the same value, the result is one of
 * them.
 *
 * `gap` is the value of α - β - n·r12 for the returned normal n, up to a few roundings. If the
 * minima are isolated, no other direction has a value that is smaller by more than 128 u α (1 +
 * α/β), with u = 2⁻⁵³ and α and β along the returned normal. If the minima are not isolated, as for
 * spheroids with a common axis, another direction may have a value that is smaller by up to 2⁻²⁰ of
 * the gap (2⁻⁴⁰ in two dimensions).
 *
 * The time is 50 to 300 times that of pw85_contact() if the minima are isolated. Otherwise it is up
 * to a few tenths of a second.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] gap [length; optional] the gap, in the unit of r12; zero if the ellipsoids touch, or
 *        if ellipsoid 2 is not inside ellipsoid 1, as pw85_contains() decides
 * @param[out] point1,point2 [length; optional] the closest points of the surfaces of ellipsoids 1
 *        and 2, both relative to the centre of ellipsoid 1; NaN if ellipsoid 2 is not inside, also
 *        on success
 * @param[out] normal [optional] outward unit normal of both ellipsoids at these points, from point2
 *        to point1; the derivative of the gap with respect to r12 is its negative; NaN if ellipsoid
 *        2 is not inside, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the proof takes too long;
 *        this has never been seen) */
PW85_API int pw85_gap_inside(double const r12[3], double const q1[6], double const q2[6],
                             double *gap, double point1[3], double point2[3], double normal[3]);

/** Computes the distance of two ellipses; see pw85_distance().
 *
 * @param r12,q1,q2 [as pw85_distance()]
 * @param[out] distance,point1,point2 [as pw85_distance()] */
PW85_API int pw85_distance_2d(double const r12[2], double const q1[3], double const q2[3],
                              double *distance, double point1[2], double point2[2]);

/** Computes the distance of two ellipses with the closest points and the normal; see
 * pw85_distance_geometry().
 *
 * @param r12,q1,q2 [as pw85_distance_geometry()]
 * @param[out] distance,point1,point2,normal [as pw85_distance_geometry()] */
PW85_API int pw85_distance_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                                       double *distance, double point1[2], double point2[2],
                                       double normal[2]);

/** Computes the penetration depth of two ellipses; see pw85_penetration().
 *
 * @param r12,q1,q2 [as pw85_penetration()]
 * @param[out] depth,direction [as pw85_penetration()] */
PW85_API int pw85_penetration_2d(double const r12[2], double const q1[3], double const q2[3],
                                 double *depth, double direction[2]);

/** Computes the signed distance of two ellipses; see pw85_signed_distance().
 *
 * @param r12,q1,q2 [as pw85_signed_distance()]
 * @param[out] distance,point1,point2 [as pw85_signed_distance()] */
PW85_API int pw85_signed_distance_2d(double const r12[2], double const q1[3], double const q2[3],
                                     double *distance, double point1[2], double point2[2]);

/** Computes the signed distance of two ellipses with the points where it is reached and the normal;
 * see pw85_signed_distance_geometry().
 *
 * @param r12,q1,q2 [as pw85_signed_distance_geometry()]
 * @param[out] distance,point1,point2,normal [as pw85_signed_distance_geometry()] */
PW85_API int pw85_signed_distance_geometry_2d(double const r12[2], double const q1[3],
                                              double const q2[3], double *distance,
                                              double point1[2], double point2[2], double normal[2]);

/** Computes the least gap of ellipse 2 inside ellipse 1; see pw85_gap_inside().
 *
 * @param r12,q1,q2 [as pw85_gap_inside()]
 * @param[out] gap,point1,point2,normal [as pw85_gap_inside()] */
PW85_API int pw85_gap_inside_2d(double const r12[2], double const q1[3], double const q2[3],
                                double *gap, double point1[2], double point2[2], double normal[2]);

/** @}
 * @name Time
 *
 * The ellipsoids translate at constant velocities, rotate about their centres at constant angular
 * velocities, and grow at constant rates. The time of the first contact is the least time in [0,
 * t_max] at which μ <= 1, or infinity if there is no contact. The search skips only time intervals
 * that are proved free of contact, and ends at a time at which μ² = 1 up to rounding. A finite
 * result does not depend on t_max, not even in its last bit.
 *
 * Let S be the sensitivity of μ² to the input: relative errors ε of the input data change μ² by at
 * most ε S, to first order. At time t
 *
 *     S = cond + Σ_i |∂μ²/∂r_i| (|r12_i| + t |v1_i| + t |v2_i|)
 *             + Σ_k (1 + t |ω_k| + t |g_k|) max|Q_k| Σ_ij |∂μ²/∂Q_k,ij|
 *
 * with cond of pw85_condition(), the velocities v, angular velocities ω and growths g of the
 * motions, and the forms Q_k at time t. The sum over k is over the ellipsoids that rotate or grow.
 *
 * At the returned time t, |μ² - 1| <= 80 u S with u = 2⁻⁵³, and μ² >= 1 - 80 u S at all earlier
 * times. The error of t is therefore at most 80 u S/|dμ²/dt| + 2 u t, unless dμ²/dt = 0 (a grazing
 * contact). If the least μ² exceeds 1 by no more than 80 u S, the pair may count as touching.
 *
 * A pair that overlaps at time 0 has its first contact at time 0. Pairs that have just collided are
 * an exception: if the ellipsoids separate at time 0, and touch, or overlap by at most 128 times
 * the bound on the rounding error of μ², t is the time of their next contact. In this case the
 * bound on μ² at earlier times holds only from the time at which they are apart.
 * @{ */

/** Motion of an ellipsoid. */
typedef struct pw85_motion {
    /** velocity of the centre, in units of length per unit of time. */
    double velocity[3];
    /** angular velocity about the centre, in radians per unit of time. */
    double angular_velocity[3];
    /** rate of growth: at time t the semi-axes are 1 + growth·t times those at time
     * 0. */
    double growth;
} pw85_motion;

/** Computes the time of the first contact of two moving ellipsoids.
 *
 * @param r12,q1,q2 [as pw85_contact()] at time 0
 * @param motion1,motion2 [mixed units; > 0 until t_max] motions of the ellipsoids; their semi-axes
 *        must be > 0 until t_max
 * @param t_max [time; >= 0; or infinite] the last time at which a contact counts
 * @param[out] t [time; member time] the time of the first contact, or infinity if there is none
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (one of three: the search
 *        ends after 100,000 steps, because the ellipsoids rotate near each other, without contact,
 *        by more than 50,000 radians, or by more than 10,000 at aspect ratio 1000; sizes, the
 *        relative velocity or the time leave the range of double; rounding errors leave no digit of
 *        an orientation or a form, after more than 2⁴³ radians or at an aspect ratio above 10⁷) */
PW85_API int pw85_first_contact(double const r12[3], double const q1[6], double const q2[6],
                                pw85_motion const *motion1, pw85_motion const *motion2,
                                double t_max, double *t);

/** Computes the least μ² while ellipsoid 2 translates past ellipsoid 1 on a straight path, and the
 * time of this minimum.
 *
 * This is the minimum of the contact function for the separations r12 + t velocity, 0 <= t <=
 * t_max. μ² is a convex function of t, so the minimum is unique unless the velocity is zero. The
 * ellipsoids overlap somewhere on this path if and only if the exact minimum is below 1.
 *
 * The error of μ² is below 8 u S, with u = 2⁻⁵³. Here S = μ² cond + 2 λ(1-λ) Σ|n_i| (|r12_i| + t
 * |velocity_i|), with cond, λ and n of pw85_condition() for the pair at time t. Relative errors ε
 * of the given numbers change μ² by at most ε S, to first order.
 *
 * @param r12,q1,q2 [as pw85_contact()] at time 0
 * @param velocity [length/time] velocity of ellipsoid 2 relative to ellipsoid 1; it may be zero
 * @param t_max [time; >= 0; or infinite] the end of the path
 * @param[out] mu2 [optional] the least μ²; 0 if ellipsoid 2 passes the centre of ellipsoid 1
 * @param[out] t [time; optional; member time] the time of the least μ², in [0, t_max]; 0 for a zero
 *        velocity or r12 = 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_passage(double const r12[3], double const q1[6], double const q2[6],
                                  double const velocity[3], double t_max, double *mu2, double *t);

/** Computes the free path of ellipsoid 1: how far it may move until it touches ellipsoid 2.
 *
 * Ellipsoid 1 moves by t times `direction`, and the separation is then r12 - t direction. If the
 * ellipsoids do not overlap at t = 0, they do not overlap at the returned t or before: rounding
 * errors make t smaller, never larger. At the returned t the ellipsoids touch up to rounding: μ² <=
 * 1 + 80 u S, with u = 2⁻⁵³ and S as for pw85_first_contact().
 *
 * t is 0 if the ellipsoids overlap at t = 0, or touch and do not separate. If they separate, an
 * overlap of at most 128 times the bound on the rounding error of μ² is ignored.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param direction [!= 0] of any length
 * @param t_max [length; >= 0; or infinite] the end of the path, as a multiple of `direction`: a
 *        length if `direction` is a unit vector
 * @param[out] t [length; member length] the free path, in the unit of t_max, from 0 to t_max, or
 *        infinity if there is no contact on the path
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for
 *        pw85_first_contact() */
PW85_API int pw85_free_path(double const r12[3], double const q1[6], double const q2[6],
                            double const direction[3], double t_max, double *t);

/** @}
 * @name Building blocks
 *
 * These functions are public for tests and experiments. Functions with two underscores in their
 * names may change between minor versions.
 * @{ */

/** Computes the Cholesky factorisation A = L Lᵀ.
 *
 * @param a symmetric positive definite matrix
 * @param[out] l [NaN on error] lower triangle of L by columns: (l11, l21, l31, l22, l32, l33); NaN
 *        if a pivot, computed in double, is not positive. If `a` is singular to working precision,
 *        rounding errors decide whether the result is NaN. */
PW85_API void pw85__cholesky_decomp(double const a[6], double l[6]);

/** Solves L Lᵀ x = b.
 *
 * @param l from pw85__cholesky_decomp()
 * @param b right-hand side
 * @param[out] x solution; may be the same array as b */
PW85_API void pw85__cholesky_solve(double const l[6], double const b[3], double x[3]);

/** Computes f, the residual g = μ2² - μ1² = -f' and its derivative g'. The root of g is the
 * maximiser of f.
 *
 * @param lambda in [0, 1]
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [NaN on error] (f, g, g') at λ; NaN for invalid input */
PW85_API void pw85__residual(double lambda, double const r12[3], double const q1[6],
                             double const q2[6], double out[3]);

/** Computes -f(λ), with all parameters in one array, as the callback of a minimiser.
 *
 * @param lambda in [0, 1]
 * @param params [15; mixed units] r12, q1, q2, one after the other
 * @return [NaN on error] -f(λ); NaN for invalid input */
PW85_API double pw85_f_neg(double lambda, double const *params);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
