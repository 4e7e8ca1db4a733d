/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85.h
 * @brief The contact function of Perram and Wertheim for two ellipsoids: one pair, in C.
 *
 * It includes pw85_shapes.h, which has walls, points, lines and other shapes, and pw85_grains.h,
 * which has curvatures and contacts. Many pairs are in pw85_batch.h, systems of particles in
 * pw85_systems.h, Monte Carlo in pw85_simulation.h.
 *
 * An ellipsoid with centre c and quadratic form Q is the set of points m with (m-c)ᵀ Q⁻¹ (m-c)
 * <= 1. Q is symmetric positive definite; its eigenvalues are the squares of the semi-axes, its
 * eigenvectors their directions. For two ellipsoids with forms Q1, Q2 and r12 = c2 - c1, the
 * contact function is
 *
 *     μ² = max { f(λ), 0 <= λ <= 1 },    f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12.
 *
 * μ is the common factor by which both ellipsoids must be scaled, their centres fixed, to touch
 * from outside: μ² < 1 if they overlap, μ² > 1 if they are apart (J. W. Perram and M. S. Wertheim,
 * J. Comp. Phys. 58, 409, 1985).
 *
 * Conventions, for every function of these headers unless it says otherwise:
 *
 * - Vectors are `double[3]`. Symmetric matrices are `double[6]`: the upper triangle in row-major
 *   order, (xx, xy, xz, yy, yz, zz). In two dimensions they are `double[2]` and `double[3]` (xx,
 *   xy, yy).
 * - Lengths are in any one unit; forms are in its square; μ² and λ have none.
 * - The caller owns all arrays. The library does not use them after the call. They need no
 *   alignment beyond that of double. Outputs may not overlap inputs.
 * - The brackets behind the name of a parameter state its extents, as n×3, its unit, as length²,
 *   and which values it may have, as > 0. A pointer that is `optional` may be null; an input `or
 *   infinite` may be infinite; a form must be positive `definite`; an `index` is at least 0 and
 *   below the number of particles or vertices. `as pw85_contact()` means: as the parameter of the
 *   same name of that function. `member` names the member of the result in C++ that an output
 *   receives.
 * - A function that returns `int` returns a status, zero for success. When it is not zero, all
 *   outputs are NaN, except those whose brackets give another value, as "-1 on error". An optional
 *   output may be null: it is then not written.
 * - #PW85_EINVAL has three causes, the same in every function: a pointer is null that is not
 *   optional; a number is NaN or infinite, and its brackets do not allow that; or an argument is
 *   not what its brackets state. #PW85_ENOTPD says that a form is not positive definite. The
 *   chapter on errors has a table. pw85_last_error() tells which argument and which row it was.
 * - Functions of one pair, one ellipsoid, many rows or a pair list in two and three dimensions
 *   allocate no memory, except pw85_law_forces_pairs(). Those that can allocate list #PW85_ENOMEM
 *   or #PW85_EDEVICE: neighbour lists, meshes, laws of pairs, simulations, ellipsoids around
 *   points, n dimensions and GPUs. No function prints anything or ends the process.
 * - Any number of threads may call any functions at the same time, but only one at a time may use
 *   the same simulation. The library has two pieces of state: the mode of pw85_set_reproducible(),
 *   for the process, and the cause that pw85_last_error() tells, for each thread.
 * - No function needs more than 16 KiB of stack, those of meshes no more than 24 KiB, plus what the
 *   dynamic linker needs for lazy binding at the first call. The threads that a batch starts have
 *   stacks of their own, whose size OMP_STACKSIZE sets.
 * - Functions compute in the default floating-point environment. The rounding mode, status flags
 *   and traps of the caller do not change the results, and after the call they are as they were
 *   before.
 * - For semi-axes and distances from 1e-150 to 1e150 no intermediate result overflows or
 *   underflows; a result beyond the range of double is infinity or zero.
 * - A form is positive definite if its leading principal minors are positive. That is decided
 *   without rounding errors, for the doubles as given, and every function and every instruction set
 *   decides alike. There are two limits. The determinant must exceed 2⁻²¹² times the product of the
 *   diagonal entries. Semi-axes may not differ by more than a factor of about 1e38.
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

/** Absolute tolerance on λ of Brent's method in pw85_contact_function(). It is that of a problem
 * in which both ellipsoids have been scaled to similar size. */
#define PW85_LAMBDA_ATOL 1e-6

/** Maximum number of iterations of Brent's method in pw85_contact_function(). */
#define PW85_MAX_ITER 25

/** Maximum number of iterations that refine the result of Brent's method in
 * pw85_contact_function(): Halley's method in the variable log(λ/(1-λ)), Newton's in pw85 1.0. */
#define PW85_NR_ITER 3

#ifdef __cplusplus
extern "C" {
#endif

/** Status codes: the values that functions returning `int` return. */
enum pw85_status {
#define PW85_STATUS_ENUMERATOR(c_name, cpp_name, value, text) , c_name = value
    PW85_SUCCESS = 0 PW85_ERROR_LIST(PW85_STATUS_ENUMERATOR)
#undef PW85_STATUS_ENUMERATOR
};

/** @name Version and errors
 * @{ */

/** Version of the library that is linked. Compare with #PW85_VERSION, the version of the header.
 *
 * @return "major.minor.patch", a constant */
PW85_API char const *pw85_version(void);

/** Meaning of a status, as a short text without a full stop.
 *
 * @param status any number
 * @return the text, a constant; never null */
PW85_API char const *pw85_strerror(int status);

/** Switches the reproducible mode on or off, for all threads of the process.
 *
 * In this mode all functions give the same bits on every processor and with every number of
 * threads: on x86-64 with any instruction set, 32-bit x86 with SSE2, 64-bit ARM and z/Architecture,
 * whatever the byte order. The functions use no fused multiplication and addition, and registers of
 * two doubles at most. The functions of many pairs are therefore slower. pw85_contact_function()
 * returns the numbers of pw85_contact(), because another library provides Brent's method. The
 * functions of pw85_gpu.h and pw85_zheng.h and the templates of the C++ headers do not follow the
 * mode.
 *
 * If the environment variable PW85_REPRODUCIBLE is neither empty nor 0 at the first call of a
 * function, the process starts in this mode. A call that runs in another thread while the mode
 * changes may compute some of its pairs in either mode.
 *
 * @param on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_set_reproducible(int on);

/** State of the reproducible mode: see pw85_set_reproducible().
 *
 * @param[out] on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_is_reproducible(int *on);

/** @}
 * @name Quadratic forms
 * @{ */

/** Quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ.
 *
 * @param a [length; > 0] equatorial radius
 * @param c [length; > 0] polar radius
 * @param n [!= 0] direction of the axis of revolution, of any length
 * @param[out] q [length²; NaN on error] the form; NaN if a length is not positive or its square
 *        leaves the range of double, or n is zero or not finite */
PW85_API void pw85_spheroid(double a, double c, double const n[3], double q[6]);

/** Quadratic form of a general ellipsoid, Q = R diag(semi_axes²) Rᵀ.
 *
 * @param semi_axes [length; > 0; finite square] lengths of the principal semi-axes (not diameters),
 *        whose squares are in the range of double
 * @param rotation [3×3; rotation] matrix R in row-major order. Its columns are the principal
 *        directions: R takes the body frame to the space frame. RᵀR may differ from I by at most
 *        1e-6 in any entry (single precision is accepted); reflections are accepted.
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6]);

/** Quadratic form of a general ellipsoid whose orientation is a quaternion.
 *
 * @param semi_axes [as pw85_ellipsoid()]
 * @param quaternion [!= 0] (w, x, y, z), scalar first, of any length; the function normalises it.
 *        It takes the body frame to the space frame.
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_quaternion(double const semi_axes[3], double const quaternion[4],
                                       double q[6]);

/** Factor S of the quadratic form of a general ellipsoid, Q = S Sᵀ. The factor keeps the digits
 * that squares of lengths lose: see pw85_contact_factored().
 *
 * @param semi_axes,quaternion [as pw85_ellipsoid_quaternion()]
 * @param[out] s [3×3; length] matrix in row-major order; its columns are the semi-axes as vectors
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_factor(double const semi_axes[3], double const quaternion[4],
                                   double s[9]);

/** Quadratic form (xx, xy, yy) of an ellipse.
 *
 * @param a,b [length; > 0; finite square] semi-axes, whose squares are in the range of double
 * @param angle from the x axis to the first semi-axis, counter-clockwise, in radians
 * @param[out] q [length²] the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipse(double a, double b, double angle, double q[3]);

/** @}
 * @name Contact of two ellipsoids
 * @{ */

/** Contact function of two ellipsoids, by a third-order iteration on log(λ/(1-λ)).
 *
 * The relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the entrywise condition number of
 * pw85_condition(), also for forms that are singular to working precision. The function evaluates f
 * at most 157 times.
 *
 * @param r12 [length] from the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid: μ² = 0,
 *        λ = 1/2
 * @param q1,q2 [length²; definite] forms of the ellipsoids, in the square of the unit of r12
 * @param[out] out [members mu2, lambda] μ², and the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL (null pointer, NaN or infinity), #PW85_ENOTPD,
 *        #PW85_ECONVERGENCE (the bound on the error cannot be proved; this has never been seen) */
PW85_API int pw85_contact(double const r12[3], double const q1[6], double const q2[6],
                          double out[2]);

/** Contact function of two ellipsoids, with μ² correctly rounded: it is the double nearest to the
 * exact value for the numbers given.
 *
 * If two doubles are equally near, μ² is the one whose last bit is 0. Underflow and overflow follow
 * the same rule: a μ² that is at least 2¹⁰²⁴ - 2⁹⁷⁰ becomes infinity, with success. λ errs by less
 * than one unit in the last place. Every processor and every instruction set therefore gives the
 * same μ². An exchange of the two ellipsoids does not change μ². Other units that are powers of two
 * do not change it if μ² stays in the range of normal doubles.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the last digit of λ
 *        cannot be proved; this has never been seen) */
PW85_API int pw85_contact_rounded(double const r12[3], double const q1[6], double const q2[6],
                                  double out[2]);

/** Contact function of two ellipsoids that are given by factors of their forms, Q1 = S1 S1ᵀ and Q2
 * = S2 S2ᵀ.
 *
 * Rounding a form to doubles changes μ² by some 1e-12 at aspect ratio 100, 1e-8 at 10⁴ and 1e-4 at
 * 10⁶: an entry of the form adds the squares of long and of short semi-axes, and rounding it to
 * double loses digits of the short ones. Rounding a factor changes μ² by less than 1e-14, 1e-12 and
 * 1e-12. The relative error of the result is below 4 u c. Here c is the relative change of μ², to
 * first order, for relative changes of one in the entries of s1, s2 and r12.
 *
 * @param r12 [as pw85_contact()]
 * @param s1,s2 [3×3; length] row-major, as pw85_ellipsoid_factor() makes them. Any matrix S counts
 *        as a factor if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
 *        lengths of its columns differ by less than a factor of 2¹²⁷.
 * @param[out] out [members mu2, lambda] μ², and the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly),
 *        #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_contact_factored(double const r12[3], double const s1[9], double const s2[9],
                                   double out[2]);

/** Condition number of the contact function: if each entry of r12, q1 and q2 changes by a fraction
 * ε of itself, μ² changes by a fraction of at most ε cond, to first order in ε.
 *
 * Data that are known to d digits give μ² to d - log10(cond) digits. The condition number is of the
 * order of one for ordinary pairs, and of the order of the squared aspect ratio for slender ones.
 * It is [λ(1-λ) Σ |n_i| ((1-λ) |q1_ij| + λ |q2_ij|) |n_j| + 2 λ(1-λ) Σ |r12_i n_i|]/μ² with n =
 * [(1-λ) q1 + λ q2]⁻¹ r12, the sums over all i and j.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] from pw85_contact()
 * @param[out] cond [member condition] the condition number: at least 3, or 0 for r12 = 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_condition(double const r12[3], double const q1[6], double const q2[6],
                            double lambda, double *cond);

/** Contact function of two ellipsoids, by Brent's method on f, refined by Halley's method, with the
 * arguments of pw85 1.0, which used Newton's. For the contract see pw85_contact(), which is several
 * times faster.
 *
 * The relative error of μ² is below 4 u cond, too. Brent's method works on a problem in which both
 * ellipsoids have been scaled to similar size. #PW85_LAMBDA_ATOL therefore has the same meaning for
 * ellipsoids of all sizes.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()] */
PW85_API int pw85_contact_function(double const r12[3], double const q1[6], double const q2[6],
                                   double out[2]);

/** Point at which the ellipsoids, scaled by μ, touch, and their common normal.
 *
 * @param r12 [as pw85_contact(); != 0]
 * @param q1,q2 [as pw85_contact()]
 * @param lambda [0..1] from pw85_contact(). Any other value in (0, 1) gives the point x0(λ) of the
 *        chapter on theory: it is on both ellipsoids when they are scaled by the factors μ1 and μ2
 *        for which f(λ) = λ μ1² + (1-λ) μ2².
 * @param[out] point [length; optional] relative to the centre of ellipsoid 1
 * @param[out] normal [optional] unit vector, outward from ellipsoid 1 and into ellipsoid 2
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD */
PW85_API int pw85_contact_geometry(double const r12[3], double const q1[6], double const q2[6],
                                   double lambda, double point[3], double normal[3]);

/** pw85_contact_geometry() of ellipsoids that are given by factors of their forms.
 *
 * The errors are below 4 u times the change that follows if each entry of a factor changes by the
 * largest entry of its column, and each coordinate of r12 by itself. This holds for the lambda
 * given.
 *
 * @param r12 [as pw85_contact_factored(); != 0]
 * @param s1,s2 [as pw85_contact_factored()]
 * @param lambda [0..1] from pw85_contact_factored()
 * @param[out] point,normal [as pw85_contact_geometry()]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD
 *        (a factor is singular, or nearly) */
PW85_API int pw85_contact_geometry_factored(double const r12[3], double const s1[9],
                                            double const s2[9], double lambda, double point[3],
                                            double normal[3]);

/** Derivatives of μ².
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] from pw85_contact()
 * @param[out] d_r12 [1/length; optional; member r12] ∂μ²/∂r12; its negative is the derivative with
 *        respect to the centre of ellipsoid 1
 * @param[out] d_q1,d_q2 [1/length²; optional; member q1, q2] derivatives with respect to the stored
 *        entries of q1 and q2 (an off-diagonal entry stands for two entries of the matrix)
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_contact_gradient(double const r12[3], double const q1[6], double const q2[6],
                                   double lambda, double d_r12[3], double d_q1[6], double d_q2[6]);

/** Derivatives of μ² of ellipsoids that are given by factors of their forms.
 *
 * The derivative with respect to a factor S is 2 (∂μ²/∂Q) S, with the symmetric matrix ∂μ²/∂Q. A
 * change dS of the factor changes μ² by Σ d_s_ij dS_ij. The errors are those of
 * pw85_contact_geometry_factored().
 *
 * @param r12,s1,s2 [as pw85_contact_factored()]
 * @param lambda [0..1] from pw85_contact_factored()
 * @param[out] d_r12 [as pw85_contact_gradient()]
 * @param[out] d_s1,d_s2 [3×3; 1/length; optional; member s1, s2] row-major: derivatives with
 *        respect to the entries of s1 and s2
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD (a factor
 *        is singular, or nearly) */
PW85_API int pw85_contact_gradient_factored(double const r12[3], double const s1[9],
                                            double const s2[9], double lambda, double d_r12[3],
                                            double d_s1[9], double d_s2[9]);

/** Derivatives of μ² with respect to rotations: for a rotation of an ellipsoid about its own centre
 * by the small vector ω, dμ² = d_rot·ω. The torque of an energy U(μ²) is -U'(μ²) d_rot.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param lambda [0..1] from pw85_contact()
 * @param[out] d_rot1,d_rot2 [optional; member rotation1, rotation2] per radian, for ellipsoids 1
 *        and 2
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_contact_torque(double const r12[3], double const q1[6], double const q2[6],
                                 double lambda, double d_rot1[3], double d_rot2[3]);

/** Second derivatives of μ².
 *
 * The relative error of the derivatives is a few times that of λ and 1-λ. The relative error of λ
 * from pw85_contact() is some u times the squared aspect ratio. If ellipsoid 1 is much larger than
 * ellipsoid 2, the relative error of 1-λ is u/(1-λ).
 *
 * @param r12 [as pw85_contact(); != 0]
 * @param q1,q2 [as pw85_contact()]
 * @param lambda [0..1] from pw85_contact()
 * @param[out] hessian [9×9; mixed units; member entries] symmetric: second derivatives with respect
 *        to r12, rotation 1 and rotation 2. A vector ω describes the rotation by the angle |ω|
 *        about the direction of ω. λ is not held fixed: it maximises f for each changed pair.
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD */
PW85_API int pw85_contact_hessian(double const r12[3], double const q1[6], double const q2[6],
                                  double lambda, double hessian[81]);

/** Tests whether two ellipsoids overlap, μ² < 1. Tangent ellipsoids (μ² = 1) do not overlap.
 *
 * The answer is exact for the numbers given. Bounds that account for rounding decide almost all
 * pairs; exact arithmetic decides the others.
 *
 * @param r12 [as pw85_contact()] zero is an overlap
 * @param q1,q2 [as pw85_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap(double const r12[3], double const q1[6], double const q2[6],
                          int *overlap);

/** Tests whether two ellipsoids overlap that are given by factors of their forms, Q1 = S1 S1ᵀ and
 * Q2 = S2 S2ᵀ.
 *
 * The answer is exact for the exact products of the factors given. It may differ from the answer of
 * pw85_overlap() for the rounded products. Separating planes and common points, with bounds that
 * account for rounding, decide almost all pairs. Integers decide the others, if their digits fit:
 * the entries of s1 and s2, and r12, must be multiples of a power of two and smaller than 2¹⁵⁰⁰
 * times that power.
 *
 * @param r12 [as pw85_contact_factored()] zero is an overlap
 * @param s1,s2 [as pw85_contact_factored()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly),
 *        #PW85_ECONVERGENCE (the pair is so near contact that only integers can decide, and their
 *        digits do not fit) */
PW85_API int pw85_overlap_factored(double const r12[3], double const s1[9], double const s2[9],
                                   int *overlap);

/** Sign of μ² - mu2, for any number mu2 >= 0.
 *
 * The sign is exact for the numbers given; pw85_overlap() is the case mu2 = 1. A bound on the error
 * of μ² decides almost all pairs; exact arithmetic decides the others.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param mu2 [>= 0; or infinite] the number to compare with
 * @param[out] sign [2 on error] -1 if μ² < mu2, 0 if they are equal, 1 if μ² > mu2
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_compare(double const r12[3], double const q1[6], double const q2[6], double mu2,
                          int *sign);

/** Tests whether two ellipsoids overlap, as pw85_overlap() does, and gives a number or a point that
 * proves the answer.
 *
 * The proof holds in exact arithmetic for the numbers given, and rational arithmetic can check it.
 * Tangent ellipsoids do not overlap, and have no such proof: `lambda` and `point` are NaN, and the
 * status is success. The function finds a λ that proves that ellipsoids are apart, if there is one
 * among the doubles. It searches for a common point near the point where the ellipsoids, scaled by
 * μ, touch. If 1 - μ² is below 1e-13, it may find none.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @param[out] lambda [optional] λ from 0 to 1, with f(λ) > 1, if the ellipsoids are apart;
 *        otherwise NaN, also on success
 * @param[out] point [length; optional] a point inside both ellipsoids and on neither surface,
 *        relative to the centre of ellipsoid 1, if they overlap; otherwise NaN, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (no proof among the
 *        doubles was found; seen only where μ² differs from one by less than 1e-13, at aspect
 *        ratios up to 10⁸) */
PW85_API int pw85_overlap_witness(double const r12[3], double const q1[6], double const q2[6],
                                  int *overlap, double *lambda, double point[3]);

/** Tests whether ellipsoid 2 is inside ellipsoid 1. It may touch the surface of ellipsoid 1 from
 * inside.
 *
 * The answer is exact for the numbers given. Every ellipsoid is inside itself.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] contains [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contains(double const r12[3], double const q1[6], double const q2[6],
                           int *contains);

/** Factor by which ellipsoid 1 must be scaled, its centre fixed, to contain ellipsoid 2, and the
 * point where the ellipsoids then touch.
 *
 * The square of the factor is the largest value of xᵀ q1⁻¹ x over the points x of ellipsoid 2. It
 * is at most 1 if ellipsoid 2 is inside ellipsoid 1; pw85_contains() decides this without rounding
 * errors. The relative error is below 16 u c, with u = 2⁻⁵³, where u c is the fraction by which the
 * square can change if each entry of r12, q1 and q2 changes by a fraction u of itself. The search
 * proves the result by bounds from both sides.
 *
 * @param r12 [as pw85_contact()] zero is valid
 * @param q1,q2 [as pw85_contact()]
 * @param[out] mu2 [optional] square of the factor
 * @param[out] point [length; optional] the point on the surface of ellipsoid 2, relative to the
 *        centre of ellipsoid 1. If the ellipsoids touch at several points, the result is one of
 *        them. They touch at several points for r12 = 0, and where r12 is short and has no
 *        component along the longest semi-axis that ellipsoid 2 has after the linear map that makes
 *        ellipsoid 1 a unit ball
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the bounds cannot be
 *        made to agree; this has never been seen) */
PW85_API int pw85_containment(double const r12[3], double const q1[6], double const q2[6],
                              double *mu2, double point[3]);

/** Distance of closest approach: the distance of the centres at which two ellipsoids of fixed
 * orientation touch from outside, when their centres are on a line of given direction d. It is
 * |d|/μ(d).
 *
 * @param direction [!= 0] from centre 1 to centre 2, of any length
 * @param q1,q2 [length²; definite] forms of the ellipsoids
 * @param[out] distance [length] distance of the centres, in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD,
 *        #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_approach(double const direction[3], double const q1[6],
                                   double const q2[6], double *distance);

/** @}
 * @name Volumes and common parts
 * @{ */

/** Volume of an ellipsoid, (4/3)π √det q.
 *
 * The relative error is below 2⁻⁵² if the semi-axes differ by a factor below 10⁷. For a larger
 * factor k it is below 2⁻⁵² k²/10¹⁴.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] volume [length³] the volume, in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_volume(double const q[6], double *volume);

/** Volume of the common part of two ellipsoids.
 *
 * The volume is 0 exactly if pw85_overlap() says that the ellipsoids do not overlap. It is
 * pw85_volume() of the smaller ellipsoid exactly if pw85_contains() says that this one is inside
 * the other one. Otherwise the error is below u (64 v + 16 s), with u = 2⁻⁵³, the volume v of the
 * smaller one, and s = Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + the same sum for q2,
 * over the entries and derivatives of pw85_overlap_volume_gradient(). If the common part, or what
 * remains of the smaller ellipsoid, is as thin as rounding errors, it may count as empty: the
 * volume is then 0, or that of the smaller ellipsoid.
 *
 * @param r12 [as pw85_contact()] zero is valid
 * @param q1,q2 [as pw85_contact()]
 * @param[out] volume [length³] the volume, in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (by the linear map that
 *        takes the smaller ellipsoid to a unit ball, the other one becomes a disc that is
 *        thinner than 2⁻²¹; the integral does not converge; or 32 digits are not enough for the
 *        bound, which is seen at aspect ratios above 10⁵) */
PW85_API int pw85_overlap_volume(double const r12[3], double const q1[6], double const q2[6],
                                 double *volume);

/** Derivatives of the volume of the common part.
 *
 * The derivatives are 0 if the ellipsoids do not overlap. If one ellipsoid is inside the other one,
 * only the derivatives of its own volume are not 0. If the surfaces touch from inside at a point,
 * except for some 10⁻¹⁷ of their size, and cross elsewhere, 32 digits may not be enough
 * (#PW85_ECONVERGENCE). The error of the derivative with respect to a number p is below u (256 m +
 * 64 s), with u = 2⁻⁵³ and s = Σ|r12_i ∂²V/∂r12_i∂p| + Σ √(q1_ii q1_jj) |∂²V/∂q1_ij∂p| + the same
 * for q2. With the volume v of the smaller ellipsoid, the inverse P of its form, and the inverse P'
 * of the form to which p belongs, m is v √P_ii for r12_i, v √(P_ii P'_ii) for a diagonal entry, and
 * v (√(P_ii P'_jj) + √(P_jj P'_ii)) for another entry.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] d_r12 [length²; optional; member r12] ∂V/∂r12; its negative is the derivative with
 *        respect to the centre of ellipsoid 1
 * @param[out] d_q1,d_q2 [length; optional; member q1, q2] derivatives with respect to the stored
 *        entries of q1 and q2 (an off-diagonal entry stands for two entries of the matrix)
 * @return as for pw85_overlap_volume() */
PW85_API int pw85_overlap_volume_gradient(double const r12[3], double const q1[6],
                                          double const q2[6], double d_r12[3], double d_q1[6],
                                          double d_q2[6]);

/** Derivatives of the volume of the common part with respect to rotations: for a rotation of an
 * ellipsoid about its own centre by the small vector ω, dV = d_rot·ω. The torque of an energy U(V)
 * is -U'(V) d_rot. With ∂V/∂r12 from pw85_overlap_volume_gradient(), d_rot1 + d_rot2 + r12 ×
 * ∂V/∂r12 = 0. The derivatives are the axial vectors of 2 q1 G1 and 2 q2 G2 with the matrices G of
 * ∂V/∂q, and their errors follow from those of G: each is below twice the sum of |q_ij| times the
 * bound for G_jk over the products that the vector is made of.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] d_rot1,d_rot2 [length³; optional; member rotation1, rotation2] per radian, for
 *        ellipsoids 1 and 2
 * @return as for pw85_overlap_volume() */
PW85_API int pw85_overlap_volume_torque(double const r12[3], double const q1[6], double const q2[6],
                                        double d_rot1[3], double d_rot2[3]);

/** Area of an ellipse, π √det q; see pw85_volume().
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] area [length²] the area, in the square of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_area_2d(double const q[3], double *area);

/** Area of the common part of two ellipses; see pw85_overlap_volume(). The bound on the error is
 * the same, with areas.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume()]
 * @param[out] area [length²] the area, in the square of the unit of length */
PW85_API int pw85_overlap_area_2d(double const r12[2], double const q1[3], double const q2[3],
                                  double *area);

/** Derivatives of the area of the common part; see pw85_overlap_volume_gradient(). The bounds on
 * the errors are the same, with areas.
 *
 * @param r12,q1,q2 [as pw85_overlap_volume_gradient()]
 * @param[out] d_r12 [as pw85_overlap_volume_gradient(); length]
 * @param[out] d_q1,d_q2 [as pw85_overlap_volume_gradient(); no unit] */
PW85_API int pw85_overlap_area_gradient_2d(double const r12[2], double const q1[3],
                                           double const q2[3], double d_r12[2], double d_q1[3],
                                           double d_q2[3]);

/** Derivatives of the area of the common part with respect to the angles of both ellipses,
 * counter-clockwise; see pw85_overlap_volume_torque().
 *
 * @param r12,q1,q2 [as pw85_overlap_volume_torque()]
 * @param[out] d_rot1,d_rot2 [length²; optional; member rotation1, rotation2] per radian */
PW85_API int pw85_overlap_area_torque_2d(double const r12[2], double const q1[3],
                                         double const q2[3], double *d_rot1, double *d_rot2);

/** @}
 * @name Two dimensions
 * @{ */

/** Contact function of two ellipses; see pw85_contact().
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [as pw85_contact()] */
PW85_API int pw85_contact_2d(double const r12[2], double const q1[3], double const q2[3],
                             double out[2]);

/** Point at which the ellipses, scaled by μ, touch, and their common normal; see
 * pw85_contact_geometry().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_geometry()]
 * @param[out] point,normal [as pw85_contact_geometry()] */
PW85_API int pw85_contact_geometry_2d(double const r12[2], double const q1[3], double const q2[3],
                                      double lambda, double point[2], double normal[2]);

/** Derivatives of μ² of two ellipses; see pw85_contact_gradient().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_gradient()]
 * @param[out] d_r12,d_q1,d_q2 [as pw85_contact_gradient()] */
PW85_API int pw85_contact_gradient_2d(double const r12[2], double const q1[3], double const q2[3],
                                      double lambda, double d_r12[2], double d_q1[3],
                                      double d_q2[3]);

/** Derivatives of μ² with respect to the angles of two ellipses, counter-clockwise; see
 * pw85_contact_torque().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_torque()]
 * @param[out] d_rot1,d_rot2 [optional; member rotation1, rotation2] per radian */
PW85_API int pw85_contact_torque_2d(double const r12[2], double const q1[3], double const q2[3],
                                    double lambda, double *d_rot1, double *d_rot2);

/** Second derivatives of μ² of two ellipses; see pw85_contact_hessian().
 *
 * @param r12,q1,q2,lambda [as pw85_contact_hessian()]
 * @param[out] hessian [4×4; mixed units; member entries] symmetric: with respect to r12, angle 1
 *        and angle 2 */
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

/** Factor by which ellipse 1 must be scaled to contain ellipse 2; see pw85_containment().
 *
 * @param r12,q1,q2 [as pw85_containment()]
 * @param[out] mu2,point [as pw85_containment()] */
PW85_API int pw85_containment_2d(double const r12[2], double const q1[3], double const q2[3],
                                 double *mu2, double point[2]);

/** Distance of closest approach of two ellipses; see pw85_closest_approach().
 *
 * @param direction,q1,q2 [as pw85_closest_approach()]
 * @param[out] distance [as pw85_closest_approach()] */
PW85_API int pw85_closest_approach_2d(double const direction[2], double const q1[3],
                                      double const q2[3], double *distance);

/** @}
 * @name Distance
 * @{ */

/** Distance of the surfaces of two ellipsoids, and the points where they are closest.
 *
 * The error of the distance is below 8 u Σ, with u = 2⁻⁵³ and Σ = Σ|n_i r12_i| + Σ|n_i q1_ij
 * n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β), the sums over all i and j. Rounding the data entry by entry
 * can change the distance by u Σ. Here n is the unit normal, and α and β are the half-widths of the
 * ellipsoids along it. The answer can be checked independently: any unit vector n gives a lower
 * bound n·r12 - α - β of the distance, and any two points of the ellipsoids give an upper bound.
 * `distance` is the lower bound for the normal that pw85_distance_derivatives() returns, and
 * |point2 - point1| is an upper bound.
 *
 * The vector point2 - point1 differs from `distance` times n by less than 2¹⁸ u (|r12| + |point1| +
 * |r12 - point2|), and |point2 - point1| differs from `distance` by no more than that. The points
 * are the closest points of a pair whose r12 differs by no more than that. The distance of each
 * point from the surface is below 2¹⁸ u times the longest semi-axis of its ellipsoid, plus the
 * rounding error u |point2| of its coordinates.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance [length; optional] the distance, in the unit of r12; zero if the ellipsoids
 *        overlap, as pw85_overlap() decides
 * @param[out] point1,point2 [length; optional] the closest points of ellipsoids 1 and 2, both
 *        relative to the centre of ellipsoid 1; NaN if the ellipsoids overlap, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the errors cannot be
 *        bounded; seen only beyond aspect ratio 10⁶) */
PW85_API int pw85_distance(double const r12[3], double const q1[6], double const q2[6],
                           double *distance, double point1[3], double point2[3]);

/** Derivatives of the distance of two ellipsoids that are apart; NaN if they overlap, also on
 * success.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] d_r12 [optional; member r12] the unit normal at the closest points, into ellipsoid 2
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] with respect to
 *        rotations, as for pw85_contact_torque()
 * @param[out] hessian [9×9; mixed units; optional] symmetric: second derivatives with respect to
 *        r12, rotation 1 and rotation 2, where the vector ω stands for the rotation by |ω| about ω
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() */
PW85_API int pw85_distance_derivatives(double const r12[3], double const q1[6], double const q2[6],
                                       double d_r12[3], double d_rot1[3], double d_rot2[3],
                                       double hessian[81]);

/** Depth of an overlap: the length of the shortest translation of ellipsoid 2 that separates two
 * ellipsoids.
 *
 * The depth is the smallest value of α + β - n·r12 over unit vectors n, with the half-widths α and
 * β of the ellipsoids along n. This function of n may have several local minima; the result is
 * proved to be the global one. `depth` is the value for the returned direction, with an error below
 * 8 u Σ, with Σ as for pw85_distance(). No other direction has a value that is smaller by more than
 * 32 u Σ, where Σ is the larger one of the two directions. If several directions are equally good,
 * the result is one of them. The time is 3 to 8 times that of pw85_contact() for more than nine in
 * ten random pairs, whose minimum has a certificate, 10 to 60 times that for the others, and about
 * a thousand times that if the best direction is not isolated.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] depth [length; optional] the depth, in the unit of r12; zero if the ellipsoids do not
 *        overlap, as pw85_overlap() decides
 * @param[out] direction [optional] unit vector along which ellipsoid 2 must move; NaN if the
 *        ellipsoids do not overlap, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the proof takes too
 *        long; seen only for forms that are singular to working precision) */
PW85_API int pw85_penetration(double const r12[3], double const q1[6], double const q2[6],
                              double *depth, double direction[3]);

/** Signed distance of two ellipsoids: their distance if they are apart, minus the depth of their
 * overlap otherwise.
 *
 * The signed distance is the largest value of n·r12 - α - β over unit vectors n, with the
 * half-widths α and β of the ellipsoids along n, whether they overlap or not. It is a convex
 * function of r12 with slope 1, and is continuous at contact. It is positive only if the ellipsoids
 * are apart and negative only if they overlap, as pw85_overlap() decides. Its error is that of
 * pw85_distance() if they are apart, and that of pw85_penetration() if they overlap.
 * pw85_penetration() also states the time that overlaps take.
 *
 * If they overlap, moving ellipsoid 2 by point1 - point2 separates them by the shortest way. If
 * several directions are equally good, the result belongs to one of them. For a direction that is
 * isolated, and aspect ratios up to 10³, point2 - point1 differs from `distance` times the unit
 * normal by less than 2¹⁸ u (|r12| + |point1| + |r12 - point2|), with u = 2⁻⁵³.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] distance [length; optional] the signed distance, in the unit of r12
 * @param[out] point1,point2 [length; optional] the points of the surfaces of ellipsoids 1 and 2
 *        where their normals are opposite and along point2 - point1: the closest points, or the
 *        deepest ones; both relative to the centre of ellipsoid 1
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance()
 *        and pw85_penetration() */
PW85_API int pw85_signed_distance(double const r12[3], double const q1[6], double const q2[6],
                                  double *distance, double point1[3], double point2[3]);

/** Derivatives of the signed distance of two ellipsoids.
 *
 * At contact they are the limits from both sides. The derivatives of the distance with respect to
 * the entries of the forms are -n_i n_j/(2α) and -n_i n_j/(2β), twice that for entries off the
 * diagonal, with the normal n = d_r12.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] d_r12 [optional; member r12] with respect to r12: the unit vector normal to both
 *        surfaces at the points of pw85_signed_distance(), out of ellipsoid 1. If several
 *        directions are equally good, the derivative does not exist, and this is one of the
 *        subgradients
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] with respect to
 *        rotations, as for pw85_contact_torque()
 * @param[out] hessian [9×9; mixed units; optional] symmetric: second derivatives as for
 *        pw85_distance_derivatives(); NaN, also on success, where the best direction is not
 *        isolated, or so nearly so that half of the digits would be lost
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for
 *        pw85_signed_distance() */
PW85_API int pw85_signed_distance_derivatives(double const r12[3], double const q1[6],
                                              double const q2[6], double d_r12[3], double d_rot1[3],
                                              double d_rot2[3], double hessian[81]);

/** Least gap between the surface of an ellipsoid and that of an ellipsoid that contains it.
 *
 * Ellipsoid 2 is inside ellipsoid 1, as for pw85_contains(). The gap is the least distance of the
 * surfaces, by which ellipsoid 2 can move in any direction without leaving ellipsoid 1. It is the
 * smallest value of α - β - n·r12 over unit vectors n, with the half-widths α and β of ellipsoids 1
 * and 2 along n. This function of n may have several local minima. The result is proved to be the
 * global one.
 *
 * `gap` is the value for the returned normal to a few roundings. No other direction has a value
 * that is smaller by more than 128 u α (1 + α/β), with u = 2⁻⁵³ and the α and β of the normal.
 * Where minima are not isolated, for example on circles of spheroids with a common axis, the proof
 * is coarser: in three dimensions another direction may have a value that is smaller by up to 2⁻²⁰
 * of the gap (in two, 2⁻⁴⁰). If several directions are equally good, the result is one of them. The
 * time is 50 to 300 times that of pw85_contact() for isolated minima, and up to some tenths of a
 * second otherwise.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] gap [length; optional] the gap, in the unit of r12; zero if the ellipsoids touch, or
 *        if ellipsoid 2 is not inside ellipsoid 1, as pw85_contains() decides
 * @param[out] point1,point2 [length; optional] the points of the surfaces of ellipsoids 1 and 2
 *        where they are closest, both relative to the centre of ellipsoid 1; NaN if ellipsoid 2 is
 *        not inside, also on success
 * @param[out] normal [optional] unit vector out of both ellipsoids at these points, from point2 to
 *        point1: minus the derivative of the gap with respect to r12; NaN if ellipsoid 2 is not
 *        inside, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the proof takes too
 *        long; this has never been seen) */
PW85_API int pw85_gap_inside(double const r12[3], double const q1[6], double const q2[6],
                             double *gap, double point1[3], double point2[3], double normal[3]);

/** Distance of two ellipses; see pw85_distance().
 *
 * @param r12,q1,q2 [as pw85_distance()]
 * @param[out] distance,point1,point2 [as pw85_distance()] */
PW85_API int pw85_distance_2d(double const r12[2], double const q1[3], double const q2[3],
                              double *distance, double point1[2], double point2[2]);

/** Depth of an overlap of two ellipses; see pw85_penetration().
 *
 * @param r12,q1,q2 [as pw85_penetration()]
 * @param[out] depth,direction [as pw85_penetration()] */
PW85_API int pw85_penetration_2d(double const r12[2], double const q1[3], double const q2[3],
                                 double *depth, double direction[2]);

/** Signed distance of two ellipses; see pw85_signed_distance().
 *
 * @param r12,q1,q2 [as pw85_signed_distance()]
 * @param[out] distance,point1,point2 [as pw85_signed_distance()] */
PW85_API int pw85_signed_distance_2d(double const r12[2], double const q1[3], double const q2[3],
                                     double *distance, double point1[2], double point2[2]);

/** Least gap between an ellipse and an ellipse that contains it; see pw85_gap_inside().
 *
 * @param r12,q1,q2 [as pw85_gap_inside()]
 * @param[out] gap,point1,point2,normal [as pw85_gap_inside()] */
PW85_API int pw85_gap_inside_2d(double const r12[2], double const q1[3], double const q2[3],
                                double *gap, double point1[2], double point2[2], double normal[2]);

/** @}
 * @name Time
 *
 * Ellipsoids that translate at constant velocities, turn about their centres at constant angular
 * velocities, and grow. The first contact is the least time in [0, t_max] at which μ <= 1; the time
 * is infinity if there is none. The search skips only time intervals that are proved free of
 * contact, and ends at a time at which the contact function shows contact. A larger t_max does not
 * change a bit of the result.
 *
 * At the time t that is returned |μ² - 1| <= 80 u S, with u = 2⁻⁵³, and before it μ² >= 1 - 80 u S.
 * So the error of t is at most 80 u S/|dμ²/dt| + 2 u t, unless the contact is grazing (dμ²/dt = 0).
 * S is the change of μ² at that time for relative errors of one in the given numbers:
 *
 *     S = cond + Σ_i |∂μ²/∂r_i| (|r12_i| + t |v1_i| + t |v2_i|)
 *             + Σ_k (1 + t |ω_k| + t |g_k|) max|Q_k| Σ_ij |∂μ²/∂Q_k,ij|
 *
 * cond is that of pw85_contact(); v, ω and g are the numbers of the motions, and Q_k is the form of
 * ellipsoid k at time t. The sum over k is over the ellipsoids that turn or grow. Pairs that miss
 * each other by no more than 80 u S count as touching. If a pair overlaps at time 0, its first
 * contact is at time 0, with one exception: if the overlap is no more than some hundred times its
 * rounding error and the ellipsoids separate, the pair counts as one that has just collided, and t
 * is the time of its next contact.
 * @{ */

/** Motion of an ellipsoid. */
typedef struct pw85_motion {
    /** velocity of the centre. */
    double velocity[3];
    /** angular velocity about the centre, in radians per unit of time. */
    double angular_velocity[3];
    /** At time t the semi-axes are 1 + growth·t times those at time 0. */
    double growth;
} pw85_motion;

/** Time of the first contact of two moving ellipsoids.
 *
 * @param r12,q1,q2 [as pw85_contact()] at time 0
 * @param motion1,motion2 [mixed units; > 0 until t_max] motions of the ellipsoids, whose semi-axes
 *        must be > 0 until t_max
 * @param t_max [time; >= 0; or infinite] the time up to which contacts count
 * @param[out] t [time; member time] the time, or infinity
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for an ellipsoid that shrinks to nothing),
 *        #PW85_ENOTPD, #PW85_ECONVERGENCE (the search ends after 100,000 steps: the ellipsoids turn
 *        by more than 50,000 radians near each other without contact, or by more than 10,000 if
 *        their aspect ratio is 1000; sizes, the relative velocity or the time leave the range of
 *        double; one turns by more than 2⁴³ radians, and its orientation is unknown, or its aspect
 *        ratio is above 10⁷, and rounding leaves no digit of its form) */
PW85_API int pw85_first_contact(double const r12[3], double const q1[6], double const q2[6],
                                pw85_motion const *motion1, pw85_motion const *motion2,
                                double t_max, double *t);

/** Least μ² while ellipsoid 2 passes ellipsoid 1 on a straight path: the minimum of the contact
 * function for the separations r12 + t velocity, 0 <= t <= t_max.
 *
 * μ² is a convex function of the time. The time of the minimum is therefore unique unless the
 * velocity is zero. The error of μ² is below 8 u S. Here S is the change of μ² for relative errors
 * of one in the given numbers: S = μ² cond + 2 λ(1-λ) Σ|n_i| (|r12_i| + t |velocity_i|), with cond,
 * λ and n of the pair at time t as in pw85_condition(). Ellipsoids that only translate overlap on
 * this path if and only if μ² < 1.
 *
 * @param r12,q1,q2 [as pw85_contact()] at time 0
 * @param velocity [length/time] velocity of ellipsoid 2 relative to ellipsoid 1; it may be zero
 * @param t_max [time; >= 0; or infinite] the end of the time
 * @param[out] mu2 [optional] the least μ²; 0 if ellipsoid 2 passes the centre of ellipsoid 1
 * @param[out] t [time; optional; member time] the time, in [0, t_max]; 0 for a zero velocity or r12
 *        = 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_passage(double const r12[3], double const q1[6], double const q2[6],
                                  double const velocity[3], double t_max, double *mu2, double *t);

/** Free path of ellipsoid 1 along a direction: how far it may move before it touches ellipsoid 2.
 * Ellipsoid 1 moves by t times `direction`, and the separation is then r12 - t direction.
 *
 * If the ellipsoids do not overlap at t = 0, they certainly do not overlap at the returned t or
 * before: rounding errors make t smaller, never larger. At the returned t the ellipsoids are in
 * contact up to rounding: μ² <= 1 + 80 u S, with S as for pw85_first_contact(). t is 0 if the
 * ellipsoids overlap at t = 0 by more than rounding, or touch and approach.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param direction [!= 0] of any length
 * @param t_max [length; >= 0; or infinite] the end of the path, in units of the length of
 *        `direction`: a length if that is a unit vector
 * @param[out] t [length; member length] in the unit of t_max, in [0, t_max), or infinity if there
 *        is no contact on the path
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD,
 *        #PW85_ECONVERGENCE as for pw85_first_contact() */
PW85_API int pw85_free_path(double const r12[3], double const q1[6], double const q2[6],
                            double const direction[3], double t_max, double *t);

/** @}
 * @name Building blocks
 *
 * Public for tests and studies. Names with two underscores may change between minor versions.
 * @{ */

/** Cholesky factorisation A = L Lᵀ.
 *
 * @param a symmetric positive definite matrix
 * @param[out] l [NaN on error] lower triangle of L by columns: (l11, l21, l31, l22, l32, l33);
 *        NaN if a pivot, computed in double, is not positive: that depends on rounding where `a`
 *        is singular to working precision */
PW85_API void pw85__cholesky_decomp(double const a[6], double l[6]);

/** Solution of L Lᵀ x = b.
 *
 * @param l from pw85__cholesky_decomp()
 * @param b right-hand side
 * @param[out] x solution; may be the same array as b */
PW85_API void pw85__cholesky_solve(double const l[6], double const b[3], double x[3]);

/** Residual g(λ) = μ2² - μ1² = -f'(λ), whose root is the maximiser of f.
 *
 * @param lambda in [0, 1]
 * @param r12,q1,q2 [as pw85_contact()]
 * @param[out] out [NaN on error] (f, g, g') at λ; NaN for invalid input */
PW85_API void pw85__residual(double lambda, double const r12[3], double const q1[6],
                             double const q2[6], double out[3]);

/** -f(λ), with parameters in one block, as minimisers pass them.
 *
 * @param lambda in [0, 1]
 * @param params [15; mixed units] r12, q1, q2 one after the other
 * @return [NaN on error] -f(λ); NaN for invalid input */
PW85_API double pw85_f_neg(double lambda, double const *params);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
