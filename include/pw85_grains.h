/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_grains.h
 * @brief Curvatures, contacts, surface and inertia of grains. pw85.h includes this header and has
 * the conventions.
 */
#ifndef PW85_GRAINS_H_INCLUDED
#define PW85_GRAINS_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Curvature and contact of grains
 *
 * Hertz's theory of two elastic bodies in contact needs the curvatures of both surfaces. The
 * chapter on curvature derives the formulas, and states which of these numbers are continuous.
 * @{ */

/** Computes the principal curvatures of the surface of an ellipsoid, and their directions, at the
 * point with a given normal.
 *
 * The relative error of each curvature is below 1e-12 for the numbers as given, up to aspect ratio
 * 10⁶. Above an aspect ratio of about 10 the function computes in double-double arithmetic, with
 * twice the digits, which takes about eight times as long.
 *
 * @param normal [!= 0] out of the ellipsoid, of any length
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] curvatures [1/length; optional] reciprocals of the radii of curvature, > 0, the
 *        smaller one first
 * @param[out] directions [2×3; optional; members direction1, direction2] unit vectors along which
 *        the surface has these curvatures. Their cross product is the unit normal. If both
 *        curvatures are equal, every direction in the tangent plane is possible, and the function
 *        chooses one
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_curvature(double const normal[3], double const q[6], double curvatures[2],
                            double directions[6]);

/** Computes the effective radius of Hertz's theory for two elastic bodies, and the shape of the
 * contact ellipse. From these, the force and the ellipse follow as functions of the depth.
 *
 * For a depth δ the force is (4/3) E* √(radius δ³), a repulsion, and the energy is (8/15) E*
 * √(radius δ⁵). Here 1/E* = (1 - ν1²)/E1 + (1 - ν2²)/E2, with Young's moduli E and Poisson's ratios
 * ν. The contact area is an ellipse with semi-axes √(ellipse[0] δ) and √(ellipse[1] δ). The square
 * of their arithmetic-geometric mean is radius δ. The function evaluates the complete elliptic
 * integrals of the theory.
 *
 * The relative errors are below 256 u, with u = 2⁻⁵³, if the ratio of the curvatures is at most
 * 10¹⁸.
 *
 * @param curvatures [1/length; > 0] principal curvatures k1, k2 of the gap between the undeformed
 *        surfaces: at the coordinates x, y along the principal directions the gap is (k1 x² + k2
 *        y²)/2. For two ellipsoids they are the curvatures of pw85_hertz_contact(), for an
 *        ellipsoid on a plane those of pw85_curvature()
 * @param[out] radius [length; optional] the effective radius, for spheres R1 R2/(R1 + R2)
 * @param[out] ellipse [length; optional] squares of the semi-axes of the contact ellipse, divided
 *        by the depth, along the direction of each curvature
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hertz(double const curvatures[2], double *radius, double ellipse[2]);

/** Computes the geometry of the contact of two grains along a given normal, for laws of contact
 * such as Hertz's.
 *
 * Let n be the unit normal, and α and β the half-widths of the ellipsoids along n. The depth is α +
 * β - n·r12. A negative depth proves that the distance of the ellipsoids is at least its magnitude.
 * If the ellipsoids overlap, the depth is at least the depth of pw85_penetration(), with equality
 * if n is the direction of pw85_penetration(). The usual choice of n is the normal of
 * pw85_contact_geometry(). The depth is then (1/μ - 1) n·r12, a smooth function of positions and
 * orientations for μ > 0. It exceeds the depth of pw85_penetration() by a term of second order in
 * the depth.
 *
 * The error of the depth is below 8 u Σ, with u = 2⁻⁵³ and Σ as for pw85_distance() with this
 * normal. The other bounds hold up to aspect ratio 10⁶ for the normal as given. The relative errors
 * of curvatures, radius and ellipse are below 1e-12. The point is half the sum of r12 and of one
 * vector of each ellipsoid; its error is below 1e-12 times the sum of the lengths of these vectors.
 * The error of the directions is less than 1e-12/(1 - k1/k2) radians, with the curvatures k1 < k2.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param normal [!= 0] out of ellipsoid 1 and into ellipsoid 2, of any length
 * @param[out] depth [length; optional] the depth, in the unit of r12; negative if a slab
 *        perpendicular to the normal separates the ellipsoids
 * @param[out] point [length; optional] the point at which contact forces act, relative to the
 *        centre of ellipsoid 1: the midpoint of the two points of the surfaces with the normals n
 *        and -n
 * @param[out] curvatures [1/length; optional; member relative.curvatures] principal curvatures of
 *        the gap between both surfaces, > 0, the smaller one first, as input for pw85_hertz():
 *        eigenvalues of the sum of the second fundamental forms
 * @param[out] directions [2×3; optional; members relative.direction1, relative.direction2] of these
 *        curvatures and of the contact ellipse
 * @param[out] radius,ellipse [as pw85_hertz(); member hertz.radius, hertz.ellipse]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_hertz_contact(double const r12[3], double const q1[6], double const q2[6],
                                double const normal[3], double *depth, double point[3],
                                double curvatures[2], double directions[6], double *radius,
                                double ellipse[2]);

/** Finds the common normal of two grains by Newton's method, and computes their contact along it.
 *
 * Let α and β be the half-widths of the ellipsoids along the unit vector n. The normal is the n at
 * which the overlap δ(n) = α + β - n·r12 has a local minimum near a given direction. Since δ is
 * stationary there, a force U'(δ) n at the point conserves an energy U(δ). Start from the normal of
 * pw85_contact_geometry(), or from that of the previous time step. The search then takes one or two
 * steps.
 *
 * A minimum exists if the overlap is smaller than the least sum of radii of curvature. The search
 * ends after a step below 2⁻²² radians. At aspect ratios up to 4, the error of the normal is less
 * than 100·2⁻⁴⁴, and so are the errors of the point and the radius in units of the semi-axes. The
 * error of the depth is the square of this number, plus rounding.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param start [!= 0] a direction near the normal, out of ellipsoid 1 and into ellipsoid 2, of any
 *        length
 * @param[out] normal [optional] unit vector n
 * @param[out] depth [length; optional] δ, in the unit of r12; negative if a slab perpendicular to
 *        the normal separates the ellipsoids
 * @param[out] point [length; optional] the midpoint of the two points of the surfaces with the
 *        normals n and -n, which are δ n apart, relative to the centre of ellipsoid 1
 * @param[out] curvatures,radius [as pw85_hertz_contact(); member curvatures, radius]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the search finds no
 *        minimum) */
PW85_API int pw85_grain_contact(double const r12[3], double const q1[6], double const q2[6],
                                double const start[3], double normal[3], double *depth,
                                double point[3], double curvatures[2], double *radius);

/** Computes the derivatives of the radius of pw85_grain_contact(). They include the change of the
 * normal with the motion. A force that depends on the radius needs these derivatives to conserve
 * the energy.
 *
 * @param r12,q1,q2 [as pw85_contact()]
 * @param normal [!= 0] that of pw85_grain_contact(), of any length
 * @param[out] d_r12 [optional; member r12] derivative with respect to r12
 * @param[out] d_rot1,d_rot2 [length; optional; member rotation1, rotation2] derivatives with
 *        respect to rotations, as for pw85_contact_torque()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ECONVERGENCE (the overlap has no minimum
 *        there) */
PW85_API int pw85_grain_radius_gradient(double const r12[3], double const q1[6], double const q2[6],
                                        double const normal[3], double d_r12[3], double d_rot1[3],
                                        double d_rot2[3]);

/** Computes the contact of a grain with its centre at 0 and a wall. The wall is tangent to the
 * plane normal·x = offset and is curved along at most one direction: it is a plane, or a cylinder
 * from inside or outside.
 *
 * The relative errors of both curvatures and of the radius are below 1e-12 for the numbers as
 * given, up to aspect ratio 10⁶, also where the curvatures nearly cancel. The function computes in
 * double-double arithmetic, with twice the digits, in two cases: the aspect ratio is above about
 * 10; or the wall is concave (curvature < 0), and the product of both curvatures of the gap is less
 * than half of the product of the curvatures of the ellipsoid.
 *
 * @param normal,offset [as pw85_distance_plane()]
 * @param direction [!= 0] perpendicular to the normal, of any length, along which the wall is
 *        curved
 * @param curvature [1/length] of the wall along `direction`: positive if the wall is convex, 0 for
 *        a plane
 * @param q [as pw85_distance_plane()]
 * @param[out] depth [length; optional] minus the distance of pw85_distance_plane()
 * @param[out] point [length; optional] the point of the ellipsoid that is deepest in the wall
 * @param[out] curvatures [1/length; optional] of the gap, the smaller one first. If the smaller one
 *        is below 2⁻²⁰ times the larger one, it is set to this value, because surfaces that touch
 *        along a line have no finite radius
 * @param[out] radius [as pw85_hertz()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_grain_contact_wall(double const normal[3], double offset,
                                     double const direction[3], double curvature, double const q[6],
                                     double *depth, double point[3], double curvatures[2],
                                     double *radius);

/** @}
 * @name Surface and inertia of bodies
 *
 * A solid body has the same mass per volume everywhere, and a shell has the same mass per area
 * everywhere; in the plane it is a wire with the same mass per length everywhere. Second moments
 * are means of x xᵀ, that is, moments of a body of mass 1.
 *
 * Surface areas and moments of shells are elliptic integrals, which the library computes with twice
 * the digits of double. Let κ be the square of the ratio of the longest to the shortest semi-axis,
 * or 1 if the axes are along the coordinates. The relative error of an area is below u + 2⁻⁹⁸ κ,
 * with u = 2⁻⁵³. The error of an entry of the moments of a shell is below u times this entry plus
 * 2⁻⁹⁸ κ times the largest entry. The chapter on bodies derives the formulas.
 * @{ */

/** Computes the surface area of an ellipsoid, 4π abc R_G(1/a², 1/b², 1/c²), with Carlson's integral
 * R_G.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] area [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_surface_area(double const q[6], double *area);

/** Computes the mean of x xᵀ over a uniform solid ellipsoid, about its centre: q/5. The error of
 * each entry is below u times the entry, with u = 2⁻⁵³.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_second_moments(double const q[6], double moments[6]);

/** Computes the form of the uniform solid ellipsoid with given second moments: 5 times the moments,
 * the inverse of pw85_second_moments().
 *
 * For a body of another shape, the result is the ellipsoid with the second moments of the body. Its
 * volume differs from that of the body. The error of each entry is below u times the entry, with u
 * = 2⁻⁵³.
 *
 * @param second_moments [length²; definite] mean of x xᵀ over a body, about its centre
 * @param[out] q [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_from_moments(double const second_moments[6], double q[6]);

/** Computes the mean of x xᵀ over the surface of an ellipsoid, about its centre: the second moments
 * of a shell.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_shell_moments(double const q[6], double moments[6]);

/** Computes the inertia tensor of a solid body or of a shell of unit density, about its centre.
 *
 * The tensor is m (tr(M) I - M), with the second moments M, and the mass m: the volume of the body,
 * or the area of the shell. For another density, multiply the tensor by the mass per volume or per
 * area. For a body of mass 1, divide it by pw85_volume() or pw85_surface_area().
 *
 * The error of each entry is below 4 u + 2⁻⁹⁸ κ times the entry for bodies, with u = 2⁻⁵³. Here κ
 * is the squared aspect ratio, or 1 if the axes are along the coordinates. For shells it is below 4
 * u times the entry plus 2⁻⁹⁸ κ times the largest entry.
 *
 * @param q [length²; definite] form of the ellipsoid
 * @param shell 0 for a solid body, any other number for a shell
 * @param[out] inertia [mixed units] length⁵ for a body, length⁴ for a shell
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_inertia(double const q[6], int shell, double inertia[6]);

/** Computes the perimeter of an ellipse, 8 R_G(0, a², b²), with Carlson's integral R_G.
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] perimeter [length]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_perimeter_2d(double const q[3], double *perimeter);

/** Computes the mean of x xᵀ over a uniform ellipse, about its centre: q/4. For mass 1, its trace
 * is the moment of inertia about the axis perpendicular to the plane.
 *
 * @param q [length²; definite] form of the ellipse
 * @param[out] moments [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_second_moments_2d(double const q[3], double moments[3]);

/** Computes the form of the uniform ellipse with given second moments: 4 times the moments; see
 * pw85_from_moments().
 *
 * @param second_moments [length²; definite]
 * @param[out] q [length²]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_from_moments_2d(double const second_moments[3], double q[3]);

/** Computes the mean of x xᵀ over the perimeter of an ellipse, about its centre: the second moments
 * of a wire.
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
