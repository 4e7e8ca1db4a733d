// SPDX-License-Identifier: BSD-3-Clause
// Computes the levels of the tree above the boxes of the particles (tree.hpp).
#include "tree.hpp"

#include "../base/parallel.hpp"

namespace pw85::detail::neighbors {

bool Tree::resize(std::size_t n) noexcept
{
    num_groups_ = (n + group_size - 1) / group_size;
    // The last group is filled with empty boxes, which intersect nothing.
    std::size_t count = num_groups_ * width;
    first_[0] = 0;
    for (int level = 0;; ++level, count = (count + width - 1) / width) {
        first_[level + 1] = first_[level] + count;
        top_ = level;
        if (level >= group_level && count == 1) break;
    }
    if (!blocks_.resize(first_[top_ + 1])) return false;
    for (std::size_t k = n; k < num_groups_ * group_size; ++k) set(k, empty_box);
    return true;
}

void Tree::enclose_levels() noexcept
{
    for (int level = 0; level < top_; ++level) {
        std::size_t const count = first_[level + 1] - first_[level],
                          capacity = first_[level + 2] - first_[level + 1];
        for_parts(capacity, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin * width; k < end * width; ++k)
                blocks_[first_[level + 1] + k / width].set(
                    static_cast<int>(k % width), k < count ? enclose(*block(level, k)) : empty_box);
        });
    }
}

} // namespace pw85::detail::neighbors
