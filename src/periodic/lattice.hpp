// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prepares a periodic lattice for the search of nearest images (nearest_image.hpp), for any skew
/// of the cell. cell.cpp, periodic_cell.cpp and image_finder.hpp call the functions, which are in
/// lattice.cpp.
///
/// A basis is reduced in the sense of Minkowski if no vector becomes shorter by adding or
/// subtracting others. In three dimensions this means that 2|b_i·b_j| <= |b_i|² for all i != j, and
/// that none of b_1 ± b_2 ± b_3 is shorter than the longest of the three. Then |det| >=
/// |b_1||b_2||b_3|/√2, and coordinates in the basis are well-conditioned.
#ifndef PW85_PERIODIC_LATTICE_HPP_INCLUDED
#define PW85_PERIODIC_LATTICE_HPP_INCLUDED

namespace pw85::detail::kernels {

/// A periodic lattice, prepared for the search of nearest images: plain data, as pairs.hpp asks
/// for.
struct Lattice {
    double basis[3][3];    ///< reduced basis vectors
    double dual[3][3];     ///< dual[i]·basis[j] = 1 if i = j, else 0
    double shift[3][9];    ///< coordinates of the vectors v of list_shifts(), one column each
    double half_square[9]; ///< ½|v|² of each
    int num_shifts;        ///< number of these vectors: 0, 2 or 9
};

/// Prepares the lattice of a cell (nine numbers, rows = vectors). It returns false if the cell is
/// singular or not finite. A reduced cell is used without change.
bool prepare(double const *cell, Lattice &lattice) noexcept;

/// Finds a reduced basis of the lattice of a cell (rows = vectors). If `multiples` is not null, it
/// becomes each reduced vector in multiples of the cell's vectors. The function returns false where
/// prepare() does. A vector that is orthogonal to the two others does not change.
bool reduce(double const *cell, double *reduced, double (*multiples)[3] = nullptr) noexcept;

} // namespace pw85::detail::kernels

#endif
