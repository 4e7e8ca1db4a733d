// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// π with the digits of any scalar, and the volume of the unit ball or the area of the unit circle.
#ifndef PW85_ALGEBRA_UNIT_BALL_HPP_INCLUDED
#define PW85_ALGEBRA_UNIT_BALL_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>

namespace pw85::detail {

/// π.
template <class T> PW85_FUNCTION inline T circle_constant() noexcept
{
    if constexpr (std::is_floating_point_v<typename ScalarTraits<T>::Lane>)
        return T(
            static_cast<typename ScalarTraits<T>::Lane>(3.14159265358979323846264338327950288L));
    else
        return T(T(4) * atan2(T(1), T(1)));
}

/// π with the digits of Finer<T>: `high` and the rest.
template <class T> PW85_FUNCTION inline Finer<T> fine_circle_constant() noexcept
{
    if constexpr (std::is_same_v<T, double>)
        return {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
    else if constexpr (std::is_same_v<T, float>)
        return {0x1.921fb6p+1F, -0x1.777a5cp-24F};
    else
        return Finer<T>(circle_constant<T>());
}

/// The volume of the unit ball, 4π/3, or the area of the unit circle, π.
template <class T, int D> PW85_FUNCTION inline T unit_measure() noexcept
{
    T const pi = circle_constant<T>();
    return D == 3 ? T(T(T(4) * pi) / T(3)) : pi;
}

} // namespace pw85::detail

#endif
