// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The numbers of voxels of a random sequential addition along each direction.
#ifndef PW85_ADDITION_DIVISIONS_HPP_INCLUDED
#define PW85_ADDITION_DIVISIONS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

namespace pw85::detail::sequential_addition {
namespace {

/// The maximum number of voxels that are made first.
constexpr double max_first_voxels = 1e8;

/// Into how many parts each vector of the cell and the angles are divided.
template <int D> struct Divisions {
    std::uint64_t places[std::size_t(D)], angles;

    /// The number of parts of all positions and angles.
    double count() const noexcept
    {
        double total = static_cast<double>(angles);
        for (std::uint64_t const one : places) total *= static_cast<double>(one);
        return total;
    }
};

/// Halves divisions until all species together have few voxels, or one voxel each.
template <int D> void limit_voxels(Divisions<D> &divisions, double num_species) noexcept
{
    while (num_species * divisions.count() > max_first_voxels && divisions.count() > 1) {
        for (auto &one : divisions.places) one = (one + 1) / 2;
        divisions.angles = (divisions.angles + 1) / 2;
    }
}

} // namespace
} // namespace pw85::detail::sequential_addition

#endif
