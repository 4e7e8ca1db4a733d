// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance of two ellipsoids, and their closest points. The kernels of the C API
/// (src/simd/lanes/distance.hpp) and distance_derivatives.hpp call these functions, which call
/// normal_search.hpp for the common normal and overlap() for the decision.
///
/// For any unit vector n, the width of the slab between the ellipsoids that is normal to n is a
/// lower bound of the distance. The distance between any two of their points is an upper bound.
/// With the normal that normal_search.hpp finds, the two bounds are equal.
#ifndef PW85_DISTANCE_DISTANCE_HPP_INCLUDED
#define PW85_DISTANCE_DISTANCE_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/doubled.hpp>
#include <pw85/distance/nested_search.hpp>
#include <pw85/distance/support.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// The distance between the surfaces of two ellipsoids. If they overlap, the distance is zero and
/// the vectors are NaN.
template <class T, int D> struct Distance {
    T distance;
    Vector<T, D> point1, point2; ///< the closest points, relative to the centre of ellipsoid 1
    /// unit vector out of ellipsoid 1 and into ellipsoid 2: the derivative with respect to r12
    Vector<T, D> normal;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Returns a distance in the units of the caller.
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> to_caller(Distance<T, D> result, Units const &units) noexcept
{
    result.distance = units.length.to_caller(result.distance);
    result.point1 = units.first.to_caller(result.point1);
    result.point2 = units.second.to_caller(result.point2);
    return result;
}

/// The slab between a pair that is normal to u, which may have any length. The supports are the
/// points of the ellipsoids that touch the slab, relative to their own centres.
template <class T, int D> struct Slab {
    Vector<T, D> u;
    Support<T, D> support1, support2;
    T norm2;        ///< uᵀu
    T along, width; ///< u·r12 and the width, both times |u|
};

template <class T, int D>
PW85_FUNCTION inline Slab<T, D> slab_between(DistancePair<T, D> const &pair, Vector<T, D> const &u,
                                             Support<T, D> const &s1,
                                             Support<T, D> const &s2) noexcept
{
    T const along = dot(u, pair.r12);
    return {u, s1, s2, dot(u, u), along, along - pair.scale1 * s1.extent - pair.scale2 * s2.extent};
}

template <class T, int D> PW85_FUNCTION inline Slab<T, D> slab_along(DistancePair<T, D> const &pair,
                                                                     Vector<T, D> const &u) noexcept
{
    return slab_between(pair, u, support(pair.q1, u), support(pair.q2, u));
}

template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance_across(Slab<T, D> const &slab) noexcept
{
    T const reciprocal = T(1) / square_root(slab.norm2);
    return {maximum(T(0), T(reciprocal * slab.width)), slab.support1.point, slab.support2.point,
            reciprocal * slab.u, StatusCode::success};
}

/// Returns whether the width of a slab exceeds its rounding error, 8uΣ of pw85_distance(). If so,
/// the pair is proved to be apart. Here the traces take the place of the magnitudes of the products
/// in the forms.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_wide(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    T const error = T(8 * unit_roundoff<T>()), a = slab.support1.extent, b = slab.support2.extent;
    T const forms = (trace(pair.q1) + trace(pair.q2)) * slab.norm2;
    return (slab.width - error * (magnitude_of_dot(slab.u, pair.r12) + (a + b))) * minimum(a, b) >
           error * forms;
}

/// Returns whether X of support.hpp is at most `spread`. The form also passes if X is at most
/// `plain` when the trace in X is replaced by the magnitudes of the products in the form. In plain
/// arithmetic 3uX bounds the error of the half-width also with these magnitudes.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_within_spread(SymmetricMatrix<T, D> const &q, Support<T, D> const &s, Slab<T, D> const &slab,
                 T const &spread, T const &plain) noexcept
{
    T const square = s.extent * s.extent;
    auto const within = trace(q) * slab.norm2 <= spread * square;
    if (all_of(within)) return within;
    return within || magnitude_of_form(q, slab.u) <= plain * square;
}

template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_within_spread(DistancePair<T, D> const &pair, Slab<T, D> const &slab, T const &spread,
                 T const &plain) noexcept
{
    return is_within_spread(pair.q1, slab.support1, slab, spread, plain) &&
           is_within_spread(pair.q2, slab.support2, slab, spread, plain);
}

/// The largest error of the points of a slab, in units of u. pw85_distance() promises 2^18 u. The
/// errors have two sources, rounding and the direction of the normal. Each may use half of 2^18.
template <class T> PW85_FUNCTION constexpr T largest_error() noexcept { return T(128000); }

/// Computes a slab whose half-widths and points err by less than largest_error(), if X is at most
/// largest_spread().
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Slab<T, D>
accurate_slab_along(DistancePair<T, D> const &pair, Vector<T, D> const &u) noexcept
{
    Slab<T, D> slab = slab_along(pair, u);
    T const plain = T(largest_error<T>() / T(3));
    auto const clear = is_within_spread(pair, slab, plain, plain);
    if (all_of(clear)) return slab;
    Slab<T, D> const accurate = slab_between(pair, u, support_from(accurate_product(pair.q1, u), u),
                                             support_from(accurate_product(pair.q2, u), u));
    slab.width = select(clear, slab.width, accurate.width);
    slab.support1.extent = select(clear, slab.support1.extent, accurate.support1.extent);
    slab.support2.extent = select(clear, slab.support2.extent, accurate.support2.extent);
    for (int i = 0; i < D; ++i) {
        slab.support1.point[i] = select(clear, slab.support1.point[i], accurate.support1.point[i]);
        slab.support2.point[i] = select(clear, slab.support2.point[i], accurate.support2.point[i]);
    }
    return slab;
}

/// Returns whether a slab gives the distance and the points. is_within_spread() bounds the errors
/// of the half-widths and points. The vector from the first point to the second one is w = r12 -
/// (Q1/α + Q2/β)n. For the exact normal its component perpendicular to n is zero. This part must
/// satisfy two conditions:
///
/// 1. The part is below `bound` times the root of the sum of the squares of r12 and of the points
///    relative to their own centres. Then these are the closest points of the pair whose r12
///    differs by this part.
/// 2. The square of the part is below 2u (n·r12) max(width, u n·r12), where u is `unit`. The
///    distance exceeds the width by at most |w| - width, which is then below 2u n·r12. This is
///    below 2uΣ of pw85_distance().
///
/// The bounds are those of a slab that accurate_slab_along() has computed, unless others are given.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_accurate(
    DistancePair<T, D> const &pair, Slab<T, D> const &slab, T const &unit = T(unit_roundoff<T>()),
    T const &bound = T(largest_error<T>() * T(unit_roundoff<T>())),
    T const &spread = largest_spread<T>(), T const &plain = T(largest_error<T>() / T(3))) noexcept
{
    Vector<T, D> const p1 = pair.scale1 * slab.support1.point,
                       p2 = pair.scale2 * slab.support2.point;
    auto const off = cross(pair.r12 - (p1 + p2), slab.u);
    T const off2 = dot(off, off), along = slab.along, factor = bound * bound;
    auto const accurate = off2 <= T(2) * unit * along * maximum(slab.width, T(unit * along)) &&
                          is_within_spread(pair, slab, spread, plain);
    if (all_of(off2 <= factor * (along * along))) return accurate; // (u·r12)² is at most |u|²|r12|²
    return accurate &&
           off2 <= factor * slab.norm2 * (dot(pair.r12, pair.r12) + dot(p1, p1) + dot(p2, p2));
}

/// The slab that gives the distance of a pair, as far as the search in the type T finds it.
template <class T, int D> struct FoundSlab {
    Slab<T, D> slab;
    typename ScalarTraits<T>::Mask found, accurate;
    bool tried; ///< false if the search has not begun
};

/// Computes the slab of a normal. Types with digits to spare need no certificate of its accuracy.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline FoundSlab<T, D>
found_slab(DistancePair<T, D> const &pair, Vector<T, D> const &u) noexcept
{
    if constexpr (std::is_same_v<Finer<T>, T>)
        return {slab_along(pair, u), true, true, true};
    else {
        auto const slab = accurate_slab_along(pair, u);
        return {slab, true, is_accurate(pair, slab), true};
    }
}

/// Returns whether f > 1 at the λ with which a search starts. Then the pair is apart, up to
/// rounding. The polynomials of the search give f. Most pairs that are apart pass this test.
template <class T, int D> PW85_FUNCTION constexpr bool
seems_apart(DistancePair<T, D> const &pair, NormalSearch<T> const &search) noexcept
{
    auto const &[a, a_s, a_ss, b, b_s, b_ss, b_sss] = search.form;
    T const t = search.x.ratio, numerator = a[0] + t * (a[1] + t * a[2]);
    return t * numerator >
           (pair.scale1 * t + pair.scale2) * ((b[0] + t * b[1]) + (t * t) * (b[2] + t * b[3]));
}

/// Finds the slab by Newton's method, which succeeds for nearly all pairs. If it is not known
/// whether the pair is apart, the search begins only if seems_apart(). All callers share one
/// instance of this function. So products are fused alike, and scaling changes no bit of the
/// result.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FoundSlab<T, D>
find_slab(DistancePair<T, D> const &pair, bool apart) noexcept
{
    // Semi-axes are below √12 times their units, so the angle between n and r12 is at most 7 times
    // the larger scale, which is below rounding.
    if (maximum(pair.scale1, pair.scale2) <= T(0.125) * unit_roundoff<T>())
        return found_slab(pair, pair.r12);
    auto const search = start_search(pair);
    if (!apart && !seems_apart(pair, search)) return {{}, false, false, false};
    LastStep<T, D> const last = find_normal(pair, search);
    if (!last.found) return {{}, false, false, true};
    return found_slab(pair, last.u);
}

/// Finds the slab by Newton's method, which starts where the ellipsoids would touch. If this fails,
/// the nested search follows.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FoundSlab<T, D>
search_slab(DistancePair<T, D> const &pair) noexcept
{
    auto const last = find_normal(pair, start_search(pair, touching_multipliers(pair)));
    Vector<T, D> const u =
        last.found ? last.u : search_normal(pair, initial_multipliers(pair).ratio);
    return found_slab(pair, unit_along(u));
}

/// The values of t and s of the search for the normal that belong to a slab. With the half-widths
/// a|u| and b|u| along u they are a/b and aφ.
template <class T, int D>
PW85_FUNCTION inline Multipliers<T> multipliers(Slab<T, D> const &slab) noexcept
{
    T const a = slab.support1.extent;
    return {a / slab.support2.extent, maximum(T(0), T(a * slab.width / slab.norm2))};
}

/// Takes one more step from a slab, by factorisation, whose products are accurate.
template <class T, int D> PW85_FUNCTION inline FoundSlab<T, D>
step_slab(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    auto const x = multipliers(slab);
    return found_slab(pair, take_last_step(pair, factorize_normal(pair, x), x).u);
}

template <class T, class F, int D>
PW85_FUNCTION constexpr Distance<T, D> rounded_to(Distance<F, D> const &d) noexcept
{
    return {rounded(d.distance), rounded(d.point1), rounded(d.point2), rounded(d.normal), d.status};
}

/// Returns whether a slab in the type F, which has more digits than T, is accurate in T.
///
/// @param largest of the errors of the points, in units of u of T
template <class T, class F, int D> PW85_FUNCTION constexpr bool
is_accurate_in(DistancePair<F, D> const &fine, Slab<F, D> const &slab, T const &largest) noexcept
{
    F const unit = F(unit_roundoff<T>()),
            spread = F(largest_error<T>()) * unit / (F(3) * F(unit_roundoff<F>()));
    return is_accurate(fine, slab, unit, F(largest) * unit, spread, spread);
}

/// Finds the slab in the type F, for a normal or half-widths that are not accurate in T. If the
/// given normal is not accurate enough, at most `steps` steps of Newton's method improve it.
template <class F, class T, int D> PW85_FUNCTION inline FoundSlab<F, D>
polish(DistancePair<T, D> const &pair, Slab<T, D> const &slab, int steps) noexcept
{
    auto const fine = finer<F>(pair);
    auto const given = slab_along(fine, converted<F>(slab.u));
    if (is_accurate_in<T>(fine, given, largest_error<T>())) return {given, true, true, true};
    auto const start = multipliers(slab);
    Multipliers<F> x{F(start.ratio), F(start.shift)};
    for (int i = 0; i < steps; ++i) {
        auto const last = take_last_step(fine, factorize_normal(fine, x), x);
        auto const polished = slab_along(fine, last.u);
        if (is_accurate_in<T>(fine, polished, T(64))) return {polished, true, true, true};
        x = last.next;
    }
    return {given, true, false, true};
}

/// Finds the slab with seven times the digits of T, by Newton's method, or else by the nested
/// search.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FoundSlab<Widened<T>, D>
polish_extended(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    using F = Widened<T>;
    auto const polished = polish<F>(pair, slab, max_normal_steps + max_last_steps);
    if (polished.accurate) return polished;
    auto const fine = finer<F>(pair);
    auto const ratio = F(multipliers(slab).ratio);
    auto const found =
        slab_along(fine, unit_along(search_normal(fine, ratio > F(0) ? ratio : F(1))));
    return {found, true, is_accurate_in<T>(fine, found, largest_error<T>()), true};
}

/// Searches for the slab of a pair for which find_slab() has not found an accurate one. Returns
/// answer(found) for the slab that it finds: in T, or with twice the digits, or with seven times
/// the digits if T has extended numbers. found.accurate is false if all of them fail.
///
/// Let L be the longest semi-axis, h a half-width along the normal, and 2^-p the rounding error of
/// an operation. Where the terms of Qn cancel, the point Qn/h errs by 2^-p L²/h. It needs u n·r12
/// if the ellipsoids nearly touch. So L² <= 2^p u h n·r12 is enough: with h about n·r12, lengths up
/// to some 2^26 n·r12 for twice the digits of double, and 2^157 n·r12 for seven times the digits.
template <class T, int D, class Answer>
PW85_FUNCTION inline auto refine_slab(DistancePair<T, D> const &pair, FoundSlab<T, D> const &slab,
                                      Answer const &answer) noexcept
{
    FoundSlab<T, D> found = slab;
    if (!found.found) found = search_slab(pair);
    if (!found.accurate) found = step_slab(pair, found.slab);
    if (found.accurate) return answer(found);
    auto const polished = polish<Finer<T>>(pair, found.slab, max_last_steps);
    if constexpr (has_extended_numbers<T>)
        if (!polished.accurate) return answer(polish_extended(pair, found.slab));
    return answer(polished);
}

/// The distance of a pair for which find_slab() has not found an accurate slab. It is in memory, as
/// a result of that function.
template <class T, int D> PW85_RARE Distance<T, D>
refined_distance(DistancePair<T, D> const &pair, FoundSlab<T, D> const &slab) noexcept
{
    return refine_slab(pair, slab, [](auto const &found) {
        return found.accurate ? rounded_to<T>(distance_across(found.slab))
                              : all_nan<Distance<T, D>>(StatusCode::no_convergence);
    });
}

/// The distance of a pair that is apart, from the result of find_slab(). Both points are relative
/// to their own centres.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance_of_slab(DistancePair<T, D> const &pair, FoundSlab<T, D> const &found) noexcept
{
    return found.accurate ? distance_across(found.slab) : refined_distance(pair, found);
}

/// Returns the result with both points relative to the centre of ellipsoid 1.
template <class T, int D> PW85_FUNCTION constexpr Distance<T, D>
with_point2(Vector<T, D> const &r12, Distance<T, D> result) noexcept
{
    result.point2 = r12 - result.point2;
    return result;
}

/// Computes distance() of a valid pair that is apart.
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance_apart(Vector<T, D> const &r12,
                                                   SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2) noexcept
{
    Distance<T, D> result;
    if (is_in_range(sum_of_magnitudes(r12), largest_diagonal(q1), largest_diagonal(q2))) {
        DistancePair<T, D> const pair{r12, q1, q2, T(1), T(1)};
        result = distance_of_slab(pair, find_slab(pair, true));
    } else {
        auto const [pair, units] = scale_distance(r12, q1, q2);
        result = to_caller(distance_of_slab(pair, find_slab(pair, true)), units);
    }
    return with_point2(r12, result);
}

PW85_RARE_TIER(refined_distance)

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance(Vector<T, D> const &r12,
                                             SymmetricMatrix<T, D> const &q1,
                                             SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    DistancePair<T, D> const pair{r12, q1, q2, T(1), T(1)};
    bool const ordinary = passes_fast_checks(r12, q1, q2);
    auto const found = ordinary ? find_slab(pair, false) : FoundSlab<T, D>{{}, false, false, false};
    if (found.accurate && is_wide(pair, found.slab))
        return with_point2(r12, distance_across(found.slab));
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != StatusCode::success || decision.overlap) {
        auto result = all_nan<Distance<T, D>>(decision.status);
        if (decision.overlap) result.distance = T(0);
        return result;
    }
    return found.tried ? with_point2(r12, distance_of_slab(pair, found))
                       : distance_apart(r12, q1, q2);
}

} // namespace pw85

#endif
