// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The geometry of a contact of two grains, or of a grain and a wall: common normal, depth, points
/// and radius. The library computes it (pw85_grains.h); here are the rows of pairs.
#ifndef PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED
#define PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED

#include "lanes.hpp"
#include "vectors.hpp"

#include <array>
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
    std::array<double, 2> curvatures{};

    /// Moves both points to the middle between them.
    void meet_in_the_middle()
    {
        Vector const half = 0.5 * depth * normal;
        arm1 = arm1 - half;
        arm2 = arm2 + half;
    }
};

/// The contacts of pairs of ellipsoids that overlap slightly: pw85_grain_contact_batch().
class GrainSearch {
  public:
    static constexpr std::size_t capacity = row_capacity;

    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }

    /// Adds a pair. The search starts from `normal`. There are less than `capacity` pairs.
    void add(Vector const &r12, double const *q1, double const *q2, Vector const &normal);

    /// Sets the normal from which the search of pair k starts.
    void start(std::size_t k, Vector const &normal) { pairs_.start[k] = normal; }

    /// Computes all contacts. A contact depends on its own pair alone. Its depth is NaN where the
    /// library finds no minimum of the overlap.
    void solve();

    Vector const &separation(std::size_t k) const { return pairs_.r12[k]; }
    GrainGeometry contact(std::size_t k) const;

    /// Replaces the contact of pair k by that found from another start.
    void search_again(std::size_t k, Vector const &normal);

    /// The contacts, each number in a row of its own, for SIMD over several pairs.
    struct Rows {
        alignas(64) Row<3> normal;
        Row<3> arm1, arm2;
        double depth[capacity], radius[capacity];
        Row<2> curvatures;
    };

    Rows const &rows() const { return rows_; }

  private:
    using Form = std::array<double, 6>;

    /// Pairs and results as the library reads and writes them.
    struct Pairs {
        std::array<Vector, capacity> r12, start;
        std::array<Form, capacity> q1, q2;
    };
    struct Results {
        std::array<Vector, capacity> normal, point;
        std::array<double, capacity> depth, radius;
        std::array<std::array<double, 2>, capacity> curvatures;
    };

    void solve(std::size_t first, std::size_t count);

    Pairs pairs_{};
    Results results_{};
    Rows rows_{};
    std::size_t size_ = 0;
};

/// Returns the geometry of an ellipsoid and a wall, at a point of the wall with a given normal.
///
/// @param normal unit vector out of the ellipsoid, into the wall
/// @param distance of the wall's tangent plane from the centre along the normal
/// @param direction a unit vector in that plane, along which the wall is curved; it is straight
/// across
/// @param curvature of the wall along `direction`; positive if the wall is convex
GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance,
                            Vector const &direction, double curvature);

/// Computes the geometry of a contact with a wall that is a plane there.
inline GrainGeometry wall_geometry(double const *q, Vector const &normal, double distance)
{
    return wall_geometry(q, normal, distance, normal, 0.0);
}

} // namespace pw85_lammps

#endif
