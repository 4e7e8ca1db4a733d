// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The first contact of two ellipsoids that translate.
///
/// Let r(time) = r + v·time, M = Q1 + t Q2, and f be the function whose maximum is μ² (pw85.hpp).
///
/// 1. At fixed λ, f is a quadratic polynomial of time, and f <= μ². There is no contact while f
///    > 1. So the first root of f = 1 is a lower bound on the time of contact. If f has no such
///    root ahead, there is no contact.
/// 2. f is convex in time and concave in λ. So the time of contact is the largest of these roots.
///    Larger roots (or a λ without a root) lie on that side of λ on which f has its maximum at the
///    time of the root. So the contact is found by a search for the root of h
///    (contact/iteration.hpp), in which every step also updates the time. The root of f = 1 is
///    stationary in λ at the contact, so its error is of second order in the error of λ.
#ifndef PW85_MOTION_TRANSLATION_HPP_INCLUDED
#define PW85_MOTION_TRANSLATION_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/solver.hpp>
#include <pw85/motion/motion.hpp>

namespace pw85 {

/// Time at which two ellipsoids first touch.
template <class T> struct FirstContact {
    T time; ///< infinity if they do not
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The first root of excess - 2 approach·x + speed·x², computed from the root of the discriminant
/// approach² - speed·excess. No two like numbers are subtracted.
template <class T> PW85_FUNCTION constexpr T nearer_root(T const &excess, T const &approach,
                                                         T const &speed, T const &root) noexcept
{
    return approach > T(0) ? T(excess / (approach + root)) : T((approach - root) / speed);
}

/// The first root of the same polynomial, which is positive before the root. Infinity if there is
/// no root, or if the polynomial is positive at zero and grows. A polynomial whose least value
/// exceeds zero by less than the slack has its root at the least value.
template <class T> PW85_FUNCTION inline T first_root(T const &excess, T const &approach,
                                                     T const &speed, T const &slack) noexcept
{
    T const square = approach * approach - speed * excess,
            root = square_root(maximum(T(0), square));
    bool const ahead = approach > T(0) || speed < T(0);
    if (!(ahead || excess < slack) || !(square + speed * slack >= T(0))) return infinity<T>();
    return nearer_root(excess, approach, speed, root);
}

/// Item 1 at one λ: rᵀM⁻¹r = target, the level of f = 1, at some time, and the coefficients of its
/// change.
template <class T, int D> struct SeparationBound {
    Vector<T, D> s, s_velocity; ///< M⁻¹r, M⁻¹v
    T excess, slack;            ///< rᵀM⁻¹r - target, and what rounding can make of it
    T approach, speed;          ///< -rᵀM⁻¹v, vᵀM⁻¹v
};

/// A pair that overlaps by at most this many times its own rounding error counts as one that
/// touches. Coordinates in a space a hundred times larger than its particles are rounded by about
/// as much.
inline constexpr int touching_tolerance = 128;

/// Conclusion from one λ: none, the ellipsoids do not touch; too_near, they are too near at the
/// start for a decision by this λ; contact, they do not touch before some time.
enum class BoundOutcome { none, too_near, contact };

/// rᵀM⁻¹r where f = 1, for f = τ/(1+τ) rᵀM⁻¹r with τ = ratio² t.
template <class T>
PW85_FUNCTION constexpr T target_at(T const &tangent, T const &ratio, T const &t) noexcept
{
    return tangent + tangent / (ratio * ratio * t);
}

/// A bound on the error of rᵀM⁻¹r. f errs by at most 4 u cond; the sums of magnitudes in cond are
/// at most thrice Σ|s_i M_ij s_j|; this sum is at most D Σ M_ii s_i², since |M_ij| <= √(M_ii M_jj).
template <class T, int D> PW85_FUNCTION constexpr T slack_of_form(SymmetricMatrix<T, D> const &m,
                                                                  Vector<T, D> const &s) noexcept
{
    T sum = m(0, 0) * s[0] * s[0];
    for (int i = 1; i < D; ++i) sum = sum + m(i, i) * s[i] * s[i];
    return T(12 * D * unit_roundoff<T>()) * sum;
}

template <class T, int D> PW85_FUNCTION inline SeparationBound<T, D>
separation_bound(Vector<T, D> const &r12, Vector<T, D> const &velocity, T const &target,
                 SymmetricMatrix<T, D> const &m, Factorization<T, D> const &factors) noexcept
{
    Vector<T, D> const y = substitute_forward(factors, r12),
                       z = substitute_forward(factors, velocity), s = substitute_back(factors, y);
    return {s,
            substitute_back(factors, z),
            dot_over_pivots(factors, y, y) - target,
            slack_of_form(m, s),
            -dot_over_pivots(factors, y, z),
            dot_over_pivots(factors, z, z)};
}

/// Returns whether the ellipsoids are too far apart for this bound to decide whether they touch.
/// The rounding error of rᵀM⁻¹r is then at least 16 u cond times the target. It can exceed the
/// difference between the least value of rᵀM⁻¹r and the target.
template <class T, int D>
PW85_FUNCTION constexpr bool is_far(SeparationBound<T, D> const &p, T const &target) noexcept
{
    return p.excess > T(15) * target;
}

/// The time that item 1 proves free of contact, counted from `origin`. There is no contact before
/// `origin`. A pair whose surfaces pass each other at a distance below rounding counts as touching.
/// A pair that overlaps at time 0 by no more than rounding, and moves apart, does not touch. For a
/// distant pair the error of the discriminant is the sum of the rounding error of rᵀM⁻¹r, that of
/// vᵀM⁻¹v, and twice that of rᵀM⁻¹v. These are of equal size if v points at the other ellipsoid, so
/// the step ends before the contact by four times the first error.
template <class T, int D> PW85_FUNCTION inline BoundOutcome
bound_outcome(SeparationBound<T, D> const &p, T const &target, T const &origin, T &time) noexcept
{
    bool const starts = !(origin > T(0));
    time = T(0);
    if (starts && p.excess > -T(touching_tolerance) * p.slack && p.approach < T(0))
        return BoundOutcome::none;
    if (starts && !(p.excess > T(0))) return BoundOutcome::too_near;
    bool const distant = is_far(p, target);
    time = first_root(distant ? T(p.excess - T(4) * p.slack) : p.excess, p.approach, p.speed,
                      distant ? T(0) : p.slack);
    if (!(time < infinity<T>())) return BoundOutcome::none;
    if (origin + time > T(0)) return BoundOutcome::contact;
    time = -origin;
    return BoundOutcome::too_near;
}

/// A Jet without second derivatives, for Newton's steps, from A, B and c = (Q2s)ᵀM⁻¹Q2s: A' = -2
/// (B - t c), B' = -2 c.
template <class T>
PW85_FUNCTION constexpr Jet<T> first_jet(T const &a, T const &b, T const &c, T const &t) noexcept
{
    T const unit = T(1) / a, twice = T(-2) * unit;
    return {T(1), twice * (b - t * c), T(0), unit * b, twice * c, T(0), T(0)};
}

/// A step in log t after which one more bound gives the contact: the error of the next t is about
/// the square of the step, and the time errs by the square of that error.
template <class T> PW85_FUNCTION constexpr T last_translation_step() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 2 + 2);
}

/// The time from the root of item 1 at some t to the contact, if Newton's step to the maximum of f
/// is small. The step raises log f by half the step times the slope λ(1-λ)(A - C)/(λA + (1-λ)C).
/// log f falls by 2 root/target in a unit of time.
template <class T> PW85_FUNCTION inline T delay(Slope<T> const &s, T const &ratio, T const &t,
                                                T const &root, T const &target) noexcept
{
    // in this order, overflow and underflow do no harm
    T const tau = T(ratio * t) * ratio, lambda = T(1) / (T(1) + T(1) / tau);
    T const step = s.difference * s.weight / (s.sum * s.k);
    T const level = T(0.5) * (s.sum + (T(1) - T(2) * lambda) * s.difference);
    return T(0.25) * (lambda * (T(1) - lambda)) * (s.difference / level) * step * (target / root);
}

/// The largest number of values of t that find_translation_contact() tries. It exceeds the number
/// that search() needs, because the time changes with every step.
inline constexpr int max_translation_steps = 100;

/// The number of steps that are only limited by the bracket: two more than in search(), because the
/// time changes. This number is a choice.
inline constexpr int free_translation_steps = 5;

/// A pair that translates, in the units of a Pair.
template <class T, int D> struct TranslatingPair {
    Pair<T, D> const &pair;
    Vector<T, D> const &velocity;
    T tangent; ///< f of a tangent pair
};

/// Bound of item 1 from some time on, at one t.
template <class T, int D> struct TimeBound {
    Factorization<T, D> factors;
    T target;
    SeparationBound<T, D> separation;
    BoundOutcome outcome;
    T wait; ///< from that time to the one to which item 1 leads
};

template <class T, int D> PW85_FUNCTION inline TimeBound<T, D>
time_bound(TranslatingPair<T, D> const &moving, T const &t, T const &time) noexcept
{
    auto const m = blend(moving.pair.q1, t, moving.pair.q2);
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    T const target = target_at(moving.tangent, moving.pair.ratio, t);
    auto const p = separation_bound(add_scaled(moving.pair.r12, time, moving.velocity),
                                    moving.velocity, target, m, factors);
    T wait;
    BoundOutcome const expected = bound_outcome(p, target, time, wait);
    return {factors, target, p, expected, wait};
}

/// The jet at the time to which a bound leads.
template <class T, int D> PW85_FUNCTION inline Jet<T>
jet_then(TranslatingPair<T, D> const &moving, TimeBound<T, D> const &bound, T const &t) noexcept
{
    Vector<T, D> const s = add_scaled(bound.separation.s, bound.wait, bound.separation.s_velocity);
    auto const weights = outer_weights(s);
    T const a = positive_form(moving.pair.q1, weights), b = positive_form(moving.pair.q2, weights);
    return first_jet(a, b, inverse_form(bound.factors, product(moving.pair.q2, s)), t);
}

/// Newton's step for the root of h.
template <class T> PW85_FUNCTION constexpr Step<T> newton_step(Slope<T> const &s) noexcept
{
    return {-s.difference * s.weight, s.sum * s.k};
}

/// Returns half of the rate at which the excess of a bound falls at the time to which it leads.
template <class T, int D> PW85_FUNCTION constexpr T root_then(TimeBound<T, D> const &bound) noexcept
{
    return bound.separation.approach - bound.separation.speed * bound.wait;
}

/// Returns whether delay() is right to rounding for a step of some size. In a grazing contact f
/// hardly changes with time, and the delay may shift the maximum of f.
template <class T, int D>
PW85_FUNCTION constexpr bool tells_delay(TimeBound<T, D> const &bound, T const &size) noexcept
{
    T const shift = size * size, grazing = last_translation_step<T>() * root_then(bound);
    return bound.outcome == BoundOutcome::contact && size <= final_step<T>() &&
           shift * shift * bound.separation.speed * bound.target < grazing * grazing;
}

/// Result of the search for the contact of a translation: the time of the contact, or infinity; and
/// the t and the time of the f that proves it: at the contact; or where f exceeds one when the
/// ellipsoids are nearest; or where f exceeds one at the end of the time.
template <class T> struct TranslationContact {
    T time, t, shown;
    StatusCode status;
};

/// A contact at t, if it is not after the end.
template <class T> PW85_FUNCTION constexpr TranslationContact<T>
contact_until(T const &end, T const &time, T const &t) noexcept
{
    return {time > end ? infinity<T>() : time, t, minimum(time, end), StatusCode::success};
}

/// The time until the pair of a bound is nearest, by its t.
template <class T, int D>
PW85_FUNCTION constexpr T wait_for_nearest(TimeBound<T, D> const &bound) noexcept
{
    auto const &[s, s_velocity, excess, slack, approach, speed] = bound.separation;
    return approach > T(0) ? T(approach / speed) : T(0);
}

/// The first contact of a pair that translates, by items 1 and 2. At a time before the root, the
/// sign of the slope does not tell on which side of t the maximum is.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline TranslationContact<T>
find_translation_contact(TranslatingPair<T, D> const &moving, T const &end) noexcept
{
    T const &ratio = moving.pair.ratio;
    auto state = safeguarded_search(initial_guess(moving.pair), free_translation_steps);
    // accepts contacts slightly after the end, so that rounding does not decide about a contact at
    // the end
    T const latest = end + T(0x1p-20) * end;
    T time = T(0);
    bool last = false;
    for (int i = 0; i < max_translation_steps; ++i) {
        T const t = state.t;
        auto const bound = time_bound(moving, t, time);
        T const reached = time + bound.wait;
        if (bound.outcome == BoundOutcome::none)
            return {infinity<T>(), t, minimum(end, T(time + wait_for_nearest(bound))),
                    StatusCode::success};
        if (last || reached > latest) return contact_until(end, reached, t);
        bool const before = is_far(bound.separation, bound.target) && reached > time;
        Jet<T> const jet = jet_then(moving, bound, t);
        Slope<T> const s = slope(jet, ratio, t);
        auto const trusted = trust(newton_step(s), s);
        T const next = next_guess(jet, trusted, ratio, t, fixed_point_image(jet, ratio));
        if (!before) take_bound(state, s.difference < T(0), t);
        if (!before && tells_delay(bound, trusted.size))
            return contact_until(
                end, T(reached + delay(s, ratio, t, root_then(bound), bound.target)), next);
        time = reached;
        last = !before && (trusted.size <= last_translation_step<T>() ||
                           is_narrow(state, last_translation_step<T>()));
        if (before || last)
            go_to(state, next);
        else
            take_step(state, next, trusted.size);
    }
    return all_nan<TranslationContact<T>>(StatusCode::no_convergence);
}

} // namespace pw85::detail

#endif
