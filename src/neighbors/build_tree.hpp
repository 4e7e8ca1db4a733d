// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builds the tree of bounding boxes. It sorts the particles along a space-filling curve
/// (order.hpp) and stores their boxes in this order (tree.hpp). neighbors.cpp calls build_tree()
/// once per list.
#ifndef PW85_NEIGHBORS_BUILD_TREE_HPP_INCLUDED
#define PW85_NEIGHBORS_BUILD_TREE_HPP_INCLUDED

#include "../base/array.hpp"
#include "periodicity.hpp"
#include "tree.hpp"

namespace pw85::detail::neighbors {

/// The centre of a particle and the half-widths of its bounding box, which include half of the
/// skin.
struct BoxExtent {
    Vector<double, 3> center, half_widths;
};

/// The particle whose box is at some place of the tree. The centre of this box is the centre of the
/// particle minus `subtracted`, in multiples of the vectors of the cell.
struct PlacedParticle {
    std::int32_t index;
    Multiples subtracted;
};

/// Moves the boxes of the particles near the origin by lattice vectors and builds their tree.
///
/// @param extents at least one particle
/// @param around the smallest box around the centres, after they are moved near the origin
/// @param[out] placed which particle is at each place of the tree
/// @return false if there is no memory
[[nodiscard]] bool build_tree(Array<BoxExtent> const &extents, Periodicity const &lattice,
                              Box const &around, Tree &tree,
                              Array<PlacedParticle> &placed) noexcept;

} // namespace pw85::detail::neighbors

#endif
