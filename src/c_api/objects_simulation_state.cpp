// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_state.h.
//
// Made from pw85_simulation_state.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes,
                                double const *quaternions, size_t seed, int32_t pair[2],
                                pw85_hard_ellipsoids **simulation)
{
    auto const system_given = value_or_empty(system);
    mark(pair, 2, -1);
    mark(simulation, 1, nullptr);
    auto const work = [&] { return hard_ellipsoids_create(*system, semi_axes, quaternions, seed,
                                                          pair, *simulation); };
    return checked_call(
        "pw85_hard_ellipsoids_create", work, Argument("system", system),
        Argument::rows("centers", system_given.centers, system_given.num_particles, 3),
        Argument::rows("semi_axes", semi_axes, system_given.num_particles, 3, limit::positive | limit::finite_square),
        Argument::rows("quaternions", quaternions, system_given.num_particles, 4, limit::not_zero),
        Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids *simulation, int dimensions)
{
    auto const work = [&] { return hard_ellipsoids_set_dimensions(*simulation, dimensions); };
    return checked_call("pw85_hard_ellipsoids_set_dimensions", work,
                        Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_dimensions(pw85_hard_ellipsoids const *simulation, int *dimensions)
{
    mark(dimensions, 1, -1);
    auto const work = [&] { return hard_ellipsoids_dimensions(*simulation, dimensions); };
    return checked_call("pw85_hard_ellipsoids_dimensions", work, Argument("simulation", simulation),
                        Argument("dimensions", dimensions));
}

int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes,
                              unsigned char *bytes)
{
    auto const work = [&] { return hard_ellipsoids_save(*simulation, num_bytes, bytes); };
    return checked_call("pw85_hard_ellipsoids_save", work, Argument("simulation", simulation),
                        Argument::array("bytes", bytes, num_bytes));
}

int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                 pw85_hard_ellipsoids **simulation)
{
    mark(simulation, 1, nullptr);
    auto const work = [&] { return hard_ellipsoids_restore(num_bytes, bytes, *simulation); };
    return checked_call("pw85_hard_ellipsoids_restore", work,
                        Argument::array("bytes", bytes, num_bytes),
                        Argument("simulation", simulation));
}
