// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Powers of the numbers of a pack. lanes/laws.hpp calls power(). Functions of the C library
/// are not used, because those of different libraries differ in their last bits, and because they
/// take one number at a time.
///
/// x^y = e^z, z = y log x. z is a sum of two numbers (doubled.hpp) with an error of less than 2^-66
/// |z|, and |z| < 2^10 where the result is in the range of double. So the relative error from that
/// of z is below 2^-56. The sum 1 + (e^r - 1) of exponential() adds less than 1.8 u. The relative
/// error of a power is less than 2 u.
#ifndef PW85_SIMD_POWER_HPP_INCLUDED
#define PW85_SIMD_POWER_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>

#include "pack.hpp"

namespace pw85::detail {
namespace {

using IntegerRegister = VectorOf<lanes>::Integers;

PW85_INLINE IntegerRegister to_bits(Pack const &x) noexcept
{
    return reinterpret_cast<IntegerRegister>(x.v);
}
PW85_INLINE Pack from_bits(IntegerRegister bits) noexcept
{
    return reinterpret_cast<Register>(bits);
}

/// Adding this to an integer, |n| < 2^51, puts it into the last bits of the sum.
inline constexpr double integer_shift = 0x1.8p52;

PW85_INLINE Pack nearest_integers(Pack const &x) noexcept
{
    return (x + Pack(integer_shift)) - Pack(integer_shift);
}

/// 2^n for integers n from -1022 to 1023.
PW85_INLINE Pack power_of_two(Pack const &n) noexcept
{
    return from_bits((to_bits(n + Pack(integer_shift)) << 52) + to_bits(Pack(1.0)));
}

/// A positive normal number as mantissa·2^exponent, with a mantissa from √½ to √2.
struct Scientific {
    Pack mantissa, exponent;
};

PW85_INLINE Scientific scientific(Pack const &x) noexcept
{
    IntegerRegister const least = to_bits(Pack(0x1.6a09e667f3bcdp-1)),
                          exponent = (to_bits(x) - least) >> 52;
    Pack const shifted = from_bits(exponent + to_bits(Pack(integer_shift)));
    return {from_bits(to_bits(x) - (exponent << 52)), shifted - Pack(integer_shift)};
}

/// log 2 in two parts. The first one has 42 bits; its product with an exponent is exact.
inline constexpr double log2_high = 0x1.62e42fefa38p-1, log2_low = 0x1.ef35793c7673p-45;

/// log x for a positive normal number, with a relative error of less than 2^-66. With m = mantissa
/// and s = (m - 1)/(m + 1), |s| < 0.172, log m = 2s + 2s³ (1/3 + s²/5 + s⁴/7 ...). The terms from
/// s⁶/7 on need no more than one number: they are less than 2^-18 of the sum and err by less than 4
/// u. The terms beyond s^26/27 are less than 2^-73 of it.
PW85_INLINE Doubled<Pack> logarithm(Pack const &x) noexcept
{
    using D = Doubled<Pack>;
    auto const [m, exponent] = scientific(x);
    D const s = D(Pack(m - Pack(1.0))) / (D(m) + D(1.0)), square = s * s;
    Pack const w = square.high;
    Pack tail = Pack(1.0 / 27.0);
    for (int n = 25; n >= 7; n -= 2) tail = Pack(1.0 / n) + w * tail;
    D const third(Pack(0x1.5555555555555p-2), Pack(0x1.5555555555555p-56));
    D const fifth(Pack(0x1.999999999999ap-3), Pack(-0x1.999999999999ap-57));
    D const series = s + s * (square * (third + square * (fifth + square * D(tail))));
    D const whole = ordered_sum(Pack(exponent * Pack(log2_high)), Pack(exponent * Pack(log2_low)));
    return whole + (series + series);
}

/// e^z for |z| < 1000. With z = n log 2 + r, |r| < 0.347, the series of e^r is truncated after
/// r^14/14!, by less than 2^-63.
PW85_INLINE Pack exponential(Doubled<Pack> const &z) noexcept
{
    using D = Doubled<Pack>;
    Pack const n = nearest_integers(Pack(z.high * Pack(0x1.71547652b82fep+0)));
    D const r = (z - D(Pack(n * Pack(log2_high)))) - D(Pack(n * Pack(log2_low)));
    Pack const h = r.high;
    double factorial = 87178291200.0; // 14!
    Pack series = Pack(1.0 / factorial);
    for (int k = 14; k > 2; --k) {
        factorial /= k;
        series = Pack(1.0 / factorial) + h * series;
    }
    Pack const power = Pack(1.0) + (h + (Pack(h * h) * series + r.low * Pack(Pack(1.0) + h)));
    Pack const first = nearest_integers(Pack(Pack(0.5) * n));
    return Pack(power * power_of_two(first)) * power_of_two(n - first);
}

/// x^y for x from 0 to infinity; NaN for other x. The logarithm of a number that is not 1 is above
/// 2^-54, and e^±800 is not in the range of double. So larger exponents y than 2^64 give what 2^64
/// gives.
[[gnu::noinline]] inline Register general_power(Register numbers, double exponent) noexcept
{
    using D = Doubled<Pack>;
    Pack const x = numbers;
    PackMask const tiny = x < Pack(smallest_number<double>());
    Doubled<Pack> const log = logarithm(select(tiny, Pack(x * Pack(0x1p54)), x));
    Pack const tiny_high = select(tiny, Pack(-54.0 * log2_high), Pack(0.0)),
               tiny_low = select(tiny, Pack(-54.0 * log2_low), Pack(0.0));
    double const y = exponent > 0x1p64 ? 0x1p64 : exponent < -0x1p64 ? -0x1p64 : exponent;
    D const z = D(y) * (D(tiny_high, tiny_low) + log);
    PackMask const in_range = absolute(z.high) <= Pack(800.0);
    Pack const limited = maximum(Pack(-800.0), minimum(Pack(800.0), z.high));
    Pack const power = exponential({limited, select(in_range, z.low, Pack(0.0))});
    Pack const of_zero = Pack(y > 0.0   ? 0.0
                              : y < 0.0 ? infinity<double>()
                                        : 1.0),
               of_infinity = Pack(y > 0.0   ? infinity<double>()
                                  : y < 0.0 ? 0.0
                                            : 1.0);
    Pack const special = select(x == Pack(0.0), of_zero,
                                select(x > Pack(0.0), of_infinity, Pack(quiet_nan<double>())));
    return select(x > Pack(0.0) && x <= Pack(largest_number<double>()), power, special).v;
}

/// A power of x >= 0. For multiples of 1/2 up to 32 it is a product of factors x^(2^k) and a root.
/// To first order, the relative error of x^(2^k) is at most (2^k - 1) u, and that of the root is u.
/// There are at most six products. So the whole error is less than (exponent + 7) u.
PW85_INLINE Pack power(Pack x, double exponent) noexcept
{
    bool const is_product =
        exponent >= 0.0 && exponent <= 32.0 && 2.0 * exponent == static_cast<int>(2.0 * exponent);
    if (!is_product) return general_power(x.v, exponent);
    int const halves = static_cast<int>(2.0 * exponent);
    Pack result = halves % 2 == 0 ? Pack(1.0) : square_root(x);
    for (int n = halves / 2; n != 0; n /= 2, x = x * x)
        if (n % 2 == 1) result = result * x;
    return result;
}

} // namespace
} // namespace pw85::detail

#endif
