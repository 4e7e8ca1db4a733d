/// @file
/// The overlap test of many pairs, one per lane: a driver of the tests on the quartic.
///
/// Each pair is tested where the scalar path begins; undecided ones are collected, so that lanes stay full, and tested where the
/// fixed-point map leads, then where the search on the rational form does. What that leaves, tangent to about as many digits as
/// the pair's conditioning leaves, or out of the ordinary, goes to the scalar path.
#ifndef PW85_KERNELS_LANE_OVERLAP_HPP_INCLUDED
#define PW85_KERNELS_LANE_OVERLAP_HPP_INCLUDED

#include <pw85/quartic.hpp>

#include "lane_contact.hpp"

namespace pw85 {
namespace {

/// Pairs that are tested before the undecided ones among them are taken up again.
inline constexpr std::size_t overlap_chunk_size = 256;
using OverlapList = OffsetList<overlap_chunk_size>;

/// Undecided pairs, with the square of the t of their next test.
struct UndecidedList {
    OverlapList pairs;
    double next[overlap_chunk_size];

    PW85_INLINE explicit UndecidedList(std::size_t begin) noexcept : pairs(begin) {}

    PW85_INLINE void push(std::size_t offset, double square) noexcept
    {
        next[pairs.size()] = square;
        pairs.push(offset);
    }

    PW85_INLINE void pad() noexcept
    {
        for (std::size_t i = pairs.size(); i < pairs.packs() * lanes; ++i) next[i] = 1.0;
        pairs.pad();
    }

    PW85_INLINE Pack load_next(std::size_t k) const noexcept
    {
        Pack squares;
        std::memcpy(&squares.v, next + k * lanes, sizeof squares.v);
        return rough_root(squares);
    }
};

/// The outcome of a test.
struct LaneDecision {
    unsigned overlap, decided; ///< lanes that are certain
    Pack next;                 ///< square of the next t of the fixed-point map
};

PW85_INLINE LaneDecision decide_lanes(LanePair const &pair, Pack const &t) noexcept
{
    auto const e = evaluate_quartic(pair, t);
    auto const certainty = decide(e, t);
    unsigned const apart = certainty.apart.to_bits(), overlap = certainty.overlap.to_bits();
    return {overlap, overlap | apart, fixed_point_square(e, t)};
}

/// Stores neighbouring answers; those that are not decided will be overwritten.
PW85_INLINE void store(unsigned overlap, std::size_t count, unsigned char *out) noexcept
{
    // Bit i to byte i: each byte keeps its own bit of a copy of all, and adding 127 carries it to the top.
    std::uint64_t const own = (overlap * 0x0101010101010101u) & 0x8040201008040201u;
    std::uint64_t const bytes = (own + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
    std::memcpy(out, &bytes, count < lanes ? count : lanes);
}

/// First test, for neighbouring pairs.
template <class Rows> PW85_INLINE void test_neighbors(Rows const &rows, std::size_t count, unsigned char *out,
                                                      UndecidedList &undecided, OverlapList &rejected) noexcept
{
    std::size_t const begin = rejected.begin();
    for (std::size_t first = 0; first < count; first += lanes) {
        std::size_t const left = count - first;
        if (first % prefetch_distance == 0) rows.prefetch(begin + first + prefetch_distance, begin + count);
        LanePair const pair = load_neighbors(rows, begin + first, left);
        unsigned const ordinary = is_ordinary(pair.r12, pair.q1, pair.q2).to_bits();
        LaneDecision const decision = decide_lanes(pair, initial_guess(pair));
        store(decision.overlap, left, out + begin + first);
        for (unsigned bits = live_lanes(left) & ordinary & ~decision.decided; bits != 0; bits &= bits - 1) {
            auto const i = static_cast<unsigned>(__builtin_ctz(bits));
            undecided.push(first + i, decision.next[i]);
        }
        for (unsigned bits = live_lanes(left) & ~ordinary; bits != 0; bits &= bits - 1)
            rejected.push(first + static_cast<unsigned>(__builtin_ctz(bits)));
    }
}

/// Stores the answers for the lanes of pack k of a list that are decided, and calls keep(offset, lane) for the others.
template <class Keep> PW85_INLINE void store_decided(OverlapList const &pairs, std::size_t size, std::size_t k,
                                                     LaneDecision const &decision, unsigned char *out,
                                                     Keep const &keep) noexcept
{
    for (unsigned i = 0; i < lanes && k * lanes + i < size; ++i) {
        std::size_t const offset = pairs.offset(k, i);
        out[pairs.begin() + offset] = decision.overlap >> i & 1u;
        if (!(decision.decided >> i & 1u)) keep(offset, i);
    }
}

/// A test of the undecided pairs, which are replaced by those that remain.
template <class Rows>
PW85_INLINE void test_undecided(Rows const &rows, unsigned char *out, UndecidedList &list) noexcept
{
    OverlapList &pairs = list.pairs;
    list.pad();
    std::size_t const packs = pairs.packs(), size = pairs.size();
    pairs.clear();
    for (std::size_t k = 0; k < packs; ++k) {
        LaneDecision const decision = decide_lanes(pairs.load(rows, k), list.load_next(k));
        store_decided(pairs, size, k, decision, out,
                      [&](std::size_t offset, unsigned i) { list.push(offset, decision.next[i]); });
    }
}

/// The last test, where the search has converged; those that remain go to `rejected`.
template <class Rows> PW85_INLINE void test_converged(Rows const &rows, unsigned char *out, OverlapList &pairs,
                                                      OverlapList &rejected) noexcept
{
    RationalSearch<Pack> searches[packs_per_chunk];
    pairs.pad();
    for (std::size_t first = 0; first < pairs.packs(); first += packs_per_chunk) {
        std::size_t const left = pairs.packs() - first, packs = left < packs_per_chunk ? left : packs_per_chunk;
        for (std::size_t k = 0; k < packs; ++k) {
            LanePair const pair = pairs.load(rows, first + k);
            searches[k] = start_search(pair, initial_guess(pair));
        }
        run(searches, packs);
        for (std::size_t k = 0; k < packs; ++k)
            store_decided(pairs, pairs.size(), first + k,
                          decide_lanes(pairs.load(rows, first + k), searches[k].candidate.t), out,
                          [&](std::size_t offset, unsigned) { rejected.push(offset); });
    }
}

/// All tests for neighbouring pairs; those left to the scalar path go to `rejected`. Not inlined, so that its lists are off the
/// stack when those are tested.
template <class Rows> [[gnu::noinline, gnu::flatten]] inline void
overlap_chunk(Rows const &rows, std::size_t count, unsigned char *out, OverlapList &rejected) noexcept
{
    UndecidedList undecided(rejected.begin());
    test_neighbors(rows, count, out, undecided, rejected);
    test_undecided(rows, out, undecided);
    test_undecided(rows, out, undecided);
    test_converged(rows, out, undecided.pairs, rejected);
}

/// The overlap test for a list of pairs by the scalar path.
template <class Rows> inline kernels::Failure overlap_one_by_one(Rows const &rows, OverlapList &list,
                                                                 unsigned char *out,
                                                                 kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    visit_pairs(rows, list, [&](std::size_t index, double const *r12, double const *q1, double const *q2) {
        int overlap = 0;
        first.update({index, scalar.overlap(r12, q1, q2, &overlap)});
        out[index] = static_cast<unsigned char>(overlap); // -1, for a bad pair, becomes 255
    });
    return first;
}

/// The overlap test for a range of pairs.
template <class Rows> inline kernels::Failure overlap_rows(Rows const &rows, kernels::Range range, unsigned char *out,
                                                           kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    for (std::size_t begin = range.begin; begin < range.end; begin += overlap_chunk_size) {
        std::size_t const left = range.end - begin;
        OverlapList rejected(begin);
        overlap_chunk(rows, left < overlap_chunk_size ? left : overlap_chunk_size, out, rejected);
        if (rejected.size() > 0) first.update(overlap_one_by_one(rows, rejected, out, scalar));
    }
    return first;
}

} // namespace
} // namespace pw85

#endif
