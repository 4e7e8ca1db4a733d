// SPDX-License-Identifier: BSD-3-Clause
// The volume of the common part of two ellipsoids and its derivatives, by an integral over plane
// sections. It shares nothing with the library.
//
// One ellipsoid becomes the unit ball, and the principal axes of the other one become the axes. In
// a section a circle and an ellipse cross where a polynomial of degree 4 of exp(iθ) has roots on
// the unit circle. All four roots divide both curves into arcs, so that a root which is no crossing
// does no harm. Each arc is inside the other curve or not, as its middle is, and it contributes in
// closed form. So nothing is decided by a tie. The heights are integrated by Gauss's rule of ten
// nodes, which is bisected until it has converged. With a point x of a surface and w = Q⁻¹(x - c),
// the derivatives are the integrals of n and ½ n wᵀ.
#ifndef PW85_TESTS_SECTIONS_TRUTH_HPP_INCLUDED
#define PW85_TESTS_SECTIONS_TRUTH_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace pw85_tests::sections {
using Real = long double;
using Complex = std::complex<Real>;
constexpr Real pi = 3.14159265358979323846264338327950288L;

/// An array that takes indices of any type.
template <int N> struct Numbers {
    Real values[std::size_t(N)];

    Real &operator[](int i) { return values[i]; }
    Real operator[](int i) const { return values[i]; }
};

/// V, dV/dc of body 2, dV/dQ of body 1 and 2 (as matrices, xx xy xz yy yz zz).
constexpr int numbers = 16;
using Sums = Numbers<numbers>;

struct Body {
    Real axes[3], center[3];
};

// Products and quotients without the treatment of infinite numbers that the standard library has.

inline Complex product(Complex const &a, Complex const &b)
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline Complex quotient(Complex const &a, Complex const &b)
{
    return product(a, std::conj(b)) / std::norm(b);
}

/// One step of Aberth's method for all roots z of a polynomial. Returns the square of the largest
/// relative change.
inline Real improve_roots(std::vector<Complex> &z, Complex const *c)
{
    std::size_t const degree = z.size();
    Real change = 0;
    for (std::size_t i = 0; i < degree; ++i) {
        Complex p = c[degree], d = 0;
        for (std::size_t k = degree; k-- > 0;) {
            d = product(d, z[i]) + p;
            p = product(p, z[i]) + c[k];
        }
        if (p == Complex(0)) continue;
        Complex sum = 0;
        for (std::size_t j = 0; j < degree; ++j)
            if (j != i && z[i] != z[j]) sum += quotient(1, z[i] - z[j]);
        Complex const w = quotient(p, d), s = quotient(w, Complex(1) - product(w, sum));
        if (!(std::norm(s) < 1e60L)) {
            z[i] *= Complex(1.01L, 0.02L);
            change = 1;
            continue;
        }
        z[i] -= s;
        change = std::max(change, std::norm(s) / (std::norm(z[i]) + 1e-60L));
    }
    return change;
}

inline void add_roots(std::vector<Real> &angles, Complex const *c, std::size_t degree)
{
    while (degree > 0 && std::abs(c[degree]) == 0) --degree;
    if (degree < 1) return;
    std::vector<Complex> z(degree);
    for (std::size_t i = 0; i < degree; ++i)
        z[i] = std::pow(Complex(0.4L, 0.9L), static_cast<int>(i) + 1);
    // Near multiple roots rounding errors of (2^-64)^(1/m) remain: the changes no longer fall.
    Real least = 1;
    for (int step = 0, idle = 0; step < 300 && idle < 4 && least >= 1e-36L; ++step) {
        Real const change = improve_roots(z, c);
        idle = change < least || least > 1e-8L ? 0 : idle + 1;
        least = std::min(least, change);
    }
    for (auto const &w : z)
        if (std::isfinite(std::arg(w))) angles.push_back(std::arg(w));
}

inline void add_arc(Sums &sums, Body const &b, int body, Real s, Real t, Real from, Real to)
{
    Real const *a = b.axes, *c = b.center, d = to - from;
    Real const C = std::sin(to) - std::sin(from), S = std::cos(from) - std::cos(to);
    Real const CC = d / 2 + (std::sin(2 * to) - std::sin(2 * from)) / 4, SS = d - CC,
               CS = (std::cos(2 * from) - std::cos(2 * to)) / 4;
    sums[0] += (a[0] * a[1] * s * s * d + c[0] * a[1] * s * C + c[1] * a[0] * s * S) / 2;
    Real const m = a[0] * a[1] / a[2] * t;
    if (body == 1) {
        sums[1] += a[1] * s * C;
        sums[2] += a[0] * s * S;
        sums[3] += m * d;
    }
    Real *g = &sums[body == 0 ? 4 : 10];
    Real const ss = s * s / 2;
    g[0] += ss * a[1] / a[0] * CC;
    g[1] += ss * CS;
    g[2] += a[1] * s * C * t / a[2] / 2;
    g[3] += ss * a[0] / a[1] * SS;
    g[4] += a[0] * s * S * t / a[2] / 2;
    g[5] += m * d * t / a[2] / 2;
}

inline void add_body(Sums &sums, Body const &b, int body, Body const &o, Real s, Real t, Real so,
                     std::vector<Real> angles)
{
    std::sort(angles.begin(), angles.end());
    if (angles.empty()) angles.push_back(0);
    angles.push_back(angles.front() + 2 * pi);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        Real const from = angles[i], to = angles[i + 1], mid = (from + to) / 2;
        if (!(to > from)) continue;
        Real const x = b.center[0] + b.axes[0] * s * std::cos(mid) - o.center[0],
                   y = b.center[1] + b.axes[1] * s * std::sin(mid) - o.center[1];
        Real const p = x / (o.axes[0] * so), q = y / (o.axes[1] * so);
        Real const value = p * p + q * q;
        // Surfaces that coincide count once.
        if (value < (body == 0 ? 1 + 1e-15L : 1 - 1e-15L)) add_arc(sums, b, body, s, t, from, to);
    }
}

inline Sums section(Body const &ball, Body const &other, Real z)
{
    Sums sums{};
    Real const t1 = (z - ball.center[2]) / ball.axes[2], t2 = (z - other.center[2]) / other.axes[2];
    if (!(std::abs(t1) < 1 && std::abs(t2) < 1)) return sums;
    Real const R = std::sqrt((1 - t1) * (1 + t1)), s = std::sqrt((1 - t2) * (1 + t2));
    Real const A = other.axes[0] * s, B = other.axes[1] * s, x = other.center[0],
               y = other.center[1];
    Real const k3 = R * R / 2 * (1 / A / A - 1 / B / B), k1 = -2 * R * x / A / A,
               k2 = -2 * R * y / B / B,
               k0 = R * R / 2 * (1 / A / A + 1 / B / B) + x * x / A / A + y * y / B / B - 1;
    Complex const c[5] = {k3, Complex(k1, k2), 2 * k0, Complex(k1, -k2), k3};
    std::vector<Real> angles, others;
    if (std::abs(k3) > 1e-17L * (R * R / A / A + R * R / B / B))
        add_roots(angles, c, 4);
    else
        add_roots(angles, c + 1, 2);
    for (Real a : angles)
        others.push_back(std::atan2((R * std::sin(a) - y) / B, (R * std::cos(a) - x) / A));
    add_body(sums, ball, 0, other, R, t1, s, angles);
    add_body(sums, other, 1, ball, s, t2, R, others);
    return sums;
}

struct Rule {
    Body ball, other;
    Real tolerance, low, high;
};

// z = low + (high - low) (1 - cos θ)/2
inline Sums integrand(Rule &r, Real theta)
{
    Real const half = (r.high - r.low) / 2, sh = std::sin(theta / 2);
    Sums s = section(r.ball, r.other, r.low + 2 * half * sh * sh);
    for (Real &x : s.values) x *= half * std::sin(theta);
    return s;
}

inline void gauss(Rule &r, Real a, Real b, Sums &sum)
{
    static Real const x[5] = {
        0.148874338981631210884826001129719985L, 0.433395394129247190799265943165784162L,
        0.679409568299024406234327365114873576L, 0.865063366688984510732096688423493048L,
        0.973906528517171720077964012084452053L};
    static Real const w[5] = {
        0.295524224714752870173815619188769353L, 0.269266719309996355091226921569469353L,
        0.219086362515982043995534934228163192L, 0.149451349150580593145863397657697332L,
        0.0666713443086881375935688098933317928L};
    sum = {};
    Real const m = (a + b) / 2, h = (b - a) / 2;
    for (int i = 0; i < 5; ++i)
        for (int side = -1; side <= 1; side += 2) {
            Sums const s = integrand(r, m + side * h * x[i]);
            for (int k = 0; k < numbers; ++k) sum[k] += h * w[i] * s[k];
        }
}

inline void refine(Rule &r, Real a, Real b, Sums const &whole, Sums &total, int depth)
{
    Sums left, right;
    Real const m = (a + b) / 2;
    gauss(r, a, m, left);
    gauss(r, m, b, right);
    Real error = 0;
    for (int k = 0; k < numbers; ++k)
        error = std::max(error, std::abs(left[k] + right[k] - whole[k]));
    if (error < r.tolerance || depth > 30) {
        for (int k = 0; k < numbers; ++k) total[k] += left[k] + right[k];
        return;
    }
    refine(r, a, m, left, total, depth + 1);
    refine(r, m, b, right, total, depth + 1);
}

/// In the frame of the ball.
inline Sums integrate(Body const &ball, Body const &other, Real tolerance)
{
    Rule r{ball, other, tolerance,
           std::max(ball.center[2] - ball.axes[2], other.center[2] - other.axes[2]),
           std::min(ball.center[2] + ball.axes[2], other.center[2] + other.axes[2])};
    Sums total{};
    if (!(r.high > r.low)) return total;
    constexpr int panels = 4; // so that no narrow part is between all nodes
    for (int k = 0; k < panels; ++k) {
        Real const a = pi * Real(k) / panels, b = pi * Real(k + 1) / panels;
        Sums whole;
        gauss(r, a, b, whole);
        refine(r, a, b, whole, total, 0);
    }
    return total;
}

using Vector = Numbers<3>;

/// A matrix, by its rows.
struct Matrix {
    Vector rows[3];

    Vector &operator[](int i) { return rows[i]; }
    Vector const &operator[](int i) const { return rows[i]; }
};

inline Real dot(Vector const &x, Vector const &y)
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// L of Q = L Lᵀ.
inline Matrix cholesky(double const *form)
{
    Matrix q, l{};
    for (int i = 0, n = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) q[i][j] = q[j][i] = form[n++];
    for (int j = 0; j < 3; ++j) {
        Real d = q[j][j];
        for (int k = 0; k < j; ++k) d -= l[j][k] * l[j][k];
        l[j][j] = std::sqrt(d);
        for (int i = j + 1; i < 3; ++i) {
            Real x = q[i][j];
            for (int k = 0; k < j; ++k) x -= l[i][k] * l[j][k];
            l[i][j] = x / l[j][j];
        }
    }
    return l;
}

inline Real determinant(Matrix const &l) { return l[0][0] * l[1][1] * l[2][2]; }

/// L⁻¹ x.
inline Vector solve(Matrix const &l, Vector x)
{
    for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < j; ++k) x[j] -= l[j][k] * x[k];
        x[j] /= l[j][j];
    }
    return x;
}

/// L⁻ᵀ x.
inline Vector solve_transposed(Matrix const &l, Vector x)
{
    for (int j = 2; j >= 0; --j) {
        for (int k = j + 1; k < 3; ++k) x[j] -= l[k][j] * x[k];
        x[j] /= l[j][j];
    }
    return x;
}

/// Makes rows orthogonal by rotations, as Jacobi's method for one side does.
inline void make_orthogonal(Matrix &g)
{
    for (int sweep = 0; sweep < 40; ++sweep)
        for (int i = 0; i < 3; ++i)
            for (int j = i + 1; j < 3; ++j) {
                Real const xx = dot(g[i], g[i]), yy = dot(g[j], g[j]), xy = dot(g[i], g[j]);
                if (std::abs(xy) <= 1e-20L * std::sqrt(xx * yy)) continue;
                Real const th = (yy - xx) / (2 * xy),
                           tn = (th >= 0 ? 1 : -1) / (std::abs(th) + std::sqrt(1 + th * th));
                Real const cs = 1 / std::sqrt(1 + tn * tn), sn = cs * tn;
                for (int k = 0; k < 3; ++k) {
                    Real const x = g[i][k], y = g[j][k];
                    g[i][k] = cs * x - sn * y;
                    g[j][k] = sn * x + cs * y;
                }
            }
}

/// The sums of a pair from those in the frame of the ball, of which `map` has the axes in its rows.
inline Sums to_space(Sums const &s, Matrix const &map, Real det, bool swapped)
{
    static int const index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    Sums out{};
    out[0] = det * s[0];
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) out[1 + k] += det * (swapped ? -1 : 1) * s[1 + i] * map[i][k];
    for (int body = 0; body < 2; ++body) {
        int const to = (body == 0) != swapped ? 4 : 10, from = body == 0 ? 4 : 10;
        for (int p = 0; p < 3; ++p)
            for (int q = p; q < 3; ++q) {
                Real x = 0;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) x += map[i][p] * s[from + index[i][j]] * map[j][q];
                out[to + index[p][q]] = det * x * (p == q ? 1 : 2);
            }
    }
    return out;
}

/// V, dV/dr12, dV/dq1, dV/dq2 of any pair (by stored entries).
inline Sums common_part(double const *r, double const *q1, double const *q2, Real tolerance)
{
    Matrix const l1 = cholesky(q1), l2 = cholesky(q2);
    bool const swapped = determinant(l1) > determinant(l2);
    Matrix const &l = swapped ? l2 : l1, &other_l = swapped ? l1 : l2;
    // L⁻¹ times the factor of the other one, with its columns as rows.
    Matrix g, map;
    for (int j = 0; j < 3; ++j) g[j] = solve(l, {other_l[0][j], other_l[1][j], other_l[2][j]});
    make_orthogonal(g);
    Real const sign = swapped ? -1 : 1;
    Vector const c = solve(l, {sign * r[0], sign * r[1], sign * r[2]});
    Body ball{{1, 1, 1}, {0, 0, 0}}, other{};
    for (int i = 0; i < 3; ++i) {
        other.axes[i] = std::sqrt(dot(g[i], g[i]));
        for (int k = 0; k < 3; ++k) g[i][k] /= other.axes[i];
        other.center[i] = dot(g[i], c);
        map[i] = solve_transposed(l, g[i]);
    }
    return to_space(integrate(ball, other, tolerance), map, determinant(l), swapped);
}
} // namespace pw85_tests::sections

#endif
