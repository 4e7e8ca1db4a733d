// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the maximum of f: a third-order iteration in x = log t, and its task on the
/// rational form. factorized_search.hpp has that on the factorised form.
///
/// With A and B as in evaluation.hpp, C = (ratio·t)² B (A = μ1² and C = μ2² of x0) and h = ½
/// log(C/A), the maximum of f is the root of h, because df/dx = λ(1-λ)(A - C). h increases. To see
/// this, use the eigenbasis of the pencil (Q1, Q2), with eigenvalues d_i and p_i = 1/(1 + t d_i).
/// There h' = ea + eb, where ea = -½ d(log A)/dx is an average of 1 - p_i, and eb = ½ d(log C)/dx
/// is an average of p_i, both over positive weights. Also h' <= 1, with equality for spheres, and
/// |h''| <= 2 h', since d p_i/dx = -p_i (1 - p_i).
///
/// The scalar of a task may be a number, a pack of numbers (one pair of ellipsoids per lane of a
/// SIMD register), or a number in a thread of a device. A task has four parts:
///
/// 1. start: start_search() makes the state of the search.
/// 2. step: take_step() changes the state. A driver calls it while the state is active. It is run()
///    for a number or one pack, and src/simd/lanes/contact.hpp has one for several packs.
/// 3. accept: last_evaluation() gives the result. Use the result only where last_evaluation() says
///    that it is certain.
/// 4. fallback: a slower method computes the pairs that are not certain. For a number it is
///    maximize_factorized() (solver.hpp); lanes and devices leave these pairs to the functions for
///    one pair.
#ifndef PW85_CONTACT_ITERATION_HPP_INCLUDED
#define PW85_CONTACT_ITERATION_HPP_INCLUDED

#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// The largest step in x after which the error is below final_step(). The error of Halley's method
/// is about the cube of the step.
template <class T> PW85_FUNCTION constexpr T penultimate_step() noexcept
{
    return negative_power_of_two<T>(result_digits<T>() / 9 + 2);
}

/// The largest step x to the root for which f + ½ f' x is correct to u. The error is f‴x³/12, where
/// |f‴| <= 2.4 f by the bounds on h' and h'', and the cube is at most 4u.
template <class T> PW85_FUNCTION constexpr T final_step() noexcept
{
    return negative_power_of_two<T>(result_digits<T>() / 3);
}

/// The values that describe h, computed from a Jet: h = artanh(difference/sum), h' = k/weight and
/// h'' = k2/weight².
template <class T> struct Slope {
    T sum;        ///< C + A
    T difference; ///< C - A
    T weight;     ///< A·B
    T k, k2;
};

template <class T>
PW85_FUNCTION constexpr Slope<T> slope(Jet<T> const &j, T const &ratio, T const &t) noexcept
{
    T const y = ratio * t, c = y * y * j.b, weight = j.a * j.b;
    T const p = t * j.b1 * j.a, q = t * j.a1 * j.b;
    return {c + j.a, c - j.a, weight, weight + T(0.5) * (p - q),
            T(0.5) * (weight * ((p - q) + t * t * (j.b2 * j.a - j.a2 * j.b)) - (p - q) * (p + q))};
}

/// Returns whether Newton's step is at most 5/8, where Halley's step is the better one. If rounding
/// noise makes h' larger than 1, the largest possible h', then 1 is used. The result is false if
/// rounding errors have made A·B negative.
///
/// As |h''| <= 2 h', a step δ of Newton's method is followed by a step of less than a quarter of δ
/// if the distance to the root is below 0.1. If the next step is not that small, δ is rounding
/// noise. Farther away, a step may be small although the root is still far: where h grows like
/// e^(2x), h/h' is 1/2.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_near(Slope<T> const &s) noexcept
{
    return s.weight > T(0) &&
           absolute(s.difference) * s.weight <= T(0.625) * (s.sum * minimum(s.k, s.weight));
}

/// A step in x, as a fraction.
template <class T> struct Step {
    T numerator;
    T denominator; ///< positive
};

/// Halley's step for the root of tanh h, where is_near() is true. It is kept between half and twice
/// Newton's step: rounding noise in h'' cannot make it small.
template <class T> PW85_FUNCTION constexpr Step<T> halley_step(Slope<T> const &s) noexcept
{
    T const k = s.sum * s.k * s.k;
    T const denominator =
        minimum(T(k + k), maximum(T(k - T(0.5) * s.difference * s.k2), T(T(0.5) * k)));
    return {-s.difference * s.k * s.weight, denominator};
}

/// e^step to third order. This is the factor by which t changes.
template <class T> PW85_FUNCTION constexpr T exponential(Step<T> const &step) noexcept
{
    T const twice = step.denominator + step.denominator;
    return rough_quotient(T(twice + step.numerator), T(twice - step.numerator));
}

/// Returns whether a step is at most `bound` in magnitude.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_within(Step<T> const &step, T const &bound) noexcept
{
    return absolute(step.numerator) <= bound * step.denominator;
}

/// A factor on t that converges from afar, as in trust-region methods (J. J. Moré and D. C.
/// Sorensen, SIAM J. Sci. Stat. Comput. 4, 553, 1983). Near the root Halley's method is better.
///
/// 1/√A and 1/√C are nearly affine in t and in 1/t. They are exactly affine if r12 is an
/// eigenvector of the pencil. Equating the tangents gives the factor y as the positive root of ea
/// y² + ((1 - ea) - ω(1 - eb)) y - ω eb, with ω = √(A/C).
template <class T>
PW85_FUNCTION inline T secular_factor(Jet<T> const &j, T const &ratio, T const &t) noexcept
{
    T const y = ratio * t;
    T const ea = j.log_factor - rough_quotient(T(T(0.5) * t * j.a1), j.a);
    T const eb = T(1) + rough_quotient(T(T(0.5) * t * j.b1), j.b) - j.log_factor;
    T const omega = rough_root(rough_quotient(j.a, T(y * y * j.b)));
    T const half = T(0.5) * ((T(1) - ea) - omega * (T(1) - eb));
    T const root = rough_root(T(half * half + ea * omega * eb));
    auto const positive = half > T(0);
    return rough_quotient(select(positive, T(omega * eb), T(root - half)),
                          select(positive, T(half + root), ea));
}

/// A step, and whether to trust it. The step is not trusted if h is far from zero. It is also not
/// trusted if numbers are out of the range of the scalar and the step is 0/0 or NaN.
template <class T> struct TrustedStep {
    Step<T> step;
    /// magnitude; 2 if the step is not trusted, which is above the size of all trusted steps
    T size;
    bool nearby;
};

template <class T>
PW85_FUNCTION constexpr TrustedStep<T> trust(Step<T> const &step, Slope<T> const &s) noexcept
{
    bool const nearby = is_near(s) && step.denominator > T(0) && is_within(step, T(2));
    return {step, nearby ? T(absolute(step.numerator) / step.denominator) : T(2), nearby};
}

/// e^(x - h), limited to the range of the scalar. Since h' <= 1, it is between t and the root. So
/// every evaluation gives a bound.
template <class T>
PW85_FUNCTION inline T fixed_point_image(Jet<T> const &j, T const &ratio) noexcept
{
    return minimum(largest_number<T>(),
                   maximum(smallest_number<T>(), T(square_root(T(j.a / j.b)) / ratio)));
}

/// The next t. It comes from the step if that is trusted, otherwise from secular_factor(). If that
/// leaves the range of the scalar, it is the image.
template <class T> PW85_FUNCTION inline T next_guess(Jet<T> const &j, TrustedStep<T> const &trusted,
                                                     T const &ratio, T const &t,
                                                     T const &image) noexcept
{
    T const next = t * (trusted.nearby ? exponential(trusted.step) : secular_factor(j, ratio, t));
    return next > smallest_number<T>() && next < largest_number<T>() ? next : image;
}

/// The start of a search, from rᵀQ1r and rᵀQ2r. It is the root if both ellipsoids are spheres.
template <class T>
PW85_FUNCTION inline T initial_guess(T const &form1, T const &form2, T const &ratio) noexcept
{
    T const unit = T(1) / ratio; // the processor divides while it takes the root
    return rough_root(rough_quotient(form1, form2)) * unit;
}

template <class T, int D> PW85_FUNCTION inline T initial_guess(Pair<T, D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    return initial_guess(quadratic_form(pair.q1, weights), quadratic_form(pair.q2, weights),
                         pair.ratio);
}

/// The point of a search. k and k2 are set when the search has converged.
template <class T> struct Candidate {
    T t;
    T k, k2; ///< h' and h'' at t, as expected from the step before
};

/// Sets the derivatives that are expected after a step that multiplies t by a factor near 1.
template <class T>
PW85_FUNCTION constexpr void expect_derivatives(Candidate<T> &candidate, Slope<T> const &s,
                                                T const &factor,
                                                typename ScalarTraits<T>::Mask where) noexcept
{
    T const reciprocal = rough_quotient(T(1), s.weight), k2 = s.k2 * reciprocal * reciprocal;
    candidate.k = select(where, T(s.k * reciprocal + k2 * (factor - T(1))), candidate.k);
    candidate.k2 = select(where, k2, candidate.k2);
}

/// The result of the last evaluation: μ² and λ. The direction of s need only be near that of
/// M⁻¹r12.
template <class T> struct StationaryValue {
    T mu2;
    T lambda, complement; ///< λ and 1-λ
    T step;               ///< the last step in x; all values above include it
};

/// Computes the result from A and B of s, and rᵀs. λ(rᵀs)²/(A + tB) is stationary in s as well as
/// in x. So an error of s enters only squared, and the scale of s does not enter. The term ½ f' x
/// for the last step x is added; it is never negative. The step solves h + k x + ½ k2 x² = 0 to
/// third order. It is limited to ¼, because rounding noise can make it meaningless.
template <class T>
PW85_FUNCTION constexpr StationaryValue<T> stationary_value(Candidate<T> const &candidate,
                                                            T const &ratio, T const &a, T const &b,
                                                            T const &rs) noexcept
{
    T const y = ratio * candidate.t, c = y * y * b, difference = a - c;
    T const reciprocal = T(1) / ((a + c) * candidate.k), newton = difference * reciprocal;
    T const bent = newton - T(0.5) * candidate.k2 * (a + c) * reciprocal * (newton * newton);
    T const step = minimum(T(0.25), maximum(T(-0.25), bent));
    T const tau = minimum(T(ratio * y), T(T(0.5) * largest_number<T>()));
    T const complement = T(1) / (T(1) + tau), lambda = tau * complement,
            weight = lambda * complement;
    T const scale = rs / (a + candidate.t * b);
    T const gain = T(0.5) * step * difference * (scale * scale) * weight;
    T const change = weight * step * (T(1) + T(0.5) * (complement - lambda) * step);
    T const rest = complement - change;
    return {lambda * rs * scale + maximum(T(0), gain),
            select(tau > T(1), T(T(1) - rest), T(lambda + change)), rest, step};
}

/// The last evaluation of a search, and a flag: true if μ² is correct to rounding.
template <class T> struct LastEvaluation {
    StationaryValue<T> value;
    typename ScalarTraits<T>::Mask certified;
};

/// The rounding error of a result, u below.
template <class T> PW85_FUNCTION constexpr T result_roundoff() noexcept
{
    if constexpr (result_digits<T>() == mantissa_digits<T>())
        return T(unit_roundoff<T>());
    else
        return negative_power_of_two<T>(result_digits<T>());
}

/// Returns whether a last evaluation is correct to rounding. Its s errs by e = u n/d of itself
/// across its direction, in the norm of M. The error of the value is then the sum of three parts.
/// Each is kept below u, where cond >= 3:
///
/// 1. λ(rᵀs)²/(A + tB) is too small by e², and a wrong root of h costs e²(1 - k)/k, with k = h'. To
///    see this, weight the eigenvalues p of Q1 relative to M with s, and let their mean be λ and
///    their variance σ². Then k = 1 - σ²/(λ(1-λ)), and h errs by eσ/(λ(1-λ)).
/// 2. The share of the step, ½ f' x, errs by 2λ(1-λ) x times the error of h, which is at most e x.
/// 3. The terms of third order in x: see final_step().
///
/// The result is false if t or k is not positive, or NaN.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_certified(Candidate<T> const &candidate, T const &step, T const &n, T const &d) noexcept
{
    T const x = absolute(step), u = result_roundoff<T>();
    return candidate.t > T(0) && u * n * n < candidate.k * d * d && n * x < d &&
           x <= final_step<T>();
}

/// The maximum of f, in the units of a Pair.
template <class T> struct Maximum {
    T mu2;
    T lambda, complement; ///< λ and 1-λ
    int evaluations;      ///< of f, in either form
    bool converged;
    /// true if condition_number() bounds the error of μ², as decide_by_certified_value() requires
    bool certified;
};

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

/// The end of the search on the rational form of one pair. `evaluations` is 0 if the rational form
/// is too inaccurate to guide a search; the candidate is then the guess.
template <class T> struct EndOfSearch {
    Candidate<T> candidate;
    int evaluations;
};

/// The start of the search on the rational form of one pair, at initial_guess(). `accurate` is
/// false if the rational form is too inaccurate to guide a search.
template <class T> struct StartOfSearch {
    RationalSearch<T, FormOfSteps<T>> search;
    bool accurate;
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline StartOfSearch<T>
start_on_rational_form(Pair<T, D> const &pair) noexcept
{
    auto const q = side_by_side(pair.q1, pair.q2), other = side_by_side(pair.q2, pair.q1),
               adj = adjugate(q);
    auto const weights = outer_weights(converted<TwoLanes<T>>(pair.r12));
    auto const forms = quadratic_form(q, weights);
    T const guess = initial_guess(first_of(forms), second_of(forms), pair.ratio);
    auto const rational = rational_form(q, other, adj, weights);
    T const diagonal = diagonal_product(blend(pair.q1, guess, pair.q2));
    return {{form_of_steps(rational), {guess, T(0), T(0)}, guess == guess},
            guides_search(rational, guess, diagonal)};
}

/// Searches on the rational form, from initial_guess().
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline EndOfSearch<T>
search_rational_form(Pair<T, D> const &pair) noexcept
{
    auto start = start_on_rational_form(pair);
    int evaluations = 0;
    if (start.accurate) evaluations = run(start.search, pair, max_rational_steps);
    return {start.search.candidate, evaluations};
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
