// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of many pairs, one pair per lane, and the distance of closest approach,
/// |d|/μ(d) for a direction d.
///
/// The kernels drive the search on the rational form (contact/iteration.hpp). Each stage runs over
/// all packs of a chunk before the next stage begins. The stages are short and the packs are
/// independent: the processor works on several packs at a time. Pairs that fail the fast checks,
/// and pairs for which the search is not certain, are left over.
#ifndef PW85_SIMD_LANES_CONTACT_HPP_INCLUDED
#define PW85_SIMD_LANES_CONTACT_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Contact functions.
struct ContactArrays {
    double *mu2, *lambda; ///< lambda may be null

    PW85_MEMBER ContactArrays from(std::size_t begin) const noexcept
    {
        return {row_of(mu2, 1, begin), row_or_null(lambda, 1, begin)};
    }
};

/// Distances of closest approach.
struct ApproachArray {
    double *distance;

    PW85_MEMBER ApproachArray from(std::size_t begin) const noexcept { return {distance + begin}; }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/contact/contact.hpp>

namespace pw85::detail {
inline namespace PW85_PACKS {

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

/// Computes the distances of a chunk. If the μ² of a pair is out of the range of double, the pair
/// is left over, because its distance may be in range.
PW85_INLINE void compute_chunk(kernels::Directions const &rows, Chunk const &chunk,
                               kernels::ApproachArray const &out,
                               kernels::Worklist &rejected_lanes) noexcept
{
    contact_chunk(
        rows, chunk, rejected_lanes,
        [&](LanePair<3> const &pair, StationaryValue<Pack> const &value, PackMask certified,
            std::size_t first, std::size_t left) {
            Pack const mu2 = value.mu2;
            Pack const distance = square_root(Pack(dot(pair.r12, pair.r12))) / square_root(mu2);
            store_lanes(distance, left, out.distance + first);
            return (certified && mu2 > Pack(0.0) && mu2 <= largest_number<Pack>()).to_bits();
        });
}

} // namespace
} // namespace pw85::detail

#elif !defined(PW85_FOR_DEVICES)
#include <pw85.h>

#include "../one_pair.hpp"

namespace pw85::detail::kernels {

template <int D> static int scalar_fallback(Target const &target, PairRow<D> const &pair,
                                            ContactArrays const &out) noexcept
{
    double contact[2];
    int const status = (D == 3 ? PW85_OF_PAIR(target, contact) : pw85_contact_2d)(pair.r12, pair.q1,
                                                                                  pair.q2, contact);
    *out.mu2 = contact[0];
    if (out.lambda != nullptr) *out.lambda = contact[1];
    return status;
}

static inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                                  ApproachArray const &out) noexcept
{
    return PW85_OF_PAIR(target, closest_approach)(pair.r12, pair.q1, pair.q2, out.distance);
}

static inline int refuse_contact(PairRow<3> const &pair) noexcept
{
    double contact[2];
    return pw85_contact(pair.r12, pair.q1, pair.q2, contact);
}

static inline int refuse_pair(Target const &, PairRow<3> const &pair,
                              ContactArrays const &) noexcept
{
    return refuse_contact(pair);
}

/// The kernels' rows have directions of length one, which are NaN for zero vectors.
static inline int refuse_row_of(Target const &, Directions const &rows, ApproachArray const &,
                                std::size_t i) noexcept
{
    auto const row = rows.arrays.from(i);
    double distance;
    return pw85_closest_approach(row.r12, row.q1, row.q2, &distance);
}

} // namespace pw85::detail::kernels

#endif
#endif
