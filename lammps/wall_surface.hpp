// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The surfaces of walls: half-spaces, cylinders, triangle meshes. They find where a grain touches
/// them.
#ifndef PW85_LAMMPS_WALL_SURFACE_HPP_INCLUDED
#define PW85_LAMMPS_WALL_SURFACE_HPP_INCLUDED

#include "grain_geometry.hpp"
#include "words.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pw85_lammps {

/// A grain in the coordinates of a wall.
struct Grain {
    Vector center;
    double form[6];
    double radius; ///< of a sphere around it
};

/// A surface of a wall, whose material is infinitely thick. The first body of its contacts is the
/// grain.
class WallSurface {
  public:
    virtual ~WallSurface() = default;

    /// Adds the contacts of a grain, with places where the surfaces are closer than a gap. Returns
    /// nothing, or why there is no answer, as a sentence about the grain.
    virtual std::string touch(Grain const &grain, double gap,
                              std::vector<GrainGeometry> &contacts) const = 0;

    /// Returns an upper bound on the equivalent radius of the contacts of a grain.
    ///
    /// @param radius the largest radius of curvature of the grain
    virtual double largest_radius(double radius) const { return radius; }

    /// Returns whether a point is so deep in the material of the wall that touch() may find no
    /// contact of a small grain there.
    virtual bool contains(Vector const &) const { return false; }

    /// Returns whether a grain cuts the wall. The answer is that of exact arithmetic for the form
    /// of the grain and the differences of coordinates of its centre and the wall. A grain that
    /// touches the wall does not cut it.
    virtual bool cuts(Grain const &) const { return false; }

    /// Returns whether cuts() can answer.
    virtual bool has_cuts() const { return true; }

    /// Returns whether the wall coincides with itself when it slides along an axis of space.
    virtual bool slides_along(int axis) const = 0;

    /// Returns whether the wall bounds the space of the grains along an axis, which then cannot be
    /// periodic.
    virtual bool crosses(int axis) const = 0;

    /// Returns the number of triangles of a mesh; 0 for other walls.
    virtual int num_triangles() const { return 0; }
    virtual std::array<Vector, 3> corners(int) const { return {}; }

    /// Reads the shape of a wall: `xplane LO HI | xcylinder RADIUS ... | box XLO XHI ... | mesh
    /// FILE ...`.
    static std::unique_ptr<WallSurface> parse(Words &words);
};

} // namespace pw85_lammps

#endif
