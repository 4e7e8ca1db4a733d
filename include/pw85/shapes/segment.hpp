// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of an ellipsoid and a segment. triangle.hpp uses it for the edges of a
/// triangle.
///
/// The segment is a + t e, 0 <= t <= 1, with e = b - a. Its nearest point is at t =
/// -a·Q⁻¹e/(e·Q⁻¹e), or at the nearer end, and the pivots of Q (Elimination) give μ² there. μ² is
/// least at this point: an error of t changes μ² only to second order. For needles and discs,
/// rounding errors of t may be so large that this change matters. So t is computed twice: from the
/// nearer end, and again from the point that the first t gives.
#ifndef PW85_SHAPES_SEGMENT_HPP_INCLUDED
#define PW85_SHAPES_SEGMENT_HPP_INCLUDED

#include <pw85/shapes/nearest_point.hpp>

namespace pw85::detail {

/// The nearest point of the edge from a to b, by the second or by the first t. A proof
/// (overlap_shapes.hpp) needs a point of the edge that is nearly the nearest one, and the first t
/// takes half the time.
template <bool with_normal, bool refined, class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_on_edge(Vector<T, 3> const &a, Vector<T, 3> const &b, Elimination<T> const &form) noexcept
{
    Vector<T, 3> const e = b - a, ze = form.map(e), weighted = form.weighted(ze), za = form.map(a),
                       zb = form.map(b);
    T const from_a = -dot(za, weighted), to_b = dot(zb, weighted), zero = T(0);
    auto const is_near = !(from_a > to_b), inside = both_true(from_a > zero, to_b > zero);
    T const reciprocal = T(1) / dot(ze, weighted);
    Vector<T, 3> const end = choose(is_near, a, b);
    T const lower = select(is_near, zero, T(-1)), upper = lower + T(1); // limits of t from this end
    T const rough = select(inside, T(select(is_near, from_a, T(-to_b)) * reciprocal), zero);
    T t = minimum(upper, maximum(lower, rough));
    Vector<T, 3> at{};
    if constexpr (refined) {
        Vector<T, 3> const z = form.map(add_scaled(end, rough, e));
        T const better = rough - select(inside, T(dot(z, weighted) * reciprocal), zero);
        t = minimum(upper, maximum(lower, better));
        at = add_scaled(z, T(t - rough), ze);
    } else {
        at = add_scaled(choose(is_near, za, zb), t, ze);
    }
    Vector<T, 3> const weights = form.weighted(at);
    T const mu2 = dot(at, weights) * form.reciprocal;
    return {mu2, add_scaled(end, t, e), Normal<T, 3, with_normal>{form.normal(weights)},
            mu2 == mu2};
}

/// The nearest point of a segment.
template <bool with_normal = false, bool refined = true> struct FindOnSegment {
    template <class T> PW85_MEMBER constexpr Nearest<T, with_normal>
    operator()(Vector<T, 3> const (&ends)[2], SymmetricMatrix<T, 3> const &q) const noexcept
    {
        auto const &[a, b] = ends;
        auto nearest = nearest_on_edge<with_normal, refined>(a, b, Elimination<T>(q));
        T const reach = reach_of(ends);
        if constexpr (!with_normal)
            nearest.certified = second_order(q, T(reach * reach), T(1)).is_small(nearest.mu2);
        return nearest;
    }
};

PW85_RARE_TIER_OF(find_finer, double, 2, FindOnSegment<>)
PW85_RARE_TIER_OF(contact_with_all_digits, double, 2, FindOnSegment<>)
PW85_SHARED_BY_QUESTIONS_OF(contact_points_scaled, double, 2, FindOnSegment<>)

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_segment(Vector<T, 3> const &a,
                                                        Vector<T, 3> const &b,
                                                        SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> const ends[2] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}};
    return detail::contact_of(ends, q, detail::FindOnSegment<>{});
}

} // namespace pw85

#endif
