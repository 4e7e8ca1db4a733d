// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether many pairs overlap, one pair per lane. The kernel drives the tests on the quartic
/// (overlap/quartic.hpp).
///
/// Each pair is first tested at about the same t as in the function for one pair. Undecided pairs
/// are collected to keep all lanes in use. They are tested again at the next two t of the
/// fixed-point map, and then at the t to which the search on the rational form converges. Pairs are
/// left over if they fail the fast checks, or if they remain undecided because they are tangent to
/// within rounding.
#ifndef PW85_SIMD_LANES_OVERLAP_HPP_INCLUDED
#define PW85_SIMD_LANES_OVERLAP_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Results of the overlap test: 1, 0, or 255 for a bad pair.
struct OverlapArray {
    unsigned char *overlap;

    PW85_MEMBER OverlapArray from(std::size_t begin) const noexcept { return {overlap + begin}; }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <bit>

#include <pw85/overlap/quartic.hpp>

#include "contact.hpp"

namespace pw85::detail {
namespace {

/// The number of pairs that are tested once before the undecided pairs among them are tested again.
inline constexpr std::size_t overlap_chunk_size = 256;
template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::OverlapArray> =
    overlap_chunk_size;

/// Undecided pairs, with t² of their next test.
struct UndecidedList {
    kernels::IndexList<overlap_chunk_size> pairs;
    double next[overlap_chunk_size];

    PW85_INLINE void push(std::size_t index, double square) noexcept
    {
        next[pairs.size] = square;
        pairs.push(index);
    }

    /// Fills the last pack. Call this between the last push() and load_next().
    PW85_INLINE void pad() noexcept
    {
        for (std::size_t i = pairs.size; i % lanes != 0; ++i) next[i] = 1.0;
        pw85::detail::pad(pairs);
    }

    PW85_INLINE Pack load_next(std::size_t k) const noexcept
    {
        return rough_root(load_lanes<Pack>(next + k));
    }
};

/// The result of a test.
struct LaneCertainty {
    /// bits of the lanes that overlap for certain, and of those that are decided
    unsigned overlap, decided;
    Pack next; ///< square of the next t of the fixed-point map
};

/// Returns the first t. It is that of the function for one pair, up to a few per cent.
template <int D> PW85_INLINE Pack first_point(LanePair<D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    return coarse_root_of_ratio(quadratic_form(pair.q1, weights), quadratic_form(pair.q2, weights));
}

/// Tests one pair per lane at t.
template <int D>
PW85_INLINE LaneCertainty test_lanes(LanePair<D> const &pair, Pack const &t) noexcept
{
    auto const e = evaluate_quartic(pair, t);
    auto const certainty = test_quartic(e, t);
    unsigned const apart = certainty.apart.to_bits(), overlap = certainty.overlap.to_bits();
    return {overlap, overlap | apart, coarse_quotient(first_form(e, t), e.form)};
}

/// The last test of up to packs_per_chunk packs: at the t to which the search on the rational form
/// converges. It is compiled once for all kernels of a file.
template <int D> [[gnu::noinline]] inline void
run_and_test(PackSearches<D> &searches, std::size_t packs, LaneCertainty *certainties) noexcept
{
    run(searches, packs);
    for (std::size_t k = 0; k < packs; ++k)
        certainties[k] = test_lanes(searches.pairs[k], searches.states[k].candidate.t);
}

/// Stores the results of consecutive pairs, one byte for each.
PW85_INLINE void store_answers(unsigned overlap, std::size_t count, unsigned char *out) noexcept
{
    // Bit i goes to byte i of memory. Each byte gets a copy of all bits and keeps bit i. Adding 127
    // carries that bit to the top of the byte.
    constexpr std::uint64_t bit_of_byte =
        std::endian::native == std::endian::little ? 0x8040201008040201u : 0x0102040810204080u;
    std::uint64_t const own = (overlap * 0x0101010101010101u) & bit_of_byte;
    std::uint64_t const bytes = (own + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
    std::memcpy(out, &bytes, count < lanes ? count : lanes);
}

/// The first test, of consecutive pairs. Later tests, or scalar_fallback(), overwrite the results
/// that are not certain.
template <class Rows> PW85_INLINE void test_consecutive(Rows const &rows, Chunk const &chunk,
                                                        unsigned char *out,
                                                        UndecidedList &undecided,
                                                        kernels::Worklist &rejected_lanes) noexcept
{
    auto const [begin, count, end] = chunk;
    for (std::size_t k = 0; k < count; k += lanes) {
        std::size_t const first = begin + k, left = count - k;
        if (k % prefetch_distance == 0)
            prefetch(rows, first + prefetch_distance, prefetch_distance, end);
        auto const pair = load_consecutive(rows, first, left);
        unsigned const passing = passes_fast_checks(pair).to_bits();
        LaneCertainty const certainty = test_lanes(pair, first_point(pair));
        store_answers(certainty.overlap, left, out + first);
        for_lanes(live_lanes(left) & passing & ~certainty.decided,
                  [&](unsigned i) { undecided.push(first + i, certainty.next[i]); });
        for_lanes(live_lanes(left) & ~passing, [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

/// Stores the results of the lanes that are decided, and calls keep(index, lane) for the others.
template <class Keep> PW85_INLINE void store_decided(std::uint16_t const *list, std::size_t count,
                                                     LaneCertainty const &certainty,
                                                     unsigned char *out, Keep const &keep) noexcept
{
    for (unsigned i = 0; i < lanes && i < count; ++i) {
        std::size_t const index = list[i];
        out[index] = certainty.overlap >> i & 1u;
        if (!(certainty.decided >> i & 1u)) keep(index, i);
    }
}

/// Tests the undecided pairs, and keeps those that remain undecided.
template <class Rows> PW85_INLINE void test_undecided(Rows const &rows, unsigned char *out,
                                                      UndecidedList &undecided) noexcept
{
    undecided.pad();
    std::size_t const size = undecided.pairs.size;
    // push() overwrites only indices that were already read
    std::uint16_t const *const list = undecided.pairs.indices;
    undecided.pairs.size = 0;
    for (std::size_t k = 0; k < size; k += lanes) {
        std::size_t const count = size - k;
        LaneCertainty const certainty =
            test_lanes(load_listed(rows, list + k), undecided.load_next(k));
        store_decided(list + k, count, certainty, out, [&](std::size_t index, unsigned i) {
            undecided.push(index, certainty.next[i]);
        });
    }
}

/// Decides the pairs that remain by the last test.
template <class Rows> PW85_INLINE void test_converged(Rows const &rows, unsigned char *out,
                                                      kernels::IndexList<overlap_chunk_size> &pairs,
                                                      kernels::Worklist &rejected_lanes) noexcept
{
    PackSearches<Rows::dimension> searches;
    LaneCertainty certainties[packs_per_chunk];
    pad(pairs);
    for (std::size_t begin = 0; begin < pairs.size; begin += contact_chunk_size) {
        std::size_t const left = pairs.size - begin,
                          count = left < contact_chunk_size ? left : contact_chunk_size;
        std::size_t const packs = (count + lanes - 1) / lanes;
        std::uint16_t const *const list = pairs.indices + begin;
        for (std::size_t k = 0; k < packs; ++k)
            searches.pairs[k] = load_listed(rows, list + k * lanes);
        run_and_test(searches, packs, certainties);
        for (std::size_t k = 0; k < packs; ++k)
            store_decided(list + k * lanes, count - k * lanes, certainties[k], out,
                          [&](std::size_t index, unsigned) { rejected_lanes.push(index); });
    }
}

/// Runs all tests on a chunk.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::OverlapArray const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    UndecidedList undecided;
    test_consecutive(rows, chunk, out.overlap, undecided, rejected_lanes);
    for (int i = 0; i < 2; ++i) test_undecided(rows, out.overlap, undecided);
    test_converged(rows, out.overlap, undecided.pairs, rejected_lanes);
}

} // namespace
} // namespace pw85::detail

#elif !defined(PW85_FOR_DEVICES)
#include <pw85.h>

#include "../one_pair.hpp"

namespace pw85::detail::kernels {

template <int D> static int scalar_fallback(Target const &target, PairRow<D> const &pair,
                                            OverlapArray const &out) noexcept
{
    int overlap = -1; // stays where the pair is bad, and becomes 255
    int const status = (D == 3 ? PW85_OF_PAIR(target, overlap)
                               : pw85_overlap_2d)(pair.r12, pair.q1, pair.q2, &overlap);
    *out.overlap = static_cast<unsigned char>(overlap);
    return status;
}

static inline int refuse_pair(Target const &, PairRow<3> const &pair, OverlapArray const &) noexcept
{
    int overlap;
    return pw85_overlap(pair.r12, pair.q1, pair.q2, &overlap);
}

} // namespace pw85::detail::kernels

#endif
#endif
