// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Code that the C functions of simulations share. hard_ellipsoids*.cpp define the functions of
/// ../base/objects.hpp for them.
#ifndef PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED
#define PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED

#include <pw85_simulation.h>

#include "../base/last_error.hpp"
#include "../base/objects.hpp"
#include "engine.hpp"

struct pw85_hard_ellipsoids {
    pw85::detail::simulation::Engine engine;
};

namespace pw85::detail::simulation {

/// A vector or quaternion divided by its length.
template <class Coordinates>
[[gnu::always_inline]] inline Coordinates unit(Coordinates const &x) noexcept
{
    Coordinates const scaled = x / largest_coordinate(x);
    return scaled / magnitude(scaled);
}

/// Computes a particle from its numbers, whose quaternion has the length one. Returns a status.
[[gnu::always_inline]] inline int make_particle(Vector3 const &center, Quaternion const &quaternion,
                                                Vector3 const &semi_axes,
                                                Particle &particle) noexcept
{
    if (!is_finite(center) || ellipsoid_quaternion(semi_axes, quaternion).status != Status::success)
        return PW85_EINVAL;
    particle = {center, quaternion, semi_axes, {}, {}};
    if (particle.shape()) return PW85_SUCCESS;
    return note_cause(PW85_ENOTPD, "semi_axes", "must give a form that is positive definite");
}

/// Returns a status, which says whether there is such a particle.
[[gnu::always_inline]] inline int check_index(Engine const &engine, std::size_t particle) noexcept
{
    if (particle < engine.particles.all().size()) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "particle", "must be the index of a particle", 0, 0,
                      static_cast<double>(particle));
}

/// Returns a status, which says whether these can be the steps of kinds, all different, in a
/// configuration.
int check_kinds(Array<SpeciesSteps> const &kinds, Configuration const &configuration) noexcept;

/// Returns whether a simulation of a configuration can have these parameters. The sum of the
/// fractions is 1 up to rounding errors.
bool are_parameters(Parameters const &parameters, Configuration const &configuration) noexcept;

} // namespace pw85::detail::simulation

#endif
