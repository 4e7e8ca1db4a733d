// SPDX-License-Identifier: BSD-3-Clause
#ifndef PW85_TESTS_THREADS_HPP_INCLUDED
#define PW85_TESTS_THREADS_HPP_INCLUDED

#ifdef _OPENMP
#include <omp.h>
#endif

namespace pw85_tests {

/// While it lives, calls of this thread have this many threads. Without OpenMP they have one.
class Threads {
  public:
#ifdef _OPENMP
    explicit Threads(int count) noexcept : usual_(omp_get_max_threads())
    {
        omp_set_num_threads(count);
    }
    ~Threads() { omp_set_num_threads(usual_); }
#else
    explicit Threads(int) noexcept {}
    ~Threads() {}
#endif
    Threads(Threads const &) = delete;
    Threads &operator=(Threads const &) = delete;

#ifdef _OPENMP
  private:
    int usual_;
#endif
};

} // namespace pw85_tests

#endif
