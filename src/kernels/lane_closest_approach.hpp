/// @file
/// Distances of closest approach, one pair per lane: |d|/μ(d), by the contact function of the direction d.
#ifndef PW85_KERNELS_LANE_CLOSEST_APPROACH_HPP_INCLUDED
#define PW85_KERNELS_LANE_CLOSEST_APPROACH_HPP_INCLUDED

#include "lane_contact.hpp"

namespace pw85::detail {
namespace {

/// Distances of a chunk. Pairs whose μ² leaves the range of double, which the distance does not, are left over.
PW85_INLINE void compute_chunk(kernels::Directions const &rows, Chunk const &chunk, kernels::ApproachArray const &out,
                               kernels::Worklist &left_over) noexcept
{
    contact_chunk(rows, chunk, left_over,
                  [&](LanePair<3> const &pair, StationaryValue<Pack> const &value, PackMask certain, std::size_t first,
                      std::size_t left) {
                      Pack const mu2 = value.mu2;
                      Pack const distance = square_root(Pack(dot(pair.r12, pair.r12))) / square_root(mu2);
                      store_lanes(distance, left, out.distance + first);
                      return (certain && mu2 > Pack(0.0) && mu2 <= largest_number<Pack>()).to_bits();
                  });
}

} // namespace
} // namespace pw85::detail

#endif
