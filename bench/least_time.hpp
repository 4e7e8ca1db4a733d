// The time of a block, on a machine that does other things too.
#ifndef PW85_BENCH_LEAST_TIME_HPP_INCLUDED
#define PW85_BENCH_LEAST_TIME_HPP_INCLUDED

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace pw85_bench {

/// Nanoseconds per item. Some passes are made over all items, so that no branch is known by heart; of each piece, from an item up to
/// another, the least time counts, since what else the machine does can only add, and leaves most short pieces alone.
template <class Work> double least_time(std::size_t items, Work work)
{
    constexpr std::size_t piece = 128;
    constexpr int passes = 31;
    std::vector<double> least((items + piece - 1) / piece, std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t k = 0; k < least.size(); ++k) {
            auto const start = std::chrono::steady_clock::now();
            work(k * piece, std::min(items, (k + 1) * piece));
            std::chrono::duration<double, std::nano> const taken = std::chrono::steady_clock::now() - start;
            least[k] = std::min(least[k], taken.count());
        }
    return std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(items);
}

} // namespace pw85_bench

#endif
