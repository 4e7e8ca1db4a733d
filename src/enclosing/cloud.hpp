// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of the caller in units of their own extent: each coordinate is multiplied by a power
/// of two. These products are exact, apart from numbers that fall below the range of double, which
/// change by less than 2^-1074 of the extent.
#ifndef PW85_ENCLOSING_CLOUD_HPP_INCLUDED
#define PW85_ENCLOSING_CLOUD_HPP_INCLUDED

#include <cstddef>

#include <pw85/algebra/doubled.hpp>
#include <pw85/algebra/units.hpp>
#include <pw85/any_dimension/packed_matrix.hpp>
#include <pw85/status.hpp>

namespace pw85::detail::enclosing {

using any_dimension::max_dimension;
inline constexpr int max_packed = any_dimension::max_packed_size;
/// The extent of each coordinate is between 2^-max_exponent and 2^max_exponent: products of two
/// extents neither overflow nor underflow.
inline constexpr int max_exponent = 480;

using Wide = Doubled<double>;

/// Returns the index of the entry (i, j), j <= i, of a lower triangle that is stored by rows.
constexpr int at(int i, int j) noexcept { return i * (i + 1) / 2 + j; }

/// m points in n dimensions. The C function has checked n and m.
struct Cloud {
    int n;
    std::size_t m;
    double const *points;
    double scale[max_dimension];
    Unit units[max_dimension];

    [[gnu::always_inline]] double coordinate(std::size_t i, int k) const noexcept
    {
        return points[i * static_cast<std::size_t>(n) + static_cast<std::size_t>(k)] * scale[k];
    }
};

/// Chooses the scale that brings each extent into [1, 2). Returns invalid_argument if a number is
/// not finite or an extent is out of range, and not_positive_definite if an extent is zero.
Status choose_scale(Cloud &cloud) noexcept;

} // namespace pw85::detail::enclosing

#endif
