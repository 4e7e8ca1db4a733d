/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_shapes.h
 * @brief One ellipsoid and a wall, a point, a line or another convex shape. pw85.h includes this
 * header and has the conventions.
 */
#ifndef PW85_SHAPES_H_INCLUDED
#define PW85_SHAPES_H_INCLUDED

#include <stddef.h>

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Walls, points and lines
 *
 * These functions are for one ellipsoid. The error of a distance is below 8 u Σ, with u = 2⁻⁵³. Let
 * n be the unit normal at the nearest points. The half-width of the ellipsoid along n is α =
 * √(nᵀqn). Σ is the sum of three terms: Σ|n_i x_i| for the given point, corner or centre x;
 * |offset|/|normal| or the radius; Σ|n_i q_ij n_j|/(2α).
 *
 * The derivatives of a distance with respect to the position of the centre and to small rotations
 * about the centre follow from the point and the normal: see pw85_distance_plane_derivatives().
 * @{ */

/** Computes the distance from an ellipsoid with its centre at 0 to the half-space normal·x >=
 * offset.
 *
 * The distance is (offset - α)/|normal| with α = √(normalᵀ q normal).
 *
 * @param normal [!= 0] into the half-space, of any length
 * @param offset [length] in the unit of normal·x. For a unit normal it is the signed distance from
 *        0 to the plane; for another normal it is |normal| times this distance. It is negative if
 *        the centre is in the half-space.
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] the distance, in the unit of the semi-axes; if the two
 *        overlap, minus the depth
 * @param[out] point [length; optional] the point of the ellipsoid that is nearest to the
 *        half-space, or deepest in it
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_plane(double const normal[3], double offset, double const q[6],
                                 double *distance, double point[3]);

/** Computes the derivatives of the distance to a half-space, which do not depend on its offset.
 *
 * The derivatives are -n and n × point, with the unit normal n and the point of
 * pw85_distance_plane().
 *
 * @param normal,q [as pw85_distance_plane()]
 * @param[out] d_center [optional; member center] derivative with respect to the position of the
 *        centre
 * @param[out] d_rot [length; optional; member rotation] derivative with respect to a small rotation
 *        vector about the centre, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_plane_derivatives(double const normal[3], double const q[6],
                                             double d_center[3], double d_rot[3]);

/** Computes the contact function of an ellipsoid with its centre at 0 and the half-space normal·x
 * >= offset.
 *
 * @param normal,offset,q [as pw85_distance_plane()]
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if the centre is in the half-space
 * @param[out] point [length; optional] the point at which the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_plane(double const normal[3], double offset, double const q[6],
                                double *mu2, double point[3]);

/** Computes the derivatives of μ² of pw85_contact_plane().
 *
 * The derivatives are -2μ n/α and 2μ² (n × p)/α, with the normal n as given, the point p of the
 * ellipsoid that is nearest to the half-space, and α = n·p. They are zero if the centre is in the
 * half-space.
 *
 * @param normal,offset,q [as pw85_distance_plane()]
 * @param[out] d_center [1/length; optional; member center] derivative with respect to the position
 *        of the centre
 * @param[out] d_rot [optional; member rotation] derivative with respect to a small rotation vector
 *        about the centre, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_plane_derivatives(double const normal[3], double offset,
                                            double const q[6], double d_center[3], double d_rot[3]);

/** Computes the distance from an ellipsoid with its centre at 0 to the nearest face of a box that
 * contains it. For a box that is an obstacle, see pw85_distance_solid_box().
 *
 * @param lower,upper [length; lower <= upper] corners of the box, relative to the centre of the
 *        ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] the distance; negative if the ellipsoid is not inside the
 *        box
 * @param[out] point [length; optional] the point of the ellipsoid that is nearest to that face, or
 *        farthest beyond it
 * @param[out] normal [optional] outward unit normal of that face
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_box(double const lower[3], double const upper[3], double const q[6],
                               double *distance, double point[3], double normal[3]);

/** Computes the distance from an ellipsoid to the wall of a cylinder of infinite length that
 * contains it.
 *
 * @param axis [!= 0] direction of the axis of the cylinder, which goes through 0; of any length
 * @param radius [length; > 0] of the cylinder
 * @param center [length] of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] the distance; negative if the ellipsoid is not inside the
 *        cylinder
 * @param[out] point [length; optional] the point of the ellipsoid that is farthest from the axis,
 *        relative to the centre of the ellipsoid
 * @param[out] normal [optional] outward unit normal of the wall there
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_cylinder(double const axis[3], double radius, double const center[3],
                                    double const q[6], double *distance, double point[3],
                                    double normal[3]);

/** Computes the distance from a point to the surface of an ellipsoid.
 *
 * @param r [length] the point, relative to the centre of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] the distance; negative if the point is inside the
 *        ellipsoid
 * @param[out] point [length; optional] the point of the surface that is nearest to r, relative to
 *        the centre; one of them if there are several
 * @param[out] normal [optional] unit vector out of the ellipsoid at this point: the derivative of
 *        the distance with respect to r
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_point(double const r[3], double const q[6], double *distance,
                                 double point[3], double normal[3]);

/** Computes the interval t[0] <= t <= t[1] in which the line origin + t·direction is inside an
 * ellipsoid.
 *
 * For a ray from the origin, intersect this interval with t >= 0; for the segment from origin to
 * origin + direction, with 0 <= t <= 1. If the line is nearly tangent, rounding errors decide
 * whether it misses the ellipsoid. pw85_overlap_segment() decides exactly whether a segment has
 * points inside the ellipsoid.
 *
 * @param origin [length] of the line, relative to the centre of the ellipsoid
 * @param direction [!= 0] of any length
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] t [length; members enter, leave] the interval; its ends are lengths if `direction`
 *        has no unit; NaN if the line misses the ellipsoid, also on success
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_intersect_line(double const origin[3], double const direction[3],
                                 double const q[6], double t[2]);

/** Computes the volume of the part of an ellipsoid that is in the half-space normal·x <= offset,
 * where x is relative to the centre of the ellipsoid.
 *
 * @param normal [!= 0] outward normal of the half-space, of any length
 * @param offset [length] in the unit of normal·x, as for pw85_distance_plane(); negative if the
 *        centre is outside the half-space
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] volume [length³] the volume, in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_volume_plane(double const normal[3], double offset, double const q[6],
                                       double *volume);

/** @}
 * @name Shapes
 *
 * These functions are for an ellipsoid with its centre at 0 and a convex set. For another centre,
 * subtract it from the points of the set. μ² is the square of the factor by which the ellipsoid
 * must be scaled about its centre to touch the set. The contact point is the point x of the set at
 * which xᵀQ⁻¹x is least. If the centre is in the set, μ² is 0. The ellipsoid and the set overlap if
 * μ² < 1. If they only touch, they do not overlap. The overlap tests are exact for the numbers
 * given.
 *
 * The error of μ² is below 80 u S, with u = 2⁻⁵³. Write x as the weighted mean Σ w_k v_k of
 * vertices v_k of the set, with weights w_k > 0, and s = Q⁻¹x. Then S = Σ|s_i q_ij s_j| + 2 Σ_k w_k
 * Σ|s_i v_ki|. Rounding the data entry by entry can change μ² by u S.
 * @{ */

/** Computes the contact function of an ellipsoid and a segment.
 *
 * @param end1,end2 [length] of the segment, relative to the centre of the ellipsoid; they may be
 *        equal: the segment is then a point
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch
 * @param[out] point [length; optional] the point of the segment at which the scaled ellipsoid
 *        touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_segment(double const end1[3], double const end2[3], double const q[6],
                                  double *mu2, double point[3]);

/** Computes the contact function of an ellipsoid and a triangle.
 *
 * @param vertex1,vertex2,vertex3 [length] of the triangle, relative to the centre of the ellipsoid;
 *        a triangle without area is a segment or a point
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch
 * @param[out] point [length; optional] the point of the triangle at which the scaled ellipsoid
 *        touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_triangle(double const vertex1[3], double const vertex2[3],
                                   double const vertex3[3], double const q[6], double *mu2,
                                   double point[3]);

/** Computes the contact function of an ellipsoid and a solid box with sides along the axes.
 *
 * @param lower,upper [length; lower <= upper] corners of the box, relative to the centre of the
 *        ellipsoid; a box may be flat
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the box
 * @param[out] point [length; optional] the point of the box at which the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_box(double const lower[3], double const upper[3], double const q[6],
                              double *mu2, double point[3]);

/** Computes the contact function of an ellipsoid and a polytope. The polytope is the intersection
 * of n half-spaces: all x with normal·x <= offset for each plane.
 *
 * The error of μ² is below 32 u Σ λ_k (|normal_k|·r + |offset_k|), to first order, with u = 2⁻⁵³.
 * The sum is over the planes that the scaled ellipsoid touches. The λ_k > 0 are the multipliers in
 * s = -Σ λ_k normal_k, with s = q⁻¹x at the point x, and r = Σ λ_k |q| |normal_k|. If this bound
 * exceeds 2⁻¹⁰ μ², integer arithmetic computes μ² and the point, with a relative error of 2 u. This
 * happens, for example, if the flat side of an ellipsoid of aspect ratio 10⁷ faces a plane.
 *
 * Integer arithmetic also decides whether a polytope is empty. This decision takes about a
 * millisecond. The point satisfies normal·point - offset <= 32 u (max |normal_i| Σ |point_i| +
 * |offset|) for each plane. There is one exception to exact decisions: no point satisfies all
 * inequalities exactly, but some points satisfy them up to these bounds. The function may then
 * return such a point instead of the result for an empty polytope.
 *
 * The time is proportional to n.
 *
 * @param n [number of planes] 0 is allowed: the polytope is then the whole space
 * @param normals [n×3; != 0] out of the polytope, of any lengths
 * @param offsets [n; length] of the planes, relative to the centre of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the polytope, infinity if the polytope is empty, or if μ² is beyond
 *        the range of double
 * @param[out] point [length; optional] the point of the polytope at which the scaled ellipsoid
 *        touches; NaN if the polytope is empty
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_polytope(size_t n, double const *normals, double const *offsets,
                                   double const q[6], double *mu2, double point[3]);

/** Tests whether an ellipsoid and a segment overlap, μ² < 1. If they only touch, they do not
 * overlap. The answer is exact for the numbers given.
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_segment(double const end1[3], double const end2[3], double const q[6],
                                  int *overlap);

/** Tests whether an ellipsoid and a triangle overlap, μ² < 1. If they only touch, they do not
 * overlap. The answer is exact for the numbers given.
 *
 * @param vertex1,vertex2,vertex3,q [as pw85_contact_triangle()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_triangle(double const vertex1[3], double const vertex2[3],
                                   double const vertex3[3], double const q[6], int *overlap);

/** Tests whether an ellipsoid and a solid box with sides along the axes overlap, μ² < 1. If they
 * only touch, they do not overlap. The answer is exact for the numbers given.
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_box(double const lower[3], double const upper[3], double const q[6],
                              int *overlap);

/** Tests whether an ellipsoid and a polytope overlap, μ² < 1. If they only touch, they do not
 * overlap. An empty polytope does not overlap. The answer is exact for the numbers given.
 *
 * @param n,normals,offsets,q [as pw85_contact_polytope()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets,
                                   double const q[6], int *overlap);

/** @}
 * @name Distances to shapes
 *
 * These functions compute the signed distance of an ellipsoid with its centre at 0 and a convex
 * set. If the two are apart, the signed distance is their distance. If they overlap, it is minus
 * the depth, which is the length of the shortest translation of the set that separates them. In
 * both cases it is the largest value of min n·y - α over unit vectors n. Here min n·y is the least
 * value for points y of the set, and α = √(nᵀqn) is the half-width of the ellipsoid along n. The
 * signed distance is positive only if the two are apart, and negative only if they overlap, as
 * pw85_overlap_segment() and the other overlap tests decide.
 *
 * The error is below 16 u Σ, with u = 2⁻⁵³ and Σ = R + Σ|n_i q_ij n_j|/(2α). Here R is the distance
 * of the farthest vertex of the set from the centre, and n is the normal of the exact result.
 *
 * A program can check the result by two bounds. For any unit vector n, min n·y - α is a lower bound
 * of the signed distance; `distance` is this bound for `normal`. If the two are apart, |point2 -
 * point1| is an upper bound. Let ε be 2¹⁸ u times R or the longest semi-axis, whichever is larger.
 * Up to aspect ratio 10³ the vector point2 - point1 differs from `distance` times `normal` by less
 * than ε. The distances of point1 from the surface and of point2 from the set are then at most ε.
 *
 * If the nearest or deepest points p1 and p2 are unique, the derivatives follow from them and the
 * normal n:
 *
 * - with respect to the position of the ellipsoid: -n; of the set: n;
 * - with respect to a small rotation vector of the ellipsoid about its centre, per radian: n × p1;
 * - with respect to a small rotation vector of the set about the centre of the ellipsoid, per
 *   radian: p2 × n; about another point c: (p2 - c) × n.
 *
 * Let an energy U depend on the signed distance d. Its force is -U'(d) n on the set, applied at p2,
 * and U'(d) n on the ellipsoid, applied at p1. These forces at these points also give the torques
 * of U.
 *
 * For another centre of the ellipsoid, subtract it from the points of the set. For another
 * orientation of a box, rotate the ellipsoid into the frame of the box.
 * @{ */

/** Computes the signed distance of an ellipsoid and a segment, and the points where it is reached.
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] distance [length; optional] the signed distance; if the two overlap, it is minus the
 *        depth
 * @param[out] point1 [length; optional] the point of the ellipsoid that is nearest to the segment,
 *        or deepest
 * @param[out] point2 [length; optional] the point of the segment that is nearest to the ellipsoid,
 *        or deepest; relative to the centre of the ellipsoid
 * @param[out] normal [optional] outward unit normal of the ellipsoid at point1; point2 - point1 is
 *        `distance` times this vector
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_segment(double const end1[3], double const end2[3], double const q[6],
                                   double *distance, double point1[3], double point2[3],
                                   double normal[3]);

/** Computes the signed distance of an ellipsoid and a triangle, and the points where it is reached.
 * The triangle is a surface: the shortest translation that separates the two may be to either side.
 *
 * @param vertex1,vertex2,vertex3,q [as pw85_contact_triangle()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] the point of the ellipsoid that is nearest to the triangle,
 *        or deepest
 * @param[out] point2 [length; optional] the point of the triangle that is nearest to the ellipsoid,
 *        or deepest; relative to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_triangle(double const vertex1[3], double const vertex2[3],
                                    double const vertex3[3], double const q[6], double *distance,
                                    double point1[3], double point2[3], double normal[3]);

/** Computes the signed distance of an ellipsoid and a solid box with sides along the axes, and the
 * points where it is reached. For a box that contains the ellipsoid, see pw85_distance_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] the point of the ellipsoid that is nearest to the box, or
 *        deepest
 * @param[out] point2 [length; optional] the point of the box that is nearest to the ellipsoid, or
 *        deepest; relative to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_solid_box(double const lower[3], double const upper[3],
                                     double const q[6], double *distance, double point1[3],
                                     double point2[3], double normal[3]);

/** @}
 * @name Capsules
 *
 * A capsule, or spherocylinder, is the set of the points that are at most `radius` away from a
 * segment. The ellipsoid has its centre at 0. μ², the points and the signed distance are defined as
 * for the other shapes. A capsule of radius 0 is a segment, and a capsule with equal ends is a
 * ball.
 *
 * The error of μ² is below 80 u (S + 2 radius |s|), with u = 2⁻⁵³ and s = Q⁻¹x at the point x of
 * contact. S is defined as for the segment of the capsule: the v_k are its ends, and the w_k are
 * the weights of its point nearest to x.
 *
 * The signed distance of a capsule is the signed distance of its segment minus the radius. The
 * error is below 16 u Σ, where R in Σ is the distance of the farthest point of the capsule from the
 * centre.
 * @{ */

/** Computes the contact function of an ellipsoid and a capsule.
 *
 * @param end1,end2 [length] of the segment, relative to the centre of the ellipsoid; they may be
 *        equal: the capsule is then a ball
 * @param radius [length; >= 0] of the capsule
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the capsule
 * @param[out] point [length; optional] the point of the capsule at which the scaled ellipsoid
 *        touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_capsule(double const end1[3], double const end2[3], double radius,
                                  double const q[6], double *mu2, double point[3]);

/** Tests whether an ellipsoid and a capsule overlap, μ² < 1. If they only touch, they do not
 * overlap.
 *
 * The answer is exact for the numbers given, with one exception: if 1 - μ² is positive and below
 * 2⁻³⁶⁰ (S + 2 radius |s|), the two count as touching.
 *
 * @param end1,end2,radius,q [as pw85_contact_capsule()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_capsule(double const end1[3], double const end2[3], double radius,
                                  double const q[6], int *overlap);

/** Computes the signed distance of an ellipsoid and a capsule, and the points where it is reached.
 *
 * @param end1,end2,radius,q [as pw85_contact_capsule()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] the point of the ellipsoid that is nearest to the capsule,
 *        or deepest
 * @param[out] point2 [length; optional] the point of the capsule that is nearest to the ellipsoid,
 *        or deepest; relative to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_capsule(double const end1[3], double const end2[3], double radius,
                                   double const q[6], double *distance, double point1[3],
                                   double point2[3], double normal[3]);

/** @}
 * @name Points and shapes in the plane
 *
 * These functions are for an ellipse with its centre at 0, and a point, a segment or a rectangle.
 * The bounds on errors are those of the functions in three dimensions. The answers of
 * pw85_overlap_segment_2d() and pw85_overlap_box_2d() are exact for the numbers given.
 * @{ */

/** Computes the distance from a point to the perimeter of an ellipse; see pw85_distance_point().
 *
 * @param r,q [as pw85_distance_point()]
 * @param[out] distance,point,normal [as pw85_distance_point()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_point_2d(double const r[2], double const q[3], double *distance,
                                    double point[2], double normal[2]);

/** Computes the contact function of an ellipse and a segment; see pw85_contact_segment().
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] mu2,point [as pw85_contact_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_segment_2d(double const end1[2], double const end2[2], double const q[3],
                                     double *mu2, double point[2]);

/** Computes the contact function of an ellipse and a solid rectangle with sides along the axes; see
 * pw85_contact_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] mu2,point [as pw85_contact_box()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_box_2d(double const lower[2], double const upper[2], double const q[3],
                                 double *mu2, double point[2]);

/** Tests whether an ellipse and a segment overlap; see pw85_overlap_segment().
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_segment_2d(double const end1[2], double const end2[2], double const q[3],
                                     int *overlap);

/** Tests whether an ellipse and a solid rectangle with sides along the axes overlap; see
 * pw85_overlap_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_box_2d(double const lower[2], double const upper[2], double const q[3],
                                 int *overlap);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
