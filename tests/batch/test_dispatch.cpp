// The choice of the instruction set: the environment forces an older one, and never one that is not there.
#include <cstdlib>
#include <cstring>

#include <glib.h>

#include "../../src/kernels/kernels.hpp"

namespace {

void test_choice()
{
    char const *const wanted = std::getenv("PW85_TARGET"), *const chosen = pw85::kernels::chosen().name;
    g_test_message("wanted %s, chosen %s", wanted == nullptr ? "the best" : wanted, chosen);
    g_assert_true(&pw85::kernels::chosen() == &pw85::kernels::chosen());
    bool has_avx2 = false, has_avx512 = false;
#if defined(__x86_64__) && defined(PW85_HAVE_X86_TARGETS)
    has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                 __builtin_cpu_supports("avx512vl");
#endif
    char const *const best = has_avx512 ? "avx512" : has_avx2 ? "avx2" : "baseline";
    if (wanted == nullptr || std::strcmp(wanted, "unknown") == 0 || std::strcmp(wanted, "avx512") == 0)
        g_assert_cmpstr(chosen, ==, best);
    else if (std::strcmp(wanted, "avx2") == 0)
        g_assert_cmpstr(chosen, ==, has_avx2 ? "avx2" : "baseline");
    else
        g_assert_cmpstr(chosen, ==, "baseline");
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/dispatch/choice", test_choice);
    return g_test_run();
}
