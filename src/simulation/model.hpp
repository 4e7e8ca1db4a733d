// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What sweeps, trials of the volume and tests of single particles share: the particles, their
/// Verlet list, what acts on them, and trials as values.
#ifndef PW85_SIMULATION_MODEL_HPP_INCLUDED
#define PW85_SIMULATION_MODEL_HPP_INCLUDED

#include "hamiltonian.hpp"
#include "parameters.hpp"
#include "verlet_list.hpp"

namespace pw85::detail::simulation {

/// A trial: N places in memory, and the particles there if it is accepted.
template <std::size_t N> struct Trial {
    std::size_t places[N];
    Particle moved[N];
};

struct Model {
    Particles particles;
    Parameters parameters{};
    Hamiltonian hamiltonian;
    VerletList list;

    ~Model(); // not inline, as that of RetiredArrays

    /// Makes the copy of the particles, and the list, those of the present particles. Returns a
    /// status.
    int prepare() noexcept;

    /// Makes another list. Returns a status. On error there is no list.
    int rebuild_list() noexcept;

    /// Returns the skin of the list. One trial moves a particle by less than half of it.
    double skin() const noexcept;

    /// Sets the particle at a place, for a trial.
    [[gnu::always_inline]] void set(std::size_t place, Particle const &particle) noexcept
    {
        particles.set(place, particle);
        list.update(place, particles.copy());
    }

    /// Moves particles to their new positions, and back unless the trial is accepted.
    /// accept_energy(old) is called last.
    ///
    /// Decisions are those of the exact overlap test for the rounded separations. The list only
    /// saves work: an overlap that is found is certain, wherever the fixed boxes are. A trial that
    /// would be accepted, but leaves a fixed box, is `unlisted`. It is made again with another
    /// list. So the list does not influence the result.
    template <std::size_t N, class Overlaps, class AcceptEnergy>
    [[gnu::always_inline]] Outcome accept_or_revert(Trial<N> const &trial, Overlaps const &overlaps,
                                                    AcceptEnergy const &accept_energy) noexcept
    {
        Particle old[N];
        for (std::size_t k = 0; k < N; ++k) {
            old[k] = particles.copy().get(trial.places[k]);
            set(trial.places[k], trial.moved[k]);
        }
        Outcome outcome = Outcome::accepted;
        for (std::size_t k = 0; k < N && outcome != Outcome::rejected; ++k) {
            if (overlaps(trial.places[k]))
                outcome = Outcome::rejected;
            else if (!list.holds(trial.places[k], particles.copy()))
                outcome = Outcome::unlisted;
        }
        if (outcome == Outcome::accepted) outcome = accept_energy(old);
        for (std::size_t k = 0; k < N; ++k) {
            if (outcome == Outcome::accepted)
                particles.accept(trial.places[k]);
            else
                set(trial.places[k], old[k]);
        }
        return outcome;
    }
};

/// The scope in which sweeps and trials of the volume move particles. At its end the caller's
/// particles become those of the copy, whether or not all were successful.
class Session {
  public:
    [[gnu::always_inline]] explicit Session(Model &model) noexcept
        : status(model.prepare()), particles_(model.particles)
    {
    }

    [[gnu::always_inline]] ~Session() { particles_.commit(); }

    Session(Session const &) = delete;
    Session &operator=(Session const &) = delete;

    int const status; ///< of the copy and of its list

  private:
    Particles &particles_;
};

} // namespace pw85::detail::simulation

#endif
