// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Triangle meshes as walls, from files in STL format.
#ifndef PW85_LAMMPS_WALL_MESH_HPP_INCLUDED
#define PW85_LAMMPS_WALL_MESH_HPP_INCLUDED

#include "wall_surface.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pw85_lammps {

/// A surface of triangles, with grains on either side.
///
/// Let φ(x) = x·Q⁻¹x for points x relative to the centre of a grain; φ < 1 in the grain. The
/// contacts are the local minima of φ on the surface, with φ < 1 or where the surfaces are closer
/// than a gap. On a face, the normal of the contact is that of the face; on an edge or in a corner
/// it is the normal of the scaled ellipsoid that touches there, which is continuous where a contact
/// moves from a face to its edge. Of two contacts on triangles with a common corner whose normals
/// are nearly parallel, only the deeper one counts: they are one contact with a curved surface that
/// the triangles approximate.
class WallMesh final : public WallSurface {
  public:
    using Triangle = std::array<int, 3>;

    WallMesh(std::vector<Vector> vertices, std::vector<Triangle> triangles);

    /// Returns the surface of a box.
    static std::unique_ptr<WallMesh> box(Vector const &lower, Vector const &upper);

    /// Reads `FILE [scale S] [shift X Y Z] [open]`.
    static std::unique_ptr<WallMesh> parse(Words &words);

    std::string touch(Grain const &grain, double gap,
                      std::vector<GrainGeometry> &contacts) const override;
    bool contains(Vector const &point) const override;
    /// A long move could pass through a surface of triangles without cutting it.
    bool has_cuts() const override { return false; }
    bool slides_along(int) const override { return false; }
    bool crosses(int) const override { return false; }
    int num_triangles() const override { return static_cast<int>(triangles_.size()); }
    std::array<Vector, 3> corners(int triangle) const override;

  private:
    /// The least φ on a triangle that a grain overlaps, or nearly touches.
    struct Minimum {
        double mu2;
        Vector point;
        int triangle;
        /// the corners of the face, the edge or the corner where the point is
        std::array<bool, 3> uses;
    };

    /// Cells of equal size, in a box around all triangles. Each has the triangles whose bounding
    /// boxes meet it.
    class Grid {
      public:
        void build(std::vector<std::array<Vector, 2>> const &boxes);

        /// Returns the triangles of the cells that a box meets; none twice.
        std::vector<int> find(std::array<Vector, 2> const &box) const;

      private:
        template <class Use> void for_each_cell(std::array<Vector, 2> const &box, Use use) const;

        Vector lower_{}, upper_{}, size_{};
        std::array<int, 3> counts_{};
        std::vector<std::vector<int>> cells_;
    };

    std::vector<Minimum> minima(Grain const &grain, double gap) const;
    Minimum minimum(int triangle, Grain const &grain) const;
    Vector normal(Minimum const &m, Grain const &grain) const;
    bool has_feature(int triangle, Minimum const &m) const;
    bool are_neighbours(int t, int u) const;

    std::vector<Vector> vertices_;
    std::vector<Triangle> triangles_;
    Grid grid_;
    /// the corners of a solid box; both sides of other meshes are free
    std::optional<std::array<Vector, 2>> solid_;
};

} // namespace pw85_lammps

#endif
