// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An ellipsoid and walls: half-space, box, cylinder. src/c_api/walls.cpp calls these functions,
/// which call support() and extreme_normal(). Distances are negative if the ellipsoid is in the
/// wall.
///
/// The half-width along n is α(n) = √(nᵀQn), and the point of the ellipsoid that is farthest along
/// n is Qn/α.
///
/// 1. A wall n·x >= c with |n| = 1 is c - α away. The ellipsoid touches the wall if it is scaled by
///    μ = c/α. Moving the centre by y changes the distance by -n·y. A small rotation ω about the
///    centre changes the distance by ω·(n × Qn/α). μ² changes by 2μ/α times the first of these and
///    by 2μ²/α times the second.
/// 2. A box is six such walls. A cylinder of radius R is one wall for every normal n to its axis:
///    R - n·c - α(n) is smallest where the projection of the ellipsoid is farthest from the axis.
#ifndef PW85_DISTANCE_WALLS_HPP_INCLUDED
#define PW85_DISTANCE_WALLS_HPP_INCLUDED

#include <pw85/distance/nearest.hpp>

namespace pw85 {

/// The contact function of an ellipsoid and a half-space.
template <class T, int D> struct PlaneContact {
    /// square of the factor by which the ellipsoid must be scaled to touch; 0 if its centre is in
    /// the wall
    T mu2;
    Vector<T, D> point; ///< at which the scaled ellipsoid touches, relative to its centre
    StatusCode status;
};

/// Derivatives of the distance to a half-space, or of μ², with respect to the centre and to the
/// rotation vector about the centre.
template <class T> struct PlaneDerivatives {
    Vector<T, 3> center, rotation;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A wall in units of its own: n·x >= offset, with a normal whose largest coordinate is of order
/// one.
template <class T, int D> struct NormalizedWall {
    Vector<T, D> normal;
    T offset;
    StatusCode status;
};

template <class T, int D> PW85_FUNCTION inline NormalizedWall<T, D>
normalize_wall(Vector<T, D> normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept
{
    StatusCode const status = offset * T(0) == T(0) ? validate(q) : StatusCode::invalid_argument;
    if (is_in_range(sum_of_magnitudes(normal), T(1), T(1))) return {normal, offset, status};
    T const largest = largest_coordinate(normal);
    bool const valid = is_finite(normal) && largest > T(0);
    normal = normal / largest;
    return {normal, offset / largest, valid ? status : StatusCode::invalid_argument};
}

/// Computes distance_plane() in the units of a valid wall.
template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_wall(Vector<T, D> const &normal, T const &offset, Support<T, D> const &s) noexcept
{
    T const reciprocal = T(1) / square_root(dot(normal, normal));
    return {(offset - s.extent) * reciprocal, s.point, reciprocal * normal, StatusCode::success};
}

/// Computes distance_plane() for any wall. The arguments are copied: callers that do not call this
/// function keep theirs in registers.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline SurfaceDistance<T, D>
distance_plane_scaled(Vector<T, D> normal, T offset, SymmetricMatrix<T, D> q) noexcept
{
    NormalizedWall<T, D> const wall = normalize_wall(normal, offset, q);
    if (wall.status != StatusCode::success) return all_nan<SurfaceDistance<T, D>>(wall.status);
    return distance_wall(wall.normal, wall.offset, support_of_any(q, wall.normal));
}

/// μ of a wall, limited to [0, largest number]. Where μ leaves the range of T, its products with
/// zeros must not be NaN.
template <class T, int D> PW85_FUNCTION inline T wall_factor(NormalizedWall<T, D> const &wall,
                                                             Support<T, D> const &s) noexcept
{
    return minimum(largest_number<T>(), maximum(T(0), T(wall.offset / s.extent)));
}

/// Finds two unit vectors that make a right-handed basis with the unit vector `axis` (T. Duff et
/// al., J. Comput. Graph. Tech. 6, 1, 2017). The divisor is at least 1 in magnitude; nothing
/// cancels.
template <class T> PW85_FUNCTION inline void
complete_basis(Vector<T, 3> const &axis, Vector<T, 3> &e1, Vector<T, 3> &e2) noexcept
{
    T const sign = select(axis[2] < T(0), T(-1), T(1)), a = T(-1) / (sign + axis[2]);
    T const ax = a * axis[0], mixed = ax * axis[1];
    e1 = {T(1) + sign * T(ax * axis[0]), sign * mixed, -(sign * axis[0])};
    e2 = {mixed, sign + T(a * axis[1]) * axis[1], -axis[1]};
}

/// The projection of an ellipsoid and of its centre to the plane across an axis, in a basis of unit
/// vectors.
template <class T> struct CrossSection {
    Vector<T, 3> e1, e2;
    SymmetricMatrix<T, 2> form;
    Vector<T, 2> center;
};

template <class T>
PW85_FUNCTION inline CrossSection<T> cross_section(Vector<T, 3> const &axis,
                                                   Vector<T, 3> const &center,
                                                   SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> e1, e2;
    complete_basis(axis, e1, e2);
    Vector<T, 3> const q1 = product(q, e1), q2 = product(q, e2);
    return {e1,
            e2,
            {positive_form(q, e1, q1), dot(e1, q2), positive_form(q, e2, q2)},
            {dot(e1, center), dot(e2, center)}};
}

/// A vector of the plane across the axis.
template <class T> PW85_FUNCTION inline Vector<T, 3> in_space(CrossSection<T> const &section,
                                                              Vector<T, 2> const &x) noexcept
{
    return add_scaled(x[0] * section.e1, x[1], section.e2);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline SurfaceDistance<T, D>
distance_plane(Vector<T, D> const &normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace detail;
    T const largest = largest_diagonal(q);
    if (is_in_range(sum_of_magnitudes(normal), largest, largest) && offset * T(0) == T(0) &&
        is_clearly_definite(q))
        return distance_wall(normal, offset, support(q, normal));
    return distance_plane_scaled(normal, offset, q);
}

template <class T> PW85_FUNCTION inline PlaneDerivatives<T>
distance_plane_derivatives(Vector<T, 3> const &normal, SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const d = distance_plane(normal, T(0), q);
    return {-d.normal, cross(d.normal, d.point), d.status};
}

template <class T, int D> PW85_FUNCTION inline PlaneContact<T, D>
contact_plane(Vector<T, D> const &normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace detail;
    NormalizedWall<T, D> const wall = normalize_wall(normal, offset, q);
    if (wall.status != StatusCode::success) return all_nan<PlaneContact<T, D>>(wall.status);
    Support<T, D> const s = support_of_any(q, wall.normal);
    T const mu = wall_factor(wall, s);
    return {mu * mu, mu * s.point, StatusCode::success};
}

template <class T> PW85_FUNCTION inline PlaneDerivatives<T>
contact_plane_derivatives(Vector<T, 3> const &normal, T const &offset,
                          SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    NormalizedWall<T, 3> const wall = normalize_wall(normal, offset, q);
    if (wall.status != StatusCode::success) return all_nan<PlaneDerivatives<T>>(wall.status);
    Support<T, 3> const s = support_of_any(q, wall.normal);
    T const mu = wall_factor(wall, s), reciprocal = T(2) / s.extent;
    // Products in this order are zero for μ = 0, whatever the sizes.
    return {T(-mu) * (reciprocal * wall.normal),
            mu * (reciprocal * (mu * cross(wall.normal, s.point))), StatusCode::success};
}

template <class T, int D>
PW85_FUNCTION inline SurfaceDistance<T, D> distance_box(Vector<T, D> const &lower,
                                                        Vector<T, D> const &upper,
                                                        SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace detail;
    bool valid = is_finite(lower) && is_finite(upper);
    for (int i = 0; i < D; ++i) valid = valid && lower[i] <= upper[i];
    StatusCode const status = valid ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<SurfaceDistance<T, D>>(status);
    int nearest = 0;
    T distance = T(0);
    for (int i = 0; i < D; ++i) {
        T const clearance = minimum(upper[i], T(-lower[i])) - square_root(q(i, i));
        if (i > 0 && !(clearance < distance)) continue;
        nearest = i;
        distance = clearance;
    }
    Vector<T, D> normal{}, point{};
    normal[nearest] = upper[nearest] <= -lower[nearest] ? T(1) : T(-1);
    T const factor = normal[nearest] / square_root(q(nearest, nearest));
    for (int k = 0; k < D; ++k) point[k] = factor * q(nearest, k);
    return {distance, point, normal, StatusCode::success};
}

template <class T> PW85_FUNCTION inline SurfaceDistance<T, 3>
distance_cylinder(Vector<T, 3> axis, T const &radius, Vector<T, 3> const &center,
                  SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    T const largest = largest_coordinate(axis);
    bool const valid = is_finite(axis) && largest > T(0) && is_finite(center) && radius > T(0) &&
                       radius * T(0) == T(0);
    StatusCode const status = valid ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<SurfaceDistance<T, 3>>(status);
    CrossSection<T> const section = cross_section(unit_along(axis / largest), center, q);
    Vector<T, 2> const n2 = extreme_normal(section.form, section.center, false);
    Vector<T, 3> const n = in_space(section, n2);
    Support<T, 3> const s = support_of_any(q, n);
    return {radius - dot(n2, section.center) - s.extent, s.point, n, StatusCode::success};
}

} // namespace pw85

#endif
