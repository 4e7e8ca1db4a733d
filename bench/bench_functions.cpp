// Every public function of one pair, at aspect ratios 2, 10, 100 and 1000, by Google Benchmark: nanoseconds per block of
// 4096 pairs, and pairs per second. For steady numbers:
//
//     bench_functions --benchmark_repetitions=9 --benchmark_report_aggregates_only --benchmark_filter=contact
#include <benchmark/benchmark.h>

#include "functions.hpp"

using namespace pw85_bench;

int main(int argc, char **argv)
{
    for (auto const &function : functions)
        benchmark::RegisterBenchmark(function.name,
                                     [call = function.call](benchmark::State &state) {
                                         auto const block = make_block(static_cast<double>(state.range(0)));
                                         Sink sink{};
                                         for ([[maybe_unused]] auto _ : state)
                                             for (auto const &pair : block) {
                                                 call(pair, sink);
                                                 benchmark::DoNotOptimize(sink);
                                             }
                                         state.SetItemsProcessed(state.iterations() * block_size);
                                     })
            ->Arg(2)
            ->Arg(10)
            ->Arg(100)
            ->Arg(1000);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
