// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernel for distances of closest approach, one pair per lane: |d|/μ(d), where d is the
/// direction. It is the kernel of the contact function (lane_contact.hpp) with another result.
/// lanes_contact.cpp defines it.
#ifndef PW85_SIMD_LANE_CLOSEST_APPROACH_HPP_INCLUDED
#define PW85_SIMD_LANE_CLOSEST_APPROACH_HPP_INCLUDED

#include "lane_contact.hpp"

namespace pw85::detail {
namespace {

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

#endif
