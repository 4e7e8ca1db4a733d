/// @file
/// Distance of closest approach of two ellipses as the root of a quartic, and of two ellipsoids as a maximum over
/// planes (X. Zheng and P. Palffy-Muhoray, Phys. Rev. E 75, 061709, 2007; X. Zheng, W. Iglesias and P. Palffy-Muhoray,
/// Phys. Rev. E 79, 057702, 2009).
#ifndef PW85_ZHENG_HPP_INCLUDED
#define PW85_ZHENG_HPP_INCLUDED

#include <pw85/closest_approach.hpp>
#include <pw85/evaluation.hpp>

namespace pw85::inline PW85_TARGET::zheng {

template <class T> struct Section {
    T tau;
    T rho;
};

template <class T> struct Tangency {
    T h1, h2;
    T fraction;
};

template <class T> inline T resolvent_root(T const &r, T const &s) noexcept
{
    using std::atan2;
    using std::cbrt;
    using std::cos;
    using std::sin;
    T const r3 = r * r * r, discriminant = r3 + T(0.25) * s;
    if (discriminant < T(0)) {
        T const a = atan2(square_root(s), square_root(T(T(-4) * discriminant))) / T(3);
        T const c = cos(a), sn = sin(a);
        return T(-2) * r * sn * (square_root(T(3)) * c - sn);
    }
    T const c = cbrt(T(r3 + T(0.5) * s + square_root(T(s * discriminant))));
    return c > T(0) ? T(r + c + r * (r / c)) : T(0);
}

template <class T> inline T quartic_root(T const &m, T const &k1, T const &k2) noexcept
{
    T const k = k1 * k2, r = (m + (k1 - k2) * (k1 + k2)) / T(6);
    T const u = resolvent_root(r, T(T(0.5) * m * k * k));
    T const v = square_root(T(u * u + k * k));
    T const half = T(0.5) * k2 * (v + u - k1 * k1) / v;
    T const root = square_root(T(half * half + u + v));
    return half > T(0) ? T((u + v) / (half + root)) : T(root - half);
}

template <class T> inline Tangency<T> tangency(Section<T> const &s1, Section<T> const &s2, T const &k) noexcept
{
    if (s1.rho < s2.rho) {
        Tangency<T> const t = tangency(s2, s1, k);
        return {t.h2, t.h1, T(1) - t.fraction};
    }
    T const k1 = s1.rho * square_root(s1.tau), k2 = s2.rho * square_root(s2.tau);
    T const rm = k * square_root(T(s1.rho - s2.rho));
    T const unit = maximum(k1, maximum(k2, rm));
    T const w = maximum(quartic_root(T((rm / unit) * (rm / unit)), T(k1 / unit), T(k2 / unit)), T(k1 / unit));
    T const z = w / (w + k2 / unit), z2 = (k2 / unit) / (w + k2 / unit);
    return {square_root(T(s1.tau + z * z * k * k / s1.rho)), square_root(T(s2.tau + z2 * z2 * k * k / s2.rho)), z};
}

template <class T> struct Planes {
    T tau1, tau2;
    T min1, min2;
    T c1, c2;
    T k;
    T dx;
};

inline int evals = 0;

template <class T> struct Line {
    Vector<T, 3> n;
    T tau;
    T minor;
};

template <class T> inline Line<T> line(Vector<T, 3> const &d, SymmetricMatrix<T, 3> const &q, T const &unit) noexcept
{
    auto const f = factorize(q, T(unit_roundoff<T>()));
    auto const g = solve(f, d);
    T const tau = T(1) / dot(d, g);
    return {times(tau, g), tau * unit, f.pivots[0] * f.pivots[1] * f.pivots[2] / tau * unit * unit};
}

template <class T> inline Section<T> sec1(Planes<T> const &p, T const &o) noexcept
{
    return {p.tau1, p.min1 + p.c1 * (p.dx * o) * (p.dx * o)};
}
template <class T> inline Section<T> sec2(Planes<T> const &p, T const &o) noexcept
{
    return {p.tau2, p.min2 + p.c2 * (p.dx * o) * (p.dx * o)};
}

template <class T> inline T maximize(Planes<T> const &p) noexcept
{
    using std::exp;
    using std::log;
    T const q = log(p.c2 / p.c1), k2 = p.k * p.k;
    T lo = q - T(0.5) * log((p.tau1 + k2 / p.min1) / p.tau2), hi = q + T(0.5) * log((p.tau2 + k2 / p.min2) / p.tau1);
    T x = minimum(maximum(T(q + T(0.5) * log(p.tau2 / p.tau1)), lo), hi);
    for (int i = 0;; ++i) {
        ++evals;
        T const e = exp(-absolute(x)), small = e / (T(1) + e), large = T(1) / (T(1) + e);
        T const o1 = x > T(0) ? large : small, o2 = x > T(0) ? small : large;
        auto const s1 = sec1(p, o1), s2 = sec2(p, o2);
        auto const tg = tangency(s1, s2, p.k);
        T const t = tg.h1 / tg.h2;
        T const value = x - q + log(t);
        (value < T(0) ? lo : hi) = x;
        T const S = s1.rho * t + s2.rho, A = p.tau2 * t * t - p.tau1;
        T const den = T(2) * S * (p.tau2 * s1.rho * t * t * t + p.tau1 * s2.rho);
        T const f1 = T(2) * t * A * S - k2 * t * t, f2 = T(2) * A * S + k2 * t * t;
        T const r1 = T(2) * p.c1 * p.dx * p.dx * o1 * o1 * o2, r2 = T(-2) * p.c2 * p.dx * p.dx * o2 * o2 * o1;
        T const slope = T(1) - (f1 * r1 + f2 * r2) / den;
        T const step = -value / slope;
        if (absolute(step) < negative_power_of_two<T>(mantissa_digits<T>() / 2 + 2) || i > 60) {
            return tg.h1 + tg.h2;
        }
        T const next = x + step;
        x = slope > T(0) && next > lo && next < hi && i < 12 ? next : T(T(0.5) * (lo + hi));
    }
}

template <class T>
inline T ellipsoids_core(Vector<T, 3> d, SymmetricMatrix<T, 3> const &q1, SymmetricMatrix<T, 3> const &q2) noexcept
{
    d = times(T(T(1) / square_root(dot(d, d))), d);
    auto const l1 = line(d, q1, T(1)), l2 = line(d, q2, T(1));
    Vector<T, 3> c{l2.n[0] - l1.n[0], l2.n[1] - l1.n[1], l2.n[2] - l1.n[2]};
    T const cd = dot(c, d);
    for (int i = 0; i < 3; ++i) c[i] = c[i] - cd * d[i];
    T const k = square_root(dot(c, c));
    if (!(k > T(0))) return square_root(l1.tau) + square_root(l2.tau);
    auto const e = times(T(T(1) / k), c);
    auto const f = cross(d, e);
    T const e1 = quadratic_form(q1, e), e2 = quadratic_form(q2, e);
    T const b1 = dot(f, product(q1, e)), b2 = dot(f, product(q2, e));
    Planes<T> p{l1.tau, l2.tau, T(1) / e1, T(1) / e2, e1 / l1.minor, e2 / l2.minor, k, b1 / e1 - b2 / e2};
    return maximize(p);
}

} // namespace pw85::inline PW85_TARGET::zheng

#endif
