/// @file
/// The distance of two ellipsoids, and their closest points.
///
/// The width of the slab normal to any n between them is a lower bound, and that between any two points an upper one: with the
/// normal of normal_search.hpp they are the same (item 1 there).
#ifndef PW85_DISTANCE_HPP_INCLUDED
#define PW85_DISTANCE_HPP_INCLUDED

#include <pw85/normal_search.hpp>
#include <pw85/overlap.hpp>

namespace pw85 {

/// How far the surfaces of two ellipsoids are apart. If they overlap, the distance is zero and the vectors are NaN.
template <class T, int D> struct Distance {
    T distance;
    Vector<T, D> point1, point2; ///< the closest points, relative to the centre of ellipsoid 1
    Vector<T, D> normal; ///< unit vector out of ellipsoid 1 and into ellipsoid 2: the derivative with respect to r12
    Status status;
};

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

/// The point of an ellipsoid that is farthest along n, Qn/α, and α.
template <class T, int D> struct Support {
    Vector<T, D> point;
    T extent;
};

template <class T, int D>
PW85_FUNCTION inline Support<T, D> support(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Vector<T, D> const point = product(q, n);
    T const extent = square_root(positive_form(q, n, point));
    return {times(T(T(1) / extent), point), extent};
}

/// The width of the slab normal to u between a pair, and the points that touch it, relative to their own centres.
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance_along(DistancePair<T, D> const &pair, Vector<T, D> const &u) noexcept
{
    T const norm = T(1) / square_root(dot(u, u));
    Support<T, D> const s1 = support(pair.q1, u), s2 = support(pair.q2, u);
    T const width = norm * (dot(u, pair.r12) - pair.scale1 * s1.extent - pair.scale2 * s2.extent);
    return {maximum(T(0), width), s1.point, s2.point, times(norm, u), Status::success};
}

/// distance() of a pair that is in range and apart, with both points relative to their own centres. All callers share one
/// instance, so that products are fused alike and scaling changes no bit of the result.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> distance_in_range(DistancePair<T, D> const &pair) noexcept
{
    Multipliers<T> const start = initial_multipliers(pair);
    Vector<T, D> u;
    // Semi-axes are below √12 of their units, so that n is within 7 scales of the direction of r12: rounding.
    if (maximum(pair.scale1, pair.scale2) <= T(0.125) * unit_roundoff<T>())
        u = pair.r12;
    else if (!find_normal(pair, start, u) && !find_normal(pair, touching_multipliers(pair), u))
        u = search_normal(pair, start.ratio);
    return distance_along(pair, u);
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
    for (int i = 0; i < D; ++i) result.point2[i] = r12[i] - result.point2[i];
    return result;
}

/// The distance of a pair that overlaps or is invalid.
template <class T, int D> PW85_FUNCTION inline Distance<T, D> no_distance(Status status) noexcept
{
    Distance<T, D> result{status == Status::success ? T(0) : quiet_nan<T>(), {}, {}, {}, status};
    for (int i = 0; i < D; ++i) result.point1[i] = result.point2[i] = result.normal[i] = quiet_nan<T>();
    return result;
}

template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    Overlap const decision = overlap(r12, q1, q2);
    if (decision.status != Status::success || decision.overlap) return no_distance<T, D>(decision.status);
    return distance_apart(r12, q1, q2);
}

} // namespace pw85

#endif
