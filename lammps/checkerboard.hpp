// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The cells of fix pw85/hpmc, in eight colours, and the positions that make its results
/// independent of the number of processors.
#ifndef PW85_LAMMPS_CHECKERBOARD_HPP_INCLUDED
#define PW85_LAMMPS_CHECKERBOARD_HPP_INCLUDED

#include "vectors.hpp"

#include <array>

namespace pw85_lammps {

/// A periodic box along one direction, whose sides and positions are multiples of a power of two,
/// the unit.
///
/// All coordinates of the box and of its periodic images are below 2⁵³ units, so that LAMMPS's
/// shifts by the period, shifts of all atoms, and differences of coordinates have no rounding
/// errors. Distances do not depend on which image of an atom a processor has.
struct ExactPeriod {
    double lower, upper, unit;

    double edge() const { return upper - lower; }

    /// The multiple of the unit that is nearest to x.
    double rounded(double x) const;

    bool operator==(ExactPeriod const &) const = default;
};

/// The period of which the sides are nearest to these. A period that is exact already is unchanged.
ExactPeriod exact_period(double lower, double upper);

/// A division of the periodic box into cells, an even number along each direction. Cells of one
/// colour are at least the edge of a cell apart.
class Checkerboard {
  public:
    using Cell = std::array<int, 3>;
    using Counts = std::array<int, 3>;

    static constexpr int num_colours = 8;

    Checkerboard() = default;
    Checkerboard(std::array<ExactPeriod, 3> const &box, Counts const &counts)
        : box_(box), counts_(counts)
    {
    }

    Counts const &counts() const { return counts_; }
    double edge(int k) const { return box_[at(k)].edge() / counts_[at(k)]; }

    /// The cell of a position in the box.
    Cell cell(double const *x) const;

    /// Whether a position is in a cell, and not within rounding errors of its sides.
    bool is_inside(Cell const &cell, double const *x) const;

    static int colour(Cell const &cell)
    {
        return cell[0] % 2 + 2 * (cell[1] % 2) + 4 * (cell[2] % 2);
    }
    int index(Cell const &cell) const
    {
        return cell[0] + counts_[0] * (cell[1] + counts_[1] * cell[2]);
    }

    /// How many cells along a direction fit into a box of this edge: an even number, below 2 if
    /// none does.
    static int largest_count(double box_edge, double cell_edge);

    /// The number of cells by default. It does not depend on the processors, but suits as many
    /// grids of processors as it can: a multiple of 12 or 4 if that makes cells by at most a third
    /// longer.
    static int default_count(int largest);

  private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    std::array<ExactPeriod, 3> box_{};
    Counts counts_{};
};

} // namespace pw85_lammps

#endif
