// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of ellipsoids that are given by factors, Qi = Si Siᵀ. pw85.hpp and the C
/// API (src/simd/) use this file.
///
/// The search on the rational form (solver.hpp) finds t from the forms, rounded. One evaluation at
/// t with the factors follows (evaluate_corrected()). It is certain for almost all pairs with
/// aspect ratios below 10⁴. For the others a safeguarded search, search(), solves equations by
/// conjugate directions (gram_schmidt.hpp), without forms, and squares no condition number.
///
/// Throughout, M = Q1 + t Q2 and s = M⁻¹r, and u is the unit roundoff. The error of the result is a
/// small multiple of u c, with the c of sensitivity().
#ifndef PW85_CONTACT_CONTACT_FACTORED_HPP_INCLUDED
#define PW85_CONTACT_CONTACT_FACTORED_HPP_INCLUDED

#include <pw85/algebra/gram_schmidt.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/factor.hpp>

namespace pw85::detail {

/// A second projection follows if a projection leaves less than 2^-evaluation_rest_bits of a
/// square. The error of a single projection is then at most about 2^10 u. It matters less than the
/// errors of the coefficients, because f is stationary. This number is a choice.
inline constexpr int evaluation_rest_bits = 20;

/// The result of an evaluation at t. With conjugate directions w_j for M and d_j = w_jᵀM w_j, s = Σ
/// (rᵀw_j/d_j) w_j, A = |S1ᵀs|², B = |S2ᵀs|² and rᵀs = Σ (rᵀw_j)²/d_j.
template <class T, int D> struct FactoredEvaluation {
    T t;
    ConjugateBasis<T, D> basis;
    ImagedVector<T, D> s;
    T a, b, rs; ///< A, B and rᵀs
};

template <class T, int D> PW85_FUNCTION inline FactoredEvaluation<T, D>
evaluate(FactoredPair<T, D> const &pair, T const &t) noexcept
{
    auto const basis = conjugate_basis(T(1), pair.q1, t, pair.q2, pair.r12,
                                       negative_power_of_two<T>(evaluation_rest_bits));
    auto const [s, rs] = solve(basis, components(basis));
    return {t, basis, s, dot(s.first, s.first), dot(s.second, s.second), rs};
}

/// A and B with their derivatives, all divided by A. Let z_j = (S2ᵀw_j)·(S2ᵀs), and v = Σ (z_j/d_j)
/// w_j = M⁻¹Q2s. Then A' = -2 (S1ᵀs)·(S1ᵀv), B' = -2 Σ z_j²/d_j, A'' = 6 |S1ᵀv|² and B'' = 6
/// |S2ᵀv|² (item 2 of evaluation.hpp).
template <class T, int D>
PW85_FUNCTION inline Jet<T> jet_of(FactoredEvaluation<T, D> const &e) noexcept
{
    Vector<T, D> z{};
    for (int j = 0; j < D; ++j) z[j] = dot(e.basis.directions[j].vector.second, e.s.second);
    auto const [v, square] = solve(e.basis, z);
    T const unit = T(1) / e.a;
    return {T(1),
            T(-2) * unit * dot(e.s.first, v.first),
            T(6) * unit * dot(v.first, v.first),
            e.b * unit,
            T(-2) * unit * square,
            T(6) * unit * dot(v.second, v.second),
            T(0)};
}

/// c μ²/λ for a bound c: If the entries of S1, S2 and r change by fractions ε, then μ² changes by a
/// fraction of at most ε c, where c = 2 λ (Σ|s_i S1_ij (S1ᵀs)_j| + t Σ|s_i S2_ij (S2ᵀs)_j| + Σ|s_i
/// r_i|)/μ².
template <class T, int D> PW85_FUNCTION inline T
sensitivity(FactoredPair<T, D> const &pair, FactoredEvaluation<T, D> const &e) noexcept
{
    T sum = magnitude_of_dot(e.s.w, pair.r12);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            sum = sum + absolute(e.s.w[i]) * (absolute(T(pair.q1(i, j) * e.s.first[j])) +
                                              e.t * absolute(T(pair.q2(i, j) * e.s.second[j])));
    return sum + sum;
}

/// The last evaluation of a search. Let v be the unit roundoff of T, u the unit roundoff of the
/// result, and e = v c the error of h. The evaluation is certain if two conditions hold. First, the
/// remaining step is within final_step(). Second, the error e moves the root so little that μ²
/// changes by less than u c: h' > e²/(u c). The factor 16 leaves room for the constants.
template <class T, int D>
PW85_FUNCTION inline LastEvaluation<T> finish(FactoredPair<T, D> const &pair,
                                              FactoredEvaluation<T, D> const &e,
                                              Slope<T> const &s) noexcept
{
    Candidate<T> candidate{e.t, T(1), T(0)};
    expect_derivatives(candidate, s, T(1), true);
    auto const value = stationary_value(candidate, pair.ratio, e.a, e.b, e.rs);
    T const v = T(unit_roundoff<T>()),
            noise = T(16) * (v / result_roundoff<T>() * v) * sensitivity(pair, e) / e.rs;
    return {value, candidate.k > noise && absolute(value.step) <= final_step<T>()};
}

/// Iterates from t until an evaluation is certain, or until a step is so small that only the
/// precision of T limits the result. The result says whether the search converged. `t` becomes the
/// last point.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T>
search(FactoredPair<T, D> const &pair, T &t) noexcept
{
    auto state = safeguarded_search(t, free_factorized_steps);
    for (int evaluations = 1;; ++evaluations) {
        t = state.t;
        auto const e = evaluate(pair, t);
        Jet<T> const jet = jet_of(e);
        Slope<T> const s = slope(jet, pair.ratio, t);
        auto const last = finish(pair, e, s);
        if (last.certified || absolute(last.value.step) <= final_step<T>() ||
            evaluations == max_factorized_steps)
            return to_maximum(last, evaluations, last.certified);
        TrustedStep<T> const trusted = trust(halley_step(s), s);
        T const image = fixed_point_image(jet, pair.ratio);
        take_bound(state, image > t, image);
        take_step(state, next_guess(jet, trusted, pair.ratio, t, image), trusted.size);
    }
}

/// Repeats the search with numbers of twice the digits, for a pair for which the digits of T do
/// not suffice.
template <class T, int D>
PW85_RARE Maximum<T> search_doubled(FactoredPair<T, D> const &pair, T const &t) noexcept
{
    using W = Doubled<T>;
    FactoredPair<W, D> const wide{converted<W>(pair.r12), converted<W>(pair.q1),
                                  converted<W>(pair.q2), W(pair.ratio)};
    W wide_t(t);
    auto const m = search(wide, wide_t);
    return {rounded(m.mu2), rounded(m.lambda), rounded(m.complement),
            m.evaluations,  m.converged,       m.certified};
}

/// The pair of the rounded forms.
template <class T, int D>
PW85_FUNCTION inline Pair<T, D> rounded_forms(FactoredPair<T, D> const &pair) noexcept
{
    return {pair.r12, form_of_factor(pair.q1), form_of_factor(pair.q2), pair.ratio};
}

/// w with its images.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr ImagedVector<T, D>
imaged(FactoredPair<T, D> const &pair, Vector<T, D> const &w) noexcept
{
    return {w, transposed_times(pair.q1, w), transposed_times(pair.q2, w)};
}

/// A and B, rᵀs and h' from a corrected solution.
template <class T> struct CorrectedEvaluation {
    T a, b, rs, k;
    T determinant, diagonal; ///< d is their ratio
};

/// Solves with the adjugate of the rounded M, and corrects the solution once.
///
/// Let C be the computed inverse of M by the adjugate, and d the determinant of M over the product
/// of its diagonal. All norms of errors are those of M, relative to s. Scale M to a unit diagonal.
/// Then its largest eigenvalue is at most 3, and its smallest at least 4d/9.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline CorrectedEvaluation<T>
evaluate_corrected(FactoredPair<T, D> const &pair, Pair<T, D> const &rounded_pair,
                   T const &t) noexcept
{
    auto const m = blend(rounded_pair.q1, t, rounded_pair.q2), adj = adjugate(m);
    T const det = determinant(m, adj), unit = T(1) / det;
    // I - C M is below 128 u/d, with the roundings of a product with C: 34 from M, whose entries
    // err by 5u; 24 from the entries of the adjugate, and 17 from the determinant; 27 from the
    // product. So s = C r errs by 128 u/d.
    auto const first = imaged(pair, unit * product(adj, pair.r12));
    auto const p = times(pair.q1, first.first), q = times(pair.q2, first.second),
               v = unit * product(adj, q);
    T const a = dot(first.first, first.first), b = dot(first.second, first.second);
    // With v = C Q2 s, h' = 1 + t (vᵀQ1s/A - vᵀQ2s/B) errs by 10 times the error of s and C, over
    // λ(1-λ).
    T const k = T(1) + t * (dot(p, v) * b - dot(q, v) * a) / (a * b);
    // s + C (r - M s) errs by (128 u/d)². With M s = S1 (S1ᵀs) + t S2 (S2ᵀs), roundings add 8 u/√d
    // by the images, 13 u/√d by the rest of the residual, and 3 u/√d by the sum. That is below 32
    // u/√d.
    auto const s = add_scaled(first, unit, imaged(pair, product(adj, (pair.r12 - p) - t * q)));
    return {dot(s.first, s.first), dot(s.second, s.second), dot(pair.r12, s.w), k, det,
            diagonal_product(m)};
}

/// The smallest d for which a corrected evaluation can be certain, about 64 u^(2/3). The error (128
/// u/d)² of the correction is then below that of roundings, 32 u/√d.
template <class T> PW85_FUNCTION constexpr T least_correctable() noexcept
{
    return negative_power_of_two<T>(2 * mantissa_digits<T>() / 3 - 6);
}

/// Returns whether a corrected evaluation at t is correct to rounding.
///
/// Let e be the error of the corrected s. If d >= 64 u^(2/3), then e < 64 u/√d. Let x be the last
/// step in log t. The value errs by the three parts of is_certified() (iteration.hpp), and by the
/// error of h'. If 4096 u/d < h' λ(1-λ), then h' errs by less than a third of itself, and e²/h' is
/// below u. If 4096 x² < d, then e x is below u, and so is the share of h' in ½ f' x, which is at
/// most 2560 u/d x².
template <class T> PW85_FUNCTION inline bool
is_certified(CorrectedEvaluation<T> const &e, T const &t, StationaryValue<T> const &value) noexcept
{
    T const x = absolute(value.step), least = maximum(least_correctable<T>(), T(T(4096) * (x * x)));
    return t > T(0) && x <= final_step<T>() && e.determinant > least * e.diagonal &&
           e.k * (value.lambda * value.complement) * e.determinant >
               T(4096 * unit_roundoff<T>()) * e.diagonal;
}

/// The last evaluation of a search on the rounded forms. Only h'' comes from the search. Beyond its
/// bound it is rounding noise.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline LastEvaluation<T>
last_evaluation(FactoredPair<T, D> const &pair, Pair<T, D> const &rounded_pair,
                Candidate<T> const &candidate) noexcept
{
    auto const e = evaluate_corrected(pair, rounded_pair, candidate.t);
    T const bound = e.k + e.k;
    Candidate<T> const exact{candidate.t, e.k, minimum(bound, maximum(T(-bound), candidate.k2))};
    auto const value = stationary_value(exact, pair.ratio, e.a, e.b, e.rs);
    return {{value.mu2, value.lambda, value.complement, value.step},
            is_certified(e, candidate.t, value)};
}

/// t, or 1 if a search cannot start at t.
template <class T> PW85_FUNCTION inline T start_near(T const &t) noexcept
{
    return t > smallest_number<T>() && t < largest_number<T>() ? t : T(1);
}

/// The end of a search on the rounded forms if it converged, otherwise its start.
template <class T, int D> PW85_FUNCTION inline T start_from(Pair<T, D> const &rounded_pair,
                                                            Candidate<T> const &candidate) noexcept
{
    return start_near(candidate.k > T(0) ? candidate.t : initial_guess(rounded_pair));
}

/// The maximum of f by conjugate directions, from t.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T>
maximize_by_directions(FactoredPair<T, D> const &pair, T t) noexcept
{
    auto const m = search(pair, t);
    if constexpr (std::is_floating_point_v<T> && FLT_EVAL_METHOD == 0)
        if (!m.certified) return search_doubled(pair, start_near(t));
    return m;
}

/// The maximum of f for a pair in range. The function is not inlined: scaling a pair must change no
/// bit of the result (solver.hpp).
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Maximum<T> maximize(FactoredPair<T, D> const &pair) noexcept
{
    auto const rounded_pair = rounded_forms(pair);
    auto const end = search_rational_form(rounded_pair);
    auto const last = last_evaluation(pair, rounded_pair, end.candidate);
    if (last.certified) return to_maximum(last, end.evaluations + 1, true);
    return maximize_by_directions(pair, start_from(rounded_pair, end.candidate));
}

PW85_RARE_TIER_OF(search_doubled, double, 3)

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Contact<T>
contact_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    return detail::contact_of(detail::pair_of(r12, s1, s2));
}

} // namespace pw85

#endif
