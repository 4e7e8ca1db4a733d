// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The cells of fix pw85/hpmc, in eight colours, and the positions that make its results
/// independent of the number of processors.
#ifndef PW85_LAMMPS_CHECKERBOARD_HPP_INCLUDED
#define PW85_LAMMPS_CHECKERBOARD_HPP_INCLUDED

#include "vectors.hpp"

#include <array>

namespace pw85_lammps {

/// A box, maybe sheared, whose vectors and positions are multiples of powers of two: along each
/// axis of space, of a unit.
///
/// All coordinates of the box and of its adjacent periodic images are below 2⁵³ units. LAMMPS's
/// shifts by vectors of the box, shifts of all atoms, and differences of coordinates therefore have
/// no rounding errors. Distances do not depend on which image of an atom a processor has.
struct ExactBox {
    Vector lower{}, edges{}; ///< edges: of the box along the axes
    Vector tilts{};          ///< xy, xz, yz, as LAMMPS has them
    Vector units{};

    double upper(std::size_t k) const { return lower[k] + edges[k]; }
    double volume() const { return edges[0] * edges[1] * edges[2]; }

    /// Returns the multiple of the unit of an axis that is nearest to x.
    double rounded(std::size_t k, double x) const;

    /// Returns the coordinates of x from the lower corner of the box, in units of its vectors.
    Vector fractions(double const *x) const;

    /// Returns the sum of the vectors of the box, each times a number.
    Vector combination(Vector const &fractions) const;

    /// Returns the distances of opposite faces.
    Vector heights() const;

    bool operator==(ExactBox const &) const = default;
};

/// Returns the smallest exact box with these tilts around this one. A box that is exact already is
/// unchanged.
/// @param is_triclinic whether LAMMPS converts positions to fractions, also without tilts
ExactBox exact_box(Vector const &lower, Vector const &upper, Vector const &tilts,
                   bool is_triclinic);

/// A division of a box into cells, an even number along each of its vectors. Cells of one colour
/// are at least the height of a cell apart.
///
/// Periodic directions have as many cells as fit into the box. Along other directions, the cells
/// fill a box that is longer by one cell, in which a sweep shifts the atoms. So the faces of the
/// cells have random positions there, too.
class Checkerboard {
  public:
    using Cell = std::array<int, 3>;
    using Counts = std::array<int, 3>;

    static constexpr int num_colours = 8;

    Checkerboard() = default;

    /// @param box that the cells fill; see lengthened()
    Checkerboard(ExactBox const &box, Counts const &counts)
        : box_(box), heights_(box.heights()), counts_(counts)
    {
        for (std::size_t k = 0; k < guards_.size(); ++k)
            guards_[k] = guard_units * counts_[k] * box_.units[k] / box_.edges[k];
    }

    /// Returns the box that is longer by one of `count` cells along a direction.
    static ExactBox lengthened(ExactBox box, std::size_t k, int count);

    ExactBox const &box() const { return box_; }
    Counts const &counts() const { return counts_; }

    /// Returns the distance of opposite faces of a cell.
    double height(std::size_t k) const { return heights_[k] / counts_[k]; }

    /// Returns the cell of a position in the box.
    Cell cell(double const *x) const;

    /// Returns whether a position is in a cell, and not within rounding errors of its sides.
    bool is_inside(Cell const &cell, double const *x) const;

    /// Returns a vector in a cell, from its lower corner.
    Vector in_cell(Vector const &fractions) const;

    static int colour(Cell const &cell)
    {
        return cell[0] % 2 + 2 * (cell[1] % 2) + 4 * (cell[2] % 2);
    }
    int index(Cell const &cell) const
    {
        return cell[0] + counts_[0] * (cell[1] + counts_[1] * cell[2]);
    }

    /// Returns the largest number of cells along a direction: an even number, below 2 if none fits.
    ///
    /// A periodic box holds all cells, each at least as high as the largest diameter. If the box is
    /// not periodic, one cell is beyond it. There is no margin for rounding errors of forms: atoms
    /// of different cells of a colour are farther apart than the height of a cell, by twice the
    /// guards. These are at least 2 guard_units 2⁻⁵¹ = 2⁻⁴⁶ of half the box, so of the diameter.
    static int largest_count(double box_height, double diameter, bool is_periodic);

    /// Returns the default number of cells. It does not depend on the processors, but suits many
    /// grids of processors: a multiple of 12 or 4 if that makes cells longer by at most a third.
    static int default_count(int largest);

  private:
    /// LAMMPS computes the sides of sub-domains from fractions of the box, with errors of a few
    /// units of an orthogonal box. In a triclinic box, whose units are 2⁶ times as large, it
    /// computes fractions of positions, with errors below a unit. Positions within this many units
    /// of the side of a cell belong to no cell. No processor then moves an atom of a cell that
    /// belongs to another. This rule depends on nothing but the position.
    static constexpr double guard_units = 16.0;

    ExactBox box_{};
    Vector heights_{};
    Counts counts_{};
    Vector guards_{}; ///< parts of the edges of a cell
};

} // namespace pw85_lammps

#endif
