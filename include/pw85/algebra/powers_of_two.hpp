// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exponents of numbers, and products with powers of two. These products are exact. The scaling of
/// pairs (contact/, motion/, distance/) and factor.hpp call them.
#ifndef PW85_ALGEBRA_POWERS_OF_TWO_HPP_INCLUDED
#define PW85_ALGEBRA_POWERS_OF_TWO_HPP_INCLUDED

#include <pw85/algebra/symmetric.hpp>

namespace pw85::detail {

/// The binary exponent n of a positive number: x·2^-n lies in [1, 2).
template <class T> PW85_FUNCTION inline int binary_exponent(T const &x) noexcept
{
    using elementary::ilogb;
    return ilogb(x);
}

/// Returns the binary exponent of a double, from its bits, because devices have no ilogb. A
/// subnormal number is first made normal.
PW85_FUNCTION inline int binary_exponent(double x) noexcept
{
    bool const subnormal = x < smallest_number<double>();
    auto const bits = __builtin_bit_cast(std::uint64_t, subnormal ? x * 0x1p54 : x);
    return static_cast<int>(bits >> 52 & 0x7ff) - (subnormal ? 1023 + 54 : 1023);
}

/// Half of the binary exponent, rounded down to n: x·4^-n lies in [1, 4).
template <class T> PW85_FUNCTION inline int half_exponent(T const &x) noexcept
{
    int const e = binary_exponent(x);
    return e >= 0 ? e / 2 : -((1 - e) / 2);
}

template <class T> PW85_FUNCTION inline T times_power_of_two(T const &x, int exponent) noexcept
{
    using elementary::ldexp;
    return ldexp(x, exponent);
}

/// Multiplies x[0] to x[N-1] by 2^exponent.
template <int N, class T>
PW85_FUNCTION inline void multiply_by_power_of_two(T *x, int exponent) noexcept
{
    for (int i = 0; i < N; ++i) x[i] = times_power_of_two(x[i], exponent);
}

/// Multiplies doubles by 2^exponent. It does not call ldexp, which devices do not have. The results
/// are rounded only once: if a step of 2^-969 gives a subnormal number, the remaining factor is at
/// most 2^-54 and gives zero.
template <int N>
PW85_FUNCTION inline void multiply_by_power_of_two(double *x, int exponent) noexcept
{
    for (; exponent > 1023; exponent -= 1023)
        for (int i = 0; i < N; ++i) x[i] = x[i] * 0x1p1023;
    for (; exponent < -1022; exponent += 969)
        for (int i = 0; i < N; ++i) x[i] = x[i] * 0x1p-969;
    double const factor =
        __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 + exponent) << 52);
    for (int i = 0; i < N; ++i) x[i] = x[i] * factor;
}

PW85_FUNCTION inline double times_power_of_two(double x, int exponent) noexcept
{
    multiply_by_power_of_two<1>(&x, exponent);
    return x;
}

template <class T, int D>
PW85_FUNCTION inline Vector<T, D> times_power_of_two(Vector<T, D> x, int exponent) noexcept
{
    if (exponent != 0) multiply_by_power_of_two<D>(x.coordinates, exponent);
    return x;
}

template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
times_power_of_two(SymmetricMatrix<T, D> a, int exponent) noexcept
{
    if (exponent != 0) multiply_by_power_of_two<a.size>(a.entries, exponent);
    return a;
}

} // namespace pw85::detail

#endif
