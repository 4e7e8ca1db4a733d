// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A pair of ellipsoids in n dimensions, in the units in which the search computes. contact.hpp,
/// geometry.hpp and overlap.hpp use it.
#ifndef PW85_ANY_DIMENSION_PAIR_HPP_INCLUDED
#define PW85_ANY_DIMENSION_PAIR_HPP_INCLUDED

#include <pw85/any_dimension/packed_matrix.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85::detail::any_dimension {

/// A pair in the units of the caller, who owns the arrays.
template <class N> struct InputOf {
    N n;
    double const *r12, *q1, *q2;
};
using Input = InputOf<int>;

/// A pair in its own units. Its members have the same meaning as those of pw85::detail::Pair.
template <class T, class N = int> struct Pair {
    N n;
    T r12[capacity<N>];
    T q1[packed_size(capacity<N>)], q2[packed_size(capacity<N>)];
    T ratio;
};

template <class N> PW85_FUNCTION inline double largest_diagonal(N n, double const *q) noexcept
{
    double largest = q[0];
    for (int i = 1; i < n; ++i) largest = maximum(largest, q[packed_index(n, i, i)]);
    return largest;
}

template <class N> PW85_FUNCTION inline double largest_magnitude(N n, double const *x) noexcept
{
    double largest = 0.0;
    for (int i = 0; i < n; ++i) largest = maximum(largest, absolute(x[i]));
    return largest;
}

/// Returns the units of a pair with positive diagonals. Pairs of ordinary sizes keep those of the
/// caller.
template <class N> PW85_FUNCTION inline Units units_of(InputOf<N> const &in) noexcept
{
    double const r = largest_magnitude(in.n, in.r12);
    double const size1 = largest_diagonal(in.n, in.q1), size2 = largest_diagonal(in.n, in.q2);
    if (is_in_range(r, size1, size2)) return {};
    Unit const unit1{half_exponent(size1)}, unit2{half_exponent(size2)};
    bool const swapped = unit1.exponent < unit2.exponent - 24;
    return {{r > 0.0 ? binary_exponent(r) : 0},
            swapped ? unit2 : unit1,
            swapped ? unit1 : unit2,
            swapped,
            {}};
}

/// Returns whether no diagonal entry becomes so small in this unit that digits of its products are
/// lost.
template <class N> PW85_FUNCTION inline bool keeps_digits(N n, double const *q, Unit unit) noexcept
{
    for (int i = 0; i < n; ++i)
        if (!(unit.to_local(q[packed_index(n, i, i)], 2) >= 0x1p-800)) return false;
    return true;
}

template <class N>
PW85_FUNCTION inline bool keep_digits(InputOf<N> const &in, Units const &units) noexcept
{
    return keeps_digits(in.n, in.q1, units.swapped ? units.second : units.first) &&
           keeps_digits(in.n, in.q2, units.swapped ? units.first : units.second);
}

/// Converts numbers to a unit, as Unit::to_local() does.
template <class T>
PW85_FUNCTION inline void to_local(Unit unit, int power, int size, double const *x, T *y) noexcept
{
    for (int i = 0; i < size; ++i) y[i] = T(unit.exponent == 0 ? x[i] : unit.to_local(x[i], power));
}

/// Converts a pair to its units. Only numbers that are too small to matter are rounded.
template <class T, class N>
PW85_FUNCTION inline void scale(InputOf<N> const &in, Units const &units, Pair<T, N> &pair) noexcept
{
    int const size = packed_size(in.n);
    pair.n = in.n;
    to_local(units.length, 1, in.n, in.r12, pair.r12);
    if (units.swapped)
        for (int i = 0; i < in.n; ++i) pair.r12[i] = -pair.r12[i];
    to_local(units.first, 2, size, units.swapped ? in.q2 : in.q1, pair.q1);
    to_local(units.second, 2, size, units.swapped ? in.q1 : in.q2, pair.q2);
    Unit const largest{ratio_exponent_limit<double>()};
    pair.ratio = T(smaller_of(units.first / units.second, largest).as<double>());
}

/// Σ q_ii x_i². It is at least 1/n of Σ |x_i q_ij x_j|.
template <class T, class N>
PW85_FUNCTION inline T diagonal_form(N n, T const *q, T const *x) noexcept
{
    T sum = T(0);
    for (int i = 0; i < n; ++i) sum = sum + q[packed_index(n, i, i)] * (x[i] * x[i]);
    return sum;
}

} // namespace pw85::detail::any_dimension

#endif
