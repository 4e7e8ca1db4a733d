// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the least gap of an ellipsoid inside another one: local minima over directions,
/// for gap_inside.hpp.
///
/// Let α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12, with ellipsoid 2 inside ellipsoid 1. The gap
/// is the smallest value over unit vectors n of α - β - n·r, that is of (α - β - n·r)/|n| over all
/// n.
///
/// 1. With Q1 = SSᵀ, let n = S⁻ᵀm. Then α(n) = |m|, β(n)² = mᵀBm with B = S⁻¹Q2S⁻ᵀ, n·r = m·ρ with
///    ρ = S⁻¹r, and |n|² = mᵀΔm with Δ = S⁻¹S⁻ᵀ. Here S has the semi-axes of ellipsoid 1 as
///    columns, and Δ is diagonal. These numbers are at most of order one in units of α, whatever
///    the aspect ratio. They are computed in Finer<T>, and rounded once.
/// 2. Let F(m) = |m| - √(mᵀBm) - m·ρ - g √(mᵀΔm), where g is the value at some unit vector. All
///    terms but the first are concave, and |m + t| <= 1 + t²/2 for t across m. So the step to
///    m - e, where e is the gradient of F across m, does not increase the value. It is taken where
///    Newton's step does not decrease it.
#ifndef PW85_DISTANCE_GAP_SEARCH_HPP_INCLUDED
#define PW85_DISTANCE_GAP_SEARCH_HPP_INCLUDED

#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/evaluation.hpp>
#include <pw85/distance/curvature.hpp>
#include <pw85/distance/nearest.hpp>

namespace pw85::detail {

/// A pair in the coordinates of item 1.
template <class T, int D> struct GapFrame {
    Vector<T, D> separation;     ///< ρ
    SymmetricMatrix<T, D> inner; ///< B
    Vector<T, D> metric;         ///< the diagonal of Δ
};

/// Computes the frame of a pair that is scaled to the size of ellipsoid 1.
template <class T, int D>
PW85_FUNCTION inline GapFrame<T, D> gap_frame(Vector<T, D> const &r12,
                                              SymmetricMatrix<T, D> const &q2,
                                              PrincipalAxes<Finer<T>, D> const &axes) noexcept
{
    using W = Finer<T>;
    auto const r = converted<W>(r12);
    auto const q = converted<W>(q2);
    Vector<W, D> columns[std::size_t(D)], products[std::size_t(D)]; // of S⁻ᵀ, and Q2 times these
    GapFrame<T, D> frame{};
    for (int k = 0; k < D; ++k) {
        W const size = W(sqrt(axes.squares[k]));
        for (int i = 0; i < D; ++i) columns[k][i] = axes.axes[i][k] / size;
        products[k] = product(q, columns[k]);
        frame.separation[k] = rounded(dot(columns[k], r));
        frame.metric[k] = rounded(W(W(1) / axes.squares[k]));
    }
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) frame.inner(i, j) = rounded(dot(columns[i], products[j]));
    return frame;
}

/// The value at a unit vector m, with what its derivatives need.
template <class T, int D> struct GapState {
    Vector<T, D> m, inner_point, metric_point; ///< m, Bm/β and Δm/|n|
    T inner_extent, length;                    ///< β and |n|
    T gap;
};

template <class T, int D> PW85_FUNCTION inline GapState<T, D>
gap_state(GapFrame<T, D> const &frame, Vector<T, D> const &m) noexcept
{
    Vector<T, D> const b = product(frame.inner, m);
    Vector<T, D> w = m;
    for (int i = 0; i < D; ++i) w[i] = frame.metric[i] * m[i];
    T const extent = square_root(maximum(dot(m, b), smallest_number<T>())),
            length = square_root(dot(m, w));
    return {m,
            T(T(1) / extent) * b,
            T(T(1) / length) * w,
            extent,
            length,
            ((T(1) - extent) - dot(m, frame.separation)) / length};
}

/// The gradient of F across m.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
gap_gradient(GapFrame<T, D> const &frame, GapState<T, D> const &at) noexcept
{
    return project(-(at.inner_point + frame.separation + at.gap * at.metric_point), at.m);
}

/// Factors of the second derivatives of the three terms of F. All are one at m itself.
template <class T> struct GapWeights {
    T outer, inner, metric;
};

/// The weighted second derivatives of F across m, and one along m: the matrix is definite if they
/// are. `shift` is subtracted from the diagonal.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
gap_hessian(GapFrame<T, D> const &frame, GapState<T, D> const &at, T const &gap,
            GapWeights<T> const &weights, T const &shift) noexcept
{
    T const inner = weights.inner / at.inner_extent, metric = weights.metric * gap / at.length;
    Vector<T, D> const &b = at.inner_point, &w = at.metric_point, &m = at.m;
    SymmetricMatrix<T, D> h{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
            T const outer = i == j ? weights.outer : T(0),
                    diagonal = i == j ? frame.metric[i] : T(0);
            h(i, j) = outer - inner * (frame.inner(i, j) - b[i] * b[j]) -
                      metric * (diagonal - w[i] * w[j]);
        }
    Vector<T, D> const along = product(h, m);
    T const both = dot(m, along) + T(1);
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
            h(i, j) = h(i, j) - (m[i] * along[j] + along[i] * m[j]) + both * (m[i] * m[j]);
            if (i == j) h(i, j) = h(i, j) - shift;
        }
    return h;
}

template <class T, int D>
PW85_FUNCTION inline bool has_positive_pivots(Factorization<T, D> const &factors) noexcept
{
    for (T const &pivot : factors.pivots)
        if (!(pivot > T(0))) return false;
    return true;
}

/// A bound of the rounding error of the gap at a state, in units of length. The extent β errs by
/// 8 u Σ|m_i B_ij m_j|/(2β), and the other terms by 8 u times their magnitudes.
template <class T, int D>
PW85_FUNCTION inline T gap_rounding(GapFrame<T, D> const &frame, GapState<T, D> const &at) noexcept
{
    T const inner = magnitude_of_form(frame.inner, at.m) / (at.inner_extent + at.inner_extent);
    return T(8 * unit_roundoff<T>()) * ((T(1) + magnitude_of_dot(at.m, frame.separation)) + inner) /
           at.length;
}

/// The number of steps that a descent takes at most. Six are usual. One that does not converge ends
/// at a valid value, too; gap_proof.hpp decides whether it is the least one.
inline constexpr int max_gap_steps = 64;

/// Follows F from a direction to a local minimum. A step below √u is the last one, because the
/// error after it is of the order of its square.
template <class T, int D> PW85_FUNCTION inline GapState<T, D>
descend_gap(GapFrame<T, D> const &frame, GapState<T, D> at) noexcept
{
    T const threshold = negative_power_of_two<T>(mantissa_digits<T>() + 2);
    for (int i = 0; i < max_gap_steps; ++i) {
        Vector<T, D> const e = gap_gradient(frame, at);
        auto const factors =
            factorize(gap_hessian(frame, at, at.gap, {T(1), T(1), T(1)}, T(0)), T(0));
        bool newton = has_positive_pivots(factors);
        Vector<T, D> step = newton ? project(solve(factors, e), at.m) : e;
        newton = newton && dot(step, step) < T(0.25);
        auto next = gap_state(frame, unit_along(at.m - (newton ? step : e)));
        T const slack = gap_rounding(frame, at);
        if (newton && !(next.gap <= at.gap + slack)) {
            newton = false;
            next = gap_state(frame, unit_along(at.m - e));
        }
        T const square = newton ? dot(step, step) : dot(e, e);
        if (!(next.gap <= at.gap + slack)) break;
        at = next;
        if (square <= threshold) break;
    }
    return at;
}

} // namespace pw85::detail

#endif
