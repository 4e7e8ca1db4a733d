// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tests whether a convex set, which is a segment, a triangle or a box, overlaps an ellipsoid with
/// its centre at 0. Floating-point numbers decide first, with margins for their rounding errors.
/// Integers decide the remaining cases (exact_shapes.hpp).
///
/// - They are apart or touch if s·y >= √(sᵀQs) for some s and every point y of the set. The normal
///   at the nearest point is tried.
/// - They overlap if Q - x xᵀ is positive definite for some point x of the set, because then xᵀQ⁻¹x
///   < 1. The nearest point is tried.
///
/// These proofs are valid even if the nearest point is not accurate. So edges are tried with the
/// first t of segment.hpp, and with the second t only if the first one decides nothing.
#ifndef PW85_SHAPES_OVERLAP_SHAPES_HPP_INCLUDED
#define PW85_SHAPES_OVERLAP_SHAPES_HPP_INCLUDED

#include <pw85/shapes/exact_shapes.hpp>
#include <pw85/shapes/triangle.hpp>

namespace pw85 {

/// True if an ellipsoid and a convex set overlap. It is false if the status is not success.
struct ShapeOverlap {
    bool overlap;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// A segment or a triangle: the hull of its ends or vertices.
template <class T, int N> struct Hull {
    Vector<T, 3> points[std::size_t(N)];

    PW85_MEMBER bool is_valid() const noexcept { return is_finite(points); }

    /// Returns the least s·y of the set.
    PW85_MEMBER T least_projection(Vector<T, 3> const &s) const noexcept
    {
        T least = dot(s, points[0]);
        for (int k = 1; k < N; ++k) least = minimum(least, dot(s, points[k]));
        return least;
    }

    /// Returns bounds on the magnitudes of the coordinates from which s·y and the nearest point are
    /// computed.
    PW85_MEMBER Vector<T, 3> magnitudes(Vector<T, 3> const &) const noexcept
    {
        Vector<T, 3> m{};
        for (int i = 0; i < 3; ++i) {
            m[i] = absolute(points[0][i]);
            for (int k = 1; k < N; ++k) m[i] = maximum(m[i], absolute(points[k][i]));
        }
        return m;
    }

    PW85_MEMBER Hull in_unit(Unit unit) const noexcept
    {
        Hull hull = *this;
        for (auto &x : hull.points) x = unit.to_local(x);
        return hull;
    }

    template <bool with_normal, bool refined = !with_normal>
    PW85_MEMBER Nearest<T, with_normal> nearest(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        if constexpr (N == 2)
            return FindOnSegment<with_normal, refined>{}(points, q);
        else
            return FindOnTriangle<with_normal, refined>{}(points, q);
    }

    PW85_MEMBER typename ScalarTraits<T>::Mask
    passes_checks(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return passes_fast_checks(points, q, unscaled_limit<T>());
    }

    [[gnu::always_inline]] bool overlaps_exactly(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return detail::overlaps_exactly(points, q);
    }
};

/// The nearest point of a box from the minimum in it.
template <bool with_normal, class T>
[[gnu::always_inline]] PW85_FUNCTION constexpr Nearest<T, with_normal>
nearest_at(BoxMinimum<T, 3> const &found, BoxProblem<T, 3> const &box) noexcept
{
    auto const certified = found.value == found.value;
    if constexpr (with_normal)
        return {found.value, found.point, {normal_at(found.point, box)}, certified};
    else
        return {found.value, found.point, {}, certified};
}

/// A solid box.
template <class T> struct SolidBox {
    Vector<T, 3> lower, upper;

    PW85_MEMBER bool is_valid() const noexcept { return is_box(lower, upper); }

    PW85_MEMBER T least_projection(Vector<T, 3> const &s) const noexcept
    {
        Vector<T, 3> y{};
        for (int i = 0; i < 3; ++i) y[i] = minimum(T(s[i] * lower[i]), T(s[i] * upper[i]));
        return sum_of(y);
    }

    /// Where s is not zero, the nearest point is on a face, and the least s·y is reached at that
    /// face if s is accurate.
    PW85_MEMBER Vector<T, 3> magnitudes(Vector<T, 3> const &s) const noexcept
    {
        Vector<T, 3> m{};
        for (int i = 0; i < 3; ++i)
            m[i] = absolute(select(T(s[i] * lower[i]) < T(s[i] * upper[i]), lower[i], upper[i]));
        return m;
    }

    PW85_MEMBER SolidBox in_unit(Unit unit) const noexcept
    {
        return {unit.to_local(lower), unit.to_local(upper)};
    }

    /// The point is always refined.
    template <bool with_normal, bool = true>
    PW85_MEMBER Nearest<T, with_normal> nearest(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        BoxProblem<T, 3> const box{lower, upper, {T(0), T(0), T(0)}, q};
        return nearest_at<with_normal>(minimum_in_box(box), box);
    }

    PW85_MEMBER typename ScalarTraits<T>::Mask
    passes_checks(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return passes_fast_checks(lower, upper, q);
    }

    [[gnu::always_inline]] bool overlaps_exactly(SymmetricMatrix<T, 3> const &q) const noexcept
    {
        return box_overlaps_exactly(lower, upper, q);
    }
};

/// Lower bound of the least xᵀQ⁻¹x of a set by a vector s of any length > 0: it is at least
/// least²/form if least > 0.
template <class T> struct Separation {
    T least; ///< no more than s·y for any point y of the set
    T form;  ///< no less than sᵀQs

    /// Returns whether the set does not overlap.
    PW85_MEMBER constexpr typename ScalarTraits<T>::Mask shows_apart() const noexcept
    {
        return least > T(0) && T(T(T(1) - T(8) * T(unit_roundoff<T>())) * least) * least > form;
    }
};

/// s·y errs by at most 3 u times the sum of the magnitudes of its terms, and sᵀQs by 6 u Σ|s_i Q_ij
/// s_j|, which is at most 18 u Σ s_i² Q_ii. The margins include the roundings of these bounds and
/// of the sum.
template <class T, class Shape> PW85_FUNCTION inline Separation<T>
separation(Shape const &shape, SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &s) noexcept
{
    T const u = T(unit_roundoff<T>());
    Vector<T, 3> const size = shape.magnitudes(s);
    T terms = T(0), form = T(0);
    for (int i = 0; i < 3; ++i) {
        terms = terms + absolute(T(s[i] * size[i]));
        form = form + T(s[i] * s[i]) * q(i, i);
    }
    return {T(shape.least_projection(s) - T(4) * u * terms),
            T(quadratic_form(q, s) + T(24) * u * form)};
}

/// Returns whether a point x that rounding moved by at most 16 u `size` from a point of the set
/// proves that the set overlaps.
///
/// Rounding errors of an entry of Q - x xᵀ are at most 36 u size_i size_j + 2 u √(Q_ii Q_jj). A
/// matrix of such errors is at most 3 times its diagonal, which the margins remove.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
shows_overlap(SymmetricMatrix<T, 3> k, Vector<T, 3> const &x, Vector<T, 3> const &size) noexcept
{
    T const u = T(unit_roundoff<T>());
    for (int i = 0; i < 3; ++i) {
        k(i, i) = T(T(1) - T(16) * u) * k(i, i) - T(T(128) * u * size[i]) * size[i];
        for (int j = i; j < 3; ++j) k(i, j) = k(i, j) - x[i] * x[j];
    }
    return is_clearly_definite(k);
}

/// Proofs by a point that is at least nearly the nearest one.
template <class T> struct ShapeCertainty {
    typename ScalarTraits<T>::Mask apart, overlap;
};

template <class T, class Shape>
PW85_FUNCTION inline ShapeCertainty<T> decide_at(Shape const &shape, SymmetricMatrix<T, 3> const &q,
                                                 Nearest<T, true> const &nearest) noexcept
{
    Vector<T, 3> const &s = nearest.normal.direction;
    auto const outside = nearest.mu2 >= T(1);
    ShapeCertainty<T> certainty{outside, !outside};
    if (any_of(certainty.apart))
        certainty.apart = certainty.apart && separation(shape, q, s).shows_apart();
    if (any_of(certainty.overlap)) {
        Vector<T, 3> size = shape.magnitudes(s);
        for (int i = 0; i < 3; ++i) size[i] = maximum(size[i], absolute(nearest.point[i]));
        certainty.overlap = certainty.overlap && shows_overlap(q, nearest.point, size);
    }
    return certainty;
}

/// The decision for one ellipsoid and set, by the refined or the first nearest point.
template <bool refined, class T, class Shape>
PW85_FUNCTION inline Decision decide(Shape const &shape, SymmetricMatrix<T, 3> const &q) noexcept
{
    if (!shape.passes_checks(q)) return Decision::none;
    auto const [apart, overlap] = decide_at(shape, q, shape.template nearest<true, refined>(q));
    return to_decision(apart, overlap);
}

/// The decision by floating-point numbers in the unit in which the largest diagonal entry of the
/// form is in [1, 4). Not inlined, so that its temporary numbers are not on the stack while
/// integers decide.
template <class T, class Shape> [[gnu::noinline]] PW85_FUNCTION inline Decision
decide_scaled(Shape const &shape, SymmetricMatrix<T, 3> const &q) noexcept
{
    Unit const unit = unit_of(q);
    return decide<true>(shape.in_unit(unit), unit.to_local(q));
}

/// Decides for any numbers. Types without integers take the sign of μ² - 1, up to rounding errors.
template <class T, class Shape> [[gnu::noinline]] PW85_FUNCTION inline ShapeOverlap
overlap_of_any(Shape const &shape, SymmetricMatrix<T, 3> const &q) noexcept
{
    StatusCode const status = shape.is_valid() ? validate(q) : StatusCode::invalid_argument;
    if (status != StatusCode::success) return {false, status};
    Decision const decision = decide_scaled(shape, q);
    if (decision != Decision::none) return {decision == Decision::overlap, status};
    if constexpr (exact::is_decidable<T>)
        return {shape.overlaps_exactly(q), status};
    else
        return {shape.template nearest<false>(q).mu2 < T(1), status};
}

PW85_SHARED_BY_QUESTIONS_OF(overlap_of_any, double, Hull<double, 2>)
PW85_SHARED_BY_QUESTIONS_OF(overlap_of_any, double, Hull<double, 3>)
PW85_SHARED_BY_QUESTIONS_OF(overlap_of_any, double, SolidBox<double>)

template <class T, class Shape> PW85_FUNCTION inline ShapeOverlap
overlap_of(Shape const &shape, SymmetricMatrix<T, 3> const &q) noexcept
{
    Decision const decision = decide<false>(shape, q);
    if (decision != Decision::none) return {decision == Decision::overlap, StatusCode::success};
    return overlap_of_any(shape, q);
}

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_segment(Vector<T, 3> const &end1,
                                                  Vector<T, 3> const &end2,
                                                  SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::overlap_of(detail::Hull<T, 2>{{end1, end2}}, q);
}

template <class T> PW85_FUNCTION inline ShapeOverlap
overlap_triangle(Vector<T, 3> const &vertex1, Vector<T, 3> const &vertex2,
                 Vector<T, 3> const &vertex3, SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::overlap_of(detail::Hull<T, 3>{{vertex1, vertex2, vertex3}}, q);
}

template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_box(Vector<T, 3> const &lower, Vector<T, 3> const &upper,
                                              SymmetricMatrix<T, 3> const &q) noexcept
{
    return detail::overlap_of(detail::SolidBox<T>{lower, upper}, q);
}

} // namespace pw85

#endif
