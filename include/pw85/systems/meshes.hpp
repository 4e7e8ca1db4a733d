// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangle meshes for C++. They call the functions of the compiled library (link with pw85), and
/// their contracts are those of pw85_systems.h.
#ifndef PW85_SYSTEMS_MESHES_HPP_INCLUDED
#define PW85_SYSTEMS_MESHES_HPP_INCLUDED

#include <memory>

#include <pw85/shapes/overlap_shapes.hpp>
#include <pw85/systems/calls.hpp>

namespace pw85 {

/// A triangle mesh and its memory; it can be moved, not copied.
class Mesh {
  public:
    /// An empty mesh: functions return Status::invalid_argument.
    Mesh() noexcept = default;
    /// Takes ownership of a mesh of the C API, which may be null.
    [[gnu::always_inline]] explicit Mesh(pw85_mesh *mesh) noexcept : object_(mesh) {}

    [[gnu::always_inline]] pw85_mesh const *get() const noexcept { return object_.get(); }

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_mesh *object) const noexcept
        {
            pw85_mesh_destroy(object);
        }
    };
    std::unique_ptr<pw85_mesh, Destroy> object_;
};

/// The contact of an ellipsoid and a mesh.
struct MeshContact {
    double mu2;              ///< infinity if the mesh has no triangles
    Vector<double, 3> point; ///< at which the scaled ellipsoid touches, relative to its centre
    std::int32_t triangle;   ///< index of the nearest triangle; -1 if there is none
    StatusCode status;
};

/// Outputs of mesh_contact_batch(): one row for each ellipsoid, or none.
struct MeshContactSpans {
    std::span<double> mu2;
    std::span<Vector<double, 3>> point;
    std::span<std::int32_t> triangle;
};

/// The signed distance of an ellipsoid and a mesh.
struct MeshDistance {
    double distance;          ///< infinity if the mesh has no triangles
    Vector<double, 3> point1; ///< of the ellipsoid, relative to its centre: the nearest or deepest
    Vector<double, 3> point2; ///< of the mesh, relative to the centre of the ellipsoid
    Vector<double, 3> normal; ///< unit vector out of the ellipsoid at point1
    std::int32_t triangle;    ///< index of the nearest triangle; -1 if there is none
    /// 1 for a centre inside a closed mesh, 0 outside; -1 if the mesh is not closed
    std::int32_t inside;
    StatusCode status;
};

/// Outputs of mesh_distance_batch(): one row for each ellipsoid, or none.
struct MeshDistanceSpans {
    std::span<double> distance;
    std::span<Vector<double, 3>> point1, point2, normal;
    std::span<std::int32_t> triangle, inside;
};

// Made by api/committed.py: functions of Triangle meshes
// clang-format off
/// Makes a mesh: see pw85_mesh_create().
///
/// @param vertices one for each vertex
/// @param triangles one for each triangle: indices of vertices, from 0. A triangle without area is
/// a segment or a point.
/// @param[out] mesh empty on error
/// @return Status::success, Status::invalid_argument, Status::out_of_memory
static inline StatusCode mesh_create(Vectors vertices,
                                     std::span<std::array<std::int32_t, 3> const> triangles,
                                     Mesh &mesh) noexcept
{
    mesh = Mesh();
    pw85_mesh *made = nullptr;
    int const status = pw85_mesh_create(vertices.size(), detail::in_c(vertices), triangles.size(),
                                        detail::in_c(triangles), &made);
    mesh = Mesh(made);
    return static_cast<StatusCode>(status);
}

/// Computes the contact function of an ellipsoid and a mesh: see pw85_mesh_contact().
///
/// @param mesh a mesh
/// @param center of the ellipsoid
/// @param q form of the ellipsoid
/// @return the values, and Status::success; Status::invalid_argument, also if the coordinates of a
/// vertex relative to the centre overflow; Status::not_positive_definite
static inline MeshContact mesh_contact(Mesh const &mesh, Vector<double, 3> const &center,
                                       SymmetricMatrix<double, 3> const &q) noexcept
{
    MeshContact found{};
    found.status = static_cast<StatusCode>(pw85_mesh_contact(mesh.get(), center.coordinates,
                                                             q.entries, &found.mu2,
                                                             found.point.coordinates,
                                                             &found.triangle));
    return found;
}

/// Tests whether an ellipsoid and a mesh overlap, μ² < 1 for any triangle: see pw85_mesh_overlap().
///
/// @param mesh a mesh
/// @param center of the ellipsoid
/// @param q form of the ellipsoid
/// @return the values, and as for mesh_contact()
static inline ShapeOverlap mesh_overlap(Mesh const &mesh, Vector<double, 3> const &center,
                                        SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_mesh_overlap(mesh.get(), center.coordinates,
                                                             q.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes the signed distance of an ellipsoid and a mesh: see pw85_mesh_distance().
///
/// @param mesh a mesh
/// @param center of the ellipsoid
/// @param q form of the ellipsoid
/// @return the values, and as for mesh_contact()
static inline MeshDistance mesh_distance(Mesh const &mesh, Vector<double, 3> const &center,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    MeshDistance found{};
    found.status = static_cast<StatusCode>(pw85_mesh_distance(mesh.get(), center.coordinates,
                                                              q.entries, &found.distance,
                                                              found.point1.coordinates,
                                                              found.point2.coordinates,
                                                              found.normal.coordinates,
                                                              &found.triangle, &found.inside));
    return found;
}

/// Computes mesh_contact() for many ellipsoids and one mesh, in parallel, with bitwise equal
/// results: see pw85_mesh_contact_batch().
///
/// @param mesh a mesh
/// @param centers,q one for each ellipsoid
/// @param[out] out rows in all spans, or in some: see pw85_mesh_contact_batch()
/// @return as for contact_batch()
static inline StatusCode mesh_contact_batch(Mesh const &mesh, Vectors centers, Forms q,
                                            MeshContactSpans const &out) noexcept
{
    if (!detail::have_rows(centers.size(), q, out.mu2, out.point, out.triangle))
        return StatusCode::invalid_argument;
    return static_cast<StatusCode>(pw85_mesh_contact_batch(mesh.get(), centers.size(),
                                                           detail::in_c(centers), detail::in_c(q),
                                                           detail::in_c(out.mu2),
                                                           detail::in_c(out.point),
                                                           detail::in_c(out.triangle)));
}

/// Computes mesh_overlap() for many ellipsoids and one mesh, in parallel: see
/// pw85_mesh_overlap_batch().
///
/// @param mesh a mesh
/// @param centers,q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1 or 0; 255 for a bad row
/// @return as for contact_batch()
static inline StatusCode mesh_overlap_batch(Mesh const &mesh, Vectors centers, Forms q,
                                            std::span<unsigned char> overlap) noexcept
{
    if (!detail::have_rows(centers.size(), q, overlap)) return StatusCode::invalid_argument;
    return static_cast<StatusCode>(pw85_mesh_overlap_batch(mesh.get(), centers.size(),
                                                           detail::in_c(centers), detail::in_c(q),
                                                           detail::in_c(overlap)));
}

/// Computes mesh_distance() for many ellipsoids and one mesh, in parallel, with bitwise equal
/// results: see pw85_mesh_distance_batch().
///
/// @param mesh a mesh
/// @param centers,q one for each ellipsoid
/// @param[out] out rows in all spans, or in some: see pw85_mesh_distance_batch()
/// @return as for contact_batch()
static inline StatusCode mesh_distance_batch(Mesh const &mesh, Vectors centers, Forms q,
                                             MeshDistanceSpans const &out) noexcept
{
    if (!detail::have_rows(centers.size(), q, out.distance, out.point1, out.point2, out.normal,
        out.triangle, out.inside)) return StatusCode::invalid_argument;
    return static_cast<StatusCode>(pw85_mesh_distance_batch(mesh.get(), centers.size(),
                                                            detail::in_c(centers), detail::in_c(q),
                                                            detail::in_c(out.distance),
                                                            detail::in_c(out.point1),
                                                            detail::in_c(out.point2),
                                                            detail::in_c(out.normal),
                                                            detail::in_c(out.triangle),
                                                            detail::in_c(out.inside)));
}
// clang-format on

} // namespace pw85

#endif
