// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The geometry of a contact of two grains, or of a grain and a wall: common normal, depth, points
/// and radius.
#ifndef PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED
#define PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED

#include "lanes.hpp"
#include "vectors.hpp"

#include <cstddef>

namespace pw85_lammps {

/// A contact, seen from the first body.
struct GrainGeometry {
    Vector normal; ///< unit vector, out of the first body and into the second
    /// length of the overlap along the normal; not positive if the bodies are apart
    double depth;
    /// from each centre to the point of that body that is deepest in the other one
    Vector arm1, arm2;
    double radius;     ///< equivalent radius
    int triangle = -1; ///< of a mesh, on which the contact is
    /// of the gap between both surfaces, the smaller one first
    double curvatures[2]{};

    /// Moves both points to the middle between them.
    void meet_in_the_middle()
    {
        Vector const half = 0.5 * depth * normal;
        arm1 = arm1 - half;
        arm2 = arm2 + half;
    }
};

/// The common normals of pairs of ellipsoids that overlap slightly, and the contacts there. It
/// works on many pairs at a time.
///
/// The overlap along a unit vector n is δ(n) = √(n·Q1n) + √(n·Q2n) - n·r12. The normal is the
/// stationary point of δ near a given vector, such as the normal of the contact function. There,
/// the points p1 = Q1n/√(n·Q1n) and r12 - Q2n/√(n·Q2n) are on both surfaces and δ n apart. A
/// translation or rotation of a body changes δ only by its explicit dependence on r12, Q1 and Q2,
/// because δ is stationary in n. So the forces and torques of an energy U(δ) are those of the force
/// U′(δ) n between these points, and the energy is conserved.
class GrainSearch {
  public:
    static constexpr std::size_t capacity = row_capacity;

    GrainSearch();

    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }

    /// Adds a pair. The search starts from the unit vector `normal`. There are less than `capacity`
    /// pairs.
    void add(Vector const &r12, double const *q1, double const *q2, Vector const &normal)
    {
        store(r12, rows_.r12, size_);
        store(normal, rows_.normal, size_);
        for (std::size_t k = 0; k < 6; ++k) {
            rows_.q1[k][size_] = q1[k];
            rows_.q2[k][size_] = q2[k];
        }
        ++size_;
    }

    /// Lets the search of pair k start from another normal.
    void start(std::size_t k, Vector const &normal) { store(normal, rows_.normal, k); }

    /// Computes all contacts. A contact depends on its own pair alone.
    void solve();

    /// Contact k. Its depth is NaN if δ has no minimum there. It has one if the depth is below the
    /// least sum of radii of curvature.
    GrainGeometry contact(std::size_t k) const;

    /// Replaces contact k.
    void replace(std::size_t k, GrainGeometry const &contact);

    /// Numbers of the pairs, each in a row of its own, so that a processor works on several pairs
    /// at a time.
    struct Rows {
        alignas(64) Row<3> r12, normal;
        Row<6> q1, q2;
        /// excess: positive if the radius needs pw85_hertz
        double depth[capacity], radius[capacity], excess[capacity];
        /// curvature: the sum of both second fundamental forms (xx, xy, yy)
        Row<3> arm1, arm2, curvature;
        Row<3> turned; ///< the normal after a step of Newton's method
        /// the square of the step; positive if δ has a minimum
        double step[capacity], least[capacity];
    };

    Rows const &rows() const { return rows_; }

  private:
    bool turn();

    Rows rows_;
    std::size_t size_ = 0;
};

/// The derivatives of the equivalent radius of two ellipsoids, whose common normal follows each
/// motion.
struct RadiusGradient {
    Vector r12;                  ///< by the separation
    Vector rotation1, rotation2; ///< by rotations of each ellipsoid about its own centre
};

/// @param normal the common normal of the two ellipsoids
/// @param depth of their overlap along it
RadiusGradient radius_gradient(double const *q1, double const *q2, Vector const &normal,
                               double depth);

/// The least ratio of curvatures in wall_geometry(). Two surfaces with a common line have no radius
/// of Hertz's theory: a grain can fit to the curvature of a cylinder.
inline constexpr double least_curvature_ratio = 0x1p-20;

/// The geometry of an ellipsoid and a wall, at a point of the wall with a given normal.
///
/// @param normal unit vector out of the ellipsoid, into the wall
/// @param distance of the wall's tangent plane from the centre along the normal
/// @param direction a unit vector in that plane, along which the wall is curved; it is straight
/// across
/// @param curvature of the wall along `direction`; positive if the wall is convex
GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance,
                            Vector const &direction, double curvature);

} // namespace pw85_lammps

#endif
