// SPDX-License-Identifier: BSD-3-Clause
// Tests of the volume of the common part (include/pw85/volume/) by kinds of intersection: surfaces
// that touch from inside and cross elsewhere, touch along a curve, or nearly do so. The truths are
// sections_truth.hpp, an integral over concentric ellipses, and closed forms.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "sections_truth.hpp"
#include "sturm.hpp"

using namespace pw85_tests;

namespace {

using Real = sections::Real;
using Pair = Sample<double, 3>;

constexpr double u = 0x1p-53;

double whole(double const q[6])
{
    double volume = 0.0;
    g_assert_cmpint(pw85_volume(q, &volume), ==, PW85_SUCCESS);
    return volume;
}

double smaller(Pair const &p) { return std::fmin(whole(p.q1.entries), whole(p.q2.entries)); }

/// By the template; NaN if there is no success.
double measured(Pair const &p) { return pw85::overlap_volume(p.r12, p.q1, p.q2).volume; }

/// By the C function.
double called(Pair const &p)
{
    double volume = 0.0;
    pw85_overlap_volume(p.r12.coordinates, p.q1.entries, p.q2.entries, &volume);
    return volume;
}

Pair aligned(double const (&r)[3], double const (&axes1)[3], double const (&axes2)[3])
{
    Pair p{};
    for (int i = 0; i < 3; ++i) {
        p.r12[i] = r[i];
        p.q1(i, i) = axes1[i] * axes1[i];
        p.q2(i, i) = axes2[i] * axes2[i];
    }
    return p;
}

sections::Sums truth_of(Pair const &p, Real tolerance)
{
    return sections::common_part(p.r12.coordinates, p.q1.entries, p.q2.entries, tolerance);
}

/// The torques of a gradient: the axial vectors of 2QG.
sections::Numbers<6> torques(Pair const &p, sections::Sums const &d)
{
    sections::Numbers<6> t{};
    for (int body = 0; body < 2; ++body) {
        pw85::SymmetricMatrix<double, 3> const &q = body == 0 ? p.q1 : p.q2;
        pw85::SymmetricMatrix<double, 3> g{};
        for (int k = 0; k < 6; ++k) g[k] = static_cast<double>(d[(body == 0 ? 4 : 10) + k]);
        for (int i = 0; i < 3; ++i)
            for (int j = i + 1; j < 3; ++j) g(i, j) *= 0.5;
        for (int i = 0; i < 3; ++i) {
            int const j = (i + 1) % 3, k = (i + 2) % 3;
            for (int m = 0; m < 3; ++m)
                t[3 * body + i] += 2.0 * (q(j, m) * g(m, k) - q(k, m) * g(m, j));
        }
    }
    return t;
}

/// Volume, gradient and torques against the sections, as fractions of the smaller body.
void check_all(Failures &failures, Pair const &p, double volume_bound, double gradient_bound)
{
    auto const truth = truth_of(p, 1e-8L);
    auto const text = [&] { return hex_text(p); };
    double const v = smaller(p), volume = measured(p), expected = static_cast<double>(truth[0]);
    failures.check(std::abs(volume - expected) <= volume_bound * v, "volume", volume, expected,
                   text);
    failures.check(std::abs(called(p) - expected) <= volume_bound * v, "C", called(p), expected,
                   text);
    double d[15] = {}, t[6] = {};
    pw85_overlap_volume_gradient(p.r12.coordinates, p.q1.entries, p.q2.entries, d, d + 3, d + 9);
    pw85_overlap_volume_torque(p.r12.coordinates, p.q1.entries, p.q2.entries, t, t + 3);
    for (int k = 0; k < 15; ++k) {
        double const right = static_cast<double>(truth[k + 1]);
        failures.check(std::abs(d[k] - right) <= gradient_bound * v, "derivative", d[k], right,
                       text);
    }
    auto const turns = torques(p, truth);
    double const size = p.q1(0, 0) + p.q1(1, 1) + p.q1(2, 2) + p.q2(0, 0) + p.q2(1, 1) + p.q2(2, 2);
    for (int k = 0; k < 6; ++k)
        failures.check(std::abs(t[k] - static_cast<double>(turns[k])) <=
                           4.0 * size * gradient_bound * v,
                       "torque", t[k], static_cast<double>(turns[k]), text);
}

/// Two spheroids that touch at a pole and cross at a circle: 112π/27. A rim that crosses itself
/// where the surfaces touch. The same with the other body inside. The last two have a vertex of the
/// rim at a root of a function whose second derivative is exactly zero in the middle of two poles.
PW85_TEST("/space_kinds/specimens")
{
    Failures failures;
    Pair const caps = aligned({0, 0, 1}, {2, 2, 2}, {2, 2, 1});
    double const right = 112.0 * std::numbers::pi / 27.0;
    failures.check(std::abs(measured(caps) - right) <= 88.0 * u * smaller(caps), "caps",
                   measured(caps), right, [&] { return hex_text(caps); });
    double const window_volume = 3.6319277912697; // by Monte Carlo 3.63 with a deviation of 0.02
    Pair const window = aligned({0, 0, -1}, {1, 2, 1}, {1, 1, 2});
    failures.check(std::abs(measured(window) - window_volume) <= 1e-12, "window", measured(window),
                   window_volume, [&] { return hex_text(window); });
    double const roots[3] = {std::sqrt(5.0), std::sqrt(0.5), 1.0};
    for (Pair const &p :
         {caps, window, aligned({0, 0, 1}, {2, 2, 2}, roots),
          aligned({1, 0, 0}, {4, 4, 2}, {5, 2, 5}), aligned({0, 1, 0}, {5, 4, 1}, {3, 3, 1}),
          aligned({0, 1, 2}, {1, 2, 1}, {4, 2, 2}), aligned({2, 0, 1}, {3, 2, 3}, {1, 3, 2}),
          aligned({1, 0, 0}, {3, 5, 1}, {2, 4, 2}), aligned({0, 0, 3}, {5, 2, 1}, {1, 5, 4})})
        check_all(failures, p, 1e-9, 1e-7);
    // The curvatures are equal in one direction where the surfaces touch.
    for (Pair const &p :
         {aligned({3, 0, 0}, {4, 2, 2}, {1, 1, 2}), aligned({3, 0, 0}, {4, 4, 5}, {1, 2, 5}),
          aligned({0, 0, 3}, {5, 2, 1}, {1, 4, 4})})
        check_all(failures, p, 1e-9, 1e-7);
}

/// Semi-axes of 1 to 5 and offsets of 0 to 4: whole numbers, so that ties are exact. Every second
/// offset is along one axis.
PW85_TEST("/space_kinds/integers")
{
    Failures failures;
    Random random(1701);
    enum Kind { apart, inside, touching, other, kinds };
    long counts[kinds] = {};
    auto const digit = [&](int n) {
        return static_cast<double>(static_cast<int>(random.uniform(0.0, n)));
    };
    for (int n = 0; n < draws(960); ++n) {
        double r[3] = {}, axes[2][3];
        for (auto &body : axes)
            for (double &x : body) x = 1.0 + digit(5);
        int const along = static_cast<int>(digit(3));
        for (int i = 0; i < 3; ++i)
            if (n % 2 == 0 || i == along) r[i] = random.sign() * digit(5);
        Pair const p = aligned(r, axes[0], axes[1]);
        int overlaps = 0, contains[2] = {};
        pw85::Vector<double, 3> const back = -p.r12;
        pw85_overlap(p.r12.coordinates, p.q1.entries, p.q2.entries, &overlaps);
        pw85_contains(p.r12.coordinates, p.q1.entries, p.q2.entries, &contains[0]);
        pw85_contains(back.coordinates, p.q2.entries, p.q1.entries, &contains[1]);
        bool const touches =
            n % 2 != 0 && std::abs(r[along]) == std::abs(axes[0][along] - axes[1][along]);
        Kind const kind = !overlaps                    ? apart
                          : contains[0] || contains[1] ? inside
                          : touches                    ? touching
                                                       : other;
        ++counts[kind];
        double const volume = measured(p);
        if (kind == apart)
            failures.check(volume == 0.0, "apart", volume, 0.0, [&] { return hex_text(p); });
        else if (kind == inside)
            failures.check(volume == smaller(p), "inside", volume, smaller(p),
                           [&] { return hex_text(p); });
        else
            check_all(failures, p, 1e-7, 1e-4);
    }
    for (long const count : counts) g_assert_cmpint(count, >, 0);
    g_test_message("apart %ld, inside %ld, touching and crossing %ld, other %ld", counts[apart],
                   counts[inside], counts[touching], counts[other]);
}

/// Whether a body with the squares b of its semi-axes is inside another one with a, at a distance
/// with the squares s, all whole numbers: exactly, by the pencil of both.
///
/// It is where g(τ) = 1 - τ - Σ s τ/(a τ - b) is not negative for a τ <= 1 that is at least each
/// b/a (the S-lemma). With the largest one, B/A, and τ = (B + t)/A, each a τ - b is F/A for F = a t
/// + a B - b A. The numerator of g is a polynomial in t, and negative for large t.
bool is_inside(Integer const (&s)[3], Integer const (&a)[3], Integer const (&b)[3])
{
    int m = 0;
    for (int i = 1; i < 3; ++i)
        if (b[i] * a[m] > b[m] * a[i]) m = i;
    if (b[m] > a[m]) return false;
    Polynomial product{1}, sum; // of all F; Σ s times the product of the other F
    bool has_pole = false;
    for (int i = 0; i < 3; ++i) {
        if (s[i] == 0) continue;
        Polynomial const factor{a[i] * b[m] - b[i] * a[m], a[i]};
        has_pole = has_pole || factor[0] == 0;
        Polynomial next, next_sum;
        add_product(next, 1, product, factor);
        add_product(next_sum, 1, sum, factor);
        add_product(next_sum, 1, {s[i]}, product);
        product = next;
        sum = next_sum;
    }
    Polynomial numerator, last;
    add_product(numerator, 1, {a[m] - b[m], -1}, product);
    add_product(last, 1, {a[m] * b[m], a[m]}, sum);
    add_product(numerator, -1, {1}, last);
    if (!has_pole && numerator[0] >= 0) return true;
    while (numerator[0] == 0) numerator.erase(numerator.begin());
    return roots_of(numerator).positive > 0;
}

/// Kind of a pair whose axes are the coordinate axes.
enum class Contact { apart, inside, touching, other, size };

/// By Sturm's theorem, for whole semi-axes and offsets.
Contact contact_of(Pair const &p, double const (&axes)[2][3])
{
    Integer s[3], squares[2][3];
    int touches = 0, along = 0;
    for (int i = 0; i < 3; ++i) {
        s[i] = Integer(p.r12[i] * p.r12[i]);
        for (int k = 0; k < 2; ++k) squares[k][i] = Integer(axes[k][i] * axes[k][i]);
        if (s[i] == 0) continue;
        ++along;
        touches += p.r12[i] == std::abs(axes[0][i] - axes[1][i]);
    }
    if (along > 0 && true_sign(p, 1.0) >= 0) return Contact::apart;
    if (is_inside(s, squares[0], squares[1]) || is_inside(s, squares[1], squares[0]))
        return Contact::inside;
    return along == 1 && touches == 1 ? Contact::touching : Contact::other;
}

/// A joint linear map changes the volume by its trace: r12 Fᵀ + 2(Q1 G1 + Q2 G2) = V I. So the
/// volume, the force and the stresses of one pair, which are integrals of their own, must agree.
void check_balance(Failures &failures, Pair const &p, double volume)
{
    double d[15] = {};
    int const status = pw85_overlap_volume_gradient(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                    d, d + 3, d + 9);
    failures.check(status == PW85_SUCCESS, "status", status, PW85_SUCCESS,
                   [&] { return hex_text(p); });
    constexpr int diagonal[3] = {0, 3, 5};
    for (int i = 0; i < 3; ++i) {
        int const k = diagonal[i];
        double const sum = p.r12[i] * d[i] + 2.0 * (p.q1[k] * d[3 + k] + p.q2[k] * d[9 + k]);
        failures.check(std::abs(sum - volume) <= 1e-9 * smaller(p), "balance", sum, volume,
                       [&] { return hex_text(p); });
    }
}

/// Every 41st (fewer if the test takes fewer inputs) of all whole semi-axes from 1 to 5 and offsets
/// from 0 to 4: none is refused, those that are apart or inside have the volume 0 or that of the
/// smaller body, and the volumes and derivatives of the others agree.
PW85_TEST("/space_kinds/list")
{
    Failures failures;
    long counts[static_cast<int>(Contact::size)] = {};
    int const step = eighths() == 1 ? 321 : stride(41);
    for (int n = 0; n < 125 * 125 * 125; n += step) {
        double r[3], axes[2][3];
        int rest = n;
        for (auto *numbers : {r, axes[0], axes[1]})
            for (int i = 0; i < 3; ++i, rest /= 5) numbers[i] = rest % 5 + (numbers == r ? 0 : 1);
        Pair const p = aligned(r, axes[0], axes[1]);
        Contact const contact = contact_of(p, axes);
        ++counts[static_cast<int>(contact)];
        double const volume = measured(p), most = smaller(p);
        bool const fits = contact == Contact::apart    ? volume == 0.0
                          : contact == Contact::inside ? volume == most
                                                       : volume >= 0.0 && volume <= most;
        failures.check(fits, "volume", volume, most, [&] { return hex_text(p); });
        if (contact != Contact::apart) check_balance(failures, p, volume);
    }
    for (long const count : counts) g_assert_cmpint(count, >, 0);
    g_test_message("apart %ld, inside %ld, touching and crossing %ld, other %ld", counts[0],
                   counts[1], counts[2], counts[3]);
}

/// L x, and L Q Lᵀ.
struct Map {
    double rows[3][3];

    Pair operator()(Pair const &p) const
    {
        Pair y{};
        auto const form = [&](pw85::SymmetricMatrix<double, 3> const &q, int i, int j) {
            Real sum = 0;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) sum += Real(rows[i][k]) * q(k, l) * rows[j][l];
            return static_cast<double>(sum);
        };
        for (int i = 0; i < 3; ++i) {
            Real sum = 0;
            for (int k = 0; k < 3; ++k) sum += Real(rows[i][k]) * p.r12[k];
            y.r12[i] = static_cast<double>(sum);
            for (int j = i; j < 3; ++j) {
                y.q1(i, j) = form(p.q1, i, j);
                y.q2(i, j) = form(p.q2, i, j);
            }
        }
        return y;
    }

    double determinant() const
    {
        return rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
               rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
               rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]);
    }
};

Map random_map(Random &random, int kind)
{
    if (kind == 0) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (kind == 1) return {{{1, 0.375, -0.25}, {0, 1, 0.625}, {0.125, 0, 1}}}; // a shear
    pw85::Vector<double, 3> const x = random.direction<3>(),
                                  y = pw85::cross(x, random.direction<3>());
    pw85::Vector<double, 3> const b = 1.0 / std::sqrt(pw85::dot(y, y)) * y, c = pw85::cross(x, b);
    return {{{x[0], x[1], x[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}}};
}

/// The area common to two ellipses with the same centre and axes. The curves cross where y = tx.
Real concentric_area(Real a1, Real b1, Real a2, Real b2)
{
    if (a1 == a2 || b1 == b2 || (a1 < a2) == (b1 < b2))
        return sections::pi * std::min(a1, a2) * std::min(b1, b2);
    if (a1 < a2) {
        std::swap(a1, a2);
        std::swap(b1, b2);
    }
    Real const t = b1 * b2 / (a1 * a2) * std::sqrt((a1 - a2) * (a1 + a2) / ((b2 - b1) * (b2 + b1)));
    return 2 * (a2 * b2 * std::atan(a2 / b2 * t) + a1 * b1 * std::atan2(b1, a1 * t));
}

/// Two ellipsoids whose axes are the coordinate axes, at a distance d along the last one.
struct Coaxial {
    double const (&axes)[2][3];
    Real d;

    /// The area of the common part in the plane at the height z.
    Real section(Real z) const
    {
        Real const x = z / axes[0][2], y = (z - d) / axes[1][2];
        Real const s = std::sqrt(std::max(Real(0), (1 - x) * (1 + x))),
                   t = std::sqrt(std::max(Real(0), (1 - y) * (1 + y)));
        return s > 0 && t > 0
                   ? concentric_area(axes[0][0] * s, axes[0][1] * s, axes[1][0] * t, axes[1][1] * t)
                   : 0;
    }

    /// The heights where the sections have an axis in common, and the ends, in order. The area is
    /// analytic between them, with square roots at them.
    std::vector<Real> breaks() const
    {
        Real const c1 = axes[0][2], c2 = axes[1][2];
        Real const low = std::max(-c1, d - c2), high = std::min(c1, d + c2);
        std::vector<Real> z{low, high};
        for (int i = 0; i < 2; ++i) {
            Real const p = Real(axes[0][i]) * axes[0][i], q = Real(axes[1][i]) * axes[1][i];
            Real const square = q / (c2 * c2) - p / (c1 * c1), half = -d * q / (c2 * c2),
                       rest = p - q - d * half;
            Real const root = std::sqrt(std::max(Real(0), half * half - square * rest));
            for (Real const x :
                 {(-half - root) / square, (root - half) / square, -rest / (2 * half)})
                if (x > low && x < high) z.push_back(x);
        }
        std::sort(z.begin(), z.end());
        return z;
    }

    /// By the rule of Takahasi and Mori, which square roots at the ends do not slow down.
    Real volume(Real step) const
    {
        auto const z = breaks();
        Real sum = 0;
        for (std::size_t i = 0; i + 1 < z.size(); ++i) {
            Real const middle = (z[i] + z[i + 1]) / 2, half = (z[i + 1] - z[i]) / 2;
            for (Real x = -4; x <= 4; x += step) {
                Real const y = sections::pi / 2 * std::sinh(x), c = std::cosh(y);
                sum += step * half * sections::pi / 2 * std::cosh(x) / (c * c) *
                       section(middle + half * std::tanh(y));
            }
        }
        return sum;
    }
};

/// Surfaces that touch at an end of an axis, moved by up to two ulps, mapped, scaled by 2^±300, and
/// exchanged. The volume changes by far less than the bound.
PW85_TEST("/space_kinds/tangencies")
{
    Failures failures;
    Random random(1702);
    double const lengths[] = {1.0, 2.0, 3.0, 5.0, 0.75, 16.0};
    for (int n = 0; n < draws(160); ++n) {
        double axes[2][3];
        for (auto &body : axes)
            for (double &x : body)
                x = lengths[static_cast<int>(random.uniform(0.0, n % 4 == 0 ? 6.0 : 5.0))];
        Pair const exact = aligned({0, 0, axes[0][2] - axes[1][2]}, axes[0], axes[1]);
        Coaxial const coaxial{axes, exact.r12[2]};
        double const volume = static_cast<double>(coaxial.volume(0x1p-5L)), v = smaller(exact);
        // Halving the step of this rule about squares its error.
        double const coarse = static_cast<double>(coaxial.volume(0x1p-4L));
        failures.check(std::abs(coarse - volume) <= 1e-10 * v, "truth", coarse, volume,
                       [&] { return hex_text(exact); });
        for (int move = -2; move <= 2; ++move) {
            Pair moved = exact;
            moved.r12[2] *= 1.0 + move * 0x1p-52;
            Map const map = random_map(random, (n + move + 2) % 3);
            Pair p = map(moved);
            if (move % 2 != 0) p = {-p.r12, p.q2, p.q1};
            double const size = std::abs(map.determinant());
            for (int e : {0, 300, -300}) {
                Pair q = p;
                for (int i = 0; i < 3; ++i) q.r12[i] = std::ldexp(p.r12[i], e);
                for (int i = 0; i < 6; ++i) {
                    q.q1[i] = std::ldexp(p.q1[i], 2 * e);
                    q.q2[i] = std::ldexp(p.q2[i], 2 * e);
                }
                double const actual = std::ldexp(measured(q), -3 * e) / size;
                failures.check(std::abs(actual - volume) <= 1e-8 * v, "volume", actual, volume,
                               [&] { return hex_text(q); });
            }
        }
    }
}

/// Spheroids about one axis with equal equators: the surfaces cross at circles in the planes z/c1 =
/// ±(z - d)/c2, and the part of each is a segment.
Real coaxial_volume(Real a, Real c1, Real c2, Real d)
{
    Real const z1 = c1 == c2 ? d / 2 : d / (1 - c2 / c1), z2 = d / (1 + c2 / c1);
    Real const low = std::max(-c1, d - c2), high = std::min(c1, d + c2);
    Real const ends[4] = {low, std::min(std::max(std::min(z1, z2), low), high),
                          std::min(std::max(std::max(z1, z2), low), high), high};
    auto const segment = [](Real z, Real c) { return z - z * z * z / (3 * c * c); };
    Real sum = 0;
    for (int i = 0; i < 3; ++i) {
        Real const z = (ends[i] + ends[i + 1]) / 2, first = std::abs(z / c1),
                   second = std::abs((z - d) / c2);
        sum += first > second ? segment(ends[i + 1], c1) - segment(ends[i], c1)
                              : segment(ends[i + 1] - d, c2) - segment(ends[i] - d, c2);
    }
    return sections::pi * a * a * sum;
}

PW85_TEST("/space_kinds/equators")
{
    Failures failures;
    Random random(1703);
    for (int n = 0; n < draws(8000); ++n) {
        // multiples of 2⁻²⁰, so that squares are exact
        double const a = std::round(random.log_uniform(0.3, 3.0) * 0x1p20) * 0x1p-20;
        double const c1 = std::round(a * random.log_uniform(0.2, 5.0) * 0x1p20) * 0x1p-20,
                     c2 = std::round(a * random.log_uniform(0.2, 5.0) * 0x1p20) * 0x1p-20;
        double const d = n % 8 == 0 ? std::abs(c1 - c2) : random.log_uniform(1e-12, 1.0) * a;
        if (!(d < c1 + c2)) continue;
        Map const map = random_map(random, n % 2 == 0 ? 0 : 2);
        Pair const p = map(aligned({0, 0, d}, {a, a, c1}, {a, a, c2}));
        double const truth = static_cast<double>(coaxial_volume(a, c1, c2, d)),
                     volume = measured(p);
        // Turned forms are rounded: entries err by u times the square of the aspect ratio.
        double const bound = n % 2 == 0 ? u * (64.0 + 16.0 * 6.0) : 1e-13;
        failures.check(std::abs(volume - truth) <= bound * smaller(p), "volume", volume, truth,
                       [&] { return hex_text(p); });
    }
}

/// Identical bodies, and one inside the other about the same centre: exactly the smaller one, also
/// where the surfaces touch along a curve.
PW85_TEST("/space_kinds/nested")
{
    Failures failures;
    Random random(1704);
    for (int n = 0; n < draws(800); ++n) {
        double axes[2][3];
        for (int i = 0; i < 3; ++i) {
            axes[0][i] = random.log_uniform(0.1, 10.0);
            axes[1][i] = axes[0][i] * (n % 4 > i ? 1.0 : 0.5);
        }
        Pair const p = aligned({0, 0, 0}, axes[0], axes[1]);
        failures.check(measured(p) == whole(p.q2.entries), "volume", measured(p),
                       whole(p.q2.entries), [&] { return hex_text(p); });
        Pair const turned = random_map(random, 2)(p);
        double const volume = measured(turned), right = smaller(turned);
        failures.check(std::abs(volume - right) <= 1e-9 * right, "turned", volume, right,
                       [&] { return hex_text(turned); });
    }
}

} // namespace
