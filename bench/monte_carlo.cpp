// SPDX-License-Identifier: BSD-3-Clause
// Measures the Monte Carlo of hard ellipsoids at packing fraction 0.4, and of hard ellipses at area
// fraction 0.6, at aspect ratio 3. measure.py runs it.
//
// The rows are `work,dimensions,particles,per_second,speed_up,limit,bytes`: millions of trials, or
// of contacts for chains, in a second with one thread; the gain by a second thread of the library;
// the gain of two independent threads with one simulation each, which is what the machine gives two
// programs; and bytes of memory in use for each particle. Half of the trials are translations, half
// rotations. The work is
//
//     sweeps          trials at constant volume
//     pressure        trials with one change of the volume after each sweep
//     chains          contacts of event chains, which have one thread
//
// All systems repeat the same equilibrated block, so that they differ in their number of particles
// alone. The numbers of the particles are in random order. The arguments are the least and the
// largest number of particles, 1e3 and 1e6 by default, and the name of the only work to measure.
// Both fluids have a βP/ρ of 8 to 9.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <malloc.h>

#include "hard_systems.hpp"
#include "thread_gain.hpp"

namespace {

using pw85::HardEllipsoids;
using pw85::Status;
using pw85_bench::lattice, pw85_bench::require, pw85_bench::System, pw85_bench::Vector3;

/// Sweeps in which a block forgets the lattice.
constexpr int equilibration = 600;
constexpr double chain_length = 10.0;

/// Particles of space, or of the plane, in blocks of a thousand.
struct Fluid {
    int dimensions;
    Vector3 semi_axes;
    double packing_fraction, pressure;
    int block[3];          ///< particles along each axis
    int repetitions[4][3]; ///< of the block
};

constexpr Fluid fluids[] = {
    {3, {0.5, 0.5, 1.5}, 0.4, 3.5, {10, 10, 10}, {{1, 1, 1}, {5, 2, 1}, {5, 5, 4}, {10, 10, 10}}},
    {2, {0.5, 1.5, 0.5}, 0.6, 2.0, {50, 20, 1}, {{1, 1, 1}, {2, 5, 1}, {10, 10, 1}, {20, 50, 1}}},
};

/// Parallel ellipsoids on a cubic lattice, or ellipses on a square one, that is stretched as they
/// are.
System stretched_lattice(Fluid const &fluid)
{
    double const pi = std::acos(-1.0), fraction = fluid.packing_fraction;
    double const stretch = 2.0 * (fluid.dimensions == 3 ? std::cbrt(pi / 6.0 / fraction)
                                                        : std::sqrt(pi / 4.0 / fraction));
    return lattice(fluid.dimensions, fluid.semi_axes, fluid.block, stretch * fluid.semi_axes);
}

/// An equilibrated block, and the steps by which 40 % of its trials are accepted.
struct Equilibrated {
    System system;
    double pressure;
    pw85::TrialSteps steps{0.1, 0.05, 0.01};

    explicit Equilibrated(Fluid const &fluid)
        : system(stretched_lattice(fluid)), pressure(fluid.pressure)
    {
        HardEllipsoids simulation = system.simulate(steps);
        require(simulation.tune(equilibration, 0.4) == Status::success, "no equilibration");
        system.take(simulation);
        steps.translation = simulation.steps().translation;
        steps.rotation = simulation.steps().rotation;
    }
};

/// Allocated bytes, or NaN if the library of C does not tell.
double bytes_in_use()
{
#ifdef __GLIBC__
    auto const all = mallinfo2();
    return static_cast<double>(all.uordblks + all.hblkhd);
#else
    return NAN;
#endif
}

/// A simulation that repeats some work, and how many trials or contacts there are in it.
struct Problem {
    HardEllipsoids simulation;
    std::function<Status(HardEllipsoids &)> work;
    double number;

    void run() { require(work(simulation) == Status::success, "no success"); }
};

/// The particles that a chain moves, without the first one. That is the number of its contacts,
/// unless a particle moves twice.
std::size_t contacts_of_chain(HardEllipsoids &simulation)
{
    pw85_system const system = simulation.system();
    auto const *const centers = reinterpret_cast<Vector3 const *>(system.centers);
    std::vector<Vector3> const before(centers, centers + system.num_particles);
    double z;
    require(simulation.chain(1, chain_length, z) == Status::success, "no chain");
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        Vector3 const way = centers[i] - before[i];
        moved += dot(way, way) > 0.0;
    }
    return moved - 1;
}

Problem sweeps(HardEllipsoids simulation, std::size_t n, double)
{
    return {std::move(simulation), [](HardEllipsoids &s) { return s.sweep(1); },
            static_cast<double>(n)};
}

Problem sweeps_and_volume(HardEllipsoids simulation, std::size_t n, double pressure)
{
    auto const work = [pressure](HardEllipsoids &s) {
        Status const status = s.sweep(1);
        return status == Status::success ? s.volume_moves(1, pressure) : status;
    };
    require(simulation.tune(50, 0.4, pressure) == Status::success, "no equilibration");
    return {std::move(simulation), work, static_cast<double>(n)};
}

Problem chains(HardEllipsoids simulation, std::size_t n, double)
{
    constexpr int samples = 400;
    std::size_t contacts = 0;
    for (int k = 0; k < samples; ++k) contacts += contacts_of_chain(simulation);
    auto const work = [n](HardEllipsoids &s) {
        double z;
        return s.chain(n, chain_length, z);
    };
    return {std::move(simulation), work,
            static_cast<double>(n) * static_cast<double>(contacts) / samples};
}

struct Work {
    char const *name;
    Problem (*make)(HardEllipsoids, std::size_t, double pressure);
    double least, most; ///< numbers of particles
};

constexpr Work all_work[] = {{"sweeps", sweeps, 1e3, 1e6},
                             {"pressure", sweeps_and_volume, 1e4, 1e5},
                             {"chains", chains, 1e4, 1e5}};

void measure_row(Work const &work, Equilibrated const &block, int x, int y, int z)
{
    System system = block.system.repeated(x, y, z);
    system.shuffle();
    std::size_t const n = system.centers.size();
    double const before = bytes_in_use();
    Problem first = work.make(system.simulate(block.steps), n, block.pressure);
    first.run();
    double const bytes = (bytes_in_use() - before) / static_cast<double>(n);
    Problem second = work.make(system.simulate(block.steps), n, block.pressure);
    // A sample is long enough to have its share of new lists of neighbours: some ten sweeps.
    double const sample = std::max(0.25, 8e-6 * static_cast<double>(n));
    pw85_bench::Gain const gain = pw85_bench::measure_threads(
        {sample, 12.0, 5, 1000}, [&] { first.run(); }, [&] { second.run(); });
    std::printf("%s,%d,%zu,%.3g,%.2f,%.2f,%.0f\n", work.name, system.dimensions, n,
                1e-6 * first.number / gain.seconds, gain.speed_up, gain.limit, bytes);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    double const least = argc > 1 ? std::atof(argv[1]) : 1e3,
                 largest = argc > 2 ? std::atof(argv[2]) : 1e6;
    std::printf("work,dimensions,particles,per_second,speed_up,limit,bytes\n");
    for (Fluid const &fluid : fluids) {
        Equilibrated const block(fluid);
        for (Work const &work : all_work) {
            if (argc > 3 && std::string(argv[3]) != work.name) continue;
            for (auto const &[x, y, z] : fluid.repetitions) {
                double const n = 1e3 * x * y * z;
                if (n >= std::max(least, work.least) && n <= std::min(largest, work.most))
                    measure_row(work, block, x, y, z);
            }
        }
    }
    return 0;
}
