// SPDX-License-Identifier: BSD-3-Clause
// Energies of pairs: see pair_energy.hpp.
#include "pair_energy.hpp"

#include <algorithm>

#include "../base/member_complaint.hpp"
#include "../neighbors/bounded_list.hpp"
#include "../rows/many_pairs.hpp"
#include "../simd/lanes/contact.hpp"
#include "neighborhood.hpp"

namespace pw85::detail::simulation {

namespace {

/// Number of the parameter that is the cutoff: μ² from which on the energy is 0.
std::size_t entry_of_cutoff(pw85_law const &law) noexcept
{
    return law.kind == PW85_LAW_TABLE ? 1 : 4;
}

/// Checks a law that pw85_law_forces_pairs() allows: whether it acts on pairs that do not overlap.
MemberComplaint of_cutoff(pw85_law const &law) noexcept
{
    std::size_t const k = entry_of_cutoff(law);
    if (law.parameters[k] > 1.0) return {};
    return {"parameters", "must have a cutoff above μ² = 1, where hard cores touch",
            law.parameters[k], k};
}

/// Returns a bound on the magnitude of the energy of pairs that do not overlap.
double bound_of(pw85_law const &law, kernels::InversePowers const &powers) noexcept
{
    double const *const x = law.parameters;
    if (law.kind == PW85_LAW_INVERSE_POWERS)
        return absolute(x[0]) + absolute(x[2]) + absolute(powers.shift);
    double largest = 0.0, steepest = 0.0;
    for (std::size_t k = 2; k < law.num_parameters; k += 2) {
        largest = maximum(largest, absolute(x[k]));
        steepest = maximum(steepest, absolute(x[k + 1]));
    }
    // A cubic polynomial of an interval leaves the values of its ends by less than this; and the
    // line before the first point begins at μ² = 1 at the earliest.
    return largest + steepest * (x[1] - minimum(1.0, x[0]));
}

int refuse_law(char const *requirement) noexcept
{
    return note_cause(PW85_EINVAL, "law", requirement);
}

} // namespace

int PairEnergy::set(pw85_law const *law) noexcept
{
    if (law == nullptr || law->kind == 0) {
        *this = PairEnergy();
        return PW85_SUCCESS;
    }
    if (law->kind == PW85_LAW_SOFT_REPULSION)
        return refuse_law("must not be a soft repulsion, which ends where the hard cores begin: "
                          "use inverse powers or a table");
    if (MemberComplaint const found = kernels::complaint_of(*law); found.text != nullptr)
        return note_complaint(found);
    if (MemberComplaint const found = of_cutoff(*law); found.text != nullptr)
        return note_complaint(found);
    double const *const x = law->parameters;
    PairEnergy made;
    if (law->kind == PW85_LAW_INVERSE_POWERS)
        made.powers_ = kernels::shifted({x[0], x[1], x[2], x[3], x[4], 0.0});
    if (!(bound_of(*law, made.powers_) <= largest))
        return refuse_law("must have energies of pairs of at most 2²⁰ k_B T");
    if (!made.parameters_.resize(law->num_parameters)) return PW85_ENOMEM;
    std::copy_n(x, law->num_parameters, made.parameters_.data());
    made.kind_ = law->kind;
    double const cutoff = x[entry_of_cutoff(*law)];
    if (cutoff > farthest * farthest) return refuse_law("must have a cutoff of at most 10⁶ in μ²");
    // The relative error of a root is below 2⁻⁵².
    made.reach_ = (1.0 + 0x1p-50) * elementary::sqrt(cutoff);
    *this = std::move(made);
    return PW85_SUCCESS;
}

EnergySum PairEnergy::of(double mu2, int count) const noexcept
{
    double energy;
    if (kind_ == PW85_LAW_INVERSE_POWERS) {
        energy = kernels::energy_of(powers_, mu2);
    } else {
        double const *const x = parameters_.data();
        energy = kernels::energy_of(
            kernels::LawTable{x[0], x[1], parameters_.size() / 2 - 2, x + 2}, mu2);
    }
    if (!(absolute(energy) <= 2.0 * largest)) return {0, true};
    constexpr double units = 0.5 / EnergySum::half_unit;
    return {count * static_cast<std::int64_t>(elementary::nearbyint(units * energy)), false};
}

// The contact function of a bad pair is NaN.
EnergySum PairEnergy::of_pairs(double const *r12, double const *q1, double const *q2,
                               int const *counts, std::size_t n) const noexcept
{
    double mu2[most_at_once];
    kernels::compute(kernels::chosen(), kernels::PairArrays<3>{r12, q1, q2}, n,
                     kernels::ContactArrays{mu2, nullptr});
    EnergySum sum;
    for (std::size_t k = 0; k < n; ++k) sum.add(of(mu2[k], counts[k]));
    return sum;
}

int PairEnergy::of_all(Configuration const &all, EnergySum &sum) const noexcept
{
    neighbors::BoundedList made;
    if (int const status = made.make(all.system(), reach_)) return status;
    pw85_pair_list const list = made.pairs();
    EnergyCollector pairs(*this);
    for (std::size_t k = 0; k < list.num_pairs; ++k) {
        auto const i = static_cast<std::size_t>(list.pairs[2 * k]),
                   j = static_cast<std::size_t>(list.pairs[2 * k + 1]);
        pairs.add(all.separation(i, j, all.cell.translation(image_of(list, k))), all.q[i], all.q[j],
                  2);
    }
    sum.add(pairs.sum());
    return PW85_SUCCESS;
}

int PairEnergy::virial_of_all(Configuration const &all, double &virial) const noexcept
{
    pw85_system const system = all.system();
    neighbors::BoundedList made;
    if (int const status = made.make(system, reach_)) return status;
    pw85_pair_list const list = made.pairs();
    pw85_law const own = law();
    double tensor[9];
    int const status =
        pw85_law_forces_pairs(&list, &system, &own, nullptr, nullptr, nullptr, tensor);
    virial = tensor[0] + tensor[4] + tensor[8];
    return status;
}

} // namespace pw85::detail::simulation
