// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The loops over the chunks, packs and steps of a kernel. Each source of this folder includes this
/// file first, and is compiled once per instruction set.
///
/// A header of this folder is one question: its rows and arrays, the kernel compute_chunk(), and
/// scalar_fallback() for rows that the kernel leaves over. Sources that include this file first get
/// the kernel, and define it by PW85_KERNEL(rows, arrays). Others get scalar_fallback(), and call
/// compute_all() (rows/many_pairs.hpp).
#ifndef PW85_SIMD_LANES_CHUNKS_HPP_INCLUDED
#define PW85_SIMD_LANES_CHUNKS_HPP_INCLUDED

#include "../lanes.hpp"
#include "gather.hpp"

namespace pw85::detail {
inline namespace PW85_PACKS {

/// The number of packs per chunk. A pack and its search take 1.7 kB with 8 lanes. Two to eight
/// packs are about as fast. A small number saves first-level cache and stack.
inline constexpr std::size_t packs_per_chunk = 3;
inline constexpr std::size_t contact_chunk_size = packs_per_chunk * lanes;

} // namespace PW85_PACKS

namespace {

/// The number of rows of a chunk.
template <class Rows, class Arrays> constexpr std::size_t chunk_size = contact_chunk_size;

/// Calls step(k) for each of up to packs_per_chunk searches, max_steps times or until none of its
/// lanes is active.
template <class Search, class Step> PW85_INLINE void run(Search const *searches, std::size_t packs,
                                                         int max_steps, Step const &step) noexcept
{
    std::uint8_t active[packs_per_chunk];
    std::size_t num_active = packs;
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k)
        active[k] = static_cast<std::uint8_t>(k);
    for (int i = 0; i < max_steps && num_active > 0; ++i) {
        std::size_t num_left = 0;
        for (std::size_t k = 0; k < num_active; ++k) {
            step(active[k]);
            active[num_left] = active[k];
            num_left += any_of(searches[active[k]].active);
        }
        num_active = num_left;
    }
}

/// Computes chunk after chunk. It stops when there may be no room for the pairs that the next chunk
/// leaves over.
template <class Rows, class Arrays>
std::size_t compute_chunks(Rows const &rows, std::size_t n, Arrays const &out,
                           kernels::Worklist &rejected_lanes) noexcept
{
    constexpr std::size_t chunk = chunk_size<Rows, Arrays>,
                          last_begin = kernels::Worklist::largest_index + 1 - chunk;
    rejected_lanes.size = 0;
    std::size_t done = 0;
    while (done < n && done <= last_begin &&
           rejected_lanes.size + chunk <= kernels::Worklist::capacity) {
        std::size_t const count = n - done < chunk ? n - done : chunk;
        // found by the namespace of Chunk
        compute_chunk(rows, Chunk{done, count, n}, out, rejected_lanes);
        done += count;
    }
    return done;
}

} // namespace
} // namespace pw85::detail

/// Defines the kernel of some rows and arrays.
#define PW85_KERNEL(Rows, Arrays)                                                                  \
    namespace pw85::detail::kernels {                                                              \
    template <>                                                                                    \
    [[gnu::flatten]] std::size_t PW85_BUILDING::compute(Rows const &rows, std::size_t n,           \
                                                        Arrays const &out,                         \
                                                        Worklist &rejected_lanes) noexcept         \
    {                                                                                              \
        return compute_chunks(rows, n, out, rejected_lanes);                                       \
    }                                                                                              \
    }

/// Defines the function that copies the pairs of some rows.
#define PW85_GATHER(Rows)                                                                          \
    namespace pw85::detail::kernels {                                                              \
    template <> void PW85_BUILDING::gather(Rows const &rows, std::uint16_t const *indices,         \
                                           std::size_t count,                                      \
                                           PairRow<Rows::dimension> *pairs) noexcept               \
    {                                                                                              \
        detail::gather(rows, indices, count, pairs);                                               \
    }                                                                                              \
    }

#endif
