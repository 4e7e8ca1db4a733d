// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the maximum of f on the rational form, as a task. The scalar may be a number, a
/// pack of lanes, or the number of a device's thread. A task has four parts:
///
/// 1. start: start_search() makes the state of the search.
/// 2. step: take_step() changes the state. A driver calls it while the state is active. It is run()
///    for a number or one pack, and src/simd/lanes/contact.hpp has one for several packs.
/// 3. accept: last_evaluation() gives the result. Use the result only where last_evaluation() says
///    that it is certain.
/// 4. fallback: a slower method computes the pairs that are not certain. For a number it is
///    maximize_factorized() (solver.hpp); lanes and devices leave these pairs to the functions for
///    one pair.
#ifndef PW85_CONTACT_RATIONAL_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_RATIONAL_SEARCH_HPP_INCLUDED

#include <pw85/contact/iteration.hpp>
#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// The number of steps after which a search gives up. Of 20,000 random pairs with aspect ratios up
/// to 1000, 413 need more than 5 steps, 56 more than 6, 7 more than 7, and none more than 8.
inline constexpr int max_rational_steps = 8;

/// The state of a search. The result for a lane depends only on its own pair, because no step
/// changes a lane that has converged.
template <class T, class Form = RationalForm<T>> struct RationalSearch {
    Form form; ///< one of which evaluate_jet() gives A and B
    Candidate<T> candidate;
    typename ScalarTraits<T>::Mask active; ///< not converged
};

/// Starts a search at t.
template <class T, int D>
PW85_FUNCTION inline RationalSearch<T> start_search(Pair<T, D> const &pair, T const &t) noexcept
{
    return {rational_form(pair), {t, T(0), T(0)}, t == t};
}

/// Starts a search at initial_guess().
template <class T, int D>
PW85_FUNCTION inline RationalSearch<T> start_search(Pair<T, D> const &pair) noexcept
{
    return start_search(pair, initial_guess(pair));
}

/// Takes Halley's step near the root, and that of secular_factor() elsewhere. A lane converges with
/// a step within penultimate_step(). Rounding errors, or numbers out of the range of the scalar,
/// can prevent this, or can lead to a wrong t. In these cases the last evaluation is not certain.
/// The function is always inlined: GCC would otherwise call it with -O2, and keep the search in
/// memory.
template <class T, class Form, int D> [[gnu::always_inline]] PW85_FUNCTION inline void
take_step(RationalSearch<T, Form> &search, Pair<T, D> const &pair) noexcept
{
    T const t = search.candidate.t;
    Jet<T> const jet = evaluate_jet(search.form, t);
    Slope<T> const s = slope(jet, pair.ratio, t);
    Step<T> const step = halley_step(s);
    auto const nearby = is_near(s), active = search.active;
    T factor = exponential(step);
    auto const converged = active && nearby && is_within(step, penultimate_step<T>());
    if (any_of(converged)) expect_derivatives(search.candidate, s, factor, converged);
    if (!all_of(nearby)) factor = select(nearby, factor, secular_factor(jet, pair.ratio, t));
    search.candidate.t = select(active, T(t * factor), t);
    search.active = active && !converged;
}

/// The driver for a number or one pack. It takes steps until no lane is active, but at most
/// max_steps. It returns the number of steps.
template <class Search, class T, int D>
PW85_FUNCTION inline int run(Search &search, Pair<T, D> const &pair, int max_steps) noexcept
{
    int steps = 0;
    for (; any_of(search.active) && steps < max_steps; ++steps) take_step(search, pair);
    return steps;
}

/// A bound on the error of solve_by_adjugate() across s in the norm of M, in units of u/d (theorem
/// `adjugate` of tests/bounds/proofs.cpp).
inline constexpr int adjugate_error = 13;

/// The last evaluation, by the adjugate of M at t.
template <class T, int D> PW85_FUNCTION inline LastEvaluation<T>
last_evaluation(Pair<T, D> const &pair, Candidate<T> const &candidate) noexcept
{
    auto const solution = solve_by_adjugate(blend(pair.q1, candidate.t, pair.q2), pair.r12);
    auto const weights = outer_weights(solution.s);
    auto const value =
        stationary_value(candidate, pair.ratio, quadratic_form(pair.q1, weights),
                         quadratic_form(pair.q2, weights), dot(pair.r12, solution.s));
    // The members are copied one by one, because a wide load of a whole structure waits for the
    // narrower stores before it.
    return {{value.mu2, value.lambda, value.complement, value.step},
            is_certified(candidate, value.step, T(T(adjugate_error) * solution.diagonal),
                         solution.determinant)};
}

} // namespace pw85::detail

#endif
