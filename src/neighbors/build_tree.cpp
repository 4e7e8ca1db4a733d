// SPDX-License-Identifier: BSD-3-Clause
// Builds the tree of build_tree.hpp. Two passes of order.hpp sort the particles: first into parts
// of the curve, then within each part.
#include "build_tree.hpp"

#include <atomic>

#include "order.hpp"

namespace pw85::detail::neighbors {

namespace {

/// A particle with its position on the curve.
struct KeyedParticle {
    std::uint64_t key;
    Box box;
    PlacedParticle particle;
};

KeyedParticle keyed_particle(BoxExtent const &extent, Periodicity const &lattice, std::uint64_t key,
                             std::size_t i) noexcept
{
    LatticeVector vector;
    lattice.reduce(extent.center, vector);
    return {key,
            lattice.wrapped(extent.center, extent.half_widths, vector.of_reduced),
            {static_cast<std::int32_t>(i), vector.of_cell}};
}

/// Computes the position of each particle on the curve.
bool find_keys(Array<BoxExtent> const &extents, Periodicity const &lattice, Box const &around,
               Array<std::uint64_t> &keys) noexcept
{
    if (!keys.resize(extents.size())) return false;
    for_parts(extents.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys[i] = key_of(lattice.wrapped(extents[i].center), around);
    });
    return true;
}

/// Sorts the particles into parts of the curve.
bool sort_into_parts(Array<BoxExtent> const &extents, Periodicity const &lattice, Box const &around,
                     Array<KeyedParticle> &particles, Partition &partition) noexcept
{
    Array<std::uint64_t> keys;
    if (!find_keys(extents, lattice, around, keys)) return false;
    if (!partition.prepare(keys) || !particles.resize(extents.size())) return false;
    partition.for_places(keys, [&](std::size_t i, std::size_t place) {
        particles[place] = keyed_particle(extents[i], lattice, keys[i], i);
    });
    return true;
}

/// Sorts the particles of one part, and stores them at the places from `begin` on.
bool store_part(KeyedParticle const *particles, std::size_t count, std::size_t begin, Tree &tree,
                Array<PlacedParticle> &placed) noexcept
{
    Array<KeyedIndex> sorted;
    if (!sorted.resize(count)) return false;
    for (std::size_t k = 0; k < count; ++k)
        sorted[k] = {particles[k].key, static_cast<std::int32_t>(k)};
    if (!sort(sorted)) return false;
    for (std::size_t k = 0; k < count; ++k) {
        KeyedParticle const &keyed = particles[sorted[k].index];
        tree.set(begin + k, keyed.box);
        placed[begin + k] = keyed.particle;
    }
    return true;
}

} // namespace

bool build_tree(Array<BoxExtent> const &extents, Periodicity const &lattice, Box const &around,
                Tree &tree, Array<PlacedParticle> &placed) noexcept
{
    Array<KeyedParticle> particles;
    Partition partition;
    if (!sort_into_parts(extents, lattice, around, particles, partition)) return false;
    if (!placed.resize(extents.size()) || !tree.resize(extents.size())) return false;
    std::atomic<bool> complete = true;
    for_tasks(partition.num_parts(), partition.num_parts() > 1, [&](std::size_t part) {
        std::size_t const begin = part > 0 ? partition.end(part - 1) : 0,
                          count = partition.end(part) - begin;
        if (!store_part(particles.data() + begin, count, begin, tree, placed)) complete = false;
    });
    if (complete) tree.enclose_levels();
    return complete;
}

} // namespace pw85::detail::neighbors
