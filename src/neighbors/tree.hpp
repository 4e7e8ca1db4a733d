// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A tree of boxes. Each box encloses eight boxes of the level below. build_tree() fills the tree,
/// and find_pairs() searches it. So do the functions of a mesh (../meshes/).
#ifndef PW85_NEIGHBORS_TREE_HPP_INCLUDED
#define PW85_NEIGHBORS_TREE_HPP_INCLUDED

#include <bit>

#include "../base/array.hpp"
#include "boxes.hpp"

namespace pw85::detail::neighbors {

/// Level 0 has the boxes of the particles. Level l + 1 has the boxes around the blocks of level l.
/// A group is 64 particles: one box of level 2, one block of level 1, eight blocks of level 0.
class Tree {
  public:
    static constexpr int group_level = 2;
    static constexpr std::size_t group_size = width * width;

    /// Sets the number of particles to n > 0. Returns false if there is no memory.
    [[nodiscard]] bool resize(std::size_t n) noexcept;

    /// Sets the box of a particle.
    [[gnu::always_inline]] void set(std::size_t particle, Box const &box) noexcept
    {
        blocks_[particle / width].set(static_cast<int>(particle % width), box);
    }

    /// Computes the boxes of the higher levels. Call this when the boxes of all particles are set.
    void enclose_levels() noexcept;

    [[gnu::always_inline]] std::size_t num_groups() const noexcept { return num_groups_; }
    [[gnu::always_inline]] Block const *block(int level, std::size_t k) const noexcept
    {
        return blocks_.data() + first_[level] + k;
    }
    [[gnu::always_inline]] Box box(int level, std::size_t k) const noexcept
    {
        return block(level, k / width)->get(static_cast<int>(k % width));
    }
    /// Returns the level of the block that has all boxes.
    [[gnu::always_inline]] int top_level() const noexcept { return top_; }
    /// Returns the smallest box around all boxes.
    [[gnu::always_inline]] Box root() const noexcept { return enclose(*block(top_, 0)); }

    /// Calls visit(group) for each group from `first` on whose box intersects `box`.
    template <class Visit>
    void visit_groups(Box const &box, std::size_t first, Visit const &visit) const noexcept
    {
        descend(box, first, visit, top_, 0);
    }

  private:
    template <class Visit> void descend(Box const &box, std::size_t first, Visit const &visit,
                                        int level, std::size_t k) const noexcept
    {
        for (unsigned bits = intersecting(box, *block(level, k)); bits != 0; bits &= bits - 1) {
            std::size_t const child = k * width + static_cast<unsigned>(std::countr_zero(bits));
            if ((child + 1) << 3 * (level - group_level) <= first) continue;
            if (level == group_level)
                visit(child);
            else
                descend(box, first, visit, level - 1, child);
        }
    }

    static constexpr int most_levels = 12; // 8¹² blocks exceed the range of the indices, int32
    Array<Block> blocks_;
    std::size_t first_[most_levels + 1] = {}; ///< index of the first block of each level
    std::size_t num_groups_ = 0;
    int top_ = group_level;
};

} // namespace pw85::detail::neighbors

#endif
