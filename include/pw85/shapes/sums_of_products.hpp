// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sums of products of up to ten given numbers, and their signs, computed in integers.
/// exact_polytope.hpp uses these signs. Each product is added to one wide sum, so the memory is
/// small for all exponents.
#ifndef PW85_SHAPES_SUMS_OF_PRODUCTS_HPP_INCLUDED
#define PW85_SHAPES_SUMS_OF_PRODUCTS_HPP_INCLUDED

#include <pw85/overlap/exact.hpp>

namespace pw85::detail::exact {

/// The product of given numbers: sign·magnitude·2^exponent, with a magnitude below 2^length.
template <int N> struct Product {
    Digits<N> magnitude;
    int length, exponent, sign;
};

/// Returns the product of no numbers.
PW85_FUNCTION constexpr Product<1> unit_product() noexcept { return {{{1}}, 1, 0, 1}; }

template <int N> PW85_FUNCTION constexpr Product<N> operator-(Product<N> x) noexcept
{
    x.sign = -x.sign;
    return x;
}

template <int N, class T>
PW85_FUNCTION inline auto operator*(Product<N> const &x, BinaryFraction<T> const &y) noexcept
{
    auto const magnitude = x.magnitude * y.magnitude;
    return Product<magnitude.size>{magnitude, x.length + y.length, x.exponent + y.exponent,
                                   x.sign * y.sign};
}

/// Finds the range of the digits of products.
struct RangeOfProducts {
    BitRange range = no_digits();

    template <int N> PW85_MEMBER void operator()(Product<N> const &x) noexcept
    {
        if (x.sign == 0) return;
        range.low = minimum(range.low, x.exponent);
        range.high = maximum(range.high, x.exponent + x.length);
    }
};

/// Adds products to a sum in units of 2^unit.
struct SumOfAllProducts {
    WideSum sum;
    int unit;

    template <int N> PW85_MEMBER void operator()(Product<N> const &x) const noexcept
    {
        if (x.sign == 0) return;
        int const exponent = x.exponent - unit;
        add(sum, times_power_of_two(x.magnitude, exponent % limb_bits), exponent / limb_bits,
            x.sign);
    }
};

/// A sum whose sign decides has less than 2^15 terms. One more bit is for the sign.
inline constexpr int bits_for_terms = 16;

/// The limbs of these sums, for any numbers: a product has up to ten factors.
template <class T> PW85_FUNCTION constexpr int limbs_for_polytopes() noexcept
{
    using Limits = std::numeric_limits<T>;
    return limbs_for(10 * (Limits::max_exponent - Limits::min_exponent + Limits::digits) +
                     bits_for_terms);
}

/// Adds products in the given memory. terms(f) calls f for each product. The sum is in units of
/// 2^unit.
template <class Terms>
PW85_FUNCTION inline WideInteger sum_of_terms(Terms const &terms, Limb *memory, int &unit) noexcept
{
    RangeOfProducts found;
    terms(found);
    BitRange const range = found.range;
    unit = range.low;
    if (range.low > range.high) return {memory, 0, 0};
    SumOfAllProducts const total{
        zero_sum(memory, limbs_for(range.high - range.low + bits_for_terms)), range.low};
    terms(total);
    return value(total.sum);
}

/// The sign of a sum of products.
template <class T, class Terms>
[[gnu::noinline]] PW85_FUNCTION inline int sign_of_terms(Terms const &terms) noexcept
{
    Limb memory[limbs_for_polytopes<T>()];
    int unit;
    return sum_of_terms(terms, memory, unit).sign;
}

/// A sum of products, truncated to the digits of an extended number.
template <class T, class Terms>
[[gnu::noinline]] PW85_FUNCTION inline Extended<T> value_of_terms(Terms const &terms) noexcept
{
    Limb memory[limbs_for_polytopes<T>()];
    int unit;
    WideInteger const sum = sum_of_terms(terms, memory, unit);
    Digits<Extended<T>::size + 1> highest{};
    for (int i = 1; i <= highest.size && i <= sum.size; ++i)
        highest.limbs[highest.size - i] = sum.limbs[sum.size - i];
    return normalized<T>(highest, unit + sum.size * limb_bits, sum.sign);
}

} // namespace pw85::detail::exact

#endif
