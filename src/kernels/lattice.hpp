/// @file
/// Prepares a periodic lattice for the search of nearest images (nearest_image.hpp), however skewed its cell.
///
/// 1. A basis is reduced (in the sense of Minkowski) where no vector gets shorter by adding or subtracting others. In three
///    dimensions this means 2|b_i·b_j| <= |b_i|² for all i != j, and that none of b_1 ± b_2 ± b_3 is shorter than the longest
///    of the three. Then |det| >= |b_1||b_2||b_3|/√2: coordinates in the basis are well-conditioned.
/// 2. Every lattice with a reduced basis has four vectors c_m with Σ c_m = 0 and c_m·c_n <= 0 for m != n: if the signs of the b_i
///    can be chosen so that no b_i·b_j is positive, (b_1, b_2, b_3, -b_1-b_2-b_3); else let all b_i·b_j be positive and the first
///    the smallest, then (b_i, -b_j, b_k-b_i, b_j-b_k). This follows from the inequalities of item 1.
/// 3. So the squared length of a lattice vector Σ n_m c_m is Σ p_mn (n_m - n_n)² over m < n with p_mn = -c_m·c_n: the lattice is of
///    Voronoi's first kind (J. reine angew. Math. 134, 198, 1908). The faces of its Voronoi cell are half-way to sums of some of
///    the c_m, which have coordinates -1, 0 or 1 in the reduced basis. The vertices of the cell, one for each order of the c_m,
///    are the potentials n_m of a network with conductances p_mn whose edges have electromotive forces ½, in the direction of
///    that order; coordinates in the reduced basis are voltages between two nodes: half the mean length of the ways that a
///    current between these nodes takes, at most 3/2; and less, because by item 1 it does not all go through both others: the p
///    between the two nodes, or else from one of them to the farther of the others, is positive.
/// 4. A separation is moved by its rounded coordinates y in the basis, so that |y_i| <= ½. By item 3 the nearest image is this or
///    one that differs by coordinates -1, 0 or 1: r - v is nearer than r if and only if r·v > ½|v|². Since |r·v| <= ½ Σ|b_i·v|,
///    that needs Σ|b_i·v| > |v|². For v = ±b_1 ±b_2 ±b_3 the sum is |v|² by item 1, which leaves nine couples ±v. If only two of
///    the b_i are not orthogonal, the same is true of their sum and difference, which leaves these two; if all are, none is needed.
#ifndef PW85_KERNELS_LATTICE_HPP_INCLUDED
#define PW85_KERNELS_LATTICE_HPP_INCLUDED

namespace pw85::detail::kernels {

/// A periodic lattice, prepared for the search of nearest images: plain data, as kernels.hpp asks for.
struct Lattice {
    double basis[3][3];    ///< reduced basis vectors
    double dual[3][3];     ///< dual[i]·basis[j] = 1 if i = j, else 0
    double shift[3][9];    ///< coordinates of the vectors v of item 4, one column each
    double half_square[9]; ///< ½|v|² of each
    int num_shifts;        ///< number of these vectors: 0, 2 or 9
};

/// Prepares the lattice of a cell (nine numbers, rows = vectors). Returns false if the cell is singular or not finite. A reduced
/// cell is used without change.
bool prepare(double const *cell, Lattice &lattice) noexcept;

/// Finds a reduced basis of the lattice of a cell, rows = vectors, and unless null each reduced vector in multiples of the cell's
/// vectors. Returns false where prepare() does. A vector that is orthogonal to the two others does not change.
bool reduce(double const *cell, double *reduced, double (*multiples)[3] = nullptr) noexcept;

} // namespace pw85::detail::kernels

#endif
