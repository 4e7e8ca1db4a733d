// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: bytes as a saved simulation, as they are and with the right size and checksum.
// A state that is restored is saved as the same state again, and can be restored after a sweep,
// which ends soon. Corpus: tests/portable/saved_*.1.
#include <cstdio>

#include "../tests/saved_sections.hpp"
#include "../tests/saved_simulations.hpp"

using namespace pw85_tests;

namespace {

/// Traps unless a simulation is saved as a state that is restored as the same state.
void check_saved(SimulationPointer const &simulation)
{
    Bytes const saved = state_of(simulation);
    if (saved.empty() || state_of(restored(saved)) != saved) {
        std::puts("a state that was restored is not saved as the same state");
        __builtin_trap();
    }
}

void check(Bytes const &bytes)
{
    SimulationPointer const made = restored(bytes);
    if (made == nullptr) return;
    check_saved(made);
    pw85_hard_ellipsoids_sweep(made.get(), 1);
    check_saved(made);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size)
{
    Bytes const bytes(data, data + size);
    check(bytes);
    if (size >= 32) check(sealed(bytes));
    return 0;
}
