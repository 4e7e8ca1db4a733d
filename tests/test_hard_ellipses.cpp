// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of hard ellipses, which are ellipsoids in a plane of z: against exact distributions,
// virial coefficients, the overlap test of ellipses, and themselves.
#include <algorithm>
#include <cstring>
#include <random>

#include <pw85.h>

#include "cases.hpp"
#include "hard_particles.hpp"
#include "saved_sections.hpp"

using namespace pw85_tests;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int sizes[] = {-40, 0, 40};

/// Where an ellipse is, and how it is turned.
struct Place {
    double x, y, angle = 0.0;
};

Quaternion turn_by(double angle)
{
    return {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)};
}

/// The arguments of a simulation of ellipses, in the plane z = height.
struct Plane : Start {
    double height = 0.25, third = 0.7; ///< third semi-axes do not matter

    void add_ellipse(Place const &place, double a, double b)
    {
        add({place.x, place.y, height}, {a, b, third}, turn_by(place.angle));
    }

    void set_cell(double x, double tilt, double y)
    {
        cell = {{{x, 0.0, 0.0}, {tilt, y, 0.0}, {0.0, 0.0, 3.0}}};
        periodic = {1, 1, 0};
    }

    /// Multiplies all lengths.
    void scale(double unit)
    {
        for (Vector3 &center : centers) center = unit * center;
        for (Vector3 &axes : semi_axes) axes = unit * axes;
        for (Vector3 &vector : cell) vector = unit * vector;
    }

    HardEllipsoids ellipses(std::size_t seed = 1) const
    {
        HardEllipsoids made = simulation(seed);
        g_assert_cmpint(made.dimensions(), ==, 3);
        g_assert_true(made.set_dimensions(2) == Status::success);
        g_assert_cmpint(made.dimensions(), ==, 2);
        return made;
    }
};

/// Ellipses of two kinds on a lattice of n² places, in a cell that is sheared.
Plane mixture(int n)
{
    Plane plane;
    double const x = 1.3, y = 2.2;
    for (int k = 0; k < n * n; ++k) {
        Place const place = {x * (k % n) + 0.3 * x * (k / n), y * (k / n)};
        plane.add_ellipse(place, k % 3 == 0 ? 0.45 : 0.5, k % 3 == 0 ? 0.8 : 1.0);
    }
    plane.set_cell(x * n, 0.3 * x * n, y * n);
    return plane;
}

double angle_of(Quaternion const &q) { return 2.0 * std::atan2(q[3], q[0]); }

/// Two unlike ellipses in a cell.
struct TwoEllipses {
    static constexpr double axes[2][2] = {{0.3, 0.9}, {0.6, 0.25}}, side = 2.2;

    /// The least μ² of all images that can be near, by the contact function of ellipses, cos 2θ of
    /// the angle between the ellipses, and the square of that of the first one in the cell.
    static std::array<double, 3> measure(Place const &first, Place const &second, double const *a,
                                         double const *b)
    {
        double q1[3], q2[3], least = HUGE_VAL;
        pw85_ellipse(a[0], a[1], first.angle, q1);
        pw85_ellipse(b[0], b[1], second.angle, q2);
        double const x = second.x - first.x, y = second.y - first.y;
        for (int k = 0; k < 9; ++k) {
            double const r[2] = {x + side * (k % 3 - 1 - std::nearbyint(x / side)),
                                 y + side * (k / 3 - 1 - std::nearbyint(y / side))};
            double out[2];
            pw85_contact_2d(r, q1, q2, out);
            least = std::min(least, out[0]);
        }
        double const along = std::cos(2.0 * first.angle);
        return {least, std::cos(2.0 * (second.angle - first.angle)), along * along};
    }
};

PW85_TEST("/hard_ellipses/two_ellipses")
{
    auto const &axes = TwoEllipses::axes;
    Plane plane;
    plane.add_ellipse({0.0, 0.0}, axes[0][0], axes[0][1]);
    plane.add_ellipse({1.1, 1.1}, axes[1][0], axes[1][1]);
    plane.set_cell(TwoEllipses::side, 0.0, TwoEllipses::side);
    HardEllipsoids simulation = plane.ellipses();
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform;
    auto const draw = [&] {
        Place const first = {0.0, 0.0, 2 * pi * uniform(random)},
                    second = {TwoEllipses::side * uniform(random),
                              TwoEllipses::side * uniform(random), 2 * pi * uniform(random)};
        return TwoEllipses::measure(first, second, axes[0], axes[1]);
    };
    expect_two_bodies<3>(simulation, {"near", "aligned", "along the cell"}, 40000, draw,
                         [](HardEllipsoids const &all) {
                             double const *const c = all.system().centers;
                             auto const q = all.quaternions();
                             auto const own = all.semi_axes();
                             return TwoEllipses::measure({c[0], c[1], angle_of(q[0])},
                                                         {c[3], c[4], angle_of(q[1])},
                                                         own[0].coordinates, own[1].coordinates);
                         });
}

PW85_TEST("/hard_ellipses/detailed_balance")
{
    Plane plane = mixture(4);
    for (Vector3 &center : plane.centers) center = {1.3 * center[0], 1.3 * center[1], center[2]};
    for (Vector3 &vector : plane.cell) vector = 1.3 * vector;
    HardEllipsoids simulation = plane.ellipses();
    g_assert_true(simulation.set_steps({0.9, 0.7, 0.1}) == Status::success);
    expect_detailed_balance(simulation, 12000);
}

// An ellipse alone: translations are uniform in a disc, whose mean square is 1/2, and turns by 2
// atan(v) have a uniform v.
PW85_TEST("/hard_ellipses/steps")
{
    constexpr double longest = 0.25, largest = 0.75;
    Plane plane;
    plane.add_ellipse({0.0, 0.0}, 0.5, 1.0);
    // too small for two domains, at whose border trials would be rejected
    plane.set_cell(4.0, 0.0, 4.0);
    HardEllipsoids simulation = plane.ellipses();
    g_assert_true(simulation.set_fractions({0, 0, 1, 0}) == Status::success);
    g_assert_true(simulation.set_steps({longest, largest, 0.1}) == Status::success);
    Blocks x(200), y(200), square(200), fourth(200), mixed(200), v(200), v2(200), v4(200);
    for (int k = 0; k < 20000; ++k) {
        double const *const c = simulation.system().centers;
        double const old[3] = {c[0], c[1], angle_of(simulation.quaternions()[0])};
        g_assert_true(simulation.sweep(1) == Status::success);
        double const dx = (c[0] - old[0]) / longest, dy = (c[1] - old[1]) / longest,
                     r2 = dx * dx + dy * dy;
        double const turn =
            std::tan(0.5 * (angle_of(simulation.quaternions()[0]) - old[2])) / largest;
        x.add(dx), y.add(dy), square.add(r2), fourth.add(r2 * r2), mixed.add(dx * dy);
        v.add(turn), v2.add(turn * turn), v4.add(turn * turn * turn * turn);
    }
    x.expect("mean x", 0.0), y.expect("mean y", 0.0), mixed.expect("mean xy", 0.0);
    square.expect("mean square", 1.0 / 2), fourth.expect("mean fourth power", 1.0 / 3);
    v.expect("mean turn", 0.0), v2.expect("square of turns", 1.0 / 3),
        v4.expect("fourth power of turns", 1.0 / 5);
}

PW85_TEST("/hard_ellipses/ideal_gas")
{
    auto const make = [](double area, std::size_t seed) {
        double const side = std::sqrt(area);
        Plane gas;
        gas.third = 1e-9;
        for (int k = 0; k < 4; ++k)
            gas.add_ellipse({0.5 * side * (k & 1), 0.5 * side * (k >> 1)}, 1e-9, 2e-9);
        // of this area
        gas.cell = {{{side, 0.4 * side, 0.0}, {-0.2 * side, 0.92 * side, 0.0}, {0.0, 0.0, 3.0}}};
        gas.periodic = {1, 1, 0};
        HardEllipsoids simulation = gas.ellipses(seed);
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.9}) == Status::success);
        return simulation;
    };
    expect_ideal_gas(4.0, make);
}

// Shears change the tilt of a cell, scalings of one axis its shape; isotropic changes do neither.
PW85_TEST("/hard_ellipses/kinds_of_changes")
{
    for (CellChange const change :
         {CellChange::isotropic, CellChange::axis, CellChange::triclinic}) {
        HardEllipsoids simulation = mixture(4).ellipses();
        g_assert_true(simulation.set_steps({0.1, 0.1, 0.02}) == Status::success);
        g_assert_true(simulation.volume_moves(100, 1.5, change) == Status::success);
        g_assert_cmpint(simulation.counts().accepted[4], >, 10);
        double const *const c = simulation.system().cell;
        g_assert_true(c[1] == 0.0);
        bool const same_shape = std::fabs(c[4] / c[0] - 2.2 / 1.3) < 1e-12,
                   same_tilt = std::fabs(c[3] / c[0] - 0.3) < 1e-12;
        g_assert_true(same_shape == (change == CellChange::isotropic));
        g_assert_true(same_tilt == (change != CellChange::triclinic));
    }
}

/// βP/ρ of N hard discs by B2 to B6 at area fraction η. In a periodic cell the term of B2 has the
/// factor 1 - 1/N: two particles are a pair.
double virials(double eta, double n)
{
    double const x = 2.0 * eta; // B2 ρ
    return 1.0 + x * (1.0 - 1.0 / n) +
           x * x * (0.78200 + x * (0.53223 + x * (0.33356 + x * 0.19884)));
}

/// Discs of diameter 1, stretched along y by an aspect ratio, on a lattice.
Plane discs(int n, double eta, double aspect)
{
    Plane plane;
    double const side = std::sqrt(pi / 4 / eta);
    for (int k = 0; k < n * n; ++k)
        plane.add_ellipse({side * (k % n) + side * (k / n), aspect * side * (k / n)}, 0.5,
                          0.5 * aspect);
    plane.set_cell(side * n, side * n, aspect * side * n);
    return plane;
}

/// Chains between which there are as many along random directions: chains along one direction keep
/// the coordinates across it.
Blocks pressures_of_chains(HardEllipsoids &simulation, int blocks, std::size_t chains,
                           double length, double const *direction)
{
    Blocks z(1);
    double ignored, found;
    for (int k = 0; k < blocks; ++k) {
        g_assert_true(simulation.chain(chains, length, ignored) == Status::success);
        g_assert_cmpint(
            pw85_hard_ellipsoids_chain(simulation.get(), chains, length, direction, &found), ==,
            PW85_SUCCESS);
        z.add(found);
    }
    return z;
}

// Discs; and parallel ellipses, which are discs in other units along y, so that βP/ρ is the same
// along all directions. Beyond B6 the series has some 0.12 x⁶, and finite systems some 3/N of the
// term of B3.
PW85_TEST("/hard_ellipses/virials")
{
    double const oblique[3] = {1, -2, 0}, axis[3] = {0, 3, 0};
    struct {
        double eta, aspect;
        int size;
        double const *direction;
    } const all[] = {{0.1, 1.0, 0, nullptr},
                     {0.2, 1.0, 40, oblique},
                     {0.2, 3.0, -40, axis},
                     {0.15, 0.25, 0, nullptr}};
    for (auto const &one : all) {
        constexpr int side = 14;
        Plane plane = discs(side, one.eta, one.aspect);
        plane.scale(std::ldexp(1.0, one.size));
        HardEllipsoids simulation = plane.ellipses();
        double const length = std::ldexp(15.0, one.size);
        pressures_of_chains(simulation, 1, 200, length, nullptr);
        Blocks const z = pressures_of_chains(simulation, 40, 50, length, one.direction);
        double const x = 2.0 * one.eta, n = side * side;
        z.expect("virials", virials(one.eta, n), 0.12 * std::pow(x, 6) + 3.0 / n * x * x);
        g_assert_cmpfloat(z.error(), <, 0.01);
        expect_no_overlap(simulation);
    }
}

// At the pressure of the virials the density is that of the virials. That of N particles differs by
// some (βP/ρ - 1)/N.
PW85_TEST("/hard_ellipses/density")
{
    constexpr double eta = 0.2, density = 4 * eta / pi;
    constexpr int side = 12;
    double const z = virials(eta, HUGE_VAL);
    HardEllipsoids simulation = discs(side, eta, 1.0).ellipses();
    expect_density(simulation, density, z, 0.5, 8000, density * (z - 1) / (side * side));
}

// Ellipses at constant area have a pressure, by chains; at this pressure they have their density
// again.
PW85_TEST("/hard_ellipses/chains_and_areas")
{
    constexpr int n = 8;
    Plane plane;
    // area fraction 0.59 with axes of 0.5 and 1
    double const x = 1.15, y = 2.3, density = 1 / (x * y);
    for (int k = 0; k < n * n; ++k) plane.add_ellipse({x * (k % n), y * (k / n)}, 0.5, 1.0);
    plane.set_cell(x * n, 0.0, y * n);
    HardEllipsoids simulation = plane.ellipses();
    g_assert_true(simulation.tune(1000, 0.4) == Status::success);
    int const rounds = g_test_perf() ? 3000 : 600;
    Blocks pressures(rounds / 20), densities(rounds / 20);
    for (int k = 0; k < rounds; ++k) {
        double z;
        g_assert_true(simulation.sweep(20) == Status::success);
        g_assert_true(simulation.chain(20, 10.0, z) == Status::success);
        pressures.add(z);
    }
    double const z = pressures.mean(), pressure = z * density;
    g_assert_true(simulation.tune(500, 0.4, pressure) == Status::success);
    for (int k = 0; k < rounds; ++k)
        for (int i = 0; i < 20; ++i) {
            g_assert_true(simulation.sweep(1) == Status::success);
            g_assert_true(simulation.volume_moves(3, pressure) == Status::success);
            if (i == 19) densities.add(n * n / measure_of(simulation));
        }
    // d ln ρ/d ln P is at most 1/(βP/ρ): pressures grow faster than densities.
    g_test_message("βP/ρ = %.4f +- %.4f", z, pressures.error());
    densities.expect("density", density, density * (4.0 * pressures.error() / z + 1.0 / (n * n)));
}

/// Whether numbers have the same bits, so that zeros have the same signs.
bool are_same(std::vector<double> const &x, std::vector<double> const &y)
{
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

/// z of centres and cell, the third vector, and x and y of quaternions.
std::vector<double> upright_numbers(HardEllipsoids const &simulation)
{
    auto const system = simulation.system();
    std::vector<double> numbers = {system.cell[2], system.cell[5], system.cell[6], system.cell[7],
                                   system.cell[8]};
    for (std::size_t i = 0; i < system.num_particles; ++i) {
        auto const &turn = simulation.quaternions()[i];
        numbers.insert(numbers.end(), {system.centers[3 * i + 2], turn[1], turn[2]});
    }
    return numbers;
}

// Everything that a simulation can do, with zeros of both signs: not one bit leaves the plane.
PW85_TEST("/hard_ellipses/nothing_leaves_the_plane")
{
    for (int const size : sizes)
        for (double const height : {0.0, 0.3, -7.0}) {
            Plane plane = mixture(6);
            std::size_t const n = plane.centers.size();
            for (std::size_t i = 0; i < n; ++i) {
                plane.centers[i][2] = i % 2 == 0 && height == 0.0 ? -0.0 : height;
                for (int d = 1; d <= 2; ++d)
                    plane.quaternions[i][d] = (i >> d) % 2 == 0 ? -0.0 : 0.0;
            }
            plane.cell[1][2] = plane.cell[2][0] = -0.0;
            double const unit = std::ldexp(1.0, size);
            plane.scale(unit);
            HardEllipsoids simulation = plane.ellipses();
            auto const before = upright_numbers(simulation);
            double const oblique[3] = {1, 2, 0}, pressure = 1.5 / (unit * unit);
            g_assert_true(simulation.set_fractions({3, 3, 2, 1}) == Status::success);
            g_assert_true(simulation.tune(20, 0.4, pressure, CellChange::triclinic) ==
                          Status::success);
            try_everything(simulation, 6, pressure);
            double z, factor;
            bool is_free;
            g_assert_true(simulation.chain(20, 10 * unit, z) == Status::success);
            g_assert_cmpint(
                pw85_hard_ellipsoids_chain(simulation.get(), 20, 10 * unit, oblique, &z), ==,
                PW85_SUCCESS);
            g_assert_true(simulation.compress(true, factor) == Status::success && factor > 0.1);
            try_everything(simulation, 3, pressure);
            double const *const c = simulation.system().centers;
            Vector3 const there = {c[0] + 1e-6 * unit, c[1], height == 0.0 ? 0.0 : c[2]};
            g_assert_true(simulation.try_placement(0, there, simulation.quaternions()[0], true,
                                                   is_free) == Status::success);
            auto const after = upright_numbers(simulation);
            g_assert_true(are_same(after, before));
            auto const counts = simulation.counts();
            for (std::size_t k = 0; k < 5; ++k) g_assert_cmpint(counts.accepted[k], >, 0);
            expect_no_overlap(simulation);
        }
}

/// The form of an ellipse of a simulation.
std::array<double, 3> form_of(HardEllipsoids const &simulation, std::size_t i)
{
    double const *const q = simulation.system().q + 6 * i;
    g_assert_true(q[2] == 0.0 && q[4] == 0.0);
    return {q[0], q[1], q[3]};
}

/// Whether an ellipse with this centre and form overlaps any image of the others or of itself, by
/// the test of ellipses.
bool overlaps_2d(HardEllipsoids const &simulation, std::size_t i, Vector3 const &center,
                 double const *q)
{
    auto const system = simulation.system();
    double const *const cell = system.cell;
    for (std::size_t j = 0; j < system.num_particles; ++j)
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y) {
                if (i == j && x == 0 && y == 0) continue;
                double const *const other = i == j ? center.coordinates : system.centers + 3 * j;
                // As in src/simulation/configuration.hpp, to the last bit
                double const r[2] = {(other[0] - center[0]) + (0.0 + x * cell[0] + y * cell[3]),
                                     (other[1] - center[1]) + (0.0 + x * cell[1] + y * cell[4])};
                auto const own = form_of(simulation, j);
                int overlap;
                g_assert_cmpint(pw85_overlap_2d(r, q, i == j ? q : own.data(), &overlap), ==,
                                PW85_SUCCESS);
                if (overlap == 1) return true;
            }
    return false;
}

// After sweeps, chains and changes of the area, no pair overlaps by the exact test of ellipses; and
// that test agrees about each place.
PW85_TEST("/hard_ellipses/overlap_2d")
{
    std::mt19937_64 random(17);
    std::normal_distribution<double> normal;
    for (int const size : sizes) {
        double const unit = std::ldexp(1.0, size);
        Plane plane = mixture(4);
        plane.scale(unit);
        HardEllipsoids simulation = plane.ellipses();
        double factor, z;
        int num_free = 0;
        constexpr int rounds = 40;
        for (int k = 0; k < rounds; ++k) {
            g_assert_true(simulation.sweep(2) == Status::success);
            g_assert_true(simulation.chain(2, 3 * unit, z) == Status::success);
            if (k % 10 == 0) g_assert_true(simulation.compress(true, factor) == Status::success);
            std::size_t const n = plane.centers.size(), i = random() % n;
            for (std::size_t j = 0; j < n; ++j) {
                double const *const c = simulation.system().centers + 3 * j;
                g_assert_false(
                    overlaps_2d(simulation, j, {c[0], c[1], c[2]}, form_of(simulation, j).data()));
            }
            double const *const c = simulation.system().centers + 3 * i;
            double const step = 0.1 * unit;
            Vector3 const there = {c[0] + step * normal(random), c[1] + step * normal(random),
                                   c[2]};
            Quaternion const turn =
                turn_by(angle_of(simulation.quaternions()[i]) + 0.1 * normal(random));
            auto const q = pw85::ellipsoid_quaternion(simulation.semi_axes()[i],
                                                      turn / std::sqrt(dot(turn, turn)))
                               .q;
            double const form[3] = {q[0], q[1], q[3]};
            bool is_free = false;
            g_assert_true(simulation.try_placement(i, there, turn, false, is_free) ==
                          Status::success);
            g_assert_true(is_free == !overlaps_2d(simulation, i, there, form));
            num_free += is_free;
        }
        g_assert_true(0 < num_free && num_free < rounds);
    }
}

/// Centres and orientations, without what is along z.
std::vector<double> flat_numbers(HardEllipsoids const &simulation)
{
    auto const system = simulation.system();
    std::vector<double> numbers = {system.cell[0], system.cell[1], system.cell[3], system.cell[4]};
    for (std::size_t i = 0; i < system.num_particles; ++i) {
        auto const &turn = simulation.quaternions()[i];
        numbers.insert(numbers.end(),
                       {system.centers[3 * i], system.centers[3 * i + 1], turn[0], turn[3]});
    }
    return numbers;
}

// The third semi-axes do not change a bit of what happens in it.
PW85_TEST("/hard_ellipses/third_axes")
{
    std::vector<double> expected;
    for (double const third : {0.7, 1e-4, 1e2, 1e7}) {
        Plane plane = mixture(7);
        for (std::size_t i = 0; i < plane.centers.size(); ++i)
            plane.semi_axes[i][2] = third * (1.0 + 0.1 * static_cast<double>(i % 5));
        HardEllipsoids simulation = plane.ellipses();
        g_assert_true(simulation.set_steps({0.2, 0.1, 0.01}) == Status::success);
        g_assert_true(simulation.set_fractions({3, 3, 2, 1}) == Status::success);
        std::vector<double> found;
        auto const append = [&] {
            auto const numbers = flat_numbers(simulation);
            found.insert(found.end(), numbers.begin(), numbers.end());
        };
        double z;
        try_everything(simulation, 3, 1.5);
        append();
        g_assert_true(simulation.chain(20, 10.0, z) == Status::success);
        append();
        try_everything(simulation, 3, 1.5);
        append();
        if (expected.empty()) expected = found;
        auto const difference =
            std::mismatch(found.begin(), found.end(), expected.begin()).first - found.begin();
        if (!are_same(found, expected))
            g_test_fail_printf("third semi-axes %a: number %td of %zu", third, difference,
                               found.size());
    }
}

PW85_TEST("/hard_ellipses/threads_and_restart")
{
    expect_same_in_threads(mixture(40), 2, 12, [](HardEllipsoids &simulation) {
        double z;
        try_everything(simulation, 3, 1.5);
        g_assert_true(simulation.chain(20, 10.0, z) == Status::success);
        return z;
    });
}

PW85_TEST("/hard_ellipses/long_trials") { expect_same_long_trials(2, 120, 300); }

PW85_TEST("/hard_ellipses/compress")
{
    for (int const size : sizes) {
        Plane plane = mixture(3);
        plane.scale(std::ldexp(1.0, size));
        HardEllipsoids simulation = plane.ellipses();
        g_assert_true(simulation.sweep(50) == Status::success);
        expect_compression(std::move(simulation));
    }
}

// Tuned translations are accepted as often as wanted, too.
PW85_TEST("/hard_ellipses/tune")
{
    expect_tuned_translations(2, 1.2);
    HardEllipsoids simulation = mixture(8).ellipses();
    g_assert_true(simulation.tune(300, 0.4) == Status::success);
    g_assert_true(simulation.sweep(300) == Status::success);
    auto const counts = simulation.counts();
    for (std::size_t k = 0; k < 2; ++k) {
        double const acceptance =
            static_cast<double>(counts.accepted[k]) / static_cast<double>(counts.trials[k]);
        g_assert_cmpfloat(std::fabs(acceptance - 0.4), <, 0.04);
    }
}

// Without a cell, and in a channel: periodic along one vector of two, of which the area does not
// change.
PW85_TEST("/hard_ellipses/open_planes")
{
    for (std::array<int, 3> const &periodic : {std::array{1, 0, 0}, std::array{0, 1, 0}}) {
        Plane plane = mixture(5);
        plane.periodic = periodic;
        HardEllipsoids simulation = plane.ellipses();
        double z;
        g_assert_true(simulation.sweep(50) == Status::success);
        g_assert_true(simulation.chain(20, 5.0, z) == Status::success);
        g_assert_true(simulation.volume_moves(1, 1.0) == Status::invalid_argument);
        expect_no_overlap(simulation);
    }
    Plane const plane = mixture(3);
    HardEllipsoids open;
    pw85::IndexPair pair;
    g_assert_true(hard_ellipsoids_create({plane.centers, {}, nullptr}, plane.semi_axes,
                                         plane.quaternions, 1, open, pair) == Status::success);
    g_assert_true(open.set_dimensions(2) == Status::success);
    g_assert_true(open.sweep(50) == Status::success);
    expect_no_overlap(open);
    HardEllipsoids none;
    std::vector<pw85::SymmetricMatrix<double, 3>> const forms(plane.centers.size() + 1);
    g_assert_true(hard_ellipsoids_create({plane.centers, forms, nullptr}, plane.semi_axes,
                                         plane.quaternions, 1, none,
                                         pair) == Status::invalid_argument);
    g_assert_true(hard_ellipsoids_create({{}, {}, nullptr}, {}, {}, 1, none, pair) ==
                  Status::success);
    g_assert_true(none.set_dimensions(2) == Status::success && none.sweep(2) == Status::success);
}

/// The status of two dimensions for a plane that is changed; nothing else may change.
void expect_refusal(char const *what, void (*change)(Plane &))
{
    Plane plane = mixture(3);
    change(plane);
    HardEllipsoids simulation = plane.simulation();
    auto const before = bytes_of(simulation);
    if (simulation.set_dimensions(2) != Status::invalid_argument) g_test_fail_printf("%s", what);
    g_assert_cmpint(simulation.dimensions(), ==, 3);
    g_assert_true(bytes_of(simulation) == before);
}

PW85_TEST("/hard_ellipses/bad_input")
{
    expect_refusal("height", [](Plane &p) { p.centers[4][2] += 0x1p-50; });
    expect_refusal("turn about x", [](Plane &p) { p.quaternions[5][1] = 1e-300; });
    expect_refusal("turn about y", [](Plane &p) { p.quaternions[8][2] = -1e-300; });
    expect_refusal("half a turn about x", [](Plane &p) { p.quaternions[2] = {0, 1, 0, 0}; });
    expect_refusal("periodic", [](Plane &p) { p.periodic[2] = 1; });
    expect_refusal("first vector", [](Plane &p) { p.cell[0][2] = 1e-12; });
    expect_refusal("second vector", [](Plane &p) { p.cell[1][2] = 1e-12; });
    expect_refusal("third vector", [](Plane &p) { p.cell[2][0] = 1e-12; });
    expect_refusal("third vector", [](Plane &p) { p.cell[2][1] = 1e-12; });
    HardEllipsoids simulation = mixture(3).ellipses();
    auto const before = bytes_of(simulation);
    for (int const dimensions : {-1, 0, 1, 4, 6})
        g_assert_true(simulation.set_dimensions(dimensions) == Status::invalid_argument);
    g_assert_true(HardEllipsoids().set_dimensions(2) == Status::invalid_argument);
    g_assert_cmpint(HardEllipsoids().dimensions(), ==, -1);
    g_assert_cmpint(pw85_hard_ellipsoids_dimensions(simulation.get(), nullptr), ==, PW85_EINVAL);
    double z = 7;
    for (Vector3 const &direction :
         {Vector3{1, 0, 1e-9}, Vector3{0, 0, 1}, Vector3{0, 0, 0}, Vector3{1, 0, NAN}})
        g_assert_true(simulation.chain(3, 1.0, direction, z) == Status::invalid_argument &&
                      std::isnan(z));
    HardEllipsoids far = mixture(3).ellipses();
    g_assert_true(far.chain(1, 1e17, z) == Status::no_convergence && std::isnan(z));
    bool is_free;
    Quaternion const turn = simulation.quaternions()[0], tilted = {turn[0], 1e-9, 0, turn[3]};
    double const *const c = simulation.system().centers;
    auto const place = [&](Vector3 const &center, Quaternion const &quaternion) {
        return simulation.try_placement(0, center, quaternion, true, is_free);
    };
    g_assert_true(place({c[0], c[1], c[2] + 1e-9}, turn) == Status::invalid_argument);
    g_assert_true(place({c[0], c[1], NAN}, turn) == Status::invalid_argument);
    g_assert_true(place({c[0], c[1], c[2]}, tilted) == Status::invalid_argument);
    g_assert_true(place({c[0], c[1], c[2]}, {0, 0, 0, 0}) == Status::invalid_argument);
    g_assert_true(simulation.set_steps({1e3, 0.1, 0.1}) == Status::invalid_argument);
    g_assert_true(bytes_of(simulation) == before);
}

// A saved plane is one when it is read again, and bytes of a state that is none are refused.
PW85_TEST("/hard_ellipses/changed_bytes")
{
    Plane plane = mixture(3);
    plane.cell[2][2] = 0.12345; // numbers that occur once
    plane.quaternions[3] = {0.75, 0.0, 0.0, 1.0};
    HardEllipsoids simulation = plane.ellipses(), made;
    auto const bytes = bytes_of(simulation);
    g_assert_true(hard_ellipsoids_restore(bytes, made) == Status::success &&
                  made.dimensions() == 2);
    g_assert_true(hard_ellipsoids_restore(with_number(bytes, 0.25, 0.5), made) ==
                  Status::invalid_argument);
    g_assert_true(hard_ellipsoids_restore(with_number(bytes, 0.12345, 0.5), made) ==
                  Status::success);
    g_assert_true(simulation.set_dimensions(3) == Status::success && simulation.dimensions() == 3);
    auto const in_space = bytes_of(simulation);
    g_assert_true(hard_ellipsoids_restore(in_space, made) == Status::success &&
                  made.dimensions() == 3);
    g_assert_true(hard_ellipsoids_restore(with_number(in_space, 0.25, 0.5), made) ==
                  Status::success);
    g_assert_true(bytes_of(plane.simulation()) == in_space);
}

// Ellipsoids that were ellipses leave the plane, without overlaps.
PW85_TEST("/hard_ellipses/back_to_space")
{
    Plane plane = mixture(5);
    HardEllipsoids simulation = plane.ellipses();
    g_assert_true(simulation.sweep(10) == Status::success);
    g_assert_true(simulation.set_dimensions(3) == Status::success);
    g_assert_true(simulation.set_steps({0.4, 0.3, 0.1}) == Status::success);
    g_assert_true(simulation.sweep(200) == Status::success);
    auto const system = simulation.system();
    double highest = 0.0;
    for (std::size_t i = 0; i < system.num_particles; ++i)
        highest = std::max(highest, std::fabs(system.centers[3 * i + 2] - plane.height));
    g_assert_cmpfloat(highest, >, 2.0);
    expect_no_overlap(simulation);
    g_assert_true(simulation.set_dimensions(2) == Status::invalid_argument);
}

// In a closed plane, a translation is at most as long as the longest vector.
PW85_TEST("/hard_ellipses/clipped_translation")
{
    HardEllipsoids simulation = mixture(3).simulation();
    g_assert_true(simulation.set_steps({1e3, 0.1, 0.1}) == Status::success);
    g_assert_true(simulation.set_dimensions(2) == Status::success);
    g_assert_cmpfloat(simulation.steps().translation, ==, std::hypot(0.3 * 1.3 * 3, 2.2 * 3));
}

} // namespace
