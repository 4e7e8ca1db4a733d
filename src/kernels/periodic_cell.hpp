/// @file
/// The cell of a system, of which some vectors are periodic: what functions of lists make of it.
#ifndef PW85_KERNELS_PERIODIC_CELL_HPP_INCLUDED
#define PW85_KERNELS_PERIODIC_CELL_HPP_INCLUDED

#include "lattice.hpp"

namespace pw85::detail::kernels {

/// A cell (nine numbers, rows = vectors) with vectors in the place of those that are not periodic: orthogonal to the others, and as
/// long as the longest of them. So the reduction leaves them alone. False if no vector is periodic, or one that is is not finite.
[[nodiscard]] bool complete(double const *cell, int const *periodic, double (&completed)[9]) noexcept;

/// Prepares the lattice of the periodic vectors of a cell; the basis and its dual are zero for the others. False if no vector is periodic,
/// or those that are are not finite or not independent.
[[nodiscard]] bool prepare(double const *cell, int const *periodic, Lattice &lattice) noexcept;

/// Which images of particles a function looks at: plain data, as kernels.hpp asks for.
struct Images {
    double cell[9]; ///< zero for vectors that are not periodic; completed if the nearest images are asked for
    bool nearest;   ///< whether they are, and the lattice is prepared
    Lattice lattice;
};

/// Prepares images, those that are given or the nearest ones; `cell` is null where nothing is periodic. False if there are given images
/// without a cell, or the cell is bad: as for prepare() where nearest images are asked for, as for complete() elsewhere.
[[nodiscard]] bool prepare(double const *cell, int const *periodic, bool given, Images &images) noexcept;

} // namespace pw85::detail::kernels

#endif
