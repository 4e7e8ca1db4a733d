// SPDX-License-Identifier: BSD-3-Clause
// Finds the pairs of search.hpp by going down the tree: first pairs of groups, then each box of one
// group against the blocks of the other group (groups/groups.hpp).
#include "search.hpp"

#include <pw85.h>

#include "groups/groups.hpp"

namespace pw85::detail::neighbors {

namespace {

MovedGroup move_group(Tree const &tree, Periodicity const &lattice, std::size_t group,
                      Multiples const &multiples, std::size_t image) noexcept
{
    MovedGroup moved{{}, group, image};
    for (std::size_t b = 0; b < width; ++b) {
        moved.blocks[b] = *tree.block(0, group * width + b);
        for (int k = 0; k < width && image != 0; ++k)
            moved.blocks[b].set(k, lattice.moved(moved.blocks[b].get(k), multiples));
    }
    return moved;
}

} // namespace

int list_images(Periodicity const &lattice, Box const &root, double most,
                Array<LatticeVector> &images) noexcept
{
    auto const reach = lattice.reach(root);
    double const all = (2.0 * reach[0] + 1.0) * (2.0 * reach[1] + 1.0) * (2.0 * reach[2] + 1.0);
    if (!(all < most) || !images.resize(static_cast<std::size_t>(all) / 2 + 1)) return PW85_ENOMEM;
    std::int32_t const x = static_cast<std::int32_t>(reach[0]),
                       y = static_cast<std::int32_t>(reach[1]),
                       z = static_cast<std::int32_t>(reach[2]);
    std::size_t count = 0;
    // Of each pair v and -v, only the vector that comes after zero in lexicographic order is in the
    // list.
    for (std::int32_t i = 0; i <= x; ++i)
        for (std::int32_t j = i > 0 ? -y : 0; j <= y; ++j)
            for (std::int32_t k = i > 0 || j > 0 ? -z : 0; k <= z; ++k) {
                LatticeVector &vector = images[count++];
                vector.of_reduced = {{i, j, k}};
                if (!lattice.set_multiples_of_cell(vector)) return PW85_EINVAL;
            }
    return PW85_SUCCESS;
}

bool find_pairs(Tree const &tree, Periodicity const &lattice, Array<LatticeVector> const &images,
                std::size_t task, double most, FoundPairs &found) noexcept
{
    auto *const pair_groups = kernels::pair_groups_of(kernels::chosen());
    found.clear();
    Box const root = tree.root();
    std::size_t const begin = task * groups_per_task,
                      end = minimum(begin + groups_per_task, tree.num_groups());
    double const most_of_task = most * static_cast<double>((end - begin) * Tree::group_size);
    for (std::size_t group = begin; group < end; ++group)
        for (std::size_t image = 0; image < images.size(); ++image) {
            Box box = tree.box(Tree::group_level, group);
            if (image != 0) box = lattice.moved(box, images[image].of_reduced);
            if (!intersect(box, root)) continue;
            MovedGroup const moved =
                move_group(tree, lattice, group, images[image].of_reduced, image);
            bool has_room = true;
            tree.visit_groups(box, image == 0 ? group : 0, [&](std::size_t other) {
                has_room = has_room && pair_groups(tree, moved, other, found);
            });
            if (!has_room || static_cast<double>(found.size()) > most_of_task) return false;
        }
    return true;
}

} // namespace pw85::detail::neighbors
