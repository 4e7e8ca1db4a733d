// SPDX-License-Identifier: BSD-3-Clause
// Largest changes of trials: see parameters.hpp.
#include "parameters.hpp"

#include <utility>

namespace pw85::detail::simulation {

namespace {

/// Returns the longest useful translation t. The longer t is, the more pairs the Verlet lists have,
/// which reach 3 t beyond two semi-axes l, and the sooner they are rebuilt. So t is at most l/2.
/// There are fewer than four particles in a cube of the edge 3 a/2, where a³ is the volume for each
/// particle. So at low density, t may be longer, as long as rows are within this cube: 2 (2 l + 3
/// t) <= 3 a/2. In two dimensions there are four particles in a square of the edge 2 a, where a² is
/// the area for each particle.
double longest_translation(Configuration const &all) noexcept
{
    double const longest = all.longest_semi_axis();
    if (!all.is_closed()) return 0.5 * longest;
    double const each = all.volume() / static_cast<double>(maximum<std::size_t>(1, all.size()));
    if (all.dimensions == 2)
        return maximum(0.5 * longest, (elementary::sqrt(each) - 2.0 * longest) / 3.0);
    return maximum(0.5 * longest, (0.75 * elementary::cbrt(each) - 2.0 * longest) / 3.0);
}

/// Let p be the share of n trials that was accepted. The logarithm of the step changes by g (p -
/// acceptance). If p falls by s where the logarithm grows by one, some 0.4, the step ends with a
/// variance of g p (1 - p)/(2 n s) of its logarithm, after 1/(g s) sweeps. So g is smaller for few
/// trials: the single trial of the volume scatters the step by 17 %, with a memory of 25 sweeps.
void adapt(double &step, std::int64_t trials, std::int64_t accepted, double acceptance,
           double largest) noexcept
{
    if (trials == 0 || largest == 0.0) return; // a step is > 0, also where none is of use
    double const n = static_cast<double>(trials), gain = minimum(1.0, 0.1 * elementary::sqrt(n));
    double const change = gain * (static_cast<double>(accepted) / n - acceptance);
    // Nearly the exponential, with the same bits everywhere.
    step = minimum(largest, step * ((2.0 + change) / (2.0 - change)));
}

/// Adapts a step to the trials of its own type and to those of both.
void adapt_to(Counts const &counts, Move move, double acceptance, double largest,
              double &step) noexcept
{
    adapt(step, counts.trials[move] + counts.trials[both],
          counts.accepted[move] + counts.accepted[both], acceptance, largest);
}

} // namespace

void Parameters::limit_translations(double longest) noexcept
{
    translation = minimum(translation, longest);
    for (std::size_t k = 0; k < species.size(); ++k)
        species[k].translation = minimum(species[k].translation, longest);
}

void Parameters::tune(Counts const &before, double acceptance, Configuration const &configuration,
                      ExternalPotential const &external) noexcept
{
    Counts others = counts;
    others.add(before, -1);
    double const longest = longest_translation(configuration);
    for (std::size_t k = 0; k < species.size(); ++k) {
        Counts const own = std::exchange(species_counts[k], Counts{});
        others.add(own, -1);
        adapt_to(own, Move::translation, acceptance,
                 external.shortened(longest, species[k].semi_axes), species[k].translation);
        adapt_to(own, Move::rotation, acceptance, 1.0, species[k].rotation);
    }
    double useful = external.mesh.exists() ? 0.0 : longest; // for any particle
    for (std::size_t i = 0; i < configuration.size() && useful < longest; ++i)
        useful = maximum(useful, external.shortened(longest, configuration.semi_axes[i]));
    adapt_to(others, Move::translation, acceptance, useful, translation);
    adapt_to(others, Move::rotation, acceptance, 1.0, rotation);
    adapt(volume, others.trials[Move::volume], others.accepted[Move::volume], acceptance, 0.5);
}

} // namespace pw85::detail::simulation
