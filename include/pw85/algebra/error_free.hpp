// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Error-free transformations: sums and products together with their rounding errors. doubled.hpp,
/// contact/refinement.hpp, contact/enclosure.hpp and motion/approach.hpp call them.
#ifndef PW85_ALGEBRA_ERROR_FREE_HPP_INCLUDED
#define PW85_ALGEBRA_ERROR_FREE_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// A number as the sum of two parts. Products of such parts are exact: it makes no difference
/// whether the compiler fuses them with an addition.
template <class T> struct Parts {
    T high, low;
};

/// Rounds the first part to 26 bits. The second part has the other 26 of the 53 bits, and a sign.
PW85_FUNCTION inline double leading_bits(double x) noexcept
{
    std::uint64_t const bits = __builtin_bit_cast(std::uint64_t, x) + 0x4000000;
    return __builtin_bit_cast(double, bits & ~std::uint64_t{0x7ffffff});
}

PW85_FUNCTION inline float leading_bits(float x) noexcept
{
    return __builtin_bit_cast(float, __builtin_bit_cast(std::uint32_t, x) & ~std::uint32_t{0xfff});
}

/// Computes the leading bits by the algorithm of T. J. Dekker, Numer. Math. 18, 224 (1971), for
/// types whose products are never fused.
template <class T> PW85_FUNCTION inline T leading_bits(T const &x) noexcept
{
    T const scaled = x * (T(1) + T(1) / negative_power_of_two<T>((mantissa_digits<T>() + 1) / 2));
    return scaled - (scaled - x);
}

template <class T> PW85_FUNCTION inline Parts<T> split(T const &x) noexcept
{
    T const high = leading_bits(x);
    return {high, x - high};
}

/// A sum and its rounding error (D. E. Knuth, The Art of Computer Programming 2, 4.2.2).
template <class T> struct CompensatedSum {
    T sum, rest;
};

template <class T> PW85_FUNCTION inline void add(CompensatedSum<T> &c, T const &x) noexcept
{
    T const sum = c.sum + x, part = sum - c.sum;
    c.rest = c.rest + ((c.sum - (sum - part)) + (x - part));
    c.sum = sum;
}

/// x y as the sum of two numbers. The error is at most 2u² |x y|: the second number is rounded.
template <class T> PW85_FUNCTION inline Parts<T> exact_product(T const &x, T const &y) noexcept
{
    Parts<T> const a = split(x), b = split(y);
    CompensatedSum<T> sum{a.high * b.high, T(0)};
    add(sum, T(a.high * b.low));
    add(sum, T(a.low * b.high));
    return {sum.sum, T(sum.rest + a.low * b.low)};
}

// Processors that fuse operations compute both numbers at once. The addition of zero keeps the
// compiler from fusing the product with an addition that follows.
#if defined(__FP_FAST_FMA)
PW85_FUNCTION inline Parts<double> exact_product(double const &x, double const &y) noexcept
{
    double const high = __builtin_fma(x, y, 0.0);
    return {high, __builtin_fma(x, y, -high)};
}
#endif
#if defined(__FP_FAST_FMAF)
PW85_FUNCTION inline Parts<float> exact_product(float const &x, float const &y) noexcept
{
    float const high = __builtin_fmaf(x, y, 0.0f);
    return {high, __builtin_fmaf(x, y, -high)};
}
#endif

/// Adds x y to a sum.
template <class T>
PW85_FUNCTION inline void add_product(CompensatedSum<T> &c, T const &x, T const &y) noexcept
{
    Parts<T> const product = exact_product(x, y);
    add(c, product.high);
    c.rest = c.rest + product.low;
}

template <class T> PW85_FUNCTION inline void
subtract_product(CompensatedSum<T> &c, Parts<T> const &x, Parts<T> const &y) noexcept
{
    add(c, T(-(x.high * y.high)));
    add(c, T(-(x.high * y.low)));
    add(c, T(-(x.low * y.high)));
    add(c, T(-(x.low * y.low)));
}

} // namespace pw85::detail

#endif
