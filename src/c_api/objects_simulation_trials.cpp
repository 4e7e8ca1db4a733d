// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_trials.h.
//
// Made from pw85_simulation_trials.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps)
{
    auto const work = [&] { return hard_ellipsoids_sweep(*simulation, num_sweeps); };
    return checked_call("pw85_hard_ellipsoids_sweep", work, Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains, double length,
                               double const direction[3], double *compressibility)
{
    mark(compressibility, 1, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_chain(*simulation, num_chains, length, direction,
                                                         compressibility); };
    return checked_call("pw85_hard_ellipsoids_chain", work, Argument("simulation", simulation),
                        Argument("length", length, limit::positive),
                        Argument("direction", direction, 3, limit::not_zero | limit::optional));
}

int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                      double pressure, int change)
{
    auto const work = [&] { return hard_ellipsoids_volume_moves(*simulation, num_moves, pressure,
                                                                change); };
    return checked_call("pw85_hard_ellipsoids_volume_moves", work,
                        Argument("simulation", simulation), Argument("pressure", pressure));
}

int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                              double acceptance, double pressure, int change)
{
    auto const work = [&] { return hard_ellipsoids_tune(*simulation, num_sweeps, acceptance,
                                                        pressure, change); };
    return checked_call("pw85_hard_ellipsoids_tune", work, Argument("simulation", simulation),
                        Argument("acceptance", acceptance, limit::positive | limit::at_most_one),
                        Argument("pressure", pressure, limit::from_zero));
}

int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation, double const fractions[4])
{
    auto const work = [&] { return hard_ellipsoids_set_fractions(*simulation, fractions); };
    return checked_call("pw85_hard_ellipsoids_set_fractions", work,
                        Argument("simulation", simulation),
                        Argument("fractions", fractions, 4, limit::from_zero));
}

int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation, double const steps[3])
{
    auto const work = [&] { return hard_ellipsoids_set_steps(*simulation, steps); };
    return checked_call("pw85_hard_ellipsoids_set_steps", work, Argument("simulation", simulation),
                        Argument("steps", steps, 3, limit::positive));
}

int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3])
{
    mark(steps, 3, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_steps(*simulation, steps); };
    return checked_call("pw85_hard_ellipsoids_steps", work, Argument("simulation", simulation),
                        Argument("steps", steps));
}

int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                        double const *semi_axes, double const *steps)
{
    auto const work = [&] { return hard_ellipsoids_set_kind_steps(*simulation, num_kinds, semi_axes,
                                                                  steps); };
    return checked_call("pw85_hard_ellipsoids_set_kind_steps", work,
                        Argument("simulation", simulation),
                        Argument::rows("semi_axes", semi_axes, num_kinds, 3),
                        Argument::rows("steps", steps, num_kinds, 2, limit::positive));
}

int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation, size_t num_kinds,
                                    double const *semi_axes, double *steps)
{
    mark(steps, num_kinds * 2, quiet_nan<double>());
    auto const work = [&] { return hard_ellipsoids_kind_steps(*simulation, num_kinds, semi_axes,
                                                              steps); };
    return checked_call("pw85_hard_ellipsoids_kind_steps", work, Argument("simulation", simulation),
                        Argument::rows("semi_axes", semi_axes, num_kinds, 3),
                        Argument::array("steps", steps, num_kinds));
}

int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                int64_t accepted[5])
{
    mark(trials, 5, -1);
    mark(accepted, 5, -1);
    auto const work = [&] { return hard_ellipsoids_counts(*simulation, trials, accepted); };
    return checked_call("pw85_hard_ellipsoids_counts", work, Argument("simulation", simulation));
}
