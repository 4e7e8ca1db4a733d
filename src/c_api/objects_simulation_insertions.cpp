// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_insertions.h.
//
// Made from pw85_simulation_insertions.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle,
                             double const center[3], double const quaternion[4], int take,
                             int *is_free)
{
    mark(is_free, 1, -1);
    auto const work = [&] { return hard_ellipsoids_try(*simulation, particle, center, quaternion,
                                                       take, is_free); };
    return checked_call("pw85_hard_ellipsoids_try", work, Argument("simulation", simulation),
                        Argument("center", center, 3, limit::optional),
                        Argument("quaternion", quaternion, 4, limit::not_zero | limit::optional),
                        Argument("is_free", is_free));
}

int pw85_hard_ellipsoids_insert(pw85_hard_ellipsoids *simulation, double const center[3],
                                double const quaternion[4], double const semi_axes[3], int take,
                                int *is_free)
{
    mark(is_free, 1, -1);
    auto const work = [&] { return hard_ellipsoids_insert(*simulation, center, quaternion,
                                                          semi_axes, take, is_free); };
    return checked_call("pw85_hard_ellipsoids_insert", work, Argument("simulation", simulation),
                        Argument("center", center, 3),
                        Argument("quaternion", quaternion, 4, limit::not_zero),
                        Argument("semi_axes", semi_axes, 3, limit::positive),
                        Argument("is_free", is_free));
}

int pw85_hard_ellipsoids_remove(pw85_hard_ellipsoids *simulation, size_t particle)
{
    auto const work = [&] { return hard_ellipsoids_remove(*simulation, particle); };
    return checked_call("pw85_hard_ellipsoids_remove", work, Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids *simulation, size_t num_trials,
                                          double const semi_axes[3], double *weight)
{
    mark(weight, 1, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_insertion_weight(*simulation, num_trials,
                                                                    semi_axes, weight); };
    return checked_call("pw85_hard_ellipsoids_insertion_weight", work,
                        Argument("simulation", simulation),
                        Argument("semi_axes", semi_axes, 3, limit::positive),
                        Argument("weight", weight));
}

int pw85_hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                         size_t num_kinds, double const *semi_axes,
                                         double const *activities, int64_t counts[4])
{
    mark(counts, 4, -1);
    auto const work = [&] { return hard_ellipsoids_insertion_moves(*simulation, num_moves,
                                                                   num_kinds, semi_axes, activities,
                                                                   counts); };
    return checked_call("pw85_hard_ellipsoids_insertion_moves", work,
                        Argument("simulation", simulation),
                        Argument::rows("semi_axes", semi_axes, num_kinds, 3, limit::positive),
                        Argument::rows("activities", activities, num_kinds, 1, limit::positive));
}
