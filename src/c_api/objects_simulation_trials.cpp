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
    Argument const arguments[] = {
        {"simulation", simulation}};
    return checked_call("pw85_hard_ellipsoids_sweep", arguments, [&] {
        return hard_ellipsoids_sweep(*simulation, num_sweeps);
    });
}

int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains, double length,
                               double const direction[3], double *compressibility)
{
    mark(compressibility, 1, quiet_nan<double>());
    Argument const arguments[] = {
        {"simulation", simulation},
        {"length", length, limit::positive},
        {"direction", direction, 3, limit::not_zero | limit::optional}};
    return checked_call("pw85_hard_ellipsoids_chain", arguments, [&] {
        return hard_ellipsoids_chain(*simulation, num_chains, length, direction, compressibility);
    });
}

int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                      double pressure, int change)
{
    Argument const arguments[] = {
        {"simulation", simulation},
        {"pressure", pressure}};
    return checked_call("pw85_hard_ellipsoids_volume_moves", arguments, [&] {
        return hard_ellipsoids_volume_moves(*simulation, num_moves, pressure, change);
    });
}

int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                              double acceptance, double pressure, int change)
{
    Argument const arguments[] = {
        {"simulation", simulation},
        {"acceptance", acceptance, limit::positive | limit::at_most_one},
        {"pressure", pressure, limit::from_zero}};
    return checked_call("pw85_hard_ellipsoids_tune", arguments, [&] {
        return hard_ellipsoids_tune(*simulation, num_sweeps, acceptance, pressure, change);
    });
}

int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation, double const fractions[4])
{
    Argument const arguments[] = {
        {"simulation", simulation},
        {"fractions", fractions, 4, limit::from_zero}};
    return checked_call("pw85_hard_ellipsoids_set_fractions", arguments, [&] {
        return hard_ellipsoids_set_fractions(*simulation, fractions);
    });
}

int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation, double const steps[3])
{
    Argument const arguments[] = {
        {"simulation", simulation},
        {"steps", steps, 3, limit::positive}};
    return checked_call("pw85_hard_ellipsoids_set_steps", arguments, [&] {
        return hard_ellipsoids_set_steps(*simulation, steps);
    });
}

int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3])
{
    mark(steps, 3, quiet_nan<double>());
    Argument const arguments[] = {
        {"simulation", simulation},
        {"steps", steps}};
    return checked_call("pw85_hard_ellipsoids_steps", arguments, [&] {
        return hard_ellipsoids_steps(*simulation, steps);
    });
}

int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                        double const *semi_axes, double const *steps)
{
    Argument const arguments[] = {
        {"simulation", simulation},
        Argument::rows("semi_axes", semi_axes, num_kinds, 3),
        Argument::rows("steps", steps, num_kinds, 2, limit::positive)};
    return checked_call("pw85_hard_ellipsoids_set_kind_steps", arguments, [&] {
        return hard_ellipsoids_set_kind_steps(*simulation, num_kinds, semi_axes, steps);
    });
}

int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation, size_t num_kinds,
                                    double const *semi_axes, double *steps)
{
    mark(steps, num_kinds * 2, quiet_nan<double>());
    Argument const arguments[] = {
        {"simulation", simulation},
        Argument::rows("semi_axes", semi_axes, num_kinds, 3),
        Argument::array("steps", steps, num_kinds)};
    return checked_call("pw85_hard_ellipsoids_kind_steps", arguments, [&] {
        return hard_ellipsoids_kind_steps(*simulation, num_kinds, semi_axes, steps);
    });
}

int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                int64_t accepted[5])
{
    mark(trials, 5, -1);
    mark(accepted, 5, -1);
    Argument const arguments[] = {
        {"simulation", simulation}};
    return checked_call("pw85_hard_ellipsoids_counts", arguments, [&] {
        return hard_ellipsoids_counts(*simulation, trials, accepted);
    });
}
