// Chooses the instruction set at run time. The functions of the C API call chosen(). The tables of functions are in one_pair.cpp
// and lanes.cpp.
#include "kernels.hpp"

#include <cstdlib>
#include <cstring>

#include "instruction_sets.h"
#include "vector_length.hpp"

namespace pw85::detail::kernels {

// one_pair.cpp and lanes.cpp define these.
#define PW85_DECLARE(target, one_pair, available)                                                                      \
    extern OnePairKernels const one_pair_##one_pair;                                                                   \
    extern LaneKernels const lanes_##target;
PW85_INSTRUCTION_SETS(PW85_DECLARE)
PW85_DECLARE(baseline, baseline, true)
#undef PW85_DECLARE

namespace {

/// All targets, from the newest to the oldest.
#define PW85_TARGET(target, one_pair, available) {#target, &one_pair_##one_pair, &lanes_##target},
constexpr Kernels targets[] = {PW85_INSTRUCTION_SETS(PW85_TARGET) PW85_TARGET(baseline, baseline, true)};
#undef PW85_TARGET

/// The newest available target that is not newer than the one that PW85_TARGET names. The function is not inlined and returns a
/// reference. Otherwise each call for one pair would save registers and check a stack frame that only this function needs.
[[gnu::noinline]] Kernels const &choose() noexcept
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

} // namespace

Kernels const &chosen() noexcept
{
    static Kernels const &chosen = choose();
    return chosen;
}

} // namespace pw85::detail::kernels
