// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// External potential of a simulation: walls, fields, and a potential of the
/// caller. hamiltonian.cpp asks for each trial, insertions.cpp for each insertion.
///
/// 1. The density of the states is that of hard particles times e^-U, in which U is the sum of the
///    energies of the particles, in the unit of k_B T. A trial that changes U by ΔU is rejected by
///    a wall, or with the probability 1 - min(1, e^-ΔU), before the overlap test. The random number
///    for that is drawn only if ΔU > 0. If the domain stops at this trial (model.hpp), it is
///    drawn again.
/// 2. An energy of infinity forbids a place. NaN, and minus infinity, are errors: the sweep stops,
///    and the simulation is in the state before it. So the potential does not have to be asked
///    twice.
/// 3. A saved state has walls and fields. The caller's potential is a function, so it must be set
///    again. Until then, trials are refused. The energy of the state was saved, and tells another
///    potential.
#ifndef PW85_SIMULATION_EXTERNAL_POTENTIAL_HPP_INCLUDED
#define PW85_SIMULATION_EXTERNAL_POTENTIAL_HPP_INCLUDED

#include <pw85_simulation.h>

#include "mesh_wall.hpp"

namespace pw85::detail::simulation {

/// Walls, fields and a potential of the caller.
class ExternalPotential {
  public:
    Array<pw85_wall> walls;
    Array<pw85_field> fields;
    MeshWall mesh;
    pw85_potential *potential = nullptr;
    void *context = nullptr;
    bool lacks_potential = false; ///< true if a restored simulation waits for its potential
    double saved_energy = 0.0;    ///< of the caller's potential in this state

    bool has_walls() const noexcept { return walls.size() > 0 || mesh.exists(); }
    bool has_energy() const noexcept { return fields.size() > 0 || potential != nullptr; }
    bool is_empty() const noexcept { return !has_walls() && !has_energy() && !lacks_potential; }

    /// Returns the status of an energy that is NaN.
    static int refuse_energy() noexcept;

    /// Returns a status: PW85_EPOTENTIAL if a restored simulation waits for its potential.
    int check_potential() const noexcept;

    /// Returns whether any wall or the mesh cuts a particle.
    bool cuts(Particle const &particle, int dimensions) const noexcept;

    /// Returns the longest translation of a particle of the given ones, which the mesh limits.
    [[gnu::always_inline]] double shortened(double translation,
                                            Vector3 const &semi_axes) const noexcept
    {
        return mesh.exists() ? minimum(translation, MeshWall::longest_step(semi_axes))
                             : translation;
    }

    /// Returns the energy of a particle. NaN is an error, which minus infinity becomes, too.
    double energy(std::size_t i, Particle const &particle, int dimensions) const noexcept;

    double energy_of_fields(Particle const &particle, int dimensions) const noexcept;
    double energy_of_potential(std::size_t i, Particle const &particle) const noexcept;

    /// Returns the sum of the energies of all particles, in their order.
    double energy(Configuration const &configuration) const noexcept;

    /// The part of the caller's potential, with the centres that place(i) returns.
    template <class Place> double energy_of_potential(Configuration const &configuration,
                                                      Place const &place) const noexcept
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < configuration.size() && potential != nullptr; ++i) {
            Particle particle = configuration.get(i);
            particle.center = place(i);
            sum += energy_of_potential(i, particle);
        }
        return sum;
    }

    double energy_of_potential(Configuration const &configuration) const noexcept
    {
        return energy_of_potential(configuration,
                                   [&](std::size_t i) { return configuration.centers[i]; });
    }

    /// Returns whether a configuration can have these walls and fields, and all its energies are
    /// finite. `overlap` becomes the first particle that a wall or the mesh cuts, and the wall or
    /// the triangle; it is left as it is if there is none.
    int check(Configuration const &configuration, std::int32_t *overlap) const noexcept;

  private:
    std::int32_t refuse_cut(Particle const &particle, int dimensions) const noexcept;
    int check_suited(Configuration const &configuration) const noexcept;
    int check_energies(Configuration const &configuration) const noexcept;
};

} // namespace pw85::detail::simulation

#endif
