// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernel for the contact function, one pair per lane. It drives the search on the rational
/// form (contact/iteration.hpp). lanes_contact.cpp defines it, and the kernels for
/// derivatives and closest approach call contact_chunk().
///
/// Each stage runs over all packs of a chunk before the next stage begins. The stages are short and
/// the packs are independent: the processor works on several packs at a time. Pairs that fail the
/// fast checks, and pairs for which the search is not certain, are left over.
#ifndef PW85_SIMD_LANE_CONTACT_HPP_INCLUDED
#define PW85_SIMD_LANE_CONTACT_HPP_INCLUDED

#include <pw85/contact/contact.hpp>

#include "gather.hpp"

namespace pw85::detail {
inline namespace PW85_PACKS {

/// The number of packs per chunk. A pack and its search take 1.7 kB with 8 lanes. Two to eight
/// packs are about as fast. A small number saves first-level cache and stack.
inline constexpr std::size_t packs_per_chunk = 3;
inline constexpr std::size_t contact_chunk_size = packs_per_chunk * lanes;

/// Pairs and their searches.
template <int D> struct PackSearches {
    LanePair<D> pairs[packs_per_chunk];
    RationalSearch<Pack> states[packs_per_chunk];

    /// Pair k. The compiler sees that the ratio is 1; it could not know that of a ratio in memory.
    PW85_INLINE LanePair<D> pair(std::size_t k) const noexcept
    {
        return pair_of(pairs[k].r12, pairs[k].q1, pairs[k].q2);
    }
};

/// Runs the searches of up to packs_per_chunk packs. It is compiled once for all kernels of an
/// instruction set.
void run(PackSearches<2> &searches, std::size_t packs) noexcept;
void run(PackSearches<3> &searches, std::size_t packs) noexcept;

} // namespace PW85_PACKS

namespace {

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

/// The definition of run().
template <int D>
PW85_INLINE void run_searches(PackSearches<D> &searches, std::size_t packs) noexcept
{
    for (std::size_t k = 0; k < packs && k < packs_per_chunk; ++k)
        searches.states[k] = start_search(searches.pairs[k]);
    run(searches.states, packs, max_rational_steps,
        [&](std::size_t k) { take_step(searches.states[k], searches.pair(k)); });
}

/// Computes the contact functions of a chunk of at most contact_chunk_size pairs. For each pack it
/// calls write(pair, value, certain, first, left), where `first` is the index of the pack's first
/// pair and `left` the number of pairs from there to the end of the chunk. write() returns the bits
/// of the lanes that are done; the other pairs are left over.
template <class Rows, class Write>
PW85_INLINE void contact_chunk(Rows const &rows, Chunk const &chunk,
                               kernels::Worklist &rejected_lanes, Write const &write) noexcept
{
    PackSearches<Rows::dimension> searches;
    auto const [begin, count, end] = chunk;
    prefetch(rows, begin + prefetch_distance, count, end);
    std::size_t const packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k)
        searches.pairs[k] = load_consecutive(rows, begin + k * lanes, count - k * lanes);
    run(searches, packs);
    for (std::size_t k = 0; k < packs; ++k) {
        std::size_t const first = begin + k * lanes, left = count - k * lanes;
        auto const &pair = searches.pairs[k];
        auto const last = last_evaluation(pair, searches.states[k].candidate);
        unsigned const done = write(pair, last.value, is_accepted(pair, last), first, left);
        for_lanes(live_lanes(left) & ~done, [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

/// Stores the contact functions of a chunk. scalar_fallback() overwrites those that are not
/// certain.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::ContactArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    contact_chunk(rows, chunk, rejected_lanes,
                  [&](auto const &, StationaryValue<Pack> const &value, PackMask certified,
                      std::size_t first, std::size_t left) {
                      store_lanes(value.mu2, left, out.mu2 + first);
                      if (out.lambda != nullptr)
                          store_lanes(value.lambda, left, out.lambda + first);
                      return certified.to_bits();
                  });
}

} // namespace
} // namespace pw85::detail

#endif
