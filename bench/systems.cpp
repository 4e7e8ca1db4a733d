// SPDX-License-Identifier: BSD-3-Clause
// Measures functions of whole systems, by Google Benchmark: random ellipsoids in a cubic periodic
// cell, in processor time. measure.py runs it. The names of the benchmarks are
//
//     neighbors/ASPECT/NUMBER    making a list at packing fraction 0.5; `items_per_second` counts
//                                particles
//     derivatives_pairs/NUMBER   derivatives of the pairs of a list of as many particles; counts
//                                pairs
//     forces/NUMBER              the same, and the sums of their forces, in two steps
//     law/LAW/NUMBER             the sums of a law in one step; `law/two_steps`: the soft repulsion
//                                by derivatives, U' and sums
//     threads/neighbors, ...     the same with two threads, in real time: `speed_up` over one
//                                thread, and the `limit` of this machine, which is the gain of two
//                                independent programs with one thread and one system each
//     overlap_any                one ellipsoid, given by its form, against 16 neighbours that it
//                                does not overlap; counts calls
//     overlap_any/quaternion     the same, given by its quaternion
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <benchmark/benchmark.h>

#include <pw85/batch.hpp>
#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include "spheroids.hpp"

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Form = pw85::SymmetricMatrix<double, 3>;
using pw85_bench::System;

void count(benchmark::State &state, std::size_t items)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void neighbors(benchmark::State &state)
{
    auto const n = static_cast<std::size_t>(state.range(1));
    System const system(n, static_cast<double>(state.range(0)), 0.5);
    for ([[maybe_unused]] auto _ : state) {
        pw85::Neighbors list;
        neighbors_create(system.particles(), {}, list);
        benchmark::DoNotOptimize(list.pairs().data());
    }
    count(state, n);
}

/// A neighbour list and the derivatives of its pairs.
struct Derivatives {
    System system;
    pw85::Neighbors list;
    std::vector<double> mu2, lambda;
    std::vector<Vector3> d_r12, d_rot1, d_rot2;

    explicit Derivatives(std::size_t num_particles) : system(num_particles, 3.0, 0.5)
    {
        neighbors_create(system.particles(), {}, list);
        std::size_t const n = list.pairs().size();
        mu2.resize(n);
        lambda.resize(n);
        for (auto *rows : {&d_r12, &d_rot1, &d_rot2}) rows->resize(n);
    }

    pw85::DerivativeSpans spans()
    {
        pw85::DerivativeSpans result;
        result.mu2 = mu2;
        result.lambda = lambda;
        result.d_r12 = d_r12;
        result.d_rot1 = d_rot1;
        result.d_rot2 = d_rot2;
        return result;
    }
};

void derivatives_pairs(benchmark::State &state)
{
    Derivatives d(static_cast<std::size_t>(state.range(0)));
    for ([[maybe_unused]] auto _ : state)
        contact_derivatives_pairs(d.list.list(), d.system.particles(), d.spans());
    count(state, d.list.pairs().size());
}

/// The sums of forces, torques and virial of a system.
struct Sums {
    std::vector<Vector3> forces, torques;
    std::array<Vector3, 3> virial;
    double energy;

    explicit Sums(std::size_t num_particles) : forces(num_particles), torques(num_particles) {}
    pw85::ForceSpans spans() { return {forces, torques, &virial}; }
};

/// The soft repulsion (1 - μ)²/2 as a user of derivatives computes it.
void compute_slopes(std::vector<double> const &mu2, std::vector<double> &d_u)
{
    for (std::size_t k = 0; k < mu2.size(); ++k) {
        double const mu = std::sqrt(mu2[k]);
        d_u[k] = mu < 1.0 ? -(1.0 - mu) / (2.0 * mu) : 0.0;
    }
}

void two_steps(benchmark::State &state)
{
    Derivatives d(static_cast<std::size_t>(state.range(0)));
    Sums sums(d.system.q.size());
    std::vector<double> d_u(d.mu2.size());
    for ([[maybe_unused]] auto _ : state) {
        contact_derivatives_pairs(d.list.list(), d.system.particles(), d.spans());
        compute_slopes(d.mu2, d_u);
        contact_forces_pairs(d.list.list(), d.system.particles(), d_u, d.spans(), sums.spans());
    }
    count(state, d.list.pairs().size());
}

void forces(benchmark::State &state)
{
    Derivatives d(static_cast<std::size_t>(state.range(0)));
    Sums sums(d.system.q.size());
    for ([[maybe_unused]] auto _ : state) {
        contact_derivatives_pairs(d.list.list(), d.system.particles(), d.spans());
        contact_forces_pairs(d.list.list(), d.system.particles(), d.mu2, d.spans(), sums.spans());
    }
    count(state, d.list.pairs().size());
}

/// A table of (1 - μ²)² at 101 points.
std::vector<double> table()
{
    std::vector<double> numbers = {0.0, 1.0};
    for (int k = 0; k <= 100; ++k) {
        double const x = 0.01 * k;
        numbers.insert(numbers.end(), {(1.0 - x) * (1.0 - x), -2.0 * (1.0 - x)});
    }
    return numbers;
}

void law(benchmark::State &state, int kind, std::vector<double> const &parameters)
{
    auto const n = static_cast<std::size_t>(state.range(0));
    System const system(n, 3.0, 0.5);
    pw85::Neighbors list;
    neighbors_create(system.particles(), {}, list);
    Sums sums(n);
    for ([[maybe_unused]] auto _ : state)
        law_forces_pairs(list.list(), system.particles(), {kind, parameters}, sums.energy,
                         sums.spans());
    count(state, list.pairs().size());
}

#ifdef _OPENMP

/// The time of a work item with a number of threads of the library.
template <class Work> double seconds(int threads, Work const &work)
{
    omp_set_num_threads(threads);
    auto const start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Three measurements with two equal systems: one system with one thread, both systems at once with
/// one thread each, and one system with two threads.
template <class Work> void compare_threads(benchmark::State &state, Work const &work)
{
    double one = HUGE_VAL, both = HUGE_VAL, two = HUGE_VAL;
    for ([[maybe_unused]] auto _ : state) {
        one = std::min(one, seconds(1, [&] { work(0); }));
        both = std::min(both, seconds(1, [&] {
                            std::thread other([&] { seconds(1, [&] { work(1); }); });
                            work(0);
                            other.join();
                        }));
        double const time = seconds(2, [&] { work(0); });
        two = std::min(two, time);
        state.SetIterationTime(time);
    }
    state.counters["speed_up"] = one / two;
    state.counters["limit"] = 2.0 * one / both;
}

void threads_neighbors(benchmark::State &state)
{
    System const systems[2] = {{1000000, 3.0, 0.5}, {1000000, 3.0, 0.5}};
    compare_threads(state, [&](std::size_t k) {
        pw85::Neighbors list;
        neighbors_create(systems[k].particles(), {}, list);
        benchmark::DoNotOptimize(list.pairs().data());
    });
}

void threads_derivatives_pairs(benchmark::State &state)
{
    Derivatives both[2] = {Derivatives(100000), Derivatives(100000)};
    compare_threads(state, [&](std::size_t k) {
        contact_derivatives_pairs(both[k].list.list(), both[k].system.particles(), both[k].spans());
    });
}

BENCHMARK(threads_neighbors)
    ->Name("threads/neighbors")
    ->UseManualTime()
    ->Iterations(7)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(threads_derivatives_pairs)
    ->Name("threads/derivatives_pairs")
    ->UseManualTime()
    ->Iterations(15)
    ->Unit(benchmark::kMillisecond);

#endif

void overlap_any(benchmark::State &state)
{
    constexpr std::size_t num_others = 16;
    bool const from_quaternion = state.range(0) != 0;
    System system(num_others + 1, 3.0, 0.4);
    pw85_tests::Random random(132);
    pw85::Vector<double, 4> const quaternion = random.direction<4>();
    Vector3 const semi_axes = {1.0, 1.0, 3.0};
    std::vector<std::int32_t> others;
    for (std::size_t i = 1; i <= num_others; ++i) {
        // The neighbours are as near as those of a dense system that do not overlap.
        Vector3 const direction = random.direction<3>();
        double const touch = pw85::closest_approach(direction, system.q[0], system.q[i]).distance;
        for (int d = 0; d < 3; ++d)
            system.centers[i][d] =
                system.centers[0][d] + random.uniform(1.05, 1.8) * touch * direction[d];
        others.push_back(static_cast<std::int32_t>(i));
    }
    for (auto &row : system.cell)
        for (int d = 0; d < 3; ++d) row[d] *= 4.0; // so that no periodic image is near
    int any = 0;
    for ([[maybe_unused]] auto _ : state) {
        Form const q =
            from_quaternion ? pw85::ellipsoid_quaternion(semi_axes, quaternion).q : system.q[0];
        benchmark::DoNotOptimize(q);
        overlap_any_indices(system.centers[0], from_quaternion ? system.q[0] : q, others,
                            system.particles(), any);
        benchmark::DoNotOptimize(any);
    }
    if (any != 0) state.SkipWithError("an overlap");
    count(state, 1);
}

BENCHMARK(neighbors)
    ->ArgsProduct({{3, 10}, {10000, 100000, 1000000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(neighbors)->Args({3, 10000000})->Unit(benchmark::kMillisecond);
BENCHMARK(derivatives_pairs)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(forces)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(two_steps)->Name("law/two_steps")->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(law, soft_repulsion, PW85_LAW_SOFT_REPULSION, {1.0, 2.0})
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(law, inverse_powers, PW85_LAW_INVERSE_POWERS, {4.0, 12.0, 4.0, 6.0, 1e300})
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(law, table, PW85_LAW_TABLE, table())
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(overlap_any)->ArgName("quaternion")->Arg(0)->Arg(1);

} // namespace

BENCHMARK_MAIN();
