/// @file
/// The search for the maximum of f on the factorised form, for pairs whose rational form is not accurate: slower, right for
/// all, and one pair at a time.
#ifndef PW85_CONTACT_FACTORIZED_SEARCH_HPP_INCLUDED
#define PW85_CONTACT_FACTORIZED_SEARCH_HPP_INCLUDED

#include <pw85/contact/iteration.hpp>
#include <pw85/contact/refinement.hpp>

namespace pw85::detail {

/// The largest number of evaluations that one search on the factorised form makes: 3 free steps, 8 of growing length to enclose
/// the root, which lies in the range of double, 17 bisections of log t to make the bracket narrow, 8 steps that halve down to
/// penultimate_step(), and the last evaluation.
inline constexpr int max_factorized_steps = 37;

/// What is known of the root from item 3.
template <class T> struct Bracket {
    T lower, upper; ///< of t; the limits of the scalar when unknown
    T reach;        ///< factor from the end that is known to the next probe
};

/// Takes note of the fixed-point map's image of some t, a bound on the side where it is from t.
template <class T> PW85_FUNCTION inline void update(Bracket<T> &bracket, T const &t, T const &image) noexcept
{
    if (image > t)
        bracket.lower = maximum(bracket.lower, image);
    else
        bracket.upper = minimum(bracket.upper, image);
}

template <class T> PW85_FUNCTION inline bool is_narrow(Bracket<T> const &bracket) noexcept
{
    return bracket.upper <= bracket.lower + penultimate_step<T>() * bracket.lower;
}

template <class T> PW85_FUNCTION inline T clamp(Bracket<T> const &bracket, T const &t) noexcept
{
    return minimum(maximum(t, bracket.lower), bracket.upper);
}

/// The middle of log t, or a point far beyond the end that is known, the farther the more were tried.
template <class T> PW85_FUNCTION inline T probe(Bracket<T> &bracket) noexcept
{
    bool const below = !(bracket.lower > smallest_number<T>());
    bool const above = !(bracket.upper < largest_number<T>());
    if (!below && !above) return square_root(bracket.lower) * square_root(bracket.upper);
    T const t = clamp(bracket, below ? T(bracket.upper / bracket.reach) : T(bracket.lower * bracket.reach));
    bracket.reach = bracket.reach * bracket.reach;
    return t;
}

/// How a search solves with M: by factorisation, or with the solution refined.
enum class Precision { working, refined };

/// M⁻¹ r12.
template <class T, int D> PW85_FUNCTION inline Vector<T, D> solve_for_separation(Pair<T, D> const &pair, T const &t,
                                                                                 Factorization<T, D> const &factors,
                                                                                 Precision precision) noexcept
{
    Vector<T, D> const s = solve(factors, pair.r12);
    return precision == Precision::refined ? refine(pair, t, factors, s) : s;
}

/// Iterates from the candidate until a step is within penultimate_step(), or only rounding noise is left. Three steps are free
/// to go anywhere in the bracket; later ones bisect it unless Halley's steps halve. False after max_steps, and where the search ends
/// out of reach of Halley's method, so that h' is not known. Not inlined: extended numbers need much stack, at one place at a time.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline bool search(Pair<T, D> const &pair, Candidate<T> &candidate, Precision precision,
                                                   int &evaluations, int max_steps = max_factorized_steps - 1) noexcept
{
    T const smallest = smallest_number<T>(), largest = largest_number<T>();
    Bracket<T> bracket{smallest, largest, T(1024)};
    T t = clamp(bracket, candidate.t), shortest = T(2); // of Halley's steps, which is_near() keeps below 5/4
    for (int i = 1;; ++i) {
        auto const factors = factorize_blend(T(1), pair.q1, t, pair.q2);
        Jet<T> const jet = evaluate_jet(pair, factors, solve_for_separation(pair, t, factors, precision));
        ++evaluations;
        Slope<T> const s = slope(jet, pair.ratio, t);
        Step<T> const step = halley_step(s);
        // Out of the range of the scalar the step is 0/0 or NaN.
        bool const near = is_near(s) && step.denominator > T(0) && is_within(step, T(2));
        T const size = near ? T(absolute(step.numerator) / step.denominator) : T(2);
        T const image = minimum(largest, maximum(smallest, T(square_root(T(jet.a / jet.b)) / pair.ratio)));
        bool const pinned = is_narrow(bracket); // t is in it
        update(bracket, t, image);
        bool const halves = size <= T(0.5) * shortest, noise = near && !halves && shortest < T(0.1);
        bool const found = size <= penultimate_step<T>() || pinned || noise;
        if (found || i >= max_steps) {
            T const factor = near ? exponential(step) : T(1);
            candidate = {clamp(bracket, T(t * factor)), T(1), T(0)};
            expect_derivatives(candidate, s, factor, near);
            return found && near;
        }
        shortest = minimum(shortest, size);
        T const next = t * (near ? exponential(step) : secular_factor(jet, pair.ratio, t));
        t = clamp(bracket, next > smallest && next < largest ? next : image);
        if (i > 3 && !halves) t = probe(bracket);
    }
}

/// A bound on the inverse of the smallest eigenvalue of M scaled to a unit diagonal: the sum of M_ii (M⁻¹)_ii.
template <class T, int D>
PW85_FUNCTION inline T condition(Factorization<T, D> const &factors, SymmetricMatrix<T, D> const &m) noexcept
{
    T sum = T(0);
    for (int i = 0; i < D; ++i) {
        Vector<T, D> unit{};
        unit[i] = T(1);
        sum = sum + m(i, i) * solve(factors, unit)[i];
    }
    return sum;
}

/// By how many u κ the solution by factorisation errs across s, in the norm of M, with κ from condition()
/// (scripts/rounding_bounds.py: 4.8).
inline constexpr int factorization_error = 5;

/// By how many u κ of itself a correction of refine() errs, or the solution that it corrects, in the norm of M
/// (scripts/rounding_bounds.py: 9.4): so one correction shrinks an error.
inline constexpr int correction_error = 10;

/// By how many roundings of a result the last evaluation's s errs across, in the norm of M, beside what is_certain() need not count:
/// solved by factorisation, or refined by three corrections. Rounding the refined s to u in each coordinate leaves at most u √cond; its
/// square over k, which is compared with u cond, is below u cond/16 where k > 16 u, and its product with the step is smaller yet.
template <class T> PW85_FUNCTION inline T error_of_solution(T const &condition, Precision precision) noexcept
{
    if (precision == Precision::working)
        return T(T(factorization_error) * condition) *
               negative_power_of_two<T>(mantissa_digits<T>() - result_digits<T>());
    T const u = T(unit_roundoff<T>()), ratio = T(T(correction_error) * u) * condition;
    return ratio * ratio * ratio * ratio / u;
}

/// What h' errs by where sᵀQ1s and sᵀQ2s cancel: -½ d(log A)/dx and ½ d(log C)/dx, whose sum it is, are at most 1 and err like A and
/// B, each by some five roundings of a sum of magnitudes, which is at most D diagonal_form().
template <class T, int D> PW85_FUNCTION inline T
noise_of_slope(Pair<T, D> const &pair, SymmetricMatrix<T, D> const &weights, T const &a, T const &b) noexcept
{
    T const sum = diagonal_form(pair.q1, weights) / a + diagonal_form(pair.q2, weights) / b;
    return T(T(5 * D + 1) * T(unit_roundoff<T>())) * sum;
}

/// The last evaluation, by factorisation.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline LastEvaluation<T>
last_evaluation(Pair<T, D> const &pair, Candidate<T> const &candidate, Precision precision) noexcept
{
    auto const m = blend(pair.q1, candidate.t, pair.q2);
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    auto const s = solve_for_separation(pair, candidate.t, factors, precision);
    auto const weights = outer_weights(s);
    T const a = positive_form(pair.q1, weights), b = positive_form(pair.q2, weights);
    auto const value = stationary_value(candidate, pair.ratio, a, b, dot(pair.r12, s));
    T const error = error_of_solution(condition(factors, m), precision);
    return {value, candidate.k > noise_of_slope(pair, weights, a, b) && is_certain(candidate, value.step, error, T(1))};
}

} // namespace pw85::detail

#endif
