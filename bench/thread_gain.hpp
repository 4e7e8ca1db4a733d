// Measures what a second thread gains, beside what the machine gives two programs. growth.cpp and monte_carlo.cpp use it.
#ifndef PW85_BENCH_THREAD_GAIN_HPP_INCLUDED
#define PW85_BENCH_THREAD_GAIN_HPP_INCLUDED

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#ifdef _OPENMP
#include <omp.h>
#endif

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

/// The least times of one thread, of two threads with a problem each, and of two threads of the library.
struct Times {
    double one = HUGE_VAL, both = HUGE_VAL, two = HUGE_VAL;
};

/// How often something is measured: in samples of at least `sample` seconds, for `total` seconds, `least` to `most` times.
struct Turns {
    double sample, total;
    int least, most;
};

/// Takes turns. Short calls are repeated, so that the start of a thread, which takes some ten microseconds, hardly counts. How often is
/// found from the shorter of two calls, because some work, as new lists of neighbours, is not done in each.
template <class First, class Second> Times measure_threads(Turns const &turns, First const &first, Second const &second)
{
    auto const repeats =
        static_cast<int>(std::ceil(turns.sample / std::max(std::min(seconds(1, first), seconds(1, first)), 1e-9)));
    auto const repeated = [repeats](auto const &problem) {
        for (int k = 0; k < repeats; ++k) problem();
    };
    Times least;
    double spent = 0.0;
    for (int pass = 0; pass < turns.least || (spent < turns.total && pass < turns.most); ++pass) {
        double const one = seconds(1, [&] { repeated(first); }),
                     both = seconds(1, [&] {
                         std::thread other([&] { seconds(1, [&] { repeated(second); }); });
                         repeated(first);
                         other.join();
                     });
        double const two = seconds(2, [&] { repeated(first); });
        least = {std::min(least.one, one), std::min(least.both, both), std::min(least.two, two)};
        spent += one + both + two;
    }
    return {least.one / repeats, least.both / repeats, least.two / repeats};
}

} // namespace pw85_bench

#endif
