// SPDX-License-Identifier: GPL-2.0-only
// The cells of fix pw85/hpmc, and positions that are multiples of a power of two.
#include "checkerboard.hpp"

#include <algorithm>
#include <cmath>

namespace pw85_lammps {

namespace {

/// Minimum number of units in the largest coordinate of a box: 2⁵⁰. With M = max(|lower|,
/// |upper|), 2ᵉ <= M < 2ᵉ⁺¹, images of the box that are adjacent to it are within 3 M < 2ᵉ⁺³ = 2⁵³
/// units.
constexpr int unit_exponent = 50;

/// Minimum number of units in the largest coordinate of a triclinic box: 2⁴⁴. LAMMPS converts
/// positions in it to fractions of its vectors and back. The error of this is at most some 20
/// roundings of terms below 4 M, less than 2⁷ 2⁻⁵³ M = 2⁻⁴⁶ M. Rounding to multiples of the unit
/// therefore finds the position again.
constexpr int triclinic_unit_exponent = 44;

/// Returns the largest coordinates of a box and of the terms of LAMMPS's conversion.
Vector largest_coordinates(ExactBox const &box)
{
    Vector largest;
    for (std::size_t k = 0; k < 3; ++k)
        largest[k] = std::max(std::abs(box.lower[k]), std::abs(box.upper(k)));
    auto const [xy, xz, yz] = box.tilts;
    largest[0] += std::abs(xy) + std::abs(xz) + std::abs(xy * yz) / box.edges[1];
    largest[1] += std::abs(yz);
    return largest;
}

} // namespace

double ExactBox::rounded(std::size_t k, double x) const
{
    return units[k] * std::nearbyint(x / units[k]);
}

Vector ExactBox::fractions(double const *x) const
{
    Vector const r = vector(x) - lower;
    double const c = r[2] / edges[2], b = (r[1] - tilts[2] * c) / edges[1];
    return {(r[0] - tilts[0] * b - tilts[1] * c) / edges[0], b, c};
}

Vector ExactBox::combination(Vector const &fractions) const
{
    auto const [a, b, c] = fractions;
    return {a * edges[0] + b * tilts[0] + c * tilts[1], b * edges[1] + c * tilts[2], c * edges[2]};
}

// Divides the volume by the areas of the faces. Without tilts the quotients are exactly the edges.
Vector ExactBox::heights() const
{
    auto const [xy, xz, yz] = tilts;
    double const slope_xy = xy / edges[1], slope_yz = yz / edges[2],
                 slope_xz = (xz - slope_xy * yz) / edges[2];
    return {edges[0] / std::hypot(1.0, slope_xy, slope_xz), edges[1] / std::hypot(1.0, slope_yz),
            edges[2]};
}

ExactBox exact_box(Vector const &lower, Vector const &upper, Vector const &tilts, bool is_triclinic)
{
    ExactBox box{lower, upper - lower, tilts, {}};
    int const exponent = is_triclinic ? triclinic_unit_exponent : unit_exponent;
    for (Vector ends = upper;;) {
        Vector const largest = largest_coordinates(box);
        Vector units;
        for (std::size_t k = 0; k < 3; ++k)
            units[k] = std::ldexp(1.0, std::ilogb(largest[k]) - exponent);
        if (units == box.units) return box;
        // Rounding up to a power of two doubles the unit, so a second turn may be needed.
        box.units = units;
        for (std::size_t k = 0; k < 3; ++k) {
            box.lower[k] = units[k] * std::floor(box.lower[k] / units[k]);
            ends[k] = units[k] * std::ceil(ends[k] / units[k]);
            box.edges[k] = ends[k] - box.lower[k];
        }
        for (std::size_t t = 0; t < 3; ++t) box.tilts[t] = box.rounded(t < 2 ? 0 : 1, box.tilts[t]);
    }
}

// The box has count - 1 cells along this direction. Sums of coordinates stay exact: the longer box
// is at most twice as long, and has no images along this direction.
ExactBox Checkerboard::lengthened(ExactBox box, std::size_t k, int count)
{
    box.edges[k] += box.rounded(k, box.edges[k] / (count - 1));
    return box;
}

Checkerboard::Cell Checkerboard::cell(double const *x) const
{
    Vector const fractions = box_.fractions(x);
    Cell cell;
    for (std::size_t k = 0; k < cell.size(); ++k)
        cell[k] =
            std::clamp(static_cast<int>(std::floor(fractions[k] * counts_[k])), 0, counts_[k] - 1);
    return cell;
}

bool Checkerboard::is_inside(Cell const &cell, double const *x) const
{
    Vector const fractions = box_.fractions(x);
    bool inside = true;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        double const place = fractions[k] * counts_[k] - cell[k];
        inside = inside && place >= guards_[k] && place < 1.0 - guards_[k];
    }
    return inside;
}

Vector Checkerboard::in_cell(Vector const &fractions) const
{
    Vector part;
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = fractions[k] / counts_[k];
    Vector result = box_.combination(part);
    // Rounded down: a shift across faces that are not periodic stays in the lengthened box.
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = box_.units[k] * std::floor(result[k] / box_.units[k]);
    return result;
}

// The quotient is rounded: it may be a number of cells for which the box is too low by less than a
// rounding error. The sign of the fused expression is exact.
int Checkerboard::largest_count(double box_height, double diameter, bool is_periodic)
{
    // The largest number of cells along a direction for which their indices fit into int.
    constexpr double most = 1024.0;
    double const beyond = is_periodic ? 0.0 : 1.0;
    double const count = 2.0 * std::floor(std::min(box_height / diameter + beyond, most) / 2.0);
    bool const fits = std::fma(count - beyond, diameter, -box_height) <= 0.0;
    return static_cast<int>(fits ? count : count - 2.0);
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
