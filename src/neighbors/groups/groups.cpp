// SPDX-License-Identifier: BSD-3-Clause
// Tests each box of one group against the blocks of the other group: see groups.hpp.
#include "groups.hpp"

namespace pw85::detail {

namespace neighbors {
namespace {

/// Returns the bits above bit k.
constexpr unsigned above(std::size_t k) noexcept { return ~0u << (k + 1); }

/// The positions of the bits that are set, for each byte, and their number.
struct Positions {
    std::uint8_t of[256][width], count[256];
};

constexpr Positions all_positions() noexcept
{
    Positions positions{};
    for (unsigned bits = 0; bits < 256; ++bits)
        for (unsigned k = 0; k < width; ++k)
            if ((bits >> k & 1) != 0)
                positions.of[bits][positions.count[bits]++] = static_cast<std::uint8_t>(k);
    return positions;
}

constexpr Positions positions = all_positions();

/// Adds the boxes `begin` + k for each bit k that is set. The loop has no branch that depends on
/// the bits, which processors would not predict: it writes eight boxes, of which the first count.
[[gnu::always_inline]] inline void add(FoundPairs &found, std::size_t begin, unsigned bits) noexcept
{
    std::int32_t *const next = found.next();
    for (int k = 0; k < width; ++k)
        next[k] = static_cast<std::int32_t>(begin) + positions.of[bits][k];
    found.extend(positions.count[bits]);
}

/// Finds the pairs of one box, number `i`, with the boxes of a group. In the group of the box
/// itself, if it is not moved, only pairs with later boxes are found. So each pair is found once.
bool pair_box(Tree const &tree, Box const &box, std::size_t i, std::size_t image, std::size_t group,
              FoundPairs &found) noexcept
{
    bool const same_group = image == 0 && i / Tree::group_size == group;
    std::size_t const own_block = i / width;
    unsigned blocks = intersecting(box, *tree.block(1, group));
    if (same_group) blocks &= above(own_block % width) | 1u << own_block % width;
    for (; blocks != 0; blocks &= blocks - 1) {
        std::size_t const b = group * width + static_cast<unsigned>(std::countr_zero(blocks));
        unsigned bits = intersecting(box, *tree.block(0, b));
        if (same_group && b == own_block) bits &= above(i % width);
        if (!found.reserve_block()) return false;
        add(found, b * width, bits);
    }
    return found.end_run(i, image);
}

} // namespace
} // namespace neighbors

namespace kernels::PW85_BUILDING {

using namespace neighbors;

bool pair_groups(Tree const &tree, MovedGroup const &moved, std::size_t group,
                 FoundPairs &found) noexcept
{
    Box const around = tree.box(Tree::group_level, group);
    for (std::size_t b = 0; b < width; ++b)
        for (unsigned bits = intersecting(around, moved.blocks[b]); bits != 0; bits &= bits - 1) {
            int const k = std::countr_zero(bits);
            std::size_t const i = (moved.group * width + b) * width + static_cast<unsigned>(k);
            if (!pair_box(tree, moved.blocks[b].get(k), i, moved.image, group, found)) return false;
        }
    return true;
}

} // namespace kernels::PW85_BUILDING
} // namespace pw85::detail
