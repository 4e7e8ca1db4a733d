// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One turn of a normal towards a local minimum of the length by which ellipsoid 2 must move along
/// it, from both ellipsoids along the normal: Newton's step across it (curvature.hpp).
/// depth_turns.hpp calls normal_turn(); depth_search.hpp has the notation.
#ifndef PW85_DISTANCE_NORMAL_TURN_HPP_INCLUDED
#define PW85_DISTANCE_NORMAL_TURN_HPP_INCLUDED

#include <pw85/algebra/two_lanes.hpp>
#include <pw85/distance/curvature.hpp>

namespace pw85::detail {

/// The roots of both numbers, by one instruction where there is one.
template <class T> PW85_FUNCTION inline TwoLanes<T> roots(TwoLanes<T> const &x) noexcept
{
    return square_root(x);
}
#if defined(__SSE2__) && !defined(__CUDA__) && !defined(__CUDACC__)
PW85_FUNCTION inline TwoLanes<double> roots(TwoLanes<double> const &x) noexcept
{
    return __builtin_ia32_sqrtpd(x.lanes);
}
#endif

/// The length by which ellipsoid 2 must move along n, its rounding error, and the ratio c of the
/// half-widths.
template <class T> struct Shift {
    T length, ratio, rounding;
};

/// From both forms side by side.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Shift<T>
shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
            SymmetricMatrix<TwoLanes<T>, D> const &q) noexcept
{
    auto const along = converted<TwoLanes<T>>(n);
    auto const weights = outer_weights(along);
    auto const extents = roots(positive_form(q, weights)), twice = extents + extents;
    T const a = first_of(extents), b = second_of(extents);
    T const sum =
        magnitude_of_dot(n, r12) + sum_of_lanes(TwoLanes<T>(magnitude_of_form(q, along) / twice));
    return {a + b - dot(n, r12), b / a, T(8 * unit_roundoff<T>()) * sum};
}

template <class T, int D>
PW85_FUNCTION inline Shift<T> shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
                                          SymmetricMatrix<T, D> const &q1,
                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    return shift_along(n, r12, side_by_side(q1, q2));
}

/// The search for the depth of a pair, with the best direction that it has found.
template <class T, int D> struct DepthSearch {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Vector<T, D> direction;
    Shift<T> best;
};

/// Both ellipsoids along a direction, side by side. The direction is n/|n|: turns do not normalise
/// n, because Qn/α and g/|n| do not need it.
template <class T, int D> struct DirectionState {
    Vector<T, D> n;
    Vector<TwoLanes<T>, D> products;        ///< Qn
    TwoLanes<T> extents, inverses, factors; ///< α = √(nᵀQn), 1/α² and 1/α
    T shift, inverse_square, scale;         ///< g(n), 1/|n|² and 1/|n|
    T length;                               ///< the shift along the unit vector, g/|n|
};

/// Those of two vectors or numbers that a mask chooses, in each lane.
template <class Mask, class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
selected(Mask const &mask, Vector<T, D> const &yes, Vector<T, D> const &no) noexcept
{
    Vector<T, D> x{};
    for (int i = 0; i < D; ++i) x[i] = select(mask, yes[i], no[i]);
    return x;
}

template <class Mask, class T> [[gnu::always_inline]] PW85_FUNCTION inline TwoLanes<T>
selected(Mask const &mask, TwoLanes<T> const &yes, TwoLanes<T> const &no) noexcept
{
    return {select(mask, first_of(yes), first_of(no)), select(mask, second_of(yes), second_of(no))};
}

template <class Mask, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Vector<TwoLanes<T>, D>
selected(Mask const &mask, Vector<TwoLanes<T>, D> const &yes,
         Vector<TwoLanes<T>, D> const &no) noexcept
{
    Vector<TwoLanes<T>, D> x{};
    for (int i = 0; i < D; ++i) x[i] = selected(mask, yes[i], no[i]);
    return x;
}

/// Qn of both ellipsoids. If they are to be accurate, the points Qn/α err by less than 2^12 u of
/// their distance from the centre: in plain arithmetic by 3uX (support.hpp).
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<TwoLanes<T>, D>
both_products(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &n,
              typename ScalarTraits<T>::Mask accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n);
    auto const plain = product(q, along);
    auto const most = TwoLanes<T>(T(1024)) * dot(along, plain);
    auto const is_plain = both_of(TwoLanes<T>(trace(q) * dot(along, along)) < most) || !accurate;
    if (all_of(is_plain)) return plain;
    auto const exact = accurate_product(q, along);
    return any_of(is_plain) ? selected(is_plain, plain, exact) : exact;
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline DirectionState<T, D>
state_along(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
            Vector<T, D> const &n, typename ScalarTraits<T>::Mask accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n), products = both_products(q, n, accurate);
    auto const forms = positive_form(q, along, products), extents = roots(forms),
               inverses = TwoLanes<T>(T(1)) / forms, factors = inverses * extents;
    T const shift = sum_of_lanes(extents) - dot(n, r12), inverse_square = T(1) / dot(n, n),
            scale = square_root(inverse_square);
    return {n, products, extents, inverses, factors, shift, inverse_square, scale, shift * scale};
}

/// r - p1 - p2. At a minimum it is along n.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
off_surface(DirectionState<T, D> const &at, Vector<T, D> const &r12) noexcept
{
    Vector<T, D> off = r12;
    for (int i = 0; i < D; ++i)
        off[i] = off[i] - sum_of_lanes(TwoLanes<T>(at.factors * at.products[i]));
    return off;
}

/// (A1 + A2)/|n| (curvature.hpp), which is zero along n.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, D>
turn_of_sum(SymmetricMatrix<TwoLanes<T>, D> const &q, DirectionState<T, D> const &at) noexcept
{
    SymmetricMatrix<T, D> a{};
    for (int i = 0; i < D; ++i) {
        auto const row = at.inverses * at.products[i];
        for (int j = i; j < D; ++j)
            a(i, j) = sum_of_lanes(TwoLanes<T>(at.factors * (q(i, j) - row * at.products[j])));
    }
    return a;
}

/// A symmetric matrix across n: its trace and its determinant in three dimensions, one and its
/// entry in two. The least eigenvalue across n, if it is positive, is at least their ratio.
template <class T> struct MinorsAcross {
    T trace, determinant;
};

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 3> const &a, DirectionState<T, 3> const &at) noexcept
{
    auto const weights = at.inverse_square * outer_weights(at.n);
    return {trace(a) - quadratic_form(a, weights), quadratic_form(adjugate(a), weights)};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 2> const &a, DirectionState<T, 2> const &at) noexcept
{
    return {T(1), trace(a) - quadratic_form(a, at.n) * at.inverse_square};
}

/// Returns whether the least eigenvalue across n is proved to exceed `floor`.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
exceeds(MinorsAcross<T> const &minors, T const &floor) noexcept
{
    return minors.trace > T(0) && minors.determinant > floor * minors.trace;
}

/// The inverse of A across n, times the determinant of MinorsAcross: [n]A[n]ᵀ/|n|² with the matrix
/// [n] of the cross product. In two dimensions [n] is a turn by a right angle, and A is left out.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, 3>
inverse_across(SymmetricMatrix<T, 3> const &a, DirectionState<T, 3> const &at) noexcept
{
    auto const &n = at.n;
    Vector<T, 3> const m{at.inverse_square * n[0], at.inverse_square * n[1],
                         at.inverse_square * n[2]};
    // the columns of [n]A
    Vector<T, 3> const x{n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2],
                         n[0] * a[1] - n[1] * a[0]},
        y{n[1] * a[4] - n[2] * a[3], n[2] * a[1] - n[0] * a[4], n[0] * a[3] - n[1] * a[1]},
        z{n[1] * a[5] - n[2] * a[4], n[2] * a[2] - n[0] * a[5], n[0] * a[4] - n[1] * a[2]};
    return {m[1] * z[0] - m[2] * y[0], m[2] * x[0] - m[0] * z[0], m[0] * y[0] - m[1] * x[0],
            m[2] * x[1] - m[0] * z[1], m[0] * y[1] - m[1] * x[1], m[0] * y[2] - m[1] * x[2]};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, 2>
inverse_across(SymmetricMatrix<T, 2> const &, DirectionState<T, 2> const &at) noexcept
{
    T const x = at.inverse_square * at.n[0], y = at.inverse_square * at.n[1];
    return {y * at.n[1], T(-x * at.n[1]), x * at.n[0]};
}

/// Ab, with the sums written out, which keeps the numbers in registers.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 3>
product_of(SymmetricMatrix<T, 3> const &a, Vector<T, 3> const &b) noexcept
{
    return {a[0] * b[0] + a[1] * b[1] + a[2] * b[2], a[1] * b[0] + a[3] * b[1] + a[4] * b[2],
            a[2] * b[0] + a[4] * b[1] + a[5] * b[2]};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 2>
product_of(SymmetricMatrix<T, 2> const &a, Vector<T, 2> const &b) noexcept
{
    return {a[0] * b[0] + a[1] * b[1], a[1] * b[0] + a[2] * b[1]};
}

/// The turn that the curvatures alone give, from A1 + A2, its trace, and r - p1 - p2. If rounding
/// hides the lesser curvature, the turn is along the force.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
turn_by_curvatures(SymmetricMatrix<T, D> const &turn, T const &size, Vector<T, D> const &off,
                   DirectionState<T, D> const &at) noexcept
{
    auto const curved = minors_across(turn, at);
    auto const definite = exceeds(curved, T(T(unit_roundoff<T>()) * size));
    Vector<T, D> along_force{}, step{};
    if (!all_of(definite))
        along_force = T(T(1) / size) * (off - T(dot(at.n, off) * at.inverse_square) * at.n);
    if (!any_of(definite)) return along_force;
    step = T(T(1) / curved.determinant) * product_of(inverse_across(turn, at), off);
    return selected(definite, step, along_force);
}

/// A turn of the normal towards a minimum, which lies across n: Newton's step (curvature.hpp), or,
/// where the stiffness A1 + A2 - g I is not positive definite, the step with the curvatures alone.
/// It is to be added to n. Returns whether it is Newton's step; `inverse` then is that of the
/// stiffness. A structure of results would pass through memory.
///
/// Newton's step is taken where the direction is isolated with half of the digits to spare.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
normal_turn(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
            DirectionState<T, D> const &at, Vector<T, D> &step,
            SymmetricMatrix<T, D> &inverse) noexcept
{
    Vector<T, D> const off = off_surface(at, r12);
    auto const turn = turn_of_sum(q, at),
               stiffness = plus_multiple_of_identity(turn, T(-at.shift * at.inverse_square));
    T const size = trace(turn);
    auto const minors = minors_across(stiffness, at);
    auto const newton =
        exceeds(minors, T(negative_power_of_two<T>(mantissa_digits<T>() / 2) * size));
    if (any_of(newton)) {
        auto const adj = inverse_across(stiffness, at);
        Vector<T, D> const along = product_of(adj, off); // while the processor divides
        T const reciprocal = T(1) / minors.determinant;
        step = reciprocal * along;
        inverse = reciprocal * adj;
        if (all_of(newton)) return newton;
    }
    Vector<T, D> const other = turn_by_curvatures(turn, size, off, at);
    step = any_of(newton) ? selected(newton, step, other) : other;
    return newton;
}

} // namespace pw85::detail

#endif
