// Particles are moved twice: to their part of space, and to their place within it.
#include "planting.hpp"

#include <atomic>

#include "order.hpp"

namespace pw85::detail::neighbors {

namespace {

/// A particle that looks for a place.
struct Settler {
    std::uint64_t key;
    Box box;
    Occupant occupant;
};

Settler settler(Extent const &extent, Periodicity const &lattice, std::uint64_t key, std::size_t i) noexcept
{
    Move move;
    lattice.reduce(extent.center, move);
    return {key,
            lattice.wrapped(extent.center, extent.half_widths, move.reduced),
            {static_cast<std::int32_t>(i), move.own}};
}

/// Positions on the curve.
bool find_keys(Array<Extent> const &extents, Periodicity const &lattice, Box const &around,
               Array<std::uint64_t> &keys) noexcept
{
    if (!keys.resize(extents.size())) return false;
    for_parts(extents.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) keys[i] = key_of(lattice.wrapped(extents[i].center), around);
    });
    return true;
}

/// The particles, each in its part of space.
bool gather(Array<Extent> const &extents, Periodicity const &lattice, Box const &around, Array<Settler> &settlers,
            Partition &partition) noexcept
{
    Array<std::uint64_t> keys;
    if (!find_keys(extents, lattice, around, keys)) return false;
    if (!partition.prepare(keys) || !settlers.resize(extents.size())) return false;
    partition.for_places(
        keys, [&](std::size_t i, std::size_t place) { settlers[place] = settler(extents[i], lattice, keys[i], i); });
    return true;
}

/// Gives the settlers of a part their places, from `begin` on.
bool settle(Settler const *settlers, std::size_t count, std::size_t begin, Tree &tree,
            Array<Occupant> &occupants) noexcept
{
    Array<Place> places;
    if (!places.resize(count)) return false;
    for (std::size_t k = 0; k < count; ++k) places[k] = {settlers[k].key, static_cast<std::int32_t>(k)};
    if (!sort(places)) return false;
    for (std::size_t k = 0; k < count; ++k) {
        Settler const &settler = settlers[places[k].index];
        tree.set(begin + k, settler.box);
        occupants[begin + k] = settler.occupant;
    }
    return true;
}

} // namespace

bool plant(Array<Extent> const &extents, Periodicity const &lattice, Box const &around, Tree &tree,
           Array<Occupant> &occupants) noexcept
{
    Array<Settler> settlers;
    Partition partition;
    if (!gather(extents, lattice, around, settlers, partition)) return false;
    if (!occupants.resize(extents.size()) || !tree.resize(extents.size())) return false;
    std::atomic<bool> complete = true;
    for_tasks(partition.num_parts(), partition.num_parts() > 1, [&](std::size_t part) {
        std::size_t const begin = part > 0 ? partition.end(part - 1) : 0, count = partition.end(part) - begin;
        if (!settle(settlers.data() + begin, count, begin, tree, occupants)) complete = false;
    });
    if (complete) tree.enclose_levels();
    return complete;
}

} // namespace pw85::detail::neighbors
