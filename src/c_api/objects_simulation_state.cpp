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
    mark(pair, 2, -1);
    mark(simulation, 1, nullptr);
    auto const system_given = value_or_empty(system);
    Argument const arguments[] = {
        {"system", system},
        Argument::rows("centers", system_given.centers, system_given.num_particles, 3),
        Argument::rows("semi_axes", semi_axes, system_given.num_particles, 3, limit::positive | limit::finite_square),
        Argument::rows("quaternions", quaternions, system_given.num_particles, 4, limit::not_zero),
        {"simulation", simulation}};
    return checked_call("pw85_hard_ellipsoids_create", arguments, [&] {
        return hard_ellipsoids_create(*system, semi_axes, quaternions, seed, pair, *simulation);
    });
}

int pw85_hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids *simulation, int dimensions)
{
    Argument const arguments[] = {
        {"simulation", simulation}};
    return checked_call("pw85_hard_ellipsoids_set_dimensions", arguments, [&] {
        return hard_ellipsoids_set_dimensions(*simulation, dimensions);
    });
}

int pw85_hard_ellipsoids_dimensions(pw85_hard_ellipsoids const *simulation, int *dimensions)
{
    mark(dimensions, 1, -1);
    Argument const arguments[] = {
        {"simulation", simulation},
        {"dimensions", dimensions}};
    return checked_call("pw85_hard_ellipsoids_dimensions", arguments, [&] {
        return hard_ellipsoids_dimensions(*simulation, dimensions);
    });
}

int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes,
                              unsigned char *bytes)
{
    Argument const arguments[] = {
        {"simulation", simulation},
        Argument::array("bytes", bytes, num_bytes)};
    return checked_call("pw85_hard_ellipsoids_save", arguments, [&] {
        return hard_ellipsoids_save(*simulation, num_bytes, bytes);
    });
}

int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                 pw85_hard_ellipsoids **simulation)
{
    mark(simulation, 1, nullptr);
    Argument const arguments[] = {
        Argument::array("bytes", bytes, num_bytes),
        {"simulation", simulation}};
    return checked_call("pw85_hard_ellipsoids_restore", arguments, [&] {
        return hard_ellipsoids_restore(num_bytes, bytes, *simulation);
    });
}
