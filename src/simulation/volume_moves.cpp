// SPDX-License-Identifier: BSD-3-Clause
// Trials of the volume: see volume_moves.hpp.
#include "volume_moves.hpp"

#include <algorithm>

#include "../neighbors/bounded_list.hpp"

namespace pw85::detail::simulation {

namespace {

/// Computes the least μ² of all pairs whose bounding boxes meet, the ellipsoids scaled; infinity
/// without pairs. Returns a status.
int least_mu2_of_list(pw85_system const &system, double scale, double &mu2) noexcept
{
    mu2 = infinity<double>();
    neighbors::BoundedList made;
    if (int const status = made.make(system, scale)) return status;
    pw85_pair_list const list = made.pairs();
    if (list.num_pairs == 0) return PW85_SUCCESS;
    Array<double> all;
    if (!all.resize(list.num_pairs)) return PW85_ENOMEM;
    int const status = pw85_contact_pairs(&list, &system, all.data(), nullptr);
    mu2 = *std::min_element(all.data(), all.data() + list.num_pairs);
    return status;
}

/// Copies centres, forms and cell in the unit of the longest semi-axis. pw85_contact_pairs() scales
/// the pairs of other units, which may change the last bits. Returns false without memory.
[[nodiscard]] bool copy_in_local_unit(Configuration const &all, Configuration &local) noexcept
{
    Unit const unit = unit_of(all.longest_semi_axis());
    if (!local.resize(all.size())) return false;
    local.cell = all.cell;
    for (double &x : local.cell.vectors) x = unit.to_local(x);
    for (std::size_t i = 0; i < all.size(); ++i) {
        local.centers[i] = unit.to_local(all.centers[i]);
        local.q[i] = unit.to_local(all.q[i]);
    }
    return true;
}

/// Computes the least μ² of all pairs, of which there is at least one. A list that is scaled by s
/// has all pairs with μ <= s.
int find_least_mu2(Configuration const &all, double &mu2) noexcept
{
    Configuration local;
    if (!copy_in_local_unit(all, local)) return PW85_ENOMEM;
    for (double scale = 1.25;;
         scale = elementary::isfinite(mu2) ? (1.0 + 0x1p-50) * elementary::sqrt(mu2) : 2.0 * scale)
        if (int const status = least_mu2_of_list(local.system(), scale, mu2);
            status != PW85_SUCCESS || mu2 <= scale * scale)
            return status;
}

} // namespace

int VolumeMoves::run(double pressure, ChangeType type) noexcept
{
    if (int const status = model_.hamiltonian.external.check_potential()) return status;
    Configuration const &all = model_.particles.copy();
    PairEnergy const &pairs = model_.hamiltonian.pairs;
    Stream stream(model_.parameters.seed, model_.parameters.step, 0);
    Change const change(type, model_.parameters.volume, all.dimensions, stream);
    double cost = pressure * all.volume() * (change.determinant() - 1.0);
    if (model_.hamiltonian.external.potential != nullptr) {
        cost += energy_change(change);
        if (elementary::isnan(cost)) return ExternalPotential::refuse_energy();
    }
    ++model_.parameters.step;
    ++model_.parameters.counts.trials[volume];
    double const exponent = static_cast<double>(all.size()) + 1.0;
    if (!accept(change.determinant(), exponent, cost, stream.uniform())) return PW85_SUCCESS;
    EnergySum const before = pairs.exists() ? model_.list.energy_of_all(all, pairs) : EnergySum{};
    Outcome outcome = Outcome::rejected;
    int const status = change_cell(
        change,
        [&] {
            return pairs.exists()
                       ? accept_energy(before, model_.list.energy_of_all(all, pairs), stream)
                       : Outcome::accepted;
        },
        outcome);
    if (status == PW85_SUCCESS && outcome == Outcome::failed) return PW85_EPOTENTIAL;
    if (outcome != Outcome::accepted) return status;
    ++model_.parameters.counts.accepted[volume];
    model_.parameters.limit_translations(all.longest_useful_translation());
    return status;
}

/// Returns the change of the energy of the caller's potential. That of the fields does not change,
/// because they are the same along all periodic vectors, or do not depend on the centres.
double VolumeMoves::energy_change(Change const &change) noexcept
{
    model_.particles.commit();
    Configuration const &all = model_.particles.all();
    ExternalPotential const &external = model_.hamiltonian.external;
    double const before = external.energy_of_potential(all);
    return external.energy_of_potential(all, [&](std::size_t i) {
        return change.apply(all.centers[i]);
    }) - before;
}

/// Changes the cell and the centres unless particles overlap afterwards. A cell for which no rows
/// can be made, because it is too small or too skewed, is rejected like an overlap.
template <class AcceptEnergy> int VolumeMoves::change_cell(Change const &change,
                                                           AcceptEnergy const &accept_energy,
                                                           Outcome &outcome) noexcept
{
    outcome = Outcome::rejected;
    if (!old_centers_.resize(model_.particles.copy().size())) return PW85_ENOMEM;
    prefer_huge_pages(old_centers_);
    apply(change);
    if (!model_.list.deform(model_.particles)) return revert(false);
    bool const list_is_new = !model_.list.holds_all(model_.particles.copy());
    int const status = list_is_new ? model_.rebuild_list() : int{PW85_SUCCESS};
    if (status == PW85_SUCCESS && !model_.list.any_overlaps(model_.particles.copy()))
        outcome = accept_energy();
    if (outcome != Outcome::accepted) {
        int const undone = revert(list_is_new);
        return status == PW85_ENOMEM ? status : undone;
    }
    model_.particles.accept_all();
    return PW85_SUCCESS;
}

void VolumeMoves::apply(Change const &change) noexcept
{
    Configuration const &all = model_.particles.copy();
    Cell cell = all.cell;
    for (int k = 0; k < all.dimensions; ++k)
        std::copy_n(change.apply(cell.vector(k)).coordinates, 3, cell.vectors + 3 * k);
    for_all(all.size(), [&](Range range) {
        for (std::size_t i = range.begin; i < range.end; ++i)
            old_centers_[i] = change.apply(all.centers[i]);
        return Failure{0, PW85_SUCCESS};
    });
    old_cell_ = cell;
    model_.particles.exchange_cell(old_cell_, old_centers_);
}

/// Reverts a change. A list that was rebuilt for it may not hold the particles before it.
int VolumeMoves::revert(bool list_is_new) noexcept
{
    model_.particles.exchange_cell(old_cell_, old_centers_);
    if (!model_.list.deform(model_.particles)) return PW85_EINVAL;
    return list_is_new && !model_.list.holds_all(model_.particles.copy()) ? model_.rebuild_list()
                                                                          : int{PW85_SUCCESS};
}

// The factor 1/μ is rounded, and so are the centres, which may lead to overlaps. So the factor is
// enlarged by small steps until the exact test finds none. The factor 1 changes nothing.
int VolumeMoves::compress(bool take, double &factor) noexcept
{
    Configuration const &all = model_.particles.copy();
    bool const is_repeated =
        all.cell.exists && (all.cell.periodic[0] || all.cell.periodic[1] || all.cell.periodic[2]);
    factor = 0.0;
    if (all.size() < (is_repeated ? 1 : 2)) return PW85_SUCCESS;
    double mu2;
    if (int const status = find_least_mu2(all, mu2)) return status;
    Outcome outcome = Outcome::rejected;
    for (double margin = 0x1p-52; outcome != Outcome::accepted; margin *= 4.0) {
        factor = minimum(1.0, (1.0 + margin) / elementary::sqrt(mu2));
        if (factor == 1.0) return PW85_SUCCESS;
        if (int const status = change_cell(
                Change(factor, all.dimensions), [] { return Outcome::accepted; }, outcome))
            return status;
    }
    if (!take) return revert(true);
    model_.parameters.limit_translations(all.longest_useful_translation());
    return PW85_SUCCESS;
}

} // namespace pw85::detail::simulation
