// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parameters of the trials of a simulation: types, largest changes, counts, and random numbers.
#ifndef PW85_SIMULATION_PARAMETERS_HPP_INCLUDED
#define PW85_SIMULATION_PARAMETERS_HPP_INCLUDED

#include <cstdint>

#include "external_potential.hpp"

namespace pw85::detail::simulation {

/// The types of trials, in the order of the C API: a translation by a point of a ball; a rotation
/// by the quaternion (1, v), in which v is a point of a ball and its negative belongs to the
/// reverse move; both; an exchange of the semi-axes of two particles of a domain; and a change of
/// the volume.
enum Move {
    translation,
    rotation,
    both,
    exchange,
    num_particle_moves,
    volume = num_particle_moves,
    num_moves
};

/// Trials and how many of them were accepted, by type.
struct Counts {
    std::int64_t trials[num_moves], accepted[num_moves];

    void count(Move move, bool is_accepted) noexcept
    {
        ++trials[move];
        accepted[move] += is_accepted;
    }

    void add(Counts const &other, int times = 1) noexcept
    {
        for (int k = 0; k < num_moves; ++k) {
            trials[k] += times * other.trials[k];
            accepted[k] += times * other.accepted[k];
        }
    }
};

/// The steps of particles with these semi-axes. Steps may depend on the semi-axes of the particle,
/// because a translation or a rotation does not change these.
struct SpeciesSteps {
    Vector3 semi_axes;
    double translation, rotation;
};

/// Maximum number of species with their own step sizes.
inline constexpr std::size_t max_species = 16;

/// Parameters of a simulation in addition to its particles.
struct Parameters {
    /// `step` counts sweeps, chains, and trials of the volume, of insertions and of removals: it
    /// selects the random numbers
    std::uint64_t seed, step;
    double translation, rotation, volume; ///< the largest changes of a trial
    double fractions[num_particle_moves]; ///< of the types of trials in a sweep; their sum is 1
    Counts counts;
    Array<SpeciesSteps> species;        ///< with steps of their own: at most max_species
    Counts species_counts[max_species]; ///< since tuning began

    /// The number of the species of a particle with steps of its own, or how many there are.
    [[gnu::always_inline]] std::size_t species_of(Vector3 const &semi_axes) const noexcept
    {
        std::size_t k = 0;
        while (k < species.size() && !are_equal(species[k].semi_axes, semi_axes)) ++k;
        return k;
    }

    /// Returns the steps of particles with these semi-axes.
    [[gnu::always_inline]] SpeciesSteps steps_of(Vector3 const &semi_axes) const noexcept
    {
        std::size_t const k = species_of(semi_axes);
        return k < species.size() ? species[k] : SpeciesSteps{semi_axes, translation, rotation};
    }

    /// Makes translations no longer than `longest`, because the cell has become smaller.
    void limit_translations(double longest) noexcept;

    /// Changes the largest changes of a trial towards an acceptance, by the counts since `before`,
    /// and those of the species.
    void tune(Counts const &before, double acceptance, Configuration const &configuration,
              ExternalPotential const &external) noexcept;
};

} // namespace pw85::detail::simulation

#endif
