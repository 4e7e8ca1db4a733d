// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The roots of the function h of a pencil (rim_axis.hpp) between two of its poles, by Newton's
/// method, which converges monotonically in the convex part and in the concave part of h.
/// rim_axis.hpp calls highest_root(), and src/simd/lanes/volume_frames.hpp calls its steps.
#ifndef PW85_VOLUME_PENCIL_ROOTS_HPP_INCLUDED
#define PW85_VOLUME_PENCIL_ROOTS_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// The function h between two poles: the interval (0, gap), with one more pole at gap + far_gap, at
/// a distance δ from the upper pole and ε from the lower pole.
///
/// The poles p_i separate the roots of h. Between two neighbouring poles h falls from ∞ to -∞, so
/// there is an odd number of roots, one or three. As h'(t) = 1 - |x|², the vertex of a root with h'
/// < 0 is outside of the ball. -h''/2 = Σ b_i²/(p_i - t)³ increases between two poles, so h is
/// first convex and then concave there.
///
/// h is computed from the weights of rim_axis.hpp. For a thin disc the weight w of the shortest
/// axis exceeds the other terms by up to 25 orders of magnitude, and would cancel in γ - b²/(p -
/// t).
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
/// to leading order. The two terms of h'' cancel where h changes from convex to concave, but not at
/// the end of the step. Therefore the sum of their magnitudes takes the place of |h''/2|.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_last_step(T const &step, T const &x, T const &sharpness, T const &slope) noexcept
{
    T const u = T(unit_roundoff<T>());
    return step <= T(T(T(4) * u) * x) || T(T(step * step) * sharpness) <= T(T(u * x) * -slope);
}

/// A step of Newton's method from x: the next x, and two flags: there is no root; the search ends.
template <class T> struct NewtonStep {
    T next;
    typename ScalarTraits<T>::Mask fails, ends;
};

/// Newton's method in the lanes of a mask, with the steps step(x). Returns the lanes that have a
/// root.
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

/// Newton's method in the concave part, from above, in the lanes of a mask. Returns the lanes that
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

/// Newton's method in the convex part, from below, in the lanes of a mask. Returns the lanes that
/// have a root there.
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

/// Below this distance from the lower pole, h is positive in the lower half: there t w/ε of the
/// lower pole is at least p w/ε, or p w/ε - w if t < p. The other terms of h are replaced by
/// bounds.
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

/// A distance from the upper pole at which, and below which, h is not positive. In the upper half t
/// w/δ of the upper pole is at least p w/δ, or p w/δ - w if t < p.
template <class T> PW85_FUNCTION inline T start_of_descent(PoleInterval<T> const &f) noexcept
{
    T const half = T(T(0.5) * f.gap);
    auto const up = f.sign > T(0);
    T const largest = select(up, f.upper_pole, T(f.upper_pole + half));
    T const most = f.plain(select(up, f.gap, T(0))) + select(up, f.weights[1], T(0)) +
                   T(largest * T(f.weights[0] / half));
    return minimum(half, positive_quotient(f.upper, most, half));
}

/// The root at which a descent ended. If it is near the lower pole, its distance from this pole is
/// computed separately, with all its digits.
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
    if (!(f.gap > T(0))) return {f.gap, T(0), Place::lower}; // make_zero() has made its term zero
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

/// The roots that are nearest to the middle pole, on its two sides, and a flag: true if the middle
/// pole counts as a root of the first side if its term is zero.
template <class T> struct MiddleRoots {
    PoleRoot<T> roots[2];
    bool counts;
};

/// Tests whether the upper pole counts as a root if its term is zero.
template <class T> PW85_FUNCTION inline bool upper_pole_counts(PoleInterval<T> const &f) noexcept
{
    return f.gap > T(0) && value_at_upper(f) >= T(0);
}

/// The roots for the intervals on the two sides of the middle pole, their upper pole.
template <class T>
PW85_FUNCTION inline MiddleRoots<T> middle_roots(PoleInterval<T> const (&f)[2]) noexcept
{
    bool const counts = upper_pole_counts(f[0]),
               other_counts = f[0].gap == T(0) ? upper_pole_counts(f[1]) : !counts;
    return {{highest_root(f[0], counts), highest_root(f[1], other_counts)}, counts};
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

} // namespace pw85::detail

#endif
