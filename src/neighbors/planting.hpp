/// @file
/// From particles in any order to a tree of boxes in the order of space.
#ifndef PW85_NEIGHBORS_PLANTING_HPP_INCLUDED
#define PW85_NEIGHBORS_PLANTING_HPP_INCLUDED

#include "array.hpp"
#include "periodicity.hpp"
#include "tree.hpp"

namespace pw85::detail::neighbors {

/// A particle's centre, and the half-widths of its box with its share of the skin.
struct Extent {
    Vector<double, 3> center, half_widths;
};

/// The particle at a place of the tree: its number, and the multiples of the cell's vectors that were subtracted.
struct Occupant {
    std::int32_t index;
    Multiples subtracted;
};

/// Puts the boxes of particles, of which there is one at least, near the origin and into a tree. `around` is the box around their
/// centres there. False if there is no memory.
[[nodiscard]] bool plant(Array<Extent> const &extents, Periodicity const &lattice, Box const &around, Tree &tree,
                         Array<Occupant> &occupants) noexcept;

} // namespace pw85::detail::neighbors

#endif
