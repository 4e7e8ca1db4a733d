// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of a block of calls on a machine that also runs other programs. peers.cpp and
// side_by_side.cpp use it.
#ifndef PW85_BENCH_LEAST_TIME_HPP_INCLUDED
#define PW85_BENCH_LEAST_TIME_HPP_INCLUDED

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "trial_run.hpp"

namespace pw85_bench {

/// Nanoseconds per item. Each pass goes over all items, so that the processor cannot learn the
/// branches of a few. The items are divided into short pieces, and the least time of each piece
/// counts: other programs can only add to a time, and rarely disturb a short piece.
template <class Work> double least_time(std::size_t items, Work work)
{
    constexpr std::size_t piece = 128;
    int const passes = is_trial_run() ? 1 : 31;
    std::vector<double> least((items + piece - 1) / piece, std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t k = 0; k < least.size(); ++k) {
            auto const start = std::chrono::steady_clock::now();
            work(k * piece, std::min(items, (k + 1) * piece));
            std::chrono::duration<double, std::nano> const taken =
                std::chrono::steady_clock::now() - start;
            least[k] = std::min(least[k], taken.count());
        }
    return std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(items);
}

} // namespace pw85_bench

#endif
