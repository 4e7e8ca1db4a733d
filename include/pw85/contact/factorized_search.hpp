// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the maximum of f on the factorised form. It is slower than the search on the
/// rational form, but it finds the maximum for all pairs. It computes one pair at a time.
/// solver.hpp calls it for pairs whose rational form is not accurate.
#ifndef PW85_CONTACT_FACTORIZED_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_FACTORIZED_SEARCH_HPP_INCLUDED

#include <pw85/contact/iteration.hpp>
#include <pw85/contact/refinement.hpp>
#include <pw85/contact/safeguarded_search.hpp>

namespace pw85::detail {

/// The number of steps that may go anywhere in the bracket. It is a choice (bench/choices.py).
inline constexpr int free_factorized_steps = 3;

/// The largest number of evaluations that one search on the factorised form makes: the free steps,
/// probes to enclose the root, which lies in the range of double, 17 bisections of log t to make
/// the bracket narrow, 8 steps that halve down to penultimate_step(), and the last evaluation.
inline constexpr int max_factorized_steps =
    free_factorized_steps + max_probes<double>() + 17 + 8 + 1;

/// Method by which a search solves equations with M: by factorisation alone, or with refinement of
/// the solution.
enum class Precision { working, refined };

/// M⁻¹ r12.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> solve_for_separation(Pair<T, D> const &pair, T const &t,
                                                       Factorization<T, D> const &factors,
                                                       Precision precision) noexcept
{
    Vector<T, D> const s = solve(factors, pair.r12);
    return precision == Precision::refined ? refine(pair, t, factors, s) : s;
}

/// The candidate at the end of a search. It is one step further if the step can be trusted.
template <class T>
PW85_FUNCTION inline Candidate<T> end_of_search(SafeguardedSearch<T> const &state,
                                                Slope<T> const &s,
                                                TrustedStep<T> const &trusted) noexcept
{
    T const factor = trusted.nearby ? exponential(trusted.step) : T(1);
    Candidate<T> candidate{clamp(state, T(state.t * factor)), T(1), T(0)};
    expect_derivatives(candidate, s, factor, trusted.nearby);
    return candidate;
}

/// Searches from the candidate until a step is within penultimate_step(), or only rounding noise is
/// left (see is_near()). The image of each evaluation is a bound. The result is false after
/// max_steps, or if the search ends where Halley's method does not apply and h' is not known. The
/// function is not inlined, because extended numbers need much stack, and only one search runs at a
/// time.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline bool
search_in_steps(Pair<T, D> const &pair, Candidate<T> &candidate, Precision precision,
                int &evaluations, int max_steps) noexcept
{
    auto state = safeguarded_search(candidate.t, free_factorized_steps);
    for (int i = 1;; ++i) {
        auto const factors = factorize_blend(T(1), pair.q1, state.t, pair.q2);
        Jet<T> const jet =
            evaluate_jet(pair, factors, solve_for_separation(pair, state.t, factors, precision));
        ++evaluations;
        Slope<T> const s = slope(jet, pair.ratio, state.t);
        TrustedStep<T> const trusted = trust(halley_step(s), s);
        T const image = fixed_point_image(jet, pair.ratio);
        bool const pinned = is_narrow(state, penultimate_step<T>()); // t is in it
        take_bound(state, image > state.t, image);
        bool const noise =
            trusted.nearby && !halves(state, trusted.size) && state.shortest < T(0.1);
        bool const found = trusted.size <= penultimate_step<T>() || pinned || noise;
        if (found || i >= max_steps) {
            candidate = end_of_search(state, s, trusted);
            return found && trusted.nearby;
        }
        take_step(state, next_guess(jet, trusted, pair.ratio, state.t, image), trusted.size);
    }
}

/// A bound on the inverse of the smallest eigenvalue of M, with M scaled to a unit diagonal: the
/// sum of M_ii (M⁻¹)_ii.
template <class T, int D>
PW85_FUNCTION inline T inverse_eigenvalue_bound(Factorization<T, D> const &factors,
                                                SymmetricMatrix<T, D> const &m) noexcept
{
    T sum = T(0);
    for (int i = 0; i < D; ++i) {
        Vector<T, D> unit{};
        unit[i] = T(1);
        sum = sum + m(i, i) * solve(factors, unit)[i];
    }
    return sum;
}

/// A bound on the error of the solution by factorisation across s, in the norm of M, in units of u
/// κ, with κ from inverse_eigenvalue_bound() (theorem `factorization` of tests/bounds/proofs.cpp).
/// To first order the error is 4.8 at least (scripts/rounding_bounds.py).
inline constexpr int factorization_error = 12;

/// A bound on the relative error of a correction of refine() in the norm of M, in units of u κ
/// (theorem `correction` of tests/bounds/proofs.cpp). The error is relative to the correction, or
/// to the solution that is corrected. To first order it is 9.4 at least
/// (scripts/rounding_bounds.py). So one correction reduces the error.
inline constexpr int correction_error = 13;

PW85_SHARED_BY_QUESTIONS(search_in_steps)

/// search_in_steps() in at most max_factorized_steps evaluations.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline bool
search(Pair<T, D> const &pair, Candidate<T> &candidate, Precision precision,
       int &evaluations) noexcept
{
    return search_in_steps(pair, candidate, precision, evaluations, max_factorized_steps - 1);
}

/// The error of the s of the last evaluation across its direction, in the norm of M, in units of
/// the roundoff of the result. The solution comes from factorisation, or is refined by three
/// corrections. The error leaves out a part that is_certified() need not count: rounding the
/// refined s to u in each coordinate leaves at most u √cond. The square of this part over k is
/// compared with u cond. It is below u cond/16 where k > 16 u. Its product with the step is smaller
/// still.
template <class T>
PW85_FUNCTION inline T error_of_solution(T const &condition, Precision precision) noexcept
{
    if (precision == Precision::working)
        return T(T(factorization_error) * condition) *
               negative_power_of_two<T>(mantissa_digits<T>() - result_digits<T>());
    T const u = T(unit_roundoff<T>()), ratio = T(T(correction_error) * u) * condition;
    return ratio * ratio * ratio * ratio / u;
}

/// The error of h' where sᵀQ1s and sᵀQ2s cancel. h' is the sum of -½ d(log A)/dx and ½ d(log C)/dx.
/// Both terms are at most 1. Their relative errors are like those of A and B: each is five
/// roundings (theorem `counts` of tests/bounds/proofs.cpp) of a sum of magnitudes, which is at most
/// D diagonal_form().
template <class T, int D>
PW85_FUNCTION inline T noise_of_slope(Pair<T, D> const &pair, SymmetricMatrix<T, D> const &weights,
                                      T const &a, T const &b) noexcept
{
    T const sum = diagonal_form(pair.q1, weights) / a + diagonal_form(pair.q2, weights) / b;
    return T(T(5 * D + 1) * T(unit_roundoff<T>())) * sum;
}

/// The last evaluation, by factorisation.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline LastEvaluation<T>
last_factorized_evaluation(Pair<T, D> const &pair, Candidate<T> const &candidate,
                           Precision precision) noexcept
{
    auto const m = blend(pair.q1, candidate.t, pair.q2);
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    auto const s = solve_for_separation(pair, candidate.t, factors, precision);
    auto const weights = outer_weights(s);
    T const a = positive_form(pair.q1, weights), b = positive_form(pair.q2, weights);
    auto const value = stationary_value(candidate, pair.ratio, a, b, dot(pair.r12, s));
    T const error = error_of_solution(inverse_eigenvalue_bound(factors, m), precision);
    return {value, candidate.k > noise_of_slope(pair, weights, a, b) &&
                       is_certified(candidate, value.step, error, T(1))};
}

PW85_SHARED_BY_QUESTIONS(last_factorized_evaluation)

} // namespace pw85::detail

#endif
