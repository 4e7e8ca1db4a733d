/// @file
/// The arguments of the functions of many pairs and of systems: spans of rows, and what belongs together in one value.
#ifndef PW85_BATCH_VALUES_HPP_INCLUDED
#define PW85_BATCH_VALUES_HPP_INCLUDED

#include <array>
#include <cstdint>
#include <span>

#include <pw85/algebra/factor.hpp>
#include <pw85/motion/motion.hpp>
#include <pw85/status.hpp>

namespace pw85 {

using Vectors = std::span<Vector<double, 3> const>;
using Forms = std::span<SymmetricMatrix<double, 3> const>;

/// Those of ellipses.
using FlatVectors = std::span<Vector<double, 2> const>;
using FlatForms = std::span<SymmetricMatrix<double, 2> const>;

/// Particles i and j of a pair.
using IndexPair = std::array<std::int32_t, 2>;

/// Multiples of the vectors of a cell, to be added to the second particle of a pair.
using Image = std::array<std::int32_t, 3>;

/// Rows = vectors of a periodic cell.
using Cell = std::array<Vector<double, 3>, 3>;

/// A reduced cell, NaN where the status is not success.
struct ReducedCell {
    Cell cell;
    Status status;
};

/// Where the contact functions of pairs and their derivatives go; see pw85_contact_derivatives_batch().
struct DerivativeSpans {
    std::span<double> mu2 = {}, lambda = {};
    std::span<Vector<double, 3>> point = {}, normal = {}, d_r12 = {}, d_rot1 = {}, d_rot2 = {};
};

/// Where first contacts go, and for each particle its next one and the index of the pair, -1 if there is none; see
/// pw85_first_contact_pairs().
struct EventSpans {
    std::span<double> time;
    std::span<double> next = {};
    std::span<std::int64_t> next_pair = {}; ///< not without `next`
};

/// The energy U(μ²) of a pair: PW85_LAW_SOFT_REPULSION, PW85_LAW_INVERSE_POWERS or PW85_LAW_TABLE, and its parameters; see pw85_law.
struct Law {
    int kind;
    std::span<double const> parameters;
};

/// Where forces go, one row for each particle, and the virial; see pw85_contact_forces_pairs().
struct ForceSpans {
    std::span<Vector<double, 3>> forces = {}, torques = {};
    std::array<Vector<double, 3>, 3> *virial = nullptr;
};

/// The pairs of a neighbour list, each with the image that it stands for; without images they are the nearest ones.
struct PairList {
    std::span<IndexPair const> pairs;
    std::span<Image const> images = {};
};

/// Particles, in a periodic cell or not.
struct Particles {
    Vectors centers;
    Forms q;
    Cell const *cell = nullptr;
    std::array<int, 3> periodic = {1, 1, 1}; ///< along which vectors of the cell there are images
};

} // namespace pw85

#endif
