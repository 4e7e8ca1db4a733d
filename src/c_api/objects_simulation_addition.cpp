// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_addition.h.
//
// Made from pw85_simulation_addition.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_random_addition_create(int dimensions, double const cell[9], size_t num_kinds,
                                double const *semi_axes, size_t seed,
                                pw85_random_addition **addition)
{
    mark(addition, 1, nullptr);
    auto const work = [&] { return random_addition_create(dimensions, cell, num_kinds, semi_axes,
                                                          seed, *addition); };
    return checked_call("pw85_random_addition_create", work, Argument("cell", cell, 9),
                        Argument::rows("semi_axes", semi_axes, num_kinds, 3, limit::positive),
                        Argument("addition", addition));
}

int pw85_random_addition_advance(pw85_random_addition *addition, double attempts,
                                 size_t num_particles, int *end)
{
    mark(end, 1, -1);
    auto const work = [&] { return random_addition_advance(*addition, attempts, num_particles,
                                                           end); };
    return checked_call("pw85_random_addition_advance", work, Argument("addition", addition),
                        Argument("attempts", attempts, limit::positive | limit::may_be_infinite),
                        Argument("end", end));
}

int pw85_random_addition_state(pw85_random_addition const *addition, size_t *num_particles,
                               double *attempts, double *free_share)
{
    mark(num_particles, 1, 0);
    mark(attempts, 1, quiet_nan<double>());
    mark(free_share, 1, quiet_nan<double>());
    auto const work = [&] { return random_addition_state(*addition, num_particles, attempts,
                                                         free_share); };
    return checked_call("pw85_random_addition_state", work, Argument("addition", addition),
                        Argument("num_particles", num_particles), Argument("attempts", attempts),
                        Argument("free_share", free_share));
}

int pw85_random_addition_particles(pw85_random_addition const *addition, size_t num_particles,
                                   double *centers, double *quaternions, int32_t *kinds)
{
    auto const work = [&] { return random_addition_particles(*addition, num_particles, centers,
                                                             quaternions, kinds); };
    return checked_call("pw85_random_addition_particles", work, Argument("addition", addition),
                        Argument::array("centers", centers, num_particles));
}
