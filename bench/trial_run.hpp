// SPDX-License-Identifier: BSD-3-Clause
#ifndef PW85_BENCH_TRIAL_RUN_HPP_INCLUDED
#define PW85_BENCH_TRIAL_RUN_HPP_INCLUDED

#include <cstdlib>

namespace pw85_bench {

/// Whether the program only has to show that it works, as in the trial run of measure.py: then it
/// measures everything once.
inline bool is_trial_run() { return std::getenv("PW85_MEASURE_ONCE") != nullptr; }

} // namespace pw85_bench

#endif
