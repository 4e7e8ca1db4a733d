// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The arguments of the functions of systems: particles, lists of pairs, and the outputs that
/// belong together. calls.hpp converts them to the arguments of the C API.
#ifndef PW85_SYSTEMS_VALUES_HPP_INCLUDED
#define PW85_SYSTEMS_VALUES_HPP_INCLUDED

#include <array>
#include <cstdint>
#include <span>

#include <pw85/batch/values.hpp>

namespace pw85 {

/// The indices i and j of the particles of a pair.
using IndexPair = std::array<std::int32_t, 2>;

/// Multiples of the vectors of a cell, to be added to the second particle of a pair.
using Image = std::array<std::int32_t, 3>;

/// A periodic cell. The rows are its vectors.
using Cell = std::array<Vector<double, 3>, 3>;

/// A reduced cell. It is NaN if the status is not success.
struct ReducedCell {
    Cell cell;
    StatusCode status;
};

/// The outputs for first contacts: one time for each pair, and for each particle its next contact
/// and the index of the pair, which is -1 if there is none. See pw85_first_contact_pairs().
struct EventSpans {
    std::span<double> time;
    std::span<double> next = {};
    std::span<std::int64_t> next_pair = {}; ///< needs `next`
};

/// The law of the energy U(μ²) of a pair, and its parameters. `kind` is PW85_LAW_SOFT_REPULSION,
/// PW85_LAW_INVERSE_POWERS or PW85_LAW_TABLE: see pw85_law.
struct Law {
    int kind;
    std::span<double const> parameters;
};

/// The outputs for forces and torques, one row for each particle, and for the virial: see
/// pw85_contact_forces_pairs().
struct ForceSpans {
    std::span<Vector<double, 3>> forces = {}, torques = {};
    std::array<Vector<double, 3>, 3> *virial = nullptr;
};

/// The pairs of a neighbour list, each with the image of its second particle. Without images the
/// functions use the nearest ones.
struct PairList {
    std::span<IndexPair const> pairs;
    std::span<Image const> images = {};
};

/// Particles, with or without a periodic cell.
struct Particles {
    Vectors centers;
    Forms q;
    Cell const *cell = nullptr;
    /// the vectors of the cell along which there are images
    std::array<int, 3> periodic = {1, 1, 1};
};

} // namespace pw85

#endif
