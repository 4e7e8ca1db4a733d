// SPDX-License-Identifier: BSD-3-Clause
// The C API of the steps of trials, of their fractions and of their counts.
#include <cmath>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;
using pw85::detail::c_api::any_null;

namespace pw85::detail::simulation {

namespace {

/// Returns whether these can be the largest changes of trials. For negative steps, no list of
/// neighbours would ever hold.
bool are_steps(double translation, double rotation, double volume) noexcept
{
    return translation > 0.0 && std::isfinite(translation) && rotation > 0.0 && rotation <= 1.0 &&
           volume > 0.0 && volume <= 1.0;
}

/// Returns whether these can be counts, and have room for more.
bool are_counts(Counts const &counts) noexcept
{
    bool allowed = true;
    for (int k = 0; k < num_moves; ++k)
        allowed = allowed && counts.accepted[k] >= 0 && counts.accepted[k] <= counts.trials[k] &&
                  counts.trials[k] <= INT64_MAX / 2;
    return allowed;
}

} // namespace

bool are_species(Array<SpeciesSteps> const &species) noexcept
{
    bool allowed = species.size() <= max_species;
    for (std::size_t k = 0; k < species.size() && allowed; ++k) {
        allowed = are_steps(species[k].translation, species[k].rotation, 1.0) &&
                  is_finite(species[k].semi_axes);
        for (std::size_t j = 0; j < k; ++j)
            allowed = allowed && !species[j].has(species[k].semi_axes);
    }
    return allowed;
}

bool are_parameters(Parameters const &parameters) noexcept
{
    double sum = 0.0;
    for (double const fraction : parameters.fractions) {
        if (!(fraction >= 0.0)) return false;
        sum += fraction;
    }
    return absolute(sum - 1.0) <= 0x1p-48 && are_counts(parameters.counts) &&
           are_steps(parameters.translation, parameters.rotation, parameters.volume);
}

double most_useful_translation(Configuration const &configuration) noexcept
{
    if (!configuration.is_closed()) return HUGE_VAL;
    double longest = 0.0;
    for (int k = 0; k < configuration.dimensions; ++k)
        longest = std::max(longest, magnitude(configuration.cell.vector(k)));
    return longest;
}

} // namespace pw85::detail::simulation

int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation, double const fractions[4])
{
    if (any_null(simulation) || any_null(fractions)) return PW85_EINVAL;
    return in_default_environment([&] {
        double sum = 0.0;
        for (int k = 0; k < num_particle_moves; ++k) {
            if (!(fractions[k] >= 0.0)) return int{PW85_EINVAL};
            sum += fractions[k];
        }
        if (!(sum > 0.0) || !std::isfinite(sum)) return int{PW85_EINVAL};
        for (int k = 0; k < num_particle_moves; ++k)
            simulation->engine.parameters.fractions[k] = fractions[k] / sum;
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation, double const steps[3])
{
    if (any_null(simulation) || any_null(steps)) return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        if (!are_steps(steps[0], steps[1], steps[2]) ||
            steps[0] > most_useful_translation(engine.configuration))
            return int{PW85_EINVAL};
        engine.parameters.translation = steps[0];
        engine.parameters.rotation = steps[1];
        engine.parameters.volume = steps[2];
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3])
{
    if (any_null(simulation) || any_null(steps)) return c_api::null_pointer(steps, 3);
    Parameters const &parameters = simulation->engine.parameters;
    c_api::store(Vector3{parameters.translation, parameters.rotation, parameters.volume}, steps);
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                        double const *semi_axes, double const *steps)
{
    if (any_null(simulation) || num_kinds > max_species ||
        (num_kinds > 0 && any_null(semi_axes, steps)))
        return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        Array<SpeciesSteps> species;
        if (!species.resize(num_kinds)) return int{PW85_ENOMEM};
        double const longest = most_useful_translation(engine.configuration);
        for (std::size_t k = 0; k < num_kinds; ++k) {
            species[k] = {c_api::load_vector<3>(semi_axes + 3 * k), steps[2 * k], steps[2 * k + 1]};
            if (!(species[k].translation <= longest)) return int{PW85_EINVAL};
        }
        if (!are_species(species)) return int{PW85_EINVAL};
        engine.species = std::move(species);
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation, size_t num_kinds,
                                    double const *semi_axes, double *steps)
{
    if (any_null(simulation) || (num_kinds > 0 && any_null(semi_axes, steps))) {
        for (std::size_t k = 0; k < 2 * num_kinds && steps != nullptr; ++k)
            steps[k] = quiet_nan<double>();
        return PW85_EINVAL;
    }
    for (std::size_t k = 0; k < num_kinds; ++k) {
        SpeciesSteps const own =
            simulation->engine.steps_of(c_api::load_vector<3>(semi_axes + 3 * k));
        steps[2 * k] = own.translation;
        steps[2 * k + 1] = own.rotation;
    }
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                int64_t accepted[5])
{
    if (any_null(simulation)) {
        if (trials != nullptr) std::fill_n(trials, 5, -1);
        if (accepted != nullptr) std::fill_n(accepted, 5, -1);
        return PW85_EINVAL;
    }
    Counts const &counts = simulation->engine.parameters.counts;
    if (trials != nullptr) std::copy_n(counts.trials, 5, trials);
    if (accepted != nullptr) std::copy_n(counts.accepted, 5, accepted);
    return PW85_SUCCESS;
}
