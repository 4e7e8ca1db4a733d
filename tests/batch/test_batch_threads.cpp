// SPDX-License-Identifier: BSD-3-Clause
// Batches give the same bits with any number of threads, and from several threads at once. Small
// work starts no threads, and threads share rows evenly.
#include <filesystem>
#include <numeric>
#include <thread>

#include <glib.h>

#include <pw85/simulation.hpp>

#include "../../src/base/parallel.hpp"
#include "../cases.hpp"
#include "batch_data.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pw85_tests;

namespace {

bool equal(BatchResult const &x, BatchResult const &y)
{
    bool same = x.contact_status == y.contact_status && x.overlap_status == y.overlap_status;
    for (std::size_t i = 0; i < x.mu2.size(); ++i) same = same && x.same_row(i, y, i);
    return same;
}

#ifdef _OPENMP
/// The number of threads of this program. OpenMP keeps those that it has started.
std::ptrdiff_t count_threads()
{
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

/// Makes 64 spheres on a lattice, moves them, and searches them for pairs.
void simulate_few()
{
    std::vector<pw85::Vector<double, 3>> centers;
    for (int k = 0; k < 64; ++k)
        centers.push_back({1.5 * (k % 4), 1.5 * (k / 4 % 4), 1.5 * (k / 16)});
    pw85::Cell const cell{{{6.0, 0.0, 0.0}, {0.0, 6.0, 0.0}, {0.0, 0.0, 6.0}}};
    std::vector<pw85::Vector<double, 3>> const semi_axes(64, {0.5, 0.5, 0.5});
    std::vector<pw85::Vector<double, 4>> const upright(64, {1.0, 0.0, 0.0, 0.0});
    pw85::HardEllipsoids simulation;
    pw85::IndexPair pair;
    double factor, z;
    g_assert_true(hard_ellipsoids_create({centers, {}, &cell}, semi_axes, upright, 1, simulation,
                                         pair) == pw85::Status::success);
    g_assert_true(simulation.sweep(2) == pw85::Status::success);
    g_assert_true(simulation.volume_moves(2, 1.0) == pw85::Status::success);
    g_assert_true(simulation.chain(2, 1.0, z) == pw85::Status::success);
    g_assert_true(simulation.compress(false, factor) == pw85::Status::success);
    g_assert_true(simulation.check(pair) == pw85::Status::success);
}
#endif

// A parallel region costs a microsecond, or a time slice of the system if the other threads have to
// wait for a processor. To be called before any other test has started the threads of OpenMP.
PW85_TEST("/batch_threads/small_work")
{
#ifdef _OPENMP
    if (!std::filesystem::exists("/proc/self/task")) return g_test_skip("no list of threads");
    omp_set_num_threads(4);
    Random random(23);
    auto const before = count_threads();
    run_batch(mixed_pairs(random, 4096));
    simulate_few();
    g_assert_cmpint(count_threads(), ==, before);
    run_batch(mixed_pairs(random, 50000));
    g_assert_cmpint(count_threads(), >, before);
#else
    g_test_skip("built without OpenMP");
#endif
}

PW85_TEST("/batch_threads/number_of_threads")
{
#ifdef _OPENMP
    Random random(21);
    for (std::size_t const n : {4097u, 10007u, 50000u}) {
        auto const pairs = mixed_pairs(random, n);
        omp_set_num_threads(1);
        BatchResult const expected = run_batch(pairs);
        for (int const threads : {2, 3, 4, 7, 16}) {
            omp_set_num_threads(threads);
            g_assert_true(equal(run_batch(pairs), expected));
        }
    }
#else
    g_test_skip("built without OpenMP");
#endif
}

// Each block may have a 64th part of the largest block too many, since its rows are rounded up.
// Blocks are not shorter than an eighth of the largest.
PW85_TEST("/batch_threads/even_shares")
{
#ifdef _OPENMP
    using namespace pw85::detail;
    for (std::size_t const threads : {1u, 2u, 3u, 8u, 16u})
        for (std::size_t const n : {4097u, 5000u, 10000u, 12289u, 33333u, 1000000u}) {
            omp_set_num_threads(static_cast<int>(threads));
            std::vector<std::size_t> shares(threads, 0);
            for_blocks(n, [&](Range range) {
                shares[static_cast<std::size_t>(omp_get_thread_num())] += range.end - range.begin;
                return Failure{0, 0};
            });
            g_assert_cmpuint(std::accumulate(shares.begin(), shares.end(), std::size_t{0}), ==, n);
            std::size_t const blocks = n / (block * threads) + 1;
            std::size_t const most = std::max(block / 8, n / threads + 1 + blocks * block / 64);
            g_assert_cmpuint(*std::max_element(shares.begin(), shares.end()), <=, most);
        }
#else
    g_test_skip("built without OpenMP");
#endif
}

// Small batches, each on the thread that calls: for ThreadSanitizer, which does not know the
// barriers of OpenMP.
PW85_TEST("/batch_threads/concurrent_calls")
{
    Random random(22);
    auto const pairs = mixed_pairs(random, 1000);
    BatchResult const expected = run_batch(pairs);
    std::vector<std::thread> threads;
    std::vector<int> same(16, 0);
    for (int &ok : same)
        threads.emplace_back([&] {
            for (int n = 0; n < 3; ++n) ok += equal(run_batch(pairs), expected);
        });
    for (auto &thread : threads) thread.join();
    for (int const ok : same) g_assert_cmpint(ok, ==, 3);
}

} // namespace
