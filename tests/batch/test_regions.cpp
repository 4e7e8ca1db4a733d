// SPDX-License-Identifier: BSD-3-Clause
// Small batches open no parallel region, which costs some hundred nanoseconds even with one thread.
// The regions are counted by a function with the name of the function of libgomp by which GCC opens
// them; the linker prefers it.
#include <dlfcn.h>

#include <glib.h>

#include "../cases.hpp"
#include "../systems.hpp"
#include "batch_data.hpp"

namespace {
int num_regions = 0;
}

extern "C" __attribute__((visibility("default"))) void
GOMP_parallel(void (*body)(void *), void *data, unsigned threads, unsigned flags)
{
    static auto *const next =
        reinterpret_cast<decltype(&GOMP_parallel)>(dlsym(RTLD_NEXT, "GOMP_parallel"));
    ++num_regions;
    next(body, data, threads, flags);
}

using namespace pw85_tests;

namespace {

PW85_TEST("/regions/regions")
{
    if (dlsym(RTLD_NEXT, "GOMP_parallel") == nullptr) {
        g_test_skip("no OpenMP by GCC");
        return;
    }
    Random random(41);
    auto const pairs = mixed_pairs(random, 10000);
    std::vector<std::int32_t> indices(2 * 4096, 0);
    std::vector<double> mu2(4096);
    double const x[6] = {1, 0, 0, 1, 0, 1}, cell[9] = {4, 0, 0, 1, 5, 0, 1, 2, 6};
    num_regions = 0;
    for (std::size_t const n : {std::size_t{1}, std::size_t{100}, std::size_t{4096}})
        run_batch(pairs, 0, n);
    for (std::size_t const n : {std::size_t{1}, std::size_t{4096}})
        g_assert_cmpint(pw85_contact_pairs(list_of(n, indices.data()), system_of(1, x, x, cell),
                                           mu2.data(), nullptr),
                        ==, PW85_SUCCESS);
    g_assert_cmpint(num_regions, ==, 0);
    run_batch(pairs);
    g_assert_cmpint(num_regions, ==, 2);
}

} // namespace
