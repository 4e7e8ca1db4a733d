// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Streams of random numbers (see philox.hpp). The moves of simulations and random points of
/// ellipsoids draw from a Stream.
#ifndef PW85_BASE_RANDOM_HPP_INCLUDED
#define PW85_BASE_RANDOM_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/philox.hpp>
#include <pw85/algebra/vector.hpp>

namespace pw85::detail {

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
