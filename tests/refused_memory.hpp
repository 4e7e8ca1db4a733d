// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Refuses one request for memory. A program that includes this is linked with -Wl,--wrap=realloc,
/// and has the library in itself.
#ifndef PW85_TESTS_REFUSED_MEMORY_HPP_INCLUDED
#define PW85_TESTS_REFUSED_MEMORY_HPP_INCLUDED

#include <atomic>
#include <cstddef>

namespace pw85_tests {

/// How many requests are granted before one is refused. Negative: the one has been refused, and all
/// others are granted.
static std::atomic<long> granted{-1};

} // namespace pw85_tests

extern "C" {

void *__real_realloc(void *memory, std::size_t size);

void *__wrap_realloc(void *memory, std::size_t size)
{
    return pw85_tests::granted.fetch_sub(1) == 0 ? nullptr : __real_realloc(memory, size);
}
}

#endif
