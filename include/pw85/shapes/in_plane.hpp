// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ellipses, segments and rectangles in two dimensions, computed by the functions for three
/// dimensions.
///
/// 1. Let Q' be Q with a third semi-axis α_z > 0 perpendicular to the plane. Then xᵀQ'⁻¹x = xᵀQ⁻¹x
///    for each x in the plane.
/// 2. A segment or a box of the plane is a segment or a flat box in space. So μ², the nearest
///    point, s = Q⁻¹x and the sum S of nearest_point.hpp are those of space, and s_z = 0.
/// 3. Q' is positive definite where Q is, and its entries are numbers of T. So the decisions in
///    space, which are exact, are those of the plane.
///
/// The square of α_z is the larger diagonal entry of Q. This number needs no rounding, does not
/// extend the range of the entries, and makes the trace of Q'⁻¹ at most twice that of Q⁻¹.
#ifndef PW85_SHAPES_IN_PLANE_HPP_INCLUDED
#define PW85_SHAPES_IN_PLANE_HPP_INCLUDED

#include <pw85/shapes/box.hpp>
#include <pw85/shapes/overlap_shapes.hpp>
#include <pw85/shapes/segment.hpp>

namespace pw85::detail {

template <class T>
PW85_FUNCTION constexpr Vector<T, 3> point_in_space(Vector<T, 2> const &x) noexcept
{
    return {x[0], x[1], T(0)};
}

template <class T>
PW85_FUNCTION constexpr SymmetricMatrix<T, 3> form_in_space(SymmetricMatrix<T, 2> const &q) noexcept
{
    return {q[0], q[1], T(0), q[2], T(0), largest_diagonal(q)};
}

template <class T>
PW85_FUNCTION constexpr ShapeContact<T, 2> in_plane(ShapeContact<T, 3> const &found) noexcept
{
    return {found.mu2, {found.point[0], found.point[1]}, found.status};
}

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeContact<T, 2> contact_segment(Vector<T, 2> const &end1,
                                                        Vector<T, 2> const &end2,
                                                        SymmetricMatrix<T, 2> const &q) noexcept
{
    using detail::point_in_space;
    return detail::in_plane(
        contact_segment(point_in_space(end1), point_in_space(end2), detail::form_in_space(q)));
}

template <class T>
PW85_FUNCTION inline ShapeContact<T, 2> contact_box(Vector<T, 2> const &lower,
                                                    Vector<T, 2> const &upper,
                                                    SymmetricMatrix<T, 2> const &q) noexcept
{
    using detail::point_in_space;
    return detail::in_plane(
        contact_box(point_in_space(lower), point_in_space(upper), detail::form_in_space(q)));
}

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_segment(Vector<T, 2> const &end1,
                                                  Vector<T, 2> const &end2,
                                                  SymmetricMatrix<T, 2> const &q) noexcept
{
    using detail::point_in_space;
    return overlap_segment(point_in_space(end1), point_in_space(end2), detail::form_in_space(q));
}

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_box(Vector<T, 2> const &lower, Vector<T, 2> const &upper,
                                              SymmetricMatrix<T, 2> const &q) noexcept
{
    using detail::point_in_space;
    return overlap_box(point_in_space(lower), point_in_space(upper), detail::form_in_space(q));
}

} // namespace pw85

#endif
