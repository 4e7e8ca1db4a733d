// SPDX-License-Identifier: BSD-3-Clause
// Calls functions of libraries that may end the process, for example by an assertion.
#ifndef PW85_BENCH_CHILD_PROCESSES_HPP_INCLUDED
#define PW85_BENCH_CHILD_PROCESSES_HPP_INCLUDED

#include <cstdio>
#include <vector>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pw85_bench {

/// call(i) for i = 0, ..., n - 1, and `otherwise` where the call ends the process. A child writes
/// its results to shared memory; the next child continues after the call at which one ended.
template <class Result, class Call>
std::vector<Result> call_in_children(std::size_t n, Result otherwise, Call call)
{
    struct Row {
        std::size_t next;
        Result result;
    };
    std::size_t const bytes = (n + 1) * sizeof(Row);
    auto *const shared = static_cast<Row *>(
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    for (std::size_t i = 0; i < n; ++i) shared[i].result = otherwise;
    std::size_t volatile &next = shared[n].next;
    while (next < n) {
        if (fork() == 0) {
            // no text of the assertion
            if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
            while (next < n) {
                std::size_t const i = next;
                next = i + 1;
                shared[i].result = call(i);
            }
            _exit(0);
        }
        wait(nullptr);
    }
    std::vector<Result> results;
    for (std::size_t i = 0; i < n; ++i) results.push_back(shared[i].result);
    munmap(shared, bytes);
    return results;
}

} // namespace pw85_bench

#endif
