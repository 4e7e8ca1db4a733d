// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Neighbour lists for C++. They call the functions of the compiled library (link with pw85), and
/// their contracts are those of pw85_systems.h.
#ifndef PW85_SYSTEMS_NEIGHBORS_HPP_INCLUDED
#define PW85_SYSTEMS_NEIGHBORS_HPP_INCLUDED

#include <memory>

#include <pw85/systems/calls.hpp>

namespace pw85 {

/// Options that determine the pairs of a neighbour list; see pw85_neighbors_create().
struct NeighborOptions {
    double scale = 1.0; ///< scale factor of the ellipsoids
    double skin = 0.0;  ///< largest gap between the boxes of a pair
};

/// A neighbour list and its memory; it can be moved, not copied.
class Neighbors {
  public:
    /// An empty list, of no particles.
    Neighbors() noexcept = default;
    /// Takes ownership of a list of the C API, which may be null.
    [[gnu::always_inline]] explicit Neighbors(pw85_neighbors *list) noexcept : object_(list) {}

    /// Returns the pairs, with images if the list has a cell. They are valid as long as this object
    /// lives.
    [[gnu::always_inline]] PairList list() const noexcept
    {
        pw85_pair_list const list = pw85_neighbors_list(object_.get());
        return {{reinterpret_cast<IndexPair const *>(list.pairs), list.num_pairs},
                {reinterpret_cast<Image const *>(list.images),
                 list.images != nullptr ? list.num_pairs : 0}};
    }

    [[gnu::always_inline]] std::span<IndexPair const> pairs() const noexcept
    {
        return list().pairs;
    }

    /// Empty without a cell.
    [[gnu::always_inline]] std::span<Image const> images() const noexcept { return list().images; }

    [[gnu::always_inline]] pw85_neighbors const *get() const noexcept { return object_.get(); }

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_neighbors *object) const noexcept
        {
            pw85_neighbors_destroy(object);
        }
    };
    std::unique_ptr<pw85_neighbors, Destroy> object_;
};

// Made by api/committed.py: functions of Neighbour lists
// clang-format off
/// Makes a neighbour list: see pw85_neighbors_create().
///
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param options see NeighborOptions
/// @param[out] list empty on error
/// @return Status::success; Status::invalid_argument, also if an image is more than 2²⁹ vectors
/// away; Status::not_positive_definite; Status::out_of_memory. neighbors_check() returns the index
/// of the bad particle.
static inline StatusCode neighbors_create(Particles const &particles,
                                          NeighborOptions const &options, Neighbors &list) noexcept
{
    list = Neighbors();
    if (!detail::have_rows(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    pw85_neighbors *made = nullptr;
    int const status = pw85_neighbors_create(&particles_in_c, options.scale, options.skin, &made);
    list = Neighbors(made);
    return static_cast<StatusCode>(status);
}

/// Finds the invalid particle after neighbors_create() has failed: see pw85_neighbors_check().
///
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param options see NeighborOptions
/// @param[out] particle index of the first bad particle: its centre or form is invalid, or it is
/// too far away; num_particles if there is none, 0 if `system` is null
/// @return the status that this particle causes; the status that another argument causes, with
/// `particle` = num_particles; or Status::success, if only the memory or the number of images can
/// be the cause
static inline StatusCode neighbors_check(Particles const &particles, NeighborOptions const &options,
                                         std::size_t &particle) noexcept
{
    particle = particles.centers.size();
    if (!detail::have_rows(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_neighbors_check(&particles_in_c, options.scale,
                                                        options.skin, &particle));
}

/// Tests whether a list still contains all pairs whose boxes intersect (without skin), after
/// particles have moved or rotated, or the cell has changed: see pw85_neighbors_holds().
///
/// @param list a list
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param[out] holds 1 or 0
/// @return Status::success; the status of the first bad particle; Status::invalid_argument, also if
/// only one of list and system has a cell, or if the two cells are periodic along different vectors
static inline StatusCode neighbors_holds(Neighbors const &list, Particles const &particles,
                                         int &holds) noexcept
{
    holds = -1;
    if (!detail::have_rows(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_neighbors_holds(list.get(), &particles_in_c, &holds));
}
// clang-format on

} // namespace pw85

#endif
