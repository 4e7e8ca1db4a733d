// The batch functions against a loop over pw85_contact_function(). Counters: `ns_pair`, nanoseconds per pair; `ratio`, how
// many times faster than the loop on the same pairs. PW85_TARGET chooses the instruction set.
#include <cstring>
#include <ctime>
#include <map>

#include <benchmark/benchmark.h>

#include <pw85.h>

#include "../pairs.hpp"
#include "neighbor_list.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pw85_bench;

namespace {

void set_threads(int threads)
{
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    (void)threads;
#endif
}

/// Pairs as the batch functions take them.
struct Arrays {
    std::vector<double> r12, q1, q2, mu2, lambda;
    std::vector<unsigned char> overlap;

    /// The pairs of a block, repeated until there are n.
    Arrays(std::vector<BenchPair> const &block, std::size_t n)
        : r12(3 * n), q1(6 * n), q2(6 * n), mu2(n), lambda(n), overlap(n)
    {
        for (std::size_t i = 0; i < n; ++i) {
            auto const &p = block[i % block.size()].pair;
            std::memcpy(&r12[3 * i], p.r12.coordinates, sizeof p.r12);
            std::memcpy(&q1[6 * i], p.q1.entries, sizeof p.q1);
            std::memcpy(&q2[6 * i], p.q2.entries, sizeof p.q2);
        }
    }

    std::size_t size() const { return mu2.size(); }
    void contact() { pw85_contact_batch(size(), r12.data(), q1.data(), q2.data(), mu2.data(), lambda.data()); }
    void run_overlap() { pw85_overlap_batch(size(), r12.data(), q1.data(), q2.data(), overlap.data()); }
};

/// The shortest of several times of a loop over n pairs, in seconds of the processor per pair.
template <class Call> double seconds_per_pair(std::size_t n, Call call)
{
    double shortest = 1e300;
    for (int repeat = 0; repeat < 10; ++repeat) {
        std::clock_t const start = std::clock();
        for (std::size_t i = 0; i < n; ++i) call(i);
        auto const ticks = static_cast<double>(std::clock() - start);
        shortest = std::min(shortest, ticks / static_cast<double>(CLOCKS_PER_SEC) / static_cast<double>(n));
    }
    return shortest;
}

/// The reference for a block of the given aspect ratio.
double reference(double aspect)
{
    static std::map<double, double> known;
    auto const [place, is_new] = known.try_emplace(aspect, 0.0);
    if (is_new) {
        auto const block = make_block(aspect);
        place->second = seconds_per_pair(block.size(), [&](std::size_t i) {
            double out[2];
            auto const &p = block[i].pair;
            pw85_contact_function(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
            benchmark::DoNotOptimize(out);
        });
    }
    return place->second;
}

void report(benchmark::State &state, std::size_t pairs, double reference_seconds)
{
    using benchmark::Counter;
    auto const n = static_cast<double>(pairs);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
    state.counters["ns_pair"] =
        Counter(n * 1e-9, static_cast<Counter::Flags>(Counter::kIsIterationInvariantRate | Counter::kInvert));
    state.counters["ratio"] = Counter(n * reference_seconds, Counter::kIsIterationInvariantRate);
}

void contact_batch(benchmark::State &state)
{
    set_threads(1);
    auto const aspect = static_cast<double>(state.range(0));
    Arrays arrays(make_block(aspect), block_size);
    for (auto _ : state) arrays.contact();
    report(state, arrays.size(), reference(aspect));
}
BENCHMARK(contact_batch)->ArgName("aspect")->Arg(2)->Arg(10)->Arg(100)->Arg(1000);

void overlap_batch(benchmark::State &state)
{
    set_threads(1);
    auto const aspect = static_cast<double>(state.range(0));
    Arrays arrays(make_block(aspect), block_size);
    for (auto _ : state) arrays.run_overlap();
    report(state, arrays.size(), reference(aspect));
}
BENCHMARK(overlap_batch)->ArgName("aspect")->Arg(2)->Arg(10)->Arg(100)->Arg(1000);

/// 1e5 particles and 2e6 pairs of aspect ratio 3.
NeighborSystem const &neighbor_system(bool sorted)
{
    static NeighborSystem const systems[] = {make_system(100000, 3.0, false), make_system(100000, 3.0, true)};
    return systems[sorted];
}

/// The reference for the first pairs of a list, whose particles are gathered by the caller.
double list_reference(bool sorted)
{
    static double known[2] = {0.0, 0.0};
    NeighborSystem const &system = neighbor_system(sorted);
    if (known[sorted] == 0.0)
        known[sorted] = seconds_per_pair(20000, [&](std::size_t k) {
            auto const i = static_cast<std::size_t>(system.pairs[k][0]),
                       j = static_cast<std::size_t>(system.pairs[k][1]);
            double r12[3], out[2];
            for (int d = 0; d < 3; ++d) {
                double const x = system.centers[j][d] - system.centers[i][d];
                r12[d] = x - system.side * std::round(x / system.side);
            }
            pw85_contact_function(r12, system.q[i].entries, system.q[j].entries, out);
            benchmark::DoNotOptimize(out);
        });
    return known[sorted];
}

enum CellKind : int { no_cell, cubic, skewed };

template <class Run> void run_list(benchmark::State &state, Run run)
{
    set_threads(1);
    bool const sorted = state.range(0) != 0;
    NeighborSystem const &system = neighbor_system(sorted);
    auto const cell = state.range(1) == skewed ? system.skewed_cell() : system.cell();
    double const *const cell_or_null = state.range(1) == no_cell ? nullptr : cell.data();
    for (auto _ : state)
        run(system.pairs.size(), system.pairs[0].data(), nullptr, system.centers.size(), system.centers[0].coordinates,
            system.q[0].entries, cell_or_null);
    report(state, system.pairs.size(), list_reference(sorted));
    state.counters["pairs"] = static_cast<double>(system.pairs.size());
}

void contact_pairs(benchmark::State &state)
{
    std::vector<double> mu2(neighbor_system(state.range(0) != 0).pairs.size());
    run_list(state, [&](auto... list) { pw85_contact_pairs(list..., mu2.data(), nullptr); });
}
BENCHMARK(contact_pairs)
    ->ArgNames({"sorted", "cell"})
    ->ArgsProduct({{0, 1}, {no_cell, cubic, skewed}})
    ->Unit(benchmark::kMillisecond);

void overlap_pairs(benchmark::State &state)
{
    std::vector<unsigned char> overlap(neighbor_system(state.range(0) != 0).pairs.size());
    run_list(state, [&](auto... list) { pw85_overlap_pairs(list..., overlap.data()); });
}
BENCHMARK(overlap_pairs)
    ->ArgNames({"sorted", "cell"})
    ->ArgsProduct({{0, 1}, {no_cell, cubic, skewed}})
    ->Unit(benchmark::kMillisecond);

/// A million pairs on several threads: compare the times.
void contact_threads(benchmark::State &state)
{
    set_threads(static_cast<int>(state.range(0)));
    Arrays arrays(make_block(10.0), 1000000);
    for (auto _ : state) arrays.contact();
    report(state, arrays.size(), reference(10.0));
    set_threads(1);
}
BENCHMARK(contact_threads)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The cost per pair from a thousand to ten million pairs, from the cache to main memory.
void contact_size(benchmark::State &state)
{
    set_threads(1);
    Arrays arrays(make_block(10.0), static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) arrays.contact();
    report(state, arrays.size(), reference(10.0));
}
BENCHMARK(contact_size)->ArgName("pairs")->RangeMultiplier(10)->Range(1000, 10000000)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
