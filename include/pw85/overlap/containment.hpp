// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tests whether one ellipsoid is inside another one. Floating-point numbers decide first, with
/// margins for their rounding errors. Integers decide the remaining pairs (exact_containment.hpp).
///
/// - Ellipsoid 2 is not inside if √(nᵀQ2n) + |n·r| > √(nᵀQ1n) for some n. It then extends beyond a
///   tangent plane of ellipsoid 1.
/// - Ellipsoid 2 is inside if K(w) = Q1 - (1 + 1/w) Q2 - (1 + w) r rᵀ is positive semidefinite for
///   some w > 0 (exact_containment.hpp).
///
/// At internal tangency both conditions reach their limits, at one w and one n only. Let M = Q1 -
/// Q2 - Q2/w, n = M⁻¹r, d = r·n and e = nᵀQ2n. This w maximises 1 - (1 + w) d, which has one
/// maximum in the range where M is positive definite. At the maximum F = w² d/((1 + w) e) is 1. F
/// increases with w.
#ifndef PW85_OVERLAP_CONTAINMENT_HPP_INCLUDED
#define PW85_OVERLAP_CONTAINMENT_HPP_INCLUDED

#include <pw85/contact/scaling.hpp>
#include <pw85/overlap/exact_containment.hpp>

namespace pw85 {

/// True if one ellipsoid is inside another one. It is false if the status is not success.
struct Containment {
    bool contains;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Decision that floating-point numbers prove for a pair.
enum class ContainmentDecision { none, outside, inside };

/// A bound on the errors of exceeds(), in units of u: the roundings of both sides of each
/// comparison, and one for terms of second order. Theorem `nesting` of tests/bounds/proofs.cpp
/// takes the counts for this margin and the next three from the code.
inline constexpr int exceeds_margin = 8;

/// Returns whether √q2 + r > √q1, for an upper bound q1, a normal number, and lower bounds q2 and
/// r, which are not negative. No square root is needed: with g = q1 - q2 - r² the condition is
/// g < 0 or 4 r² q2 > g².
///
/// 1. The computed g exceeds the exact one by u q1 or more if the exact one is not negative. Then
///    q2 + r² <= q1. The roundings take less than 6 u q1 of the 8 u q1 that `grow` adds, and
///    underflow of r² takes less than u q1.
/// 2. The other comparison has as few roundings, and `grow` exceeds them, too.
/// 3. Let m be the smallest normal number. Underflow of r² changes 4 r² q2 by less than 5 u m q1.
///    This is below the u² q1² by which the computed g² exceeds the exact one if q1 > 8 m/u. If
///    not, the computed 4 r² q2 is zero.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
exceeds(T const &q1, T const &q2, T const &r) noexcept
{
    T const grow = T(1) + T(exceeds_margin * unit_roundoff<T>()), square = T(r * r);
    T const g = T(grow * q1) - T(q2 + square);
    return g < T(0) || T(T(T(4) * square) * q2) > T(T(grow * g) * g);
}

/// Returns whether ellipsoid 2 reaches beyond the bounding box of ellipsoid 1.
template <class T, int D>
PW85_FUNCTION inline bool exceeds_bounding_box(Pair<T, D> const &pair) noexcept
{
    bool exceeded = false;
    for (int i = 0; i < D; ++i)
        exceeded |= exceeds(pair.q1(i, i), pair.q2(i, i), absolute(pair.r12[i]));
    return exceeded;
}

/// Tests whether each ellipsoid certainly exceeds the bounding box of the other one. Then neither
/// is inside the other one. The pair must be in the range in which exceeds() holds.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
exceed_each_other(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                  SymmetricMatrix<T, D> const &q2) noexcept
{
    T distance = absolute(r12[0]);
    auto first = exceeds(q2(0, 0), q1(0, 0), distance),
         second = exceeds(q1(0, 0), q2(0, 0), distance);
    for (int i = 1; i < D; ++i) {
        distance = absolute(r12[i]);
        first = first || exceeds(q2(i, i), q1(i, i), distance);
        second = second || exceeds(q1(i, i), q2(i, i), distance);
    }
    return first && second;
}

/// Bounds on the errors of nᵀQn and of n·r, in units of u times the sum of the magnitudes of their
/// terms.
inline constexpr int nested_form_margin = 8, nested_product_margin = 6;

/// Returns whether a direction n proves that ellipsoid 2 is not inside.
///
/// The margins bound the roundings of the terms, and that of the sum with the margin. The
/// magnitudes of the terms of nᵀQn add up to (Σ |ni| √Qii)² at most, which is at most D Σ Qii ni².
/// `tiny` is far above the errors of underflow, because the entries of the forms are at most 2^24.
/// Nothing overflows: as ellipsoid 2 is in the bounding box, the directions of decide_containment()
/// are below 2^64.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
shows_outside(Pair<T, D> const &pair, Vector<T, D> const &n) noexcept
{
    T const tiny = T(smallest_number<T>() * T(T(1) + largest_coordinate(n)));
    T const form_error = T(nested_form_margin * D * unit_roundoff<T>());
    T const product_error = T(nested_product_margin * unit_roundoff<T>());
    T sum1 = T(0), sum2 = T(0);
    for (int i = 0; i < D; ++i) {
        T const square = T(n[i] * n[i]);
        sum1 = sum1 + T(square * pair.q1(i, i));
        sum2 = sum2 + T(square * pair.q2(i, i));
    }
    T const r =
        absolute(dot(n, pair.r12)) - T(T(product_error * magnitude_of_dot(n, pair.r12)) + tiny);
    T const q1 = quadratic_form(pair.q1, n) + T(T(form_error * sum1) + tiny);
    T const q2 = quadratic_form(pair.q2, n) - T(T(form_error * sum2) + tiny);
    return exceeds(q1, maximum(q2, T(0)), maximum(r, T(0)));
}

/// The share of the diagonal of Q1 that bounds the errors of K(w), in units of u.
inline constexpr int inside_margin = 32;

/// K(w) in the first lanes, with a smaller diagonal, and M in the second lanes. If K(w) is clearly
/// definite and u <= w <= 1/u, ellipsoid 2 is inside. Errors of underflow do not matter then.
///
/// Let C = (1 + 1/w) Q2 + (1 + w) r rᵀ, with non-negative terms. The magnitudes of the terms of an
/// entry of C add up to √(Cii Cjj) at most. If the diagonal of K is positive, Cii <= Q1ii. So no
/// entry of K errs by more than 7 u √(Q1ii Q1jj): 4 u for C, up to 2 u for the difference, and on
/// the diagonal u or 2 u for the product with `shrink`. A matrix of such errors is at most 7 D u
/// diag(Q1). This is less than the part of the diagonal that `shrink` removes.
template <class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<TwoLanes<T>, D>
inner_matrices(Pair<T, D> const &pair, T const &w) noexcept
{
    using Two = TwoLanes<T>;
    T const share2 = T(1) + T(1) / w;
    Two const share_r(T(1) + w, T(0)), shrink(T(1) - T(inside_margin * unit_roundoff<T>()), T(1));
    SymmetricMatrix<Two, D> k{};
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
            Two const q1(pair.q1(i, j));
            k(i, j) =
                (i == j ? shrink * q1 : q1) -
                (Two(T(share2 * pair.q2(i, j))) + (share_r * Two(pair.r12[i])) * Two(pair.r12[j]));
        }
    return k;
}

/// A direction n in which nᵀAn is not positive. The first entry of A is positive, and one of its
/// leading minors is not positive. Up to a positive factor, nᵀAn is the first such minor.
template <class T>
PW85_FUNCTION inline Vector<T, 2> negative_direction(SymmetricMatrix<T, 2> const &a) noexcept
{
    return {-a(0, 1), a(0, 0)};
}

template <class T>
PW85_FUNCTION inline Vector<T, 3> negative_direction(SymmetricMatrix<T, 3> const &a) noexcept
{
    auto const adj = adjugate(a);
    if (adj(2, 2) <= T(0)) return {-a(0, 1), a(0, 0), T(0)};
    return {adj(0, 2), adj(1, 2), adj(2, 2)};
}

/// Result of the search at w.
template <class T> struct NestingStep {
    T excess; ///< 1 - 1/F; positive if w is above the best one
    T next;   ///< the next w by Newton's method
};

/// Computes the values at w from the adjugate of M and factor = 1/det M, by M' = Q2/w², d' = -e/w²
/// and e' = -2 nᵀQ2M⁻¹Q2n/w². So w F'/F = 1 + 1/(1 + w) - e/(w d) + 2 nᵀQ2M⁻¹Q2n/(w e).
template <class T, int D>
PW85_FUNCTION inline NestingStep<T> take_nesting_step(Pair<T, D> const &pair,
                                                      SymmetricMatrix<T, D> const &adj,
                                                      T const &factor, T const &w) noexcept
{
    Vector<T, D> const n = factor * product(adj, pair.r12), q2n = product(pair.q2, n);
    T const d = dot(pair.r12, n), e = dot(n, q2n), curvature = T(factor * quadratic_form(adj, q2n));
    T const excess = T(1) - T(T(T(1) + w) * e) / T(T(w * w) * d);
    T const slope = T(1) + T(1) / T(T(1) + w) - e / T(w * d) + T(T(2) * curvature) / T(w * e);
    return {excess, T(w - T(w * excess) / slope)};
}

/// The number of steps after which the search gives up. Let κ be the factor by which ellipsoid 1
/// must be scaled to touch ellipsoid 2. Of random pairs with |κ² - 1| from 1e-2 to 1e-12 and aspect
/// ratios from 2 to 1000, one in a thousand needs more than eight steps. Integers decide the rest.
/// For types without integers the search continues until its bracket is as small as rounding
/// errors.
template <class T> PW85_FUNCTION constexpr int max_nesting_steps() noexcept
{
    return exact::is_decidable<T> ? 16 : 8 * mantissa_digits<T>();
}

/// The matrix in the second lanes.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, D>
second_lanes(SymmetricMatrix<TwoLanes<T>, D> const &a) noexcept
{
    SymmetricMatrix<T, D> second{};
    for (int k = 0; k < a.size; ++k) second[k] = second_of(a[k]);
    return second;
}

/// The search for a proof. It uses Newton's method on F(w) = 1, in a bracket.
template <class T, int D> PW85_FUNCTION inline ContainmentDecision
search_for_containment(Pair<T, D> const &pair, T w) noexcept
{
    T low = T(0), high = infinity<T>();
    for (int step = 0; step < max_nesting_steps<T>(); ++step) {
        auto const matrices = inner_matrices(pair, w), adjugates = adjugate(matrices);
        auto const definite = is_clearly_definite(matrices, adjugates);
        if (all_of(definite) && w >= T(unit_roundoff<T>()) && T(w * T(unit_roundoff<T>())) <= T(1))
            return ContainmentDecision::inside;
        T next = low;
        if (any_of(definite)) {
            auto const adj = second_lanes(adjugates);
            if (shows_outside(pair, product(adj, pair.r12))) return ContainmentDecision::outside;
            auto const found = take_nesting_step(
                pair, adj, T(T(1) / second_of(determinant(matrices, adjugates))), w);
            (found.excess > T(0) ? high : low) = w;
            next = found.next;
        } else
            low = w;
        if (!(next > low && next < high))
            next = high < infinity<T>() ? T(T(0.5) * T(low + high)) : T(T(2) * low);
        if (absolute(T(next - w)) <= T(T(4) * T(unit_roundoff<T>())) * w) break;
        w = next;
    }
    return ContainmentDecision::none;
}

/// The decision by floating-point numbers. The search for a proof starts at the larger of two
/// values: the w at which two balls with the extents along r would touch, to 10 %, and the trace of
/// (Q1 - Q2)⁻¹Q2. M is positive definite there.
template <class T, int D>
PW85_FUNCTION inline ContainmentDecision decide_containment(Pair<T, D> const &pair) noexcept
{
    if (exceeds_bounding_box(pair)) return ContainmentDecision::outside;
    T const u = T(unit_roundoff<T>());
    SymmetricMatrix<T, D> difference = pair.q1;
    for (int k = 0; k < difference.size; ++k) difference[k] = difference[k] - pair.q2[k];
    if (!is_clearly_definite(difference)) {
        bool const outside = shows_outside(pair, negative_direction(difference));
        return outside ? ContainmentDecision::outside : ContainmentDecision::none;
    }
    auto const adj = adjugate(difference);
    T const r2 = dot(pair.r12, pair.r12),
            trace = contraction(adj, pair.q2) / determinant(difference, adj);
    T const extent = coarse_root_of_ratio(quadratic_form(pair.q2, pair.r12), T(r2 * r2));
    T const largest = T(1) / u, start = maximum(u, maximum(trace, extent));
    if (r2 > T(0) && start < largest) return search_for_containment(pair, start);
    auto const matrices = inner_matrices(pair, largest);
    return all_of(is_clearly_definite(matrices, adjugate(matrices))) ? ContainmentDecision::inside
                                                                     : ContainmentDecision::none;
}

/// The decision for any pair, in the unit of ellipsoid 1. A number that becomes subnormal errs by
/// 2^-53 of the smallest number, for double.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline ContainmentDecision
decide_containment_scaled(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                          SymmetricMatrix<T, D> const &q2) noexcept
{
    Unit const unit = unit_of(q1);
    return decide_containment(pair_of(unit.to_local(r12), unit.to_local(q1), unit.to_local(q2)));
}

template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline StatusCode
validate_apart(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
               SymmetricMatrix<T, D> const &q2) noexcept
{
    ScaledPair<T, D> scaled;
    return validate_pair(pair_of(r12, q1, q2), scaled);
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Containment contains(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, q1, q2);
    bool const in_range = passes_fast_checks(pair);
    StatusCode const status = in_range ? StatusCode::success : validate_apart(r12, q1, q2);
    if (status != StatusCode::success) return {false, status};
    ContainmentDecision const nesting =
        in_range ? decide_containment(pair) : decide_containment_scaled(r12, q1, q2);
    if (nesting != ContainmentDecision::none)
        return {nesting == ContainmentDecision::inside, status};
    if constexpr (exact::is_decidable<T>)
        return {contains_exactly(r12, q1, q2), status};
    else
        return {true, status}; // they touch to rounding
}

} // namespace pw85

namespace pw85::detail {

/// contains() for functions that call it first. It is not inlined there.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Containment
call_contains(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
              SymmetricMatrix<T, D> const &q2) noexcept
{
    return contains(r12, q1, q2);
}

PW85_SHARED_BY_QUESTIONS(call_contains)

} // namespace pw85::detail

#endif
