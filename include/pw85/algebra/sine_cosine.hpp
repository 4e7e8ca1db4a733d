// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sine and cosine of an angle. contact/forms.hpp and motion/motion.hpp call sine_cosine(). For
/// double it uses only additions and products, because the functions of different C libraries
/// differ in their last bits.
///
/// 1. angle = n π/2 + r with an integer n and |r| <= π/4 (1 + 2^-20). The remainder r is a sum of
///    two numbers (doubled.hpp). Multiples of π/2 are subtracted until n is below 2^26. They are
///    computed from three parts of π/2. The first two have 27 bits; their products with n are
///    exact. The error of r is less than 2^-102 of the angle.
/// 2. The series of the sine to r^17 and of the cosine to r^16 are truncated by less than 2^-62 r
///    and 2^-58. So each result errs by less than one unit in the last place for |angle| <= π/4,
///    and by less than 2^-53 + 2^-102 |angle| otherwise.
#ifndef PW85_ALGEBRA_SINE_COSINE_HPP_INCLUDED
#define PW85_ALGEBRA_SINE_COSINE_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/algebra/powers_of_two.hpp>
#include <pw85/algebra/two_lanes.hpp>

namespace pw85::detail {

template <class T> struct SineCosine {
    T sine, cosine;
};

template <class T> PW85_FUNCTION inline SineCosine<T> sine_cosine(T const &angle) noexcept
{
    using elementary::cos;
    using elementary::sin;
    T const sine = sin(angle), cosine = cos(angle);
    return {sine, cosine};
}

/// An angle less a multiple of π/2.
struct ReducedAngle {
    Doubled<double> rest;
    int quarters; ///< the multiple, modulo 4
};

/// Returns the nearest integer to x, for |x| < 2^51.
PW85_FUNCTION constexpr double nearest_integer(double x) noexcept
{
    constexpr double shift = 0x1.8p52;
    return (x + shift) - shift;
}

/// x less multiple·π/2. The multiple has at most 26 bits.
PW85_FUNCTION inline Doubled<double> minus_quarters(Doubled<double> const &x,
                                                    double multiple) noexcept
{
    CompensatedSum<double> c{x.high, x.low};
    add(c, -(multiple * 0x1.921fb54p+0));
    add(c, -(multiple * 0x1.10b461p-30));
    add(c, -(multiple * 0x1.a62633145c06ep-58));
    return ordered_sum(c.sum, c.rest);
}

/// Smaller angles are reduced, because their multiple of π/2 is zero.
inline constexpr double reduced_angle = 0.75;

/// Item 1, for a finite angle. Each pass takes at least 25 bits off. All passes but the last
/// subtract multiples of 4 quarters, or of 2 quarters.
PW85_FUNCTION inline ReducedAngle reduce_angle(double angle) noexcept
{
    ReducedAngle reduced{{angle, 0.0}, 0};
    if (absolute(angle) < reduced_angle) return reduced;
    for (int exponent = 1; exponent > 0;) {
        double const high = reduced.rest.high;
        exponent = high == 0.0 ? 0 : maximum(0, binary_exponent(absolute(high)) - 25);
        double const count =
            nearest_integer(times_power_of_two(high, -exponent) * 0x1.45f306dc9c883p-1);
        if (exponent < 2) reduced.quarters += static_cast<int>(count) << exponent;
        reduced.rest = minus_quarters(reduced.rest, times_power_of_two(count, exponent));
    }
    reduced.quarters &= 3;
    return reduced;
}

/// (sin h - h)/h³ of w = h², for an angle that is reduced.
template <class Real> PW85_FUNCTION constexpr Real sine_series(Real const &w) noexcept
{
    constexpr double c[8] = {
        -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
        -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    Real sum(c[7]);
    for (int k = 6; k >= 0; --k) sum = Real(c[k]) + w * sum;
    return sum;
}

/// (cos h - 1 + ½h²)/h⁴ of w = h², likewise.
template <class Real> PW85_FUNCTION constexpr Real cosine_series(Real const &w) noexcept
{
    constexpr double c[7] = {
        1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
        1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    Real sum(c[6]);
    for (int k = 5; k >= 0; --k) sum = Real(c[k]) + w * sum;
    return sum;
}

/// Returns the sine of an angle that is reduced, by its series about the first part.
PW85_FUNCTION inline double sine_of_rest(Doubled<double> const &x) noexcept
{
    double const h = x.high, w = h * h;
    return h + (h * w * sine_series(w) + x.low * (1.0 - 0.5 * w));
}

/// Returns the cosine likewise. The rounding error of 1 - h²/2 is added to the rest of the series.
PW85_FUNCTION inline double cosine_of_rest(Doubled<double> const &x) noexcept
{
    double const h = x.high, w = h * h, half = 0.5 * w, first = 1.0 - half;
    return first + (((1.0 - first) - half) + (w * w * cosine_series(w) - h * x.low));
}

PW85_FUNCTION inline SineCosine<double> sine_cosine(double angle) noexcept
{
    if (!(absolute(angle) <= largest_number<double>()))
        return {quiet_nan<double>(), quiet_nan<double>()};
    auto const [rest, quarters] = reduce_angle(angle);
    double const sine = sine_of_rest(rest), cosine = cosine_of_rest(rest);
    double const first = quarters % 2 == 0 ? sine : cosine,
                 second = quarters % 2 == 0 ? cosine : sine;
    return {quarters < 2 ? first : -first, quarters == 1 || quarters == 2 ? -second : second};
}

/// The sines and cosines of two angles, computed one after the other.
template <class T>
PW85_FUNCTION inline SineCosine<TwoLanes<T>> one_by_one(TwoLanes<T> const &angles) noexcept
{
    auto const [sine1, cosine1] = sine_cosine(first_of(angles));
    auto const [sine2, cosine2] = sine_cosine(second_of(angles));
    return {TwoLanes<T>(sine1, sine2), TwoLanes<T>(cosine1, cosine2)};
}

template <class T>
PW85_FUNCTION inline SineCosine<TwoLanes<T>> sine_cosine(TwoLanes<T> const &angles) noexcept
{
    return one_by_one(angles);
}

/// Two angles. Those that are reduced have their series side by side.
PW85_FUNCTION inline SineCosine<TwoLanes<double>>
sine_cosine(TwoLanes<double> const &angles) noexcept
{
    using Lanes = TwoLanes<double>;
    if (!all_of(absolute(angles) < Lanes(reduced_angle))) return one_by_one(angles);
    Lanes const w = angles * angles, half = Lanes(0.5) * w, first = Lanes(1.0) - half;
    return {angles + angles * w * sine_series(w),
            first + (((Lanes(1.0) - first) - half) + w * w * cosine_series(w))};
}

} // namespace pw85::detail

#endif
