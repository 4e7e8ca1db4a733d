// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A number that is the sum of two numbers of a narrower type, and so has about twice its digits.
/// The distances (distance/) and the solver of contact/ use it. The operators call error_free.hpp.
///
/// Let u be the unit roundoff of the narrower type. Sums err by less than 4u² times the magnitudes
/// of their terms. Products err by less than 8u² times their value, quotients and roots by less
/// than 16u² times theirs (M. Joldes, J.-M. Muller and V. Popescu, ACM Trans. Math. Softw. 44, 15,
/// 2017). Where an error would matter, only products of parts that are exact (error_free.hpp) are
/// added. So it makes no difference whether the compiler fuses them with additions. The range is
/// that of the narrower type. A result that overflows becomes NaN.
#ifndef PW85_ALGEBRA_DOUBLED_HPP_INCLUDED
#define PW85_ALGEBRA_DOUBLED_HPP_INCLUDED

#include <pw85/algebra/error_free.hpp>
#include <pw85/algebra/symmetric.hpp>

// In WebAssembly, which pages load, and in units that define PW85_SHORT_OPERATIONS, each operation
// is one function. Inlined, they would make the module of js/ a fifth longer.
#if defined(__wasm__) || defined(PW85_SHORT_OPERATIONS)
#define PW85_OPERATION [[gnu::noinline]] PW85_FUNCTION inline
#define PW85_OPERAND Doubled<T> const &
#elif defined(__clang__) && !defined(PW85_BUILDING) && !defined(__CUDACC__) && !defined(__CUDA__)
// In programs that include the headers as well: Clang would inline the operations in rare code, GCC
// does not. Registers pass the numbers.
#define PW85_OPERATION [[gnu::noinline]] PW85_FUNCTION inline
#define PW85_OPERAND Doubled<T> const
#else
#define PW85_OPERATION PW85_FUNCTION inline
#define PW85_OPERAND Doubled<T> const &
#endif

namespace pw85::detail {

template <class T> struct Doubled {
    T high, low; ///< |low| is at most u |high|

    Doubled() = default;
    template <class Number> PW85_MEMBER constexpr explicit Doubled(Number x) noexcept
        : high(T(x)), low(T(0))
    {
    }
    PW85_MEMBER constexpr Doubled(T const &leading, T const &rest) noexcept
        : high(leading), low(rest)
    {
    }
};

/// x + y, which is exact if |y| <= |x| (T. J. Dekker, Numer. Math. 18, 224, 1971).
template <class T> PW85_FUNCTION inline Doubled<T> ordered_sum(T const &x, T const &y) noexcept
{
    T const sum = x + y;
    return {sum, T(y - (sum - x))};
}

template <class T> PW85_OPERATION Doubled<T> operator+(PW85_OPERAND x, PW85_OPERAND y) noexcept
{
    CompensatedSum<T> c{x.high, T(0)};
    add(c, y.high);
    return ordered_sum(c.sum, T(c.rest + (x.low + y.low)));
}

template <class T> PW85_FUNCTION inline Doubled<T> operator-(Doubled<T> x) noexcept
{
    x.high = -x.high;
    x.low = -x.low;
    return x;
}

template <class T> PW85_OPERATION Doubled<T> operator-(PW85_OPERAND x, PW85_OPERAND y) noexcept
{
    return x + -y;
}

template <class T> PW85_OPERATION Doubled<T> operator*(PW85_OPERAND x, PW85_OPERAND y) noexcept
{
    Parts<T> const a = split(x.high), b = split(y.high);
    Doubled<T> const first = ordered_sum(T(a.high * b.high), T(a.high * b.low));
    Doubled<T> const second = ordered_sum(first.high, T(a.low * b.high));
    T const rest = a.low * b.low + (x.high * y.low + x.low * y.high);
    return ordered_sum(second.high, T(first.low + (second.low + rest)));
}

/// The quotient of the remainder is added to the first quotient and gives the missing digits.
template <class T> PW85_OPERATION Doubled<T> operator/(PW85_OPERAND x, PW85_OPERAND y) noexcept
{
    T const first = x.high / y.high, second = (x - y * Doubled<T>(first)).high / y.high;
    return ordered_sum(first, second);
}

template <class T> PW85_OPERATION Doubled<T> sqrt(PW85_OPERAND x) noexcept
{
    T const root = square_root(x.high);
    if (!(root > T(0))) return Doubled<T>(root);
    return ordered_sum(root, T((x - Doubled<T>(root) * Doubled<T>(root)).high / (root + root)));
}

template <class T>
PW85_FUNCTION inline bool operator<(Doubled<T> const &x, Doubled<T> const &y) noexcept
{
    return x.high < y.high || (x.high == y.high && x.low < y.low);
}

template <class T>
PW85_FUNCTION inline bool operator==(Doubled<T> const &x, Doubled<T> const &y) noexcept
{
    return x.high == y.high && x.low == y.low;
}

template <class T>
PW85_FUNCTION inline bool operator<=(Doubled<T> const &x, Doubled<T> const &y) noexcept
{
    return x < y || x == y;
}

template <class T>
PW85_FUNCTION inline bool operator>(Doubled<T> const &x, Doubled<T> const &y) noexcept
{
    return y < x;
}

template <class T>
PW85_FUNCTION inline bool operator>=(Doubled<T> const &x, Doubled<T> const &y) noexcept
{
    return y <= x;
}

template <class T> PW85_FUNCTION inline Doubled<T> abs(Doubled<T> const &x) noexcept
{
    return x.high < T(0) ? -x : x;
}

/// The type with about twice the digits of a hardware type. For other types, which have digits to
/// spare, Finer is the type itself.
template <class T> using Finer =
    std::conditional_t<std::is_floating_point_v<typename ScalarTraits<T>::Lane>, Doubled<T>, T>;

/// Rounds a number to a type with fewer digits.
template <class T> PW85_FUNCTION constexpr T rounded(Doubled<T> const &x) noexcept
{
    return x.high;
}
template <class T> PW85_FUNCTION constexpr T rounded(T const &x) noexcept { return x; }

template <class T, int D> PW85_FUNCTION constexpr auto rounded(Vector<T, D> const &x) noexcept
{
    Vector<decltype(rounded(x[0])), D> y{};
    for (int i = 0; i < D; ++i) y[i] = rounded(x[i]);
    return y;
}

} // namespace pw85::detail

namespace pw85 {

/// Results are computed to the digits of T. Only distances need more digits.
template <class T>
requires std::is_floating_point_v<T>
struct ScalarTraits<detail::Doubled<T>> {
    using Lane = detail::Doubled<T>;
    using Mask = bool;
    static constexpr int lanes = 1;
    static constexpr int result_digits = std::numeric_limits<T>::digits;
};

} // namespace pw85

/// The digits are two fewer than those of two mantissas, because of the rounding errors of a
/// product.
template <class T> struct std::numeric_limits<pw85::detail::Doubled<T>>
    : std::numeric_limits<typename pw85::ScalarTraits<T>::Lane> {
    static constexpr int digits = 2 * pw85::detail::mantissa_digits<T>() - 2;
    PW85_MEMBER static constexpr pw85::detail::Doubled<T> epsilon() noexcept
    {
        T const u = T(pw85::detail::unit_roundoff<T>());
        return pw85::detail::Doubled<T>(T(T(8) * u) * u);
    }
    PW85_MEMBER static constexpr pw85::detail::Doubled<T>(max)() noexcept
    {
        return pw85::detail::Doubled<T>(pw85::detail::largest_number<T>());
    }
    PW85_MEMBER static constexpr pw85::detail::Doubled<T>(min)() noexcept
    {
        return pw85::detail::Doubled<T>(pw85::detail::smallest_number<T>());
    }
    // NOLINTNEXTLINE(readability-identifier-naming): numeric_limits calls it that
    PW85_MEMBER static constexpr pw85::detail::Doubled<T> quiet_NaN() noexcept
    {
        return pw85::detail::Doubled<T>(pw85::detail::quiet_nan<T>());
    }
};

#undef PW85_OPERATION
#undef PW85_OPERAND

#endif
