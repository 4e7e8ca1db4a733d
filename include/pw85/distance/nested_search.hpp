// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the common normal of the closest points for pairs for which Newton's method
/// (normal_search.hpp) fails: a safeguarded search for t, with a monotone search for s in it.
#ifndef PW85_DISTANCE_NESTED_SEARCH_HPP_INCLUDED
#define PW85_DISTANCE_NESTED_SEARCH_HPP_INCLUDED

#include <pw85/contact/safeguarded_search.hpp>
#include <pw85/distance/normal_search.hpp>

namespace pw85::detail {

/// Finds s for some t, starting at any other s: the root of 1/√(A + tB) = 1/√(1 + 1/t). If there is
/// no root, s = 0 takes its place.
///
/// The left side is concave in s and increases. So Newton's method is monotone from s = 0. From
/// another s, the first step ends below the root, or at zero. Each step divides residual times
/// slope by at least 4. For aspect ratios up to 2^127 the slope falls by at most 2^254 in all, and
/// the residual by 2^last_digits(). With the first step, the search therefore ends after 129 +
/// last_digits()/2 steps.
template <class Pair, class T>
PW85_FUNCTION inline T find_shift(Pair const &pair, T const &ratio, T shift) noexcept
{
    T const target = pair.scale1 + pair.scale2 / ratio;
    for (int i = 0; i < 129 + last_digits<T>() / 2; ++i) {
        Multipliers<T> const x{ratio, shift};
        auto const jet = solve_normal(pair, factorize_normal(pair, x), x).jet;
        T const step = jet.sum * (square_root(T(jet.sum / target)) - T(1)) / jet.sum_shift;
        if (!(step > T(0)) && (i > 0 || !(shift > T(0)))) break;
        shift = maximum(T(0), T(shift + step));
        if (is_within(NormalStep<T>{T(0), T(1), step}, jet, last_digits<T>())) break;
    }
    return shift;
}

/// The largest number of values of t that search_normal() tries. It is a sum: max_probes() values
/// enclose the root, which is in the range of T. 15 values and one for each digit make the bracket
/// as narrow as rounding allows. Newton's steps, which halve at most once for each digit, are the
/// rest.
template <class T> PW85_FUNCTION constexpr int max_ratios() noexcept
{
    return 2 * mantissa_digits<T>() + 15 + max_probes<T>();
}

/// Finds a vector along the normal by a search for t. find_shift() gives s. Then t is too large if
/// and only if t²B > A.
///
/// The proof uses the dual function g(y) = ½ rᵀ(Q1/y1 + Q2/y2 + I)⁻¹r - ½(y1 + y2) of the problem
/// to minimise |w|² under the constraints that the points are in the ellipsoids. g is concave. Its
/// largest value is ½ distance², at y = (αφ, βφ). The s of find_shift() is that of the maximum of g
/// on the ray y1 = t y2. As a function of the ray these maxima have a single maximum, and t²B - A
/// has the sign of minus their slope. If the maximum on a ray is at y = 0, f <= 1 at λ = t/(1+t),
/// where f is that of the contact function. A - t²B has the sign of the slope of f, so the search
/// moves to where f > 1.
template <class Pair, class T>
[[gnu::noinline]] PW85_FUNCTION inline auto search_normal(Pair const &pair, T ratio) noexcept
{
    auto state = safeguarded_search(ratio, 0);
    T shift = T(0);
    for (int i = 1;; ++i) {
        shift = find_shift(pair, state.t, shift);
        Multipliers<T> const x{state.t, shift};
        auto const v = solve_normal(pair, factorize_normal(pair, x), x);
        auto const step = newton_step(pair, v.jet, x);
        if (is_within(step, v.jet, last_digits<T>())) return advance(v, x, step);
        take_bound(state, !(x.ratio * x.ratio * v.jet.b > v.jet.a), x.ratio);
        if (i >= max_ratios<T>() || is_narrow(state, T(T(4) * unit_roundoff<T>()))) return v.u;
        take_step(state, advance(x, step).ratio, absolute(T(step.numerator / step.denominator)));
    }
}

} // namespace pw85::detail

#endif
