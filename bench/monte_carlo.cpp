// SPDX-License-Identifier: BSD-3-Clause
// Measures the Monte Carlo of hard ellipsoids at packing fraction 0.4 and aspect ratio 3. measure.py runs it.
//
// The rows are `work,particles,per_second,speed_up,limit,bytes`: millions of trials, or of contacts for chains, in a second with one
// thread; the gain by a second thread of the library; the gain of two independent threads with one simulation each, which is what the
// machine gives two programs; and bytes of memory in use for each particle. Half of the trials are translations, half rotations. The work is
//
//     sweeps          trials at constant volume
//     pressure        trials with one change of the volume after each sweep
//     chains          contacts of event chains, which have one thread
//
// All systems repeat the same equilibrated block, so that they differ in their number of particles alone. The numbers of the particles are
// in random order. The arguments are the least and the largest number of particles, 1e3 and 1e6 by default, and the name of the only work to
// measure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <malloc.h>

#include <pw85/simulation.hpp>

#include "thread_gain.hpp"

namespace {

using pw85::HardEllipsoids;
using pw85::Status;
using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

constexpr Vector3 semi_axes = {0.5, 0.5, 1.5};
constexpr double packing_fraction = 0.4, pressure = 3.5, chain_length = 10.0;
/// Particles of a block along each axis, and sweeps in which a block forgets the lattice.
constexpr int block_side = 10, equilibration = 600;

void require(bool condition, char const *what)
{
    if (condition) return;
    std::fprintf(stderr, "monte_carlo: %s\n", what);
    std::exit(1);
}

struct System {
    std::vector<Vector3> centers;
    std::vector<Quaternion> quaternions;
    Vector3 sides;

    HardEllipsoids simulate(pw85::TrialSteps const &steps) const
    {
        pw85::Cell const cell{{{sides[0], 0.0, 0.0}, {0.0, sides[1], 0.0}, {0.0, 0.0, sides[2]}}};
        std::vector<Vector3> const all(centers.size(), semi_axes);
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        require(hard_ellipsoids_create({centers, {}, &cell}, all, quaternions, 1, simulation, pair) == Status::success,
                "no simulation");
        require(simulation.set_steps(steps) == Status::success, "no steps");
        return simulation;
    }

    /// Repeats the system along each axis.
    System repeated(int x, int y, int z) const
    {
        System whole{{}, {}, {x * sides[0], y * sides[1], z * sides[2]}};
        for (int k = 0; k < x * y * z; ++k) {
            Vector3 const shift = {k % x * sides[0], k / x % y * sides[1], k / x / y * sides[2]};
            for (Vector3 const &center : centers) whole.centers.push_back(center + shift);
            whole.quaternions.insert(whole.quaternions.end(), quaternions.begin(), quaternions.end());
        }
        return whole;
    }

    void shuffle()
    {
        std::vector<std::size_t> order(centers.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), std::mt19937_64(1));
        System const before = *this;
        for (std::size_t i = 0; i < order.size(); ++i) {
            centers[i] = before.centers[order[i]];
            quaternions[i] = before.quaternions[order[i]];
        }
    }
};

/// Parallel ellipsoids on a cubic lattice that is stretched as they are.
System lattice()
{
    double const stretch = 2.0 * std::cbrt(std::acos(-1.0) / 6.0 / packing_fraction);
    System system;
    for (int k = 0; k < block_side * block_side * block_side; ++k) {
        int const place[3] = {k % block_side, k / block_side % block_side, k / block_side / block_side};
        Vector3 center;
        for (int d = 0; d < 3; ++d) center[d] = stretch * semi_axes[d] * place[d];
        system.centers.push_back(center);
        system.quaternions.push_back({1.0, 0.0, 0.0, 0.0});
    }
    system.sides = stretch * block_side * semi_axes;
    return system;
}

/// An equilibrated block, and the steps by which 40 % of its trials are accepted.
struct Equilibrated {
    System system = lattice();
    pw85::TrialSteps steps{0.1, 0.05, 0.01};

    Equilibrated()
    {
        HardEllipsoids simulation = system.simulate(steps);
        require(simulation.tune(equilibration, 0.4) == Status::success, "no equilibration");
        auto const *const centers = reinterpret_cast<Vector3 const *>(simulation.system().centers);
        std::copy_n(centers, system.centers.size(), system.centers.begin());
        std::copy_n(simulation.quaternions().data(), system.quaternions.size(), system.quaternions.begin());
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

/// The particles that a chain moves, without the first one. That is the number of its contacts, unless a particle moves twice.
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

Problem sweeps(HardEllipsoids simulation, std::size_t n)
{
    return {std::move(simulation), [](HardEllipsoids &s) { return s.sweep(1); }, static_cast<double>(n)};
}

Problem sweeps_and_volume(HardEllipsoids simulation, std::size_t n)
{
    auto const work = [](HardEllipsoids &s) {
        Status const status = s.sweep(1);
        return status == Status::success ? s.volume_moves(1, pressure) : status;
    };
    require(simulation.tune(50, 0.4, pressure) == Status::success, "no equilibration");
    return {std::move(simulation), work, static_cast<double>(n)};
}

Problem chains(HardEllipsoids simulation, std::size_t n)
{
    constexpr int samples = 400;
    std::size_t contacts = 0;
    for (int k = 0; k < samples; ++k) contacts += contacts_of_chain(simulation);
    auto const work = [n](HardEllipsoids &s) {
        double z;
        return s.chain(n, chain_length, z);
    };
    return {std::move(simulation), work, static_cast<double>(n) * static_cast<double>(contacts) / samples};
}

struct Work {
    char const *name;
    Problem (*make)(HardEllipsoids, std::size_t);
    double least, most; ///< numbers of particles
};

constexpr Work all_work[] = {
    {"sweeps", sweeps, 1e3, 1e6}, {"pressure", sweeps_and_volume, 1e4, 1e5}, {"chains", chains, 1e4, 1e5}};

void measure_row(Work const &work, Equilibrated const &block, int x, int y, int z)
{
    System system = block.system.repeated(x, y, z);
    system.shuffle();
    std::size_t const n = system.centers.size();
    double const before = bytes_in_use();
    Problem first = work.make(system.simulate(block.steps), n);
    first.run();
    double const bytes = (bytes_in_use() - before) / static_cast<double>(n);
    Problem second = work.make(system.simulate(block.steps), n);
    // A sample is long enough to have its share of new lists of neighbours: some ten sweeps.
    double const sample = std::max(0.25, 8e-6 * static_cast<double>(n));
    pw85_bench::Gain const gain = pw85_bench::measure_threads(
        {sample, 12.0, 5, 1000}, [&] { first.run(); }, [&] { second.run(); });
    std::printf("%s,%zu,%.3g,%.2f,%.2f,%.0f\n", work.name, n, 1e-6 * first.number / gain.seconds, gain.speed_up,
                gain.limit, bytes);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    double const least = argc > 1 ? std::atof(argv[1]) : 1e3, largest = argc > 2 ? std::atof(argv[2]) : 1e6;
    constexpr int repetitions[][3] = {{1, 1, 1}, {5, 2, 1}, {5, 5, 4}, {10, 10, 10}};
    Equilibrated const block;
    std::printf("work,particles,per_second,speed_up,limit,bytes\n");
    for (Work const &work : all_work) {
        if (argc > 3 && std::string(argv[3]) != work.name) continue;
        for (auto const &[x, y, z] : repetitions) {
            double const n = 1e3 * x * y * z;
            if (n >= std::max(least, work.least) && n <= std::min(largest, work.most))
                measure_row(work, block, x, y, z);
        }
    }
    return 0;
}
