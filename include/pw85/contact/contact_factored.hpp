/// @file
/// The contact function of ellipsoids that are given by factors, Qi = Si Siᵀ. pw85.hpp and the C API (one_pair.cpp) use this file.
/// It orthogonalises the factors (gram_schmidt.hpp), and iterates with the safeguarded search (safeguarded_search.hpp).
///
/// The forms are never computed, so no condition number is squared. With K = [S1ᵀ; √t S2ᵀ], M = Q1 + t Q2 is KᵀK. Let K = U R
/// (gram_schmidt.hpp), s = M⁻¹r, y = R⁻ᵀr and g = U y. The upper half of g is g1 = S1ᵀs, and the lower half is g2 = √t S2ᵀs. Then
///
/// 1. A = |g1|², tB = |g2|² and rᵀs = |y|².
/// 2. Let U2 be the lower half of U, z = U2ᵀg2 and w = U z, with the halves w1 and w2. Then tA' = -2 g1·w1, t²B' = -2 |z|²,
///    t²A'' = 6 |w1|² and t³B'' = 6 |w2|². (U2ᵀU2 has the eigenvalues 1 - p, in the notation of evaluation.hpp.) These are the
///    derivatives at 1, if the unit of ellipsoid 2 is changed so that t becomes 1.
///
/// If the entries of S1, S2 and r change by fractions ε, then μ² changes by a fraction of at most ε c, where c = 2 λ (Σ|s_i S1_ij
/// g1_j| + √t Σ|s_i S2_ij g2_j| + Σ|s_i r_i|)/μ². The error of the result is a small multiple of u c.
#ifndef PW85_CONTACT_CONTACT_FACTORED_HPP_INCLUDED
#define PW85_CONTACT_CONTACT_FACTORED_HPP_INCLUDED

#include <pw85/algebra/gram_schmidt.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/factor.hpp>

namespace pw85::detail {

/// A pair of factors in units of their own. The true factors and the separation are S1, S2/ratio and r12, each times the same power
/// of two. As in Pair, τ = ratio²·t.
template <class T, int D> struct FactoredPair {
    Vector<T, D> r12;
    Factor<T, D> s1, s2;
    T ratio;
};

/// A pair in units that keep every intermediate result in range, and the exponents that lead back to the units of the caller.
/// ScaledPair is the same for forms.
template <class T, int D> struct ScaledFactors {
    FactoredPair<T, D> pair;
    int length, factor; ///< r12 is the pair's times 2^length, S1 the pair's times 2^factor
    bool swapped;
};

/// Brings a pair of regular factors with r12 != 0 into range. The scaling is exact.
template <class T, int D> PW85_FUNCTION inline ScaledFactors<T, D>
scale(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    int const e1 = binary_exponent(largest_entry(s1)), e2 = binary_exponent(largest_entry(s2));
    bool const swapped = e1 < e2;
    int const er = binary_exponent(largest_coordinate(r12)), limit = ratio_exponent_limit<T>();
    int const difference = swapped ? e2 - e1 : e1 - e2;
    ScaledFactors<T, D> scaled{};
    scaled.pair.r12 = times_power_of_two(swapped ? -r12 : r12, -er);
    scaled.pair.s1 = times_power_of_two(swapped ? s2 : s1, swapped ? -e2 : -e1);
    scaled.pair.s2 = times_power_of_two(swapped ? s1 : s2, swapped ? -e1 : -e2);
    scaled.pair.ratio = times_power_of_two(T(1), minimum(difference, limit));
    scaled.length = er;
    scaled.factor = swapped ? e2 : e1;
    scaled.swapped = swapped;
    return scaled;
}

/// The factorisation of K at t.
template <class T, int D>
PW85_FUNCTION inline OrthogonalFactors<T, D> factorize(FactoredPair<T, D> const &pair, T const &root_t) noexcept
{
    StackedVector<T, D> columns[D];
    for (int j = 0; j < D; ++j)
        for (int k = 0; k < D; ++k) {
            columns[j].upper[k] = pair.s1(j, k);
            columns[j].lower[k] = root_t * pair.s2(j, k);
        }
    return orthogonalize(columns);
}

/// The result of an evaluation at t (items 1 and 2).
template <class T, int D> struct FactoredEvaluation {
    T root_t;
    OrthogonalFactors<T, D> factors;
    Vector<T, D> y;
    StackedVector<T, D> g;
    T a, b, rs; ///< A, tB and rᵀs
    T ratio;    ///< the ratio of the units, if the unit of ellipsoid 2 is such that t is 1
};

template <class T, int D>
PW85_FUNCTION inline FactoredEvaluation<T, D> evaluate(FactoredPair<T, D> const &pair, T const &t) noexcept
{
    T const root_t = square_root(t);
    auto const factors = factorize(pair, root_t);
    auto const y = solve_transposed(factors, pair.r12);
    auto const g = combine(factors, y);
    return {root_t, factors, y, g, dot(g.upper, g.upper), dot(g.lower, g.lower), dot(y, y), pair.ratio * root_t};
}

/// A and tB with their derivatives at 1, all divided by A (item 2).
template <class T, int D> PW85_FUNCTION inline Jet<T> jet_of(FactoredEvaluation<T, D> const &e) noexcept
{
    Vector<T, D> z{};
    for (int j = 0; j < D; ++j) z[j] = dot(e.factors.u[e.factors.order[j]].lower, e.g.lower);
    auto const w = combine(e.factors, z);
    T const unit = T(1) / e.a;
    return {T(1),
            T(-2) * unit * dot(e.g.upper, w.upper),
            T(6) * unit * dot(w.upper, w.upper),
            e.b * unit,
            T(-2) * unit * dot(z, z),
            T(6) * unit * dot(w.lower, w.lower),
            T(0)};
}

/// c μ²/λ, where c is the bound at the top of this file.
template <class T, int D>
PW85_FUNCTION inline T sensitivity(FactoredPair<T, D> const &pair, FactoredEvaluation<T, D> const &e) noexcept
{
    Vector<T, D> const s = solve_triangle(e.factors, e.y);
    T sum = magnitude_of_dot(s, pair.r12);
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            sum = sum + absolute(s[i]) * (absolute(T(pair.s1(i, j) * e.g.upper[j])) +
                                          e.root_t * absolute(T(pair.s2(i, j) * e.g.lower[j])));
    return sum + sum;
}

/// The last evaluation of a search. Let v be the unit roundoff of T, u the unit roundoff of the result, and e = v c the error of h.
/// The evaluation is certain if two conditions hold. First, the remaining step is within final_step(). Second, the error e moves
/// the root so little that μ² changes by less than u c: h' > e²/(u c). The factor 16 leaves room for the constants.
template <class T, int D> PW85_FUNCTION inline LastEvaluation<T>
finish(FactoredPair<T, D> const &pair, FactoredEvaluation<T, D> const &e, Slope<T> const &s) noexcept
{
    Candidate<T> candidate{T(1), T(1), T(0)};
    expect_derivatives(candidate, s, T(1), true);
    auto const value = stationary_value(candidate, e.ratio, e.a, e.b, e.rs);
    T const v = T(unit_roundoff<T>()), noise = T(16) * (v / result_roundoff<T>() * v) * sensitivity(pair, e) / e.rs;
    return {value, candidate.k > noise && absolute(value.step) <= final_step<T>()};
}

/// Iterates from t until an evaluation is certain, or until a step is so small that only the precision of T limits the result. The
/// result says whether the search converged. `t` becomes the last point.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Maximum<T> search(FactoredPair<T, D> const &pair, T &t) noexcept
{
    auto state = safeguarded_search(t, free_factorized_steps);
    for (int evaluations = 1;; ++evaluations) {
        t = state.t;
        auto const e = evaluate(pair, t);
        Jet<T> const jet = jet_of(e);
        Slope<T> const s = slope(jet, e.ratio, T(1));
        auto const last = finish(pair, e, s);
        if (last.certain || absolute(last.value.step) <= final_step<T>() || evaluations == max_factorized_steps)
            return to_maximum(last, evaluations, last.certain);
        TrustedStep<T> const trusted = trust(halley_step(s), s);
        T const image = t * fixed_point_image(jet, e.ratio);
        take_bound(state, image > t, image);
        take_step(state, T(t * next_guess(jet, trusted, e.ratio, T(1), T(image / t))), trusted.size);
    }
}

/// Does the same search with numbers of twice the digits, for a pair for which the digits of T do not suffice.
template <class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline Maximum<T>
search_doubled(FactoredPair<T, D> const &pair, T const &t) noexcept
{
    using W = Doubled<T>;
    FactoredPair<W, D> const wide{converted<W>(pair.r12), converted<W>(pair.s1), converted<W>(pair.s2), W(pair.ratio)};
    W wide_t(t);
    auto const m = search(wide, wide_t);
    return {rounded(m.mu2), rounded(m.lambda), rounded(m.complement), m.evaluations, m.converged, m.certain};
}

/// The start of the search. It is the end of the search on the rational form of the rounded forms, if that search converges.
/// Otherwise it is the guess that is exact for spheres.
template <class T, int D> PW85_FUNCTION inline T initial_guess(FactoredPair<T, D> const &pair) noexcept
{
    Pair<T, D> const rounded_pair{pair.r12, form_of_factor(pair.s1), form_of_factor(pair.s2), pair.ratio};
    T const guess = initial_guess(rounded_pair);
    auto state = start_search(rounded_pair, guess);
    run(state, rounded_pair, max_rational_steps);
    T const t = state.active ? guess : state.candidate.t;
    return t > smallest_number<T>() && t < largest_number<T>() ? t : T(1);
}

/// The maximum of f for a pair in range.
template <class T, int D> PW85_FUNCTION inline Maximum<T> maximize(FactoredPair<T, D> const &pair) noexcept
{
    T t = initial_guess(pair);
    auto const m = search(pair, t);
    if constexpr (std::is_floating_point_v<T> && FLT_EVAL_METHOD == 0)
        if (!m.certain) return search_doubled(pair, t > T(0) && t < largest_number<T>() ? t : T(1));
    return m;
}

/// The status of a pair of factors. It is checked before anything is computed with them.
template <class T, int D>
PW85_FUNCTION inline Status validate(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    if (!is_finite(r12) || !is_finite(s1) || !is_finite(s2)) return Status::invalid_argument;
    return is_regular(s1) && is_regular(s2) ? Status::success : Status::not_positive_definite;
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Contact<T>
contact_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    using namespace detail;
    if (is_in_range(sum_of_magnitudes(r12), largest_entry(s1), largest_entry(s2)) && is_clearly_regular(s1) &&
        is_clearly_regular(s2))
        return to_contact(maximize(FactoredPair<T, D>{r12, s1, s2, T(1)}));
    Status const status = validate(r12, s1, s2);
    if (status != Status::success) return all_nan<Contact<T>>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), T(0.5), Status::success};
    auto const scaled = scale(r12, s1, s2);
    auto const m = maximize(scaled.pair);
    Contact<T> result = to_contact(m);
    result.mu2 = times_power_of_two(result.mu2, 2 * (scaled.length - scaled.factor));
    if (scaled.swapped && result.status == Status::success) result.lambda = m.complement;
    return result;
}

} // namespace pw85

#endif
