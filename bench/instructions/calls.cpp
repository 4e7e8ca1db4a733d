// SPDX-License-Identifier: BSD-3-Clause
// Calls a function on a block of pairs a number of times, for instructions.py. Usage: calls
// FUNCTION ASPECT TIMES
#include <cstdlib>
#include <cstring>

#include "../functions.hpp"

using namespace pw85_bench;

namespace {

/// Whether there is such a function.
bool call(char const *name, Block &block, int times)
{
    for (auto const &function : batch_functions) {
        if (std::strcmp(function.name, name) != 0) continue;
        for (int i = 0; i < times; ++i) function.call(block);
        return true;
    }
    for (auto const &function : functions) {
        if (std::strcmp(function.name, name) != 0) continue;
        Sink sink{};
        for (int i = 0; i < times; ++i)
            for (std::size_t k = 0; k < block.size(); ++k)
                function.call(block.pairs[k], block.lambdas[k], sink);
        return true;
    }
    return false;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 4) return 2;
    Block block(random_block(std::atof(argv[2])));
    return call(argv[1], block, std::atoi(argv[3])) ? 0 : 2;
}
