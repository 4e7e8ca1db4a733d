// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops over many rows and sums over them, as tasks for threads. The lists of this folder and the simulations use them.
#ifndef PW85_NEIGHBORS_PARALLEL_HPP_INCLUDED
#define PW85_NEIGHBORS_PARALLEL_HPP_INCLUDED

#include <algorithm>
#include <cstddef>

#include "../tasks.hpp"

namespace pw85::detail::neighbors {
namespace {

/// The number of rows of each task.
inline constexpr std::size_t rows_per_task = 1024;

/// Calls visit(begin, end) for parts of n rows, in parallel.
template <class Visit> void for_parts(std::size_t n, Visit const &visit) noexcept
{
    std::size_t const count = (n + rows_per_task - 1) / rows_per_task;
    for_tasks(count, count > 1, [&](std::size_t k) { visit(k * rows_per_task, std::min(n, (k + 1) * rows_per_task)); });
}

/// Calls part(begin, end) for parts of n rows, in parallel if these are more than `few`, and returns the sum of the results, by their
/// add(). They are on the stack, so that nothing is allocated.
template <class Sum, class Part> Sum of_all_parts(std::size_t n, Part const &part, std::size_t few = 0) noexcept
{
    constexpr std::size_t most_parts = 64;
    Sum parts[most_parts];
    std::size_t const count = std::min(most_parts, n / rows_per_task + 1);
    for_tasks(count, count > 1 && n > few, [&](std::size_t k) { parts[k] = part(n * k / count, n * (k + 1) / count); });
    for (std::size_t k = 1; k < count; ++k) parts[0].add(parts[k]);
    return parts[0];
}

} // namespace
} // namespace pw85::detail::neighbors

#endif
