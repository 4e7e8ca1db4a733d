// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the depth of an overlap, for penetration.hpp: the search for a local minimum over
/// one number c, and the starts of the search for a local minimum over the normal
/// (depth_turns.hpp).
///
/// Let α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12. To separate from ellipsoid 1, ellipsoid 2 must
/// move by g(n) = α + β - n·r along the unit vector n. The depth is the smallest value of g, which
/// may have several local minima.
///
/// (α + β)² is the smallest value over c > 0 of nᵀWn, W(c) = (1 + c) Q1 + (1 + 1/c) Q2. It is
/// reached at c = β/α. So the depth is the smallest value over c of D(c), the depth of the point r
/// in the ellipsoid W(c). For each c, nearest.hpp finds the global D(c), also for ellipsoids of
/// revolution and concentric ellipsoids.
#ifndef PW85_DISTANCE_DEPTH_SEARCH_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_SEARCH_HPP_INCLUDED

#include <pw85/contact/solver.hpp>
#include <pw85/distance/depth_turns.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85::detail {

/// W(c) minus `deficit` Q2.
template <class T, int D>
PW85_FUNCTION constexpr SymmetricMatrix<T, D> enclosing_form(SymmetricMatrix<T, D> const &q1,
                                                             SymmetricMatrix<T, D> const &q2,
                                                             T const &c, T const &deficit) noexcept
{
    return blend(T(T(1) + c), q1, T(T(1) + (T(1) / c - deficit)), q2);
}

/// A multiple of a vector that is not zero, whose square does not underflow.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> with_square_in_range(Vector<T, D> const &x) noexcept
{
    T const largest = largest_coordinate(x);
    return largest > negative_power_of_two<T>(std::numeric_limits<T>::max_exponent / 8)
               ? x
               : x / largest;
}

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

/// Bounds of the squares of the shortest and of the longest semi-axis of an ellipsoid.
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

/// The range of c = β/α over all directions. If rounding errors are larger than the square of the
/// shortest semi-axis, u/16 times the square of the longest semi-axis replaces it, which is below
/// the rounding errors of the entries of the form.
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

/// The decision about a pair, and λ/(1 - λ) near the maximum of f, where the ellipsoids touch if
/// they are scaled.
template <class T> struct DepthStart {
    T t; ///< zero if it is not known, or if the pair is undecided and seems to be apart
    Decision decision;
};

/// t after one step of the search for the maximum of f.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline T
step_from(QuarticStart<T> const &start, Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
          SymmetricMatrix<T, D> const &q2) noexcept
{
    RationalSearch<T, FormOfSteps<T>> search{
        form_of_steps(start.quartic.form), {start.t, T(0), T(0)}, start.t == start.t};
    take_step(search, pair_of(r12, q1, q2));
    return search.candidate.t;
}

/// Returns whether f >= 1, up to rounding.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
seems_apart(QuarticEvaluation<T> const &value, T const &t) noexcept
{
    return t * value.a >= T(T(1) + t) * value.b;
}

/// Takes one step of the search for the maximum of f, with the quartic of the overlap test, which
/// also decides. More steps cost more than they save in turns of the normal. All callers
/// share one instance of this function: the same products are fused, and scaling changes no bit.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline DepthStart<T>
start_depth(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
            SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const start = start_by_quartic(r12, q1, q2);
    if (!start.passes) return {T(0), Decision::none};
    if (start.decision == Decision::apart) return {T(0), Decision::apart};
    T const t = step_from(start, r12, q1, q2);
    if (start.decision == Decision::overlap) return {t, Decision::overlap};
    auto const value = evaluate_quartic(start.quartic, t);
    auto const certainty = test_by_coefficients(value, t);
    return {seems_apart(value, t) ? T(0) : t, to_decision(certainty.apart, certainty.overlap)};
}

/// Returns t of start_depth(), or that of the maximum of f if the step has not found it. It does
/// not depend on the length of r12.
template <class T, int D>
PW85_FUNCTION inline T nearly_touching(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                       SymmetricMatrix<T, D> const &q2, T const &t) noexcept
{
    if (t > smallest_number<T>() && t < largest_number<T>()) return t;
    Maximum<T> const touching = maximize(pair_of(r12, q1, q2));
    return touching.lambda / touching.complement;
}

/// Finds the minimum next to the direction M⁻¹r, M = Q1 + tQ2, in which the ellipsoids touch if
/// they are scaled. It is nearly the best one if the depth is small.
template <class T, int D> PW85_FUNCTION inline FollowedNormal<T, D>
descend_from_touching(DepthSearch<T, D> &search, T const &start) noexcept
{
    if (largest_coordinate(search.r12) == T(0)) return {{}, false, false};
    Vector<T, D> const r = with_square_in_range(search.r12);
    T const t = nearly_touching(r, search.q1, search.q2, start);
    auto const form = blend(search.q1, t, search.q2);
    T const size = trace(form),
            limit = T(std::numeric_limits<T>::max_exponent >= 1024 ? 0x1p80 : 0x1p8);
    auto const adj = adjugate(size < limit ? form : T(T(1) / size) * form);
    auto const followed = follow_normal(search, product(adj, r));
    if (followed.converged || search.best.length < T(0)) return followed;
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
