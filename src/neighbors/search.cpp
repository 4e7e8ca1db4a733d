// The search of pairs: groups against groups, boxes against blocks.
#include "search.hpp"

#include <pw85.h>

namespace pw85::detail::neighbors {

namespace {

/// The blocks of a group, moved to an image.
struct MovedGroup {
    Block blocks[width];
    std::size_t group, image;
};

MovedGroup move(Tree const &tree, Periodicity const &lattice, std::size_t group, Multiples const &multiples,
                std::size_t image) noexcept
{
    MovedGroup moved{{}, group, image};
    for (std::size_t b = 0; b < width; ++b) {
        moved.blocks[b] = *tree.block(0, group * width + b);
        for (int k = 0; k < width && image != 0; ++k)
            moved.blocks[b].set(k, lattice.moved(moved.blocks[b].get(k), multiples));
    }
    return moved;
}

/// Bits of the numbers above k.
constexpr unsigned above(std::size_t k) noexcept { return ~0u << (k + 1); }

/// Pairs of one box, number `i`, with those of another group; of its own, if it has not moved, with those that follow.
bool pair_box(Tree const &tree, Box const &box, std::size_t i, std::size_t image, std::size_t group,
              FoundPairs &found) noexcept
{
    bool const follow = image == 0 && i / Tree::group_size == group;
    std::size_t const own = i / width;
    unsigned blocks = meeting(box, *tree.block(1, group));
    if (follow) blocks &= above(own % width) | 1u << own % width;
    for (; blocks != 0; blocks &= blocks - 1) {
        std::size_t const b = group * width + static_cast<unsigned>(std::countr_zero(blocks));
        unsigned bits = meeting(box, *tree.block(0, b));
        if (follow && b == own) bits &= above(i % width);
        if (bits != 0 && !found.add(i, b * width, bits, image)) return false;
    }
    return true;
}

/// Pairs of two groups.
bool pair_groups(Tree const &tree, MovedGroup const &moved, std::size_t group, FoundPairs &found) noexcept
{
    Box const around = tree.box(Tree::group_level, group);
    for (std::size_t b = 0; b < width; ++b)
        for (unsigned bits = meeting(around, moved.blocks[b]); bits != 0; bits &= bits - 1) {
            int const k = std::countr_zero(bits);
            std::size_t const i = (moved.group * width + b) * width + static_cast<unsigned>(k);
            if (!pair_box(tree, moved.blocks[b].get(k), i, moved.image, group, found)) return false;
        }
    return true;
}

} // namespace

int list_images(Periodicity const &lattice, Box const &root, Array<Move> &images) noexcept
{
    auto const reach = lattice.reach(root);
    double const most = (2.0 * reach[0] + 1.0) * (2.0 * reach[1] + 1.0) * (2.0 * reach[2] + 1.0);
    if (!(most < most_multiples) || !images.resize(static_cast<std::size_t>(most) / 2 + 1)) return PW85_ENOMEM;
    std::int32_t const x = static_cast<std::int32_t>(reach[0]), y = static_cast<std::int32_t>(reach[1]),
                       z = static_cast<std::int32_t>(reach[2]);
    std::size_t count = 0;
    // In lexicographic order half of the multiples come after zero.
    for (std::int32_t i = 0; i <= x; ++i)
        for (std::int32_t j = i > 0 ? -y : 0; j <= y; ++j)
            for (std::int32_t k = i > 0 || j > 0 ? -z : 0; k <= z; ++k) {
                Move &move = images[count++];
                move.reduced = {{i, j, k}};
                if (!lattice.set_own(move)) return PW85_EINVAL;
            }
    return PW85_SUCCESS;
}

bool find_pairs(Tree const &tree, Periodicity const &lattice, Array<Move> const &images, std::size_t task,
                FoundPairs &found) noexcept
{
    found.clear();
    Box const root = tree.root();
    std::size_t const end = std::min((task + 1) * groups_per_task, tree.num_groups());
    for (std::size_t group = task * groups_per_task; group < end; ++group)
        for (std::size_t image = 0; image < images.size(); ++image) {
            Box box = tree.box(Tree::group_level, group);
            if (image != 0) box = lattice.moved(box, images[image].reduced);
            if (!meets(box, root)) continue;
            MovedGroup const moved = move(tree, lattice, group, images[image].reduced, image);
            bool enough_memory = true;
            tree.visit_groups(box, image == 0 ? group : 0, [&](std::size_t other) {
                enough_memory = enough_memory && pair_groups(tree, moved, other, found);
            });
            if (!enough_memory) return false;
        }
    return true;
}

} // namespace pw85::detail::neighbors
