// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sign of μ² - m in n dimensions, for the numbers exactly as given. With m = 1 it decides
/// whether two ellipsoids overlap. Floating-point numbers decide if a vector s proves the answer,
/// in double precision and then with twice the digits. Integers decide the rest (exact_sign.hpp).
///
/// Let √m Q be the ellipsoid of the form m Q. For any vector s and any t > 0, with A = sᵀQ1s and
/// B = sᵀQ2s:
///
/// 1. sᵀr12 > √m (√A + √B) proves that √m Q1 and √m Q2 are apart: a slab across s separates them.
/// 2. With the residual ρ = r12 - (Q1 + t Q2) s, the point x = Q1 s + ρ satisfies r12 - x = t Q2 s.
///    So √A + √(ρᵀQ1⁻¹ρ) < √m and t √B < √m prove that x is inside both.
///
/// No step depends on how well s solves an equation. The bounds on rounding errors count the
/// operations of product() and dot(), whose terms are at most √(q_ii q_jj) |s_i s_j|: their sum is
/// at most n Σ q_ii s_i². If Q1 - 2c diag(Q1) has positive pivots, ρᵀQ1⁻¹ρ <= Σ ρ_i²/(c q_ii).
#ifndef PW85_ANY_DIMENSION_OVERLAP_HPP_INCLUDED
#define PW85_ANY_DIMENSION_OVERLAP_HPP_INCLUDED

#include <pw85/any_dimension/contact.hpp>
#include <pw85/overlap/decision.hpp>

namespace pw85 {

/// The sign of μ² - m. It is meaningless if the status is not success.
struct NdComparison {
    int sign;
    StatusCode status;
};

/// The answer of nd_overlap(). It is meaningless if the status is not success.
struct NdOverlap {
    bool overlap;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail::any_dimension {

/// sᵀQs rounded up: product() and dot() make up to 5n/4 + 9 operations on a term, and the bound
/// itself n + 3.
template <class T>
PW85_FUNCTION inline T form_above(int n, T const *q, T const *s, T const *qs) noexcept
{
    return dot(n, s, qs) + T(n * (3 * n + 12)) * operation_error<T>() * diagonal_form(n, q, s);
}

/// Returns ρᵀQ1⁻¹ρ rounded up, for c = shift/2. It is NaN if Q1 does not allow this shift.
template <class T> PW85_FUNCTION inline T residual_above(Pair<T> const &pair, T const &t,
                                                         T const &shift, Evaluation<T> &at) noexcept
{
    int const n = pair.n;
    T const error = T(2 * n + 16) * operation_error<T>();
    T const width1 = square_root(T(n) * diagonal_form(n, pair.q1, at.s)),
            width2 = t * square_root(T(n) * diagonal_form(n, pair.q2, at.s));
    T sum = T(0);
    for (int i = 0; i < n; ++i) {
        T const q1 = pair.q1[packed_index(n, i, i)], q2 = pair.q2[packed_index(n, i, i)];
        T const terms = absolute(pair.r12[i]) + square_root(q1) * width1 + square_root(q2) * width2;
        T const rest = absolute(T(pair.r12[i] - at.p[i] - t * at.q[i])) + error * terms;
        sum = sum + rest * rest / q1;
    }
    if (!is_definite_with_shift(n, pair.q1, shift, at.factors)) return quiet_nan<T>();
    return T(2.5) * sum / shift; // the factor is 2, enlarged for rounding errors
}

/// Decides by s at t of an evaluation. Overwrites the factors.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline Decision
decide_at(Pair<T> const &pair, T const &t, T const &m, Evaluation<T> &at) noexcept
{
    int const n = pair.n;
    T const w = operation_error<T>(), root = square_root(m);
    T const a = square_root(form_above(n, pair.q1, at.s, at.p)),
            b = square_root(form_above(n, pair.q2, at.s, at.q));
    T magnitude = T(0);
    for (int i = 0; i < n; ++i) magnitude = magnitude + absolute(T(pair.r12[i] * at.s[i]));
    T const along = dot(n, pair.r12, at.s) - T(n + 8) * w * magnitude;
    if (along > root * (a + b / pair.ratio) * (T(1) + T(16) * w)) return Decision::apart;
    T const limit = root * (T(1) - T(16) * w);
    if (!(a < limit) || !(pair.ratio * t * b < limit)) return Decision::none;
    for (int bits : {20, 36, 70}) {
        T const shift = T(times_power_of_two(1.0, -bits));
        if (!(shift > least_shift<T>(n))) break;
        if (a + square_root(residual_above(pair, t, shift, at)) < limit) return Decision::overlap;
    }
    return Decision::none;
}

/// Returns whether a number is so far from the limits of double that products of such numbers do
/// not underflow.
PW85_FUNCTION inline bool is_moderate(double m) noexcept { return m > 0x1p-400 && m < 0x1p400; }

/// Decides by a search in the type T and one more step. m is in the units of the pair.
template <class T> [[gnu::noinline]] PW85_FUNCTION inline Decision
decide_in(Input const &in, Units const &units, double m, Workspace<T> &work) noexcept
{
    auto &pair = work.pair;
    auto &at = work.at;
    scale(in, units, pair);
    if (!is_moderate(m) || !keep_digits(in, units)) return Decision::none;
    Candidate<T> candidate = start(pair, at);
    int evaluations = 0;
    if (!search(pair, candidate, at, evaluations)) return Decision::none;
    for (int i = 0; i < 2; ++i) {
        T const t = candidate.t;
        if (!evaluate(pair, t, at)) return Decision::none;
        Jet<T> const jet = jet_of(pair, t, at);
        Slope<T> const s = slope(jet, pair.ratio, t);
        Decision const decision = decide_at(pair, t, T(m), at);
        if (decision != Decision::none || !is_near(s)) return decision;
        candidate.t = t * exponential(halley_step(s));
    }
    return Decision::none;
}

/// Returns the sign of μ² - m for a valid pair with r12 != 0 and a finite m > 0, or sign_unknown.
PW85_FUNCTION inline int sign_of_difference(Input const &in, double m) noexcept
{
    Units const units = units_of(in);
    double const scaled = units.mu().to_local(m, 2);
    auto const decide = [&](auto &work) { return decide_in(in, units, scaled, work); };
    Decision decision = with_workspace(decide);
    if constexpr (FLT_EVAL_METHOD == 0)
        if (decision == Decision::none) decision = with_wide_workspace(decide);
    if (decision == Decision::none) return compare_exactly(in, m);
    return decision == Decision::apart ? 1 : -1;
}

} // namespace pw85::detail::any_dimension

namespace pw85 {

/// Returns the sign of μ² - m in n dimensions, exactly; see nd_contact().
PW85_FUNCTION inline NdComparison nd_compare(int n, double const *r12, double const *q1,
                                             double const *q2, double m) noexcept
{
    using namespace detail;
    any_dimension::Input const in{n, r12, q1, q2};
    if (!(m >= 0.0)) return {0, StatusCode::invalid_argument};
    StatusCode const status = any_dimension::status_of(in);
    if (status != StatusCode::success) return {0, status};
    if (any_dimension::largest_magnitude(n, r12) == 0.0) return {m > 0.0 ? -1 : 0, status};
    if (m == 0.0 || m > largest_number<double>()) return {m == 0.0 ? 1 : -1, status};
    int const sign = any_dimension::sign_of_difference(in, m);
    return sign == any_dimension::sign_unknown ? NdComparison{0, StatusCode::out_of_memory}
                                               : NdComparison{sign, status};
}

/// Decides exactly if two ellipsoids overlap in n dimensions; see nd_contact(). Ellipsoids that
/// touch do not.
PW85_FUNCTION inline NdOverlap nd_overlap(int n, double const *r12, double const *q1,
                                          double const *q2) noexcept
{
    auto const comparison = nd_compare(n, r12, q1, q2, 1.0);
    return {comparison.sign < 0, comparison.status};
}

} // namespace pw85

#endif
