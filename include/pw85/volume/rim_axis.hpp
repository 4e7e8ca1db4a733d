// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The axis of the rim: a line about which the rim of the common part, where both surfaces
/// intersect, is a curve of one or two points per half-plane. rim_integrals.hpp integrates over the
/// half-planes.
///
/// The pair is in its joint frame (joint_frame.hpp). With homogeneous coordinates X = (x, x0), the
/// unit ball is B(X, X) <= 0 with B = diag(1, ..., 1, -1), and the other ellipsoid is A(X, X) <= 0
/// with A = [P, -b; -bᵀ, γ]. The singular members of the pencil A - tB are at the roots of h(t) =
/// t + γ - Σ b_i²/(p_i - t), with vertices x = (P - t)⁻¹b. With the weights w_i = b_i²/p_i and the
/// shortest axis s, γ is Σ w_i - s and h(t) = t - s - t Σ w_i/(p_i - t). Two of these vertices give
/// the axis (RimAxis).
#ifndef PW85_VOLUME_RIM_AXIS_HPP_INCLUDED
#define PW85_VOLUME_RIM_AXIS_HPP_INCLUDED

#include <pw85/volume/joint_frame.hpp>

namespace pw85::detail {

/// The axis o + z ℓ, with |ℓ| = 1 and o ⟂ ℓ, and the vertices (a_i, height_i) conjugate to it, for
/// which B is the identity.
///
/// In three dimensions let w1, w2 be the vertices of the roots that are nearest to the middle pole
/// of h, on its two sides. Both are outside of the ball, and A(w1, w2) = B(w1, w2) = 0. The points
/// that are conjugate to both are a line through the ball: the axis. It meets the sphere at n1 and
/// n2, and A(w, n) = B(w, n) = 0 for each w of w1, w2 and n of n1, n2. So the pair is, up to a
/// projective map, a ball and an ellipsoid that are symmetric about the two planes through their
/// common axis. A point of the rim is X = p n1 + q n2 + cos ψ w1 + sin ψ w2, for which B(X, X) = 0
/// gives p q, and A(X, X) = 0 a quadratic equation in p².
template <class T, int D> struct RimAxis {
    Vector<T, D> origin, direction;
    Vector<T, D> vertices[std::size_t(D - 1)];
    T heights[std::size_t(D - 1)];
    T roots[std::size_t(D - 1)]; ///< t of each vertex: A(w_i, w_i), in units of the pencil
    T half_chord;                ///< half of the length of the axis inside the ball
    bool touches_at_end;         ///< true if a vertex was moved (give_pole_to_touching_vertex())
};

/// The function h between two poles: the interval (0, gap), with one more pole at gap + far_gap, at
/// a distance δ from the upper pole and ε from the lower pole.
///
/// The poles p_i separate the roots of h. Between two neighbouring poles h falls from ∞ to -∞, so
/// there is an odd number of roots, one or three. As h'(t) = 1 - |x|², the vertex of a root with h'
/// < 0 is outside of the ball. -h''/2 = Σ b_i²/(p_i - t)³ increases between two poles, so h is
/// first convex and then concave there.
///
/// h is computed by the weights (above). On a thin disc w of the shortest axis exceeds the other
/// terms by up to 25 orders of magnitude, and γ less b²/(p - t) cancels it.
template <class T> struct PoleInterval {
    T gap, far_gap;
    T lower, upper, beyond;   ///< b_i² of the pole below, above, and beyond the interval
    T weights[3];             ///< w_i of these
    T lower_pole, upper_pole; ///< p_i
    T shortest, sign;         ///< s, and the sign of t in pole_interval()

    /// h without the terms of the weights, at a distance from the smaller pole: sign (t - s).
    PW85_MEMBER T plain(T const &distance) const noexcept
    {
        return T(sign * T(T(minimum(lower_pole, upper_pole) - shortest) + distance));
    }

    /// Value, slope, half of the negative second derivative, and the sum of its terms by magnitude.
    struct Value {
        T h, slope, half_second, sharpness;
    };

    PW85_MEMBER Value at(T const &delta, T const &epsilon) const noexcept
    {
        T const below = T(1) / epsilon, above = T(1) / delta;
        T farther = T(0);
        if (any_of(beyond > T(0))) farther = T(1) / T(far_gap + delta);
        T const l = T(lower * below), u = T(upper * above), b = T(beyond * farther);
        T const l2 = T(l * below), u2 = T(u * above), b2 = T(b * farther);
        T const towards_upper = u2 * above + b2 * farther, towards_lower = l2 * below;
        T const distance = select(sign > T(0), epsilon, delta),
                t = T(minimum(lower_pole, upper_pole) + distance),
                terms = T(T(weights[0] * below) - T(weights[1] * above)) - T(weights[2] * farther);
        return {T(plain(distance) + T(t * terms)), T(1) - l2 - u2 - b2,
                towards_upper - towards_lower, towards_upper + towards_lower};
    }
};

/// A root by its distances from both poles. If it is at a pole, the vertex is at infinity in the
/// direction of that axis.
template <class T> struct PoleRoot {
    enum class Place { between, lower, upper };
    T delta, epsilon;
    Place place;
};

inline constexpr int most_newton_steps = 200;

/// Tests whether a step of Newton's method is the last. The next step would be step² |h''/2|/|h'|,
/// to leading order. The two terms of h'' cancel where h turns from convex to concave, but not at
/// the end of the step. Therefore the sum of their magnitudes takes the place of |h''/2|.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_last_step(T const &step, T const &x, T const &sharpness, T const &slope) noexcept
{
    T const u = T(unit_roundoff<T>());
    return step <= T(T(T(4) * u) * x) || T(T(step * step) * sharpness) <= T(T(u * x) * -slope);
}

/// A step of Newton's method from x: the next x, and whether there is no root or the search ends.
template <class T> struct NewtonStep {
    T next;
    typename ScalarTraits<T>::Mask fails, ends;
};

/// Newton's method in the lanes of a mask, by step(x). Returns those of them that have a root.
template <class T, class Step> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
find_root(typename ScalarTraits<T>::Mask active, T &x, Step const &step) noexcept
{
    auto has_root = active;
    for (int k = 0; k < most_newton_steps && any_of(active); ++k) {
        NewtonStep<T> const s = step(x);
        x = select(active && !s.fails, s.next, x);
        has_root = has_root && !(active && s.fails);
        active = active && !(s.fails || s.ends);
    }
    return has_root;
}

/// Newton's method in the concave part, from above, in the lanes of a mask. It returns those that
/// have a root there.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
descend(typename ScalarTraits<T>::Mask const &active, PoleInterval<T> const &f, T &delta) noexcept
{
    return find_root(active, delta, [&](T const &x) {
        auto const value = f.at(x, T(f.gap - x));
        auto const is_root = value.h >= T(0);
        T const next = select(is_root, x, T(x + value.h / value.slope));
        return NewtonStep<T>{
            next, !(value.half_second >= T(0) && value.slope < T(0)) || !(is_root || next < f.gap),
            is_root || is_last_step(T(next - x), x, value.sharpness, value.slope)};
    });
}

/// Newton's method in the convex part, from below, likewise.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
ascend(typename ScalarTraits<T>::Mask const &active, PoleInterval<T> const &f, T &epsilon) noexcept
{
    return find_root(active, epsilon, [&](T const &x) {
        auto const value = f.at(T(f.gap - x), x);
        auto const is_root = !(value.h > T(0));
        T const next = select(is_root, x, T(x - value.h / value.slope));
        return NewtonStep<T>{next, !(value.slope < T(0)) || !(is_root || next < f.gap),
                             is_root || is_last_step(T(next - x), x, value.sharpness, value.slope)};
    });
}

/// x/y, or another number where y is not positive.
template <class T>
PW85_FUNCTION inline T positive_quotient(T const &x, T const &y, T const &otherwise) noexcept
{
    auto const is_positive = y > T(0);
    return select(is_positive, T(x / select(is_positive, y, T(1))), otherwise);
}

/// Below this distance from the lower pole, h is positive in the lower half: there t w/ε of the
/// lower pole is at least p w/ε, less w if t < p, and the other factors of h are at their bounds.
template <class T> PW85_FUNCTION inline T start_of_ascent(PoleInterval<T> const &f) noexcept
{
    T const half = T(T(0.5) * f.gap);
    auto const up = f.sign > T(0);
    T const largest = select(up, T(f.lower_pole + half), f.lower_pole);
    T others = T(f.weights[1] / half);
    if (any_of(f.beyond > T(0))) others = others + f.weights[2] / T(f.far_gap + half);
    T const least =
        select(up, T(0), f.weights[0]) + T(largest * others) - f.plain(select(up, T(0), f.gap));
    return minimum(half, positive_quotient(f.lower, least, half));
}

/// h without the term of the upper pole, at this pole.
template <class T> PW85_FUNCTION inline T value_at_upper(PoleInterval<T> const &f) noexcept
{
    T const others = f.weights[0] / f.gap - (f.beyond > T(0) ? T(f.weights[2] / f.far_gap) : T(0));
    return f.plain(f.sign > T(0) ? f.gap : T(0)) + f.sign * f.weights[1] + f.upper_pole * others;
}

/// A distance from the upper pole at which, and below which, h is not positive. In the upper half
/// t w/δ of the upper pole is at least p w/δ, less w if t < p.
template <class T> PW85_FUNCTION inline T start_of_descent(PoleInterval<T> const &f) noexcept
{
    T const half = T(T(0.5) * f.gap);
    auto const up = f.sign > T(0);
    T const largest = select(up, f.upper_pole, T(f.upper_pole + half));
    T const most = f.plain(select(up, f.gap, T(0))) + select(up, f.weights[1], T(0)) +
                   T(largest * T(f.weights[0] / half));
    return minimum(half, positive_quotient(f.upper, most, half));
}

/// The root at which a descent ended. A small distance from the lower pole has digits of its own.
template <class T> PW85_FUNCTION inline PoleRoot<T> root_after_descent(PoleInterval<T> const &f,
                                                                       T const &delta) noexcept
{
    T epsilon = T(f.gap - delta);
    auto const is_lower = epsilon < delta;
    if (any_of(is_lower)) {
        auto const value = f.at(delta, epsilon);
        T const better = maximum(T(epsilon - value.h / value.slope), T(T(0.5) * epsilon));
        epsilon = select(is_lower, better, epsilon);
    }
    return {delta, epsilon, PoleRoot<T>::Place::between};
}

/// The root of h that is nearest to the upper pole. It is in the concave part, or it is the only
/// root and in the convex part. Newton's method from the pole converges monotonically to it. The
/// upper pole counts as a root if its term is zero and h is positive there: this is the limit of a
/// small term. The caller decides this by `upper_counts`.
template <class T>
PW85_FUNCTION inline PoleRoot<T> highest_root(PoleInterval<T> const &f, bool upper_counts) noexcept
{
    using Place = typename PoleRoot<T>::Place;
    T const half = T(T(0.5) * f.gap);
    if (!(f.upper > T(0)) && upper_counts) return {T(0), f.gap, Place::upper};
    T delta = start_of_descent(f);
    if (delta == T(0)) delta = T(T(unit_roundoff<T>()) * half);
    // If only rounding errors make h positive at a pole that does not count, no root is below it.
    bool const starts_below = f.upper > T(0) || !(value_at_upper(f) > T(0));
    if (starts_below && descend(true, f, delta)) return root_after_descent(f, delta);
    T epsilon = start_of_ascent(f);
    if (!(epsilon > T(0))) {
        epsilon = T(T(unit_roundoff<T>()) * half);
        if (!(f.at(T(f.gap - epsilon), epsilon).h > T(0))) return {f.gap, T(0), Place::lower};
    }
    if (!ascend(true, f, epsilon) && !(f.lower > T(0))) return {f.gap, T(0), Place::lower};
    return {T(f.gap - epsilon), epsilon, Place::between};
}

/// The root of h that is nearest to the lower pole, if h is convex there. The lower pole counts as
/// a root if its term is zero and h is negative there.
template <class T>
PW85_FUNCTION inline bool find_lowest_root(PoleInterval<T> const &f, PoleRoot<T> &root) noexcept
{
    using Place = typename PoleRoot<T>::Place;
    root = {f.gap, T(0), Place::lower};
    if (!(f.lower > T(0)))
        return f.plain(f.sign > T(0) ? T(0) : f.gap) <
               T(f.lower_pole *
                 T(f.weights[1] / f.gap +
                   (f.beyond > T(0) ? T(f.weights[2] / T(f.far_gap + f.gap)) : T(0))));
    T epsilon = start_of_ascent(f);
    if (!(epsilon > T(0)) || !ascend(true, f, epsilon)) return false;
    root = {T(f.gap - epsilon), epsilon, Place::between};
    return true;
}

/// The pencil in the coordinates of the joint frame, A times the shortest axis, and the poles in
/// increasing order.
template <class T, int D> struct Pencil {
    Vector<T, D> poles, b, weights; ///< p_i, b_i and w_i
    T shortest;                     ///< s
};

template <class T, int D>
PW85_FUNCTION inline Pencil<T, D> pencil(JointFrame<T, D> const &frame) noexcept
{
    T const shortest = frame.axes[std::size_t(D - 1)];
    Pencil<T, D> pencil{{}, {}, {}, shortest};
    T const least = negative_power_of_two<T>(
        std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8 < 128
            ? std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent / 8
            : 128);
    for (int i = 0; i < D; ++i) {
        T const ratio = shortest / frame.axes[i];
        pencil.poles[i] = ratio / frame.axes[i];
        T const b = T(ratio * frame.center[i]);
        auto const is_zero = absolute(b) < least;
        pencil.b[i] = select(is_zero, T(0), b);
        pencil.weights[i] =
            select(is_zero, T(0), T(shortest * T(frame.center[i] * frame.center[i])));
    }
    return pencil;
}

/// The vertex of the root, as a homogeneous vector whose last coordinate is the height. `lower` and
/// `upper` are the axes of the two poles, `third` is the other axis, whose pole is at distance
/// `far_gap` beyond the upper or the lower pole.
template <class T, int D> struct Vertex {
    Vector<T, D> x;
    T height, root;
};

/// B(v, w).
template <class T, int D>
PW85_FUNCTION inline T lorentz(Vertex<T, D> const &v, Vertex<T, D> const &w) noexcept
{
    return dot(v.x, w.x) - v.height * w.height;
}

/// v/√B(v, v). v is first divided by its largest coordinate.
template <class T, int D> PW85_FUNCTION inline Vertex<T, D> normalized(Vertex<T, D> v) noexcept
{
    T const size = T(1) / maximum(largest_coordinate(v.x), absolute(v.height));
    v = {size * v.x, size * v.height, v.root};
    T const floor = T(T(unit_roundoff<T>()) * T(unit_roundoff<T>()));
    T const scale = T(1) / square_root(maximum(lorentz(v, v), floor));
    return {scale * v.x, scale * v.height, v.root};
}

/// The poles that bound an interval and the third one, by their axes. sign(p_upper - p_lower) is
/// that of `sign`.
template <class T> struct PoleAxes {
    int lower, upper, beyond;
    T sign;
};

/// The interval between two poles; sign = -1 turns t to -t, so that the "upper" pole can be the one
/// that is smaller.
template <class T, int D> PW85_FUNCTION inline PoleInterval<T>
pole_interval(Pencil<T, D> const &p, PoleAxes<T> const &axes) noexcept
{
    auto const [lower, upper, beyond, sign] = axes;
    bool const has_third = D == 3;
    T const third = has_third ? T(p.b[beyond] * p.b[beyond]) : T(0);
    T const third_weight = has_third ? p.weights[beyond] : T(0);
    T const far_gap = has_third ? T(sign * T(p.poles[beyond] - p.poles[upper])) : T(0);
    return {T(sign * T(p.poles[upper] - p.poles[lower])),
            far_gap,
            T(p.b[lower] * p.b[lower]),
            T(p.b[upper] * p.b[upper]),
            third,
            {p.weights[lower], p.weights[upper], third_weight},
            p.poles[lower],
            p.poles[upper],
            p.shortest,
            sign};
}

/// t at a root.
template <class T, int D> PW85_FUNCTION inline T
parameter_of(Pencil<T, D> const &p, PoleAxes<T> const &axes, PoleRoot<T> const &root) noexcept
{
    return select(root.delta <= root.epsilon, T(p.poles[axes.upper] - axes.sign * root.delta),
                  T(p.poles[axes.lower] + axes.sign * root.epsilon));
}

/// The vertex of a root between poles.
template <class T, int D> PW85_FUNCTION inline Vertex<T, D>
inner_vertex(Pencil<T, D> const &p, PoleAxes<T> const &axes, PoleRoot<T> const &root) noexcept
{
    auto const [lower, upper, beyond, sign] = axes;
    Vertex<T, D> v{{}, T(1), parameter_of(p, axes, root)};
    // p_i - t, times sign: -ε, δ and far_gap + δ.
    v.x[lower] = -(T(sign * p.b[lower]) / root.epsilon);
    if (any_of(root.delta > T(0))) v.x[upper] = T(sign * p.b[upper]) / root.delta;
    if constexpr (D == 3) {
        T const far_gap = T(sign * T(p.poles[beyond] - p.poles[upper]));
        if (any_of(!(p.b[beyond] == T(0))))
            v.x[beyond] = T(sign * p.b[beyond]) / T(far_gap + root.delta);
    }
    return normalized(v);
}

/// The vertex of a root.
template <class T, int D> PW85_FUNCTION inline Vertex<T, D>
vertex_of(Pencil<T, D> const &p, PoleAxes<T> const &axes, PoleRoot<T> const &root) noexcept
{
    using Place = typename PoleRoot<T>::Place;
    if (root.place == Place::between) return inner_vertex(p, axes, root);
    Vertex<T, D> v{{}, T(0), parameter_of(p, axes, root)};
    v.x[root.place == Place::upper ? axes.upper : axes.lower] = T(1);
    return v;
}

/// The vertex at the root nearest to the upper one of both poles.
template <class T, int D> PW85_FUNCTION inline Vertex<T, D>
vertex_between(Pencil<T, D> const &p, PoleAxes<T> const &axes, bool upper_counts) noexcept
{
    auto const interval = pole_interval(p, axes);
    if (!(interval.gap > T(0))) { // make_zero() has made b_lower zero
        Vertex<T, D> v{{}, T(0), p.poles[axes.lower]};
        v.x[axes.lower] = T(1);
        return v;
    }
    return vertex_of(p, axes, highest_root(interval, upper_counts));
}

/// The height of a vertex beyond which the ellipsoids count as touching there.
template <class T> PW85_FUNCTION constexpr T highest_vertex() noexcept
{
    return T(1) / negative_power_of_two<T>(mantissa_digits<T>() / 5);
}

/// Where the ellipsoids touch from inside, two roots of the pencil coincide, and their vertex is
/// the point that they touch at. If these roots are the two of an interval that are nearest to the
/// middle pole, the third one takes their place. Its vertex is outside of the ball, too, and the
/// axis then passes through the point of tangency, as this point is conjugate to both vertices.
///
/// Let H be the height of the vertex, and Δ the distance between its root and the next one. B(v, v)
/// is 1 for the normalized vertex, and h' is near 1/H². So Δ and the relative distance of α or γ
/// from zero are near 1/H² and 1/H⁴, which is below common_end().
template <class T> PW85_FUNCTION inline void
replace_touching_vertex(Pencil<T, 3> const &p, PoleAxes<T> const &axes, Vertex<T, 3> &v) noexcept
{
    if (!(absolute(v.height) > highest_vertex<T>())) return;
    PoleRoot<T> root{};
    if (!find_lowest_root(pole_interval(p, axes), root)) return;
    auto const other = vertex_of(p, axes, root);
    if (absolute(other.height) < absolute(v.height)) v = other;
}

/// The height of a vertex beyond which the vertex at the middle pole may take its place.
///
/// As above, α or γ is η = 1/H⁴ of its size, 2^-44, if the vertex is at the point of tangency. An
/// end of the axis within η counts as common to both bodies. Let the surfaces have the distance z²
/// - y⁴ + η near that point, to leading order. The rims that are wrong there have y up to η^(1/4)
/// and z up to η^(1/2). The volume changes by η^(7/4), which is below u, and the derivatives by
/// η^(3/4). This is of the order of their bound, as second derivatives are near η^(-1/4).
inline constexpr double highest_vertex_beside_pole = 2048.0;

/// The size of b of the middle pole that rounding of the forms and of the offset explains.
///
/// Let the bodies touch at an end of the axis a², with equal curvatures in the direction of the
/// middle axis a, so that the centre is at a² - 1. The entries of Q1, Q2 and r are rounded by u,
/// and a form by √3 u κ in the metric of the ball, κ the condition number of Q1. To first order the
/// centre moves across by at most u κ times
///
///     (a² - 1) + √3 (a² - 1)/2 + √3 (a² - 1) (a⁴ + (a⁴ + a²)/2)/(a⁴ - a²) = (1 + 2√3) a² - 1,
///
/// the last of these terms by the turn of the axes. b is the pole, s/a² with the shortest axis s,
/// times this: up to 4.5 u κ s, or 8 u s for κ up to 1.8. With a < 1 the pole exceeds s, and 8 u
/// times the pole moves the centre by 8 u. The term 2 b y is below η everywhere.
template <class T> PW85_FUNCTION inline T rounding_of_middle_b(Pencil<T, 3> const &p) noexcept
{
    T const shortest = T(T(1) / p.poles[2]);
    return T(T(T(8) * negative_power_of_two<T>(result_digits<T>())) *
             maximum(p.poles[1], shortest));
}

/// Where the ellipsoids touch from inside with equal curvatures in the direction of the middle
/// axis, the middle pole is a third root next to the two that coincide, within a few 1/H². Its term
/// is zero, or moves the centre by rounding alone. Its vertex then takes the place of a touching
/// one, in whichever interval the pole counts by rounding: the vertices are those of the limit of
/// equal roots, and the axis passes through the point of tangency.
template <class T>
PW85_FUNCTION inline bool give_pole_to_touching_vertex(Pencil<T, 3> p, PoleAxes<T> const (&axes)[2],
                                                       bool counts, Vertex<T, 3> (&v)[2]) noexcept
{
    auto const height = [](Vertex<T, 3> const(&x)[2]) {
        return maximum(absolute(x[0].height), absolute(x[1].height));
    };
    T const limit = T(highest_vertex_beside_pole);
    int const touching = absolute(v[0].height) > absolute(v[1].height) ? 0 : 1;
    T const pole = p.poles[1], distance = absolute(T(v[touching].root - pole));
    bool const is_at_pole = T(distance * T(limit * limit)) <= T(T(4) * pole) &&
                            absolute(p.b[1]) <= rounding_of_middle_b(p);
    if (!(height(v) > limit) || !is_at_pole) return false;
    p.b[1] = p.weights[1] = T(0);
    for (int k = 0; k < 2; ++k) {
        bool const first_counts = (k == 0) == counts;
        Vertex<T, 3> const other[2] = {vertex_between(p, axes[0], first_counts),
                                       vertex_between(p, axes[1], !first_counts)};
        if (height(other) > limit) continue;
        v[0] = other[0];
        v[1] = other[1];
        return true;
    }
    return false;
}

/// Turns the coordinates of two axes with the same pole so that b of the first is zero. Returns the
/// rotation.
template <class T> struct PlaneRotation {
    T cosine, sine;
};

template <class T, int D>
PW85_FUNCTION inline PlaneRotation<T> make_zero(Pencil<T, D> &p, int zero, int other) noexcept
{
    T const length = square_root(T(p.b[zero] * p.b[zero] + p.b[other] * p.b[other]));
    if (!(length > T(0))) return {T(1), T(0)};
    PlaneRotation<T> const turn{p.b[other] / length, p.b[zero] / length};
    p.b[zero] = T(0);
    p.b[other] = length;
    p.weights[other] = p.weights[other] + p.weights[zero];
    p.weights[zero] = T(0);
    return turn;
}

/// Turns a vector back.
template <class T, int D> PW85_FUNCTION inline void turn_back(Vector<T, D> &x, int zero, int other,
                                                              PlaneRotation<T> const &turn) noexcept
{
    T const a = x[zero], b = x[other];
    x[zero] = turn.cosine * a + turn.sine * b;
    x[other] = turn.cosine * b - turn.sine * a;
}

/// Tests whether the middle pole counts as a root of an interval if its term is zero.
template <class T>
PW85_FUNCTION inline bool counts_as_root(Pencil<T, 3> const &p, PoleAxes<T> const &axes) noexcept
{
    auto const interval = pole_interval(p, axes);
    return interval.gap > T(0) && value_at_upper(interval) >= T(0);
}

/// Makes two vertices orthogonal with respect to B.
template <class T> PW85_FUNCTION inline void make_orthogonal(Vertex<T, 3> (&v)[2]) noexcept
{
    T const along = lorentz(v[0], v[1]);
    v[1] = normalized(
        Vertex<T, 3>{v[1].x - along * v[0].x, T(v[1].height - along * v[0].height), v[1].root});
}

/// Sets the vertices of an axis, and its direction.
template <class T>
PW85_FUNCTION inline void set_vertices(RimAxis<T, 3> &axis, Vertex<T, 3> const (&v)[2]) noexcept
{
    for (int i = 0; i < 2; ++i) {
        axis.vertices[i] = v[i].x;
        axis.heights[i] = v[i].height;
        axis.roots[i] = v[i].root;
    }
    Vector<T, 3> const normal = cross(v[0].x, v[1].x);
    axis.direction = normal / magnitude(normal);
}

/// The vertices w1 and w2 of RimAxis, made orthogonal with respect to B.
template <class T>
PW85_FUNCTION inline void find_vertices(Pencil<T, 3> p, RimAxis<T, 3> &axis) noexcept
{
    bool const first = p.poles[0] == p.poles[1], second = p.poles[1] == p.poles[2];
    PlaneRotation<T> turn1{T(1), T(0)}, turn2{T(1), T(0)};
    if (first) turn1 = make_zero(p, 0, 1);
    if (second) turn2 = make_zero(p, 2, 1);
    PoleAxes<T> const axes[2] = {{0, 1, 2, T(1)}, {2, 1, 0, T(-1)}};
    bool const counts = counts_as_root(p, axes[0]);
    Vertex<T, 3> v[2] = {vertex_between(p, axes[0], counts),
                         vertex_between(p, axes[1], first ? counts_as_root(p, axes[1]) : !counts)};
    if constexpr (!std::is_floating_point_v<T>) { // other rims are computed by more digits
        if (!first) replace_touching_vertex(p, axes[0], v[0]);
        if (!second) replace_touching_vertex(p, axes[1], v[1]);
        if (!first && !second)
            axis.touches_at_end = give_pole_to_touching_vertex(p, axes, counts, v);
    }
    make_orthogonal(v);
    for (int i = 0; i < 2; ++i) {
        if (second) turn_back(v[i].x, 2, 1, turn2);
        if (first) turn_back(v[i].x, 0, 1, turn1);
    }
    set_vertices(axis, v);
}

/// Sets the origin and the length of an axis from its vertices. a_i·x = height_i are the planes
/// that contain it, and a_i·a_j = δ_ij + height_i height_j. So its point next to the centre of the
/// ball is Σ height_i a_i/(1 + Σ height_i²).
template <class T, int D> PW85_FUNCTION inline void set_origin(RimAxis<T, D> &axis) noexcept
{
    T sum = T(1);
    for (T const &height : axis.heights) sum = sum + height * height;
    for (int i = 0; i < D - 1; ++i)
        axis.origin = axis.origin + T(axis.heights[i] / sum) * axis.vertices[i];
    axis.half_chord = T(1) / square_root(sum);
}

/// The axis of the rim.
template <class T, int D>
PW85_FUNCTION inline RimAxis<T, D> rim_axis(Pencil<T, D> const &p) noexcept
{
    RimAxis<T, D> axis{};
    find_vertices(p, axis);
    set_origin(axis);
    return axis;
}

} // namespace pw85::detail

#endif
