// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the depth of an overlap: a local minimum over one number, for penetration.hpp.
///
/// Let α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12. To separate from ellipsoid 1, ellipsoid 2 must
/// move by g(n) = α + β - n·r along the unit vector n. The depth is the smallest value of g, which
/// may have several local minima.
///
/// (α + β)² is the smallest value over c > 0 of nᵀWn, W(c) = (1 + c) Q1 + (1 + 1/c) Q2. It is
/// reached at c = β/α. So the depth is the smallest value over c of D(c), the depth of the point r
/// in the ellipsoid W(c). For each c, nearest.hpp finds D without a search, whatever the symmetry.
/// Ellipsoids of revolution and concentric ellipsoids are no exception.
#ifndef PW85_DISTANCE_DEPTH_SEARCH_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_SEARCH_HPP_INCLUDED

#include <pw85/contact/solver.hpp>
#include <pw85/distance/curvature.hpp>
#include <pw85/distance/nearest.hpp>

namespace pw85::detail {

/// The length by which ellipsoid 2 must move along n, its rounding error, and the ratio c of the
/// half-widths.
template <class T> struct Shift {
    T length, ratio, rounding;
};

template <class T, int D>
PW85_FUNCTION inline Shift<T> shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
                                          SymmetricMatrix<T, D> const &q1,
                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const weights = outer_weights(n);
    T const a = square_root(positive_form(q1, weights)),
            b = square_root(positive_form(q2, weights));
    T const sum = magnitude_of_dot(n, r12) + magnitude_of_form(q1, n) / (a + a) +
                  magnitude_of_form(q2, n) / (b + b);
    return {a + b - dot(n, r12), b / a, T(8 * unit_roundoff<T>()) * sum};
}

/// W(c) minus `deficit` Q2.
template <class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> enclosing_form(SymmetricMatrix<T, D> const &q1,
                                                             SymmetricMatrix<T, D> const &q2,
                                                             T const &c, T const &deficit) noexcept
{
    return blend(T(T(1) + c), q1, T(T(1) + (T(1) / c - deficit)), q2);
}

/// The search for the depth of a pair, with the best direction that it has found.
template <class T, int D> struct DepthSearch {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Vector<T, D> direction;
    Shift<T> best;
};

/// Computes the shift along a direction, and keeps the direction if it is the best one.
template <class T, int D> PW85_FUNCTION inline Shift<T>
try_direction(DepthSearch<T, D> &search, Vector<T, D> const &n) noexcept
{
    Shift<T> const shift = shift_along(n, search.r12, search.q1, search.q2);
    if (shift.length < search.best.length - search.best.rounding) {
        search.best = shift;
        search.direction = n;
    }
    return shift;
}

/// The fraction by which the ratio of the half-widths along the direction of D(c) exceeds c. The
/// slope of D has the opposite sign.
template <class T, int D>
PW85_FUNCTION inline T try_ratio(DepthSearch<T, D> &search, T const &c) noexcept
{
    auto const form = enclosing_form(search.q1, search.q2, c, T(0));
    return try_direction(search, extreme_normal(form, search.r12, true)).ratio / c - T(1);
}

/// Follows D to a local minimum. The next c is the ratio of the half-widths along the direction, or
/// the c at which the two agree by the secant. D is correct up to rounding if its slope is below
/// the root of the rounding error, after a few steps. A last step makes the direction correct, too.
/// This step is taken unless it lengthens the shift by more than rounding.
template <class T, int D> PW85_FUNCTION inline void descend(DepthSearch<T, D> &search, T c) noexcept
{
    T const threshold = negative_power_of_two<T>(mantissa_digits<T>() / 2 + 2);
    T excess = try_ratio(search, c), step = excess;
    for (int i = 0; i < 16 && absolute(excess) > threshold; ++i) {
        T const next = c * (T(1) + step), after = try_ratio(search, next);
        T const secant = step * after / (excess - after);
        bool const forward =
            secant * after > T(0) && absolute(secant) < T(8) * absolute(after) && secant > T(-0.5);
        step = forward ? secant : after;
        excess = after;
        c = next;
    }
    auto const form = enclosing_form(search.q1, search.q2, T(c * (T(1) + step)), T(0));
    Vector<T, D> const n = extreme_normal(form, search.r12, true);
    Shift<T> const last = shift_along(n, search.r12, search.q1, search.q2);
    if (!(last.length <= search.best.length + search.best.rounding)) return;
    search.best = last;
    search.direction = n;
}

/// Takes Newton's steps for the normal (curvature.hpp). The value at the minimum is correct up to
/// rounding when the direction has half of its digits; these steps make the direction as good as
/// its isolation permits. A step is taken if it does not lengthen the shift by more than rounding.
template <class T, int D>
PW85_FUNCTION inline void polish_direction(DepthSearch<T, D> &search) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    for (int i = 0; i < 2; ++i) {
        SurfaceElement<T, D> const elements[2] = {surface_element(q1, T(1), n),
                                                  surface_element(q2, T(1), n)};
        auto const stiffness = stiffness_across(elements, T(-best.length), n);
        auto const factors = factorize(stiffness, T(0));
        if (!is_isolated(stiffness, factors)) return;
        Vector<T, D> const points = support_from(accurate_product(q1, n), n).point +
                                    support_from(accurate_product(q2, n), n).point;
        Vector<T, D> const next = n + solve(factors, project(r12 - points, n));
        Vector<T, D> const unit = T(T(1) / square_root(dot(next, next))) * next;
        Shift<T> const shift = shift_along(unit, r12, q1, q2);
        if (!(shift.length <= best.length + best.rounding)) return;
        search.best = shift;
        search.direction = unit;
    }
}

/// The squares of the shortest and of the longest semi-axis of an ellipsoid, up to some u times the
/// latter.
template <class T> struct AxisSquares {
    T least, most;
    int unit; ///< the squares are these numbers times 4^unit
};

template <class T, int D>
PW85_FUNCTION inline AxisSquares<T> axis_squares(SymmetricMatrix<T, D> const &q) noexcept
{
    int const unit = half_exponent(largest_diagonal(q));
    auto const axes = principal_axes(times_power_of_two(q, -2 * unit));
    AxisSquares<T> squares{axes.squares[0], axes.squares[0], unit};
    for (int i = 1; i < D; ++i) {
        squares.least = minimum(squares.least, axes.squares[i]);
        squares.most = maximum(squares.most, axes.squares[i]);
    }
    return squares;
}

/// The range of c = β/α over all directions, extended by a factor of two at both ends for rounding.
template <class T> struct RatioRange {
    T lower, upper;
};

template <class T> PW85_FUNCTION inline RatioRange<T>
ratio_range(AxisSquares<T> const &axes1, AxisSquares<T> const &axes2) noexcept
{
    int const unit = axes2.unit - axes1.unit;
    return {times_power_of_two(T(T(0.5) * square_root(T(axes2.least / axes1.most))), unit),
            times_power_of_two(T(T(2) * square_root(T(axes2.most / axes1.least))), unit)};
}

/// Finds the minimum next to the direction in which the ellipsoids touch if they are scaled. It is
/// nearly the best one if the depth is small.
template <class T, int D>
PW85_FUNCTION inline void descend_from_touching(DepthSearch<T, D> &search) noexcept
{
    if (largest_coordinate(search.r12) == T(0)) return;
    Maximum<T> const touching = maximize(pair_of(search.r12, search.q1, search.q2));
    descend(search, T(touching.complement / touching.lambda));
    polish_direction(search);
}

/// Finds the best minimum of several. With more starts, the proof finds a better one less often.
template <class T, int D> PW85_FUNCTION inline void
descend_from_all(DepthSearch<T, D> &search, RatioRange<T> const &range) noexcept
{
    constexpr int starts = 8;
    T const factor = square_root(square_root(square_root(T(range.upper / range.lower))));
    T c = range.lower * square_root(factor);
    for (int i = 0; i < starts; ++i) {
        try_ratio(search, c);
        c = c * factor;
    }
    descend(search, search.best.ratio);
    polish_direction(search);
}

} // namespace pw85::detail

#endif
