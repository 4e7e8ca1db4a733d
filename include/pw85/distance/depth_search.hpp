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
/// Ellipsoids of revolution and concentric ellipsoids are not an exception.
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

/// Bounds of the squares of the shortest and of the longest semi-axis of an ellipsoid, where
/// rounding does not hide them within a factor of two.
template <class T> struct AxisBounds {
    T least, most; ///< `least` is zero where rounding hides it
    int unit;      ///< the squares are these numbers times 4^unit
};

/// The Frobenius norm.
template <class T, int D>
PW85_FUNCTION inline T frobenius_norm(SymmetricMatrix<T, D> const &a) noexcept
{
    T sum = T(0);
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) sum = sum + (i == j ? T(1) : T(2)) * (a(i, j) * a(i, j));
    return square_root(sum);
}

/// A⁻¹.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
inverse_by_factors(SymmetricMatrix<T, D> const &a) noexcept
{
    auto const factors = factorize(a, T(unit_roundoff<T>()));
    SymmetricMatrix<T, D> result{};
    for (int j = 0; j < D; ++j) {
        Vector<T, D> unit{};
        unit[j] = T(1);
        Vector<T, D> const column = solve(factors, unit);
        for (int i = 0; i <= j; ++i) result(i, j) = column[i];
    }
    return result;
}

/// The largest eigenvalue of a matrix is at most its Frobenius norm, and at least that over √D. So
/// are those of Q and of Q⁻¹. A column of Q⁻¹ is exact for a matrix that differs by less
/// than 32u trace Q.
template <class T, int D>
PW85_FUNCTION inline AxisBounds<T> axis_bounds(SymmetricMatrix<T, D> const &q) noexcept
{
    int const unit = half_exponent(largest_diagonal(q));
    auto const a = times_power_of_two(q, -2 * unit);
    T const rounding = T(32 * unit_roundoff<T>()) * trace(a);
    return {maximum(T(0), T(T(1) / frobenius_norm(inverse_by_factors(a)) - rounding)),
            frobenius_norm(a) + rounding, unit};
}

/// A range of c.
template <class T> struct RatioRange {
    T lower, upper;
};

/// The range of c = β/α over all directions. Where rounding hides the shortest semi-axis, its
/// square counts as u/16 of that of the longest one, which is below what the entries of the form
/// tell.
template <class T> PW85_FUNCTION inline RatioRange<T>
ratio_range(AxisBounds<T> const &axes1, AxisBounds<T> const &axes2) noexcept
{
    int const unit = axes2.unit - axes1.unit;
    T const floor = T(unit_roundoff<T>() / T(16));
    T const least1 = maximum(axes1.least, T(floor * axes1.most)),
            least2 = maximum(axes2.least, T(floor * axes2.most));
    return {times_power_of_two(square_root(T(least2 / axes1.most)), unit),
            times_power_of_two(square_root(T(axes2.most / least1)), unit)};
}

/// Start of a turn: a direction, the points of both surfaces with this normal, and the
/// shift.
template <class T, int D> struct DirectionState {
    Vector<T, D> n;
    Support<T, D> s1, s2;
    T length;
};

/// The point with the normal n. If it is to be accurate, it errs by less than 2^12 u of its
/// distance from the centre: in plain arithmetic by 3uX (support.hpp).
template <class T, int D> PW85_FUNCTION inline Support<T, D>
support_for_turn(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n, bool accurate) noexcept
{
    auto const plain = support(q, n);
    if (!accurate || trace(q) <= T(1024) * (plain.extent * plain.extent)) return plain;
    return support_from(accurate_product(q, n), n);
}

template <class T, int D> PW85_FUNCTION inline DirectionState<T, D>
state_along(DepthSearch<T, D> const &search, Vector<T, D> const &n, bool accurate) noexcept
{
    auto const s1 = support_for_turn(search.q1, n, accurate),
               s2 = support_for_turn(search.q2, n, accurate);
    return {n, s1, s2, s1.extent + s2.extent - dot(n, search.r12)};
}

/// A turn of the normal towards a minimum, which lies across n: Newton's step (curvature.hpp), or,
/// where the stiffness is not positive definite, the step with the curvatures alone.
template <class T, int D> struct NormalTurn {
    Vector<T, D> turn;
    bool newton;
};

template <class T, int D> PW85_FUNCTION inline NormalTurn<T, D>
normal_turn(DepthSearch<T, D> const &search, DirectionState<T, D> const &at) noexcept
{
    auto const &n = at.n;
    SurfaceElement<T, D> const elements[2] = {surface_element(search.q1, T(1), at.s1),
                                              surface_element(search.q2, T(1), at.s2)};
    Vector<T, D> const off = project(search.r12 - (at.s1.point + at.s2.point), n);
    auto const stiffness = stiffness_across(elements, T(-at.length), n);
    auto const factors = factorize(stiffness, T(0));
    if (is_isolated(stiffness, factors)) return {solve(factors, off), true};
    T const floor = T(unit_roundoff<T>());
    return {solve(factorize(stiffness_across(elements, T(0), n), floor), off), false};
}

/// The unit vector along n + factor·turn.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
turned(Vector<T, D> const &n, T const &factor, Vector<T, D> const &turn) noexcept
{
    return unit_along(add_scaled(n, factor, turn));
}

/// The numbers of turns, and of halves of one, that follow_normal() takes at most. Three whole ones
/// are usual.
inline constexpr int max_normal_turns = 32, max_turn_halves = 8;

/// The state after a turn, or after the longest part of it that does not lengthen the shift by more
/// than `slack`. `taken` is that part, or zero.
template <class T, int D> struct TakenTurn {
    DirectionState<T, D> at;
    T taken;
};

template <class T, int D> PW85_FUNCTION inline TakenTurn<T, D>
take_turn(DepthSearch<T, D> const &search, DirectionState<T, D> const &at, Vector<T, D> const &turn,
          bool accurate, T const &slack) noexcept
{
    T factor = T(1);
    for (int k = 0; k <= max_turn_halves; ++k) {
        auto const next = state_along(search, turned(at.n, factor, turn), accurate);
        if (next.length <= at.length + slack) return {next, factor};
        factor = T(0.5) * factor;
    }
    return {at, T(0)};
}

/// Follows turns from a direction to a local minimum. Returns false if they do not converge. The
/// best direction is kept.
///
/// A Newton's turn is about C times the square of the one before, so that C is known from two of
/// them. The direction is as good as its isolation permits when the next turn would be below u, or
/// after one below 2^-(digits + 16)/2, whose C may be rounding. The length then is correct up to
/// rounding. The last turns need accurate products: those after a
/// turn below 2^-7.
template <class T, int D>
PW85_FUNCTION inline bool follow_normal(DepthSearch<T, D> &search, Vector<T, D> const &n) noexcept
{
    T const u = T(unit_roundoff<T>()), limit = negative_power_of_two<T>(14),
            tiny = negative_power_of_two<T>(mantissa_digits<T>() + 16);
    T const slack = shift_along(n, search.r12, search.q1, search.q2).rounding;
    bool accurate = false, converged = false;
    T before = T(1); // the square of the last turn
    auto at = state_along(search, n, accurate);
    for (int i = 0; i < max_normal_turns && !converged; ++i) {
        auto const step = normal_turn(search, at);
        T const square = dot(step.turn, step.turn);
        bool const close = step.newton && square <= limit;
        auto const next = take_turn(search, at, step.turn, close, slack);
        if (!(next.taken > T(0))) break;
        // C² = square/before², and the square of the next turn is C² square²
        T const growth = maximum(T(1), T(square / (before * before)));
        converged = accurate && next.taken == T(1) &&
                    (square <= tiny || growth * (square * square) <= u * u);
        at = next.at;
        accurate = close;
        before = square;
    }
    Shift<T> const shift = shift_along(at.n, search.r12, search.q1, search.q2);
    if (shift.length <= search.best.length + search.best.rounding) {
        search.best = shift;
        search.direction = at.n;
    }
    return converged;
}

/// Finds the minimum next to the direction in which the ellipsoids touch if they are scaled. It is
/// nearly the best one if the depth is small.
template <class T, int D>
PW85_FUNCTION inline void descend_from_touching(DepthSearch<T, D> &search) noexcept
{
    if (largest_coordinate(search.r12) == T(0)) return;
    Maximum<T> const touching = maximize(pair_of(search.r12, search.q1, search.q2));
    auto const form = blend(touching.complement, search.q1, touching.lambda, search.q2);
    Vector<T, D> const n = solve(factorize(form, T(unit_roundoff<T>())), search.r12);
    if (!follow_normal(search, unit_along(n))) {
        descend(search, T(touching.complement / touching.lambda));
        follow_normal(search, search.direction);
    }
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
    follow_normal(search, search.direction);
}

} // namespace pw85::detail

#endif
