// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: bytes as a saved simulation, as they are and with the right size and checksum.
// A state that is restored is saved as the same state again. Corpus:
// tests/portable/saved_*.1.
#include <cstdio>

#include "../tests/saved_sections.hpp"
#include "../tests/saved_simulations.hpp"

using namespace pw85_tests;

namespace {

void check(Bytes const &bytes)
{
    SimulationPointer const made = restored(bytes);
    if (made == nullptr) return;
    Bytes const saved = state_of(made);
    if (saved.empty() || state_of(restored(saved)) != saved) {
        std::puts("a state that was restored is not saved as the same state");
        __builtin_trap();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size)
{
    Bytes const bytes(data, data + size);
    check(bytes);
    if (size >= 32) check(sealed(bytes));
    return 0;
}
