// The choice of the instruction set.
#include "kernels.hpp"

#include <cstdlib>
#include <cstring>

namespace pw85::kernels {

extern ScalarKernels const scalar_baseline;
extern LaneKernels const lanes_baseline;
#ifdef PW85_HAVE_X86_TARGETS
extern ScalarKernels const scalar_avx2, scalar_avx512;
extern LaneKernels const lanes_avx2, lanes_avx512;
#endif

namespace {

struct Target {
    Kernels kernels;
    bool available;
};

/// The best of the available targets, no newer than the one that is asked for.
Kernels choose() noexcept
{
    // From the newest to the oldest.
    Target const targets[] = {
#ifdef PW85_HAVE_X86_TARGETS
        {{"avx512", &scalar_avx512, &lanes_avx512},
         __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")},
        {{"avx2", &scalar_avx2, &lanes_avx2}, __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")},
#endif
        {{"baseline", &scalar_baseline, &lanes_baseline}, true},
    };
    char const *const wanted = std::getenv("PW85_TARGET");
    bool allowed = true;
    if (wanted != nullptr)
        for (Target const &target : targets) allowed = allowed && std::strcmp(wanted, target.kernels.name) != 0;
    for (Target const &target : targets) {
        allowed = allowed || std::strcmp(wanted, target.kernels.name) == 0;
        if (allowed && target.available) return target.kernels;
    }
    return {"baseline", &scalar_baseline, &lanes_baseline};
}

} // namespace

Kernels const &chosen() noexcept
{
    static Kernels const chosen = choose();
    return chosen;
}

} // namespace pw85::kernels
