// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas of common parts of many pairs in two dimensions, one pair per lane. The kernel drives the
/// chords of volume/chord_area.hpp, which give the bits of the function for one pair. Contact
/// functions (contact.hpp) and overlaps (overlap.hpp) are those of three dimensions.
///
/// The kernel for overlaps decides first. Pairs that overlap are collected, so that all lanes are
/// in use. A pair is left over if that kernel leaves it over, or if its chords have no margin.
#ifndef PW85_SIMD_LANES_TWO_DIMENSIONS_HPP_INCLUDED
#define PW85_SIMD_LANES_TWO_DIMENSIONS_HPP_INCLUDED

#include "../pairs.hpp"
#include "contact.hpp"
#include "overlap.hpp"

namespace pw85::detail::kernels {

/// Areas of common parts.
struct AreaArray {
    double *area;

    PW85_MEMBER AreaArray from(std::size_t begin) const noexcept { return {area + begin}; }
};

/// Eight lanes would gain a factor of 1.0 to 1.3, and less than 1.3 at aspect ratio 10.
template <> inline constexpr bool has_lanes256<PairArrays<2>, AreaArray> = true;

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/volume/chord_area.hpp>

namespace pw85::detail {
inline namespace PW85_PACKS {

/// Computes third_of_exponent() of a number for each lane, in integers of 64 bits.
PW85_INLINE Pack third_of_exponent(Pack const &x) noexcept
{
    using Integers = VectorOf<lanes>::Integers;
    auto const high = reinterpret_cast<Integers>(x.v) >> 32;
    return reinterpret_cast<Register>((((high * 0x55555556) >> 32) + 0x2a9f7893) << 32);
}

} // namespace PW85_PACKS

namespace {

template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::AreaArray> =
    overlap_chunk_size;

/// The decisions of a chunk: 0, 1, or 255 for a pair that is left over.
struct ChunkOverlaps {
    unsigned char answers[overlap_chunk_size];
};

/// Decides by the kernel for overlaps as it is compiled for them. This and the areas are functions
/// of their own: their frames are not on the stack at once.
template <class Rows> [[gnu::noinline]] inline void
decide_chunk(Rows const &rows, std::size_t count, ChunkOverlaps &overlaps) noexcept
{
    kernels::Worklist rejected;
    kernels::PW85_BUILDING::compute(rows, count, kernels::OverlapArray{overlaps.answers}, rejected);
    for (std::size_t i = 0; i < rejected.size; ++i) overlaps.answers[rejected.indices[i]] = 255;
}

/// Computes the areas of the listed pairs, which overlap.
template <class Rows> [[gnu::noinline]] inline void
compute_areas(Rows const &rows, kernels::IndexList<overlap_chunk_size> &list, std::size_t begin,
              double *out, kernels::Worklist &rejected_lanes) noexcept
{
    pad(list);
    for (std::size_t k = 0; k < list.size; k += lanes) {
        auto const pair = load_listed(rows, list.indices + k);
        auto const found = chord_area(pair.r12, pair.q1, pair.q2);
        unsigned const certain = found.certain.to_bits(), live = live_lanes(list.size - k);
        for_lanes(live & certain,
                  [&](unsigned i) { out[begin + list.indices[k + i]] = found.area[i]; });
        for_lanes(live & ~certain,
                  [&](unsigned i) { rejected_lanes.push(begin + list.indices[k + i]); });
    }
}

/// Computes the areas of a chunk.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::AreaArray const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    std::size_t const begin = chunk.begin, count = chunk.count;
    Rows const rest = rows.from(begin);
    ChunkOverlaps overlaps;
    decide_chunk(rest, count, overlaps);
    kernels::IndexList<overlap_chunk_size> list;
    for (std::size_t i = 0; i < count; ++i) {
        out.area[begin + i] = 0.0;
        if (overlaps.answers[i] == 1) list.push(i);
        if (overlaps.answers[i] == 255) rejected_lanes.push(begin + i);
    }
    compute_areas(rest, list, begin, out.area, rejected_lanes);
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../targets.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &, PairRow<2> const &pair,
                                  AreaArray const &out) noexcept
{
    return pw85_overlap_area_2d(pair.r12, pair.q1, pair.q2, out.area);
}

} // namespace pw85::detail::kernels

#endif
#endif
