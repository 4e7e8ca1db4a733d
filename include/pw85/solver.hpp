/// @file
/// The maximum of f of any pair: the search on the rational form, and where its last evaluation is not certain the one on the
/// factorised form, with the solution refined where that is not certain either.
#ifndef PW85_SOLVER_HPP_INCLUDED
#define PW85_SOLVER_HPP_INCLUDED

#include <pw85/factorized_search.hpp>
#include <pw85/rational_search.hpp>

namespace pw85 {

/// The largest number of evaluations of f, in either form, that maximize() makes for a pair of doubles.
inline constexpr int max_evaluations = 83;
static_assert(max_evaluations == max_rational_steps + 1 + 2 * max_factorized_steps);

template <class T>
PW85_FUNCTION inline Maximum<T> to_maximum(LastEvaluation<T> const &last, int evaluations, bool converged) noexcept
{
    auto const &value = last.value;
    return {value.mu2, value.lambda, value.complement, evaluations, converged, converged && last.certain};
}

/// The maximum of f by the factorised form alone, from where a search on the rational form came to after so many evaluations.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T>
maximize_factorized(Pair<T, D> const &pair, Candidate<T> candidate, int evaluations) noexcept
{
    if (!(candidate.t > T(0) && candidate.t < largest_number<T>())) candidate.t = initial_guess(pair);
    bool const found = search(pair, candidate, Precision::working, evaluations);
    auto const last = last_evaluation(pair, candidate, Precision::working);
    ++evaluations;
    if (found && last.certain) return to_maximum(last, evaluations, true);
    bool const found_again = search(pair, candidate, Precision::refined, evaluations);
    auto const refined = last_evaluation(pair, candidate, Precision::refined);
    return to_maximum(refined, evaluations + 1, found_again);
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

} // namespace pw85

#endif
