// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Periodic cells and the images of particles, and one ellipsoid among the particles of a system.
/// The functions call the C API.
#ifndef PW85_SYSTEMS_PERIODIC_HPP_INCLUDED
#define PW85_SYSTEMS_PERIODIC_HPP_INCLUDED

#include <pw85/systems/calls.hpp>

namespace pw85 {

/// @name One ellipsoid in a system
/// @{

/// overlap_any() for other particles of a system, given by their indices: see
/// pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the first ellipsoid
/// @param indices indices of the others
/// @param particles the system
/// @param[out] any 1 or 0; -1 on error
/// @return as for overlap_any(); Status::invalid_argument also if nearest images do not decide
static inline StatusCode overlap_any_indices(Vector<double, 3> const &center,
                                             SymmetricMatrix<double, 3> const &q1,
                                             std::span<std::int32_t const> indices,
                                             Particles const &particles, int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size()) return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_overlap_any_indices(
        center.coordinates, q1.entries, &system, indices.size(), indices.data(), nullptr, &any));
}

/// overlap_any() for given images of other particles of a system: see pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the first ellipsoid
/// @param indices indices of the others
/// @param images one for each of the others; none if there are no others
/// @param particles the system, in a cell
/// @param[out] any 1 or 0; -1 on error
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite
static inline StatusCode overlap_any_indices(Vector<double, 3> const &center,
                                             SymmetricMatrix<double, 3> const &q1,
                                             std::span<std::int32_t const> indices,
                                             std::span<Image const> images,
                                             Particles const &particles, int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size() || images.size() != indices.size())
        return StatusCode::invalid_argument;
    constexpr Image none{}; // null would ask for all images
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_overlap_any_indices(
        center.coordinates, q1.entries, &system, indices.size(), indices.data(),
        images.empty() ? none.data() : images[0].data(), &any));
}

/// @}

/// @name Periodic cells
/// @{

// Made by api/committed.py: functions of Periodic cells
// clang-format off
/// Computes a reduced cell of a lattice: see pw85_cell_reduce().
///
/// @param cell rows are the vectors
/// @return the values, and Status::success or Status::invalid_argument
static inline ReducedCell cell_reduce(Cell const &cell) noexcept
{
    ReducedCell found{};
    found.status = static_cast<StatusCode>(pw85_cell_reduce(cell.front().coordinates,
                                                            found.cell.front().coordinates));
    return found;
}

/// Computes the nearest images that the functions of pair lists use if `images` is null: see
/// pw85_nearest_images().
///
/// @param pairs one for each pair: indices (i, j) of particles, from 0
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] r12 one for each pair, or empty: from particle i to the image of particle j; NaN for
/// a bad pair
/// @param[out] images one for each pair, or empty: multiples of the vectors of the cell, as given;
/// INT32_MIN for a bad pair
/// @return as for contact_batch(); a pair is bad if a centre is not finite, or if a requested
/// multiple is beyond 2³¹ - 1
static inline StatusCode nearest_images(std::span<IndexPair const> pairs,
                                        Particles const &particles,
                                        std::span<Vector<double, 3>> r12,
                                        std::span<std::array<std::int32_t, 3>> images = {}) noexcept
{
    if (!(detail::have_rows(particles.centers.size(), detail::optional(particles.q)) &&
        detail::have_rows(pairs.size(), r12, images))) return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_nearest_images(pairs.size(), detail::in_c(pairs),
                                                       &particles_in_c, detail::in_c(r12),
                                                       detail::in_c(images)));
}

/// Computes the limit of μ² below which an image of a pair of these particles is always the nearest
/// image: see pw85_nearest_image_limit().
///
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] mu2 the limit; infinity without particles
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite
static inline StatusCode nearest_image_limit(Particles const &particles, double &mu2) noexcept
{
    mu2 = detail::quiet_nan<double>();
    if (!detail::have_rows(particles.q.size(), detail::optional(particles.centers)))
        return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_nearest_image_limit(&particles_in_c, &mu2));
}
// clang-format on

/// @}

} // namespace pw85

#endif
