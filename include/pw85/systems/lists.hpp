// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Functions of the pairs of a list, in a system of particles: the functions of pw85_systems.h, on
/// spans.
#ifndef PW85_SYSTEMS_LISTS_HPP_INCLUDED
#define PW85_SYSTEMS_LISTS_HPP_INCLUDED

#include <pw85_systems.h>

#include <pw85/systems/calls.hpp>

namespace pw85 {

// Made by api/committed.py: pairs of pw85_systems.h
// clang-format off
/// @name Lists of pairs
/// @{

/// Computes the contact function of the pairs of a list: see pw85_contact_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] mu2 one for each pair
/// @param[out] lambda one for each pair, or empty
/// @return as for contact_batch()
static inline StatusCode contact_pairs(PairList const &list, Particles const &particles,
                                       std::span<double> mu2,
                                       std::span<double> lambda = {}) noexcept
{
    return detail::call_pairs(pw85_contact_pairs, list, particles, mu2, lambda);
}

/// Tests whether the pairs of a list overlap: see pw85_overlap_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contact_pairs()
static inline StatusCode overlap_pairs(PairList const &list, Particles const &particles,
                                       std::span<unsigned char> overlap) noexcept
{
    return detail::call_pairs(pw85_overlap_pairs, list, particles, overlap);
}

/// Computes the volumes of the intersections of the pairs of a list: see
/// pw85_overlap_volume_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] volume one for each pair
/// @return as for contact_pairs()
static inline StatusCode overlap_volume_pairs(PairList const &list, Particles const &particles,
                                              std::span<double> volume) noexcept
{
    return detail::call_pairs(pw85_overlap_volume_pairs, list, particles, volume);
}

/// Computes μ², its derivatives, points and normals for the pairs of a list: see
/// pw85_contact_derivatives_pairs().
///
/// @param list indices of particles, with or without images
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] out rows in all spans, or in some: see pw85_contact_derivatives_pairs()
/// @return as for contact_pairs()
static inline StatusCode contact_derivatives_pairs(PairList const &list, Particles const &particles,
                                                   DerivativeSpans const &out) noexcept
{
    return detail::call_pairs(pw85_contact_derivatives_pairs, list, particles, out.mu2, out.lambda,
                              out.point, out.normal, out.d_r12, out.d_rot1, out.d_rot2);
}

/// @}
// clang-format on

} // namespace pw85

#endif
