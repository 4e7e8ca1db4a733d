// SPDX-License-Identifier: BSD-3-Clause
// Measures what a second thread gains, beside what the machine gives two programs. growth.cpp and
// monte_carlo.cpp use it.
#ifndef PW85_BENCH_THREAD_GAIN_HPP_INCLUDED
#define PW85_BENCH_THREAD_GAIN_HPP_INCLUDED

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "trial_run.hpp"

namespace pw85_bench {

/// Seconds of some work in which the calls of this thread have a number of threads of the library.
template <class Work> double seconds(int threads, Work const &work)
{
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    static_cast<void>(threads);
#endif
    auto const start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of a call with one thread, and what a second thread gains: one of the library, and one
/// with a problem of its own.
struct Gain {
    double seconds, speed_up, limit;
};

/// How often something is measured: in samples of at least `sample` seconds, for `total` seconds,
/// `least` to `most` times.
struct Turns {
    double sample, total;
    int least, most;
};

inline double median(std::vector<double> x)
{
    auto const middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
    std::nth_element(x.begin(), middle, x.end());
    return *middle;
}

/// Takes turns. Short calls are repeated, so that the start of a thread, which takes some ten
/// microseconds, hardly counts. How often is found from the shorter of two calls, because some
/// work, as new lists of neighbours, is not done in each. The least time counts, but of the gains
/// the median: other programs slow down the three samples of a turn alike, and not those of all
/// turns. In a trial run, each problem runs once.
template <class First, class Second>
Gain measure_threads(Turns turns, First const &first, Second const &second)
{
    if (is_trial_run()) turns = {1e-9, 0.0, 1, 1};
    auto const repeats = static_cast<int>(
        std::ceil(turns.sample / std::max(std::min(seconds(1, first), seconds(1, first)), 1e-9)));
    auto const repeated = [repeats](auto const &problem) {
        for (int k = 0; k < repeats; ++k) problem();
    };
    double least = HUGE_VAL, spent = 0.0;
    std::vector<double> speed_ups, limits;
    for (int turn = 0; turn < turns.least || (spent < turns.total && turn < turns.most); ++turn) {
        double const one = seconds(1, [&] { repeated(first); }),
                     both = seconds(1, [&] {
                         std::thread other([&] { seconds(1, [&] { repeated(second); }); });
                         repeated(first);
                         other.join();
                     });
        double const two = seconds(2, [&] { repeated(first); });
        least = std::min(least, one);
        speed_ups.push_back(one / two);
        limits.push_back(2.0 * one / both);
        spent += one + both + two;
    }
    return {least / repeats, median(speed_ups), median(limits)};
}

} // namespace pw85_bench

#endif
