// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prepares a periodic lattice for the search of nearest images (nearest_image.hpp), for any skew
/// of the cell. cell.cpp, periodic_cell.cpp and image_finder.hpp call the functions, which are in
/// lattice.cpp.
///
/// 1. A basis is reduced in the sense of Minkowski if no vector becomes shorter by adding or
///    subtracting others. In three dimensions this means that 2|b_i·b_j| <= |b_i|² for all i != j,
///    and that none of b_1 ± b_2 ± b_3 is shorter than the longest of the three. Then |det| >=
///    |b_1||b_2||b_3|/√2, so that coordinates in the basis are well-conditioned.
/// 2. Every lattice with a reduced basis has four vectors c_m with Σ c_m = 0 and c_m·c_n <= 0 for m
///    != n. If the signs of the b_i can be chosen so that no b_i·b_j is positive, they are (b_1,
///    b_2, b_3, -b_1-b_2-b_3). Otherwise choose the signs so that all products are positive, and
///    number the vectors so that b_i·b_j is the smallest product. Then the four vectors are (b_i,
///    -b_j, b_k-b_i, b_j-b_k). This follows from the inequalities of item 1.
/// 3. So the squared length of a lattice vector Σ n_m c_m is Σ p_mn (n_m - n_n)² over m < n with
///    p_mn = -c_m·c_n. This means that the lattice is of Voronoi's first kind (J. reine angew.
///    Math. 134, 198, 1908). The faces of its Voronoi cell are half-way to sums of some of the c_m,
///    which have coordinates -1, 0 or 1 in the reduced basis. The cell has a vertex for each order
///    of the c_m. The n_m of a vertex are the potentials of a network with conductances p_mn, whose
///    edges have electromotive forces ½ in the direction of that order. The coordinates of a vertex
///    in the reduced basis are voltages between two nodes of this network. Such a voltage is half
///    the mean length of the paths of a current between the two nodes, so it is at most 3/2. It is
///    less than 3/2, because by item 1 not all of the current goes through both other nodes: p is
///    positive between the two nodes, or else between one of them and the farther of the other two.
/// 4. The nearest integers are subtracted from the coordinates of a separation in the basis, so
///    that its coordinates y are |y_i| <= ½. By item 3 the nearest image is this one, or one whose
///    coordinates differ by -1, 0 or 1. The image r - v is nearer than r if and only if r·v >
///    ½|v|². Since |r·v| <= ½ Σ|b_i·v|, this needs Σ|b_i·v| > |v|². For v = ±b_1 ±b_2 ±b_3 the sum
///    is |v|² by item 1, which leaves nine pairs ±v. If only two of the b_i are not orthogonal, the
///    same holds for their sum and difference, which leaves only these two vectors. If all are
///    orthogonal, no v is left.
#ifndef PW85_PERIODIC_LATTICE_HPP_INCLUDED
#define PW85_PERIODIC_LATTICE_HPP_INCLUDED

namespace pw85::detail::kernels {

/// A periodic lattice, prepared for the search of nearest images: plain data, as kernels.hpp asks
/// for.
struct Lattice {
    double basis[3][3];    ///< reduced basis vectors
    double dual[3][3];     ///< dual[i]·basis[j] = 1 if i = j, else 0
    double shift[3][9];    ///< coordinates of the vectors v of item 4, one column each
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
