// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The pairs of the threads of a device: rows of arrays, which a block of threads copies together
/// through its shared memory, and pairs of a neighbour list, which each thread loads.
#ifndef PW85_GPU_ROWS_HPP_INCLUDED
#define PW85_GPU_ROWS_HPP_INCLUDED

#include "../periodic/periodic_cell.hpp"
#include "../simd/rows.hpp"

namespace pw85::detail::gpu {

using Pairs = kernels::PairArrays<3>;
using Pair3 = Pair<double, 3>;

/// The number of threads of a block.
inline constexpr unsigned block_size = 128;

/// The shared memory of a block of threads, with one row for each pair of the block: 3, 6 and 6
/// numbers of r12, q1 and q2. All threads copy the rows together, and consecutive threads read
/// consecutive addresses. The five results of three numbers go back through the same rows. The
/// width 15 is odd, so threads that access their own rows use different memory banks.
struct Tile {
    static constexpr std::size_t width = 15;
    double numbers[width * block_size];

    PW85_MEMBER double *row(unsigned thread) noexcept { return numbers + width * thread; }
    PW85_MEMBER double const *row(unsigned thread) const noexcept
    {
        return numbers + width * thread;
    }
};

/// The share of one thread in copying `count` rows into the tile, at `offset` within its rows.
template <std::size_t columns>
PW85_FUNCTION inline void copy_to_tile(double const *from, Tile &tile, std::size_t offset,
                                       std::size_t count, unsigned thread) noexcept
{
    for (std::size_t k = thread; k < columns * count; k += block_size)
        tile.numbers[Tile::width * (k / columns) + offset + k % columns] = from[k];
}

/// The share of one thread in copying `count` rows of three numbers from the tile to `to`. It does
/// nothing if `to` is null.
PW85_FUNCTION inline void copy_from_tile(Tile const &tile, std::size_t offset, double *to,
                                         std::size_t count, unsigned thread) noexcept
{
    for (std::size_t k = thread; to != nullptr && k < 3 * count; k += block_size)
        to[k] = tile.numbers[Tile::width * (k / 3) + offset + k % 3];
}

PW85_FUNCTION inline Pair3 load(Pairs const &arrays, std::size_t index) noexcept
{
    return load_pairs<double>(arrays, &index);
}

/// The share of one thread in loading `count` pairs from `begin` on.
PW85_FUNCTION inline void load_tile(Tile &tile, Pairs const &arrays, std::size_t begin,
                                    std::size_t count, unsigned thread) noexcept
{
    Pairs const block = arrays.from(begin);
    copy_to_tile<3>(block.r12, tile, 0, count, thread);
    copy_to_tile<6>(block.q1, tile, 3, count, thread);
    copy_to_tile<6>(block.q2, tile, 9, count, thread);
}

PW85_FUNCTION inline Pair3 load(Tile const &tile, Pairs const &, std::size_t,
                                unsigned thread) noexcept
{
    double const *const row = tile.row(thread);
    return load(Pairs{row, row + 3, row + 9}, 0);
}

/// A neighbour list on the device. The cell and its lattice are passed by value, in `images`; the
/// pointers to them in `list` are null.
struct DeviceList {
    kernels::NeighborList list;
    std::uint32_t num_particles;
    kernels::Images images;

    PW85_MEMBER DeviceList from(std::size_t begin) const noexcept
    {
        DeviceList rest = *this;
        rest.list = list.from(begin);
        return rest;
    }
};

PW85_FUNCTION inline Pair3 pair_of_nan() noexcept
{
    double const nan = quiet_nan<double>();
    return {{nan, nan, nan}, {nan, nan, nan, nan, nan, nan}, {nan, nan, nan, nan, nan, nan}, nan};
}

/// Pair k of a list. The numbers are NaN if an index of the pair is out of range.
PW85_FUNCTION inline Pair3 load(DeviceList const &rows, std::size_t k) noexcept
{
    kernels::NeighborList list = rows.list;
    list.cell = rows.images.cell;
    list.lattice = rows.images.nearest ? &rows.images.lattice : nullptr;
    std::int32_t const *const pair = kernels::row_of(list.pairs, 2, k);
    auto const i = static_cast<std::uint32_t>(pair[0]), j = static_cast<std::uint32_t>(pair[1]);
    if (i >= rows.num_particles || j >= rows.num_particles) return pair_of_nan();
    return load_pairs<double>(list, &k);
}

/// The pairs of a list do not use the tile. Their particles may be anywhere in memory, so each
/// thread loads its own pair.
PW85_FUNCTION inline void load_tile(Tile &, DeviceList const &, std::size_t, std::size_t,
                                    unsigned) noexcept
{
}

PW85_FUNCTION inline Pair3 load(Tile const &, DeviceList const &list, std::size_t begin,
                                unsigned thread) noexcept
{
    return load(list, begin + thread);
}

} // namespace pw85::detail::gpu

#endif
