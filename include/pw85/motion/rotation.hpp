// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The first contact of two ellipsoids that turn and grow. All steps in time are proved free of
/// contact, and the search ends where f is 1 to rounding at the time itself.
///
/// In the units of a Pair, with M = Q1 + t Q2 for some t, and `target` the value of rᵀM⁻¹r where f
/// = 1 (translation.hpp):
///
/// 1. For any vector s, (s·r)² <= sᵀMs rᵀM⁻¹r. So there is no contact while s·r > √(target sᵀMs),
///    whatever s and t are. The best s and t are those of the maximum of f, where their errors
///    count squared.
/// 2. From a time with s0 = M⁻¹r on, s(x) = s0 + x s1 is used, where s1 is the derivative of M⁻¹r.
///    So s turns with the plane between the ellipsoids. In the frame of an ellipsoid, s is m(x) =
///    (1 + γx) R(-x) s(x), with a rotation R and the growth rate γ. With W y = ω × y and the part
///    of R(-x) s(x) of second order in x, c2 = ½W²s0 - Ws1, its third derivative is R(-x) W (Ws1 -
///    2 c2 - x W²s1): its Taylor polynomial of degree two lacks at most x³ω (|Ws1 - 2 c2|/6 + xω
///    |Ws1|/24).
/// 3. The root of sᵀQs is a norm of m. Let all eigenvalues of Q be between κ and λ, and let Q =
///    (Q - κI) + κI. The second part contributes κ(1 + γx)²|s|² exactly. The root of the first part
///    differs from that of the Taylor polynomial by at most √(λ - κ) times the remainder of m.
/// 4. The root of a sum of squares is a norm, too. So, by the triangle inequality, there is no
///    contact while N - ρx³ > √q. Here N = s·r, q is target sᵀMs from the polynomials, and ρ² is
///    target times the sum of the squares of the remainders' factors. The condition holds while P =
///    (N - ρx³)² - q, of degree six, stays positive.
/// 5. For x <= X, a power xᵏ is at most X^(k-2) x². So a parabola bounds P from below, and its
///    first root has a closed form.
/// 6. P is a difference of sums. Slender ellipsoids have a large s far from where they touch. There
///    the rounding errors of f may be larger than 1, although they are tiny at the contact. So P
///    must exceed a bound on its rounding errors. In the frame of an ellipsoid, m(x) - s0 is at
///    most x (1 + |γ|)(1 + ω + |γ|)(|s1| + (ω + |γ|) |s0|) long for x <= 1. So the errors are at
///    most those at s0 and what noise_of_step() bounds, times x².
#ifndef PW85_MOTION_ROTATION_HPP_INCLUDED
#define PW85_MOTION_ROTATION_HPP_INCLUDED

#include <pw85/motion/approach.hpp>

namespace pw85::detail {

/// Two bodies in the units of a Pair at some time, and how the centre of the second moves relative
/// to that of the first.
template <class T, int D> struct BodyPair {
    Vector<T, D> r12, velocity;
    Body<T, D> bodies[2];
    T ratio;
    T tangent; ///< f of a tangent pair
};

template <class T, int D> struct MovingPair {
    BodyPair<T, D> start;
    TurningForm<T, D> forms[2];
    Reach<T> spheres; ///< of spheres around the bodies at the start
};

template <class T, int D>
PW85_FUNCTION inline MovingPair<T, D> moving_pair(BodyPair<T, D> const &start) noexcept
{
    auto const &[body1, body2] = start.bodies;
    T const unit = square_root(start.tangent); // of forms over that of r12
    return {start,
            {turning_form(body1), turning_form(body2)},
            reach_of_spheres(body1, unit, body2, T(unit / start.ratio))};
}

template <class T, int D>
PW85_FUNCTION inline BodyPair<T, D> pair_at(MovingPair<T, D> const &moving, T const &time) noexcept
{
    auto const &[r12, velocity, bodies, ratio, tangent] = moving.start;
    return {add_scaled(r12, time, velocity),
            velocity,
            {body_at(bodies[0], moving.forms[0], time), body_at(bodies[1], moving.forms[1], time)},
            ratio,
            tangent};
}

/// How long the spheres around the ellipsoids stay apart from some time on; zero if they are too
/// near for a step that is worth its cost. The moment errs by at most 4 u |r| |v|, which the margin
/// of the radii covers if |r| is below 2^40 times their sum.
template <class T, int D>
PW85_FUNCTION inline T time_apart(MovingPair<T, D> const &moving, T const &time) noexcept
{
    Vector<T, D> const &velocity = moving.start.velocity,
                       r12 = add_scaled(moving.start.r12, time, velocity);
    auto const reach = reach_after(moving.spheres, time);
    T const square = dot(r12, r12);
    if (!(square - reach.radius * reach.radius > T(0.0625) * square)) return T(0);
    return meeting_of_spheres(r12, velocity, reach, cross(r12, velocity)).time;
}

/// The largest step, for which remainders are bounded.
template <class T> PW85_FUNCTION constexpr T longest_advance() noexcept { return T(1); }

/// M of a pair at some t, and what is M⁻¹r.
template <class T, int D> struct Blend {
    SymmetricMatrix<T, D> m;
    Factorization<T, D> factors;
    Vector<T, D> s;
};

template <class T, int D>
PW85_FUNCTION inline Blend<T, D> blend_at(BodyPair<T, D> const &pair, T const &t) noexcept
{
    Body<T, D> const &body1 = pair.bodies[0], &body2 = pair.bodies[1];
    auto const m = plus_multiple_of_identity(blend(body1.rest, t, body2.rest),
                                             T(body1.least + t * body2.least));
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    return {m, factors, solve(factors, pair.r12)};
}

/// f at one time and t, and Newton's step in log t to the maximum of f.
template <class T, int D> struct StateAtTime {
    Blend<T, D> blend;
    Vector<T, D> products[2]; ///< (Q - κI) s of each body
    T a, b;                   ///< sᵀQs of each body
    T excess, slack, target;  ///< as in a SeparationBound
    /// what the rounding of forms that have turned can make of the excess
    T turning_slack;
    T newton, per_difference; ///< the step, and the step per h
    bool nearby;              ///< whether to trust both
};

/// The largest eigenvalue of a form that turns, at most. A form that does not turn has no error of
/// rotation.
template <class T, int D> PW85_FUNCTION constexpr T most_that_turns(Body<T, D> const &body) noexcept
{
    return body.rate > T(0) ? body.most : T(0);
}

template <class T, int D> PW85_FUNCTION inline StateAtTime<T, D>
state_at_time(BodyPair<T, D> const &pair, T const &t) noexcept
{
    auto const &[body1, body2] = pair.bodies;
    auto const blend = blend_at(pair, t);
    Vector<T, D> const &s = blend.s, y1 = product(body1.rest, s), y2 = product(body2.rest, s);
    T const square = dot(s, s), a = dot(s, y1) + body1.least * square,
            b = dot(s, y2) + body2.least * square;
    T const bend = inverse_form(blend.factors, add_scaled(y2, body2.least, s));
    Slope<T> const of_h = slope(first_jet(a, b, bend, t), pair.ratio, t);
    T const target = target_at(pair.tangent, pair.ratio, t), per = of_h.weight / of_h.k;
    return {blend,
            {y1, y2},
            a,
            b,
            dot(s, pair.r12) - target,
            slack_of_form(blend.m, s),
            target,
            T(12 * D * unit_roundoff<T>()) * square *
                (most_that_turns(body1) + t * most_that_turns(body2)),
            -(of_h.difference / of_h.sum) * per,
            per,
            is_near(of_h)};
}

/// Products of a body with s0: (Q - κI) s0, ω × s0, and the derivative of Qs0.
template <class T, int D> struct Response {
    Vector<T, D> product, turned, change;
};

template <class T, int D> PW85_FUNCTION constexpr Response<T, D>
respond(Body<T, D> const &body, Vector<T, D> const &s, Vector<T, D> const &y) noexcept
{
    Vector<T, D> const w = turning(body.omega, s);
    Vector<T, D> const outer = turning(body.omega, y), inner = product(body.rest, w);
    Response<T, D> result{y, w, {}};
    for (int i = 0; i < D; ++i)
        result.change[i] = outer[i] - inner[i] + T(2) * body.growth * (y[i] + body.least * s[i]);
    return result;
}

/// s(x) = s0 + x s1, and the coefficients of |s(x)|².
template <class T, int D> struct NormalPath {
    Vector<T, D> s0, s1;
    T square[3];
};

template <class T, int D> PW85_FUNCTION constexpr NormalPath<T, D>
normal_path(Vector<T, D> const &s0, Vector<T, D> const &s1) noexcept
{
    return {s0, s1, {dot(s0, s0), T(2) * dot(s0, s1), dot(s1, s1)}};
}

/// sᵀQs by items 2 and 3: the coefficients of a polynomial, and the factor of x³ in the remainder
/// of its root.
template <class T> struct Extent {
    T square[5], remainder;
};

template <class T, int D>
PW85_FUNCTION inline Extent<T> extent(Body<T, D> const &body, NormalPath<T, D> const &path,
                                      Response<T, D> const &response) noexcept
{
    Vector<T, D> const w1 = turning(body.omega, path.s1);
    Vector<T, D> const c1 = path.s1 - response.turned;
    Vector<T, D> const c2 = turning(body.omega, T(0.5) * response.turned - path.s1);
    Vector<T, D> const z1 = add_scaled(c1, body.growth, path.s0),
                       z2 = add_scaled(c2, body.growth, c1);
    Vector<T, D> const &y0 = response.product, y1 = product(body.rest, z1),
                       y2 = product(body.rest, z2);
    T const g = body.growth, twice = g + g, square = g * g, k = body.least,
            step = longest_advance<T>();
    T const sixth = T(1) / T(6), remainder = magnitude(add_scaled(w1, T(-2), c2)) +
                                             T(0.25) * step * body.rate * magnitude(w1);
    T const lack = body.rate * sixth * remainder;
    T const most = (T(1) + maximum(T(0), g) * step) * lack + absolute(g) * magnitude(c2);
    auto const &[l0, l1, l2] = path.square;
    return {{dot(path.s0, y0) + k * l0, T(2) * dot(z1, y0) + k * (l1 + twice * l0),
             T(2) * dot(z2, y0) + dot(z1, y1) + k * (l2 + twice * l1 + square * l0),
             T(2) * dot(z1, y2) + k * (twice * l2 + square * l1), dot(z2, y2) + k * square * l2},
            square_root(T(body.most - body.least)) * most};
}

/// The coefficients of P/N(0) of item 4. The first is the excess of f over 1 in the units of
/// `target`. The rounding errors of item 6 have been subtracted.
template <class T> struct Clearance {
    T p[7];
};

/// The part of the rounding errors of P that grows with x², for one body (item 6). slack_of_form()
/// bounds those of f by 4 u cond; the most that was seen is 0.35 of this. A square (a + b)² is at
/// most 10/7 a² + 10/3 b². So the errors are less than half of the slack and 5/4 of this bound,
/// with |s_i| <= |s| and the largest eigenvalue for the diagonal.
template <class T, int D>
PW85_FUNCTION inline T noise_of_step(Body<T, D> const &body, NormalPath<T, D> const &path) noexcept
{
    T const growth = absolute(body.growth), rate = body.rate + growth;
    T const change = (T(1) + growth) * (T(1) + rate) *
                     (square_root(path.square[2]) + rate * square_root(path.square[0]));
    return T(15 * D * unit_roundoff<T>()) * body.most * change * change;
}

template <class T, int D> PW85_FUNCTION inline Clearance<T>
clearance(BodyPair<T, D> const &pair, StateAtTime<T, D> const &state, NormalPath<T, D> const &path,
          Extent<T> const &e1, Extent<T> const &e2, T const &t) noexcept
{
    T const target = state.target, n0 = state.excess + target,
            n1 = dot(path.s1, pair.r12) + dot(path.s0, pair.velocity),
            n2 = dot(path.s1, pair.velocity), unit = T(1) / n0;
    T const squares = e1.remainder * e1.remainder + t * e2.remainder * e2.remainder;
    T const rho = square_root(T(target * squares));
    T const noise = noise_of_step(pair.bodies[0], path) + t * noise_of_step(pair.bodies[1], path);
    T q[5];
    for (int k = 1; k < 5; ++k) q[k] = target * (e1.square[k] + t * e2.square[k]);
    return {{state.excess, T(2) * n1 - unit * q[1], T(2) * n2 + unit * (n1 * n1 - q[2]) - noise,
             unit * (T(2) * n1 * n2 - q[3]) - T(2) * rho, unit * (n2 * n2 - T(2) * n1 * rho - q[4]),
             T(-2) * unit * n2 * rho, unit * rho * rho}};
}

/// The excess of f over 1 less its rounding errors (item 6). The least slack at a contact, where
/// ΣM_ii s_i² is sᵀMs, is not subtracted: a contact counts up to there, and well-conditioned pairs
/// end at f = 1.
template <class T, int D>
PW85_FUNCTION inline T certain_excess(StateAtTime<T, D> const &state) noexcept
{
    T const hidden = T(12 * D * unit_roundoff<T>()) * state.target;
    return maximum(state.excess, state.slack) - T(0.5) * maximum(T(0), T(state.slack - hidden));
}

/// A time up to which P is positive, near its first root (item 5), from the excess at its start. A
/// parabola that misses zero by less than the slack leads to its least value, where the pair may
/// touch. X decreases until it is near the root of the parabola.
template <class T> PW85_FUNCTION inline T safe_time(Clearance<T> const &clearance, T const &excess,
                                                    T const &slack) noexcept
{
    auto const &p = clearance.p;
    // a pair that separates has no root at its start
    T const approach = T(-0.5) * p[1], miss = minimum(slack, excess);
    T lower = T(0), upper = minimum(longest_advance<T>(), first_root(excess, approach, p[2], miss)),
      x = upper;
    for (int i = 0; i < 4 && lower <= T(0.9) * upper; ++i) {
        T tail = minimum(T(0), p[6]);
        for (int k = 5; k >= 3; --k) tail = minimum(T(0), p[k]) + x * tail;
        T const root = first_root(excess, approach, T(p[2] + x * tail), miss);
        if (root < x) upper = x;
        lower = maximum(lower, minimum(root, x));
        x = square_root(T(lower * upper));
    }
    return lower;
}

/// What follows from one state on: P, and how log t of the maximum of f changes with time.
template <class T> struct BoundAtLambda {
    Clearance<T> clearance;
    T rate;
};

template <class T, int D> PW85_FUNCTION inline BoundAtLambda<T>
bound_at_lambda(BodyPair<T, D> const &pair, StateAtTime<T, D> const &state, T const &t) noexcept
{
    auto const &[body1, body2] = pair.bodies;
    auto const &blend = state.blend;
    auto const i1 = respond(body1, blend.s, state.products[0]),
               i2 = respond(body2, blend.s, state.products[1]);
    Vector<T, D> const change = add_scaled(i1.change, t, i2.change);
    auto const path = normal_path(blend.s, solve(blend.factors, pair.velocity - change));
    auto const e1 = extent(body1, path, i1), e2 = extent(body2, path, i2);
    T const change_of_h = T(0.5) * (e2.square[1] / state.b - e1.square[1] / state.a);
    return {clearance(pair, state, path, e1, e2, t), -change_of_h * state.per_difference};
}

/// t at the maximum of f.
template <class T, int D> PW85_FUNCTION inline T maximiser(BodyPair<T, D> const &pair) noexcept
{
    auto const m = maximize(
        Pair<T, D>{pair.r12, form_of(pair.bodies[0]), form_of(pair.bodies[1]), pair.ratio});
    T const t = m.lambda / m.complement / pair.ratio / pair.ratio;
    return maximum(smallest_number<T>(), minimum(largest_number<T>(), t));
}

/// Whether the numbers are finite, and orientations and forms are known. None of this is the fault
/// of the arguments: sizes may grow out of the range of T, angles may grow until their rounding
/// errors exceed a thousandth of a radian, and a form may be so slender that no digit of f is left
/// when it has turned.
template <class T, int D> PW85_FUNCTION inline bool
is_known(BodyPair<T, D> const &pair, StateAtTime<T, D> const &state, T const &time) noexcept
{
    T const f = state.excess + state.target;
    return state.excess * T(0) == T(0) &&
           maximum(pair.bodies[0].rate, pair.bodies[1].rate) * time <= longest_turn<T>() &&
           (state.turning_slack <= f || time == T(0));
}

/// Whether the excess of f over 1 is above rounding.
template <class T, int D>
PW85_FUNCTION constexpr bool is_clear(StateAtTime<T, D> const &state) noexcept
{
    return state.excess > state.slack;
}

/// Whether a state at a t that was carried over from an earlier time suffices: f is at its maximum,
/// or near its maximum and clear.
template <class T, int D>
PW85_FUNCTION constexpr bool is_enough(StateAtTime<T, D> const &state) noexcept
{
    return state.nearby &&
           (is_clear(state) || state.newton * state.newton <= T(unit_roundoff<T>()));
}

/// Whether a pair that is not clear separates, and overlaps by no more than a pair that has just
/// collided.
template <class T, int D> PW85_FUNCTION constexpr bool
just_separates(StateAtTime<T, D> const &state, BoundAtLambda<T> const &bound) noexcept
{
    return bound.clearance.p[1] > T(0) && state.excess >= -T(touching_tolerance) * state.slack;
}

/// Where a search ends that no step leads on: at a contact, if f exceeds 1 by no more than it
/// changes while the time changes by its rounding error.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
end_of_steps(StateAtTime<T, D> const &state, BoundAtLambda<T> const &bound, T const &time) noexcept
{
    T const change = T(4 * unit_roundoff<T>()) * time * absolute(bound.clearance.p[1]);
    if (state.excess <= state.slack + change) return {time, StatusCode::success};
    return all_nan<FirstContact<T>>(StatusCode::no_convergence);
}

/// The largest number of steps of first_contact(), a choice: some ten thousand radians of rotation
/// without contact.
inline constexpr int max_advances = 100000;

/// first_contact() of a valid pair, in a unit of time in which its rates are below 2. A pair that
/// has been apart touches when it is no longer clear. A pair that has not been apart may separate
/// first. t follows the maximum of f; if it loses the maximum, the maximum is sought anew. The
/// steps do not depend on the end.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
advance_to_contact(MovingPair<T, D> const &moving, T const &end) noexcept
{
    T time = T(0), t = T(0);
    bool apart = false, lost = true;
    for (int i = 0; i < max_advances; ++i) {
        T const wait = time_apart(moving, time);
        time = time + wait;
        if (time > end || time == infinity<T>()) return {infinity<T>(), StatusCode::success};
        auto const pair = pair_at(moving, time);
        bool const sought = lost || wait > T(0);
        if (sought) t = maximiser(pair);
        auto const here = state_at_time(pair, t);
        if (!is_known(pair, here, time))
            return all_nan<FirstContact<T>>(StatusCode::no_convergence);
        lost = !(sought || is_enough(here));
        if (lost) continue;
        if (apart && !is_clear(here)) return {time, StatusCode::success};
        auto const ahead = bound_at_lambda(pair, here, t);
        if (!is_clear(here) && !just_separates(here, ahead)) return {time, StatusCode::success};
        apart = apart || is_clear(here);
        T const x = safe_time(ahead.clearance, certain_excess(here), here.slack),
                log_t = here.newton + ahead.rate * x;
        if (!(time + x > time)) return end_of_steps(here, ahead, time);
        time = time + x;
        lost = !(here.nearby && absolute(log_t) < T(1));
        t = t * exponential(Step<T>{log_t, T(1)});
    }
    return all_nan<FirstContact<T>>(StatusCode::no_convergence);
}

} // namespace pw85::detail

#endif
