// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of an ellipsoid and a triangle.
///
/// Let a, b and c be the vertices, n = (b - a) × (c - a), and x the nearest point of the plane of
/// the triangle (nearest_point.hpp). If x is in the triangle, it is the nearest point. Otherwise
/// the nearest point is on an edge whose line separates x from the triangle. There are one or two
/// such edges. If n has lost digits, as in a triangle without area, all three edges are tried.
///
/// n·v is equal for the three vertices v. Its mean with the weights of x has an error of u times
/// the weighted magnitudes of the vertices.
#ifndef PW85_SHAPES_TRIANGLE_HPP_INCLUDED
#define PW85_SHAPES_TRIANGLE_HPP_INCLUDED

#include <pw85/shapes/segment.hpp>

namespace pw85::detail {

/// The nearest point of the plane of a triangle, and its weights: those of b and c, and 1 minus
/// their sum. `errors` is that of errors_of_weights().
template <class T, bool with_normal> struct NearestOnPlane {
    Nearest<T, with_normal> nearest;
    Vector<T, 3> weights;
    SecondOrder<T> errors;
};

/// The term of second order of the weights. Near the triangle, rounding errors move the point of
/// the plane by at most 20 u R |e1| |e2|/|n|. Of these, 7 u |p| |e2|/|n| and 7 u |e1| |p|/|n| are
/// the errors of the products for the weights of b and c, with |p| <= R, and the rest is that of
/// the normal. If this takes the point across an edge, the edge is at most that far away. `product`
/// is no less than |e1| |e2|.
template <class T>
PW85_FUNCTION constexpr SecondOrder<T> errors_of_weights(SymmetricMatrix<T, 3> const &q,
                                                         T const &reach, T const &product,
                                                         T const &nn) noexcept
{
    T const size = reach * product;
    return second_order(q, T(size * size), nn);
}

/// The square of the largest allowed ratio between the terms of the coordinates of the normal of a
/// triangle and the normal itself. Cancellation increases the relative error of the normal by this
/// ratio, which is 8 for a type without guard digits.
template <class T> PW85_FUNCTION constexpr T square_of_largest_cancellation() noexcept
{
    return T(64) / negative_power_of_two<T>(2 * (mantissa_digits<T>() - result_digits<T>()));
}

/// Returns whether n is not smaller than the terms of its coordinates by more than a factor, in
/// units of the bounding box of the ellipsoid.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate_normal(Vector<T, 3> const &n, Vector<T, 3> const &e1, Vector<T, 3> const &e2,
                   SymmetricMatrix<T, 3> const &q, T const &square_of_factor) noexcept
{
    T size = T(0), terms = T(0);
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        T const term = absolute(T(e1[j] * e2[k])) + absolute(T(e1[k] * e2[j]));
        size = size + T(n[i] * n[i]) * q(i, i);
        terms = terms + T(term * term) * q(i, i);
    }
    return T(square_of_factor * size) > terms;
}

template <bool with_normal, class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr NearestOnPlane<T, with_normal>
nearest_on_plane(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const &[a, b, c] = vertices;
    Vector<T, 3> const e1 = b - a, e2 = c - a, n = cross(e1, e2), qn = product(q, n);
    T const reciprocal = T(1) / dot(n, qn), da = dot(n, a);
    Vector<T, 3> const p = T(da * reciprocal) * qn - a;
    T const nn = dot(n, n), scale = T(1) / nn;
    T const wb = dot(n, cross(p, e2)) * scale, wc = dot(n, cross(e1, p)) * scale,
            wa = T(1) - wb - wc;
    T const d = wa * da + wb * dot(n, b) + wc * dot(n, c);
    return {{T(d * d) * reciprocal, add_scaled(add_scaled(wa * a, wb, b), wc, c),
             Normal<T, 3, with_normal>{choose(d < T(0), -n, n)},
             is_accurate_normal(n, e1, e2, q, square_of_largest_cancellation<T>())},
            {wa, wb, wc},
            errors_of_weights(q, reach_of(vertices),
                              T(sum_of_magnitudes(e1) * sum_of_magnitudes(e2)), nn)};
}

/// The ends of an edge.
template <class T> struct Ends {
    Vector<T, 3> first, second;
};

/// The edge that has the nearest point, if the nearest point of the plane is not in the triangle.
/// The vertex m with the largest weight is one of its ends; let i and j be the others. If the
/// weight of i is not negative, the nearest point of the plane is beyond the edge from m to i only.
/// If the weights of i and j are both negative, this point is beyond both edges of m. Then m·Q⁻¹e <
/// 0 holds for at most one of the edges e that begin at m, by Cauchy's inequality, and that edge
/// has the nearest point; if it holds for none, m is the nearest point.
template <class T> [[gnu::always_inline]] PW85_FUNCTION constexpr Ends<T>
nearest_edge(Vector<T, 3> const (&vertices)[3], Vector<T, 3> const &weights,
             Elimination<T> const &form) noexcept
{
    auto const &[a, b, c] = vertices;
    auto const is_b = weights[1] > weights[0] && weights[1] >= weights[2];
    auto const is_c = !is_b && weights[2] > weights[0];
    auto const turned = [&](auto const &x, auto const &y, auto const &z) {
        return choose(is_b, y, choose(is_c, z, x));
    };
    auto const m = turned(a, b, c), i = turned(b, c, a), j = turned(c, a, b);
    T const wi = select(is_b, weights[2], select(is_c, weights[0], weights[1]));
    T const wj = select(is_b, weights[0], select(is_c, weights[1], weights[2]));
    auto const is_i =
        wi >= T(0) || (wj < T(0) && dot(form.weighted(form.map(m)), form.map(i - m)) < T(0));
    return {m, choose(is_i, i, j)};
}

/// The nearest point of the edges.
template <bool with_normal, bool refined, class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_of_edges(Vector<T, 3> const (&vertices)[3], Elimination<T> const &form) noexcept
{
    auto best = nearest_on_edge<with_normal, refined>(vertices[1], vertices[2], form);
    for (int k = 1; k < 3; ++k) {
        auto const found = nearest_on_edge<with_normal, refined>(vertices[(k + 1) % 3],
                                                                 vertices[(k + 2) % 3], form);
        best = choose(!(found.mu2 >= best.mu2), found, best);
    }
    return best;
}

/// Returns whether the digits of T suffice for a triangle whose normal is not accurate and whose
/// nearest point is on an edge, with this μ². There are two reasons:
///
/// - It is known, up to the errors of the weights, on which side of each edge the nearest point of
///   the plane is. The normal is used only for this, so the square of its relative error may be as
///   large as u. Its coordinates err by 4 u times their terms.
/// - The triangle is so thin that no point inside is nearer than the edges, up to rounding. The
///   height above the longer one of two edges is |n|/|e|. The error of |n| is at most 5 u |e1|
///   |e2|, so the true n² is at most 2 n² + 50 u² (|e1| |e2|)².
///
/// The function is not inlined: compilers would keep numbers in memory for it.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
edges_suffice(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q,
              SecondOrder<T> const &errors, T const &mu2) noexcept
{
    auto const &[a, b, c] = vertices;
    Vector<T, 3> const e1 = b - a, e2 = c - a, n = cross(e1, e2);
    T const size1 = sum_of_magnitudes(e1), size2 = sum_of_magnitudes(e2),
            longest = maximum(size1, size2);
    T const product = size1 * size2, reach = reach_of(vertices), u = T(unit_roundoff<T>());
    T const height = T(dot(n, n) / T(T(16) * u * u)) + product * product;
    auto const place = is_accurate_normal(n, e1, e2, q, T(T(1) / square_of_roundoff<T>(4)));
    auto const thin =
        longest == T(0) || second_order(q, height, T(longest * longest)).is_small(mu2);
    return (place && errors.is_small(mu2)) ||
           (thin && second_order(q, T(reach * reach), T(1)).is_small(mu2));
}

/// The nearest point of a triangle. For proofs (overlap_shapes.hpp) it does not matter whether the
/// digits suffice.
template <bool with_normal, bool refined, class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_on_triangle(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const plane = nearest_on_plane<with_normal>(vertices, q);
    auto const &w = plane.weights;
    auto const inside = both_true(w[0] >= T(0), both_true(w[1] >= T(0), w[2] >= T(0)));
    auto const accurate = plane.nearest.certified;
    auto nearest = plane.nearest;
    if (all_of(inside)) {
        if constexpr (!with_normal)
            nearest.certified = accurate && plane.errors.is_small(nearest.mu2);
        return nearest;
    }
    Elimination<T> const form(q);
    auto const ends = nearest_edge(vertices, w, form);
    auto edge = nearest_on_edge<with_normal, refined>(ends.first, ends.second, form);
    auto const known = inside || accurate;
    auto edges_are_certain = T(0) < T(0);
    if (!all_of(known)) {
        auto const of_edges = nearest_of_edges<with_normal, refined>(vertices, form);
        edge = choose(known, edge, of_edges);
        if constexpr (!with_normal)
            edges_are_certain = !known && edges_suffice(vertices, q, plane.errors, of_edges.mu2);
    }
    nearest = choose(inside, nearest, edge);
    if constexpr (!with_normal)
        nearest.certified = (accurate && plane.errors.is_small(nearest.mu2)) || edges_are_certain;
    return nearest;
}

/// Finds the nearest point of one triangle. The function is not inlined: with the checks around it,
/// compilers would keep its numbers in memory.
template <bool with_normal, bool refined, class T>
[[gnu::noinline]] PW85_FUNCTION inline Nearest<T, with_normal>
nearest_on_one_triangle(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) noexcept
{
    return nearest_on_triangle<with_normal, refined>(vertices, q);
}

template <bool with_normal = false, bool refined = true> struct FindOnTriangle {
    template <class T> PW85_MEMBER Nearest<T, with_normal>
    operator()(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) const noexcept
    {
        if constexpr (ScalarTraits<T>::lanes == 1)
            return nearest_on_one_triangle<with_normal, refined>(vertices, q);
        else
            return nearest_on_triangle<with_normal, refined>(vertices, q);
    }
};

PW85_RARE_TIER_OF(find_finer, double, 3, FindOnTriangle<>)
PW85_RARE_TIER_OF(contact_with_all_digits, double, 3, FindOnTriangle<>)
PW85_SHARED_BY_QUESTIONS_OF(contact_points_scaled, double, 3, FindOnTriangle<>)

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline ShapeContact<T, 3>
contact_triangle(Vector<T, 3> const &a, Vector<T, 3> const &b, Vector<T, 3> const &c,
                 SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> const vertices[3] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}};
    return detail::contact_of(vertices, q, detail::FindOnTriangle<>{});
}

} // namespace pw85

#endif
