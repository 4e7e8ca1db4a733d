// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof that two ellipsoids that rotate and grow do not touch for some time. From the state at
/// one time, bound_at_lambda() and safe_time() compute a time up to which there is no contact. This
/// is the step of the search in rotation.hpp.
///
/// In the units of a Pair, let M = Q1 + t Q2 for some t, and let `target` be the value of rᵀM⁻¹r
/// where f = 1 (translation.hpp). For any vector s, (s·r)² <= sᵀMs rᵀM⁻¹r. So there is no contact
/// while s·r > √(target sᵀMs), for any s and t. The best s and t are those of the maximum of f,
/// where the bound depends only to second order on their errors.
#ifndef PW85_MOTION_TURNING_BOUND_HPP_INCLUDED
#define PW85_MOTION_TURNING_BOUND_HPP_INCLUDED

#include <pw85/motion/translation.hpp>

namespace pw85::detail {

/// Two bodies in the units of a Pair at some time, side by side, and how the centre of the second
/// moves relative to that of the first.
template <class T, int D> struct BodyPair {
    Vector<T, D> r12;
    Body<TwoLanes<T>, D> bodies;
    T ratio; ///< as in a Pair
    Vector<T, D> velocity;
    T tangent; ///< f of a tangent pair
};

/// The largest step, for which remainders are bounded.
template <class T> PW85_FUNCTION constexpr T longest_advance() noexcept { return T(1); }

/// 1 and t: the weights of both bodies in M.
template <class T> PW85_FUNCTION constexpr TwoLanes<T> weights_in_m(T const &t) noexcept
{
    return TwoLanes<T>(T(1), t);
}

/// M of a pair at some t, and its solution M⁻¹r.
template <class T, int D> struct Blend {
    SymmetricMatrix<T, D> m;
    Factorization<T, D> factors;
    Vector<T, D> s;
};

template <class T, int D>
PW85_FUNCTION inline Blend<T, D> blend_at(BodyPair<T, D> const &moving, T const &t) noexcept
{
    auto const m = sum_of_lanes(weights_in_m(t) * form_of(moving.bodies));
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    return {m, factors, solve(factors, moving.r12)};
}

/// f at one time and t, and Newton's step in log t to the maximum of f.
template <class T, int D> struct StateAtTime {
    Blend<T, D> blend;
    Vector<TwoLanes<T>, D> products; ///< (Q - κI) s of each body
    TwoLanes<T> extents;             ///< sᵀQs of each body
    T excess, slack, target;         ///< as in a SeparationBound
    /// bound on the error of the excess from rounding of forms that have rotated
    T turning_slack;
    T newton, per_difference; ///< the step, and the step per h
    bool nearby;              ///< true if both are reliable
};

/// An upper bound on the largest eigenvalue of a form that rotates. It is zero for a form that does
/// not rotate, which has no error of rotation.
template <class T, int D> PW85_FUNCTION constexpr T most_that_turns(Body<T, D> const &body) noexcept
{
    return select(body.rate > T(0), body.most, T(0));
}

template <class T, int D> PW85_FUNCTION inline StateAtTime<T, D>
state_at_time(BodyPair<T, D> const &moving, T const &t) noexcept
{
    auto const &bodies = moving.bodies;
    T const ratio = moving.ratio;
    auto const blend = blend_at(moving, t);
    auto const s = converted<TwoLanes<T>>(blend.s), y = product(bodies.rest, s);
    T const square = dot(blend.s, blend.s);
    auto const extents = dot(s, y) + bodies.least * TwoLanes<T>(square);
    Vector<T, D> q2s = blend.s;
    for (int i = 0; i < D; ++i) q2s[i] = second_of(y[i]) + second_of(bodies.least) * q2s[i];
    T const c = inverse_form(blend.factors, q2s);
    Slope<T> const of_h = slope(first_jet(first_of(extents), second_of(extents), c, t), ratio, t);
    T const target = target_at(moving.tangent, ratio, t), per = of_h.weight / of_h.k;
    return {blend,
            y,
            extents,
            dot(blend.s, moving.r12) - target,
            slack_of_form(blend.m, blend.s),
            target,
            T(12 * D * unit_roundoff<T>()) * square *
                sum_of_lanes(weights_in_m(t) * most_that_turns(bodies)),
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

/// s(x) = s0 + x s1, and the coefficients of |s(x)|². From a time with s0 = M⁻¹r on, s1 is the
/// derivative of M⁻¹r. So s rotates with the plane between the ellipsoids.
template <class T, int D> struct NormalPath {
    Vector<T, D> s0, s1;
    T square[3];
};

template <class T, int D> PW85_FUNCTION constexpr NormalPath<T, D>
normal_path(Vector<T, D> const &s0, Vector<T, D> const &s1) noexcept
{
    return {s0, s1, {dot(s0, s0), T(2) * dot(s0, s1), dot(s1, s1)}};
}

/// sᵀQs of one body along a NormalPath: the coefficients of a polynomial, and the factor of x³ in
/// the remainder of its root.
template <class T> struct Extent {
    T square[5], remainder;
};

/// Computes an Extent. In the frame of an ellipsoid, s is m(x) = (1 + γx) R(-x) s(x), with a
/// rotation R and the growth rate γ. Let W y = ω × y, and let c2 = ½W²s0 - Ws1 be the part of R(-x)
/// s(x) of second order in x. The third derivative of R(-x) s(x) is R(-x) W (Ws1 - 2 c2 - x W²s1).
/// So its Taylor polynomial of degree two lacks at most x³ω (|Ws1 - 2 c2|/6 + xω |Ws1|/24).
///
/// The root of sᵀQs is a norm of m. Let all eigenvalues of Q be between κ and λ, and let Q = (Q -
/// κI) + κI. The second part contributes κ(1 + γx)²|s|² exactly. The root of the first part differs
/// from that of the Taylor polynomial by at most √(λ - κ) times the remainder of m.
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

/// The coefficients of P/N(0), where P is positive only where there is no contact. The first is the
/// excess of f over 1 in the units of `target`. The rounding errors that grow with x² have been
/// subtracted (noise_of_step()).
///
/// The root of a sum of squares is a norm. So, by the triangle inequality, the remainders of both
/// bodies (Extent) show that there is no contact while N - ρx³ > √q. Here N = s·r, q is target sᵀMs
/// from the polynomials, and ρ² is target times the sum of the squares of the remainders' factors.
/// The condition holds while P = (N - ρx³)² - q, of degree six, stays positive.
template <class T> struct Clearance {
    T p[7];
};

/// The part of the rounding errors of P that grows with x², for one body.
///
/// P is a difference of sums. Far from contact, s of slender ellipsoids is large. The rounding
/// errors of f may then be larger than 1, although they are tiny at the contact. So P must exceed a
/// bound on its rounding errors. In the frame of an ellipsoid, m(x) - s0 is at most x (1 + |γ|)(1 +
/// ω + |γ|)(|s1| + (ω + |γ|) |s0|) long for x <= 1. So the errors are at most those at s0 and this
/// bound times x².
///
/// slack_of_form() bounds the errors of f by 4 u cond; the most that was seen is 0.35 of this. A
/// square (a + b)² is at most 10/7 a² + 10/3 b². So the errors are less than half of the slack and
/// 5/4 of this bound, with |s_i| <= |s| and the largest eigenvalue for the diagonal.
template <class T, int D>
PW85_FUNCTION inline T noise_of_step(Body<T, D> const &body, NormalPath<T, D> const &path) noexcept
{
    T const growth = absolute(body.growth), rate = body.rate + growth;
    T const change = (T(1) + growth) * (T(1) + rate) *
                     (square_root(path.square[2]) + rate * square_root(path.square[0]));
    return T(15 * D * unit_roundoff<T>()) * body.most * change * change;
}

template <class T, int D> PW85_FUNCTION inline Clearance<T>
clearance(BodyPair<T, D> const &moving, StateAtTime<T, D> const &state,
          NormalPath<T, D> const &path, Extent<TwoLanes<T>> const &extents,
          TwoLanes<T> const &noises, T const &t) noexcept
{
    auto const weights = weights_in_m(t);
    T const target = state.target, n0 = state.excess + target,
            n1 = dot(path.s1, moving.r12) + dot(path.s0, moving.velocity),
            n2 = dot(path.s1, moving.velocity), unit = T(1) / n0;
    T const squares = sum_of_lanes(weights * (extents.remainder * extents.remainder));
    T const rho = square_root(T(target * squares));
    T const noise = sum_of_lanes(weights * noises);
    T q[5];
    for (int k = 1; k < 5; ++k) q[k] = target * sum_of_lanes(weights * extents.square[k]);
    return {{state.excess, T(2) * n1 - unit * q[1], T(2) * n2 + unit * (n1 * n1 - q[2]) - noise,
             unit * (T(2) * n1 * n2 - q[3]) - T(2) * rho, unit * (n2 * n2 - T(2) * n1 * rho - q[4]),
             T(-2) * unit * n2 * rho, unit * rho * rho}};
}

/// The excess of f over 1 minus its rounding errors. The least possible slack at a contact, for
/// which ΣM_ii s_i² = sᵀMs, is not subtracted, because a pair counts as touching up to this slack.
/// So the search for well-conditioned pairs ends at f = 1.
template <class T, int D>
PW85_FUNCTION inline T certain_excess(StateAtTime<T, D> const &state) noexcept
{
    T const hidden = T(12 * D * unit_roundoff<T>()) * state.target;
    return maximum(state.excess, state.slack) - T(0.5) * maximum(T(0), T(state.slack - hidden));
}

/// A time up to which P is positive, near its first root, from the excess at its start. For x <= X,
/// a power xᵏ is at most X^(k-2) x². So a parabola bounds P from below, and its first root has a
/// closed form. X decreases until it is near the root of the parabola. If the least value of a
/// parabola is positive and below the slack, the result is the time of this value, at which the
/// pair may touch.
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

/// A bound that is valid from the time of a state: P, and the rate at which log t of the maximum of
/// f changes with time.
template <class T> struct BoundAtLambda {
    Clearance<T> clearance;
    T rate;
};

template <class T, int D> PW85_FUNCTION inline BoundAtLambda<T>
bound_at_lambda(BodyPair<T, D> const &moving, StateAtTime<T, D> const &state, T const &t) noexcept
{
    auto const &bodies = moving.bodies;
    auto const &blend = state.blend;
    auto const s0 = converted<TwoLanes<T>>(blend.s);
    auto const responses = respond(bodies, s0, state.products);
    auto const s1 =
        solve(blend.factors, moving.velocity - sum_of_lanes(weights_in_m(t) * responses.change));
    auto const path = normal_path(s0, converted<TwoLanes<T>>(s1));
    auto const extents = extent(bodies, path, responses);
    auto const changes = extents.square[1] / state.extents;
    T const change_of_h = T(0.5) * (second_of(changes) - first_of(changes));
    return {clearance(moving, state, NormalPath<T, D>{blend.s, s1, {}}, extents,
                      noise_of_step(bodies, path), t),
            -change_of_h * state.per_difference};
}

} // namespace pw85::detail

#endif
