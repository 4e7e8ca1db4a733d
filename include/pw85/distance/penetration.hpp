/// @file
/// The depth of an overlap: the shortest translation that separates two ellipsoids.
///
/// With α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12, ellipsoid 2 must move by g(n) = α + β - n·r along the unit vector n. The depth
/// is the smallest value of g, which may have several local minima; the proof that one is the global minimum is a search over one
/// number:
///
/// 1. (α + β)² is the smallest value over c > 0 of nᵀWn, W(c) = (1 + c) Q1 + (1 + 1/c) Q2, reached at c = β/α. So the depth is that of
///    the point r in the ellipsoid W(c), D(c), at its smallest over c. For each c, D is found without search (nearest.hpp), whatever
///    the symmetry: ellipsoids of revolution and concentric ones are no exception.
/// 2. For c from c0/ρ to c0ρ, 1/c is at least 2/c0 - c/c0². With this in its place W is affine in c, so that for each n the root
///    of nᵀWn is concave, and smallest at an end: D(c) is at least the smaller depth of r in W(c0/ρ) - δQ2 and W(c0ρ) - δQ2,
///    δ = (ρ - 1)²/(ρc0).
/// 3. This errs by a square of log ρ. Where D is quadratic, the intervals on which it proves that D is not below the smallest value
///    by more than rounding are longer in proportion to their distance from it: some hundred are enough.
#ifndef PW85_DISTANCE_PENETRATION_HPP_INCLUDED
#define PW85_DISTANCE_PENETRATION_HPP_INCLUDED

#include <pw85/distance/nearest.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids: zero, and a NaN direction, if they are apart.
template <class T, int D> struct Penetration {
    T depth;
    Vector<T, D> direction; ///< unit vector
    Status status;
};

} // namespace pw85

namespace pw85::detail {

template <class T, int D> PW85_FUNCTION inline Penetration<T, D> no_penetration(Status status) noexcept
{
    auto result = all_nan<Penetration<T, D>>(status);
    if (status == Status::success) result.depth = T(0);
    return result;
}

/// By how far ellipsoid 2 must move along n, with the ratio c of the half-widths and the rounding error.
template <class T> struct Shift {
    T length, ratio, rounding;
};

template <class T, int D> PW85_FUNCTION inline Shift<T> shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
                                                                    SymmetricMatrix<T, D> const &q1,
                                                                    SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const weights = outer_weights(n);
    T const a = square_root(positive_form(q1, weights)), b = square_root(positive_form(q2, weights));
    T const sum = magnitude_of_dot(n, r12) + magnitude_of_form(q1, n) / (a + a) + magnitude_of_form(q2, n) / (b + b);
    return {a + b - dot(n, r12), b / a, T(8 * unit_roundoff<T>()) * sum};
}

/// W(c) less `deficit` Q2.
template <class T, int D> PW85_FUNCTION constexpr SymmetricMatrix<T, D>
enclosing_form(SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2, T const &c, T const &deficit) noexcept
{
    return blend(T(T(1) + c), q1, T(T(1) + (T(1) / c - deficit)), q2);
}

/// The search for the depth of a pair, with the best direction so far.
template <class T, int D> struct DepthSearch {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Vector<T, D> direction;
    Shift<T> best;
};

/// Takes note of a direction; returns what it gives.
template <class T, int D>
PW85_FUNCTION inline Shift<T> try_direction(DepthSearch<T, D> &search, Vector<T, D> const &n) noexcept
{
    Shift<T> const shift = shift_along(n, search.r12, search.q1, search.q2);
    if (shift.length < search.best.length) {
        search.best = shift;
        search.direction = n;
    }
    return shift;
}

/// By what fraction the ratio of the half-widths along the direction of D(c) exceeds c: the slope of D has the opposite sign.
template <class T, int D> PW85_FUNCTION inline T try_ratio(DepthSearch<T, D> &search, T const &c) noexcept
{
    auto const form = enclosing_form(search.q1, search.q2, c, T(0));
    return try_direction(search, extreme_normal(form, search.r12, true)).ratio / c - T(1);
}

/// Follows D to a local minimum: the next c is that of the direction, or where the secant says that they agree. D is right to
/// rounding where its slope is below the root of that, after a few steps; that it is the least is shown elsewhere.
template <class T, int D> PW85_FUNCTION inline void descend(DepthSearch<T, D> &search, T c) noexcept
{
    T const small = negative_power_of_two<T>(mantissa_digits<T>() / 2 + 2);
    T excess = try_ratio(search, c), step = excess;
    for (int i = 0; i < 16 && absolute(excess) > small; ++i) {
        T const next = c * (T(1) + step), after = try_ratio(search, next);
        T const secant = step * after / (excess - after);
        bool const forward = secant * after > T(0) && absolute(secant) < T(8) * absolute(after) && secant > T(-0.5);
        step = forward ? secant : after;
        excess = after;
        c = next;
    }
}

/// The range of c = β/α over all directions, and twice as far for rounding.
template <class T> struct RatioRange {
    T lower, upper;
};

template <class T, int D> PW85_FUNCTION inline RatioRange<T> ratio_range(SymmetricMatrix<T, D> const &q1,
                                                                         SymmetricMatrix<T, D> const &q2) noexcept
{
    int const unit1 = half_exponent(largest_diagonal(q1)), unit2 = half_exponent(largest_diagonal(q2));
    auto const p1 = principal_axes(times_power_of_two(q1, -2 * unit1)),
               p2 = principal_axes(times_power_of_two(q2, -2 * unit2));
    T least1 = p1.squares[0], most1 = least1, least2 = p2.squares[0], most2 = least2;
    for (int i = 1; i < D; ++i) {
        least1 = minimum(least1, p1.squares[i]);
        most1 = maximum(most1, p1.squares[i]);
        least2 = minimum(least2, p2.squares[i]);
        most2 = maximum(most2, p2.squares[i]);
    }
    return {times_power_of_two(T(T(0.5) * square_root(T(least2 / most1))), unit2 - unit1),
            times_power_of_two(T(T(2) * square_root(T(most2 / least1))), unit2 - unit1)};
}

/// Whether item 2 shows that D is not smaller than the smallest value found, for c from `c` to ρ²c; directions that come to light
/// are tried.
template <class T, int D>
PW85_FUNCTION inline bool none_deeper(DepthSearch<T, D> &search, T const &c, T const &rho) noexcept
{
    T const middle = rho * c, deficit = (rho - T(1)) * (rho - T(1)) / (rho * middle), level = search.best.length;
    for (int end = 0; end < 2; ++end) {
        auto const form = enclosing_form(search.q1, search.q2, end == 0 ? c : T(rho * middle), deficit);
        Vector<T, D> const n = extreme_normal(form, search.r12, true);
        Shift<T> const found = try_direction(search, n);
        if (search.best.length < level - T(2) * search.best.rounding) descend(search, found.ratio);
        T const depth = support(form, n).extent - dot(n, search.r12);
        if (!(depth >= search.best.length - T(2) * maximum(search.best.rounding, found.rounding))) return false;
    }
    return true;
}

/// The largest number of intervals that the proof takes: some hundred are usual.
inline constexpr int max_depth_intervals = 20000;

/// Goes through a range of c by intervals, as long as they can be; false if there are too many. One that is shorter than the root
/// of u leaves less than rounding open.
template <class T, int D>
PW85_FUNCTION inline bool prove_depth(DepthSearch<T, D> &search, RatioRange<T> const &range) noexcept
{
    T const shortest = negative_power_of_two<T>(mantissa_digits<T>() / 2);
    T c = range.lower, width = T(0.5);
    for (int i = 0; i < max_depth_intervals; ++i) {
        T const rho = T(1) + width;
        if (none_deeper(search, c, rho) || width <= shortest) {
            c = rho * rho * c;
            width = minimum(T(0.5), T(width + width));
            if (!(c < range.upper)) return true;
        } else
            width = T(0.5) * width;
    }
    return false;
}

/// penetration() of a valid pair that overlaps, in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline Penetration<T, D>
penetration_in_range(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    RatioRange<T> const range = ratio_range(q1, q2);
    DepthSearch<T, D> search{r12, q1, q2, {}, {largest_number<T>(), T(1), T(0)}};
    constexpr int starts = 8; // the more, the less often a better minimum comes to light in the proof
    T const factor = square_root(square_root(square_root(T(range.upper / range.lower))));
    T c = range.lower * square_root(factor);
    for (int i = 0; i < starts; ++i) {
        try_ratio(search, c);
        c = c * factor;
    }
    descend(search, search.best.ratio);
    if (!prove_depth(search, range)) return no_penetration<T, D>(Status::no_convergence);
    return {maximum(T(0), search.best.length), search.direction, Status::success};
}

/// penetration() of a valid pair that overlaps: the larger ellipsoid is of size 2^room, so that cQ1 and Q2/c are in range for any
/// aspect ratio; a smaller one that would leave it is made larger, which is far below rounding.
template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> penetration_overlapping(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                               SymmetricMatrix<T, D> const &q2) noexcept
{
    constexpr int limit = std::numeric_limits<T>::max_exponent, room = limit / 5 * 2, least = 16 - limit / 2;
    T const size1 = largest_diagonal(q1), size2 = largest_diagonal(q2);
    if (is_in_range(T(1), size1, size2)) return penetration_in_range(r12, q1, q2);
    int const e1 = half_exponent(size1), e2 = half_exponent(size2), unit = maximum(e1, e2) - room;
    int const unit1 = minimum(unit, e1 - least), unit2 = minimum(unit, e2 - least);
    auto result = penetration_in_range(times_power_of_two(r12, -unit), times_power_of_two(q1, -2 * unit1),
                                       times_power_of_two(q2, -2 * unit2));
    result.depth = times_power_of_two(result.depth, unit);
    return result;
}

} // namespace pw85::detail

namespace pw85 {

/// The shortest translation of ellipsoid 2 that separates two ellipsoids.
template <class T, int D> PW85_FUNCTION inline Penetration<T, D>
penetration(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != Status::success || !decision.overlap) return detail::no_penetration<T, D>(decision.status);
    return detail::penetration_overlapping(r12, q1, q2);
}

} // namespace pw85

#endif
