// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defines functions of lanes.hpp by compute_chunk() of the headers lane_*.hpp.
#ifndef PW85_SIMD_CHUNKS_HPP_INCLUDED
#define PW85_SIMD_CHUNKS_HPP_INCLUDED

#include "lane_overlap.hpp"
#include "lanes.hpp"

namespace pw85::detail::kernels {
namespace {

/// The number of pairs of a chunk.
template <class Rows, class Arrays> constexpr std::size_t chunk_size = contact_chunk_size;
template <class Rows> constexpr std::size_t chunk_size<Rows, OverlapArray> = overlap_chunk_size;
template <class Rows> constexpr std::size_t chunk_size<Rows, AreaArray> = overlap_chunk_size;
template <class Set, class Arrays> constexpr std::size_t chunk_size<SetRows<Set>, Arrays> = lanes;
template <class Set> constexpr std::size_t chunk_size<SetRows<Set>, OverlapArray> = lanes;

/// Computes chunk after chunk. It stops when there may be no room for the pairs that the next chunk
/// leaves over.
template <class Rows, class Arrays> std::size_t compute_chunks(Rows const &rows, std::size_t n,
                                                               Arrays const &out,
                                                               Worklist &rejected_lanes) noexcept
{
    constexpr std::size_t chunk = chunk_size<Rows, Arrays>,
                          last_begin = Worklist::largest_index + 1 - chunk;
    rejected_lanes.size = 0;
    std::size_t done = 0;
    while (done < n && done <= last_begin && rejected_lanes.size + chunk <= Worklist::capacity) {
        std::size_t const count = n - done < chunk ? n - done : chunk;
        // found by the namespace of Chunk
        compute_chunk(rows, Chunk{done, count, n}, out, rejected_lanes);
        done += count;
    }
    return done;
}

} // namespace
} // namespace pw85::detail::kernels

// Definitions of the functions, in the namespace of the target.
#define PW85_DEFINE_COMPUTE(Rows, Arrays)                                                          \
    [[gnu::flatten]] std::size_t compute(Rows const &rows, std::size_t n, Arrays const &out,       \
                                         Worklist &rejected_lanes) noexcept                        \
    {                                                                                              \
        return compute_chunks(rows, n, out, rejected_lanes);                                       \
    }
#define PW85_DEFINE_GATHER(Rows)                                                                   \
    void gather(Rows const &rows, std::uint16_t const *indices, std::size_t count,                 \
                PairRow<Rows::dimension> *pairs) noexcept                                          \
    {                                                                                              \
        detail::gather(rows, indices, count, pairs);                                               \
    }

#endif
