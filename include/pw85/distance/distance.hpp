/// @file
/// The distance of two ellipsoids, and their closest points.
///
/// The width of the slab normal to any n between them is a lower bound, and that between any two points an upper one: with the
/// normal of normal_search.hpp they are the same (item 1 there).
#ifndef PW85_DISTANCE_DISTANCE_HPP_INCLUDED
#define PW85_DISTANCE_DISTANCE_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/doubled.hpp>
#include <pw85/distance/normal_search.hpp>
#include <pw85/distance/support.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// How far the surfaces of two ellipsoids are apart. If they overlap, the distance is zero and the vectors are NaN.
template <class T, int D> struct Distance {
    T distance;
    Vector<T, D> point1, point2; ///< the closest points, relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector out of ellipsoid 1 and into ellipsoid 2: the derivative with respect to r12
    Status status;
};

} // namespace pw85

namespace pw85::detail {

/// Exponents of the units of a DistancePair: the caller's separation is 2^length, form i 4^form_i times the pair's.
struct DistanceUnits {
    int length, form1, form2;
};

/// Brings a valid pair that is apart into range.
template <class T, int D>
PW85_FUNCTION inline DistancePair<T, D> scale_distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                       SymmetricMatrix<T, D> const &q2, DistanceUnits &units) noexcept
{
    units = {binary_exponent(largest_coordinate(r12)), half_exponent(largest_diagonal(q1)),
             half_exponent(largest_diagonal(q2))};
    return {times_power_of_two(r12, -units.length), times_power_of_two(q1, -2 * units.form1),
            times_power_of_two(q2, -2 * units.form2), times_power_of_two(T(1), units.form1 - units.length),
            times_power_of_two(T(1), units.form2 - units.length)};
}

/// The slab between a pair that is normal to u, of any length, with the points that touch it, relative to their own centres.
template <class T, int D> struct Slab {
    Vector<T, D> u;
    Support<T, D> support1, support2;
    T norm2;        ///< uᵀu
    T along, width; ///< u·r12 and the width, both times |u|
};

template <class T, int D>
PW85_FUNCTION inline Slab<T, D> slab_along(DistancePair<T, D> const &pair, Vector<T, D> const &u) noexcept
{
    Support<T, D> const s1 = support(pair.q1, u), s2 = support(pair.q2, u);
    T const along = dot(u, pair.r12);
    return {u, s1, s2, dot(u, u), along, along - pair.scale1 * s1.extent - pair.scale2 * s2.extent};
}

template <class T, int D> PW85_FUNCTION inline Distance<T, D> distance_across(Slab<T, D> const &slab) noexcept
{
    T const reciprocal = T(1) / square_root(slab.norm2);
    return {maximum(T(0), T(reciprocal * slab.width)), slab.support1.point, slab.support2.point, reciprocal * slab.u,
            Status::success};
}

/// Whether the half-width along u, and so the point of the surface, errs by less than `bound` relative to itself: by 3u of the
/// magnitudes of the products in its square, which are not above the trace.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate(SymmetricMatrix<T, D> const &q, Support<T, D> const &s, Slab<T, D> const &slab, T const &bound) noexcept
{
    T const least = bound * (s.extent * s.extent), error = T(3) * unit_roundoff<T>();
    auto const clear = error * (trace(q) * slab.norm2) <= least;
    if (all_of(clear)) return clear;
    return T(error * magnitude_of_form(q, slab.u)) <= least;
}

/// Whether a slab gives the distance and the points: for half-widths that err by less than `bound`, and for the way between the
/// points, w = r12 - (Q1/α + Q2/β)n. The part of w across n, which is zero for the normal,
///
/// 1. is below `bound` times the root of the sum of the squares of r12 and of the points relative to their own centres: these are
///    the closest points of the pair whose r12 differs by that part;
/// 2. has a square below 2u (n·r12) max(width, u n·r12): the width lacks less than it of the distance, at most |w| less the width,
///    2u n·r12, which is below 2uΣ of pw85_distance(); u is `unit`.
template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate(DistancePair<T, D> const &pair, Slab<T, D> const &slab, T const &unit, T const &bound) noexcept
{
    Vector<T, D> const p1 = pair.scale1 * slab.support1.point, p2 = pair.scale2 * slab.support2.point;
    auto const off = cross(pair.r12 - (p1 + p2), slab.u);
    T const off2 = dot(off, off);
    return off2 <= bound * bound * slab.norm2 * (dot(pair.r12, pair.r12) + dot(p1, p1) + dot(p2, p2)) &&
           off2 <= T(2) * unit * slab.along * maximum(slab.width, T(unit * slab.along)) &&
           is_accurate(pair.q1, slab.support1, slab, bound) && is_accurate(pair.q2, slab.support2, slab, bound);
}

/// By how much the points of a slab may err: half of the 2^18 u that pw85_distance() promises for either source of errors.
template <class T> PW85_FUNCTION constexpr T largest_error() noexcept { return T(T(128000) * unit_roundoff<T>()); }

template <class T, int D> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_accurate(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    return is_accurate(pair, slab, T(unit_roundoff<T>()), largest_error<T>());
}

/// The slab of the distance of a pair, as far as the search by T leads.
template <class T, int D> struct FoundSlab {
    Slab<T, D> slab;
    typename ScalarTraits<T>::Mask found, accurate;
};

/// Types with digits to spare need no certificate.
template <class T, int D>
PW85_FUNCTION inline FoundSlab<T, D> judge(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    return {slab, true, std::is_same_v<Finer<T>, T> || is_accurate(pair, slab)};
}

/// By Newton's method, which finds nearly all.
template <class T, int D> PW85_FUNCTION inline FoundSlab<T, D> find_slab(DistancePair<T, D> const &pair) noexcept
{
    // Semi-axes are below √12 of their units, so that n is within 7 scales of the direction of r12: rounding.
    bool const far = maximum(pair.scale1, pair.scale2) <= T(0.125) * unit_roundoff<T>();
    auto const start = initial_multipliers(pair);
    LastStep<T, D> const last = far ? LastStep<T, D>{pair.r12, start, true} : find_normal(pair, start);
    if (!last.found) return {{}, false, false};
    return judge(pair, slab_along(pair, last.u));
}

/// By Newton's method from where the ellipsoids would touch, else by the nested search.
template <class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline FoundSlab<T, D> search_slab(DistancePair<T, D> const &pair) noexcept
{
    auto const last = find_normal(pair, touching_multipliers(pair));
    Vector<T, D> const u = last.found ? last.u : search_normal(pair, initial_multipliers(pair).ratio);
    return judge(pair, slab_along(pair, T(T(1) / square_root(dot(u, u))) * u));
}

/// t and s of the search for the normal, for that of a slab: with the half-widths a|u| and b|u| along u they are a/b and aφ.
template <class T, int D> PW85_FUNCTION inline Multipliers<T> multipliers(Slab<T, D> const &slab) noexcept
{
    T const a = slab.support1.extent;
    return {a / slab.support2.extent, maximum(T(0), T(a * slab.width / slab.norm2))};
}

template <class T, int D>
PW85_FUNCTION constexpr DistancePair<Finer<T>, D> finer(DistancePair<T, D> const &pair) noexcept
{
    using F = Finer<T>;
    return {converted<F>(pair.r12), converted<F>(pair.q1), converted<F>(pair.q2), F(pair.scale1), F(pair.scale2)};
}

template <class T, int D> PW85_FUNCTION constexpr Distance<T, D> rounded(Distance<Finer<T>, D> const &d) noexcept
{
    return {rounded(d.distance), rounded(d.point1), rounded(d.point2), rounded(d.normal), d.status};
}

/// A slab in the finer type, where T leaves a normal or half-widths that are not accurate: by Newton's method, unless the normal serves
/// as it is.
template <class T, int D>
PW85_FUNCTION inline FoundSlab<Finer<T>, D> polish(DistancePair<T, D> const &pair, Slab<T, D> const &slab) noexcept
{
    using F = Finer<T>;
    auto const fine = finer(pair);
    F const unit = F(unit_roundoff<T>());
    auto const given = slab_along(fine, converted<F>(slab.u));
    if (is_accurate(fine, given, unit, F(largest_error<T>()))) return {given, true, true};
    auto const start = multipliers(slab);
    Multipliers<F> x{F(start.ratio), F(start.shift)};
    for (int i = 0; i < max_last_steps; ++i) {
        auto const last = take_last_step(fine, factorize_normal(fine, x), x);
        auto const polished = slab_along(fine, last.u);
        if (is_accurate(fine, polished, unit, F(T(64.0) * unit_roundoff<T>()))) return {polished, true, true};
        x = last.next;
    }
    return {given, true, false};
}

/// Where find_slab() has not led to an accurate slab. Arguments that are copied stay in registers where it is not called.
template <class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline Distance<T, D>
refined_distance(DistancePair<T, D> pair, FoundSlab<T, D> found) noexcept
{
    if (!found.found) found = search_slab(pair);
    if (found.accurate) return distance_across(found.slab);
    auto const polished = polish(pair, found.slab);
    if (!polished.accurate) return all_nan<Distance<T, D>>(Status::no_convergence);
    return rounded<T, D>(distance_across(polished.slab));
}

/// distance() of a pair that is in range and apart, with both points relative to their own centres. All callers share one
/// instance, so that products are fused alike and scaling changes no bit of the result.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> distance_in_range(DistancePair<T, D> const &pair) noexcept
{
    auto const found = find_slab(pair);
    return found.accurate ? distance_across(found.slab) : refined_distance(pair, found);
}

/// distance() of a valid pair that is apart.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance_apart(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Distance<T, D> result;
    if (is_in_range(sum_of_magnitudes(r12), largest_diagonal(q1), largest_diagonal(q2)))
        result = distance_in_range(DistancePair<T, D>{r12, q1, q2, T(1), T(1)});
    else {
        DistanceUnits units;
        result = distance_in_range(scale_distance(r12, q1, q2, units));
        result.distance = times_power_of_two(result.distance, units.length);
        result.point1 = times_power_of_two(result.point1, units.form1);
        result.point2 = times_power_of_two(result.point2, units.form2);
    }
    result.point2 = r12 - result.point2;
    return result;
}

/// The distance of a pair that overlaps or is invalid.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> no_distance(Status status) noexcept
{
    auto result = all_nan<Distance<T, D>>(status);
    if (status == Status::success) result.distance = T(0);
    return result;
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != Status::success || decision.overlap) return detail::no_distance<T, D>(decision.status);
    return detail::distance_apart(r12, q1, q2);
}

} // namespace pw85

#endif
