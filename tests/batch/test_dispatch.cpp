// SPDX-License-Identifier: BSD-3-Clause
// The choice of the instruction set: PW85_TARGET can select an older one, but never one that the
// processor lacks. The reproducible mode goes before it.
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include <glib.h>

#include "../../src/simd/lanes.hpp"
#include "../../src/simd/lanes/overlap.hpp"
#include "../../src/simd/vector_length.hpp"
#include "../cases.hpp"

namespace {

struct Target {
    char const *name;
    bool available;
};

/// From the newest to the oldest.
#define PW85_TARGET(name, one_pair, lanes256, available) {#name, available},
Target const targets[] = {PW85_EACH_TARGET(PW85_TARGET)};
#undef PW85_TARGET

bool is_known(char const *name)
{
    for (Target const &target : targets)
        if (std::strcmp(name, target.name) == 0) return true;
    return false;
}

/// Whether calls get the function of the baseline for lanes.
bool has_lanes_of_baseline()
{
    using namespace pw85::detail::kernels;
    return compute_of<PairArrays<3>, OverlapArray>(chosen()) ==
           &baseline::compute<PairArrays<3>, OverlapArray>;
}

PW85_TEST("/dispatch/choice")
{
    char const *const wanted = std::getenv("PW85_TARGET"), *const chosen =
                                                               pw85::detail::kernels::chosen().name;
    g_test_message("wanted %s, chosen %s", wanted == nullptr ? "the best" : wanted, chosen);
    g_assert_true(&pw85::detail::kernels::chosen() == &pw85::detail::kernels::chosen());
    bool allowed = wanted == nullptr || !is_known(wanted);
    char const *expected = "baseline";
    for (Target const &target : targets) {
        allowed = allowed || std::strcmp(wanted, target.name) == 0;
        if (!allowed || !target.available) continue;
        expected = target.name;
        break;
    }
    char const *const mode = std::getenv("PW85_REPRODUCIBLE");
    bool const on = mode != nullptr && *mode != '\0' && std::strcmp(mode, "0") != 0;
    g_assert_cmpstr(chosen, ==, on ? "reproducible" : expected);
    using namespace pw85::detail::kernels;
    for (bool const other : {true, false}) {
        set_reproducible(other);
        g_assert_true(is_reproducible() == other);
        g_assert_cmpstr(pw85::detail::kernels::chosen().name, ==,
                        other ? "reproducible" : expected);
        g_assert_true(has_lanes_of_baseline() == (other || std::strcmp(expected, "baseline") == 0));
    }
}

} // namespace
