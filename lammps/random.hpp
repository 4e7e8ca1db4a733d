// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Streams of random numbers, from which fix pw85/hpmc and fix pw85/pour draw.
#ifndef PW85_LAMMPS_RANDOM_HPP_INCLUDED
#define PW85_LAMMPS_RANDOM_HPP_INCLUDED

#include "vectors.hpp"

#include <pw85/algebra/philox.hpp>

namespace pw85_lammps {

/// The random numbers of one task of one sweep. They depend on nothing but the seed, the sweep and
/// the task. Task 0 is what all processors share, and the other tasks are the tags of the atoms.
class Stream : public pw85::detail::Stream {
  public:
    Stream(std::uint32_t seed, std::uint64_t sweep, std::uint64_t task)
        : pw85::detail::Stream(seed | task >> 32 << 32, sweep, static_cast<std::uint32_t>(task))
    {
    }

    /// Returns a point in the unit ball. A point and its negative are equally probable.
    Vector in_ball() { return vector(pw85::detail::Stream::in_ball().coordinates); }
};

} // namespace pw85_lammps

#endif
