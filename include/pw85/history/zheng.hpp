// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance of closest approach of two ellipses, as the root of a quartic, and of two
/// ellipsoids, as a maximum over planes. It is kept for comparison; pw85_zheng.cpp calls it.
///
/// The algorithms are those of X. Zheng and P. Palffy-Muhoray, Phys. Rev. E 75, 061709, 2007, and
/// of X. Zheng, W. Iglesias and P. Palffy-Muhoray, Phys. Rev. E 79, 057702, 2009. These papers work
/// with axes and angles. Here everything is computed from the forms themselves: equal orientations,
/// circles and principal directions need no special treatment.
///
/// Two ellipses touch where a quartic has its positive root (Tangency, quartic_root()). A plane
/// through the line of centres cuts two ellipsoids in two ellipses (Section). The distance of the
/// ellipsoids is the largest one of these ellipses over all planes (Pencil, largest_distance()).
#ifndef PW85_HISTORY_ZHENG_HPP_INCLUDED
#define PW85_HISTORY_ZHENG_HPP_INCLUDED

#include <pw85/contact/closest_approach.hpp>
#include <pw85/contact/evaluation.hpp>

namespace pw85::detail::zheng {

/// An ellipse: the section of an ellipsoid by a plane through the line of centres, which has the
/// unit direction d. The plane contains d and a vector s.
///
/// Consider covectors n of the plane with n·d = 1 and n·s = ν. The square of the support function
/// of the ellipse is h² = τ + (ν - k)²/ρ. Here τ = 1/(dᵀQ⁻¹d), k = c·s with c = τ Q⁻¹d, and ρ =
/// (pᵀQp) τ/det Q with the plane's normal p = d×s (minors of a product of matrices).
template <class T> struct Section {
    T tau; ///< squared half-chord on the line of centres
    T rho;
};

/// The common tangent line: its distances from the two centres, whose sum is the distance of
/// closest approach, and the parts into which its ν divides the offset K = k2 - k1.
///
/// A common tangent line with the normal n is at the distances h1 and h2 from the centres. The
/// distance of closest approach is the least h1 + h2 over ν. With t = h1/h2 it is where (ν -
/// k1)/(k2 - ν) = t ρ1/ρ2. Then h1² = t² h2² reads F = 0 with
///     F = (τ2 t² - τ1) (ρ1 t + ρ2)² - K² (ρ1 - ρ2) t².
/// This quartic has one change of sign among its coefficients. So it has one positive root
/// (Descartes).
template <class T> struct Tangency {
    T h1, h2;
    T nu1, nu2;
};

/// The positive root of u³ - 3 r u² - s for s >= 0. Every sum is of positive terms, or keeps a
/// quarter of its larger term.
template <class T> PW85_FUNCTION inline T resolvent_root(T const &r, T const &s) noexcept
{
    using elementary::atan2;
    using elementary::cbrt;
    using elementary::cos;
    using elementary::sin;
    T const r3 = r * r * r, discriminant = r3 + T(0.25) * s;
    if (discriminant < T(0)) {
        T const angle = atan2(square_root(s), square_root(T(T(-4) * discriminant))) / T(3);
        T const sine = sin(angle);
        return T(-2) * r * sine * (square_root(T(3)) * cos(angle) - sine);
    }
    T const root = cbrt(T(r3 + T(0.5) * s + square_root(T(s * discriminant))));
    return root > T(0) ? T(root + r + r * (r / root)) : T(0);
}

/// The positive root of the quartic F, as w = ρ1 √τ2 t, for ρ1 >= ρ2. Here m is M = K² (ρ1 - ρ2),
/// and κ = ρ √τ. The arguments are >= 0, and the largest is of order one. The error of the result
/// is at most 16 u in the terms of the equation, without a final step of Newton's method.
///
/// In these terms F = 0 is M/(w + κ2)² + κ1²/w² = 1, so that w >= κ1. As a difference of squares
/// its factors are w² + κ2 w - u = ±[v - κ2 (u - κ1²) w/v], v² = u² + κ1² κ2², where u³ - 3 r u² -
/// M κ1² κ2²/2 = 0, 6 r = M + κ1² - κ2². This cubic has one positive root. With this root, one
/// factor has one positive root and the other has none, so that no branch has to be chosen.
template <class T>
PW85_FUNCTION inline T quartic_root(T const &m, T const &kappa1, T const &kappa2) noexcept
{
    T const k = kappa1 * kappa2, r = (m + (kappa1 - kappa2) * (kappa1 + kappa2)) / T(6);
    T const u = resolvent_root(r, T(T(0.5) * m * k * k));
    T const v = square_root(T(u * u + k * k));
    T const half = T(0.5) * kappa2 * (v + u - kappa1 * kappa1) / v;
    T const root = square_root(T(half * half + u + v));
    T const w = half > T(0) ? T((u + v) / (half + root)) : T(root - half);
    return maximum(w, kappa1);
}

/// Closest approach of two sections with rho1 >= rho2, whose k differ by `offset`.
template <class T> PW85_FUNCTION inline Tangency<T>
ordered_tangency(Section<T> const &s1, Section<T> const &s2, T const &offset) noexcept
{
    T const kappa1 = s1.rho * square_root(s1.tau), kappa2 = s2.rho * square_root(s2.tau);
    T const root_m = absolute(offset) * square_root(T(s1.rho - s2.rho));
    T const scale = T(1) / maximum(kappa1, maximum(kappa2, root_m)), a = scale * root_m,
            b = scale * kappa2;
    T const w = quartic_root(T(a * a), T(scale * kappa1), b);
    T const nu1 = w / (w + b) * offset, nu2 = b / (w + b) * offset;
    return {square_root(T(s1.tau + nu1 * nu1 / s1.rho)),
            square_root(T(s2.tau + nu2 * nu2 / s2.rho)), nu1, nu2};
}

/// Closest approach of two sections whose k differ by `offset`.
template <class T> PW85_FUNCTION inline Tangency<T>
tangency(Section<T> const &s1, Section<T> const &s2, T const &offset) noexcept
{
    if (s1.rho >= s2.rho) return ordered_tangency(s1, s2, offset);
    Tangency<T> const reversed = ordered_tangency(s2, s1, offset);
    return {reversed.h2, reversed.h1, reversed.nu2, reversed.nu1};
}

/// A pair in the units of ellipsoid 1, where lengths of ellipsoid 2 count `unit` <= 1.
template <class T, int D> struct Problem {
    Vector<T, D> d; ///< unit vector
    SymmetricMatrix<T, D> q1, q2;
    T unit;
};

/// The smallest unit; smaller ones are replaced by it. As the aspect ratio of a valid form is below
/// 1/√u, an ellipsoid of this size adds less than a rounding error to the distance, and so does a
/// smaller one.
template <class T> PW85_FUNCTION constexpr T smallest_unit() noexcept
{
    return negative_power_of_two<T>(3 * mantissa_digits<T>() / 2);
}

template <class T, int D>
PW85_FUNCTION inline Problem<T, D> problem(Pair<T, D> const &pair) noexcept
{
    T const norm = square_root(dot(pair.r12, pair.r12));
    return {T(T(1) / norm) * pair.r12, pair.q1, pair.q2,
            maximum(T(T(1) / pair.ratio), smallest_unit<T>())};
}

/// The section in two dimensions, where s is d rotated by a right angle.
template <class T> struct Ellipse {
    Section<T> section;
    T k;
};

template <class T> PW85_FUNCTION inline Ellipse<T>
ellipse_on_line(Vector<T, 2> const &d, SymmetricMatrix<T, 2> const &q, T const &unit) noexcept
{
    Vector<T, 2> const s{-d[1], d[0]};
    auto const factors = factorize(q, T(unit_roundoff<T>()));
    T const across = positive_form(q, outer_weights(s));
    return {{unit * unit * factors.pivots[0] * factors.pivots[1] / across,
             T(1) / (unit * unit * across)},
            -dot(d, product(q, s)) / across};
}

/// The distance of two ellipses: the sum of the support functions at the normal that was found. It
/// is stationary there, so the result depends only to second order on errors of the quartic and of
/// the sections. The error is that of the forms themselves, 2 u cond at most (cond as for the
/// contact function), whatever the aspect ratio.
template <class T> PW85_FUNCTION inline T distance(Problem<T, 2> const &pair) noexcept
{
    Vector<T, 2> const &d = pair.d;
    auto const e1 = ellipse_on_line(d, pair.q1, T(1)), e2 = ellipse_on_line(d, pair.q2, pair.unit);
    T const nu = e1.k + tangency(e1.section, e2.section, T(e2.k - e1.k)).nu1;
    auto const weights = outer_weights(Vector<T, 2>{d[0] - nu * d[1], d[1] + nu * d[0]});
    return square_root(positive_form(pair.q1, weights)) +
           pair.unit * square_root(positive_form(pair.q2, weights));
}

/// The quantities that all sections of an ellipsoid share.
template <class T> struct Axis {
    Vector<T, 3> c;
    T tau;
    T minor; ///< det Q/τ in units of the ellipsoid's own: the determinant of Q projected along d
};

template <class T> PW85_FUNCTION inline Axis<T>
axis(Vector<T, 3> const &d, SymmetricMatrix<T, 3> const &q, T const &unit) noexcept
{
    auto const factors = factorize(q, T(unit_roundoff<T>()));
    Vector<T, 3> const g = solve(factors, d);
    T const inverse = dot(d, g);
    return {T(T(1) / inverse) * g, unit * unit / inverse,
            factors.pivots[0] * factors.pivots[1] * factors.pivots[2] * inverse};
}

/// The sections of an ellipsoid as the plane turns. The plane with the normal p = f + x e has ρ =
/// least + growth (x - x0)², with least = 1/(eᵀQe), growth g = (eᵀQe) τ/det Q and x0 =
/// -(eᵀQf)/(eᵀQe). d, e and f are orthonormal.
template <class T> struct Fan {
    T tau;
    T least, growth;
    T x0;
};

template <class T> PW85_FUNCTION inline Fan<T> fan(Axis<T> const &a, SymmetricMatrix<T, 3> const &q,
                                                   T const &unit, Vector<T, 3> const &e,
                                                   Vector<T, 3> const &f) noexcept
{
    T const along = positive_form(q, outer_weights(e)), area = unit * unit;
    return {a.tau, T(1) / (area * along), along / (area * a.minor), -dot(f, product(q, e)) / along};
}

template <class T>
PW85_FUNCTION inline Section<T> section(Fan<T> const &fan, T const &from_x0) noexcept
{
    return {fan.tau, fan.least + fan.growth * from_x0 * from_x0};
}

/// The planes through the line of centres. Let c be the difference of the vectors c of the two
/// ellipsoids (Axis), which is orthogonal to d, and e = c/|c|, f = d×e. The planes are p = f + x e
/// with s = e - x f, so that K = |c| in all of them. The plane p = e (x infinite) has K = 0 and the
/// least distance, √τ1 + √τ2.
template <class T> struct Pencil {
    Fan<T> fan1, fan2;
    T offset;
};

/// The distance in a plane, and the equation of largest_distance() with its derivative, in y.
template <class T> struct Plane {
    T distance;
    T residual; ///< negative before the maximum, positive after it
    T slope;
};

/// d(log t)/dy from the quartic F (Tangency) by implicit differentiation, for dρ1/dy and dρ2/dy.
template <class T>
PW85_FUNCTION constexpr T ratio_slope(Section<T> const &s1, Section<T> const &s2, T const &offset,
                                      T const &t, T const &rho1_slope, T const &rho2_slope) noexcept
{
    T const k2 = offset * offset, sum = s1.rho * t + s2.rho,
            twice = T(2) * (s2.tau * t * t - s1.tau) * sum;
    T const change = t * (twice - k2 * t) * rho1_slope + (twice + k2 * t * t) * rho2_slope;
    return -change / (T(2) * sum * (s2.tau * s1.rho * t * t * t + s1.tau * s2.rho));
}

template <class T> PW85_FUNCTION inline Plane<T> plane(Pencil<T> const &pencil, T const &y) noexcept
{
    using elementary::exp;
    using elementary::log;
    T const ratio = exp(-absolute(y)), lesser = ratio / (T(1) + ratio),
            greater = T(1) / (T(1) + ratio);
    T const before = y > T(0) ? greater : lesser, after = y > T(0) ? lesser : greater;
    T const range = pencil.fan2.x0 - pencil.fan1.x0, x1 = range * before, x2 = range * after;
    auto const s1 = section(pencil.fan1, x1), s2 = section(pencil.fan2, x2);
    auto const touching = tangency(s1, s2, pencil.offset);
    T const t = touching.h1 / touching.h2;
    T const slope =
        ratio_slope(s1, s2, pencil.offset, t, T(T(2) * pencil.fan1.growth * x1 * x1 * after),
                    T(T(-2) * pencil.fan2.growth * x2 * x2 * before));
    return {touching.h1 + touching.h2, y + log(t * (pencil.fan1.growth / pencil.fan2.growth)),
            T(1) + slope};
}

/// The largest distance over the planes of a pencil.
///
/// The distance has one maximum in x. It increases before it and decreases after it. Proof: The
/// half-chord of an ellipsoid parallel to d at the offset ξ from the line of centres is a strictly
/// concave function of ξ. So is the distance Φ(ξ) at which two such chords touch end to end. The
/// distance in a plane is the maximum of Φ along a line through ξ = 0. If a convex set {Φ >= const}
/// does not contain 0, the directions in which it is seen from there are an interval.
///
/// The distance decreases in ρ1 and in ρ2. So its maximum is between the x0 of both ellipsoids, x1
/// and x2. By the envelope theorem it is where (x - x1)/(x2 - x) = g2/(t g1). Newton's method
/// solves this equation in y = log[(x - x1)/(x2 - x)], inside a bracket. The bracket follows from τ
/// <= h² <= τ + K²/least for both ellipses, and it is certain because there is only one maximum.
/// The search takes 2 to 3 planes at aspect 4 and 4 planes at aspect 100. The largest number seen
/// is 41.
template <class T> PW85_FUNCTION inline T largest_distance(Pencil<T> const &pencil) noexcept
{
    using elementary::log;
    Fan<T> const &f1 = pencil.fan1, &f2 = pencil.fan2;
    T const k2 = pencil.offset * pencil.offset, centre = log(f2.growth / f1.growth);
    T lower = centre - T(0.5) * log((f1.tau + k2 / f1.least) / f2.tau);
    T upper = centre + T(0.5) * log((f2.tau + k2 / f2.least) / f1.tau);
    T y = centre + T(0.5) * log(f2.tau / f1.tau), last = upper - lower;
    for (;;) {
        Plane<T> const here = plane(pencil, y);
        (here.residual < T(0) ? lower : upper) = y;
        T const step = -here.residual / here.slope;
        // By the envelope theorem, the distance changes by less than a fraction |residual| of
        // itself per unit of y.
        if (absolute(T(step * here.residual)) <= unit_roundoff<T>()) return here.distance;
        T const next = y + step, middle = T(0.5) * (lower + upper);
        bool const converging = next > lower && next < upper && absolute(step) <= T(0.5) * last;
        last = converging ? absolute(step) : T(0.5) * (upper - lower);
        y = converging ? next : middle;
        if (!(y > lower && y < upper)) return here.distance;
    }
}

/// The distance of two ellipsoids. The sections depend on Q⁻¹d and det Q, whose relative error is u
/// κ, with κ = tr Q tr Q⁻¹, which is about the square of the aspect ratio. So the error of the
/// distance is at most u (κ1 + κ2); a quarter of this has been seen. It can be so large even for a
/// pair that is well-conditioned for the contact function. The chapter on closest approach has the
/// largest errors of random pairs.
template <class T> PW85_FUNCTION inline T distance(Problem<T, 3> const &pair) noexcept
{
    Vector<T, 3> const &d = pair.d;
    auto const a1 = axis(d, pair.q1, T(1)), a2 = axis(d, pair.q2, pair.unit);
    Vector<T, 3> const between = a2.c - a1.c, c = add_scaled(between, T(-dot(between, d)), d);
    T const offset = square_root(dot(c, c));
    if (!(offset > T(0))) return square_root(a1.tau) + square_root(a2.tau);
    Vector<T, 3> const e = T(T(1) / offset) * c, f = cross(d, e);
    return largest_distance(
        Pencil<T>{fan(a1, pair.q1, T(1), e, f), fan(a2, pair.q2, pair.unit, e, f), offset});
}

/// Distance of closest approach along `direction`, of any length > 0.
template <class T, int D>
PW85_FUNCTION inline ClosestApproach<T> checked_distance(Vector<T, D> direction,
                                                         SymmetricMatrix<T, D> const &q1,
                                                         SymmetricMatrix<T, D> const &q2) noexcept
{
    if (!is_finite(direction) || !(largest_coordinate(direction) > T(0)))
        return all_nan<ClosestApproach<T>>(StatusCode::invalid_argument);
    ScaledPair<T, D> scaled;
    StatusCode const status = validate_pair(pair_of(direction, q1, q2), scaled);
    if (status != StatusCode::success) return all_nan<ClosestApproach<T>>(status);
    return {scaled.units.first.to_caller(distance(problem(scaled.pair))), StatusCode::success};
}

} // namespace pw85::detail::zheng

namespace pw85::zheng {

/// Distance of closest approach of two ellipses, in closed form.
template <class T>
PW85_FUNCTION inline ClosestApproach<T> ellipses(Vector<T, 2> const &direction,
                                                 SymmetricMatrix<T, 2> const &q1,
                                                 SymmetricMatrix<T, 2> const &q2) noexcept
{
    return detail::zheng::checked_distance(direction, q1, q2);
}

/// Distance of closest approach of two ellipsoids, as the largest of those of their plane sections.
template <class T>
PW85_FUNCTION inline ClosestApproach<T> ellipsoids(Vector<T, 3> const &direction,
                                                   SymmetricMatrix<T, 3> const &q1,
                                                   SymmetricMatrix<T, 3> const &q2) noexcept
{
    return detail::zheng::checked_distance(direction, q1, q2);
}

} // namespace pw85::zheng

#endif
