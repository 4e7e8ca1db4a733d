// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// First contacts and sums of forces over the pairs of a list. The functions call the C API.
/// Functions whose only outputs are rows for the pairs are in lists.hpp.
#ifndef PW85_SYSTEMS_SUMS_HPP_INCLUDED
#define PW85_SYSTEMS_SUMS_HPP_INCLUDED

#include <pw85/systems/calls.hpp>

namespace pw85 {

namespace detail {

static inline bool fits(std::size_t n, DerivativeSpans const &out) noexcept
{
    return fits(n, out.mu2) && fits(n, out.lambda) && fits(n, out.point) && fits(n, out.normal) &&
           fits(n, out.d_r12) && fits(n, out.d_rot1) && fits(n, out.d_rot2);
}

} // namespace detail

/// @name Sums over pairs
/// @{

/// first_contact() for the pairs of a neighbour list, and the next event of each particle: see
/// pw85_first_contact_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param motions one for each particle
/// @param end as for first_contact()
/// @param[out] out one time for each pair, and one event for each particle
/// @return as for contact_pairs(), or Status::no_convergence
static inline StatusCode first_contact_pairs(PairList const &list, Particles const &particles,
                                             std::span<Motion<double, 3> const> motions, double end,
                                             EventSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size(), num_particles = particles.centers.size();
    if (out.time.size() != n || motions.size() != num_particles ||
        !detail::fits(num_particles, out.next) || !detail::fits(num_particles, out.next_pair) ||
        !detail::fit(list, particles))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = detail::in_c(list);
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_first_contact_pairs(
        &c_list, &system, detail::in_c(motions), end, detail::in_c(out.time),
        detail::in_c(out.next), detail::in_c(out.next_pair)));
}

/// Forces, torques and virial from the energies of pairs: see pw85_contact_forces_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param d_u one for each pair: the derivative of the energy with respect to μ²
/// @param derivatives from contact_derivatives_pairs()
/// @param[out] out the sums
/// @return Status::success, Status::invalid_argument
static inline StatusCode contact_forces_pairs(PairList const &list, Particles const &particles,
                                              std::span<double const> d_u,
                                              DerivativeSpans const &derivatives,
                                              ForceSpans const &out) noexcept
{
    std::size_t const n = list.pairs.size(), num_particles = particles.centers.size();
    if (d_u.size() != n || !detail::fits(n, derivatives) || !detail::fits(n, list.images) ||
        !detail::fits(num_particles, particles.q) || !detail::fits(num_particles, out.forces) ||
        !detail::fits(num_particles, out.torques))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = detail::in_c(list);
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_contact_forces_pairs(
        &c_list, &system, d_u.data(), detail::in_c(derivatives.d_r12),
        detail::in_c(derivatives.d_rot1), detail::in_c(derivatives.d_rot2),
        detail::in_c(out.forces), detail::in_c(out.torques),
        reinterpret_cast<double *>(out.virial)));
}

/// Returns the energy, forces, torques and virial of a law for the pairs of a neighbour list: see
/// pw85_law_forces_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param law the energy of a pair
/// @param[out] energy the sum of the energies
/// @param[out] out the sums
/// @return as for contact_pairs(); Status::invalid_argument also for a law whose parameters are not
/// allowed; Status::out_of_memory
static inline StatusCode law_forces_pairs(PairList const &list, Particles const &particles,
                                          Law const &law, double &energy,
                                          ForceSpans const &out) noexcept
{
    std::size_t const num_particles = particles.centers.size();
    if (!detail::fit(list, particles) || !detail::fits(num_particles, out.forces) ||
        !detail::fits(num_particles, out.torques))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = detail::in_c(list);
    pw85_system const system = detail::in_c(particles);
    pw85_law const c_law = {law.kind, law.parameters.size(), law.parameters.data()};
    return static_cast<StatusCode>(
        pw85_law_forces_pairs(&c_list, &system, &c_law, &energy, detail::in_c(out.forces),
                              detail::in_c(out.torques), reinterpret_cast<double *>(out.virial)));
}

/// @}

} // namespace pw85

#endif
