/// @file
/// The maximum of f of any pair: the search on the rational form, and where its last evaluation is not certain the one on the
/// factorised form, with the solution refined where that is not certain either, and by wider numbers where nothing else is.
#ifndef PW85_CONTACT_SOLVER_HPP_INCLUDED
#define PW85_CONTACT_SOLVER_HPP_INCLUDED

#include <pw85/algebra/definite.hpp>
#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/factorized_search.hpp>
#include <pw85/contact/rational_search.hpp>

#include <cfloat>

namespace pw85::detail {

/// The largest number of evaluations of f, in either form, that maximize() makes for a pair of doubles.
inline constexpr int max_evaluations = 157;
static_assert(max_evaluations == max_rational_steps + 1 + 4 * max_factorized_steps);

template <class T>
PW85_FUNCTION inline Maximum<T> to_maximum(LastEvaluation<T> const &last, int evaluations, bool converged) noexcept
{
    auto const &value = last.value;
    return {value.mu2, value.lambda, value.complement, evaluations, converged, converged && last.certain};
}

/// Where a search on the factorised form begins, if one before led to t.
template <class T, int D> PW85_FUNCTION inline T start_from(Pair<T, D> const &pair, T const &t) noexcept
{
    return t > T(0) && t < largest_number<T>() ? t : initial_guess(pair);
}

/// A pair in a wider type.
template <class Wide, class T, int D> PW85_FUNCTION inline Pair<Wide, D> widened(Pair<T, D> const &pair) noexcept
{
    return {converted<Wide>(pair.r12), converted<Wide>(pair.q1), converted<Wide>(pair.q2), Wide(pair.ratio)};
}

/// The maximum of f by a wider type, from where another search came to. Where it is certain, the value is right to rounding, not to some
/// cond of it.
template <class Wide, class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline Maximum<T>
maximize_in(Pair<T, D> const &pair, T const &t, int evaluations) noexcept
{
    Pair<Wide, D> const wide = widened<Wide>(pair);
    Candidate<Wide> candidate{start_from(wide, Wide(t)), Wide(1), Wide(0)};
    bool const found = search(wide, candidate, Precision::working, evaluations);
    auto const last = last_evaluation(wide, candidate, Precision::working);
    auto const &value = last.value;
    return {rounded(value.mu2), rounded(value.lambda), rounded(value.complement),
            evaluations + 1,    found && last.certain, false};
}

/// By twice the digits, where arithmetic is that of the type: certain but for one in many millions of pairs that are nearly singular.
/// Then by extended numbers: certain but for an ill-conditioning beyond that of forms that are positive definite.
template <class T, int D>
PW85_FUNCTION inline Maximum<T> maximize_wider(Pair<T, D> const &pair, T const &t, int evaluations) noexcept
{
    if constexpr (FLT_EVAL_METHOD == 0) {
        auto const m = maximize_in<Doubled<T>>(pair, t, evaluations);
        if (m.converged) return m;
        evaluations = m.evaluations;
    }
    return maximize_in<exact::Extended<T>>(pair, t, evaluations);
}

/// The maximum of f by the factorised form alone, from where a search on the rational form came to after so many evaluations.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T>
maximize_factorized(Pair<T, D> const &pair, Candidate<T> candidate, int evaluations) noexcept
{
    candidate.t = start_from(pair, candidate.t);
    bool const found = search(pair, candidate, Precision::working, evaluations);
    auto const last = last_evaluation(pair, candidate, Precision::working);
    ++evaluations;
    if (found && last.certain) return to_maximum(last, evaluations, true);
    bool const found_again = search(pair, candidate, Precision::refined, evaluations);
    auto const refined = last_evaluation(pair, candidate, Precision::refined);
    ++evaluations;
    if constexpr (has_extended_numbers<T>)
        if (!found_again || !refined.certain) return maximize_wider(pair, candidate.t, evaluations);
    return to_maximum(refined, evaluations, found_again);
}

/// The maximum of f over λ in [0, 1], for a pair of positive definite forms in range with r12 != 0. All callers share one
/// instance, so that products are fused alike and scaling changes no bit of the result.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T> maximize(Pair<T, D> const &pair) noexcept
{
    T const guess = initial_guess(pair);
    auto state = start_search(pair, guess);
    int evaluations = 0;
    T const diagonal = diagonal_product(blend(pair.q1, guess, pair.q2));
    if (evaluate_b(state.form, guess) >= rough_conditioning<T>() * diagonal) {
        for (; any_of(state.active) && evaluations < max_rational_steps; ++evaluations) take_step(state, pair.ratio);
        auto const last = last_evaluation(pair, state.candidate);
        ++evaluations;
        if (last.certain) return to_maximum(last, evaluations, true);
    }
    return maximize_factorized(pair, state.candidate, evaluations);
}

} // namespace pw85::detail

#endif
