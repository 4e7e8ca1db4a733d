// SPDX-License-Identifier: BSD-3-Clause
// The instruction set that the library chooses on a processor. Usage: chosen EXPECTED
#include <cstdio>
#include <cstring>

#include "../../src/simd/targets.hpp"

int main(int, char **argv)
{
    char const *const chosen = pw85::detail::kernels::chosen().name;
    std::printf("%s\n", chosen);
    return std::strcmp(chosen, argv[1]) == 0 ? 0 : 1;
}
