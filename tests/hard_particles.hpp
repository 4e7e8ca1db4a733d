// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulations of hard particles for tests: how they start, their states, and means with errors.
#ifndef PW85_TESTS_HARD_PARTICLES_HPP_INCLUDED
#define PW85_TESTS_HARD_PARTICLES_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "failures.hpp"
#include "threads.hpp"

namespace pw85_tests {

using pw85::CellChange;
using pw85::HardEllipsoids;
using pw85::Status;
using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

/// The arguments of a simulation.
struct Start {
    std::vector<Vector3> centers, semi_axes;
    std::vector<Quaternion> quaternions;
    pw85::Cell cell{};
    std::array<int, 3> periodic = {1, 1, 1};

    void add(Vector3 const &center, Vector3 const &axes,
             Quaternion const &quaternion = {1.0, 0.0, 0.0, 0.0})
    {
        centers.push_back(center);
        semi_axes.push_back(axes);
        quaternions.push_back(quaternion);
    }

    Status create(HardEllipsoids &simulation, pw85::IndexPair &pair, std::size_t seed = 1) const
    {
        return hard_ellipsoids_create({centers, {}, &cell, periodic}, semi_axes, quaternions, seed,
                                      simulation, pair);
    }

    HardEllipsoids simulation(std::size_t seed = 1) const
    {
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        g_assert_true(create(simulation, pair, seed) == Status::success);
        return simulation;
    }
};

inline pw85::Cell box(double x, double y, double z)
{
    return {{{x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}}};
}

/// Particles of two kinds on a lattice in a periodic cell.
inline Start lattice(int n)
{
    Start start;
    double const a = 1.25, c = 2.6;
    for (int k = 0; k < n * n * n; ++k)
        start.add({a * (k % n), a * (k / n % n), c * (k / n / n)},
                  k % 3 == 0 ? Vector3{0.45, 0.5, 0.9} : Vector3{0.5, 0.5, 1.2});
    start.cell = box(a * n, a * n, c * n);
    return start;
}

inline std::vector<unsigned char> bytes_of(HardEllipsoids const &simulation)
{
    std::vector<unsigned char> bytes(simulation.num_bytes());
    g_assert_true(simulation.save(bytes) == Status::success);
    return bytes;
}

inline void expect_no_overlap(HardEllipsoids const &simulation)
{
    pw85::IndexPair pair;
    g_assert_true(simulation.check(pair) == Status::success);
    g_assert_true(pair[0] == -1 && pair[1] == -1);
}

/// The volume of the cell; its area in two dimensions.
inline double measure_of(HardEllipsoids const &simulation)
{
    double const *const c = simulation.system().cell;
    bool const is_flat = simulation.dimensions() == 2;
    return dot(Vector3{c[0], c[1], c[2]},
               cross(Vector3{c[3], c[4], c[5]},
                     is_flat ? Vector3{0.0, 0.0, 1.0} : Vector3{c[6], c[7], c[8]}));
}

/// Means over blocks, and the error of their mean.
class Blocks {
  public:
    explicit Blocks(int length) : length_(length) {}

    void add(double x)
    {
        sum_ += x;
        if (++count_ % length_ != 0) return;
        double const mean = sum_ / length_;
        total_ += mean;
        squares_ += mean * mean;
        sum_ = 0.0;
    }

    double mean() const { return total_ / blocks(); }
    double error() const
    {
        return std::sqrt(std::max(0.0, squares_ / blocks() - mean() * mean()) / (blocks() - 1.0));
    }

    /// Checks that the mean differs from a value by at most four errors and a systematic error.
    void expect(char const *what, double expected, double systematic = 0.0) const
    {
        double const most = 4.0 * error() + systematic;
        g_test_message("%s: %.5f +- %.5f, expected %.5f", what, mean(), error(), expected);
        if (!(std::fabs(mean() - expected) <= most))
            g_test_fail_printf("%s: %a instead of %a, error %a", what, mean(), expected, error());
    }

  private:
    double blocks() const { return count_ / length_; }

    int length_, count_ = 0;
    double sum_ = 0.0, total_ = 0.0, squares_ = 0.0;
};

/// Counts of changes from one state to another. In detailed balance the change back is as frequent.
class Changes {
  public:
    explicit Changes(std::size_t num_states) : n_(num_states), counts_(num_states * num_states) {}

    /// The states of all particles before and after a sweep.
    void add(std::vector<std::size_t> const &before, std::vector<std::size_t> const &after)
    {
        for (std::size_t i = 0; i < after.size(); ++i) counts_[n_ * before[i] + after[i]] += 1.0;
    }

    /// Changes that follow each other tend to cancel, so that the variance of a difference is at
    /// most the number of changes.
    void expect_balance(double least_pairs) const
    {
        double sum = 0.0, expected = 0.0;
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                double const there = counts_[n_ * i + j], back = counts_[n_ * j + i];
                if (there + back < 10.0) continue;
                sum += (there - back) * (there - back) / (there + back);
                expected += 1.0;
            }
        g_test_message("chi^2 %.1f of %.0f pairs of states", sum, expected);
        g_assert_cmpfloat(expected, >, least_pairs);
        if (!(sum < expected + 4.0 * std::sqrt(2.0 * expected)))
            g_test_fail_printf("chi^2 %a of %a", sum, expected);
    }

  private:
    std::size_t n_;
    std::vector<double> counts_;
};

/// Some of everything, but for the chains.
inline void try_everything(HardEllipsoids &simulation, int steps, double pressure)
{
    for (int k = 0; k < steps; ++k) {
        g_assert_true(simulation.sweep(2) == Status::success);
        g_assert_true(simulation.volume_moves(2, pressure, static_cast<CellChange>(k % 3)) ==
                      Status::success);
    }
}

/// Checks N points at constant pressure. The volume V, or the area, has the density V^N e^-βPV: its
/// mean and variance are (N + 1)/βP and (N + 1)/βP². make(V, seed) makes the cell and the points
/// again now and then, since nothing limits shears of the cell.
template <class Make> void expect_ideal_gas(double n, Make const &make)
{
    constexpr double pressure = 5.0;
    for (CellChange const change :
         {CellChange::isotropic, CellChange::axis, CellChange::triclinic}) {
        Blocks mean(2000), square(2000);
        double volume = 1.5;
        for (std::size_t seed = 0; seed < 200; ++seed) {
            HardEllipsoids simulation = make(volume, seed);
            for (int k = 0; k < 300; ++k) {
                g_assert_true(simulation.volume_moves(1, pressure, change) == Status::success);
                volume = measure_of(simulation);
                mean.add(volume);
                square.add((volume - (n + 1) / pressure) * (volume - (n + 1) / pressure));
            }
        }
        mean.expect("mean volume", (n + 1) / pressure);
        square.expect("variance of the volume", (n + 1) / (pressure * pressure));
    }
}

/// Which of 54 states a particle is in: its thirds of the cell along the last two axes, the third
/// of a turn about the third axis, or of half a turn of an ellipse, and its kind. A drift or a
/// preferred sense of rotation makes a current around a cycle of three states.
inline std::vector<std::size_t> states_of(HardEllipsoids const &simulation)
{
    auto const system = simulation.system();
    int const last = simulation.dimensions() - 1;
    auto const third = [](double x) {
        return static_cast<std::size_t>(std::floor(3.0 * (x - std::floor(x)))) % 3;
    };
    std::vector<std::size_t> states(simulation.quaternions().size());
    for (std::size_t k = 0; k < states.size(); ++k) {
        double const *const r = system.centers + 3 * k, *const cell = system.cell;
        double const along_y = r[1] / cell[4];
        double const along[] = {(r[0] - along_y * cell[3]) / cell[0], along_y, r[2] / cell[8]};
        auto const [w, x, y, z] = simulation.quaternions()[k].coordinates;
        double const turns =
            std::atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z)) / (2 * std::numbers::pi);
        std::size_t const kind = simulation.semi_axes()[k][last] > 0.95;
        states[k] = third(along[last - 1]) + 3 * third(along[last]) +
                    9 * third(last == 2 ? turns : 2 * turns) + 27 * kind;
    }
    return states;
}

/// Checks changes of particles from one of 54 states to another, in sweeps of all kinds of trials.
inline void expect_detailed_balance(HardEllipsoids &simulation, int sweeps)
{
    g_assert_true(simulation.set_fractions({0.3, 0.3, 0.2, 0.2}) == Status::success);
    g_assert_true(simulation.sweep(300) == Status::success);
    Changes changes(54);
    auto before = states_of(simulation);
    for (int k = 0; k < (g_test_perf() ? 100000 : sweeps); ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        auto const after = states_of(simulation);
        changes.add(before, after);
        before = after;
    }
    changes.expect_balance(200.0);
}

/// Checks all kinds of trials of two bodies against independent configurations of which those with
/// overlaps are left out. draw() and measure(simulation) return the least μ² of all images, and
/// other numbers whose means are compared.
template <std::size_t N, class Draw, class Measure>
void expect_two_bodies(HardEllipsoids &simulation, std::array<char const *, N> const &names,
                       int samples, Draw const &draw, Measure const &measure)
{
    if (g_test_perf()) samples *= 10;
    std::vector<Blocks> expected(N, Blocks(samples / 50)), found(N, Blocks(samples / 50));
    auto const add = [](std::vector<Blocks> &means, std::array<double, N> const &one) {
        means[0].add(one[0] < 1.5);
        for (std::size_t k = 1; k < N; ++k) means[k].add(one[k]);
    };
    for (int k = 0; k < samples;) {
        std::array<double, N> const one = draw();
        if (one[0] < 1.0) continue;
        add(expected, one);
        ++k;
    }
    g_assert_true(simulation.set_steps({0.7, 0.6, 0.1}) == Status::success);
    g_assert_true(simulation.set_fractions({0.3, 0.3, 0.2, 0.2}) == Status::success);
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(4) == Status::success);
        std::array<double, N> const one = measure(simulation);
        if (one[0] < 1.0 - 1e-12) g_test_fail_printf("overlap, mu2 = %a", one[0]);
        add(found, one);
    }
    for (std::size_t k = 0; k < N; ++k)
        found[k].expect(names[k], expected[k].mean(), 4.0 * expected[k].error());
    auto const counts = simulation.counts();
    for (std::size_t k = 0; k < 4; ++k)
        g_assert_true(0 < counts.accepted[k] && counts.accepted[k] < counts.trials[k]);
}

/// Checks the mean density of particles that translate at the pressure P = zρ of this density ρ.
inline void expect_density(HardEllipsoids &simulation, double density, double z, double acceptance,
                           int sweeps, double systematic)
{
    auto const n = static_cast<double>(simulation.system().num_particles);
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.tune(300, acceptance, z * density) == Status::success);
    if (g_test_perf()) sweeps *= 8;
    Blocks densities(sweeps / 20);
    for (int k = 0; k < sweeps; ++k) {
        g_assert_true(simulation.sweep(1) == Status::success);
        g_assert_true(simulation.volume_moves(simulation.dimensions() == 3 ? 4 : 2, z * density) ==
                      Status::success);
        densities.add(n / measure_of(simulation));
    }
    densities.expect("density", density, systematic);
    expect_no_overlap(simulation);
}

/// Checks that tuned translations stay short beside the particles, or beside their distance, so
/// that Verlet lists do. At low density nearly every translation is accepted.
inline void expect_tuned_translations(int dimensions, double least_spacing)
{
    for (double const unit : {1.0, 0x1p40, 0x1p-40})
        for (double const spacing : {least_spacing, 3.0, 20.0}) {
            Start start;
            double const a = spacing * unit;
            int const n = dimensions == 3 ? 5 : 10;
            for (int k = 0; k < n * n * (dimensions == 3 ? n : 1); ++k)
                start.add({a * (k % n), a * (k / n % n), a * (k / n / n)},
                          {0.5 * unit, 0.4 * unit, 0.4 * unit});
            start.cell = box(n * a, n * a, n * a);
            start.periodic = {1, 1, dimensions == 3};
            HardEllipsoids simulation = start.simulation();
            g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
            g_assert_true(simulation.tune(100, 0.4, 0.0) == Status::success);
            double const translation = simulation.steps().translation / unit,
                         most = dimensions == 3 ? spacing / 4 - 1.0 / 3 : (spacing - 1.0) / 3.0;
            if (spacing > 2.0) g_assert_cmpfloat(translation, >=, 0.25);
            g_assert_cmpfloat(translation, <=, std::max(0.25, most) * (1 + 1e-12));
        }
}

/// Checks that long translations are the same in a restored simulation, which has a Verlet list of
/// its own, whose boxes other trials leave, and that they make no overlaps. Threads do not read
/// particles in other domains of the colour that they work on. Here these are little more than a
/// diameter apart along the first axis, and trials are as long. Particles that left their domains
/// would meet unseen, and overlap after a few sweeps. So would those in four domains of a cell that
/// is not wide enough for more than two.
inline void expect_same_long_trials(int dimensions, int n, std::int64_t least_accepted)
{
    constexpr double b = 1.2;
    for (double const a : {1.5, 1.2}) {
        Start start;
        for (int k = 0; k < 3 * n * (dimensions == 3 ? n : 1); ++k)
            start.add({a * (k % 3), b * (k / 3 % n), b * (k / 3 / n)}, {0.5, 0.5, 0.5});
        start.cell = box(3 * a, b * n, b * n);
        start.periodic = {1, 1, dimensions == 3};
        HardEllipsoids simulation = start.simulation();
        g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
        g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
        g_assert_true(simulation.set_steps({1.0, 0.1, 0.1}) == Status::success);
        for (int k = 0; k < 5; ++k) {
            HardEllipsoids other;
            g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), other) == Status::success);
            g_assert_true(simulation.sweep(4) == Status::success);
            g_assert_true(other.sweep(4) == Status::success);
            g_assert_true(bytes_of(other) == bytes_of(simulation));
        }
        g_assert_cmpint(simulation.counts().accepted[0], >, least_accepted);
        expect_no_overlap(simulation);
    }
}

/// All images that can be near, with the least |r_d| / (half-widths) and μ² of each.
struct AllImages {
    explicit AllImages(HardEllipsoids const &simulation)
        : system(simulation.system()), half_widths(system.num_particles)
    {
        for (std::size_t i = 0; i < half_widths.size(); ++i)
            for (int d = 0; d < 3; ++d)
                half_widths[i][d] = std::sqrt(system.q[6 * i + (d == 0 ? 0 : d == 1 ? 3 : 5)]);
    }

    Vector3 center(std::size_t i) const
    {
        return {system.centers[3 * i], system.centers[3 * i + 1], system.centers[3 * i + 2]};
    }
    pw85::SymmetricMatrix<double, 3> form(std::size_t i) const
    {
        pw85::SymmetricMatrix<double, 3> q;
        std::copy_n(system.q + 6 * i, 6, q.entries);
        return q;
    }

    /// Calls visit(j, image, translation) for the images at most four vectors away, but not for
    /// particle i itself.
    template <class Visit> void visit(std::size_t i, Visit const &visit_one) const
    {
        auto const reach = [&](int k) {
            return system.cell != nullptr && system.periodic[k] ? 4 : 0;
        };
        for (std::size_t j = 0; j < system.num_particles; ++j)
            for (int x = -reach(0); x <= reach(0); ++x)
                for (int y = -reach(1); y <= reach(1); ++y)
                    for (int z = -reach(2); z <= reach(2); ++z) {
                        if (i == j && x == 0 && y == 0 && z == 0) continue;
                        Vector3 translation{};
                        for (int d = 0; d < 3 && system.cell != nullptr; ++d)
                            translation[d] = x * system.cell[d] + y * system.cell[3 + d] +
                                             z * system.cell[6 + d];
                        visit_one(j, std::array<std::int32_t, 3>{x, y, z}, translation);
                    }
    }

    double least_mu2() const
    {
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < system.num_particles; ++i)
            visit(i, [&](std::size_t j, auto const &, Vector3 const &translation) {
                Vector3 const r = center(j) - center(i) + translation;
                least = std::min(least, pw85::contact(r, form(i), form(j)).mu2);
            });
        return least;
    }

    pw85_system system;
    std::vector<Vector3> half_widths;
};

/// The particles and the cell of a simulation, its lengths times a factor.
inline Start scaled(HardEllipsoids const &simulation, double factor)
{
    AllImages const all(simulation);
    Start start;
    std::copy_n(all.system.periodic, 3, start.periodic.begin());
    for (std::size_t i = 0; i < all.system.num_particles; ++i)
        start.add(factor * all.center(i), simulation.semi_axes()[i], simulation.quaternions()[i]);
    for (std::size_t k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d)
            start.cell[k][d] = factor * all.system.cell[3 * k + static_cast<std::size_t>(d)];
    return start;
}

// The least μ of pairs of a few semi-axes has a relative rounding error of some 2⁻⁵⁰. The
// quaternions of `scaled` are rounded again.
inline void expect_compression(HardEllipsoids simulation)
{
    double const expected = 1.0 / std::sqrt(AllImages(simulation).least_mu2());
    auto const before = bytes_of(simulation);
    double factor;
    g_assert_true(simulation.compress(false, factor) == Status::success);
    if (!(std::fabs(factor / expected - 1.0) <= 0x1p-40))
        g_test_fail_printf("%a instead of %a", factor, expected);
    g_assert_true(bytes_of(simulation) == before);
    HardEllipsoids other;
    pw85::IndexPair pair;
    g_assert_true(scaled(simulation, factor * (1.0 + 0x1p-38)).create(other, pair) ==
                  Status::success);
    g_assert_true(scaled(simulation, factor * (1.0 - 0x1p-38)).create(other, pair) ==
                  Status::overlap);
    double const measure = measure_of(simulation), dimensions = simulation.dimensions();
    double taken, again;
    g_assert_true(simulation.compress(true, taken) == Status::success && taken == factor);
    g_assert_cmpfloat(
        std::fabs(measure_of(simulation) / measure / std::pow(factor, dimensions) - 1.0), <,
        0x1p-48);
    expect_no_overlap(simulation);
    g_assert_true(simulation.compress(true, again) == Status::success);
    g_assert_true(1.0 - 0x1p-38 < again && again <= 1.0);
    expect_no_overlap(simulation);
    g_assert_true(simulation.sweep(2) == Status::success);
    expect_no_overlap(simulation);
}

/// Checks that a simulation has the same bits after it is restored, and with several threads.
/// work(simulation) returns a number that must be the same, too. There are many domains, and
/// particles diffuse out of the boxes of their Verlet lists.
template <class Work>
void expect_same_in_threads(Start const &start, int dimensions, int repetitions, Work const &work)
{
    auto const begin = [&] {
        HardEllipsoids simulation = start.simulation(42);
        g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
        g_assert_true(simulation.set_fractions({3, 3, 2, 1}) == Status::success);
        g_assert_true(simulation.set_steps({0.2, 0.1, 0.002}) == Status::success);
        return simulation;
    };
    Threads const one(1);
    HardEllipsoids simulation = begin(), resumed;
    double const first = work(simulation);
    auto const middle = bytes_of(simulation);
    double const second = work(simulation);
    auto const expected = bytes_of(simulation);
    expect_no_overlap(simulation);
    g_assert_cmpint(simulation.counts().accepted[4], >, 0);
    g_assert_true(hard_ellipsoids_restore(middle, resumed) == Status::success);
    g_assert_cmpint(resumed.dimensions(), ==, dimensions);
    g_assert_true(work(resumed) == second && bytes_of(resumed) == expected);
    // A domain that is taken too early changes the result in some runs only.
    for (int k = 0; k < repetitions; ++k) {
        Threads const several(2 + k % 2);
        HardEllipsoids parallel = begin();
        g_assert_true(work(parallel) == first && work(parallel) == second);
        g_assert_true(bytes_of(parallel) == expected);
    }
}

} // namespace pw85_tests

#endif
