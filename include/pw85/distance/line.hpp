// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The part of a straight line that is inside an ellipsoid. src/c_api/walls.cpp calls
/// intersect_line(), and src/simd/lanes/lines.hpp chord().
///
/// In the metric of Q⁻¹ the ellipsoid is a ball. The function first finds the point of the line
/// that is nearest to the centre, and then half of the chord. So a far origin of the line causes no
/// errors other than the rounding error of the nearest point.
#ifndef PW85_DISTANCE_LINE_HPP_INCLUDED
#define PW85_DISTANCE_LINE_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85 {

/// The part enter <= t <= leave of the line origin + t·direction that is in an ellipsoid. Both ends
/// are NaN if the line misses the ellipsoid.
template <class T> struct Chord {
    T enter, leave;
    StatusCode status;
};

namespace detail {

/// The middle of the chord of a line, as a multiple of the direction, and the square of its half.
/// If the square is negative, the line misses the ellipsoid.
template <class T> struct ChordMiddle {
    T middle, half2;
};

template <class T, int D>
PW85_FUNCTION inline ChordMiddle<T> chord(Vector<T, D> const &origin, Vector<T, D> const &direction,
                                          SymmetricMatrix<T, D> const &q) noexcept
{
    auto const factors = factorize(q, T(unit_roundoff<T>()));
    Vector<T, D> const w = solve(factors, direction);
    T const norm2 = dot(direction, w), middle = -dot(origin, w) / norm2;
    Vector<T, D> const nearest = add_scaled(origin, middle, direction);
    return {middle, (T(1) - dot(nearest, solve(factors, nearest))) / norm2};
}

/// Returns whether chord() neither overflows nor underflows, and the form is valid.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
has_clear_chord(Vector<T, D> const &origin, Vector<T, D> const &direction,
                SymmetricMatrix<T, D> const &q) noexcept
{
    T const limit = unscaled_limit<T>(), form = largest_diagonal(q),
            length = sum_of_magnitudes(direction);
    return sum_of_magnitudes(origin) < limit && length < limit && length * limit > T(1) &&
           form < limit && form * limit > T(1) && is_clearly_definite(q);
}

} // namespace detail

template <class T, int D>
PW85_FUNCTION inline Chord<T> intersect_line(Vector<T, D> const &origin,
                                             Vector<T, D> const &direction,
                                             SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace detail;
    T const largest = largest_coordinate(direction);
    bool const valid = is_finite(origin) && is_finite(direction) && largest > T(0);
    StatusCode const status = valid ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<Chord<T>>(status);
    Unit const unit = unit_of(q), length = unit_of(direction), step = unit / length;
    auto const [middle, half2] =
        chord(unit.to_local(origin), length.to_local(direction), unit.to_local(q));
    if (!(half2 >= T(0))) return all_nan<Chord<T>>(StatusCode::success);
    T const half = square_root(half2);
    return {step.to_caller(T(middle - half)), step.to_caller(T(middle + half)),
            StatusCode::success};
}

} // namespace pw85

#endif
