/// @file
/// What the templates ask of a scalar. A scalar `T` is a floating-point type (float, double, long double, a
/// multiprecision number) or a pack of them; comparisons of a `T` give a mask, which is `bool` for plain numbers.
///
/// 1. `T` is made of a number of its lanes, `T(x)`, with one value in all lanes; nothing has to convert to or from it by itself.
///    So constants are written `T(0.5)`.
/// 2. A product may be a type of its own that is not rounded until it becomes a `T`: what is added to it or subtracted from it is
///    then fused with it. So a product or a sum of products that is an argument, a divisor, an operand of another product or one
///    alternative of select() is wrapped, `T(x * y)`: that says where it is rounded, and lets the type of a template's arguments
///    be `T`. What is not wrapped may be fused or not, and every bound holds for both.
/// 3. Masks are combined by `&&`, `||` and `!`, which may be functions: both sides are evaluated, and what the right one computes
///    must do no harm where the left one is false. A mask need not convert to `bool`: where one decides what is executed at all, it
///    is any_of() or all_of() it. Functions of one pair alone (`if`, `while`) ask for a `T` whose mask is bool.
/// 4. rough_quotient() and rough_root() may err by 2^-20 of themselves, coarse_root_of_ratio() by 10 %: they are for what guides an
///    iteration, never for what bounds or returns a result. select() of lanes, load_lanes(), first_lane(), any_of(), all_of() and,
///    where they are faster, maximum(), minimum() and absolute() come with the type, as do sqrt(), and for one pair ilogb() and
///    ldexp(), which argument-dependent lookup finds. ScalarTraits says what a lane is.
///
/// tests/test_archetype.cpp has a type that can do this and no more.
#ifndef PW85_ALGEBRA_SCALAR_HPP_INCLUDED
#define PW85_ALGEBRA_SCALAR_HPP_INCLUDED

#include <pw85/algebra/elementary.hpp>
#include <pw85/requirements.hpp>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace pw85 {

/// The floating-point properties of one lane of `T`; specialised for packs.
template <class T> struct ScalarTraits {
    using Lane = T;
    using Mask = bool;
    static constexpr int lanes = 1;
};

} // namespace pw85

namespace pw85::detail {

/// A floating-point type or a pack of them. Integers are none: their quotients are truncated.
template <class T>
concept Scalar = !std::numeric_limits<typename ScalarTraits<T>::Lane>::is_integer;

/// To be asserted by whatever is made of scalars.
template <class T> PW85_FUNCTION consteval bool require_scalar() noexcept
{
    static_assert(Scalar<T>, "pw85 computes with floating-point numbers: write 1.0, not 1");
    return true;
}

/// As many numbers as `T` has lanes, from memory.
template <class T> PW85_FUNCTION constexpr T load_lanes(typename ScalarTraits<T>::Lane const *x) noexcept
{
    return T(*x);
}

/// The number in the first lane.
template <class T> PW85_FUNCTION constexpr T first_lane(T const &x) noexcept { return x; }

/// What a function of numeric_limits returns, for a native type: a constant, so that no unit, of a device least of all, calls it.
template <auto function> constexpr auto constant_of = function();

/// One of the functions of numeric_limits for a lane of `T`.
template <class T, auto function> PW85_FUNCTION constexpr typename ScalarTraits<T>::Lane lane_limit() noexcept
{
    if constexpr (std::is_floating_point_v<typename ScalarTraits<T>::Lane>)
        return constant_of<function>;
    else
        return function();
}

/// The largest finite number.
template <class T> PW85_FUNCTION constexpr T largest_number() noexcept
{
    return T(lane_limit<T, std::numeric_limits<typename ScalarTraits<T>::Lane>::max>());
}

/// The smallest positive number of full precision.
template <class T> PW85_FUNCTION constexpr T smallest_number() noexcept
{
    return T(lane_limit<T, std::numeric_limits<typename ScalarTraits<T>::Lane>::min>());
}

/// Unit roundoff u of one lane: 2^-53 for double.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Lane unit_roundoff() noexcept
{
    using Lane = typename ScalarTraits<T>::Lane;
    return lane_limit<T, std::numeric_limits<Lane>::epsilon>() * Lane(0.5);
}

/// Binary digits of the mantissa of one lane.
template <class T> PW85_FUNCTION constexpr int mantissa_digits() noexcept
{
    return std::numeric_limits<typename ScalarTraits<T>::Lane>::digits;
}

/// 2^-n for n up to 1022: computed in double, so that types whose products take long need not.
template <class T> PW85_FUNCTION constexpr T negative_power_of_two(int n) noexcept
{
    double power = 1;
    for (int i = 0; i < n; ++i) power = power * 0.5;
    return T(static_cast<typename ScalarTraits<T>::Lane>(power));
}

/// Binary digits that results are wanted to: those of the mantissa, but for a type that has more to guard those of another.
template <class T> PW85_FUNCTION constexpr int result_digits() noexcept
{
    if constexpr (requires { ScalarTraits<T>::result_digits; })
        return ScalarTraits<T>::result_digits;
    else
        return mantissa_digits<T>();
}

template <class T> PW85_FUNCTION constexpr T quiet_nan() noexcept
{
    return T(lane_limit<T, std::numeric_limits<typename ScalarTraits<T>::Lane>::quiet_NaN>());
}

template <class T> PW85_FUNCTION constexpr T infinity() noexcept
{
    return T(lane_limit<T, std::numeric_limits<typename ScalarTraits<T>::Lane>::infinity>());
}

template <class T> PW85_FUNCTION constexpr T select(bool condition, T const &yes, T const &no) noexcept
{
    return condition ? yes : no;
}

PW85_FUNCTION constexpr bool any_of(bool mask) noexcept { return mask; }

PW85_FUNCTION constexpr bool all_of(bool mask) noexcept { return mask; }

/// The larger of two numbers; the first where either is NaN.
template <class T> PW85_FUNCTION constexpr T maximum(T const &x, T const &y) noexcept { return select(y > x, y, x); }

/// The smaller of two numbers; the first where either is NaN.
template <class T> PW85_FUNCTION constexpr T minimum(T const &x, T const &y) noexcept { return select(y < x, y, x); }

template <class T> PW85_FUNCTION constexpr T absolute(T const &x) noexcept
{
    using elementary::abs;
    return abs(x);
}

template <class T> PW85_FUNCTION inline T square_root(T const &x) noexcept
{
    using elementary::sqrt;
    return sqrt(x);
}

/// A quotient and a root that only guide an iteration, so that a relative error of 2^-20 does no harm: packs may round
/// them coarsely.
template <class T> PW85_FUNCTION constexpr T rough_quotient(T const &x, T const &y) noexcept { return x / y; }

template <class T> PW85_FUNCTION inline T rough_root(T const &x) noexcept { return square_root(x); }

/// √(x/y), to 10 % or better.
template <class T> PW85_FUNCTION inline T coarse_root_of_ratio(T const &x, T const &y) noexcept
{
    return rough_root(rough_quotient(x, y));
}

/// The bits of a positive double are about its logarithm.
PW85_FUNCTION inline double coarse_root_of_ratio(double x, double y) noexcept
{
    static_assert(std::numeric_limits<double>::is_iec559);
    constexpr auto one = __builtin_bit_cast(std::uint64_t, 1.0);
    return __builtin_bit_cast(
        double, (__builtin_bit_cast(std::uint64_t, x) - __builtin_bit_cast(std::uint64_t, y) + 2 * one) >> 1);
}

} // namespace pw85::detail

#endif
