// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pages of 2 MiB for large arrays that stay. Simulations ask for them, because each trial reads
/// about ten arrays, and the address translations of pages of 4 KiB do not stay in the cache.
#ifndef PW85_BASE_HUGE_PAGES_HPP_INCLUDED
#define PW85_BASE_HUGE_PAGES_HPP_INCLUDED

#ifdef __linux__
#include <cerrno>
#include <sys/mman.h>
#endif

#include "array.hpp"

namespace pw85::detail {

/// Arrays with fewer bytes have no huge pages. An array need not begin at a border of such pages,
/// so that of a smaller one would have only few of them.
inline constexpr std::size_t least_huge_size = std::size_t{4} << 20;

/// Asks the system to put an array on huge pages, if it is large. Call this after the array is
/// resized, before it is written. The system may refuse, which changes nothing.
template <class T>
[[gnu::always_inline]] inline void prefer_huge_pages([[maybe_unused]] Array<T> &array) noexcept
{
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = 65536; // a multiple of the page sizes of usual systems
    std::size_t const size = array.size() * sizeof(T);
    if (size < least_huge_size) return;
    auto const begin = reinterpret_cast<std::uintptr_t>(array.data()),
               first = (begin + page - 1) / page * page, last = (begin + size) / page * page;
    int const before = errno; // that of the caller, also where the system refuses
    if (madvise(reinterpret_cast<void *>(first), last - first, MADV_HUGEPAGE) != 0) errno = before;
#endif
}

} // namespace pw85::detail

#endif
