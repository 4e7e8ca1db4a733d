/// @file
/// The time of the first contact of two ellipsoids that translate, rotate about their centres and grow.
///
/// Translation alone, r(time) = r + v·time, with M = Q1 + t Q2 and f as everywhere:
///
/// 1. At fixed λ, f <= μ² is a quadratic polynomial of time: where it is above 1 there is no contact. Its first root bounds the
///    time of contact from below; without a root ahead there is no contact.
/// 2. f is convex in time and concave in λ. So a contact is the largest of these roots, and the side of λ on which larger ones
///    (or a λ without) are is that on which the maximum of f is, at the root's time: a search for the root of h (iteration.hpp)
///    with the time updated at every step. As the root is stationary there, an error in λ counts only squared.
///
/// In general, from a time at which n is the unit normal of the plane that separates the pair when both are scaled by μ, by x:
///
/// 3. n·(r + vx) - (1 + γ1x) w1(x) - (1 + γ2x) w2(x) bounds the gap from below, with the growth rates γ relative to the sizes
///    reached, and the half-widths w = √p along n: p(x) = mᵀQm, where m turns from n about the axis of rotation the other way.
/// 4. With m = m0 + cos θ m1 - sin θ m2 for the angle θ, p = c0 + c1 cos θ + s1 sin θ + c2 cos 2θ + s2 sin 2θ: its second
///    derivative in θ is at most P = √(c1² + s1²) + 4√(c2² + s2²), and w at most the root of c0 + √(c1² + s1²) + √(c2² + s2²).
/// 5. So p <= p(0) + p'(0) θ + ½Pθ², whose root is convex, since p'² <= 2Pp for p >= 0 with p'' <= P; for the same reason
///    |w'| <= √(P/2). This makes the bound of item 3 concave in x: it is positive up to any x where it is, and from zero to where
///    its chord is.
/// 6. Near contact the bound errs in second order, so that stepping to its root converges as Newton's method does, from below.
#ifndef PW85_FIRST_CONTACT_HPP_INCLUDED
#define PW85_FIRST_CONTACT_HPP_INCLUDED

#include <pw85/forms.hpp>
#include <pw85/geometry.hpp>

namespace pw85 {

/// How an ellipsoid moves: its size is 1 + growth·time times that at time 0. In two dimensions the angular velocity has one
/// coordinate.
template <class T, int D> struct Motion {
    Vector<T, D> velocity;
    Vector<T, D == 3 ? 3 : 1> angular_velocity;
    T growth;
};

/// When two ellipsoids touch first.
template <class T> struct FirstContact {
    T time; ///< infinity if they do not
    Status status;
};

template <class T> PW85_FUNCTION constexpr T infinity() noexcept
{
    return T(lane_limit<T, std::numeric_limits<typename ScalarTraits<T>::Lane>::infinity>());
}

/// x + factor·y.
template <class T, int D>
PW85_FUNCTION constexpr Vector<T, D> moved(Vector<T, D> x, T const &factor, Vector<T, D> const &y) noexcept
{
    for (int i = 0; i < D; ++i) x[i] = x[i] + factor * y[i];
    return x;
}

/// Item 1 at one λ: rᵀM⁻¹r = target, the level of f = 1, at time 0, and the coefficients of its change.
template <class T, int D> struct Passage {
    Vector<T, D> s, s_velocity; ///< M⁻¹r, M⁻¹v
    T excess, slack;            ///< rᵀM⁻¹r - target, and what rounding can make of it
    T approach, speed;          ///< -rᵀM⁻¹v, vᵀM⁻¹v
};

/// By how many times its own rounding a pair may overlap and still count as one that only touches: what is left of the rounding
/// of coordinates in a space a hundred times larger than its particles.
inline constexpr int touching_tolerance = 128;

/// What the motion can be at one λ: not to touch, to be too near from the beginning for this λ to tell, or to touch not before
/// some time.
enum class Prospect { none, near, contact };

/// Slack: f errs by 4 u cond at most, the sums of magnitudes that make up cond by Σ|s_i M_ij s_j|, thrice this sum, and it
/// by D Σ M_ii s_i², since |M_ij| <= √(M_ii M_jj).
template <class T, int D>
PW85_FUNCTION inline Passage<T, D> passage(Vector<T, D> const &r12, Vector<T, D> const &velocity, T const &target,
                                           SymmetricMatrix<T, D> const &m, Factorization<T, D> const &factors) noexcept
{
    Vector<T, D> const s = solve(factors, r12), v = solve(factors, velocity);
    T sum = m(0, 0) * s[0] * s[0];
    for (int i = 1; i < D; ++i) sum = sum + m(i, i) * s[i] * s[i];
    return {s, v, dot(r12, s) - target, T(12 * D * unit_roundoff<T>()) * sum, -dot(velocity, s), dot(velocity, v)};
}

/// Where item 1 leads to. A pair that would miss by no more than rounding touches; one that overlaps by no more and separates
/// does not.
template <class T, int D> PW85_FUNCTION inline Prospect prospect(Passage<T, D> const &p, T &time) noexcept
{
    time = T(0);
    if (p.excess > -T(touching_tolerance) * p.slack && p.approach < T(0)) return Prospect::none;
    if (!(p.excess > T(0))) return Prospect::near;
    T const square = p.approach * p.approach - p.speed * p.excess;
    if (!(p.approach > T(0)) || !(square + p.speed * p.slack >= T(0))) return Prospect::none;
    time = p.excess / (p.approach + square_root(maximum(T(0), square)));
    return Prospect::contact;
}

/// The largest number of values of t that find_passage() tries: those of search(), of which each but the last ends the search for
/// some time, and with the time moving along.
inline constexpr int max_passages = 100;

/// A step is small enough where its square, by which the next t errs, is below the root of u.
template <class T> PW85_FUNCTION constexpr T last_passage_step() noexcept
{
    return negative_power_of_two<T>(mantissa_digits<T>() / 4 + 1);
}

/// The first contact in the units of a Pair, where f of a tangent pair is `tangent`; items 1 and 2.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
find_passage(Pair<T, D> const &pair, Vector<T, D> const &velocity, T const &tangent, T const &end) noexcept
{
    T const smallest = smallest_number<T>(), largest = largest_number<T>();
    Bracket<T> bracket{smallest, largest, T(1024)};
    T t = clamp(bracket, initial_guess(pair)), shortest = T(2);
    bool last = false;
    for (int i = 1; i <= max_passages; ++i) {
        auto const m = blend(pair.q1, t, pair.q2);
        auto const factors = factorize(m, T(unit_roundoff<T>()));
        T const target = tangent + tangent / (pair.ratio * pair.ratio * t);
        auto const p = passage(pair.r12, velocity, target, m, factors);
        T time;
        if (prospect(p, time) == Prospect::none || time > end) return {infinity<T>(), Status::success};
        if (last) return {time, Status::success};
        Jet<T> const jet = evaluate_jet(pair, factors, moved(p.s, time, p.s_velocity));
        Slope<T> const s = slope(jet, pair.ratio, t);
        Step<T> const step{-s.difference * s.weight, s.sum * s.k}; // Newton's
        bool const near = is_near(s) && step.denominator > T(0) && is_within(step, T(2));
        T const size = near ? T(absolute(step.numerator) / step.denominator) : T(2);
        T const image = minimum(largest, maximum(smallest, T(square_root(T(jet.a / jet.b)) / pair.ratio)));
        (image > t ? bracket.lower : bracket.upper) = t;
        last = size <= last_passage_step<T>() || is_narrow(bracket);
        bool const halves = size <= T(0.5) * shortest;
        shortest = minimum(shortest, size);
        T const next = t * (near ? exponential(step) : secular_factor(jet, pair.ratio, t));
        t = clamp(bracket, next > smallest && next < largest ? next : image);
        if (i > 5 && !halves && !last) t = probe(bracket);
    }
    return {quiet_nan<T>(), Status::no_convergence};
}

/// first_contact() of a valid pair that only translates.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
first_contact_of_translation(ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity, T const &end) noexcept
{
    T const largest = largest_coordinate(velocity);
    int const unit = largest > T(0) ? binary_exponent(largest) : 0, exponent = scaled.length - unit; // of time
    Vector<T, D> const v = times_power_of_two(scaled.swapped ? times(T(-1), velocity) : velocity, -unit);
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    auto result = find_passage(scaled.pair, v, tangent, times_power_of_two(end, -exponent));
    result.time = times_power_of_two(result.time, exponent);
    return result;
}

/// An ellipsoid that turns at `rate` about a unit axis, and grows.
template <class T, int D> struct Body {
    SymmetricMatrix<T, D> q; ///< at time 0
    Vector<T, D == 3 ? 3 : 1> axis;
    T rate, growth;
};

template <class T, int D>
PW85_FUNCTION inline Body<T, D> to_body(SymmetricMatrix<T, D> const &q, Motion<T, D> const &motion, int unit) noexcept
{
    auto const w = times_power_of_two(motion.angular_velocity, unit);
    T const rate = square_root(dot(w, w));
    return {q, times(rate > T(0) ? T(T(1) / rate) : T(0), w), rate, times_power_of_two(motion.growth, unit)};
}

/// R Q Rᵀ.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D> congruent(SymmetricMatrix<T, D> const &q,
                                                                                  T const (&rotation)[D * D]) noexcept
{
    SymmetricMatrix<T, D> result{};
    for (int i = 0; i < D; ++i) {
        Vector<T, D> row{};
        for (int k = 0; k < D; ++k) row[k] = rotation[D * i + k];
        Vector<T, D> const turned = product(q, row);
        for (int j = 0; j <= i; ++j)
            for (int k = 0; k < D; ++k) result(j, i) = result(j, i) + rotation[D * j + k] * turned[k];
    }
    return result;
}

template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 3> turned(Body<T, 3> const &body, T const &angle) noexcept
{
    using elementary::cos;
    using elementary::sin;
    T const half = T(0.5) * angle, s = sin(half), c = cos(half);
    Vector<T, 4> const quaternion{c, s * body.axis[0], s * body.axis[1], s * body.axis[2]};
    return congruent(body.q, rotation_matrix(quaternion, dot(quaternion, quaternion)).entries);
}

template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 2> turned(Body<T, 2> const &body, T const &angle) noexcept
{
    using elementary::cos;
    using elementary::sin;
    T const c = cos(angle), s = body.axis[0] * sin(angle);
    T const rotation[4] = {c, -s, s, c};
    return congruent(body.q, rotation);
}

/// The form at some time.
template <class T, int D>
PW85_FUNCTION inline SymmetricMatrix<T, D> form_at(Body<T, D> const &body, T const &time) noexcept
{
    T const size = T(1) + body.growth * time;
    return times(size, times(size, body.rate > T(0) ? turned(body, T(body.rate * time)) : body.q));
}

/// The part of n along an axis, and axis × n.
template <class T> PW85_FUNCTION inline void split_normal(Vector<T, 3> const &axis, Vector<T, 3> const &n,
                                                          Vector<T, 3> &along, Vector<T, 3> &across) noexcept
{
    along = times(dot(axis, n), axis);
    across = cross(axis, n);
}

template <class T> PW85_FUNCTION inline void split_normal(Vector<T, 1> const &axis, Vector<T, 2> const &n,
                                                          Vector<T, 2> &along, Vector<T, 2> &across) noexcept
{
    along = {T(0), T(0)};
    across = {-axis[0] * n[1], axis[0] * n[0]};
}

/// The half-width of a turning ellipsoid along n in a time x: at most √(extent² + 2·first·x + second·x²) and `most`, per size.
template <class T> struct HalfWidth {
    T extent, first, second, most;
    T growth;   ///< relative to the size reached
    T rounding; ///< of the extent, in units of u
};

/// Items 4 and 5; q is the form at the time at which x = 0.
template <class T, int D> PW85_FUNCTION inline HalfWidth<T>
half_width(Body<T, D> const &body, T const &time, SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Vector<T, D> m0, m2;
    split_normal(body.axis, n, m0, m2);
    Vector<T, D> const m1 = moved(n, T(-1), m0), q0 = product(q, m0), q1 = product(q, m1), q2 = product(q, m2);
    T const square = positive_form(q, outer_weights(n)), extent = square_root(square), unit = T(1) / square;
    T const f11 = unit * dot(m1, q1), f22 = unit * dot(m2, q2), f01 = unit * dot(m0, q1), f02 = unit * dot(m0, q2),
            f12 = unit * dot(m1, q2), half = T(0.5) * (f11 - f22);
    T const once = T(2) * square_root(T(f01 * f01 + f02 * f02)), twice = square_root(T(half * half + f12 * f12));
    T const most = maximum(T(1), T(unit * dot(m0, q0) + T(0.5) * (f11 + f22) + once + twice));
    return {extent,
            -body.rate * square * (f02 + f12),
            T(0.5) * body.rate * body.rate * square * (once + T(4) * twice),
            extent * square_root(most),
            body.growth / (T(1) + body.growth * time),
            magnitude_of_form(q, n) / extent};
}

/// The bound of item 3 on the gap after a time x, without what second order brings.
template <class T> struct GapBound {
    T gap, rate, rounding; ///< at x = 0, with its derivative and rounding error
    T bend;                ///< of growth and rotation together
    HalfWidth<T> widths[2];
};

/// The bound and its derivative at x.
template <class T> PW85_FUNCTION inline T evaluate(GapBound<T> const &bound, T const &x, T &derivative) noexcept
{
    T value = bound.gap + (bound.rate - bound.bend * x) * x;
    derivative = bound.rate - T(2) * bound.bend * x;
    for (auto const &w : bound.widths) {
        T const rise = (T(2) * w.first + w.second * x) * x;
        T const width = square_root(maximum(T(0), T(w.extent * w.extent + rise)));
        value = value - rise / (width + w.extent);
        derivative = derivative - (w.first + w.second * x) / maximum(width, smallest_number<T>());
    }
    return value;
}

/// A time for which the bound is positive, near the longest if that is short.
template <class T> PW85_FUNCTION inline T safe_time(GapBound<T> const &bound) noexcept
{
    T slope, longest = T(0);
    evaluate(bound, T(0), slope);
    T x = slope < T(0) ? T(bound.gap / -slope) : T(1);
    for (int i = 0; i < 12; ++i) {
        T const value = evaluate(bound, x, slope);
        if (value >= T(0)) {
            longest = x;
            x = x + x;
            continue;
        }
        longest = maximum(longest, T(x * (bound.gap / (bound.gap - value))));
        if (longest >= T(0.9) * x) break;
        x = x - value / slope;
    }
    return longest;
}

/// A time for which the largest half-widths leave a gap.
template <class T> PW85_FUNCTION inline T time_apart(GapBound<T> const &bound) noexcept
{
    T gap = bound.gap, rate = bound.rate;
    for (auto const &w : bound.widths) {
        gap = gap - (w.most - w.extent);
        rate = rate - w.growth * (w.most - w.extent);
    }
    if (!(gap > T(0))) return T(0);
    return rate < T(0) ? T(gap / -rate) : infinity<T>();
}

/// Two bodies, and how the centre of the second moves relative to that of the first.
template <class T, int D> struct MovingPair {
    Vector<T, D> r12, velocity;
    Body<T, D> bodies[2];
};

/// The bound of item 3 at some time; not a number where it does not exist, as for concentric ellipsoids.
template <class T, int D>
PW85_FUNCTION inline GapBound<T> gap_bound(MovingPair<T, D> const &pair, T const &time, Status &status) noexcept
{
    Vector<T, D> const r12 = moved(pair.r12, time, pair.velocity);
    SymmetricMatrix<T, D> const forms[2] = {form_at(pair.bodies[0], time), form_at(pair.bodies[1], time)};
    auto const c = contact(r12, forms[0], forms[1]);
    // Sizes that grow out of the range of T are no fault of the arguments.
    status = c.status == Status::success ? Status::success : Status::no_convergence;
    Vector<T, D> const n = contact_geometry(r12, forms[0], forms[1], c.lambda).normal;
    GapBound<T> bound{dot(n, r12), dot(n, pair.velocity), magnitude_of_dot(n, r12), T(0), {}};
    for (int i = 0; i < 2; ++i) {
        HalfWidth<T> const w = bound.widths[i] = half_width(pair.bodies[i], time, forms[i], n);
        bound.gap = bound.gap - w.extent;
        bound.rate = bound.rate - w.growth * w.extent;
        bound.rounding = bound.rounding + w.rounding;
        bound.bend = bound.bend + absolute(w.growth) * square_root(w.second);
    }
    bound.rounding = T(8 * unit_roundoff<T>()) * bound.rounding;
    return bound;
}

/// The largest number of steps of first_contact(): some thousand radians of rotation without contact.
inline constexpr int max_advances = 10000;

/// first_contact() of a valid pair, in any unit of time in which its rates are not large.
template <class T, int D>
PW85_FUNCTION inline FirstContact<T> advance_to_contact(MovingPair<T, D> const &pair, T const &end) noexcept
{
    T time = T(0);
    for (int i = 0; i < max_advances; ++i) {
        Status status;
        GapBound<T> bound = gap_bound(pair, time, status);
        if (status != Status::success) return {quiet_nan<T>(), status};
        T slope;
        evaluate(bound, T(0), slope);
        if (!(bound.gap >= -T(touching_tolerance) * bound.rounding) || (bound.gap <= bound.rounding && slope <= T(0)))
            return {time, Status::success};
        bound.gap = maximum(bound.gap, bound.rounding);
        T const next = time + maximum(safe_time(bound), time_apart(bound));
        if (next >= end) return {infinity<T>(), Status::success};
        if (!(next > time)) return {time, Status::success};
        time = next;
    }
    return {quiet_nan<T>(), Status::no_convergence};
}

template <class T, int D> PW85_FUNCTION inline bool is_valid_motion(Motion<T, D> const &motion, T const &end) noexcept
{
    bool const finite =
        is_finite(motion.velocity) && is_finite(motion.angular_velocity) && motion.growth * T(0) == T(0);
    return finite && (motion.growth >= T(0) || T(1) + motion.growth * end > T(0));
}

template <class T, int D> PW85_FUNCTION inline bool only_translates(Motion<T, D> const &motion) noexcept
{
    return largest_coordinate(motion.angular_velocity) == T(0) && motion.growth == T(0);
}

/// The largest of the rates at which the two turn and grow.
template <class T, int D>
PW85_FUNCTION inline T fastest(Motion<T, D> const &motion1, Motion<T, D> const &motion2) noexcept
{
    T const turning =
        maximum(largest_coordinate(motion1.angular_velocity), largest_coordinate(motion2.angular_velocity));
    return maximum(turning, maximum(absolute(motion1.growth), absolute(motion2.growth)));
}

/// The larger of an exponent and that of x.
template <class T> PW85_FUNCTION inline int larger_exponent(int exponent, T const &x) noexcept
{
    return x > T(0) && binary_exponent(x) > exponent ? binary_exponent(x) : exponent;
}

/// first_contact() of a valid pair, in the unit of time in which the largest rate is of order one.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FirstContact<T>
first_contact_of_motion(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
                        Motion<T, D> const &motion1, Motion<T, D> const &motion2, T const &end) noexcept
{
    Vector<T, D> const velocity = moved(motion2.velocity, T(-1), motion1.velocity);
    int const none = std::numeric_limits<T>::min_exponent;
    int length = larger_exponent(half_exponent(largest_diagonal(q1)), square_root(largest_diagonal(q2)));
    length = larger_exponent(length, largest_coordinate(r12));
    int const across = larger_exponent(none, largest_coordinate(velocity)) - length;
    int const rate = larger_exponent(across, fastest(motion1, motion2));
    MovingPair<T, D> const pair{
        r12, times_power_of_two(velocity, -rate), {to_body(q1, motion1, -rate), to_body(q2, motion2, -rate)}};
    auto result = advance_to_contact(pair, times_power_of_two(end, rate));
    result.time = times_power_of_two(result.time, -rate);
    return result;
}

template <class T, int D>
PW85_FUNCTION inline FirstContact<T> first_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
                                                   Motion<T, D> const &motion2, T const &end) noexcept
{
    bool const valid = end >= T(0) && is_valid_motion(motion1, end) && is_valid_motion(motion2, end);
    if (!valid) return {quiet_nan<T>(), Status::invalid_argument};
    ScaledPair<T, D> scaled{{r12, q1, q2, T(1)}, 0, 0, false};
    if (!is_ordinary(r12, q1, q2)) {
        Status const status = validate(r12, q1, q2, scaled);
        if (status != Status::success) return {quiet_nan<T>(), status};
    }
    if (largest_coordinate(r12) == T(0)) return {T(0), Status::success};
    if (only_translates(motion1) && only_translates(motion2))
        return first_contact_of_translation(scaled, moved(motion2.velocity, T(-1), motion1.velocity), end);
    return first_contact_of_motion(r12, q1, q2, motion1, motion2, end);
}

} // namespace pw85

#endif
