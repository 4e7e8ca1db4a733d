/// @file
/// The periodic images of a system, along any of the vectors of its cell.
///
/// Roundings: with u = 2⁻⁵³, a vector of the reduced lattice is a sum of up to three products, off by 3 u times `size`, the sum of
/// their magnitudes. A centre c that is moved by multiples s of these vectors is then off by at most 8 u M in each coordinate, with
/// M = |c| + Σ|s| size; a half-width h of three roundings by 4 u h, and each side of its box by u (M + h) more. So boxes grow by
/// 16 u (M + h) on each side, and by 16 u (M' + |side|) when they are moved by multiples m, M' = Σ|m| size: what meets in exact
/// arithmetic meets.
#ifndef PW85_NEIGHBORS_PERIODICITY_HPP_INCLUDED
#define PW85_NEIGHBORS_PERIODICITY_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/symmetric.hpp>

#include "boxes.hpp"

namespace pw85::detail::neighbors {

/// 16 u.
inline constexpr double margin = 0x1p-49;

/// Multiples of the vectors of a lattice.
struct Multiples {
    std::int32_t n[3];
};

/// Multiples are followed as far as this: the sum of three is in the range of int32.
inline constexpr double most_multiples = 0x1p29;

/// A vector of the lattice, in multiples of its reduced vectors and of the cell's own ones.
struct Move {
    Multiples reduced, own;
};

/// The lattice of the periodic directions.
class Periodicity {
  public:
    /// Without a cell nothing is periodic, and `periodic` is not read. False if no vector of a cell is periodic, or those that are are
    /// not finite or not independent.
    bool prepare(double const *cell, int const *periodic) noexcept;

    /// What to subtract from a point to take it near the origin; false if that takes too many multiples.
    bool reduce(Vector<double, 3> const &point, Move &move) const noexcept;

    /// A point near the origin that differs by multiples of the vectors, or nearly so.
    Vector<double, 3> wrapped(Vector<double, 3> const &point) const noexcept;

    /// The box around a centre less multiples of the vectors.
    Box wrapped(Vector<double, 3> const &center, Vector<double, 3> const &half_widths,
                Multiples const &multiples) const noexcept;

    /// A box moved by multiples of the vectors.
    Box moved(Box const &box, Multiples const &multiples) const noexcept;

    /// Multiples up to which images of a box can meet it: more than most_multiples where there are too many.
    Vector<double, 3> reach(Box const &box) const noexcept;

    /// Sets the own multiples from the reduced ones; false if they are too many.
    bool set_own(Move &move) const noexcept;

    /// Whether there are images along vector l of the cell.
    bool is_periodic(int l) const noexcept { return periodic_[l]; }

    /// A vector whose product with the periodic vectors of the cell is 1 for number l, which is one of them, and 0 for the others.
    Vector<double, 3> own_dual(int l) const noexcept;

    /// No entry of own_dual() is larger than this, whatever its rounding.
    double own_dual_bound(int l) const noexcept;

  private:
    /// Multiples of vector k that take a point away from the origin along it.
    double multiples_in(Vector<double, 3> const &point, int k) const noexcept;

    Vector<double, 3> sum(Multiples const &multiples, double const (&vectors)[3][3]) const noexcept;

    bool periodic_[3] = {};
    bool any_ = false;
    double basis_[3][3] = {};     ///< reduced vectors; zero for directions that are not periodic
    double size_[3][3] = {};      ///< see above
    double dual_[3][3] = {};      ///< zero as the basis
    double multiples_[3][3] = {}; ///< of the cell's vectors, for each of the reduced ones
};

} // namespace pw85::detail::neighbors

#endif
