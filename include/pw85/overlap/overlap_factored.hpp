// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The overlap test of ellipsoids that are given by factors, Qi = Si Siᵀ. pw85.hpp and the C API
/// use this file. The answer is that of exact arithmetic for the exact products of the factors.
///
/// 1. The ellipsoids are apart if r12ᵀs > |S1ᵀs| + |S2ᵀs| for some vector s, because |Siᵀs| is the
///    half-width of ellipsoid i along s.
/// 2. They overlap if r12 = S1 w1 + S2 w2 with |w1| < 1 and |w2| < 1, because S1 w1 is then a point
///    inside both. It suffices that r12 = S1 w1 + S2 w2 + e with |wi| + |Si⁻¹e| < 1 for both, as e
///    can be added to either w.
///
/// Any s, w1 and w2 are proofs, if the inequalities hold with bounds on the rounding errors. Good
/// ones are s = M⁻¹r12, w1 = α S1ᵀs and w2 = β S2ᵀs with M = α Q1 + β Q2, near the maximum of f.
/// Three points are tried: the start of the search on the rounded forms, its end, and the maximum
/// for the factors. Then integers decide (exact_factored.hpp).
#ifndef PW85_OVERLAP_OVERLAP_FACTORED_HPP_INCLUDED
#define PW85_OVERLAP_OVERLAP_FACTORED_HPP_INCLUDED

#include <pw85/contact/contact_factored.hpp>
#include <pw85/overlap/exact_factored.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85::detail {

/// Σ|S_ij x_i y_j|.
template <class T, int D> PW85_FUNCTION constexpr T
magnitude_of_form(Factor<T, D> const &s, Vector<T, D> const &x, Vector<T, D> const &y) noexcept
{
    T sum = T(0);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) sum = sum + absolute(T(s(i, j) * x[i] * y[j]));
    return sum;
}

/// The vector whose coordinates are 1.
template <class T, int D> PW85_FUNCTION constexpr Vector<T, D> ones() noexcept
{
    Vector<T, D> x{};
    for (int i = 0; i < D; ++i) x[i] = T(1);
    return x;
}

/// A bound on the error of r12ᵀs - |S1ᵀs| - |S2ᵀs|, in units of u (Σ|r_i s_i| + Σ|S1_ij s_i| +
/// Σ|S2_ij s_i|). To first order it is 8: three roundings in each scalar product, and not more than
/// five in the two lengths, their sum and the difference.
inline constexpr int separation_margin = 10;

/// Returns whether s proves that the ellipsoids are apart (item 1).
template <class T, int D>
PW85_FUNCTION inline bool separates(FactoredPair<T, D> const &pair, Vector<T, D> const &s,
                                    Vector<T, D> const &first, Vector<T, D> const &second) noexcept
{
    auto const one = ones<T, D>();
    T const sum = magnitude_of_dot(pair.r12, s) + magnitude_of_form(pair.q1, s, one) +
                  magnitude_of_form(pair.q2, s, one);
    T const gap = dot(pair.r12, s) - (magnitude(first) + magnitude(second));
    return gap > T(separation_margin * unit_roundoff<T>()) * sum + smallest_number<T>();
}

/// An upper bound on |S⁻¹x|/|x|, which is at most √(Σ|(S⁻¹)_ij|²). By Cramer's rule and Hadamard's
/// inequality this root is at most √(Π|c|² Σ 1/|c|²)/|det S|, with the columns c. The computed
/// determinant of a regular factor errs by less than 15 % of itself: by 9u Π|c|, where it exceeds
/// least_volume() Π|c|. The factor 2 covers this.
template <class T, int D> PW85_FUNCTION inline T bound_on_inverse(Factor<T, D> const &s) noexcept
{
    Vector<T, D> columns[std::size_t(D)];
    T product = T(1), sum = T(0);
    for (int j = 0; j < D; ++j) {
        columns[j] = column(s, j);
        T const square = dot(columns[j], columns[j]);
        product = product * square;
        sum = sum + T(1) / square;
    }
    return T(2) * square_root(T(product * sum)) / absolute(determinant(columns));
}

/// A bound on the error of a coordinate of r12 - S1 w1 - S2 w2, in units of u times the sum of the
/// magnitudes of its terms. There are 7 terms, so to first order it is 7.
inline constexpr int residual_margin = 8;

/// Σ|e_i| for e of item 2, with a bound on its rounding errors.
template <class T, int D> PW85_FUNCTION inline T bound_on_residual(FactoredPair<T, D> const &pair,
                                                                   Vector<T, D> const &w1,
                                                                   Vector<T, D> const &w2) noexcept
{
    T total = smallest_number<T>();
    for (int i = 0; i < D; ++i) {
        T residual = pair.r12[i], sum = absolute(pair.r12[i]);
        for (int j = 0; j < D; ++j) {
            T const x = pair.q1(i, j) * w1[j], y = pair.q2(i, j) * w2[j];
            residual = (residual - x) - y;
            sum = sum + (absolute(x) + absolute(y));
        }
        total = total + (absolute(residual) + T(residual_margin * unit_roundoff<T>()) * sum);
    }
    return total;
}

/// Returns whether w1 and w2 prove that the ellipsoids overlap (item 2). The lengths and their sum
/// err by less than 16u.
template <class T, int D> PW85_FUNCTION inline bool
meet(FactoredPair<T, D> const &pair, Vector<T, D> const &w1, Vector<T, D> const &w2) noexcept
{
    T const inverse = minimum(bound_on_inverse(pair.q1), bound_on_inverse(pair.q2));
    T const longest = square_root(maximum(dot(w1, w1), dot(w2, w2)));
    return longest + inverse * bound_on_residual(pair, w1, w2) < T(1) - T(16 * unit_roundoff<T>());
}

/// Decides by s, in units in which no number that matters underflows: the entries of the larger
/// factor are of order one. So an error by underflow is far below u times the sums of magnitudes.
template <class T, int D>
PW85_FUNCTION inline Decision decide_by_direction(FactoredPair<T, D> const &pair, T const &alpha,
                                                  T const &beta, Vector<T, D> s) noexcept
{
    s = T(T(1) / largest_coordinate(s)) * s;
    Vector<T, D> const first = transposed_times(pair.q1, s), second = transposed_times(pair.q2, s);
    if (separates(pair, s, first, second)) return Decision::apart;
    T const scale = dot(pair.r12, s) / (alpha * dot(first, first) + beta * dot(second, second));
    bool const overlap = meet(pair, T(alpha * scale) * first, T(beta * scale) * second);
    return to_decision(false, overlap);
}

/// Decides by s = (Q1 + t Q2)⁻¹r12 of the rounded forms.
template <class T, int D>
PW85_FUNCTION inline Decision decide_by_rounded_forms(FactoredPair<T, D> const &pair,
                                                      Pair<T, D> const &rounded_pair,
                                                      T const &t) noexcept
{
    auto const solution = solve_by_adjugate(blend(rounded_pair.q1, t, rounded_pair.q2), pair.r12);
    return decide_by_direction(pair, T(1), t, solution.s);
}

/// Decides at the start and at the end of the search on the rounded forms.
template <class T, int D>
PW85_FUNCTION inline Decision decide_by_rounded_forms(FactoredPair<T, D> const &pair) noexcept
{
    auto const rounded_pair = rounded_forms(pair);
    Decision const decision =
        decide_by_rounded_forms(pair, rounded_pair, initial_guess(rounded_pair));
    if (decision != Decision::none) return decision;
    return decide_by_rounded_forms(pair, rounded_pair,
                                   search_rational_form(rounded_pair).candidate.t);
}

/// The pair times a power of two that brings the entries of the larger factor to order one.
template <class T, int D>
PW85_FUNCTION inline FactoredPair<T, D> in_common_units(FactoredPair<T, D> const &pair) noexcept
{
    Unit const unit = larger_of(unit_of(pair.q1), unit_of(pair.q2));
    return pair_of(unit.to_local(pair.r12), unit.to_local(pair.q1), unit.to_local(pair.q2));
}

/// Decides at the maximum of f, for any pair.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline OverlapDecision
decide_near_contact(FactoredPair<T, D> const &pair) noexcept
{
    ScaledPair<T, D, Factor<T, D>> scaled;
    StatusCode const status = validate_pair(pair, scaled);
    if (status != StatusCode::success) return {Decision::none, OverlapTier::contact, status};
    T const r = largest_coordinate(pair.r12),
            size = maximum(largest_entry(pair.q1), largest_entry(pair.q2));
    bool const distant = r / T(8) > size, concentric = !(r > T(0));
    if (distant || concentric)
        return {to_decision(distant, concentric), OverlapTier::contact, status};
    auto const m = maximize(scaled.pair);
    T const alpha = scaled.units.swapped ? m.lambda : m.complement,
            beta = scaled.units.swapped ? m.complement : m.lambda;
    auto const common = in_common_units(pair);
    auto const s = solve_blend(alpha, common.q1, beta, common.q2, common.r12).w;
    return {decide_by_direction(common, alpha, beta, s), OverlapTier::contact, status};
}

/// The last tier, for a valid pair. For multiprecision numbers it compares μ² with 1, up to
/// rounding.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Overlap
overlap_exactly(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    if constexpr (exact::is_decidable<T>) {
        Decision const decision = decide_factored_exactly(r12, s1, s2);
        return {decision == Decision::overlap, OverlapTier::exact,
                decision != Decision::none ? StatusCode::success : StatusCode::no_convergence};
    } else {
        return {contact_factored(r12, s1, s2).mu2 < T(1), OverlapTier::contact,
                StatusCode::success};
    }
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Overlap
overlap_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    using namespace detail;
    auto const pair = pair_of(r12, s1, s2);
    Decision decision = passes_fast_checks(pair) ? decide_by_rounded_forms(pair) : Decision::none;
    if (decision != Decision::none)
        return {decision == Decision::overlap, OverlapTier::contact, StatusCode::success};
    auto const near_contact = decide_near_contact(pair);
    decision = near_contact.decision;
    if (decision == Decision::none && near_contact.status == StatusCode::success)
        return overlap_exactly(r12, s1, s2);
    return {decision == Decision::overlap, near_contact.tier, near_contact.status};
}

} // namespace pw85

#endif
