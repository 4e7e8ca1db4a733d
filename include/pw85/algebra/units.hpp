// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Units that are powers of two times the units of the caller, so conversions change no digit. Data
/// that are scaled to keep their numbers in range are stored with their units (Scaled).
#ifndef PW85_ALGEBRA_UNITS_HPP_INCLUDED
#define PW85_ALGEBRA_UNITS_HPP_INCLUDED

#include <pw85/algebra/factor.hpp>

namespace pw85::detail {

/// A unit of any quantity, 2^exponent times the caller's.
struct Unit {
    int exponent;

    /// Converts x to this unit. `power` is that of the unit in the dimension of x: for a unit of
    /// length, 1 for a length, 2 for a form or an area, and -1 for a curvature.
    template <class X> PW85_MEMBER X to_local(X const &x, int power = 1) const noexcept
    {
        return times_power_of_two(x, -power * exponent);
    }

    /// Converts x from this unit to the caller's.
    template <class X> PW85_MEMBER X to_caller(X const &x, int power = 1) const noexcept
    {
        return times_power_of_two(x, power * exponent);
    }

    /// Converts a form to this unit of length.
    template <class T, int D>
    PW85_MEMBER SymmetricMatrix<T, D> to_local(SymmetricMatrix<T, D> const &q) const noexcept
    {
        return to_local(q, 2);
    }

    /// This unit as a number of the caller's units.
    template <class T> PW85_MEMBER T as() const noexcept { return to_caller(T(1)); }
};

PW85_FUNCTION constexpr Unit operator*(Unit a, Unit b) noexcept
{
    return {a.exponent + b.exponent};
}

PW85_FUNCTION constexpr Unit operator/(Unit a, Unit b) noexcept
{
    return {a.exponent - b.exponent};
}

PW85_FUNCTION constexpr bool operator<(Unit a, Unit b) noexcept { return a.exponent < b.exponent; }

PW85_FUNCTION constexpr Unit larger_of(Unit a, Unit b) noexcept { return a < b ? b : a; }

PW85_FUNCTION constexpr Unit smaller_of(Unit a, Unit b) noexcept { return b < a ? b : a; }

/// The unit in which a positive number is in [1, 2).
template <class T> PW85_FUNCTION inline Unit unit_of(T const &x) noexcept
{
    return {binary_exponent(x)};
}

/// The unit of length in which the largest diagonal entry of a form is in [1, 4).
template <class T, int D> PW85_FUNCTION inline Unit unit_of(SymmetricMatrix<T, D> const &q) noexcept
{
    return {half_exponent(largest_diagonal(q))};
}

/// The unit in which the largest entry of a factor is in [1, 2).
template <class T, int D> PW85_FUNCTION inline Unit unit_of(Factor<T, D> const &s) noexcept
{
    return {binary_exponent(largest_entry(s))};
}

/// The unit in which the largest coordinate of a vector is in [1, 2), or the caller's if it is
/// zero.
template <class T, int D> PW85_FUNCTION inline Unit unit_of(Vector<T, D> const &x) noexcept
{
    T const largest = largest_coordinate(x);
    return {largest > T(0) ? binary_exponent(largest) : 0};
}

/// The larger of two units: `least`, and the one in which x, given in `unit`, is of order one.
template <class T> PW85_FUNCTION inline Unit larger_unit(Unit least, T const &x, Unit unit) noexcept
{
    return x > T(0) ? larger_of(least, unit_of(x) * unit) : least;
}

/// A unit below that of any number.
PW85_FUNCTION constexpr Unit smallest_unit() noexcept
{
    return {constant_of<std::numeric_limits<int>::min>};
}

/// The units of a pair of ellipsoids.
struct Units {
    Unit length;        ///< of r12
    Unit first, second; ///< of the lengths of each ellipsoid, in the order of the pair
    bool swapped;       ///< true if the order of the pair is not the caller's
    Unit time;          ///< of a pair that moves

    PW85_MEMBER constexpr Unit mu() const noexcept { return length / first; }

    PW85_MEMBER constexpr Unit velocity() const noexcept { return length / time; }

    /// Converts a vector that points from one ellipsoid to the other one between the order of the
    /// caller and that of the pair.
    template <class V> PW85_MEMBER constexpr V reordered(V const &x) const noexcept
    {
        return swapped ? -x : x;
    }
};

/// A pair in units that keep every intermediate result in range, and these units.
template <class P> struct Scaled {
    P pair;
    Units units;
};

} // namespace pw85::detail

#endif
