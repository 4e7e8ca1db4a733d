// SPDX-License-Identifier: BSD-3-Clause
// Chooses the instruction set at run time. The functions of the C API call chosen(). The tables of functions are in one_pair.cpp,
// one_set.cpp and lanes.cpp.
#include "kernels.hpp"

#include <atomic>
#include <cstdlib>
#include <cstring>

#include "instruction_sets.h"
#include "vector_length.hpp"

namespace pw85::detail::kernels {

// one_pair.cpp, one_set.cpp and lanes.cpp define these. one_set.cpp is compiled for the targets of one_pair.cpp.
#define PW85_DECLARE(target, one_pair, available)                                                                      \
    extern OnePairKernels const one_pair_##one_pair;                                                                   \
    extern OneSetKernels const one_set_##one_pair;                                                                     \
    extern LaneKernels const lanes_##target;
PW85_INSTRUCTION_SETS(PW85_DECLARE)
PW85_DECLARE(baseline, baseline, true)
#undef PW85_DECLARE

namespace {

/// All targets, from the newest to the oldest.
#define PW85_TARGET(target, one_pair, available) {#target, &one_pair_##one_pair, &one_set_##one_pair, &lanes_##target},
constexpr Kernels targets[] = {PW85_INSTRUCTION_SETS(PW85_TARGET) PW85_TARGET(baseline, baseline, true)};
#undef PW85_TARGET

/// The target of the reproducible mode: the functions of the baseline, whose arithmetic is the same on every processor.
constexpr Kernels reproducible = {"reproducible", &one_pair_baseline, &one_set_baseline, &lanes_baseline};

/// The newest available target that is not newer than the one that PW85_TARGET names.
Kernels const &newest() noexcept
{
#define PW85_AVAILABLE(target, one_pair, available) available,
    bool const available[] = {PW85_INSTRUCTION_SETS(PW85_AVAILABLE) PW85_AVAILABLE(baseline, baseline, true)};
#undef PW85_AVAILABLE
    char const *const wanted = std::getenv("PW85_TARGET");
    bool allowed = true;
    if (wanted != nullptr)
        for (Kernels const &target : targets) allowed = allowed && std::strcmp(wanted, target.name) != 0;
    std::size_t i = 0;
    for (; i + 1 < sizeof targets / sizeof *targets; ++i) {
        allowed = allowed || std::strcmp(wanted, targets[i].name) == 0;
        if (allowed && available[i]) break;
    }
    return targets[i];
}

bool is_set(char const *name) noexcept
{
    char const *const value = std::getenv(name);
    return value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0;
}

/// The target that calls use; null before the first call. The tables are constant, so that any order of loads and stores will do.
std::atomic<Kernels const *> current{nullptr};

/// Chooses at the first call. A choice that another thread makes meanwhile by set_reproducible() has priority. The function is
/// not inlined. Otherwise each call for one pair would save registers that only this function needs.
[[gnu::noinline, gnu::cold]] Kernels const &choose() noexcept
{
    Kernels const *made = nullptr;
    Kernels const &first = is_set("PW85_REPRODUCIBLE") ? reproducible : newest();
    return current.compare_exchange_strong(made, &first, std::memory_order_relaxed) ? first : *made;
}

} // namespace

Kernels const &chosen() noexcept
{
    Kernels const *const target = current.load(std::memory_order_relaxed);
    return target != nullptr ? *target : choose();
}

void set_reproducible(bool on) noexcept { current.store(on ? &reproducible : &newest(), std::memory_order_relaxed); }

bool is_reproducible() noexcept { return &chosen() == &reproducible; }

} // namespace pw85::detail::kernels
