// SPDX-License-Identifier: BSD-3-Clause
// Insertions and removals of particles in simulations: against ideal gases, hard spheres, small
// systems that can be counted, and themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "cases.hpp"
#include "hard_particles.hpp"
#include "threads.hpp"

using namespace pw85_tests;

namespace {

constexpr double pi = 3.14159265358979323846;

/// A simulation of a cell without particles, of some dimensions.
HardEllipsoids empty(pw85::Cell const &cell, int dimensions = 3, std::size_t seed = 1)
{
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    pw85::Particles const particles{{}, {}, &cell, {1, 1, dimensions == 3}};
    g_assert_true(hard_ellipsoids_create(particles, {}, {}, seed, simulation, pair) ==
                  Status::success);
    g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
    g_assert_true(simulation.set_steps({0.3, 0.3, 0.1}) == Status::success);
    return simulation;
}

void exchange(HardEllipsoids &simulation, std::size_t moves, std::vector<Vector3> const &axes,
              std::vector<double> const &activities)
{
    std::array<std::int64_t, 4> counts;
    g_assert_true(simulation.insertion_moves(moves, axes, activities, counts) == Status::success);
    g_assert_cmpint(counts[0] + counts[2], ==, static_cast<std::int64_t>(moves));
    g_assert_true(counts[1] <= counts[0] && counts[3] <= counts[2]);
}

double count_of(HardEllipsoids const &simulation, Vector3 const &axes)
{
    double count = 0.0;
    for (Vector3 const &one : simulation.semi_axes())
        count += one[0] == axes[0] && one[1] == axes[1];
    return count;
}

// Points: the numbers of both kinds have Poisson's distribution with the means zV, and are
// independent.
PW85_TEST("/insertion/ideal_gas")
{
    std::vector<Vector3> const axes = {{1e-9, 2e-9, 1e-9}, {1e-9, 1e-9, 1e-9}};
    std::vector<double> const activities = {2.0, 0.5};
    for (int const dimensions : {3, 2}) {
        HardEllipsoids simulation = empty(box(2, 1.5, dimensions == 2 ? 7.0 : 1.0), dimensions);
        Blocks first(2000), second(2000), square(2000), product(2000);
        for (int k = 0; k < 200000; ++k) {
            exchange(simulation, 20, axes, activities);
            double const a = count_of(simulation, axes[0]) - 6.0,
                         b = count_of(simulation, axes[1]) - 1.5;
            first.add(a);
            second.add(b);
            square.add(a * a);
            product.add(a * b);
        }
        first.expect("mean of the first kind", 0.0);
        second.expect("mean of the second kind", 0.0);
        square.expect("variance", 6.0);
        product.expect("covariance", 0.0);
    }
}

/// βμ_ex of hard spheres by the equation of state of Carnahan and Starling.
double excess_of_spheres(double eta)
{
    return eta * (8.0 + eta * (-9.0 + 3.0 * eta)) / ((1.0 - eta) * (1.0 - eta) * (1.0 - eta));
}

// At constant volume -ln w is the difference of the free energies of N + 1 and N spheres, which is
// μ of N + 1/2 spheres up to 1/N². With this μ as activity, there are N spheres on average, up to
// 1/N. Both are some 0.1 % here.
PW85_TEST("/insertion/hard_spheres")
{
    constexpr int n = 125;
    double const eta = 0.25, side = std::cbrt(n * pi / 6.0 / eta);
    Start start;
    for (int k = 0; k < n; ++k)
        start.add(0.2 * side * Vector3{double(k % 5), double(k / 5 % 5), double(k / 25)},
                  {0.5, 0.5, 0.5});
    start.cell = box(side, side, side);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.tune(200, 0.4) == Status::success);
    int const samples = g_test_perf() ? 40000 : 2000;
    Blocks weights(samples / 40);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(2) == Status::success);
        double weight;
        g_assert_true(simulation.insertion_weight(200, {0.5, 0.5, 0.5}, weight) == Status::success);
        weights.add(weight);
    }
    double const expected = std::exp(-excess_of_spheres(eta * (n + 0.5) / n));
    weights.expect("part of free places", expected, 0.003 * expected);

    double const activity = n / (side * side * side) * std::exp(excess_of_spheres(eta));
    Blocks numbers(samples / 40), difference(samples / 40);
    for (int k = 0; k < 2 * samples; ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        exchange(simulation, 100, {{0.5, 0.5, 0.5}}, {activity});
        auto const count = static_cast<double>(simulation.system().num_particles);
        double weight;
        g_assert_true(simulation.insertion_weight(50, {0.5, 0.5, 0.5}, weight) == Status::success);
        numbers.add(count);
        difference.add(count / n - activity * side * side * side * weight / n);
    }
    numbers.expect("number of spheres", n, 0.005 * n);
    difference.expect("N - zVw", 0.0);
    expect_no_overlap(simulation);
}

/// A well: βU = -0.3 up to μ² = 2, and from there a cubic polynomial to 0 at 2.25.
constexpr double well[] = {1.0, 2.25, -0.3, 0, -0.3, 0, -0.3, 0, -0.3, 0, -0.3, 0, 0, 0};

/// βU of two spheres of diameter 1.
double attraction(double square)
{
    double const s = std::clamp(4.0 * (square - 2.0), 0.0, 1.0);
    return -0.3 * (1.0 - s * s * (3.0 - 2.0 * s));
}

/// The energy of two spheres in a cube with periodic images; infinite if they overlap.
double attraction_in_cube(Vector3 const &r, double side)
{
    double sum = 0.0;
    for (int k = 13; k < 40; ++k) { // the middle first
        int const n = k % 27;
        Vector3 const image =
            r + side * Vector3{double(n % 3 - 1), double(n / 3 % 3 - 1), double(n / 9 - 1)};
        double const square = dot(image, image);
        if (square < 1.0) return HUGE_VAL;
        sum += attraction(square);
    }
    return sum;
}

/// The mean of e^-βU over the places of a second sphere, by the midpoints of cubes of an octant.
double mean_of_second(double side)
{
    constexpr int n = 200;
    double sum = 0.0;
    for (int k = 0; k < n * n * n; ++k) {
        Vector3 const r = {k % n + 0.5, k / n % n + 0.5, k / n / n + 0.5};
        sum += std::exp(-attraction_in_cube(0.5 * side / n * r, side));
    }
    return sum / (n * n * n);
}

// An attractive sphere in a cube that is wider than the law reaches.
PW85_TEST("/insertion/reach")
{
    constexpr double side = 3.2;
    Vector3 const axes = {0.5, 0.5, 0.5};
    HardEllipsoids simulation = empty(box(side, side, side));
    g_assert_true(simulation.set_law({PW85_LAW_TABLE, well}) == Status::success);
    bool is_free;
    g_assert_true(simulation.insert({0.2, 0.3, 0.4}, {1, 0, 0, 0}, axes, true, is_free) ==
                  Status::success);
    Blocks weights(20);
    for (int k = 0; k < 2000; ++k) {
        double weight;
        g_assert_true(simulation.insertion_weight(500, axes, weight) == Status::success);
        weights.add(weight);
    }
    constexpr int n = 1000;
    double sum = std::pow(side, 3) - 4.0 / 3.0 * pi * 3.375;
    for (int k = 0; k < n; ++k) {
        double const r = 1.0 + 0.5 * (k + 0.5) / n;
        sum += 0.5 / n * 4.0 * pi * r * r * std::exp(-attraction(r * r));
    }
    double const expected = sum / std::pow(side, 3);
    weights.expect("weight", expected, 1e-6 * expected);
}

// Attractive spheres in a cube with room for two. Each has six images of itself within the cutoff,
// and so the energy of three pairs. Among three points of a cube some are nearer to each other than
// the half of a diagonal of a face, 0.98 here.
PW85_TEST("/insertion/attraction")
{
    constexpr double side = 1.38, volume = side * side * side, activity = 1.0;
    Vector3 const axes = {0.5, 0.5, 0.5};
    double const own = std::exp(-3.0 * attraction(side * side)), second = mean_of_second(side);
    HardEllipsoids simulation = empty(box(side, side, side));
    g_assert_true(simulation.set_law({PW85_LAW_TABLE, well}) == Status::success);
    double weight;
    g_assert_true(simulation.insertion_weight(10, axes, weight) == Status::success);
    g_assert_cmpfloat_with_epsilon(weight, own, 1e-8); // the same everywhere
    bool is_free;
    g_assert_true(simulation.insert({0.2, 0.3, 0.4}, {1, 0, 0, 0}, axes, true, is_free) ==
                  Status::success);
    Blocks weights(20);
    for (int k = 0; k < 2000; ++k) {
        g_assert_true(simulation.insertion_weight(500, axes, weight) == Status::success);
        weights.add(weight);
    }
    // The midpoints are wrong by some 10⁻⁴ at the surfaces of the spheres.
    weights.expect("weight of a second sphere", own * second, 3e-4 * own * second);

    double const one = activity * volume * own, two = 0.5 * one * one * second,
                 all = 1.0 + one + two;
    int const samples = g_test_perf() ? 200000 : 20000;
    Blocks numbers[3] = {Blocks(samples / 50), Blocks(samples / 50), Blocks(samples / 50)};
    for (int k = 0; k < samples; ++k) {
        exchange(simulation, 30, {axes}, {activity});
        std::size_t const count = simulation.system().num_particles;
        g_assert_cmpuint(count, <=, 2);
        for (std::size_t n = 0; n < 3; ++n) numbers[n].add(count == n);
    }
    numbers[0].expect("no sphere", 1.0 / all, 1e-4);
    numbers[1].expect("one sphere", one / all, 1e-4);
    numbers[2].expect("two spheres", two / all, 1e-4);
}

// ⟨N⟩ = zV⟨w⟩ holds exactly for each kind, in any field, with any law, and in the plane.
PW85_TEST("/insertion/identity")
{
    auto const potential = [](std::int32_t, Vector3 const &x, Quaternion const &,
                              Vector3 const &axes) {
        return axes[1] * std::cos(2.0 * pi * x[0] / 3.0);
    };
    for (int const test : {0, 1, 2, 3}) {
        int const dimensions = test % 2 == 0 ? 3 : 2;
        std::vector<Vector3> const axes = {{0.3, 0.6, 0.2}, {0.25, 0.25, 0.4}};
        std::vector<double> const activities = {0.6, 0.9};
        double const side = dimensions == 2 ? 1.0 : 3.0, volume = dimensions == 2 ? 12.0 : 36.0;
        HardEllipsoids simulation = empty({{{3, 0, 0}, {0.5, 4, 0}, {0, 0, side}}}, dimensions);
        pw85::Field const field = pw85::Field::aligning({1, 0, 0}, 1.0, 1);
        g_assert_true(simulation.set_potential(potential) == Status::success);
        g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
        if (test >= 2) g_assert_true(simulation.set_law({PW85_LAW_TABLE, well}) == Status::success);
        int const samples = g_test_perf() ? 200000 : test < 2 ? 8000 : 2000;
        Blocks differences[2] = {Blocks(samples / 50), Blocks(samples / 50)};
        for (int k = 0; k < samples; ++k) {
            exchange(simulation, 40, axes, activities);
            if (k % 3 == 0) g_assert_true(simulation.sweep(1) == Status::success);
            for (std::size_t kind = 0; kind < 2; ++kind) {
                double weight;
                g_assert_true(simulation.insertion_weight(20, axes[kind], weight) ==
                              Status::success);
                differences[kind].add(count_of(simulation, axes[kind]) -
                                      activities[kind] * volume * weight);
            }
        }
        for (Blocks const &one : differences) one.expect("N - zVw", 0.0);
        expect_no_overlap(simulation);
    }
}

// A cell with room for one particle is empty or full. It may touch its own images, and more so in
// some orientations.
PW85_TEST("/insertion/full_cell")
{
    auto const potential = [](std::int32_t, Vector3 const &x, Quaternion const &, Vector3 const &) {
        return 2.0 * std::cos(2.0 * pi * x[2]);
    };
    Vector3 const axes = {0.3, 0.55, 0.45};
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    Blocks free(2000);
    for (int k = 0; k < 100000; ++k) {
        Quaternion turn = {normal(random), normal(random), normal(random), normal(random)};
        auto const q = pw85::ellipsoid_quaternion(axes, turn / std::sqrt(dot(turn, turn))).q;
        bool is_free = true;
        for (int n = 14; n < 27; ++n) {
            Vector3 const r = {double(n % 3 - 1), double(n / 3 % 3 - 1), double(n / 9 - 1)};
            is_free = is_free && pw85::contact(r, q, q).mu2 >= 1.0;
        }
        free.add(is_free);
    }
    constexpr double activity = 0.8, bessel = 2.2795853023360673; // I₀(2)
    HardEllipsoids simulation = empty(box(1, 1, 1));
    g_assert_true(simulation.set_potential(potential) == Status::success);
    Blocks full(4000);
    for (int k = 0; k < 400000; ++k) {
        exchange(simulation, 4, {axes}, {activity});
        full.add(static_cast<double>(simulation.system().num_particles));
        g_assert_cmpuint(simulation.system().num_particles, <=, 1);
    }
    double const weight = activity * bessel * free.mean();
    g_assert_true(free.mean() > 0.1 && free.mean() < 0.9);
    full.expect("full cells", weight / (1.0 + weight), 4.0 * free.error() / free.mean() * 0.25);

    // those that cannot touch their images beside those that can
    HardEllipsoids mixture = empty(box(1, 1, 1));
    double num_long = 0.0;
    for (int k = 0; k < 100; ++k) {
        exchange(mixture, 20, {{0.1, 0.1, 0.1}, axes}, {1.0, 5.0});
        expect_no_overlap(mixture);
        num_long += count_of(mixture, axes);
    }
    g_assert_true(num_long > 20.0);
}

/// A crowded mixture in a cell that is sheared.
HardEllipsoids crowded(int dimensions, std::size_t seed)
{
    HardEllipsoids simulation =
        empty({{{5, 0, 0}, {1, 4, 0}, {0, 0, dimensions == 2 ? 1.0 : 6.0}}}, dimensions, seed);
    exchange(simulation, 20000, {{0.3, 0.6, 0.4}, {0.5, 0.5, 0.2}}, {3.0, 2.0});
    return simulation;
}

// Insertions and removals beside sweeps: the same bits with any number of threads and after a
// restart, and no overlap.
PW85_TEST("/insertion/threads_and_restart")
{
    for (int const dimensions : {3, 2}) {
        auto const run = [&](int threads, int restarts, std::size_t at_once) {
            Threads const used(threads);
            HardEllipsoids simulation = crowded(dimensions, 5);
            for (int k = 0; k < 12; ++k) {
                g_assert_true(simulation.sweep(2) == Status::success);
                for (std::size_t done = 0; done < 300; done += at_once)
                    exchange(simulation, at_once, {{0.5, 0.5, 0.2}, {0.3, 0.6, 0.4}}, {1.5, 1.0});
                double weight;
                g_assert_true(simulation.insertion_weight(7, {0.1, 0.2, 0.3}, weight) ==
                              Status::success);
                expect_no_overlap(simulation);
                if (restarts == 0) continue;
                HardEllipsoids again;
                g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), again) ==
                              Status::success);
                simulation = std::move(again);
            }
            return bytes_of(simulation);
        };
        auto const expected = run(1, 0, 300);
        g_assert_true(run(2, 0, 300) == expected);
        g_assert_true(run(2, 1, 300) == expected);
        g_assert_true(run(1, 1, 50) == expected);
    }
}

/// Whether a new particle is free, by a simulation of all particles.
bool is_free_of(HardEllipsoids const &simulation, Vector3 const &center,
                Quaternion const &quaternion, Vector3 const &axes)
{
    pw85_system const system = simulation.system();
    Start start;
    for (std::size_t i = 0; i < system.num_particles; ++i)
        start.add({system.centers[3 * i], system.centers[3 * i + 1], system.centers[3 * i + 2]},
                  simulation.semi_axes()[i], simulation.quaternions()[i]);
    start.add(center, axes, quaternion);
    std::copy_n(system.cell, 9, &start.cell[0][0]);
    start.periodic = {system.periodic[0], system.periodic[1], system.periodic[2]};
    HardEllipsoids other;
    pw85::IndexPair pair;
    Status const status = start.create(other, pair);
    g_assert_true(status == Status::success || status == Status::overlap);
    return status == Status::success;
}

// Particles of all sizes at places in many images, one after the other, with removals between.
PW85_TEST("/insertion/insert_and_remove")
{
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    for (int const dimensions : {3, 2}) {
        HardEllipsoids simulation = crowded(dimensions, 2);
        int num_free = 0, num_taken = 0;
        double const *const first = simulation.system().centers;
        for (int trial = 0; trial < 400; ++trial) {
            double const scale = std::exp(-3.0 * uniform(random));
            Vector3 const axes = scale * Vector3{0.8, 0.5, 0.3};
            Vector3 center = {9 * normal(random), 9 * normal(random),
                              dimensions == 2 ? 0.0 : 9 * normal(random)};
            Quaternion turn = {normal(random), normal(random), normal(random), normal(random)};
            if (dimensions == 2) turn[1] = turn[2] = 0.0;
            bool const expected =
                           is_free_of(simulation, center, turn / std::sqrt(dot(turn, turn)), axes),
                       take = trial % 2 == 0;
            std::size_t const before = simulation.system().num_particles;
            bool found = !expected;
            g_assert_true(simulation.insert(center, turn, axes, take, found) == Status::success);
            if (found != expected) g_test_fail_printf("trial %d: free %d", trial, found);
            std::size_t const after = simulation.system().num_particles;
            g_assert_cmpuint(after, ==, before + (found && take));
            if (found && take) g_assert_true(simulation.semi_axes()[after - 1][1] == axes[1]);
            num_free += found;
            num_taken += found && take;
            if (trial % 7 == 6) {
                std::size_t const i = random() % after;
                double const last = simulation.system().centers[3 * (after - 1)];
                g_assert_true(simulation.remove(i) == Status::success);
                g_assert_cmpuint(simulation.system().num_particles, ==, after - 1);
                if (i + 1 < after) g_assert_true(simulation.system().centers[3 * i] == last);
            }
            if (trial % 20 == 0) g_assert_true(simulation.sweep(1) == Status::success);
        }
        expect_no_overlap(simulation);
        g_assert_true(num_free > 40 && num_taken > 20);
        g_assert_true(std::isfinite(first[0])); // outgrown, but still there
        while (simulation.system().num_particles > 0)
            g_assert_true(simulation.remove(0) == Status::success);
        g_assert_true(simulation.remove(0) == Status::invalid_argument &&
                      simulation.sweep(2) == Status::success);
        bool found;
        g_assert_true(simulation.insert({0, 0, 0}, {1, 0, 0, 0}, {0.3, 0.4, 0.5}, true, found) ==
                      Status::success);
        g_assert_true(found && simulation.sweep(2) == Status::success);
        g_assert_true(simulation.volume_moves(3, 1.0) == Status::success);
    }
}

// A sphere among hundreds of points in the corners of its bounding box, of which at most one is
// inside.
PW85_TEST("/insertion/many_neighbors")
{
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int trial = 0; trial < 20; ++trial) {
        Start start;
        while (start.centers.size() < 300) {
            Vector3 const x = {uniform(random), uniform(random), uniform(random)};
            if (dot(x, x) > 1.1) start.add(x, {1e-4, 1e-4, 1e-4});
        }
        start.cell = box(6, 6, 6);
        bool found;
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.insert({}, {1, 0, 0, 0}, {1, 1, 1}, false, found) ==
                          Status::success &&
                      found);
        start.centers[random() % 300] = {0.6 * uniform(random), 0.6 * uniform(random), 0.4};
        HardEllipsoids other = start.simulation();
        g_assert_true(other.insert({}, {1, 0, 0, 0}, {1, 1, 1}, false, found) == Status::success &&
                      !found);
    }
}

// A slit that exchanges spheres with a reservoir, in a field that aligns nothing and pulls them
// down: for points ⟨N⟩ = z ∫ e^(-U). The walls of the second slit let particles leave the cell,
// where they are neither inserted nor removed. There, U = 0 and the density is z, too.
PW85_TEST("/insertion/slit")
{
    constexpr double g = 0.8, height = 3.0, radius = 1e-6, activity = 0.7;
    for (bool const is_wide : {false, true}) {
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        pw85::Cell const cell = {{{2, 0, 0}, {0.5, 1.5, 0}, {0, 0.3, height}}};
        pw85::Particles const particles{{}, {}, &cell, {1, 1, 0}};
        g_assert_true(hard_ellipsoids_create(particles, {}, {}, 1, simulation, pair) ==
                      Status::success);
        pw85::Wall const walls[] = {
            pw85::Wall::plane({0, 0, -1}, is_wide ? 1.0 : radius),
            pw85::Wall::plane({0, 0, 1}, (is_wide ? 4.0 : height) + radius)};
        g_assert_true(simulation.set_walls(walls, pair) == Status::success);
        pw85::Field const field = pw85::Field::linear({0, 0, g});
        if (!is_wide) g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
        g_assert_true(simulation.set_steps({0.9, 0.5, 0.1}) == Status::success);
        g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
        int const samples = g_test_perf() ? 200000 : 6000;
        Blocks numbers(samples / 50), weights(samples / 50);
        for (int k = 0; k < samples; ++k) {
            exchange(simulation, 4, {{radius, radius, radius}}, {activity});
            g_assert_true(simulation.sweep(1) == Status::success);
            numbers.add(static_cast<double>(simulation.system().num_particles));
            double weight;
            g_assert_true(simulation.insertion_weight(2, {radius, radius, radius}, weight) ==
                          Status::success);
            weights.add(weight);
        }
        double const mean = is_wide ? 1.0 : (1.0 - std::exp(-g * height)) / (g * height);
        numbers.expect("points in a slit", activity * 3.0 * (is_wide ? 5.0 : height * mean));
        if (!is_wide) weights.expect("weight", mean);
    }
}

// Walls and potentials forbid places, in a system without a cell, too.
PW85_TEST("/insertion/walls")
{
    Start start;
    start.add({0, 0, 0}, {0.5, 0.5, 0.5});
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    pw85::Particles const particles{start.centers, {}, nullptr};
    g_assert_true(hard_ellipsoids_create(particles, start.semi_axes, start.quaternions, 1,
                                         simulation, pair) == Status::success);
    pw85::Wall const wall = pw85::Wall::sphere({}, 3.0);
    g_assert_true(simulation.set_walls({&wall, 1}, pair) == Status::success);
    bool found;
    auto const insert = [&](double x) {
        return simulation.insert({x, 0, 0}, {1, 0, 0, 0}, {0.5, 0.5, 0.5}, false, found);
    };
    g_assert_true(insert(1.0) == Status::success && found);
    g_assert_true(insert(0.999) == Status::success && !found);
    g_assert_true(insert(2.5) == Status::success && found);
    g_assert_true(insert(2.501) == Status::success && !found);
    auto const potential = [](std::int32_t i, Vector3 const &x, Quaternion const &,
                              Vector3 const &) {
        return i == 0 ? 0.0 : x[0] > 2.0 ? HUGE_VAL : x[0] < 0.0 ? double{NAN} : 0.0;
    };
    g_assert_true(simulation.set_potential(potential) == Status::success);
    g_assert_true(insert(2.5) == Status::success && !found);
    g_assert_true(insert(-2.0) == Status::bad_potential && !found);
    g_assert_true(insert(1.5) == Status::success && found);
}

// e^-U of wells and barriers beyond the range of double.
PW85_TEST("/insertion/range_of_weights")
{
    HardEllipsoids simulation = empty(box(2, 2, 2));
    for (double const energy : {-1e300, -5000.0, -1450.0, -720.0, 0.0, 701.0, 1e300, HUGE_VAL}) {
        auto const potential = [&](std::int32_t, Vector3 const &, Quaternion const &,
                                   Vector3 const &) { return energy; };
        double weight = -1.0;
        g_assert_true(simulation.set_potential(potential) == Status::success &&
                      simulation.insertion_weight(2, {0.1, 0.1, 0.1}, weight) == Status::success);
        g_assert_cmpfloat(weight, ==, energy < 0.0 ? HUGE_VAL : energy > 0.0 ? 0.0 : 1.0);
    }
}

PW85_TEST("/insertion/bad_input")
{
    Vector3 const axes = {0.3, 0.4, 0.5};
    Quaternion const upright = {1, 0, 0, 0};
    HardEllipsoids simulation = crowded(3, 1);
    auto const before = bytes_of(simulation);
    bool found;
    double weight;
    std::array<std::int64_t, 4> counts;
    auto const moves = [&](HardEllipsoids &one, std::vector<Vector3> const &kinds,
                           std::vector<double> const &activities) {
        return one.insertion_moves(1, kinds, activities, counts);
    };
    g_assert_true(simulation.insert({NAN, 0, 0}, upright, axes, true, found) ==
                      Status::invalid_argument &&
                  !found);
    g_assert_true(simulation.insert({1e15, 0, 0}, upright, axes, true, found) ==
                  Status::invalid_argument);
    g_assert_true(simulation.insert({0, 0, 0}, {0, 0, 0, 0}, axes, true, found) ==
                  Status::invalid_argument);
    for (Vector3 const &bad : {Vector3{0.3, -0.4, 0.5}, Vector3{0.3, 0.4, NAN},
                               Vector3{0.3, 0, 0.5}, Vector3{0.3, 0.4, 200}}) {
        g_assert_true(simulation.insert({}, upright, bad, true, found) == Status::invalid_argument);
        g_assert_true(simulation.insertion_weight(5, bad, weight) == Status::invalid_argument &&
                      std::isnan(weight));
        g_assert_true(moves(simulation, {bad}, {1.0}) == Status::invalid_argument &&
                      counts[0] == -1);
    }
    for (double const activity : {0.0, -1.0, double{NAN}, HUGE_VAL})
        g_assert_true(moves(simulation, {axes}, {activity}) == Status::invalid_argument);
    g_assert_true(moves(simulation, {}, {}) == Status::invalid_argument);
    g_assert_true(moves(simulation, {axes, axes}, {1.0, 2.0}) == Status::invalid_argument);
    g_assert_true(simulation.insertion_weight(0, axes, weight) == Status::success &&
                  std::isnan(weight));
    g_assert_true(simulation.remove(1000) == Status::invalid_argument);
    g_assert_true(bytes_of(simulation) == before);
    auto const bad_potential = [&](std::int32_t, Vector3 const &, Quaternion const &,
                                   Vector3 const &one) {
        return one[0] == axes[0] && one[1] == axes[1] ? double{NAN} : 0.0;
    };
    g_assert_true(simulation.set_potential(bad_potential) == Status::success);
    auto const with_potential = bytes_of(simulation);
    std::vector<Vector3> const kinds = {axes};
    std::vector<double> const activities = {1.0};
    g_assert_true(simulation.insertion_moves(50, kinds, activities, counts) ==
                  Status::bad_potential);
    g_assert_true(simulation.insertion_weight(500, axes, weight) == Status::bad_potential &&
                  std::isnan(weight));
    HardEllipsoids restored;
    g_assert_true(hard_ellipsoids_restore(with_potential, restored) == Status::success);
    g_assert_true(moves(restored, kinds, activities) == Status::bad_potential);
    g_assert_true(restored.insertion_weight(1, axes, weight) == Status::bad_potential);
    g_assert_true(restored.insert({}, upright, axes, true, found) == Status::bad_potential);
    g_assert_true(restored.remove(0) == Status::bad_potential &&
                  bytes_of(restored) == with_potential);

    HardEllipsoids flat = crowded(2, 1), none;
    g_assert_true(flat.insert({0, 0, 1}, upright, axes, true, found) == Status::invalid_argument);
    g_assert_true(flat.insert({0, 0, 0}, {1, 0.1, 0, 0}, axes, true, found) ==
                  Status::invalid_argument);
    Start slab;
    slab.add({0, 0, 0}, axes);
    slab.cell = box(2, 2, 0);
    slab.periodic = {1, 1, 0};
    HardEllipsoids open = slab.simulation();
    g_assert_true(open.insertion_weight(1, axes, weight) == Status::invalid_argument);
    g_assert_true(moves(open, {axes}, {1.0}) == Status::invalid_argument);
    g_assert_true(none.insertion_weight(1, axes, weight) == Status::invalid_argument);
    g_assert_true(moves(none, {axes}, {1.0}) == Status::invalid_argument);
    g_assert_true(none.insert({}, upright, axes, true, found) == Status::invalid_argument);
    g_assert_true(none.remove(0) == Status::invalid_argument);
    g_assert_cmpint(pw85_hard_ellipsoids_insert(flat.get(), nullptr, nullptr, nullptr, 0, nullptr),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_hard_ellipsoids_insertion_weight(flat.get(), 1, nullptr, nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(
        pw85_hard_ellipsoids_insertion_moves(flat.get(), 1, 1, nullptr, nullptr, nullptr), ==,
        PW85_EINVAL);
}

} // namespace
