// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All that acts on the particles of a simulation in addition to their hard cores, and whether
/// trials are accepted for it.
#ifndef PW85_SIMULATION_HAMILTONIAN_HPP_INCLUDED
#define PW85_SIMULATION_HAMILTONIAN_HPP_INCLUDED

#include <pw85/algebra/philox.hpp>

#include "../simd/power.hpp"
#include "external_potential.hpp"
#include "pair_energy.hpp"
#include "particles.hpp"

namespace pw85::detail::simulation {

/// Outcome of a trial. It has `failed` if its energy is NaN. It is `unlisted` if all would accept
/// it, but a particle would leave its fixed box of the Verlet list (model.hpp).
enum class Outcome { rejected, accepted, unlisted, failed };

/// Returns true with probability min(1, ratio^exponent e^-cost). The functions for x^y and e^x give
/// the same bits everywhere.
[[gnu::always_inline]] inline bool accept(double ratio, double exponent, double cost,
                                          double uniform) noexcept
{
    double const log = logarithm(Pack(ratio)).high[0], sum = exponent * log - cost;
    if (sum >= 0.0) return true;
    return sum > -700.0 && uniform < exponential(Doubled<Pack>(Pack(sum)))[0];
}

/// Walls, fields, a potential and a law of pairs. They change outside of sessions.
struct Hamiltonian {
    ExternalPotential external;
    PairEnergy pairs;

    /// Returns whether nothing but the hard cores acts on the particles.
    bool is_hard() const noexcept { return external.is_empty() && !pairs.exists(); }

    bool has_energy() const noexcept { return external.has_energy() || pairs.exists(); }

    /// Returns whether walls and the external energy accept that particles at some places become
    /// others.
    Outcome accept_external(Particles const &particles, std::span<std::size_t const> places,
                            Particle const *moved, Stream &stream) const noexcept;

    /// Computes the energy of a configuration, with that of the pairs by a list of neighbours of
    /// its own. Returns a status.
    int energy(Configuration const &all, double &sum) const noexcept;
};

/// Returns whether a change of the energy is accepted, in the unit of k_B T. The random number is
/// drawn only if it is needed.
Outcome accept_energy(double change, Stream &stream) noexcept;

/// Returns whether a change of the energy of pairs is accepted.
Outcome accept_energy(EnergySum const &before, EnergySum const &after, Stream &stream) noexcept;

} // namespace pw85::detail::simulation

#endif
