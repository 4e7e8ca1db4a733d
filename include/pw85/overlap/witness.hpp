/// @file
/// A number or a point that proves the answer of the overlap test.
///
/// 1. f is concave, so that f(λ) > 1 for some number λ of the type only if it is for one of the two next to the maximiser. The
///    maximiser by extended numbers errs by far less than half of what separates them: it, rounded, and its two neighbours are tried.
/// 2. The point x0 of the maximiser is as deep inside of ellipsoid 1 as inside of ellipsoid 2, relative to the sizes of both. Near
///    contact what they have in common is a thin lens about it, in the common tangent plane, and x0 rounded may be beside the lens.
///    Then the points of a lattice about x0 are tried: one coordinate is computed from the others, so that the point is nearest to the
///    plane, and the integers are asked if it is within the thickness of the lens.
#ifndef PW85_OVERLAP_WITNESS_HPP_INCLUDED
#define PW85_OVERLAP_WITNESS_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/overlap/exact_witness.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// A witness that two ellipsoids overlap or are apart.
template <class T, int D> struct OverlapWitness {
    bool overlap;
    T lambda;               ///< a λ with f > 1, if they are apart
    Vector<T, D> direction; ///< unit normal of a plane that separates them to rounding, from 1 to 2, if they are apart
    Vector<T, D> point;     ///< a point inside both, relative to the centre of ellipsoid 1, if they overlap
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// Whether numbers of the type show that f(λ) > 1. The t of λ has two roundings, and log f changes by no more than log t does.
template <class T, int D>
PW85_FUNCTION inline bool exceeds_one_clearly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                              SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    if (!(lambda > T(0) && lambda < T(1)) || !passes_fast_checks(r12, q1, q2)) return false;
    T const t = lambda / T(T(1) - lambda);
    if (!(t * unscaled_limit<T>() > T(1) && t < unscaled_limit<T>())) return false;
    auto e = evaluate_quartic(Pair<T, D>{r12, q1, q2, T(1)}, t);
    e.b = e.b + T(T(4) * T(unit_roundoff<T>())) * e.diagonal;
    return shows_apart(e, t);
}

/// The maximum of f by extended numbers: what is near it in numbers of the type.
template <class T, int D> struct PreciseMaximum {
    T lambda;                   ///< rounded
    T below_one;                ///< 1 - μ², rounded
    Vector<T, D> point, offset; ///< x0, rounded, and what is left of it
    Vector<T, D> normal;        ///< across which they touch, of any length
};

/// Halley's steps beyond those of the search. Each leaves an error in log t of about the cube of the one before: the search ends with
/// at most 2^-15, and three leave less than 2^-300.
inline constexpr int steps_to_all_digits = 3;

/// The maximiser t of a pair, by all digits.
template <class W, int D> [[gnu::noinline]] PW85_FUNCTION inline W precise_maximiser(Pair<W, D> const &pair) noexcept
{
    Candidate<W> candidate{initial_guess(pair), W(1), W(0)};
    int evaluations = 0;
    search(pair, candidate, Precision::working, evaluations);
    W t = candidate.t;
    for (int n = 0; n < steps_to_all_digits; ++n) {
        auto const factors = factorize_blend(W(1), pair.q1, t, pair.q2);
        auto const s = slope(evaluate_jet(pair, factors, solve(factors, pair.r12)), pair.ratio, t);
        t = t * exponential(halley_step(s));
    }
    return t;
}

/// For any valid pair with r12 != 0.
template <class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline PreciseMaximum<T, D>
maximize_precisely(ScaledPair<T, D> const &scaled, Vector<T, D> const &r12) noexcept
{
    using W = exact::Extended<T>;
    auto const pair = widened<W>(scaled.pair);
    W const t = precise_maximiser(pair), tau = pair.ratio * pair.ratio * t, one(1);
    auto const s = solve(factorize_blend(one, pair.q1, t, pair.q2), pair.r12);
    auto const x = product(pair.q1, s);
    W const mu2 = times_two_to(tau / (one + tau) * dot(pair.r12, s), 2 * (scaled.length - scaled.form));
    PreciseMaximum<T, D> result{rounded(scaled.swapped ? one / (one + tau) : tau / (one + tau)), rounded(one - mu2), {}, {}, {}};
    for (int i = 0; i < D; ++i) {
        W const relative = times_two_to(x[i], scaled.length);
        W const coordinate = scaled.swapped ? W(r12[i]) + relative : relative;
        result.point[i] = rounded(coordinate);
        result.offset[i] = rounded(coordinate - W(result.point[i]));
        result.normal[i] = rounded(s[i]);
    }
    return result;
}

/// A λ with f(λ) > 1, or NaN, for a valid pair with r12 != 0.
template <class T, int D>
PW85_FUNCTION inline T find_lambda(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                   SymmetricMatrix<T, D> const &q2, T const &guess, ScaledPair<T, D> const &scaled) noexcept
{
    if (exceeds_one_clearly(r12, q1, q2, guess)) return guess;
    T const best = maximize_precisely(scaled, r12).lambda;
    for (T const &lambda : {best, next_number(best, T(0)), next_number(best, T(1))})
        if (lambda > T(0) && lambda < T(1) && exceeds_one_exactly(r12, q1, q2, lambda)) return lambda;
    return quiet_nan<T>();
}

/// Whether a point is inside both ellipsoids.
template <class T, int D>
PW85_FUNCTION inline bool is_inside_both(Vector<T, D> const &x, Vector<T, D> const &r12,
                                         SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_finite(x) && is_inside_exactly(x, Vector<T, D>{}, q1) && is_inside_exactly(x, r12, q2);
}

} // namespace pw85::detail

#endif
