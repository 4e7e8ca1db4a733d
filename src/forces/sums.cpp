// SPDX-License-Identifier: BSD-3-Clause
// The functions of sums of forces of the C API. They check the arguments of a call, and call
// forces.hpp and law_forces.hpp.
#include <pw85.h>
#include <pw85_systems.h>

#include "../base/c_arrays.hpp"
#include "../lists/arguments.hpp"
#include "../rows/laws.hpp"
#include "forces.hpp"
#include "law_forces.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                              double const *d_u, double const *d_r12, double const *d_rot1,
                              double const *d_rot2, double *forces, double *torques, double *virial)
{
    if (any_null(list) || any_null(system) || system->num_particles > max_rows)
        return refuse_arrays("pw85_contact_forces_pairs");
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        if (any_null(d_u) || (forces != nullptr && any_null(d_r12)) ||
            (torques != nullptr && any_null(d_rot1, d_rot2)) ||
            (virial != nullptr && any_null(d_r12)))
            return refuse_arrays("pw85_contact_forces_pairs");
        if (int const status = prepare_list("pw85_contact_forces_pairs", *list,
                                            without_forms(*system), images, rows))
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
        return refuse_arrays("pw85_law_forces_pairs");
    if (!is_valid(*law)) return refuse_arrays("pw85_law_forces_pairs");
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0)
        if (int const status = prepare_list("pw85_law_forces_pairs", *list, *system, images, rows))
            return status;
    auto const sum = [&](auto const &one) {
        return sum_law(
            LawProblem<std::decay_t<decltype(one)>>{
                list->num_pairs, system->num_particles, rows, one, {forces, torques, virial}},
            energy);
    };
    return with_law(*law, sum);
}
