// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The depth of an overlap: the shortest translation that separates two ellipsoids.
/// src/simd/unfused/depth.cpp calls penetration(), and src/simd/lanes/depth.hpp calls its first
/// method for one pair per lane.
///
/// Newton's method for the normal finds a local minimum (depth_turns.hpp). For most pairs the
/// curvatures at this minimum prove that it is the global one (depth_certificate.hpp). Otherwise
/// two proofs show that the best minimum is the global one, or find a better one: around it
/// depth_minimum.hpp, and elsewhere depth_intervals.hpp.
#ifndef PW85_DISTANCE_PENETRATION_HPP_INCLUDED
#define PW85_DISTANCE_PENETRATION_HPP_INCLUDED

#include <pw85/distance/depth_certificate.hpp>
#include <pw85/distance/depth_intervals.hpp>
#include <pw85/distance/depth_minimum.hpp>

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

/// The range of c = β/α over all directions of a pair.
template <class T, int D>
PW85_FUNCTION inline RatioRange<T> ratio_range(DepthSearch<T, D> const &search) noexcept
{
    return ratio_range(axis_bounds(search.q1), axis_bounds(search.q2));
}

/// Proves the depth by tangents where `open` says that this has not been done otherwise.
template <class T, int D>
PW85_FUNCTION inline DepthProof prove_by_tangents(DepthSearch<T, D> &search,
                                                  RatioRange<T> const &around, T const &sigma,
                                                  bool open_below, bool open_above) noexcept
{
    RatioRange<T> const range = ratio_range(search);
    auto below = DepthProof::complete;
    if (open_below) below = prove_depth(search, {range.lower, around.lower}, sigma);
    if (below != DepthProof::complete || !open_above) return below;
    return prove_depth(search, {around.upper, range.upper}, sigma);
}

/// Proves that the best minimum is the global one, or finds a better one.
template <class T, int D>
PW85_FUNCTION inline DepthProof prove_once(DepthSearch<T, D> &search) noexcept
{
    RatioRange<T> around = proved_range(search);
    if (!(around.lower < around.upper)) { // no isolated minimum; a better one may be
        descend_from_all(search, ratio_range(search));
        around = proved_range(search);
    }
    T const d = search.best.length, sigma = d * (dot(search.direction, search.r12) + d),
            level = d - T(2) * search.best.rounding;
    bool const below = is_deep_beyond(search, around.lower, false, sigma),
               above = is_deep_beyond(search, around.upper, true, sigma);
    if (search.best.length < level) return DepthProof::better;
    if (below && above) return DepthProof::complete;
    return prove_by_tangents(search, around, sigma, !below, !above);
}

/// The largest number of minima for which a proof is tried. Each is lower than the last one. More
/// than two are rare.
inline constexpr int max_depth_minima = 64;

/// A direction m with a negative mᵀAm: the column of L⁻ᵀ of the first pivot of A = L diag(d) Lᵀ
/// that is negative. Zero if all pivots before the last one are positive, and the last one is not
/// negative.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> negative_direction(SymmetricMatrix<T, D> a) noexcept
{
    Vector<T, D> m{};
    T lower[std::size_t(D)][std::size_t(D)];
    for (int j = 0; j < D; ++j) {
        T const pivot = a(j, j);
        if (pivot < T(0)) {
            m[j] = T(1);
            for (int i = j - 1; i >= 0; --i)
                for (int k = i + 1; k <= j; ++k) m[i] = m[i] - lower[k][i] * m[k];
            return m;
        }
        if (!(pivot > T(0))) return m;
        for (int i = j + 1; i < D; ++i) lower[i][j] = a(j, i) / pivot;
        for (int i = j + 1; i < D; ++i)
            for (int k = i; k < D; ++k) a(i, k) = a(i, k) - lower[i][j] * a(j, k);
    }
    return m;
}

/// Tries a direction n + sm that needs less than the best minimum, if there is one at its ratio c
/// of the half-widths. Returns whether it does.
///
/// With d = g(n), σ = d(n·r + d) and |n + sm| = 1, (n + sm)ᵀW(c)(n + sm) - ((n + sm)·r + d)² is
/// s²mᵀ(W(c) - σI - rrᵀ)m (depth_certificate.hpp). Where this is negative, g(n + sm) < d.
template <class T, int D> PW85_FUNCTION inline bool step_below(DepthSearch<T, D> &search) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    T const d = best.length, level = d - T(2) * best.rounding;
    auto form = plus_multiple_of_identity(enclosing_form(q1, q2, best.ratio, T(0)),
                                          T(-d * (dot(n, r12) + d)));
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) form(i, j) = form(i, j) - r12[i] * r12[j];
    Vector<T, D> const m = negative_direction(form);
    T const square = dot(m, m);
    if (!(square > T(0))) return false;
    return try_direction(search, unit_along(add_scaled(n, T(T(-2) * dot(n, m) / square), m)))
               .length < level;
}

/// Returns whether a certificate proves the best minimum, or one below it to which step_below()
/// leads.
template <class T, int D> PW85_FUNCTION inline bool
find_certified(DepthSearch<T, D> &search, FollowedNormal<T, D> minimum) noexcept
{
    for (int i = 0; i < max_depth_minima && minimum.found; ++i) {
        if (is_certified(search, minimum.at)) return true;
        if (!step_below(search)) return false;
        minimum = follow_normal(search, search.direction);
    }
    return false;
}

/// Proves a minimum that has no certificate, or finds better ones.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline bool prove_globally(DepthSearch<T, D> &search) noexcept
{
    for (int i = 0; i < max_depth_minima; ++i) {
        auto const proof = prove_once(search);
        if (proof != DepthProof::better) return proof == DepthProof::complete;
        auto minimum = follow_normal(search, search.direction);
        if (!minimum.converged) {
            descend(search, search.best.ratio);
            minimum = follow_normal(search, search.direction);
        }
        if (find_certified(search, minimum)) return true;
    }
    return false;
}

/// Computes penetration() of a valid pair that overlaps and is in range, from t of start_depth().
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_from(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2, T const &t) noexcept
{
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    if (!find_certified(search, descend_from_touching(search, t)) && !prove_globally(search))
        return no_penetration<T, D>(StatusCode::no_convergence);
    return {maximum(T(0), search.best.length), search.direction, StatusCode::success};
}

/// Computes penetration() of a valid pair in range that seems to overlap, and decides whether it
/// does. A certificate of a positive depth proves it: no direction separates the ellipsoids. A
/// direction that separates them disproves it. For pairs near contact, this decision takes less
/// time than the overlap test.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_if_decided(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                       SymmetricMatrix<T, D> const &q2, T const &t, Decision &decision) noexcept
{
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    bool const certified = find_certified(search, descend_from_touching(search, t));
    auto const &[length, ratio, rounding] = search.best;
    decision = to_decision(length < T(-2) * rounding, certified && length > T(2) * rounding);
    if (decision == Decision::apart) return no_penetration<T, D>(StatusCode::success);
    return {length, search.direction, StatusCode::success};
}

template <class T, int D> PW85_FUNCTION inline Penetration<T, D>
penetration_in_range(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                     SymmetricMatrix<T, D> const &q2) noexcept
{
    return penetration_from(r12, q1, q2, start_depth(r12, q1, q2).t);
}

/// Computes penetration() of a valid pair that overlaps. A pair of similar sizes is scaled to sizes
/// of order one; its results are bitwise equal to those of a pair that needs no scaling. Otherwise
/// the larger ellipsoid is scaled to size 2^headroom, which keeps cQ1 and Q2/c in range for any
/// aspect ratio. A smaller ellipsoid that would leave the range is made larger. This change is far
/// below rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int limit = std::numeric_limits<T>::max_exponent, headroom = limit / 5 * 2,
                  least = 16 - limit / 2;
    T const size1 = largest_diagonal(q1), size2 = largest_diagonal(q2);
    if (is_in_range(T(1), size1, size2)) return penetration_in_range(r12, q1, q2);
    Unit const own1 = unit_of(q1), own2 = unit_of(q2), larger = larger_of(own1, own2);
    bool const alike = is_in_range(T(1), larger.to_local(size1, 2), larger.to_local(size2, 2));
    Unit const unit = alike ? larger : larger / Unit{headroom};
    auto result =
        penetration_in_range(unit.to_local(r12), smaller_of(unit, own1 / Unit{least}).to_local(q1),
                             smaller_of(unit, own2 / Unit{least}).to_local(q2));
    result.depth = unit.to_caller(result.depth);
    return result;
}

/// The result of penetration(), and whether the ellipsoids are apart.
template <class T, int D> struct FoundDepth {
    Penetration<T, D> result;
    bool apart;
};

template <class T, int D> PW85_FUNCTION inline FoundDepth<T, D>
find_depth(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
           SymmetricMatrix<T, D> const &q2, DepthStart<T> const &start) noexcept
{
    if (start.decision == Decision::overlap) return {penetration_from(r12, q1, q2, start.t), false};
    if (start.decision == Decision::apart) return {no_penetration<T, D>(StatusCode::success), true};
    if (start.t > T(0)) {
        auto decision = Decision::none;
        auto const result = penetration_if_decided(r12, q1, q2, start.t, decision);
        if (decision != Decision::none) return {result, decision == Decision::apart};
    }
    Overlap const decision = call_overlap(r12, q1, q2);
    if (decision.overlap) return {penetration_overlapping(r12, q1, q2), false};
    return {no_penetration<T, D>(decision.status), decision.status == StatusCode::success};
}

template <class T, int D>
PW85_FUNCTION inline FoundDepth<T, D> find_depth(Vector<T, D> const &r12,
                                                 SymmetricMatrix<T, D> const &q1,
                                                 SymmetricMatrix<T, D> const &q2) noexcept
{
    return find_depth(r12, q1, q2, start_depth(r12, q1, q2));
}

} // namespace pw85::detail

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids.
template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> penetration(Vector<T, D> const &r12,
                                                   SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2) noexcept
{
    return detail::find_depth(r12, q1, q2).result;
}

} // namespace pw85

#endif
