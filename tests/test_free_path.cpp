// SPDX-License-Identifier: BSD-3-Clause
// How far an ellipsoid may move along a direction, against the contact function in 50 digits.
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "flights.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

double const infinity = std::numeric_limits<double>::infinity();

/// Ellipsoid 1 of a pair moves along a direction, up to an end.
template <class T, int D> struct Path {
    Sample<T, D> pair;
    pw85::Vector<T, D> direction;
    T end;
};

template <class T, int D> std::string text(Path<T, D> const &p)
{
    return hex_text(p.pair) + ", direction = " + hex_text(p.direction.coordinates, D) +
           ", end = " + hex_text(&p.end, 1);
}

template <class T, int D> T free_path(Path<T, D> const &p)
{
    return pw85::free_path(p.pair.r12, p.pair.q1, p.pair.q2, p.direction, p.end).length;
}

/// In double and three dimensions by the C API.
double free_path(Path<double, 3> const &p)
{
    double t = 7;
    pw85_free_path(p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries,
                   p.direction.coordinates, p.end, &t);
    return t;
}

/// The same as a flight of the tests of first contacts.
template <class T, int D> Flight<Wide, D> wide_flight(Path<T, D> const &p)
{
    return convert_flight<Wide>(Flight<T, D>{p.pair, {p.direction, {}, T(0)}, {}, p.end});
}

/// Whether the ellipsoids still approach, or are nearest, at x. μ² is convex on the path. So if it
/// falls at x and is one or more there, it is one or more from the start to x.
template <int D> bool approaches(Flight<Wide, D> const &f, Wide const &x)
{
    auto const p = pair_at(f, x);
    auto const lambda = pw85::contact(p.r12, p.q1, p.q2).lambda;
    return pw85::dot(pw85::contact_gradient(p.r12, p.q1, p.q2, lambda).r12, f.motion1.velocity) >=
           0;
}

/// A path that ends at a contact is free of contact, by no rounding error, and the contact follows
/// within rounding errors.
template <class T, int D>
void check_contact(Failures &failures, Path<T, D> const &p, T const &length)
{
    auto const f = wide_flight(p);
    Wide const x = length, excess = mu2_at(f, x) - 1,
               bound = touching_error * Wide(pw85::detail::unit_roundoff<T>()) * sensitivity(f, x);
    failures.check(excess >= 0 && approaches(f, x), "free", static_cast<double>(excess), 0.0,
                   [&] { return text(p); });
    failures.check(excess <= bound, "μ² - 1", static_cast<double>(excess),
                   static_cast<double>(bound), [&] { return text(p); });
}

/// A path of any direction. Four in five lead near the other ellipsoid, and half start very near
/// contact.
template <int D> Path<double, D> random_path(Random &random, int n, PairOptions options)
{
    options.mu2_min = n % 2 == 0 ? 1.0 + 1e-12 : 1.01;
    options.mu2_max = n % 2 == 0 ? 1.01 : 100.0;
    Path<double, D> p{random_pair<D>(random, options),
                      random.log_uniform(0.1, 10.0) * random.direction<D>(),
                      n % 3 == 0 ? infinity : random.log_uniform(0.1, 10.0)};
    if (n % 5 != 0) p.direction = p.pair.r12 + random.log_uniform(1e-3, 1.0) * p.direction;
    return p;
}

template <int D> void check_random(PairOptions const &options, int count)
{
    Failures failures;
    Random random(800 + D);
    int contacts = 0;
    for (int n = 0; n < count; ++n) {
        auto const p = random_path<D>(random, n, options);
        double const length = free_path(p);
        bool const meets =
            pw85::first_contact(p.pair.r12, p.pair.q1, p.pair.q2,
                                pw85::Motion<double, D>{p.direction, {}, 0.0}, {}, p.end)
                .time < infinity;
        failures.check(meets == (length < infinity), "as first_contact()", length, p.end,
                       [&] { return text(p); });
        if (length < infinity) check_contact(failures, p, length);
        contacts += length > 0.0 && length < infinity;
    }
    g_assert_cmpint(contacts, >, count / 2);
}

PW85_TEST("/free_path/random")
{
    check_random<3>({.aspect = 3.0}, draws(1000));
    check_random<3>({.aspect = 1e3}, draws(1000));
    check_random<3>({.aspect = 1e6}, draws(400));
    check_random<2>({.aspect = 1e3}, draws(1000));
}

// Ellipsoids of very different sizes, either way.
void test_sizes() { check_random<3>({.aspect = 10.0, .size_ratio = 0x1p40}, draws(1000)); }

template <class T> void check_scalar(int count)
{
    Failures failures;
    Random random(810);
    for (int n = 0; n < count; ++n) {
        auto const p = random_path<3>(random, 2 * n + 1, {.aspect = 10.0});
        Path<T, 3> const narrow{convert<T>(p.pair), convert<T>(p.direction), static_cast<T>(p.end)};
        T const length = free_path(narrow);
        if (length > T(0) && length < std::numeric_limits<T>::infinity())
            check_contact(failures, narrow, length);
    }
}

PW85_TEST("/free_path/scalars")
{
    check_scalar<float>(draws(400));
    check_scalar<long double>(draws(400));
}

// Units of length, and the length of the direction, change no bit; exchanging the ellipsoids and
// turning the path only rounding.
PW85_TEST("/free_path/units")
{
    Failures failures;
    Random random(820);
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = random_path<3>(random, n, {.aspect = 100.0});
        double const length = free_path(p);
        for (int const e : {-480, -40, 40, 480})
            for (int const unit : {-40, 0, 400}) {
                auto q = p;
                q.pair = {pw85::detail::times_power_of_two(p.pair.r12, e),
                          pw85::detail::times_power_of_two(p.pair.q1, 2 * e),
                          pw85::detail::times_power_of_two(p.pair.q2, 2 * e)};
                q.direction = pw85::detail::times_power_of_two(p.direction, e - unit);
                q.end = std::ldexp(p.end, unit);
                double const other = std::ldexp(free_path(q), -unit);
                failures.check(other == length, "unit", other, length, [&] { return text(q); });
            }
        Path<double, 3> const turned{{-p.pair.r12, p.pair.q2, p.pair.q1}, -p.direction, p.end};
        double const other = free_path(turned);
        failures.check(other == length || std::abs(other - length) <= 1e-7 * (1 + length),
                       "exchange", other, length, [&] { return text(p); });
    }
}

// From afar: r12 is up to 2⁵⁰ times as long as the ellipsoids.
PW85_TEST("/free_path/remote")
{
    Failures failures;
    Random random(830);
    int contacts = 0;
    for (int n = 0; n < draws(400); ++n) {
        auto p = random_path<3>(random, 2 * n + 1, {.aspect = 10.0});
        p.end = infinity;
        p.direction = p.pair.r12 + random.uniform(0.0, 0.3) * random.direction<3>();
        p.pair.r12 = p.pair.r12 + random.log_uniform(1.0, 0x1p50) * p.direction;
        double const length = free_path(p);
        contacts += length < infinity;
        if (length < infinity) check_contact(failures, p, length);
    }
    g_assert_cmpint(contacts, >, draws(400) / 4);
}

// Paths along the surface: of whole numbers that touch exactly, or miss or overlap by one or two
// ulps, also turned. The contact follows within rounding errors of μ², as elsewhere.
PW85_TEST("/free_path/grazing")
{
    Failures failures;
    Random random(850);
    int contacts = 0, overlaps = 0;
    for (int n = 0; n < draws(2000); ++n) {
        auto const whole = [&](int least, int most) {
            return std::floor(random.uniform(least, most + 1));
        };
        Path<double, 3> p{};
        for (int i = 0; i < 3; ++i) {
            double const a = whole(1, 5), b = whole(1, 5);
            p.pair.q1(i, i) = a * a;
            p.pair.q2(i, i) = b * b;
        }
        int const i = n % 3, along = (i + 1) % 3, shift = n / 3 % 5 - 2;
        double const touching = std::sqrt(p.pair.q1(i, i)) + std::sqrt(p.pair.q2(i, i));
        p.pair.r12[i] = touching * (1 + shift * 0x1p-52);
        p.pair.r12[along] = whole(4, 12);
        p.direction[along] = n % 2 == 0 ? 1 : 0.75;
        p.end = n % 7 == 0 ? p.pair.r12[along] : infinity;
        bool const meets = shift < 0;
        if (n % 4 == 0) p.pair.r12 = p.pair.r12 + 64.0 * p.direction;
        if (n % 4 == 1) { // exchanged
            std::swap(p.pair.q1, p.pair.q2);
            p.pair.r12 = -p.pair.r12;
            p.direction = -p.direction;
        }
        double const length = free_path(p);
        if (p.end == infinity)
            failures.check(length < infinity || !meets, "contact", length, 0,
                           [&] { return text(p); });
        if (length < infinity) check_contact(failures, p, length);
        contacts += length < infinity;
        overlaps += meets;
    }
    g_assert_cmpint(contacts, >, draws(800));
    g_assert_cmpint(overlaps, >, draws(600));
    // The plane at the nearest place is exactly along the path, and the ellipsoids overlap by 2⁻⁵⁰.
    double const q1[6] = {16, 0, 0, 16, 0, 1}, q2[6] = {4, 0, 0, 16, 0, 9},
                 r12[3] = {0, 0x1.fffffffffffffp+2, -5}, direction[3] = {0, 0, -1};
    double t = 7;
    g_assert_cmpint(pw85_free_path(r12, q1, q2, direction, 8.0, &t), ==, PW85_SUCCESS);
    g_assert_true(t < 5.0 && t > 5.0 - 1e-6);
}

// Spheres: the root of |r - t d| = 2.
PW85_TEST("/free_path/spheres")
{
    double const q[6] = {1, 0, 0, 1, 0, 1}, d[3] = {1, 0, 0}, r12[3] = {5, 1, 0},
                 touching[3] = {2, 0, 0}, back[3] = {-1, 0, 0}, across[3] = {0, 1, 0},
                 center[3] = {0, 0, 0}, inside[3] = {1, 0, 0};
    auto const path = [&](double const *r, double const *direction, double end) {
        double t = 7;
        g_assert_cmpint(pw85_free_path(r, q, q, direction, end, &t), ==, PW85_SUCCESS);
        return t;
    };
    double const expected = 5 - std::sqrt(3.0);
    g_assert_cmpfloat(path(r12, d, infinity), <=, expected + 0x1p-52);
    g_assert_cmpfloat(path(r12, d, infinity), >, expected - 80 * 0x1p-53 * 5.0);
    g_assert_true(path(r12, d, 3.2) == infinity);
    g_assert_true(path(r12, d, 3.3) < 3.3);
    g_assert_true(path(r12, back, infinity) == infinity);
    g_assert_true(path(r12, across, infinity) == infinity);
    g_assert_true(path(touching, d, 1.0) == 0.0);
    g_assert_true(path(touching, back, 1.0) == infinity);
    g_assert_true(path(center, d, 1.0) == 0.0);
    g_assert_true(path(inside, back, 1.0) == 0.0);
}

// A chain of two: each ellipsoid moves up to the other, again and again. No pair of doubles on the
// way overlaps, if each move stops short by the rounding of positions.
PW85_TEST("/free_path/never_overlaps")
{
    Failures failures;
    Random random(840);
    for (int n = 0; n < draws(2000); ++n) {
        auto p = random_path<3>(random, 2 * n + 1, {.aspect = random.log_uniform(1.0, 1e3)});
        p.direction = p.pair.r12;
        p.end = infinity;
        double const length = free_path(p);
        p.pair.r12 = p.pair.r12 - (length - 0x1p-50 * (1 + length)) * p.direction;
        int overlap = -1;
        pw85_overlap(p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries, &overlap);
        failures.check(overlap == 0, "overlap", overlap, 0, [&] { return text(p); });
    }
}

PW85_TEST("/free_path/bad_input")
{
    double const q[6] = {1, 0, 0, 1, 0, 1}, bad[6] = {1, 0, 0, -1, 0, 1}, r12[3] = {5, 1, 0},
                 d[3] = {1, 0, 0}, zero[3] = {0, 0, 0}, nan[3] = {0, NAN, 1};
    double t = 7;
    g_assert_cmpint(pw85_free_path(r12, q, bad, d, 1.0, &t), ==, PW85_ENOTPD);
    g_assert_true(std::isnan(t));
    for (double const *direction : {zero, nan})
        g_assert_cmpint(pw85_free_path(r12, q, q, direction, 1.0, &t), ==, PW85_EINVAL);
    for (double const end : {-1.0, static_cast<double>(NAN)})
        g_assert_cmpint(pw85_free_path(r12, q, q, d, end, &t), ==, PW85_EINVAL);
}

PW85_ADD_TEST("/free_path/sizes", test_sizes);

} // namespace
