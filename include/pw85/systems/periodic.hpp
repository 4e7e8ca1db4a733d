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

/// Returns a reduced cell of the same lattice. It can be passed in place of the cell, and needs
/// less preparation: see pw85_cell_reduce().
///
/// @param cell rows are its vectors
/// @return the reduced cell; Status::invalid_argument for a cell that is singular or not finite
static inline ReducedCell cell_reduce(Cell const &cell) noexcept
{
    ReducedCell result;
    result.status = static_cast<StatusCode>(
        pw85_cell_reduce(detail::in_c(&cell), reinterpret_cast<double *>(&result.cell)));
    return result;
}

/// Returns the nearest images of the pairs of a list: see pw85_nearest_images().
///
/// @param pairs indices of particles
/// @param particles centres and cell; forms may be left out
/// @param[out] r12 from the first to the image of the second, one for each pair, or none
/// @param[out] images multiples of the vectors of the cell, one row for each pair, or none
/// @return Status::success, or Status::invalid_argument, also for the first bad pair, whose rows
/// are NaN and INT32_MIN
static inline StatusCode nearest_images(std::span<IndexPair const> pairs,
                                        Particles const &particles,
                                        std::span<Vector<double, 3>> r12,
                                        std::span<Image> images = {}) noexcept
{
    std::size_t const n = pairs.size();
    if (!detail::fits(n, r12) || !detail::fits(n, images) ||
        !detail::fits(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_nearest_images(n, detail::in_c(pairs), &system,
                                                       detail::in_c(r12), detail::in_c(images)));
}

/// Computes the largest μ² up to which only nearest images count: see pw85_nearest_image_limit().
///
/// @param particles forms and cell; centres may be left out
/// @param[out] mu2 the limit; infinity if there are no particles
/// @return Status::success, Status::invalid_argument (also for a cell that is singular or not
/// finite), Status::not_positive_definite
static inline StatusCode nearest_image_limit(Particles const &particles, double &mu2) noexcept
{
    mu2 = detail::quiet_nan<double>();
    if (!detail::fits(particles.q.size(), particles.centers)) return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_nearest_image_limit(&system, &mu2));
}

/// @}

} // namespace pw85

#endif
