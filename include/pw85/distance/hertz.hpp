// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hertz's theory of the contact of two elastic bodies, and the geometry of a pair of ellipsoids
/// that it needs.
///
/// Near the contact the gap between the surfaces is ½(κ1 x² + κ2 y²), where κ1 <= κ2 are the
/// eigenvalues of the sum of both second fundamental forms. The contact area is an ellipse with the
/// semi-axes a along x and b = ka along y. Let K and E be the complete elliptic integrals of the
/// parameter m = 1 - k², M = agm(1, k) = π/(2K) and s = (K - E)/(mK). Hertz's equations for a depth
/// δ and the modulus E* of both materials are
///
///     a² = 2 s δ/κ1,   b² = 2 (1 - s) δ/κ2   and   F = (4/3) E* δ agm(a, b).
///
/// So F = (4/3) E* √(R δ³) with R = 2 s M²/κ1.
#ifndef PW85_DISTANCE_HERTZ_HPP_INCLUDED
#define PW85_DISTANCE_HERTZ_HPP_INCLUDED

#include <pw85/distance/principal_curvatures.hpp>

namespace pw85 {

/// The stiffness of a Hertzian contact and the size of its ellipse.
template <class T> struct HertzEllipse {
    T radius;             ///< R of Hertz's equations
    Vector<T, 2> ellipse; ///< a²/δ and b²/δ
    StatusCode status;
};

/// The contact of two ellipsoids along a normal.
template <class T> struct HertzContact {
    T depth;               ///< negative if the slab between the ellipsoids has a width
    Vector<T, 3> point;    ///< relative to the centre of ellipsoid 1
    Curvature<T> relative; ///< of the sum of both second fundamental forms
    HertzEllipse<T> hertz;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Functions of k, with σ = (s - ½)/m.
template <class T> struct EllipticMeans {
    T mean, share, sigma; ///< M, s, σ
};

/// Computes M, s and σ by the sequence of the arithmetic-geometric mean: a_0 = 1, b_0 = k, c_(n+1)
/// = (a_n - b_n)/2 = c_n²/(4 a_(n+1)). The sum of 2^(n-1) (c_n/m)² over n >= 1 is σ. c_1/m is 1/(2
/// (1 + k)); nothing cancels where k is near 1.
///
/// The first term that is left out of s is w c³d/(8 M²), with the last c and d and their weight w.
/// The loop takes four steps at most for k > 0.004, and six for k = 10⁻¹⁰.
template <class T> PW85_FUNCTION inline EllipticMeans<T> elliptic_means(T const &k) noexcept
{
    // a_1, b_1, c_1, c_1/m
    T a = T(0.5) * (T(1) + k), b = square_root(k), c = T(0.5) * (T(1) - k), d = T(0.25) / a;
    T sigma = d * d, weight = T(1);
    T const unit = T(unit_roundoff<T>());
    while (T(weight * (c * c)) * T(c * d) > unit * (a * a)) {
        T const next = T(0.5) * (a + b), ratio = T(T(0.25) * c) / next;
        b = square_root(T(a * b));
        a = next;
        c = ratio * c;
        d = ratio * d;
        weight = weight + weight;
        sigma = sigma + weight * (d * d);
    }
    return {T(0.5) * (a + b), T(0.5) + T((T(1) - k) * (T(1) + k)) * sigma, sigma};
}

/// An approximation of k: q^(-1/2) times a polynomial in q^(-1/8). The coefficients are a fit, with
/// an error of 0.2 % for q up to 10⁵ and of 8 % up to 10¹⁸. It is exact for q = 1.
template <class T> PW85_FUNCTION inline T approximate_axis_ratio(T const &q) noexcept
{
    T const root = T(1) / square_root(q), x = square_root(square_root(root)) - T(1);
    return root *
           (T(1) + x * (T(1.38604) + x * (T(0.71774) + x * (T(-0.48400) + x * T(-0.59363)))));
}

/// Computes hertz() for curvatures in order.
///
/// k is the root of log ρ with ρ = (1 - s)/(s k² q), q = κ2/κ1. log ρ decreases with log k. Its
/// slope is (s² - 2σ)/(s (1 - s)) - 2, which goes from -3/2 for a circle to -2 for a line. So
/// Newton's method on log k converges from any start, and once a step is below 2^-24, the next one
/// is below rounding.
///
/// The rounding errors of s are 5 u in the worst of 3·10⁶ draws, of which tests/test_hertz.cpp
/// makes fewer. 1 - s tends to 1/K for long ellipses, and is at least 1/24 for curvatures whose
/// ratio is at most 10^18. So the relative error of b² grows to 113 u there, while that of the
/// other results is below 14 u. The contract says 256 u.
template <class T>
PW85_FUNCTION inline HertzEllipse<T> hertz_ordered(T const &smaller, T const &larger) noexcept
{
    T const q = larger / smaller, last = negative_power_of_two<T>(mantissa_digits<T>() / 2 - 2);
    T k = approximate_axis_ratio(q), mean = T(1), share = T(0.5), step = T(1);
    for (int i = 0; i < 40 && absolute(step) > last; ++i) {
        auto const at = elliptic_means(k);
        // ρ = rest/wanted
        T const rest = T(1) - at.share, wanted = at.share * T(k * k * q), product = at.share * rest;
        // ds/dlog k
        T const slope = T(2) * at.sigma - at.share * at.share;
        // 2 (ρ - 1)/(ρ + 1) stands for log ρ: it has the same sign and is smaller. 1 + y + y²/2
        // stands for the exponential of a step y. Both differ from the functions in third order.
        step = T(T(2) * (rest - wanted)) * product / T((rest + wanted) * (T(2) * product + slope));
        k = minimum(T(1), T(k * (T(1) + step * (T(1) + T(0.5) * step))));
        mean = at.mean + at.mean * (rest * step);
        share = at.share + slope * step;
    }
    // Hertz's equations follow from δ = (p ab/E*) R_F(0, a², b²), κ1/2 = (p ab/E*) R_D(0, b²,
    // a²)/3, κ2/2 = (p ab/E*) R_D(0, a², b²)/3 and F = (2π/3) p ab with the largest pressure p (K.
    // L. Johnson, Contact Mechanics, 1985, section 4.2), and from R_F(0, 1, k²) = K, R_D(0, k², 1)
    // = 3 s K and R_D(0, 1, k²) = 3 (1 - s) K/k².
    T const squared_length = T(2) * share / smaller; // a²/δ
    return {squared_length * (mean * mean),
            {squared_length, T(2) * (T(1) - share) / larger},
            StatusCode::success};
}

/// The largest ratio of curvatures for fitted_radius().
inline constexpr int fitted_ratio_exponent = 14;

/// Hertz's radius R without a search, with a relative error of 1e-15 at most for curvatures whose
/// ratio q is up to 2^fitted_ratio_exponent.
///
/// R is the largest value of 2 agm(1, k)²/(κ1 + κ2 k²) over k. The polynomial in x = q^(-1/8) - 1
/// is k √q with an error of 4.4e-8, by a minimax fit. Because R is stationary in k, its relative
/// error is of the order of the square of this error: at most 7.2e-16. For k = 0.003, the smallest
/// k, the two means differ by 2.4e-9 after five steps, and half of their sum is the
/// arithmetic-geometric mean to 1e-18.
template <class T> PW85_FUNCTION inline T fitted_radius(T const &smaller, T const &larger) noexcept
{
    constexpr double coefficients[] = {
        -18.74904377413505,  -87.06880334735197, -172.19228907682344, -185.40234673169687,
        -112.28982142769661, -32.6840723729428,  -0.9023072913707475, -0.2800748513544689,
        -1.6652324362178421, 0.2211017953454545, 1.3333210122327765,  1.0};
    T const root = square_root(T(smaller / larger)), x = square_root(square_root(root)) - T(1);
    T p = T(coefficients[0]);
    for (int i = 1; i < 12; ++i) p = p * x + T(coefficients[i]);
    T a = T(1), b = p * root;
    for (int step = 0; step < 5; ++step) {
        T const mean = T(0.5) * (a + b);
        b = square_root(T(a * b));
        a = mean;
    }
    T const mean = T(0.5) * (a + b);
    return T(T(mean + mean) * mean) / T(smaller * T(T(1) + p * p));
}

/// Hertz's radius for curvatures in order. Types with more digits than double need the search.
template <class T> PW85_FUNCTION inline T hertz_radius(T const &smaller, T const &larger) noexcept
{
    if (mantissa_digits<T>() <= 53 &&
        negative_power_of_two<T>(fitted_ratio_exponent) * larger <= smaller)
        return fitted_radius(smaller, larger);
    return hertz_ordered(smaller, larger).radius;
}

/// The unit of the smaller ellipsoid, in which curvatures are of order one at most.
PW85_FUNCTION constexpr Unit smaller_unit(Units const &units) noexcept
{
    return smaller_of(units.first, units.second);
}

/// The status of a pair and its normal. If it is success, the normal is brought into range.
template <class T> PW85_FUNCTION inline StatusCode validate_facing(Vector<T, 3> const &r12,
                                                                   SymmetricMatrix<T, 3> const &q1,
                                                                   SymmetricMatrix<T, 3> const &q2,
                                                                   Vector<T, 3> &normal) noexcept
{
    if (!is_finite(r12) || scale_normal(normal) != StatusCode::success)
        return StatusCode::invalid_argument;
    if (!(is_finite(q1) && is_finite(q2))) return StatusCode::invalid_argument;
    bool const definite =
        validate(q1) == StatusCode::success && validate(q2) == StatusCode::success;
    return definite ? StatusCode::success : StatusCode::not_positive_definite;
}

/// Scales a valid pair. r12 is in the unit of the larger ellipsoid.
template <class T> PW85_FUNCTION inline Scaled<DistancePair<T, 3>>
scale_facing(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
             SymmetricMatrix<T, 3> const &q2) noexcept
{
    Unit const unit1 = unit_in_range(q1), unit2 = unit_in_range(q2);
    return in_units(r12, q1, q2, {larger_of(unit1, unit2), unit1, unit2, false, {}});
}

/// Returns a result in the units of the caller.
template <class T>
PW85_FUNCTION inline HertzContact<T> to_caller(HertzContact<T> result, Units const &units) noexcept
{
    Unit const larger = units.length, smaller = smaller_unit(units);
    result.depth = larger.to_caller(result.depth);
    result.point = larger.to_caller(result.point);
    result.relative.curvatures = smaller.to_caller(result.relative.curvatures, -1);
    result.hertz.radius = smaller.to_caller(result.hertz.radius);
    result.hertz.ellipse = smaller.to_caller(result.hertz.ellipse);
    return result;
}

/// Computes hertz_contact() with numbers of type W. Lengths are in the unit of the larger
/// ellipsoid, curvatures in that of the smaller one.
template <class W, class T> PW85_FUNCTION inline HertzContact<T>
hertz_facing(DistancePair<T, 3> const &pair, Vector<T, 3> const &normal, bool &accurate) noexcept
{
    W const scale1 = W(pair.scale1), scale2 = W(pair.scale2);
    auto const frame = tangent_frame(converted<W>(normal));
    auto const surface1 = curved_surface(converted<W>(pair.q1), frame),
               surface2 = curved_surface(converted<W>(pair.q2), frame);
    accurate = surface1.accurate && surface2.accurate;
    Vector<W, 3> const r12 = converted<W>(pair.r12);
    Vector<W, 3> const ends = scale1 * surface1.support.point - scale2 * surface2.support.point;
    W const depth = scale1 * surface1.support.extent + scale2 * surface2.support.extent -
                    dot(frame.normal, r12);
    // scale2 is the unit of the smaller ellipsoid over that of ellipsoid 1, if ellipsoid 1 is the
    // larger one, and scale1 is 1.
    auto const relative =
        principal_curvatures(blend(scale2, surface1.shape, scale1, surface2.shape), frame);
    HertzContact<T> result{rounded(depth),
                           rounded(W(0.5) * (r12 + ends)),
                           rounded_curvature<T>(relative),
                           {},
                           StatusCode::success};
    result.hertz = hertz_ordered(result.relative.curvatures[0], result.relative.curvatures[1]);
    return result;
}

/// Computes hertz_facing() with twice the digits.
template <class T> PW85_RARE HertzContact<T> hertz_facing_finer(DistancePair<T, 3> const &pair,
                                                                Vector<T, 3> const &normal) noexcept
{
    bool accurate;
    return hertz_facing<Finer<T>>(pair, normal, accurate);
}

PW85_RARE_TIER_OF(hertz_facing_finer, double)

} // namespace pw85::detail

namespace pw85 {

template <class T>
PW85_FUNCTION inline HertzEllipse<T> hertz(Vector<T, 2> const &curvatures) noexcept
{
    using namespace detail;
    T const &x = curvatures[0], &y = curvatures[1];
    if (!(is_finite(curvatures) && x > T(0) && y > T(0)))
        return all_nan<HertzEllipse<T>>(StatusCode::invalid_argument);
    if (x <= y) return hertz_ordered(x, y);
    auto const result = hertz_ordered(y, x);
    return {result.radius, {result.ellipse[1], result.ellipse[0]}, StatusCode::success};
}

template <class T> PW85_FUNCTION inline HertzContact<T>
hertz_contact(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
              SymmetricMatrix<T, 3> const &q2, Vector<T, 3> normal) noexcept
{
    using namespace detail;
    StatusCode const status = validate_facing(r12, q1, q2, normal);
    if (status != StatusCode::success)
        return {quiet_nan<T>(), all_nan<Curvature<T>>(status).direction1,
                all_nan<Curvature<T>>(status), all_nan<HertzEllipse<T>>(status), status};
    auto const [pair, units] = scale_facing(r12, q1, q2);
    bool accurate;
    auto result = hertz_facing<T>(pair, normal, accurate);
    if constexpr (!std::is_same_v<Finer<T>, T>)
        if (!accurate) result = hertz_facing_finer(pair, normal);
    return to_caller(result, units);
}

} // namespace pw85

#endif
