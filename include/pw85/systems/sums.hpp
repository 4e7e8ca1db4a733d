// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// First contacts and sums of forces over the pairs of a list. The functions call the C API.
/// Functions whose only outputs are rows for the pairs are in lists.hpp.
#ifndef PW85_SYSTEMS_SUMS_HPP_INCLUDED
#define PW85_SYSTEMS_SUMS_HPP_INCLUDED

#include <pw85/systems/calls.hpp>

namespace pw85 {

/// @name Sums over pairs
/// @{

// Made by api/committed.py: functions of Lists of pairs
// clang-format off
/// Computes the forces, torques and virial of a pair energy U(μ²) by summing over the pairs: see
/// pw85_contact_forces_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param d_u one for each pair: dU/dμ²; if it is 0, the pair contributes nothing, even if its
/// derivatives are NaN
/// @param derivatives rows in all spans, or in some: see pw85_contact_forces_pairs()
/// @param[out] out rows in all spans, or in some: see pw85_contact_forces_pairs()
/// @return Status::success, also if a NaN in the input makes some of the sums NaN;
/// Status::invalid_argument as for contact_pairs(), before anything is written
static inline StatusCode contact_forces_pairs(PairList const &list, Particles const &particles,
                                              std::span<double const> d_u,
                                              DerivativeSpans const &derivatives,
                                              ForceSpans const &out) noexcept
{
    if (!(detail::have_rows(list.pairs.size(), detail::optional(list.images), d_u,
        derivatives.d_r12, derivatives.d_rot1, derivatives.d_rot2) &&
        detail::have_rows(particles.centers.size(), detail::optional(particles.q), out.forces,
        out.torques))) return StatusCode::invalid_argument;
    pw85_pair_list const list_in_c = detail::in_c(list);
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_contact_forces_pairs(&list_in_c, &particles_in_c,
                                                             detail::in_c(d_u),
                                                             detail::in_c(derivatives.d_r12),
                                                             detail::in_c(derivatives.d_rot1),
                                                             detail::in_c(derivatives.d_rot2),
                                                             detail::in_c(out.forces),
                                                             detail::in_c(out.torques),
                                                             detail::in_c(out.virial)));
}

/// Computes the total energy, the forces, the torques and the virial of the pairs of a list: see
/// pw85_law_forces_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param law the energy of a pair
/// @param[out] energy ΣU
/// @param[out] out rows in all spans, or in some: see pw85_law_forces_pairs()
/// @return as for contact_pairs(); sums to which a bad pair contributes are NaN.
/// Status::invalid_argument also for a kind or parameters that are not allowed;
/// Status::out_of_memory if one megabyte per thread cannot be allocated. In both cases nothing is
/// written.
static inline StatusCode law_forces_pairs(PairList const &list, Particles const &particles,
                                          Law const &law, double &energy,
                                          ForceSpans const &out) noexcept
{
    energy = detail::quiet_nan<double>();
    if (!(detail::have_rows(list.pairs.size(), detail::optional(list.images)) &&
        detail::have_rows(particles.centers.size(), particles.q, out.forces, out.torques)))
        return StatusCode::invalid_argument;
    pw85_pair_list const list_in_c = detail::in_c(list);
    pw85_system const particles_in_c = detail::in_c(particles);
    pw85_law const law_in_c = detail::in_c(law);
    return static_cast<StatusCode>(pw85_law_forces_pairs(&list_in_c, &particles_in_c, &law_in_c,
                                                         &energy, detail::in_c(out.forces),
                                                         detail::in_c(out.torques),
                                                         detail::in_c(out.virial)));
}

/// Computes the times of the first contacts of the pairs of a list, and the first contact of each
/// particle, for event-driven simulations: see pw85_first_contact_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param motions one for each particle
/// @param t_max the last time at which a contact counts; for all pairs; >= 0; may be infinite
/// @param[out] out rows in all spans, or in some: see pw85_first_contact_pairs()
/// @return as for contact_pairs(); Status::no_convergence as for first_contact()
static inline StatusCode first_contact_pairs(PairList const &list, Particles const &particles,
                                             std::span<Motion<double, 3> const> motions,
                                             double t_max, EventSpans const &out) noexcept
{
    if (!(detail::have_rows(list.pairs.size(), detail::optional(list.images), out.time) &&
        detail::have_rows(particles.centers.size(), particles.q, motions, out.next, out.next_pair)))
        return StatusCode::invalid_argument;
    pw85_pair_list const list_in_c = detail::in_c(list);
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_first_contact_pairs(&list_in_c, &particles_in_c,
                                                            detail::in_c(motions), t_max,
                                                            detail::in_c(out.time),
                                                            detail::in_c(out.next),
                                                            detail::in_c(out.next_pair)));
}
// clang-format on

/// @}

} // namespace pw85

#endif
