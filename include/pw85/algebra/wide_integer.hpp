// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Integers of any width, in memory that the caller provides. extended_number.hpp,
/// overlap/exact_numbers.hpp and overlap/exact_quartic.hpp use them. A sum has a fixed number of
/// limbs, the lowest one first. All operations are exact modulo 2^bits. So an intermediate overflow
/// is harmless if the result fits in two's complement.
#ifndef PW85_ALGEBRA_WIDE_INTEGER_HPP_INCLUDED
#define PW85_ALGEBRA_WIDE_INTEGER_HPP_INCLUDED

#include <pw85/attributes.hpp>

#include <bit>
#include <cstdint>
#include <limits>

namespace pw85::detail::exact {

#if defined(__SIZEOF_INT128__)
using Limb = std::uint64_t;
__extension__ typedef unsigned __int128 DoubleLimb;
__extension__ typedef __int128 SignedDoubleLimb;
#else
using Limb = std::uint32_t;
using DoubleLimb = std::uint64_t;
using SignedDoubleLimb = std::int64_t;
#endif

static constexpr int limb_bits = std::numeric_limits<Limb>::digits;

/// Returns the number of limbs for this number of bits.
PW85_FUNCTION constexpr int limbs_for(int bits) noexcept
{
    return (bits + limb_bits - 1) / limb_bits;
}

/// A small integer, Σ limbs[i] 2^(limb_bits·i).
template <int N> struct Digits {
    static constexpr int size = N;

    Limb limbs[std::size_t(N)];
};

template <int M, int N>
PW85_FUNCTION inline Digits<M + N> operator*(Digits<M> const &x, Digits<N> const &y) noexcept
{
    Digits<M + N> product{};
    for (int i = 0; i < M; ++i) {
        DoubleLimb carry = 0;
        for (int j = 0; j < N; ++j) {
            carry += product.limbs[i + j] + DoubleLimb{x.limbs[i]} * y.limbs[j];
            product.limbs[i + j] = static_cast<Limb>(carry);
            carry >>= limb_bits;
        }
        product.limbs[i + N] = static_cast<Limb>(carry);
    }
    return product;
}

/// x·2^exponent, for 0 <= exponent < limb_bits.
template <int N>
PW85_FUNCTION inline Digits<N + 1> times_power_of_two(Digits<N> const &x, int exponent) noexcept
{
    return x * Digits<1>{{Limb{1} << exponent}};
}

/// Returns the largest power of two that divides x > 0.
template <int N> PW85_FUNCTION inline int trailing_zeros(Digits<N> const &x) noexcept
{
    int i = 0;
    while (x.limbs[i] == 0) ++i;
    return i * limb_bits + __builtin_ctzll(x.limbs[i]);
}

/// x/2^exponent, rounded down, for 0 <= exponent < limb_bits·N.
template <int N>
PW85_FUNCTION inline Digits<N> over_power_of_two(Digits<N> const &x, int exponent) noexcept
{
    int const whole = exponent / limb_bits, bits = exponent % limb_bits;
    Digits<N> quotient{};
    for (int i = 0; i + whole < N; ++i) {
        Limb const low = x.limbs[i + whole],
                   high = i + whole + 1 < N ? x.limbs[i + whole + 1] : Limb{0};
        quotient.limbs[i] =
            bits == 0 ? low : static_cast<Limb>(low >> bits | high << (limb_bits - bits));
    }
    return quotient;
}

/// The integer sign·Σ limbs[i] 2^(limb_bits·i). The highest limb is not zero. Zero has no limbs.
struct WideInteger {
    Limb const *limbs;
    int size;
    int sign; ///< -1, 0 or 1
};

/// A sum to which products are added.
struct WideSum {
    Limb *limbs;
    int size;
};

/// Makes a sum with the value zero in the given memory.
PW85_FUNCTION inline WideSum zero_sum(Limb *memory, int size) noexcept
{
    for (int i = 0; i < size; ++i) memory[i] = 0;
    return {memory, size};
}

/// sum = -1 - sum. Between two calls, an addition to the sum acts as a subtraction.
PW85_FUNCTION inline void complement(WideSum sum) noexcept
{
    for (int i = 0; i < sum.size; ++i) sum.limbs[i] = ~sum.limbs[i];
}

/// sum += sign·2^(limb_bits·position)·x, sign = ±1.
template <int N>
PW85_FUNCTION inline void add(WideSum sum, Digits<N> const &x, int position, int sign) noexcept
{
    Limb const flip = sign < 0 ? ~Limb{0} : Limb{0};
    DoubleLimb const neutral = flip & 1;
    DoubleLimb carry = neutral;
    Limb *const limbs = sum.limbs + position;
    int const rest = sum.size - position;
    for (int i = 0; i < N && i < rest; ++i) {
        carry += DoubleLimb{limbs[i]} + (x.limbs[i] ^ flip);
        limbs[i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
    for (int i = N; i < rest && carry != neutral; ++i) {
        carry += DoubleLimb{limbs[i]} + flip;
        limbs[i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
}

/// sum += sign·x y, sign = ±1.
[[gnu::noinline]] PW85_FUNCTION inline void add_product(WideSum sum, int sign, WideInteger x,
                                                        WideInteger y) noexcept
{
    bool const negative = sign * x.sign * y.sign < 0;
    if (negative) complement(sum);
    for (int i = 0; i < x.size && i < sum.size; ++i) {
        Limb *const limbs = sum.limbs + i;
        int const rest = sum.size - i, size = y.size < rest ? y.size : rest;
        DoubleLimb carry = 0;
        for (int j = 0; j < size; ++j) {
            carry += limbs[j] + DoubleLimb{x.limbs[i]} * y.limbs[j];
            limbs[j] = static_cast<Limb>(carry);
            carry >>= limb_bits;
        }
        for (int j = size; j < rest && carry != 0; ++j) {
            carry += limbs[j];
            limbs[j] = static_cast<Limb>(carry);
            carry >>= limb_bits;
        }
    }
    if (negative) complement(sum);
}

/// sum *= factor.
PW85_FUNCTION inline void multiply(WideSum sum, Limb factor) noexcept
{
    DoubleLimb carry = 0;
    for (int i = 0; i < sum.size; ++i) {
        carry += DoubleLimb{sum.limbs[i]} * factor;
        sum.limbs[i] = static_cast<Limb>(carry);
        carry >>= limb_bits;
    }
}

/// Converts a sum to sign and magnitude. The memory of the sum then holds the magnitude.
PW85_FUNCTION inline WideInteger value(WideSum sum) noexcept
{
    // Each sum has limbs, which the analyser of Clang does not always see.
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult)
    bool const negative = sum.limbs[sum.size - 1] >> (limb_bits - 1) != 0;
    if (negative) {
        complement(sum);
        add(sum, Digits<1>{{1}}, 0, 1);
    }
    int size = sum.size;
    while (size > 0 && sum.limbs[size - 1] == 0) --size;
    return {sum.limbs, size, size == 0 ? 0 : negative ? -1 : 1};
}

/// A sum of up to 2^(limb_bits - 2) products of limbs. The low and the high halves of the products
/// are added separately, and neither sum overflows.
struct SumOfProducts {
    DoubleLimb low, high;
};

/// Returns the sum of the products that contribute to one limb of |x y|, without the carry from
/// lower limbs.
PW85_FUNCTION inline SumOfProducts column_of_product(WideInteger x, WideInteger y,
                                                     int column) noexcept
{
    SumOfProducts sum{};
    for (int i = column < y.size ? 0 : column - y.size + 1; i <= column && i < x.size; ++i) {
        DoubleLimb const product = DoubleLimb{x.limbs[i]} * y.limbs[column - i];
        sum.low += static_cast<Limb>(product);
        sum.high += product >> limb_bits;
    }
    return sum;
}

/// Returns the sign of |x y| - |u v|. It needs no memory for the products. The difference is
/// computed limb by limb, the lowest one first. Only two facts are kept: whether all limbs are
/// zero, and what the last limb borrows.
[[gnu::noinline]] PW85_FUNCTION inline int compare_products(WideInteger x, WideInteger y,
                                                            WideInteger u, WideInteger v) noexcept
{
    int const left = x.size + y.size, right = u.size + v.size,
              columns = left > right ? left : right;
    SignedDoubleLimb carry = 0;
    Limb any = 0;
    for (int k = 0; k < columns; ++k) {
        SumOfProducts const plus = column_of_product(x, y, k), minus = column_of_product(u, v, k);
        carry += static_cast<SignedDoubleLimb>(plus.low - minus.low);
        any |= static_cast<Limb>(carry);
        carry >>= limb_bits;
        carry += static_cast<SignedDoubleLimb>(plus.high - minus.high);
    }
    return carry < 0 ? -1 : any != 0;
}

} // namespace pw85::detail::exact

#endif
