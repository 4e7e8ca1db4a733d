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
    [[gnu::always_inline]] explicit Neighbors(pw85_neighbors *list) noexcept : list_(list) {}

    /// Returns the pairs, with images if the list has a cell. They are valid as long as this object
    /// lives.
    [[gnu::always_inline]] PairList list() const noexcept
    {
        pw85_pair_list const list = pw85_neighbors_list(list_.get());
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

    [[gnu::always_inline]] pw85_neighbors const *get() const noexcept { return list_.get(); }

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_neighbors *list) const noexcept
        {
            pw85_neighbors_destroy(list);
        }
    };
    std::unique_ptr<pw85_neighbors, Destroy> list_;
};

/// Finds all pairs whose bounding boxes intersect: see pw85_neighbors_create().
///
/// @param particles with or without a cell, which may be periodic along some of its vectors
/// @param options which pairs to list
/// @param[out] list empty on error
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite,
/// Status::out_of_memory
static inline StatusCode neighbors_create(Particles const &particles,
                                          NeighborOptions const &options, Neighbors &list) noexcept
{
    list = Neighbors();
    if (particles.centers.size() != particles.q.size()) return StatusCode::invalid_argument;
    pw85_neighbors *made = nullptr;
    pw85_system const system = detail::in_c(particles);
    int const status = pw85_neighbors_create(&system, options.scale, options.skin, &made);
    list = Neighbors(made);
    return static_cast<StatusCode>(status);
}

/// Finds the particle because of which a list cannot be made: see pw85_neighbors_check().
///
/// @param particles,options as for neighbors_create()
/// @param[out] particle index of the first bad particle, or the number of particles if there is
/// none
/// @return the status of this particle or of the options, or Status::success
static inline StatusCode neighbors_check(Particles const &particles, NeighborOptions const &options,
                                         std::size_t &particle) noexcept
{
    particle = particles.centers.size();
    if (particles.centers.size() != particles.q.size()) return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(
        pw85_neighbors_check(&system, options.scale, options.skin, &particle));
}

/// Returns whether a list still has all pairs after particles or cell have changed: see
/// pw85_neighbors_holds().
///
/// @param list a list
/// @param particles the present positions and the present cell
/// @param[out] holds 1, 0, or -1 on error
/// @return Status::success, Status::invalid_argument, Status::not_positive_definite
static inline StatusCode neighbors_holds(Neighbors const &list, Particles const &particles,
                                         int &holds) noexcept
{
    holds = -1;
    if (particles.centers.size() != particles.q.size()) return StatusCode::invalid_argument;
    pw85_system const system = detail::in_c(particles);
    return static_cast<StatusCode>(pw85_neighbors_holds(list.get(), &system, &holds));
}

} // namespace pw85

#endif
