// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh of triangles with a tree of their boxes. mesh.cpp makes it, and search.hpp and
/// winding.hpp search it.
#ifndef PW85_MESHES_MESH_HPP_INCLUDED
#define PW85_MESHES_MESH_HPP_INCLUDED

#include <pw85_systems.h>

#include <pw85/algebra/symmetric.hpp>

#include "../base/array.hpp"
#include "../neighbors/tree.hpp"

namespace pw85::detail::meshes {

struct Triangle {
    Vector<double, 3> vertices[3];
    std::int32_t index; ///< its number in the caller's array
};

} // namespace pw85::detail::meshes

/// The triangles are in the order of the tree, along a space-filling curve. A mesh without
/// triangles has no tree.
struct pw85_mesh {
    pw85::detail::Array<pw85::detail::meshes::Triangle> triangles;
    pw85::detail::neighbors::Tree tree;
    bool is_closed; ///< winding.hpp
};

#endif
