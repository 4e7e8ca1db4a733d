// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof for gap_inside.hpp that no direction has a smaller gap than the best local minimum of
/// gap_search.hpp, whose notation this file uses. The proof divides the sphere of m (the circle in
/// the plane) into cells, the cones over arcs or triangles with the unit vectors v_i as corners. It
/// bisects the longest edge of cells that are not proved. Let d be the gap to be proved.
///
/// 1. For 0 < c < 1, (α - β)² >= (1 - c) α² - (1/c - 1) β², with equality at c = β/α. So with q =
///    m·ρ the gap is proved where (1 - c)(m² - mᵀBm/c) >= (q + d|n|)², because α >= β.
/// 2. On a cell m = Σ t_i v_i with t_i >= 0. |n| is convex and of first degree, so u·n <= |n| <= Σ
///    t_i |n_i| for any unit vector u. With q⁺ = Σ t_i max(q_i, 0) this gives q|n| <= q (u·n) + q⁺
///    Σ t_i (|n_i| - u·n_i).
/// 3. So (q + d|n|)² = q² + 2d q|n| + d²|n|² is at most a quadratic form of t, and item 1 holds on
///    the cell if no entry of the matrix of the difference is negative. c and u are those of the
///    middle of the cell. The loss by these bounds is of second order in the size of the cell, and
///    the margin grows with the square of the distance from a minimum. So a few cells suffice for
///    each factor of two of that distance.
/// 4. Around an isolated minimum F is convex: is_proved_around() finds a cap without smaller
///    values.
#ifndef PW85_DISTANCE_GAP_PROOF_HPP_INCLUDED
#define PW85_DISTANCE_GAP_PROOF_HPP_INCLUDED

#include <pw85/distance/gap_search.hpp>

namespace pw85::detail {

/// The directions m + t with t across the unit vector m and |t| <= radius.
template <class T, int D> struct GapCap {
    Vector<T, D> m;
    T radius;
};

/// A cone over an arc or a triangle.
template <class T, int D> struct GapCell {
    Vector<T, D> corners[std::size_t(D)];
    int depth; ///< the number of bisections that led to it
};

inline constexpr int max_gap_caps = 16, max_gap_cells = 64;

/// The state of a proof: the level d, the best direction, the caps around minima, and the cells
/// that are left.
template <class T, int D> struct GapProof {
    GapFrame<T, D> frame;
    GapState<T, D> best;
    T rounding; ///< gap_rounding() of the best direction; d is below its gap by four times this
    GapCap<T, D> caps[std::size_t(max_gap_caps)];
    GapCell<T, D> cells[std::size_t(max_gap_cells)];
    int num_caps, num_cells;
};

template <class T, int D> PW85_FUNCTION inline T gap_level(GapProof<T, D> const &proof) noexcept
{
    return maximum(T(0), T(proof.best.gap - T(4) * proof.rounding));
}

/// Returns whether F, with d in place of g, is not negative on a cap around the state, which is a
/// minimum up to rounding.
///
/// Let m + t be in the cap, b = Bm/β, w = Δm/|n|, and C(A, a) the matrix A - aaᵀ. Then
///
///     |m + t| >= 1 + (1 - t²/4) t²/2,
///     β(m + t) <= β + b·t + tᵀC(B, b)t/(2β(1 + b·t/β)),
///
/// and the same for |n| with w. The first line is Taylor's series, the other one √(1 + x) <= 1 +
/// x/2. With the matrix H that takes 1 - radius²/4 and the largest 1/(1 + b·t/β), F is at least
/// e·t + tᵀHt/2. The gradient e is not zero only by rounding. With d in place of g it is larger by
/// (g - d) |n(m + t)|, at least `slack`. So it is not negative if H - λ is semidefinite for λ =
/// e²/(2 slack). The margin of 64 u times the trace covers the errors of H, whose entries err by
/// less than 16 u times those of its terms, and of the factorisation. e errs by less than 32 u.
template <class T, int D> PW85_FUNCTION inline bool
is_proved_around(GapProof<T, D> const &proof, GapState<T, D> const &at, T const &radius) noexcept
{
    T const level = gap_level(proof), u = T(unit_roundoff<T>());
    Vector<T, D> const e = gap_gradient(proof.frame, at);
    T const inner = T(1) - radius * magnitude(project(at.inner_point, at.m)) / at.inner_extent,
            metric = T(1) - radius * magnitude(project(at.metric_point, at.m)) / at.length;
    T const close = negative_power_of_two<T>(5);
    if (!(inner > close && metric > close)) return false;
    T const error = magnitude(e) + T(32) * u,
            slack = metric * (at.gap - (level + gap_rounding(proof.frame, at))) * at.length;
    if (!(slack > T(0))) return false;
    T trace_metric = T(0);
    for (int i = 0; i < D; ++i) trace_metric = trace_metric + proof.frame.metric[i];
    T const size = T(1) + trace(proof.frame.inner) / (inner * at.inner_extent) +
                   at.gap * trace_metric / (metric * at.length);
    T const shift = T(0.5) * error * error / slack + T(64) * u * size;
    GapWeights<T> const weights{T(1) - T(0.25) * (radius * radius), T(1) / inner, T(1) / metric};
    return has_positive_pivots(
        factorize(gap_hessian(proof.frame, at, at.gap, weights, shift), T(0)));
}

/// Returns whether a unit vector is in a cap. Caps are convex cones. The margin covers rounding.
template <class T, int D>
PW85_FUNCTION inline bool is_in_cap(GapCap<T, D> const &cap, Vector<T, D> const &v) noexcept
{
    T const cosine = T(1) / square_root(T(T(1) + cap.radius * cap.radius));
    return dot(v, cap.m) >= cosine + T(16) * T(unit_roundoff<T>());
}

/// Keeps the largest cap that is proved around a minimum, of a few sizes, unless the minimum is in
/// another cap.
template <class T, int D>
PW85_FUNCTION inline void add_cap(GapProof<T, D> &proof, GapState<T, D> const &at) noexcept
{
    for (int k = 0; k < proof.num_caps; ++k)
        if (is_in_cap(proof.caps[k], at.m)) return;
    if (proof.num_caps == max_gap_caps) return;
    T radius = T(1);
    for (int i = 0; i < 24; ++i) {
        if (is_proved_around(proof, at, radius)) {
            proof.caps[proof.num_caps++] = {at.m, radius};
            return;
        }
        radius = T(0.5) * radius;
    }
}

/// Data of a corner v for item 3: q, q⁺, |n|, u·n and the magnitude of the terms of q.
template <class T> struct GapCorner {
    T along, forward, length, projection, magnitude;
};

template <class T, int D>
PW85_FUNCTION inline GapCorner<T> gap_corner(GapFrame<T, D> const &frame,
                                             GapState<T, D> const &middle,
                                             Vector<T, D> const &v) noexcept
{
    T const along = dot(v, frame.separation);
    T square = T(0);
    for (int i = 0; i < D; ++i) square = square + frame.metric[i] * (v[i] * v[i]);
    return {along, maximum(along, T(0)), square_root(square), dot(v, middle.metric_point),
            magnitude_of_dot(v, frame.separation)};
}

/// An entry of the matrix of item 3, less a bound of its rounding errors.
///
/// The products v·w and (1/c) vᵀBw err by less than 16 u times the magnitudes of their terms, which
/// includes the rounding of the entries of B. The other terms err by less than 16 u (Q1 + d|n1|)
/// (Q2 + d|n2|), where Q bounds the magnitudes of the terms of q.
template <class T, int D>
PW85_FUNCTION inline T gap_entry(GapFrame<T, D> const &frame, GapCell<T, D> const &cell,
                                 GapCorner<T> const (&corners)[std::size_t(D)], int i, int j,
                                 T const &c, T const &d) noexcept
{
    Vector<T, D> const &v = cell.corners[i], &w = cell.corners[j];
    GapCorner<T> const &a = corners[i], &b = corners[j];
    T inner = T(0), magnitudes = T(0), metric = T(0);
    for (int k = 0; k < D; ++k) {
        metric = metric + frame.metric[k] * (v[k] * w[k]);
        for (int l = 0; l < D; ++l) {
            T const term = v[k] * frame.inner(k, l) * w[l];
            inner = inner + term;
            magnitudes = magnitudes + absolute(term);
        }
    }
    T const margin = T(16) * T(unit_roundoff<T>());
    T const form =
        (T(1) - c) * ((dot(v, w) - inner / c) - margin * (magnitude_of_dot(v, w) + magnitudes / c));
    T const cross = a.along * b.projection + b.along * a.projection +
                    a.forward * (b.length - b.projection) + b.forward * (a.length - a.projection);
    T const rest = (a.magnitude + d * a.length) * (b.magnitude + d * b.length);
    return form - (a.along * b.along + d * cross + d * d * metric) - margin * rest;
}

/// Returns whether the gap `level` is proved on a cell.
template <class T, int D>
PW85_FUNCTION inline bool is_proved_on(GapFrame<T, D> const &frame, GapState<T, D> const &middle,
                                       GapCell<T, D> const &cell, T const &level) noexcept
{
    T const c = minimum(middle.inner_extent, T(T(1) - T(unit_roundoff<T>())));
    GapCorner<T> corners[std::size_t(D)];
    for (int i = 0; i < D; ++i) corners[i] = gap_corner(frame, middle, cell.corners[i]);
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            if (!(gap_entry(frame, cell, corners, i, j, c, level) >= T(0))) return false;
    return true;
}

/// Divides a cell at the middle of its longest edge.
template <class T, int D>
PW85_FUNCTION inline void bisect(GapProof<T, D> &proof, GapCell<T, D> const &cell) noexcept
{
    int first = 0, second = 1;
    T least = dot(cell.corners[0], cell.corners[1]);
    for (int i = 0; i < D; ++i)
        for (int j = i + 1; j < D; ++j) {
            T const cosine = dot(cell.corners[i], cell.corners[j]);
            if (!(cosine < least)) continue;
            least = cosine;
            first = i;
            second = j;
        }
    Vector<T, D> const middle = unit_along(cell.corners[first] + cell.corners[second]);
    for (int end : {first, second}) {
        GapCell<T, D> &part = proof.cells[proof.num_cells++];
        part = cell;
        part.corners[end] = middle;
        ++part.depth;
    }
}

/// The orthants.
template <class T, int D> PW85_FUNCTION inline void fill_orthants(GapProof<T, D> &proof) noexcept
{
    proof.num_cells = 0;
    for (int signs = 0; signs < (1 << D); ++signs) {
        GapCell<T, D> &cell = proof.cells[proof.num_cells++];
        cell = {};
        for (int k = 0; k < D; ++k) cell.corners[k][k] = (signs >> k & 1) != 0 ? T(-1) : T(1);
    }
}

/// Constants for minima that are not isolated, as on circles of spheroids with a common axis. There
/// the gap is proved up to the fraction 2^-gap_share_digits of it. This weaker proof is used after
/// a number of bisections that leads to cells of the size 2^-9 in three dimensions and 2^-26 in
/// two. In two dimensions c is constant along arcs of minima, and item 1 is exact.
template <int D> inline constexpr int gap_share_digits = D == 2 ? 40 : 20;
template <int D> inline constexpr int max_gap_depth = D == 2 ? 26 : 21;

/// The largest number of cells. A few hundred are usual.
inline constexpr int max_gap_proofs = 400000;

/// Returns whether a gap is below the best one by more than rounding.
template <class T, int D>
PW85_FUNCTION inline bool is_better(GapProof<T, D> const &proof, T const &gap) noexcept
{
    return gap < proof.best.gap - proof.rounding;
}

/// Descends from a direction, and keeps the minimum. What was proved for a higher level remains
/// proved. In the rare case that a better minimum with a smaller rounding error leads to a higher
/// level, the proof begins again.
template <class T, int D>
PW85_FUNCTION inline void try_minimum(GapProof<T, D> &proof, GapState<T, D> const &start) noexcept
{
    auto const found = descend_gap(proof.frame, start);
    if (is_better(proof, found.gap)) {
        T const level = gap_level(proof);
        proof.best = found;
        proof.rounding = gap_rounding(proof.frame, found);
        if (gap_level(proof) > level) {
            proof.num_caps = 0;
            fill_orthants(proof);
        }
    }
    add_cap(proof, found);
}

/// Returns whether a cell is in a cap, as it is if its corners are.
template <class T, int D> PW85_FUNCTION inline bool is_in_a_cap(GapProof<T, D> const &proof,
                                                                GapCell<T, D> const &cell) noexcept
{
    for (int k = 0; k < proof.num_caps; ++k) {
        bool inside = true;
        for (auto const &v : cell.corners) inside = inside && is_in_cap(proof.caps[k], v);
        if (inside) return true;
    }
    return false;
}

/// Proves a cell, or divides it. After every few bisections, a descent from its middle searches for
/// another minimum. This minimum may be better, and is enclosed in a cap.
template <class T, int D>
PW85_FUNCTION inline void prove_or_bisect(GapProof<T, D> &proof, GapCell<T, D> const &cell) noexcept
{
    constexpr int interval = 6; // bisections between two descents
    T const share = T(1) - negative_power_of_two<T>(gap_share_digits<D>), level = gap_level(proof);
    Vector<T, D> sum = cell.corners[0];
    for (int k = 1; k < D; ++k) sum = sum + cell.corners[k];
    auto const middle = gap_state(proof.frame, unit_along(sum));
    if (is_proved_on(proof.frame, middle, cell, level)) return;
    bool const is_last = cell.depth >= max_gap_depth<D>;
    if (is_last && is_proved_on(proof.frame, middle, cell, T(share * level))) return;
    if (is_better(proof, middle.gap) || cell.depth % interval == interval - 1)
        try_minimum(proof, middle);
    bisect(proof, cell);
}

/// Proves that no direction has a gap below the level, or finds a better one, which lowers it. The
/// level 0 needs no proof, because ellipsoid 2 is inside.
template <class T, int D> PW85_FUNCTION inline bool prove_gap(GapProof<T, D> &proof) noexcept
{
    fill_orthants(proof);
    for (int i = 0; proof.num_cells > 0 && gap_level(proof) > T(0); ++i) {
        if (i == max_gap_proofs || proof.num_cells + 2 > max_gap_cells) return false;
        GapCell<T, D> const cell = proof.cells[--proof.num_cells];
        if (!is_in_a_cap(proof, cell)) prove_or_bisect(proof, cell);
    }
    return true;
}

} // namespace pw85::detail

#endif
