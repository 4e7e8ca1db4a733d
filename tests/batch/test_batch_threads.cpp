// Batches give the same bits with any number of threads, and from several threads at once.
#include <thread>

#include <glib.h>

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

void test_number_of_threads()
{
#ifdef _OPENMP
    Random random(21);
    auto const pairs = mixed_pairs(random, 50000);
    omp_set_num_threads(1);
    BatchResult const expected = run_batch(pairs);
    for (int const threads : {2, 3, 4, 7, 16}) {
        omp_set_num_threads(threads);
        g_assert_true(equal(run_batch(pairs), expected));
    }
#else
    g_test_skip("built without OpenMP");
#endif
}

// Small batches, each on the thread that calls: for ThreadSanitizer, which does not know the barriers of OpenMP.
void test_concurrent_calls()
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

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/batch_threads/concurrent_calls", test_concurrent_calls);
    g_test_add_func("/batch_threads/number_of_threads", test_number_of_threads);
    return g_test_run();
}
