/** @file pw85.h
 * @brief The contact function of Perram and Wertheim for two ellipsoids: the whole main C API.
 *
 * An ellipsoid with centre c and quadratic form Q is the set of points m with (m-c)ᵀ Q⁻¹ (m-c) <= 1. Q is symmetric
 * positive definite; its eigenvalues are the squares of the semi-axes, its eigenvectors their directions. For two
 * ellipsoids with forms Q1, Q2 and r12 = c2 - c1, the contact function is
 *
 *     μ² = max { f(λ), 0 <= λ <= 1 },    f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12.
 *
 * μ is the common factor by which both ellipsoids must be scaled, their centres fixed, to touch from outside: μ² < 1
 * if they overlap, μ² > 1 if they are apart (J. W. Perram and M. S. Wertheim, J. Comp. Phys. 58, 409, 1985).
 *
 * Conventions, for every function unless it says otherwise:
 *
 * - Vectors are `double[3]`. Symmetric matrices are `double[6]`: the upper triangle in row-major order, (xx, xy, xz,
 *   yy, yz, zz). In two dimensions they are `double[2]` and `double[3]` (xx, xy, yy).
 * - Lengths are in any one unit; forms are in its square; μ² and λ have none.
 * - The caller owns all arrays. The library does not use them after the call. They need no alignment beyond that of
 *   double. Outputs may not overlap inputs.
 * - A function that returns `int` returns a status, zero for success. When it is not zero, all outputs are NaN,
 *   except where the description of an output gives another value. Outputs whose pointers are null are left out.
 * - #PW85_EINVAL has three causes, the same in every function: a pointer is null, and its description does not allow that; a
 *   number is NaN or infinite, and its description does not allow that; or an argument is outside of the range that its
 *   description states, as "> 0". #PW85_ENOTPD says that a form is not positive definite. The chapter on errors has a table.
 * - Only the functions of neighbour lists and of simulations and pw85_mesh_create() allocate memory. No function prints anything or
 *   ends the process. No function shares state with another call, except that pw85_set_reproducible() sets a mode of the process, and
 *   that a simulation changes: any number of threads may call any functions at the same time, for different simulations.
 * - No function needs more than 16 KiB of stack, those of meshes no more than 24 KiB, besides what the dynamic linker takes to bind
 *   it at its first call. The threads that a batch starts have stacks of their own, which OpenMP provides.
 * - Functions compute in the default floating-point environment. The rounding mode, status flags and traps of the caller do not
 *   change the results, and after the call they are as they were before.
 * - For semi-axes and distances from 1e-150 to 1e150 no intermediate result overflows or underflows; a result beyond the range of
 *   double is infinity or zero.
 * - A form is positive definite if its leading principal minors are positive. That is decided without rounding errors, for the
 *   doubles as given, and every function and every instruction set decides alike. There are two limits. The determinant must
 *   exceed 2⁻²¹² of the product of the diagonal. Semi-axes may not differ by more than a factor of about 1e38.
 */
#ifndef PW85_H_INCLUDED
#define PW85_H_INCLUDED

#include <stddef.h>
#include <stdint.h>

#include <pw85/export.h>
#include <pw85/status.h>
#include <pw85/version.h>

/** Dimension of the physical space. */
#define PW85_DIM 3

/** Number of stored entries of a symmetric matrix. */
#define PW85_SYM 6

/** Absolute tolerance on λ of Brent's method in pw85_contact_function(). It is that of a problem in which both ellipsoids
 * have been scaled to similar size. */
#define PW85_LAMBDA_ATOL 1e-6

/** Maximum number of iterations of Brent's method in pw85_contact_function(). */
#define PW85_MAX_ITER 25

/** Maximum number of iterations that refine the result of Brent's method in pw85_contact_function(). They are by Halley's method in
 * the variable log(λ/(1-λ)), where pw85 1.0 had Newton-Raphson iterations. */
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

/** Sentence that says what a status means.
 *
 * @param status any number
 * @return the sentence, a constant; never null */
PW85_API char const *pw85_strerror(int status);

/** Switches the reproducible mode on or off, for all threads of the process.
 *
 * In this mode all functions of pw85.h give the same bits on every processor and with every number of threads: on x86-64 with any
 * instruction set, 32-bit x86 with SSE2, 64-bit ARM and z/Architecture, whatever the byte order. The functions use no fused
 * multiplication and addition, and registers of two doubles at most, so that those of many pairs are slower.
 * pw85_contact_function() returns the numbers of pw85_contact(), because Brent's method comes from a library that is compiled
 * elsewhere. The functions of pw85_gpu.h and pw85_zheng.h do not follow the mode.
 *
 * If the environment variable PW85_REPRODUCIBLE is neither empty nor 0 at the first call of a function, the process starts in this
 * mode. A call that runs in another thread while the mode changes may compute some of its pairs in either mode.
 *
 * @param on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_set_reproducible(int on);

/** Whether the reproducible mode is on: see pw85_set_reproducible().
 *
 * @param[out] on 1 or 0
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_is_reproducible(int *on);

/** @}
 * @name Quadratic forms
 * @{ */

/** Quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ.
 *
 * @param a equatorial radius, > 0
 * @param c polar radius, > 0
 * @param n direction of the axis of revolution, of any length > 0
 * @param[out] q the form; NaN if a length is not positive or its square leaves the range of double, or n is zero or not
 *        finite */
PW85_API void pw85_spheroid(double a, double c, double const n[PW85_DIM], double q[PW85_SYM]);

/** Quadratic form of a general ellipsoid, Q = R diag(semi_axes²) Rᵀ.
 *
 * @param semi_axes lengths of the principal semi-axes (not diameters), > 0, whose squares are in the range of double
 * @param rotation 3×3 matrix R in row-major order; its columns are the principal directions, so that R takes the body
 *        frame to the space frame. RᵀR may differ from I by at most 1e-6 in any entry (single precision is
 *        accepted); reflections are accepted.
 * @param[out] q the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid(double const semi_axes[PW85_DIM], double const rotation[PW85_DIM * PW85_DIM],
                            double q[PW85_SYM]);

/** Quadratic form of a general ellipsoid whose orientation is a quaternion.
 *
 * @param semi_axes lengths of the principal semi-axes (not diameters), > 0, whose squares are in the range of double
 * @param quaternion (w, x, y, z), scalar first, of any length > 0: normalised inside. It takes the body frame to the
 *        space frame.
 * @param[out] q the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_quaternion(double const semi_axes[PW85_DIM], double const quaternion[4],
                                       double q[PW85_SYM]);

/** Factor S of the quadratic form of a general ellipsoid, Q = S Sᵀ. It keeps the digits that squares of lengths lose: see
 * pw85_contact_factored().
 *
 * @param semi_axes lengths of the principal semi-axes (not diameters), > 0, whose squares are in the range of double
 * @param quaternion (w, x, y, z), scalar first, of any length > 0: normalised inside. It takes the body frame to the
 *        space frame.
 * @param[out] s 3×3 matrix in row-major order; its columns are the semi-axes as vectors
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipsoid_factor(double const semi_axes[PW85_DIM], double const quaternion[4],
                                   double s[PW85_DIM * PW85_DIM]);

/** Quadratic form (xx, xy, yy) of an ellipse.
 *
 * @param a first semi-axis, > 0, whose square is in the range of double
 * @param b second semi-axis, > 0, whose square is in the range of double
 * @param angle from the x axis to the first semi-axis, counter-clockwise, in radians
 * @param[out] q the form
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_ellipse(double a, double b, double angle, double q[3]);

/** @}
 * @name Contact of two ellipsoids
 * @{ */

/** Contact function of two ellipsoids, by a third-order iteration on log(λ/(1-λ)).
 *
 * The error is below 4 u cond, with u = 2⁻⁵³ and cond the entrywise condition number of the problem (see the chapter on
 * testing), also for forms that are singular to working precision. No more than 157 evaluations of f are made.
 *
 * @param r12 from the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid: μ² = 0, λ = 1/2
 * @param q1,q2 forms of the ellipsoids, in the square of the unit of r12
 * @param[out] out (μ², λ), with the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL (null pointer, NaN or infinity), #PW85_ENOTPD, #PW85_ECONVERGENCE (the bound on the
 *         error cannot be proved; this has never been seen) */
PW85_API int pw85_contact(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                          double out[2]);

/** Contact function of two ellipsoids, with μ² correctly rounded: it is the double nearest to the exact value for the numbers given.
 *
 * If two doubles are equally near, μ² is the one whose last bit is 0. Underflow and overflow follow the same rule: a μ² that is at
 * least 2¹⁰²⁴ - 2⁹⁷⁰ becomes infinity, with success. λ errs by less than one unit in the last place. So every processor and every
 * instruction set gives the same μ², as do the pair with both ellipsoids exchanged and, if μ² stays in the range of normal doubles,
 * the pair in other units that are powers of two.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] out (μ², λ), with the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the last digit of λ cannot be proved; this has never been
 *         seen) */
PW85_API int pw85_contact_rounded(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                  double out[2]);

/** Contact function of two ellipsoids that are given by factors of their forms, Q1 = S1 S1ᵀ and Q2 = S2 S2ᵀ.
 *
 * Rounding a form to doubles changes μ² by some 1e-12 at aspect ratio 100, 1e-8 at 10⁴ and 1e-4 at 10⁶, because the squares of the
 * semi-axes stand in the same numbers. Rounding a factor changes μ² by less than 1e-14, 1e-12 and 1e-12. The relative error of the
 * result is below 4 u c, where c is the fraction by which μ² can change if each entry of s1, s2 and r12 changes by a fraction of one.
 *
 * @param r12 from the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid: μ² = 0, λ = 1/2
 * @param s1,s2 3×3, row-major, as pw85_ellipsoid_factor() makes them. Any matrix S counts as a factor if its columns,
 *        scaled to length one, span a volume above 2⁻³⁹, and if the lengths of its columns differ by less than a factor of 2¹²⁷.
 * @param[out] out (μ², λ), with the maximiser λ of f in [0, 1]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly), #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_contact_factored(double const r12[PW85_DIM], double const s1[PW85_DIM * PW85_DIM],
                                   double const s2[PW85_DIM * PW85_DIM], double out[2]);

/** Condition number of the contact function: if each entry of r12, q1 and q2 changes by a fraction ε of itself, μ² changes by a
 * fraction of at most ε cond, to first order in ε.
 *
 * So data that are known to d digits give μ² to d - log10(cond) digits. The condition number is some units for ordinary pairs, and
 * some squares of the aspect ratio for slender ones. It is
 * [λ(1-λ) Σ |n_i| ((1-λ) |q1_ij| + λ |q2_ij|) |n_j| + 2 λ(1-λ) Σ |r12_i n_i|]/μ² with n = [(1-λ) q1 + λ q2]⁻¹ r12, the sums over all i
 * and j.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param lambda from pw85_contact()
 * @param[out] cond no less than 3; 0 for r12 = 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_condition(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                            double lambda, double *cond);

/** Contact function of two ellipsoids, by Brent's method on f and Newton-Raphson iterations on f' (the method and the
 * semantics of pw85 1.0). Same contract as pw85_contact(), which is several times faster.
 *
 * The relative error of μ² is below 4 u cond, too. Brent's method works on a problem in which both ellipsoids have been scaled
 * to similar size, so that #PW85_LAMBDA_ATOL has the same meaning for ellipsoids of all sizes. */
PW85_API int pw85_contact_function(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                   double out[2]);

/** Point at which the ellipsoids, scaled by μ, touch, and their common normal.
 *
 * @param r12,q1,q2 as for pw85_contact(), r12 != 0
 * @param lambda from pw85_contact(). Any other value in (0, 1) gives the point x0(λ) of the chapter on theory: it is on both
 *        ellipsoids when they are scaled by the factors μ1 and μ2 for which f(λ) = λ μ1² + (1-λ) μ2².
 * @param[out] point relative to the centre of ellipsoid 1; may be null
 * @param[out] normal unit vector, outward from ellipsoid 1 and into ellipsoid 2; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD */
PW85_API int pw85_contact_geometry(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                   double lambda, double point[PW85_DIM], double normal[PW85_DIM]);

/** pw85_contact_geometry() of ellipsoids that are given by factors of their forms.
 *
 * The errors are below 4 u times the change that follows if each entry of a factor changes by the largest entry of its column, and each
 * coordinate of r12 by itself. This holds for the lambda given.
 *
 * @param r12 as for pw85_contact_factored(), r12 != 0
 * @param s1,s2 as for pw85_contact_factored()
 * @param lambda from pw85_contact_factored()
 * @param[out] point relative to the centre of ellipsoid 1; may be null
 * @param[out] normal unit vector, outward from ellipsoid 1 and into ellipsoid 2; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD (a factor is singular, or nearly) */
PW85_API int pw85_contact_geometry_factored(double const r12[PW85_DIM], double const s1[PW85_DIM * PW85_DIM],
                                            double const s2[PW85_DIM * PW85_DIM], double lambda, double point[PW85_DIM],
                                            double normal[PW85_DIM]);

/** Derivatives of μ².
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param lambda from pw85_contact()
 * @param[out] d_r12 ∂μ²/∂r12; its negative is the derivative with respect to the centre of ellipsoid 1; may be null
 * @param[out] d_q1,d_q2 derivatives with respect to the stored entries of q1 and q2 (an off-diagonal entry stands for
 * two entries of the matrix); may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_contact_gradient(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                   double lambda, double d_r12[PW85_DIM], double d_q1[PW85_SYM], double d_q2[PW85_SYM]);

/** Derivatives of μ² of ellipsoids that are given by factors of their forms.
 *
 * The derivative with respect to a factor S is 2 (∂μ²/∂Q) S, with the symmetric matrix ∂μ²/∂Q. So a change dS of the factor changes μ²
 * by Σ d_s_ij dS_ij. The errors are those of pw85_contact_geometry_factored().
 *
 * @param r12,s1,s2 as for pw85_contact_factored()
 * @param lambda from pw85_contact_factored()
 * @param[out] d_r12 ∂μ²/∂r12; its negative is the derivative with respect to the centre of ellipsoid 1; may be null
 * @param[out] d_s1,d_s2 3×3, row-major: derivatives with respect to the entries of s1 and s2; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD (a factor is singular, or nearly) */
PW85_API int pw85_contact_gradient_factored(double const r12[PW85_DIM], double const s1[PW85_DIM * PW85_DIM],
                                            double const s2[PW85_DIM * PW85_DIM], double lambda, double d_r12[PW85_DIM],
                                            double d_s1[PW85_DIM * PW85_DIM], double d_s2[PW85_DIM * PW85_DIM]);

/** Derivatives of μ² with respect to rotations: for a rotation of an ellipsoid about its own centre by the small vector
 * ω, dμ² = d_rot·ω. The torque of an energy U(μ²) is -U'(μ²) d_rot.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param lambda from pw85_contact()
 * @param[out] d_rot1,d_rot2 per radian, for ellipsoids 1 and 2; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1]), #PW85_ENOTPD */
PW85_API int pw85_contact_torque(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                 double lambda, double d_rot1[PW85_DIM], double d_rot2[PW85_DIM]);

/** Second derivatives of μ².
 *
 * Their relative error is a few times that of λ and 1-λ. The λ of pw85_contact() has a relative error of some u times the square of
 * the aspect ratio, and where ellipsoid 1 is much the larger, 1-λ has one of u/(1-λ).
 *
 * @param r12,q1,q2 as for pw85_contact(), r12 != 0
 * @param lambda from pw85_contact()
 * @param[out] hessian 9×9, symmetric: second derivatives with respect to r12, rotation 1 and rotation 2. A vector ω describes
 *        the rotation by the angle |ω| about the direction of ω. λ is not held fixed: it maximises f for each changed pair.
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lambda outside [0, 1] and r12 = 0), #PW85_ENOTPD */
PW85_API int pw85_contact_hessian(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                  double lambda, double hessian[81]);

/** Whether two ellipsoids overlap, μ² < 1. Tangent ellipsoids (μ² = 1) do not.
 *
 * The answer is that of exact arithmetic for the numbers given. Bounds that account for rounding decide almost all pairs, and
 * exact arithmetic decides the others.
 *
 * @param r12,q1,q2 as for pw85_contact(); r12 = 0 is an overlap
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                          int *overlap);

/** Whether two ellipsoids overlap that are given by factors of their forms, Q1 = S1 S1ᵀ and Q2 = S2 S2ᵀ.
 *
 * The answer is that of exact arithmetic for the exact products of the factors given. So it may differ from the answer of
 * pw85_overlap() for the rounded products. Separating planes and common points, with bounds that account for rounding, decide almost all
 * pairs. Integers decide the others, if their digits fit: the entries of s1 and s2, and r12, must be multiples of a power of two and
 * smaller than 2¹⁵⁰⁰ times that power.
 *
 * @param r12 as for pw85_contact_factored(); r12 = 0 is an overlap
 * @param s1,s2 as for pw85_contact_factored()
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD (a factor is singular, or nearly), #PW85_ECONVERGENCE (the pair is so near to
 *         contact that only integers can decide, and their digits do not fit) */
PW85_API int pw85_overlap_factored(double const r12[PW85_DIM], double const s1[PW85_DIM * PW85_DIM],
                                   double const s2[PW85_DIM * PW85_DIM], int *overlap);

/** The sign of μ² - mu2, for any number mu2.
 *
 * The sign is that of exact arithmetic for the numbers given, as the answer of pw85_overlap(), which is the case mu2 = 1. A bound on
 * the error of μ² decides almost all pairs, and exact arithmetic decides the others.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param mu2 >= 0; may be infinity
 * @param[out] sign -1 if μ² < mu2, 0 if they are equal, 1 if μ² > mu2; 2 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_compare(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM], double mu2,
                          int *sign);

/** Whether two ellipsoids overlap, as pw85_overlap(), with a number or a point that proves the answer.
 *
 * The proof holds in exact arithmetic for the numbers given, and rational arithmetic can check it. Tangent ellipsoids do not overlap;
 * they have no such proof, `lambda` and `point` are NaN, and the status is success. If a λ that proves that ellipsoids are apart exists
 * among the doubles, it is found. Points are sought near the point where the ellipsoids, scaled by μ, touch: if 1 - μ² is below
 * 1e-13, none may be found.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] overlap 1 or 0; -1 on error
 * @param[out] lambda from 0 to 1, with f(λ) > 1, if the ellipsoids are apart; otherwise NaN, also on success; may be null
 * @param[out] point inside both ellipsoids and on neither surface, relative to the centre of ellipsoid 1, if they overlap; otherwise
 *        NaN, also on success; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (no proof among the doubles was found; seen only where μ²
 *         differs from one by less than 1e-13, at aspect ratios up to 10⁸) */
PW85_API int pw85_overlap_witness(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                  int *overlap, double *lambda, double point[PW85_DIM]);

/** Whether ellipsoid 2 is inside ellipsoid 1. It may touch the surface of ellipsoid 1 from inside.
 *
 * The answer is that of exact arithmetic for the numbers given, as that of pw85_overlap(). Every ellipsoid is inside itself.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] contains 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contains(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                           int *contains);

/** The factor by which ellipsoid 1 must be scaled, its centre fixed, to contain ellipsoid 2, and the point where they touch then.
 *
 * The square of the factor is the largest value of xᵀ q1⁻¹ x over the points x of ellipsoid 2. It is at most 1 if ellipsoid 2 is inside
 * ellipsoid 1; pw85_contains() decides this without rounding errors. The relative error is below 16 u c, with u = 2⁻⁵³, where u c is the
 * fraction by which the square can change if each entry of r12, q1 and q2 changes by a fraction u of itself. The search proves the result
 * by bounds from both sides.
 *
 * @param r12,q1,q2 as for pw85_contact(); zero is valid for r12, too
 * @param[out] mu2 square of the factor; may be null
 * @param[out] point on the surface of ellipsoid 2, relative to the centre of ellipsoid 1. If they touch at several points, the result is
 *        one of them: they do for r12 = 0, and wherever r12 is short and has no part along the longest direction of ellipsoid 2,
 *        measured by q1; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the bounds cannot be made to agree; this has never been seen) */
PW85_API int pw85_containment(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                              double *mu2, double point[PW85_DIM]);

/** Volume of an ellipsoid, (4/3)π √det q.
 *
 * The relative error is below 2⁻⁵² if the semi-axes differ by a factor below 10⁷. It is below 2⁻⁵⁰ times the fourth power of a larger
 * factor over 10²⁸.
 *
 * @param q form of the ellipsoid
 * @param[out] volume in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_volume(double const q[PW85_SYM], double *volume);

/** pw85_volume() for n ellipsoids; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param q n×6
 * @param[out] volume n
 * @return #PW85_SUCCESS, or the status of the first bad ellipsoid; #PW85_EINVAL if a pointer is null and n > 0 */
PW85_API int pw85_volume_batch(size_t n, double const *q, double *volume);

/** Volume of the common part of two ellipsoids.
 *
 * It is 0 exactly where pw85_overlap() says that they do not overlap, and pw85_volume() of the smaller one exactly where pw85_contains()
 * says that this one is inside the other one. Otherwise the error is below 64 u v + 16 u s, with u = 2⁻⁵³ and the volume v of the smaller
 * ellipsoid, where u s is the change of the result if each entry of r12, q1 and q2 changes by a fraction u of itself. For a thin lens
 * the error is below 64 u + 16 u s/V of the volume V of the lens itself.
 *
 * @param r12,q1,q2 as for pw85_contact(); zero is valid for r12, too
 * @param[out] volume in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (if the smaller ellipsoid is taken to a unit ball by a linear
 *         map, the other one becomes a disc that is thinner than 2⁻²¹) */
PW85_API int pw85_overlap_volume(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                 double *volume);

/** pw85_overlap_volume() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] volume n
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_volume_batch(size_t n, double const *r12, double const *q1, double const *q2, double *volume);

/** Derivatives of the volume of the common part.
 *
 * They are 0 where the ellipsoids do not overlap. Where one is inside the other one, only the derivatives of its own volume are not 0.
 *
 * @param r12,q1,q2 as for pw85_overlap_volume()
 * @param[out] d_r12 ∂V/∂r12; its negative is the derivative with respect to the centre of ellipsoid 1; may be null
 * @param[out] d_q1,d_q2 derivatives with respect to the stored entries of q1 and q2 (an off-diagonal entry stands for two entries of the
 *        matrix); may be null
 * @return as for pw85_overlap_volume() */
PW85_API int pw85_overlap_volume_gradient(double const r12[PW85_DIM], double const q1[PW85_SYM],
                                          double const q2[PW85_SYM], double d_r12[PW85_DIM], double d_q1[PW85_SYM],
                                          double d_q2[PW85_SYM]);

/** pw85_overlap_volume_gradient() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] d_r12 n×3
 * @param[out] d_q1,d_q2 n×6; any output may be null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_volume_gradient_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                                double *d_r12, double *d_q1, double *d_q2);

/** Derivatives of the volume of the common part with respect to rotations: for a rotation of an ellipsoid about its own centre by the
 * small vector ω, dV = d_rot·ω. The torque of an energy U(V) is -U'(V) d_rot. With ∂V/∂r12 from pw85_overlap_volume_gradient(), d_rot1 +
 * d_rot2 + r12 × ∂V/∂r12 = 0.
 *
 * @param r12,q1,q2 as for pw85_overlap_volume()
 * @param[out] d_rot1,d_rot2 per radian, for ellipsoids 1 and 2; may be null
 * @return as for pw85_overlap_volume() */
PW85_API int pw85_overlap_volume_torque(double const r12[PW85_DIM], double const q1[PW85_SYM],
                                        double const q2[PW85_SYM], double d_rot1[PW85_DIM], double d_rot2[PW85_DIM]);

/** pw85_overlap_volume_torque() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] d_rot1,d_rot2 n×3; any output may be null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_volume_torque_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                              double *d_rot1, double *d_rot2);

/** Volume of the part of an ellipsoid that is in the half-space of the points x with normal·x <= offset, relative to the centre of the
 * ellipsoid.
 *
 * @param normal outward normal of the half-space, of any length > 0
 * @param offset in units of the length of `normal` times the unit of length
 * @param q form of the ellipsoid
 * @param[out] volume in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_overlap_volume_plane(double const normal[PW85_DIM], double offset, double const q[PW85_SYM],
                                       double *volume);

/** pw85_overlap_volume_plane() for n ellipsoids and half-spaces; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3
 * @param offsets n
 * @param q n×6
 * @param[out] volume n
 * @return as for pw85_volume_batch() */
PW85_API int pw85_overlap_volume_plane_batch(size_t n, double const *normals, double const *offsets, double const *q,
                                             double *volume);

/** Area of an ellipse, π √det q; see pw85_volume().
 *
 * @param q form of the ellipse
 * @param[out] area in the square of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_area_2d(double const q[3], double *area);

/** pw85_area_2d() for n ellipses; the bits are the same.
 *
 * @param n number of ellipses
 * @param q n×3
 * @param[out] area n
 * @return as for pw85_volume_batch() */
PW85_API int pw85_area_batch_2d(size_t n, double const *q, double *area);

/** Area of the common part of two ellipses; see pw85_overlap_volume(). The bound on the error is the same, with areas.
 *
 * @param r12,q1,q2 as for pw85_contact_2d(); zero is valid for r12, too
 * @param[out] area in the square of the unit of length
 * @return as for pw85_overlap_volume() */
PW85_API int pw85_overlap_area_2d(double const r12[2], double const q1[3], double const q2[3], double *area);

/** pw85_overlap_area_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2
 * @param q1,q2 n×3
 * @param[out] area n
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_area_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *area);

/** Distance of closest approach: the distance of the centres at which two ellipsoids of fixed orientation touch from
 * outside, when their centres are on a line of given direction d. It is |d|/μ(d).
 *
 * @param direction from centre 1 to centre 2, of any length > 0
 * @param q1,q2 forms of the ellipsoids
 * @param[out] distance in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_approach(double const direction[PW85_DIM], double const q1[PW85_SYM],
                                   double const q2[PW85_SYM], double *distance);

/** @}
 * @name Two dimensions
 * @{ */

/** Contact function of two ellipses; see pw85_contact(). */
PW85_API int pw85_contact_2d(double const r12[2], double const q1[3], double const q2[3], double out[2]);

/** Point at which the ellipses, scaled by μ, touch, and their common normal; see pw85_contact_geometry(). */
PW85_API int pw85_contact_geometry_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                                      double point[2], double normal[2]);

/** Derivatives of μ² of two ellipses; see pw85_contact_gradient(). */
PW85_API int pw85_contact_gradient_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                                      double d_r12[2], double d_q1[3], double d_q2[3]);

/** Derivatives of μ² with respect to the angles of two ellipses, counter-clockwise; see pw85_contact_torque().
 *
 * @param[out] d_rot1,d_rot2 one number each, per radian; may be null */
PW85_API int pw85_contact_torque_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                                    double *d_rot1, double *d_rot2);

/** Second derivatives of μ² of two ellipses; see pw85_contact_hessian().
 *
 * @param[out] hessian 4×4, symmetric: with respect to r12, angle 1 and angle 2 */
PW85_API int pw85_contact_hessian_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                                     double hessian[16]);

/** Whether two ellipses overlap; see pw85_overlap(). */
PW85_API int pw85_overlap_2d(double const r12[2], double const q1[3], double const q2[3], int *overlap);

/** Whether ellipse 2 is inside ellipse 1; see pw85_contains(). */
PW85_API int pw85_contains_2d(double const r12[2], double const q1[3], double const q2[3], int *contains);

/** The factor by which ellipse 1 must be scaled to contain ellipse 2; see pw85_containment(). */
PW85_API int pw85_containment_2d(double const r12[2], double const q1[3], double const q2[3], double *mu2,
                                 double point[2]);

/** Distance of closest approach of two ellipses; see pw85_closest_approach(). */
PW85_API int pw85_closest_approach_2d(double const direction[2], double const q1[3], double const q2[3],
                                      double *distance);

/** @}
 * @name Distance
 * @{ */

/** Distance of the surfaces of two ellipsoids, and the points where they are closest.
 *
 * The error of the distance is below 8 u Σ, with u = 2⁻⁵³ and Σ = Σ|n_i r12_i| + Σ|n_i q1_ij n_j|/(2α) + Σ|n_i q2_ij n_j|/(2β),
 * the sums over all i and j. Rounding the data entry by entry can change the distance by u Σ. Here n is the unit normal, and α and β
 * are the half-widths of the ellipsoids along it. The answer can be checked independently: any unit vector n gives a lower bound
 * n·r12 - α - β of the distance, and any two points of the ellipsoids give an upper bound. `distance` is the lower bound for the
 * normal that pw85_distance_derivatives() returns, and |point2 - point1| is an upper bound.
 *
 * The vector point2 - point1 differs from `distance` times n by less than 2¹⁸ u (|r12| + |point1| + |r12 - point2|), and |point2 -
 * point1| differs from `distance` by no more than that. The points are the closest points of a pair whose r12 differs by no more
 * than that. The distance of each point from the surface is below 2¹⁸ u times the longest semi-axis of its ellipsoid, plus the
 * rounding error u |point2| of its coordinates.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] distance in the unit of r12; zero if the ellipsoids overlap, which is decided as in pw85_overlap(); may be null
 * @param[out] point1,point2 the closest points of ellipsoids 1 and 2, both relative to the centre of ellipsoid 1; NaN if they
 *        overlap, also on success; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the errors cannot be bounded; seen only beyond
 *         aspect ratio 10⁶) */
PW85_API int pw85_distance(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                           double *distance, double point1[PW85_DIM], double point2[PW85_DIM]);

/** Derivatives of the distance of two ellipsoids that are apart; NaN if they overlap, also on success.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] d_r12 with respect to r12: the unit vector normal to both surfaces at the closest points, out of ellipsoid 1
 *        and into ellipsoid 2; may be null
 * @param[out] d_rot1,d_rot2 with respect to rotations of ellipsoids 1 and 2 by small vectors about their own centres, per
 *        radian; may be null
 * @param[out] hessian 9×9, symmetric: second derivatives with respect to r12, rotation 1 and rotation 2, where the vector ω
 *        stands for the rotation by |ω| about ω; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() */
PW85_API int pw85_distance_derivatives(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                       double d_r12[PW85_DIM], double d_rot1[PW85_DIM], double d_rot2[PW85_DIM],
                                       double hessian[81]);

/** The depth of an overlap: the shortest translation of ellipsoid 2 that separates two ellipsoids.
 *
 * It is the smallest value of α + β - n·r12 over unit vectors n, with the half-widths α and β of the ellipsoids along n. This
 * function of n may have several local minima; the result is proved to be the global one. `depth` is the value for the returned
 * direction, with an error below 8 u Σ, with Σ as for pw85_distance(). No other direction has a value that is smaller by more than
 * 32 u Σ, where Σ is the larger one of the two directions. If several directions are equally good, the result is one of them. The
 * time is some hundred times that of pw85_contact(), and several hundred times if the best direction is not isolated. It is a third
 * of that if the depth is below the least radii of curvature of both ellipsoids together.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] depth in the unit of r12; zero if the ellipsoids do not overlap, which is decided as in pw85_overlap(); may be null
 * @param[out] direction unit vector along which ellipsoid 2 is to move; NaN if they do not overlap, also on success; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the proof takes too long; seen only for forms
 *         that are singular to working precision) */
PW85_API int pw85_penetration(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                              double *depth, double direction[PW85_DIM]);

/** The signed distance of two ellipsoids: their distance if they are apart, minus the depth of their overlap otherwise.
 *
 * It is the largest value of n·r12 - α - β over unit vectors n, with the half-widths α and β of the ellipsoids along n, whether they
 * overlap or not. So it is a convex function of r12 with slope 1, which is continuous at contact. It is positive only if the
 * ellipsoids are apart and negative only if they overlap, which is decided as in pw85_overlap(). Its error is that of
 * pw85_distance(), or that of the depth of pw85_penetration(), which also states the time that overlaps take.
 *
 * If they overlap, moving ellipsoid 2 by point1 - point2 separates them by the shortest way. If several directions are equally good,
 * the result belongs to one of them. For a direction that is isolated, and aspect ratios up to 10³, point2 - point1 differs from
 * `distance` times the unit normal by less than 2¹⁸ u (|r12| + |point1| + |r12 - point2|), with u = 2⁻⁵³.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] distance in the unit of r12; may be null
 * @param[out] point1,point2 the points of the surfaces of ellipsoids 1 and 2 where their normals are opposite and along point2 -
 *        point1: the closest points, or the deepest ones; both relative to the centre of ellipsoid 1; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_distance() and pw85_penetration() */
PW85_API int pw85_signed_distance(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                  double *distance, double point1[PW85_DIM], double point2[PW85_DIM]);

/** Derivatives of the signed distance of two ellipsoids.
 *
 * At contact they are the limits from both sides. The derivatives of the distance with respect to the entries of the forms are
 * -n_i n_j/(2α) and -n_i n_j/(2β), twice that for entries off the diagonal, with the normal n = d_r12.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] d_r12 with respect to r12: the unit vector normal to both surfaces at the points of pw85_signed_distance(), out of
 *        ellipsoid 1. If several directions are equally good, the derivative does not exist, and this is one of the subgradients;
 *        may be null
 * @param[out] d_rot1,d_rot2 with respect to rotations of ellipsoids 1 and 2 by small vectors about their own centres, per
 *        radian; may be null
 * @param[out] hessian 9×9, symmetric: second derivatives as for pw85_distance_derivatives(); NaN where the best direction is not
 *        isolated, up to half of the digits, also on success; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_signed_distance() */
PW85_API int pw85_signed_distance_derivatives(double const r12[PW85_DIM], double const q1[PW85_SYM],
                                              double const q2[PW85_SYM], double d_r12[PW85_DIM],
                                              double d_rot1[PW85_DIM], double d_rot2[PW85_DIM], double hessian[81]);

/** Distance of two ellipses; see pw85_distance(). */
PW85_API int pw85_distance_2d(double const r12[2], double const q1[3], double const q2[3], double *distance,
                              double point1[2], double point2[2]);

/** @}
 * @name Time
 *
 * Ellipsoids that translate at constant velocities, turn about their centres at constant angular velocities, and grow. The first
 * contact is the least time in [0, t_max] at which μ <= 1; infinity stands for none. The search skips only time intervals that are
 * proved free of contact, and ends where the contact function itself shows a contact. A larger t_max does not change a bit of it.
 *
 * At the time t that is returned |μ² - 1| <= 80 u S, with u = 2⁻⁵³, and before it μ² >= 1 - 80 u S. So the error of t is at most
 * 80 u S/|dμ²/dt| + 2 u t, unless the contact grazes. S is the change of μ² at that time for relative errors of one in the given
 * numbers:
 *
 *     S = cond + Σ_i |∂μ²/∂r_i| (|r12_i| + t |v1_i| + t |v2_i|) + Σ_k (1 + t |ω_k| + t |g_k|) max|Q_k| Σ_ij |∂μ²/∂Q_k,ij|
 *
 * cond is that of pw85_contact(); v, ω and g are the numbers of the motions, and Q_k is the form of ellipsoid k at time t. The sum
 * over k is over the ellipsoids that turn or grow. Pairs that miss each other by no more than 80 u S count as touching. If a pair
 * overlaps at time 0, its first contact is at time 0, with one exception: if the overlap is no more than some hundred times its
 * rounding error and the ellipsoids separate, the pair counts as one that has just collided, and t is the time of its next contact.
 * @{ */

/** How an ellipsoid moves. */
typedef struct pw85_motion {
    /** velocity of the centre. */
    double velocity[PW85_DIM];
    /** angular velocity about the centre, in radians per unit of time. */
    double angular_velocity[PW85_DIM];
    /** At time t the semi-axes are 1 + growth·t times those at time 0. */
    double growth;
} pw85_motion;

/** The time of the first contact of two moving ellipsoids.
 *
 * @param r12,q1,q2 as for pw85_contact(), at time 0
 * @param motion1,motion2 how the ellipsoids move; none may shrink to nothing before t_max
 * @param t_max the time up to which contacts count, >= 0; may be infinity
 * @param[out] t the time, or infinity
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for an ellipsoid that shrinks to nothing), #PW85_ENOTPD, #PW85_ECONVERGENCE (the
 *         ellipsoids turn by more than 50,000 radians near each other without contact, or by more than 10,000 if their aspect ratio
 *         is 1000: the search ends after 100,000 steps; sizes, the relative velocity or the time leave the range of double; one
 *         turns by more than 2⁴³ radians, so that its orientation is unknown; or one turns whose aspect ratio is above 10⁷, so that
 *         rounding leaves no digit of its form) */
PW85_API int pw85_first_contact(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                pw85_motion const *motion1, pw85_motion const *motion2, double t_max, double *t);

/** The least μ² while ellipsoid 2 passes ellipsoid 1 on a straight way: the least contact function for the separations r12 + t velocity,
 * 0 <= t <= t_max.
 *
 * μ² is a convex function of the time, so there is one such time unless the velocity is zero. The error of μ² is below 8 u S. Here S is
 * the change of μ² for relative errors of one in the given numbers: S = μ² cond + 2 λ(1-λ) Σ|n_i| (|r12_i| + t |velocity_i|), with cond,
 * λ and n of the pair at time t as in pw85_condition(). Ellipsoids that only translate overlap on their way if and only if μ² < 1.
 *
 * @param r12,q1,q2 as for pw85_contact(), at time 0
 * @param velocity of ellipsoid 2 relative to ellipsoid 1; may be zero
 * @param t_max the end of the time, >= 0; may be infinity
 * @param[out] mu2 the least μ²; 0 if ellipsoid 2 passes through the centre of ellipsoid 1; may be null
 * @param[out] t the time, in [0, t_max]; 0 for a zero velocity or r12 = 0; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_contact() */
PW85_API int pw85_closest_passage(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                  double const velocity[PW85_DIM], double t_max, double *mu2, double *t);

/** How far ellipsoid 1 may move along a direction before it touches ellipsoid 2: it moves by t direction, so that the separation is
 * r12 - t direction.
 *
 * At the t that is returned and before, the ellipsoids do not overlap, for certain, if they do not at t = 0; rounding errors make t
 * smaller, never larger. The contact follows within them: μ² <= 1 + 80 u S at t, with S as for pw85_first_contact(). t is 0 if the
 * ellipsoids overlap at t = 0 by more than rounding, or touch and approach.
 *
 * @param r12,q1,q2 as for pw85_contact()
 * @param direction of any length > 0
 * @param t_max the end of the path, >= 0; may be infinity
 * @param[out] t in [0, t_max), or infinity if there is no contact on the path
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD, #PW85_ECONVERGENCE as for pw85_first_contact() */
PW85_API int pw85_free_path(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                            double const direction[PW85_DIM], double t_max, double *t);

/** @}
 * @name Curvature and contact of grains
 *
 * Hertz's theory of two elastic bodies that touch needs the curvatures of both surfaces. The chapter on curvature derives the formulas,
 * and says which of these numbers are continuous.
 * @{ */

/** Principal curvatures of an ellipsoid's surface at the point with a given normal, and their directions.
 *
 * The relative error of each curvature is below 1e-12 for the numbers as given, up to aspect ratio 10⁶. From aspect ratio 10 or so on the
 * function computes with twice the digits, which takes some eight times as long.
 *
 * @param normal out of the ellipsoid, of any length > 0
 * @param q form of the ellipsoid
 * @param[out] curvatures reciprocal radii of curvature, > 0, the smaller one first; may be null
 * @param[out] directions 2×3: unit vectors along which the surface has these curvatures. Their cross product is the unit normal. If
 *        both curvatures are equal, they are any such vectors; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_curvature(double const normal[PW85_DIM], double const q[PW85_SYM], double curvatures[2],
                            double directions[6]);

/** Hertz's theory of the contact of two elastic bodies: the force and the contact ellipse as functions of the depth.
 *
 * The gap between the undeformed surfaces is half of the sum of curvature times squared length along two perpendicular directions. For a
 * depth δ the bodies repel each other by the force (4/3) E* √(radius δ³), with 1/E* = (1 - ν1²)/E1 + (1 - ν2²)/E2, Young's moduli E and
 * Poisson's ratios ν. The energy is (8/15) E* √(radius δ⁵). The contact area is an ellipse with the semi-axes √(ellipse[0] δ) and
 * √(ellipse[1] δ), the square of whose arithmetic-geometric mean is radius δ. Complete elliptic integrals are included. The relative
 * errors are below 256 u, with u = 2⁻⁵³, for curvatures whose ratio is at most 10¹⁸.
 *
 * @param curvatures along both directions, the sums of those of both bodies, > 0. pw85_hertz_contact() returns them for two ellipsoids.
 *        A plane has none, so that for an ellipsoid on a plane they are those of pw85_curvature()
 * @param[out] radius the effective radius. For spheres it is R1 R2/(R1 + R2); may be null
 * @param[out] ellipse squares of the semi-axes over the depth, along the direction of each curvature; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a curvature that is not positive) */
PW85_API int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2]);

/** Geometry of the contact of two grains along a common normal: what laws of contact such as Hertz's need.
 *
 * For the normal n of pw85_contact_geometry() the depth is α + β - n·r12 = (1/μ - 1) n·r12, with the half-widths α and β of the
 * ellipsoids along n. This is the usual choice: it is a smooth function of positions and orientations for μ > 0. The depth of
 * pw85_penetration() is smaller by a part of second order in the depth; its direction, as `normal`, gives it here, too. For every normal
 * a negative depth proves that the ellipsoids are apart, by at least minus the depth, and the depth is at least that of
 * pw85_penetration() if they overlap.
 *
 * The error of the depth is below 8 u Σ, with Σ as for pw85_distance() with this normal. The relative error of the other numbers is below
 * 1e-12 up to aspect ratio 10⁶, for the normal as given. That of the point is relative to the lengths of which it is the sum, and
 * directions err by that over the relative difference of the curvatures.
 *
 * @param r12 from the centre of ellipsoid 1 to that of ellipsoid 2
 * @param q1,q2 forms of the ellipsoids, in the square of the unit of r12
 * @param normal out of ellipsoid 1 and into ellipsoid 2, of any length > 0
 * @param[out] depth in the unit of r12; negative if the slab between the ellipsoids has a width; may be null
 * @param[out] point where the forces of contact act: the middle of the points of both surfaces that have the normals n and -n, relative
 *        to the centre of ellipsoid 1; may be null
 * @param[out] curvatures of the gap between both surfaces, > 0, the smaller one first: eigenvalues of the sum of their second
 *        fundamental forms, as pw85_hertz() takes them; may be null
 * @param[out] directions 2×3: the directions of these curvatures, and so of the contact ellipse; as for pw85_curvature(); may be null
 * @param[out] radius,ellipse as for pw85_hertz(); may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_hertz_contact(double const r12[PW85_DIM], double const q1[PW85_SYM], double const q2[PW85_SYM],
                                double const normal[PW85_DIM], double *depth, double point[PW85_DIM],
                                double curvatures[2], double directions[6], double *radius, double ellipse[2]);

/** @}
 * @name Walls, points and lines
 *
 * These functions are for one ellipsoid. The distance is the largest or smallest value of n·x ∓ α over unit vectors n, where α is
 * the half-width of the ellipsoid along n. Its error is below 8 u Σ. Here Σ is the sum of the magnitudes of the terms of n·x and of
 * other lengths in the distance, and of Σ|n_i q_ij n_j|/(2α), where n is the unit normal of the exact answer.
 *
 * The derivatives of a distance with respect to the position of the centre and to small rotations about it follow from the
 * point and the normal: see pw85_distance_plane_derivatives().
 * @{ */

/** Distance from an ellipsoid with its centre at 0 to the half-space normal·x >= offset: (offset - α)/|normal|.
 *
 * @param normal into the half-space, of any length > 0
 * @param offset in the unit of normal·x; negative if the centre is in the half-space
 * @param q form of the ellipsoid
 * @param[out] distance in the unit of the semi-axes; negative if the two overlap: minus the depth; may be null
 * @param[out] point of the ellipsoid, nearest to the half-space or deepest in it; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_distance_plane(double const normal[PW85_DIM], double offset, double const q[PW85_SYM],
                                 double *distance, double point[PW85_DIM]);

/** Derivatives of the distance to a half-space, which do not depend on its offset: -n and n × point, with n the unit normal.
 *
 * @param normal,q as for pw85_distance_plane()
 * @param[out] d_center with respect to the position of the centre; may be null
 * @param[out] d_rot with respect to small rotation vectors about the centre, per radian; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_distance_plane_derivatives(double const normal[PW85_DIM], double const q[PW85_SYM],
                                             double d_center[PW85_DIM], double d_rot[PW85_DIM]);

/** Contact function of an ellipsoid with its centre at 0 and the half-space normal·x >= offset.
 *
 * @param normal,offset,q as for pw85_distance_plane()
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch; 0 if the centre is in the half-space;
 *             may be null
 * @param[out] point where the scaled ellipsoid touches; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_contact_plane(double const normal[PW85_DIM], double offset, double const q[PW85_SYM], double *mu2,
                                double point[PW85_DIM]);

/** Derivatives of μ² of pw85_contact_plane(): -2μ n/α and 2μ² (n × p)/α, with p the point of the ellipsoid that is nearest to
 * the half-space, n the normal as given and α = n·p; zero if the centre is in the half-space.
 *
 * @param normal,offset,q as for pw85_distance_plane()
 * @param[out] d_center with respect to the position of the centre; may be null
 * @param[out] d_rot with respect to small rotation vectors about the centre, per radian; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_contact_plane_derivatives(double const normal[PW85_DIM], double offset, double const q[PW85_SYM],
                                            double d_center[PW85_DIM], double d_rot[PW85_DIM]);

/** Distance from an ellipsoid with its centre at 0 to the nearest face of a box around it.
 *
 * @param lower,upper corners of the box, relative to the centre of the ellipsoid; lower <= upper
 * @param q form of the ellipsoid
 * @param[out] distance negative if the ellipsoid is not inside of the box; may be null
 * @param[out] point of the ellipsoid, nearest to that face or farthest beyond it; may be null
 * @param[out] normal outward unit normal of that face; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_distance_box(double const lower[PW85_DIM], double const upper[PW85_DIM], double const q[PW85_SYM],
                               double *distance, double point[PW85_DIM], double normal[PW85_DIM]);

/** Distance from an ellipsoid to the wall of a cylinder of infinite length around it.
 *
 * @param axis direction of the axis, which goes through 0; of any length > 0
 * @param radius of the cylinder, > 0
 * @param center of the ellipsoid
 * @param q form of the ellipsoid
 * @param[out] distance negative if the ellipsoid is not inside of the cylinder; may be null
 * @param[out] point of the ellipsoid, farthest from the axis, relative to its centre; may be null
 * @param[out] normal outward unit normal of the wall there; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero axis or a radius that is not positive), #PW85_ENOTPD */
PW85_API int pw85_distance_cylinder(double const axis[PW85_DIM], double radius, double const center[PW85_DIM],
                                    double const q[PW85_SYM], double *distance, double point[PW85_DIM],
                                    double normal[PW85_DIM]);

/** Distance from a point to the surface of an ellipsoid.
 *
 * @param r the point, relative to the centre of the ellipsoid
 * @param q form of the ellipsoid
 * @param[out] distance negative if the point is inside; may be null
 * @param[out] point of the surface, nearest to r, relative to the centre; one of them if there are several; may be null
 * @param[out] normal unit vector out of the ellipsoid at this point, the derivative of the distance; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_point(double const r[PW85_DIM], double const q[PW85_SYM], double *distance,
                                 double point[PW85_DIM], double normal[PW85_DIM]);

/** The part t[0] <= t <= t[1] of the line origin + t·direction that is in an ellipsoid. A ray from the origin has t >= 0,
 * the segment from the origin to origin + direction 0 <= t <= 1.
 *
 * @param origin of the line, relative to the centre of the ellipsoid
 * @param direction of any length > 0
 * @param q form of the ellipsoid
 * @param[out] t NaN if the line misses the ellipsoid, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD */
PW85_API int pw85_intersect_line(double const origin[PW85_DIM], double const direction[PW85_DIM],
                                 double const q[PW85_SYM], double t[2]);

/** @}
 * @name Shapes
 *
 * An ellipsoid with its centre at 0, and a convex set. μ² is the square of the factor by which the ellipsoid must be scaled about its
 * centre to touch the set, and the point is where it then touches: the point x of the set where xᵀQ⁻¹x is least. If the centre is in
 * the set, μ² is 0. The set overlaps the ellipsoid if μ² < 1.
 *
 * The error of μ² is below 80 u S. Here S = Σ|s_i q_ij s_j| + 2 Σ_k w_k Σ|s_i v_ki| over the points v_k of the set
 * of which x = Σ w_k v_k is the mean with weights w_k > 0, and s = Q⁻¹x. Rounding the data entry by entry can change μ² by u S.
 *
 * For another position of the ellipsoid, subtract its centre from the points of the set.
 * @{ */

/** Contact function of an ellipsoid and a segment.
 *
 * @param end1,end2 of the segment, relative to the centre of the ellipsoid; equal ends are a point
 * @param q form of the ellipsoid
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch; may be null
 * @param[out] point of the segment, where the scaled ellipsoid touches; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_segment(double const end1[PW85_DIM], double const end2[PW85_DIM], double const q[PW85_SYM],
                                  double *mu2, double point[PW85_DIM]);

/** Contact function of an ellipsoid and a triangle.
 *
 * @param vertex1,vertex2,vertex3 of the triangle, relative to the centre of the ellipsoid; a triangle without area is the segment
 *        or the point that has all three vertices
 * @param q form of the ellipsoid
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch; may be null
 * @param[out] point of the triangle, where the scaled ellipsoid touches; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_triangle(double const vertex1[PW85_DIM], double const vertex2[PW85_DIM],
                                   double const vertex3[PW85_DIM], double const q[PW85_SYM], double *mu2,
                                   double point[PW85_DIM]);

/** Contact function of an ellipsoid and a solid box with sides along the axes.
 *
 * @param lower,upper corners of the box, relative to the centre of the ellipsoid; lower <= upper; a box may be flat
 * @param q form of the ellipsoid
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in the box; may be null
 * @param[out] point of the box, where the scaled ellipsoid touches; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_contact_box(double const lower[PW85_DIM], double const upper[PW85_DIM], double const q[PW85_SYM],
                              double *mu2, double point[PW85_DIM]);

/** Contact function of an ellipsoid and a polytope, the intersection of half-spaces: all x with normal·x <= offset for each of n planes.
 *
 * The time is proportional to n. The error of μ² is below 32 u Σ λ_k (|normal_k|·r + |offset_k|), to first order: the sum is over the
 * planes that the scaled ellipsoid touches, s = -Σ λ_k normal_k with λ_k > 0, and r = Σ λ_k |q| |normal_k|.
 *
 * @param n number of planes; 0 is fine: the polytope is the whole space
 * @param normals n×3: out of the polytope, of any lengths > 0
 * @param offsets n, for planes relative to the centre of the ellipsoid
 * @param q form of the ellipsoid
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in the polytope, infinity if
 *        the polytope is empty, which is decided up to rounding errors: one that begins beyond μ² = 10¹⁰ may count as empty; may
 *        be null
 * @param[out] point of the polytope, where the scaled ellipsoid touches; NaN if the polytope is empty; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (this has never been seen) */
PW85_API int pw85_contact_polytope(size_t n, double const *normals, double const *offsets, double const q[PW85_SYM],
                                   double *mu2, double point[PW85_DIM]);

/** Whether an ellipsoid and a segment overlap, μ² < 1. If they only touch, they do not. The answer is that of exact arithmetic for the
 * numbers given, as that of pw85_overlap().
 *
 * @param end1,end2,q as for pw85_contact_segment()
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_segment(double const end1[PW85_DIM], double const end2[PW85_DIM], double const q[PW85_SYM],
                                  int *overlap);

/** Whether an ellipsoid and a triangle overlap, μ² < 1. If they only touch, they do not. The answer is that of exact arithmetic for
 * the numbers given, as that of pw85_overlap().
 *
 * @param vertex1,vertex2,vertex3,q as for pw85_contact_triangle()
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_triangle(double const vertex1[PW85_DIM], double const vertex2[PW85_DIM],
                                   double const vertex3[PW85_DIM], double const q[PW85_SYM], int *overlap);

/** Whether an ellipsoid and a solid box with sides along the axes overlap, μ² < 1. If they only touch, they do not. The answer is
 * that of exact arithmetic for the numbers given, as that of pw85_overlap().
 *
 * @param lower,upper,q as for pw85_contact_box()
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_overlap_box(double const lower[PW85_DIM], double const upper[PW85_DIM], double const q[PW85_SYM],
                              int *overlap);

/** Whether an ellipsoid and a polytope overlap, μ² < 1. If they only touch, they do not; an empty polytope does not overlap. The answer
 * is that of exact arithmetic for the numbers given, as that of pw85_overlap().
 *
 * @param n,normals,offsets,q as for pw85_contact_polytope()
 * @param[out] overlap 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets, double const q[PW85_SYM],
                                   int *overlap);

/** @}
 * @name Many pairs
 *
 * Arrays are contiguous, and row i belongs to pair i. A bad pair (NaN, infinity, a form that is not positive definite) is
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

/** pw85_contact() for n pairs. The relative error of μ² is below 4 u cond, too; the last bits may differ from those of
 * pw85_contact().
 *
 * @param n number of pairs; 0 is fine, and pointers may then be null
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] mu2 n
 * @param[out] lambda n, or null
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad pair */
PW85_API int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                double *lambda);

/** pw85_overlap() for n pairs; the answers are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] overlap n: 1, 0, or 255 for a bad pair
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                unsigned char *overlap);

/** pw85_contact_rounded() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] mu2 n, or null
 * @param[out] lambda n, or null
 * @return as for pw85_contact_batch(), or #PW85_ECONVERGENCE as for pw85_contact_rounded() */
PW85_API int pw85_contact_rounded_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                        double *lambda);

/** pw85_overlap_factored() for n pairs; the answers are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param s1,s2 n×3×3
 * @param[out] overlap n: 1, 0, or 255 for a bad pair
 * @return as for pw85_contact_batch(), or #PW85_ECONVERGENCE as for pw85_overlap_factored() */
PW85_API int pw85_overlap_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                         unsigned char *overlap);

/** pw85_compare() for n pairs; the signs are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param mu2 n, >= 0; may be infinity
 * @param[out] sign n: -1, 0 or 1, or 2 for a bad pair
 * @return as for pw85_contact_batch() */
PW85_API int pw85_compare_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *mu2,
                                int *sign);

/** pw85_overlap_witness() for n pairs; the results are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] overlap n: 1, 0, or 255 for a bad pair
 * @param[out] lambda n, or null; NaN where the ellipsoids are not apart
 * @param[out] point n×3, or null; NaN where they do not overlap
 * @return as for pw85_contact_batch(), or #PW85_ECONVERGENCE as for pw85_overlap_witness() */
PW85_API int pw85_overlap_witness_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                        unsigned char *overlap, double *lambda, double *point);

/** pw85_contains() for n pairs; the answers are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] contains n: 1, 0, or 255 for a bad pair
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contains_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                 unsigned char *contains);

/** pw85_containment() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] mu2 n
 * @param[out] point n×3; any output may be null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_containment_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                    double *point);

/** pw85_closest_passage() for n pairs. The error of μ² is below 8 u S, too; the last bits may differ from those of
 * pw85_closest_passage().
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param velocity n×3
 * @param t_max as for pw85_closest_passage(), for all pairs
 * @param[out] mu2 n
 * @param[out] t n, or null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_closest_passage_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                        double const *velocity, double t_max, double *mu2, double *t);

/** pw85_free_path() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param direction n×3
 * @param t_max n, each >= 0; may be infinity
 * @param[out] t n
 * @return as for pw85_contact_batch(); the causes of pw85_free_path() */
PW85_API int pw85_free_path_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                  double const *direction, double const *t_max, double *t);

/** pw85_closest_approach() for n pairs. The relative error is below 2 u cond + 4 u; the last bits may differ from those of
 * pw85_closest_approach().
 *
 * @param n number of pairs
 * @param directions n×3, of any lengths > 0
 * @param q1,q2 n×6
 * @param[out] distance n
 * @return as for pw85_contact_batch(); a zero direction is #PW85_EINVAL */
PW85_API int pw85_closest_approach_batch(size_t n, double const *directions, double const *q1, double const *q2,
                                         double *distance);

/** pw85_contact_factored() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param s1,s2 n×3×3
 * @param[out] mu2,lambda n each; any output may be null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_factored_batch(size_t n, double const *r12, double const *s1, double const *s2, double *mu2,
                                         double *lambda);

/** pw85_condition() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param lambda n, as pw85_contact_batch() returns them
 * @param[out] cond n
 * @return as for pw85_contact_batch() */
PW85_API int pw85_condition_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                                  double *cond);

/** pw85_contact_function() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] mu2,lambda n each; any output may be null
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_function_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                         double *lambda);

/** pw85_contact_geometry() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3, r12 != 0
 * @param q1,q2 n×6
 * @param lambda n
 * @param[out] point,normal n×3 each; any output may be null
 * @return as for pw85_contact_batch(); r12 = 0 and lambda outside [0, 1] are #PW85_EINVAL */
PW85_API int pw85_contact_geometry_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                         double const *lambda, double *point, double *normal);

/** pw85_contact_gradient() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param lambda n
 * @param[out] d_r12 n×3; any output may be null
 * @param[out] d_q1,d_q2 n×6 each
 * @return as for pw85_contact_batch(); lambda outside [0, 1] is #PW85_EINVAL */
PW85_API int pw85_contact_gradient_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                         double const *lambda, double *d_r12, double *d_q1, double *d_q2);

/** pw85_contact_geometry_factored() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3, r12 != 0
 * @param s1,s2 n×3×3
 * @param lambda n
 * @param[out] point,normal n×3 each; any output may be null
 * @return as for pw85_contact_batch(); r12 = 0 and lambda outside [0, 1] are #PW85_EINVAL */
PW85_API int pw85_contact_geometry_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                                  double const *lambda, double *point, double *normal);

/** pw85_contact_gradient_factored() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param s1,s2 n×3×3
 * @param lambda n
 * @param[out] d_r12 n×3; any output may be null
 * @param[out] d_s1,d_s2 n×3×3 each
 * @return as for pw85_contact_batch(); lambda outside [0, 1] is #PW85_EINVAL */
PW85_API int pw85_contact_gradient_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                                  double const *lambda, double *d_r12, double *d_s1, double *d_s2);

/** pw85_contact_torque() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param lambda n
 * @param[out] d_rot1,d_rot2 n×3 each; any output may be null
 * @return as for pw85_contact_gradient_batch() */
PW85_API int pw85_contact_torque_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                       double const *lambda, double *d_rot1, double *d_rot2);

/** pw85_contact_hessian() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3, r12 != 0
 * @param q1,q2 n×6
 * @param lambda n
 * @param[out] hessian n×9×9
 * @return as for pw85_contact_batch(); r12 = 0 and lambda outside [0, 1] are #PW85_EINVAL */
PW85_API int pw85_contact_hessian_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                        double const *lambda, double *hessian);

/** pw85_contact_2d() for n pairs; see pw85_contact_batch().
 *
 * @param r12 n×2
 * @param q1,q2 n×3 */
PW85_API int pw85_contact_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                   double *lambda);

/** pw85_overlap_2d() for n pairs; see pw85_overlap_batch().
 *
 * @param r12 n×2
 * @param q1,q2 n×3 */
PW85_API int pw85_overlap_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   unsigned char *overlap);

/** pw85_contact_geometry_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2, r12 != 0
 * @param q1,q2 n×3
 * @param lambda n
 * @param[out] point,normal n×2 each; any output may be null
 * @return as for pw85_contact_batch(); r12 = 0 and lambda outside [0, 1] are #PW85_EINVAL */
PW85_API int pw85_contact_geometry_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                            double const *lambda, double *point, double *normal);

/** pw85_contact_gradient_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2
 * @param q1,q2 n×3
 * @param lambda n
 * @param[out] d_r12 n×2; any output may be null
 * @param[out] d_q1,d_q2 n×3 each
 * @return as for pw85_contact_gradient_batch() */
PW85_API int pw85_contact_gradient_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                            double const *lambda, double *d_r12, double *d_q1, double *d_q2);

/** pw85_contact_torque_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2
 * @param q1,q2 n×3
 * @param lambda n
 * @param[out] d_rot1,d_rot2 n each; any output may be null
 * @return as for pw85_contact_gradient_batch() */
PW85_API int pw85_contact_torque_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                          double const *lambda, double *d_rot1, double *d_rot2);

/** pw85_contact_hessian_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2, r12 != 0
 * @param q1,q2 n×3
 * @param lambda n
 * @param[out] hessian n×4×4
 * @return as for pw85_contact_batch(); r12 = 0 and lambda outside [0, 1] are #PW85_EINVAL */
PW85_API int pw85_contact_hessian_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                           double const *lambda, double *hessian);

/** pw85_closest_approach_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param directions n×2, of any lengths > 0
 * @param q1,q2 n×3
 * @param[out] distance n
 * @return as for pw85_closest_approach_batch() */
PW85_API int pw85_closest_approach_batch_2d(size_t n, double const *directions, double const *q1, double const *q2,
                                            double *distance);

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

/** pw85_distance() for n pairs. Points of pairs that overlap are NaN.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] distance n; any output may be null
 * @param[out] point1,point2 n×3 each, relative to the centres of the first ellipsoids
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_distance_batch(size_t n, double const *r12, double const *q1, double const *q2, double *distance,
                                 double *point1, double *point2);

/** pw85_distance_derivatives() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] d_r12,d_rot1,d_rot2 n×3 each; any output may be null
 * @param[out] hessian n×9×9
 * @return as for pw85_contact_batch() */
PW85_API int pw85_distance_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                             double *d_r12, double *d_rot1, double *d_rot2, double *hessian);

/** pw85_distance_2d() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×2
 * @param q1,q2 n×3
 * @param[out] distance n; any output may be null
 * @param[out] point1,point2 n×2 each
 * @return as for pw85_contact_batch() */
PW85_API int pw85_distance_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *distance,
                                    double *point1, double *point2);

/** pw85_penetration() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] depth n; any output may be null
 * @param[out] direction n×3; NaN for pairs that do not overlap
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_penetration_batch(size_t n, double const *r12, double const *q1, double const *q2, double *depth,
                                    double *direction);

/** pw85_signed_distance() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] distance n; any output may be null
 * @param[out] point1,point2 n×3
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_signed_distance_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                        double *distance, double *point1, double *point2);

/** pw85_signed_distance_derivatives() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param[out] d_r12,d_rot1,d_rot2 n×3; any output may be null
 * @param[out] hessian n×9×9
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_signed_distance_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                                    double *d_r12, double *d_rot1, double *d_rot2, double *hessian);

/** pw85_curvature() for n ellipsoids; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3, of any lengths > 0
 * @param q n×6
 * @param[out] curvatures n×2; any output may be null
 * @param[out] directions n×2×3
 * @return as for pw85_contact_batch(); a zero normal is #PW85_EINVAL */
PW85_API int pw85_curvature_batch(size_t n, double const *normals, double const *q, double *curvatures,
                                  double *directions);

/** pw85_hertz() for n contacts; the bits are the same.
 *
 * @param n number of contacts
 * @param curvatures n×2, > 0
 * @param[out] radius n; any output may be null
 * @param[out] ellipse n×2
 * @return as for pw85_contact_batch(); a curvature that is not positive is #PW85_EINVAL */
PW85_API int pw85_hertz_batch(size_t n, double const *curvatures, double *radius, double *ellipse);

/** pw85_hertz_contact() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param normals n×3, of any lengths > 0
 * @param[out] depth n; any output may be null
 * @param[out] point n×3
 * @param[out] curvatures n×2
 * @param[out] directions n×2×3
 * @param[out] radius n
 * @param[out] ellipse n×2
 * @return as for pw85_contact_batch(); a zero normal is #PW85_EINVAL */
PW85_API int pw85_hertz_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                      double const *normals, double *depth, double *point, double *curvatures,
                                      double *directions, double *radius, double *ellipse);

/** pw85_distance_plane() for n ellipsoids and half-spaces; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3
 * @param offsets n
 * @param q n×6
 * @param[out] distance n; any output may be null
 * @param[out] point n×3
 * @return as for pw85_contact_batch(); a zero normal is #PW85_EINVAL */
PW85_API int pw85_distance_plane_batch(size_t n, double const *normals, double const *offsets, double const *q,
                                       double *distance, double *point);

/** pw85_distance_plane_derivatives() for n ellipsoids and half-spaces; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3
 * @param q n×6
 * @param[out] d_center,d_rot n×3 each; any output may be null
 * @return as for pw85_distance_plane_batch() */
PW85_API int pw85_distance_plane_derivatives_batch(size_t n, double const *normals, double const *q, double *d_center,
                                                   double *d_rot);

/** pw85_contact_plane() for n ellipsoids and half-spaces; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3
 * @param offsets n
 * @param q n×6
 * @param[out] mu2 n; any output may be null
 * @param[out] point n×3
 * @return as for pw85_distance_plane_batch() */
PW85_API int pw85_contact_plane_batch(size_t n, double const *normals, double const *offsets, double const *q,
                                      double *mu2, double *point);

/** pw85_contact_plane_derivatives() for n ellipsoids and half-spaces; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param normals n×3
 * @param offsets n
 * @param q n×6
 * @param[out] d_center,d_rot n×3 each; any output may be null
 * @return as for pw85_distance_plane_batch() */
PW85_API int pw85_contact_plane_derivatives_batch(size_t n, double const *normals, double const *offsets,
                                                  double const *q, double *d_center, double *d_rot);

/** pw85_distance_box() for n ellipsoids and boxes; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param lower,upper n×3 each; lower <= upper
 * @param q n×6
 * @param[out] distance n; any output may be null
 * @param[out] point,normal n×3 each
 * @return as for pw85_contact_batch(); lower > upper is #PW85_EINVAL */
PW85_API int pw85_distance_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                                     double *distance, double *point, double *normal);

/** pw85_distance_cylinder() for n ellipsoids and cylinders; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param axis n×3, of any lengths > 0
 * @param radius n, > 0
 * @param center n×3
 * @param q n×6
 * @param[out] distance n; any output may be null
 * @param[out] point,normal n×3 each
 * @return as for pw85_contact_batch(); a zero axis and a radius that is not positive are #PW85_EINVAL */
PW85_API int pw85_distance_cylinder_batch(size_t n, double const *axis, double const *radius, double const *center,
                                          double const *q, double *distance, double *point, double *normal);

/** pw85_distance_point() for n points and ellipsoids; the bits are the same.
 *
 * @param n number of points
 * @param r n×3
 * @param q n×6
 * @param[out] distance n; any output may be null
 * @param[out] point,normal n×3 each
 * @return as for pw85_contact_batch() */
PW85_API int pw85_distance_point_batch(size_t n, double const *r, double const *q, double *distance, double *point,
                                       double *normal);

/** pw85_intersect_line() for n lines and ellipsoids; the bits are the same.
 *
 * @param n number of lines
 * @param origin n×3
 * @param directions n×3, of any lengths > 0
 * @param q n×6
 * @param[out] enter,leave n each: where a line enters and leaves, as t; NaN if it misses its ellipsoid; any output may be null
 * @return as for pw85_contact_batch(); a zero direction is #PW85_EINVAL */
PW85_API int pw85_intersect_line_batch(size_t n, double const *origin, double const *directions, double const *q,
                                       double *enter, double *leave);

/** pw85_contact_segment() for n ellipsoids and segments. The bound of the error is the same; the last bits may differ.
 *
 * @param n number of ellipsoids
 * @param end1,end2 n×3 each
 * @param q n×6
 * @param[out] mu2 n; any output may be null
 * @param[out] point n×3
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_segment_batch(size_t n, double const *end1, double const *end2, double const *q, double *mu2,
                                        double *point);

/** pw85_contact_triangle() for n ellipsoids and triangles. The bound of the error is the same; the last bits may differ.
 *
 * @param n number of ellipsoids
 * @param vertex1,vertex2,vertex3 n×3 each
 * @param q n×6
 * @param[out] mu2 n; any output may be null
 * @param[out] point n×3
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_triangle_batch(size_t n, double const *vertex1, double const *vertex2, double const *vertex3,
                                         double const *q, double *mu2, double *point);

/** pw85_contact_box() for n ellipsoids and boxes. The bound of the error is the same; the last bits may differ.
 *
 * @param n number of ellipsoids
 * @param lower,upper n×3 each; lower <= upper
 * @param q n×6
 * @param[out] mu2 n; any output may be null
 * @param[out] point n×3
 * @return as for pw85_contact_batch(); lower > upper is #PW85_EINVAL */
PW85_API int pw85_contact_box_batch(size_t n, double const *lower, double const *upper, double const *q, double *mu2,
                                    double *point);

/** pw85_overlap_segment() for n ellipsoids and segments.
 *
 * @param n number of ellipsoids
 * @param end1,end2 n×3 each
 * @param q n×6
 * @param[out] overlap n: 1 or 0, 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_segment_batch(size_t n, double const *end1, double const *end2, double const *q,
                                        unsigned char *overlap);

/** pw85_overlap_triangle() for n ellipsoids and triangles.
 *
 * @param n number of ellipsoids
 * @param vertex1,vertex2,vertex3 n×3 each
 * @param q n×6
 * @param[out] overlap n: 1 or 0, 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_overlap_triangle_batch(size_t n, double const *vertex1, double const *vertex2, double const *vertex3,
                                         double const *q, unsigned char *overlap);

/** pw85_overlap_box() for n ellipsoids and boxes.
 *
 * @param n number of ellipsoids
 * @param lower,upper n×3 each; lower <= upper
 * @param q n×6
 * @param[out] overlap n: 1 or 0, 255 for a bad row
 * @return as for pw85_contact_batch(); lower > upper is #PW85_EINVAL */
PW85_API int pw85_overlap_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                                    unsigned char *overlap);

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

/** pw85_first_contact() for n pairs; the bits are the same.
 *
 * @param n number of pairs
 * @param r12 n×3
 * @param q1,q2 n×6
 * @param motion1,motion2 n each
 * @param t_max as for pw85_first_contact(), for all pairs
 * @param[out] t n
 * @return as for pw85_contact_batch(); #PW85_ECONVERGENCE, too */
PW85_API int pw85_first_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                      pw85_motion const *motion1, pw85_motion const *motion2, double t_max, double *t);

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

/** Particles, in a periodic cell or not. The caller owns the struct and its arrays; functions only read them, and do not use them
 * after the call. A pointer may be null if the function says so, because it does not read that member.
 *
 * If there is a cell, `periodic` says along which of its vectors there are periodic images. It must be set: a cell without a
 * periodic vector is #PW85_EINVAL. Vectors that are not periodic may be zero or NaN. Without a cell `periodic` is not read. */
typedef struct pw85_system {
    /** number of particles; 0 is fine, and pointers may then be null. */
    size_t num_particles;
    /** num_particles×3: centres, anywhere in space. */
    double const *centers;
    /** num_particles×6: forms. */
    double const *q;
    /** 3×3: rows are the vectors of the cell, of which at least one is periodic;
     * or null if nothing is periodic. */
    double const *cell;
    /** not 0 for each vector of the cell along which there are images. */
    int periodic[3];
} pw85_system;

/** Pairs of particles of a system. The caller owns the struct and its arrays; functions only read them, and do not use them after
 * the call. */
typedef struct pw85_pair_list {
    /** number of pairs; 0 is fine, and pointers may then be null. */
    size_t num_pairs;
    /** num_pairs×2: indices (i, j) of particles, from 0. */
    int32_t const *pairs;
    /** num_pairs×3: multiples of the cell vectors, as given, to be added to the centre
     * of j, where multiples of vectors that are not periodic count as 0; or null for
     * the nearest images. */
    int32_t const *images;
} pw85_pair_list;

/** pw85_overlap_any() for others of a system, by their indices: the inner loop of a Monte Carlo move, for the trial ellipsoid.
 *
 * In a periodic cell `images` selects one image of each of the others, as in a neighbour list. Without `images` the answer is about
 * all images of the others and of the ellipsoid itself. The function then tests the nearest images. The answer is known if one of
 * them overlaps, or if no farther image can overlap (pw85_nearest_image_limit() of all these particles is 1 or more). Otherwise the
 * status is #PW85_EINVAL: pass the images of a neighbour list. In so small a cell the ellipsoid can also overlap images of itself,
 * which the list contains: write the trial into the arrays of the system before the call, so that its own index refers to the
 * trial.
 *
 * @param center,q1 centre and form of the ellipsoid
 * @param system the particles; the cell is best reduced (pw85_cell_reduce()) unless there are images. Unless there are, others that
 *        are more than 2⁵⁰ vectors of the reduced cell from the ellipsoid are bad.
 * @param n number of others; 0 is fine
 * @param indices n: of particles, from 0; not that of the ellipsoid itself unless there are images
 * @param images n×3: multiples of the cell vectors, as given, to be added to the centres of the others; or null for all images
 * @param[out] any 1 or 0; -1 on error
 * @return as for pw85_overlap_any(); #PW85_EINVAL also for an index out of range, `images` without `cell`, a cell that is
 *         not finite or, unless there are images, singular, and if nearest images do not decide */
PW85_API int pw85_overlap_any_indices(double const center[PW85_DIM], double const q1[PW85_SYM],
                                      pw85_system const *system, size_t n, int32_t const *indices,
                                      int32_t const *images, int *any);

/** pw85_contact() for the pairs of a neighbour list.
 *
 * In a periodic cell a pair stands for one image of j, either that of `images` or the nearest one (by the distance of the
 * centres). The nearest one is found for any cell, however skewed. If the cell is small or particles are large, an image that is
 * not the nearest can have a smaller μ²: pw85_nearest_image_limit() says when.
 *
 * @param list the pairs
 * @param system the particles. Where nearest images are asked for, a pair is bad whose centres are more than 2⁵⁰ vectors of the
 *        reduced cell from each other: rounding leaves nothing of its nearest image. The cell need not be reduced, but then each call
 *        takes some hundred nanoseconds more than for the reduced one: see pw85_cell_reduce().
 * @param[out] mu2 num_pairs
 * @param[out] lambda num_pairs, or null
 * @return as for pw85_contact_batch(); #PW85_EINVAL also for `images` without `cell`, a cell that is not finite or, unless
 *         there are images, singular */
PW85_API int pw85_contact_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2, double *lambda);

/** pw85_overlap() for the pairs of a neighbour list; arguments as for pw85_contact_pairs().
 *
 * @param[out] overlap num_pairs: 1, 0, or 255 for a bad pair */
PW85_API int pw85_overlap_pairs(pw85_pair_list const *list, pw85_system const *system, unsigned char *overlap);

/** pw85_overlap_volume() for the pairs of a neighbour list; arguments as for pw85_contact_pairs(). Their sum is the two-body overlap
 * of a system; what three ellipsoids have in common counts three times in it.
 *
 * @param[out] volume num_pairs
 * @return as for pw85_contact_pairs() */
PW85_API int pw85_overlap_volume_pairs(pw85_pair_list const *list, pw85_system const *system, double *volume);

/** The derivatives for the pairs of a neighbour list; arguments as for pw85_contact_pairs(), outputs as for
 * pw85_contact_derivatives_batch().
 *
 * @param[out] mu2,lambda num_pairs each; any output may be null
 * @param[out] point,normal,d_r12,d_rot1,d_rot2 num_pairs×3 each */
PW85_API int pw85_contact_derivatives_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2,
                                            double *lambda, double *point, double *normal, double *d_r12,
                                            double *d_rot1, double *d_rot2);

/** Sums of the forces, torques and virial of an energy U(μ²) of pairs: the derivatives of pw85_contact_derivatives_pairs() times
 * dU/dμ². The terms are added in the order of the pairs, so that the bits depend only on the input, not on the number of threads.
 * Each thread goes through all pairs, and adds the terms of its own particles.
 *
 * @param list the pairs; without pairs the sums are 0
 * @param system as for pw85_contact_pairs(); `q` may be null, and without pairs `centers`, too
 * @param d_u num_pairs: dU/dμ²; a pair for which it is 0 is left out, whatever its derivatives
 * @param d_r12,d_rot1,d_rot2 num_pairs×3 each: derivatives of μ²; null if no output needs them
 * @param[out] forces num_particles×3: -∂U/∂centre; any output may be null
 * @param[out] torques num_particles×3: -∂U/∂(rotation vector) about the centre
 * @param[out] virial 3×3: Σ r12 ⊗ force on the second particle of each pair, row-major; divided by the volume it is the part of the
 *             pressure tensor that comes from contacts
 * @return #PW85_SUCCESS, also if a NaN in the input makes some of the sums NaN; #PW85_EINVAL as for pw85_contact_pairs(), before
 *         anything is written */
PW85_API int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system, double const *d_u,
                                       double const *d_r12, double const *d_rot1, double const *d_rot2, double *forces,
                                       double *torques, double *virial);

/** A soft repulsion, U = ε/α (1 - μ)^α for μ < 1 and 0 beyond. Parameters: ε, and α >= 1; 2 is harmonic, 2.5 that of Hertz. */
#define PW85_LAW_SOFT_REPULSION 1

/** Powers of 1/μ, U = A μ⁻ⁿ - B μ⁻ᵐ for μ² < c, less the value of that at μ² = c; 0 beyond. Parameters: A, n, B, m, and c > 0, with
 * n > m > 0. (4ε, 12, 4ε, 6, c) is the potential of Lennard-Jones with μ in the place of r/σ, as Perram and others take it; with
 * c = 2^(1/3) it is only repulsive. */
#define PW85_LAW_INVERSE_POWERS 2

/** A table of at least two points, which divide the range from a to b of μ² into equal intervals: U is the cubic polynomial with the
 * values and derivatives of the points at both ends of an interval, linear below a, and 0 from b on. Parameters: a, b > a, then U and
 * dU/dμ² of each point, in turn. */
#define PW85_LAW_TABLE 3

/** The energy U(μ²) of a pair, the same for all pairs. The caller owns the struct and its array; functions only read them, and do not
 * use them after the call. */
typedef struct pw85_law {
    /** #PW85_LAW_SOFT_REPULSION, #PW85_LAW_INVERSE_POWERS or #PW85_LAW_TABLE. */
    int kind;
    /** number of parameters, which must be that of the kind. */
    size_t num_parameters;
    /** num_parameters: all finite, in the order of the description of the kind. */
    double const *parameters;
} pw85_law;

/** Sums of the energies, forces, torques and virial of the pairs of a neighbour list, whose energy is a law of μ². The function takes
 * little more time than pw85_contact_derivatives_pairs() alone, and less for a soft repulsion, where pairs that do not overlap have no
 * forces. The sums of forces and torques are those of pw85_contact_forces_pairs(), bit by bit, except that a soft repulsion leaves out
 * pairs that do not overlap although their μ² is rounded to less than 1. The bits depend only on the input, not on the number of
 * threads.
 *
 * Concentric ellipsoids have no force. Particles of several species need one list, and one call, for each law.
 *
 * @param list the pairs; without pairs the sums are 0
 * @param system as for pw85_contact_pairs()
 * @param law the energy of a pair
 * @param[out] energy ΣU; any output may be null
 * @param[out] forces num_particles×3: -∂U/∂centre
 * @param[out] torques num_particles×3: -∂U/∂(rotation vector) about the centre
 * @param[out] virial 3×3: Σ r12 ⊗ force on the second particle of each pair, row-major
 * @return as for pw85_contact_pairs(); sums to which a bad pair contributes are NaN. #PW85_EINVAL also for a law whose kind is none of
 *         these, or whose parameters are not allowed; #PW85_ENOMEM without memory for one megabyte per thread. Both come
 *         before anything is written. */
PW85_API int pw85_law_forces_pairs(pw85_pair_list const *list, pw85_system const *system, pw85_law const *law,
                                   double *energy, double *forces, double *torques, double *virial);

/** pw85_first_contact() for the pairs of a neighbour list, and the next event of each particle: what event-driven simulations
 * schedule. A pair stands for the same image of j at all times, that of time 0.
 *
 * @param list,system as for pw85_contact_pairs()
 * @param motions num_particles
 * @param t_max as for pw85_first_contact(), for all pairs
 * @param[out] t num_pairs
 * @param[out] next num_particles: the least t of the pairs of each particle, infinity if there is none; may be null
 * @param[out] next_pair num_particles: the index of that pair, the first of several, or -1; may be null, and must be null
 *        without `next`
 * @return as for pw85_contact_pairs(); #PW85_ECONVERGENCE, too. Bad pairs are no events. */
PW85_API int pw85_first_contact_pairs(pw85_pair_list const *list, pw85_system const *system, pw85_motion const *motions,
                                      double t_max, double *t, double *next, int64_t *next_pair);

/** @}
 * @name Periodic cells
 * @{ */

/** A reduced cell of the same lattice: none of its vectors gets shorter by adding or subtracting others. Compute it once and keep
 * it: the functions of neighbour lists recognise a reduced cell by a few inequalities, and need not reduce it again. Rectangular
 * cells are reduced, and so are cells whose vectors have equal lengths and angles between 60 and 120 degrees.
 *
 * The reduced vectors are sums of cell vectors, and are rounded. `images` for one of the two cells are not valid for the other.
 *
 * @param cell 3×3, rows = vectors
 * @param[out] reduced 3×3; may be the same array as cell
 * @return #PW85_SUCCESS or #PW85_EINVAL (a null pointer, a cell that is singular or not finite) */
PW85_API int pw85_cell_reduce(double const cell[9], double reduced[9]);

/** The nearest images, which the functions of neighbour lists use without `images`: as vectors, and as values for `images`.
 *
 * Functions that are called with these `images` need no search, and each pair keeps the same image. They remain the nearest ones
 * until a particle has moved by about half a cell.
 *
 * @param num_pairs number of pairs
 * @param pairs num_pairs×2: indices (i, j) of particles, from 0
 * @param system the particles, in a cell as for pw85_contact_pairs(): `cell` is not null; `q` may be null
 * @param[out] r12 num_pairs×3: from particle i to the image of particle j; NaN for a bad pair; may be null
 * @param[out] images num_pairs×3: multiples of the vectors of the cell, as given; INT32_MIN for a bad pair; may be null
 * @return as for pw85_contact_batch(); a pair is bad if a centre is not finite, or, if `images` are requested, a multiple is beyond
 *         2³¹ - 1; #PW85_EINVAL also for a cell that is singular or not finite */
PW85_API int pw85_nearest_images(size_t num_pairs, int32_t const *pairs, pw85_system const *system, double *r12,
                                 int32_t *images);

/** The limit of μ² below which only nearest images count: any image of a pair of these particles with a smaller μ² is the nearest.
 *
 * So pw85_overlap_pairs() with nearest images misses no overlap, of any image, if mu2 >= 1; and a μ² below mu2 from
 * pw85_contact_pairs() is the smallest of all images. In a rectangular cell the limit is the smallest value of (L/4h)² over the
 * three directions, with the side L of the cell and the largest half-width h of the particles' bounding boxes: mu2 >= 1 if no box
 * is wider than half the cell. In other cells the directions are those of the faces of the lattice's Voronoi cell. Above the limit,
 * list the images that count and pass them as `images`.
 *
 * @param system the particles, in a cell: `cell` is not null; `centers` may be null. Without particles the limit is infinity.
 * @param[out] mu2 the limit
 * @return #PW85_SUCCESS, #PW85_EINVAL (a cell that is singular or not finite, too), #PW85_ENOTPD */
PW85_API int pw85_nearest_image_limit(pw85_system const *system, double *mu2);

/** @}
 * @name Neighbour lists
 * @{ */

/** A list of all pairs of particles whose bounding boxes intersect, with periodic images. The library owns it; its pairs are
 * arguments of pw85_contact_pairs() and similar functions. */
typedef struct pw85_neighbors pw85_neighbors;

/** Lists the pairs (i, j, image) whose bounding boxes are no farther apart than `skin` along any axis, the ellipsoids scaled by
 * `scale`: |r_d| <= scale (√Qi_dd + √Qj_dd) + skin for d = x, y, z, where r is from the centre of i to that of the image of j.
 * The list therefore has all pairs with μ² <= scale², also after the particles have moved, as long as pw85_neighbors_holds().
 *
 * Each pair is listed once: with i < j, or i = j and an image of i itself whose first multiple other than 0 is positive. Pairs
 * whose boxes are apart by no more than rounding errors (2⁻⁴⁸ of the coordinates) may be listed, too. The pairs are in the order of
 * the particles in space, which depends only on the input, not on the number of threads. The time is proportional to the numbers of
 * particles and pairs, for all sizes and positions, unless most particles are within 2⁻²¹ of the extent of the system. The memory
 * is at most 200 bytes per particle and 64 per pair while the list is made, and 48 and 20 (8 without a cell) afterwards.
 *
 * @param system at most 2³¹ - 1 particles, anywhere in space or in the cell and its images, up to 2²⁹ cells away; there is
 *        no limit to how skewed or small the cell is
 * @param scale factor of the ellipsoids, > 0
 * @param skin >= 0, in the unit of the semi-axes
 * @param[out] list null on error; to be destroyed by pw85_neighbors_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if the periodic vectors are not independent, or an image is more than 2²⁹ vectors
 *         away; #PW85_ENOTPD; #PW85_ENOMEM. pw85_neighbors_check() says which particle is bad. */
PW85_API int pw85_neighbors_create(pw85_system const *system, double scale, double skin, pw85_neighbors **list);

/** The particle because of which a list cannot be made; arguments as for pw85_neighbors_create().
 *
 * @param[out] particle index of the first bad particle: its centre or form is invalid, or it is too far away; num_particles
 *        if there is none, 0 if `system` is null
 * @return the status of that particle; or of the other arguments, with `particle` = num_particles; #PW85_SUCCESS if only
 *         the memory or the number of images can be the cause */
PW85_API int pw85_neighbors_check(pw85_system const *system, double scale, double skin, size_t *particle);

/** Whether a list still has all pairs whose boxes intersect (without skin) after the particles have moved and turned, and the cell
 * has changed.
 *
 * The linear map from the present periodic vectors of the cell to those of the list is applied to each box. The answer is 1 if each
 * box is then within its old box, enlarged by half the skin on each side, up to a motion that all particles share. If the cell
 * shrinks or is sheared together with the centres, about any point, only the changes of the boxes themselves use up the skin,
 * whatever the size of the cell. If the centres do not follow the cell, their displacements relative to it use up the skin, too.
 * After the answer 1 no pair is missing, of any image. After the answer 0 pairs may be missing or not.
 *
 * Do not wrap the centres into the cell again, and do not reduce or flip the vectors of the cell: `images` are multiples of these
 * vectors.
 *
 * @param list a list
 * @param system the same number of particles as for the list, at their present positions, with their forms and the present
 *        cell, which is periodic along the same vectors as for the list: `cell` is not null if the list has one
 * @param[out] holds 1 or 0; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, also if the number of particles is not that of the list, only one of the two has a
 *         cell, or the cell is periodic along other vectors, or its periodic vectors are not finite or not independent; or the
 *         status of the first bad particle */
PW85_API int pw85_neighbors_holds(pw85_neighbors const *list, pw85_system const *system, int *holds);

/** The pairs of a list, with their images if it has a cell: pointers to the arrays of the list, which are valid until it is
 * destroyed.
 *
 * @param list a list, or null
 * @return the pairs; none for null */
PW85_API pw85_pair_list pw85_neighbors_list(pw85_neighbors const *list);

/** Frees a list.
 *
 * @param list a list, or null */
PW85_API void pw85_neighbors_destroy(pw85_neighbors *list);

/** @}
 * @name Triangle meshes
 *
 * Ellipsoids and a mesh of triangles, such as a wall. The mesh is a surface: an ellipsoid inside of a closed mesh does not overlap it
 * unless it meets a triangle. The coordinates of the vertices relative to the centre are rounded to doubles, and the results are those
 * of pw85_contact_triangle() and pw85_overlap_triangle() for all triangles, bit by bit. A tree of boxes saves most of the work.
 * @{ */

/** A triangle mesh and its tree of boxes. The library owns it. Any number of threads may use it at the same time. */
typedef struct pw85_mesh pw85_mesh;

/** Makes a mesh. The arrays are copied.
 *
 * The memory is at most 300 bytes per triangle while the mesh is made, and 150 afterwards.
 *
 * @param num_vertices number of vertices, at most 2³¹ - 1
 * @param vertices num_vertices×3
 * @param num_triangles number of triangles, at most 2³¹ - 1
 * @param triangles num_triangles×3: indices of vertices, from 0. A triangle without area is the segment or the point that has all three
 *        vertices.
 * @param[out] mesh null on error; to be destroyed by pw85_mesh_destroy()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_mesh_create(size_t num_vertices, double const *vertices, size_t num_triangles,
                              int32_t const *triangles, pw85_mesh **mesh);

/** Contact function of an ellipsoid and a mesh: the least μ² of all triangles.
 *
 * The time is some 20 µs for 1,000 triangles, and doubles for ten times as many. It is larger if many triangles are equally near, if
 * the aspect ratio of the ellipsoid exceeds some thousands, or if semi-axes and distances differ by more than a factor of 1e30.
 *
 * @param mesh a mesh
 * @param center of the ellipsoid
 * @param q form of the ellipsoid
 * @param[out] mu2 square of the factor by which the ellipsoid must be scaled to touch the mesh; infinity if the mesh has no triangles;
 *             may be null
 * @param[out] point where the scaled ellipsoid touches, relative to its centre; NaN if the mesh has no triangles; may be null
 * @param[out] triangle index of the nearest triangle, the first of several; -1 if the mesh has none, and on error; may be null
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if the coordinates of a vertex relative to the centre overflow; #PW85_ENOTPD */
PW85_API int pw85_mesh_contact(pw85_mesh const *mesh, double const center[PW85_DIM], double const q[PW85_SYM],
                               double *mu2, double point[PW85_DIM], int32_t *triangle);

/** Whether an ellipsoid and a mesh overlap, μ² < 1 for any triangle. If they only touch, they do not. The answer is that of exact
 * arithmetic for the rounded coordinates relative to the centre.
 *
 * @param mesh,center,q as for pw85_mesh_contact()
 * @param[out] overlap 1 or 0; -1 on error
 * @return as for pw85_mesh_contact() */
PW85_API int pw85_mesh_overlap(pw85_mesh const *mesh, double const center[PW85_DIM], double const q[PW85_SYM],
                               int *overlap);

/** pw85_mesh_contact() for n ellipsoids and one mesh; the bits are the same. Runs in parallel.
 *
 * @param mesh a mesh
 * @param n number of ellipsoids
 * @param centers n×3
 * @param q n×6
 * @param[out] mu2 n; any output may be null
 * @param[out] point n×3
 * @param[out] triangle n: -1 for a bad row, too
 * @return as for pw85_contact_batch() */
PW85_API int pw85_mesh_contact_batch(pw85_mesh const *mesh, size_t n, double const *centers, double const *q,
                                     double *mu2, double *point, int32_t *triangle);

/** pw85_mesh_overlap() for n ellipsoids and one mesh. Runs in parallel.
 *
 * @param mesh a mesh
 * @param n number of ellipsoids
 * @param centers n×3
 * @param q n×6
 * @param[out] overlap n: 1 or 0; 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_mesh_overlap_batch(pw85_mesh const *mesh, size_t n, double const *centers, double const *q,
                                     unsigned char *overlap);

/** Frees a mesh.
 *
 * @param mesh a mesh, or null */
PW85_API void pw85_mesh_destroy(pw85_mesh *mesh);

/** @}
 * @name Monte Carlo of hard ellipsoids
 *
 * A simulation owns particles, cell, lists of neighbours, random numbers and counts. Particles never overlap: each trial is decided by the
 * exact overlap test, for the separations of centres as rounded to doubles. The target is the uniform distribution of all configurations
 * without overlaps, at constant volume or, with trials of the volume, at constant pressure.
 *
 * The random numbers are those of Philox4x32-10 (Salmon and others 2011), selected by the seed and the number of the step. So the same
 * calls give the same trajectory, bit by bit, with any number of threads and after pw85_hard_ellipsoids_restore().
 *
 * One simulation may be used by one thread at a time; the functions themselves run in parallel.
 * @{ */

/** A simulation. The library owns it. */
typedef struct pw85_hard_ellipsoids pw85_hard_ellipsoids;

/** Scales the cell in all directions alike. */
#define PW85_CHANGE_ISOTROPIC 0

/** Scales the cell along x, y or z, chosen at random. */
#define PW85_CHANGE_AXIS 1

/** Scales the cell along x, y or z, or shears it, chosen at random. A shear adds a multiple of a later coordinate to an earlier one, so
 * that a cell whose vectors are a lower triangular matrix stays one. */
#define PW85_CHANGE_TRICLINIC 2

/** Makes a simulation. The arrays are copied.
 *
 * In the beginning, half of the trials are translations and half are rotations. The memory is some 420 bytes per particle, 24 more with
 * trials of the volume, and 8 for each of its neighbours. While neighbours are listed, there are at least 10 more for each of them.
 *
 * @param system at most 2³¹ - 1 particles as for pw85_neighbors_create(); `q` may be null, it is not read. The cell may be smaller than
 *        a particle, whose images must not overlap either.
 * @param semi_axes num_particles×3: lengths of the principal semi-axes of each particle, > 0, whose squares are in the range of double
 * @param quaternions num_particles×4: (w, x, y, z), of any lengths > 0
 * @param seed selects the random numbers
 * @param[out] pair the first two particles that overlap, the same for a particle and its own image; -1 if no particles overlap; may be null
 * @param[out] simulation null on error; to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if particles overlap; #PW85_EINVAL and #PW85_ENOTPD as for pw85_neighbors_create(); #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes, double const *quaternions,
                                         size_t seed, int32_t pair[2], pw85_hard_ellipsoids **simulation);

/** Makes sweeps. A sweep has as many trials as there are particles.
 *
 * For each sweep the cell is divided into domains with a random origin. Domains that are not neighbours are worked on at the same time.
 * Each gets as many trials as it has particles, each of a random particle of the domain, and the domains of one colour come after those
 * of another, in random order. A trial that leaves its domain is rejected. So the division does not change during a sweep, the way back of
 * each trial is as probable as the trial, and a sweep is in detailed balance.
 *
 * A translation is by a point of a ball. A rotation multiplies the quaternion by (1, v) from the left, v a point of a ball. An exchange
 * swaps the semi-axes of two particles of a domain.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_ENOMEM, after which the last sweep is not complete */
PW85_API int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps);

/** Makes event chains, which translate many particles at once and give the pressure.
 *
 * For each chain a random particle moves along a direction until it touches another one. This one moves on from there, and so on, until
 * the sum of the ways is the length of the chain. No chain leads to an overlap (pw85_free_path(), and the exact overlap test of each
 * place). Chains do not rotate particles: use sweeps of rotations, too.
 *
 * Chains along one direction keep the uniform distribution, without detailed balance, but do not change the coordinates across it.
 * Chains along random directions are in detailed balance. βP/ρ, along the direction, is the mean of (x_last - x_first)/length over
 * chains, where x is the coordinate along the direction of the particle that moves, which jumps at each contact (Michel, Kapfer
 * and Krauth 2014). Make blocks of chains to see its error.
 *
 * @param simulation a simulation
 * @param num_chains how many
 * @param length of each chain, > 0, in the unit of length. It is long if it is the mean way between contacts times the number of
 *        particles
 * @param direction of any length > 0; or null for a random direction of each chain, isotropic
 * @param[out] compressibility βP/ρ along the directions, by these chains; may be null. NaN on error, without chains or particles, and where
 *        a particle could touch its own image if it turned: where the shortest vector of the lattice is not longer than twice the
 *        longest semi-axis. Such contacts are a part of the pressure that chains do not find, because images move with their particle.
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a zero direction; #PW85_ENOMEM or #PW85_ECONVERGENCE (particles block each other within
 *         rounding errors, or the length is more than some 10¹⁵ ways), after which the last chain is not complete */
PW85_API int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains, double length,
                                        double const direction[PW85_DIM], double *compressibility);

/** Tries changes of the cell and of all centres with it, at constant pressure.
 *
 * The coordinates are multiplied by a random matrix E. It is as probable as its inverse. The trial is accepted with the probability
 * min(1, (det E)^(N+1) exp(-βP V (det E - 1))) if there is no overlap afterwards. So the density of volumes of N particles is that of
 * V^N exp(-βPV) for each kind of change, and the kinds may be mixed. The logarithmic lengths and the shears of the cell are distributed
 * uniformly otherwise; a fluid does not limit the shears.
 *
 * @param simulation a simulation with a cell that is periodic along its three vectors
 * @param num_moves number of trials
 * @param pressure βP, > 0, in the inverse cube of the unit of length
 * @param change #PW85_CHANGE_ISOTROPIC, #PW85_CHANGE_AXIS or #PW85_CHANGE_TRICLINIC
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves, double pressure,
                                               int change);

/** Makes sweeps, and changes the steps after each of them towards an acceptance. Then it sets all counts to zero.
 *
 * Trials are not in detailed balance while the steps change: use this to equilibrate only. Translations become at most half as long as the
 * longest semi-axis. Only where particles are far apart may they become longer, so that the lists of neighbours stay short.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @param acceptance the desired part of the trials that is accepted, > 0 and at most 1
 * @param pressure βP as for pw85_hard_ellipsoids_volume_moves(), for one trial of the volume after each sweep; 0 for none
 * @param change as for pw85_hard_ellipsoids_volume_moves()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps, double acceptance,
                                       double pressure, int change);

/** Sets the parts of the trials of a sweep that are translations, rotations, both at once, and exchanges.
 *
 * @param simulation a simulation
 * @param fractions not negative; they are divided by their sum, which is positive
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation, double const fractions[4]);

/** Sets the largest changes of a trial.
 *
 * The lists of neighbours reach three times as far as a translation. So their memory grows with its third power.
 *
 * @param simulation a simulation
 * @param steps positive: the length of a translation, in a cell that is periodic along its three vectors at most that of the longest one;
 *        the tangent of half of the angle of a rotation, at most 1; the relative change of a length of the cell or the shear, at most 1
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation, double const steps[3]);

/** The largest changes of a trial.
 *
 * @param simulation a simulation
 * @param[out] steps as for pw85_hard_ellipsoids_set_steps()
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3]);

/** The numbers of trials since the simulation was made or tuned: translations, rotations, both at once, exchanges, volume.
 *
 * @param simulation a simulation
 * @param[out] trials how many there were; -1 on error; may be null
 * @param[out] accepted how many of them were accepted; -1 on error; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                         int64_t accepted[5]);

/** The images of particles whose bounding boxes meet that of one particle, ordered by their indices, then by their images. Particles
 * that the given one may touch or overlap are among them. The order and the numbers depend on the present state alone.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param capacity how many images the arrays can have; with 0 the function only counts
 * @param[out] count how many images there are, which may be more than `capacity`; 0 on error
 * @param[out] particles capacity: index of each; the first `count` are written, as of the next arrays, which may all be null
 * @param[out] images capacity×3: multiples of the vectors of the cell, to be added to the centre of that particle, or null
 * @param[out] separations capacity×3: from the centre of the given particle to that of the image, or null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_neighbors(pw85_hard_ellipsoids *simulation, size_t particle, size_t capacity,
                                            size_t *count, int32_t *particles, int32_t *images, double *separations);

/** Whether a particle would be free of overlaps at another place, by the exact test; and moves it there, if wanted. All images are tested,
 * those of the particle itself, too. Counts and random numbers stay as they are.
 *
 * A place near the present one takes about as long as a trial of a sweep. For other places, a new list of all neighbours is made.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param center new centre, anywhere in the cell or its images, or null for the present one
 * @param quaternion new orientation (w, x, y, z), of any length > 0, or null for the present one
 * @param take whether the particle shall stay there if it is free
 * @param[out] is_free 1 or 0; -1 on error
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a free place that is too far away for pw85_neighbors_create(); #PW85_ENOTPD;
 *         #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle, double const center[PW85_DIM],
                                      double const quaternion[4], int take, int *is_free);

/** How far cell and centres can be compressed before particles touch: the factor of all lengths, the same in all directions; and
 * compresses, if wanted. Particles keep their sizes. The factor is that of the least μ of all pairs, 1/μ, enlarged by no more than rounding
 * errors require: the exact test finds no overlap after the coordinates are multiplied by the factor and rounded.
 *
 * @param simulation a simulation
 * @param take whether the cell and the centres shall be multiplied by the factor
 * @param[out] factor at most 1; 0, and nothing is changed, if there are no pairs; NaN on error
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if particles are too far apart for a list of neighbours; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_compress(pw85_hard_ellipsoids *simulation, int take, double *factor);

/** Searches all particles for overlaps, by a neighbour list of its own.
 *
 * @param simulation a simulation
 * @param[out] pair as for pw85_hard_ellipsoids_create()
 * @return #PW85_SUCCESS if there is no overlap, #PW85_EOVERLAP, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_check(pw85_hard_ellipsoids const *simulation, int32_t pair[2]);

/** Particles and cell: pointers to the arrays of the simulation. They are valid until it is destroyed, and show its present state. Centres
 * are not wrapped into the cell.
 *
 * @param simulation a simulation, or null
 * @return the system; without particles for null */
PW85_API pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation);

/** The orientations, num_particles×4, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation a simulation, or null
 * @return quaternions (w, x, y, z) of length one; null for null */
PW85_API double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation);

/** The semi-axes, num_particles×3, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation a simulation, or null
 * @return the lengths; null for null */
PW85_API double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation);

/** The number of bytes that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation a simulation, or null
 * @return the number; 0 for null */
PW85_API size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation);

/** Writes the whole state of a simulation as bytes: 80 for each particle and some hundreds. They can be read on machines of the same
 * kind.
 *
 * @param simulation a simulation
 * @param num_bytes pw85_hard_ellipsoids_num_bytes()
 * @param[out] bytes num_bytes
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes, unsigned char *bytes);

/** Makes a simulation from the bytes of another, which it continues bit by bit.
 *
 * @param num_bytes number of bytes
 * @param bytes num_bytes
 * @param[out] simulation null on error; to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for bytes of another kind of machine or of another version; #PW85_EINVAL, #PW85_EOVERLAP,
 *         #PW85_ENOTPD if bytes have been changed to a state that is not possible; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                          pw85_hard_ellipsoids **simulation);

/** Frees a simulation.
 *
 * @param simulation a simulation, or null */
PW85_API void pw85_hard_ellipsoids_destroy(pw85_hard_ellipsoids *simulation);

/** @}
 * @name Many forms
 *
 * Rows, bad rows and threads are as for many pairs. Bad rows are marked with NaN.
 * @{ */

/** pw85_ellipsoid_factor() for n ellipsoids; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param semi_axes n×3, as for pw85_ellipsoid_factor()
 * @param quaternions n×4: (w, x, y, z), of any lengths > 0
 * @param[out] s n×3×3
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_ellipsoid_factor_batch(size_t n, double const *semi_axes, double const *quaternions, double *s);

/** pw85_ellipsoid_quaternion() for n ellipsoids; the bits are the same.
 *
 * @param n number of ellipsoids
 * @param semi_axes n×3, as for pw85_ellipsoid_quaternion()
 * @param quaternions n×4: (w, x, y, z), of any lengths > 0
 * @param[out] q n×6
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes, double const *quaternions, double *q);

/** Tight boxes, with sides along the axes, around n ellipsoids.
 *
 * @param n number of ellipsoids
 * @param q n×6
 * @param[out] half_widths n×3: √Qxx, √Qyy, √Qzz, in the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL, or the status of the first bad form */
PW85_API int pw85_bounding_boxes(size_t n, double const *q, double *half_widths);

/** @}
 * @name Building blocks
 *
 * Public for tests and studies. Names with two underscores may change between minor versions.
 * @{ */

/** Cholesky factorisation A = L Lᵀ.
 *
 * @param a symmetric positive definite matrix
 * @param[out] l lower triangle of L by columns: (l11, l21, l31, l22, l32, l33); NaN if a pivot, computed in double, is not
 *        positive: that depends on rounding where `a` is singular to working precision */
PW85_API void pw85__cholesky_decomp(double const a[PW85_SYM], double l[PW85_SYM]);

/** Solution of L Lᵀ x = b.
 *
 * @param l from pw85__cholesky_decomp()
 * @param b right-hand side
 * @param[out] x solution; may be the same array as b */
PW85_API void pw85__cholesky_solve(double const l[PW85_SYM], double const b[PW85_DIM], double x[PW85_DIM]);

/** Residual g(λ) = μ2² - μ1² = -f'(λ), whose root is the maximiser of f.
 *
 * @param lambda in [0, 1]
 * @param r12,q1,q2 as for pw85_contact()
 * @param[out] out (f, g, g') at λ; NaN for invalid input */
PW85_API void pw85__residual(double lambda, double const r12[PW85_DIM], double const q1[PW85_SYM],
                             double const q2[PW85_SYM], double out[3]);

/** -f(λ), with parameters in one block, as minimisers pass them.
 *
 * @param lambda in [0, 1]
 * @param params 15: r12, q1, q2 one after the other
 * @return -f(λ); NaN for invalid input */
PW85_API double pw85_f_neg(double lambda, double const *params);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
