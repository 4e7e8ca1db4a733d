// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof for penetration.hpp that the best minimum of D (depth_search.hpp) is the smallest value
/// of D for a range of c around it: a matrix that depends on c is positive semidefinite there.
///
/// Let (n, c0) be the minimum, c0 = β/α. With x = (m; 1) for unit vectors m, mᵀWm - (m·r + d)² is
/// xᵀGx, where G(c) = diag(W - σI, σ) - (r; d)(r; d)ᵀ for any number σ. So D(c) >= d if G is
/// positive semidefinite for some σ. Here σ = dℓ + (c - c0) σ1 + (1/c - 1/c0) σ2, with ℓ = m·r + d
/// at m = n.
///
/// The basis consists of v = (n; 1), of (t_i; 0) with the tangents t_i, and of (n; -1). In this
/// basis the entry vᵀGv is (ℓ' - ℓ)(ℓ' + ℓ) + α²(c - c0)²/c with ℓ' = α + β, and the rest of its
/// row is h + (c - c0) k. At a minimum with d = ℓ' - n·r, ℓ' = ℓ and h = 0. H is G without the
/// first row and column. So G is semidefinite where K = (α²/c, kᵀ; k, H) is.
#ifndef PW85_DISTANCE_DEPTH_MINIMUM_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_MINIMUM_HPP_INCLUDED

#include <pw85/distance/depth_search.hpp>

namespace pw85::detail {

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

/// K as K0 + c K1 + y K2 with y = 1/c, with the margins of its diagonal for rounding errors and for
/// h.
template <class T, int D> struct MinimumProof {
    T ratio; ///< c0
    struct {
        LowerTriangle<T, D + 1> constant, by_c, by_y;
    } entries;
    /// reserved on the diagonal of H: margin + c margin_c + y margin_y
    T margin, margin_c, margin_y;
    bool valid;
};

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

/// The system of the tangents, H_tt m = x, with σ subtracted from the diagonal of H_tt = LLᵀ, and
/// L⁻¹x for the columns x next to the tangents.
template <class T, int D> struct TangentSystem {
    LowerTriangle<T, D> factor;
    T hessian[std::size_t(D - 1)];                        ///< L⁻¹ H_tz
    T by_c[std::size_t(D - 1)], by_y[std::size_t(D - 1)]; ///< L⁻¹ times the columns of K1 and K2
};

/// Solves the system of the tangents at c0. Returns false if it is not positive definite.
template <class T, int D>
PW85_FUNCTION inline bool solve_tangents(MinimumProof<T, D> const &proof, T const &sigma,
                                         TangentSystem<T, D> &system) noexcept
{
    auto const &[fixed, by_c, by_y] = proof.entries;
    T const c = proof.ratio, y = T(1) / c;
    auto &[h, z, p, q] = system;
    for (int i = 0; i < D - 1; ++i) {
        for (int j = 0; j <= i; ++j)
            h.entries[i][j] = fixed.entries[i][j] + c * by_c.entries[i][j] + y * by_y.entries[i][j];
        h.entries[i][i] = h.entries[i][i] - sigma;
        z[i] = fixed.entries[D - 1][i] + c * by_c.entries[D - 1][i] + y * by_y.entries[D - 1][i];
        p[i] = by_c.entries[D - 1][i];
        q[i] = by_y.entries[D - 1][i];
        h.entries[D - 1][i] = T(0);
    }
    h.entries[D - 1][D - 1] = largest_number<T>();
    if (!factorize_in_place(h)) return false;
    solve_forward(h, z);
    solve_forward(h, p);
    solve_forward(h, q);
    return true;
}

/// Subtracts σ from the diagonal of K. σ1 and σ2 are such that K is definite next to c0 at every
/// strict minimum: k_z = m·k_t, where m solves H_tt m = H_tz.
template <class T, int D>
PW85_FUNCTION inline bool subtract_sigma(MinimumProof<T, D> &proof, T const &sigma,
                                         T const &unscaled, T const &trace1,
                                         T const &trace2) noexcept
{
    auto &[fixed, by_c, by_y] = proof.entries;
    T const c = proof.ratio, y = T(1) / c;
    TangentSystem<T, D> system;
    if (!solve_tangents(proof, sigma, system)) return false;
    auto const &[factor, z, p, q] = system;
    T product_p = T(0), product_q = T(0);
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
    T const fraction = T(1024 * unit_roundoff<T>());
    proof.margin = fraction * (unscaled + absolute(rest));
    proof.margin_c = fraction * (absolute(sigma1) + trace1);
    proof.margin_y = fraction * (absolute(sigma2) + trace2);
    return true;
}

/// Computes K for the best minimum of a search. The proof is not valid if the minimum is not
/// isolated, or if rounding errors of c0 are too large.
///
/// The entries of H err by less than 30u times their size. This is far below the margin, which is
/// at least 1024u of the size. The margin is as large as h and k need, which is computed here. The
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
    if (!subtract_sigma(proof, sigma, size, trace1, trace2)) return proof;
    Vector<T, D> const h =
        ((T(1) + c) * a) * s1.point + ((T(1) + y) * b) * s2.point - (sigma * n + level * r12);
    T const rounding = T(16) * u * (size + c * trace1 + y * trace2 + absolute(sigma));
    T const error = T(3) * u * (trace1 / (a * a) + trace2 / (b * b)),
            row = T(8) * u * (trace1 + T(16) * trace2 * y / c);
    T const least = maximum(T(T(16) * (dot(h, h) + rounding * rounding) / slack),
                            T(T(65536 * D) * row * row / (a * a * y)));
    proof.margin = maximum(proof.margin, T(T(1.0625) * least));
    proof.valid = T(32768) * error * error * (a * b) < slack;
    return proof;
}

/// Returns whether K is positive definite, with its margin, at two points (c, y): whether the
/// pivots of K = LDLᵀ are positive.
template <class T, int D> PW85_FUNCTION inline bool
are_definite(MinimumProof<T, D> const &proof, TwoLanes<T> const &c, TwoLanes<T> const &y) noexcept
{
    using Two = TwoLanes<T>;
    auto const &[fixed, by_c, by_y] = proof.entries;
    LowerTriangle<Two, D + 1> k;
    for (int i = 0; i <= D; ++i)
        for (int j = 0; j <= i; ++j)
            k.entries[i][j] = Two(fixed.entries[i][j]) + c * Two(by_c.entries[i][j]) +
                              y * Two(by_y.entries[i][j]);
    auto const margin = Two(proof.margin) + c * Two(proof.margin_c) + y * Two(proof.margin_y);
    for (int i = 0; i < D; ++i) k.entries[i][i] = k.entries[i][i] - margin;
    for (int j = 0; j <= D; ++j) {
        if (!all_of(k.entries[j][j] > Two(T(0)))) return false;
        auto const inverse = Two(T(1)) / k.entries[j][j];
        for (int i = j + 1; i <= D; ++i) {
            auto const factor = k.entries[i][j] * inverse;
            for (int l = j + 1; l <= i; ++l)
                k.entries[i][l] = k.entries[i][l] - factor * k.entries[l][j];
        }
    }
    return true;
}

/// The end of the range around c0 for which K is semidefinite, up to a factor of 16. K is
/// affine in c and y = 1/c. So it is semidefinite on an interval if it is at three points (c, y):
/// at both ends, and where the tangents of the hyperbola y = 1/c at the ends meet. The arc is in
/// the triangle of these three points. The first interval is the whole range; the ends of one that
/// fails come closer, by a root.
template <class T, int D>
PW85_FUNCTION inline T proved_bound(MinimumProof<T, D> const &proof, bool up) noexcept
{
    T c = proof.ratio, step = T(16);
    T const last = up ? T(step * c) : T(c / step);
    for (int i = 0; i < 24 && step > (c == proof.ratio ? T(1 + 0x1p-16) : T(1.0625)); ++i) {
        T const next = up ? minimum(T(c * step), last) : maximum(T(c / step), last), sum = c + next;
        if (are_definite<T, D>(proof, {next, T(T(2) * c * next / sum)},
                               {T(T(1) / next), T(T(2) / sum)})) {
            c = next;
            if (c == last) break;
        } else
            step = square_root(step);
    }
    return c;
}

/// The range of c around the best minimum for which K proves the depth.
template <class T, int D>
PW85_FUNCTION inline RatioRange<T> proved_range(DepthSearch<T, D> const &search) noexcept
{
    auto const proof = prepare_proof(search);
    T const c = search.best.ratio;
    TwoLanes<T> const ratio(proof.ratio);
    if (!(proof.valid && are_definite(proof, ratio, TwoLanes<T>(T(1)) / ratio))) return {c, c};
    return {proved_bound(proof, false), proved_bound(proof, true)};
}

} // namespace pw85::detail

#endif
