// Reduction of a lattice; items as in lattice.hpp.
#include "lattice.hpp"

#include <cmath>
#include <initializer_list>

#include <pw85/symmetric.hpp>

namespace pw85::batch {

namespace {

/// Three linearly independent lattice vectors.
struct LatticeBasis {
    Vector<double, 3> b[3];
};

/// Replaces `x` by `candidate` if that is shorter by more than rounding; so reductions come to an end.
bool shorten(Vector<double, 3> &x, Vector<double, 3> const &candidate) noexcept
{
    bool const shorter = dot(candidate, candidate) < (1.0 - 0x1p-44) * dot(x, x);
    if (shorter) x = candidate;
    return shorter;
}

/// x + k y.
Vector<double, 3> plus_multiple(Vector<double, 3> x, double k, Vector<double, 3> const &y) noexcept
{
    for (int i = 0; i < 3; ++i) x[i] = std::fma(k, y[i], x[i]);
    return x;
}

/// Item 1, for b_i.
bool reduce_vector(LatticeBasis &basis, int i) noexcept
{
    Vector<double, 3> &x = basis.b[i];
    Vector<double, 3> const &y = basis.b[(i + 1) % 3], &z = basis.b[(i + 2) % 3];
    bool reduced = false;
    for (Vector<double, 3> const &w : {y, z})
        if (double const square = dot(w, w); square > 0.0)
            reduced = shorten(x, plus_multiple(x, -std::round(dot(x, w) / square), w)) || reduced;
    for (double sign_y : {-1.0, 1.0})
        for (double sign_z : {-1.0, 1.0})
            reduced = shorten(x, plus_multiple(plus_multiple(x, sign_y, y), sign_z, z)) || reduced;
    return reduced;
}

/// Item 1; false if the cell is singular to working precision: then reduction ends with a vector that is all rounding.
bool reduce(LatticeBasis &basis) noexcept
{
    double longest = 0.0, shortest = HUGE_VAL;
    for (auto const &b : basis.b) longest = std::fmax(longest, dot(b, b));
    // Each pass over a couple of vectors shortens like Euclid's algorithm: 53 bits are gone in far fewer rounds than this.
    bool reduced = true;
    for (int round = 0; reduced && round < 1000; ++round) {
        reduced = false;
        for (int i = 0; i < 3; ++i) reduced = reduce_vector(basis, i) || reduced;
    }
    for (auto const &b : basis.b) shortest = std::fmin(shortest, dot(b, b));
    return !reduced && shortest > 0x1p-80 * longest;
}

/// Item 3, for the vector with coordinates k in the reduced basis. Images whose squared distances agree to 2^-44 count as
/// equally near.
void add_shift(Lattice &lattice, LatticeBasis const &basis, int const (&k)[3]) noexcept
{
    Vector<double, 3> v{};
    for (int i = 0; i < 3; ++i) v = plus_multiple(v, k[i], basis.b[i]);
    double reach = 0.0;
    for (auto const &b : basis.b) reach += std::fabs(dot(b, v));
    if (!(reach > (1.0 + 0x1p-44) * dot(v, v))) return;
    for (int d = 0; d < 3; ++d) lattice.shift[lattice.num_shifts][d] = v[d];
    lattice.half_square[lattice.num_shifts++] = 0.5 * dot(v, v);
}

/// Lists the lattice vectors of item 3 with coordinates up to 2, one of each ± couple.
void list_shifts(Lattice &lattice, LatticeBasis const &basis) noexcept
{
    lattice.num_shifts = 0;
    for (int a = 0; a <= 2; ++a)
        for (int b = a > 0 ? -2 : 0; b <= 2; ++b)
            for (int c = a > 0 || b > 0 ? -2 : 1; c <= 2; ++c) add_shift(lattice, basis, {a, b, c});
}

/// Item 1 and what it takes to find coordinates, for a cell of order one; false if it is singular.
bool prepare_scaled(LatticeBasis basis, Lattice &lattice) noexcept
{
    if (!reduce(basis)) return false;
    double const volume = dot(basis.b[0], cross(basis.b[1], basis.b[2]));
    if (!std::isnormal(volume)) return false;
    for (int i = 0; i < 3; ++i) {
        auto const normal = cross(basis.b[(i + 1) % 3], basis.b[(i + 2) % 3]);
        for (int d = 0; d < 3; ++d) {
            lattice.basis[i][d] = basis.b[i][d];
            lattice.dual[i][d] = normal[d] / volume;
        }
    }
    list_shifts(lattice, basis);
    return true;
}

} // namespace

bool prepare(double const *cell, Lattice &lattice) noexcept
{
    double largest = 0.0;
    for (int k = 0; k < 9; ++k) {
        if (!std::isfinite(cell[k])) return false;
        largest = std::fmax(largest, std::fabs(cell[k]));
    }
    if (largest == 0.0) return false;
    int const e = std::ilogb(largest);
    LatticeBasis basis;
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) basis.b[i][d] = std::ldexp(cell[3 * i + d], -e);
    if (!prepare_scaled(basis, lattice)) return false;
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) {
            lattice.basis[i][d] = std::ldexp(lattice.basis[i][d], e);
            lattice.dual[i][d] = std::ldexp(lattice.dual[i][d], -e);
        }
    for (int k = 0; k < lattice.num_shifts; ++k) {
        for (double &x : lattice.shift[k]) x = std::ldexp(x, e);
        lattice.half_square[k] = std::ldexp(lattice.half_square[k], 2 * e);
    }
    return true;
}

} // namespace pw85::batch
