// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Counter-based random numbers: Philox4x32-10 of Salmon, Moraes, Dror and Shaw, Parallel random
/// numbers: as easy as 1, 2, 3 (2011), doi:10.1145/2063384.2063405. The moves of simulations,
/// random points of ellipsoids and the styles for LAMMPS draw from a Stream of them.
#ifndef PW85_ALGEBRA_PHILOX_HPP_INCLUDED
#define PW85_ALGEBRA_PHILOX_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/vector.hpp>

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

/// The random numbers of one task of one step. They depend on nothing but the seed,
/// the step and the task. There are 2³⁴ words.
class Stream {
  public:
    Stream() noexcept = default;
    [[gnu::always_inline]] Stream(std::uint64_t seed, std::uint64_t step,
                                  std::uint32_t task) noexcept
        : seed_(seed), counter_{{0, task, static_cast<std::uint32_t>(step),
                                 static_cast<std::uint32_t>(step >> 32)}}
    {
    }

    /// 32 random bits.
    [[gnu::always_inline]] std::uint32_t bits() noexcept
    {
        if (used_ == 4) {
            words_ = philox(counter_, seed_);
            ++counter_.word[0];
            used_ = 0;
        }
        return words_.word[used_++];
    }

    /// An integer from 0 to n - 1. The probabilities differ by less than 2⁻³². They do not depend
    /// on the state of the simulation: a move and its reverse are chosen with equal probability.
    [[gnu::always_inline]] std::uint32_t below(std::uint32_t n) noexcept
    {
        return static_cast<std::uint32_t>(std::uint64_t{bits()} * n >> 32);
    }

    /// Returns a multiple of 2⁻⁵³ from 0 up to but not including 1.
    [[gnu::always_inline]] double uniform() noexcept
    {
        std::uint64_t const high = bits(), low = bits();
        return static_cast<double>((high << 32 | low) >> 11) * 0x1p-53;
    }

    /// An odd multiple of 2⁻³² between -1 and 1. A number and its negative are equally probable.
    [[gnu::always_inline]] double symmetric() noexcept
    {
        return (2.0 * static_cast<std::int32_t>(bits()) + 1.0) * 0x1p-32;
    }

    /// Returns a point in the unit ball. A point and its negative are equally probable.
    [[gnu::always_inline]] Vector<double, 3> in_ball() noexcept
    {
        Vector<double, 3> x;
        do x = {symmetric(), symmetric(), symmetric()};
        while (dot(x, x) > 1.0);
        return x;
    }

    /// Returns a point in the unit disc of the plane of x and y. A point and its negative are
    /// equally probable. z is -0.0, because a sum with it, or with a positive multiple of it, keeps
    /// all bits of the other number; 0.0 would change -0.0.
    [[gnu::always_inline]] Vector<double, 3> in_disc() noexcept
    {
        Vector<double, 3> x;
        do x = {symmetric(), symmetric(), -0.0};
        while (dot(x, x) > 1.0);
        return x;
    }

    /// Returns a point of the unit ball of some dimensions: in_ball() or in_disc().
    [[gnu::always_inline]] Vector<double, 3> in_ball(int dimensions) noexcept
    {
        return dimensions == 2 ? in_disc() : in_ball();
    }

  private:
    std::uint64_t seed_ = 0;
    PhiloxWords counter_{}, words_{};
    int used_ = 4;
};

} // namespace pw85::detail

#endif
