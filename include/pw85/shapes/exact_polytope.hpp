// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides in integers whether a polytope overlaps an ellipsoid, and where the scaled ellipsoid
/// touches it. overlap_polytope.hpp and polytope.hpp call these functions. A polytope that only
/// touches the ellipsoid does not overlap it.
///
/// A half-space is g·x >= d, with x relative to the centre c of the ellipsoid, and d = -offset -
/// g·c. The search is that of polytope.hpp with exact signs. It ends in three cases: no half-space
/// is violated; the half-spaces have no common point; only the overlap is asked for, and μ² of the
/// touched planes is 1 or more. μ² increases from step to step, so no set of planes occurs twice,
/// and the search ends. For touched planes 1 to K, M_ij = g_iᵀQg_j. For K = 3, C = g_1·(g_2 × g_3)
/// and w_i = g_j × g_k in cyclic order.
///
/// All numbers whose signs decide are sums of products of the given numbers
/// (sums_of_products.hpp).
#ifndef PW85_SHAPES_EXACT_POLYTOPE_HPP_INCLUDED
#define PW85_SHAPES_EXACT_POLYTOPE_HPP_INCLUDED

#include <cstddef>

#include <pw85/shapes/nearest_point.hpp>
#include <pw85/shapes/sums_of_products.hpp>

namespace pw85::detail {

namespace exact {

/// A half-space g·x >= -offset.
template <class T> struct GivenPlane {
    BinaryFraction<T> g[3], offset;
};

/// At most three planes that the scaled ellipsoid touches at a point.
template <class T> struct GivenPlanes {
    GivenPlane<T> planes[3];
    int size;
};

/// Question for a search: overlap, is μ² < 1? contact, what is μ²?
enum class Question { overlap, contact };

/// The form and the centre of the ellipsoid.
template <class T> struct GivenEllipsoid {
    BinaryFraction<T> entries[6], center[3];
    Question question;

    [[gnu::always_inline]] BinaryFraction<T> const &q(int i, int j) const noexcept
    {
        return entries[SymmetricMatrix<T, 3>::index(i < j ? i : j, i < j ? j : i)];
    }
};

// The functions times_...(e, x, ..., f) call f for each of the products whose sum is x times a
// number. The comments name the number.

/// d.
template <class T, int N, class F>
PW85_FUNCTION inline void times_distance(GivenEllipsoid<T> const &e, Product<N> const &x,
                                         GivenPlane<T> const &a, F &&f) noexcept
{
    f(-(x * a.offset));
    for (int i = 0; i < 3; ++i)
        if (e.center[i].sign != 0 && a.g[i].sign != 0) f(-(x * a.g[i] * e.center[i]));
}

/// M, for two planes.
template <class T, int N, class F>
PW85_FUNCTION inline void times_gram(GivenEllipsoid<T> const &e, Product<N> const &x,
                                     GivenPlane<T> const &a, GivenPlane<T> const &b, F &&f) noexcept
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (a.g[i].sign * b.g[j].sign * e.q(i, j).sign != 0) f(x * a.g[i] * b.g[j] * e.q(i, j));
}

/// D = det M > 0, for one or two planes.
template <class T, int N, class F>
PW85_FUNCTION inline void times_determinant(GivenEllipsoid<T> const &e, Product<N> const &x,
                                            GivenPlanes<T> const &at, F &&f) noexcept
{
    GivenPlane<T> const &a = at.planes[0], &b = at.planes[1];
    if (at.size == 1) return times_gram(e, x, a, a, f);
    times_gram(e, x, a, a, [&](auto const &y) { times_gram(e, y, b, b, f); });
    times_gram(e, -x, a, b, [&](auto const &y) { times_gram(e, y, a, b, f); });
}

/// N_i, which has the sign of λ_i, for one or two planes: N_1 = d_1 for K = 1, and N_i = d_i M_jj -
/// d_j M_ij for K = 2.
template <class T, int N, class F>
PW85_FUNCTION inline void times_multiplier(GivenEllipsoid<T> const &e, Product<N> const &x,
                                           GivenPlanes<T> const &at, int i, F &&f) noexcept
{
    GivenPlane<T> const &a = at.planes[i], &b = at.planes[1 - i];
    if (at.size == 1) return times_distance(e, x, a, f);
    times_distance(e, x, a, [&](auto const &y) { times_gram(e, y, b, b, f); });
    times_distance(e, -x, b, [&](auto const &y) { times_gram(e, y, a, b, f); });
}

/// Coordinate i of a × b.
template <class T, int N, class F>
PW85_FUNCTION inline void times_cross(Product<N> const &x, GivenPlane<T> const &a,
                                      GivenPlane<T> const &b, int i, F &&f) noexcept
{
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    f(x * a.g[j] * b.g[k]);
    f(-(x * a.g[k] * b.g[j]));
}

/// Coordinate j of w_i, for three planes.
template <class T, int N, class F> PW85_FUNCTION inline void
times_w(Product<N> const &x, GivenPlanes<T> const &at, int i, int j, F &&f) noexcept
{
    times_cross(x, at.planes[(i + 1) % 3], at.planes[(i + 2) % 3], j, f);
}

/// C, for three planes.
template <class T, int N, class F> PW85_FUNCTION inline void
times_volume(Product<N> const &x, GivenPlanes<T> const &at, F &&f) noexcept
{
    for (int j = 0; j < 3; ++j) times_w(x * at.planes[0].g[j], at, 0, j, f);
}

/// An entry of adj(Q).
template <class T, int N, class F> PW85_FUNCTION inline void
times_cofactor(GivenEllipsoid<T> const &e, Product<N> const &x, int i, int j, F &&f) noexcept
{
    int const i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    f(x * e.q(i1, j1) * e.q(i2, j2));
    f(-(x * e.q(i1, j2) * e.q(i2, j1)));
}

/// w_iᵀ adj(Q) w_j, for three planes.
template <class T, int N, class F>
PW85_FUNCTION inline void times_form_of_w(GivenEllipsoid<T> const &e, Product<N> const &x,
                                          GivenPlanes<T> const &at, int i, int j, F &&f) noexcept
{
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
            times_cofactor(e, x, k, l, [&](auto const &y) {
                times_w(y, at, i, k, [&](auto const &z) { times_w(z, at, j, l, f); });
            });
}

template <class T> PW85_FUNCTION inline bool are_independent(GivenPlanes<T> const &at) noexcept
{
    auto const unit = unit_product();
    if (at.size == 1) return true;
    if (at.size == 3) return sign_of_terms<T>([&](auto &f) { times_volume(unit, at, f); }) != 0;
    for (int i = 0; i < 3; ++i)
        if (sign_of_terms<T>(
                [&](auto &f) { times_cross(unit, at.planes[0], at.planes[1], i, f); }) != 0)
            return true;
    return false;
}

/// The sign of λ_i, which is the sign of N_i, or for three planes the sign of w_iᵀ adj(Q) p with p
/// = Σ d_i w_i = C x.
template <class T> PW85_FUNCTION inline int
sign_of_multiplier(GivenEllipsoid<T> const &e, GivenPlanes<T> const &at, int i) noexcept
{
    auto const unit = unit_product();
    if (at.size < 3) return sign_of_terms<T>([&](auto &f) { times_multiplier(e, unit, at, i, f); });
    return sign_of_terms<T>([&](auto &f) {
        for (int j = 0; j < 3; ++j)
            times_distance(e, unit, at.planes[j],
                           [&](auto const &x) { times_form_of_w(e, x, at, i, j, f); });
    });
}

/// The numerator of μ²: Σ d_i N_i, or for three planes pᵀ adj(Q) p.
template <class T, int N, class F>
PW85_FUNCTION inline void times_numerator(GivenEllipsoid<T> const &e, Product<N> const &x,
                                          GivenPlanes<T> const &at, F &&f) noexcept
{
    auto const &planes = at.planes;
    if (at.size < 3) {
        for (int i = 0; i < at.size; ++i)
            times_distance(e, x, planes[i],
                           [&](auto const &y) { times_multiplier(e, y, at, i, f); });
        return;
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            times_distance(e, x, planes[i], [&](auto const &y) {
                times_distance(e, y, planes[j],
                               [&](auto const &z) { times_form_of_w(e, z, at, i, j, f); });
            });
}

/// The denominator of μ², which is positive: D, or for three planes C² det Q.
template <class T, int N, class F>
PW85_FUNCTION inline void times_denominator(GivenEllipsoid<T> const &e, Product<N> const &x,
                                            GivenPlanes<T> const &at, F &&f) noexcept
{
    if (at.size < 3) return times_determinant(e, x, at, f);
    for (int k = 0; k < 3; ++k)
        times_cofactor(e, x * e.q(0, k), 0, k, [&](auto const &y) {
            times_volume(y, at, [&](auto const &z) { times_volume(z, at, f); });
        });
}

/// Returns whether μ² >= 1.
template <class T>
PW85_FUNCTION inline bool reaches(GivenEllipsoid<T> const &e, GivenPlanes<T> const &at) noexcept
{
    auto const unit = unit_product();
    return sign_of_terms<T>([&](auto &f) {
               times_numerator(e, unit, at, f);
               times_denominator(e, -unit, at, f);
           }) >= 0;
}

/// The numerator of coordinate j of the point where the planes are touched: coordinate j of Σ N_i Q
/// g_i, or for three planes of p. The denominator is D or C.
template <class T, int N, class F>
PW85_FUNCTION inline void times_coordinate(GivenEllipsoid<T> const &e, Product<N> const &x,
                                           GivenPlanes<T> const &at, int j, F &&f) noexcept
{
    for (int i = 0; i < at.size; ++i) {
        GivenPlane<T> const &plane = at.planes[i];
        if (at.size == 3)
            times_distance(e, x, plane, [&](auto const &y) { times_w(y, at, i, j, f); });
        else
            for (int k = 0; k < 3; ++k) times_multiplier(e, x * plane.g[k] * e.q(j, k), at, i, f);
    }
}

/// Returns whether the point where the planes are touched violates a half-space h. The condition is
/// d_h D > Σ N_i M_ih, or for three planes (d_h C - g_h·p) C > 0. If only the overlap is asked for,
/// μ² of the planes is below 1. A half-space that contains the whole ellipsoid (d <= 0 and d² >=
/// gᵀQg) is then not violated.
template <class T> PW85_FUNCTION inline bool
violates(GivenEllipsoid<T> const &e, GivenPlanes<T> const &at, GivenPlane<T> const &h) noexcept
{
    auto const unit = unit_product();
    int const side = sign_of_terms<T>([&](auto &f) { times_distance(e, unit, h, f); });
    if (at.size == 0) return side > 0;
    if (e.question == Question::overlap && side <= 0 && reaches(e, GivenPlanes<T>{{h, h, h}, 1}))
        return false;
    if (at.size < 3)
        return sign_of_terms<T>([&](auto &f) {
                   times_distance(e, unit, h,
                                  [&](auto const &x) { times_determinant(e, x, at, f); });
                   for (int i = 0; i < at.size; ++i)
                       times_multiplier(e, -unit, at, i, [&](auto const &x) {
                           times_gram(e, x, at.planes[i], h, f);
                       });
               }) > 0;
    int const excess = sign_of_terms<T>([&](auto &f) {
        times_distance(e, unit, h, [&](auto const &x) { times_volume(x, at, f); });
        for (int j = 0; j < 3; ++j) times_coordinate(e, -unit * h.g[j], at, j, f);
    });
    return excess * sign_of_terms<T>([&](auto &f) { times_volume(unit, at, f); }) > 0;
}

/// Returns whether the scaled ellipsoid first touches the intersection of `planes` and `others` at
/// these planes. It then touches all of `planes`, with positive multipliers. If μ² >= 1 and only
/// the overlap is asked for, `others` are not tested.
template <class T> PW85_FUNCTION inline bool touches(GivenEllipsoid<T> const &e,
                                                     GivenPlanes<T> const &planes,
                                                     GivenPlanes<T> const &others) noexcept
{
    if (!are_independent(planes)) return false;
    for (int i = 0; i < planes.size; ++i)
        if (sign_of_multiplier(e, planes, i) <= 0) return false;
    if (e.question == Question::overlap && reaches(e, planes)) return true;
    for (int k = 0; k < others.size; ++k)
        if (violates(e, planes, others.planes[k])) return false;
    return true;
}

/// The planes that are touched after a half-space is added; no planes if the half-spaces have no
/// common point.
template <class T>
PW85_FUNCTION inline GivenPlanes<T> touch_with(GivenEllipsoid<T> const &e,
                                               GivenPlanes<T> const &old,
                                               GivenPlane<T> const &added) noexcept
{
    for (int subset = 0; subset < 1 << old.size; ++subset) {
        GivenPlanes<T> tried{{added, added, added}, 1};
        for (int k = 0; k < old.size; ++k)
            if ((subset >> k & 1) != 0 && tried.size++ < 3)
                tried.planes[tried.size - 1] = old.planes[k];
        if (tried.size <= 3 && touches(e, tried, old)) return tried;
    }
    return {{added, added, added}, 0};
}

template <class T>
PW85_FUNCTION inline GivenEllipsoid<T> given_ellipsoid(SymmetricMatrix<T, 3> const &q,
                                                       Vector<T, 3> const &center,
                                                       Question question) noexcept
{
    GivenEllipsoid<T> ellipsoid;
    for (int k = 0; k < 6; ++k) ellipsoid.entries[k] = to_binary_fraction(q[k]);
    for (int i = 0; i < 3; ++i) ellipsoid.center[i] = to_binary_fraction(center[i]);
    ellipsoid.question = question;
    return ellipsoid;
}

template <class T>
PW85_FUNCTION inline GivenPlane<T> given_plane(T const *normal, T const &offset) noexcept
{
    return {{to_binary_fraction(T(-normal[0])), to_binary_fraction(T(-normal[1])),
             to_binary_fraction(T(-normal[2]))},
            to_binary_fraction(offset)};
}

/// Finds the planes that the scaled ellipsoid touches first. `none` becomes true if there are no
/// such planes, because the polytope is empty or, if only the overlap is asked for, because μ² >=
/// 1.
template <class T>
PW85_FUNCTION inline GivenPlanes<T> search_exactly(GivenEllipsoid<T> const &ellipsoid,
                                                   std::size_t n, T const *normals,
                                                   T const *offsets, bool &none) noexcept
{
    GivenPlanes<T> at{{}, 0};
    none = false;
    std::size_t satisfied = 0;
    for (std::size_t k = 0; satisfied < n; k = k + 1 < n ? k + 1 : 0) {
        auto const plane = given_plane(normals + 3 * k, offsets[k]);
        ++satisfied;
        if (!violates(ellipsoid, at, plane)) continue;
        at = touch_with(ellipsoid, at, plane);
        none = at.size == 0 || (ellipsoid.question == Question::overlap && reaches(ellipsoid, at));
        if (none) return at;
        satisfied = 1;
    }
    return at;
}

} // namespace exact

/// Returns whether a polytope overlaps the ellipsoid, for the numbers exactly as given.
template <class T>
requires exact::is_decidable<T> PW85_RARE bool
polytope_overlaps_exactly(std::size_t n, T const *normals, T const *offsets,
                          SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &center) noexcept
{
    using namespace exact;
    bool none;
    search_exactly(given_ellipsoid(q, center, Question::overlap), n, normals, offsets, none);
    return !none;
}

/// The contact of a polytope and the ellipsoid, for the numbers exactly as given. Each result is a
/// quotient of two exact sums, and its relative error is below 2u.
template <class T>
requires exact::is_decidable<T> PW85_RARE ShapeContact<T, 3>
contact_polytope_exactly(std::size_t n, T const *normals, T const *offsets,
                         SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &center)
noexcept
{
    using namespace exact;
    auto const ellipsoid = given_ellipsoid(q, center, Question::contact);
    bool none;
    auto const at = search_exactly(ellipsoid, n, normals, offsets, none);
    auto contact = all_nan<ShapeContact<T, 3>>(StatusCode::success);
    contact.mu2 = infinity<T>();
    if (none) return contact;
    if (at.size == 0) return {T(0), {T(0), T(0), T(0)}, StatusCode::success};
    auto const unit = unit_product();
    auto const quotient = [](Extended<T> const &x, Extended<T> const &y) { return rounded(x / y); };
    auto const square =
        value_of_terms<T>([&](auto &f) { times_denominator(ellipsoid, unit, at, f); });
    auto const divisor =
        at.size < 3 ? square : value_of_terms<T>([&](auto &f) { times_volume(unit, at, f); });
    contact.mu2 = quotient(
        value_of_terms<T>([&](auto &f) { times_numerator(ellipsoid, unit, at, f); }), square);
    for (int j = 0; j < 3; ++j)
        contact.point[j] = quotient(
            value_of_terms<T>([&](auto &f) { times_coordinate(ellipsoid, unit, at, j, f); }),
            divisor);
    return contact;
}

PW85_RARE_TIER_OF(polytope_overlaps_exactly, double)
PW85_RARE_TIER_OF(contact_polytope_exactly, double)

} // namespace pw85::detail

#endif
