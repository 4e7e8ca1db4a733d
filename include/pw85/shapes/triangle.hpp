/// @file
/// The contact function of an ellipsoid and a triangle. The items are those of nearest_point.hpp.
///
/// Let a, b and c be the vertices, n = (b - a) × (c - a), and x the nearest point of the plane of the triangle (item 1). If x is in
/// the triangle, it is the nearest point. Otherwise the nearest point is on an edge whose line separates x from the triangle: x -
/// y has no obtuse angle with any other edge at a point y of it. There are one or two such edges. A triangle without area is the
/// longest of its edges, and all three are tried.
///
/// n·v is the same for the three vertices v. Its mean with the weights of x errs by u times the weighted magnitudes of the vertices.
#ifndef PW85_SHAPES_TRIANGLE_HPP_INCLUDED
#define PW85_SHAPES_TRIANGLE_HPP_INCLUDED

#include <pw85/shapes/segment.hpp>

namespace pw85::detail {

/// The nearest point of the plane of a triangle, and its weights: those of b and c, and 1 minus their sum.
template <class T, bool with_normal> struct NearestOnPlane {
    Nearest<T, with_normal> nearest;
    Vector<T, 3> weights;
};

/// How many times smaller the normal of a triangle may be than the terms of its coordinates. The error of the normal is larger by
/// this factor.
inline constexpr int largest_cancellation = 8;

/// Whether n is not much smaller than the terms of its coordinates, in units of the bounding box of the ellipsoid.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_accurate_normal(Vector<T, 3> const &n, Vector<T, 3> const &e1,
                                                                          Vector<T, 3> const &e2,
                                                                          SymmetricMatrix<T, 3> const &q) noexcept
{
    T size = T(0), terms = T(0);
    for (int i = 0; i < 3; ++i) {
        int const j = (i + 1) % 3, k = (i + 2) % 3;
        T const term = absolute(T(e1[j] * e2[k])) + absolute(T(e1[k] * e2[j]));
        size = size + T(n[i] * n[i]) * q(i, i);
        terms = terms + T(term * term) * q(i, i);
    }
    return T(T(largest_cancellation * largest_cancellation) * size) > terms;
}

template <bool with_normal, class T> [[gnu::always_inline]] PW85_FUNCTION constexpr NearestOnPlane<T, with_normal>
nearest_on_plane(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) noexcept
{
    auto const &[a, b, c] = vertices;
    Vector<T, 3> const e1 = b - a, e2 = c - a, n = cross(e1, e2), qn = product(q, n);
    T const reciprocal = T(1) / dot(n, qn), da = dot(n, a);
    Vector<T, 3> const p = T(da * reciprocal) * qn - a;
    T const nn = dot(n, n), scale = T(1) / nn;
    T const wb = dot(n, cross(p, e2)) * scale, wc = dot(n, cross(e1, p)) * scale, wa = T(1) - wb - wc;
    T const d = wa * da + wb * dot(n, b) + wc * dot(n, c);
    return {{T(d * d) * reciprocal, add_scaled(add_scaled(wa * a, wb, b), wc, c),
             Normal<T, 3, with_normal>{choose(d < T(0), -n, n)}, is_accurate_normal(n, e1, e2, q)},
            {wa, wb, wc}};
}

/// The nearest point of a triangle in units of order one.
template <template <class, bool> class Segments, bool with_normal = false> struct FindOnTriangle {
    template <class T> PW85_MEMBER constexpr Nearest<T, with_normal>
    operator()(Vector<T, 3> const (&vertices)[3], SymmetricMatrix<T, 3> const &q) const noexcept
    {
        auto const plane = nearest_on_plane<with_normal>(vertices, q);
        auto const &w = plane.weights;
        auto const inside = w[0] >= T(0) && w[1] >= T(0) && w[2] >= T(0);
        if (all_of(inside)) return plane.nearest;
        return choose(inside, plane.nearest, nearest_on_edges(vertices, w, plane.nearest.certain, q));
    }

    /// The nearest point of those edges that may have it: the edge opposite to vertex k, if its weight is negative. If the normal is
    /// not accurate, these are all edges.
    template <class T> PW85_MEMBER static constexpr Nearest<T, with_normal>
    nearest_on_edges(Vector<T, 3> const (&vertices)[3], Vector<T, 3> const &weights,
                     typename ScalarTraits<T>::Mask const &certain, SymmetricMatrix<T, 3> const &q) noexcept
    {
        Segments<T, with_normal> const nearest_on_edge(q);
        Nearest<T, with_normal> best{quiet_nan<T>(), vertices[0], Normal<T, 3, with_normal>{vertices[0]}, certain};
        for (int k = 0; k < 3; ++k) {
            auto const away = certain && weights[k] >= T(0);
            if (all_of(away)) continue;
            auto const found = nearest_on_edge(vertices[(k + 1) % 3], vertices[(k + 2) % 3]);
            best = choose(!away && !(found.mu2 >= best.mu2), found, best);
        }
        return best;
    }
};

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline ShapeContact<T> contact_triangle(Vector<T, 3> const &a, Vector<T, 3> const &b,
                                                                         Vector<T, 3> const &c,
                                                                         SymmetricMatrix<T, 3> const &q) noexcept
{
    Vector<T, 3> const vertices[3] = {a, b, c};
    return detail::contact_of(vertices, q, detail::FindOnTriangle<detail::FastSegments>{},
                              detail::FindOnTriangle<detail::CarefulSegments>{});
}

} // namespace pw85

#endif
