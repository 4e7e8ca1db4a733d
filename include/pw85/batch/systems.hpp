/// @file
/// Functions of systems of particles, with or without a periodic cell. batch.hpp includes this file, and the functions call the C
/// API. Functions whose only outputs are rows for the pairs of a list are in lists.hpp.
#ifndef PW85_BATCH_SYSTEMS_HPP_INCLUDED
#define PW85_BATCH_SYSTEMS_HPP_INCLUDED

#include <pw85/batch/lists.hpp>

namespace pw85 {

namespace detail {

static inline bool fits(std::size_t n, DerivativeSpans const &out) noexcept
{
    return fits(n, out.mu2) && fits(n, out.lambda) && fits(n, out.point) && fits(n, out.normal) && fits(n, out.d_r12) &&
           fits(n, out.d_rot1) && fits(n, out.d_rot2);
}

} // namespace detail

/// @name Systems
/// @{

/// first_contact() for the pairs of a neighbour list, and the next event of each particle: see pw85_first_contact_pairs().
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
    if (out.time.size() != n || motions.size() != num_particles || !detail::fits(num_particles, out.next) ||
        !detail::fits(num_particles, out.next_pair) || !detail::fit(list, particles))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = detail::in_c(list);
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_first_contact_pairs(&c_list, &system, detail::in_c(motions), end,
                                                            detail::in_c(out.time), detail::in_c(out.next),
                                                            detail::in_c(out.next_pair)));
}

/// Forces, torques and virial from the energies of pairs: see pw85_contact_forces_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param d_u one for each pair: the derivative of the energy with respect to μ²
/// @param derivatives from contact_derivatives_pairs()
/// @param[out] out the sums
/// @return Status::success, Status::invalid_argument
static inline StatusCode contact_forces_pairs(PairList const &list, Particles const &particles,
                                              std::span<double const> d_u, DerivativeSpans const &derivatives,
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
        &c_list, &system, d_u.data(), detail::in_c(derivatives.d_r12), detail::in_c(derivatives.d_rot1),
        detail::in_c(derivatives.d_rot2), detail::in_c(out.forces), detail::in_c(out.torques),
        reinterpret_cast<double *>(out.virial)));
}

/// The energy, forces, torques and virial of a law for the pairs of a neighbour list: see pw85_law_forces_pairs().
///
/// @param list,particles as for contact_pairs()
/// @param law the energy of a pair
/// @param[out] energy the sum of the energies
/// @param[out] out the sums
/// @return as for contact_pairs(); Status::invalid_argument also for a law whose parameters are not allowed; Status::out_of_memory
static inline StatusCode law_forces_pairs(PairList const &list, Particles const &particles, Law const &law,
                                          double &energy, ForceSpans const &out) noexcept
{
    std::size_t const num_particles = particles.centers.size();
    if (!detail::fit(list, particles) || !detail::fits(num_particles, out.forces) ||
        !detail::fits(num_particles, out.torques))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = detail::in_c(list);
    pw85_system const system = detail::in_c(particles);
    pw85_law const c_law = {law.kind, law.parameters.size(), law.parameters.data()};
    return static_cast<StatusCode>(pw85_law_forces_pairs(&c_list, &system, &c_law, &energy, detail::in_c(out.forces),
                                                         detail::in_c(out.torques),
                                                         reinterpret_cast<double *>(out.virial)));
}

/// overlap_any() for other particles of a system, given by their indices: see pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the first ellipsoid
/// @param indices indices of the others
/// @param particles the system
/// @param[out] any 1 or 0; -1 on error
/// @return as for overlap_any(); Status::invalid_argument also if nearest images do not decide
static inline StatusCode overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                             std::span<std::int32_t const> indices, Particles const &particles,
                                             int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size()) return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_overlap_any_indices(center.coordinates, q1.entries, &system, indices.size(),
                                                            indices.data(), nullptr, &any));
}

/// overlap_any() for given images of other particles of a system: see pw85_overlap_any_indices().
///
/// @param center,q1 centre and form of the first ellipsoid
/// @param indices indices of the others
/// @param images one for each of the others; none if there are no others
/// @param particles the system, in a cell
/// @param[out] any 1 or 0; -1 on error
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite
static inline StatusCode overlap_any_indices(Vector<double, 3> const &center, SymmetricMatrix<double, 3> const &q1,
                                             std::span<std::int32_t const> indices, std::span<Image const> images,
                                             Particles const &particles, int &any) noexcept
{
    any = -1;
    if (particles.centers.size() != particles.q.size() || images.size() != indices.size())
        return StatusCode::invalid_argument;
    constexpr Image none{}; // null would ask for all images
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_overlap_any_indices(center.coordinates, q1.entries, &system, indices.size(),
                                                            indices.data(),
                                                            images.empty() ? none.data() : images[0].data(), &any));
}

/// @}

/// @name Periodic cells
/// @{

/// A reduced cell of the same lattice. It can be passed in place of the cell, and needs less preparation: see pw85_cell_reduce().
///
/// @param cell rows are its vectors
/// @return the reduced cell; Status::invalid_argument for a cell that is singular or not finite
static inline ReducedCell cell_reduce(Cell const &cell) noexcept
{
    ReducedCell result;
    result.status =
        static_cast<StatusCode>(pw85_cell_reduce(detail::in_c(&cell), reinterpret_cast<double *>(&result.cell)));
    return result;
}

/// The nearest images of the pairs of a list: see pw85_nearest_images().
///
/// @param pairs indices of particles
/// @param particles centres and cell; forms may be left out
/// @param[out] r12 from the first to the image of the second, one for each pair, or none
/// @param[out] images multiples of the vectors of the cell, one row for each pair, or none
/// @return Status::success, or Status::invalid_argument, also for the first bad pair, whose rows are NaN and INT32_MIN
static inline StatusCode nearest_images(std::span<IndexPair const> pairs, Particles const &particles,
                                        std::span<Vector<double, 3>> r12, std::span<Image> images = {}) noexcept
{
    std::size_t const n = pairs.size();
    if (!detail::fits(n, r12) || !detail::fits(n, images) || !detail::fits(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(
        pw85_nearest_images(n, detail::in_c(pairs), &system, detail::in_c(r12), detail::in_c(images)));
}

/// The largest μ² up to which only nearest images count: see pw85_nearest_image_limit().
///
/// @param particles forms and cell; centres may be left out
/// @param[out] mu2 the limit; infinity if there are no particles
/// @return Status::success, Status::invalid_argument (also for a cell that is singular or not finite),
/// Status::not_positive_definite
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
