/// @file
/// The search for the maximum of f on the rational form: the same few functions step a number, a pack of lanes or the value
/// of a device's thread. Whoever drives it loops; what it finds is right wherever the last evaluation says that it is certain.
#ifndef PW85_CONTACT_RATIONAL_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_RATIONAL_SEARCH_HPP_INCLUDED

#include <pw85/contact/iteration.hpp>
#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// The number of steps after which a search gives up. Of 20,000 random pairs of aspect ratios to 1000, 413 need more than 5, 56 more
/// than 6, 7 more than 7, and none more than 8.
inline constexpr int max_rational_steps = 8;

/// A search under way. What becomes of a lane depends on nothing but its pair: one that has converged is left alone.
template <class T> struct RationalSearch {
    RationalForm<T> form;
    Candidate<T> candidate;
    typename ScalarTraits<T>::Mask active; ///< not converged
};

/// A search that is about to begin at t.
template <class T, int D>
PW85_FUNCTION inline RationalSearch<T> start_search(Pair<T, D> const &pair, T const &t) noexcept
{
    return {rational_form(pair), {t, T(0), T(0)}, t == t};
}

/// One step: Halley's, or that of item 4 from afar. Lanes converge with a step within penultimate_step(); those that rounding
/// errors or the range of the scalar lead astray never do, or end where the last evaluation is not certain.
template <class T> PW85_FUNCTION inline void take_step(RationalSearch<T> &search, T const &ratio) noexcept
{
    T const t = search.candidate.t;
    Jet<T> const jet = evaluate_jet(search.form, t);
    Slope<T> const s = slope(jet, ratio, t);
    Step<T> const step = halley_step(s);
    auto const near = is_near(s), active = search.active;
    T factor = exponential(step);
    auto const converged = active && near && is_within(step, penultimate_step<T>());
    if (any_of(converged)) expect_derivatives(search.candidate, s, factor, converged);
    if (!all_of(near)) factor = select(near, factor, secular_factor(jet, ratio, t));
    search.candidate.t = select(active, T(t * factor), t);
    search.active = active && !converged;
}

/// By how many u/d solve_by_adjugate() errs across s, in the norm of M (theorem `adjugate` of tests/bounds/proofs.cpp).
inline constexpr int adjugate_error = 13;

/// The last evaluation, by the adjugate of M at t.
template <class T, int D>
PW85_FUNCTION inline LastEvaluation<T> last_evaluation(Pair<T, D> const &pair, Candidate<T> const &candidate) noexcept
{
    auto const solution = solve_by_adjugate(blend(pair.q1, candidate.t, pair.q2), pair.r12);
    auto const weights = outer_weights(solution.s);
    auto const value = stationary_value(candidate, pair.ratio, quadratic_form(pair.q1, weights),
                                        quadratic_form(pair.q2, weights), dot(pair.r12, solution.s));
    // One by one: a copy of the whole would wait for stores that are narrower than its loads.
    return {{value.mu2, value.lambda, value.complement, value.step},
            is_certain(candidate, value.step, T(T(adjugate_error) * solution.diagonal), solution.determinant)};
}

} // namespace pw85::detail

#endif
