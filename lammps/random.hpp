// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Counter-based random numbers: Philox4x32-10 of Salmon, Moraes, Dror and Shaw, Parallel random numbers: as easy as 1, 2, 3 (2011),
/// doi:10.1145/2063384.2063405. fix pw85/hpmc draws its moves from a Stream.
///
/// The library has the same generator (src/simulation/random.hpp), but offers it through no public header.
#ifndef PW85_LAMMPS_RANDOM_HPP_INCLUDED
#define PW85_LAMMPS_RANDOM_HPP_INCLUDED

#include "vectors.hpp"

#include <array>
#include <cstdint>

namespace pw85_lammps {

using PhiloxWords = std::array<std::uint32_t, 4>;

/// The random words of a counter: a bijection of the counters for each key.
inline PhiloxWords philox(PhiloxWords x, std::uint64_t key)
{
    auto low = static_cast<std::uint32_t>(key), high = static_cast<std::uint32_t>(key >> 32);
    for (int round = 0; round < 10; ++round, low += 0x9e3779b9u, high += 0xbb67ae85u) {
        std::uint64_t const first = std::uint64_t{0xd2511f53u} * x[0], second = std::uint64_t{0xcd9e8d57u} * x[2];
        x = {static_cast<std::uint32_t>(second >> 32) ^ x[1] ^ low, static_cast<std::uint32_t>(second),
             static_cast<std::uint32_t>(first >> 32) ^ x[3] ^ high, static_cast<std::uint32_t>(first)};
    }
    return x;
}

/// The random numbers of one task of one sweep. They depend on nothing but the seed, the sweep and the task. Task 0 is what all
/// processors share, and the other tasks are the tags of the atoms.
class Stream {
  public:
    Stream(std::uint32_t seed, std::uint64_t sweep, std::uint64_t task)
        : key_(seed | task >> 32 << 32), counter_{0, static_cast<std::uint32_t>(task),
                                                  static_cast<std::uint32_t>(sweep),
                                                  static_cast<std::uint32_t>(sweep >> 32)}
    {
    }

    /// 32 random bits.
    std::uint32_t bits()
    {
        if (used_ == words_.size()) {
            words_ = philox(counter_, key_);
            ++counter_[0];
            used_ = 0;
        }
        return words_[used_++];
    }

    /// An integer from 0 to n - 1. The probabilities differ by less than 2⁻³².
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(std::uint64_t{bits()} * n >> 32); }

    /// A multiple of 2⁻⁵³ from 0 up to but not including 1.
    double uniform()
    {
        std::uint64_t const high = bits(), low = bits();
        return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
    }

    /// A point in the unit ball. A point and its negative are equally probable, because the coordinates are odd multiples of 2⁻³².
    Vector in_ball()
    {
        Vector x;
        do
            for (double &entry : x) entry = (2.0 * static_cast<std::int32_t>(bits()) + 1.0) * 0x1p-32;
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
