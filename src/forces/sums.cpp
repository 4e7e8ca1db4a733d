// SPDX-License-Identifier: BSD-3-Clause
// The functions of sums of forces of the C API. They check the arguments of a call, and call
// forces.hpp and law_forces.hpp.
#include <pw85.h>
#include <pw85_systems.h>

#include <cmath>

#include "../base/c_arrays.hpp"
#include "../lists/arguments.hpp"
#include "forces.hpp"
#include "law_forces.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

namespace {

/// Whether a law has the parameters of its kind, with values that the kind allows.
bool is_valid(pw85_law const &law) noexcept
{
    std::size_t const n = law.num_parameters;
    double const *const x = law.parameters;
    if (any_null(x) || n > max_rows ||
        !std::all_of(x, x + n, [](double number) { return std::isfinite(number); }))
        return false;
    switch (law.kind) {
    case PW85_LAW_SOFT_REPULSION:
        return n == 2 && x[1] >= 1.0;
    case PW85_LAW_INVERSE_POWERS:
        return n == 5 && x[1] > x[3] && x[3] > 0.0 && x[4] > 0.0;
    case PW85_LAW_TABLE:
        return n >= 6 && n % 2 == 0 && x[1] > x[0];
    default:
        return false;
    }
}

/// The law with the shift by which its energy at the cutoff is 0.
InversePowers shifted(InversePowers law) noexcept
{
    double d_u;
    InversePowers everywhere = law;
    everywhere.mu2_max = HUGE_VAL;
    in_default_environment([&] {
        law.shift = evaluate_of<InversePowers>(chosen())(everywhere, 1, &law.mu2_max, &d_u).energy;
    });
    return law;
}

} // namespace

int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                              double const *d_u, double const *d_r12, double const *d_rot1,
                              double const *d_rot2, double *forces, double *torques, double *virial)
{
    if (any_null(list) || any_null(system) || system->num_particles > max_rows) return PW85_EINVAL;
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        if (any_null(d_u) || (forces != nullptr && any_null(d_r12)) ||
            (torques != nullptr && any_null(d_rot1, d_rot2)) ||
            (virial != nullptr && any_null(d_r12)))
            return PW85_EINVAL;
        if (int const status = prepare_list(*list, without_forms(*system), images, rows))
            return status;
    }
    sum_forces({list->num_pairs, rows, d_u, d_r12, d_rot1, d_rot2}, system->num_particles,
               {forces, torques, virial});
    return PW85_SUCCESS;
}

int pw85_law_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                          pw85_law const *law, double *energy, double *forces, double *torques,
                          double *virial)
{
    if (any_null(list) || any_null(system) || any_null(law) || system->num_particles > max_rows)
        return PW85_EINVAL;
    if (!is_valid(*law)) return PW85_EINVAL;
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0)
        if (int const status = prepare_list(*list, *system, images, rows)) return status;
    auto const sum = [&](auto const &one) {
        return sum_law(
            LawProblem<std::decay_t<decltype(one)>>{
                list->num_pairs, system->num_particles, rows, one, {forces, torques, virial}},
            energy);
    };
    double const *const x = law->parameters;
    switch (law->kind) {
    case PW85_LAW_SOFT_REPULSION:
        return sum(SoftRepulsion{x[0], x[1]});
    case PW85_LAW_INVERSE_POWERS:
        return sum(shifted({x[0], x[1], x[2], x[3], x[4], 0.0}));
    default:
        return sum(LawTable{x[0], x[1], law->num_parameters / 2 - 2, x + 2});
    }
}
