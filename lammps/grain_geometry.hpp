// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The geometry of a contact of two grains, or of a grain and a wall: common normal, depth, points and radius.
#ifndef PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED
#define PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED

#include "vectors.hpp"

namespace pw85_lammps {

/// A contact, seen from the first body.
struct GrainGeometry {
    Vector normal;     ///< unit vector, out of the first body and into the second
    double depth;      ///< length of the overlap along the normal; not positive if the bodies are apart
    Vector arm1, arm2; ///< from each centre to the point of that body that is deepest in the other one
    double radius;     ///< equivalent radius

    /// Moves both points to the middle between them.
    void meet_in_the_middle()
    {
        Vector const half = 0.5 * depth * normal;
        arm1 = arm1 - half;
        arm2 = arm2 + half;
    }
};

/// The common normal of two ellipsoids that overlap slightly.
///
/// The overlap along a unit vector n is δ(n) = √(n·Q1n) + √(n·Q2n) - n·r12. The normal is the stationary point of δ near the
/// normal of the contact function. There, the points p1 = Q1n/√(n·Q1n) and r12 - Q2n/√(n·Q2n) are on both surfaces and δ n apart.
/// A translation or rotation of a body changes δ only by its explicit dependence on r12, Q1 and Q2, because δ is stationary in n.
/// So the forces and torques of an energy U(δ) are those of the force U′(δ) n between these points, and the energy is conserved.
///
/// @param normal unit vector from which the search starts
/// @return whether δ has a minimum there. It has one if the depth is below the least sum of radii of curvature.
bool find_geometry(Vector const &r12, double const *q1, double const *q2, Vector const &normal, GrainGeometry &result);

/// The geometry of an ellipsoid and a wall, at a point of the wall with a given normal.
///
/// @param normal unit vector out of the ellipsoid, into the wall
/// @param distance of the wall's tangent plane from the centre along the normal
/// @param direction a unit vector in that plane, along which the wall is curved; it is straight across
/// @param curvature of the wall along `direction`; positive if the wall is convex
GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance, Vector const &direction,
                            double curvature);

} // namespace pw85_lammps

#endif
