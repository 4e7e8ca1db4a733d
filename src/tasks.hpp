// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs tasks in parallel, with dynamic scheduling. The neighbour lists use it.
#ifndef PW85_TASKS_HPP_INCLUDED
#define PW85_TASKS_HPP_INCLUDED

#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "floating_point_environment.hpp"

namespace pw85::detail {
namespace {

/// The largest number of threads that run tasks.
inline std::size_t most_threads() noexcept
{
#ifdef _OPENMP
    return static_cast<std::size_t>(omp_get_max_threads());
#else
    return 1;
#endif
}

/// Calls task(0), task(1), ..., task(count - 1), in parallel if `enough`. A thread that is idle takes the next task.
template <class Task> void for_tasks(std::size_t count, [[maybe_unused]] bool enough, Task const &task) noexcept
{
#pragma omp parallel if (enough)
    {
        DefaultEnvironment const environment; // each thread has its own environment
#pragma omp for schedule(dynamic) nowait
        for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(count); ++k) task(static_cast<std::size_t>(k));
    }
}

} // namespace
} // namespace pw85::detail

#endif
