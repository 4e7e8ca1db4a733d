// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A proof for penetration.hpp that a depth is the smallest one for a range of c, by intervals of c
/// (depth_search.hpp). Next to the best minimum another proof takes over (depth_minimum.hpp).
#ifndef PW85_DISTANCE_DEPTH_INTERVALS_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_INTERVALS_HPP_INCLUDED

#include <pw85/distance/depth_search.hpp>

namespace pw85::detail {

/// Whether D is proved not to be below the smallest value found, for c from `c` to ρ²c. The
/// directions that this computes are tried as well.
///
/// With c0 = ρc, 1/c is at least 2/c0 - c/c0², its tangent. If this bound replaces 1/c, W is affine
/// in c. Then for each n the root of nᵀWn is concave in c, and smallest at an end of the interval.
/// So D(c) is at least the smaller depth of r in W(c0/ρ) - δQ2 and W(c0ρ) - δQ2, with δ = (ρ -
/// 1)²/(ρc0).
template <class T, int D>
PW85_FUNCTION inline bool none_deeper(DepthSearch<T, D> &search, T const &c, T const &rho) noexcept
{
    T const middle = rho * c, deficit = (rho - T(1)) * (rho - T(1)) / (rho * middle),
            level = search.best.length;
    for (int end = 0; end < 2; ++end) {
        auto const form =
            enclosing_form(search.q1, search.q2, end == 0 ? c : T(rho * middle), deficit);
        Vector<T, D> const n = extreme_normal(form, search.r12, true);
        Shift<T> const found = try_direction(search, n);
        if (search.best.length < level - T(2) * search.best.rounding) descend(search, found.ratio);
        T const depth = support(form, n).extent - dot(n, search.r12);
        if (!(depth >= search.best.length - T(2) * maximum(search.best.rounding, found.rounding)))
            return false;
    }
    return true;
}

/// The largest number of intervals that the proof takes. A few hundred are usual.
inline constexpr int max_depth_intervals = 20000;

/// Proves the depth for a range of c by intervals that are as long as possible. Returns false if
/// there are too many. The bound of none_deeper() is off by O(log²ρ). So the intervals that can be
/// proved shrink towards a minimum, in proportion to their distance from it. An interval that is
/// shorter than the root of u counts as proved, because what it leaves open is below rounding.
template <class T, int D> PW85_FUNCTION inline bool prove_depth(DepthSearch<T, D> &search,
                                                                RatioRange<T> const &range) noexcept
{
    T const shortest = negative_power_of_two<T>(mantissa_digits<T>() / 2), longest = T(1);
    T c = range.lower, width = T(0.5);
    for (int i = 0; i < max_depth_intervals && c < range.upper; ++i) {
        T const end = minimum(range.upper, T((T(1) + width) * (T(1) + width) * c));
        if (none_deeper(search, c, square_root(T(end / c))) || width <= shortest) {
            c = end;
            width = minimum(longest, T(width + width));
        } else
            width = T(0.5) * width;
    }
    return !(c < range.upper);
}

} // namespace pw85::detail

#endif
