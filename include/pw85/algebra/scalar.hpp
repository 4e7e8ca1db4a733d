// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The requirements of the templates on a scalar. A scalar `T` is a floating-point type (float,
/// double, long double, a multiprecision number) or a pack of such numbers. vector.hpp,
/// error_free.hpp and the packs (src/simd/pack.hpp) include this file. tests/test_archetype.cpp has
/// a type that fulfils these requirements and no more.
///
/// `T(x)` makes a `T` with the number x in all lanes. Implicit conversions to or from `T` need not
/// exist, so constants are written `T(0.5)`. Comparisons of a `T` give a mask, which is `bool` for
/// plain numbers (ScalarTraits). The type provides select() of lanes, load_lanes(), first_lane(),
/// any_of(), all_of() and sqrt(). It provides maximum(), minimum() and absolute() if its own are
/// faster. A type for one pair also provides ilogb() and ldexp(). Argument-dependent lookup finds
/// these functions.
///
/// A product may have a type of its own that is rounded only when it becomes a `T`. An addition or
/// subtraction is then fused with the product. So a product or a sum of products is wrapped,
/// `T(x * y)`, if it is an argument, a divisor, an operand of another product, or one alternative
/// of select(). This shows where it is rounded, and template arguments are deduced as `T`. A
/// product that is not wrapped may be fused or not. Every bound holds for both.
#ifndef PW85_ALGEBRA_SCALAR_HPP_INCLUDED
#define PW85_ALGEBRA_SCALAR_HPP_INCLUDED

#include <pw85/algebra/elementary.hpp>
#include <pw85/requirements.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace pw85 {

/// The floating-point properties of one lane of `T`, and its mask; specialised for packs.
///
/// Masks are combined by `&&`, `||` and `!`, which may be functions. Then both sides are evaluated,
/// so the right side must be harmless if the left side is false. A mask need not convert to `bool`:
/// code that branches on a mask calls any_of() or all_of(). Functions that are only for one pair
/// (with `if` and `while`) require a `T` whose mask is bool.
template <class T> struct ScalarTraits {
    using Lane = T;
    using Mask = bool;
    static constexpr int lanes = 1;
};

} // namespace pw85

namespace pw85::detail {

/// A floating-point type or a pack of them. Integers are not scalars, because their quotients are
/// truncated.
template <class T>
concept Scalar = !std::numeric_limits<typename ScalarTraits<T>::Lane>::is_integer;

/// Types that are made of scalars assert this.
template <class T> PW85_FUNCTION consteval bool require_scalar() noexcept
{
    static_assert(Scalar<T>, "pw85 computes with floating-point numbers: write 1.0, not 1");
    return true;
}

/// Loads as many numbers as `T` has lanes from memory.
template <class T>
PW85_FUNCTION constexpr T load_lanes(typename ScalarTraits<T>::Lane const *x) noexcept
{
    return T(*x);
}

/// The number in the first lane.
template <class T> PW85_FUNCTION constexpr T first_lane(T const &x) noexcept { return x; }

/// The value of a function of numeric_limits for a native type, as a constant, because devices
/// cannot call the function.
template <auto function> constexpr auto constant_of = function();

/// The value of a function of numeric_limits for a lane of `T`.
template <class T, auto function>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Lane lane_limit() noexcept
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

/// 2^-n for n from 0 to 1022, from the bits of a double. A loop of products would not serve:
/// compilers do not evaluate it at compile time at every level of optimization.
template <class T> PW85_FUNCTION constexpr T negative_power_of_two(int n) noexcept
{
    static_assert(std::numeric_limits<double>::is_iec559);
    double const power = __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 - n) << 52);
    return T(static_cast<typename ScalarTraits<T>::Lane>(power));
}

/// The binary digits to which results are computed: those of the mantissa, except for a type with
/// additional guard digits.
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

template <class T>
PW85_FUNCTION constexpr T select(bool condition, T const &yes, T const &no) noexcept
{
    return condition ? yes : no;
}

PW85_FUNCTION constexpr bool any_of(bool mask) noexcept { return mask; }

PW85_FUNCTION constexpr bool all_of(bool mask) noexcept { return mask; }

/// x && y without a branch, which a processor could not predict if the conditions depend on data.
template <class Mask> PW85_FUNCTION constexpr Mask both_true(Mask const &x, Mask const &y) noexcept
{
    return x && y;
}

PW85_FUNCTION constexpr bool both_true(bool x, bool y) noexcept
{
    return (static_cast<unsigned>(x) & static_cast<unsigned>(y)) != 0;
}

/// x == y for masks.
template <class Mask> PW85_FUNCTION inline Mask are_equal(Mask const &x, Mask const &y) noexcept
{
    return (x && y) || !(x || y);
}

/// The larger of two numbers. It is the first one if either is NaN.
template <class T> PW85_FUNCTION constexpr T maximum(T const &x, T const &y) noexcept
{
    return select(y > x, y, x);
}

/// The smaller of two numbers. It is the first one if either is NaN.
template <class T> PW85_FUNCTION constexpr T minimum(T const &x, T const &y) noexcept
{
    return select(y < x, y, x);
}

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

/// x/y, or another number where y is not positive.
template <class T>
PW85_FUNCTION inline T positive_quotient(T const &x, T const &y, T const &otherwise) noexcept
{
    auto const is_positive = y > T(0);
    return select(is_positive, T(x / select(is_positive, y, T(1))), otherwise);
}

/// A quotient and a root that only guide an iteration, and must not bound or return a result. Packs
/// may compute them with a relative error of up to 2^-20.
template <class T> PW85_FUNCTION constexpr T rough_quotient(T const &x, T const &y) noexcept
{
    return x / y;
}

template <class T> PW85_FUNCTION inline T rough_root(T const &x) noexcept { return square_root(x); }

/// √(x/y) with a relative error of 10 % at most, also only to guide an iteration.
template <class T> PW85_FUNCTION inline T coarse_root_of_ratio(T const &x, T const &y) noexcept
{
    return rough_root(rough_quotient(x, y));
}

/// Returns the bits of a positive double, read as an integer, approximate its logarithm.
PW85_FUNCTION inline double coarse_root_of_ratio(double x, double y) noexcept
{
    static_assert(std::numeric_limits<double>::is_iec559);
    constexpr auto one = __builtin_bit_cast(std::uint64_t, 1.0);
    return __builtin_bit_cast(double, (__builtin_bit_cast(std::uint64_t, x) -
                                       __builtin_bit_cast(std::uint64_t, y) + 2 * one) >>
                                          1);
}

} // namespace pw85::detail

#endif
