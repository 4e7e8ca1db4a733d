// The choice of the instruction set.
#include "kernels.hpp"

#include <cstdlib>
#include <cstring>

#include "instruction_sets.h"
#include "vector_length.hpp"

namespace pw85::detail::kernels {

// Defined where they are compiled.
#define PW85_DECLARE(target, one_pair, available)                                                                      \
    extern OnePairKernels const one_pair_##one_pair;                                                                   \
    extern LaneKernels const lanes_##target;
PW85_INSTRUCTION_SETS(PW85_DECLARE)
PW85_DECLARE(baseline, baseline, true)
#undef PW85_DECLARE

namespace {

struct Target {
    Kernels kernels;
    bool available;
};

/// The best of the available targets, no newer than the one that is asked for. Not inlined, so that calls for one pair, which ask what
/// was chosen, do not save registers and check a stack that only the choice needs.
[[gnu::noinline]] Kernels choose() noexcept
{
#define PW85_TARGET(target, one_pair, available) {{#target, &one_pair_##one_pair, &lanes_##target}, available},
    Target const targets[] = {PW85_INSTRUCTION_SETS(PW85_TARGET) PW85_TARGET(baseline, baseline, true)};
#undef PW85_TARGET
    char const *const wanted = std::getenv("PW85_TARGET");
    bool allowed = true;
    if (wanted != nullptr)
        for (Target const &target : targets) allowed = allowed && std::strcmp(wanted, target.kernels.name) != 0;
    for (Target const &target : targets) {
        allowed = allowed || std::strcmp(wanted, target.kernels.name) == 0;
        if (allowed && target.available) return target.kernels;
    }
    return {"baseline", &one_pair_baseline, &lanes_baseline};
}

} // namespace

Kernels const &chosen() noexcept
{
    static Kernels const chosen = choose();
    return chosen;
}

} // namespace pw85::detail::kernels
