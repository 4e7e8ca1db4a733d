/// @file
/// The first contact of two ellipsoids that turn and grow. All steps in time but the last, tiny one are proved free of contact.
///
/// In the units of a Pair, with M = Q1 + t Q2 for some t, and `target` the value of rᵀM⁻¹r where f = 1 (passage.hpp):
///
/// 1. For any vector s, (s·r)² <= sᵀMs rᵀM⁻¹r. So there is no contact while s·r > √(target sᵀMs), whatever s and t are. The best s
///    and t are those of the maximum of f, where their errors count squared.
/// 2. From a time with s0 = M⁻¹r on, s(x) = s0 + x s1 is used, where s1 is the derivative of M⁻¹r. So s turns with the plane
///    between the ellipsoids. In the frame of an ellipsoid, s is m(x) = (1 + γx) R(-x) s(x), with a rotation R and the growth rate
///    γ. With W y = ω × y and the part of R(-x) s(x) of second order in x, c2 = ½W²s0 - Ws1, its third derivative is R(-x) W (Ws1 -
///    2 c2 - x W²s1): its Taylor polynomial of degree two lacks at most x³ω (|Ws1 - 2 c2|/6 + xω |Ws1|/24).
/// 3. The root of sᵀQs is a norm of m. Let all eigenvalues of Q be between κ and λ, and let Q = (Q - κI) + κI. The second part
///    contributes κ(1 + γx)²|s|² exactly. The root of the first part differs from that of the Taylor polynomial by at most √(λ - κ)
///    times the remainder of m.
/// 4. The root of a sum of squares is a norm, too. So, by the triangle inequality, there is no contact while N - ρx³ > √q. Here N =
///    s·r, q is target sᵀMs from the polynomials, and ρ² is target times the sum of the squares of the remainders' factors. The
///    condition holds while P = (N - ρx³)² - q, of degree six, stays positive.
/// 5. For x <= X, a power xᵏ is at most X^(k-2) x². So a parabola bounds P from below, and its first root has a closed form.
#ifndef PW85_MOTION_ADVANCE_HPP_INCLUDED
#define PW85_MOTION_ADVANCE_HPP_INCLUDED

#include <pw85/motion/approach.hpp>

namespace pw85::detail {

/// Two bodies in the units of a Pair at some time, and how the centre of the second moves relative to that of the first.
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

template <class T, int D> PW85_FUNCTION inline MovingPair<T, D> moving_pair(BodyPair<T, D> const &start) noexcept
{
    auto const &[body1, body2] = start.bodies;
    T const unit = square_root(start.tangent); // of forms over that of r12
    return {
        start, {turning_form(body1), turning_form(body2)}, reach_of_spheres(body1, unit, body2, T(unit / start.ratio))};
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

/// How long the spheres around the ellipsoids stay apart from some time on; zero if they are too near for a step that is worth its
/// cost. The moment errs by at most 4 u |r| |v|, which the margin of the radii covers if |r| is below 2^40 times their sum.
template <class T, int D> PW85_FUNCTION inline T time_apart(MovingPair<T, D> const &moving, T const &time) noexcept
{
    Vector<T, D> const &velocity = moving.start.velocity, r12 = add_scaled(moving.start.r12, time, velocity);
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

template <class T, int D> PW85_FUNCTION inline Blend<T, D> blend_at(BodyPair<T, D> const &pair, T const &t) noexcept
{
    Body<T, D> const &body1 = pair.bodies[0], &body2 = pair.bodies[1];
    auto const m = plus_multiple_of_identity(blend(body1.rest, t, body2.rest), T(body1.least + t * body2.least));
    auto const factors = factorize(m, T(unit_roundoff<T>()));
    return {m, factors, solve(factors, pair.r12)};
}

/// Products of a body with s0: (Q - κI) s0, ω × s0, and the derivative of Qs0.
template <class T, int D> struct Response {
    Vector<T, D> product, turned, change;
};

template <class T, int D>
PW85_FUNCTION constexpr Response<T, D> respond(Body<T, D> const &body, Vector<T, D> const &s) noexcept
{
    Vector<T, D> const y = product(body.rest, s), w = turning(body.omega, s);
    Vector<T, D> const outer = turning(body.omega, y), inner = product(body.rest, w);
    Response<T, D> result{y, w, {}};
    for (int i = 0; i < D; ++i)
        result.change[i] = outer[i] - inner[i] + T(2) * body.growth * (y[i] + body.least * s[i]);
    return result;
}

/// s(x) = s0 + x s1, and the coefficients of |s(x)|².
template <class T, int D> struct Path {
    Vector<T, D> s0, s1;
    T square[3];
};

template <class T, int D>
PW85_FUNCTION constexpr Path<T, D> make_path(Vector<T, D> const &s0, Vector<T, D> const &s1) noexcept
{
    return {s0, s1, {dot(s0, s0), T(2) * dot(s0, s1), dot(s1, s1)}};
}

/// sᵀQs by items 2 and 3: the coefficients of a polynomial, and the factor of x³ in the remainder of its root.
template <class T> struct Extent {
    T square[5], remainder;
};

template <class T, int D> PW85_FUNCTION inline Extent<T> extent(Body<T, D> const &body, Path<T, D> const &path,
                                                                Response<T, D> const &response) noexcept
{
    Vector<T, D> const w1 = turning(body.omega, path.s1);
    Vector<T, D> const c1 = path.s1 - response.turned;
    Vector<T, D> const c2 = turning(body.omega, T(0.5) * response.turned - path.s1);
    Vector<T, D> const z1 = add_scaled(c1, body.growth, path.s0), z2 = add_scaled(c2, body.growth, c1);
    Vector<T, D> const &y0 = response.product, y1 = product(body.rest, z1), y2 = product(body.rest, z2);
    T const g = body.growth, twice = g + g, square = g * g, k = body.least, step = longest_advance<T>();
    T const sixth = T(1) / T(6),
            remainder = magnitude(add_scaled(w1, T(-2), c2)) + T(0.25) * step * body.rate * magnitude(w1);
    T const lack = body.rate * sixth * remainder;
    T const most = (T(1) + maximum(T(0), g) * step) * lack + absolute(g) * magnitude(c2);
    auto const &[l0, l1, l2] = path.square;
    return {{dot(path.s0, y0) + k * l0, T(2) * dot(z1, y0) + k * (l1 + twice * l0),
             T(2) * dot(z2, y0) + dot(z1, y1) + k * (l2 + twice * l1 + square * l0),
             T(2) * dot(z1, y2) + k * (twice * l2 + square * l1), dot(z2, y2) + k * square * l2},
            square_root(T(body.most - body.least)) * most};
}

/// The coefficients of P/N(0) of item 4. The first is the excess of f over 1 in the units of `target`.
template <class T> struct Clearance {
    T p[7];
};

template <class T, int D>
PW85_FUNCTION inline Clearance<T> clearance(BodyPair<T, D> const &pair, Path<T, D> const &path, Extent<T> const &e1,
                                            Extent<T> const &e2, T const &t, T const &target) noexcept
{
    T const n0 = dot(path.s0, pair.r12), n1 = dot(path.s1, pair.r12) + dot(path.s0, pair.velocity),
            n2 = dot(path.s1, pair.velocity), unit = T(1) / n0;
    T const squares = e1.remainder * e1.remainder + t * e2.remainder * e2.remainder;
    T const rho = square_root(T(target * squares));
    T q[5];
    for (int k = 1; k < 5; ++k) q[k] = target * (e1.square[k] + t * e2.square[k]);
    return {{n0 - target, T(2) * n1 - unit * q[1], T(2) * n2 + unit * (n1 * n1 - q[2]),
             unit * (T(2) * n1 * n2 - q[3]) - T(2) * rho, unit * (n2 * n2 - T(2) * n1 * rho - q[4]),
             T(-2) * unit * n2 * rho, unit * rho * rho}};
}

/// A time up to which P is positive, near its first root (item 5). X decreases until it is near the root of the parabola.
template <class T>
PW85_FUNCTION inline T safe_time(Clearance<T> const &clearance, T const &slack, T const &end) noexcept
{
    auto const &p = clearance.p;
    T const excess = maximum(p[0], slack), approach = T(-0.5) * p[1];
    T lower = T(0), upper = minimum(end, first_root(excess, approach, p[2], slack)), x = upper;
    for (int i = 0; i < 4 && lower <= T(0.9) * upper; ++i) {
        T tail = minimum(T(0), p[6]);
        for (int k = 5; k >= 3; --k) tail = minimum(T(0), p[k]) + x * tail;
        T const root = first_root(excess, approach, T(p[2] + x * tail), slack);
        if (root < x) upper = x;
        lower = maximum(lower, minimum(root, x));
        x = square_root(T(lower * upper));
    }
    return lower;
}

/// A bound on how much too small P may be after a step x. It is the sum of the terms that are bounds themselves, and of what an
/// error of log t takes from f: at most a quarter of its square, since f'' = -2 λ(1-λ) h' f at the maximum (contact/iteration.hpp).
template <class T> PW85_FUNCTION inline T error_of_step(Clearance<T> const &clearance, T const &target, T const &x,
                                                        T const &log_t) noexcept
{
    T sum = absolute(clearance.p[6]);
    for (int k = 5; k >= 3; --k) sum = absolute(clearance.p[k]) + x * sum;
    return x * x * x * sum + T(0.25) * log_t * log_t * target;
}

/// Newton's step in log t to the maximum of f, the change of this maximum with time, and whether to trust both.
template <class T> struct Drift {
    T newton, rate;
    bool near;
};

template <class T, int D> PW85_FUNCTION inline Drift<T> find_drift(BodyPair<T, D> const &pair, Blend<T, D> const &blend,
                                                                   Extent<T> const &e1, Extent<T> const &e2,
                                                                   Vector<T, D> const &product2, T const &t) noexcept
{
    T const a = e1.square[0], b = e2.square[0];
    Vector<T, D> const q = add_scaled(product2, pair.bodies[1].least, blend.s);
    Slope<T> const s = slope(first_jet(a, b, inverse_form(blend.factors, q), t), pair.ratio, t);
    T const change = T(0.5) * (e2.square[1] / b - e1.square[1] / a), per = s.weight / s.k; // of h; over h'
    return {-(s.difference / s.sum) * per, -change * per, is_near(s)};
}

/// What one time and t show.
template <class T> struct View {
    Clearance<T> clearance;
    T slack, target; ///< as in a Passage
    Drift<T> drift;
};

template <class T, int D> PW85_FUNCTION inline View<T> view(BodyPair<T, D> const &pair, T const &t) noexcept
{
    auto const blend = blend_at(pair, t);
    auto const i1 = respond(pair.bodies[0], blend.s), i2 = respond(pair.bodies[1], blend.s);
    Vector<T, D> const change = add_scaled(i1.change, t, i2.change);
    auto const path = make_path(blend.s, solve(blend.factors, pair.velocity - change));
    auto const e1 = extent(pair.bodies[0], path, i1), e2 = extent(pair.bodies[1], path, i2);
    T const target = target_at(pair.tangent, pair.ratio, t);
    return {clearance(pair, path, e1, e2, t, target), slack_of_form(blend.m, blend.s), target,
            find_drift(pair, blend, e1, e2, i2.product, t)};
}

/// t at the maximum of f.
template <class T, int D> PW85_FUNCTION inline T maximiser(BodyPair<T, D> const &pair) noexcept
{
    auto const m = maximize(Pair<T, D>{pair.r12, form_of(pair.bodies[0]), form_of(pair.bodies[1]), pair.ratio});
    T const t = m.lambda / m.complement / pair.ratio / pair.ratio;
    return maximum(smallest_number<T>(), minimum(largest_number<T>(), t));
}

/// Whether the numbers are finite, and the orientations are known. Neither is the fault of the arguments: sizes may grow out of the
/// range of T, and angles may grow until their rounding errors exceed a thousandth of a radian.
template <class T, int D>
PW85_FUNCTION inline bool is_known(BodyPair<T, D> const &pair, View<T> const &view, T const &time) noexcept
{
    return view.clearance.p[0] * T(0) == T(0) &&
           maximum(pair.bodies[0].rate, pair.bodies[1].rate) * time <= longest_turn<T>();
}

/// Whether the excess of f over 1 is above rounding.
template <class T> PW85_FUNCTION constexpr bool is_clear(View<T> const &view) noexcept
{
    return view.clearance.p[0] > view.slack;
}

/// Whether a view at a t that was carried over from an earlier time suffices: f is at its maximum, or near its maximum and clear.
template <class T> PW85_FUNCTION constexpr bool is_enough(View<T> const &view) noexcept
{
    Drift<T> const &drift = view.drift;
    return drift.near && (is_clear(view) || drift.newton * drift.newton <= T(unit_roundoff<T>()));
}

/// Whether a pair that is not clear separates, and overlaps by no more than a pair that has just collided.
template <class T> PW85_FUNCTION constexpr bool just_separates(View<T> const &view) noexcept
{
    return view.clearance.p[1] > T(0) && view.clearance.p[0] >= -T(touching_tolerance) * view.slack;
}

/// Whether a step of x in time and one in log t lead to the contact, to rounding.
template <class T>
PW85_FUNCTION constexpr bool ends_at_contact(View<T> const &view, T const &x, T const &log_t) noexcept
{
    return view.drift.near && view.clearance.p[1] < T(0) && x < longest_advance<T>() &&
           error_of_step(view.clearance, view.target, x, log_t) <= view.slack;
}

/// The largest number of steps of first_contact(): some thousand radians of rotation without contact.
inline constexpr int max_advances = 10000;

/// first_contact() of a valid pair, in a unit of time in which its rates are below 2. A pair that has been apart touches when it is
/// no longer clear. A pair that has not been apart may separate first. t follows the maximum of f; if it loses the maximum, the
/// maximum is sought anew.
template <class T, int D>
PW85_FUNCTION inline FirstContact<T> advance_to_contact(MovingPair<T, D> const &moving, T const &end) noexcept
{
    T time = T(0), t = T(0);
    bool apart = false, lost = true;
    for (int i = 0; i < max_advances; ++i) {
        T const wait = time_apart(moving, time);
        time = time + wait;
        if (time >= end) return {infinity<T>(), Status::success};
        auto const pair = pair_at(moving, time);
        bool const sought = lost || wait > T(0);
        if (sought) t = maximiser(pair);
        View<T> const v = view(pair, t);
        if (!is_known(pair, v, time)) return all_nan<FirstContact<T>>(Status::no_convergence);
        lost = !(sought || is_enough(v));
        if (lost) continue;
        if (!is_clear(v) && (apart || !just_separates(v))) return {time, Status::success};
        apart = apart || is_clear(v);
        T const x = safe_time(v.clearance, v.slack, minimum(T(end - time), longest_advance<T>()));
        T const log_t = v.drift.newton + v.drift.rate * x, next = time + x;
        if (next >= end) return {infinity<T>(), Status::success};
        if (ends_at_contact(v, x, log_t) || !(next > time)) return {next, Status::success};
        time = next;
        lost = !(v.drift.near && absolute(log_t) < T(1));
        t = t * exponential(Step<T>{log_t, T(1)});
    }
    return all_nan<FirstContact<T>>(Status::no_convergence);
}

} // namespace pw85::detail

#endif
