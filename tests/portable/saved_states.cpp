// SPDX-License-Identifier: BSD-3-Clause
// Saved simulations are the same bytes on every machine, and every format can be restored for ever.
// Usage:
//     portable_saved_states check SPACE PLANE     files of format 1, of which nothing may change
//     portable_saved_states record SPACE PLANE    writes such files
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "../saved_simulations.hpp"

using namespace pw85_tests;

namespace {

using State = std::vector<unsigned char>;

/// The checksums of the states after ten more sweeps, in the reproducible mode. They are others if
/// sweeps make other trials.
constexpr std::uint32_t sums_of_continued[2] = {0x74f58fc2, 0xd08d8e6b};

/// The checksum in a state.
std::uint32_t sum_of(State const &state)
{
    std::uint32_t sum = 0;
    for (std::size_t k = 4; k < 8; ++k) sum = sum << 8 | state[state.size() - k - 1];
    return sum;
}

State read(char const *path)
{
    std::ifstream file(path, std::ios::binary);
    return State(std::istreambuf_iterator<char>(file), {});
}

bool is_true(bool condition, char const *what, char const *path)
{
    if (!condition) std::printf("%s: %s\n", path, what);
    return condition;
}

/// Makes ten more sweeps, and returns the state.
State continued(SimulationPointer const &simulation)
{
    pw85_hard_ellipsoids_sweep(simulation.get(), 10);
    return state_of(simulation);
}

bool check(char const *path, SimulationPointer const &made, bool has_potential,
           std::uint32_t sum_of_continued)
{
    State const state = read(path);
    SimulationPointer const old = restored(state);
    if (!is_true(made != nullptr, "its simulation cannot be made", path) ||
        !is_true(old != nullptr, "is refused", path))
        return false;
    bool const same = is_true(state_of(old) == state, "has other bytes after it is restored", path),
               alike = is_true(state_of(made) == state, "has other bytes than here", path);
    if (has_potential && !is_true(pw85_hard_ellipsoids_set_potential(old.get(), quadratic_potential,
                                                                     nullptr) == PW85_SUCCESS,
                                  "has another energy", path))
        return false;
    State const later = continued(old);
    bool const continues = is_true(later == continued(made), "continues in another way", path),
               moves = is_true(later != state, "does not continue", path);
    if (sum_of(later) != sum_of_continued)
        std::printf("%s: 0x%08x after ten sweeps\n", path, static_cast<unsigned>(sum_of(later)));
    return same && alike && continues && moves && sum_of(later) == sum_of_continued;
}

bool record(char const *path, SimulationPointer const &simulation)
{
    State const state = state_of(simulation);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<char const *>(state.data()),
               static_cast<std::streamsize>(state.size()));
    return static_cast<bool>(file.flush());
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 4) return 2;
    pw85_set_reproducible(1);
    SimulationPointer const space = simulation_in_space(), plane = simulation_in_plane();
    if (std::strcmp(argv[1], "record") == 0)
        return record(argv[2], space) && record(argv[3], plane) ? 0 : 1;
    bool const right = check(argv[2], space, true, sums_of_continued[0]);
    return check(argv[3], plane, false, sums_of_continued[1]) && right ? 0 : 1;
}
