// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Values of random sequential addition, for C++: its progress, and why it ends. Their contracts
/// are those of pw85_simulation_addition.h.
#ifndef PW85_SIMULATION_ADDITION_HPP_INCLUDED
#define PW85_SIMULATION_ADDITION_HPP_INCLUDED

#include <pw85_simulation_addition.h>

#include <cstddef>

namespace pw85 {

/// The reason why an addition ends: see pw85_random_addition_advance().
enum class AdditionEnd {
    none = PW85_ADDITION_CONTINUES,
    saturated = PW85_ADDITION_SATURATED,
    attempts = PW85_ADDITION_ATTEMPTS,
    particles = PW85_ADDITION_PARTICLES
};

/// The progress of an addition: see pw85_random_addition_state().
struct AdditionState {
    std::size_t num_particles;
    double attempts, free_share;
};

} // namespace pw85

#endif
