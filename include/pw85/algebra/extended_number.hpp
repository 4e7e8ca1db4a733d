// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Floating-point numbers with seven times the digits of a native type, computed in integers.
/// definite.hpp and overlap/exact.hpp use them for pairs that are too nearly singular for the
/// native type. The operators call wide_integer.hpp. Rounding modes, compiler options and
/// instruction sets do not change a bit of the results. The operators are compiled for speed
/// (`gnu::hot`). The formulas that call them are compiled for size (`gnu::cold`), because few pairs
/// need them and each translation unit contains them.
#ifndef PW85_ALGEBRA_EXTENDED_NUMBER_HPP_INCLUDED
#define PW85_ALGEBRA_EXTENDED_NUMBER_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>
#include <pw85/algebra/wide_integer.hpp>

namespace pw85::detail::exact {

/// The supported native formats: those of IEEE 754, and the x87 format with 64 digits.
template <class T> static constexpr bool is_decidable = std::is_floating_point_v<T> &&
                                                        (std::numeric_limits<T>::digits == 24 ||
                                                         std::numeric_limits<T>::digits == 53 ||
                                                         std::numeric_limits<T>::digits == 64 ||
                                                         std::numeric_limits<T>::digits == 113);

/// The sign of a number that is not finite.
inline constexpr int undefined_sign = 2;

/// Reads a native number x = sign·mantissa/2^(limb_bits·N)·2^exponent, exactly if it is finite, and
/// returns the sign. For zero and for numbers that are not finite, the mantissa and the exponent
/// become zero.
template <class Native, int N>
PW85_FUNCTION inline int read_digits(Native x, Digits<N> &mantissa, int &exponent) noexcept
{
    mantissa = {};
    exponent = 0;
    if (!(x * Native(0) == Native(0))) return undefined_sign;
    if (x == Native(0)) return 0;
    exponent = binary_exponent(absolute(x)) + 1;
    Native fraction = pw85::detail::times_power_of_two(absolute(x), -exponent);
    constexpr auto radix = Native(2) * static_cast<Native>(Limb{1} << (limb_bits - 1));
    for (int i = N - 1; i >= 0 && fraction > Native(0); --i) {
        fraction = fraction * radix;
        mantissa.limbs[i] = static_cast<Limb>(fraction);
        fraction = fraction - static_cast<Native>(mantissa.limbs[i]);
    }
    return x > Native(0) ? 1 : -1;
}

template <class T> struct Extended;

/// Converts a native number. It is not inlined: formulas have many constants, and each would take
/// 170 bytes.
template <class Native, class T>
[[gnu::noinline]] PW85_FUNCTION inline void read(Native number, Extended<T> &x) noexcept
{
    x.sign = read_digits(number, x.mantissa, x.exponent);
}

/// The number sign·m·2^exponent with m = mantissa/2^bits in [1/2, 1). The number is zero if the
/// sign is zero, and NaN if the sign is `undefined`. There is no infinity. Results are truncated.
/// The relative error of a sum or product is at most 2^(1-bits).
template <class T> struct Extended {
    static constexpr int size = limbs_for(7 * std::numeric_limits<T>::digits);
    static constexpr int bits = size * limb_bits;
    static constexpr int undefined = undefined_sign;

    Digits<size> mantissa;
    int exponent;
    int sign; ///< -1, 0, 1 or undefined

    Extended() noexcept = default;

    /// Converts a finite native number exactly, and others to NaN. Constants may have another type
    /// than `T`.
    template <class Number>
    requires std::is_arithmetic_v<Number> PW85_MEMBER explicit Extended(Number number) noexcept
    {
        using Native = std::conditional_t<std::is_integral_v<Number>, double, Number>;
        read(static_cast<Native>(number), *this);
    }

    PW85_MEMBER bool is_defined() const noexcept { return sign != undefined; }
};

template <class T> PW85_FUNCTION inline Extended<T> not_a_number() noexcept
{
    Extended<T> x(0);
    x.sign = Extended<T>::undefined;
    return x;
}

/// Returns the number of zero bits above the highest bit that is set. For zero, all bits are
/// counted.
template <int N> PW85_FUNCTION inline int leading_zeros(Digits<N> const &x) noexcept
{
    int i = N - 1;
    while (i > 0 && x.limbs[i] == 0) --i;
    return (N - 1 - i) * limb_bits + std::countl_zero(x.limbs[i]);
}

/// x·2^exponent modulo 2^(limb_bits·N), for 0 <= exponent < limb_bits·N.
template <int N>
PW85_FUNCTION inline Digits<N> shifted_up(Digits<N> const &x, int exponent) noexcept
{
    int const whole = exponent / limb_bits, bits = exponent % limb_bits;
    Digits<N> result{};
    for (int i = N - 1; i >= whole; --i) {
        Limb const high = x.limbs[i - whole], low = i > whole ? x.limbs[i - whole - 1] : Limb{0};
        result.limbs[i] =
            bits == 0 ? high : static_cast<Limb>(high << bits | low >> (limb_bits - bits));
    }
    return result;
}

/// sign·x/2^(limb_bits·N)·2^exponent, truncated.
template <class T, int N>
PW85_FUNCTION inline Extended<T> normalized(Digits<N> const &x, int exponent, int sign) noexcept
{
    int const zeros = leading_zeros(x);
    Extended<T> result(0);
    if (zeros == N * limb_bits) return result;
    auto const shifted = shifted_up(x, zeros);
    for (int i = 0; i < result.size; ++i)
        result.mantissa.limbs[i] = shifted.limbs[N - result.size + i];
    result.exponent = exponent - zeros;
    result.sign = sign;
    return result;
}

/// The limbs of the guard below the mantissa. The guard has 64 bits for limbs of any width, so
/// results are truncated at the same bit.
inline constexpr int guard_limbs = limbs_for(64);

/// The mantissa divided by 2^exponent, with a guard below it and one limb above.
template <class T>
PW85_FUNCTION inline auto with_guards(Extended<T> const &x, int exponent) noexcept
{
    constexpr int size = Extended<T>::size + guard_limbs + 1;
    Digits<size> result{};
    for (int i = 0; i < x.size; ++i) result.limbs[i + guard_limbs] = x.mantissa.limbs[i];
    return exponent < size * limb_bits ? over_power_of_two(result, exponent) : Digits<size>{};
}

/// x + sign·y for numbers Σ limbs in two's complement, with sign = ±1.
template <int N>
PW85_FUNCTION inline Digits<N> sum(Digits<N> x, Digits<N> const &y, int sign) noexcept
{
    add(WideSum{x.limbs, N}, y, 0, sign);
    return x;
}

/// The sum if |x| has the larger exponent. If y is shifted by more than one bit, |y| is smaller
/// than half of |x|. Then the result loses at most one leading bit, and the bits that are truncated
/// below the guard do not matter.
template <class T> [[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T>
add_ordered(Extended<T> const &x, Extended<T> const &y) noexcept
{
    auto result = sum(with_guards(x, 0), with_guards(y, x.exponent - y.exponent), x.sign * y.sign);
    int const exponent = x.exponent + limb_bits; // includes the limb above
    if (result.limbs[result.size - 1] >> (limb_bits - 1) == 0)
        return normalized<T>(result, exponent, x.sign);
    return normalized<T>(sum(Digits<result.size>{}, result, -1), exponent, -x.sign);
}

template <class T> [[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T>
operator+(Extended<T> const &x, Extended<T> const &y) noexcept
{
    if (!x.is_defined() || !y.is_defined()) return not_a_number<T>();
    if (x.sign == 0) return y;
    if (y.sign == 0) return x;
    return x.exponent >= y.exponent ? add_ordered(x, y) : add_ordered(y, x);
}

template <class T>
[[gnu::noinline]] PW85_FUNCTION inline Extended<T> operator-(Extended<T> const &x) noexcept
{
    Extended<T> result = x;
    if (x.is_defined()) result.sign = -x.sign;
    return result;
}

template <class T> [[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T>
operator-(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return x + -y;
}

template <class T> [[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T>
operator*(Extended<T> const &x, Extended<T> const &y) noexcept
{
    if (!x.is_defined() || !y.is_defined()) return not_a_number<T>();
    if (x.sign == 0 || y.sign == 0) return Extended<T>(0);
    return normalized<T>(x.mantissa * y.mantissa, x.exponent + y.exponent, x.sign * y.sign);
}

/// The nearest native number, up to an error of 2^-16 ulp. Outside the range of `T` the result is
/// infinity or zero. The mantissa is read in pieces that `T` represents exactly and that divide
/// limbs of any width. The result does not depend on this width.
template <class T> PW85_FUNCTION inline T rounded(Extended<T> const &x) noexcept
{
    if (!x.is_defined()) return quiet_nan<T>();
    constexpr int piece_bits = std::numeric_limits<T>::digits < 32 ? 16 : 32,
                  pieces = limb_bits / piece_bits;
    constexpr Limb mask = (Limb{1} << (piece_bits - 1)) * 2 - 1;
    constexpr T unit = T(1) / static_cast<T>(std::uint64_t{1} << piece_bits);
    T fraction = T(0);
    for (int i = 0; i < x.size * pieces; ++i) {
        Limb const piece = (x.mantissa.limbs[i / pieces] >> (i % pieces * piece_bits)) & mask;
        fraction = (fraction + static_cast<T>(piece)) * unit;
    }
    return pw85::detail::times_power_of_two(T(static_cast<T>(x.sign) * fraction), x.exponent);
}

/// x with another exponent, chosen so that the result is in [1/2, 1), or half or twice as large.
template <class T>
PW85_FUNCTION inline Extended<T> with_exponent(Extended<T> x, int exponent) noexcept
{
    x.exponent = exponent;
    return x;
}

/// The number of Newton steps from the digits of `T` to all digits. Each step doubles the number of
/// correct digits. Three steps give eight times the digits, and seven times are needed.
inline constexpr int newton_steps = 3;

/// 1/x with a relative error of some 2^-bits, for x != 0.
template <class T> [[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T>
reciprocal(Extended<T> const &x) noexcept
{
    auto const m = with_exponent(x, 0), one = Extended<T>(1);
    Extended<T> y(T(1) / rounded(m));
    for (int n = 0; n < newton_steps; ++n) y = y + y * (one - m * y);
    return with_exponent(y, y.exponent - x.exponent);
}

template <class T>
PW85_FUNCTION inline Extended<T> operator/(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return y.sign == 0 ? not_a_number<T>() : x * reciprocal(y);
}

template <class T>
[[gnu::noinline, gnu::hot]] PW85_FUNCTION inline Extended<T> sqrt(Extended<T> const &x) noexcept
{
    if (x.sign == 0) return x;
    if (x.sign != 1) return not_a_number<T>();
    int const odd = x.exponent & 1; // correct for negative exponents as well
    auto const m = with_exponent(x, odd), three = Extended<T>(3), half = Extended<T>(0.5);
    Extended<T> y(T(1) / square_root(rounded(m)));
    for (int n = 0; n < newton_steps; ++n) y = half * (y * (three - m * (y * y)));
    auto const root = m * y;
    return with_exponent(root, root.exponent + (x.exponent - odd) / 2);
}

PW85_RARE_TIER_OF(operator+, double)
PW85_RARE_TIER_OF(operator*, double)
PW85_RARE_TIER_OF(reciprocal, double)
PW85_RARE_TIER_OF(sqrt, double)

template <class T>
[[gnu::noinline]] PW85_FUNCTION inline Extended<T> abs(Extended<T> const &x) noexcept
{
    return x.sign == -1 ? -x : x;
}

template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool
operator<(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return (x - y).sign == -1;
}
template <class T>
PW85_FUNCTION inline bool operator>(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return y < x;
}
template <class T> [[gnu::noinline]] PW85_FUNCTION inline bool
operator<=(Extended<T> const &x, Extended<T> const &y) noexcept
{
    int const sign = (x - y).sign;
    return sign == -1 || sign == 0;
}
template <class T>
PW85_FUNCTION inline bool operator>=(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return y <= x;
}
template <class T>
PW85_FUNCTION inline bool operator==(Extended<T> const &x, Extended<T> const &y) noexcept
{
    return (x - y).sign == 0;
}

} // namespace pw85::detail::exact

namespace pw85 {

template <class T> struct ScalarTraits<detail::exact::Extended<T>> {
    using Lane = detail::exact::Extended<T>;
    using Mask = bool;
    static constexpr int lanes = 1;
    static constexpr int result_digits = std::numeric_limits<T>::digits;
};

} // namespace pw85

/// The range is declared as that of the native type, although exponents can be much larger. The
/// declared digits are fewer than the bits, because quotients and roots lose some. Those of float
/// err by up to 2^(12-bits), because eight times its 24 digits are only 192.
template <class T> class std::numeric_limits<pw85::detail::exact::Extended<T>> {
    using Extended = pw85::detail::exact::Extended<T>;

  public:
    static constexpr bool is_specialized = true, is_integer = false;
    static constexpr int digits = Extended::bits - 16,
                         min_exponent = std::numeric_limits<T>::min_exponent,
                         max_exponent = std::numeric_limits<T>::max_exponent;

    PW85_MEMBER static Extended(max)() noexcept
    {
        return Extended(pw85::detail::largest_number<T>());
    }
    PW85_MEMBER static Extended(min)() noexcept
    {
        return Extended(pw85::detail::smallest_number<T>());
    }
    // NOLINTNEXTLINE(readability-identifier-naming): numeric_limits calls it that
    PW85_MEMBER static Extended quiet_NaN() noexcept
    {
        return pw85::detail::exact::not_a_number<T>();
    }
    PW85_MEMBER static Extended epsilon() noexcept
    {
        return with_exponent(Extended(1), 2 - digits);
    }
};

#endif
