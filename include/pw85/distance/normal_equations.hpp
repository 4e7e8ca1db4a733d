// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two equations for the common normal of the closest points of two ellipsoids, and Newton's step
/// towards their solution. normal_search.hpp solves them.
///
/// With α(n) = √(nᵀQ1n), β(n) = √(nᵀQ2n) and r = r12, the normal n and the distance φ of ellipsoids
/// that are apart fulfil r = (Q1/α + Q2/β + φ I) n (normal_search.hpp has the proof). Let u = n/α,
/// t = α/β and s = αφ. Then M u = r with M = Q1 + t Q2 + s I, A = uᵀQ1u = 1 and t²B = t²uᵀQ2u = 1.
/// The last two are equations for t and s.
#ifndef PW85_DISTANCE_NORMAL_EQUATIONS_HPP_INCLUDED
#define PW85_DISTANCE_NORMAL_EQUATIONS_HPP_INCLUDED

#include <pw85/contact/rational.hpp>

namespace pw85::detail {

/// The unknowns t and s. In the units of a DistancePair M = P1 + t P2 + s I with P = scale Q. The
/// statements on A + tB and 1 + 1/t then hold for scale1 A + scale2 tB and scale1 + scale2/t.
template <class T> struct Multipliers {
    T ratio, shift;
};

/// The numbers at some t and s from which the equations are formed. S = A + tB.
template <class T> struct NormalJet {
    T r, form_u;                 ///< rᵀu, uᵀM⁻¹u
    T a, b;                      ///< A and B
    T log_ratio, log_shift;      ///< ½ AB ∂(log B/A)/∂t, ½ AB ∂(log B/A)/∂s
    T sum, sum_ratio, sum_shift; ///< S, -½ ∂S/∂t, -½ ∂S/∂s
};

/// R = rᵀM⁻¹r as a quotient a/b of polynomials in t and s, which have positive coefficients. The
/// coefficients are those of 1, t, t² ..., and of these times s and s².
template <class T> struct ShiftedForm {
    T a[3], a_s[2], a_ss;
    T b[4], b_s[3], b_ss[2], b_sss;
};

template <class T>
PW85_FUNCTION constexpr ShiftedForm<T> shifted_form(Vector<T, 2> const &r12,
                                                    SymmetricMatrix<T, 2> const &p1,
                                                    SymmetricMatrix<T, 2> const &p2) noexcept
{
    auto const rational = rational_form(Pair<T, 2>{r12, p1, p2, T(1)});
    return {{rational.a[0], rational.a[1], T(0)},
            {dot(r12, r12), T(0)},
            T(0),
            {rational.b[0], rational.b[1], rational.b[2], T(0)},
            {trace(p1), trace(p2), T(0)},
            {T(1), T(0)},
            T(0)};
}

template <class T>
PW85_FUNCTION constexpr ShiftedForm<T> shifted_form(Vector<T, 3> const &r12,
                                                    SymmetricMatrix<T, 3> const &p1,
                                                    SymmetricMatrix<T, 3> const &p2) noexcept
{
    auto const weights = outer_weights(r12);
    auto const adj1 = adjugate(p1), adj2 = adjugate(p2), mixed = mixed_adjugate(p1, p2);
    T const r2 = dot(r12, r12), trace1 = trace(p1), trace2 = trace(p2);
    return {{quadratic_form(adj1, weights), quadratic_form(mixed, weights),
             quadratic_form(adj2, weights)},
            {trace1 * r2 - quadratic_form(p1, weights), trace2 * r2 - quadratic_form(p2, weights)},
            r2,
            {determinant(p1, adj1), contraction(adj1, p2), contraction(adj2, p1),
             determinant(p2, adj2)},
            {trace(adj1), trace(mixed), trace(adj2)},
            {trace1, trace2},
            T(1)};
}

/// Evaluates the equations by the polynomials. With C = uᵀu, B = -∂R/∂t, C = -∂R/∂s and A = R -
/// tB - sC. So no step except the last needs to solve linear equations. The coefficients lose
/// digits as the aspect ratio grows, so the result only guides the search. Here the forms are P, n
/// is b²B, and S is R - sC.
template <class T, int D>
PW85_FUNCTION constexpr NormalJet<T> evaluate_normal(DistancePair<T, D> const &pair,
                                                     ShiftedForm<T> const &f,
                                                     Multipliers<T> const &x) noexcept
{
    T const t = x.ratio, s = x.shift, t2 = t + t, s2 = s + s;
    T const a1 = f.a_s[0] + t * f.a_s[1], b1 = f.b_s[0] + t * (f.b_s[1] + t * f.b_s[2]);
    T const b2 = f.b_ss[0] + t * f.b_ss[1], b3 = s * f.b_sss, third = T(3) * (t * f.b[3]);
    T const a = (f.a[0] + t * (f.a[1] + t * f.a[2])) + s * (a1 + s * f.a_ss);
    T const a_t = f.a[1] + t2 * f.a[2] + s * f.a_s[1], a_s = a1 + s2 * f.a_ss;
    T const b = (f.b[0] + t * f.b[1]) + (t * t) * (f.b[2] + t * f.b[3]) + s * (b1 + s * (b2 + b3));
    T const half = f.b_s[1] + t2 * f.b_s[2], b_s = b1 + s * (T(2) * b2 + T(3) * b3);
    T const b_t = (f.b[1] + t * (T(2) * f.b[2] + third)) + s * (half + s * f.b_ss[1]);
    T const half_tt = f.b[2] + third + s * f.b_s[2], b_ts = half + s2 * f.b_ss[1],
            half_ss = b2 + T(3) * b3;
    T const n = a * b_t - a_t * b, c = a * b_s - a_s * b, half_n_t = a * half_tt - f.a[2] * b;
    T const half_n_s = T(0.5) * ((a * b_ts - f.a_s[1] * b) + (a_s * b_t - a_t * b_s));
    T const half_c_s = a * half_ss - f.a_ss * b;
    T const q = rough_quotient(T(1), b), q2 = q * q, log_t = b_t * q, log_s = b_s * q;
    T const form_b = n * q2, form_c = c * q2, sum = (a * b - s * c) * q2;
    T const b_ratio = log_t * form_b - half_n_t * q2, b_shift = log_s * form_b - half_n_s * q2;
    T const form_u = log_s * form_c - half_c_s * q2, sum_shift = form_c - s * form_u;
    T const unit1 = T(1) / pair.scale1, unit2 = T(1) / pair.scale2, unit = unit1 * unit2;
    return {a * q,
            form_u,
            unit1 * (sum - t * form_b),
            unit2 * form_b,
            unit * (form_b * (form_b - s * b_shift) - sum * b_ratio),
            unit * (form_b * sum_shift - sum * b_shift),
            sum,
            T(0.5) * form_b - s * b_shift,
            sum_shift};
}

/// A step in log t, as a fraction, and a step in s.
template <class T> struct NormalStep {
    T numerator, denominator;
    T shift;
};

/// Newton's step. The method converges from afar if the equations are written as t²B = A, solved
/// for log t, and 1/√(A + tB) = 1/√(1 + 1/t), which is nearly affine in s. With v = t(A + tB) and w
/// = 1 + t, the fraction (w + 3v)/(3w + v) takes the place of √(v/w). Both are one, and their
/// derivatives agree, where v = w. `Pair` is a DistancePair, or one in n dimensions.
template <class Pair, class T> PW85_FUNCTION constexpr NormalStep<T>
newton_step(Pair const &pair, NormalJet<T> const &j, Multipliers<T> const &x) noexcept
{
    T const t = x.ratio, c = t * t * j.b, weight = j.a * j.b, both = j.a + c;
    T const h = weight * (c - j.a), h_ratio = both * (weight + t * j.log_ratio),
            h_shift = both * j.log_shift;
    T const v = t * j.sum, w = pair.scale1 * t + pair.scale2, below = t * w * (T(3) * w + v);
    T const k = T(4) * v * w * (v - w), k_shift = T(-2) * below * j.sum_shift;
    T const k_ratio = pair.scale2 * v * (w + T(3) * v) - T(2) * t * below * j.sum_ratio;
    T const determinant = h_shift * k_ratio - h_ratio * k_shift;
    NormalStep<T> step{h * k_shift - h_shift * k, determinant,
                       rough_quotient(T(h_ratio * k - h * k_ratio), determinant)};
    auto const alone = x.shift + step.shift < T(0);
    // If a step would make s negative, each equation is solved alone, the second one first. With s
    // = 0 the first equation leads to the maximum of the contact function, where the second one has
    // a root.
    if (any_of(alone)) {
        T const shift = maximum(T(-x.shift), T(-rough_quotient(k, k_shift)));
        step.shift = select(alone, shift, step.shift);
        step.numerator = select(alone, T(-(h + h_shift * shift)), step.numerator);
        step.denominator = select(alone, h_ratio, step.denominator);
    }
    return step;
}

/// Returns whether a step is at most 2^-digits, relative to t, and relative to u in the norm of M.
/// In this norm a change of t causes a smaller relative change of u than of t.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_within(NormalStep<T> const &step, NormalJet<T> const &j, int digits) noexcept
{
    T const bound = negative_power_of_two<T>(digits);
    return absolute(step.numerator) <= bound * absolute(step.denominator) &&
           step.shift * step.shift * j.form_u <= bound * bound * j.r;
}

/// The largest step in log t: t changes by at most a factor of 7. This is a choice
/// (docs/implementation.rst).
template <class T> PW85_FUNCTION constexpr T longest_step() noexcept { return T(1.5); }

/// t and s after a step, with e^x to third order.
template <class T> PW85_FUNCTION constexpr Multipliers<T>
advance(Multipliers<T> const &x, NormalStep<T> const &step) noexcept
{
    T const n = step.numerator, d = step.denominator, twice = d + d, bound = longest_step<T>();
    T const largest = (T(2) + bound) / (T(2) - bound), smallest = T(1) / largest;
    auto const distant = absolute(n) > bound * absolute(d), up = n * d > T(0);
    T const factor =
        select(distant, select(up, largest, smallest), rough_quotient(T(twice + n), T(twice - n)));
    return {x.ratio * factor, maximum(T(0), T(x.shift + step.shift))};
}

} // namespace pw85::detail

#endif
