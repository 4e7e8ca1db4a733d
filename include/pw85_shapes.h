/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_shapes.h
 * @brief One ellipsoid and a wall, a point, a line or another convex shape. A part of pw85.h, which
 * includes it and has the conventions.
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
 * These functions are for one ellipsoid. The distance is the largest or smallest value of n·x - α
 * or n·x + α over unit vectors n, as each function states. Here x is a point of the other body,
 * relative to the centre, and α is the half-width of the ellipsoid along n. The error is below 8 u
 * Σ, where Σ is the sum of the magnitudes of the terms of n·x and of other lengths in the distance,
 * and of Σ|n_i q_ij n_j|/(2α), where n is the unit normal of the exact answer.
 *
 * The derivatives of a distance with respect to the position of the centre and to small rotations
 * about it follow from the point and the normal: see pw85_distance_plane_derivatives().
 * @{ */

/** Distance from an ellipsoid with its centre at 0 to the half-space normal·x >= offset: (offset -
 * α)/|normal|.
 *
 * @param normal [!= 0] into the half-space, of any length
 * @param offset [length] in the unit of normal·x, which scales with `normal`: for a unit normal it
 *        is the distance of the plane from 0; negative if the centre is in the half-space
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] in the unit of the semi-axes; negative if the two
 *        overlap: minus the depth
 * @param[out] point [length; optional] of the ellipsoid, nearest to the half-space or deepest in it
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_distance_plane(double const normal[3], double offset, double const q[6],
                                 double *distance, double point[3]);

/** Derivatives of the distance to a half-space, which do not depend on its offset: -n and n ×
 * point, with n the unit normal.
 *
 * @param normal,q [as pw85_distance_plane()]
 * @param[out] d_center [optional; member center] with respect to the position of the centre
 * @param[out] d_rot [length; optional; member rotation] with respect to small rotation vectors
 *        about the centre, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_distance_plane_derivatives(double const normal[3], double const q[6],
                                             double d_center[3], double d_rot[3]);

/** Contact function of an ellipsoid with its centre at 0 and the half-space normal·x >= offset.
 *
 * @param normal,offset,q [as pw85_distance_plane()]
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if the centre is in the half-space
 * @param[out] point [length; optional] where the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_contact_plane(double const normal[3], double offset, double const q[6],
                                double *mu2, double point[3]);

/** Derivatives of μ² of pw85_contact_plane(): -2μ n/α and 2μ² (n × p)/α, with p the point of the
 * ellipsoid that is nearest to the half-space, n the normal as given and α = n·p; zero if the
 * centre is in the half-space.
 *
 * @param normal,offset,q [as pw85_distance_plane()]
 * @param[out] d_center [1/length; optional; member center] with respect to the position of the
 *        centre
 * @param[out] d_rot [optional; member rotation] with respect to small rotation vectors about the
 *        centre, per radian
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_contact_plane_derivatives(double const normal[3], double offset,
                                            double const q[6], double d_center[3], double d_rot[3]);

/** Distance from an ellipsoid with its centre at 0 to the nearest face of a box around it, a
 * container. The distance to a solid box, an obstacle, is pw85_distance_solid_box().
 *
 * @param lower,upper [length; lower <= upper] corners of the box, relative to the centre of the
 *        ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] negative if the ellipsoid is not inside of the box
 * @param[out] point [length; optional] of the ellipsoid, nearest to that face or farthest beyond it
 * @param[out] normal [optional] outward unit normal of that face
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_distance_box(double const lower[3], double const upper[3], double const q[6],
                               double *distance, double point[3], double normal[3]);

/** Distance from an ellipsoid to the wall of a cylinder of infinite length around it.
 *
 * @param axis [!= 0] direction of the axis, which goes through 0; of any length
 * @param radius [length; > 0] of the cylinder
 * @param center [length] of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] negative if the ellipsoid is not inside of the cylinder
 * @param[out] point [length; optional] of the ellipsoid, farthest from the axis, relative to its
 *        centre
 * @param[out] normal [optional] outward unit normal of the wall there
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero axis or a radius that is not positive),
 *        #PW85_ENOTPD */
PW85_API int pw85_distance_cylinder(double const axis[3], double radius, double const center[3],
                                    double const q[6], double *distance, double point[3],
                                    double normal[3]);

/** Distance from a point to the surface of an ellipsoid.
 *
 * @param r [length] the point, relative to the centre of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] distance [length; optional] negative if the point is inside
 * @param[out] point [length; optional] of the surface, nearest to r, relative to the centre; one of
 *        them if there are several
 * @param[out] normal [optional] unit vector out of the ellipsoid at this point, the derivative of
 *        the distance
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_point(double const r[3], double const q[6], double *distance,
                                 double point[3], double normal[3]);

/** The part t[0] <= t <= t[1] of the line origin + t·direction that is in an ellipsoid. A ray from
 * the origin has t >= 0, the segment from the origin to origin + direction 0 <= t <= 1.
 *
 * Rounding errors decide about lines that are nearly tangent. pw85_overlap_segment() says exactly
 * whether a segment has inner points of the ellipsoid.
 *
 * @param origin [length] of the line, relative to the centre of the ellipsoid
 * @param direction [!= 0] of any length
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] t [length; members enter, leave] NaN if the line misses the ellipsoid, also on
 *        success
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero direction), #PW85_ENOTPD */
PW85_API int pw85_intersect_line(double const origin[3], double const direction[3],
                                 double const q[6], double t[2]);

/** Volume of the part of an ellipsoid that is in the half-space of the points x with normal·x <=
 * offset, relative to the centre of the ellipsoid.
 *
 * @param normal [!= 0] outward normal of the half-space, of any length
 * @param offset [length] in units of the length of `normal` times the unit of length
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] volume [length³] in the third power of the unit of length
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a zero normal), #PW85_ENOTPD */
PW85_API int pw85_overlap_volume_plane(double const normal[3], double offset, double const q[6],
                                       double *volume);

/** @}
 * @name Shapes
 *
 * An ellipsoid with its centre at 0, and a convex set. μ² is the square of the factor by which the
 * ellipsoid must be scaled about its centre to touch the set, and the point is where it then
 * touches: the point x of the set where xᵀQ⁻¹x is least. If the centre is in the set, μ² is 0. The
 * set overlaps the ellipsoid if μ² < 1.
 *
 * The error of μ² is below 80 u S. Here S = Σ|s_i q_ij s_j| + 2 Σ_k w_k Σ|s_i v_ki| over the points
 * v_k of the set of which x = Σ w_k v_k is the mean with weights w_k > 0, and s = Q⁻¹x. Rounding
 * the data entry by entry can change μ² by u S.
 *
 * For another position of the ellipsoid, subtract its centre from the points of the set.
 * @{ */

/** Contact function of an ellipsoid and a segment.
 *
 * @param end1,end2 [length] of the segment, relative to the centre of the ellipsoid; equal ends are
 *        a point
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch
 * @param[out] point [length; optional] of the segment, where the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_segment(double const end1[3], double const end2[3], double const q[6],
                                  double *mu2, double point[3]);

/** Contact function of an ellipsoid and a triangle.
 *
 * @param vertex1,vertex2,vertex3 [length] of the triangle, relative to the centre of the ellipsoid;
 *        a triangle without area is the segment or the point that has all three vertices
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch
 * @param[out] point [length; optional] of the triangle, where the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_triangle(double const vertex1[3], double const vertex2[3],
                                   double const vertex3[3], double const q[6], double *mu2,
                                   double point[3]);

/** Contact function of an ellipsoid and a solid box with sides along the axes.
 *
 * @param lower,upper [length; lower <= upper] corners of the box, relative to the centre of the
 *        ellipsoid; a box may be flat
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the box
 * @param[out] point [length; optional] of the box, where the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_contact_box(double const lower[3], double const upper[3], double const q[6],
                              double *mu2, double point[3]);

/** Contact function of an ellipsoid and a polytope, the intersection of half-spaces: all x with
 * normal·x <= offset for each of n planes.
 *
 * The time is proportional to n. The error of μ² is below 32 u Σ λ_k (|normal_k|·r + |offset_k|),
 * to first order: the sum is over the planes that the scaled ellipsoid touches, s = -Σ λ_k normal_k
 * with λ_k > 0, and r = Σ λ_k |q| |normal_k|. Where this bound exceeds 2⁻¹⁰ μ², as for an ellipsoid
 * of aspect ratio 10⁷ whose flat side faces a plane, integers give μ² and the point, with a
 * relative error of 2 u. They also decide that a polytope is empty, which takes about a
 * millisecond.
 *
 * The point satisfies normal·point - offset <= 32 u (max |normal_i| Σ |point_i| + |offset|) for
 * each plane. A polytope whose planes cannot be satisfied exactly, but up to these bounds, may have
 * such a point instead of being empty.
 *
 * @param n [number of planes] 0 is fine: the polytope is the whole space
 * @param normals [n×3; != 0] out of the polytope, of any lengths
 * @param offsets [n; length] for planes relative to the centre of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the polytope, infinity if the polytope is empty, or if μ² is beyond
 *        the range of double
 * @param[out] point [length; optional] of the polytope, where the scaled ellipsoid touches; NaN if
 *        the polytope is empty
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_polytope(size_t n, double const *normals, double const *offsets,
                                   double const q[6], double *mu2, double point[3]);

/** Tests whether an ellipsoid and a segment overlap, μ² < 1. If they only touch, they do not. The
 * answer is that of exact arithmetic for the numbers given, as that of pw85_overlap().
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_segment(double const end1[3], double const end2[3], double const q[6],
                                  int *overlap);

/** Tests whether an ellipsoid and a triangle overlap, μ² < 1. If they only touch, they do not. The
 * answer is that of exact arithmetic for the numbers given, as that of pw85_overlap().
 *
 * @param vertex1,vertex2,vertex3,q [as pw85_contact_triangle()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_triangle(double const vertex1[3], double const vertex2[3],
                                   double const vertex3[3], double const q[6], int *overlap);

/** Tests whether an ellipsoid and a solid box with sides along the axes overlap, μ² < 1. If they
 * only touch, they do not. The answer is that of exact arithmetic for the numbers given, as that of
 * pw85_overlap().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_overlap_box(double const lower[3], double const upper[3], double const q[6],
                              int *overlap);

/** Tests whether an ellipsoid and a polytope overlap, μ² < 1. If they only touch, they do not; an
 * empty polytope does not overlap. The answer is that of exact arithmetic for the numbers given, as
 * that of pw85_overlap().
 *
 * @param n,normals,offsets,q [as pw85_contact_polytope()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_polytope(size_t n, double const *normals, double const *offsets,
                                   double const q[6], int *overlap);

/** @}
 * @name Distances to shapes
 *
 * The signed distance of an ellipsoid with its centre at 0 and a convex set. If they are apart, it
 * is their distance. If they overlap, it is minus the depth: the length of the shortest translation
 * of the set that separates them. It is the largest value of min n·y - α over unit vectors n, where
 * min n·y is the least value for the points y of the set, and α = √(nᵀqn) is the half-width of the
 * ellipsoid along n. It is positive only if they are apart, and negative only if they overlap, as
 * pw85_overlap_segment() and its relatives decide.
 *
 * The error is below 16 u Σ, with u = 2⁻⁵³ and Σ = R + Σ|n_i q_ij n_j|/(2α). Here R is the distance
 * of the farthest vertex of the set from the centre, and n is the unit normal of the exact answer.
 * The answer can be checked independently. Any unit vector n gives a lower bound min n·y - α of the
 * signed distance; `distance` is this bound for `normal`. If they are apart, |point2 - point1| is
 * an upper bound. Up to aspect ratio 10³ the vector point2 - point1 differs from `distance` times
 * `normal` by less than 2¹⁸ u times the larger one of R and the longest semi-axis, and the points
 * are off the surface and off the set by no more than this.
 *
 * The derivatives follow from the normal n and the points p1 and p2, if the nearest or deepest
 * points are unique:
 *
 * - with respect to the position of the ellipsoid: -n; of the set: n;
 * - with respect to a small rotation vector of the ellipsoid about its centre, per radian: n × p1;
 *   of the set about the centre of the ellipsoid: p2 × n, and about another point c: (p2 - c) × n.
 *
 * So a force f n on the set at p2, and -f n on the ellipsoid at p1, have the torques of an energy
 * that depends on the signed distance.
 *
 * For another position of the ellipsoid, subtract its centre from the points of the set. For
 * another orientation of a box, turn the form and the centre of the ellipsoid into the frame of the
 * box.
 * @{ */

/** Signed distance of an ellipsoid and a segment, and the points where it is reached.
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] distance [length; optional] negative if they overlap: minus the depth
 * @param[out] point1 [length; optional] of the ellipsoid: nearest to the segment, or deepest
 * @param[out] point2 [length; optional] of the segment: nearest to the ellipsoid, or deepest;
 *        relative to the centre of the ellipsoid
 * @param[out] normal [optional] unit vector out of the ellipsoid at point1; point2 - point1 is
 *        `distance` times it
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_segment(double const end1[3], double const end2[3], double const q[6],
                                   double *distance, double point1[3], double point2[3],
                                   double normal[3]);

/** Signed distance of an ellipsoid and a triangle, which is a surface: an overlap is undone by a
 * translation to either side.
 *
 * @param vertex1,vertex2,vertex3,q [as pw85_contact_triangle()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] of the ellipsoid: nearest to the triangle, or deepest
 * @param[out] point2 [length; optional] of the triangle: nearest to the ellipsoid, or deepest;
 *        relative to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_triangle(double const vertex1[3], double const vertex2[3],
                                    double const vertex3[3], double const q[6], double *distance,
                                    double point1[3], double point2[3], double normal[3]);

/** Signed distance of an ellipsoid and a solid box with sides along the axes. For a box around the
 * ellipsoid, a container, see pw85_distance_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] of the ellipsoid: nearest to the box, or deepest
 * @param[out] point2 [length; optional] of the box: nearest to the ellipsoid, or deepest; relative
 *        to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_distance_solid_box(double const lower[3], double const upper[3],
                                     double const q[6], double *distance, double point1[3],
                                     double point2[3], double normal[3]);

/** @}
 * @name Capsules
 *
 * An ellipsoid with its centre at 0, and a capsule or spherocylinder: the points that are at most
 * `radius` away from a segment. μ², the points and the signed distance are defined as for the other
 * shapes.
 *
 * The error of μ² is below 80 u (S + 2 radius |s|). Here S is that of a segment: with s = Q⁻¹x at
 * the point x of contact, v_k the ends, and w_k the weights of the point of the segment that is
 * nearest to x. The signed distance is that of the segment minus the radius. Its error is below
 * 16 u Σ, where R in Σ is the distance of the farthest point of the capsule.
 *
 * A capsule of radius 0 is its segment, and one with equal ends is a ball.
 * @{ */

/** Contact function of an ellipsoid and a capsule.
 *
 * @param end1,end2 [length] of the segment, relative to the centre of the ellipsoid; equal ends are
 *        a ball
 * @param radius [length; >= 0] of the capsule
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch; 0
 *        if its centre is in the capsule
 * @param[out] point [length; optional] of the capsule, where the scaled ellipsoid touches
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a negative radius), #PW85_ENOTPD */
PW85_API int pw85_contact_capsule(double const end1[3], double const end2[3], double radius,
                                  double const q[6], double *mu2, double point[3]);

/** Tests whether an ellipsoid and a capsule overlap, μ² < 1. If they only touch, they do not. The
 * answer is that of exact arithmetic unless 1 - μ² is positive and below 2⁻³⁶⁰ (S + 2 radius |s|):
 * such an overlap counts as touching.
 *
 * @param end1,end2,radius,q [as pw85_contact_capsule()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a negative radius), #PW85_ENOTPD */
PW85_API int pw85_overlap_capsule(double const end1[3], double const end2[3], double radius,
                                  double const q[6], int *overlap);

/** Signed distance of an ellipsoid and a capsule, and the points where it is reached.
 *
 * @param end1,end2,radius,q [as pw85_contact_capsule()]
 * @param[out] distance [as pw85_distance_segment()]
 * @param[out] point1 [length; optional] of the ellipsoid: nearest to the capsule, or deepest
 * @param[out] point2 [length; optional] of the capsule: nearest to the ellipsoid, or deepest;
 *        relative to the centre of the ellipsoid
 * @param[out] normal [as pw85_distance_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for a negative radius), #PW85_ENOTPD */
PW85_API int pw85_distance_capsule(double const end1[3], double const end2[3], double radius,
                                   double const q[6], double *distance, double point1[3],
                                   double point2[3], double normal[3]);

/** @}
 * @name Points and shapes in the plane
 *
 * An ellipse with its centre at 0, and a point, a segment or a box. The errors have the bounds of
 * the functions in three dimensions, and the answers of pw85_overlap_segment_2d() and
 * pw85_overlap_box_2d() are exact as theirs.
 * @{ */

/** Distance from a point to an ellipse, the curve; see pw85_distance_point().
 *
 * @param r,q [as pw85_distance_point()]
 * @param[out] distance,point,normal [as pw85_distance_point()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_distance_point_2d(double const r[2], double const q[3], double *distance,
                                    double point[2], double normal[2]);

/** Contact function of an ellipse and a segment; see pw85_contact_segment().
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] mu2,point [as pw85_contact_segment()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_contact_segment_2d(double const end1[2], double const end2[2], double const q[3],
                                     double *mu2, double point[2]);

/** Contact function of an ellipse and a solid rectangle with sides along the axes; see
 * pw85_contact_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] mu2,point [as pw85_contact_box()]
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_contact_box_2d(double const lower[2], double const upper[2], double const q[3],
                                 double *mu2, double point[2]);

/** Tests whether an ellipse and a segment overlap, μ² < 1; see pw85_overlap_segment().
 *
 * @param end1,end2,q [as pw85_contact_segment()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_overlap_segment_2d(double const end1[2], double const end2[2], double const q[3],
                                     int *overlap);

/** Tests whether an ellipse and a solid rectangle with sides along the axes overlap, μ² < 1; see
 * pw85_overlap_box().
 *
 * @param lower,upper,q [as pw85_contact_box()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return #PW85_SUCCESS, #PW85_EINVAL (also for lower > upper), #PW85_ENOTPD */
PW85_API int pw85_overlap_box_2d(double const lower[2], double const upper[2], double const q[3],
                                 int *overlap);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
