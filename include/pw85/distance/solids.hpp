// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The signed distance of an ellipsoid and a convex set: a segment, a triangle, a solid box.
/// src/c_api/solids.cpp calls these functions, which call extreme_normal() (nearest.hpp) and
/// overlap_of() (overlap_shapes.hpp).
///
/// For a unit vector n, let w(n) be the least n·y of the points y of the set minus the half-width
/// α(n) = √(nᵀQn) of the ellipsoid: the width of the slab between them that is normal to n. The
/// signed distance is the largest w(n). If they are apart, every w(n) is a lower bound of the
/// distance. If they overlap, moving the set by -w(n) n separates them, and the largest w(n) is
/// minus the length of the shortest such translation. So any n proves its w(n), and it suffices
/// that the best n is among those that are tried:
///
/// 1. w is a minimum of smooth functions, n·v - α(n) with the vertices v. At its maximum the least
///    n·y is reached at a vertex, at an edge or at a face. At a face, n is one of its two normals.
/// 2. At an edge with the point a, n is a local maximum of n·a - α(n) on the circle of the unit
///    vectors across the edge. This is the problem of a point and an ellipse, to which both are
///    projected along the edge. At a vertex it is that of a point and the ellipsoid.
/// 3. n·x - α(n) has at most two local maxima, up to symmetry (J. M. Martínez, SIAM J. Optim. 4,
///    159, 1994, with the points of the surface as the unknowns). One is global: extreme_normal().
///    Only it counts if they are apart, because w increases up to it then. With the numbers of
///    nearest.hpp, the other one has n along v with v_i = r_i/(g_i - σ). Here 0 < σ < g_i for the
///    axes with g_i > 0, and σ is the smaller root of F(σ)² = Σ q_i r_i²/(g_i - σ)² = 1. F² is
///    convex, so Newton's method is monotone from the σ at which the term with g_i = 0 is 1. If r_i
///    = 0 for this axis, the other one is the mirror image of the global one.
/// 4. The largest w(n) depends continuously on the data. So a local maximum that appears or
///    disappears by rounding errors changes the result by no more than the rounding errors do.
///
/// Coordinates across an edge mix entries of Q of different sizes. So the normal is computed twice,
/// the second time in coordinates of which one is along the first normal.
#ifndef PW85_DISTANCE_SOLIDS_HPP_INCLUDED
#define PW85_DISTANCE_SOLIDS_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/distance/walls.hpp>
#include <pw85/shapes/overlap_shapes.hpp>

namespace pw85 {

/// The signed distance of an ellipsoid and a convex set. All numbers are NaN if the status is not
/// success.
template <class T> struct ShapeDistance {
    T distance;          ///< negative if they overlap: minus the depth
    Vector<T, 3> point1; ///< of the ellipsoid, relative to its centre: the nearest or the deepest
    Vector<T, 3> point2; ///< of the set, relative to the centre of the ellipsoid
    /// unit vector out of the ellipsoid at point1 and into the set: the derivative with respect to
    /// the position of the set
    Vector<T, 3> normal;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// principal_axes() of a form in any unit.
template <class T, int D>
PW85_FUNCTION inline PrincipalAxes<T, D> axes_in_unit(SymmetricMatrix<T, D> const &q) noexcept
{
    Unit const unit = unit_of(q);
    auto axes = principal_axes(unit.to_local(q));
    for (T &square : axes.squares) square = unit.to_caller(square, 2);
    return axes;
}

/// The first axis with g_i = 0.
template <class T, int D>
PW85_FUNCTION inline int axis_without_gap(AxisComponents<T, D> const &c) noexcept
{
    int i = 0;
    while (i + 1 < D && !(c.gaps[i] <= T(0))) ++i;
    return i;
}

/// Item 3: the local maximum that is not the global one. Returns false if there is none.
template <class T, int D> PW85_FUNCTION inline bool
local_normal(PrincipalAxes<T, D> const &p, Vector<T, D> const &x, Vector<T, D> &n) noexcept
{
    AxisComponents<T, D> const c = axis_components(p, x, true);
    int const last = axis_without_gap(c);
    T v[std::size_t(D)], sigma = c.roots[last];
    if (!(sigma > T(0))) {
        n = extreme_normal(p, x, true);
        T twice = T(0);
        for (int k = 0; k < D; ++k) twice = twice + T(2) * n[k] * p.axes[k][last];
        for (int k = 0; k < D; ++k) n[k] = n[k] - twice * p.axes[k][last];
        return true;
    }
    for (int step = 0; step < max_shift_steps; ++step) {
        T f2 = T(-1), slope = T(0);
        for (int i = 0; i < D; ++i) {
            T const gap = i == last ? sigma : T(c.gaps[i] - sigma);
            if (!(gap > T(0))) return false;
            T const root = c.roots[i] / gap, square = root * root;
            f2 = f2 + square;
            slope = slope + (i == last ? T(square / gap) : T(-square / gap));
            v[i] = (i == last ? T(-c.along[i]) : c.along[i]) / gap;
        }
        if (!(f2 > T(0))) break;
        if (!(slope > T(0))) return false;
        T const change = f2 / (slope + slope);
        if (!(change > unit_roundoff<T>() * sigma)) break;
        sigma = sigma + change;
    }
    n = unit_vector_along<T, D>(p, v);
    return true;
}

/// The unit vectors that are tried for a set: at most 6 of faces, 24 of edges and 16 of vertices.
template <class T, class Set> struct SlabSearch {
    Set const &set;
    SymmetricMatrix<T, 3> const &q;
    bool overlap;
    int size;
    T best;
    Vector<T, 3> normals[46];
    T widths[46];

    PW85_MEMBER void take(Vector<T, 3> const &n) noexcept
    {
        T const width = set.least_projection(n) - support(q, n).extent;
        if (!(width == width)) return;
        normals[size] = n;
        widths[size++] = width;
        best = maximum(best, width);
    }

    PW85_MEMBER void take_both(Vector<T, 3> const &n) noexcept
    {
        take(n);
        take(-n);
    }
};

/// Tries the normals of a vertex.
template <class T, class Set>
PW85_FUNCTION inline void try_vertex(SlabSearch<T, Set> &search, PrincipalAxes<T, 3> const &axes,
                                     Vector<T, 3> const &vertex) noexcept
{
    search.take(extreme_normal(axes, vertex, true));
    Vector<T, 3> other;
    if (search.overlap && local_normal(axes, vertex, other)) search.take(other);
}

/// Two unit vectors across an edge, and the principal axes of the ellipse to which they project the
/// ellipsoid.
template <class T> struct EdgeFrame {
    Vector<T, 3> e1, e2;
    PrincipalAxes<T, 2> axes;

    PW85_MEMBER EdgeFrame(SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &first,
                          Vector<T, 3> const &second) noexcept
        : e1(first), e2(second)
    {
        Vector<T, 3> const q1 = product(q, e1), q2 = product(q, e2);
        axes = axes_in_unit(
            SymmetricMatrix<T, 2>{positive_form(q, e1, q1), dot(e1, q2), positive_form(q, e2, q2)});
    }

    /// Computes the normal of one of the two local maxima. Returns false if there is none.
    PW85_MEMBER bool normal(Vector<T, 3> const &point, bool global, Vector<T, 3> &n) const noexcept
    {
        Vector<T, 2> const across{dot(e1, point), dot(e2, point)};
        Vector<T, 2> n2{};
        if (global)
            n2 = extreme_normal(axes, across, true);
        else if (!local_normal(axes, across, n2))
            return false;
        n = add_scaled(n2[0] * e1, n2[1], e2);
        return true;
    }
};

/// Tries the normals of an edge between two points.
template <class T, class Set> PW85_FUNCTION inline void
try_edge(SlabSearch<T, Set> &search, Vector<T, 3> const &a, Vector<T, 3> const &b) noexcept
{
    Vector<T, 3> along = b - a, e1, e2, n;
    T const largest = largest_coordinate(along);
    if (!(largest > T(0))) return;
    along = unit_along(along / largest);
    complete_basis(along, e1, e2);
    EdgeFrame<T> const frame(search.q, e1, e2);
    for (bool const global : {true, false}) {
        if (!global && !search.overlap) return;
        if (!frame.normal(a, global, n)) continue;
        search.take(n);
        if (EdgeFrame<T>(search.q, n, cross(along, n)).normal(a, global, n)) search.take(n);
    }
}

template <class T>
PW85_FUNCTION inline void try_features(SlabSearch<T, Hull<T, 2>> &search) noexcept
{
    auto const &[a, b] = search.set.points;
    auto const axes = axes_in_unit(search.q);
    try_vertex(search, axes, a);
    try_vertex(search, axes, b);
    try_edge(search, a, b);
}

/// The normal of a triangle, zero for a triangle without area, to the digits of T.
template <class T>
PW85_FUNCTION inline Vector<T, 3> face_normal(Hull<T, 3> const &triangle) noexcept
{
    using W = Finer<T>;
    Vector<T, 3> const &a = triangle.points[0], &b = triangle.points[1], &c = triangle.points[2];
    T const size = maximum(largest_coordinate(b - a), largest_coordinate(c - a));
    if (!(size > T(0))) return {T(0), T(0), T(0)};
    Unit const unit = unit_of(size);
    auto const from_a = [&](Vector<T, 3> const &x) {
        return converted<W>(unit.to_local(x)) - converted<W>(unit.to_local(a));
    };
    Vector<T, 3> const n = rounded(cross(from_a(b), from_a(c)));
    T const largest = largest_coordinate(n);
    if (!(largest > T(0))) return {T(0), T(0), T(0)};
    return unit_along(n / largest);
}

template <class T>
PW85_FUNCTION inline void try_features(SlabSearch<T, Hull<T, 3>> &search) noexcept
{
    auto const &points = search.set.points;
    auto const axes = axes_in_unit(search.q);
    for (int k = 0; k < 3; ++k) {
        try_vertex(search, axes, points[k]);
        try_edge(search, points[k], points[(k + 1) % 3]);
    }
    Vector<T, 3> const n = face_normal(search.set);
    if (largest_coordinate(n) > T(0)) search.take_both(n);
}

/// Corner `code` of a box: bit i says whether coordinate i is the upper one.
template <class T>
PW85_FUNCTION constexpr Vector<T, 3> corner(SolidBox<T> const &box, int code) noexcept
{
    Vector<T, 3> x{};
    for (int i = 0; i < 3; ++i) x[i] = (code >> i & 1) != 0 ? box.upper[i] : box.lower[i];
    return x;
}

/// The coordinates across an edge along axis i are those of the other two axes.
template <class T>
PW85_FUNCTION inline void try_features(SlabSearch<T, SolidBox<T>> &search) noexcept
{
    auto const axes = axes_in_unit(search.q);
    for (int code = 0; code < 8; ++code) try_vertex(search, axes, corner(search.set, code));
    for (int i = 0; i < 3; ++i) {
        Vector<T, 3> unit[3]{}, n;
        for (int k = 0; k < 3; ++k) unit[k][k] = T(1);
        search.take_both(unit[i]);
        EdgeFrame<T> const frame(search.q, unit[(i + 1) % 3], unit[(i + 2) % 3]);
        for (int code = 0; code < 8; ++code) {
            if ((code >> i & 1) != 0) continue;
            Vector<T, 3> const a = corner(search.set, code);
            for (bool const global : {true, false})
                if ((global || search.overlap) && frame.normal(a, global, n)) search.take(n);
        }
    }
}

/// The point of a set that is nearest to x.
template <class T, int N>
PW85_FUNCTION inline Vector<T, 3> nearest_of(Hull<T, N> hull, Vector<T, 3> const &x) noexcept
{
    for (auto &y : hull.points) y = y - x;
    SymmetricMatrix<T, 3> const ball{T(1), T(0), T(0), T(1), T(0), T(1)};
    if constexpr (N == 2)
        return x + contact_of(hull.points, ball, FindOnSegment<>{}).point;
    else
        return x + contact_of(hull.points, ball, FindOnTriangle<>{}).point;
}

template <class T>
PW85_FUNCTION inline Vector<T, 3> nearest_of(SolidBox<T> const &box, Vector<T, 3> const &x) noexcept
{
    Vector<T, 3> y{};
    for (int i = 0; i < 3; ++i) y[i] = clamped(x[i], box.lower[i], box.upper[i]);
    return y;
}

/// The result for one of the unit vectors. If the two are apart, the point of the set is the one
/// nearest to the point of the ellipsoid. Otherwise it is the one nearest to the place of this
/// point after the translation that separates them.
template <class T, class Set> PW85_FUNCTION inline ShapeDistance<T>
distance_along(SlabSearch<T, Set> const &search, int k) noexcept
{
    Vector<T, 3> const &n = search.normals[k];
    T const width =
        search.overlap ? minimum(T(0), search.widths[k]) : maximum(T(0), search.widths[k]);
    Vector<T, 3> const point = support_from(accurate_product(search.q, n), n).point;
    return {width, point, nearest_of(search.set, add_scaled(point, minimum(T(0), width), n)), n,
            StatusCode::success};
}

/// The result for the largest width. If several widths are equal up to rounding, their normals can
/// differ by √u. For the exact normal n and its width w, the vector between the points is w n. So
/// the function takes the normal for which this vector differs least from w n.
template <class T, class Set>
PW85_FUNCTION inline ShapeDistance<T> best_distance(SlabSearch<T, Set> const &search) noexcept
{
    T least = infinity<T>();
    auto best = all_nan<ShapeDistance<T>>(StatusCode::invalid_argument);
    for (int k = 0; k < search.size; ++k) {
        Vector<T, 3> const &n = search.normals[k];
        T const extent = support(search.q, n).extent;
        T const sizes = absolute(search.best) + extent + magnitude_of_form(search.q, n) / extent;
        T const error = T(4 * unit_roundoff<T>()) * sizes;
        if (search.widths[k] < search.best - error) continue;
        auto const found = distance_along(search, k);
        T const gap =
            largest_coordinate(add_scaled(found.point2 - found.point1, T(-found.distance), n));
        if (!(gap < least)) continue;
        least = gap;
        best = found;
    }
    return best;
}

/// The largest magnitude of a coordinate of a set.
template <class T, int N> PW85_FUNCTION inline T size_of(Hull<T, N> const &hull) noexcept
{
    return largest_coordinate(hull.magnitudes({}));
}

template <class T> PW85_FUNCTION inline T size_of(SolidBox<T> const &box) noexcept
{
    return maximum(largest_coordinate(box.lower), largest_coordinate(box.upper));
}

/// The unit for a set, if `own` is that for the ellipsoid. It is larger only if sums of a few
/// coordinates of the set would overflow.
template <class T, class Set>
PW85_FUNCTION inline Unit unit_of_set(Set const &set, Unit own) noexcept
{
    return larger_unit(own, size_of(set), Unit{8 - std::numeric_limits<T>::max_exponent});
}

/// Computes the signed distance in the unit in which the largest diagonal entry of the form is in
/// [1, 4), or in that of a set that is so far away that it would overflow. In the unit of the set,
/// an ellipsoid whose form would underflow is made larger. This change is far below rounding errors
/// of the set. The sign is that of the decision.
template <class T, class Set> PW85_FUNCTION inline ShapeDistance<T>
distance_of(Set const &set, SymmetricMatrix<T, 3> const &q) noexcept
{
    ShapeOverlap const decision = overlap_of(set, q);
    if (decision.status != StatusCode::success) return all_nan<ShapeDistance<T>>(decision.status);
    Unit const own = unit_of(q), unit = unit_of_set<T>(set, own),
               limit{std::numeric_limits<T>::max_exponent / 4};
    SymmetricMatrix<T, 3> const form = smaller_of(unit, own * limit).to_local(q);
    Set const scaled = set.in_unit(unit);
    SlabSearch<T, Set> search{scaled, form, decision.overlap, 0, -infinity<T>(), {}, {}};
    try_features(search);
    auto best = best_distance(search);
    best.distance = unit.to_caller(best.distance);
    best.point1 = unit.to_caller(best.point1);
    best.point2 = unit.to_caller(best.point2);
    return best;
}

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_segment(Vector<T, 3> const &end1,
                                                       Vector<T, 3> const &end2,
                                                       SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::distance_of(detail::Hull<T, 2>{{end1, end2}}, q);
}

template <class T> PW85_FUNCTION inline ShapeDistance<T>
distance_triangle(Vector<T, 3> const &vertex1, Vector<T, 3> const &vertex2,
                  Vector<T, 3> const &vertex3, SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::distance_of(detail::Hull<T, 3>{{vertex1, vertex2, vertex3}}, q);
}

template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_solid_box(Vector<T, 3> const &lower,
                                                         Vector<T, 3> const &upper,
                                                         SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::distance_of(detail::SolidBox<T>{lower, upper}, q);
}

} // namespace pw85

#endif
