// SPDX-License-Identifier: BSD-3-Clause
// Tests of an ellipsoid and a capsule (include/pw85/distance/capsule.hpp).
//
// The truth in 50 digits proves itself. The point x of the capsule gives an upper bound of μ², and
// s = Q⁻¹x a lower one: the least s·y of the capsule, squared, over sᵀQs.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glib.h>

#include <pw85.h>
#include <pw85/distance/capsule.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "rotated.hpp"
#include "shape_cases.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

template <class T> struct CapsuleCase {
    pw85::Vector<T, 3> a, b;
    T r;
    pw85::SymmetricMatrix<T, 3> q;
};

using Doubles = CapsuleCase<double>;
using Wides = CapsuleCase<Wide>;

std::string text(Doubles const &c)
{
    return "a, b, r, q = " + hex_text(c.a.coordinates, 3) + ", " + hex_text(c.b.coordinates, 3) +
           ", " + hex_text(&c.r, 1) + ", " + hex_text(c.q.entries, 6);
}

Wides widen(Doubles const &c)
{
    return {convert<Wide>(c.a), convert<Wide>(c.b), c.r, convert<Wide>(c.q)};
}

Doubles scaled(Doubles c, int length, int form)
{
    using pw85::detail::times_power_of_two;
    return {times_power_of_two(c.a, length), times_power_of_two(c.b, length),
            times_power_of_two(c.r, length), times_power_of_two(c.q, 2 * form)};
}

struct Contact {
    int status;
    double mu2;
    Vector3 point;
};

Contact contact(Doubles const &c)
{
    Contact found{};
    found.status = pw85_contact_capsule(c.a.coordinates, c.b.coordinates, c.r, c.q.entries,
                                        &found.mu2, found.point.coordinates);
    return found;
}

int overlap(Doubles const &c)
{
    int answer = -2;
    pw85_overlap_capsule(c.a.coordinates, c.b.coordinates, c.r, c.q.entries, &answer);
    return answer;
}

struct Distance {
    int status;
    double distance;
    Vector3 point1, point2, normal;
};

Distance distance(Doubles const &c)
{
    Distance d{};
    d.status =
        pw85_distance_capsule(c.a.coordinates, c.b.coordinates, c.r, c.q.entries, &d.distance,
                              d.point1.coordinates, d.point2.coordinates, d.normal.coordinates);
    return d;
}

/// The nearest point of a segment to x.
WideVector nearest_of_segment(Wides const &c, WideVector const &x)
{
    auto const e = c.b - c.a;
    Wide const ee = pw85::dot(e, e);
    if (ee == 0) return c.a;
    Wide const t = std::clamp(Wide(pw85::dot(x - c.a, e) / ee), Wide(0), Wide(1));
    return pw85::detail::add_scaled(c.a, t, e);
}

struct Truth {
    Wide mu2, sensitivity;
};

/// μ² in 50 digits with its proof, and S + 2 r|s| of the contract.
Truth proved_truth(Wides const &c, Failures &failures)
{
    auto const found = pw85::contact_capsule(c.a, c.b, c.r, c.q);
    auto const describe = [] { return std::string("the truth"); };
    auto const check = [&](bool right, char const *what, Wide const &x, Wide const &y) {
        failures.check(right, what, static_cast<double>(x), static_cast<double>(y), describe);
    };
    auto const nearest = nearest_of_segment(c, found.point);
    Wide const size = norm(c.a) + norm(c.b) + c.r, tiny = Wide("1e-40") * size;
    check(norm(found.point - nearest) <= c.r + tiny, "in the capsule", norm(found.point - nearest),
          c.r);
    auto const s = pw85::product(inverse(c.q), found.point);
    Wide const upper = pw85::dot(s, found.point), form = pw85::dot(s, pw85::product(c.q, s));
    if (found.mu2 == 0) return {0, 0};
    Wide const least = std::min(pw85::dot(s, c.a), pw85::dot(s, c.b)) - c.r * norm(s),
               lower = least > 0 ? Wide(least * least / form) : Wide(0);
    Wide terms = c.r * norm(s);
    auto const e = c.b - c.a;
    Wide const ee = pw85::dot(e, e),
               weight = ee > 0 ? Wide(pw85::dot(nearest - c.a, e) / ee) : Wide(0);
    for (int i = 0; i < 3; ++i)
        terms += abs(s[i]) * ((1 - weight) * abs(c.a[i]) + weight * abs(c.b[i]));
    Wide const sensitivity = absolute_form(c.q, s) + 2 * terms;
    check(abs(upper - found.mu2) <= Wide("1e-25") * sensitivity, "upper bound", upper, found.mu2);
    check(abs(lower - found.mu2) <= Wide("1e-25") * sensitivity, "lower bound", lower, found.mu2);
    return {found.mu2, sensitivity};
}

/// Balls, needles and discs; capsules from 1e-6 to 1e4 times their size, thick and thin, some of
/// them balls.
Doubles random_capsule(Random &random, int n)
{
    auto const drawn = random_case<Segment>(random, n);
    Doubles c{drawn.points[0], drawn.points[1], random.log_uniform(1e-6, 10.0), drawn.q};
    if (n % 7 == 0) c.b = c.a;
    if (n % 5 == 0) c.r = random.uniform(0.0, 1.0) * norm(c.a);
    if (n % 31 == 0) c.r = 0;
    if (n % 13 == 0) c.b = pw85::detail::add_scaled(c.b, 1e3 * norm(c.a), random.direction<3>());
    return c;
}

PW85_TEST("/capsule/contact")
{
    Failures failures;
    Random random(960);
    double worst = 0;
    for (int n = 0; n < draws(3000); ++n) {
        auto const c = random_capsule(random, n);
        auto const truth = proved_truth(widen(c), failures);
        auto const describe = [&] { return text(c); };
        int const exponent = n % 3 == 0 ? 0 : n % 3 == 1 ? 40 : -40;
        for (int const other : {0, 20}) {
            auto const found = contact(scaled(c, exponent + other, exponent));
            Wide const mu2 = pw85::detail::times_power_of_two(Wide(found.mu2), -2 * other),
                       error = abs(Wide(mu2 - truth.mu2)), unit = u * truth.sensitivity;
            failures.check(found.status == PW85_SUCCESS && error <= 80 * unit, "mu2",
                           static_cast<double>(mu2), static_cast<double>(truth.mu2), describe);
            if (unit > 0) worst = std::max(worst, static_cast<double>(Wide(error / unit)));
        }
    }
    g_test_message("largest error %.3g u S", worst);
}

/// Capsules at distances such that |μ² - 1| is from 1e-17 to 1/2.
PW85_TEST("/capsule/overlap")
{
    Failures failures;
    Random random(961);
    int decided = 0;
    for (int n = 0; n < draws(3000); ++n) {
        auto c = random_capsule(random, n);
        double const mu2 = contact(c).mu2;
        if (!(mu2 > 1e-12)) continue;
        double const factor = std::sqrt((1 + random.sign() * random.log_uniform(1e-17, 0.5)) / mu2);
        c.a = factor * c.a;
        c.b = factor * c.b;
        c.r = factor * c.r;
        Wide const excess = proved_truth(widen(c), failures).mu2 - 1;
        if (abs(excess) < Wide("1e-30")) continue;
        ++decided;
        int const exponent = n % 3 == 0 ? 0 : n % 3 == 1 ? 40 : -40;
        int const found = overlap(scaled(c, exponent, exponent));
        failures.check(found == (excess < 0), "overlap", found, static_cast<double>(excess),
                       [&] { return text(c); });
    }
    g_assert_cmpint(decided, >, draws(3000) / 2);
}

/// Integers for which the capsule touches the ellipsoid exactly. With s = (1, 2, 2), |s| = 3, and m
/// = Qs/k, where k² = sᵀQs, the ellipsoid has the normal s at m, and a ball of radius 3r about m +
/// r s touches it. w is across s: adding w wᵀ to Q changes neither, and the segment may go on along
/// w.
PW85_TEST("/capsule/touching")
{
    Failures failures;
    for (int n = 0; n < 600; ++n) {
        double const m2 = 2 * (1 + n % 3), m3 = 2 * (1 + n / 3 % 4), m1 = 2 * (1 + n / 12 % 3),
                     k = m1 + 2 * (m2 + m3), r = 1 + n % 7;
        Vector3 const w = n % 2 == 0 ? Vector3{2, -2, 1} : Vector3{2, 1, -2}, s{1, 2, 2};
        Doubles c{
            {m1 + r, m2 + 2 * r, m3 + 2 * r}, {}, 3 * r, {k * m1, 0, 0, k * m2 / 2, 0, k * m3 / 2}};
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) c.q(i, j) += double(n % 5) * w[i] * w[j];
        double const forward = n % 4, back = n % 3;
        c.b = pw85::detail::add_scaled(c.a, forward, w);
        if (n % 8 == 7) c.b = c.b + s; // away from the ellipsoid
        c.a = pw85::detail::add_scaled(c.a, n % 8 == 7 ? 0.0 : -back, w);
        if (n % 2 == 1) std::swap(c.a, c.b);
        for (int const exponent : {0, 40, -40}) {
            auto const touching = scaled(c, exponent, exponent);
            auto more = touching, less = touching;
            more.r *= 1 + 2 * u;
            less.r *= 1 - u;
            auto const describe = [&] { return text(touching); };
            failures.check(overlap(touching) == 0, "touching", overlap(touching), 0, describe);
            failures.check(overlap(more) == 1, "larger by a bit", overlap(more), 1, describe);
            failures.check(overlap(less) == 0, "smaller by a bit", overlap(less), 0, describe);
            auto const d = distance(touching);
            failures.check(d.distance >= 0 && d.distance <= 16 * u * 200 * std::ldexp(1, exponent),
                           "distance", d.distance, 0, describe);
        }
    }
}

/// The distance in 50 digits is that of the segment minus the radius, which test_solids proves. If
/// they are apart, the points prove it.
PW85_TEST("/capsule/distance")
{
    Failures failures;
    Random random(962);
    double worst = 0;
    for (int n = 0; n < draws(3000); ++n) {
        auto const c = random_capsule(random, n);
        auto const wide = widen(c);
        auto const truth = pw85::distance_segment(wide.a, wide.b, wide.q);
        Wide const expected = truth.distance - wide.r;
        Wide const farthest = std::max(norm(wide.a), norm(wide.b)) + wide.r;
        Wide const half_width = pw85::detail::support(wide.q, truth.normal).extent;
        Wide const unit = u * (farthest + absolute_form(wide.q, truth.normal) / (2 * half_width));
        auto const describe = [&] { return text(c); };
        int const exponent = n % 3 == 0 ? 0 : n % 3 == 1 ? 40 : -40;
        auto const d = distance(scaled(c, exponent, exponent));
        Wide const found = pw85::detail::times_power_of_two(Wide(d.distance), -exponent),
                   error = abs(Wide(found - expected)) / unit;
        failures.check(d.status == PW85_SUCCESS && error <= 16, "distance",
                       static_cast<double>(found), static_cast<double>(expected), describe);
        worst = std::max(worst, static_cast<double>(error));
        int const answer = overlap(c);
        failures.check(answer == 1 ? d.distance <= 0 : d.distance >= 0, "sign", d.distance, answer,
                       describe);
        if (n % 4 == 3) continue; // aspect ratios up to 10³
        auto const near = distance(c);
        auto const p1 = convert<Wide>(near.point1), p2 = convert<Wide>(near.point2),
                   normal = convert<Wide>(near.normal);
        Wide const bound =
            0x1p18 * u * std::max(farthest, Wide(sqrt(pw85::detail::largest_diagonal(wide.q))));
        failures.check(norm(p2 - p1 - Wide(near.distance) * normal) <= bound, "points",
                       near.distance, 0, describe);
        failures.check(norm(p2 - nearest_of_segment(wide, p2)) <= wide.r + bound, "set",
                       near.distance, 0, describe);
    }
    g_test_message("largest error %.3g u sum", worst);
}

/// A ball is an ellipsoid without a direction: the distance and, if the ellipsoid is a ball, μ² are
/// known. A capsule of radius 0 is a segment.
PW85_TEST("/capsule/degenerate")
{
    Failures failures;
    Random random(963);
    for (int n = 0; n < draws(1000); ++n) {
        auto c = random_capsule(random, n);
        auto const describe = [&] { return text(c); };
        auto const same = [&](double x, double y, char const *what) {
            failures.check(x == y, what, x, y, describe);
        };
        c.r = 0;
        double length, point1[3], point2[3], normal[3];
        int answer;
        pw85_overlap_segment(c.a.coordinates, c.b.coordinates, c.q.entries, &answer);
        pw85_distance_segment(c.a.coordinates, c.b.coordinates, c.q.entries, &length, point1,
                              point2, normal);
        auto const d = distance(c);
        same(overlap(c), answer, "overlap");
        same(d.distance, length, "distance");
        for (int i = 0; i < 3; ++i) same(d.point2[i], point2[i], "point2");
        double const radius = random.log_uniform(1e-3, 1e3), far = norm(c.a);
        c.q = {radius * radius, 0, 0, radius * radius, 0, radius * radius};
        c.r = random.log_uniform(1e-3, 1e3);
        c.b = c.a;
        double const gap = std::max(0.0, far - c.r);
        failures.check(std::fabs(std::sqrt(contact(c).mu2) * radius - gap) <= 16 * u * (far + c.r),
                       "two balls", contact(c).mu2, gap, describe);
    }
}

/// Sizes that are far apart, and beyond squares.
PW85_TEST("/capsule/range")
{
    for (int const size : {-500, 0, 500})
        for (int const radius : {-1000, -300, 0, 300, 1000}) {
            double const r = std::ldexp(1.0, radius), axis = std::ldexp(1.0, size);
            Doubles const c{{0, 0, 1.5 * r + 1.5 * axis},
                            {r, 0, 1.5 * r + 1.5 * axis},
                            r,
                            {axis * axis, 0, 0, axis * axis, 0, axis * axis}};
            double const gap = c.a[2] - r, expected = gap / axis;
            auto const found = contact(c);
            g_assert_cmpint(found.status, ==, PW85_SUCCESS);
            if (expected * expected <= std::numeric_limits<double>::max())
                g_assert_cmpfloat(std::fabs(found.mu2 - expected * expected), <=,
                                  64 * u * expected * expected);
            g_assert_cmpint(overlap(c), ==, 0);
            g_assert_cmpfloat(std::fabs(distance(c).distance - (gap - axis)), <=,
                              16 * u * (c.a[2] + axis));
        }
}

PW85_TEST("/capsule/bad_input")
{
    Doubles const good{{3, 0, 0}, {0, 3, 0}, 0.5, {1, 0, 0, 1, 0, 1}};
    g_assert_cmpint(contact(good).status, ==, PW85_SUCCESS);
    for (double const radius : {-1.0, -5e-324}) {
        auto bad = good;
        bad.r = radius;
        g_assert_cmpint(contact(bad).status, ==, PW85_EINVAL);
        g_assert_true(std::isnan(contact(bad).mu2));
        g_assert_cmpint(overlap(bad), ==, -1);
        g_assert_cmpint(distance(bad).status, ==, PW85_EINVAL);
        g_assert_true(std::isnan(distance(bad).distance));
    }
}

/// Rows are as one row, and a bad row is marked.
PW85_TEST("/capsule/rows")
{
    Random random(964);
    constexpr int rows = 9, bad = 4;
    double a[3 * rows], b[3 * rows], r[rows], q[6 * rows];
    unsigned char answers[rows];
    Doubles cases[rows];
    for (int n = 0; n < rows; ++n) {
        cases[n] = random_capsule(random, n);
        if (n == bad) cases[n].r = -1;
        std::copy_n(cases[n].a.coordinates, 3, a + 3 * n);
        std::copy_n(cases[n].b.coordinates, 3, b + 3 * n);
        std::copy_n(cases[n].q.entries, 6, q + 6 * n);
        r[n] = cases[n].r;
    }
    g_assert_cmpint(pw85_overlap_capsule_batch(rows, a, b, r, q, answers), ==, PW85_EINVAL);
    for (int n = 0; n < rows; ++n)
        g_assert_cmpint(answers[n], ==, n == bad ? 255 : overlap(cases[n]));
}

} // namespace
