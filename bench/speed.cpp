// SPDX-License-Identifier: BSD-3-Clause
// Measures the time per pair of every public function, by Google Benchmark: `items_per_second`
// counts pairs. measure.py runs it. The names of the benchmarks are
//
//     FUNCTION/ASPECT               on pairs half of which overlap (pairs.hpp)
//     FUNCTION/ASPECT/EXCESS        on pairs with |μ² - 1| = EXCESS
//     FUNCTION/list/ORDER/CELL      on a neighbour list of aspect ratio 3 (neighbor_list.hpp)
//     FUNCTION/million              on a million pairs of aspect ratio 10, in real time
//
// Environment variables select the instruction set (PW85_TARGET) and the number of threads of the
// batch (OMP_NUM_THREADS).
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "functions.hpp"
#include "neighbor_list.hpp"
#include "systems.hpp"

using namespace pw85_bench;
using pw85_tests::list_of;
using pw85_tests::system_of;

namespace {

/// The block of pairs for an aspect ratio and an excess. Each block is made only once.
Block &block(double aspect, double excess)
{
    static std::map<std::pair<double, double>, std::unique_ptr<Block>> blocks;
    auto &place = blocks[{aspect, excess}];
    if (!place) place = std::make_unique<Block>(random_block(aspect, excess));
    return *place;
}

void count_pairs(benchmark::State &state, std::size_t pairs)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
}

std::string text(double number)
{
    char digits[40];
    std::snprintf(digits, sizeof digits, "%g", number);
    return digits;
}

template <class Run> void add(std::string const &name, double aspect, double excess, Run run)
{
    auto const measure = [=](benchmark::State &state) {
        Block &b = block(aspect, excess);
        for ([[maybe_unused]] auto _ : state) run(b);
        count_pairs(state, b.size());
    };
    std::string title = name + '/' + text(aspect);
    if (excess > 0.0) title += '/' + text(excess);
    benchmark::RegisterBenchmark(title.c_str(), measure);
}

void add(Function const &function, double aspect, double excess = 0.0)
{
    add(function.name, aspect, excess, [call = function.call](Block &b) {
        Sink sink{};
        for (std::size_t i = 0; i < b.size(); ++i) {
            call(b.pairs[i], b.lambdas[i], sink);
            benchmark::DoNotOptimize(sink);
        }
    });
}

void add(BatchFunction const &function, double aspect, double excess = 0.0)
{
    add(function.name, aspect, excess, function.call);
}

/// Registers all functions on pairs far from contact, and those whose time depends on |μ² - 1| also
/// on pairs near contact.
template <class Functions> void add_all(Functions const &functions)
{
    for (auto const &function : functions) {
        for (double const aspect : {2.0, 10.0, 100.0, 1000.0}) add(function, aspect);
        if (std::string(function.name).find("overlap") == std::string::npos) continue;
        for (double const aspect : {2.0, 10.0, 100.0})
            for (double const excess : {1e-2, 1e-4, 1e-6, 1e-8}) add(function, aspect, excess);
    }
}

/// Registers the functions of lists on 1e5 particles and 2e6 pairs of aspect ratio 3.
NeighborSystem const &neighbor_system(bool sorted)
{
    static NeighborSystem const systems[] = {make_system(100000, 3.0, false),
                                             make_system(100000, 3.0, true)};
    return systems[sorted];
}

enum class Cell { none, cubic, skewed };

template <class Run> void add_list(char const *function, bool sorted, Cell kind, Run run)
{
    constexpr char const *names[] = {"no_cell", "cubic", "skewed"};
    std::string const name = std::string(function) + "/list/" + (sorted ? "sorted/" : "unsorted/") +
                             names[static_cast<int>(kind)];
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State &state) {
        NeighborSystem const &system = neighbor_system(sorted);
        auto const cell = kind == Cell::skewed ? system.skewed_cell() : system.cell();
        for ([[maybe_unused]] auto _ : state)
            run(list_of(system.pairs.size(), system.pairs[0].data()),
                system_of(system.centers.size(), system.centers[0].coordinates, system.q[0].entries,
                          kind == Cell::none ? nullptr : cell.data()));
        count_pairs(state, system.pairs.size());
    })->Unit(benchmark::kMillisecond);
}

void add_lists()
{
    static std::vector<double> mu2(4000000);
    static std::vector<unsigned char> overlap(mu2.size());
    for (bool const sorted : {false, true})
        for (Cell const cell : {Cell::none, Cell::cubic, Cell::skewed}) {
            add_list("contact_pairs", sorted, cell,
                     [](auto const &...list) { pw85_contact_pairs(list..., mu2.data(), nullptr); });
            add_list("overlap_pairs", sorted, cell,
                     [](auto const &...list) { pw85_overlap_pairs(list..., overlap.data()); });
        }
}

void add_million(BatchFunction const &function)
{
    benchmark::RegisterBenchmark((std::string(function.name) + "/million").c_str(),
                                 [call = function.call](benchmark::State &state) {
                                     Block million(random_block(10.0, 0.0, 1000000));
                                     for ([[maybe_unused]] auto _ : state) call(million);
                                     count_pairs(state, million.size());
                                 })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char **argv)
{
    add_all(functions);
    add_all(batch_functions);
    add_lists();
    for (auto const &function : batch_functions) add_million(function);
    benchmark::AddCustomContext("pw85", pw85_version());
    benchmark::AddCustomContext("compiler", PW85_BENCH_COMPILER);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
