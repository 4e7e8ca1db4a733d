// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof for penetration.hpp that no direction needs less than the best depth, for a range of the
/// ratio c of the half-widths (depth_search.hpp). Next to the best minimum another proof takes over
/// (depth_minimum.hpp).
///
/// Let W(c, y) = (1 + c) Q1 + (1 + y) Q2, so that the W(c) of depth_search.hpp is W(c, 1/c). The
/// point r has at least the depth d in the ellipsoid W(c, y) if and only if some σ > 0 makes
/// G(c, y, σ) = diag(W - σI, σ) - (r; d)(r; d)ᵀ positive semidefinite (the S-lemma;
/// depth_minimum.hpp uses the same matrix).
///
/// 1. G is affine in (c, y, σ). So where it is semidefinite at two points, each with a σ of its
///    own, it is so on the line between them.
/// 2. W grows with y. So a line below the hyperbola y = 1/c covers the part of it above the line.
/// 3. Tangents of the hyperbola lie below it. So a polyline of tangents, each of which begins where
///    the last one ends, proves the depth for a range of c by one test at each of its vertices.
///
/// 4. W grows with c, too. So a test at (c, 0) proves the depth for all larger ratios, and one at
///    (0, 1/c) for all smaller ones. Most pairs need no tangents.
///
/// A vertex on the tangent at c0, at c = (1 + w) c0, has y = (1 - w)/c0. The two tangents through a
/// vertex (c, y) touch at (1 ± √(1 - cy))/y.
#ifndef PW85_DISTANCE_DEPTH_INTERVALS_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_INTERVALS_HPP_INCLUDED

#include <pw85/distance/depth_search.hpp>

namespace pw85::detail {

/// A point (c, y) at which the depth is tested, with the σ at which the next test starts.
template <class T> struct DepthVertex {
    T c, y, sigma;
};

/// σ with what is known of the best one, and φ(σ) = rᵀ(W - σI)⁻¹r + d²/σ. G is semidefinite where
/// W - σI is definite and φ <= 1. φ is convex and smallest where σ|x| = d with x = (W - σI)⁻¹r.
template <class T, int D> struct ShiftTrial {
    T phi, next;
    Vector<T, D> x; ///< along the normal of the nearest point, at the best σ
    bool definite;
};

/// Evaluates φ, and takes Newton's step for σ|x| = d, which increases with σ.
///
/// μ = 32 u trace W is subtracted from W. The solution is exact for a matrix that differs by less
/// (the entries err by 3 u, the factorisation and the substitution by 3D u of the trace), and φ is
/// a sum of squares. So if the computed matrix is definite and the computed φ is at most 1 - 64 u,
/// this also holds in exact arithmetic.
template <class T, int D>
PW85_FUNCTION inline ShiftTrial<T, D> try_shift(SymmetricMatrix<T, D> const &w,
                                                Vector<T, D> const &r, T const &d,
                                                T const &sigma) noexcept
{
    T const margin = T(32 * unit_roundoff<T>()) * trace(w);
    auto const factors = factorize(plus_multiple_of_identity(w, T(-(sigma + margin))), T(0));
    for (T const &pivot : factors.pivots)
        if (!(pivot > T(0))) return {T(0), T(0), {}, false};
    Vector<T, D> const half = substitute_forward(factors, r), x = substitute_back(factors, half);
    T const squares = dot(x, x), size = square_root(squares), excess = sigma * size - d;
    T const slope = size + sigma * inverse_form(factors, x) / maximum(size, smallest_number<T>());
    return {dot_over_pivots(factors, half, half) + d * d / sigma, sigma - excess / slope, x, true};
}

/// The largest number of σ that a test tries. Two or three are usual.
inline constexpr int max_shift_trials = 12;

/// Returns whether the depth is proved at a vertex. If it is not, the direction that the test has
/// found is tried.
template <class T, int D>
PW85_FUNCTION inline bool is_deep_at(DepthSearch<T, D> &search, DepthVertex<T> &vertex) noexcept
{
    auto const w = blend(T(T(1) + vertex.c), search.q1, T(T(1) + vertex.y), search.q2);
    T const d = maximum(T(0), T(search.best.length - T(2) * search.best.rounding)),
            nearly = T(1) - T(64 * unit_roundoff<T>()), close = negative_power_of_two<T>(10);
    T lower = T(0), upper = trace(w), sigma = minimum(vertex.sigma, T(T(0.5) * upper));
    Vector<T, D> x{};
    for (int i = 0; i < max_shift_trials; ++i) {
        auto const trial = try_shift(w, search.r12, d, sigma);
        if (trial.definite) {
            vertex.sigma = sigma;
            if (trial.phi <= nearly) return true;
            x = trial.x;
            if (absolute(T(trial.next - sigma)) <= close * sigma) break;
            (trial.next > sigma ? lower : upper) = sigma;
        } else
            upper = sigma;
        bool const inside = trial.definite && trial.next > lower && trial.next < upper;
        sigma = inside ? trial.next : T(T(0.5) * (lower + upper));
    }
    if (largest_coordinate(x) > T(0)) try_direction(search, unit_along(with_square_in_range(x)));
    return false;
}

/// Returns whether the depth is proved for all ratios above c, or for all ratios below c.
template <class T, int D> PW85_FUNCTION inline bool
is_deep_beyond(DepthSearch<T, D> &search, T const &c, bool above, T const &sigma) noexcept
{
    DepthVertex<T> vertex{above ? c : T(0), above ? T(0) : T(T(1) / c), sigma};
    return is_deep_at(search, vertex);
}

/// Returns whether the depth is proved to rounding for c from `c` to ρ²c, where a minimum is not
/// isolated. The directions that this computes are tried as well.
///
/// With c0 = ρc, the tangent at c0 bounds 1/c from below. Its ends have y = 1/c - δ with δ = (ρ -
/// 1)²/(ρc0), and are vertices. This function computes the depth at these vertices instead of
/// testing it.
template <class T, int D>
PW85_FUNCTION inline bool none_deeper(DepthSearch<T, D> &search, T const &c, T const &rho) noexcept
{
    T const middle = rho * c, deficit = (rho - T(1)) * (rho - T(1)) / (rho * middle);
    for (int end = 0; end < 2; ++end) {
        auto const form =
            enclosing_form(search.q1, search.q2, end == 0 ? c : T(rho * middle), deficit);
        Vector<T, D> const n = extreme_normal(form, search.r12, true);
        Shift<T> const found = try_direction(search, n);
        T const depth = support(form, n).extent - dot(n, search.r12);
        if (!(depth >= search.best.length - T(2) * maximum(search.best.rounding, found.rounding)))
            return false;
    }
    return true;
}

/// The largest number of tangents that the proof takes. Ten are usual.
inline constexpr int max_tangents = 20000;

/// Result of a proof: complete for the range, a better direction that needs less, or incomplete.
enum class DepthProof { complete, better, incomplete };

/// The proof for c from the lower end of a range up to c.
template <class T> struct DepthProgress {
    T c, width;            ///< c, and w of the next tangent
    DepthVertex<T> vertex; ///< the first vertex of the next tangent
    bool begun;            ///< true if `vertex` has been tested
};

/// The next vertex: the end of a tangent, or the first one, below the hyperbola.
template <class T>
PW85_FUNCTION inline DepthVertex<T> next_vertex(DepthProgress<T> const &p) noexcept
{
    T const w = p.width, one = T(1), sigma = p.vertex.sigma;
    if (!p.begun) return {p.c, T((one - w * w) / p.c), sigma};
    T const root = square_root(maximum(T(0), T(one - p.vertex.c * p.vertex.y))),
            touch = (one + root) / p.vertex.y;
    return {(one + w) * touch, (one - w) / touch, sigma};
}

/// Takes one tangent, or makes the next one shorter. A tangent that is shorter than √u counts as
/// proved: a smaller value there would differ by less than rounding.
template <class T, int D>
PW85_FUNCTION inline void advance(DepthSearch<T, D> &search, DepthProgress<T> &p) noexcept
{
    T const shortest = negative_power_of_two<T>(mantissa_digits<T>() / 2), longest = T(0.5),
            short_width = negative_power_of_two<T>(8);
    DepthVertex<T> next = next_vertex(p);
    bool const tested = is_deep_at(search, next) || p.width <= shortest;
    T const rho = T(1) + p.width;
    bool const proved = tested || (p.width <= short_width && none_deeper(search, p.c, rho));
    p.vertex.sigma = next.sigma;
    if (!proved) {
        p.width = T(0.5) * p.width;
        return;
    }
    p.c = tested ? next.c : T(rho * rho * p.c);
    p.vertex = next;
    p.begun = tested;
    p.width = minimum(longest, T(p.width + p.width));
}

/// Proves the depth for a range of c by tangents that are as long as possible. Near a minimum the
/// vertices that can be proved approach the hyperbola, in proportion to their distance from it.
/// `sigma` is that of the best minimum.
template <class T, int D> PW85_FUNCTION inline DepthProof
prove_depth(DepthSearch<T, D> &search, RatioRange<T> const &range, T const &sigma) noexcept
{
    T const level = search.best.length;
    DepthProgress<T> p{range.lower, T(0.5), {range.lower, T(0), sigma}, false};
    for (int i = 0; i < max_tangents && p.c < range.upper; ++i) {
        advance(search, p);
        if (search.best.length < level - T(2) * search.best.rounding) return DepthProof::better;
    }
    return p.c < range.upper ? DepthProof::incomplete : DepthProof::complete;
}

} // namespace pw85::detail

#endif
