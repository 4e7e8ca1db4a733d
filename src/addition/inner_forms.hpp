// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ellipses and balls inside all particles that can be put into a voxel, however these particles
/// are rounded. A particle of the packing that overlaps such a form at each corner of the voxel
/// overlaps everything that can be put there.
#ifndef PW85_ADDITION_INNER_FORMS_HPP_INCLUDED
#define PW85_ADDITION_INNER_FORMS_HPP_INCLUDED

#include <cstdint>

#include <pw85/algebra/symmetric.hpp>

namespace pw85::detail::sequential_addition {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Semi-axes of inner forms are smaller by this fraction, and then their squares by
/// rounding_loss(). Distances are compared with this margin.
constexpr double margin = 1e-11;

/// Bound of the errors of positions, as a fraction of the sum of the lengths of the vectors of the
/// cell: see rounding_loss().
constexpr double position_error = 0x1p-47;

/// Two semi-axes of an ellipse, or their squares.
using Axes2 = Vector<double, 2>;

/// The semi-axes of an ellipse that is inside each ellipse with semi-axes a >= b that is rotated
/// from it by at most an angle.
///
/// With the mean m and half the difference d of the squares of the semi-axes, the ellipse at the
/// angle φ has the half-width √(m + d cos 2(t - φ)) along the direction t. So m' + d' cos 2t is
/// never larger if m' = m - |d' - d exp(2iφ)|. The function chooses the d' with the largest area.
inline Axes2 inside_rotated(double a, double b, double angle) noexcept
{
    double const m = (a * a + b * b) / 2, d = (a * a - b * b) / 2,
                 s = elementary::sin(minimum(angle, pi / 2));
    Axes2 best = {b, b};
    for (int k = 1; k <= 64; ++k) {
        double const less = k / 64.0 * d;
        double const mean = m - elementary::sqrt((d - less) * (d - less) + 4 * d * less * s * s);
        if (mean <= less) continue;
        Axes2 const axes = {elementary::sqrt(mean + less), elementary::sqrt(mean - less)};
        if (axes[0] * axes[1] > best[0] * best[1]) best = axes;
    }
    return best;
}

/// An upper bound of what rounding takes from the square of each half-width of an inner form.
///
/// Errors of forms, as norms, in units of 2⁻⁵³ a². The inner form (rotated_form()): 11 by
/// inside_rotated(), whose mean of squares, their difference and root have 2, 2 and 7; 6 by roots,
/// the margin and squares; 13 by the double angle, which is up to 3π, has an error of 25 units and
/// moves the form by half of that; 6 by its sums. The form of a particle that is drawn: 14 by the
/// rotation of its quaternion, whose half angle has 5 units and whose entries have 1; in the plane
/// 21 by ellipsoid_quaternion(), whose factor has 6 in each entry. In space only the form of a
/// particle counts, which is 51, by 7 in each entry of the factor. The largest sum is 71, and the
/// function takes 128.
///
/// Positions have errors of at most 27 units of 2⁻⁵³ `edges` in each direction: products and sums
/// of the position of the voxel and of the particle that is drawn 6 each, its corner 3, images and
/// separations 12. Therefore they are within ε = 2⁻⁴⁷ `edges`. A half-width h that is left has
/// (h + ε)² <= (1 + t) h² + (1 + 1/t) ε². With t = 1.5 `margin`, the margin makes up for the first
/// factor, and 1 + 1/t <= 1/`margin`.
///
/// @param outer longest semi-axis a
/// @param edges sum of the lengths of the vectors of the cell
inline double rounding_loss(double outer, double edges) noexcept
{
    double const moved = position_error * edges;
    return 0x1p-46 * outer * outer + moved * moved / margin;
}

/// The radius of a ball inside the form of a particle with these longest and shortest semi-axes,
/// however the form is rounded; 0 if rounding leaves none. The exact test finds an overlap wherever
/// two such balls overlap.
inline double radius_inside(double outer, double inner) noexcept
{
    return elementary::sqrt(maximum(0.0, inner * inner - rounding_loss(outer, 0)));
}

/// The squares of semi-axes, smaller by the margin and by a loss. They may be negative.
inline Axes2 reduced_squares(Axes2 const &axes, double loss) noexcept
{
    double const a = axes[0] * (1 - margin), b = axes[1] * (1 - margin);
    return {a * a - loss, b * b - loss};
}

/// Returns whether forms with these squares of semi-axes, the larger one first, are positive
/// definite for certain. Their rounding errors are less than 128 units of 2⁻⁵³ times the larger
/// one.
inline bool is_certainly_definite(Axes2 const &squares) noexcept
{
    return squares[1] > 0x1p-46 * squares[0];
}

/// The form of the ellipse with the squares of semi-axes at half of an angle from x.
inline SymmetricMatrix<double, 2> rotated_form(Axes2 const &squares, double double_angle) noexcept
{
    double const m = (squares[0] + squares[1]) / 2, d = (squares[0] - squares[1]) / 2;
    return {m + d * elementary::cos(double_angle), d * elementary::sin(double_angle),
            m - d * elementary::cos(double_angle)};
}

/// Twice the angle in the middle of a voxel, which has one of `angles` parts of π.
inline double double_middle_angle(std::uint64_t part, std::uint64_t angles) noexcept
{
    return 2 * pi * (static_cast<double>(part) + 0.5) / static_cast<double>(angles);
}

/// Half of the range of angles of a voxel.
inline double half_angle_range(std::uint64_t angles) noexcept
{
    return pi / 2 / static_cast<double>(angles);
}

} // namespace
} // namespace pw85::detail::sequential_addition

#endif
