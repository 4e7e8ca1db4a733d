// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function with μ² correctly rounded, and λ with an error below one unit in the last
/// place. pw85.hpp and the C API use this file. Each step is slower than the one before, and is
/// used only for pairs that the steps before it do not decide:
///
/// 1. bound_maximum(): bounds on μ² and λ from doubled numbers (contact/enclosure.hpp). If both
///    bounds on μ² round to the same number, this number is μ².
/// 2. maximize_to_all_digits(): λ from extended numbers, with a proof, if the first step does not
///    prove one.
/// 3. nearest_number(): μ² is compared with the numbers in the middle of two numbers of the type,
///    in integers (exact.hpp).
#ifndef PW85_OVERLAP_CONTACT_ROUNDED_HPP_INCLUDED
#define PW85_OVERLAP_CONTACT_ROUNDED_HPP_INCLUDED

#include <pw85/algebra/running_error.hpp>
#include <pw85/contact/enclosure.hpp>
#include <pw85/overlap/exact.hpp>
#include <pw85/overlap/witness.hpp>

namespace pw85::detail {

/// Bounds of the maximum that floating-point numbers prove, in the units of the caller. λ is NaN if
/// its last digit is not proved. Numbers that are not known are NaN.
template <class T> struct MaximumBounds {
    T lower, upper; ///< μ² is between numbers that round to these
    T lambda;
    T t;             ///< near the maximiser
    int evaluations; ///< of doubled numbers
};

template <class T> PW85_FUNCTION constexpr MaximumBounds<T> no_bounds() noexcept
{
    T const nan = quiet_nan<T>();
    return {nan, nan, nan, nan, 0};
}

/// Returns whether the bounds leave one μ². Subnormal numbers are rounded twice, so they are left
/// open.
template <class T> PW85_FUNCTION inline bool decides(MaximumBounds<T> const &bounds) noexcept
{
    return bounds.lower == bounds.upper && bounds.lower >= smallest_number<T>() &&
           bounds.lambda >= T(0);
}

/// The largest error of λ before it is rounded, relative to λ. With half a unit in the last place
/// from rounding, less than three quarters of a unit remain.
template <class T> PW85_FUNCTION constexpr T largest_lambda_error() noexcept
{
    return T(T(0.25) * T(unit_roundoff<T>()));
}

/// λ at the maximum, rounded.
template <class T, int D> PW85_FUNCTION inline T lambda_of(ScaledPair<T, D> const &scaled,
                                                           EnclosedMaximum<T, D> const &e) noexcept
{
    if (!(e.step.error <= largest_lambda_error<T>())) return quiet_nan<T>();
    T const change = e.lambda.high * e.complement.high * e.step.step;
    return scaled.units.swapped ? T(e.complement.high + (e.complement.low - change))
                                : T(e.lambda.high + (e.lambda.low + change));
}

template <class T, int D> PW85_FUNCTION inline MaximumBounds<T>
bounds_of(ScaledPair<T, D> const &scaled, EnclosedMaximum<T, D> const &e, int evaluations) noexcept
{
    Unit const mu = scaled.units.mu();
    T const lower = e.value.high + (e.value.low - e.below),
            upper = e.value.high + (e.value.low + e.above);
    return {mu.to_caller(lower, 2), mu.to_caller(upper, 2), lambda_of(scaled, e), e.next.t,
            evaluations};
}

/// Returns whether t and τ are so near to one that no product of enclose() leaves the range of the
/// type.
template <class T, int D>
PW85_FUNCTION inline bool is_moderate(Pair<T, D> const &pair, T const &t) noexcept
{
    constexpr int exponent = std::numeric_limits<T>::max_exponent / 10;
    T const least = negative_power_of_two<T>(exponent), tau = t * pair.ratio * pair.ratio;
    return t > least && t * least < T(1) && tau > least && tau * least < T(1);
}

/// The largest number of evaluations in doubled numbers. The first one decides nearly all pairs.
inline constexpr int max_enclosures = 4;

/// Step 1, for a pair in range with r12 != 0.
template <class T, int D>
PW85_FUNCTION inline MaximumBounds<T> bound_maximum(ScaledPair<T, D> const &scaled) noexcept
{
    auto const &pair = scaled.pair;
    Maximum<T> const maximum = maximize(pair);
    NearMaximum<T, D> at{T(maximum.lambda / pair.ratio / maximum.complement / pair.ratio), {}};
    MaximumBounds<T> bounds = no_bounds<T>();
    bounds.t = at.t;
    for (int n = 0; n < max_enclosures && is_moderate(pair, at.t); ++n) {
        auto const m = blend(pair.q1, at.t, pair.q2);
        auto const inverse = invert_by_adjugate(m);
        if (!(inverse.error > T(0) && inverse.error <= T(0.0625))) break;
        if (n == 0) at.s = solve(inverse, pair.r12);
        auto const enclosure = enclose(pair, at, m, inverse);
        if (!enclosure.step.proved) break;
        bounds = bounds_of(scaled, enclosure, n + 1);
        if (decides(bounds)) break;
        at = enclosure.next;
    }
    return bounds;
}

/// A pair in extended numbers, whose units differ by 2^ratio, and a guess of t. Half of the ratio
/// is left to Q2. So t is of order one for sizes of any ratio.
template <class T, int D> struct ExtendedStart {
    Pair<exact::Extended<T>, D> pair;
    exact::Extended<T> t;
};

template <class T, int D> PW85_FUNCTION inline ExtendedStart<T, D>
extended_start(ScaledPair<T, D> const &scaled, int ratio, T const &guess) noexcept
{
    using W = exact::Extended<T>;
    ExtendedStart<T, D> start{widened<W>(scaled.pair), W(guess)};
    if (!(scaled.pair.ratio == T(1))) {
        int const half = ratio / 2;
        for (int k = 0; k < start.pair.q2.size; ++k)
            start.pair.q2[k] = scaled_by(start.pair.q2[k], -2 * half);
        start.pair.ratio = scaled_by(W(1), ratio - half);
        start.t = scaled_by(start.t, 2 * half);
    }
    start.t = start_from(start.pair, start.t);
    return start;
}

/// μ² and λ to all digits of extended numbers, rounded. λ is NaN if its last digit is not proved.
template <class T> struct ExtendedMaximum {
    T mu2, lambda;
};

/// z, S, λ, 1-λ and f at t (contact/enclosure.hpp), with bounds on their errors.
template <class W> struct BoundedEvaluation {
    RunningError<W> slope, curvature, lambda, complement, mu2;
};

/// Evaluates with the solution s of the adjugate. The function is not inlined, because its numbers
/// need much stack.
template <class W, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline BoundedEvaluation<W>
evaluate_with_bounds(Pair<W, D> const &exact, W const &t) noexcept
{
    using B = RunningError<W>;
    auto const r12 = converted<B>(exact.r12);
    auto const q1 = converted<B>(exact.q1), q2 = B(t) * converted<B>(exact.q2);
    auto const m = blend(q1, B(W(1)), q2);
    auto const adj = adjugate(m);
    B const reciprocal = reciprocal_of(determinant(m, adj));
    auto const s = reciprocal * product(adj, r12), y1 = product(q1, s), y2 = product(q2, s);
    B const tau(exact.ratio * exact.ratio * t), complement = reciprocal_of(B(W(1)) + tau),
                                                lambda = tau * complement;
    return {complement * dot(s, y1) - lambda * dot(s, y2), dot(reciprocal * product(adj, y2), y1),
            lambda, complement, lambda * dot(r12, s)};
}

/// Step 2, for a valid pair with r12 != 0 whose units differ by 2^ratio.
template <class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline ExtendedMaximum<T>
maximize_to_all_digits(ScaledPair<T, D> const &scaled, int ratio, T const &guess) noexcept
{
    using W = exact::Extended<T>;
    auto const [pair, start] = extended_start(scaled, ratio, guess);
    auto const [slope, curvature, lambda, complement, mu2] =
        evaluate_with_bounds(pair, precise_maximiser(pair, start));
    auto const step =
        prove_step(Stationarity<W>{slope.value, slope.error, curvature.value, curvature.error});
    W const change = lambda.value * complement.value * step.step;
    bool const proved = step.proved && step.error <= W(largest_lambda_error<T>());
    T const result =
        rounded(scaled.units.swapped ? complement.value - change : lambda.value + change);
    return {rounded(scaled_by(mu2.value, 2 * scaled.units.mu().exponent)),
            proved ? result : quiet_nan<T>()};
}

/// The number next to x >= 0 and larger.
template <class T> PW85_FUNCTION inline T next_above(T const &x) noexcept { return x + spacing(x); }

/// The number next to x > 0 and smaller.
template <class T> PW85_FUNCTION inline T next_below(T const &x) noexcept
{
    T const below = x - spacing(x), above = next_above(below);
    return above < x ? above : below;
}

/// The number in the middle of x >= 0 and next_above(x). It has one digit more than x, which is 1.
template <class T> PW85_FUNCTION inline exact::BinaryFraction<T> middle_above(T const &x) noexcept
{
    int const unit = binary_exponent(spacing(x)) - 1;
    auto middle = exact::to_binary_fraction(x);
    int const zeros = middle.sign == 0 ? 0 : middle.exponent - unit;
    middle.magnitude = exact::shifted_up(middle.magnitude, zeros);
    middle.magnitude.limbs[0] |= 1;
    middle.length = middle.sign == 0 ? 1 : middle.length + zeros;
    middle.exponent = unit;
    middle.sign = 1;
    return middle;
}

/// Returns whether the last digit of x >= 0 is 0.
template <class T> PW85_FUNCTION inline bool is_even(T const &x) noexcept
{
    auto const fraction = exact::to_binary_fraction(x);
    return fraction.sign == 0 || fraction.exponent > binary_exponent(spacing(x));
}

/// Step 3: the number nearest to μ², for a valid pair with r12 != 0. If two are equally near, it is
/// the one whose last digit is 0. It is infinity if μ² is at least as large as the middle of the
/// largest number and the next power of two. The function goes from `guess` >= 0 to the neighbours
/// until it has found μ². It counts the comparisons.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline T
nearest_number(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
               SymmetricMatrix<T, D> const &q2, T const &guess, int &comparisons) noexcept
{
    T const largest = largest_number<T>();
    T x = minimum(guess, largest);
    // Returns whether μ² rounds to more than x.
    auto const exceeds = [&](T const &number) {
        ++comparisons;
        int const sign = compare_exactly(r12, q1, q2, middle_above(number));
        return sign > 0 || (sign == 0 && !is_even(number));
    };
    if (exceeds(x)) {
        do {
            if (x >= largest) return infinity<T>();
            x = next_above(x);
        } while (exceeds(x));
        return x;
    }
    while (x > T(0) && !exceeds(next_below(x))) x = next_below(x);
    return x;
}

/// A result, and the number of evaluations and comparisons.
template <class T> struct RoundedContact {
    Contact<T> contact;
    int evaluations; ///< of doubled numbers
    int comparisons; ///< in integers
};

/// Steps 2 and 3, for pairs that step 1 does not decide.
template <class T, int D>
PW85_RARE RoundedContact<T> round_by_doubled_numbers(Pair<T, D> const &pair,
                                                     ScaledPair<T, D> const &scaled,
                                                     MaximumBounds<T> const &bounds) noexcept
{
    auto const &[r12, q1, q2, unit] = pair;
    ExtendedMaximum<T> maximum{bounds.lower, bounds.lambda};
    if (!(maximum.lambda >= T(0) && maximum.mu2 >= T(0))) {
        int const ratio = (unit_of(q1) / unit_of(q2)).exponent;
        maximum = maximize_to_all_digits(scaled, scaled.units.swapped ? -ratio : ratio, bounds.t);
    }
    RoundedContact<T> result{all_nan<Contact<T>>(StatusCode::no_convergence), bounds.evaluations,
                             0};
    if (!(maximum.lambda >= T(0) && maximum.mu2 >= T(0))) return result;
    T const mu2 = nearest_number(r12, q1, q2, maximum.mu2, result.comparisons);
    result.contact = {mu2, maximum.lambda, StatusCode::success};
    return result;
}

/// All steps, for a valid pair with r12 != 0. Processors that compute in a wider type than T have
/// no doubled numbers.
template <class T, int D> PW85_FUNCTION inline RoundedContact<T>
round_contact(Pair<T, D> const &pair, ScaledPair<T, D> const &scaled) noexcept
{
    MaximumBounds<T> bounds = no_bounds<T>();
    if constexpr (FLT_EVAL_METHOD == 0) bounds = bound_maximum(scaled);
    if (decides(bounds))
        return {{bounds.lower, bounds.lambda, StatusCode::success}, bounds.evaluations, 0};
    return round_by_doubled_numbers(pair, scaled, bounds);
}

/// contact_rounded() for a pair that fails the fast checks.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline RoundedContact<T>
round_contact_scaled(Pair<T, D> pair) noexcept
{
    ScaledPair<T, D> scaled;
    StatusCode const status = validate_pair(pair, scaled);
    if (status != StatusCode::success) return {all_nan<Contact<T>>(status), 0, 0};
    if (largest_coordinate(pair.r12) == T(0)) return {{T(0), T(0.5), StatusCode::success}, 0, 0};
    return round_contact(pair, scaled);
}

/// contact_rounded() with the number of evaluations and comparisons.
template <class T, int D>
PW85_FUNCTION inline RoundedContact<T> round_contact(Pair<T, D> const &pair) noexcept
{
    return passes_fast_checks(pair) ? round_contact(pair, ScaledPair<T, D>{pair, {}})
                                    : round_contact_scaled(pair);
}

PW85_RARE_TIER_OF(round_by_doubled_numbers, double, 3)

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Contact<T> contact_rounded(Vector<T, D> const &r12,
                                                SymmetricMatrix<T, D> const &q1,
                                                SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    if constexpr (exact::is_decidable<T>)
        return round_contact(pair_of(r12, q1, q2)).contact;
    else
        return contact(r12, q1, q2);
}

} // namespace pw85

#endif
