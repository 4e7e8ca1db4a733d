// SPDX-License-Identifier: BSD-3-Clause
// The functions of sums of forces of the C API. They check the arguments of a call, and call
// forces.hpp and law_forces.hpp.
#include <pw85.h>
#include <pw85_systems.h>

#include "../base/c_arrays.hpp"
#include "../forces/forces.hpp"
#include "../forces/law_forces.hpp"
#include "../lists/arguments.hpp"
#include "../simd/lanes/laws.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

namespace {

/// Records what is wrong with a law, and returns the status.
[[gnu::cold, gnu::noinline]] int refuse_law(char const *function,
                                            MemberComplaint const &found) noexcept
{
    return refuse(PW85_EINVAL,
                  {0, function, found.member, found.text, 0, found.entry, found.value});
}

} // namespace

int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                              double const *d_u, double const *d_r12, double const *d_rot1,
                              double const *d_rot2, double *forces, double *torques, double *virial)
{
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_contact_forces_pairs", list, system);
    if (system->num_particles > max_rows) return refuse_size("pw85_contact_forces_pairs", *system);
    Images images;
    NeighborList rows{};
    if (list->num_pairs > 0) {
        bool const needs_r12 = forces != nullptr || virial != nullptr;
        bool const needs_rotations = torques != nullptr;
        if (any_null(d_u) || (needs_r12 && any_null(d_r12)) ||
            (needs_rotations && any_null(d_rot1, d_rot2)))
            return refuse_arrays("pw85_contact_forces_pairs", "num_pairs", list->num_pairs,
                                 NamedArray{"d_u", d_u},
                                 NamedArray{"d_r12", needs_r12 ? d_r12 : d_u},
                                 NamedArray{"d_rot1", needs_rotations ? d_rot1 : d_u},
                                 NamedArray{"d_rot2", needs_rotations ? d_rot2 : d_u});
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
    if (any_null(list) || any_null(system))
        return refuse_structs("pw85_law_forces_pairs", list, system);
    if (any_null(law))
        return refuse_call(PW85_EINVAL, "pw85_law_forces_pairs", Argument("law", law));
    if (system->num_particles > max_rows) return refuse_size("pw85_law_forces_pairs", *system);
    if (MemberComplaint const found = complaint_of(*law); found.text != nullptr)
        return refuse_law("pw85_law_forces_pairs", found);
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
