// SPDX-License-Identifier: BSD-3-Clause
// Energies of trials and configurations: see hamiltonian.hpp.
#include "hamiltonian.hpp"

namespace pw85::detail::simulation {

Outcome accept_energy(double change, Stream &stream) noexcept
{
    if (elementary::isnan(change)) return Outcome::failed;
    if (change <= 0.0) return Outcome::accepted;
    return accept(1.0, 0.0, change, stream.uniform()) ? Outcome::accepted : Outcome::rejected;
}

Outcome accept_energy(EnergySum const &before, EnergySum const &after, Stream &stream) noexcept
{
    if (before.is_bad || after.is_bad) return Outcome::failed;
    return accept_energy(EnergySum{after.halves - before.halves}.energy(), stream);
}

Outcome Hamiltonian::accept_external(Particles const &particles,
                                     std::span<std::size_t const> places, Particle const *moved,
                                     Stream &stream) const noexcept
{
    Configuration const &all = particles.copy();
    for (std::size_t k = 0; k < places.size(); ++k)
        if (external.cuts(moved[k], all.dimensions)) return Outcome::rejected;
    if (!external.has_energy()) return Outcome::accepted;
    double change = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        auto const number = static_cast<std::size_t>(particles.order().particle(places[k]));
        change += external.energy(number, moved[k], all.dimensions) -
                  external.energy(number, all.get(places[k]), all.dimensions);
    }
    return accept_energy(change, stream);
}

int Hamiltonian::energy(Configuration const &all, double &sum) const noexcept
{
    if (int const status = external.check_potential()) return status;
    sum = external.energy(all);
    if (elementary::isnan(sum)) return ExternalPotential::refuse_energy();
    if (!pairs.exists()) return PW85_SUCCESS;
    EnergySum of_pairs;
    if (int const status = pairs.of_all(all, of_pairs)) return status;
    sum += of_pairs.energy();
    return of_pairs.is_bad ? PW85_EPOTENTIAL : PW85_SUCCESS;
}

} // namespace pw85::detail::simulation
