/// @file
/// The overlap test of many pairs, one per lane: a driver of the tests on the quartic.
///
/// Each pair is tested where the scalar path begins; undecided ones are collected, so that lanes stay full, and tested where the
/// fixed-point map leads, then where the search on the rational form does. What that leaves, tangent to about as many digits as
/// the pair's conditioning leaves, or out of the ordinary, is left over.
#ifndef PW85_KERNELS_LANE_OVERLAP_HPP_INCLUDED
#define PW85_KERNELS_LANE_OVERLAP_HPP_INCLUDED

#include <bit>

#include <pw85/overlap/quartic.hpp>

#include "lane_contact.hpp"

namespace pw85::detail {
namespace {

/// Pairs that are tested before the undecided ones among them are taken up again.
inline constexpr std::size_t overlap_chunk_size = 256;

/// Undecided pairs, with the square of the t of their next test.
struct UndecidedList {
    kernels::IndexList<overlap_chunk_size> pairs;
    double next[overlap_chunk_size];

    PW85_INLINE void push(std::size_t index, double square) noexcept
    {
        next[pairs.size] = square;
        pairs.push(index);
    }

    /// To be called between the last push() and load_next().
    PW85_INLINE void pad() noexcept
    {
        for (std::size_t i = pairs.size; i % lanes != 0; ++i) next[i] = 1.0;
        pw85::detail::pad(pairs);
    }

    PW85_INLINE Pack load_next(std::size_t k) const noexcept { return rough_root(load_lanes<Pack>(next + k)); }
};

/// The outcome of a test.
struct LaneCertainty {
    unsigned overlap, decided; ///< lanes that are certain
    Pack next;                 ///< square of the next t of the fixed-point map
};

template <int D> PW85_INLINE LaneCertainty test_lanes(LanePair<D> const &pair, Pack const &t) noexcept
{
    auto const e = evaluate_quartic(pair, t);
    auto const certainty = test_quartic(e, t);
    unsigned const apart = certainty.apart.to_bits(), overlap = certainty.overlap.to_bits();
    return {overlap, overlap | apart, fixed_point_square(e, t)};
}

/// Stores answers for neighbouring pairs.
PW85_INLINE void store_answers(unsigned overlap, std::size_t count, unsigned char *out) noexcept
{
    // Bit i to byte i of memory: each byte keeps its own bit of a copy of all, and adding 127 carries it to the top.
    constexpr std::uint64_t bit_of_byte =
        std::endian::native == std::endian::little ? 0x8040201008040201u : 0x0102040810204080u;
    std::uint64_t const own = (overlap * 0x0101010101010101u) & bit_of_byte;
    std::uint64_t const bytes = (own + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
    std::memcpy(out, &bytes, count < lanes ? count : lanes);
}

/// First test, for neighbouring pairs; answers that are not certain will be overwritten.
template <class Rows> PW85_INLINE void test_neighbors(Rows const &rows, Chunk const &chunk, unsigned char *out,
                                                      UndecidedList &undecided, kernels::Worklist &left_over) noexcept
{
    auto const [begin, count, end] = chunk;
    for (std::size_t k = 0; k < count; k += lanes) {
        std::size_t const first = begin + k, left = count - k;
        if (k % prefetch_distance == 0) prefetch(rows, first + prefetch_distance, prefetch_distance, end);
        auto const pair = load_neighbors(rows, first, left);
        unsigned const ordinary = passes_fast_checks(pair.r12, pair.q1, pair.q2).to_bits();
        LaneCertainty const certainty = test_lanes(pair, initial_guess(pair));
        store_answers(certainty.overlap, left, out + first);
        for_lanes(live_lanes(left) & ordinary & ~certainty.decided,
                  [&](unsigned i) { undecided.push(first + i, certainty.next[i]); });
        for_lanes(live_lanes(left) & ~ordinary, [&](unsigned i) { left_over.push(first + i); });
    }
}

/// Stores the answers for the lanes of a list that are decided, and calls keep(index, lane) for the others.
template <class Keep> PW85_INLINE void store_decided(std::uint16_t const *list, std::size_t count,
                                                     LaneCertainty const &certainty, unsigned char *out,
                                                     Keep const &keep) noexcept
{
    for (unsigned i = 0; i < lanes && i < count; ++i) {
        std::size_t const index = list[i];
        out[index] = certainty.overlap >> i & 1u;
        if (!(certainty.decided >> i & 1u)) keep(index, i);
    }
}

/// A test of the undecided pairs, which are replaced by those that remain.
template <class Rows>
PW85_INLINE void test_undecided(Rows const &rows, unsigned char *out, UndecidedList &undecided) noexcept
{
    undecided.pad();
    std::size_t const size = undecided.pairs.size;
    std::uint16_t const *const list = undecided.pairs.indices; // stay where they are until push() overwrites them
    undecided.pairs.size = 0;
    for (std::size_t k = 0; k < size; k += lanes) {
        std::size_t const count = size - k;
        LaneCertainty const certainty = test_lanes(load_listed(rows, list + k), undecided.load_next(k));
        store_decided(list + k, count, certainty, out,
                      [&](std::size_t index, unsigned i) { undecided.push(index, certainty.next[i]); });
    }
}

/// The last test, where the search has converged.
template <class Rows> PW85_INLINE void test_converged(Rows const &rows, unsigned char *out,
                                                      kernels::IndexList<overlap_chunk_size> &pairs,
                                                      kernels::Worklist &left_over) noexcept
{
    PackSearches<Rows::dimension> searches;
    pad(pairs);
    for (std::size_t begin = 0; begin < pairs.size; begin += contact_chunk_size) {
        std::size_t const left = pairs.size - begin, count = left < contact_chunk_size ? left : contact_chunk_size;
        std::size_t const packs = (count + lanes - 1) / lanes;
        std::uint16_t const *const list = pairs.indices + begin;
        for (std::size_t k = 0; k < packs; ++k) searches.pairs[k] = load_listed(rows, list + k * lanes);
        run(searches, packs);
        for (std::size_t k = 0; k < packs; ++k)
            store_decided(list + k * lanes, count - k * lanes,
                          test_lanes(searches.pairs[k], searches.states[k].candidate.t), out,
                          [&](std::size_t index, unsigned) { left_over.push(index); });
    }
}

/// All tests for a chunk.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::OverlapArray const &out,
                                                     kernels::Worklist &left_over) noexcept
{
    UndecidedList undecided;
    test_neighbors(rows, chunk, out.overlap, undecided, left_over);
    test_undecided(rows, out.overlap, undecided);
    test_undecided(rows, out.overlap, undecided);
    test_converged(rows, out.overlap, undecided.pairs, left_over);
}

} // namespace
} // namespace pw85::detail

#endif
