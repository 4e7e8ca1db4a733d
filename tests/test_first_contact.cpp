// SPDX-License-Identifier: BSD-3-Clause
// Tests of the time of first contact.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/batch.hpp>
#include <pw85/systems.hpp>
#include <pw85_batch.h>
#include <pw85_systems.h>

#include "cases.hpp"
#include "draws.hpp"
#include "flights.hpp"
#include "systems.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;
constexpr double infinity = std::numeric_limits<double>::infinity();

pw85::SymmetricMatrix<double, 3> sphere(double radius)
{
    double const square = radius * radius;
    return {square, 0.0, 0.0, square, 0.0, square};
}

// μ = 1 at the time given, to what pw85.h says.
template <int D> void check_touch(Failures &failures, Flight<double, D> const &f, double time)
{
    auto const wide = convert_flight<Wide>(f);
    Wide const error = abs(Wide(mu2_at(wide, Wide(time)) - 1)),
               bound = touching_error * u * sensitivity(wide, Wide(time));
    failures.check(error <= bound, "μ² - 1", static_cast<double>(error), static_cast<double>(bound),
                   [&] { return flight_text(f); });
}

template <int D> void check_touching(int flights, Moving moving)
{
    Failures failures;
    Random random(520 + D + (moving == Moving::all ? 10 : 0));
    for (int n = 0; n < flights; ++n) {
        auto const f = random_flight<D>(random, random.log_uniform(1.0, 30.0), moving);
        double const time = first_contact(f).time;
        if (time < infinity) check_touch(failures, f, time);
    }
}

PW85_TEST("/first_contact/translation/touching")
{
    check_touching<3>(300, Moving::centres);
    check_touching<2>(300, Moving::centres);
}

PW85_TEST("/first_contact/motion/touching")
{
    check_touching<3>(300, Moving::all);
    check_touching<2>(300, Moving::all);
}

// A contact that is returned is one, and no end of the time after it changes a bit of it.
template <int D> void check_slender(int flights)
{
    Failures failures;
    Random random(526 + D);
    int hits = 0;
    for (int n = 0; n < flights; ++n) {
        auto const f = in_units(slender_flight<D>(random, random.log_uniform(1e2, 1e7), 0.02),
                                40 * (n % 3 - 1), 7 * (n % 5));
        auto const c = first_contact(f);
        failures.check(c.status == pw85::Status::success, "status", c.time, 0.0,
                       [&] { return flight_text(f); });
        if (!(c.time < infinity) || c.time == 0.0) continue;
        ++hits;
        check_touch(failures, f, c.time);
        for (double const end : {1.0 - 0x1p-40, 1.0, 1.125, 2.0, 64.0, infinity}) {
            auto longer = f;
            longer.end = end * c.time;
            double const time = first_contact(longer).time,
                         expected = end < 1.0 ? infinity : c.time;
            failures.check(time == expected, "depends on the end", time, expected,
                           [&] { return flight_text(longer); });
        }
    }
    g_assert_cmpint(hits, >, flights / 3);
}

PW85_TEST("/first_contact/slender")
{
    check_slender<3>(draws(600));
    check_slender<2>(draws(200));
}

// A needle that spins at a disc that passes. At a time at which μ² is 1.75e7 the rounding errors of
// f are larger than 1.
PW85_TEST("/first_contact/needle_and_disc")
{
    Flight<double, 3> f{{{0x1.dd067bd5825afp+0, -0x1.2a3a54dfaf9d0p-1, -0x1.62df24a41bb9bp+0},
                         {0x1.b929f2125fca9p-2, -0x1.bbd4a6324dd67p-3, 0x1.c7f03b134b22cp-2,
                          0x1.be837ad7b83b0p-4, -0x1.cab1cc50b5829p-3, 0x1.d7352f3b21c2ap-2},
                         {0x1.569927c2763cep-1, 0x1.991c228fee02ap-2, -0x1.fd05d5d1a6512p-3,
                          0x1.08ff3ef3f8978p-1, 0x1.335377e1b695fp-2, 0x1.a067994a6d12ap-1}},
                        {{}, {4.407170478251845, -4.827230428105657, -4.351934395057262}, 0.0},
                        {{-0.8615687860397974, 0.23043762658374264, 0.7535779315272126},
                         {0.09001305319356734, -0.14148190462668336, -0.21887727185324282},
                         0.0},
                        0.0};
    for (double const end : {1.5, 1.6, 2.0, 3.0, 5.0, infinity}) {
        f.end = end;
        double const time = first_contact(f).time;
        g_assert_true(end < 1.52 ? time == infinity : std::fabs(time - 1.52008825738) < 1e-8);
    }
}

/// Lets a flight start earlier, and its rotations with it.
template <int D> void start_earlier(Flight<double, D> &f, double earlier)
{
    auto const v = f.motion2.velocity - f.motion1.velocity;
    f.start.r12 = pw85::detail::add_scaled(f.start.r12, -earlier, v);
    f.end += earlier;
    for (auto *m : {&f.motion1, &f.motion2}) {
        m->angular_velocity = 1.0 / (1.0 + earlier) * m->angular_velocity;
        m->growth = m->growth / (1.0 + earlier);
    }
}

// From any distance, in units in which pairs are scaled and in others, and for any sizes, a contact
// is found where there is one.
template <int D> void check_afar(int flights, Moving moving, double farthest)
{
    Failures failures;
    Random random(530 + D + (moving == Moving::all ? 10 : 0));
    int hits = 0;
    for (int n = 0; n < flights; ++n) {
        auto f = random_flight<D>(random, random.log_uniform(1.0, 30.0), moving);
        auto const v = f.motion2.velocity - f.motion1.velocity;
        start_earlier(f, random.log_uniform(1.0, farthest) / norm(v));
        if (n % 3 == 0) f = in_units(f, -40, 0);
        if (mu2_at(f, 0.0) < 1.0) continue; // they have come from where they overlap
        double const time = first_contact(f).time,
                     expected = static_cast<double>(first_contact(convert_flight<Wide>(f)).time);
        failures.check((time < infinity) == (expected < infinity), "afar", time, expected,
                       [&] { return flight_text(f); });
        if (time < infinity) check_touch(failures, f, time), ++hits;
    }
    g_assert_cmpint(hits, >, flights / 10);
}

PW85_TEST("/first_contact/afar")
{
    for (auto const moving : {Moving::centres, Moving::all}) {
        check_afar<3>(200, moving, 1e8);
        check_afar<2>(200, moving, 1e8);
    }
}

// From so far that the rounding of a position is larger than the ellipsoids: only one of them
// moves, so that the numbers given say exactly whether they meet.
PW85_TEST("/first_contact/remote")
{
    Failures failures;
    Random random(531);
    for (int n = 0; n < draws(300); ++n) {
        double const distance = random.log_uniform(1e9, 1e150),
                     size = n % 4 == 0 ? random.log_uniform(1e-150, 1.0) : 1.0;
        auto const toward = distance * random.direction<3>();
        Flight<double, 3> f{{toward, sphere(size * random.uniform(0.5, 1.0)),
                             sphere(size * random.uniform(0.5, 1.0))},
                            {},
                            {},
                            2.0};
        f.motion2.velocity = -toward;
        if (n % 2 == 0) f.motion1.angular_velocity = random.direction<3>();
        if (n % 3 == 0)
            f.start.r12[0] += random.log_uniform(1e-3, 1e3) * std::fmax(size, 1e-16 * distance);
        auto const time = first_contact(f).time;
        auto const expected = static_cast<double>(first_contact(convert_flight<Wide>(f)).time);
        failures.check(time == expected || std::fabs(time - expected) <= 8 * u * expected, "remote",
                       time, expected, [&] { return flight_text(f); });
    }
}

// Spheres: |r + v t| = (1 + g1 t) a + (1 + g2 t) b is a quadratic equation.
PW85_TEST("/first_contact/spheres")
{
    Failures failures;
    Random random(540);
    for (int n = 0; n < draws(3000); ++n) {
        auto f = random_flight<3>(random, 1.0, n % 2 == 0 ? Moving::centres : Moving::all);
        double const a = random.uniform(0.5, 1.0), b = random.uniform(0.1, 1.0);
        f.start = {(a + b) * random.uniform(1.1, 3.0) * random.direction<3>(), sphere(a),
                   sphere(b)};
        auto const v = f.motion2.velocity - f.motion1.velocity;
        double const rate = a * f.motion1.growth + b * f.motion2.growth;
        double const half = -(pw85::dot(f.start.r12, v) - (a + b) * rate),
                     square = pw85::dot(v, v) - rate * rate,
                     excess = pw85::dot(f.start.r12, f.start.r12) - (a + b) * (a + b);
        double const root = half * half - square * excess;
        double const expected = root >= 0.0 && half + std::sqrt(root) > 0.0
                                    ? excess / (half + std::sqrt(root))
                                    : infinity;
        if (std::fabs(root) < 1e-3 * half * half || std::fabs(expected - f.end) < 1e-9)
            continue; // grazing, or at the end
        double const time = first_contact(f).time;
        bool const hits = expected <= f.end;
        failures.check(hits ? std::fabs(time - expected) <= 1e-12 * expected + 1e-13
                            : time == infinity,
                       "time", time, expected, [&] { return flight_text(f); });
    }
}

// A grain of dust and a globe, whose squared ratio is beyond the range of double.
PW85_TEST("/first_contact/sizes")
{
    Sample<double, 3> const spheres{{3e120, 0.0, 0.0}, sphere(1e-120), sphere(1e120)};
    pw85::Motion<double, 3> const coming{{-1e120, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0}, still{};
    for (auto const &[motion1, motion2] :
         {std::pair{still, coming},
          std::pair{pw85::Motion<double, 3>{{1e120, 0.0, 0.0}, {}, 0.0}, still}}) {
        double const time = first_contact(Flight<double, 3>{spheres, motion1, motion2, 10.0}).time;
        g_assert_cmpfloat(std::fabs(time - 2.0), <=, 1e-14);
    }
}

// Rods turning about the z axis, |r| apart: one stands across, and the other sweeps until it
// touches. At the end of a quarter turn the tips meet where the sum of the lengths is the distance;
// and spheroids that turn about their own axes do not change.
PW85_TEST("/first_contact/turning")
{
    Sample<double, 3> const rods{
        {3.0, 0.0, 0.0}, {0.01, 0.0, 0.0, 4.0, 0.0, 0.01}, {0.01, 0.0, 0.0, 1.0, 0.0, 0.01}};
    pw85::Motion<double, 3> const turning{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}, 0.0}, still{};
    auto const both = first_contact(Flight<double, 3>{rods, turning, turning, 10.0});
    // grazing: the root of u
    g_assert_cmpfloat(std::fabs(both.time - 3.1415926535897931), <=, 1e-7);
    auto const short_of = first_contact(Flight<double, 3>{rods, turning, turning, 3.0});
    g_assert_true(short_of.time == infinity);
    Sample<double, 3> const near{{2.9, 0.0, 0.0}, rods.q1, rods.q2},
        far{{3.001, 0.0, 0.0}, rods.q1, rods.q2};
    auto const earlier = first_contact(Flight<double, 3>{near, turning, turning, 10.0});
    g_assert_cmpfloat(earlier.time, <, 3.13);
    g_assert_true(first_contact(Flight<double, 3>{far, turning, turning, 100.0}).time == infinity);
    Sample<double, 3> const side_by_side{
        {3.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 16.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 4.0, 0.0, 1.0}};
    pw85::Motion<double, 3> const spinning{{0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, 0.0},
        coming{{-0.25, 0.0, 0.0}, {0.0, 5.0, 0.0}, 0.0};
    g_assert_cmpfloat(
        std::fabs(first_contact(Flight<double, 3>{side_by_side, spinning, coming, 10.0}).time -
                  4.0),
        <=, 1e-13);
    g_assert_true(first_contact(Flight<double, 3>{side_by_side, spinning, still, 10.0}).time ==
                  infinity);
}

// Overlapping pairs touch at once, whatever their motion.
PW85_TEST("/first_contact/overlapping")
{
    Failures failures;
    Random random(550);
    for (int n = 0; n < draws(2000); ++n) {
        auto f = random_flight<3>(random, 10.0, n % 2 == 0 ? Moving::centres : Moving::all);
        f.start = random_pair<3>(random, {.aspect = 10.0, .mu2_min = 1e-4, .mu2_max = 1.0 - 1e-10});
        double const time = first_contact(f).time;
        failures.check(time == 0.0, "overlapping", time, 0.0, [&] { return flight_text(f); });
    }
    Flight<double, 3> concentric{{{0.0, 0.0, 0.0}, sphere(1.0), sphere(2.0)}, {}, {}, 1.0};
    g_assert_cmpfloat(first_contact(concentric).time, ==, 0.0);
    concentric.motion1.growth = 1.0;
    g_assert_cmpfloat(first_contact(concentric).time, ==, 0.0);
}

// A pair that touches to rounding is in contact if it approaches or rests, and not if it separates:
// what collides does not collide again at once.
PW85_TEST("/first_contact/after_collision")
{
    Failures failures;
    Random random(560);
    for (int n = 0; n < draws(2000); ++n) {
        auto f = random_flight<3>(random, 10.0, n % 2 == 0 ? Moving::centres : Moving::all);
        auto const c = first_contact(f);
        if (!(c.time < infinity) || c.time < 1e-3) continue;
        auto const p = pair_at(f, c.time);
        double const normal_rate = (mu2_at(f, c.time) - mu2_at(f, c.time - 1e-6)) / 1e-6;
        if (!(normal_rate < -1e-3)) continue;
        auto const opposite = [](pw85::Motion<double, 3> const &m) {
            return pw85::Motion<double, 3>{-m.velocity, -m.angular_velocity, -m.growth};
        };
        Flight<double, 3> const on{p, f.motion1, f.motion2, 1.0};
        Flight<double, 3> const back{p, opposite(f.motion1), opposite(f.motion2), 0.5 * c.time};
        failures.check(first_contact(on).time <= 1e-9, "closing", first_contact(on).time, 0.0,
                       [&] { return flight_text(on); });
        failures.check(first_contact(back).time > 1e-6, "separating", first_contact(back).time,
                       infinity, [&] { return flight_text(back); });
    }
}

// Spheres that pass each other at the distance of contact touch; farther by more than rounding they
// do not.
PW85_TEST("/first_contact/grazing")
{
    for (double const growth : {0.0, 0x1p-60}) { // by either way
        pw85::Motion<double, 3> const still{}, passing{{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, growth};
        auto const time = [&](double height) {
            Sample<double, 3> const p{{4.0, height, 0.0}, sphere(1.0), sphere(1.0)};
            return first_contact(Flight<double, 3>{p, still, passing, 100.0}).time;
        };
        g_assert_cmpfloat(std::fabs(time(2.0) - 4.0), <=, 1e-6);
        g_assert_cmpfloat(std::fabs(time(2.0 + 0x1p-51) - 4.0), <=, 1e-6);
        g_assert_cmpfloat(time(2.0 - 1e-12), <, 4.0);
        g_assert_true(time(2.0 + 1e-12) == infinity);
    }
}

// Powers of two on all lengths, and on all times, change nothing but the units, not a bit;
// exchanging the ellipsoids only rounding.
PW85_TEST("/first_contact/units")
{
    Failures failures;
    Random random(570);
    for (int n = 0; n < draws(1000); ++n) {
        auto const f = random_flight<3>(random, 10.0, n % 2 == 0 ? Moving::centres : Moving::all);
        double const time = first_contact(f).time;
        for (int const length : {-480, -100, 100, 480})
            for (int const unit : {-400, 0, 400}) {
                auto const g = in_units(f, length, unit);
                double const scaled = std::ldexp(first_contact(g).time, -unit);
                failures.check(scaled == time, "unit", scaled, time,
                               [&] { return flight_text(g); });
            }
        Flight<double, 3> const exchanged{
            {-f.start.r12, f.start.q2, f.start.q1}, f.motion2, f.motion1, f.end};
        double const other = first_contact(exchanged).time;
        failures.check(other == time || std::fabs(other - time) <= 1e-9 * time, "exchange", other,
                       time, [&] { return flight_text(f); });
    }
}

// The root of the polynomial of extent() and its remainder bound the root of the form of a body
// that turns and grows. Vectors along the axis, and such that the rotation leaves little of the
// third order, make the growth's part of the remainder the largest.
PW85_TEST("/first_contact/remainder")
{
    Failures failures;
    Random random(605);
    for (int n = 0; n < draws(2000); ++n) {
        auto const axis = random.direction<3>();
        auto const q = pw85::spheroid(1.0, random.log_uniform(1.0, 10.0), axis).q;
        pw85::Motion<double, 3> const motion{{}, random.direction<3>(), random.uniform(-0.9, 1.0)};
        auto const body = pw85::detail::to_body(q, motion, {});
        auto const s1 = n % 2 == 0 ? 1.0 / 3.0 * pw85::detail::turning(body.omega, axis)
                                   : random.direction<3>();
        auto const path = pw85::detail::normal_path(axis, s1);
        auto const e = pw85::detail::extent(
            body, path, pw85::detail::respond(body, axis, pw85::product(body.rest, axis)));
        double const x = random.uniform(0.1, 1.0), size = 1.0 + body.growth * x;
        // of the same vector in the frame of the ellipsoid
        auto const opposite = turned_form(q, motion, x);
        auto const s = pw85::detail::add_scaled(axis, x, s1);
        double const all = pw85::dot(s, pw85::product(opposite, s)),
                     same = body.least * size * size * pw85::dot(s, s);
        double polynomial = -same;
        for (int k = 4; k >= 0; --k) polynomial += e.square[k] * std::pow(x, k);
        double const difference = std::fabs(std::sqrt(std::fmax(0.0, all - same)) -
                                            std::sqrt(std::fmax(0.0, polynomial)));
        double const bound = e.remainder * x * x * x + 1e-7; // a root of rounding
        failures.check(difference <= bound, "remainder", difference, bound, [&] {
            return "q = " + hex_text(q.entries, 6) + ", s1 = " + hex_text(s1.coordinates, 3) +
                   ", x = " + hex_text(&x, 1) + ", motion = " + motion_text(motion);
        });
    }
}

// No difference of like numbers: 1e-15 + 2x - 3x² has the root 2/3, of an excess that is rounding.
PW85_TEST("/first_contact/first_root")
{
    double const excess = 1e-15, time = pw85::detail::first_root(excess, -1.0, -3.0, 0.0);
    g_assert_cmpfloat(std::fabs(time - 2.0 / 3.0), <=, 1e-14);
    g_assert_cmpfloat(std::fabs(pw85::detail::first_root(1.0, 1e8, 1.0, 0.0) - 5e-9), <=, 1e-23);
}

// Products that cancel leave a difference that is right to rounding, however small it is.
PW85_TEST("/first_contact/difference_of_products")
{
    Failures failures;
    Random random(606);
    for (int n = 0; n < draws(3000); ++n) {
        double const a = random.uniform(0.5, 2.0), b = random.uniform(0.5, 2.0),
                     c = random.uniform(0.5, 2.0),
                     d = n % 3 == 0   ? a * b / c
                         : n % 3 == 1 ? random.uniform(0.5, 2.0)
                                      : b;
        double const e = n % 3 == 2 ? a : c,
                     difference = pw85::detail::difference_of_products(a, b, e, d),
                     exact = static_cast<double>(Wide(Wide(a) * b - Wide(e) * d));
        failures.check(
            std::fabs(difference - exact) <= 4 * u * std::fabs(exact), "difference", difference,
            exact,
            [&] { return hex_text(&a, 1) + hex_text(&b, 1) + hex_text(&e, 1) + hex_text(&d, 1); });
    }
}

template <class T, int D> void check_scalar(Failures &failures, Flight<double, D> const &f)
{
    auto const narrow = convert_flight<T>(f);
    auto const time = first_contact(narrow).time;
    if (!(time < std::numeric_limits<T>::infinity()) || time == T(0)) return;
    auto const wide = convert_flight<Wide>(narrow);
    Wide const error = abs(Wide(mu2_at(wide, Wide(time)) - 1));
    Wide const bound =
        touching_error * Wide(pw85::detail::unit_roundoff<T>()) * sensitivity(wide, Wide(time));
    failures.check(error <= bound, "μ² - 1", static_cast<double>(error), static_cast<double>(bound),
                   [&] { return flight_text(f); });
}

PW85_TEST("/first_contact/scalars")
{
    Failures failures;
    Random random(580);
    for (int n = 0; n < 200; ++n) {
        auto const f = random_flight<3>(random, 5.0, n % 2 == 0 ? Moving::centres : Moving::all);
        check_scalar<float>(failures, f);
        check_scalar<long double>(failures, f);
        check_scalar<float>(failures,
                            slender_flight<3>(random, random.log_uniform(10.0, 300.0), 0.1));
        check_scalar<float>(failures,
                            slender_flight<2>(random, random.log_uniform(10.0, 300.0), 0.1));
    }
}

// Extreme sizes, shapes and rates: an answer, and no garbage.
PW85_TEST("/first_contact/extremes")
{
    Failures failures;
    Random random(590);
    for (int n = 0; n < draws(2000); ++n) {
        auto const magnitude = [&] { return random.log_uniform(1e-140, 1e140); };
        auto const motion = [&] {
            pw85::Motion<double, 3> m{magnitude() * random.direction<3>(), {}, 0.0};
            if (n % 2 == 0) return m;
            m.angular_velocity = magnitude() * random.direction<3>();
            m.growth = magnitude();
            return m;
        };
        double const aspect = random.log_uniform(1.0, 1e6);
        Flight<double, 3> const f{{magnitude() * random.direction<3>(),
                                   random.form(magnitude(), aspect),
                                   random.form(magnitude(), aspect)},
                                  motion(),
                                  motion(),
                                  n % 3 == 0 ? infinity : magnitude()};
        auto const c = first_contact(f);
        bool const ok = c.status == pw85::Status::success
                            ? c.time >= 0.0 && (c.time <= f.end || c.time == infinity)
                            : c.status == pw85::Status::no_convergence && std::isnan(c.time);
        failures.check(ok, "time", c.time, static_cast<double>(static_cast<int>(c.status)),
                       [&] { return flight_text(f); });
    }
}

// A periodic list: the times are those of single pairs, and next events the least of each particle.
PW85_TEST("/first_contact/lists")
{
    Failures failures;
    Random random(600);
    constexpr std::size_t n = 40;
    double const side = 6.0, cell[9] = {side, 0.0, 0.0, 0.0, side, 0.0, 0.0, 0.0, side};
    std::vector<double> centers, forms;
    std::vector<pw85_motion> motions;
    std::vector<int32_t> pairs;
    for (std::size_t i = 0; i < n; ++i) {
        for (int d = 0; d < 3; ++d) centers.push_back(random.uniform(0.0, side));
        auto const q = random.form(0.5, 3.0);
        forms.insert(forms.end(), q.entries, q.entries + 6);
        motions.push_back(
            c_motion(random_motion<3>(random, 1.0, i < n / 2 ? Moving::centres : Moving::all)));
        for (std::size_t j = 0; j < i; ++j)
            pairs.insert(pairs.end(), {static_cast<int32_t>(i), static_cast<int32_t>(j)});
    }
    std::size_t const num_pairs = pairs.size() / 2;
    std::vector<double> t(num_pairs), next(n), r12, q1, q2, t_batch(num_pairs);
    std::vector<pw85_motion> motion1, motion2;
    std::vector<int64_t> next_pair(n);
    g_assert_cmpint(pw85_first_contact_pairs(list_of(num_pairs, pairs.data()),
                                             system_of(n, centers.data(), forms.data(), cell),
                                             motions.data(), 2.0, t.data(), next.data(),
                                             next_pair.data()),
                    ==, PW85_SUCCESS);
    std::vector<double> least(n, infinity);
    std::vector<int32_t> images;
    for (std::size_t k = 0; k < num_pairs; ++k) {
        auto const i = static_cast<std::size_t>(pairs[2 * k]),
                   j = static_cast<std::size_t>(pairs[2 * k + 1]);
        for (std::size_t d = 0; d < 3; ++d) {
            double const along = centers[3 * j + d] - centers[3 * i + d];
            images.push_back(-static_cast<int32_t>(std::lround(along / side)));
            r12.push_back(along + images.back() * side);
        }
        q1.insert(q1.end(), forms.begin() + static_cast<std::ptrdiff_t>(6 * i),
                  forms.begin() + static_cast<std::ptrdiff_t>(6 * i + 6));
        q2.insert(q2.end(), forms.begin() + static_cast<std::ptrdiff_t>(6 * j),
                  forms.begin() + static_cast<std::ptrdiff_t>(6 * j + 6));
        motion1.push_back(motions[i]);
        motion2.push_back(motions[j]);
        for (std::size_t const particle : {i, j})
            least[particle] = std::fmin(least[particle], t[k]);
    }
    g_assert_cmpint(pw85_first_contact_batch(num_pairs, r12.data(), q1.data(), q2.data(),
                                             motion1.data(), motion2.data(), 2.0, t_batch.data()),
                    ==, PW85_SUCCESS);
    auto const text = [] { return std::string(); };
    for (std::size_t k = 0; k < num_pairs; ++k) {
        bool const same = t[k] == t_batch[k] || std::fabs(t[k] - t_batch[k]) <= 1e-12;
        failures.check(same, "list and batch", t[k], t_batch[k], text);
    }
    for (std::size_t i = 0; i < n; ++i) {
        failures.check(next[i] == least[i], "next event", next[i], least[i], text);
        bool const none = next_pair[i] == -1;
        failures.check(none ? next[i] == infinity
                            : t[static_cast<std::size_t>(next_pair[i])] == next[i],
                       "next pair", next[i], static_cast<double>(next_pair[i]), text);
    }
    std::vector<double> again(num_pairs);
    g_assert_cmpint(pw85_first_contact_pairs(list_of(num_pairs, pairs.data(), images.data()),
                                             system_of(n, centers.data(), forms.data(), cell),
                                             motions.data(), 2.0, again.data(), nullptr, nullptr),
                    ==, PW85_SUCCESS);
    pw85::Vectors const vectors(reinterpret_cast<pw85::Vector<double, 3> const *>(centers.data()),
                                n);
    pw85::Forms const q(reinterpret_cast<pw85::SymmetricMatrix<double, 3> const *>(forms.data()),
                        n);
    std::span const moving(reinterpret_cast<pw85::Motion<double, 3> const *>(motions.data()), n);
    pw85::Cell const rows{{{side, 0.0, 0.0}, {0.0, side, 0.0}, {0.0, 0.0, side}}};
    std::span const listed(reinterpret_cast<pw85::IndexPair const *>(pairs.data()), num_pairs);
    std::vector<double> in_cpp(num_pairs), next_in_cpp(n);
    g_assert_true(pw85::first_contact_pairs({listed}, {vectors, q, &rows}, moving, 2.0,
                                            {in_cpp, next_in_cpp}) == pw85::Status::success);
    g_assert_true(in_cpp == t && next_in_cpp == next);
    g_assert_true(pw85::first_contact_pairs({listed}, {vectors, q, &rows}, moving.first(n - 1), 2.0,
                                            {in_cpp}) == pw85::Status::invalid_argument);
    for (std::size_t k = 0; k < num_pairs; ++k)
        failures.check(again[k] == t[k] || std::fabs(again[k] - t[k]) <= 1e-12, "images", again[k],
                       t[k], text);
}

// What leaves the range of double on the way is an error, never a wrong time; what stays in it is
// right.
PW85_TEST("/first_contact/limits")
{
    pw85::Motion<double, 3> const still{}, growing{{}, {}, 1.0},
        spinning{{}, {0.0, 0.0, 1e-308}, 0.0};
    auto const moving = [](double speed, double rate) {
        return pw85::Motion<double, 3>{{speed, 0.0, 0.0}, {0.0, 0.0, rate}, 0.0};
    };
    auto const spheres = [](double distance, double radius) {
        return Sample<double, 3>{{distance, 0.0, 0.0}, sphere(radius), sphere(radius)};
    };
    auto const rod = pw85::spheroid(1.0, 2.0, pw85::Vector<double, 3>{1.0, 0.0, 0.0}).q;
    struct {
        char const *what;
        Flight<double, 3> flight;
        double time; ///< NaN for PW85_ECONVERGENCE
    } const cases[] = {
        {"relative velocity",
         {spheres(3.0, 1.0), moving(1.7e308, 0.0), moving(-1.7e308, 0.0), infinity},
         NAN},
        {"time", {spheres(3e10, 1.0), still, moving(-1e-308, 0.0), infinity}, NAN},
        {"time of motion", {spheres(3e10, 1.0), spinning, moving(-1e-308, 0.0), infinity}, NAN},
        {"size", {spheres(1e200, 1.0), growing, growing, infinity}, NAN},
        {"orientation", {{{1e30, 0.0, 0.0}, rod, rod}, still, moving(-1.0, 1.0), infinity}, NAN},
        {"distance over size", {spheres(1e160, 1e-150), still, moving(-1.0, 0.0), infinity}, NAN},
        {"never", {spheres(1e160, 1e-150), still, moving(1.0, 0.0), infinity}, infinity},
        {"nothing moves", {spheres(1e160, 1e-150), still, still, infinity}, infinity},
        {"turns only", {spheres(1e160, 1e-150), still, moving(0.0, 1.0), infinity}, infinity},
        {"far", {spheres(1e150, 1e-150), still, moving(-1e150, 0.0), infinity}, 1.0},
        {"far, turning", {spheres(1e150, 1e-150), spinning, moving(-1e150, 0.0), infinity}, 1.0},
        {"far, growing", {spheres(1e140, 1.0), growing, growing, infinity}, 5e139},
        {"grows by 1e9", {spheres(2e8, 1.0), growing, growing, infinity}, 99999999.0},
        {"small and growing", {spheres(2.0, 1e-4), growing, growing, infinity}, 9999.0},
        {"deep overlap", {spheres(1e-150, 1e150), moving(1e150, 1.0), growing, infinity}, 0.0},
        {"deep overlap of translation",
         {spheres(1e-150, 1e150), moving(1e150, 0.0), still, infinity},
         0.0},
    };
    Failures failures;
    for (auto const &[what, flight, expected] : cases) {
        auto const c = first_contact(flight);
        bool const ok =
            std::isnan(expected)
                ? c.status == pw85::Status::no_convergence && std::isnan(c.time)
                : c.status == pw85::Status::success &&
                      (c.time == expected || std::fabs(c.time - expected) <= 8 * u * expected);
        failures.check(ok, what, c.time, expected,
                       [&motion = flight] { return flight_text(motion); });
    }
}

PW85_TEST("/first_contact/statuses")
{
    double const r12[3] = {3.0, 0.0, 0.0}, q[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
                 nan = std::numeric_limits<double>::quiet_NaN();
    pw85_motion const still{}, closing{{-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0};
    auto const expect = [&](int expected, double time, pw85_motion const *motion, double end) {
        double t = 7.0;
        g_assert_cmpint(pw85_first_contact(r12, q, q, &still, motion, end, &t), ==, expected);
        g_assert_true(std::isnan(time) ? std::isnan(t) : t == time);
    };
    expect(PW85_SUCCESS, 1.0, &closing, infinity);
    expect(PW85_SUCCESS, 1.0, &closing, 1.0);
    expect(PW85_SUCCESS, infinity, &closing, 0.5);
    expect(PW85_SUCCESS, infinity, &still, infinity);
    expect(PW85_EINVAL, nan, &closing, -1.0);
    pw85_motion const shrinking{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, -0.5};
    expect(PW85_SUCCESS, infinity, &shrinking, 1.5);
    expect(PW85_EINVAL, nan, &shrinking, 2.0);
    expect(PW85_EINVAL, nan, &shrinking, infinity);
    // Two rods that turn within reach of each other: in line they meet, across they never do.
    double const rod[6] = {1e-6, 0.0, 0.0, 4.0, 0.0, 1e-6},
                 across[6] = {4.0, 0.0, 0.0, 1e-6, 0.0, 1e-6};
    pw85_motion const turning{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.0};
    double t = 7.0;
    g_assert_cmpint(pw85_first_contact(r12, rod, rod, &turning, &turning, infinity, &t), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_first_contact(r12, rod, across, &turning, &turning, infinity, &t), ==,
                    PW85_ECONVERGENCE);
    g_assert_true(std::isnan(t));
    g_assert_cmpint(pw85_first_contact(r12, q, q, &still, &closing, 1.0, nullptr), ==, PW85_EINVAL);
    // Lists: no pairs, no events; whole calls that are wrong write nothing.
    double next[2] = {7.0, 7.0};
    int64_t next_pair[2] = {7, 7};
    g_assert_cmpint(pw85_first_contact_pairs(list_of(0, nullptr),
                                             system_of(2, nullptr, nullptr, nullptr), nullptr, 1.0,
                                             nullptr, next, next_pair),
                    ==, PW85_SUCCESS);
    g_assert_true(next[0] == infinity && next[1] == infinity && next_pair[0] == -1 &&
                  next_pair[1] == -1);
    int32_t const outside[2] = {0, 2};
    double const centers[6] = {0.0, 0.0, 0.0, 3.0, 0.0, 0.0},
                 forms[12] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    pw85_motion const motions[2] = {still, closing};
    t = 7.0;
    g_assert_cmpint(pw85_first_contact_pairs(list_of(1, outside),
                                             system_of(2, centers, forms, nullptr), motions, 1.0,
                                             &t, nullptr, nullptr),
                    ==, PW85_EINVAL);
    int32_t const inside[2] = {0, 1};
    g_assert_cmpint(pw85_first_contact_pairs(list_of(1, inside),
                                             system_of(2, centers, forms, nullptr), nullptr, 1.0,
                                             &t, nullptr, nullptr),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_first_contact_pairs(list_of(1, inside),
                                             system_of(2, centers, forms, nullptr), motions, 1.0,
                                             &t, nullptr, next_pair),
                    ==, PW85_EINVAL);
    g_assert_cmpfloat(t, ==, 7.0);
    g_assert_cmpint(pw85_first_contact_pairs(list_of(1, inside),
                                             system_of(2, centers, forms, nullptr), motions, 1.0,
                                             &t, next, next_pair),
                    ==, PW85_SUCCESS);
    g_assert_true(t == 1.0 && next[1] == 1.0 && next_pair[0] == 0);
}

} // namespace
