// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The geometry of a contact of two grains, or of a grain and a wall: common normal, depth, points
/// and radius. The library computes it (pw85_grains.h); here are the rows of pairs.
#ifndef PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED
#define PW85_LAMMPS_GRAIN_GEOMETRY_HPP_INCLUDED

#include "lanes.hpp"
#include "vectors.hpp"

#include <pw85.h>

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
    using Form = std::array<double, PW85_SYM>;

    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }

    /// Adds a pair. The search starts from `normal`. There are less than `capacity` pairs.
    void add(Vector const &r12, Form const &q1, Form const &q2, Vector const &normal)
    {
        pairs_.r12[size_] = r12;
        store(r12, rows_.r12, size_);
        pairs_.start[size_] = normal;
        pairs_.q1[size_] = q1;
        pairs_.q2[size_] = q2;
        ++size_;
    }

    /// The normal from which the search of pair k starts.
    Vector const &start(std::size_t k) const { return pairs_.start[k]; }
    void set_start(std::size_t k, Vector const &normal) { pairs_.start[k] = normal; }

    /// Computes all contacts. A contact depends on its own pair alone. Its depth is NaN where the
    /// library finds no minimum of the overlap.
    void solve() { solve(0, size_); }

    Vector const &separation(std::size_t k) const { return pairs_.r12[k]; }
    GrainGeometry contact(std::size_t k) const;

    /// Computes the contact of pair k again, after set_start().
    void search_again(std::size_t k) { solve(k, 1); }

    /// The contacts, with the coordinates in rows of their own, for SIMD over several pairs.
    struct Rows {
        alignas(64) Row<3> normal;
        Row<3> point; ///< the middle of both deepest points, relative to the first centre
        Row<3> r12;
        double depth[capacity], radius[capacity];
        std::array<double, 2> curvatures[capacity];

        /// Returns the points of both bodies that are deepest in the other one, relative to their
        /// own centres.
        std::array<Vector, 2> arms(std::size_t k) const
        {
            Vector const middle = load(point, k), half = 0.5 * depth[k] * load(normal, k);
            return {middle + half, middle - half - load(r12, k)};
        }
    };

    Rows const &rows() const { return rows_; }

  private:
    /// Pairs, and vectors of results, as the library reads and writes them.
    struct Pairs {
        std::array<Vector, capacity> r12, start;
        std::array<Form, capacity> q1, q2;
    };
    struct Results {
        std::array<Vector, capacity> normal, point;
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
