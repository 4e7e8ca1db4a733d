// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The part of a straight line that is inside an ellipsoid. src/c_api/walls.cpp calls
/// intersect_line(), which calls factorize() and solve().
///
/// In the metric of Q⁻¹ the ellipsoid is a ball. The function first finds the point of the line
/// that is nearest to the centre, and then half of the chord. So a line that starts far away costs
/// no digits except those of the nearest point itself.
#ifndef PW85_DISTANCE_LINE_HPP_INCLUDED
#define PW85_DISTANCE_LINE_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/validate.hpp>

namespace pw85 {

/// The part enter <= t <= leave of the line origin + t·direction that is in an ellipsoid. Both ends
/// are NaN if the line misses the ellipsoid.
template <class T> struct Chord {
    T enter, leave;
    StatusCode status;
};

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
    int const unit = half_exponent(largest_diagonal(q)), length = binary_exponent(largest);
    auto const factors = factorize(times_power_of_two(q, -2 * unit), T(unit_roundoff<T>()));
    Vector<T, D> const d = times_power_of_two(direction, -length), w = solve(factors, d);
    Vector<T, D> x = times_power_of_two(origin, -unit);
    T const norm2 = dot(d, w), middle = -dot(x, w) / norm2;
    x = add_scaled(x, middle, d);
    T const rest = T(1) - dot(x, solve(factors, x));
    if (!(rest >= T(0))) return all_nan<Chord<T>>(StatusCode::success);
    T const half = square_root(T(rest / norm2));
    return {times_power_of_two(T(middle - half), unit - length),
            times_power_of_two(T(middle + half), unit - length), StatusCode::success};
}

} // namespace pw85

#endif
