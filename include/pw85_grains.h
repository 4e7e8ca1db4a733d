/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_grains.h
 * @brief Curvatures, contacts, surface and inertia of grains. A part of pw85.h, which includes it
 * and has the conventions.
 */
#ifndef PW85_GRAINS_H_INCLUDED
#define PW85_GRAINS_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Curvature and contact of grains
 *
 * Hertz's theory of two elastic bodies that touch needs the curvatures of both surfaces. The
 * chapter on curvature derives the formulas, and says which of these numbers are continuous.
 * @{ */

/** Principal curvatures of an ellipsoid's surface at the point with a given normal, and their
 * directions.
 *
 * The relative error of each curvature is below 1e-12 for the numbers as given, up to aspect ratio
 * 10⁶. From aspect ratio 10 or so on the function computes with twice the digits, which takes some
 * eight times as long.
 *
 * @param normal [!= 0] out of the ellipsoid, of any length
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] curvatures [1/length; optional] reciprocal radii of curvature, > 0, the smaller one
 *        first
 * @param[out] directions [2×3; optional; members direction1, direction2] unit vectors along which
 *        the surface has these curvatures. Their cross product is the unit normal. If both
 *        curvatures are equal, they are any such vectors
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_curvature(double const normal[3], double const q[6], double curvatures[2],
                            double directions[6]);

/** Hertz's theory of the contact of two elastic bodies: the force and the contact ellipse as
 * functions of the depth.
 *
 * The gap between the undeformed surfaces is half of the sum of curvature times squared length
 * along two perpendicular directions. For a depth δ the bodies repel each other by the force (4/3)
 * E* √(radius δ³), with 1/E* = (1 - ν1²)/E1 + (1 - ν2²)/E2, Young's moduli E and Poisson's ratios
 * ν. The energy is (8/15) E* √(radius δ⁵). The contact area is an ellipse with the semi-axes
 * √(ellipse[0] δ) and √(ellipse[1] δ), the square of whose arithmetic-geometric mean is radius δ.
 * Complete elliptic integrals are included. The relative errors are below 256 u, with u = 2⁻⁵³, for
 * curvatures whose ratio is at most 10¹⁸.
 *
 * @param curvatures [1/length; > 0] along both directions, the sums of those of both bodies: those
 *        of pw85_hertz_contact() for two ellipsoids, of pw85_curvature() for one on a plane
 * @param[out] radius [length; optional] the effective radius. For spheres it is R1 R2/(R1 + R2)
 * @param[out] ellipse [length; optional] squares of the semi-axes over the depth, along the
 *        direction of each curvature
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a curvature that is not positive) */
PW85_API int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2]);

/** Geometry of the contact of two grains along a common normal: what laws of contact such as
 * Hertz's need.
 *
 * For the normal n of pw85_contact_geometry() the depth is α + β - n·r12 = (1/μ - 1) n·r12, with
 * the half-widths α and β of the ellipsoids along n. This is the usual choice: it is a smooth
 * function of positions and orientations for μ > 0. The depth of pw85_penetration() is smaller by a
 * part of second order in the depth; its direction, as `normal`, gives it here, too. For every
 * normal a negative depth proves that the ellipsoids are apart, by at least minus the depth, and
 * the depth is at least that of pw85_penetration() if they overlap.
 *
 * The error of the depth is below 8 u Σ, with Σ as for pw85_distance() with this normal. Up to
 * aspect ratio 10⁶, and for the normal as given, the relative errors of curvatures, radius and
 * ellipse are below 1e-12. The point is half the sum of r12 and of one vector of each ellipsoid;
 * its error is below 1e-12 times the sum of their lengths. The directions err by less than
 * 1e-12/(1 - k1/k2) radians, with the curvatures k1 < k2.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param normal [!= 0] out of ellipsoid 1 and into ellipsoid 2, of any length
 * @param[out] depth [length; optional] in the unit of r12; negative if a slab separates them
 * @param[out] point [length; optional] where the forces of contact act: the middle of the points of
 *        both surfaces that have the normals n and -n, relative to the centre of ellipsoid 1
 * @param[out] curvatures [1/length; optional; member relative.curvatures] of the gap between both
 *        surfaces, > 0, the smaller one first: eigenvalues of the sum of their second fundamental
 *        forms, as pw85_hertz() takes them
 * @param[out] directions [2×3; optional; members relative.direction1, relative.direction2] of these
 *        curvatures and of the contact ellipse
 * @param[out] radius,ellipse [as pw85_hertz(); member hertz.radius, hertz.ellipse]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_hertz_contact(double const r12[3], double const q1[6], double const q2[6],
                                double const normal[3], double *depth, double point[3],
                                double curvatures[2], double directions[6], double *radius,
                                double ellipse[2]);

/** The contact of two grains along their common normal: the least overlap δ(n) = α + β - n·r12 near
 * a given direction, with the half-widths α and β of the ellipsoids along the unit vector n.
 *
 * δ is stationary there, so the force U'(δ) n at the point conserves an energy U(δ).
 * pw85_hertz_contact() takes the normal from the caller; this function finds it by Newton's method.
 * Start from the normal of pw85_contact_geometry(), or from that of the time step before. Then it
 * takes one or two steps.
 *
 * There is a minimum if the overlap is small: below the least sum of radii of curvature. The search
 * ends after a step below 2⁻²² radians. The normal, and points and radius in units of the
 * semi-axes, then err by less than 100·2⁻⁴⁴ at aspect ratios up to 4; the depth errs by the square
 * of that and by rounding.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param start [!= 0] a direction near the normal, out of ellipsoid 1 and into ellipsoid 2, of any
 *        length
 * @param[out] normal [optional] unit vector
 * @param[out] depth [length; optional] δ, in the unit of r12; negative if a slab separates the
 *        ellipsoids
 * @param[out] point [length; optional] the middle of the points of both surfaces that have the
 *        normals n and -n, which are δ n apart, relative to the centre of ellipsoid 1
 * @param[out] curvatures,radius [as pw85_hertz_contact(); member curvatures, radius]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD, #PW85_ECONVERGENCE
 *        if the search leads to no minimum */
PW85_API int pw85_grain_contact(double const r12[3], double const q1[6], double const q2[6],
                                double const start[3], double normal[3], double *depth,
                                double point[3], double curvatures[2], double *radius);

/** Derivatives of the radius of pw85_grain_contact(), whose normal follows each motion. A force
 * that depends on the radius needs them to conserve the energy.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param normal [!= 0] that of pw85_grain_contact(), of any length
 * @param[out] d_r12 [optional; member r12] with respect to r12
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] with respect to small
 *        rotation vectors of either ellipsoid about its own centre, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD, #PW85_ECONVERGENCE if
 *        the overlap has no minimum there */
PW85_API int pw85_grain_radius_gradient(double const r12[3], double const q1[6], double const q2[6],
                                        double const normal[3], double d_r12[3], double d_rot1[3],
                                        double d_rot2[3]);

/** The contact of a grain with its centre at 0 and a wall that touches the plane normal·x = offset
 * and is curved along one direction, as a plane, a cylinder or the edge of one is.
 *
 * Up to aspect ratio 10⁶ the relative errors of both curvatures and of the radius are below 1e-12
 * for the numbers as given, also where the curvatures nearly cancel. From aspect ratio 10 or so on,
 * and for concave walls (curvature < 0) that make the product of both curvatures of the gap less
 * than half of that of the ellipsoid, the function computes with twice the digits.
 *
 * @param normal,offset [as pw85_distance_plane()]
 * @param direction [!= 0] across the normal, of any length, along which the wall is curved
 * @param curvature [1/length] of the wall along `direction`: positive for a wall that is convex, 0
 *        for a plane
 * @param q [as pw85_distance_plane()]
 * @param[out] depth [length; optional] minus the distance of pw85_distance_plane()
 * @param[out] point [length; optional] of the ellipsoid, the deepest one in the wall
 * @param[out] curvatures [1/length; optional] of the gap, the smaller one first. It is raised to
 *        2⁻²⁰ times the larger one if it is less: surfaces that touch along a line have no finite
 *        radius
 * @param[out] radius [as pw85_hertz()]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal or direction), #PW85_ENOTPD */
PW85_API int pw85_grain_contact_wall(double const normal[3], double offset,
                                     double const direction[3], double curvature, double const q[6],
                                     double *depth, double point[3], double curvatures[2],
                                     double *radius);

/** @}
 * @name Surface and inertia of bodies
 *
 * A solid body is uniform. A shell is a sheet of the same mass per area everywhere, or in the plane
 * a wire of the same mass per length. Moments are means: they are those of a body with the mass 1.
 *
 * Surfaces and shells are elliptic integrals, which the library computes with twice the digits of
 * double. Let κ be the square of the ratio of the longest to the shortest semi-axis. The relative
 * error of an area is below u + 2⁻⁹⁸ κ, with u = 2⁻⁵³. The error of an entry of the moments of a
 * shell is below u times this entry plus 2⁻⁹⁸ κ times the largest entry. If the axes are along the
 * coordinates, κ counts as 1. The chapter on bodies derives the formulas.
 * @{ */

/** Area of the surface of an ellipsoid: 4π abc R_G(1/a², 1/b², 1/c²), with Carlson's integral.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] area [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_surface_area(double const q[6], double *area);

/** Mean of x xᵀ over a uniform solid ellipsoid, about its centre: q/5. The error of each entry is
 * below u times the entry.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_second_moments(double const q[6], double moments[6]);

/** Form of the uniform solid ellipsoid that has given second moments: 5 times these, the inverse of
 * pw85_second_moments(). Other bodies get the ellipsoid with their second moments, which has
 * another volume. The error of each entry is below u times the entry.
 *
 * @param second_moments [length²; definite] mean of x xᵀ over a body, about its centre
 * @param[out] q [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_from_moments(double const second_moments[6], double q[6]);

/** Mean of x xᵀ over the surface of an ellipsoid, about its centre: the second moments of a shell.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_shell_moments(double const q[6], double moments[6]);

/** Tensor of inertia of a body or of a shell of unit density, about its centre: m (tr(M) I - M)
 * with the second moments M, and the volume of the body or the area of the shell for the mass m.
 *
 * Multiply it by the mass per volume or per area. Divided by pw85_volume() or pw85_surface_area(),
 * it is the tensor of mass 1. The error of each entry is below 4 u + 2⁻⁹⁸ κ times the entry for
 * bodies. For shells it is below 4 u times the entry plus 2⁻⁹⁸ κ times the largest entry.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param shell 0 for a solid body, any other number for a shell
 * @param[out] inertia [mixed units] length⁵ for a body, length⁴ for a shell
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_inertia(double const q[6], int shell, double inertia[6]);

/** Perimeter of an ellipse: 8 R_G(0, a², b²), with Carlson's integral.
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] perimeter [length]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_perimeter_2d(double const q[3], double *perimeter);

/** Mean of x xᵀ over a uniform ellipse, about its centre: q/4. The trace is the moment of inertia
 * about the axis across the plane, for the mass 1.
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_second_moments_2d(double const q[3], double moments[3]);

/** Form of the uniform ellipse that has given second moments: 4 times these; see
 * pw85_from_moments().
 *
 * @param second_moments [length²; definite]
 * @param[out] q [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_from_moments_2d(double const second_moments[3], double q[3]);

/** Mean of x xᵀ over the perimeter of an ellipse, about its centre: the second moments of a wire.
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_shell_moments_2d(double const q[3], double moments[3]);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
