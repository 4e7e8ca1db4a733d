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

#include <pw85/algebra/two_lanes.hpp>
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
    Unit unit;     ///< of the semi-axes
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
    Unit const unit = unit_of(q);
    auto const a = unit.to_local(q);
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
    Unit const unit = axes2.unit / axes1.unit;
    T const floor = T(unit_roundoff<T>() / T(16));
    T const least1 = maximum(axes1.least, T(floor * axes1.most)),
            least2 = maximum(axes2.least, T(floor * axes2.most));
    return {unit.to_caller(square_root(T(least2 / axes1.most))),
            unit.to_caller(square_root(T(axes2.most / least1)))};
}

/// Both ellipsoids along a direction, side by side. The direction is n/|n|: turns do not normalise
/// n, because Qn/α and g/|n| do not need it.
template <class T, int D> struct DirectionState {
    Vector<T, D> n;
    Vector<TwoLanes<T>, D> products;        ///< Qn
    TwoLanes<T> extents, inverses, factors; ///< α = √(nᵀQn), 1/α² and 1/α
    T shift, inverse_square;                ///< g(n) and 1/|n|²
    T length;                               ///< the shift along the unit vector, g/|n|
};

/// Qn of both ellipsoids. If they are to be accurate, the points Qn/α err by less than 2^12 u of
/// their distance from the centre: in plain arithmetic by 3uX (support.hpp).
template <class T, int D>
PW85_FUNCTION inline Vector<TwoLanes<T>, D> both_products(SymmetricMatrix<TwoLanes<T>, D> const &q,
                                                          Vector<T, D> const &n,
                                                          bool accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n);
    auto const plain = product(q, along);
    auto const most = TwoLanes<T>(T(1024)) * dot(along, plain);
    if (!accurate || all_of(TwoLanes<T>(trace(q) * dot(along, along)) < most)) return plain;
    return accurate_product(q, along);
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline DirectionState<T, D>
state_along(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
            Vector<T, D> const &n, bool accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n), products = both_products(q, n, accurate);
    auto const forms = positive_form(q, along, products), extents = square_root(forms),
               inverses = TwoLanes<T>(T(1)) / forms, factors = inverses * extents;
    T const shift = sum_of_lanes(extents) - dot(n, r12), inverse_square = T(1) / dot(n, n);
    return {n,       products, extents,        inverses,
            factors, shift,    inverse_square, shift * square_root(inverse_square)};
}

/// r - p1 - p2. At a minimum it is along n.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
off_surface(DirectionState<T, D> const &at, Vector<T, D> const &r12) noexcept
{
    Vector<T, D> off = r12;
    for (int i = 0; i < D; ++i)
        off[i] = off[i] - sum_of_lanes(TwoLanes<T>(at.factors * at.products[i]));
    return off;
}

/// (A1 + A2)/|n| (curvature.hpp), which is zero along n.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
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

template <class T> PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 3> const &a, DirectionState<T, 3> const &at) noexcept
{
    return {trace(a) - quadratic_form(a, at.n) * at.inverse_square,
            quadratic_form(adjugate(a), at.n) * at.inverse_square};
}

template <class T> PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 2> const &a, DirectionState<T, 2> const &at) noexcept
{
    return {T(1), trace(a) - quadratic_form(a, at.n) * at.inverse_square};
}

/// Returns whether the least eigenvalue across n is proved to exceed `floor`.
template <class T>
PW85_FUNCTION inline bool exceeds(MinorsAcross<T> const &minors, T const &floor) noexcept
{
    return minors.trace > T(0) && minors.determinant > floor * minors.trace;
}

/// The solution x across n of Ax = b across n, times the determinant of MinorsAcross. A turn by a
/// right angle about n makes the adjugate of two dimensions.
template <class T> PW85_FUNCTION inline Vector<T, 3> solve_across(SymmetricMatrix<T, 3> const &a,
                                                                  DirectionState<T, 3> const &at,
                                                                  Vector<T, 3> const &b) noexcept
{
    return cross(product(a, at.inverse_square * cross(at.n, b)), at.n);
}

template <class T> PW85_FUNCTION inline Vector<T, 2> solve_across(SymmetricMatrix<T, 2> const &,
                                                                  DirectionState<T, 2> const &at,
                                                                  Vector<T, 2> const &b) noexcept
{
    T const along = at.inverse_square * cross(at.n, b)[0];
    return {-at.n[1] * along, at.n[0] * along};
}

/// A turn of the normal towards a minimum, which lies across n: Newton's step (curvature.hpp), or,
/// where the stiffness A1 + A2 - g I is not positive definite, the step with the curvatures alone.
/// It is to be added to n.
template <class T, int D> struct NormalTurn {
    Vector<T, D> turn;
    bool newton;
};

/// Newton's step is taken where the direction is isolated with half of the digits to spare. If
/// rounding hides the lesser curvature, the turn is along the force.
template <class T, int D>
PW85_FUNCTION inline NormalTurn<T, D> normal_turn(SymmetricMatrix<TwoLanes<T>, D> const &q,
                                                  Vector<T, D> const &r12,
                                                  DirectionState<T, D> const &at) noexcept
{
    Vector<T, D> const off = off_surface(at, r12);
    auto const turn = turn_of_sum(q, at),
               stiffness = plus_multiple_of_identity(turn, T(-at.shift * at.inverse_square));
    T const size = trace(turn);
    auto const minors = minors_across(stiffness, at);
    if (exceeds(minors, T(negative_power_of_two<T>(mantissa_digits<T>() / 2) * size)))
        return {T(T(1) / minors.determinant) * solve_across(stiffness, at, off), true};
    auto const curved = minors_across(turn, at);
    if (exceeds(curved, T(T(unit_roundoff<T>()) * size)))
        return {T(T(1) / curved.determinant) * solve_across(turn, at, off), false};
    return {T(T(1) / size) * (off - (dot(at.n, off) * at.inverse_square) * at.n), false};
}

/// The numbers of turns, and of halves of one, that follow_normal() takes at most. Three whole ones
/// are usual.
inline constexpr int max_normal_turns = 32, max_turn_halves = 8;

/// n + factor·turn, normalised after a turn by more than half a right angle.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
turned(Vector<T, D> const &n, T const &factor, Vector<T, D> const &turn, bool is_large) noexcept
{
    Vector<T, D> const next = add_scaled(n, factor, turn);
    return is_large ? unit_along(next) : next;
}

/// The state after a turn, or after the longest part of it that does not lengthen the shift by more
/// than `slack`. `taken` is that part, or zero.
template <class T, int D> struct TakenTurn {
    DirectionState<T, D> at;
    T taken;
};

template <class T, int D> PW85_FUNCTION inline TakenTurn<T, D>
take_turn(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
          DirectionState<T, D> const &at, Vector<T, D> const &turn, bool accurate, bool is_large,
          T const &slack) noexcept
{
    T factor = T(1);
    for (int k = 0; k <= max_turn_halves; ++k) {
        auto const next = state_along(q, r12, turned(at.n, factor, turn, is_large), accurate);
        if (next.length <= at.length + slack) return {next, factor};
        factor = T(0.5) * factor;
    }
    return {at, T(0)};
}

/// The end of a path along turns. `found` is true if the turns have converged to the best direction
/// of the search.
template <class T, int D> struct FollowedNormal {
    DirectionState<T, D> at;
    bool converged, found;
};

/// Follows turns from a unit vector to a local minimum. The best direction is kept.
///
/// A Newton's turn is about C times the square of the one before; two of them give C. The direction
/// is as good as its isolation permits when the next turn would be below u, or after one below
/// 2^-(digits + 16)/2, whose C may be rounding. The length then is correct up to rounding. The last
/// turns need accurate products: those after a turn below 2^-7.
template <class T, int D> PW85_FUNCTION inline FollowedNormal<T, D>
follow_normal(DepthSearch<T, D> &search, Vector<T, D> const &n) noexcept
{
    T const u = T(unit_roundoff<T>()), limit = negative_power_of_two<T>(14),
            tiny = negative_power_of_two<T>(mantissa_digits<T>() + 16);
    auto const q = side_by_side(search.q1, search.q2);
    bool accurate = false, converged = false;
    T before = T(1); // the square of the last turn
    auto at = state_along(q, search.r12, n, accurate);
    T const slack =
        T(8) * u *
        (sum_of_magnitudes(search.r12) + sum_of_lanes(TwoLanes<T>(trace(q) * at.factors)));
    for (int i = 0; i < max_normal_turns && !converged; ++i) {
        auto const step = normal_turn(q, search.r12, at);
        T const square = dot(step.turn, step.turn) * at.inverse_square;
        bool const close = step.newton && square <= limit;
        auto const next = take_turn(q, search.r12, at, step.turn, close, square > T(1), slack);
        if (!(next.taken > T(0))) break;
        // C² = square/before², and the square of the next turn is C² square²
        converged = accurate && close && next.taken == T(1) &&
                    (square <= tiny || maximum(T(before * before), square) * (square * square) <=
                                           u * u * (before * before));
        at = next.at;
        accurate = close;
        before = square;
    }
    Vector<T, D> const direction = unit_along(at.n);
    Shift<T> const shift = shift_along(direction, search.r12, search.q1, search.q2);
    bool const best = shift.length <= search.best.length + search.best.rounding;
    if (best) {
        search.best = shift;
        search.direction = direction;
    }
    return {at, converged, converged && best};
}

/// λ/(1 - λ) near the maximum of f, where the ellipsoids touch if they are scaled: one step of the
/// search for it. More steps cost more than they save in turns of the normal.
template <class T, int D>
PW85_FUNCTION inline T nearly_touching(DepthSearch<T, D> const &search) noexcept
{
    auto const pair = pair_of(search.r12, search.q1, search.q2);
    auto start = start_on_rational_form(pair);
    if (start.accurate) take_step(start.search, pair);
    T const t = start.search.candidate.t;
    if (t > smallest_number<T>() && t < largest_number<T>()) return t;
    Maximum<T> const touching = maximize(pair);
    return touching.lambda / touching.complement;
}

/// Finds the minimum next to the direction M⁻¹r, M = Q1 + tQ2, in which the ellipsoids touch if
/// they are scaled. It is nearly the best one if the depth is small.
template <class T, int D>
PW85_FUNCTION inline FollowedNormal<T, D> descend_from_touching(DepthSearch<T, D> &search) noexcept
{
    if (largest_coordinate(search.r12) == T(0)) return {{}, false, false};
    T const t = nearly_touching(search);
    auto const form = blend(search.q1, t, search.q2);
    auto const adj = adjugate(T(T(1) / trace(form)) * form);
    auto const followed = follow_normal(search, unit_along(product(adj, search.r12)));
    if (followed.converged) return followed;
    descend(search, T(T(1) / t));
    return follow_normal(search, search.direction);
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
