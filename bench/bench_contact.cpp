// Times of the functions that matter to a simulation, and their ratio to pw85_contact_function(): one thread, one run,
// medians over repetitions in which the functions take turns. Usage: bench_contact [REPETITIONS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "functions.hpp"

using namespace pw85_bench;

namespace {

constexpr double aspects[] = {2.0, 10.0, 100.0, 1000.0};
constexpr int num_shown = 7; // of the functions in functions.hpp

double nanoseconds_per_pair(Function const &function, std::vector<BenchPair> const &block)
{
    static Sink sink; // with static storage, so that the results are not optimised away

    auto const start = std::chrono::steady_clock::now();
    for (auto const &pair : block) function.call(pair, sink);
    auto const stop = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::nano>(stop - start).count() / block_size;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void print_table(double aspect, int repetitions)
{
    auto const block = make_block(aspect);
    std::vector<double> times[num_shown];
    for (int n = 0; n <= repetitions; ++n)
        for (int i = 0; i < num_shown; ++i) {
            double const time = nanoseconds_per_pair(functions[i], block);
            if (n > 0) times[i].push_back(time); // the first round warms up
        }
    double const reference = median(times[0]);
    for (int i = 0; i < num_shown; ++i) {
        double const time = median(times[i]);
        std::printf("%7g  %-20s %9.1f %12.3g %9.2f\n", aspect, functions[i].name, time, 1e9 / time, reference / time);
    }
}

} // namespace

int main(int argc, char **argv)
{
    int const repetitions = argc > 1 ? std::atoi(argv[1]) : 51;
    if (repetitions < 1) {
        std::fprintf(stderr, "usage: %s [REPETITIONS]\n", argv[0]);
        return 1;
    }
    std::printf("%7s  %-20s %9s %12s %9s\n", "aspect", "function", "ns/pair", "pairs/s", "speed-up");
    for (double const aspect : aspects) print_table(aspect, repetitions);
    return 0;
}
