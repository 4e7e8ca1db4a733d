// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Code that the C functions of simulations share. hard_ellipsoids*.cpp define these functions.
#ifndef PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED
#define PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED

#include <pw85_simulation.h>

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

/// A particle from its numbers, whose quaternion has the length one. Returns a status.
[[gnu::always_inline]] inline int make_particle(Vector3 const &center, Quaternion const &quaternion,
                                                Vector3 const &semi_axes,
                                                Particle &particle) noexcept
{
    if (!is_finite(center) || ellipsoid_quaternion(semi_axes, quaternion).status != Status::success)
        return PW85_EINVAL;
    particle = {center, quaternion, semi_axes, {}, {}};
    return particle.shape() ? PW85_SUCCESS : PW85_ENOTPD;
}

/// Returns whether these can be the steps of species, all different.
bool are_species(Array<SpeciesSteps> const &species) noexcept;

/// Returns whether a simulation can have these parameters. The sum of the fractions is 1 up to
/// rounding errors.
bool are_parameters(Parameters const &parameters) noexcept;

/// The longest translation that is of use: a longer one leads to places that shorter ones reach,
/// too.
double most_useful_translation(Configuration const &configuration) noexcept;

} // namespace pw85::detail::simulation

#endif
