// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of an ellipsoid and a box with sides along the axes.
///
/// The nearest point of the box is on a face that faces the centre; otherwise there would be points
/// of the box between it and the centre. There are up to three such faces. On the face x_i = c,
/// xᵀQ⁻¹x is c²/Q_ii plus the same function of the other two coordinates, with the centre at Q_ij
/// c/Q_ii and with the Schur complement of Q_ii instead of Q. This is the problem for a rectangle,
/// with up to two edges that face its centre. It leads in the same way to the problem for an
/// interval. Every term is a square, and the errors of the complements are those of pivots
/// (nearest_point.hpp).
#ifndef PW85_SHAPES_BOX_HPP_INCLUDED
#define PW85_SHAPES_BOX_HPP_INCLUDED

#include <pw85/shapes/nearest_point.hpp>

namespace pw85::detail {

/// A box in D dimensions, and the form and the centre of the function (x - center)ᵀQ⁻¹(x - center).
template <class T, int D> struct BoxProblem {
    Vector<T, D> lower, upper, center;
    SymmetricMatrix<T, D> q;
};

/// The least value of this function in the box, and where it is.
template <class T, int D> struct BoxMinimum {
    T value;
    Vector<T, D> point;
};

template <class T>
PW85_FUNCTION constexpr T clamped(T const &x, T const &lower, T const &upper) noexcept
{
    return minimum(maximum(x, lower), upper);
}

/// Returns the index of the k-th coordinate other than i.
PW85_FUNCTION constexpr int other_axis(int i, int k) noexcept { return k < i ? k : k + 1; }

/// The problem on the face on which coordinate i differs from that of the centre by `offset`.
/// `reciprocal` is 1/Q_ii.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxProblem<T, D - 1>
problem_on_face(BoxProblem<T, D> const &box, int i, T const &offset, T const &reciprocal) noexcept
{
    BoxProblem<T, D - 1> face{};
    for (int k = 0; k < D - 1; ++k) {
        int const j = other_axis(i, k);
        T const factor = box.q(i, j) * reciprocal;
        face.lower[k] = box.lower[j];
        face.upper[k] = box.upper[j];
        face.center[k] = box.center[j] + factor * offset;
        for (int l = k; l < D - 1; ++l)
            face.q(k, l) = box.q(j, other_axis(i, l)) - factor * box.q(i, other_axis(i, l));
        face.q(k, k) = maximum(face.q(k, k), T(T(unit_roundoff<T>()) * box.q(j, j)));
    }
    return face;
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxMinimum<T, 1>
minimum_in_box(BoxProblem<T, 1> const &box) noexcept
{
    T const x = clamped(box.center[0], box.lower[0], box.upper[0]), offset = x - box.center[0];
    return {T(offset * T(offset / box.q[0])), {x}};
}

template <class Mask, class T, int D> PW85_FUNCTION constexpr BoxMinimum<T, D>
choose(Mask const &mask, BoxMinimum<T, D> const &yes, BoxMinimum<T, D> const &no) noexcept
{
    return {select(mask, yes.value, no.value), choose(mask, yes.point, no.point)};
}

/// The minimum of the box from the minimum on the face on which coordinate i is x.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxMinimum<T, D>
on_face(BoxMinimum<T, D - 1> const &rest, int i, T const &x, T const &offset,
        T const &reciprocal) noexcept
{
    BoxMinimum<T, D> whole{};
    whole.value = T(offset * offset) * reciprocal + rest.value;
    whole.point[i] = x;
    for (int k = 0; k < D - 1; ++k) whole.point[other_axis(i, k)] = rest.point[k];
    return whole;
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxMinimum<T, D>
minimum_in_box(BoxProblem<T, D> const &box) noexcept;

/// The minimum on the face on which coordinate i is x, which differs from that of the centre by
/// `offset`.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxMinimum<T, D>
minimum_on_face(BoxProblem<T, D> const &box, int i, T const &x, T const &offset) noexcept
{
    T const reciprocal = T(1) / box.q(i, i);
    auto const rest = minimum_in_box(problem_on_face(box, i, offset, reciprocal));
    return on_face<T, D>(rest, i, x, offset, reciprocal);
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr BoxMinimum<T, D>
minimum_in_box(BoxProblem<T, D> const &box) noexcept
{
    BoxMinimum<T, D> best{};
    best.point = box.center;
    auto found = T(0) < T(0);
    for (int i = 0; i < D; ++i) {
        T const x = clamped(box.center[i], box.lower[i], box.upper[i]), offset = x - box.center[i];
        auto const faces_center = !(offset == T(0));
        // With several lanes, mostly at least one needs the face, and processors cannot predict
        // such a branch.
        if (ScalarTraits<T>::lanes == 1 && !any_of(faces_center)) continue;
        auto const whole = minimum_on_face(box, i, x, offset);
        best = choose(faces_center && !(found && best.value <= whole.value), whole, best);
        found = found || faces_center;
    }
    return best;
}

/// A multiple of Q⁻¹x at the nearest point x. Its component along an axis is zero if x is on no
/// face that is orthogonal to the axis.
template <class T> PW85_FUNCTION constexpr Vector<T, 3>
normal_at(Vector<T, 3> const &x, BoxProblem<T, 3> const &box) noexcept
{
    Elimination<T> const form(box.q);
    Vector<T, 3> s = form.normal(form.weighted(form.map(x)));
    for (int i = 0; i < 3; ++i)
        s[i] = select(box.lower[i] < x[i] && x[i] < box.upper[i], T(0), s[i]);
    return s;
}

template <class T> PW85_FUNCTION constexpr Vector<T, 3>
nearest_corner(Vector<T, 3> const &lower, Vector<T, 3> const &upper) noexcept
{
    return {clamped(T(0), lower[0], upper[0]), clamped(T(0), lower[1], upper[1]),
            clamped(T(0), lower[2], upper[2])};
}

template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_box(Vector<T, 3> const &lower, Vector<T, 3> const &upper) noexcept
{
    return is_finite(lower) && is_finite(upper) && lower[0] <= upper[0] && lower[1] <= upper[1] &&
           lower[2] <= upper[2];
}

/// Returns whether three conditions hold, tested with products only: the centre is not in the box;
/// the distance of the box and the form are of order one; both are valid.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Vector<T, 3> const &lower, Vector<T, 3> const &upper,
                   SymmetricMatrix<T, 3> const &q) noexcept
{
    T const largest = largest_diagonal(q), size = sum_of_magnitudes(nearest_corner(lower, upper));
    return is_in_range(size, largest, largest) && is_box(lower, upper) && is_clearly_definite(q);
}

/// contact_box() in units in which the form and the distance of the box are of order one.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline ShapeContact<T, 3>
contact_box_scaled(Vector<T, 3> lower, Vector<T, 3> upper, SymmetricMatrix<T, 3> q) noexcept
{
    StatusCode const status = is_box(lower, upper) ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return all_nan<ShapeContact<T, 3>>(status);
    T const size = largest_coordinate(nearest_corner(lower, upper));
    if (!(size > T(0))) return {T(0), {T(0), T(0), T(0)}, StatusCode::success};
    Unit const length = unit_of(size), form = unit_of(q);
    auto const found = minimum_in_box(BoxProblem<T, 3>{
        length.to_local(lower), length.to_local(upper), {T(0), T(0), T(0)}, form.to_local(q)});
    return to_caller(found.value, found.point, length, form);
}

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_box(Vector<T, 3> const &lower,
                                                    Vector<T, 3> const &upper,
                                                    SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    if (passes_fast_checks(lower, upper, q)) {
        auto const found = minimum_in_box(BoxProblem<T, 3>{lower, upper, {T(0), T(0), T(0)}, q});
        return {found.value, found.point, StatusCode::success};
    }
    return contact_box_scaled(lower, upper, q);
}

} // namespace pw85

#endif
