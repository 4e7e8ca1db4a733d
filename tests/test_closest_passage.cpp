// SPDX-License-Identifier: BSD-3-Clause
// The closest passage on a straight way, against golden section over the time of the contact
// function in 50 digits.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "condition_number.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "golden_section.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

double const infinity = std::numeric_limits<double>::infinity();

/// A pair on its way.
struct Passing {
    Sample<double, 3> pair;
    Vector3 velocity;
    double t_max;
};

std::string text(Passing const &p)
{
    return pw85_tests::hex_text(p.pair) +
           ", velocity = " + pw85_tests::hex_text(p.velocity.coordinates, 3) +
           ", t_max = " + pw85_tests::hex_text(&p.t_max, 1);
}

/// The pair at time t, and μ² there.
Sample<Wide, 3> at(Passing const &p, Wide const &t)
{
    auto s = convert<Wide>(p.pair);
    for (int i = 0; i < 3; ++i) s.r12[i] += t * Wide(p.velocity[i]);
    return s;
}

Wide mu2_at(Passing const &p, Wide const &t)
{
    auto const s = at(p, t);
    return pw85::contact(s.r12, s.q1, s.q2).mu2;
}

/// The least μ² and its time, to some 1e-20 in the time and to 1e-40 in μ², which is stationary
/// there.
struct Least {
    Wide mu2, t;
};

Least least(Passing const &p)
{
    auto const value = [&p](Wide const &t) { return mu2_at(p, t); };
    Wide const start = value(0);
    Wide high = std::isinf(p.t_max) ? Wide(1) : Wide(p.t_max);
    while (std::isinf(p.t_max) && value(high) <= start) high *= 2;
    auto const found = golden_section<Wide>(value, {0, high}, 110);
    Wide const t = (found.low + found.high) / 2;
    Least result{value(t), t};
    if (start <= result.mu2) result = {start, 0};
    if (!std::isinf(p.t_max) && mu2_at(p, p.t_max) <= result.mu2)
        result = {mu2_at(p, p.t_max), p.t_max};
    return result;
}

/// S of pw85.h at time t: μ² cond has the terms of the separation itself, 2λ(1-λ) Σ|n_i (r +
/// tv)_i|, which those of r and of t v replace.
Wide change(Passing const &p, Wide const &t)
{
    auto s = at(p, t);
    auto const c = pw85::contact(s.r12, s.q1, s.q2);
    auto const gradient = pw85::contact_gradient(s.r12, s.q1, s.q2, c.lambda);
    Wide sum = c.mu2 * condition_number(s, c.lambda);
    for (int i = 0; i < 3; ++i)
        sum += abs(gradient.r12[i]) * (abs(Wide(p.pair.r12[i])) + t * abs(Wide(p.velocity[i])));
    return sum;
}

template <class T> struct Passage {
    T mu2, t;
};
using Result = Passage<double>;

/// By the headers. The numbers must be in T.
template <class T> Passage<T> by_type(Passing const &p)
{
    auto const s = convert<T>(p.pair);
    auto const c =
        pw85::closest_passage(s.r12, s.q1, s.q2, convert<T>(p.velocity), static_cast<T>(p.t_max));
    return {c.mu2, c.time};
}

Result by_one(Passing const &p) { return by_type<double>(p); }

Result by_batch(Passing const &p)
{
    Result result{7, 7};
    pw85_closest_passage_batch(1, p.pair.r12.coordinates, p.pair.q1.entries, p.pair.q2.entries,
                               p.velocity.coordinates, p.t_max, &result.mu2, &result.t);
    return result;
}

/// How much μ² may change by the rounding of the time t, by 2 u t: μ is a norm, so μ changes by 2 u
/// t μ(v) at most.
Wide change_by_rounding(Passing const &p, Least const &exact, Wide const &u)
{
    auto const s = convert<Wide>(p.pair);
    auto const v = convert<Wide>(p.velocity);
    Wide const mu = sqrt(exact.mu2),
               change = 2 * u * exact.t * sqrt(pw85::contact(v, s.q1, s.q2).mu2);
    return change * (2 * mu + change);
}

/// The bound of pw85.h, and that μ² at the time is the least one.
template <class T> void compare(Passing const &p, Least const &exact, Passage<T> const &result,
                                char const *what, Failures &failures)
{
    auto const describe = [&] { return what + (": " + text(p)); };
    failures.check(result.t >= 0 && result.t <= static_cast<T>(p.t_max), "range of t",
                   static_cast<double>(result.t), p.t_max, describe);
    Wide const u = pw85::detail::unit_roundoff<T>(), unit = u * change(p, exact.t);
    double const error = static_cast<double>(Wide(abs(Wide(result.mu2) - exact.mu2) / unit));
    failures.check(error <= 8, "error in u S", error, 8, describe);
    Wide const excess = mu2_at(p, result.t) - exact.mu2 - change_by_rounding(p, exact, u);
    failures.check(excess <= 8 * unit, "at the time, in u S",
                   static_cast<double>(Wide(excess / unit)), 8, describe);
}

/// Pairs of all shapes. Every second way leads near the other ellipsoid; some ways lead along an
/// axis, or very near the centre.
Passing random_passing(Random &random, int n, double largest_aspect)
{
    double const aspect = n % 4 == 0 ? 1.0 : std::pow(largest_aspect, (n % 4) / 3.0);
    Passing p{{random.log_uniform(1e-2, 1e2) * random.direction<3>(),
               random.form(1.0, random.log_uniform(1.0, aspect)),
               random.form(random.log_uniform(1e-3, 1e3), random.log_uniform(1.0, aspect))},
              random.log_uniform(0.1, 10.0) * random.direction<3>(),
              n % 3 == 0 ? infinity : random.log_uniform(0.1, 10.0)};
    int const kind = n / 4 % 5;
    if (n % 2 == 0) p.velocity = 0.3 * p.velocity - p.pair.r12;
    if (kind == 1 || kind == 2)
        for (int const k : {1, 2, 4}) p.pair.q1[k] = p.pair.q2[k] = 0;
    if (kind == 2) p.velocity[n % 3] = 0;
    if (kind == 3) p.velocity = random.log_uniform(1e-6, 1.0) * p.velocity - 10.0 * p.pair.r12;
    return p;
}

PW85_TEST("/closest_passage/random/double")
{
    Failures failures;
    Random random(700);
    int between = 0, count = draws(1000);
    for (int n = 0; n < count; ++n) {
        auto const p = random_passing(random, n, 1e6);
        if (std::isnan(by_one(p).mu2)) continue; // a form that is not definite when it is rounded
        auto const exact = least(p);
        compare(p, exact, by_one(p), "one", failures);
        compare(p, exact, by_batch(p), "batch", failures);
        between += exact.t > 0 && exact.t < p.t_max;
    }
    g_assert_cmpint(between, >, count / 4);
    g_assert_cmpint(between, <, 3 * count / 4);
}

/// The pair with numbers that are rounded to float.
Passing in_float(Passing const &p)
{
    return {convert<double>(convert<float>(p.pair)), convert<double>(convert<float>(p.velocity)),
            static_cast<double>(static_cast<float>(p.t_max))};
}

template <class T> void test_type()
{
    Failures failures;
    Random random(705);
    for (int n = 0; n < draws(200); ++n) {
        auto const p = in_float(random_passing(random, n, 100.0));
        compare(p, least(p), by_type<T>(p), "type", failures);
    }
}

// Forms along the axes and a way that is not: their shadows lose the digits of the short axes.
PW85_TEST("/closest_passage/shadows_that_cancel")
{
    Failures failures;
    Random random(710);
    for (int n = 0; n < draws(80); ++n) {
        double const length = random.log_uniform(1e3, 1e13);
        Passing p{{random.log_uniform(0.1, 10.0) * random.direction<3>(),
                   {length, 0, 0, 1, 0, 0.5},
                   {random.uniform(0.5, 2.0) * length, 0, 0, 0.3, 0, 1}},
                  {1, 0.5, 0.5},
                  infinity};
        if (n % 2 == 0) p.velocity = -1.0 * p.velocity;
        compare(p, least(p), by_one(p), "one", failures);
        compare(p, least(p), by_batch(p), "batch", failures);
    }
}

// Spheres: |r × v|²/(|v| (a1 + a2))².
PW85_TEST("/closest_passage/spheres")
{
    double mu2 = 7, t = 7;
    double const r12[3] = {-6, 2, 1}, q1[6] = {1, 0, 0, 1, 0, 1}, q2[6] = {4, 0, 0, 4, 0, 4},
                 v[3] = {3, 0, 0};
    g_assert_cmpint(pw85_closest_passage(r12, q1, q2, v, infinity, &mu2, &t), ==, PW85_SUCCESS);
    g_assert_cmpfloat_with_epsilon(mu2, 5.0 / 9, 1e-15);
    g_assert_cmpfloat_with_epsilon(t, 2.0, 1e-15);
    pw85_closest_passage(r12, q1, q2, v, 1.0, &mu2, &t);
    g_assert_cmpfloat_with_epsilon(mu2, 14.0 / 9, 1e-14);
    g_assert_true(t == 1.0);
    double const away[3] = {-3, 0, 0};
    pw85_closest_passage(r12, q1, q2, away, infinity, &mu2, &t);
    g_assert_cmpfloat_with_epsilon(mu2, 41.0 / 9, 1e-14);
    g_assert_true(t == 0.0);
}

// Through the centre μ² is exactly 0, whether the time is a double or not; not if the way ends
// before it.
PW85_TEST("/closest_passage/center")
{
    Failures failures;
    Random random(720);
    for (int n = 0; n < draws(400); ++n) {
        Vector3 r{};
        for (int i = 0; i < 3; ++i) r[i] = std::floor(random.uniform(-9.0, 10.0));
        r[n % 3] = 1 + n % 7;
        Passing p{{r, random.form(1.0, 1e3), random.form(random.log_uniform(1e-3, 1e3), 1e2)},
                  -(1.0 + n % 11) * r,
                  infinity};
        for (auto const &result : {by_one(p), by_batch(p)}) {
            double const t = 1 / (1.0 + n % 11);
            failures.check(result.mu2 == 0.0, "mu2", result.mu2, 0.0, [&] { return text(p); });
            failures.check(std::abs(result.t - t) <= 0x1p-52 * t, "t", result.t, t,
                           [&] { return text(p); });
        }
        p.t_max = 0.5 / (1.0 + n % 11);
        for (auto const &result : {by_one(p), by_batch(p)}) {
            double const quarter = 0.25 * pw85::contact(r, p.pair.q1, p.pair.q2).mu2;
            failures.check(std::abs(result.mu2 / quarter - 1) < 1e-8 && result.t == p.t_max,
                           "half way", result.mu2, quarter, [&] { return text(p); });
        }
    }
}

// Without motion the result is the contact function.
PW85_TEST("/closest_passage/rest")
{
    Random random(730);
    for (int n = 0; n < 50; ++n) {
        auto p = random_passing(random, n, 100.0);
        double const mu2 = pw85::contact(p.pair.r12, p.pair.q1, p.pair.q2).mu2;
        p.t_max = 0;
        g_assert_cmpfloat_with_epsilon(by_one(p).mu2 / mu2, 1.0, 1e-11);
        g_assert_cmpfloat_with_epsilon(by_batch(p).mu2 / mu2, 1.0, 1e-11);
        g_assert_true(by_one(p).t == 0 && by_batch(p).t == 0);
        p.t_max = infinity;
        p.velocity = {0, -0.0, 0};
        g_assert_true(by_one(p).mu2 == mu2 && by_one(p).t == 0 && by_batch(p).mu2 == mu2 &&
                      by_batch(p).t == 0);
        p.pair.r12 = {0, 0, 0};
        p.velocity = {1, 0, 0};
        g_assert_true(by_one(p).mu2 == 0 && by_one(p).t == 0 && by_batch(p).mu2 == 0 &&
                      by_batch(p).t == 0);
    }
}

// Units of length and time change no bit.
PW85_TEST("/closest_passage/units")
{
    Failures failures;
    Random random(740);
    for (int n = 0; n < draws(400); ++n) {
        auto const p = random_passing(random, n, 1e3);
        auto const wanted = by_one(p);
        for (int const e : {-480, -40, 0, 40, 480})
            for (int const et : {-40, 0, 500}) {
                Passing q = p;
                for (int i = 0; i < 3; ++i) {
                    q.pair.r12[i] = std::ldexp(p.pair.r12[i], e);
                    q.velocity[i] = std::ldexp(p.velocity[i], e - et);
                }
                for (int k = 0; k < 6; ++k) {
                    q.pair.q1[k] = std::ldexp(p.pair.q1[k], 2 * e);
                    q.pair.q2[k] = std::ldexp(p.pair.q2[k], 2 * e);
                }
                q.t_max = std::ldexp(p.t_max, et);
                if (std::abs(e - et) > 900) continue;
                auto const result = by_one(q);
                failures.check(result.mu2 == wanted.mu2, "mu2", result.mu2, wanted.mu2,
                               [&] { return text(q); });
                double const t = std::ldexp(wanted.t, et);
                failures.check(result.t == t, "t", result.t, t, [&] { return text(q); });
            }
    }
}

// Sizes 1e±150, and ellipsoids of very different sizes.
PW85_TEST("/closest_passage/extremes")
{
    auto const ball = [](double a) {
        return pw85::SymmetricMatrix<double, 3>{a * a, 0, 0, a * a, 0, a * a};
    };
    for (double const size : {1e-150, 1.0, 1e150})
        for (double const ratio : {1e-150, 1.0, 1e150}) {
            double const a2 = size == ratio ? size : size * ratio, sum = size + a2;
            if (!(a2 * a2 > 0.0 && a2 * a2 < infinity)) continue;
            Passing const p{{{-4 * sum, 3 * sum, 0}, ball(size), ball(a2)}, {sum, 0, 0}, infinity};
            for (auto const &result : {by_one(p), by_batch(p)}) {
                g_assert_cmpfloat_with_epsilon(result.mu2, 9.0, 1e-13);
                g_assert_cmpfloat_with_epsilon(result.t, 4.0, 1e-13);
            }
        }
}

// Ellipsoids that only translate meet if and only if the least μ² is at most 1.
PW85_TEST("/closest_passage/first_contact")
{
    Failures failures;
    Random random(750);
    int meetings = 0, count = draws(2000);
    for (int n = 0; n < count; ++n) {
        auto const p = random_passing(random, n, 10.0);
        pw85::Motion<double, 3> const rest{}, motion{p.velocity, {}, 0.0};
        double const mu2 = by_batch(p).mu2;
        if (std::abs(mu2 - 1) < 1e-9) continue;
        double const t =
            pw85::first_contact(p.pair.r12, p.pair.q1, p.pair.q2, rest, motion, p.t_max).time;
        failures.check((t < infinity) == (mu2 < 1), "first contact", t, mu2,
                       [&] { return text(p); });
        meetings += t < infinity;
    }
    g_assert_cmpint(meetings, >, count / 10);
}

// Many pairs, one of them bad; most are computed in lanes, whose results agree with those of one
// pair.
PW85_TEST("/closest_passage/batch")
{
    Failures failures;
    Random random(760);
    std::vector<Passing> all;
    std::vector<double> r12, q1, q2, v;
    for (int n = 0; n < 1000; ++n) {
        auto p = random_passing(random, n, 4.0);
        p.t_max = 1.5;
        if (n == 600) p.pair.q2[0] = -1;
        all.push_back(p);
        r12.insert(r12.end(), p.pair.r12.coordinates, p.pair.r12.coordinates + 3);
        q1.insert(q1.end(), p.pair.q1.entries, p.pair.q1.entries + 6);
        q2.insert(q2.end(), p.pair.q2.entries, p.pair.q2.entries + 6);
        v.insert(v.end(), p.velocity.coordinates, p.velocity.coordinates + 3);
    }
    std::vector<double> mu2(all.size(), 7), t(all.size(), 7);
    auto const batch = [&](double t_max, double *times) {
        return pw85_closest_passage_batch(all.size(), r12.data(), q1.data(), q2.data(), v.data(),
                                          t_max, mu2.data(), times);
    };
    g_assert_cmpint(batch(1.5, nullptr), ==, PW85_ENOTPD);
    g_assert_cmpint(batch(1.5, t.data()), ==, PW85_ENOTPD);
    for (std::size_t n = 0; n < all.size(); ++n) {
        auto const &p = all[n];
        auto const one = by_one(p);
        if (n == 600) {
            g_assert_true(std::isnan(mu2[n]) && std::isnan(t[n]) && std::isnan(one.mu2) &&
                          std::isnan(one.t));
            continue;
        }
        double const unit = static_cast<double>(change(p, one.t)) * 0x1p-53,
                     size = 1.5 + std::abs(one.t);
        failures.check(std::abs(mu2[n] - one.mu2) <= 16 * unit, "mu2", mu2[n], one.mu2,
                       [&] { return text(p); });
        failures.check(std::abs(t[n] - one.t) <= 1e-11 * size, "t", t[n], one.t,
                       [&] { return text(p); });
    }
    g_assert_cmpint(batch(-1.0, t.data()), ==, PW85_EINVAL);
    g_assert_true(std::isnan(mu2[0]) && std::isnan(t[999]));
    g_assert_cmpint(batch(std::nan(""), t.data()), ==, PW85_EINVAL);
}

PW85_ADD_TEST("/closest_passage/random/float", test_type<float>);
PW85_ADD_TEST("/closest_passage/random/long_double", test_type<long double>);

} // namespace
