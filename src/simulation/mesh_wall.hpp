// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hard mesh around or between the particles of a simulation. external_potential.hpp has it
/// beside the walls.
///
/// 1. A particle is free of the mesh if pw85_mesh_overlap() finds no overlap. In a periodic cell
///    the mesh is repeated: all images of the particle that may meet it are tested, each at its
///    rounded centre. The decision depends on nothing but the particle, so a trial that the mesh
///    rejects is in detailed balance. The cell does not change: trials of the volume are refused.
/// 2. No translation is longer than longest_step(), which is less than twice the radius of a ball
///    in the particle. If the segment between two centres met a triangle, the point where it does
///    would be less than this radius from one of them, and the particle would overlap the triangle
///    there. So particles stay on their side of the mesh.
#ifndef PW85_SIMULATION_MESH_WALL_HPP_INCLUDED
#define PW85_SIMULATION_MESH_WALL_HPP_INCLUDED

#include "../base/owner.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

struct DestroyMesh {
    static void destroy(pw85_mesh *mesh) noexcept { pw85_mesh_destroy(mesh); }
};

class MeshWall {
  public:
    Array<double> vertices;        ///< as the caller gave them
    Array<std::int32_t> triangles; ///< three vertices each

    bool exists() const noexcept { return triangles.size() > 0; }

    /// Builds the mesh of the arrays, periodic with a cell. Returns a status: PW85_EINVAL also for
    /// a mesh that is longer than most_cells along a periodic vector.
    int prepare(Cell const &cell) noexcept;

    /// Returns whether a particle is so short, and so near, that all images which may meet the mesh
    /// can be tested.
    bool is_testable(Particle const &particle) const noexcept;

    /// Returns whether a particle meets a triangle, or is not testable.
    bool cuts(Particle const &particle) const noexcept;

    /// Returns the triangle that is nearest to a particle which meets the mesh.
    std::int32_t nearest(Particle const &particle) const noexcept;

    /// A translation up to this length does not lead through a triangle, as long as the coordinates
    /// are below 2²⁸ times the shortest semi-axis. It is 0 if rounding errors of the form are as
    /// large as its least eigenvalue.
    static double longest_step(Vector3 const &semi_axes) noexcept;

  private:
    /// The first with room for a particle as long as four cells beside a mesh as long as 16. A test
    /// takes up to 1 µs.
    static constexpr double most_images = 0x1p14, most_cells = 16.0;

    /// Multiples of the vectors of the cell, from the first to the last, along each of them.
    struct ImageRange {
        std::int32_t first[3], last[3];
    };

    void enclose(Cell const &cell) noexcept;
    Vector3 reach_of(Particle const &particle) const noexcept;
    bool find_images(Particle const &particle, Vector3 const &reach,
                     ImageRange &images) const noexcept;
    template <class Test> bool any_image(Particle const &particle, Test const &test) const noexcept;

    Owner<pw85_mesh, DestroyMesh> mesh_;
    Cell cell_{};
    Vector3 middle_{}, half_widths_{}; ///< of the box around the mesh
    Vector3 dual_[3] = {};             ///< of the periodic vectors of the cell; or else 0
    double dual_bound_[3] = {};        ///< of their entries
};

} // namespace pw85::detail::simulation

#endif
