// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Vectors of any scalar, with their operators and products. symmetric.hpp includes this file;
/// every algorithm calls it.
#ifndef PW85_ALGEBRA_VECTOR_HPP_INCLUDED
#define PW85_ALGEBRA_VECTOR_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85 {

/// A point or direction in `D` dimensions, by its Cartesian coordinates.
template <class T, int D> struct Vector {
    static_assert(detail::require_scalar<T>());

    T coordinates[std::size_t(D)];

    PW85_MEMBER constexpr T &operator[](int i) noexcept { return coordinates[i]; }
    PW85_MEMBER constexpr T const &operator[](int i) const noexcept { return coordinates[i]; }
};

} // namespace pw85

namespace pw85::detail {

/// The number of axes of rotation.
template <int D> inline constexpr int rotation_axes = D *(D - 1) / 2;

/// Converts the coordinates to another type, by a constructor that takes a T.
template <class To, class T, int D>
PW85_FUNCTION constexpr Vector<To, D> converted(Vector<T, D> const &x) noexcept
{
    Vector<To, D> y{};
    for (int i = 0; i < D; ++i) y[i] = To(x[i]);
    return y;
}

} // namespace pw85::detail

namespace pw85 {

template <class T, class... U> Vector(T, U...) -> Vector<T, 1 + static_cast<int>(sizeof...(U))>;

/// x·y.
template <class T, int D>
PW85_FUNCTION constexpr T dot(Vector<T, D> const &x, Vector<T, D> const &y) noexcept
{
    T sum = x[0] * y[0];
    for (int i = 1; i < D; ++i) sum = sum + x[i] * y[i];
    return sum;
}

/// x × y.
template <class T>
PW85_FUNCTION constexpr Vector<T, 3> cross(Vector<T, 3> const &x, Vector<T, 3> const &y) noexcept
{
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// x × y in two dimensions: the component along the one axis of rotation.
template <class T>
PW85_FUNCTION constexpr Vector<T, 1> cross(Vector<T, 2> const &x, Vector<T, 2> const &y) noexcept
{
    return {x[0] * y[1] - x[1] * y[0]};
}

template <class T, int D> PW85_FUNCTION constexpr Vector<T, D> operator-(Vector<T, D> x) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = -x[i];
    return x;
}

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> operator+(Vector<T, D> x, Vector<T, D> const &y) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = x[i] + y[i];
    return x;
}

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> operator-(Vector<T, D> x, Vector<T, D> const &y) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = x[i] - y[i];
    return x;
}

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> operator*(T const &factor, Vector<T, D> x) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = factor * x[i];
    return x;
}

template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> operator/(Vector<T, D> x, T const &divisor) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = x[i] / divisor;
    return x;
}

} // namespace pw85

namespace pw85::detail {

/// x + factor·y, with one rounding if the product is fused with the sum.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D>
add_scaled(Vector<T, D> x, T const &factor, Vector<T, D> const &y) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = x[i] + factor * y[i];
    return x;
}

/// √(x·x).
template <class T, int D> PW85_FUNCTION inline T magnitude(Vector<T, D> const &x) noexcept
{
    return square_root(dot(x, x));
}

/// The sum of the magnitudes of the products in x·y. Relative errors ε of its terms change x·y by
/// at most ε times this sum.
template <class T, int D>
PW85_FUNCTION constexpr T magnitude_of_dot(Vector<T, D> const &x, Vector<T, D> const &y) noexcept
{
    T sum = absolute(T(x[0] * y[0]));
    for (int i = 1; i < D; ++i) sum = sum + absolute(T(x[i] * y[i]));
    return sum;
}

/// Returns whether all coordinates are finite.
template <class T, int D>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_finite(Vector<T, D> const &x) noexcept
{
    T zero = x[0] * T(0);
    for (int i = 1; i < D; ++i) zero = zero + x[i] * T(0);
    return zero == T(0);
}

/// The sum of the magnitudes of the coordinates. It is between the largest magnitude and D times
/// the largest magnitude. It is NaN if a coordinate is NaN.
template <class T, int D>
PW85_FUNCTION constexpr T sum_of_magnitudes(Vector<T, D> const &x) noexcept
{
    T sum = absolute(x[0]);
    for (int i = 1; i < D; ++i) sum = sum + absolute(x[i]);
    return sum;
}

template <class T, int D>
PW85_FUNCTION constexpr T largest_coordinate(Vector<T, D> const &x) noexcept
{
    T largest = absolute(x[0]);
    for (int i = 1; i < D; ++i) largest = maximum(largest, absolute(x[i]));
    return largest;
}

} // namespace pw85::detail

#endif
