/// @file
/// The maximum of f: a third-order iteration in x = log t, prepared on the rational form.
///
/// With A and B as in evaluation.hpp, C = (ratio·t)² B (A = μ1² and C = μ2² of x0) and h = ½ log(C/A):
///
/// 1. The maximum of f is the root of h, df/dx = λ(1-λ)(A - C), and h increases: in the eigenbasis of the pencil
///    (Q1, Q2), with eigenvalues d_i and p_i = 1/(1 + t d_i), h' = ea + eb, where ea = -½ d(log A)/dx is an average of
///    1 - p_i and eb = ½ d(log C)/dx one of p_i over positive weights, and h' <= 1, with equality for spheres.
/// 2. |h''| <= 2 h', since d p_i/dx = -p_i (1 - p_i). So a step δ of Newton's method from a distance below 0.1 is followed
///    by one of less than a quarter of it; where that is not seen, δ is rounding noise. Farther away a step may be small and
///    the root still far: where h grows like e^(2x), h/h' is 1/2.
/// 3. f <= μ² <= max(A, C), and x - h is nearer to the root than x and on the same side: every evaluation gives a bound.
/// 4. 1/√A and 1/√C are nearly affine in t and in 1/t (exactly, where r12 is an eigenvector of the pencil). Equating the
///    tangents gives a quadratic for t that converges from afar, as in trust-region methods (J. J. Moré and
///    D. C. Sorensen, SIAM J. Sci. Stat. Comput. 4, 553, 1983); near the root Halley's method is better.
#ifndef PW85_SOLVER_HPP_INCLUDED
#define PW85_SOLVER_HPP_INCLUDED

#include <pw85/rational.hpp>

namespace pw85 {

/// The largest number of evaluations of f, in either form, that maximize() makes for a pair of doubles: 5 on the rational
/// form; on the factorised one 3 free steps, 8 of growing length to enclose the root, which lies in the range of double, 17
/// bisections of log t to make the bracket narrow, 8 steps that halve down to penultimate_step(), and the last one.
inline constexpr int max_evaluations = 42;

/// Value and maximiser of the contact function in the units of a Pair.
template <class T> struct Maximum {
    T mu2;
    T lambda, complement; ///< λ and 1-λ
    int evaluations;      ///< of f, in either form
    bool converged;
};

/// A step in x that leaves an error below final_step(): Halley's error is about its cube.
template <class T> static constexpr T penultimate_step() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 9 + 2);
}

/// A step in x below which Newton's step and second-order Taylor of f are exact to rounding: its cube is below u.
template <class T> static constexpr T final_step() noexcept
{
    return negative_power_of_two<T>((mantissa_digits<T>() + 3) / 3);
}

/// A Jet's view of h: h = artanh(difference/sum); h' = k/weight and h'' = k2/weight².
template <class T> struct Slope {
    T sum;        ///< C + A
    T difference; ///< C - A
    T weight;     ///< A·B
    T k, k2;
};

template <class T> static constexpr Slope<T> slope(Jet<T> const &j, T const &ratio, T const &t) noexcept
{
    T const y = ratio * t, c = y * y * j.b, weight = j.a * j.b;
    T const p = t * j.b1 * j.a, q = t * j.a1 * j.b;
    return {c + j.a, c - j.a, weight, weight + T(0.5) * (p - q),
            T(0.5) * (weight * ((p - q) + t * t * (j.b2 * j.a - j.a2 * j.b)) - (p - q) * (p + q))};
}

/// Whether Newton's step is at most 5/8, where item 2 makes Halley's the better one. Where rounding noise exceeds the
/// largest h', it counts as that.
template <class T> static constexpr typename ScalarTraits<T>::Mask is_near(Slope<T> const &s) noexcept
{
    return absolute(s.difference) * s.weight <= T(0.625) * (s.sum * minimum(s.k, s.weight));
}

/// A step in x, as a fraction.
template <class T> struct Step {
    T numerator;
    T denominator; ///< positive
};

/// Halley's step for the root of tanh h, where is_near(), kept between half and twice Newton's: rounding noise in h'' must
/// not make it small.
template <class T> static constexpr Step<T> halley_step(Slope<T> const &s) noexcept
{
    T const k = s.sum * s.k * s.k;
    T const denominator = minimum(T(k + k), maximum(T(k - T(0.5) * s.difference * s.k2), T(T(0.5) * k)));
    return {-s.difference * s.k * s.weight, denominator};
}

/// e^step to third order: the factor by which t changes.
template <class T> static constexpr T exponential(Step<T> const &step) noexcept
{
    T const twice = step.denominator + step.denominator;
    return rough_quotient(T(twice + step.numerator), T(twice - step.numerator));
}

/// Whether a step is at most `bound` in magnitude.
template <class T>
static constexpr typename ScalarTraits<T>::Mask is_within(Step<T> const &step, T const &bound) noexcept
{
    return absolute(step.numerator) <= bound * step.denominator;
}

/// The factor y on t of item 4: the positive root of ea y² + ((1 - ea) - ω(1 - eb)) y - ω eb, with ω = √(A/C).
template <class T> static inline T secular_factor(Jet<T> const &j, T const &ratio, T const &t) noexcept
{
    T const y = ratio * t;
    T const ea = j.log_factor - rough_quotient(T(T(0.5) * t * j.a1), j.a);
    T const eb = T(1) + rough_quotient(T(T(0.5) * t * j.b1), j.b) - j.log_factor;
    T const omega = rough_root(rough_quotient(j.a, T(y * y * j.b)));
    T const half = T(0.5) * ((T(1) - ea) - omega * (T(1) - eb));
    T const root = rough_root(T(half * half + ea * omega * eb));
    auto const positive = half > T(0);
    return rough_quotient(select(positive, T(omega * eb), T(root - half)), select(positive, T(half + root), ea));
}

/// Where the iteration starts: exact for spheres.
template <class T, int D> static inline T initial_guess(Pair<T, D> const &pair) noexcept
{
    auto const weights = outer_weights(pair.r12);
    return rough_root(rough_quotient(quadratic_form(pair.q1, weights), quadratic_form(pair.q2, weights))) / pair.ratio;
}

/// What a search knows when it is about to make its last evaluation.
template <class T> struct Candidate {
    T t;
    T k, k2; ///< h' and h'' at t
};

/// The end of a step that is within penultimate_step(), with the derivatives expected there.
template <class T> static constexpr Candidate<T> advance(T const &t, Slope<T> const &s, Step<T> const &step) noexcept
{
    T const y = exponential(step), reciprocal = rough_quotient(T(1), s.weight);
    T const k2 = s.k2 * reciprocal * reciprocal;
    return {t * y, s.k * reciprocal + k2 * (y - T(1)), k2};
}

/// The last evaluation: μ² and λ from any vector near M⁻¹r12 in direction.
template <class T> struct Finish {
    T mu2;
    T lambda, complement; ///< λ and 1-λ
    T step;               ///< the last step in x, taken into account in all of these
};

/// From A and B of s and rᵀs. λ(rᵀs)²/(A + tB) is stationary in s as well as in x, so that an error of s counts only
/// squared, and its scale not at all; to it comes ½ f' x for the last step x, which is never negative. The step, to third
/// order, is that of h + k x + ½ k2 x² = 0; where rounding noise makes it meaningless it is limited to ¼.
template <class T> static constexpr Finish<T> finish(Candidate<T> const &candidate, T const &ratio, T const &a,
                                                     T const &b, T const &rs) noexcept
{
    T const y = ratio * candidate.t, c = y * y * b, difference = a - c;
    T const reciprocal = T(1) / ((a + c) * candidate.k), newton = difference * reciprocal;
    T const bent = newton - T(0.5) * candidate.k2 * (a + c) * reciprocal * (newton * newton);
    T const step = minimum(T(0.25), maximum(T(-0.25), bent));
    T const tau = minimum(T(ratio * y), T(T(0.5) * largest_number<T>()));
    T const complement = T(1) / (T(1) + tau), lambda = tau * complement, weight = lambda * complement;
    T const scale = rs / (a + candidate.t * b);
    T const gain = T(0.5) * step * difference * (scale * scale) * weight;
    T const change = weight * step * (T(1) + T(0.5) * (complement - lambda) * step);
    T const rest = complement - change;
    return {lambda * rs * scale + maximum(T(0), gain), select(tau > T(1), T(T(1) - rest), T(lambda + change)), rest,
            step};
}

/// Iterates on the rational form from t until a step is within penultimate_step(); false if rounding errors or the
/// range of the scalar get in the way, or after 5 evaluations.
template <class T> [[gnu::always_inline]] static inline bool prepare(RationalForm<T> const &form, T const &ratio,
                                                                     Candidate<T> &candidate, int &evaluations) noexcept
{
    T const largest = largest_number<T>();
    T t = candidate.t;
    while (evaluations < 5) {
        Jet<T> const jet = evaluate_jet(form, t);
        ++evaluations;
        if (!(jet.a > T(0) && jet.b > T(0))) return false;
        Slope<T> const s = slope(jet, ratio, t);
        if (is_near(s)) {
            Step<T> const step = halley_step(s);
            if (is_within(step, penultimate_step<T>())) {
                Candidate<T> const last = advance(t, s, step);
                bool const valid = last.t > T(0) && last.t < largest && last.k > T(0);
                if (valid) candidate = last;
                return valid;
            }
            t = t * exponential(step);
        } else
            t = t * secular_factor(jet, ratio, t);
        if (!(t > T(0) && t < largest)) return false;
        candidate.t = t;
    }
    return false;
}

/// What is known of the root from item 3.
template <class T> struct Bracket {
    T lower, upper; ///< of t; the limits of the scalar when unknown
    T reach;        ///< factor from the end that is known to the next probe

    /// Takes note of the fixed-point map's image of some t, a bound on the side where it is from t.
    [[gnu::always_inline]] void update(T const &t, T const &image) noexcept
    {
        if (image > t)
            lower = maximum(lower, image);
        else
            upper = minimum(upper, image);
    }

    [[gnu::always_inline]] bool is_narrow() const noexcept { return upper <= lower + penultimate_step<T>() * lower; }

    /// The middle of log t, or a point far beyond the end that is known, the farther the more were tried.
    [[gnu::always_inline]] T probe() noexcept
    {
        bool const below = !(lower > smallest_number<T>()), above = !(upper < largest_number<T>());
        if (!below && !above) return square_root(lower) * square_root(upper);
        T const t = clamp(below ? T(upper / reach) : T(lower * reach));
        reach = reach * reach;
        return t;
    }

    [[gnu::always_inline]] T clamp(T const &t) const noexcept { return minimum(maximum(t, lower), upper); }
};

/// Iterates on the factorised form until a step is within penultimate_step(), or only rounding noise is left. Three steps
/// are free to go anywhere in the bracket; later ones bisect it unless Halley's steps halve.
template <class T, int D> static inline Candidate<T> search(Pair<T, D> const &pair, T t, int &evaluations) noexcept
{
    T const smallest = smallest_number<T>(), largest = largest_number<T>();
    Bracket<T> bracket{smallest, largest, T(1024)};
    T shortest = T(2); // of Halley's steps, which is_near() keeps below 5/4
    for (int i = 1;; ++i) {
        Jet<T> const jet = evaluate_jet(pair, t);
        ++evaluations;
        Slope<T> const s = slope(jet, pair.ratio, t);
        Step<T> const step = halley_step(s);
        // Out of the range of the scalar the step is 0/0 or NaN.
        bool const near = is_near(s) && step.denominator > T(0) && is_within(step, T(2));
        T const size = near ? T(absolute(step.numerator) / step.denominator) : T(2);
        T const image = minimum(largest, maximum(smallest, T(square_root(T(jet.a / jet.b)) / pair.ratio)));
        bool const pinned = bracket.is_narrow(); // t is in it
        bracket.update(t, image);
        bool const halves = size <= T(0.5) * shortest, noise = near && !halves && shortest < T(0.1);
        if (size <= penultimate_step<T>() || pinned || noise || evaluations >= max_evaluations - 1)
            return near ? advance(t, s, step) : Candidate<T>{bracket.clamp(t), T(1), T(0)};
        shortest = minimum(shortest, size);
        T const next = t * (near ? exponential(step) : secular_factor(jet, pair.ratio, t));
        t = bracket.clamp(next > smallest && next < largest ? next : image);
        if (i > 3 && !halves) t = bracket.probe();
    }
}

/// The maximum of f over λ in [0, 1] where the rational form is accurate; `converged` tells. The candidate is the
/// better start for maximize() where it is not.
template <class T, int D> [[gnu::always_inline]] static inline Maximum<T>
maximize_rational(Pair<T, D> const &pair, Candidate<T> &candidate) noexcept
{
    candidate = {initial_guess(pair), T(1), T(0)};
    RationalForm<T> const form = rational_form(pair);
    int evaluations = 0;
    T const diagonal = diagonal_product(blend(pair.q1, candidate.t, pair.q2));
    if (evaluate_b(form, candidate.t) < rough_conditioning<T>() * diagonal ||
        !prepare(form, pair.ratio, candidate, evaluations))
        return {T(0), T(0), T(0), evaluations, false};
    auto const solution = solve_by_adjugate(blend(pair.q1, candidate.t, pair.q2), pair.r12);
    if (!is_accurate(solution)) return {T(0), T(0), T(0), evaluations, false};
    auto const weights = outer_weights(solution.s);
    Finish<T> const last = finish(candidate, pair.ratio, quadratic_form(pair.q1, weights),
                                  quadratic_form(pair.q2, weights), dot(pair.r12, solution.s));
    return {last.mu2, last.lambda, last.complement, evaluations + 1, absolute(last.step) <= final_step<T>()};
}

/// The last evaluation on the factorised form.
template <class T, int D>
static inline Finish<T> finish_factorized(Pair<T, D> const &pair, Candidate<T> const &candidate) noexcept
{
    Vector<T, D> const s = solve(factorize_blend(T(1), pair.q1, candidate.t, pair.q2), pair.r12);
    auto const weights = outer_weights(s);
    return finish(candidate, pair.ratio, positive_form(pair.q1, weights), positive_form(pair.q2, weights),
                  dot(pair.r12, s));
}

/// The maximum of f over λ in [0, 1] by the factorised form alone, after so many evaluations on the rational form.
template <class T, int D> [[gnu::noinline]] static inline Maximum<T>
maximize_factorized(Pair<T, D> const &pair, Candidate<T> candidate, int evaluations) noexcept
{
    candidate = search(pair, candidate.t, evaluations);
    Finish<T> const last = finish_factorized(pair, candidate);
    return {last.mu2, last.lambda, last.complement, evaluations + 1, evaluations < max_evaluations - 1};
}

/// The maximum of f over λ in [0, 1], for a pair of positive definite forms in range with r12 != 0. All callers share one
/// instance, so that products are fused alike and scaling changes no bit of the result.
template <class T, int D> [[gnu::noinline]] static inline Maximum<T> maximize(Pair<T, D> const &pair) noexcept
{
    Candidate<T> candidate;
    Maximum<T> const maximum = maximize_rational(pair, candidate);
    return maximum.converged ? maximum : maximize_factorized(pair, candidate, maximum.evaluations);
}

} // namespace pw85

#endif
