// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The corners of a set and the form of an ellipsoid as integers, and their products, for
/// exact_shapes.hpp.
///
/// All coordinates are multiples of some 2^h and all entries of Q are multiples of 4^h. So the
/// coordinates and entries are integers in the same unit of length, and terms of the same dimension
/// can be compared.
#ifndef PW85_SHAPES_INTEGER_SHAPES_HPP_INCLUDED
#define PW85_SHAPES_INTEGER_SHAPES_HPP_INCLUDED

#include <pw85/overlap/exact.hpp>

namespace pw85::detail::exact {

/// Memory for integers, which is used from the front. What a function takes from a copy is free
/// again when the function returns.
struct Workspace {
    Limb *next;

    [[gnu::always_inline]] WideSum take(int limbs) noexcept
    {
        WideSum const sum = zero_sum(next, limbs);
        next += limbs;
        return sum;
    }
};

/// sign·x y.
struct WideProduct {
    WideInteger x, y;
    int sign;
};

struct WideVector {
    WideInteger x[3];
};

/// The upper triangle of a symmetric matrix.
struct WideForm {
    WideInteger entries[6];

    [[gnu::always_inline]] WideInteger operator()(int i, int j) const noexcept
    {
        return entries[SymmetricMatrix<double, 3>::index(i < j ? i : j, i < j ? j : i)];
    }
};

template <std::size_t N>
PW85_FUNCTION inline WideInteger sum_of(Workspace &space, WideProduct const (&terms)[N]) noexcept
{
    int limbs = 0;
    for (auto const &[x, y, sign] : terms) limbs = maximum(limbs, x.size + y.size);
    WideSum const sum = space.take(limbs + 1);
    for (auto const &[x, y, sign] : terms) add_product(sum, sign, x, y);
    return value(sum);
}

template <std::size_t N>
PW85_FUNCTION inline int sign_of(Workspace space, WideProduct const (&terms)[N]) noexcept
{
    return sum_of(space, terms).sign;
}

PW85_FUNCTION inline int sign_of_dot(Workspace space, WideVector const &a,
                                     WideVector const &b) noexcept
{
    return sign_of(space, {{a.x[0], b.x[0], 1}, {a.x[1], b.x[1], 1}, {a.x[2], b.x[2], 1}});
}

PW85_FUNCTION inline WideVector cross(Workspace &space, WideVector const &a,
                                      WideVector const &b) noexcept
{
    WideVector c;
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        c.x[i] = sum_of(space, {{a.x[j], b.x[k], 1}, {a.x[k], b.x[j], -1}});
    }
    return c;
}

PW85_FUNCTION inline WideVector product(Workspace &space, WideForm const &q,
                                        WideVector const &v) noexcept
{
    WideVector y;
    for (int i = 0; i < 3; ++i)
        y.x[i] = sum_of(space, {{q(i, 0), v.x[0], 1}, {q(i, 1), v.x[1], 1}, {q(i, 2), v.x[2], 1}});
    return y;
}

/// Returns an entry of adj(Q).
PW85_FUNCTION inline WideInteger cofactor(Workspace &space, WideForm const &q, int i,
                                          int j) noexcept
{
    int const i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return sum_of(space, {{q(i1, j1), q(i2, j2), 1}, {q(i1, j2), q(i2, j1), -1}});
}

/// Row i of adj(Q).
PW85_FUNCTION inline WideVector row_of_adjugate(Workspace &space, WideForm const &q, int i) noexcept
{
    WideVector row;
    for (int j = 0; j < 3; ++j) row.x[j] = cofactor(space, q, i, j);
    return row;
}

/// adj(Q) v.
PW85_FUNCTION inline WideVector product_with_adjugate(Workspace &space, WideForm const &q,
                                                      WideVector const &v) noexcept
{
    int form = 0, vector = 0;
    for (auto const &x : q.entries) form = maximum(form, x.size);
    for (auto const &x : v.x) vector = maximum(vector, x.size);
    WideVector y;
    for (int i = 0; i < 3; ++i) {
        WideSum const sum = space.take(2 * form + vector + 2);
        Workspace rest = space;
        WideVector const row = row_of_adjugate(rest, q, i);
        for (int j = 0; j < 3; ++j) add_product(sum, 1, row.x[j], v.x[j]);
        y.x[i] = value(sum);
    }
    return y;
}

template <class T> struct Corner {
    BinaryFraction<T> x[3];
};

/// x/2^unit, which is an integer.
template <class T>
PW85_FUNCTION inline void add(WideSum sum, BinaryFraction<T> const &x, int unit, int sign) noexcept
{
    if (x.sign == 0) return;
    int const exponent = x.exponent - unit;
    add(sum, times_power_of_two(x.magnitude, exponent % limb_bits), exponent / limb_bits,
        sign * x.sign);
}

/// A form and the corners of a set, with their common unit 2^unit of length.
template <class T, std::size_t N> struct ShapeNumbers {
    Corner<T> corners[N];
    BinaryFraction<T> q[6];
    int unit;
    /// of a difference of coordinates, and of an entry of the form
    int coordinate_limbs, entry_limbs;
};

template <class T, std::size_t N> PW85_FUNCTION inline ShapeNumbers<T, N>
to_shape_numbers(Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q) noexcept
{
    ShapeNumbers<T, N> numbers;
    BitRange lengths = no_digits(), squares = no_digits();
    for (std::size_t k = 0; k < N; ++k)
        for (int i = 0; i < 3; ++i)
            lengths.include(numbers.corners[k].x[i] = to_binary_fraction(points[k][i]));
    for (int k = 0; k < 6; ++k) squares.include(numbers.q[k] = to_binary_fraction(q[k]));
    int const half = squares.low >= 0 ? squares.low / 2 : -((1 - squares.low) / 2);
    numbers.unit = minimum(lengths.low, half);
    numbers.coordinate_limbs = limbs_for(maximum(lengths.high - numbers.unit, 0) + 2);
    numbers.entry_limbs = limbs_for(squares.high - 2 * numbers.unit + 2);
    return numbers;
}

template <class T, std::size_t N> PW85_FUNCTION inline WideForm
integers_of_form(Workspace &space, ShapeNumbers<T, N> const &numbers) noexcept
{
    WideForm q;
    for (int k = 0; k < 6; ++k) {
        WideSum const sum = space.take(numbers.entry_limbs);
        add(sum, numbers.q[k], 2 * numbers.unit, 1);
        q.entries[k] = value(sum);
    }
    return q;
}

/// The coordinates of a corner.
template <class T, std::size_t N> PW85_FUNCTION inline WideVector
integers_of(Workspace &space, ShapeNumbers<T, N> const &numbers, Corner<T> const &a) noexcept
{
    WideVector v;
    for (int i = 0; i < 3; ++i) {
        WideSum const sum = space.take(numbers.coordinate_limbs);
        add(sum, a.x[i], numbers.unit, 1);
        v.x[i] = value(sum);
    }
    return v;
}

/// The differences b - a of the coordinates of two corners.
template <class T, std::size_t N>
PW85_FUNCTION inline WideVector difference(Workspace &space, ShapeNumbers<T, N> const &numbers,
                                           Corner<T> const &b, Corner<T> const &a) noexcept
{
    WideVector v;
    for (int i = 0; i < 3; ++i) {
        WideSum const sum = space.take(numbers.coordinate_limbs);
        add(sum, b.x[i], numbers.unit, 1);
        add(sum, a.x[i], numbers.unit, -1);
        v.x[i] = value(sum);
    }
    return v;
}

} // namespace pw85::detail::exact

#endif
