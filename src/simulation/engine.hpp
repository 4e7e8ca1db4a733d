// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Monte Carlo of hard ellipsoids. hard_ellipsoids.cpp offers it in the C API.
///
/// The target is the uniform distribution of all configurations without overlaps. A trial is
/// accepted if it leads to no overlap. It is in detailed balance with this target, if the trial
/// that leads back is equally probable. Walls, fields and a potential (external_potential.hpp) may
/// reject a trial before the overlap test, energies of pairs (pair_energy.hpp) after it.
#ifndef PW85_SIMULATION_ENGINE_HPP_INCLUDED
#define PW85_SIMULATION_ENGINE_HPP_INCLUDED

#include "sweep.hpp"
#include "volume_moves.hpp"

namespace pw85::detail::simulation {

/// An image of a particle near another one, and the separation from the centre of that one.
struct NearImage {
    std::int32_t particle;
    Multiples image;
    Vector3 r12;
};

/// Finds an overlap by a list of neighbours of its own, and returns PW85_EOVERLAP and the first
/// pair; PW85_SUCCESS if there is none.
int find_first_overlap(Configuration const &configuration, std::int32_t *pair) noexcept;

/// A simulation: its model and the trials of many particles.
struct Engine : Model {
    Sweeps sweeps{*this};
    VolumeMoves volume_moves{*this};

    Engine() noexcept; // not inline, as that of RetiredArrays
    ~Engine();

    /// Finds the images whose bounding boxes meet that of a particle, ordered by particles and
    /// multiples. Returns a status.
    int find_neighbors(std::size_t particle, Array<NearImage> &found) noexcept;

    /// Returns whether a particle is free at another place. If so and if `take`, it stays there.
    /// Returns a status.
    int try_placement(std::size_t particle, Particle const &moved, bool take,
                      bool &is_free) noexcept;

    /// As find_first_overlap(); then the first particle that a wall cuts, and -1.
    int check(std::int32_t *pair) const noexcept;
};

} // namespace pw85::detail::simulation

#endif
