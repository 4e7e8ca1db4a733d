// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two numbers side by side (two_lanes.hpp) with twice the digits of doubles (doubled.hpp). Their
/// leading digits are in one register, and the other ones in another. In both lanes, each operation
/// is bitwise equal to that of Doubled<double>. volume/ uses this file.
#ifndef PW85_ALGEBRA_TWO_DOUBLED_HPP_INCLUDED
#define PW85_ALGEBRA_TWO_DOUBLED_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/algebra/two_lanes.hpp>

// Where TwoLanes<double> is a register. In WebAssembly the operations would make modules longer.
#if (defined(__SSE2__) || defined(__aarch64__)) && !defined(__CUDA__) && !defined(__CUDACC__)

namespace pw85::detail {

/// leading_bits() of both doubles.
PW85_FUNCTION inline TwoLanes<double> leading_bits(TwoLanes<double> const &x) noexcept
{
    typedef unsigned long long Bits __attribute__((vector_size(2 * sizeof(double))));
    Bits const bits = (Bits)x.lanes + 0x4000000ull;
    return TwoLanes<double>((TwoLanes<double>::Register)(bits & ~0x7ffffffull));
}

template <> struct TwoLanes<Doubled<double>> {
    Doubled<TwoLanes<double>> lanes;

    TwoLanes() = default;
    PW85_MEMBER TwoLanes(Doubled<TwoLanes<double>> const &x) noexcept : lanes(x) {}
    PW85_MEMBER TwoLanes(Doubled<double> const &x, Doubled<double> const &y) noexcept
        : lanes{{x.high, y.high}, {x.low, y.low}}
    {
    }
    PW85_MEMBER explicit TwoLanes(Doubled<double> const &x) noexcept : TwoLanes(x, x) {}
    PW85_MEMBER explicit TwoLanes(double x) noexcept : lanes(x) {}
};

using TwoDoubled = TwoLanes<Doubled<double>>;

PW85_FUNCTION inline Doubled<double> first_of(TwoDoubled const &x) noexcept
{
    return {first_of(x.lanes.high), first_of(x.lanes.low)};
}
PW85_FUNCTION inline Doubled<double> second_of(TwoDoubled const &x) noexcept
{
    return {second_of(x.lanes.high), second_of(x.lanes.low)};
}

PW85_FUNCTION inline TwoDoubled operator+(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return x.lanes + y.lanes;
}
PW85_FUNCTION inline TwoDoubled operator-(TwoDoubled const &x) noexcept { return -x.lanes; }
PW85_FUNCTION inline TwoDoubled operator-(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return x.lanes - y.lanes;
}
PW85_FUNCTION inline TwoDoubled operator*(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return x.lanes * y.lanes;
}
PW85_FUNCTION inline TwoDoubled operator/(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return x.lanes / y.lanes;
}
PW85_FUNCTION inline TwoLaneMask operator<(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    auto const &a = x.lanes, &b = y.lanes;
    return {(a.high.lanes < b.high.lanes) |
            ((a.high.lanes == b.high.lanes) & (a.low.lanes < b.low.lanes))};
}

PW85_FUNCTION inline TwoDoubled select(TwoLaneMask const &mask, TwoDoubled const &yes,
                                       TwoDoubled const &no) noexcept
{
    return Doubled<TwoLanes<double>>{select(mask, yes.lanes.high, no.lanes.high),
                                     select(mask, yes.lanes.low, no.lanes.low)};
}
PW85_FUNCTION inline TwoDoubled maximum(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return select(x < y, y, x);
}
PW85_FUNCTION inline TwoDoubled minimum(TwoDoubled const &x, TwoDoubled const &y) noexcept
{
    return select(y < x, y, x);
}

} // namespace pw85::detail

#endif
#endif
