// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tests whether a polytope overlaps an ellipsoid. Floating-point numbers decide first, with
/// margins for their rounding errors. Integers decide the remaining cases (exact_polytope.hpp). The
/// symbols are those of polytope.hpp.
///
/// - They are apart or touch if Σ λ_k d_k >= √(sᵀQs), s = Σ λ_k g_k, for some λ >= 0. Single planes
///   are tried first: they decide most cases if most ellipsoids are far from the polytope. The
///   multipliers of the touched planes follow.
/// - They overlap if a point x is in all half-spaces, and Q - x xᵀ is positive definite. The
///   nearest point of a slightly smaller polytope is tried, whose planes are moved inwards; this
///   point is in the half-spaces in spite of rounding errors.
#ifndef PW85_SHAPES_OVERLAP_POLYTOPE_HPP_INCLUDED
#define PW85_SHAPES_OVERLAP_POLYTOPE_HPP_INCLUDED

#include <pw85/shapes/exact_polytope.hpp>
#include <pw85/shapes/overlap_shapes.hpp>
#include <pw85/shapes/polytope.hpp>

namespace pw85::detail {

/// Errors by underflow are far below 2^-underflow_bits. Where numbers of this size matter, integers
/// decide.
inline constexpr int underflow_bits = 200;

/// Distance by which planes are moved inwards, in half-widths of the ellipsoid: 2^-inset_bits.
inline constexpr int inset_bits = 36;

/// Returns whether the multipliers of touched planes prove that the polytope does not overlap.
///
/// With t_i = Σ λ_k |g_ki|, a coordinate of s errs by at most 3 u t_i, and sᵀQs by (6 + 6) u Σ t_i
/// t_j |Q_ij|, which is at most 36 u Σ t_i² Q_ii. d errs by 4 u m, and Σ λ_k d_k by 3 u Σ λ_k |d_k|
/// more. The margins include the roundings of these bounds, of the square and of the sum.
template <class T> PW85_FUNCTION inline bool shows_apart(SymmetricMatrix<T, 3> const &q,
                                                         TouchedPlanes<T> const &at) noexcept
{
    T const u = T(unit_roundoff<T>());
    Vector<T, 3> s{}, terms{};
    T least = T(0), largest = T(0), form = T(0);
    for (int k = 0; k < at.size; ++k) {
        auto const &plane = at.planes[k];
        T const lambda = at.multipliers[k];
        if (!(lambda >= T(0))) return false;
        s = add_scaled(s, lambda, plane.g);
        for (int i = 0; i < 3; ++i) terms[i] = terms[i] + lambda * absolute(plane.g[i]);
        least = least + lambda * T(plane.d - T(8) * u * plane.magnitude);
        largest = largest + lambda * absolute(plane.d);
    }
    for (int i = 0; i < 3; ++i) form = form + T(terms[i] * terms[i]) * q(i, i);
    least = least - T(4) * u * largest;
    T const underflow = negative_power_of_two<T>(underflow_bits);
    return least > underflow && form * underflow < T(1) &&
           T(T(T(1) - T(8) * u) * least) * least > T(quadratic_form(q, s) + T(48) * u * form);
}

/// The decision by single planes, for numbers of ordinary sizes: the ellipsoid is outside one
/// half-space, or its centre is inside all of them. All planes are read, because one may be
/// invalid.
template <class T>
PW85_FUNCTION inline Decision decide_by_planes(Polytope<T> const &polytope) noexcept
{
    T const limit = unscaled_limit<T>(), form = largest_diagonal(polytope.q);
    T const underflow = negative_power_of_two<T>(underflow_bits);
    if (!(is_in_range(form, form, form) && is_clearly_definite(polytope.q) &&
          is_finite(polytope.center)))
        return Decision::none;
    bool inside = true, apart = false;
    for (std::size_t k = 0; k < polytope.count; ++k) {
        Vector<T, 3> const g = -polytope.normal(k);
        T const offset = polytope.offsets[k], length = sum_of_magnitudes(g),
                d = -offset - dot(g, polytope.center);
        T const magnitude = absolute(offset) + magnitude_of_dot(g, polytope.center);
        if (!(length * limit > T(1) && length < limit && magnitude < T(limit * limit)))
            return Decision::none;
        inside = inside && d < -T(T(T(8) * T(unit_roundoff<T>())) * magnitude + underflow);
        TouchedPlanes<T> plane{};
        plane.size = 1;
        plane.multipliers[0] = T(1);
        plane.planes[0] = {g, g, d, magnitude};
        apart = apart || shows_apart(polytope.q, plane);
    }
    return to_decision(apart, inside);
}

/// Returns whether a point x proves that the polytope overlaps. g·x - d is computed of terms that
/// err by at most 4 u (|g|·|x| + m).
template <class T>
PW85_FUNCTION inline bool shows_overlap(Polytope<T> const &polytope, Vector<T, 3> const &x) noexcept
{
    Vector<T, 3> size = x;
    for (int i = 0; i < 3; ++i) size[i] = absolute(x[i]);
    T const underflow = negative_power_of_two<T>(underflow_bits);
    for (std::size_t k = 0; k < polytope.count; ++k) {
        auto const h = polytope.half_space(k);
        T const error =
            T(T(8) * T(unit_roundoff<T>())) * T(magnitude_of_dot(h.g, size) + h.magnitude);
        if (!(dot(h.g, x) - h.d > T(error + underflow))) return false;
    }
    return shows_overlap(polytope.q, x, size);
}

/// The decision by floating-point numbers, in the unit in which the largest diagonal entry of the
/// form is in [1, 4).
template <class T>
[[gnu::noinline]] PW85_FUNCTION inline Decision decide_polytope(Polytope<T> const &given) noexcept
{
    Unit const unit = unit_of(given.q);
    auto const polytope = scaled(given, unit, unit);
    auto const outside = search_polytope(polytope, T(1));
    if (outside.at.mu2 >= T(1))
        return shows_apart(polytope.q, outside.at) ? Decision::apart : Decision::none;
    auto inner = polytope;
    inner.inset = negative_power_of_two<T>(inset_bits);
    auto const inside = search_polytope(inner, T(1));
    if (inside.end != PolytopeSearch<T>::End::found) return Decision::none;
    return shows_overlap(polytope, inside.at.point) ? Decision::overlap : Decision::none;
}

PW85_SHARED_BY_QUESTIONS_OF(decide_polytope, double)

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_polytope(std::size_t n, T const *normals,
                                                   T const *offsets, SymmetricMatrix<T, 3> const &q,
                                                   Vector<T, 3> const &center) noexcept
{
    using namespace detail;
    Polytope<T> const polytope{n, normals, offsets, q, center, {}, T(0)};
    Decision const simple = decide_by_planes(polytope);
    if (simple != Decision::none) return {simple == Decision::overlap, StatusCode::success};
    StatusCode const planes = check_planes(polytope).status,
                     status = planes == StatusCode::success ? validate(q) : planes;
    if (status != StatusCode::success) return {false, status};
    Decision const decision = decide_polytope(polytope);
    if (decision != Decision::none) return {decision == Decision::overlap, status};
    if constexpr (exact::is_decidable<T>)
        return {polytope_overlaps_exactly(n, normals, offsets, q, center), status};
    else
        return {contact_polytope(n, normals, offsets, q, center).mu2 < T(1), status};
}

} // namespace pw85

#endif
