// SPDX-License-Identifier: BSD-3-Clause
// Trials of the volume, and the test of a whole configuration: see engine.hpp.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "../neighbors/bounded_list.hpp"
#include "../rows/many_pairs.hpp"
#include "acceptance.hpp"
#include "engine.hpp"

namespace pw85::detail::simulation {

namespace {

/// Particles per block of a thread: each takes some hundred nanoseconds.
constexpr std::size_t block_of_particles = 256;

/// Computes the least μ² of all pairs whose bounding boxes meet, the ellipsoids scaled; infinity
/// without pairs. Returns a status.
int least_mu2_of_list(pw85_system const &system, double scale, double &mu2) noexcept
{
    mu2 = HUGE_VAL;
    pw85_neighbors *made = nullptr;
    if (int const status = neighbors::create_bounded_list(system, scale, 0.0, made)) return status;
    std::unique_ptr<pw85_neighbors, DestroyList> const owner(made);
    pw85_pair_list const list = pw85_neighbors_list(made);
    if (list.num_pairs == 0) return PW85_SUCCESS;
    Array<double> all;
    if (!all.resize(list.num_pairs)) return PW85_ENOMEM;
    int const status = pw85_contact_pairs(&list, &system, all.data(), nullptr);
    mu2 = *std::min_element(all.data(), all.data() + list.num_pairs);
    return status;
}

/// Computes the least μ² of all pairs, of which there is at least one. A list that is scaled by s
/// has all pairs with μ <= s.
int find_least_mu2(pw85_system const &system, double &mu2) noexcept
{
    for (double scale = 1.25;;
         scale = std::isfinite(mu2) ? (1.0 + 0x1p-50) * std::sqrt(mu2) : 2.0 * scale)
        if (int const status = least_mu2_of_list(system, scale, mu2);
            status != PW85_SUCCESS || mu2 <= scale * scale)
            return status;
}

} // namespace

int Engine::try_volume(double pressure, ChangeType type) noexcept
{
    if (int const status = external.check_potential()) return status;
    Stream stream(parameters.seed, parameters.step, 0);
    Change const change(type, parameters.volume, ordered_.dimensions, stream);
    double cost = pressure * ordered_.volume() * (change.determinant() - 1.0);
    if (external.potential != nullptr) {
        cost += energy_change(change);
        if (std::isnan(cost)) return ExternalPotential::refuse_energy();
    }
    ++parameters.step;
    ++parameters.counts.trials[volume];
    double const exponent = static_cast<double>(ordered_.size()) + 1.0;
    if (!accept(change.determinant(), exponent, cost, stream.uniform())) return PW85_SUCCESS;
    EnergySum const before = pair_energy.exists() ? energy_of_rows() : EnergySum{};
    Outcome outcome = Outcome::rejected;
    int const status = change_cell(
        change,
        [&] {
            if (!pair_energy.exists()) return Outcome::accepted;
            return acceptance_of_change(before, energy_of_rows(), stream);
        },
        outcome);
    if (status == PW85_SUCCESS && outcome == Outcome::failed) return PW85_EPOTENTIAL;
    parameters.counts.accepted[volume] += outcome == Outcome::accepted;
    if (outcome == Outcome::accepted) limit_translations(ordered_.longest_useful_translation());
    return status;
}

/// Returns the change of the energy of the caller's potential. That of the fields does not change,
/// because they are the same along all periodic vectors, or do not depend on the centres.
double Engine::energy_change(Change const &change) noexcept
{
    end();
    auto const &centers = configuration.centers;
    double const before =
        external.energy_of_potential(configuration, [&](std::size_t i) { return centers[i]; });
    return external.energy_of_potential(configuration, [&](std::size_t i) {
        return change.apply(centers[i]);
    }) - before;
}

/// Changes the cell and the centres unless particles overlap afterwards. A cell for which no rows
/// can be made, because it is too small or too skewed, is rejected like an overlap.
template <class Accept> int Engine::change_cell(Change const &change,
                                                Accept const &accept_energy_change,
                                                Outcome &outcome) noexcept
{
    outcome = Outcome::rejected;
    if (!old_centers_.resize(ordered_.size())) return PW85_ENOMEM;
    apply(change);
    if (!set_cell()) return undo(false);
    bool const rows_are_new = !all_within_skin(0.0);
    int const status = rows_are_new ? rebuild_list() : PW85_SUCCESS;
    if (status == PW85_SUCCESS && !any_overlaps()) outcome = accept_energy_change();
    if (outcome != Outcome::accepted) {
        int const undone = undo(rows_are_new);
        return status == PW85_ENOMEM ? status : undone;
    }
    std::fill_n(moved_.data(), moved_.size(), std::uint8_t{true});
    return PW85_SUCCESS;
}

// The factor 1/μ is rounded, and so are the centres, which may lead to overlaps. So the factor is
// enlarged by small steps until the exact test finds none. The factor 1 changes nothing.
int Engine::compress(bool take, double &factor) noexcept
{
    Cell const &cell = ordered_.cell;
    bool const is_repeated =
        cell.exists && (cell.periodic[0] || cell.periodic[1] || cell.periodic[2]);
    factor = 0.0;
    if (ordered_.size() < (is_repeated ? 1 : 2)) return PW85_SUCCESS;
    double mu2;
    if (int const status = find_least_mu2(ordered_.system(), mu2)) return status;
    Outcome outcome = Outcome::rejected;
    for (double margin = 0x1p-52; outcome != Outcome::accepted; margin *= 4.0) {
        factor = std::min(1.0, (1.0 + margin) / std::sqrt(mu2));
        if (factor == 1.0) return PW85_SUCCESS;
        if (int const status = change_cell(
                Change(factor, ordered_.dimensions), [] { return Outcome::accepted; }, outcome))
            return status;
    }
    if (!take) return undo(true);
    limit_translations(ordered_.longest_useful_translation());
    return PW85_SUCCESS;
}

/// Updates rows and boxes after a change of the cell. Returns false if it is singular.
bool Engine::set_cell() noexcept
{
    if (!neighborhood_.set_cell(ordered_.cell)) return false;
    refresh_boxes();
    return true;
}

void Engine::apply(Change const &change) noexcept
{
    old_cell_ = ordered_.cell;
    for (int k = 0; k < ordered_.dimensions; ++k) {
        double *const row = ordered_.cell.vectors + 3 * k;
        Vector3 const changed = change.apply({row[0], row[1], row[2]});
        std::copy_n(changed.coordinates, 3, row);
    }
    std::swap(ordered_.centers, old_centers_);
    for_all(ordered_.size(), [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i)
            ordered_.centers[i] = change.apply(old_centers_[i]);
        return Failure{0, PW85_SUCCESS};
    });
}

/// Reverts a change. Rows that were built for it may not be valid for the configuration before.
int Engine::undo(bool rows_are_new) noexcept
{
    ordered_.cell = old_cell_;
    std::swap(ordered_.centers, old_centers_);
    if (!set_cell()) return PW85_EINVAL;
    return rows_are_new && !all_within_skin(0.0) ? rebuild_list() : PW85_SUCCESS;
}

/// Returns whether any particles overlap, by the rows.
bool Engine::any_overlaps() const noexcept
{
    std::atomic<bool> found{false};
    for_all(
        ordered_.size(),
        [&](Range range) {
            for (std::size_t i = range.begin;
                 i < range.end && !found.load(std::memory_order_relaxed); ++i)
                if (overlaps(i, [i](std::size_t j) { return j >= i; }))
                    found.store(true, std::memory_order_relaxed);
            return Failure{0, PW85_SUCCESS};
        },
        block_of_particles);
    return found.load();
}

int Engine::check(std::int32_t *pair) const noexcept
{
    if (int const status = find_first_overlap(configuration, pair)) return status;
    for (std::size_t i = 0; i < configuration.size() && external.has_walls(); ++i)
        if (external.cuts(configuration.get(i), configuration.dimensions)) {
            if (pair != nullptr) pair[0] = static_cast<std::int32_t>(i);
            return PW85_EOVERLAP;
        }
    return PW85_SUCCESS;
}

int find_first_overlap(Configuration const &configuration, std::int32_t *pair) noexcept
{
    pw85_system const system = configuration.system();
    pw85_neighbors *made = nullptr;
    if (int const status = neighbors::create_bounded_list(system, 1.0, 0.0, made)) return status;
    std::unique_ptr<pw85_neighbors, DestroyList> const owner(made);
    pw85_pair_list const list = pw85_neighbors_list(made);
    auto const overlap = PW85_OF_PAIR(kernels::chosen(), overlap);
    Failure const first = for_blocks(list.num_pairs, [&](Range range) {
        for (std::size_t k = range.begin; k < range.end; ++k) {
            auto const i = static_cast<std::size_t>(list.pairs[2 * k]),
                       j = static_cast<std::size_t>(list.pairs[2 * k + 1]);
            Vector3 const r =
                configuration.separation(i, j, configuration.cell.translation(image_of(list, k)));
            int answer = 0;
            if (int const status = overlap(r.coordinates, configuration.q[i].entries,
                                           configuration.q[j].entries, &answer))
                return Failure{k, status};
            if (answer == 1) return Failure{k, PW85_EOVERLAP};
        }
        return Failure{0, PW85_SUCCESS};
    });
    if (pair != nullptr && first.status == PW85_EOVERLAP)
        std::copy_n(list.pairs + 2 * first.index, 2, pair);
    return first.status;
}

/// Returns the longest useful translation t. The longer t is, the more pairs the Verlet lists have,
/// which reach 3 t beyond two semi-axes l, and the sooner they are rebuilt. So t is at most l/2.
/// There are fewer than four particles in a cube of the edge 3 a/2, where a³ is the volume for each
/// particle. So at low density, t may be longer, as long as rows are within this cube: 2 (2 l + 3
/// t) <= 3 a/2. In two dimensions there are four particles in a square of the edge 2 a, where a² is
/// the area for each particle.
double Engine::longest_translation() const noexcept
{
    if (!ordered_.is_closed()) return 0.5 * longest_;
    double const each =
        ordered_.volume() / static_cast<double>(std::max<std::size_t>(1, ordered_.size()));
    if (ordered_.dimensions == 2)
        return std::max(0.5 * longest_, (std::sqrt(each) - 2.0 * longest_) / 3.0);
    double const a = std::cbrt(each);
    return std::max(0.5 * longest_, (0.75 * a - 2.0 * longest_) / 3.0);
}

/// Let p be the share of n trials that was accepted. The logarithm of the step changes by g (p -
/// acceptance). If p falls by s where the logarithm grows by one, some 0.4, the step ends with a
/// variance of g p (1 - p)/(2 n s) of its logarithm, after 1/(g s) sweeps. So g is smaller for few
/// trials: the single trial of the volume scatters the step by 17 %, with a memory of 25 sweeps.
void Engine::tune(Counts const &before, double acceptance) noexcept
{
    Counts others = parameters.counts;
    others.subtract(before);
    double const longest = longest_translation();
    auto const adapt = [&](double &step, Counts const &counts, Move first, Move second,
                           double largest) {
        std::int64_t trials = counts.trials[first], accepted = counts.accepted[first];
        if (second != first) {
            trials += counts.trials[second];
            accepted += counts.accepted[second];
        }
        if (trials == 0 || largest == 0.0) return; // a step is > 0, also where none is of use
        double const n = static_cast<double>(trials), gain = std::min(1.0, 0.1 * std::sqrt(n));
        double const change = gain * (static_cast<double>(accepted) / n - acceptance);
        // Nearly the exponential, with the same bits everywhere.
        step = std::min(largest, step * ((2.0 + change) / (2.0 - change)));
    };
    for (std::size_t k = 0; k < species.size(); ++k) {
        Counts const own = std::exchange(species_counts[k], Counts{});
        others.subtract(own);
        adapt(species[k].translation, own, Move::translation, both,
              external.shortened(longest, species[k].semi_axes));
        adapt(species[k].rotation, own, Move::rotation, both, 1.0);
    }
    double useful = external.mesh.exists() ? 0.0 : longest; // for any particle
    for (std::size_t i = 0; i < configuration.size() && useful < longest; ++i)
        useful = std::max(useful, external.shortened(longest, configuration.semi_axes[i]));
    adapt(parameters.translation, others, Move::translation, both, useful);
    adapt(parameters.rotation, others, Move::rotation, both, 1.0);
    adapt(parameters.volume, others, Move::volume, Move::volume, 0.5);
}

} // namespace pw85::detail::simulation
