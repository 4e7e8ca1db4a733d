// SPDX-License-Identifier: GPL-2.0-only
// The cells of fix pw85/hpmc, and positions that are multiples of a power of two.
#include "checkerboard.hpp"

#include <algorithm>
#include <cmath>

namespace pw85_lammps {

double ExactPeriod::rounded(double x) const { return unit * std::nearbyint(x / unit); }

// With M = max(|lower|, |upper|), 2ᵉ <= M < 2ᵉ⁺¹, images of the box that are adjacent to it are
// within 3 M < 2ᵉ⁺³ = 2⁵³ units.
ExactPeriod exact_period(double lower, double upper)
{
    ExactPeriod period{lower, upper, 0.0};
    for (;;) {
        double const unit = std::ldexp(
            1.0, std::ilogb(std::max(std::abs(period.lower), std::abs(period.upper))) - 50);
        if (unit == period.unit) return period;
        // Rounding up to a power of two doubles the unit, so that a second turn may be needed.
        period.unit = unit;
        period.lower = period.rounded(period.lower);
        period.upper = period.rounded(period.upper);
    }
}

Checkerboard::Cell Checkerboard::cell(double const *x) const
{
    Cell cell;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        double const fraction = (x[k] - box_[k].lower) / box_[k].edge();
        cell[k] =
            std::clamp(static_cast<int>(std::floor(fraction * counts_[k])), 0, counts_[k] - 1);
    }
    return cell;
}

// LAMMPS computes the sides of sub-domains from fractions of the box, with errors of a few units.
// Positions within 16 units of the side of a cell belong to no cell, so that no processor moves an
// atom of a cell that belongs to another. This rule depends on nothing but the position.
bool Checkerboard::is_inside(Cell const &cell, double const *x) const
{
    bool inside = true;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        double const guard = 16.0 * box_[k].unit, width = box_[k].edge() / counts_[k];
        double const lower = box_[k].lower + cell[k] * width,
                     upper = box_[k].lower + (cell[k] + 1) * width;
        inside &= (x[k] >= lower + guard) & (x[k] < upper - guard);
    }
    return inside;
}

int Checkerboard::largest_count(double box_edge, double cell_edge)
{
    // The largest number of cells along a direction for which their indices fit into int.
    constexpr double most = 1024.0;
    return 2 * static_cast<int>(std::floor(std::min(box_edge / cell_edge, most) / 2.0));
}

int Checkerboard::default_count(int largest)
{
    for (int const divisor : {12, 4}) {
        int const count = largest / divisor * divisor;
        if (4 * count >= 3 * largest) return count;
    }
    return largest;
}

} // namespace pw85_lammps
