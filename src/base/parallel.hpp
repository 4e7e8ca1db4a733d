// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All loops that threads share: tasks of any length, and blocks of many rows with the first bad
/// row of them. Each thread has the default floating-point environment.
#ifndef PW85_BASE_PARALLEL_HPP_INCLUDED
#define PW85_BASE_PARALLEL_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <pw85/algebra/scalar.hpp>

#include "floating_point_environment.hpp"

namespace pw85::detail {
namespace {

/// Returns the largest number of threads that share a loop.
inline std::size_t most_threads() noexcept
{
#ifdef _OPENMP
    return static_cast<std::size_t>(omp_get_max_threads());
#else
    return 1;
#endif
}

/// The number of the calling thread among those that run the work of in_each_thread(), and the
/// number of these threads.
struct ThreadNumber {
    std::size_t thread, threads;
};

inline ThreadNumber this_thread() noexcept
{
#ifdef _OPENMP
    return {static_cast<std::size_t>(omp_get_thread_num()),
            static_cast<std::size_t>(omp_get_num_threads())};
#else
    return {0, 1};
#endif
}

/// Calls work() in each of up to `threads` threads. It is the one place where threads start.
template <class Work>
void in_each_thread([[maybe_unused]] std::size_t threads, Work const &work) noexcept
{
#pragma omp parallel num_threads(static_cast <int>(threads)) if (threads > 1)
    {
        DefaultEnvironment const environment; // each thread has its own environment
        work();
    }
}

/// The number of threads for a loop: one, unless it is long enough for several.
inline std::size_t threads_if(bool enough) noexcept { return enough ? most_threads() : 1; }

/// Calls task(0), task(1), ..., task(count - 1), in parallel if `enough`. A thread that is idle
/// takes the next task.
template <class Task> void for_tasks(std::size_t count, bool enough, Task const &task) noexcept
{
    in_each_thread(threads_if(enough), [&] {
#pragma omp for schedule(dynamic) nowait
        for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(count); ++k)
            task(static_cast<std::size_t>(k));
    });
}

/// The number of rows of each task of for_parts() and of_all_parts().
constexpr std::size_t rows_per_task = 1024;

/// Calls visit(begin, end) for parts of n rows, in parallel.
template <class Visit> void for_parts(std::size_t n, Visit const &visit) noexcept
{
    std::size_t const count = (n + rows_per_task - 1) / rows_per_task;
    for_tasks(count, count > 1, [&](std::size_t k) {
        visit(k * rows_per_task, minimum(n, (k + 1) * rows_per_task));
    });
}

/// Calls part(begin, end) for parts of n rows, in parallel if these are more than `few`, and
/// returns the sum of the results, by their add(). They are on the stack; nothing is allocated.
template <class Sum, class Part>
Sum of_all_parts(std::size_t n, Part const &part, std::size_t few = 0) noexcept
{
    constexpr std::size_t most_parts = 64;
    Sum parts[most_parts];
    std::size_t const count = minimum(most_parts, n / rows_per_task + 1);
    for_tasks(count, count > 1 && n > few,
              [&](std::size_t k) { parts[k] = part(n * k / count, n * (k + 1) / count); });
    for (std::size_t k = 1; k < count; ++k) parts[0].add(parts[k]);
    return parts[0];
}

/// The rows begin, begin + 1, ... end - 1.
struct Range {
    std::size_t begin, end;
};

/// The first bad row of a range; `status` is 0 if there is none.
struct Failure {
    std::size_t index;
    int status;

    /// Keeps the earlier of two failures.
    void update(Failure const &other) noexcept
    {
        if (other.status != 0 && (status == 0 || other.index < index)) *this = other;
    }
};

/// The largest number of rows for which an array of up to 6 doubles per row can exist.
constexpr std::size_t max_rows = PTRDIFF_MAX / (6 * sizeof(double));

/// The largest number of rows per block of a thread: some tens of microseconds of work. A call with
/// no more rows than this opens no parallel region, which costs some hundred nanoseconds even with
/// one thread.
constexpr std::size_t block = 4096;

/// Returns the number of rows of each block of n rows, so that all threads have nearly equally
/// many: at most `rows`, and not less than an eighth of them. A multiple of their 64th part, since
/// lanes take some rows at once.
inline std::size_t rows_of_blocks(std::size_t n, std::size_t rows) noexcept
{
    std::size_t const threads = most_threads(), unit = maximum<std::size_t>(1, rows / 64);
    std::size_t const blocks = (n + rows * threads - 1) / (rows * threads) * threads;
    return maximum(rows / 8, (n + blocks * unit - 1) / (blocks * unit) * unit);
}

/// Calls kernel(range) for blocks of n rows in parallel, and returns the earliest failure. Each
/// thread takes neighbouring blocks.
template <class Kernel> [[gnu::noinline]] Failure
for_many_blocks(std::size_t n, Kernel const &kernel, std::size_t most_rows) noexcept
{
    Failure first{0, 0};
    std::size_t const rows = rows_of_blocks(n, most_rows);
    auto const blocks = static_cast<std::ptrdiff_t>((n + rows - 1) / rows);
    in_each_thread(most_threads(), [&] {
        Failure own{0, 0};
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t b = 0; b < blocks; ++b) {
            std::size_t const begin = static_cast<std::size_t>(b) * rows;
            own.update(kernel(Range{begin, minimum(n, begin + rows)}));
        }
#pragma omp critical(pw85_batch)
        first.update(own);
    });
    return first;
}

/// Divides n rows into blocks of at most `rows`, calls kernel(range) for each, in parallel if there
/// are several, and returns the earliest failure.
template <class Kernel>
Failure for_blocks(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    if (n > rows) return for_many_blocks(n, kernel, rows);
    return in_default_environment([&] { return kernel(Range{0, n}); });
}

/// Calls the kernel for all blocks, for callers that need only the status.
template <class Kernel>
int for_all(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    return for_blocks(n, kernel, rows).status;
}

} // namespace
} // namespace pw85::detail

#endif
