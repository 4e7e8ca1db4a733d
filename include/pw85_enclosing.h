/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_enclosing.h
 * @brief The smallest ellipsoid around points, in 1 to 16 dimensions, and random points of an
 * ellipsoid.
 *
 * Conventions are those of pw85.h. Points are rows of n numbers. A form is a packed symmetric
 * matrix: the rows of its upper triangle, one after the other. These n(n+1)/2 numbers are (xx, xy,
 * xz, yy, yz, zz) for n = 3.
 */
#ifndef PW85_ENCLOSING_H_INCLUDED
#define PW85_ENCLOSING_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Computes the ellipsoid of least volume around points, up to a tolerance, with a proof.
 *
 * Every point is inside the returned ellipsoid or on its surface; this holds in exact arithmetic
 * for the returned numbers. The volume is at most 1 + excess times the least volume. If the status
 * is #PW85_SUCCESS, the excess is at most the tolerance.
 *
 * The excess cannot be arbitrarily small, because the centre and the form are rounded to double.
 * Rounding the form adds about n u κ to the excess, with u = 2⁻⁵³. Here κ is the least condition
 * number of the form over all choices of a separate unit for each coordinate. It is 1 if the axes
 * are along the coordinates, and up to the square of the aspect ratio for other axes. Rounding the
 * centre adds about n u D/a, with the distance D of the points from 0 and the shortest semi-axis a.
 * If the points are far from 0, translate them before the call.
 *
 * If all points are in a hyperplane, the smallest ellipsoid has no volume. The status is then
 * #PW85_ENOTPD, and the outputs are the smallest ellipsoid in the affine hull of the points: q is
 * singular, with rank k < n, and the excess refers to the volume in k dimensions. The function does
 * not prove this ellipsoid: points can be outside it by rounding errors, and by their distance from
 * the hull. If all points are equal, k = 0 and q = 0.
 *
 * For 10⁶ random points, the time is that of 5 to 10 passes over the points. The function allocates
 * 16 bytes for each point, another 8 n bytes for each point if the points are in a hyperplane, and
 * at most 2 MiB that do not depend on m.
 *
 * @param n [1..16] dimensions
 * @param m [number of points] at least n + 1
 * @param points [m×n; length] in any order; points may be equal. The extent of each coordinate must
 *        be between 2⁻⁴⁸⁰ and 2⁴⁸⁰
 * @param tolerance [> 0] of the volume, relative
 * @param[out] center [n; length; optional] of the ellipsoid
 * @param[out] q [n(n+1)/2; length²; optional] form of the ellipsoid, packed
 * @param[out] excess [optional] upper bound of the relative difference between the volume and the
 *        least volume
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for fewer than n + 1 points; #PW85_ENOTPD if the points
 *        are in a hyperplane, or so close to one that no form of double precision can be certified
 *        (nearer than about 2⁻²⁴ of their extents); #PW85_ECONVERGENCE if the excess exceeds the
 *        tolerance: the outputs are valid then; #PW85_ENOMEM */
PW85_API int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                                      double *center, double *q, double *excess);

/** Computes the ellipsoid of least volume around ellipsoids, up to a tolerance, with a proof.
 *
 * Every given ellipsoid is inside the returned one; this holds in exact arithmetic for the given
 * and the returned numbers. The volume is at most 1 + excess times the least volume.
 *
 * Rounding limits the excess as for pw85_enclosing_ellipsoid(): for needles of aspect ratio 10⁴ the
 * excess is about n 10⁻⁸, and for needles of aspect ratio 10⁷ a proof is not always possible. In
 * ten and more dimensions the excess sometimes exceeds a tolerance of 10⁻¹², because the proof that
 * the ellipsoids are inside enlarges the result.
 *
 * The function needs about ten rounds. Each round makes one test of containment for each ellipsoid,
 * and about 15 steps of Newton's method for the ellipsoids that touch the result.
 *
 * @param n [1..16] dimensions
 * @param m [number of ellipsoids] at least 1
 * @param centers [m×n; length] of the ellipsoids, in any order. The extent of all ellipsoids along
 *        each coordinate must be between 2⁻⁴⁸⁰ and 2⁴⁸⁰
 * @param forms [m×n(n+1)/2; length²; definite] of the ellipsoids, packed
 * @param tolerance [> 0] of the volume, relative
 * @param[out] center,q,excess [as pw85_enclosing_ellipsoid()]
 * @return #PW85_SUCCESS; #PW85_EINVAL; #PW85_ENOTPD if a form is not positive definite, or if the
 *        result is too flat for a proof; #PW85_ECONVERGENCE if the excess exceeds the tolerance:
 *        the outputs are valid then; #PW85_ENOMEM */
PW85_API int pw85_enclosing_ellipsoid_of(int n, size_t m, double const *centers,
                                         double const *forms, double tolerance, double *center,
                                         double *q, double *excess);

/** Makes random points, distributed uniformly in an ellipsoid with its centre at 0, or on its
 * surface.
 *
 * Point k depends only on the form, the seed and k: a call with more points begins with the same
 * points. A point of the body is a random point of the unit ball, stretched by the semi-axes. A
 * point of the surface is a random point of the unit sphere, stretched, and kept with a probability
 * that makes the distribution uniform. At least half of the points are kept, for every shape. The
 * coordinates of points of the ball are odd multiples of 2⁻³², from Philox4x32-10. The error of
 * each coordinate is below 10 u times the longest semi-axis, with u = 2⁻⁵³.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param surface 0 for points of the body, any other number for points of the surface
 * @param seed selects the random numbers
 * @param num_points [number of points] may be 0
 * @param[out] points [num_points×3; length] relative to the centre; NaN if the status is not
 *        success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_random_points(double const q[6], int surface, size_t seed, size_t num_points,
                                double *points);

#ifdef __cplusplus
}
#endif

#endif
