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
 * Every point is inside the ellipsoid or on it, in exact arithmetic for the numbers that are
 * returned. The volume is at most 1 + excess times the least volume. With #PW85_SUCCESS the excess
 * is at most the tolerance.
 *
 * Rounding the centre and the form to double limits the excess. The form adds about n u κ, with u =
 * 2⁻⁵³. Here κ is the condition number of the form in those units of the coordinates that make it
 * least: 1 for axes along the coordinates, the square of the aspect ratio for general axes. The
 * centre adds about n u D/a, with the distance D of the points from 0 and the shortest semi-axis a:
 * move points that are far from 0 first.
 *
 * Points in a hyperplane have an ellipsoid without volume. With #PW85_ENOTPD, the outputs are the
 * smallest ellipsoid in the affine hull of the points: q is singular, with rank k < n, and the
 * excess is that of the volume in k dimensions. This ellipsoid is not proved. Points can be outside
 * by rounding errors, and across the hull by their distance from it. All points equal give k = 0
 * and q = 0.
 *
 * The time for 10⁶ random points is that of 5 to 10 passes over them. The function allocates 16
 * bytes for each point, 8 n more for points in a hyperplane, and at most 2 MiB that do not depend
 * on m.
 *
 * @param n [1..16] dimensions
 * @param m [number of points] at least n + 1
 * @param points [m×n; length] in any order; points may be equal. The extent of each coordinate must
 *        be between 2⁻⁴⁸⁰ and 2⁴⁸⁰
 * @param tolerance [> 0] of the volume, relative
 * @param[out] center [n; length; optional] of the ellipsoid
 * @param[out] q [n(n+1)/2; length²; optional] form of the ellipsoid, packed
 * @param[out] excess [optional] upper bound of the relative difference of the volume and the least
 *        volume
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for fewer than n + 1 points; #PW85_ENOTPD if the points
 *        are in a hyperplane, or so close to one that no form of double precision can be certified
 *        (nearer than about 2⁻²⁴ of their extents); #PW85_ECONVERGENCE if the excess exceeds the
 *        tolerance: the outputs are valid then; #PW85_ENOMEM */
PW85_API int pw85_enclosing_ellipsoid(int n, size_t m, double const *points, double tolerance,
                                      double *center, double *q, double *excess);

/** Computes the ellipsoid of least volume around ellipsoids, up to a tolerance, with a proof.
 *
 * Every ellipsoid is inside, in exact arithmetic for the numbers that are given and returned. The
 * volume is at most 1 + excess times the least volume.
 *
 * Rounding limits the excess as for pw85_enclosing_ellipsoid(): needles of aspect ratio 10⁴ have an
 * excess of about n 10⁻⁸, and those of 10⁷ cannot always be certified. In ten and more dimensions
 * the excess sometimes exceeds a tolerance of 10⁻¹², because the proof that the ellipsoids are
 * inside enlarges the result.
 *
 * The time is that of some ten rounds. A round takes one test of containment for each ellipsoid,
 * and some 15 steps of Newton's method for those that touch the result.
 *
 * @param n [1..16] dimensions
 * @param m [number of ellipsoids] at least 1
 * @param centers [m×n; length] of the ellipsoids, in any order. The extent of all ellipsoids along
 *        each coordinate must be between 2⁻⁴⁸⁰ and 2⁴⁸⁰
 * @param forms [m×n(n+1)/2; length²; definite] of the ellipsoids, packed
 * @param tolerance [> 0] of the volume, relative
 * @param[out] center,q,excess [as pw85_enclosing_ellipsoid()]
 * @return #PW85_SUCCESS; #PW85_EINVAL; #PW85_ENOTPD if a form is not positive definite, or if the
 *        ellipsoid is so flat that it cannot be certified; #PW85_ECONVERGENCE if the excess exceeds
 *        the tolerance: the outputs are valid then; #PW85_ENOMEM */
PW85_API int pw85_enclosing_ellipsoid_of(int n, size_t m, double const *centers,
                                         double const *forms, double tolerance, double *center,
                                         double *q, double *excess);

/** Makes random points of an ellipsoid with its centre at 0, uniform in its volume or on its
 * surface.
 *
 * Point k depends only on the form, the seed and k: a call with more points gives the same first
 * points. A point of the body is a random point of the unit ball, stretched by the semi-axes. A
 * point of the surface is one of the unit sphere, stretched, and kept with a probability that makes
 * the points uniform. At least half of them are kept, for every shape. The coordinates of points of
 * the ball are odd multiples of 2⁻³², from Philox4x32-10. The error of each coordinate is below 10
 * u times the longest semi-axis, with u = 2⁻⁵³.
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
