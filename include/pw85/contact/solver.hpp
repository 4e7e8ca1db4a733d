// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The maximum of f for any pair in range. contact.hpp calls maximize(); the headers for distances
/// and first contacts use it as well. It takes the first of these methods whose result is certain:
///
/// 1. the search on the rational form (iteration.hpp), which is enough for almost all pairs;
/// 2. the search on the factorised form (factorized_search.hpp);
/// 3. the search on the factorised form with refined solutions of the linear equations
///    (refinement.hpp);
/// 4. the search on the factorised form with wider numbers.
#ifndef PW85_CONTACT_SOLVER_HPP_INCLUDED
#define PW85_CONTACT_SOLVER_HPP_INCLUDED

#include <pw85/algebra/definite.hpp>
#include <pw85/algebra/doubled.hpp>
#include <pw85/contact/factorized_search.hpp>
#include <pw85/contact/iteration.hpp>

#include <cfloat>

namespace pw85::detail {

/// The largest number of evaluations of f, in either form, that maximize() makes for a pair of
/// doubles.
inline constexpr int max_evaluations = 157;
static_assert(max_evaluations == max_rational_steps + 1 + 4 * max_factorized_steps);

template <class T> PW85_FUNCTION inline Maximum<T>
to_maximum(LastEvaluation<T> const &last, int evaluations, bool converged) noexcept
{
    auto const &value = last.value;
    return {value.mu2,   value.lambda, value.complement,
            evaluations, converged,    converged && last.certified};
}

/// The start of a search on the factorised form, if the search before it ended at t.
template <class T, int D>
PW85_FUNCTION inline T start_from(Pair<T, D> const &pair, T const &t) noexcept
{
    return t > T(0) && t < largest_number<T>() ? t : initial_guess(pair);
}

/// A pair in a wider type.
template <class Wide, class T, int D>
PW85_FUNCTION inline Pair<Wide, D> widened(Pair<T, D> const &pair) noexcept
{
    return {converted<Wide>(pair.r12), converted<Wide>(pair.q1), converted<Wide>(pair.q2),
            Wide(pair.ratio)};
}

/// Finds the maximum of f with a wider type, starting at t. If the search converges, μ² is correct
/// to rounding for any condition number of the pair.
template <class Wide, class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline Maximum<T>
maximize_in(Pair<T, D> const &pair, T const &t, int evaluations) noexcept
{
    Pair<Wide, D> const wide = widened<Wide>(pair);
    Candidate<Wide> candidate{start_from(wide, Wide(t)), Wide(1), Wide(0)};
    bool const found = search(wide, candidate, Precision::working, evaluations);
    auto const last = last_factorized_evaluation(wide, candidate, Precision::working);
    auto const &value = last.value;
    return {rounded(value.mu2), rounded(value.lambda),   rounded(value.complement),
            evaluations + 1,    found && last.certified, false};
}

/// Finds the maximum of f with wider numbers. If the processor computes in the type itself, numbers
/// of twice the digits come first. They fail for one in many millions of nearly singular pairs.
/// Then extended numbers follow. They fail only for pairs that are worse conditioned than positive
/// definite forms can be.
template <class T, int D>
PW85_RARE Maximum<T> maximize_wider(Pair<T, D> const &pair, T const &t, int evaluations) noexcept
{
    if constexpr (FLT_EVAL_METHOD == 0) {
        auto const m = maximize_in<Doubled<T>>(pair, t, evaluations);
        if (m.converged) return m;
        evaluations = m.evaluations;
    }
    return maximize_in<exact::Extended<T>>(pair, t, evaluations);
}

/// Finds the maximum of f by methods 2 to 4, starting at the candidate of the search on the
/// rational form, which made `evaluations` evaluations.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Maximum<T>
maximize_factorized(Pair<T, D> const &pair, Candidate<T> const &start, int evaluations) noexcept
{
    Candidate<T> candidate = start;
    candidate.t = start_from(pair, start.t);
    bool const found = search(pair, candidate, Precision::working, evaluations);
    auto const last = last_factorized_evaluation(pair, candidate, Precision::working);
    ++evaluations;
    if (found && last.certified) return to_maximum(last, evaluations, true);
    bool const found_again = search(pair, candidate, Precision::refined, evaluations);
    auto const refined = last_factorized_evaluation(pair, candidate, Precision::refined);
    ++evaluations;
    if constexpr (has_extended_numbers<T>)
        if (!found_again || !refined.certified)
            return maximize_wider(pair, candidate.t, evaluations);
    return to_maximum(refined, evaluations, found_again);
}

/// Finds the maximum of f over λ in [0, 1], for a pair of positive definite forms in range with r12
/// != 0. The function is not inlined. So all callers share one instance, in which the same products
/// are fused, and scaling a pair changes no bit of the result.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline Maximum<T> maximize(Pair<T, D> const &pair) noexcept
{
    auto [candidate, evaluations] = search_rational_form(pair);
    if (evaluations > 0) {
        auto const last = last_evaluation(pair, candidate);
        ++evaluations;
        if (last.certified) return to_maximum(last, evaluations, true);
    }
    return maximize_factorized(pair, candidate, evaluations);
}

PW85_RARE_TIER(maximize_wider)

PW85_RARE_TIER_OF(search_in_steps, exact::Extended<double>, 2)
PW85_RARE_TIER_OF(search_in_steps, exact::Extended<double>, 3)

PW85_SHARED_BY_QUESTIONS(maximize)
PW85_SHARED_BY_QUESTIONS(maximize_factorized)

} // namespace pw85::detail

#endif
