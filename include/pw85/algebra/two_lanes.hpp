// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two numbers side by side, on which the same formula is computed. A function of one pair computes
/// with both forms, or tests two points, at once. contact/rational.hpp and overlap/quartic.hpp use
/// this file.
///
/// On processors with registers for two doubles, the two numbers are in one register. The source
/// does this explicitly, because compilers do it by themselves only with some flags.
#ifndef PW85_ALGEBRA_TWO_LANES_HPP_INCLUDED
#define PW85_ALGEBRA_TWO_LANES_HPP_INCLUDED

#include <pw85/algebra/symmetric.hpp>

namespace pw85::detail {

/// One truth value per lane.
template <class Mask> struct TwoMasks {
    Mask first, second;
};

/// A scalar of two lanes (scalar.hpp). It has the operations that the formulas of one pair need.
template <class T> struct TwoLanes {
    T first, second;

    TwoLanes() = default;
    PW85_MEMBER constexpr TwoLanes(T const &x, T const &y) noexcept : first(x), second(y) {}
    template <class Number> PW85_MEMBER constexpr explicit TwoLanes(Number const &x) noexcept
        : first(T(x)), second(T(x))
    {
    }
};

template <class T> PW85_FUNCTION constexpr T first_of(TwoLanes<T> const &x) noexcept
{
    return x.first;
}
template <class T> PW85_FUNCTION constexpr T second_of(TwoLanes<T> const &x) noexcept
{
    return x.second;
}

template <class T>
PW85_FUNCTION constexpr TwoLanes<T> operator+(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {x.first + y.first, x.second + y.second};
}
template <class T>
PW85_FUNCTION constexpr TwoLanes<T> operator-(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {x.first - y.first, x.second - y.second};
}
template <class T> PW85_FUNCTION constexpr TwoLanes<T> operator-(TwoLanes<T> const &x) noexcept
{
    return {-x.first, -x.second};
}
template <class T>
PW85_FUNCTION constexpr TwoLanes<T> operator*(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {T(x.first * y.first), T(x.second * y.second)};
}
template <class T>
PW85_FUNCTION constexpr TwoLanes<T> operator/(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {x.first / y.first, x.second / y.second};
}
template <class T>
PW85_FUNCTION constexpr auto operator<(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return TwoMasks<typename ScalarTraits<T>::Mask>{x.first < y.first, x.second < y.second};
}
template <class T>
PW85_FUNCTION constexpr auto operator>(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return y < x;
}
template <class T>
PW85_FUNCTION constexpr TwoLanes<T> maximum(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {maximum(x.first, y.first), maximum(x.second, y.second)};
}
template <class T>
PW85_FUNCTION constexpr TwoLanes<T> minimum(TwoLanes<T> const &x, TwoLanes<T> const &y) noexcept
{
    return {minimum(x.first, y.first), minimum(x.second, y.second)};
}

template <class T, class Mask> PW85_FUNCTION constexpr TwoLanes<T>
select(TwoMasks<Mask> const &mask, TwoLanes<T> const &yes, TwoLanes<T> const &no) noexcept
{
    return {select(mask.first, yes.first, no.first), select(mask.second, yes.second, no.second)};
}

template <class Mask> PW85_FUNCTION constexpr TwoMasks<Mask>
operator&&(TwoMasks<Mask> const &x, TwoMasks<Mask> const &y) noexcept
{
    return {x.first && y.first, x.second && y.second};
}
template <class Mask> PW85_FUNCTION constexpr bool any_of(TwoMasks<Mask> const &mask) noexcept
{
    return any_of(mask.first) || any_of(mask.second);
}
template <class Mask> PW85_FUNCTION constexpr bool all_of(TwoMasks<Mask> const &mask) noexcept
{
    return all_of(mask.first) && all_of(mask.second);
}

// For packs, one truth value per lane.

template <class Mask> PW85_FUNCTION constexpr Mask either_of(TwoMasks<Mask> const &mask) noexcept
{
    return mask.first || mask.second;
}
template <class Mask> PW85_FUNCTION constexpr Mask both_of(TwoMasks<Mask> const &mask) noexcept
{
    return mask.first && mask.second;
}

// Devices compute in scalars, and so do processors of 32 bits without SSE2.
#if (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)) &&                    \
    !defined(__CUDA__) && !defined(__CUDACC__)

/// The truth values of a comparison of two doubles: all bits of a lane are set, or none.
struct TwoLaneMask {
    typedef long long Bits __attribute__((vector_size(2 * sizeof(double))));

    Bits bits;
};

template <> struct TwoLanes<double> {
    typedef double Register __attribute__((vector_size(2 * sizeof(double))));

    Register lanes;

    TwoLanes() = default;
    PW85_MEMBER TwoLanes(Register x) noexcept : lanes(x) {}
    PW85_MEMBER TwoLanes(double x, double y) noexcept : lanes{x, y} {}
    PW85_MEMBER explicit TwoLanes(double x) noexcept : lanes{x, x} {}
};

PW85_FUNCTION inline double first_of(TwoLanes<double> const &x) noexcept { return x.lanes[0]; }
PW85_FUNCTION inline double second_of(TwoLanes<double> const &x) noexcept { return x.lanes[1]; }

PW85_FUNCTION inline TwoLanes<double> operator+(TwoLanes<double> const &x,
                                                TwoLanes<double> const &y) noexcept
{
    return x.lanes + y.lanes;
}
PW85_FUNCTION inline TwoLanes<double> operator-(TwoLanes<double> const &x,
                                                TwoLanes<double> const &y) noexcept
{
    return x.lanes - y.lanes;
}
PW85_FUNCTION inline TwoLanes<double> operator-(TwoLanes<double> const &x) noexcept
{
    return -x.lanes;
}
PW85_FUNCTION inline TwoLanes<double> operator*(TwoLanes<double> const &x,
                                                TwoLanes<double> const &y) noexcept
{
    return x.lanes * y.lanes;
}
PW85_FUNCTION inline TwoLanes<double> operator/(TwoLanes<double> const &x,
                                                TwoLanes<double> const &y) noexcept
{
    return x.lanes / y.lanes;
}
PW85_FUNCTION inline TwoLaneMask operator<(TwoLanes<double> const &x,
                                           TwoLanes<double> const &y) noexcept
{
    return {x.lanes < y.lanes};
}
PW85_FUNCTION inline TwoLanes<double> maximum(TwoLanes<double> const &x,
                                              TwoLanes<double> const &y) noexcept
{
    return y.lanes > x.lanes ? y.lanes : x.lanes;
}
PW85_FUNCTION inline TwoLanes<double> minimum(TwoLanes<double> const &x,
                                              TwoLanes<double> const &y) noexcept
{
    return y.lanes < x.lanes ? y.lanes : x.lanes;
}
PW85_FUNCTION inline TwoLanes<double> select(TwoLaneMask const &mask, TwoLanes<double> const &yes,
                                             TwoLanes<double> const &no) noexcept
{
    return mask.bits ? yes.lanes : no.lanes;
}

PW85_FUNCTION inline TwoLaneMask operator&&(TwoLaneMask const &x, TwoLaneMask const &y) noexcept
{
    return {x.bits & y.bits};
}
#ifdef __SSE2__
/// Returns the truth values as the two lowest bits.
PW85_FUNCTION inline int to_bits(TwoLaneMask const &mask) noexcept
{
    return __builtin_ia32_movmskpd((TwoLanes<double>::Register)mask.bits);
}
PW85_FUNCTION inline bool any_of(TwoLaneMask const &mask) noexcept { return to_bits(mask) != 0; }
PW85_FUNCTION inline bool all_of(TwoLaneMask const &mask) noexcept { return to_bits(mask) == 3; }
#else
PW85_FUNCTION inline bool any_of(TwoLaneMask const &mask) noexcept
{
    return (mask.bits[0] | mask.bits[1]) != 0;
}
PW85_FUNCTION inline bool all_of(TwoLaneMask const &mask) noexcept
{
    return (mask.bits[0] & mask.bits[1]) != 0;
}
#endif

PW85_FUNCTION inline bool either_of(TwoLaneMask const &mask) noexcept { return any_of(mask); }
PW85_FUNCTION inline bool both_of(TwoLaneMask const &mask) noexcept { return all_of(mask); }

/// Computes the same result as the function of two doubles, bitwise equal, without moves to other
/// registers.
PW85_FUNCTION inline double coarse_root_of_ratio(TwoLanes<double> const &x) noexcept
{
    typedef unsigned long long Bits __attribute__((vector_size(2 * sizeof(double))));
    constexpr auto one = __builtin_bit_cast(unsigned long long, 1.0);
    Bits const first = (Bits)x.lanes, second = {first[1], first[0]};
    return ((TwoLanes<double>::Register)((first - second + 2 * one) >> 1))[0];
}

#endif

/// The lanes exchanged.
template <class T> PW85_FUNCTION constexpr TwoLanes<T> swapped(TwoLanes<T> const &x) noexcept
{
    return {second_of(x), first_of(x)};
}

template <class T> PW85_FUNCTION constexpr TwoLanes<T> absolute(TwoLanes<T> const &x) noexcept
{
    return maximum(x, -x);
}

template <class T> PW85_FUNCTION inline TwoLanes<T> square_root(TwoLanes<T> const &x) noexcept
{
    return {square_root(first_of(x)), square_root(second_of(x))};
}

/// The sum of both lanes.
template <class T> PW85_FUNCTION constexpr T sum_of_lanes(TwoLanes<T> const &x) noexcept
{
    return first_of(x) + second_of(x);
}

/// √(first/second) with a relative error of 10 % at most.
template <class T> PW85_FUNCTION inline T coarse_root_of_ratio(TwoLanes<T> const &x) noexcept
{
    return coarse_root_of_ratio(first_of(x), second_of(x));
}

/// The type of a comparison.
template <class T> using MaskOfTwo = decltype(TwoLanes<T>() < TwoLanes<T>());

} // namespace pw85::detail

template <class T> struct pw85::ScalarTraits<pw85::detail::TwoLanes<T>> {
    using Lane = typename ScalarTraits<T>::Lane;
    using Mask = pw85::detail::MaskOfTwo<T>;
    static constexpr int lanes = 2;
};

namespace pw85::detail {

/// Two matrices side by side. This is not a loop, because compilers do not unroll all loops with
/// -O2.
template <class T, int D, int... k>
[[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<TwoLanes<T>, D>
side_by_side(SymmetricMatrix<T, D> const &first, SymmetricMatrix<T, D> const &second,
             std::integer_sequence<int, k...>) noexcept
{
    return {{TwoLanes<T>(first[k], second[k])...}};
}

template <class T, int D>
[[gnu::always_inline]] PW85_FUNCTION constexpr SymmetricMatrix<TwoLanes<T>, D>
side_by_side(SymmetricMatrix<T, D> const &first, SymmetricMatrix<T, D> const &second) noexcept
{
    return side_by_side(first, second,
                        std::make_integer_sequence<int, SymmetricMatrix<T, D>::size>());
}

/// Two vectors side by side.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr Vector<TwoLanes<T>, D>
side_by_side(Vector<T, D> const &first, Vector<T, D> const &second) noexcept
{
    Vector<TwoLanes<T>, D> both{};
    for (int i = 0; i < D; ++i) both[i] = TwoLanes<T>(first[i], second[i]);
    return both;
}

/// The sums of both lanes of the coordinates.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> sum_of_lanes(Vector<TwoLanes<T>, D> const &x) noexcept
{
    Vector<T, D> sum{};
    for (int i = 0; i < D; ++i) sum[i] = sum_of_lanes(x[i]);
    return sum;
}

/// The sums of both lanes of the entries.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
sum_of_lanes(SymmetricMatrix<TwoLanes<T>, D> const &a) noexcept
{
    SymmetricMatrix<T, D> sum{};
    for (int k = 0; k < sum.size; ++k) sum[k] = sum_of_lanes(a[k]);
    return sum;
}

} // namespace pw85::detail

#endif
