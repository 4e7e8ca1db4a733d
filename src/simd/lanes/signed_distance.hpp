// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The signed distances of many pairs, one pair per lane. Pairs that overlap are computed as depths
/// are (depth.hpp), and have the bits of one pair. Pairs that are apart are listed and computed as
/// distances are (distance.hpp), and have the bits of their rows.
///
/// A pair is left over in the cases of depth.hpp and of distance.hpp.
#ifndef PW85_SIMD_LANES_SIGNED_DISTANCE_HPP_INCLUDED
#define PW85_SIMD_LANES_SIGNED_DISTANCE_HPP_INCLUDED

#include "distance.hpp"

#include "depth.hpp"

namespace pw85::detail::kernels {

/// Signed distances, closest or deepest points, and normals. Any pointer may be null.
struct SignedDistanceArrays {
    static constexpr std::size_t rows_of_block = DepthArrays::rows_of_block;
    DistanceArrays arrays;

    PW85_MEMBER SignedDistanceArrays from(std::size_t begin) const noexcept
    {
        return {arrays.from(begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/signed_distance.hpp>

namespace pw85::detail {
namespace {

template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::SignedDistanceArrays> =
    depth_chunk_size;

/// The deepest points of pairs that overlap, as signed_distance_overlapping() computes them. Pairs
/// that pass the fast checks need no scaling.
PW85_INLINE Distance<Pack, 3> deepest_points(SidePair const &pair, LaneDepths const &found) noexcept
{
    auto const &[r12, q] = pair;
    DistancePair<Pack, 3> const one{r12, first_of(q), second_of(q), Pack(1.0), Pack(1.0)};
    auto result = distance_through(one, found.direction);
    result.distance = Pack(0.0) - found.depth;
    return result;
}

/// Computes the pairs of a list, which overlap or prove to be apart.
template <class Rows>
[[gnu::noinline]] inline void compute_overlapping(Rows const &rows, StartedList &list,
                                                  kernels::DistanceArrays const &out,
                                                  kernels::Worklist &rejected_lanes) noexcept
{
    compute_depths(rows, list, rejected_lanes,
                   [&](SidePair const &pair, LaneDepths const &found, std::uint16_t const *indices,
                       unsigned certain) {
                       scatter_distances(deepest_points(pair, found), pair.r12, certain, indices,
                                         out);
                   });
}

template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::SignedDistanceArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    if constexpr (lanes == 2) return reject_all(chunk, rejected_lanes);
    StartedList list;
    start_depths(rows, chunk, list, rejected_lanes);
    compute_overlapping(rows, list, out.arrays, rejected_lanes);
    pad(list.apart);
    kernels::PW85_BUILDING::listed_distances(rows, list.apart.indices, list.apart.size, out.arrays,
                                             rejected_lanes);
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../one_pair.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                                  SignedDistanceArrays const &out) noexcept
{
    auto const &[distance, point1, point2, normal] = out.arrays;
    return PW85_OF_PAIR(target, signed_distance_geometry)(pair.r12, pair.q1, pair.q2, distance,
                                                          point1, point2, normal);
}

static inline int refuse_pair(Target const &, PairRow<3> const &pair,
                              SignedDistanceArrays const &) noexcept
{
    return pw85_signed_distance(pair.r12, pair.q1, pair.q2, nullptr, nullptr, nullptr);
}

} // namespace pw85::detail::kernels

#endif
#endif
