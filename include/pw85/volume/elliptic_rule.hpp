// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The change of variable for integrals along the rim (rim_axis.hpp) of an intersection: it gives
/// the half-planes through the axis at which the integrands are evaluated. rule_ladder.hpp has the
/// values of the parameter, and the sums.
///
/// The rim is an elliptic curve: its points are algebraic in (cos ψ, sin ψ) except for the root of
/// E(ψ) = T² - 4αγ (rim_frame.hpp), a form of degree 4 in (cos ψ, sin ψ). In the uniform parameter
/// of the curve, ∫ dψ/√E, they are meromorphic and periodic. The trapezoidal rule therefore
/// converges geometrically. Its rate hardly depends on how nearly the rim touches itself.
#ifndef PW85_VOLUME_ELLIPTIC_RULE_HPP_INCLUDED
#define PW85_VOLUME_ELLIPTIC_RULE_HPP_INCLUDED

#include <pw85/volume/rim_points.hpp>

namespace pw85::detail {

/// A unit vector at the angle ψ, or at another angle.
template <class T> struct UnitVector2 {
    T cosine, sine;
};

template <class Mask, class T>
requires(!std::is_same_v<Mask, bool>) PW85_FUNCTION
    inline UnitVector2<T> select(Mask const &mask, UnitVector2<T> const &yes,
                                 UnitVector2<T> const &no) noexcept
{
    return {select(mask, yes.cosine, no.cosine), select(mask, yes.sine, no.sine)};
}

/// A pair of opposite half-planes, by the direction of one.
template <class T> struct RimDirection {
    UnitVector2<T> direction;
    /// weight of the pair in the integral over ψ: the derivative of ψ with respect to the parameter
    /// of the rule
    T weight;
    T pace;   ///< weight/√E
    T excess; ///< T less `least` of the rim
};

/// The largest number of transformations of Landen. The transformation sin φ = (1 + k1) sin φ1/(1 +
/// k1 sin²φ1), with k1 = (1 - k')/(1 + k'), replaces k by k1 < k. A few of them make the modulus so
/// small that φ1 itself serves as the uniform parameter. Seven of them lead from k' = 2^-200 to k'
/// > 0.875, where they end. Packs of numbers do not compute pairs that need more than
/// `most_landen_steps_of_lanes`.
inline constexpr int most_landen_steps = 12, most_landen_steps_of_lanes = 4;

/// The change of variable from the uniform parameter to ψ.
///
/// The vertices diagonalise the form E, so E = a cos⁴ψ + 2b cos²ψ sin²ψ + c sin⁴ψ. With tan ψ =
/// (a/c)^(1/4) tan χ it is proportional to 1 - m sin²2χ with m = (1 - b/√(ac))/2. For m < 0 it is
/// proportional to 1 - k² cos²2χ, with k² = |m|/(1 + |m|). So 2χ, minus π/2 for m < 0, is an
/// amplitude φ of the modulus k.
// The members are in the order of the derivation, not in the order with the least padding.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
template <class T> struct EllipticRule {
    static constexpr int most_steps =
        ScalarTraits<T>::lanes == 1 ? most_landen_steps : most_landen_steps_of_lanes;

    /// k, k1, ... and 1 - k, 1 - k1, ...
    T moduli[std::size_t(most_steps + 1)], gaps[std::size_t(most_steps + 1)];
    int steps;                  ///< the number of transformations, in lanes the largest one
    T own_steps;                ///< the number of a lane
    T last_modulus;             ///< k of the last transformation
    T factor;                   ///< Π (1 + k_j)
    T stretch, inverse_stretch; ///< √(tan ψ/tan χ), and its inverse
    /// The derivative of ψ by φ is √E times this constant over √(1 - k² sin²φ) of the last φ. The
    /// constant follows from ψ = 0, where √E = √a: it is Π (1 + k_j)/(ac)^(1/4), times k' for
    /// m < 0. So derivatives along the rim need no division by √E, which is small where the rim
    /// nearly touches itself.
    T pace;
    T excess[2]; ///< of the vertices
    /// x and y, which are not used if y is 0. T changes its sign along a rim with αγ < 0 that
    /// nearly touches itself. Then T is a multiple of x + y cos 2χ, with 2x = t1 (c/a)^(1/4) + t2
    /// (a/c)^(1/4) and 2y the difference of these terms, where t1 and t2 are T at the two vertices.
    /// As t1²c - t2²a = -4αγ (t1² - t2²), nothing cancels in x.
    T mean, swing;
    typename ScalarTraits<T>::Mask is_shifted; ///< true if m < 0
    /// True if the form of cover_all_scales() takes the place of E; then E = excess (excess + 2
    /// `least`) + `negative`, with the two numbers below. Packs of numbers do not compute such
    /// pairs.
    bool is_covering;
    T least, negative;

    /// Tests if a pair has transformation j. For one pair the answer is always true.
    PW85_MEMBER typename ScalarTraits<T>::Mask takes_step(int j) const noexcept
    {
        if constexpr (ScalarTraits<T>::lanes == 1)
            return true;
        else
            return T(j) <= own_steps;
    }
};

/// The smallest ratio of E to T² that counts at the vertices: u².
template <class T> PW85_FUNCTION constexpr T rim_floor() noexcept
{
    return T(T(unit_roundoff<T>()) * T(unit_roundoff<T>()));
}

/// k', from `ratio` = b/√(ac) and `difference` = (ac - b²)/(ac). For m >= 0 it is the square root
/// of (1 + b/√(ac))/2, and ac - b² = -4αγ(t1 - t2)², where t1 and t2 are T at the two vertices. So
/// k' is computed without cancellation where the rim nearly touches itself. k' is set to at least
/// u²: below that, the part of the integral that changes is negligible.
template <class T>
PW85_FUNCTION inline T complementary_modulus(T const &ratio, T const &difference) noexcept
{
    T const u = T(unit_roundoff<T>());
    auto const is_shifted = ratio > T(1), is_positive = ratio > T(0);
    T const half = T(0.5), larger = T(1) + ratio,
            numerator = select(is_shifted, T(2),
                               select(is_positive, T(half * larger), T(half * difference))),
            divisor = select(is_shifted, larger, select(is_positive, T(1), T(T(1) - ratio)));
    return maximum(square_root(maximum(T(numerator / divisor), T(0))), T(u * u));
}

/// A form a cos⁴ψ + 2b cos²ψ sin²ψ + c sin⁴ψ: a, c, b/√(ac), and k' of complementary_modulus().
template <class T> struct QuarticForm {
    T a, c, ratio, complement;
};

/// E.
template <class T>
PW85_FUNCTION inline QuarticForm<T> quartic_form(RimEquation<T> const &rim) noexcept
{
    // a = t1² - 4αγ and c = t2² - 4αγ, with t - 2√(αγ) = excess if αγ > 0
    T const e1 = rim.excess[0], e2 = rim.excess[1], product = T(T(4) * T(rim.alpha * rim.gamma));
    T const least = rim.least, more = T(least + least), t1 = e1 + least, t2 = e2 + least;
    T const tiny = smallest_number<T>(), negative = maximum(T(-product), T(0));
    T const a = maximum(T(e1 * T(e1 + more) + negative), T(tiny + rim_floor<T>() * T(t1 * t1)));
    T const c = maximum(T(e2 * T(e2 + more) + negative), T(tiny + rim_floor<T>() * T(t2 * t2)));
    T const scale = T(a * c), step = T(t1 - t2);
    // t1 t2 - 4αγ, without cancellation where both t are near 2√(αγ)
    T const mixed = select(least > T(0), T(e1 * e2 + least * T(e1 + e2)), T(T(t1 * t2) - product));
    T const ratio = positive_quotient(mixed, square_root(scale), T(1));
    return {a, c, ratio,
            complementary_modulus(ratio, T(-(T(T(product * T(step * step)) / a) / c)))};
}

/// Limits for (a/c)^(1/4) of E and for k'. If (a/c)^(1/4) is below the first limit or above its
/// inverse, and k' is above the second limit, a rule for E can miss nearly all half-planes that
/// matter. Its nodes are then dense only where tan ψ is near (a/c)^(1/4). For a smaller k' they are
/// also dense elsewhere.
inline constexpr double smallest_stretch2 = 1.0 / 32.0, least_complement_to_cover = 1.0 / 64.0;

/// Tests whether a rule for E may miss half-planes that matter. Where the bodies touch, or nearly
/// touch, from inside with nearly equal curvatures in one direction, T is near zero for one vertex.
/// The rim is then near one end of the axis for ψ below r = (a/c)^(1/4), and far from it elsewhere:
/// α or γ is below r⁴ times the other one; the test requires r² times. cover_all_scales() then
/// chooses the nodes by the form (cos²ψ + sin²ψ)(r²cos²ψ + sin²ψ) instead of E: their number per
/// unit of log tan ψ is constant from r to 1. If α and γ are of similar size, the axis is short,
/// and the rule for E is accurate.
///
template <class T>
PW85_FUNCTION inline typename ScalarTraits<T>::Mask may_miss_half_planes(RimEquation<T> const &rim,
                                                                         QuarticForm<T> const &form,
                                                                         T const &stretch2) noexcept
{
    T const r = minimum(stretch2, T(T(1) / stretch2)), alpha = absolute(rim.alpha),
            gamma = absolute(rim.gamma);
    return r < T(smallest_stretch2) && form.complement > T(least_complement_to_cover) &&
           minimum(alpha, gamma) <= T(T(r * r) * maximum(alpha, gamma));
}

template <class T>
PW85_FUNCTION inline bool cover_all_scales(RimEquation<T> const &rim, QuarticForm<T> &form) noexcept
{
    T const stretch2 = square_root(square_root(T(form.a / form.c)));
    if (!may_miss_half_planes(rim, form, stretch2)) return false;
    bool const is_small = stretch2 < T(1);
    T const r = is_small ? stretch2 : T(T(1) / stretch2), square = T(r * r);
    T const ratio = T(T(T(1) + square) / T(r + r));
    form = {is_small ? square : T(1), is_small ? T(1) : square, ratio,
            complementary_modulus(ratio, T(0))};
    return true;
}

/// Adds the transformations of Landen from a modulus.
template <class T>
PW85_FUNCTION inline void add_moduli(EllipticRule<T> &rule, T complement) noexcept
{
    rule.last_modulus = rule.moduli[0] =
        square_root(T(T(T(1) - complement) * T(T(1) + complement)));
    T const enough = T(0.875);
    for (auto active = complement < enough; rule.steps < rule.most_steps && any_of(active);
         active = complement < enough) {
        T const sum = T(1) + complement, next = T(T(1) - complement) / sum;
        rule.moduli[++rule.steps] = next;
        rule.gaps[rule.steps] = T(complement + complement) / sum;
        complement = select(active, T(T(T(2) * square_root(complement)) / sum), complement);
        rule.factor = select(active, T(rule.factor * T(T(1) + next)), rule.factor);
        rule.own_steps = select(active, T(rule.steps), rule.own_steps);
        rule.last_modulus = select(active, next, rule.last_modulus);
    }
}

template <class T>
PW85_FUNCTION inline EllipticRule<T> elliptic_rule(RimEquation<T> const &rim) noexcept
{
    auto form = quartic_form(rim);
    bool is_covering = false;
    if constexpr (ScalarTraits<T>::lanes == 1) is_covering = cover_all_scales(rim, form);
    auto const &[a, c, ratio, complement] = form;
    T const e1 = rim.excess[0], e2 = rim.excess[1],
            negative = maximum(T(T(-4) * T(rim.alpha * rim.gamma)), T(0));
    EllipticRule<T> rule{{},           {},          0,         T(0),     T(0), T(1),
                         T(1),         T(1),        T(1),      {e1, e2}, T(0), T(0),
                         ratio > T(1), is_covering, rim.least, negative};
    rule.stretch = square_root(square_root(square_root(T(a / c))));
    rule.inverse_stretch = T(1) / rule.stretch;
    add_moduli(rule, complement);
    T const root = T(square_root(square_root(a)) * square_root(square_root(c)));
    auto const swings = negative > T(0) && T(e1 * e2) < T(0);
    if (any_of(swings) && !is_covering) {
        T const first_term = T(e1 * square_root(c)), second_term = T(e2 * square_root(a));
        T const difference = T(first_term - second_term), half = T(T(0.5) / root);
        rule.swing = select(swings, T(difference * half), T(0));
        rule.mean = T(T(negative * T(e1 * e1 - e2 * e2)) / difference) * half;
    }
    rule.pace = select(rule.is_shifted, T(rule.factor * complement), rule.factor) / root;
    return rule;
}

/// √E of a half-plane from T minus `least`, for the form of cover_all_scales().
template <class T, class N>
PW85_FUNCTION inline N root_of_quartic(EllipticRule<T> const &rule, N const &excess) noexcept
{
    N const least(rule.least), t = excess + least;
    N const square = excess * N(excess + N(least + least)) + N(rule.negative);
    return square_root(maximum(square, N(N(smallest_number<T>()) + N(rim_floor<T>()) * N(t * t))));
}

/// A vector in the direction of ψ, and the square of the length of the vector before the stretch.
template <class N> struct StretchedVector {
    UnitVector2<N> psi;
    N square;
};

/// The direction of ψ from that of 2χ. The vectors (1 + cos 2χ, sin 2χ) and (sin 2χ, 1 - cos 2χ)
/// have the direction of χ. The square of the length of the first one is 2 (1 + cos 2χ).
template <class T, class N> [[gnu::always_inline]] PW85_FUNCTION inline StretchedVector<N>
stretched_half(EllipticRule<T> const &rule, UnitVector2<N> const &twice) noexcept
{
    N const larger = N(1) + absolute(twice.cosine);
    auto const is_acute = twice.cosine > N(0);
    return {{N(select(is_acute, larger, twice.sine) * N(rule.inverse_stretch)),
             N(select(is_acute, twice.sine, larger) * N(rule.stretch))},
            N(larger + larger)};
}

/// The half-planes at a value of the parameter, or at values in lanes of N. `theta` is φ, minus π/2
/// for m < 0. So the half-planes at -θ are the mirror images of those at θ.
template <class T, class N> PW85_FUNCTION inline RimDirection<N>
rim_direction(EllipticRule<T> const &rule, UnitVector2<N> const &theta) noexcept
{
    auto phi = select(rule.is_shifted, UnitVector2<N>{-theta.sine, theta.cosine}, theta);
    N const last(rule.last_modulus);
    N delta = square_root(N(N(1) - N(N(last * phi.sine) * N(last * phi.sine))));
    N const inverse_delta = N(1) / delta, pace = N(N(rule.pace) * inverse_delta);
    N weight(rule.factor);
    if (rule.steps > 0) weight = select(rule.takes_step(1), N(weight * inverse_delta), weight);
    for (int j = rule.steps; j > 0; --j) {
        N const k(rule.moduli[j]), inverse = N(1) / N(N(1) + k * N(phi.sine * phi.sine));
        N const difference = N(rule.gaps[j]) + k * N(phi.cosine * phi.cosine); // 1 - k sin²φ
        phi = select(rule.takes_step(j),
                     UnitVector2<N>{N(N(phi.cosine * delta) * inverse),
                                    N(N(N(N(1) + k) * phi.sine) * inverse)},
                     phi);
        // √(1 - k² sin²φ) of the modulus before
        delta = select(rule.takes_step(j), N(difference * inverse), delta);
    }
    if (rule.steps > 0) weight = select(rule.takes_step(1), N(weight * delta), weight);
    auto const twice = select(rule.is_shifted, UnitVector2<N>{phi.sine, -phi.cosine}, phi); // 2χ
    auto const [psi, square] = stretched_half(rule, twice);
    N const c2 = N(psi.cosine * psi.cosine), s2 = N(psi.sine * psi.sine);
    N const inverse = N(1) / N(c2 + s2), scale = square_root(inverse);
    auto const swings = absolute(rule.swing) > T(0);
    N excess = N(rule.excess[0]) * c2 + N(rule.excess[1]) * s2;
    if (any_of(swings))
        excess = select(swings, N(N(N(rule.mean) + N(rule.swing) * twice.cosine) * square), excess);
    RimDirection<N> direction{{N(psi.cosine * scale), N(psi.sine * scale)},
                              N(N(weight * square) * inverse),
                              pace,
                              N(excess * inverse)};
    if (rule.is_covering)
        direction.pace = N(direction.weight / root_of_quartic(rule, direction.excess));
    return direction;
}

} // namespace pw85::detail

#endif
