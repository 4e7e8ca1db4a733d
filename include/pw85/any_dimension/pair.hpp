// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A pair of ellipsoids in n dimensions, in the units in which the search computes. contact.hpp,
/// geometry.hpp and overlap.hpp use it.
#ifndef PW85_ANY_DIMENSION_PAIR_HPP_INCLUDED
#define PW85_ANY_DIMENSION_PAIR_HPP_INCLUDED

#include <pw85/any_dimension/packed_matrix.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85::detail::any_dimension {

/// A pair as the caller gives it. The arrays are his.
template <class N> struct InputOf {
    N n;
    double const *r12, *q1, *q2;
};
using Input = InputOf<int>;

/// A pair in units of its own. Its members mean what those of pw85::detail::Pair mean.
template <class T, class N = int> struct Pair {
    N n;
    T r12[capacity<N>];
    T q1[packed_size(capacity<N>)], q2[packed_size(capacity<N>)];
    T ratio;
};

/// The exponents of these units, as in ScaledPair.
struct Units {
    int length, form, second;
    bool swapped;
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
    if (is_in_range(r, size1, size2)) return {0, 0, 0, false};
    int const e1 = half_exponent(size1), e2 = half_exponent(size2);
    bool const swapped = e1 < e2 - 24;
    return {r > 0.0 ? binary_exponent(r) : 0, swapped ? e2 : e1, swapped ? e1 : e2, swapped};
}

/// Returns whether no diagonal entry becomes so small in these units that digits of its products
/// are lost.
template <class N>
PW85_FUNCTION inline bool keeps_digits(N n, double const *q, int exponent) noexcept
{
    for (int i = 0; i < n; ++i)
        if (!(times_power_of_two(q[packed_index(n, i, i)], exponent) >= 0x1p-800)) return false;
    return true;
}

template <class N>
PW85_FUNCTION inline bool keep_digits(InputOf<N> const &in, Units const &units) noexcept
{
    int const first = units.swapped ? units.second : units.form,
              second = units.swapped ? units.form : units.second;
    return keeps_digits(in.n, in.q1, -2 * first) && keeps_digits(in.n, in.q2, -2 * second);
}

template <class T>
PW85_FUNCTION inline void scale(int size, double const *x, int exponent, double sign, T *y) noexcept
{
    for (int i = 0; i < size; ++i)
        y[i] = T(sign * (exponent == 0 ? x[i] : times_power_of_two(x[i], exponent)));
}

/// Brings a pair to its units. Only numbers that are too small to matter are rounded.
template <class T, class N>
PW85_FUNCTION inline void scale(InputOf<N> const &in, Units const &units, Pair<T, N> &pair) noexcept
{
    int const size = packed_size(in.n), limit = ratio_exponent_limit<double>();
    int const difference = units.form - units.second;
    pair.n = in.n;
    scale(in.n, in.r12, -units.length, units.swapped ? -1.0 : 1.0, pair.r12);
    scale(size, units.swapped ? in.q2 : in.q1, -2 * units.form, 1.0, pair.q1);
    scale(size, units.swapped ? in.q1 : in.q2, -2 * units.second, 1.0, pair.q2);
    pair.ratio = T(times_power_of_two(1.0, difference < limit ? difference : limit));
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
