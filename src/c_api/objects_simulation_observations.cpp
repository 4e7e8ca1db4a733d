// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_observations.h.
//
// Made from pw85_simulation_observations.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_hard_ellipsoids_energy(pw85_hard_ellipsoids const *simulation, double *energy)
{
    mark(energy, 1, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_energy(*simulation, energy); };
    return checked_call("pw85_hard_ellipsoids_energy", work, Argument("simulation", simulation),
                        Argument("energy", energy));
}

int pw85_hard_ellipsoids_law_virial(pw85_hard_ellipsoids const *simulation, double *virial)
{
    mark(virial, 1, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_law_virial(*simulation, virial); };
    return checked_call("pw85_hard_ellipsoids_law_virial", work, Argument("simulation", simulation),
                        Argument("virial", virial));
}

int pw85_hard_ellipsoids_neighbors(pw85_hard_ellipsoids *simulation, size_t particle,
                                   size_t capacity, size_t *count, int32_t *particles,
                                   int32_t *images, double *separations)
{
    mark(count, 1, 0);
    auto const work = [&] { return hard_ellipsoids_neighbors(*simulation, particle, capacity, count,
                                                             particles, images, separations); };
    return checked_call("pw85_hard_ellipsoids_neighbors", work, Argument("simulation", simulation),
                        Argument("count", count));
}

int pw85_hard_ellipsoids_check(pw85_hard_ellipsoids const *simulation, int32_t pair[2])
{
    mark(pair, 2, -1);
    auto const work = [&] { return hard_ellipsoids_check(*simulation, pair); };
    return checked_call("pw85_hard_ellipsoids_check", work, Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_compress(pw85_hard_ellipsoids *simulation, int take, double *factor)
{
    mark(factor, 1, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_compress(*simulation, take, factor); };
    return checked_call("pw85_hard_ellipsoids_compress", work, Argument("simulation", simulation),
                        Argument("factor", factor));
}
