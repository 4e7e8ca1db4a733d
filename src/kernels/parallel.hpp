/// @file
/// The distribution of rows to threads.
#ifndef PW85_KERNELS_PARALLEL_HPP_INCLUDED
#define PW85_KERNELS_PARALLEL_HPP_INCLUDED

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../floating_point_environment.hpp"

namespace pw85::detail::kernels {
namespace {

/// Rows begin, begin + 1, ... end - 1.
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

/// The largest number of rows that an array of up to 6 doubles per row can have.
constexpr std::size_t max_rows = PTRDIFF_MAX / (6 * sizeof(double));

/// Rows that a thread takes at a time: some tens of microseconds of work. No more rows than this are not worth a parallel region,
/// which costs some hundred nanoseconds even where it has one thread.
constexpr std::size_t block = 4096;

/// Calls kernel(range) for blocks, of `rows` each, of n rows, in parallel, and returns the earliest failure.
template <class Kernel>
[[gnu::noinline]] Failure for_blocks(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    Failure first{0, 0};
    auto const blocks = static_cast<std::ptrdiff_t>((n + rows - 1) / rows);
#pragma omp parallel
    {
        DefaultEnvironment const environment; // threads have their own
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

/// Calls kernel(range) for parts of n rows and returns the status of the first bad one.
template <class Kernel> int for_all(std::size_t n, Kernel const &kernel, std::size_t rows = block) noexcept
{
    if (n > rows) return for_blocks(n, kernel, rows).status;
    return in_default_environment([&] { return kernel(Range{0, n}).status; });
}

} // namespace
} // namespace pw85::detail::kernels

#endif
