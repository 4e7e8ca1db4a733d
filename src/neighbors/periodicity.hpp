// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The periodic images of a system along any of the vectors of its cell. The class moves points and
/// boxes by lattice vectors. build_tree.cpp and search.cpp call it, and periodic/lattice.hpp
/// reduces the lattice.
///
/// Rounding errors, with u = 2⁻⁵³: a vector of the reduced lattice is a sum of up to three
/// products. Its error is at most 3 u times `size`, the sum of their magnitudes. A centre c that is
/// moved by multiples s of these vectors has an error of at most 8 u M in each coordinate, with M =
/// |c| + Σ|s| size. A half-width h after three roundings has an error of at most 4 u h. Each side
/// of its box errs by u (M + h) more. So boxes grow by 16 u (M + h) on each side. When they are
/// moved by multiples m, they grow by 16 u (M' + |side|), with M' = Σ|m| size. Boxes that intersect
/// in exact arithmetic therefore intersect here.
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

/// Larger multiples are an error. The sum of three multiples of this size is in the range of int32.
inline constexpr double most_multiples = 0x1p29;

/// A vector of the lattice.
struct LatticeVector {
    Multiples of_reduced; ///< its coordinates in the reduced basis
    Multiples of_cell;    ///< its coordinates in the vectors of the cell, as the caller gave them
};

/// The lattice of the periodic directions.
class Periodicity {
  public:
    /// @param cell nine numbers, rows = vectors; null if nothing is periodic
    /// @param periodic which vectors are periodic; not read if there is no cell
    /// @return false if no vector of the cell is periodic, or if the periodic vectors are not
    /// finite or not linearly independent
    bool prepare(double const *cell, int const *periodic) noexcept;

    /// Finds the lattice vector that is subtracted from a point to move it near the origin. Returns
    /// false if its multiples are too large.
    bool reduce(Vector<double, 3> const &point, LatticeVector &vector) const noexcept;

    /// Returns a point near the origin that differs from the given one by a lattice vector, up to
    /// rounding.
    Vector<double, 3> wrapped(Vector<double, 3> const &point) const noexcept;

    /// The box around a centre after multiples of the reduced vectors are subtracted.
    Box wrapped(Vector<double, 3> const &center, Vector<double, 3> const &half_widths,
                Multiples const &multiples) const noexcept;

    /// Returns a box that is moved by multiples of the reduced vectors.
    Box moved(Box const &box, Multiples const &multiples) const noexcept;

    /// Returns the largest multiple of each reduced vector by which a box can be moved and still
    /// intersect itself. The result may exceed most_multiples.
    Vector<double, 3> reach(Box const &box) const noexcept;

    /// Computes `of_cell` from `of_reduced`. Returns false if the multiples are too large.
    bool set_multiples_of_cell(LatticeVector &vector) const noexcept;

    /// Returns the length of the shortest vector of the lattice; infinity if nothing is periodic.
    double shortest() const noexcept;

    /// Returns whether there are images along vector l of the cell.
    bool is_periodic(int l) const noexcept { return periodic_[l]; }

    /// Returns the dual of vector l of the cell, which must be periodic. The product of the dual
    /// with this vector is 1, and with the other periodic vectors 0.
    Vector<double, 3> dual_of_cell(int l) const noexcept;

    /// Returns a bound on the entries of dual_of_cell() that includes rounding errors.
    double dual_of_cell_bound(int l) const noexcept;

  private:
    /// Returns the coordinate of a point along reduced vector k, rounded to an integer.
    double multiples_in(Vector<double, 3> const &point, int k) const noexcept;

    Vector<double, 3> sum(Multiples const &multiples, double const (&vectors)[3][3]) const noexcept;

    bool periodic_[3] = {};
    bool any_ = false;
    double basis_[3][3] = {}; ///< reduced vectors; zero for directions that are not periodic
    double size_[3][3] = {};  ///< `size` of the comment at the head of this file
    /// dual of the reduced vectors; zero for directions that are not periodic
    double dual_[3][3] = {};
    double multiples_[3][3] = {}; ///< each reduced vector in multiples of the vectors of the cell
};

} // namespace pw85::detail::neighbors

#endif
