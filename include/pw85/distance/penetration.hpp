// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The depth of an overlap: the shortest translation that separates two ellipsoids.
/// src/pair/distance.cpp calls penetration_overlapping(), which calls extreme_normal() for the
/// depth of a point in an ellipsoid, and support().
///
/// Let α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12. To separate from ellipsoid 1, ellipsoid 2 must
/// move by g(n) = α + β - n·r along the unit vector n. The depth is the smallest value of g, which
/// may have several local minima. A search over one number proves that one of them is the global
/// minimum:
///
/// 1. (α + β)² is the smallest value over c > 0 of nᵀWn, W(c) = (1 + c) Q1 + (1 + 1/c) Q2. It is
///    reached at c = β/α. So the depth is the smallest value over c of D(c), the depth of the point
///    r in the ellipsoid W(c). For each c, nearest.hpp finds D without a search, whatever the
///    symmetry. Ellipsoids of revolution and concentric ellipsoids are no exception.
/// 2. For c from c0/ρ to c0ρ, 1/c is at least 2/c0 - c/c0². If this bound replaces 1/c, W is affine
///    in c. Then for each n the root of nᵀWn is concave in c, and smallest at an end of the
///    interval. So D(c) is at least the smaller depth of r in W(c0/ρ) - δQ2 and W(c0ρ) - δQ2, δ =
///    (ρ - 1)²/(ρc0).
/// 3. The bound of item 2 is off by O(log²ρ). So the intervals that can be proved shrink towards a
///    minimum, in proportion to their distance from it.
/// 4. Around the best minimum (n, c0), c0 = β/α, another proof takes over. With x = (m; 1) for unit
///    vectors m, mᵀWm - (m·r + d)² is xᵀGx, where G(c) = diag(W - σI, σ) - (r; d)(r; d)ᵀ for any
///    number σ. So D(c) >= d if G is positive semidefinite for some σ. Here σ = dℓ + (c - c0) σ1 +
///    (1/c - 1/c0) σ2, with ℓ = m·r + d at m = n. The basis consists of v = (n; 1), of (t_i; 0)
///    with the tangents t_i, and of (n; -1). In this basis the entry vᵀGv is (ℓ' - ℓ)(ℓ' + ℓ) +
///    α²(c - c0)²/c with ℓ' = α + β, and the rest of its row is h + (c - c0) k. At a minimum with d
///    = ℓ' - n·r, ℓ' = ℓ and h = 0. H is G without the first row and column. So G is semidefinite
///    where K = (α²/c, kᵀ; k, H) is.
/// 5. K is affine in c and y = 1/c. So K is semidefinite on an interval if it is semidefinite at
///    three points (c, y): at both ends, and where the tangents of the hyperbola y = 1/c at the
///    ends meet. The arc is in the triangle of these three points.
/// 6. A shallow depth needs no proof over c. An ellipsoid with the longest semi-axis a and the
///    shortest one b is a union of balls of the radius b²/a, its least radius of curvature
///    (Blaschke's rolling theorem). So the sum of the ellipsoids is a union of balls of the radius
///    R = R1 + R2. Let P = p1 + p2 be its boundary point with the normal n, r = P - d n + w with w
///    across n, and d < R. The ball of radius R that touches the boundary at P is in the sum. So no
///    direction needs less than the depth of r in this ball, R - |(R - d)n + w| >= d - |w|²/(2(R -
///    d)).
#ifndef PW85_DISTANCE_PENETRATION_HPP_INCLUDED
#define PW85_DISTANCE_PENETRATION_HPP_INCLUDED

#include <pw85/distance/curvature.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids. If they are apart, the
/// depth is zero and the direction is NaN.
template <class T, int D> struct Penetration {
    T depth;
    Vector<T, D> direction; ///< unit vector
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> no_penetration(StatusCode status) noexcept
{
    auto result = all_nan<Penetration<T, D>>(status);
    if (status == StatusCode::success) result.depth = T(0);
    return result;
}

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
/// This step is taken unless it lengthens the shift by more than rounding. Items 2 to 5 show that
/// the minimum is the global one.
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

/// A lower bound of the radii of curvature of an ellipsoid (item 6); zero if rounding hides them.
template <class T> PW85_FUNCTION inline T least_radius(AxisSquares<T> const &axes) noexcept
{
    T const rounding = T(64 * unit_roundoff<T>()) * axes.most;
    return times_power_of_two(
        T(maximum(T(0), T(axes.least - rounding)) / square_root(T(axes.most + rounding))),
        axes.unit);
}

/// Whether item 6 proves the best depth to its rounding error, for the least radius of curvature
/// `radius` of the sum. Half of the radius is left for R - d. The points are computed by
/// accurate_product(), so that they err by less than (3 + 2√X)u times the longest semi-axis
/// (support.hpp); the factor of 8 covers the sum and the projection.
template <class T, int D>
PW85_FUNCTION inline bool is_shallow(DepthSearch<T, D> const &search, T const &radius) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    if (!(T(2) * best.length <= radius)) return false;
    auto const s1 = support_from(accurate_product(q1, n), n),
               s2 = support_from(accurate_product(q2, n), n);
    T const size1 = square_root(trace(q1)), size2 = square_root(trace(q2));
    T const x1 = size1 / s1.extent, x2 = size2 / s2.extent; // the roots of X
    if (!(maximum(T(x1 * x1), T(x2 * x2)) <= largest_spread<T>())) return false;
    T const size = sum_of_magnitudes(r12) + size1 * (T(1) + x1) + size2 * (T(1) + x2);
    Vector<T, D> const off = project(r12 - (s1.point + s2.point), n);
    T const across = square_root(dot(off, off)) + T(8 * unit_roundoff<T>()) * size;
    return across * across <= radius * best.rounding;
}

/// Whether item 2 shows that D is not below the smallest value found, for c from `c` to ρ²c. The
/// directions that this computes are tried as well.
template <class T, int D>
PW85_FUNCTION inline bool none_deeper(DepthSearch<T, D> &search, T const &c, T const &rho) noexcept
{
    T const middle = rho * c, deficit = (rho - T(1)) * (rho - T(1)) / (rho * middle),
            level = search.best.length;
    for (int end = 0; end < 2; ++end) {
        auto const form =
            enclosing_form(search.q1, search.q2, end == 0 ? c : T(rho * middle), deficit);
        Vector<T, D> const n = extreme_normal(form, search.r12, true);
        Shift<T> const found = try_direction(search, n);
        if (search.best.length < level - T(2) * search.best.rounding) descend(search, found.ratio);
        T const depth = support(form, n).extent - dot(n, search.r12);
        if (!(depth >= search.best.length - T(2) * maximum(search.best.rounding, found.rounding)))
            return false;
    }
    return true;
}

/// The largest number of intervals that the proof takes. A few hundred are usual.
inline constexpr int max_depth_intervals = 20000;

/// Proves the depth for a range of c by intervals that are as long as possible. Returns false if
/// there are too many. An interval that is shorter than the root of u counts as proved, because
/// what it leaves open is below rounding.
template <class T, int D> PW85_FUNCTION inline bool prove_depth(DepthSearch<T, D> &search,
                                                                RatioRange<T> const &range) noexcept
{
    T const shortest = negative_power_of_two<T>(mantissa_digits<T>() / 2), longest = T(1);
    T c = range.lower, width = T(0.5);
    for (int i = 0; i < max_depth_intervals && c < range.upper; ++i) {
        T const end = minimum(range.upper, T((T(1) + width) * (T(1) + width) * c));
        if (none_deeper(search, c, square_root(T(end / c))) || width <= shortest) {
            c = end;
            width = minimum(longest, T(width + width));
        } else
            width = T(0.5) * width;
    }
    return !(c < range.upper);
}

/// A square matrix of which only the lower triangle is used.
template <class T, int N> struct LowerTriangle {
    T entries[std::size_t(N)][std::size_t(N)];
};

/// Replaces a symmetric matrix by its factor L, a = LLᵀ. Returns false if the matrix is not
/// positive definite.
template <class T, int N>
PW85_FUNCTION inline bool factorize_in_place(LowerTriangle<T, N> &a) noexcept
{
    for (int j = 0; j < N; ++j) {
        for (int k = 0; k < j; ++k)
            for (int i = j; i < N; ++i)
                a.entries[i][j] = a.entries[i][j] - a.entries[i][k] * a.entries[j][k];
        T const pivot = a.entries[j][j];
        if (!(pivot > T(0))) return false;
        T const factor = T(1) / square_root(pivot);
        for (int i = j; i < N; ++i) a.entries[i][j] = factor * a.entries[i][j];
    }
    return true;
}

/// K of item 4 as K0 + c K1 + y K2, with the margins of its diagonal for rounding errors and for h.
template <class T, int D> struct MinimumProof {
    T ratio; ///< c0
    struct {
        LowerTriangle<T, D + 1> constant, by_c, by_y;
    } entries;
    /// reserved on the diagonal of H: margin + c margin_c + y margin_y
    T margin, margin_c, margin_y;
    bool valid;
};

/// Computes the directions orthogonal to the unit vector n: the columns of the reflection that
/// exchanges n and a unit vector of the axes.
template <class T, int D> PW85_FUNCTION inline void
fill_tangents(Vector<T, D> const &n, Vector<T, D> (&tangents)[std::size_t(D - 1)]) noexcept
{
    int pole = 0;
    for (int i = 1; i < D; ++i)
        if (absolute(n[i]) > absolute(n[pole])) pole = i;
    Vector<T, D> v = n;
    v[pole] = v[pole] + (n[pole] < T(0) ? T(-1) : T(1));
    for (int i = 0, j = 0; j < D; ++j) {
        if (j == pole) continue;
        tangents[i] = (-n[j] / (T(1) + absolute(n[pole]))) * v;
        tangents[i][j] = tangents[i][j] + T(1);
        ++i;
    }
}

/// Solves Ly = x in place, for the first N - 1 rows of a factor.
template <class T, int N> PW85_FUNCTION inline void
solve_forward(LowerTriangle<T, N> const &factor, T (&x)[std::size_t(N - 1)]) noexcept
{
    for (int i = 0; i < N - 1; ++i) {
        for (int k = 0; k < i; ++k) x[i] = x[i] - factor.entries[i][k] * x[k];
        x[i] = x[i] / factor.entries[i][i];
    }
}

/// Computes the entries of K that do not depend on σ. The tangents come first, then (n; -1), then
/// the row of α²/c. `d` is the depth to be proved.
template <class T, int D> PW85_FUNCTION inline void
fill_entries(MinimumProof<T, D> &proof, DepthSearch<T, D> const &search, T const &d) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    Vector<T, D> const p = product(q1, n), q = product(q2, n);
    Vector<T, D> tangents[std::size_t(D - 1)];
    fill_tangents(n, tangents);
    T const a2 = dot(n, p), b2 = dot(n, q), back = dot(n, r12) - d;
    auto &[fixed, by_c, by_y] = proof.entries;
    for (int i = 0; i < D - 1; ++i) {
        Vector<T, D> const &t = tangents[i];
        Vector<T, D> const p_t = product(q1, t), q_t = product(q2, t);
        T const r = dot(t, r12);
        for (int j = 0; j <= i; ++j) {
            by_c.entries[i][j] = dot(tangents[j], p_t);
            by_y.entries[i][j] = dot(tangents[j], q_t);
            fixed.entries[i][j] =
                by_c.entries[i][j] + by_y.entries[i][j] - r * dot(tangents[j], r12);
        }
        by_c.entries[D - 1][i] = fixed.entries[D][i] = dot(t, p);
        by_y.entries[D - 1][i] = dot(t, q);
        by_y.entries[D][i] = -dot(t, q) / proof.ratio;
        by_c.entries[D][i] = T(0);
        fixed.entries[D - 1][i] = dot(t, p) + dot(t, q) - r * back;
    }
    by_c.entries[D - 1][D - 1] = fixed.entries[D][D - 1] = a2;
    by_y.entries[D - 1][D - 1] = b2;
    by_y.entries[D][D - 1] = -b2 / proof.ratio;
    fixed.entries[D - 1][D - 1] = a2 + b2 - back * back;
    by_c.entries[D][D - 1] = by_c.entries[D][D] = fixed.entries[D][D] = T(0);
    by_y.entries[D][D] = a2 - negative_power_of_two<T>(9) * a2;
}

/// Subtracts σ from the diagonal of K. σ1 and σ2 are such that K is definite next to c0 at every
/// strict minimum: k_z = m·k_t, where m solves H_tt m = H_tz.
template <class T, int D> PW85_FUNCTION inline bool
subtract_sigma(MinimumProof<T, D> &proof, T const &sigma, T const &unscaled) noexcept
{
    auto &[fixed, by_c, by_y] = proof.entries;
    T const c = proof.ratio, y = T(1) / c;
    LowerTriangle<T, D> h{};
    T z[std::size_t(D - 1)], p[std::size_t(D - 1)], q[std::size_t(D - 1)], product_p = T(0),
                                                                           product_q = T(0);
    for (int i = 0; i < D - 1; ++i) {
        for (int j = 0; j <= i; ++j)
            h.entries[i][j] = fixed.entries[i][j] + c * by_c.entries[i][j] + y * by_y.entries[i][j];
        h.entries[i][i] = h.entries[i][i] - sigma;
        z[i] = fixed.entries[D - 1][i] + c * by_c.entries[D - 1][i] + y * by_y.entries[D - 1][i];
        p[i] = by_c.entries[D - 1][i];
        q[i] = by_y.entries[D - 1][i];
    }
    h.entries[D - 1][D - 1] = largest_number<T>();
    if (!factorize_in_place(h)) return false;
    solve_forward(h, z);
    solve_forward(h, p);
    solve_forward(h, q);
    for (int i = 0; i < D - 1; ++i) {
        product_p = product_p + z[i] * p[i];
        product_q = product_q + z[i] * q[i];
    }
    T const a2 = by_c.entries[D - 1][D - 1], b2 = by_y.entries[D - 1][D - 1];
    T const sigma1 = T(0.5) * (a2 - product_p), sigma2 = T(0.5) * (b2 - product_q);
    T const rest = sigma - sigma1 * c - sigma2 * y;
    for (int i = 0; i < D - 1; ++i) {
        fixed.entries[i][i] = fixed.entries[i][i] - rest;
        by_c.entries[i][i] = by_c.entries[i][i] - sigma1;
        by_y.entries[i][i] = by_y.entries[i][i] - sigma2;
    }
    fixed.entries[D][D - 1] = product_p;
    by_y.entries[D][D - 1] = -product_q / c;
    T const fraction = negative_power_of_two<T>(mantissa_digits<T>() / 2);
    proof.margin = fraction * (unscaled + absolute(rest));
    proof.margin_c = fraction * absolute(sigma1);
    proof.margin_y = fraction * absolute(sigma2);
    return true;
}

/// Computes K for the best minimum of a search. The proof is not valid if the minimum is not
/// isolated, or if rounding errors exceed the margin.
///
/// The entries of H err by less than 30u times their size. This is far below the margin, which is
/// 2^-26 of the size in double. The parts of the margin that h and k need are computed here. The
/// depth to be proved is below the minimum by at least ρ, the rounding error of the minimum. So the
/// first entry of G has g >= ρ (α + β) at c0. A quarter of the margin makes (g/2, hᵀ; h, margin)
/// semidefinite if 16 |h|² < ρ (α + β) margin. c0 errs by less than e = 3u (X1 + X2) c0
/// (support.hpp). (c - c0)² from the true c0 is at least 1 - 2^-10 of that from the given one, less
/// 2^10 e². So 2^14 e² α²/c0 < ρ (α + β)/2 suffices for c down to c0/16. Row k errs by less than 8u
/// (trace Q1 + trace Q2/(c c0)). For this another 2^-10 of α²/c and a quarter of the margin
/// suffice.
template <class T, int D>
PW85_FUNCTION inline MinimumProof<T, D> prepare_proof(DepthSearch<T, D> const &search) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    Support<T, D> const s1 = support_from(accurate_product(q1, n), n),
                        s2 = support_from(accurate_product(q2, n), n);
    T const a = s1.extent, b = s2.extent, c = b / a, y = T(1) / c, u = T(unit_roundoff<T>());
    T const trace1 = trace(q1), trace2 = trace(q2), slack = best.rounding * (a + b);
    T const d = best.length - T(2) * best.rounding, level = dot(n, r12) + d, sigma = d * level;
    MinimumProof<T, D> proof{c, {}, T(0), T(0), T(0), false};
    fill_entries(proof, search, d);
    T const size = trace1 + trace2 + dot(r12, r12) + d * d;
    if (!subtract_sigma(proof, sigma, size)) return proof;
    proof.margin_c = proof.margin_c + negative_power_of_two<T>(mantissa_digits<T>() / 2) * trace1;
    proof.margin_y = proof.margin_y + negative_power_of_two<T>(mantissa_digits<T>() / 2) * trace2;
    Vector<T, D> const h =
        ((T(1) + c) * a) * s1.point + ((T(1) + y) * b) * s2.point - (sigma * n + level * r12);
    T const rounding = T(16) * u * (size + c * trace1 + y * trace2 + absolute(sigma));
    T const error = T(3) * u * (trace1 / (a * a) + trace2 / (b * b)),
            row = T(8) * u * (trace1 + T(16) * trace2 * y / c);
    proof.valid = T(16) * (dot(h, h) + rounding * rounding) < slack * proof.margin &&
                  T(32768) * error * error * (a * b) < slack &&
                  T(65536 * D) * row * row < a * a * y * proof.margin;
    return proof;
}

/// Whether K is positive definite, with its margin, at a point (c, y).
template <class T, int D> PW85_FUNCTION inline bool is_definite(MinimumProof<T, D> const &proof,
                                                                T const &c, T const &y) noexcept
{
    auto const &[fixed, by_c, by_y] = proof.entries;
    LowerTriangle<T, D + 1> k;
    for (int i = 0; i <= D; ++i)
        for (int j = 0; j <= i; ++j)
            k.entries[i][j] = fixed.entries[i][j] + c * by_c.entries[i][j] + y * by_y.entries[i][j];
    for (int i = 0; i < D; ++i)
        k.entries[i][i] =
            k.entries[i][i] - (proof.margin + c * proof.margin_c + y * proof.margin_y);
    return factorize_in_place(k);
}

/// The end of the range around c0 for which item 5 proves the depth, up to a factor of 16. The ends
/// of an interval differ by a factor of 2, or of a root of 2.
template <class T, int D>
PW85_FUNCTION inline T proved_bound(MinimumProof<T, D> const &proof, bool up) noexcept
{
    T c = proof.ratio, step = T(2);
    for (int i = 0; i < 12 && step > T(1.05); ++i) {
        T const next = up ? T(c * step) : T(c / step), sum = c + next;
        bool const distant = up ? next > T(16) * proof.ratio : T(16) * next < proof.ratio;
        if (distant) break;
        if (is_definite(proof, next, T(T(1) / next)) &&
            is_definite(proof, T(T(2) * c * next / sum), T(T(2) / sum)))
            c = next;
        else
            step = square_root(step);
    }
    return c;
}

/// The range of c around the best minimum for which items 4 and 5 prove the depth.
template <class T, int D>
PW85_FUNCTION inline RatioRange<T> proved_range(DepthSearch<T, D> const &search) noexcept
{
    auto const proof = prepare_proof(search);
    T const c = search.best.ratio;
    if (!(proof.valid && is_definite(proof, proof.ratio, T(T(1) / proof.ratio)))) return {c, c};
    return {proved_bound(proof, false), proved_bound(proof, true)};
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

/// Proves by items 2 to 5 that the best minimum is the global one, or finds a better one.
template <class T, int D> PW85_FUNCTION inline bool
prove_globally(DepthSearch<T, D> &search, RatioRange<T> const &range) noexcept
{
    RatioRange<T> const around = proved_range(search);
    if (!(prove_depth(search, RatioRange<T>{range.lower, around.lower}) &&
          prove_depth(search, RatioRange<T>{around.upper, range.upper})))
        return false;
    polish_direction(search);
    return true;
}

/// Computes penetration() of a valid pair that overlaps and is in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_in_range(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2) noexcept
{
    AxisSquares<T> const axes1 = axis_squares(q1), axes2 = axis_squares(q2);
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    descend_from_touching(search);
    if (!is_shallow(search, T(least_radius(axes1) + least_radius(axes2)))) {
        RatioRange<T> const range = ratio_range(axes1, axes2);
        descend_from_all(search, range);
        if (!prove_globally(search, range)) return no_penetration<T, D>(StatusCode::no_convergence);
    }
    return {maximum(T(0), search.best.length), search.direction, StatusCode::success};
}

/// Computes penetration() of a valid pair that overlaps. A pair of like sizes is scaled to sizes of
/// order one, so that it gets the bits of a pair that needs no scaling. Otherwise the larger
/// ellipsoid is scaled to size 2^room, so that cQ1 and Q2/c are in range for any aspect ratio. A
/// smaller ellipsoid that would leave the range is made larger. This change is far below rounding.
template <class T, int D> PW85_FUNCTION inline Penetration<T, D>
penetration_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int limit = std::numeric_limits<T>::max_exponent, room = limit / 5 * 2,
                  least = 16 - limit / 2;
    T const size1 = largest_diagonal(q1), size2 = largest_diagonal(q2);
    if (is_in_range(T(1), size1, size2)) return penetration_in_range(r12, q1, q2);
    int const e1 = half_exponent(size1), e2 = half_exponent(size2), larger = maximum(e1, e2);
    bool const alike = is_in_range(T(1), T(times_power_of_two(size1, -2 * larger)),
                                   T(times_power_of_two(size2, -2 * larger)));
    int const unit = alike ? larger : larger - room;
    int const unit1 = minimum(unit, e1 - least), unit2 = minimum(unit, e2 - least);
    auto result =
        penetration_in_range(times_power_of_two(r12, -unit), times_power_of_two(q1, -2 * unit1),
                             times_power_of_two(q2, -2 * unit2));
    result.depth = times_power_of_two(result.depth, unit);
    return result;
}

} // namespace pw85::detail

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids.
template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> penetration(Vector<T, D> const &r12,
                                                   SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != StatusCode::success || !decision.overlap)
        return detail::no_penetration<T, D>(decision.status);
    return detail::penetration_overlapping(r12, q1, q2);
}

} // namespace pw85

#endif
