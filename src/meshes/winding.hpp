// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether a mesh is closed, and whether a point is inside of a closed mesh. mesh.cpp calls
/// is_closed(), and mesh_distance.cpp calls is_inside().
///
/// A mesh is closed if each edge from a to b of a triangle is cancelled by one from b to a of
/// another triangle. Vertices with equal coordinates are the same one. The number of times that a
/// closed mesh winds around a point is the sum of the orientations of the triangles that a ray from
/// the point crosses. The point is inside if the number is not 0. So the triangles of a solid must
/// have the same orientation, all outward or all inward.
#ifndef PW85_MESHES_WINDING_HPP_INCLUDED
#define PW85_MESHES_WINDING_HPP_INCLUDED

#include <cstdint>

#include "mesh.hpp"

namespace pw85::detail::meshes {

bool is_closed(Array<Triangle> const &triangles) noexcept;

/// 1 for a point inside of a closed mesh and 0 outside; -1 if the mesh is not closed. The
/// coordinates of the vertices relative to the point must be finite.
int is_inside(pw85_mesh const &mesh, Vector<double, 3> const &point) noexcept;

} // namespace pw85::detail::meshes

#endif
