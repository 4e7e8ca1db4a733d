// SPDX-License-Identifier: BSD-3-Clause
// The C API of the steps of trials, of their fractions and of their counts.
#include <algorithm>
#include <span>

#include "../base/c_arrays.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace pw85::detail::simulation {

namespace {

/// Returns a status, which says whether these can be the largest changes of trials: a translation,
/// a rotation and maybe a change of the volume. For negative steps, no list of neighbours would
/// ever hold.
int check_steps(std::span<double const> steps, Configuration const &configuration,
                std::size_t row = 0) noexcept
{
    for (double const step : steps)
        if (!(step > 0.0 && is_finite(step))) return PW85_EINVAL;
    for (std::size_t k = 1; k < steps.size(); ++k)
        if (steps[k] > 1.0)
            return note_cause(PW85_EINVAL, "steps", "must be at most 1", row, k, steps[k]);
    if (steps[0] <= configuration.longest_useful_translation()) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "steps", "must be at most the longest vector of the cell", row,
                      0, steps[0]);
}

/// Returns whether these can be counts, and are far from overflow.
bool are_counts(Counts const &counts) noexcept
{
    bool allowed = true;
    for (int k = 0; k < num_moves; ++k)
        allowed = allowed && counts.accepted[k] >= 0 && counts.accepted[k] <= counts.trials[k] &&
                  counts.trials[k] <= INT64_MAX / 2;
    return allowed;
}

} // namespace

int check_kinds(Array<SpeciesSteps> const &kinds, Configuration const &configuration) noexcept
{
    if (kinds.size() > max_species)
        return note_cause(PW85_EINVAL, "num_kinds", "must be at most 16");
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        double const steps[] = {kinds[k].translation, kinds[k].rotation};
        if (int const status = check_steps(steps, configuration, k)) return status;
        if (!is_finite(kinds[k].semi_axes)) return PW85_EINVAL;
        for (std::size_t j = 0; j < k; ++j)
            if (are_equal(kinds[j].semi_axes, kinds[k].semi_axes))
                return note_cause(PW85_EINVAL, "semi_axes", "must differ from those before", k);
    }
    return PW85_SUCCESS;
}

bool are_parameters(Parameters const &parameters, Configuration const &configuration) noexcept
{
    double sum = 0.0;
    for (double const fraction : parameters.fractions) {
        if (!(fraction >= 0.0)) return false;
        sum += fraction;
    }
    double const steps[] = {parameters.translation, parameters.rotation, parameters.volume};
    return absolute(sum - 1.0) <= 0x1p-48 && are_counts(parameters.counts) &&
           check_steps(steps, configuration) == PW85_SUCCESS;
}

} // namespace pw85::detail::simulation

int pw85::detail::hard_ellipsoids_set_fractions(pw85_hard_ellipsoids &simulation,
                                                double const fractions[4]) noexcept
{
    double sum = 0.0;
    for (int k = 0; k < num_particle_moves; ++k) sum += fractions[k];
    if (!(sum > 0.0) || !elementary::isfinite(sum))
        return note_cause(PW85_EINVAL, "fractions", "must have a sum that is > 0 and finite", 0, 0,
                          sum);
    for (int k = 0; k < num_particle_moves; ++k)
        simulation.engine.parameters.fractions[k] = fractions[k] / sum;
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_set_steps(pw85_hard_ellipsoids &simulation,
                                            double const steps[3]) noexcept
{
    Engine &engine = simulation.engine;
    if (int const status = check_steps({steps, 3}, engine.particles.all())) return status;
    engine.parameters.translation = steps[0];
    engine.parameters.rotation = steps[1];
    engine.parameters.volume = steps[2];
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_steps(pw85_hard_ellipsoids const &simulation,
                                        double steps[3]) noexcept
{
    Parameters const &parameters = simulation.engine.parameters;
    c_api::store(Vector3{parameters.translation, parameters.rotation, parameters.volume}, steps);
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids &simulation, size_t num_kinds,
                                                 double const *semi_axes,
                                                 double const *steps) noexcept
{
    Engine &engine = simulation.engine;
    if (num_kinds > max_species) return note_cause(PW85_EINVAL, "num_kinds", "must be at most 16");
    Array<SpeciesSteps> kinds;
    if (!kinds.resize(num_kinds)) return PW85_ENOMEM;
    for (std::size_t k = 0; k < num_kinds; ++k)
        kinds[k] = {c_api::load_vector<3>(semi_axes + 3 * k), steps[2 * k], steps[2 * k + 1]};
    if (int const status = check_kinds(kinds, engine.particles.all())) return status;
    engine.parameters.species = std::move(kinds);
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const &simulation,
                                             size_t num_kinds, double const *semi_axes,
                                             double *steps) noexcept
{
    for (std::size_t k = 0; k < num_kinds; ++k) {
        SpeciesSteps const own =
            simulation.engine.parameters.steps_of(c_api::load_vector<3>(semi_axes + 3 * k));
        steps[2 * k] = own.translation;
        steps[2 * k + 1] = own.rotation;
    }
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_counts(pw85_hard_ellipsoids const &simulation, int64_t trials[5],
                                         int64_t accepted[5]) noexcept
{
    Counts const &counts = simulation.engine.parameters.counts;
    if (trials != nullptr) std::copy_n(counts.trials, 5, trials);
    if (accepted != nullptr) std::copy_n(counts.accepted, 5, accepted);
    return PW85_SUCCESS;
}
