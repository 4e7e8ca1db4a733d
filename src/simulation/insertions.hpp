// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insertions and removals of particles of a simulation. hard_ellipsoids_insertions.cpp offers them
/// in the C API.
///
/// 1. A particle is inserted at a point of the cell and with an orientation that are both uniformly
///    distributed. U is its energy, with that of its pairs with all others and with its own images.
///    w = e^-U, or 0 if it overlaps any other or a wall, and its mean over the states of N
///    particles is e^(-βμ_ex) (Widom 1963).
/// 2. The grand canonical target has the density Π_k z_k^N_k / N_k! e^-U of all configurations
///    without overlaps, with the activities z_k of the species: an ideal gas has ρ_k = z_k. A trial
///    chooses a species, and an insertion or a removal, all equally probable. Insertions are
///    accepted with the probability min(1, z V/(N + 1) e^-U), removals of a random particle of the
///    species with min(1, N/(z V) e^U). Here N is the number of particles of the species before the
///    trial, and V the volume of the cell. Along vectors that are not periodic, particles may leave
///    the cell. Such a particle is not removed, as none is inserted there.
/// 3. Decisions are those of the exact overlap test for the rounded separations, as in model.hpp.
///    Bins find the neighbours. Nothing depends on the state of the bins, so a saved state
///    continues bit by bit.
#ifndef PW85_SIMULATION_INSERTIONS_HPP_INCLUDED
#define PW85_SIMULATION_INSERTIONS_HPP_INCLUDED

#include "bins.hpp"
#include "model.hpp"

namespace pw85::detail::simulation {

/// Counts of insertions, accepted ones, removals, accepted ones.
struct InsertionCounts {
    std::int64_t insertions, inserted, removals, removed;
};

/// Particles of the same semi-axes.
struct Species {
    Vector3 semi_axes;
    double activity;
    std::size_t count; ///< particles of this species
};

class Insertions {
  public:
    explicit Insertions(Model &model) noexcept
        : particles_(model.particles), hamiltonian_(model.hamiltonian),
          parameters_(model.parameters)
    {
    }

    /// To be called after the configuration has changed in another way, and after `more` particles
    /// were added. Returns a status.
    int prepare(std::size_t more) noexcept;

    /// Returns whether a particle would be free of all others, of its own images, and of walls.
    /// Returns a status.
    int test(Particle const &particle, bool &is_free) noexcept;

    /// e^-U of a particle at random, or 0 if it is not free. Returns a status.
    int try_weight(Vector3 const &semi_axes, double &weight) noexcept;

    /// Makes a trial of 2. Returns a status; on error nothing changes.
    int try_exchange(std::span<Species> species, InsertionCounts &counts) noexcept;

  private:
    bool draw(Stream &stream, Vector3 const &semi_axes, Particle &particle) const noexcept;
    int try_insertion(Species &species, Stream &stream, InsertionCounts &counts) noexcept;
    int try_removal(Species &species, Stream &stream, InsertionCounts &counts) noexcept;
    int add(Particle const &particle) noexcept;
    void remove(std::size_t i) noexcept;
    int add_pair_energy(Particle const &particle, std::size_t skipped, double &energy) noexcept;
    bool overlaps_others(Particle const &particle) const noexcept;
    double longest_axis(Particle const &particle) const noexcept;
    int list_own_images(double reach) noexcept;
    int test_images(Particle const &particle, bool &is_free) noexcept;

    Particles &particles_;
    Hamiltonian const &hamiltonian_;
    Parameters &parameters_;
    Bins bins_;
    /// numbers_[i] is the number of particle i in the bins; behind them stand the free numbers
    Array<std::int32_t> numbers_;
    neighbors::Periodicity periodicity_;
    /// vectors of the lattice, one of each pair of opposite ones, and up to which length along each
    /// axis they are there
    Array<Vector3> own_images_;
    double listed_ = 0.0;
    double shortest_ = 0.0; ///< vector of the lattice
    double longest_ = 0.0;  ///< of all semi-axes
};

} // namespace pw85::detail::simulation

#endif
