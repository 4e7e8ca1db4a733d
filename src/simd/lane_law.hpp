// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernels for laws: the energy U(μ²) of a pair and its derivative with respect to μ², one pair
/// per lane. lanes_laws.cpp defines them, and law_forces.hpp sums the results.
///
/// Each law has a function evaluate(). It gives NaN for NaN. Concentric ellipsoids have no force
/// for any law. So if U has no derivative at μ = 0, evaluate() gives 0 for it.
#ifndef PW85_SIMD_LANE_LAW_HPP_INCLUDED
#define PW85_SIMD_LANE_LAW_HPP_INCLUDED

#include "gather.hpp"
#include "power.hpp"

namespace pw85::detail {
namespace {

/// The energies of pairs, and the derivatives.
struct LawValues {
    Pack u, d_u;
};

/// The difference 1 - μ is computed from 1 - μ², which is exact near contact.
PW85_INLINE LawValues evaluate(kernels::SoftRepulsion const &law, Pack const &mu2) noexcept
{
    Pack const mu = square_root(mu2), gap = (Pack(1.0) - mu2) / (Pack(1.0) + mu);
    Pack const slope = Pack(law.energy) * power(gap, law.exponent - 1.0);
    Pack const u = Pack(slope * gap) / Pack(law.exponent), d_u = -slope / (mu + mu);
    PackMask const apart = mu2 >= Pack(1.0);
    return {select(apart, Pack(0.0), u), select(apart || mu2 == Pack(0.0), Pack(0.0), d_u)};
}

/// The smaller power is a factor: no infinities are subtracted at μ = 0.
PW85_INLINE LawValues evaluate(kernels::InversePowers const &law, Pack const &mu2) noexcept
{
    Pack const x = Pack(1.0) / mu2, weak = power(x, 0.5 * law.m),
               ratio = power(x, 0.5 * (law.n - law.m));
    Pack const u =
        weak * Pack(Pack(law.repulsion) * ratio - Pack(law.attraction)) - Pack(law.shift);
    Pack const slope = Pack(law.n * law.repulsion) * ratio - Pack(law.m * law.attraction);
    Pack const d_u = Pack(-0.5 * x) * Pack(weak * slope);
    PackMask const apart = mu2 >= Pack(law.mu2_max);
    return {select(apart, Pack(0.0), u), select(apart || mu2 == Pack(0.0), Pack(0.0), d_u)};
}

/// The intervals in which positions >= 0 are, as whole numbers in lanes, and the rows of their
/// first points. A position on a point may belong to either interval. The sum of a number and
/// `bias` is rounded to a whole number, whose low bits count from `bias`.
struct Intervals {
    Pack begin;
    double const *rows[lanes];

    PW85_INLINE Intervals(Pack const &position, double const *points) noexcept
    {
        constexpr double bias = 0x1.8p52;
        Pack const biased = (position - Pack(0.5)) + Pack(bias);
        begin = biased - Pack(bias);
        std::uint64_t bits[lanes];
        std::memcpy(bits, &biased.v, sizeof bits);
        for (std::size_t i = 0; i < lanes; ++i)
            rows[i] = points + 2 * (bits[i] - __builtin_bit_cast(std::uint64_t, bias));
    }
};

PW85_INLINE LawValues evaluate(kernels::LawTable const &law, Pack const &mu2) noexcept
{
    auto const count = static_cast<double>(law.intervals);
    double const width = (law.mu2_max - law.mu2_min) / count, per_interval = 1.0 / width;
    Pack const position = Pack(per_interval) * (mu2 - Pack(law.mu2_min));
    // The nearest position that has an interval behind it; 0 for NaN.
    Intervals const intervals(minimum(Pack(count - 1.0), maximum(Pack(0.0), position)), law.points);
    Pack p[4]; // value and derivative at both ends
    ColumnLoader<Pack, 4>::load(intervals.rows, p);
    Pack const x = position - intervals.begin, chord = Pack(per_interval) * (p[2] - p[0]);
    Pack const square = Pack(3.0) * chord - Pack(2.0) * p[1] - p[3],
               cube = p[1] + p[3] - Pack(2.0) * chord;
    PackMask const before = x < Pack(0.0), apart = mu2 >= Pack(law.mu2_max);
    // the mean derivative up to x
    Pack const mean = select(before, p[1], p[1] + x * Pack(square + x * cube));
    Pack const d_u =
        select(before, p[1], p[1] + x * Pack(Pack(2.0) * square + Pack(3.0 * x) * cube));
    Pack const u = p[0] + Pack(x * Pack(width)) * mean;
    return {select(apart, Pack(0.0), u), select(apart, Pack(0.0), d_u)};
}

} // namespace
} // namespace pw85::detail

#endif
