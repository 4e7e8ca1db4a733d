// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Counter-based random numbers: Philox4x32-10 of Salmon, Moraes, Dror and Shaw, Parallel random
/// numbers: as easy as 1, 2, 3 (2011), doi:10.1145/2063384.2063405. The simulations of the library
/// and the styles for LAMMPS draw from it.
#ifndef PW85_ALGEBRA_PHILOX_HPP_INCLUDED
#define PW85_ALGEBRA_PHILOX_HPP_INCLUDED

#include <cstdint>

#include <pw85/attributes.hpp>

namespace pw85::detail {

/// Four words: a counter, or the random words of this counter.
struct PhiloxWords {
    std::uint32_t word[4];
};

/// Returns the random words of a counter: a bijection of the counters for each key. Each of the ten
/// rounds multiplies two of the words and adds the key, which grows by a constant from round to
/// round.
[[gnu::always_inline]] PW85_FUNCTION inline PhiloxWords philox(PhiloxWords counter,
                                                               std::uint64_t key) noexcept
{
    auto low = static_cast<std::uint32_t>(key), high = static_cast<std::uint32_t>(key >> 32);
    auto &x = counter.word;
    for (int round = 0; round < 10; ++round, low += 0x9e3779b9u, high += 0xbb67ae85u) {
        std::uint64_t const first = std::uint64_t{0xd2511f53u} * x[0],
                            second = std::uint64_t{0xcd9e8d57u} * x[2];
        counter = {static_cast<std::uint32_t>(second >> 32) ^ x[1] ^ low,
                   static_cast<std::uint32_t>(second),
                   static_cast<std::uint32_t>(first >> 32) ^ x[3] ^ high,
                   static_cast<std::uint32_t>(first)};
    }
    return counter;
}

} // namespace pw85::detail

#endif
