// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Means over half-planes by trapezoidal rules in the parameter of elliptic_rule.hpp: the nodes; a
/// sequence ("ladder") of rules, each of which contains the nodes of the rule before; and the test
/// that ends it. rim_integrals.hpp and overlap_volume_derivatives.hpp call mean_over_half_planes().
#ifndef PW85_VOLUME_RULE_LADDER_HPP_INCLUDED
#define PW85_VOLUME_RULE_LADDER_HPP_INCLUDED

#include <pw85/algebra/two_doubled.hpp>
#include <pw85/volume/elliptic_rule.hpp>

namespace pw85::detail {

template <class T> PW85_FUNCTION inline UnitVector2<T> turned(UnitVector2<T> const &a,
                                                              UnitVector2<T> const &b) noexcept
{
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

/// Halves an angle in [0, π].
template <class T> PW85_FUNCTION inline UnitVector2<T> half_turned(UnitVector2<T> const &a) noexcept
{
    T const root = square_root(T(T(0.5) * T(T(1) + absolute(a.cosine)))),
            other = a.sine / T(T(2) * root);
    auto const is_acute = a.cosine > T(0);
    return {select(is_acute, root, other), select(is_acute, other, root)};
}

/// Rules have at most 2^14 pairs of half-planes, or three times as many. 16 or 24 nodes are usual.
inline constexpr int finest_rule = 14;

/// Sums over half-planes, or means, and the number of pairs of half-planes.
template <class T, int N> struct RimSums {
    T numbers[std::size_t(N)];
    int pairs;
};

/// The mean from the sums over two sets of half-planes; `inverse` is the reciprocal of the number
/// of half-planes.
template <class T, int N> PW85_FUNCTION inline RimSums<T, N>
mean_of(RimSums<T, N> const &x, RimSums<T, N> const &y, T const &inverse) noexcept
{
    RimSums<T, N> mean{{}, x.pairs + y.pairs};
    for (int i = 0; i < N; ++i) mean.numbers[i] = T(T(x.numbers[i] + y.numbers[i]) * inverse);
    return mean;
}

template <class T, int N>
PW85_FUNCTION inline RimSums<T, N> mean_of(RimSums<T, N> const &x, RimSums<T, N> const &y) noexcept
{
    return mean_of(x, y, T(T(1) / T(2 * (x.pairs + y.pairs))));
}

/// The half-planes of one lane.
template <class T, class Function> PW85_FUNCTION inline RimDirection<T>
lane_of(Function const &lane, RimDirection<TwoLanes<T>> const &x) noexcept
{
    return {{lane(x.direction.cosine), lane(x.direction.sine)},
            lane(x.weight),
            lane(x.pace),
            lane(x.excess)};
}

/// The nodes θ: multiples of 2π/2^level, and multiples of 2π/2^level shifted by 2π/3. Other
/// multiples, and those shifted by -2π/3, are mirror images of these nodes, with the same roots and
/// weights.
template <class T> struct RuleNodes {
    T half = T(0.5);
    UnitVector2<T> starts[2] = {{T(1), T(0)}, {-half, T(half *square_root(T(3)))}};
    UnitVector2<T> turns[finest_rule + 1] = {{T(1), T(0)}, {T(-1), T(0)}, {T(0), T(1)}}; ///< 2π/2^k

    /// Prepares a level. The ones below it must be prepared.
    PW85_MEMBER void prepare(int level) noexcept
    {
        if (level > 2) turns[level] = half_turned(turns[level - 1]);
    }

    /// Returns the number of nodes that visit() visits.
    PW85_MEMBER static constexpr int count(int start, int k) noexcept
    {
        int const first_bit = start == 0 ? 2 : 1;
        return k < first_bit ? 1 : 1 << (k - first_bit);
    }

    /// Tests if the mirror images of nodes are different nodes.
    PW85_MEMBER static constexpr bool have_images(int start, int k) noexcept
    {
        return start > 0 || k > 1;
    }

    /// Visits the nodes at odd multiples of 2π/2^k from a start, without their images: calls
    /// one(θ), or two(θ, θ') if there is more than one.
    template <class One, class Two>
    PW85_MEMBER void visit(int start, int k, One const &one, Two const &two) const noexcept
    {
        auto const first = turned(starts[start], turns[k]);
        int const size = count(start, k);
        if (size == 1) one(first);
        for (int j = 0; size > 1 && j < size; j += 2) {
            UnitVector2<T> phi = first;
            for (int bit = 1; bit < k - 1; ++bit)
                if ((j >> bit & 1) != 0) phi = turned(phi, turns[k - 1 - bit]);
            two(phi, turned(phi, turns[k - 1]));
        }
    }
};

/// Adds the nodes at odd multiples of 2π/2^k from a start. Two nodes are computed at the same time.
/// add_integrands(integrands, direction, has_image, sums) adds a pair of half-planes, and its
/// mirror image if it has one. The function is not a member, because Clang gives external linkage
/// to lambdas in members.
template <class T, int N, class Integrands>
PW85_FUNCTION inline void add_nodes(EllipticRule<T> const &rule, Integrands const &integrands,
                                    RuleNodes<T> const &nodes, int start, int k,
                                    RimSums<T, N> &sums) noexcept
{
    using Two = TwoLanes<T>;
    bool const has_image = nodes.have_images(start, k);
    auto const add = [&](RimDirection<T> const &direction) {
        add_integrands(integrands, direction, has_image, sums);
    };
    nodes.visit(
        start, k, [&](UnitVector2<T> const &theta) { add(rim_direction(rule, theta)); },
        [&](UnitVector2<T> const &theta, UnitVector2<T> const &next) {
            auto const both = rim_direction(
                rule, UnitVector2<Two>{{theta.cosine, next.cosine}, {theta.sine, next.sine}});
            add(lane_of<T>([](Two const &x) { return first_of(x); }, both));
            add(lane_of<T>([](Two const &x) { return second_of(x); }, both));
        });
    sums.pairs += nodes.count(start, k) << (has_image ? 1 : 0);
}

/// A ladder of trapezoidal rules.
template <class T, int N, class Integrands> struct RuleLadder {
    EllipticRule<T> const &rule;
    Integrands const &integrands;
    int level = -1, starts = 1;
    RimSums<T, N> coarse{{}, 0}, added{{}, 0}; ///< coarse: of every other node
    RuleNodes<T> nodes{};

    /// Doubles the number of nodes; adds the first node if there is none.
    PW85_MEMBER void refine() noexcept
    {
        nodes.prepare(++level);
        for (int i = 0; i < N; ++i) coarse.numbers[i] = coarse.numbers[i] + added.numbers[i];
        coarse.pairs += added.pairs;
        added = {{}, 0};
        for (int i = 0; i < starts; ++i) add_nodes(rule, integrands, nodes, i, level, added);
    }

    /// Triples the number of nodes. May be called only once.
    PW85_MEMBER void triple() noexcept
    {
        for (int k = 0; k < level; ++k) add_nodes(rule, integrands, nodes, starts, k, coarse);
        add_nodes(rule, integrands, nodes, starts, level, added);
        ++starts;
    }
};

/// The means over ψ, and a flag: true if they have converged.
template <class T, int N> struct RimMeans {
    RimSums<T, N> means;
    typename ScalarTraits<T>::Mask converged;
};

/// Estimates the error of a rule. `distance` is the difference between the means by this rule and
/// by half of its nodes, in units of the scale of change_of_means(); `previous` is that of the rule
/// before. The error of a rule with n nodes is C xⁿ. Both distances determine C and x. If this rule
/// has twice the nodes of the rule before, its error is C x^2n = distance (distance/previous)². If
/// it has three times the nodes, the exponent is 3/2. The function uses C = 1 if C is larger: C may
/// be small, because a pole of an integrand near the real axis can have a small residue, but a
/// large C is not trusted.
template <class T>
PW85_FUNCTION inline T error_of_rule(T const &distance, T const &previous,
                                     typename ScalarTraits<T>::Mask const &by_three) noexcept
{
    auto const is_known = previous > T(0);
    T const ratio = distance / select(is_known, previous, T(1)),
            power = select(is_known, T(ratio * select(by_three, square_root(ratio), ratio)),
                           largest_number<T>());
    return select(distance > T(0), T(distance * maximum(distance, power)), T(0));
}

/// The constant ε = √u/2: a rule whose error is at most ε² = u/4 is accurate enough.
template <class T> PW85_FUNCTION inline T enough_of_rule() noexcept
{
    return T(T(0.5) * square_root(negative_power_of_two<T>(result_digits<T>())));
}

/// Tests if 24 nodes are expected to suffice, but not 16. With the distance d between the means of
/// the rules with 8 and 4 nodes, the expected errors are d⁴ for 16 nodes and d⁶ for 24 nodes.
template <class T>
PW85_FUNCTION inline typename ScalarTraits<T>::Mask is_better_by_three(T const &distance) noexcept
{
    T const enough = enough_of_rule<T>(), expected = T(distance * distance);
    return expected > enough && T(expected * distance) <= enough;
}

/// A difference divided by a scale; 0 if the difference is at most `floor`, the largest effect of
/// rounding errors.
template <class T>
PW85_FUNCTION inline T fraction_of(T const &difference, T const &scale, T const &floor) noexcept
{
    return select(difference <= floor, T(0), T(difference / scale));
}

/// The largest change of 3V, with the ball as unit, that counts as rounding: V changes by less than
/// 22 u, which is below 6 u v.
template <class T> PW85_FUNCTION constexpr T rim_integral_floor() noexcept
{
    return T(T(64) * negative_power_of_two<T>(result_digits<T>()));
}

/// The change of all terms from one rule to the next, divided by the sum of both areas, because the
/// bound on the error of V contains more than half of this sum. The change of each area is also
/// divided by 64 times this area, and the largest quotient counts. This matters for an area below
/// 1/64 of the sum: it can converge more slowly than the other terms. For the end of a huge disc in
/// a ball, A1 is 10⁻⁹ times D A2.
template <class T> PW85_FUNCTION inline T
fraction_of_areas(T const (&areas)[2], T const (&changes)[2], T const &rest) noexcept
{
    T const floor = rim_integral_floor<T>(), a = absolute(areas[0]), b = absolute(areas[1]);
    T const all = fraction_of(T(T(changes[0] + changes[1]) + rest), T(a + b), floor);
    return maximum(all, maximum(fraction_of(changes[0], T(T(64) * a), floor),
                                fraction_of(changes[1], T(T(64) * b), floor)));
}

/// The change of means from one rule to the next, by fraction_of_areas(). The first two numbers are
/// the areas, and the other numbers that have a unit are those of the area vector.
template <class T, int N, std::size_t K> [[gnu::always_inline]] PW85_FUNCTION inline T
change_of_means(RimSums<T, N> const &x, RimSums<T, N> const &y, T const (&units)[K]) noexcept
{
    auto const of = [&](int i) { return T(units[i] * absolute(T(x.numbers[i] - y.numbers[i]))); };
    T rest = of(2);
    for (int i = 3; i < int(K); ++i) rest = T(rest + of(i));
    return fraction_of_areas({x.numbers[0], T(units[1] * x.numbers[1])}, {of(0), of(1)}, rest);
}

/// Computes means over half-planes by the trapezoidal rule, of numbers in these units, with an
/// error of u/4. The first rules have 4 and 8 nodes, and show how fast the means converge. The next
/// rule has 16 nodes, or 24 if is_better_by_three().
template <int N, class T, std::size_t K, class Integrands>
PW85_FUNCTION inline RimMeans<T, N> mean_over_half_planes(EllipticRule<T> const &rule,
                                                          Integrands const &integrands,
                                                          T const (&units)[K]) noexcept
{
    T const enough = enough_of_rule<T>();
    RuleLadder<T, N, Integrands> ladder{rule, integrands};
    while (ladder.level < 2) ladder.refine();
    T previous = T(0);
    for (bool by_three = false;;) {
        auto const mean = mean_of(ladder.coarse, ladder.added);
        T const distance =
            change_of_means(mean, mean_of(ladder.coarse, RimSums<T, N>{{}, 0}), units);
        bool const has_converged =
            ladder.level > 2 && error_of_rule(distance, previous, by_three) <= T(enough * enough);
        if (has_converged || ladder.level == finest_rule) return {mean, has_converged};
        by_three = ladder.level == 3 && !by_three && is_better_by_three(distance);
        by_three ? ladder.triple() : ladder.refine();
        previous = distance;
    }
}

} // namespace pw85::detail

#endif
