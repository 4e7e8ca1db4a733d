// SPDX-License-Identifier: BSD-3-Clause
// Measures Monte Carlo on the inputs that HOOMD's developers use for their engines: ellipsoids with
// semi-axes 2.5, 0.5, 0.5.
//
//     hoomd_benchmarks.hpmc_ellipsoid   packing fraction 0.5, d = 0.0366, a = 0.0198
//     hoomd-rs, mc_3d_ellipsoid         packing fraction 0.4, d = 0.19, a = 0.093
//
// Half of the trials are translations by a point of a ball with radius d, half are rotations.
// HOOMD-blue adds a random quaternion of length a to that of a particle, and hoomd-rs rotates by a
// vector of three normal numbers with standard deviation a. With the imaginary part v of the
// quaternion (1, v), the mean square of both is 3 a²/4 to first order. Here v is a point of a ball,
// whose mean square is three fifths of its squared radius. So the radius is a √5/2.
//
// The start is as theirs: parallel ellipsoids, 6 apart on a cubic lattice, are moved with d = a =
// 0.1 and then compressed, so that the fluid has no common director. To be quick, 128 of them are
// compressed, repeated to a block of 1024, and relaxed. All systems repeat the block, with the
// particles numbered at random.
//
// The rows are `input,particles,per_second,translations,rotations`: millions of trials in a second
// with one thread, by the time of the processor; and the parts of the translations and rotations
// that are accepted. The arguments are the largest number of particles, 65536 by default, and the
// name of the only input to measure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include <pw85/pw85.hpp>

#include "hard_systems.hpp"
#include "thread_gain.hpp"
#include "trial_run.hpp"

namespace {

using pw85::HardEllipsoids;
using pw85::Status;
using pw85_bench::require, pw85_bench::System;

struct Input {
    char const *name;
    double packing_fraction, translation, rotation;
};

constexpr Input inputs[] = {{"hoomd_benchmarks", 0.5, 0.03662120237875685, 0.019755985607527712},
                            {"hoomd_rs", 0.4, 0.19, 0.093}};
constexpr int repetitions[][3] = {{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 2, 2},
                                  {4, 2, 2}, {4, 4, 2}, {4, 4, 4}};
/// times along each axis, to the block
constexpr int compressed_lattice[3] = {8, 4, 4}, compressed_times = 2;
constexpr double block_size = 1024.0;
constexpr std::size_t randomizing = 4000, relaxing = 4000; ///< sweeps

double volume(System const &system) { return system.sides[0] * system.sides[1] * system.sides[2]; }

/// Some particles at a packing fraction, compressed between sweeps as far as the particles allow.
System compressed(double packing_fraction)
{
    System system = pw85_bench::lattice(3, {2.5, 0.5, 0.5}, compressed_lattice, {6.0, 6.0, 6.0});
    double const particle = pw85::volume(pw85::spheroid(0.5, 2.5, {1.0, 0.0, 0.0}).q).volume;
    double const wanted = particle * static_cast<double>(system.centers.size()) / packing_fraction;
    HardEllipsoids simulation = system.simulate({0.1, 0.1, 0.01});
    require(simulation.sweep(randomizing) == Status::success, "no sweeps");
    for (;;) {
        double factor;
        require(simulation.tune(5, 0.3) == Status::success, "no sweeps");
        require(simulation.compress(false, factor) == Status::success, "no compression");
        system.take(simulation);
        double const to_wanted = std::cbrt(wanted / volume(system));
        if (factor <= to_wanted) {
            for (auto &center : system.centers) center = to_wanted * center;
            system.sides = to_wanted * system.sides;
            return system;
        }
        require(simulation.compress(true, factor) == Status::success, "no compression");
    }
}

/// The part of the trials of one kind that was accepted.
double acceptance(pw85::TrialCounts const &counts, std::size_t kind)
{
    return static_cast<double>(counts.accepted[kind]) / static_cast<double>(counts.trials[kind]);
}

/// Seconds of the processors for some work, which are those of a clock on the wall if nothing else
/// runs.
template <class Work> double processor_seconds(Work const &work)
{
    std::clock_t const before = std::clock();
    work();
    return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

/// Millions of trials in a second of one thread, the most of several samples. A sample has some ten
/// sweeps at least, and so its share of new lists of neighbours.
double measure_speed(HardEllipsoids &simulation, double n)
{
    double best = 0.0;
    auto const sweeps = static_cast<std::size_t>(std::max(10.0, 2e5 / n));
    double const total = pw85_bench::is_trial_run() ? 1e-9 : 4.0;
    pw85_bench::seconds(1, [&] {
        for (double spent = 0.0; spent < total;) {
            double const one = processor_seconds(
                [&] { require(simulation.sweep(sweeps) == Status::success, "no sweep"); });
            best = std::max(best, 1e-6 * static_cast<double>(sweeps) * n / one);
            spent += one;
        }
    });
    return best;
}

void measure_row(Input const &input, System const &block, pw85::TrialSteps const &steps,
                 int const (&times)[3])
{
    System system = block.repeated(times[0], times[1], times[2]);
    system.shuffle();
    auto const n = static_cast<double>(system.centers.size());
    HardEllipsoids simulation = system.simulate(steps);
    double const speed = measure_speed(simulation, n);
    pw85::TrialCounts const counts = simulation.counts();
    std::printf("%s,%.0f,%.3g,%.2f,%.2f\n", input.name, n, speed, acceptance(counts, 0),
                acceptance(counts, 1));
    std::fflush(stdout);
}

void measure(Input const &input, double largest)
{
    System block = compressed(input.packing_fraction)
                       .repeated(compressed_times, compressed_times, compressed_times);
    pw85::TrialSteps const steps{input.translation, std::sqrt(1.25) * input.rotation, 0.01};
    HardEllipsoids simulation = block.simulate(steps);
    std::size_t const sweeps = pw85_bench::is_trial_run() ? 1 : relaxing;
    require(simulation.sweep(sweeps) == Status::success, "no sweeps");
    block.take(simulation);
    for (auto const &times : repetitions)
        if (block_size * times[0] * times[1] * times[2] <= largest)
            measure_row(input, block, steps, times);
}

} // namespace

int main(int argc, char **argv)
{
    double const largest = argc > 1 ? std::atof(argv[1]) : 65536.0;
    std::printf("input,particles,per_second,translations,rotations\n");
    for (Input const &input : inputs)
        if (argc < 3 || std::string(argv[2]) == input.name) measure(input, largest);
    return 0;
}
