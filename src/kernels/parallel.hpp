// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Divides rows among threads, and finds the first bad row. All functions of many rows use it.
#ifndef PW85_KERNELS_PARALLEL_HPP_INCLUDED
#define PW85_KERNELS_PARALLEL_HPP_INCLUDED

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../floating_point_environment.hpp"
#include "../tasks.hpp"

namespace pw85::detail::kernels {
namespace {

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

/// The largest number of rows per block of a thread: some tens of microseconds of work. A call with no more rows than this opens no
/// parallel region, which costs some hundred nanoseconds even with one thread.
constexpr std::size_t block = 4096;

/// How many rows of n each block has, so that all threads have nearly the same number: at most `rows`, and not less than an eighth of
/// them. A multiple of their 64th part, since lanes take some rows at once.
inline std::size_t rows_of_blocks(std::size_t n, std::size_t rows) noexcept
{
    std::size_t const threads = most_threads(), unit = std::max<std::size_t>(1, rows / 64);
    std::size_t const blocks = (n + rows * threads - 1) / (rows * threads) * threads;
    return std::max(rows / 8, (n + blocks * unit - 1) / (blocks * unit) * unit);
}

/// Calls kernel(range) for blocks of n rows in parallel, and returns the earliest failure.
template <class Kernel>
[[gnu::noinline]] Failure for_many_blocks(std::size_t n, Kernel const &kernel, std::size_t most_rows) noexcept
{
    Failure first{0, 0};
    std::size_t const rows = rows_of_blocks(n, most_rows);
    auto const blocks = static_cast<std::ptrdiff_t>((n + rows - 1) / rows);
#pragma omp parallel
    {
        DefaultEnvironment const environment; // each thread has its own environment
        Failure own{0, 0};
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t b = 0; b < blocks; ++b) {
            std::size_t const begin = static_cast<std::size_t>(b) * rows;
            own.update(kernel(Range{begin, std::min(n, begin + rows)}));
        }
#pragma omp critical(pw85_batch)
        first.update(own);
    }
    return first;
}

/// Divides n rows into blocks of at most `rows`, calls kernel(range) for each, in parallel if there are several, and returns the earliest
/// failure.
template <class Kernel> Failure for_blocks(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    if (n > rows) return for_many_blocks(n, kernel, rows);
    return in_default_environment([&] { return kernel(Range{0, n}); });
}

/// The same for callers that need only the status.
template <class Kernel> int for_all(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    return for_blocks(n, kernel, rows).status;
}

} // namespace
} // namespace pw85::detail::kernels

#endif
