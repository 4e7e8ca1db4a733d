// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Trials of a simulation, for C++: kinds of changes of the cell, steps, fractions and counts.
/// Their contracts are those of pw85_simulation_trials.h.
#ifndef PW85_SIMULATION_TRIALS_HPP_INCLUDED
#define PW85_SIMULATION_TRIALS_HPP_INCLUDED

#include <pw85_simulation_trials.h>

#include <array>
#include <cstdint>

namespace pw85 {

/// Type of the change of the cell in a volume move: see pw85_hard_ellipsoids_volume_moves().
enum class CellChange {
    isotropic = PW85_CHANGE_ISOTROPIC,
    axis = PW85_CHANGE_AXIS,
    triclinic = PW85_CHANGE_TRICLINIC,
    aspect = PW85_CHANGE_ASPECT
};

/// The largest changes of a trial: see pw85_hard_ellipsoids_set_steps().
struct TrialSteps {
    double translation, rotation, volume;
};

/// The fractions of the types of trials in a sweep: see pw85_hard_ellipsoids_set_fractions().
struct TrialFractions {
    double translation, rotation, both, exchange;
};

/// Numbers of trials, and numbers of accepted trials: translations, rotations, both at once,
/// exchanges, volume moves.
struct TrialCounts {
    std::array<std::int64_t, 5> trials, accepted;
};

} // namespace pw85

#endif
