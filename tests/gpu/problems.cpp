// SPDX-License-Identifier: BSD-3-Clause
// Writes the contact problems as plain numbers, for programs that another compiler makes. Usage:
// problems FILE
#include <cstdio>

#include "../reference_data.hpp"

int main(int argc, char **argv)
{
    std::FILE *const file = argc > 1 ? std::fopen(argv[1], "wb") : nullptr;
    if (file == nullptr) return 1;
    for (auto const &p : pw85_tests::contact_problems()) {
        double const rest[3] = {p.mu2, p.cond, p.mu2_minus_1 < 0.0 ? 1.0 : 0.0};
        std::fwrite(&p.pair, sizeof p.pair, 1, file);
        std::fwrite(rest, sizeof rest, 1, file);
    }
    return std::fclose(file);
}
