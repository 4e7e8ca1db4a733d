/// @file
/// Loops over many rows, as tasks for threads. The other files of this folder call for_parts().
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

} // namespace
} // namespace pw85::detail::neighbors

#endif
