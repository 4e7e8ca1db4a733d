// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of the part of an ellipsoid that is in a half-space: overlap_volume_plane().
///
/// A linear map takes the ellipsoid to the unit ball and the half-space to {z <= d}, where d is the
/// offset over √(nᵀQn). With the height h = 1 + d, the fraction of the ball that is in the
/// half-space is h² (3 - h)/4, for 0 <= h <= 2.
#ifndef PW85_VOLUME_HALF_SPACE_HPP_INCLUDED
#define PW85_VOLUME_HALF_SPACE_HPP_INCLUDED

#include <pw85/volume/volume.hpp>

namespace pw85 {

/// The volume of the intersection of an ellipsoid with its centre at 0 and the half-space normal·x
/// <= offset.
template <class T>
PW85_FUNCTION inline Volume<T> overlap_volume_plane(Vector<T, 3> const &normal, T const &offset,
                                                    SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    T const largest = largest_coordinate(normal);
    bool const valid = is_finite(normal) && absolute(offset) < infinity<T>() && largest > T(0);
    StatusCode const status = valid || !is_finite(q) ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success || !valid)
        return all_nan<Volume<T>>(status != StatusCode::success ? status
                                                                : StatusCode::invalid_argument);
    Unit const size = unit_of(normal), unit = unit_of(q);
    auto const scaled = unit.to_local(q);
    auto const n = size.to_local(normal);
    T const reach =
        square_root(inverse_form(factorize(scaled, T(unit_roundoff<T>())), product(scaled, n)));
    T const distance = T((size * unit).to_local(offset) / reach);
    T const height = minimum(maximum(T(T(1) + distance), T(0)), T(2));
    T const share = T(T(T(0.25) * T(height * height)) * T(T(3) - height));
    // multiplied in this unit, because 0 times an infinite volume would be NaN
    return {unit.to_caller(T(share * measure_of(scaled)), 3), status};
}

} // namespace pw85

#endif
