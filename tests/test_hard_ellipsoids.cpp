// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of hard ellipsoids against exact distributions, counting, and itself: other numbers
// of threads, and saved states.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include <glib.h>

#include <pw85/algebra/philox.hpp>
#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "cases.hpp"
#include "hard_particles.hpp"
#include "saved_sections.hpp"
#include "threads.hpp"

using namespace pw85_tests;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Particles of two kinds on a lattice of n³ places, in a cell that is sheared.
Start mixture(int n)
{
    Start start;
    double const a = 1.25, c = 2.6;
    for (int k = 0; k < n * n * n; ++k) {
        int const x = k % n, y = k / n % n, z = k / n / n;
        start.add({a * x + 0.3 * a * y, a * y, c * z},
                  k % 3 == 0 ? Vector3{0.45, 0.5, 0.9} : Vector3{0.5, 0.5, 1.2});
    }
    start.cell = {{{a * n, 0.0, 0.0}, {0.3 * a * n, a * n, 0.0}, {0.0, 0.0, c * n}}};
    return start;
}

// The vectors of Random123's file kat_vectors, which Salmon and others publish with their paper.
PW85_TEST("/hard_ellipsoids/philox")
{
    struct {
        pw85::detail::PhiloxWords counter;
        std::uint64_t key;
        std::uint32_t expected[4];
    } const known[] = {
        {{{0, 0, 0, 0}}, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}},
         0xffffffffffffffff,
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
         0x299f31d0a4093822,
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    for (auto const &one : known) {
        auto const found = pw85::detail::philox(one.counter, one.key);
        for (int k = 0; k < 4; ++k) g_assert_cmphex(found.word[k], ==, one.expected[k]);
    }
}

PW85_TEST("/hard_ellipsoids/ideal_gas")
{
    auto const make = [](double volume, std::size_t seed) {
        double const side = std::cbrt(volume);
        Start gas;
        for (int k = 0; k < 8; ++k)
            gas.add(0.5 * side * Vector3{double(k & 1), double(k >> 1 & 1), double(k >> 2)},
                    {1e-9, 2e-9, 1e-9});
        gas.cell = box(side, side, side);
        HardEllipsoids simulation = gas.simulation(seed);
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.7}) == Status::success);
        return simulation;
    };
    expect_ideal_gas(8.0, make);
}

// A sphere, or a disc, of diameter one does not overlap its images if all edges are at least one.
// At constant volume the logarithms of the edges are uniform on a triangle, or a line: with their
// sum S, the mean square of one of them is S²/6, or S²/3.
PW85_TEST("/hard_ellipsoids/aspect")
{
    for (int const dimensions : {3, 2}) {
        Start start;
        start.add({0, 0, 0}, {0.5, 0.5, 0.5});
        start.cell = box(2, 1.5, dimensions == 3 ? 1.2 : 7.0);
        start.periodic = {1, 1, dimensions == 3};
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.6}) == Status::success);
        double const sum = std::log(dimensions == 3 ? 3.6 : 3.0);
        Blocks squares(1000);
        for (int k = 0; k < 40000; ++k) {
            g_assert_true(simulation.volume_moves(2, 0.0, CellChange::aspect) == Status::success);
            double const edge = std::log(simulation.system().cell[0]);
            squares.add(edge * edge);
        }
        squares.expect("square of the logarithm of an edge",
                       sum * sum / (dimensions == 3 ? 6.0 : 3.0));
        double const *const c = simulation.system().cell;
        g_assert_cmpfloat(std::fabs(std::log(c[0] * c[4] * (dimensions == 3 ? c[8] : 1.0)) - sum),
                          <, 1e-10);
        g_assert_true(simulation.tune(5, 0.4, 0.0, CellChange::aspect) == Status::success);
        g_assert_true(simulation.volume_moves(2, NAN, CellChange::aspect) ==
                      Status::invalid_argument);
        g_assert_true(simulation.volume_moves(2, 0.0, CellChange::axis) ==
                      Status::invalid_argument);
        g_assert_cmpint(pw85_hard_ellipsoids_volume_moves(simulation.get(), 1, 1.0, 4), ==,
                        PW85_EINVAL);
    }
}

// Carnahan and Starling's equation of state, J. Chem. Phys. 51, 635 (1969): it errs by less than
// 0.3 % here. The density of 64 spheres at this pressure differs from that of infinitely many by
// some tenths of a per cent.
PW85_TEST("/hard_ellipsoids/hard_spheres")
{
    constexpr double eta = 0.3, z = (1 + eta + eta * eta - eta * eta * eta) /
                                    ((1 - eta) * (1 - eta) * (1 - eta));
    constexpr double density = 6.0 * eta / pi;
    Start start;
    for (int k = 0; k < 64; ++k)
        start.add(1.3 * Vector3{double(k % 4), double(k / 4 % 4), double(k / 16)}, {0.5, 0.5, 0.5});
    start.cell = box(5.2, 5.2, 5.2);
    HardEllipsoids simulation = start.simulation();
    expect_density(simulation, density, z, 0.3, 12000, 0.005 * density);
}

// Trials of particles and the single trial of the volume of a sweep reach the acceptance that is
// asked for, from steps far too long or too short. Steps scatter, so the mean over several is
// compared.
PW85_TEST("/hard_ellipsoids/tune")
{
    constexpr std::size_t moves[3] = {0, 1, 4}; // translations, rotations, volume
    for (double const wanted : {0.2, 0.6})
        for (double const factor : {0.1, 10.0}) {
            HardEllipsoids simulation = mixture(4).simulation();
            g_assert_true(simulation.set_steps({0.05 * factor, 0.05 * factor, 0.002 * factor}) ==
                          Status::success);
            double accepted[3] = {}, trials[3] = {};
            for (int k = 0; k < 12; ++k) {
                g_assert_true(simulation.tune(k == 0 ? 300 : 50, wanted, 2.0) == Status::success);
                for (int i = 0; i < 50; ++i) {
                    g_assert_true(simulation.sweep(1) == Status::success);
                    g_assert_true(simulation.volume_moves(1, 2.0) == Status::success);
                }
                auto const counts = simulation.counts();
                for (std::size_t const move : moves) {
                    std::size_t const kind = std::min(move, std::size_t{2});
                    accepted[kind] += static_cast<double>(counts.accepted[move]);
                    trials[kind] += static_cast<double>(counts.trials[move]);
                }
            }
            for (int kind = 0; kind < 3; ++kind) {
                double const acceptance = accepted[kind] / trials[kind];
                g_test_message("kind %d: %.3f, wanted %.3f", kind, acceptance, wanted);
                if (std::fabs(acceptance - wanted) > 0.08)
                    g_test_fail_printf("kind %d: %a instead of %a", kind, acceptance, wanted);
            }
        }
}

/// Spheres of two sizes on a lattice, and their kinds.
struct TwoSizes {
    static constexpr Vector3 large = {0.5, 0.5, 0.5}, little = {0.2, 0.2, 0.3};

    static Start start()
    {
        Start start;
        for (int k = 0; k < 1000; ++k)
            start.add(1.1 * Vector3{double(k % 10), double(k / 10 % 10), double(k / 100)},
                      k % 2 == 0 ? large : little);
        start.cell = box(11, 11, 11);
        return start;
    }
};

// The trials of each kind reach the acceptance that is asked for. A particle is chosen n times in a
// sweep by Poisson's law, so that e^-a of them have not moved, with the acceptance a. Lengths of
// translations are those of the kind.
PW85_TEST("/hard_ellipsoids/kind_steps")
{
    Vector3 const kinds[] = {TwoSizes::large, TwoSizes::little};
    HardEllipsoids simulation = TwoSizes::start().simulation();
    pw85::TrialSteps const first[] = {{0.01, 0.02, 0.0}, {0.03, 0.04, 0.0}};
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.set_kind_steps(kinds, first) == Status::success);
    for (int const tuned : {0, 1}) {
        double share[2] = {}, longest[2] = {};
        if (tuned) g_assert_true(simulation.tune(400, 0.7) == Status::success);
        for (int k = 0; k < 40; ++k) {
            std::vector<double> const before(simulation.system().centers,
                                             simulation.system().centers + 3000);
            g_assert_true(simulation.sweep(1) == Status::success);
            for (std::size_t i = 0; i < 1000; ++i) {
                double moved = 0.0;
                for (std::size_t d = 0; d < 3; ++d)
                    moved = std::max(moved, std::fabs(simulation.system().centers[3 * i + d] -
                                                      before[3 * i + d]));
                share[i % 2] += moved > 0.0 ? 1.0 / 500 / 40 : 0.0;
                longest[i % 2] = std::max(longest[i % 2], moved);
            }
        }
        for (std::size_t k = 0; k < 2; ++k) {
            double const acceptance = -std::log(1.0 - share[k]),
                         step = simulation.kind_steps(kinds[k]).translation;
            g_test_message("kind %zu: step %.4f, longest %.4f, accepted %.3f", k, step, longest[k],
                           acceptance);
            if (!tuned) g_assert_cmpfloat(step, ==, first[k].translation);
            g_assert_true(longest[k] > step * 0.9 && longest[k] < 6.0 * step);
            if (tuned) g_assert_cmpfloat(std::fabs(acceptance - 0.7), <, 0.04);
        }
        if (tuned)
            g_assert_cmpfloat(simulation.kind_steps(kinds[1]).translation, >,
                              1.5 * simulation.kind_steps(kinds[0]).translation);
    }
    double const common = simulation.steps().translation;
    g_assert_true(simulation.kind_steps({1, 2, 3}).translation == common);
    g_assert_true(simulation.set_kind_steps({}, {}) == Status::success);
    g_assert_true(simulation.kind_steps(kinds[0]).translation == common);
}

// The same bits with any number of threads and after a restart, with exchanges, too. Bad steps
// change nothing.
PW85_TEST("/hard_ellipsoids/kind_steps_restart")
{
    Vector3 const kinds[] = {TwoSizes::large, TwoSizes::little};
    pw85::TrialSteps const steps[] = {{0.05, 0.02, 0.0}, {0.3, 0.4, 0.0}};
    auto const run = [&](int threads, bool restarts) {
        Threads const used(threads);
        HardEllipsoids simulation = TwoSizes::start().simulation();
        g_assert_true(simulation.set_kind_steps(kinds, steps) == Status::success);
        g_assert_true(simulation.set_fractions({1, 1, 1, 1}) == Status::success);
        g_assert_true(simulation.tune(5, 0.3) == Status::success &&
                      simulation.sweep(3) == Status::success);
        if (restarts) {
            HardEllipsoids again;
            g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), again) == Status::success);
            simulation = std::move(again);
        }
        g_assert_true(simulation.tune(3, 0.3) == Status::success &&
                      simulation.sweep(3) == Status::success);
        expect_no_overlap(simulation);
        return bytes_of(simulation);
    };
    auto const expected = run(1, false);
    g_assert_true(run(2, false) == expected && run(1, true) == expected &&
                  run(3, true) == expected);

    HardEllipsoids simulation = TwoSizes::start().simulation();
    g_assert_true(simulation.set_kind_steps(kinds, steps) == Status::success);
    auto const before = bytes_of(simulation);
    for (pw85::TrialSteps const &bad : {pw85::TrialSteps{0.0, 0.1, 0.0},
                                        {NAN, 0.1, 0.0},
                                        {0.1, -0.1, 0.0},
                                        {0.1, 1.1, 0.0},
                                        {11.1, 0.1, 0.0},
                                        {HUGE_VAL, 0.1, 0.0}}) {
        pw85::TrialSteps const both[] = {steps[0], bad};
        g_assert_true(simulation.set_kind_steps(kinds, both) == Status::invalid_argument);
    }
    Vector3 const same[] = {kinds[0], kinds[0]}, unknown[] = {kinds[0], {0.1, NAN, 0.2}};
    g_assert_true(simulation.set_kind_steps(same, steps) == Status::invalid_argument);
    g_assert_true(simulation.set_kind_steps(unknown, steps) == Status::invalid_argument);
    std::vector<Vector3> const many(17, kinds[0]);
    std::vector<double> const numbers(34, 0.1);
    g_assert_cmpint(pw85_hard_ellipsoids_set_kind_steps(simulation.get(), 17, many[0].coordinates,
                                                        numbers.data()),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_hard_ellipsoids_set_kind_steps(simulation.get(), 1, nullptr, nullptr), ==,
                    PW85_EINVAL);
    g_assert_true(bytes_of(simulation) == before);
    double out[2] = {1.0, 1.0};
    g_assert_cmpint(pw85_hard_ellipsoids_kind_steps(simulation.get(), 1, nullptr, out), ==,
                    PW85_EINVAL);
    g_assert_true(std::isnan(out[0]) && std::isnan(out[1]) &&
                  std::isnan(HardEllipsoids().kind_steps(kinds[0]).rotation));
    g_assert_true(HardEllipsoids().set_kind_steps(kinds, steps) == Status::invalid_argument);
    Bytes const changed = with_word(before, "SPECIES", 4, word_of(-1.0));
    g_assert_true(hard_ellipsoids_restore(changed, simulation) == Status::invalid_argument);
}

PW85_TEST("/hard_ellipsoids/tuned_translations") { expect_tuned_translations(3, 1.6); }

/// Two unlike ellipsoids in a cell.
struct TwoEllipsoids {
    static constexpr Vector3 axes[2] = {{0.3, 0.5, 0.9}, {0.6, 0.4, 0.2}};
    static constexpr double side = 2.0;

    /// The least μ² of all images that can be near, and the squared cosine between the third axes.
    static std::array<double, 2> measure(Vector3 const &r, Quaternion const &a, Quaternion const &b,
                                         Vector3 const &axes_a, Vector3 const &axes_b)
    {
        auto const qa = pw85::ellipsoid_quaternion(axes_a, a).q,
                   qb = pw85::ellipsoid_quaternion(axes_b, b).q;
        double least = HUGE_VAL;
        for (int k = 0; k < 27; ++k) {
            Vector3 image = r;
            int const n[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
            for (int d = 0; d < 3; ++d) image[d] += side * (n[d] - std::nearbyint(r[d] / side));
            least = std::min(least, pw85::contact(image, qa, qb).mu2);
        }
        auto const third = [](Quaternion const &q) {
            return Vector3{2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]),
                           1 - 2 * (q[1] * q[1] + q[2] * q[2])};
        };
        double const cosine = dot(third(a), third(b));
        return {least, cosine * cosine};
    }
};

PW85_TEST("/hard_ellipsoids/two_ellipsoids")
{
    constexpr double side = TwoEllipsoids::side;
    auto const &axes = TwoEllipsoids::axes;
    Start start;
    start.add({0, 0, 0}, axes[0]);
    start.add({1, 1, 1}, axes[1]);
    start.cell = box(side, side, side);
    HardEllipsoids simulation = start.simulation();
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.0, side);
    auto const turn = [&] {
        Quaternion const q = {normal(random), normal(random), normal(random), normal(random)};
        return q / std::sqrt(dot(q, q));
    };
    auto const draw = [&] {
        Vector3 const r = {uniform(random), uniform(random), uniform(random)};
        return TwoEllipsoids::measure(r, turn(), turn(), axes[0], axes[1]);
    };
    expect_two_bodies<2>(
        simulation, {"near", "aligned"}, 20000, draw, [](HardEllipsoids const &all) {
            auto const *const centers = reinterpret_cast<Vector3 const *>(all.system().centers);
            auto const q = all.quaternions();
            auto const own = all.semi_axes();
            return TwoEllipsoids::measure(centers[1] - centers[0], q[0], q[1], own[0], own[1]);
        });
}

// A particle alone turns by (1, v), in which v and -v are equally probable: the mean of v is 0. The
// parts of the quaternion after a turn, multiplied by the conjugate of the one before, are in the
// ratio 1 : v.
PW85_TEST("/hard_ellipsoids/domain_scheduler")
{
    constexpr double largest = 0.25;
    Start start;
    start.add({0, 0, 0}, {0.3, 0.5, 0.9});
    start.cell = box(5, 5, 5);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({0, 1, 0, 0}) == Status::success);
    g_assert_true(simulation.set_steps({0.1, largest, 0.1}) == Status::success);
    Blocks means[3] = {Blocks(200), Blocks(200), Blocks(200)}, square(200);
    for (int k = 0; k < 10000; ++k) {
        auto const [w, x, y, z] = simulation.quaternions()[0].coordinates;
        g_assert_true(simulation.sweep(1) == Status::success);
        auto const [a, b, c, d] = simulation.quaternions()[0].coordinates;
        double const scalar = a * w + b * x + c * y + d * z;
        Vector3 const v = Vector3{b * w - a * x - c * z + d * y, c * w - a * y - d * x + b * z,
                                  d * w - a * z - b * y + c * x} /
                          (scalar * largest);
        for (int i = 0; i < 3; ++i) means[i].add(v[i]);
        square.add(dot(v, v));
    }
    for (Blocks const &mean : means) mean.expect("mean turn", 0.0);
    square.expect("mean square of a point of a ball", 0.6);
}

PW85_TEST("/hard_ellipsoids/detailed_balance")
{
    Start start = mixture(3);
    for (auto &center : start.centers) center = 1.3 * center;
    for (auto &vector : start.cell) vector = 1.3 * vector;
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_steps({0.7, 0.7, 0.1}) == Status::success);
    expect_detailed_balance(simulation, 8000);
}

PW85_TEST("/hard_ellipsoids/long_trials") { expect_same_long_trials(3, 27, 1000); }

PW85_TEST("/hard_ellipsoids/threads_and_restart")
{
    Start const start = mixture(13);
    expect_same_in_threads(start, 3, 24, [](HardEllipsoids &simulation) {
        try_everything(simulation, 3, 2.0);
        return simulation.steps().volume;
    });
    HardEllipsoids one = start.simulation(42), other = start.simulation(43);
    try_everything(one, 1, 2.0), try_everything(other, 1, 2.0);
    g_assert_true(bytes_of(other) != bytes_of(one));
}

// An exchange leaves the semi-axes of all particles together as they are, and does not move or turn
// any particle.
PW85_TEST("/hard_ellipsoids/exchange")
{
    Start start = mixture(6);
    for (std::size_t i = 0; i < start.quaternions.size(); ++i)
        start.quaternions[i] = {1.0, 0.0, 0.0, 0x1p-12 * static_cast<double>(i)};
    HardEllipsoids simulation = start.simulation();
    std::vector<Quaternion> const before(simulation.quaternions().begin(),
                                         simulation.quaternions().end());
    g_assert_true(simulation.set_fractions({0, 0, 0, 1}) == Status::success);
    g_assert_true(simulation.sweep(5) == Status::success);
    g_assert_cmpint(simulation.counts().accepted[3], >, 0);
    std::ptrdiff_t moved = 0, turned = 0, exchanged = 0, slender = 0;
    double const *const centers = simulation.system().centers;
    for (std::size_t i = 0; i < start.centers.size(); ++i) {
        auto const equal = [](double const *x, auto const &y) {
            return std::equal(x, x + 3, y.coordinates);
        };
        moved += !equal(centers + 3 * i, start.centers[i]);
        turned += !std::equal(before[i].coordinates, before[i].coordinates + 4,
                              simulation.quaternions()[i].coordinates);
        exchanged += !equal(simulation.semi_axes()[i].coordinates, start.semi_axes[i]);
        slender += (simulation.semi_axes()[i][2] == 1.2) - (start.semi_axes[i][2] == 1.2);
    }
    g_assert_cmpint(moved, ==, 0);
    g_assert_cmpint(turned, ==, 0);
    g_assert_cmpint(slender, ==, 0);
    g_assert_cmpint(exchanged, >, 0);
}

// At a pressure whose factor exp(-βPΔV) is below all numbers, no trial makes the volume larger.
PW85_TEST("/hard_ellipsoids/immense_pressures")
{
    for (double const pressure : {1e3, 1e5, 1e9, 1e100, 1e300}) {
        Start start;
        start.add({0, 0, 0}, {0.01, 0.01, 0.01});
        start.cell = box(40, 40, 40);
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.1}) == Status::success);
        for (int k = 0; k < 30; ++k) {
            double const before = simulation.system().cell[0];
            g_assert_true(simulation.volume_moves(1, pressure) == Status::success);
            g_assert_cmpfloat(simulation.system().cell[0], <=, before);
        }
        auto const counts = simulation.counts();
        g_assert_true(0 < counts.accepted[4] && counts.accepted[4] < counts.trials[4]);
    }
}

// The rounded form of a needle with the aspect ratio 2³⁰ is positive definite in some orientations
// only. Trials do not lead to the others.
PW85_TEST("/hard_ellipsoids/needles")
{
    Start start;
    start.add({0, 0, 0}, {1.0, 0x1p-30, 0x1p-30});
    start.add({5, 1, 2}, {1.0, 0x1p-30, 0x1p-30});
    start.cell = box(12, 12, 12);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({0, 1, 0, 0}) == Status::success);
    for (int k = 0; k < 100; ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        expect_no_overlap(simulation);
    }
    auto const counts = simulation.counts();
    g_assert_cmpint(counts.accepted[1], <, counts.trials[1]); // nothing else rejects them
}

// A small sphere that becomes a large one leaves the box that it has had. The skin of the rows has
// room for that, or the sweep would make rows without end.
PW85_TEST("/hard_ellipsoids/exchange_of_sizes")
{
    Start start;
    start.add({0, 0, 0}, {1.0, 1.0, 1.0});
    start.add({4, 1, 2}, {0.1, 0.1, 0.1});
    start.cell = box(9, 9, 9);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({0, 0, 0, 1}) == Status::success);
    g_assert_true(simulation.sweep(20) == Status::success);
    auto const counts = simulation.counts();
    g_assert_cmpint(counts.trials[3], ==, 40);
    g_assert_cmpint(counts.accepted[3], >, 0);
    expect_no_overlap(simulation);
}

// A rod that is longer than two sides of its cell meets its own images. Periodic along two vectors,
// it is on its own along the third.
PW85_TEST("/hard_ellipsoids/small_cell")
{
    Start start;
    start.add({0, 0, 0}, {0.2, 0.2, 2.0});
    start.cell = box(1, 1, 5);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.sweep(20000) == Status::success);
    expect_no_overlap(simulation);
    auto const counts = simulation.counts();
    g_assert_true(0 < counts.accepted[1] && counts.accepted[1] < counts.trials[1]);
    start.cell = box(1, 1, 3);
    pw85::IndexPair pair;
    g_assert_true(start.create(simulation, pair) == Status::overlap);
    g_assert_true(pair[0] == 0 && pair[1] == 0);
    start.periodic = {1, 1, 0};
    simulation = start.simulation();
    g_assert_true(simulation.sweep(2000) == Status::success);
    expect_no_overlap(simulation);
    g_assert_true(simulation.volume_moves(1, 1.0) == Status::invalid_argument);
}

/// A few particles of two kinds in a sheared cell, times a power of two, after some sweeps; or one
/// in a cell smaller than itself.
HardEllipsoids small_system(int size, bool is_single)
{
    double const unit = std::ldexp(1.0, size);
    Start start = mixture(2);
    if (is_single) {
        start = Start();
        start.add({0, 0, 0}, {0.2, 0.3, 2.0}, {0.8, 0.0, 0.6, 0.0});
        start.cell = box(5, 1, 1);
    }
    for (Vector3 &center : start.centers) center = unit * center;
    for (Vector3 &axes : start.semi_axes) axes = unit * axes;
    for (Vector3 &vector : start.cell) vector = unit * vector;
    HardEllipsoids simulation = start.simulation(static_cast<std::size_t>(size + 50));
    g_assert_true(simulation.set_steps({0.2 * unit, 0.1, 0.02}) == Status::success);
    g_assert_true(simulation.sweep(60) == Status::success);
    g_assert_true(simulation.volume_moves(4, 0.5 / (unit * unit * unit), CellChange::triclinic) ==
                  Status::success);
    return simulation;
}

constexpr int sizes[] = {-40, 0, 40};

void expect_neighbors(HardEllipsoids &simulation, std::size_t i)
{
    AllImages const all(simulation);
    std::size_t count = 0, k = 0;
    g_assert_true(simulation.neighbors(i, count) == Status::success);
    std::vector<std::int32_t> particles(count + 1);
    std::vector<std::array<std::int32_t, 3>> images(count + 1);
    std::vector<Vector3> separations(count + 1);
    g_assert_true(simulation.neighbors(i, count, particles, images, separations) ==
                  Status::success);
    all.visit(i, [&](std::size_t j, auto const &image, Vector3 const &translation) {
        Vector3 const r = (all.center(j) - all.center(i)) + translation;
        double gap = -1.0; // of the boxes, relative to their sizes
        for (int d = 0; d < 3; ++d) {
            double const reach = all.half_widths[i][d] + all.half_widths[j][d];
            gap = std::max(gap, std::fabs(r[d]) / reach - 1.0);
        }
        bool const listed =
            k < count && particles[k] == static_cast<std::int32_t>(j) && images[k] == image;
        if (std::fabs(gap) > 1e-12 && listed != (gap < 0.0))
            g_test_fail_printf("particle %zu and %zu, gap %a, listed %d", i, j, gap, listed);
        if (!listed) return;
        Vector3 const error = separations[k++] - r;
        g_assert_cmpfloat(dot(error, error), <=, 0x1p-96 * dot(r, r));
    });
    g_assert_cmpuint(k, ==, count);
}

PW85_TEST("/hard_ellipsoids/neighbors")
{
    for (int const size : sizes) {
        HardEllipsoids simulation = small_system(size, false);
        for (std::size_t i = 0; i < 8; ++i) expect_neighbors(simulation, i);
        double z;
        g_assert_true(simulation.chain(20, std::ldexp(8.0, size), z) == Status::success);
        for (std::size_t i = 0; i < 8; ++i) expect_neighbors(simulation, i);
        simulation = small_system(size, true);
        expect_neighbors(simulation, 0);
        std::size_t count = 7;
        g_assert_true(simulation.neighbors(0, count) == Status::success && count > 0);
        g_assert_true(simulation.neighbors(1, count) == Status::invalid_argument && count == 0);
    }
}

/// The probability that a trial of the volume of an ideal gas is rejected, by the midpoint rule
/// over the factors that src/simulation/change.hpp draws, for an isotropic scaling
/// of the lengths by (1 + x/2)/(1 - x/2) with |x| < `largest`.
double rejection_of_volume(double n, double pressure, double volume, double largest)
{
    constexpr int points = 100;
    double sum = 0.0;
    for (int k = 0; k < points; ++k) {
        double const x = largest * ((2 * k + 1.0) / points - 1.0);
        double const determinant = std::pow((1.0 + 0.5 * x) / (1.0 - 0.5 * x), 3);
        sum += std::max(0.0, 1.0 - std::pow(determinant, n + 1.0) *
                                       std::exp(-pressure * volume * (determinant - 1.0)));
    }
    return sum / points;
}

// How many trials are rejected, of steps so short that all are accepted with a probability above
// 0.98, and of longer ones. The cell is at first larger than on average. The number of rejected
// trials, less the sum of the probabilities p, has the variance Σ p (1 - p), whatever volumes
// occur.
PW85_TEST("/hard_ellipsoids/rejected_volumes")
{
    constexpr double n = 8.0, pressure = 5.0;
    for (double const largest : {0.001, 0.02, 0.3}) {
        Start gas;
        for (int k = 0; k < 8; ++k)
            gas.add({0.5 * (k & 1), 0.5 * (k >> 1 & 1), 0.5 * (k >> 2)}, {1e-9, 2e-9, 1e-9});
        gas.cell = box(1.44, 1.44, 1.44);
        HardEllipsoids simulation = gas.simulation();
        g_assert_true(simulation.set_steps({0.1, 0.1, largest}) == Status::success);
        double expected = 0.0, variance = 0.0;
        for (int k = 0; k < 10000; ++k) {
            double const p = rejection_of_volume(n, pressure, measure_of(simulation), largest);
            expected += p;
            variance += p * (1.0 - p);
            g_assert_true(simulation.volume_moves(1, pressure) == Status::success);
        }
        auto const counts = simulation.counts();
        double const rejected = static_cast<double>(counts.trials[4] - counts.accepted[4]);
        g_test_message("steps of %g: %g rejected, expected %.1f +- %.1f", largest, rejected,
                       expected, std::sqrt(variance));
        g_assert_cmpfloat(expected, >, 20.0);
        if (!(std::fabs(rejected - expected) <= 4.0 * std::sqrt(variance)))
            g_test_fail_printf("steps of %a: %a rejected instead of %a", largest, rejected,
                               expected);
    }
}

// A single particle is compressed until it meets its own images, and never overlaps them.
PW85_TEST("/hard_ellipsoids/own_images")
{
    for (CellChange const change :
         {CellChange::isotropic, CellChange::axis, CellChange::triclinic}) {
        Start start;
        start.add({0, 0, 0}, {0.3, 0.4, 0.5}, {0.8, 0.0, 0.6, 0.0});
        start.cell = box(1.5, 1.5, 1.5);
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.1}) == Status::success);
        for (int k = 0; k < 100; ++k) {
            g_assert_true(simulation.volume_moves(1, 1e3, change) == Status::success);
            expect_no_overlap(simulation);
        }
        g_assert_cmpint(simulation.counts().accepted[4], >, 0);
    }
}

// Places spheres 1 and 2 next to each other along an axis, around some place, and expects that they
// overlap where their centres are too near. If there is a period, they meet across it.
void expect_near_pairs(HardEllipsoids &simulation, Vector3 const &place, double unit, double period)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    constexpr double radius = 0.95;
    constexpr Quaternion upright = {1, 0, 0, 0};
    int num_free = 0, num_near = 0;
    for (int k = 0; k < 300; ++k) {
        // One axis decides about the boxes of spheres that are near each other along it.
        double const sign = k % 2 == 0 ? 1.0 : -1.0;
        Vector3 r12 = {0.01 * uniform(random), 0.01 * uniform(random), 0.01 * uniform(random)};
        r12[k % 3] = sign * (1.0 + radius + 0.1 * uniform(random));
        Vector3 across{};
        across[k % 3] = sign * period;
        Vector3 const offset = unit * Vector3{uniform(random), uniform(random), uniform(random)};
        Vector3 const first = place + offset + 0.5 * across, second = first + unit * r12 - across,
                      between = second + across - first;
        bool free_first = false, free_second = false;
        g_assert_true(simulation.try_placement(1, first, upright, true, free_first) ==
                      Status::success);
        g_assert_true(simulation.try_placement(2, second, upright, false, free_second) ==
                      Status::success);
        if (!free_first) continue;
        bool const expected = dot(between, between) > unit * unit * (1.0 + radius) * (1.0 + radius);
        if (free_second != expected)
            g_test_fail_printf("unit %a: free %d at %a %a %a from %a %a %a", unit, free_second,
                               second[0], second[1], second[2], first[0], first[1], first[2]);
        num_free += expected;
        num_near += !expected;
    }
    g_assert_cmpint(num_free, >, 50);
    g_assert_cmpint(num_near, >, 50);
}

// Far from the first particle, coordinates in single precision are multiples of an eighth of the
// longest semi-axis, and so are the translations of a large cell. Spheres that overlap by less are
// found nevertheless.
PW85_TEST("/hard_ellipsoids/far_spheres")
{
    for (int const size : sizes)
        for (double const period : {0.0, 0x1.1999ap+20}) {
            double const unit = std::ldexp(1.0, size);
            Vector3 const far = unit * Vector3{0x1p20, -0x1p20, 0x1p20},
                          place = period > 0.0 ? Vector3{} : far;
            Start start;
            start.add(0.25 * (place - far), unit * Vector3{1.0, 1.0, 1.0});
            start.add(place, unit * Vector3{0.95, 0.95, 0.95});
            start.add(place + unit * Vector3{8.0, 0.0, 0.0}, unit * Vector3{1.0, 1.0, 1.0});
            double const side = unit * period;
            start.cell = box(side, side, side);
            pw85::Particles const particles{
                start.centers, {}, period > 0.0 ? &start.cell : nullptr, start.periodic};
            HardEllipsoids simulation;
            pw85::IndexPair pair;
            g_assert_true(hard_ellipsoids_create(particles, start.semi_axes, start.quaternions, 1,
                                                 simulation, pair) == Status::success);
            expect_near_pairs(simulation, place, unit, side);
        }
}

// Sizes at which products underflow. Lanes then show overlaps that are none, so that the answers
// for pairs that fail the fast checks are left to the function for one pair.
PW85_TEST("/hard_ellipsoids/tiny_pairs")
{
    Vector3 const pairs[][3] = {
        // semi-axes of the first and of the second, and the separation
        {{0x1.c164c1c2df11p-103, 0x1.8edbecaacc814p-74, 0x1.b4b348519df76p-105},
         {0x1.158e7ae378a22p-113, 0x1.16b8862051887p-122, 0x1.676059b185994p-127},
         {-0x1.0cefd418610ddp-105, -0x1.648faa016801ep-74, -0x1.6fe650fc9569fp-105}},
        {{0x1.e2fd98b263331p-151, 0x1.1030d06945f9bp-121, 0x1.9062ed5de0cfp-79},
         {0x1.37c29c0824c4fp-97, 0x1.ffd35985a3511p-131, 0x1.6c979ad42f75dp-151},
         {0x1.4a3a686ba7cp-101, 0x1.d96dc6916c394p-122, -0x1.d4e648e1f840fp-80}},
        {{0x1.c41e97ab1457bp-84, 0x1.33828669aaae8p-86, 0x1.6e89bd40c961dp-107},
         {0x1.53b4b3c0d4093p-130, 0x1.e7346fe9caadep-104, 0x1.6c0908c8efff7p-108},
         {0x1.b7c184026d09bp-85, 0x1.313f8fd0fca74p-87, -0x1.c6931cb785894p-107}},
        {{0x1.b4a8ed427368dp-65, 0x1.ad9655fe1fd3ep-112, 0x1.36b421439dca6p-130},
         {0x1.63e117da80186p-106, 0x1.10fdf3c00e1c9p-103, 0x1.e99ab2cd581aap-124},
         {-0x1.868be28cc89e5p-67, 0x1.15dcec66f9a52p-104, -0x1.ad5aa48925e5ep-124}}};
    for (auto const &[first, second, r12] : pairs) {
        Start start;
        start.add(-64.0 * r12, first);
        start.add(r12, second);
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        g_assert_true(hard_ellipsoids_create({start.centers, {}, nullptr}, start.semi_axes,
                                             start.quaternions, 1, simulation,
                                             pair) == Status::success);
        for (double const part : {0.0, 1.0}) {
            bool is_free = true;
            g_assert_true(simulation.try_placement(0, part * r12, {1, 0, 0, 0}, false, is_free) ==
                          Status::success);
            g_assert_true(is_free == (part == 0.0));
        }
    }
}

/// Whether a particle would be free, by the contact function.
bool is_free(AllImages const &all, std::size_t i, Vector3 const &center,
             pw85::SymmetricMatrix<double, 3> const &q)
{
    bool free = true;
    all.visit(i, [&](std::size_t j, auto const &, Vector3 const &translation) {
        Vector3 const from = i == j ? center : all.center(j);
        free = free &&
               pw85::contact((from - center) + translation, q, i == j ? q : all.form(j)).mu2 >= 1.0;
    });
    return free;
}

// A large sphere among hundreds of small ones, which its bounding box meets at once.
PW85_TEST("/hard_ellipsoids/many_candidates")
{
    Start start;
    start.add({0, 0, 0}, {2, 2, 2});
    constexpr int n = 14;
    constexpr double spacing = 0.46;
    for (int k = 0; k < n * n * n; ++k) {
        Vector3 const center = spacing * Vector3{k % n - 6.5, k / n % n - 6.5, k / n / n - 6.5};
        if (dot(center, center) > 2.3 * 2.3) start.add(center, {0.2, 0.2, 0.2});
    }
    start.cell = box(n * spacing, n * spacing, n * spacing);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_steps({0.06, 0.1, 0.1}) == Status::success);
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    Vector3 const before = *reinterpret_cast<Vector3 const *>(simulation.system().centers);
    for (int k = 0; k < 10; ++k) {
        g_assert_true(simulation.sweep(10) == Status::success);
        expect_no_overlap(simulation);
    }
    Vector3 const after = *reinterpret_cast<Vector3 const *>(simulation.system().centers);
    g_assert_cmpfloat(dot(after - before, after - before), >, 0.0);
}

// Small, large and very large motions, of which only some are taken.
PW85_TEST("/hard_ellipsoids/try")
{
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int const size : sizes)
        for (bool const is_single : {false, true}) {
            HardEllipsoids simulation = small_system(size, is_single);
            int num_free = 0;
            for (int trial = 0; trial < 60; ++trial) {
                AllImages const all(simulation);
                std::size_t const i = random() % all.system.num_particles;
                double const step = std::ldexp(trial % 3 == 0   ? 0.2
                                               : trial % 3 == 1 ? 1.0
                                                                : 3.0,
                                               size);
                Vector3 const center =
                    all.center(i) + step * Vector3{normal(random), normal(random), normal(random)};
                Quaternion turned = simulation.quaternions()[i];
                for (int d = 0; d < 4; ++d) turned[d] += 0.2 * normal(random);
                turned = turned / std::sqrt(dot(turned, turned));
                auto const q = pw85::ellipsoid_quaternion(simulation.semi_axes()[i], turned).q;
                bool const expected = is_free(all, i, center, q), take = trial % 2 == 0;
                auto const before = bytes_of(simulation);
                bool found = !expected;
                g_assert_true(simulation.try_placement(i, center, 3.0 * turned, take, found) ==
                              Status::success);
                if (found != expected)
                    g_test_fail_printf("size %d, trial %d, particle %zu at %a %a %a: free %d", size,
                                       trial, i, center[0], center[1], center[2], found);
                bool const moved = found && take;
                g_assert_true((bytes_of(simulation) == before) == !moved);
                if (moved) g_assert_true(AllImages(simulation).center(i)[1] == center[1]);
                if (trial % 10 == 9) g_assert_true(simulation.sweep(1) == Status::success);
                num_free += found;
            }
            expect_no_overlap(simulation);
            g_assert_true(0 < num_free && num_free < 60);
        }
    HardEllipsoids simulation = small_system(0, true);
    bool found;
    Quaternion const upright = {1, 0, 0, 0};
    g_assert_true(simulation.try_placement(0, {NAN, 0, 0}, upright, true, found) ==
                  Status::invalid_argument);
    g_assert_true(simulation.try_placement(0, {0, 0, 0}, {0, 0, 0, 0}, true, found) ==
                  Status::invalid_argument);
    g_assert_true(simulation.try_placement(1, {0, 0, 0}, upright, true, found) ==
                  Status::invalid_argument);
    Quaternion const lying = simulation.quaternions()[0];
    g_assert_true(simulation.try_placement(0, {1e15, 0, 0}, lying, true, found) ==
                      Status::invalid_argument &&
                  !found);
    g_assert_true(simulation.sweep(1) == Status::success);
}

PW85_TEST("/hard_ellipsoids/compress")
{
    for (int const size : sizes)
        for (bool const is_single : {false, true})
            expect_compression(small_system(size, is_single));
    Start dilute;
    dilute.add({1, 2, 3}, {1e-6, 2e-6, 3e-6});
    double factor;
    dilute.cell = box(7, 8, 9);
    expect_compression(dilute.simulation());
    auto const without_cell = [&] {
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        pw85::Particles const particles{dilute.centers, {}, nullptr};
        g_assert_true(hard_ellipsoids_create(particles, dilute.semi_axes, dilute.quaternions, 1,
                                             simulation, pair) == Status::success);
        return simulation;
    };
    g_assert_true(without_cell().compress(true, factor) == Status::success && factor == 0.0);
    dilute.add({2, 2, 3}, {0.001, 0.002, 0.003});
    HardEllipsoids pair_alone = without_cell();
    g_assert_true(pair_alone.compress(true, factor) == Status::success);
    g_assert_cmpfloat(std::fabs(factor - 0.001001), <, 1e-15);
    expect_no_overlap(pair_alone);
    g_assert_true(HardEllipsoids().compress(true, factor) == Status::invalid_argument &&
                  std::isnan(factor));
}

PW85_TEST("/hard_ellipsoids/bad_input")
{
    Start start = mixture(2);
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    start.centers[5] = start.centers[2] + Vector3{0.1, 0, 0};
    g_assert_true(start.create(simulation, pair) == Status::overlap);
    g_assert_true(pair[0] == 2 && pair[1] == 5);
    g_assert_true(simulation.sweep(1) == Status::invalid_argument && simulation.num_bytes() == 0);
    start.centers[5][1] = NAN;
    g_assert_true(start.create(simulation, pair) == Status::invalid_argument);
    simulation = mixture(2).simulation();
    for (double const pressure : {0.0, -1.0, double{NAN}, HUGE_VAL})
        g_assert_true(simulation.volume_moves(1, pressure) == Status::invalid_argument);
    g_assert_true(simulation.set_fractions({0, 0, 0, 0}) == Status::invalid_argument);
    g_assert_true(simulation.set_steps({0.1, NAN, 0.1}) == Status::invalid_argument);
    g_assert_true(simulation.tune(1, 1.5) == Status::invalid_argument);
    auto bytes = bytes_of(simulation);
    bytes.pop_back();
    g_assert_true(hard_ellipsoids_restore(bytes, simulation) == Status::invalid_argument);
}

// Lists for a translation that is longer than the cell would need gigabytes for a few particles.
PW85_TEST("/hard_ellipsoids/bad_steps")
{
    for (int const size : {0, 40, -40}) {
        double const unit = std::ldexp(1.0, size);
        Start start;
        start.add({0, 0, 0}, unit * Vector3{0.5, 0.5, 0.5});
        start.cell = box(2 * unit, 3 * unit, 2 * unit);
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.set_steps({3.0 * unit, 1.0, 1.0}) == Status::success);
        auto const before = bytes_of(simulation);
        double const beyond = 1.0 + 0x1p-52;
        for (pw85::TrialSteps const &steps : {pw85::TrialSteps{3.0 * unit * beyond, 0.1, 0.1},
                                              {0.0, 0.1, 0.1},
                                              {-unit, 0.1, 0.1},
                                              {HUGE_VAL, 0.1, 0.1},
                                              {unit, beyond, 0.1},
                                              {unit, 0.1, beyond},
                                              {unit, 0.1, 0.0}})
            if (simulation.set_steps(steps) != Status::invalid_argument)
                g_test_fail_printf("size %d: %a %a %a", size, steps.translation, steps.rotation,
                                   steps.volume);
        g_assert_true(bytes_of(simulation) == before);
        start.periodic = {1, 1, 0};
        g_assert_true(start.simulation().set_steps({4.0 * unit, 0.1, 0.1}) == Status::success);
    }
}

// Sweeps with these numbers would never end, or would make no trials.
PW85_TEST("/hard_ellipsoids/changed_bytes")
{
    constexpr double steps[3] = {0.0123, 0.0456, 0.0789}, fraction = 0.25, other = 0.75;
    HardEllipsoids simulation = mixture(2).simulation();
    g_assert_true(simulation.set_steps({steps[0], steps[1], steps[2]}) == Status::success);
    g_assert_true(simulation.set_fractions({fraction, other, 0.0, 0.0}) == Status::success);
    auto const bytes = bytes_of(simulation);
    auto const restored = [&](double old, double number) {
        HardEllipsoids made;
        return hard_ellipsoids_restore(with_number(bytes, old, number), made);
    };
    for (double const old : {steps[0], steps[1], steps[2], fraction, other})
        for (double const number : {-1.0, double{NAN}, HUGE_VAL, -HUGE_VAL})
            if (restored(old, number) != Status::invalid_argument)
                g_test_fail_printf("%a for %a", number, old);
    for (double const old : {steps[0], steps[1], steps[2]})
        g_assert_true(restored(old, 0.5) == Status::success);
    g_assert_true(restored(steps[0], 0.0) == Status::invalid_argument);
    g_assert_true(restored(fraction, 0.5) == Status::invalid_argument);
}

} // namespace
