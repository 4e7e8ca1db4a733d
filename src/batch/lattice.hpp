/// @file
/// Nearest images in a periodic lattice, however skewed its cell.
///
/// 1. The basis is reduced in the sense of Minkowski: no vector gets shorter by adding or subtracting others. In three
///    dimensions it is enough to try b_i ± b_j (with multiples) and b_i ± b_j ± b_k (P. Q. Nguyen and D. Stehlé, ACM Trans.
///    Algorithms 5, 46, 2009).
/// 2. A separation is moved by the rounded coordinates y in the reduced basis, so that |y_i| <= ½.
/// 3. An image r - v is nearer than r if and only if r·v > ½|v|²; since r·v <= ½ Σ|b_i·v|, only lattice vectors v with
///    Σ|b_i·v| > |v|² can do that. They are few (none, if the cell is rectangular), have small coordinates in a reduced
///    basis, and are listed once.
#ifndef PW85_BATCH_LATTICE_HPP_INCLUDED
#define PW85_BATCH_LATTICE_HPP_INCLUDED

namespace pw85::batch {

/// A periodic lattice, prepared for the search of nearest images: plain data, as kernels.hpp asks for.
struct Lattice {
    double basis[3][3];     ///< reduced basis vectors
    double dual[3][3];      ///< dual[i]·basis[j] = 1 if i = j, else 0
    double shift[62][3];    ///< the lattice vectors of item 3, one of each ± couple
    double half_square[62]; ///< half the squared length of each
    int num_shifts;
};

/// Prepares the lattice of a cell (nine numbers, rows = vectors); false if the cell is singular or not finite.
bool prepare(double const *cell, Lattice &lattice) noexcept;

} // namespace pw85::batch

#endif
