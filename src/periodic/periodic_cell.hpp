// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prepares the cell of a system, in which any of the vectors may be periodic. The functions of
/// lists (lists/, gpu/gpu.cpp) and the neighbour lists use it.
#ifndef PW85_PERIODIC_PERIODIC_CELL_HPP_INCLUDED
#define PW85_PERIODIC_PERIODIC_CELL_HPP_INCLUDED

#include "lattice.hpp"

namespace pw85::detail::kernels {

/// Copies a cell (nine numbers, rows = vectors), and replaces the vectors that are not periodic by
/// vectors that are orthogonal to the others and as long as the longest of them. The reduction of
/// the lattice does not change these. Returns false if no vector is periodic, or if a periodic one
/// is not finite.
[[nodiscard]] bool complete(double const *cell, int const *periodic,
                            double (&completed)[9]) noexcept;

/// Prepares the lattice of the periodic vectors of a cell. The basis and its dual are zero for the
/// others. Returns false if no vector is periodic, or if the periodic vectors are not finite or not
/// linearly independent.
[[nodiscard]] bool prepare(double const *cell, int const *periodic, Lattice &lattice) noexcept;

/// The images of particles that a function uses. This is plain data, as pairs.hpp requires.
struct Images {
    /// of complete() if `nearest`; otherwise with zeros for the vectors that are not periodic
    double cell[9];
    bool nearest = false; ///< true if the function uses the nearest images
    Lattice lattice;      ///< prepared if `nearest`
};

/// Prepares images: those that the caller gives if `given` is true, otherwise the nearest ones.
/// `cell` is null if nothing is periodic. The function returns false if images are given without a
/// cell. Otherwise the cell must be valid: for given images as for complete(), for nearest images
/// as for the function above.
[[nodiscard]] bool prepare(double const *cell, int const *periodic, bool given,
                           Images &images) noexcept;

} // namespace pw85::detail::kernels

#endif
