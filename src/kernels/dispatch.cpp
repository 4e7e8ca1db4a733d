// Chooses the instruction set at run time. The functions of the C API call chosen().
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

struct Target {
    Kernels kernels;
    bool available;
};

/// The newest available target that is not newer than the one that PW85_TARGET names. It is not inlined: otherwise each call for
/// one pair would save registers and check a stack frame that only this function needs.
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
