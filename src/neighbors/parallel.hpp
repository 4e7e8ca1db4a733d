/// @file
/// Tasks for threads.
#ifndef PW85_NEIGHBORS_PARALLEL_HPP_INCLUDED
#define PW85_NEIGHBORS_PARALLEL_HPP_INCLUDED

#include <algorithm>
#include <cstddef>

#include "../floating_point_environment.hpp"

namespace pw85::neighbors {
namespace {

/// Calls task(0), task(1), ..., task(count - 1); idle threads take the next.
template <class Task> void for_tasks(std::size_t count, Task const &task) noexcept
{
#pragma omp parallel if (count > 1)
    {
        DefaultEnvironment const environment; // threads have their own
#pragma omp for schedule(dynamic) nowait
        for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(count); ++k) task(static_cast<std::size_t>(k));
    }
}

/// Rows of a task.
inline constexpr std::size_t rows_per_task = 4096;

/// Calls visit(begin, end) for parts of n rows.
template <class Visit> void for_parts(std::size_t n, Visit const &visit) noexcept
{
    for_tasks((n + rows_per_task - 1) / rows_per_task,
              [&](std::size_t k) { visit(k * rows_per_task, std::min(n, (k + 1) * rows_per_task)); });
}

} // namespace
} // namespace pw85::neighbors

#endif
