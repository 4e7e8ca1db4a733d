// SPDX-License-Identifier: BSD-3-Clause
// The library misses no first contact. The test follows each motion in long double up to the time
// that the library returns, with steps from an independent bound on the speed. `test_motion_truth
// MOTIONS` takes more motions than the test does.
#include <cstdio>
#include <cstdlib>
#include <limits>

#include <glib.h>

#include "flights.hpp"

using namespace pw85_tests;

namespace {

using Real = long double;

/// Motions of each kind, in three dimensions; half as many in two.
int motions = 150;

/// μ², and how far the ellipsoids are apart at least, over the sum of their half-widths, along the
/// normal.
struct Gap {
    Real mu2, gap, width;
};

template <int D> Gap gap_at(Flight<Real, D> const &f, Real time)
{
    auto const p = pair_at(f, time);
    auto const c = pw85::contact(p.r12, p.q1, p.q2);
    auto const n = pw85::contact_geometry(p.r12, p.q1, p.q2, c.lambda).normal;
    Real const width = std::sqrt(pw85::detail::quadratic_form(p.q1, n)) +
                       std::sqrt(pw85::detail::quadratic_form(p.q2, n));
    return {c.mu2, pw85::dot(n, p.r12) - width, width};
}

/// What rounding may change μ² by at some time, by pw85.h.
template <int D> Real rounding(Flight<Real, D> const &f, Real time)
{
    return static_cast<Real>(touching_error) * 0x1p-53L * sensitivity(f, time);
}

/// The largest semi-axis up to the end, at most, times the rate at which what is on it moves about
/// the centre.
template <int D> Real speed_of_surface(pw85::SymmetricMatrix<Real, D> const &q,
                                       pw85::Motion<Real, D> const &m, Real end)
{
    Real trace = 0;
    for (int i = 0; i < D; ++i) trace += q(i, i);
    return std::sqrt(trace) * (norm(m.angular_velocity) * (1 + std::fmax(Real(0), m.growth) * end) +
                               std::fabs(m.growth));
}

/// The speed at which surfaces approach, at most.
template <int D> Real top_speed(Flight<Real, D> const &f)
{
    Real square = 0;
    for (int i = 0; i < D; ++i) {
        Real const v = f.motion2.velocity[i] - f.motion1.velocity[i];
        square += v * v;
    }
    return std::sqrt(square) + speed_of_surface(f.start.q1, f.motion1, f.end) +
           speed_of_surface(f.start.q2, f.motion2, f.end);
}

/// By how much μ² is below 1 beyond rounding.
template <int D> Real depth_at(Flight<Real, D> const &f, Real time)
{
    Real const mu2 = gap_at(f, time).mu2;
    return mu2 < 1 ? 1 - mu2 - rounding(f, time) : -1;
}

/// The time of the smallest μ² between two, by golden section.
template <int D> Real time_of_minimum(Flight<Real, D> const &f, Real a, Real b)
{
    Real const ratio = 0.61803398874989485L;
    for (int n = 0; n < 40; ++n) {
        Real const x = b - ratio * (b - a), y = a + ratio * (b - a);
        (gap_at(f, x).mu2 < gap_at(f, y).mu2 ? b : a) = gap_at(f, x).mu2 < gap_at(f, y).mu2 ? y : x;
    }
    return (a + b) / 2;
}

/// The largest depth from 0 to a time. A step is as long as the gap lasts at top speed, and at
/// least as long as a thousandth of the ellipsoids' widths or a 100,000th of the whole way: then
/// minima between steps are looked for. Ends where it is positive.
template <int D> Real largest_depth(Flight<Real, D> const &f, Real end)
{
    Real const speed = top_speed(f);
    Real times[3] = {0, 0, 0}, values[3] = {4, 4, 4}, largest = -1;
    bool short_of_gap = false;
    for (Real time = 0;;) {
        Gap const here = gap_at(f, time);
        largest = std::fmax(largest, depth_at(f, time));
        for (int k = 0; k < 2; ++k) times[k] = times[k + 1], values[k] = values[k + 1];
        times[2] = time, values[2] = here.mu2;
        if (values[1] <= values[0] && values[1] <= values[2] && (values[1] < 1.1L || short_of_gap))
            largest = std::fmax(largest, depth_at(f, time_of_minimum(f, times[0], times[2])));
        if (time >= end || largest > 0) return largest;
        Real const least = std::fmax(here.width / 1000 / speed, f.end / 100000);
        short_of_gap = here.gap < 2 * least * speed;
        time = std::fmin(end, time + std::fmax(here.gap / speed, least));
    }
}

/// Makes a flight one that grazes, by some depth of either sign: μ² scales with the inverse of the
/// forms.
template <int D> Flight<double, D> grazing(Flight<double, D> f, Random &random)
{
    auto apart = convert_flight<Real>(f);
    Real lowest = gap_at(apart, Real(0)).mu2;
    for (int k = 1; k <= 200; ++k)
        lowest = std::fmin(lowest, gap_at(apart, apart.end * k / 200).mu2);
    double const depth =
        (random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0) * random.log_uniform(1e-10, 1e-3);
    double const factor = static_cast<double>(lowest) * (1.0 - depth);
    f.start.q1 = factor * f.start.q1;
    f.start.q2 = factor * f.start.q2;
    return f;
}

/// The time errs by no more than what changes μ² by that much, as long as μ² changes in proportion
/// to time, and by what rounds it.
template <int D> void check_time(Failures &failures, Flight<double, D> const &f, double time)
{
    auto const wide = convert_flight<Real>(f);
    Real const expected = first_contact(wide).time, h = 1e-6L * expected,
               before = (gap_at(wide, expected).mu2 - gap_at(wide, expected - h).mu2) / h,
               after = (gap_at(wide, expected + h).mu2 - gap_at(wide, expected).mu2) / h;
    Real const bound = rounding(wide, expected) / std::fabs(before) + 0x1p-52L * expected;
    // it grazes
    if (!(before < 0) || std::fabs(after - before) > 1e-3L * -before || bound > h) return;
    failures.check(std::fabs(time - expected) <= bound, "time", time, static_cast<double>(expected),
                   [&] { return flight_text(f); });
}

/// μ = 1 at the time given, and nowhere before it.
template <int D> void check_flight(Failures &failures, Flight<double, D> const &f, int &touching)
{
    auto const c = first_contact(f);
    bool const touches = c.time <= f.end;
    touching += touches;
    auto const text = [&] { return flight_text(f); };
    failures.check(c.status == pw85::Status::success &&
                       (touches || c.time == std::numeric_limits<double>::infinity()),
                   "time", c.time, f.end, text);
    if (c.time == 0.0) return; // overlapping
    auto const wide = convert_flight<Real>(f);
    Real const last = std::fmin(Real(c.time), wide.end), depth = largest_depth(wide, last);
    failures.check(depth <= 0, "missed", static_cast<double>(depth), 0.0, text);
    if (!touches) return;
    double const error = static_cast<double>(rounding(wide, last)),
                 mu2 = static_cast<double>(gap_at(wide, last).mu2 - 1);
    failures.check(std::fabs(mu2) <= error, "no contact", mu2, error, text);
    check_time(failures, f, c.time);
}

template <int D> void check_flights(Moving moving, bool graze)
{
    Failures failures;
    Random random(
        static_cast<std::uint64_t>(500 + D + (moving == Moving::all ? 10 : 0) + (graze ? 20 : 0)));
    int const flights = D == 3 ? motions : motions / 2;
    int touching = 0;
    for (int n = 0; n < flights; ++n) {
        auto const f =
            random_flight<D>(random, random.log_uniform(1.0, n % 10 == 0 ? 100.0 : 5.0), moving);
        check_flight(failures, graze ? grazing(f, random) : f, touching);
    }
    g_assert_cmpint(touching, >, flights / 5);
    g_assert_cmpint(touching, <, 19 * flights / 20);
}

/// Needles and discs, of which few touch for longer than an instant.
template <int D> void check_slender(int flights)
{
    Failures failures;
    Random random(541 + D);
    int touching = 0;
    for (int n = 0; n < flights; ++n)
        check_flight(failures, slender_flight<D>(random, random.log_uniform(10.0, 1e7), 0.1),
                     touching);
    g_assert_cmpint(touching, >, flights / 5);
}

void test_slender()
{
    check_slender<3>(motions);
    check_slender<2>(motions / 2);
}

template <Moving moving, bool graze> void test_flights()
{
    check_flights<3>(moving, graze);
    check_flights<2>(moving, graze);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    // of four kinds, and half as many in two dimensions
    if (argc > 1) motions = std::atoi(argv[1]) / 6;
    g_test_add_func("/motion_truth/translation", test_flights<Moving::centres, false>);
    g_test_add_func("/motion_truth/motion", test_flights<Moving::all, false>);
    g_test_add_func("/motion_truth/grazing_translation", test_flights<Moving::centres, true>);
    g_test_add_func("/motion_truth/grazing_motion", test_flights<Moving::all, true>);
    g_test_add_func("/motion_truth/slender", test_slender);
    return g_test_run();
}
