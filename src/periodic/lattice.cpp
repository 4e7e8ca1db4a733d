// SPDX-License-Identifier: BSD-3-Clause
// Reduces a lattice and prepares the search of nearest images (nearest_image.hpp). lattice.hpp says
// what a reduced basis is, and lists the callers.
#include "lattice.hpp"

#include <algorithm>

#include <pw85/algebra/symmetric.hpp>

namespace pw85::detail::kernels {

namespace {

/// Three lattice vectors, in multiples of `unit`.
struct Basis {
    Vector<double, 3> b[3];
    double multiples[3][3]; ///< each of them in multiples of the cell's vectors
    double unit;            ///< a power of two, 1 unless the lengths are extreme
};

/// The scalar products in the inequalities of a reduced basis (lattice.hpp).
struct Gram {
    double square[3];  ///< b_i·b_i
    double product[3]; ///< entry i: the product of the two other vectors
};

/// A cell is not scaled if its largest entry is between this number and its inverse.
constexpr double unscaled_limit = 0x1p100;

/// An inequality counts as fulfilled if it fails by no more than this fraction of the squares of
/// lengths. The fraction is far above their rounding errors.
constexpr double tolerance = 0x1p-44;

/// A cell counts as singular if the smallest squared length of its reduced vectors over the largest
/// is below this number.
constexpr double singular = 0x1p-80;

/// Returns whether the nine numbers of a cell are finite.
bool is_finite(double const *cell) noexcept
{
    double zero = 0.0;
    for (int k = 0; k < 9; ++k) zero += 0.0 * cell[k];
    return zero == 0.0;
}

/// Loads a cell in units in which products of its entries stay in range. It returns false if the
/// cell is not finite, or zero.
bool load(double const *cell, Basis &basis) noexcept
{
    double largest = 0.0;
    for (int k = 0; k < 9; ++k) largest = maximum(largest, elementary::abs(cell[k]));
    if (!(is_finite(cell) && largest > 0.0)) return false;
    bool const in_range = largest < unscaled_limit && largest * unscaled_limit > 1.0;
    basis.unit =
        in_range ? 1.0 : elementary::ldexp(1.0, maximum(elementary::ilogb(largest), -1022));
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) {
            basis.b[i][d] = cell[3 * i + d] / basis.unit;
            basis.multiples[i][d] = i == d;
        }
    return true;
}

Gram gram(Basis const &basis) noexcept
{
    Gram g;
    for (int i = 0; i < 3; ++i) {
        g.square[i] = dot(basis.b[i], basis.b[i]);
        g.product[i] = dot(basis.b[(i + 1) % 3], basis.b[(i + 2) % 3]);
    }
    return g;
}

/// The signs of the shortest of b_1 ± b_2 ± b_3, and the square of its length.
struct Triple {
    double sign[3];
    double square;
};

Triple shortest_triple(Gram const &g) noexcept
{
    double const sum = g.square[0] + g.square[1] + g.square[2];
    Triple shortest{{}, infinity<double>()};
    for (double const second : {-1.0, 1.0})
        for (double const third : {-1.0, 1.0}) {
            double const products =
                second * third * g.product[0] + third * g.product[1] + second * g.product[2];
            if (double const square = sum + 2.0 * products; square < shortest.square)
                shortest = {{1.0, second, third}, square};
        }
    return shortest;
}

/// Subtracts a multiple of vector j from vector i.
void subtract(Basis &basis, std::ptrdiff_t i, double multiple, std::ptrdiff_t j) noexcept
{
    for (int d = 0; d < 3; ++d) {
        basis.b[i][d] = elementary::fma(-multiple, basis.b[j][d], basis.b[i][d]);
        basis.multiples[i][d] =
            elementary::fma(-multiple, basis.multiples[j][d], basis.multiples[i][d]);
    }
}

/// Returns whether adding multiples of another vector can shorten a vector. `product` is their
/// product, `square` and `other` are their squares.
bool is_reducible(double product, double square, double other) noexcept
{
    double const excess = elementary::abs(product) - 0.5 * other;
    return excess > 0.0 && excess * excess > tolerance * tolerance * (square * other);
}

/// Shortens one vector of the basis. It returns false if the basis is already reduced.
bool shorten(Basis &basis, Gram const &g) noexcept
{
    for (int k = 0; k < 3; ++k)
        for (int const i : {(k + 1) % 3, (k + 2) % 3}) {
            int const j = 3 - i - k;
            if (!is_reducible(g.product[k], g.square[i], g.square[j])) continue;
            subtract(basis, i, elementary::round(g.product[k] / g.square[j]), j);
            return true;
        }
    Triple const triple = shortest_triple(g);
    auto const longest = std::max_element(g.square, g.square + 3) - g.square;
    if (!(triple.square < (1.0 - tolerance) * g.square[longest])) return false;
    for (auto const other : {(longest + 1) % 3, (longest + 2) % 3})
        subtract(basis, longest, -triple.sign[longest] * triple.sign[other], other);
    return true;
}

/// Reduces a basis. A basis that is already reduced does not change. It returns false if the basis
/// is singular to working precision. In this case the reduction leads to a vector that consists of
/// rounding errors only.
bool reduce(Basis &basis, Gram &g) noexcept
{
    g = gram(basis);
    double const least = singular * *std::max_element(g.square, g.square + 3);
    // The lengths decrease as in Euclid's algorithm. Far fewer steps than this limit use up all 53
    // bits.
    for (int step = 0; step < 1000; ++step) {
        if (!(*std::min_element(g.square, g.square + 3) > least)) return false;
        if (!shorten(basis, g)) return true;
        g = gram(basis);
    }
    return false;
}

/// Lists the vectors v, up to the sign, by which the nearest image may differ from the image that
/// nearest_image() first computes.
///
/// nearest_image() subtracts the nearest integers from the coordinates of a separation in the
/// reduced basis. Then the coordinates y satisfy |y_i| <= ½. The nearest image is this one, or one
/// whose coordinates differ by -1, 0 or 1. Proof: Every lattice with a reduced basis has four
/// vectors c_m with Σ c_m = 0 and c_m·c_n <= 0 for m != n. If the signs of the b_i can be chosen so
/// that no b_i·b_j is positive, they are (b_1, b_2, b_3, -b_1-b_2-b_3). Otherwise choose the signs
/// so that all products are positive, and number the vectors so that b_i·b_j is the smallest
/// product. Then the four vectors are (b_i, -b_j, b_k-b_i, b_j-b_k). This follows from the
/// inequalities of a reduced basis.
///
/// So the squared length of a lattice vector Σ n_m c_m is Σ p_mn (n_m - n_n)² over m < n with p_mn
/// = -c_m·c_n. This means that the lattice is of Voronoi's first kind (J. reine angew. Math. 134,
/// 198, 1908). The faces of its Voronoi cell are half-way to sums of some of the c_m, which have
/// coordinates -1, 0 or 1 in the reduced basis. The cell has a vertex for each order of the c_m.
/// The n_m of a vertex are the potentials of a network with conductances p_mn, whose edges have
/// electromotive forces ½ in the direction of that order. The coordinates of a vertex in the
/// reduced basis are voltages between two nodes of this network. Such a voltage is half the mean
/// length of the paths of a current between the two nodes, so it is at most 3/2. It is less than
/// 3/2, because by the inequalities not all of the current goes through both other nodes: p is
/// positive between the two nodes, or else between one of them and the farther of the other two.
void list_shifts(Lattice &lattice, Basis const &basis, Gram const &g) noexcept
{
    int num_skew = 0,
        // the number of pairs of vectors that are not orthogonal; a vector that is not in the last
        // such pair
        skew = 0;
    for (int i = 0; i < 3; ++i) {
        double const bound = tolerance * tolerance * g.square[(i + 1) % 3] * g.square[(i + 2) % 3];
        if (g.product[i] * g.product[i] <= bound) continue;
        skew = i;
        ++num_skew;
    }
    // The image r - v is nearer than r if and only if r·v > ½|v|². Since |r·v| <= ½ Σ|b_i·v|, this
    // needs Σ|b_i·v| > |v|². For v = ±b_1 ±b_2 ±b_3 the sum is |v|² by the inequalities of a
    // reduced basis, which leaves nine pairs ±v. If only two of the b_i are not orthogonal, the
    // same holds for their sum and difference, which leaves only these two vectors. If all are
    // orthogonal, no v is left.
    lattice.num_shifts = num_skew == 0 ? 0 : num_skew == 1 ? 2 : 9;
    if (num_skew == 0) return;
    for (int d = 0; d < 3; ++d) {
        double const x = basis.b[skew][d], y = basis.b[(skew + 1) % 3][d],
                     z = basis.b[(skew + 2) % 3][d];
        double const shifts[9] = {y, z, x, y + z, y - z, x + y, x - y, x + z, x - z};
        std::copy_n(shifts, 9, lattice.shift[d]);
    }
    for (int k = 0; k < 9; ++k) {
        double const x = lattice.shift[0][k], y = lattice.shift[1][k], z = lattice.shift[2][k];
        lattice.half_square[k] = 0.5 * (x * x + y * y + z * z);
    }
}

/// Converts a lattice from units of the basis to units of the caller.
void rescale(Lattice &lattice, double unit) noexcept
{
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) {
            lattice.basis[i][d] *= unit;
            lattice.dual[i][d] /= unit;
        }
    for (int k = 0; k < lattice.num_shifts; ++k) {
        for (auto &coordinates : lattice.shift) coordinates[k] *= unit;
        lattice.half_square[k] *= unit * unit;
    }
}

/// Does what prepare() does, faster, for a cell whose vectors are along the axes and need no
/// scaling. It returns false for other cells. Monte Carlo simulations prepare a cell for each move.
bool prepare_rectangular(double const *cell, Lattice &lattice) noexcept
{
    for (int const k : {1, 2, 3, 5, 6, 7})
        if (!(cell[k] == 0.0)) return false;
    double const lengths[] = {elementary::abs(cell[0]), elementary::abs(cell[4]),
                              elementary::abs(cell[8])};
    for (double const length : lengths)
        if (!(length < unscaled_limit && length * unscaled_limit > 1.0)) return false;
    double const shortness =
        *std::min_element(lengths, lengths + 3) / *std::max_element(lengths, lengths + 3);
    if (!(shortness * shortness > singular)) return false;
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) {
            lattice.basis[i][d] = i == d ? cell[4 * i] : 0.0;
            lattice.dual[i][d] = i == d ? 1.0 / cell[4 * i] : 0.0;
        }
    lattice.num_shifts = 0;
    return true;
}

} // namespace

bool prepare(double const *cell, Lattice &lattice) noexcept
{
    if (prepare_rectangular(cell, lattice)) return true;
    Basis basis;
    Gram g;
    if (!load(cell, basis) || !reduce(basis, g)) return false;
    double const volume = dot(basis.b[0], cross(basis.b[1], basis.b[2]));
    for (int i = 0; i < 3; ++i) {
        auto const normal = cross(basis.b[(i + 1) % 3], basis.b[(i + 2) % 3]);
        for (int d = 0; d < 3; ++d) {
            lattice.basis[i][d] = basis.b[i][d];
            lattice.dual[i][d] = normal[d] / volume;
        }
    }
    list_shifts(lattice, basis, g);
    if (basis.unit != 1.0) rescale(lattice, basis.unit);
    return true;
}

bool reduce(double const *cell, double *reduced, double (*multiples)[3]) noexcept
{
    Basis basis;
    Gram g;
    if (!load(cell, basis) || !reduce(basis, g)) return false;
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) {
            reduced[3 * i + d] = basis.unit * basis.b[i][d];
            if (multiples != nullptr) multiples[i][d] = basis.multiples[i][d];
        }
    return true;
}

} // namespace pw85::detail::kernels
