/// @file
/// Whether one ellipsoid is inside another one. pw85.hpp and the C API use this file. Floating-point numbers decide first, with
/// margins for their rounding errors. Integers decide the remaining pairs (exact_containment.hpp).
///
/// - Ellipsoid 2 is outside if √(nᵀQ2n) + |n·r| > √(nᵀQ1n) for some n. Then it reaches beyond a plane that bounds ellipsoid 1.
/// - Ellipsoid 2 is inside if K(w) = Q1 - (1 + 1/w) Q2 - (1 + w) r rᵀ is positive semidefinite for some w > 0
///   (exact_containment.hpp).
///
/// At internal tangency both conditions reach their limits, at one w and one n only. Let M = Q1 - Q2 - Q2/w, n = M⁻¹r, d = r·n and
/// e = nᵀQ2n. This w maximises 1 - (1 + w) d, which has one maximum in the range where M is positive definite. At the maximum
/// F = w² d/((1 + w) e) is 1. F increases with w.
#ifndef PW85_OVERLAP_CONTAINMENT_HPP_INCLUDED
#define PW85_OVERLAP_CONTAINMENT_HPP_INCLUDED

#include <pw85/contact/validate.hpp>
#include <pw85/overlap/exact_containment.hpp>

namespace pw85 {

/// Whether one ellipsoid is inside another one. It is false if the status is not success.
struct Containment {
    bool contains;
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// What floating-point numbers prove about a pair.
enum class Nesting { none, outside, inside };

/// A pair with the difference Q1 - Q2. The unit is such that the largest diagonal entry of Q1 is in [1, 4).
template <class T, int D> struct NestedPair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2, difference;
};

/// Scales a pair by a power of two. A number that becomes subnormal errs by 2^-53 of the smallest number, for double.
template <class T, int D> PW85_FUNCTION inline NestedPair<T, D> nested_pair(Pair<T, D> const &pair) noexcept
{
    int const e = half_exponent(largest_diagonal(pair.q1));
    NestedPair<T, D> nested{
        times_power_of_two(pair.r12, -e), times_power_of_two(pair.q1, -2 * e), times_power_of_two(pair.q2, -2 * e), {}};
    for (int k = 0; k < pair.q1.size; ++k) nested.difference[k] = nested.q1[k] - nested.q2[k];
    return nested;
}

/// Whether ellipsoid 2 reaches beyond the bounding box of ellipsoid 1. The five roundings, and those of the comparison, are below 8
/// u in all.
template <class T, int D> PW85_FUNCTION inline bool exceeds_bounding_box(Pair<T, D> const &pair) noexcept
{
    T const shrink = T(1) - T(8) * T(unit_roundoff<T>());
    bool exceeds = false;
    for (int i = 0; i < D; ++i) {
        T const reach = square_root(pair.q2(i, i)) + absolute(pair.r12[i]);
        exceeds = exceeds || T(shrink * reach) > square_root(pair.q1(i, i));
    }
    return exceeds;
}

/// Whether a direction n, of any length > 0, proves that ellipsoid 2 is not inside.
///
/// A term of a form is rounded five times at most, and a term of n·r three times (theorem `counts` of tests/bounds/proofs.cpp). The
/// sums with the margins are rounded once more.
/// So the margins 8 u and 6 u, times the sums of magnitudes, bound these errors. A further 8 u bounds those of the two roots, their
/// sum and the product. The smallest number is far above the errors of underflow, because n has coordinates below 2 and the forms
/// have entries of 4 at most.
template <class T, int D> PW85_FUNCTION inline bool shows_outside(NestedPair<T, D> const &pair, Vector<T, D> n) noexcept
{
    T const u = T(unit_roundoff<T>()), tiny = smallest_number<T>(), length = largest_coordinate(n);
    if (!(length > T(0) && length < largest_number<T>())) return false;
    n = times_power_of_two(n, -binary_exponent(length));
    T const r = absolute(dot(n, pair.r12)) - T(T(6) * u * magnitude_of_dot(n, pair.r12) + tiny);
    T const q1 = quadratic_form(pair.q1, n) + T(T(8) * u * magnitude_of_form(pair.q1, n) + tiny);
    T const q2 = quadratic_form(pair.q2, n) - T(T(8) * u * magnitude_of_form(pair.q2, n) + tiny);
    T const reach = square_root(maximum(q2, T(0))) + maximum(r, T(0));
    return T(T(T(1) - T(8) * u) * reach) > square_root(q1);
}

/// Whether w proves that ellipsoid 2 is inside. Errors of underflow do not matter, because u <= w <= 1/u.
///
/// Let C = (1 + 1/w) Q2 + (1 + w) r rᵀ, with non-negative terms. The magnitudes of the terms of an entry of C add up to √(Cii Cjj)
/// at most. If the diagonal of K is positive, Cii <= Q1ii. So no entry of K errs by more than 7 u √(Q1ii Q1jj): 4 u for C, u for
/// the difference, and on the diagonal u for the product. A matrix of such errors is at most 21 u diag(Q1). This is less than the
/// part of the diagonal that `shrink` removes.
template <class T, int D> PW85_FUNCTION inline bool shows_inside(NestedPair<T, D> const &pair, T const &w) noexcept
{
    T const u = T(unit_roundoff<T>()), share2 = T(1) + T(1) / w, share_r = T(1) + w, shrink = T(1) - T(32) * u;
    SymmetricMatrix<T, D> k{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
            T const cover = T(share2 * pair.q2(i, j)) + T(T(share_r * pair.r12[i]) * pair.r12[j]);
            k(i, j) = (i == j ? T(shrink * pair.q1(i, j)) : pair.q1(i, j)) - cover;
        }
    return w >= u && T(w * u) <= T(1) && is_clearly_definite(k);
}

/// A direction n in which nᵀAn is not positive. The first entry of A is positive, and one of its leading minors is not positive. Up
/// to a positive factor, nᵀAn is the first such minor.
template <class T> PW85_FUNCTION inline Vector<T, 2> negative_direction(SymmetricMatrix<T, 2> const &a) noexcept
{
    return {-a(0, 1), a(0, 0)};
}

template <class T> PW85_FUNCTION inline Vector<T, 3> negative_direction(SymmetricMatrix<T, 3> const &a) noexcept
{
    auto const adj = adjugate(a);
    if (adj(2, 2) <= T(0)) return {-a(0, 1), a(0, 0), T(0)};
    return {adj(0, 2), adj(1, 2), adj(2, 2)};
}

/// The values that the search computes at w.
template <class T, int D> struct NestingStep {
    Vector<T, D> n;
    T excess; ///< 1 - 1/F; positive if w is above the best one
    T next;   ///< the next w by Newton's method
};

/// Computes the values at w, by M' = Q2/w², d' = -e/w² and e' = -2 nᵀQ2M⁻¹Q2n/w². So w F'/F = 1 + 1/(1 + w) - e/(w d) + 2
/// nᵀQ2M⁻¹Q2n/(w e).
template <class T, int D> PW85_FUNCTION inline NestingStep<T, D>
take_nesting_step(NestedPair<T, D> const &pair, SymmetricMatrix<T, D> const &m, T const &w) noexcept
{
    auto const adj = adjugate(m);
    T const factor = T(1) / determinant(m, adj);
    Vector<T, D> const n = factor * product(adj, pair.r12), q2n = product(pair.q2, n);
    T const d = dot(pair.r12, n), e = dot(n, q2n), curvature = T(factor * quadratic_form(adj, q2n));
    T const excess = T(1) - T(T(T(1) + w) * e) / T(T(w * w) * d);
    T const slope = T(1) + T(1) / T(T(1) + w) - e / T(w * d) + T(T(2) * curvature) / T(w * e);
    return {n, excess, T(w - T(w * excess) / slope)};
}

/// The number of steps after which the search gives up. Let κ be the factor by which ellipsoid 1 must be scaled to touch ellipsoid
/// 2. Of random pairs with |κ² - 1| from 1e-2 to 1e-12 and aspect ratios from 2 to 1000, one in a thousand needs more than eight
/// steps.
inline constexpr int max_nesting_steps = 16;

/// The search for a proof. It uses Newton's method on F(w) = 1, in a bracket.
template <class T, int D> PW85_FUNCTION inline Nesting search_for_nesting(NestedPair<T, D> const &pair, T w) noexcept
{
    T low = T(0), high = infinity<T>();
    for (int step = 0; step < max_nesting_steps; ++step) {
        if (shows_inside(pair, w)) return Nesting::inside;
        SymmetricMatrix<T, D> m = pair.difference;
        for (int k = 0; k < m.size; ++k) m[k] = m[k] - T(pair.q2[k] / w);
        T next = low;
        if (is_clearly_definite(m)) {
            auto const found = take_nesting_step(pair, m, w);
            if (shows_outside(pair, found.n)) return Nesting::outside;
            (found.excess > T(0) ? high : low) = w;
            next = found.next;
        } else
            low = w;
        if (!(next > low && next < high)) next = high < infinity<T>() ? T(T(0.5) * T(low + high)) : T(T(2) * low);
        if (absolute(T(next - w)) <= T(T(4) * T(unit_roundoff<T>())) * w) break;
        w = next;
    }
    return Nesting::none;
}

/// The decision by floating-point numbers. The search starts at the larger of two values: the w at which two balls with the extents
/// along r would touch, and the trace of (Q1 - Q2)⁻¹Q2. M is positive definite there.
template <class T, int D> PW85_FUNCTION inline Nesting decide_nesting(NestedPair<T, D> const &pair) noexcept
{
    T const u = T(unit_roundoff<T>());
    if (!is_clearly_definite(pair.difference)) {
        bool const outside = shows_outside(pair, negative_direction(pair.difference));
        return outside ? Nesting::outside : Nesting::none;
    }
    auto const adj = adjugate(pair.difference);
    T const r2 = dot(pair.r12, pair.r12), trace = contraction(adj, pair.q2) / determinant(pair.difference, adj);
    T const extent = square_root(quadratic_form(pair.q2, pair.r12)) / r2;
    T const largest = T(1) / u, start = maximum(u, maximum(trace, extent));
    if (r2 > T(0) && start < largest) return search_for_nesting(pair, start);
    return shows_inside(pair, largest) ? Nesting::inside : Nesting::none;
}

template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Status validate_apart(Pair<T, D> pair) noexcept
{
    ScaledPair<T, D> scaled;
    return validate(pair, scaled);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Containment
contains(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    Status const status = passes_fast_checks(pair) ? Status::success : validate_apart(pair);
    if (status != Status::success) return {false, status};
    if (exceeds_bounding_box(pair)) return {false, status};
    Nesting const nesting = decide_nesting(nested_pair(pair));
    if (nesting != Nesting::none) return {nesting == Nesting::inside, status};
    if constexpr (exact::is_decidable<T>)
        return {contains_exactly(r12, q1, q2), status};
    else
        return {true, status}; // they touch to rounding
}

} // namespace pw85

#endif
