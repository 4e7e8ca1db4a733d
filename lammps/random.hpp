// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Streams of random numbers (see pw85/algebra/philox.hpp), from which fix pw85/hpmc and fix
/// pw85/pour draw.
#ifndef PW85_LAMMPS_RANDOM_HPP_INCLUDED
#define PW85_LAMMPS_RANDOM_HPP_INCLUDED

#include "vectors.hpp"

#include <pw85/algebra/philox.hpp>

#include <cstddef>
#include <cstdint>

namespace pw85_lammps {

using pw85::detail::philox;
using pw85::detail::PhiloxWords;

/// The random numbers of one task of one sweep. They depend on nothing but the seed, the sweep and
/// the task. Task 0 is what all processors share, and the other tasks are the tags of the atoms.
class Stream {
  public:
    Stream(std::uint32_t seed, std::uint64_t sweep, std::uint64_t task)
        : key_(seed | task >> 32 << 32), counter_{{0, static_cast<std::uint32_t>(task),
                                                   static_cast<std::uint32_t>(sweep),
                                                   static_cast<std::uint32_t>(sweep >> 32)}}
    {
    }

    /// Returns 32 random bits.
    std::uint32_t bits()
    {
        if (used_ == 4) {
            words_ = philox(counter_, key_);
            ++counter_.word[0];
            used_ = 0;
        }
        return words_.word[used_++];
    }

    /// Returns an integer from 0 to n - 1. The probabilities differ by less than 2⁻³².
    std::uint32_t below(std::uint32_t n)
    {
        return static_cast<std::uint32_t>(std::uint64_t{bits()} * n >> 32);
    }

    /// Returns a multiple of 2⁻⁵³ from 0 up to but not including 1.
    double uniform()
    {
        std::uint64_t const high = bits(), low = bits();
        return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
    }

    /// Returns a point in the unit ball. A point and its negative are equally probable, because the
    /// coordinates are odd multiples of 2⁻³².
    Vector in_ball()
    {
        Vector x;
        do
            for (double &entry : x)
                entry = (2.0 * static_cast<std::int32_t>(bits()) + 1.0) * 0x1p-32;
        while (dot(x, x) > 1.0);
        return x;
    }

  private:
    std::uint64_t key_;
    PhiloxWords counter_, words_{};
    std::size_t used_ = 4;
};

} // namespace pw85_lammps

#endif
