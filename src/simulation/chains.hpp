// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Event chains of hard ellipsoids, after Bernard, Krauth and Wilson, Event-chain Monte Carlo
/// algorithms for hard-sphere systems (2009), doi:10.1103/PhysRevE.80.056704. hard_ellipsoids.cpp
/// offers them in the C API.
///
/// A random particle moves along a direction d until it touches another one. Then that particle
/// moves along d, and so forth, until the sum of the paths is the length of the chain. There are no
/// rejections.
///
/// For a given direction and length, the chains from all configurations and all particles are a
/// bijection that keeps volumes: the chain along -d from the last particle leads back. So the
/// uniform distribution is stationary. If the direction is random, and opposite directions are
/// equally probable, chains are in detailed balance.
#ifndef PW85_SIMULATION_CHAINS_HPP_INCLUDED
#define PW85_SIMULATION_CHAINS_HPP_INCLUDED

#include "contact_search.hpp"
#include "pressure_sample.hpp"

namespace pw85::detail::simulation {

/// A chain that is to be run.
struct EventChain {
    std::size_t first; ///< the particle that moves first
    Vector3 direction; ///< of length one
    double length;     ///< the sum of the paths
};

class Chains {
  public:
    explicit Chains(Configuration &configuration) noexcept
        // The analyser does not follow the constructor of the search.
        // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject)
        : bodies_(configuration), search_(bodies_)
    {
    }

    /// Reads the configuration. Call it after anything else has changed the configuration. Returns
    /// a status.
    int prepare() noexcept { return bodies_.prepare(); }

    /// Runs a chain, and adds its contacts to a sample. Returns a status: PW85_ECONVERGENCE if the
    /// chain does not advance, because particles block each other within rounding errors.
    int run(EventChain const &chain, PressureSample &sample) noexcept;

    /// Returns whether a particle could touch its own image if it turned. Chains do not find such
    /// contacts: the images of a particle move with it. But such contacts contribute to the
    /// pressure.
    bool own_images_may_touch() const noexcept { return bodies_.own_images_may_touch(); }

  private:
    double advance(Stage const &stage, double digit) noexcept;

    ChainBodies bodies_;
    ContactSearch search_;
};

} // namespace pw85::detail::simulation

#endif
