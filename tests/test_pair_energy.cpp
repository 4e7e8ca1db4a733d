// SPDX-License-Identifier: BSD-3-Clause
// Energies of pairs beside the hard cores: against quadrature, independent configurations and a
// simulation that knows no lists, with threads, saved states and bad input.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "cases.hpp"
#include "hard_particles.hpp"
#include "threads.hpp"

using namespace pw85_tests;

namespace {

using pw85::Law;

/// Lennard-Jones with μ in the place of r/σ, cut and shifted at μ² = c.
struct LennardJones {
    double epsilon, c;
    double parameters[5] = {4.0 * epsilon, 12.0, 4.0 * epsilon, 6.0, c};

    Law law() const { return {PW85_LAW_INVERSE_POWERS, parameters}; }

    double everywhere(double mu2) const
    {
        double const x = 1.0 / (mu2 * mu2 * mu2);
        return 4.0 * epsilon * (x * x - x);
    }

    double operator()(double mu2) const { return mu2 < c ? everywhere(mu2) - everywhere(c) : 0.0; }
};

double energy_of(HardEllipsoids const &simulation)
{
    double energy;
    g_assert_true(simulation.energy(energy) == Status::success);
    return energy;
}

void set_law(HardEllipsoids &simulation, Law const &law)
{
    g_assert_true(simulation.set_law(law) == Status::success);
}

/// The integral by Simpson's rule.
template <class Function> double integral(double from, double to, Function const &f)
{
    constexpr int n = 4000;
    double sum = f(from) + f(to);
    for (int k = 1; k < n; ++k) sum += (k % 2 ? 4.0 : 2.0) * f(from + (to - from) * k / n);
    return sum * (to - from) / (3.0 * n);
}

// Two unit spheres in a cube: their distance has the density r² e^-U.
PW85_TEST("/pair_energy/two_spheres")
{
    LennardJones const attraction{1.5, 4.0}, repulsion{-1.0, 3.0};
    // A ramp: U falls from 1.5 at μ² = 1 to 0 at μ² = 4, linear in μ².
    double const ramp[] = {1.0, 4.0, 1.5, -0.5, 0.75, -0.5, 0.0, -0.5};
    auto const compare = [&](char const *name, Law const &law, auto const &u) {
        Start start;
        start.cell = box(4, 4, 4);
        start.add({0, 0, 0}, {0.5, 0.5, 0.5});
        start.add({1.5, 1.5, 1.5}, {0.5, 0.5, 0.5});
        HardEllipsoids simulation = start.simulation();
        set_law(simulation, law);
        g_assert_true(simulation.set_steps({1.0, 0.1, 0.1}) == Status::success);
        int const samples = g_test_perf() ? 1000000 : 10000;
        Blocks energies(samples / 50);
        for (int k = 0; k < samples; ++k) {
            g_assert_true(simulation.sweep(4) == Status::success);
            energies.add(energy_of(simulation));
        }
        auto const weight = [&](double r) { return 4.0 * M_PI * r * r * std::exp(-u(r * r)); };
        double const inside = integral(1.0, 2.0, weight), outside = 64.0 - 4.0 / 3.0 * M_PI * 8.0,
                     sum = integral(1.0, 2.0, [&](double r) { return u(r * r) * weight(r); });
        energies.expect(name, sum / (inside + outside));
    };
    compare("attraction", attraction.law(), attraction);
    compare("repulsion", repulsion.law(), repulsion);
    compare("ramp", {PW85_LAW_TABLE, ramp},
            [](double mu2) { return mu2 < 4.0 ? 0.5 * (4.0 - mu2) : 0.0; });
}

/// A uniform orientation.
template <class Random> Quaternion any_turn(Random &random)
{
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random), normal(random)};
}

// Two ellipsoids against independent configurations of their density.
PW85_TEST("/pair_energy/two_ellipsoids")
{
    LennardJones const u{1.5, 2.25};
    Vector3 const axes[2] = {{0.4, 0.5, 0.9}, {0.6, 0.6, 0.4}};
    double const edge = 4.0;
    Start start;
    start.cell = box(edge, edge, edge);
    start.add({0, 0, 0}, axes[0]);
    start.add({2, 2, 2}, axes[1]);
    HardEllipsoids simulation = start.simulation();
    set_law(simulation, u.law());
    g_assert_true(simulation.set_steps({0.8, 0.6, 0.1}) == Status::success);
    g_assert_true(simulation.set_fractions({2, 2, 1, 1}) == Status::success);
    int const samples = g_test_perf() ? 1000000 : 50000;
    Blocks found(samples / 50), expected(samples / 50);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(4) == Status::success);
        found.add(energy_of(simulation));
    }
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    for (int k = 0; k < samples;) {
        auto const q1 = pw85::ellipsoid_quaternion(axes[0], any_turn(random)).q,
                   q2 = pw85::ellipsoid_quaternion(axes[1], any_turn(random)).q;
        Vector3 const r{edge * uniform(random), edge * uniform(random), edge * uniform(random)};
        double const mu2 = pw85::contact(r, q1, q2).mu2;
        if (mu2 < 1.0) continue;
        // The nearest image alone has an energy, which is at least -1.5.
        if (uniform(random) + 0.5 > std::exp(-u(mu2) - 1.5)) continue;
        expected.add(u(mu2));
        ++k;
    }
    found.expect("two ellipsoids", expected.mean(), 4.0 * expected.error());
}

// One ellipsoid and its own images: each pair of opposite ones counts once.
PW85_TEST("/pair_energy/own_images")
{
    LennardJones const u{-2.0, 4.0};
    Vector3 const axes{0.4, 0.5, 1.0};
    double const edge = 2.05;
    Start start;
    start.cell = box(edge, edge, edge);
    start.add({0.3, 0.2, 0.1}, axes);
    HardEllipsoids simulation = start.simulation();
    set_law(simulation, u.law());
    g_assert_true(simulation.set_steps({0.3, 0.7, 0.1}) == Status::success);
    int const samples = g_test_perf() ? 400000 : 20000;
    Blocks found(samples / 50), expected(samples / 50);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(4) == Status::success);
        found.add(energy_of(simulation));
    }
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int k = 0; k < samples;) {
        auto const q = pw85::ellipsoid_quaternion(axes, any_turn(random)).q;
        double energy = 0.0; // of one of each two opposite images
        for (int n = 0; n < 62; ++n) {
            double const x = n % 5 - 2, y = n / 5 % 5 - 2, z = n / 25 - 2;
            energy += u(pw85::contact(edge * Vector3{x, y, z}, q, q).mu2);
        }
        if (uniform(random) > std::exp(-energy)) continue; // energies are positive
        expected.add(energy);
        ++k;
    }
    found.expect("own images", expected.mean(), 4.0 * expected.error());
}

// A sphere in a cube of images: the volume has the density V e^(-βPV - U).
PW85_TEST("/pair_energy/volume")
{
    LennardJones const u{1.0, 6.25};
    double const pressure = 0.7;
    Start start;
    start.cell = box(2, 2, 2);
    start.add({}, {0.5, 0.5, 0.5});
    HardEllipsoids simulation = start.simulation();
    set_law(simulation, u.law());
    g_assert_true(simulation.set_steps({0.3, 0.1, 0.2}) == Status::success);
    int const samples = g_test_perf() ? 1000000 : 15000;
    Blocks volumes(samples / 50);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.volume_moves(4, pressure, CellChange::isotropic) ==
                      Status::success);
        volumes.add(std::pow(simulation.system().cell[0], 3));
    }
    auto const density = [&](double edge) {
        double energy = 0.0;
        for (int n = 0; n < 343; ++n) {
            double const x = n % 7 - 3, y = n / 7 % 7 - 3, z = n / 49 - 3;
            if (n != 171) energy += 0.5 * u(edge * edge * (x * x + y * y + z * z));
        }
        double const v = edge * edge * edge;
        return v * std::exp(-pressure * v - energy) * edge * edge;
    };
    volumes.expect("volume", integral(1.0, 5.0, [&](double x) { return x * x * x * density(x); }) /
                                 integral(1.0, 5.0, density));
}

/// A fluid of ellipsoids on a loose lattice, to be melted: n³ of them, in a cell of these edges.
Start loose(int n, double a, double c)
{
    Start start;
    for (int k = 0; k < n * n * n; ++k)
        start.add({a * (k % n), a * (k / n % n), c * (k / n / n)}, {0.4, 0.5, 0.8});
    start.cell = box(a * n, a * n, c * n);
    return start;
}

/// The same system, cell and centres multiplied by a factor.
HardEllipsoids scaled(HardEllipsoids const &simulation, double factor)
{
    pw85_system const system = simulation.system();
    Start start;
    for (std::size_t i = 0; i < system.num_particles; ++i) {
        Vector3 center, axes;
        Quaternion turn;
        std::copy_n(system.centers + 3 * i, 3, center.coordinates);
        std::copy_n(simulation.semi_axes()[i].coordinates, 3, axes.coordinates);
        std::copy_n(simulation.quaternions()[i].coordinates, 4, turn.coordinates);
        start.add(factor * center, axes, turn);
    }
    start.cell = box(factor * system.cell[0], factor * system.cell[4], factor * system.cell[8]);
    return start.simulation();
}

// The virial is the derivative of the energy by the logarithm of a length, with the other sign. The
// energies are rounded to 2⁻³² for each of some hundred pairs, and the central difference over ±δ
// errs by δ²/6 of the third derivative, which is some 12³ times the energy.
PW85_TEST("/pair_energy/virial")
{
    LennardJones const u{0.8, 2.5};
    for (int dimensions : {3, 2}) {
        Start start = loose(dimensions == 3 ? 4 : 6, 1.2, 1.8);
        if (dimensions == 2) {
            start = {};
            for (int k = 0; k < 36; ++k)
                start.add({1.1 * (k % 6), 1.3 * (k / 6), 0.3}, {0.4, 0.5, 0.7});
            start.cell = box(6.6, 7.8, 50.0);
            start.periodic = {1, 1, 0};
        }
        HardEllipsoids simulation = start.simulation();
        if (dimensions == 2) g_assert_true(simulation.set_dimensions(2) == Status::success);
        double virial = -1.0;
        g_assert_true(simulation.law_virial(virial) == Status::success && virial == 0.0);
        set_law(simulation, u.law());
        g_assert_true(simulation.sweep(20) == Status::success);
        g_assert_true(simulation.law_virial(virial) == Status::success);
        if (dimensions == 2) {
            // By the ellipses: z of cell and centres takes no part.
            double expected = 0.0;
            pw85_system const system = simulation.system();
            for (int i = 0; i < 36; ++i)
                for (int n = 0; n < 9 * 36; ++n) {
                    int const j = n / 9, x = n % 3 - 1, y = n / 3 % 3 - 1;
                    if (j == i && x == 0 && y == 0) continue;
                    double const *const a = system.centers + 3 * i, *const b =
                                                                        system.centers + 3 * j;
                    Vector3 const r{b[0] - a[0] + 6.6 * x, b[1] - a[1] + 7.8 * y, 0.0};
                    pw85::SymmetricMatrix<double, 3> q1, q2;
                    std::copy_n(system.q + 6 * i, 6, q1.entries);
                    std::copy_n(system.q + 6 * j, 6, q2.entries);
                    double const mu2 = pw85::contact(r, q1, q2).mu2;
                    if (mu2 >= u.c) continue;
                    double const s = 1.0 / (mu2 * mu2 * mu2);
                    expected += 0.5 * 4.0 * u.epsilon * (12.0 * s * s - 6.0 * s); // -μ dU/dμ
                }
            g_assert_cmpfloat(std::fabs(virial - expected), <, 1e-9 * std::fabs(expected));
            continue;
        }
        double const delta = 1e-4;
        HardEllipsoids less = scaled(simulation, 1.0 - delta),
                       more = scaled(simulation, 1.0 + delta);
        set_law(less, u.law());
        set_law(more, u.law());
        double const slope =
            (energy_of(less) - energy_of(more)) / (std::log1p(delta) - std::log1p(-delta));
        g_test_message("virial %.6f, by energies %.6f", virial, slope);
        g_assert_cmpfloat(std::fabs(virial - slope), <, 2e-3);
        g_assert_cmpfloat(std::fabs(virial), >, 10.0);
    }
}

// The pressure at which the volume fluctuates is the mean of that by the virial: for each
// configuration and any repulsion that lets hardly any pairs touch. By parts, the integral of
// d(V^N e^(-βPV - U))/dV over all volumes is zero, so βP = <N/V + W/(3V)> without contacts. Those
// add up to U(1) = 15 where less than e^-15 of the pairs are.
PW85_TEST("/pair_energy/virial_at_constant_pressure")
{
    double const pressure = 0.9, parameters[] = {16.0, 8.0, 0.0, 4.0, 3.0};
    HardEllipsoids simulation = loose(3, 1.7, 2.2).simulation();
    set_law(simulation, {PW85_LAW_INVERSE_POWERS, parameters});
    g_assert_true(simulation.tune(300, 0.4, pressure) == Status::success);
    int const samples = g_test_perf() ? 200000 : 4000;
    Blocks found(samples / 40), of_law(samples / 40);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(2) == Status::success);
        g_assert_true(simulation.volume_moves(2, pressure) == Status::success);
        double const *const cell = simulation.system().cell;
        double const volume = cell[0] * cell[4] * cell[8];
        double virial;
        g_assert_true(simulation.law_virial(virial) == Status::success);
        found.add((27.0 + virial / 3.0) / volume);
        of_law.add(virial / 3.0 / volume);
    }
    found.expect("pressure by the virial", pressure);
    g_assert_cmpfloat(found.error(), <, 0.02 * pressure);
    g_assert_cmpfloat(of_law.mean(), >, 0.3 * pressure);
}

// The factor of a compression is that of the hard cores. Afterwards all is as if the simulation
// had begun there.
PW85_TEST("/pair_energy/compression")
{
    LennardJones const u{0.8, 2.5};
    HardEllipsoids simulation = loose(5, 1.2, 1.8).simulation();
    g_assert_true(simulation.sweep(10) == Status::success);
    HardEllipsoids hard, with;
    auto const bytes = bytes_of(simulation);
    g_assert_true(hard_ellipsoids_restore(bytes, hard) == Status::success);
    set_law(simulation, u.law());
    double const before = energy_of(simulation);
    double factor, expected, without;
    g_assert_true(hard.compress(true, expected) == Status::success);
    g_assert_true(simulation.compress(false, without) == Status::success);
    g_assert_true(energy_of(simulation) == before);
    g_assert_true(simulation.compress(true, factor) == Status::success);
    g_assert_true(factor == expected && without == expected && factor < 1.0);
    expect_no_overlap(simulation);
    g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), with) == Status::success);
    g_assert_true(energy_of(with) == energy_of(simulation) && energy_of(with) != before);
    g_assert_true(with.sweep(5) == Status::success && simulation.sweep(5) == Status::success);
    g_assert_true(bytes_of(with) == bytes_of(simulation));
    set_law(hard, u.law());
    g_assert_true(hard.sweep(5) == Status::success && bytes_of(hard) == bytes_of(with));
}

// Two particles that exchange their semi-axes and nothing else are in either of two states.
PW85_TEST("/pair_energy/exchange")
{
    LennardJones const u{2.0, 6.25};
    Vector3 const axes[2] = {{0.5, 0.5, 0.8}, {0.6, 0.4, 0.4}};
    Quaternion const turns[2] = {{1.0, 0.2, 0.0, 0.0}, {1.0, 0.0, 0.5, 0.3}};
    Start start;
    start.cell = box(4, 4, 4);
    start.add({0, 0, 0}, axes[0], turns[0]);
    start.add({0.7, 0.8, 0.6}, axes[1], turns[1]);
    HardEllipsoids simulation = start.simulation();
    set_law(simulation, u.law());
    g_assert_true(simulation.set_fractions({0, 0, 0, 1}) == Status::success);
    std::swap(start.semi_axes[0], start.semi_axes[1]);
    HardEllipsoids other = start.simulation();
    set_law(other, u.law());
    double const first = energy_of(simulation), second = energy_of(other);
    g_assert_cmpfloat(std::fabs(first - second), >, 0.4);
    Blocks is_first(400);
    for (int k = 0; k < 20000; ++k) {
        g_assert_true(simulation.sweep(2) == Status::success);
        is_first.add(simulation.semi_axes()[0][2] == 0.8);
    }
    is_first.expect("exchange", 1.0 / (1.0 + std::exp(first - second)));
}

/// Unit spheres that attract each other at distances between 2.12 and 2.5, and repel each other
/// from 1.66 on, by the polynomials of two intervals of a table. So what forgets pairs that are far
/// apart finds another energy.
struct Shell {
    static constexpr double edge = 6.0, inner = 4.5, outer = 6.25, slope = 1.5;
    double parameters[10] = {1.0, outer, 0.0, 0.0, 0.0, 0.0, 0.0, -slope, 0.0, slope};

    static double of(double mu2)
    {
        constexpr double width = outer - inner;
        double const x = (mu2 - inner) / width;
        if (x < -1.0 || x > 1.0) return 0.0;
        return slope * width * (x < 0.0 ? -x * (1.0 + x) * (1.0 + x) : -x * (1.0 - x));
    }

    Law law() const { return {PW85_LAW_TABLE, parameters}; }

    /// The energy of sphere i at x with all others; infinite if it overlaps any.
    static double energy(std::vector<Vector3> const &centers, std::size_t i, Vector3 const &x)
    {
        double sum = 0.0;
        for (std::size_t j = 0; j < centers.size(); ++j) {
            if (j == i) continue;
            Vector3 r = centers[j] - x;
            for (int d = 0; d < 3; ++d) r[d] -= edge * std::round(r[d] / edge);
            double const mu2 = dot(r, r);
            if (mu2 < 1.0) return HUGE_VAL;
            sum += of(mu2);
        }
        return sum;
    }

    static double energy(std::vector<Vector3> const &centers)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < centers.size(); ++i)
            sum += 0.5 * energy(centers, i, centers[i]);
        return sum;
    }
};

/// The mean energy by trials that ask all others.
Blocks plain_energies(std::vector<Vector3> centers, int sweeps)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Blocks energies(sweeps / 40);
    for (int sweep = -sweeps / 10; sweep < sweeps; ++sweep) {
        for (std::size_t k = 0; k < centers.size(); ++k) {
            auto const i =
                static_cast<std::size_t>(static_cast<double>(centers.size()) * uniform(random));
            Vector3 x = centers[i];
            for (int d = 0; d < 3; ++d) x[d] += 0.8 * (uniform(random) - 0.5);
            double const change =
                Shell::energy(centers, i, x) - Shell::energy(centers, i, centers[i]);
            if (uniform(random) < std::exp(-change)) centers[i] = x;
        }
        if (sweep >= 0) energies.add(Shell::energy(centers));
    }
    return energies;
}

// Many spheres, in a cell that is divided into domains. Spheres that are far apart have energies.
PW85_TEST("/pair_energy/many_spheres")
{
    Shell const shell;
    Start start;
    start.cell = box(Shell::edge, Shell::edge, Shell::edge);
    for (int k = 0; k < 64; ++k)
        start.add(Shell::edge / 4 * Vector3{double(k % 4), double(k / 4 % 4), double(k / 16)},
                  {0.5, 0.5, 0.5});
    HardEllipsoids simulation = start.simulation();
    set_law(simulation, shell.law());
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.tune(500, 0.5) == Status::success);
    int const sweeps = g_test_perf() ? 200000 : 2000;
    Blocks found(sweeps / 40);
    std::vector<Vector3> centers(64);
    for (int k = 0; k < sweeps; ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        for (std::size_t i = 0; i < centers.size(); ++i)
            std::copy_n(simulation.system().centers + 3 * i, 3, centers[i].coordinates);
        found.add(Shell::energy(centers));
    }
    g_assert_cmpfloat(std::fabs(energy_of(simulation) - Shell::energy(centers)), <, 1e-6);
    Blocks const expected = plain_energies(start.centers, sweeps);
    g_test_message("its error is %.5f", expected.error());
    found.expect("many spheres", expected.mean(), 4.0 * expected.error());
    g_assert_cmpfloat(found.error() + expected.error(), <, 0.02 * std::fabs(expected.mean()));
}

// Domains are wider than the law reaches. Trials that leave their domain are rejected, and tell its
// width: without energies, a fourth of the edge would be enough for so many small spheres.
PW85_TEST("/pair_energy/width_of_domains")
{
    double const nothing[] = {1.0, 24.0 * 24.0, 0.0, 0.0, 0.0, 0.0}, edge = 10.0, step = 0.5;
    Start start;
    start.cell = box(edge, edge, edge);
    for (int k = 0; k < 2048; ++k)
        start.add({edge / 16 * (k % 16), edge / 16 * (k / 16 % 16), edge / 8 * (k / 256)},
                  {0.05, 0.05, 0.05});
    for (bool const has_law : {true, false}) {
        HardEllipsoids simulation = start.simulation();
        if (has_law) set_law(simulation, {PW85_LAW_TABLE, nothing});
        g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
        g_assert_true(simulation.set_steps({step, 0.1, 0.1}) == Status::success);
        // With the law a sweep takes more than a second.
        g_assert_true(simulation.sweep(has_law ? 1 : 3) == Status::success);
        pw85::TrialCounts const counts = simulation.counts();
        double const rejected = 1.0 - static_cast<double>(counts.accepted[0]) /
                                          static_cast<double>(counts.trials[0]),
                     width = edge / (has_law ? 2.0 : 4.0);
        // A coordinate of a point of a ball has the mean magnitude 3/8 of the radius. Few spheres
        // overlap, and few leave two sides at once.
        g_test_message("%.3f rejected", rejected);
        g_assert_cmpfloat(std::fabs(rejected - 3.0 * 0.375 * step / width), <, 0.025);
    }
}

// The same bits with any number of threads, and from a saved state on.
PW85_TEST("/pair_energy/threads_and_restart")
{
    LennardJones const u{0.8, 1.7};
    pw85::Field const field = pw85::Field::aligning({0, 1, 2}, 1.5);
    for (bool const has_field : {false, true}) {
        auto const run = [&](int threads, bool restarts) {
            Threads const used(threads);
            HardEllipsoids simulation = lattice(10).simulation();
            if (has_field) g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
            set_law(simulation, u.law());
            g_assert_true(simulation.set_fractions({4, 4, 1, 1}) == Status::success);
            g_assert_true(simulation.tune(3, 0.4, 1.0) == Status::success);
            g_assert_true(simulation.sweep(4) == Status::success);
            if (restarts) {
                HardEllipsoids again;
                auto const bytes = bytes_of(simulation);
                g_assert_true(hard_ellipsoids_restore(bytes, again) == Status::success);
                g_assert_true(bytes_of(again) == bytes);
                g_assert_true(energy_of(again) == energy_of(simulation));
                simulation = std::move(again);
            }
            g_assert_true(simulation.sweep(4) == Status::success);
            g_assert_true(simulation.volume_moves(5, 1.0) == Status::success);
            expect_no_overlap(simulation);
            return bytes_of(simulation);
        };
        auto const expected = run(1, false);
        g_assert_true(run(3, false) == expected);
        g_assert_true(run(1, true) == expected);
        g_assert_true(run(2, true) == expected);
    }
}

// The energy is that of pw85_law_forces_pairs(). Without the law the simulation is as it was.
PW85_TEST("/pair_energy/energy")
{
    LennardJones const u{0.8, 1.7};
    HardEllipsoids simulation = lattice(6).simulation();
    auto const before = bytes_of(simulation);
    set_law(simulation, u.law());
    g_assert_true(bytes_of(simulation).size() == before.size() + 16 + 6 * 8);
    pw85_system const system = simulation.system();
    pw85_neighbors *made = nullptr;
    g_assert_cmpint(pw85_neighbors_create(&system, std::sqrt(u.c) * 1.001, 0.0, &made), ==,
                    PW85_SUCCESS);
    pw85_pair_list const list = pw85_neighbors_list(made);
    pw85_law const law = {PW85_LAW_INVERSE_POWERS, 5, u.parameters};
    double expected;
    g_assert_cmpint(
        pw85_law_forces_pairs(&list, &system, &law, &expected, nullptr, nullptr, nullptr), ==,
        PW85_SUCCESS);
    // Each energy is rounded to a multiple of 2⁻³².
    g_assert_cmpfloat(std::fabs(energy_of(simulation) - expected), <=,
                      0x1p-32 * static_cast<double>(list.num_pairs));
    g_assert_cmpfloat(expected, <, -10.0);
    pw85_neighbors_destroy(made);
    for (bool const is_null : {false, true}) {
        set_law(simulation, u.law());
        g_assert_true((is_null ? simulation.set_law(nullptr) : simulation.set_law({0, {}})) ==
                      Status::success);
        g_assert_true(bytes_of(simulation) == before);
    }
    g_assert_true(energy_of(simulation) == 0.0 && bytes_of(simulation) == before);
    HardEllipsoids other = lattice(6).simulation();
    g_assert_true(simulation.sweep(5) == Status::success && other.sweep(5) == Status::success);
    g_assert_true(bytes_of(simulation) == bytes_of(other));
}

/// Ends steeply: U = 0.75 at μ = 1.98, and 0 from 2 on.
constexpr double steep_end[] = {1.0, 4.0, 0.0, 0.0, 0.0, -10.0};

// Two spheres that are as far apart along x as the law reaches, nearly, and a law that is set
// between sweeps and trials of the volume.
PW85_TEST("/pair_energy/reach")
{
    Start start;
    start.add({0, 0, 0}, {0.5, 0.5, 0.5});
    start.add({1.98, 0, 0}, {0.5, 0.5, 0.5});
    start.cell = box(9, 9, 9);
    HardEllipsoids simulation = start.simulation();
    g_assert_true(simulation.sweep(0) == Status::success);
    set_law(simulation, {PW85_LAW_TABLE, steep_end});
    double const t = (1.98 * 1.98 - 1.0) / 3.0;
    g_assert_cmpfloat_with_epsilon(energy_of(simulation), 30.0 * t * t * (1.0 - t), 1e-9);
    HardEllipsoids again;
    g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), again) == Status::success);
    for (HardEllipsoids *const one : {&simulation, &again})
        g_assert_true(one->volume_moves(20, 1.0) == Status::success);
    g_assert_true(bytes_of(simulation) == bytes_of(again));
}

PW85_TEST("/pair_energy/bad_input")
{
    HardEllipsoids simulation = lattice(3).simulation(), none;
    auto const before = bytes_of(simulation);
    double const good[] = {1.0, 12.0, 1.0, 6.0, 2.0}, order[] = {1.0, 6.0, 1.0, 12.0, 2.0},
                 large[] = {1e6, 12.0, 1e6, 6.0, 2.0}, nan[] = {NAN, 12.0, 1.0, 6.0, 2.0},
                 steep[] = {2.0, 4.0, 0.0, 1e6, 0.0, 0.0}, soft[] = {1.0, 2.0},
                 endless[] = {1.0, 12.0, 1.0, 6.0, 1e7};
    for (Law const &law :
         {Law{PW85_LAW_INVERSE_POWERS, order}, Law{PW85_LAW_INVERSE_POWERS, large},
          Law{PW85_LAW_INVERSE_POWERS, nan}, Law{PW85_LAW_INVERSE_POWERS, soft},
          Law{PW85_LAW_TABLE, steep}, Law{PW85_LAW_TABLE, good},
          Law{PW85_LAW_INVERSE_POWERS, endless}, Law{PW85_LAW_SOFT_REPULSION, soft}, Law{7, good},
          Law{PW85_LAW_TABLE, {}}}) {
        g_assert_true(simulation.set_law(law) == Status::invalid_argument);
        g_assert_true(bytes_of(simulation) == before);
    }
    Law const law{PW85_LAW_INVERSE_POWERS, good};
    g_assert_true(none.set_law(law) == Status::invalid_argument);
    set_law(simulation, law);
    double number;
    g_assert_true(simulation.chain(1, 1.0, number) == Status::invalid_argument);
    g_assert_true(none.law_virial(number) == Status::invalid_argument && std::isnan(number));
    g_assert_cmpint(pw85_hard_ellipsoids_law_virial(simulation.get(), nullptr), ==, PW85_EINVAL);
    // The cutoff is at μ = √2, so that 30 times the cell is too long.
    Vector3 const rod{30.0 * simulation.system().cell[0], 0.5, 0.5};
    g_assert_true(simulation.insertion_weight(1, rod, number) == Status::invalid_argument);
    // A law that is refused leaves the one that there is.
    auto const with = bytes_of(simulation);
    g_assert_true(simulation.set_law({PW85_LAW_INVERSE_POWERS, order}) == Status::invalid_argument);
    g_assert_true(bytes_of(simulation) == with);
}

} // namespace
