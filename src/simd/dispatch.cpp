// SPDX-License-Identifier: BSD-3-Clause
// Chooses the instruction set at run time (targets.hpp).
#include "targets.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "vector_length.hpp"

namespace pw85::detail::kernels {

namespace {

#define PW85_ONE(target, one_pair, lanes256, available) +1
constexpr int num_targets = PW85_EACH_TARGET(PW85_ONE);
#undef PW85_ONE

/// All targets, from the newest to the oldest. Their numbers begin with the baseline, in the order
/// of one_of().
struct Targets {
    Target of[std::size_t(num_targets)];
};

constexpr Targets numbered() noexcept
{
#define PW85_NAME(target, one_pair, lanes256, available) #target,
    char const *const names[] = {PW85_EACH_TARGET(PW85_NAME)};
#undef PW85_NAME
    Targets made{};
    for (int i = 0; i < num_targets; ++i) made.of[i] = {names[i], (i + 1) % num_targets};
    return made;
}

constexpr Targets targets = numbered();

/// The target of the reproducible mode: the functions of the baseline, whose arithmetic is the same
/// on every processor.
constexpr Target reproducible = {"reproducible", 0};

/// Returns the newest available target that is not newer than the one that PW85_TARGET names.
Target const &newest() noexcept
{
#define PW85_AVAILABLE(target, one_pair, lanes256, available) available,
    bool const available[] = {PW85_EACH_TARGET(PW85_AVAILABLE)};
#undef PW85_AVAILABLE
    char const *const wanted = std::getenv("PW85_TARGET");
    bool allowed = true;
    if (wanted != nullptr)
        for (Target const &target : targets.of)
            allowed = allowed && std::strcmp(wanted, target.name) != 0;
    int i = 0;
    for (; i + 1 < num_targets; ++i) {
        allowed = allowed || std::strcmp(wanted, targets.of[i].name) == 0;
        if (allowed && available[i]) break;
    }
    return targets.of[i];
}

bool is_set(char const *name) noexcept
{
    char const *const value = std::getenv(name);
    return value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0;
}

/// The target that calls use; null before the first call. Targets are constant, so any order of
/// loads and stores will do.
std::atomic<Target const *> current{nullptr};

/// Chooses at the first call. A choice that another thread makes meanwhile by set_reproducible()
/// has priority. The function is not inlined. Otherwise each call for one pair would save registers
/// that only this function needs.
[[gnu::noinline, gnu::cold]] Target const &choose() noexcept
{
    Target const *made = nullptr;
    Target const &first = is_set("PW85_REPRODUCIBLE") ? reproducible : newest();
    return current.compare_exchange_strong(made, &first, std::memory_order_relaxed) ? first : *made;
}

} // namespace

Target const &chosen() noexcept
{
    Target const *const target = current.load(std::memory_order_relaxed);
    return target != nullptr ? *target : choose();
}

void set_reproducible(bool on) noexcept
{
    current.store(on ? &reproducible : &newest(), std::memory_order_relaxed);
}

bool is_reproducible() noexcept { return &chosen() == &reproducible; }

} // namespace pw85::detail::kernels
